//! The material by the force that it needs: its factor over that of Ck45, and the hardness that makes it.

use std::fmt::Write as _;

use super::data::at;
use super::noise::{FORCE, steady_rows};
use super::outcome::{FitEstimate, FitOutcome, FitPlot, left_over, nothing_yet};
use super::request::{FitFault, FitRequest, FitRole, WITHIN};
use super::{FitAbout, FitAtWork, MeasuredFit};
use crate::base::language::{in_english, text, tr};
use crate::identify::material::{CutSamples, MaterialFit, identify_material, scenario_of_material};
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;

/// The fit.
#[derive(Debug)]
pub struct MaterialFromData;

/// The largest force of a revolution.
pub const PEAK: FitRole = FitRole {
    label: text!("Force, largest of a turn"),
    about: text!(
        "The channel with the largest force of a revolution, in N or kN (`steadycut measured --peak` makes it of components)."
    ),
    ..FORCE
};
/// The feed.
pub const FEED: FitRole = FitRole {
    option: "feed",
    label: text!("Feed"),
    about: text!("The channel with the feed, mm/min; without it the scenario's program holds."),
    what: text!("a feed"),
    unit: "mm/min",
    needed: false,
    names: &["feed_mm_min", "feed"],
    words: &["feed_act", "feed_meas", "vorschub", "vf", "podaj"],
};
/// The spindle speed.
pub const SPEED: FitRole = FitRole {
    option: "speed",
    label: text!("Spindle speed"),
    about: text!(
        "The channel with the spindle speed, 1/min; without it the scenario's program holds."
    ),
    what: text!("a spindle speed"),
    unit: "1/min",
    needed: false,
    names: &["spindle_rpm", "spindle", "speed", "rpm", "n"],
    words: &["spindle_act", "spindle_speed", "speed", "dreh", "vrti", "rpm"],
};
/// The position along the path.
pub const POSITION: FitRole = FitRole {
    option: "position",
    label: text!("Position along the path"),
    about: text!(
        "The channel with the position along the path, mm, where the part has several depths."
    ),
    what: text!("a position"),
    unit: "mm",
    needed: false,
    names: &["position_mm", "position", "s"],
    words: &["position", "weg", "pot"],
};

/// The samples of a request, and the times of the first and the others, s.
///
/// # Errors
/// A channel that is not there, of another unit, not even in time, not whole, or of other times than the force.
pub fn recorded(request: &FitRequest) -> Result<(CutSamples, Vec<f64>), FitFault> {
    let force = request.needed(&PEAK)?;
    let taken = force.within(request.span(&WITHIN)?);
    let values = |role: &FitRole| -> Result<Option<Vec<f64>>, FitFault> {
        let Some(channel) = request.even(role)? else { return Ok(None) };
        channel.goes_with(&force)?;
        Ok(Some(at(&taken, &channel.values)))
    };
    let program = &request.scenario.program;
    let samples = CutSamples {
        force_n: at(&taken, &force.values),
        feed_mm_min: values(&FEED)?.unwrap_or_else(|| vec![program.feed_mm_min; taken.len()]),
        speed_rpm: values(&SPEED)?.unwrap_or_else(|| vec![program.spindle_rpm; taken.len()]),
        position_mm: values(&POSITION)?.unwrap_or_default(),
    };
    Ok((samples, taken.iter().map(|i| force.time_s(*i)).collect()))
}

/// The fit while it is worked at.
#[derive(Clone, Debug)]
pub struct MaterialAtWork {
    samples: CutSamples,
    times_s: Vec<f64>,
    file: String,
    scenario: Scenario,
    edits: Edits,
    found: Option<Result<MaterialFit, String>>,
}

impl MeasuredFit for MaterialFromData {
    const ABOUT: FitAbout = FitAbout {
        title: text!("Material"),
        finds: text!(
            "The factor of the material's force over that of Ck45 at 200 HB, and the hardness that the scenario's material would have it at."
        ),
        needs: text!(
            "The largest force of each revolution in a cut, even in time, 40 samples and more; feed, speed and position beside it where they change; the scenario has cutter, part and a force model that is a map, not tooth by tooth (Forces fits that)."
        ),
        sample: "steadycut run table3-5-noise --set controller.kind=constant_feed --set plant.hardness_hb=260 --out trace.csv",
        timed: true,
        roles: &[PEAK, FEED, SPEED, POSITION],
        options: &[WITHIN],
        most_steps: 1,
    };
    type Work = MaterialAtWork;

    fn begin(request: &FitRequest) -> Result<MaterialAtWork, FitFault> {
        let (samples, times_s) = recorded(request)?;
        let FitRequest { file, scenario, edits, .. } = request;
        let (file, scenario, edits) = (file.clone(), scenario.clone(), edits.clone());
        Ok(MaterialAtWork { samples, times_s, file, scenario, edits, found: None })
    }

    /// Force, feed, speed and position of a cut at constant feed in the scenario's material.
    fn sample(scenario: &Scenario, seed: u32) -> Result<String, String> {
        if scenario.plant.force_model.tooth_by_tooth() {
            return Err(tr!(
                "`plant.force_model` is {id}, tooth by tooth: expected is a scenario whose force is a map; `steadycut identify force` fits the teeth",
                id = scenario.plant.force_model.id()
            ));
        }
        let names = "time_s [s],force_measured_n [N],feed_mm_min [mm/min],spindle_rpm [1/min],position_mm [mm]";
        let mut text = format!("{names}\n");
        for row in steady_rows(scenario, seed)? {
            // Into memory: it does not fail.
            let _ = writeln!(
                text,
                "{:.6},{:.4},{:.4},{:.3},{:.4}",
                row.time_s, row.force_measured_n, row.feed_mm_min, row.spindle_rpm, row.position_mm
            );
        }
        Ok(text)
    }
}

impl FitAtWork for MaterialAtWork {
    fn step(&mut self) -> bool {
        self.found = Some(identify_material(&self.scenario, &self.samples));
        false
    }

    fn outcome(&self) -> Result<FitOutcome, FitFault> {
        let fit = self.found.clone().ok_or_else(nothing_yet)??;
        let material = self.scenario.plant.material;
        let hardness = tr!("hardness of {material}", material = tr(material.label()));
        let estimates = vec![
            FitEstimate::new(tr("force over that of Ck45 at 200 HB"), fit.factor, 4, ""),
            FitEstimate::new(hardness, fit.hardness_hb, 1, "HB"),
        ];
        let mut notes = Vec::new();
        if fit.outside > 0.0 {
            notes.push(tr!(
                "the model was used outside its range in {percent:.0} % of the samples",
                percent = 100.0 * fit.outside
            ));
        }
        notes.push(
            tr("one factor holds wear, material and hardness together: forces alone do not tell them apart")
                .to_owned(),
        );
        let source = format!("from {}", self.file);
        let made = in_english(|| scenario_of_material(&self.scenario, &self.edits, &fit, &source));
        let (settings, file) = FitOutcome::accepted(made);
        let plot = FitPlot {
            title: tr("Force").to_owned(),
            over: (tr("time").to_owned(), "s"),
            unit: "N".to_owned(),
            points: fit
                .forces
                .iter()
                .map(|(i, [force, model])| [self.times_s[*i], *force, *model])
                .collect(),
            joined: true,
            logarithmic: false,
        };
        Ok(FitOutcome {
            summary: tr!("{samples} samples in the cut", samples = fit.samples),
            estimates,
            table: None,
            left: left_over(fit.rest_n, "N", fit.r2),
            notes,
            plots: vec![plot],
            settings,
            file,
        })
    }
}
