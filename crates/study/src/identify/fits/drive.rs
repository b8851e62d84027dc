//! A feed drive from a recorded step: structures compared, dead time, order and lag.

use std::fmt::Write as _;

use super::data::at;
use super::outcome::{FitEstimate, FitOutcome, FitPlot, FitTable, left_over, nothing_yet, told};
use super::request::{FitFault, FitOption, FitOptionKind, FitRequest, FitRole, WITHIN, missing};
use super::{FitAbout, FitAtWork, MeasuredFit};
use crate::base::language::{fixed, in_english, text, tr};
use crate::base::rng::Stream;
use crate::blocks::cnc::dead_time::DeadTime;
use crate::blocks::cnc::feed_drive::FeedDrive;
use crate::identify::drive::{DriveRecording, DriveSearch, DriveStructure, drive_file};
use crate::identify::estimate::explained;
use crate::own_file::{OwnFile, OwnFileKind};
use crate::run::scenario::Scenario;

/// The fit.
#[derive(Debug)]
pub struct DriveFromData;

/// The feed that was measured.
pub const FEED: FitRole = FitRole {
    option: "feed",
    label: text!("Feed, measured"),
    about: text!("The channel with the feed that was measured."),
    what: text!("a feed"),
    unit: "",
    needed: true,
    names: &["feed_mm_min", "feed"],
    words: &["feed_act", "feed_meas", "act", "ist", "vorschub_ist", "v_ist", "vf", "podaj"],
};
/// The feed that was asked for.
pub const COMMAND: FitRole = FitRole {
    option: "command",
    label: text!("Feed, asked for"),
    about: text!(
        "The channel with the feed that was asked for. What a sample has holds from the sample before on, as in the rows of a run."
    ),
    what: text!("a feed that was asked for, or the step that was"),
    unit: "",
    needed: false,
    names: &["feed_command_mm_min", "feed_command"],
    words: &[
        "feed_command",
        "feed_cmd",
        "feed_set",
        "command",
        "cmd",
        "set",
        "soll",
        "vorschub_soll",
        "v_soll",
    ],
};
const SIZES: [f64; 2] = [-1e6, 1e6];
/// When the step was asked for, where the command was not recorded.
pub const STEP_AT: FitOption = step("step-at", text!("Step at"), "s");
/// From which feed.
pub const STEP_FROM: FitOption = step("step-from", text!("Step from"), "");
/// To which feed.
pub const STEP_TO: FitOption = step("step-to", text!("Step to"), "");

const fn step(option: &'static str, label: &'static str, unit: &'static str) -> FitOption {
    FitOption {
        option,
        label,
        about: text!(
            "The step that was asked for, where it was not recorded: when, from and to which feed."
        ),
        unit,
        kind: FitOptionKind::Number { range: SIZES, default: None, whole: false },
    }
}

/// The recording that a request has, and the unit of its feed.
///
/// # Errors
/// A channel that is not there, not even in time, or not whole; neither a command nor a step.
pub fn recorded(request: &FitRequest) -> Result<(DriveRecording, String), FitFault> {
    let feed = request.needed(&FEED)?;
    let commands = match request.even(&COMMAND)? {
        Some(command) => {
            command.goes_with(&feed)?;
            command.values
        }
        None => {
            let [Some(at_s), Some(from), Some(to)] =
                [request.number(&STEP_AT)?, request.number(&STEP_FROM)?, request.number(&STEP_TO)?]
            else {
                return Err(missing(&COMMAND));
            };
            (0..feed.values.len()).map(|i| if feed.time_s(i) <= at_s { from } else { to }).collect()
        }
    };
    let taken = feed.within(request.span(&WITHIN)?);
    let recording = DriveRecording {
        period_s: 1.0 / feed.rate_hz,
        command: at(&taken, &commands),
        feed: at(&taken, &feed.values),
    };
    Ok((recording, feed.unit))
}

/// The fit while it is worked at.
#[derive(Clone, Debug)]
pub struct DriveAtWork {
    search: DriveSearch,
    unit: String,
    file: String,
    scenario: Scenario,
}

impl MeasuredFit for DriveFromData {
    const ABOUT: FitAbout = FitAbout {
        title: text!("Drive"),
        finds: text!(
            "Dead time, order and lag of the feed drive, four structures compared by Schwarz's and Akaike's criteria."
        ),
        needs: text!(
            "A recording of a step of the feed: the feed that was measured and the one that was asked for, even in time, from before the step until the feed is steady."
        ),
        sample: "steadycut run table3-5 --out trace.csv",
        timed: true,
        roles: &[FEED, COMMAND],
        options: &[STEP_AT, STEP_FROM, STEP_TO, WITHIN],
        most_steps: DriveStructure::ALL.len(),
    };
    type Work = DriveAtWork;

    fn lacks(request: &FitRequest) -> Option<FitFault> {
        let said = |option: &FitOption| matches!(request.number(option), Ok(Some(_)));
        let step = [STEP_AT, STEP_FROM, STEP_TO].iter().all(said);
        (request.chosen(&COMMAND).is_none() && !step).then(|| missing(&COMMAND))
    }

