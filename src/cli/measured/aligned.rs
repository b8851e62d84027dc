//! A measured channel beside a run: its shift in time and its scale.

use serde::Serialize;

use super::args::PrepareArgs;
use crate::cli::progress;
use crate::cli::scenarios::load;
use crate::measured::channel::{MeasuredChannel, SampleTimes};
use crate::measured::signal::periods::resampled;
use crate::run::one_run::Run;
use crate::run::signals::SIGNALS;
use crate::study::over_run::{self, OverRun, OverRunFit};

/// A channel in the time of a run.
pub struct Aligned {
    /// What was found.
    pub told: AlignmentTold,
    /// The channel in the run's time, and the run's signal.
    pub channels: Vec<MeasuredChannel>,
}

/// How a channel lies to a signal of a run, as it is told.
#[derive(Serialize)]
pub struct AlignmentTold {
    scenario: String,
    channel: String,
    signal: &'static str,
    unit: &'static str,
    /// So much later the measurement is, s.
    shift_s: f64,
    scale: f64,
    offset: f64,
    correlation: f64,
    rest: f64,
    samples: usize,
}

impl AlignmentTold {
    /// Its lines, for people.
    pub fn lines(&self) -> Vec<(&'static str, String)> {
        let unit = self.unit;
        vec![
            ("run", format!("{}, {}", self.scenario, self.signal)),
            ("shift", format!("{:+.6} s: the measurement is so much later", self.shift_s)),
            ("scale", format!("{:.6}", self.scale)),
            ("offset", format!("{:+.4} {unit}", self.offset)),
            ("correlation", format!("{:.6}", self.correlation)),
            ("what is left, rms", format!("{:.4} {unit} over {} samples", self.rest, self.samples)),
        ]
    }
}

/// Runs the scenario and finds when the measurement began, seen from it.
pub fn aligned(
    args: &PrepareArgs,
    channels: &[MeasuredChannel],
    json: bool,
) -> Result<Option<Aligned>, Box<dyn std::error::Error>> {
    let (Some(path), Some((name, id))) = (&args.align, &args.pair) else { return Ok(None) };
    let signal = SIGNALS.iter().find(|signal| signal.id == *id).ok_or_else(|| {
        let ids: Vec<&str> = SIGNALS.iter().map(|signal| signal.id).collect();
        format!("--pair: a run has no signal `{id}`; it has {}", ids.join(", "))
    })?;
    let channel = channels.iter().find(|channel| channel.name == *name).ok_or_else(|| {
        let names: Vec<&str> = channels.iter().map(|channel| channel.name.as_str()).collect();
        format!("--pair: there is no channel `{name}`; there are {}", names.join(", "))
    })?;
    let (scenario, edits) = load(path)?;
    let mut run = Run::new(&scenario, &edits);
    progress::work(&mut run, "run", json)?;
    let row_s = run.recording().row_s();
    let failed = |fault| format!("--align: {fault}");
    let measured = resampled(channel, row_s).map_err(failed)?;
    let of_run = over_run::reference(run.recording(), signal).map_err(failed)?;
    let OverRunFit { place, correlation, rest, samples } =
        over_run::aligned(&measured, &of_run, row_s).map_err(failed)?;
    let OverRun { shift_s, scale, offset } = place;
    let told = AlignmentTold {
        scenario: scenario.info.name.clone(),
        channel: name.clone(),
        signal: signal.id,
        unit: signal.unit,
        shift_s,
        scale,
        offset,
        correlation,
        rest,
        samples,
    };
    let times = match &channel.times {
        SampleTimes::Unknown => SampleTimes::Unknown,
        SampleTimes::Even { rate_hz, first_s } => {
            SampleTimes::Even { rate_hz: *rate_hz, first_s: first_s - shift_s }
        }
        SampleTimes::Given(times) => {
            SampleTimes::Given(times.iter().map(|time_s| time_s - shift_s).collect())
        }
    };
    let channels = vec![
        MeasuredChannel { times, ..channel.clone() },
        over_run::channel_of(run.recording(), signal),
    ];
    Ok(Some(Aligned { told, channels }))
}