    fn begin(request: &FitRequest) -> Result<DriveAtWork, FitFault> {
        let (recording, unit) = recorded(request)?;
        Ok(DriveAtWork {
            search: DriveSearch::new(recording)?,
            unit,
            file: request.file.clone(),
            scenario: request.scenario.clone(),
        })
    }

    /// A step from three fifths of the programmed feed to all of it, by the scenario's own dead time and drive.
    fn sample(scenario: &Scenario, seed: u32) -> Result<String, String> {
        const PERIOD_S: f64 = 1e-3;
        const STEP_S: f64 = 0.2;
        const SAMPLES: u64 = 1600;
        /// Noise as a share of the step.
        const NOISE: f64 = 0.01;
        let to = scenario.program.feed_mm_min;
        let from = 0.6 * to;
        let dead_ticks = (scenario.cnc.dead_time_s / PERIOD_S).round() as usize;
        let mut channel = DeadTime::new(dead_ticks, [from, 0.0]);
        let mut drive = FeedDrive::new(&scenario.feed_drive, PERIOD_S, from);
        let stream = Stream::new(u64::from(seed), "recorded feed");
        let mut text = "time_s [s],feed_command_mm_min [mm/min],feed_mm_min [mm/min]\n".to_owned();
        for k in 0..SAMPLES {
            let time_s = k as f64 * PERIOD_S;
            let command = if time_s > STEP_S { to } else { from };
            if k > 0 {
                drive.update(channel.pass([command, 0.0])[0]);
            }
            let noise = NOISE * (to - from) * stream.normal(k);
            // Into memory: it does not fail.
            let _ = writeln!(text, "{time_s:.3},{command},{:.4}", drive.actual() + noise);
        }
        Ok(text)
    }
}

impl FitAtWork for DriveAtWork {
    fn step(&mut self) -> bool {
        self.search.step()
    }

    fn outcome(&self) -> Result<FitOutcome, FitFault> {
        let fits = self.search.fits();
        let best = fits.first().ok_or_else(nothing_yet)?;
        let recording = self.search.recording();
        let samples = recording.feed.len();
        let file =
            in_english(|| drive_file(best, &format!("identified in {}", self.file), samples));
        let settings = OwnFile::parse(OwnFileKind::Machine, &file).and_then(|own| {
            self.scenario.clone().set_all(&own.changes)?;
            Ok(own.changes)
        });
        let mut estimates = vec![
            FitEstimate::new(tr("dead time"), best.dead_time_s, 5, "s"),
            FitEstimate::new(tr("lag"), best.lag_s, 5, "s"),
            FitEstimate::new(tr("gain"), best.gain, 5, ""),
        ];
        let own = |(name, unit, value): &(&'static str, &'static str, _)| {
            FitEstimate::new(*name, *value, 5, unit)
        };
        estimates.extend(best.parameters.iter().map(own));
        let rows = fits.iter().map(|fit| {
            vec![
                tr(fit.structure.label()).to_owned(),
                fixed(fit.bic, 1),
                fixed(fit.aic, 1),
                fixed(fit.rest, 4),
                told(fit.dead_time_s, 4),
                told(fit.lag_s, 4),
            ]
        });
        let rest = match self.unit.is_empty() {
            true => tr("left, rms").to_owned(),
            false => format!("{} [{}]", tr("left, rms"), self.unit),
        };
        let table = FitTable {
            title: tr("Structures compared; the one of least BIC is taken").to_owned(),
            heads: vec![
                tr("structure").to_owned(),
                "BIC".to_owned(),
                "AIC".to_owned(),
                rest,
                tr("dead time [s]").to_owned(),
                tr("lag [s]").to_owned(),
            ],
            rows: rows.collect(),
            taken: Some(0),
        };
        let mut notes = Vec::new();
        /// Difference of the criterion up to which two structures are about as good (Kass and Raftery, Bayes factors, 1995).
        const ALIKE: f64 = 2.0;
        if let Some(other) = fits.get(1).filter(|other| other.bic - best.bic < ALIKE) {
            notes.push(tr!(
                "this recording does not tell {one} from {other}: their BIC differ by {by:.1}",
                one = tr(best.structure.label()),
                other = tr(other.structure.label()),
                by = other.bic - best.bic
            ));
        }
        let point = |k: usize| {
            let measured = recording.feed[k];
            [k as f64 * recording.period_s, measured, measured - best.residuals[k]]
        };
        let plot = FitPlot {
            title: tr("Feed").to_owned(),
            over: (tr("time").to_owned(), "s"),
            unit: self.unit.clone(),
            points: (0..best.residuals.len().min(samples)).map(point).collect(),
            joined: true,
            logarithmic: false,
        };
        Ok(FitOutcome {
            summary: tr!(
                "{samples} samples, {period} s apart; {structure}",
                samples = samples,
                period = recording.period_s,
                structure = tr(best.structure.label())
            ),
            estimates,
            table: Some(table),
            left: left_over(best.rest, &self.unit, explained(&recording.feed, &best.residuals)),
            notes,
            plots: vec![plot],
            settings: settings.map_err(|error| error.to_string()),
            file: Ok(file),
        })
    }
}
