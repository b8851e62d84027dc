//! Sizes of noise and ripple in the force of a steady cut.

use std::fmt::Write as _;

use super::data::force_n;
use super::force::{OTHER_FEED, OTHER_SPEED};
use super::outcome::{FitEstimate, FitOutcome, FitPlot, left_over, nothing_yet, number};
use super::request::{FitFault, FitOption, FitOptionKind, FitRequest, FitRole, WITHIN};
use super::{FitAbout, FitAtWork, MeasuredFit};
use crate::base::language::{in_english, text, tr};
use crate::blocks::control::ControllerKind;
use crate::identify::noise::{NoiseFit, NoiseRecording, NoisyCut, identify_noise, noisy_scenario};
use crate::run::edits::Edits;
use crate::run::one_run::Run;
use crate::run::scenario::Scenario;
use crate::run::signals::Row;

/// The fit.
#[derive(Debug)]
pub struct NoiseFromData;

/// The force.
pub const FORCE: FitRole = FitRole {
    option: "force",
    label: text!("Force"),
    about: text!("The channel with the force, in N or kN."),
    what: text!("a force"),
    unit: "N",
    needed: true,
    names: &["force_measured_n", "force_measured", "force_n", "force", "fxy_n", "fxy"],
    words: &["force", "kraft", "sila", "peak", "fxy"],
};
/// When the tool was in the air.
pub const REST: FitOption = FitOption {
    option: "rest",
    label: text!("In the air"),
    about: text!(
        "Times in s between which the tool was in the air: the sensor's noise is told there."
    ),
    unit: "s",
    kind: FitOptionKind::Span,
};

/// The recording of a request, and what is known of its cut.
///
/// # Errors
/// A channel that is not there, no force, not even in time, or not whole; an option out of its range.
pub fn recorded(request: &FitRequest) -> Result<(NoiseRecording, NoisyCut), FitFault> {
    let (channel, cut_n) = force_n(request, &FORCE, &WITHIN)?;
    let rest_n = match request.span(&REST)? {
        Some(_) => force_n(request, &FORCE, &REST)?.1,
        None => Vec::new(),
    };
    let scenario = &request.scenario;
    let (noise, program, tool) = (&scenario.noise, &scenario.program, &scenario.tool);
    let cut = NoisyCut {
        speed_rpm: request.number(&OTHER_SPEED)?.unwrap_or(program.spindle_rpm),
        teeth: tool.teeth,
        feed_mm_min: request.number(&OTHER_FEED)?.unwrap_or(program.feed_mm_min),
        band_hz: [noise.band_low_hz, noise.band_high_hz],
        correlation_mm: noise.correlation_mm,
    };
    Ok((NoiseRecording { period_s: 1.0 / channel.rate_hz, cut_n, rest_n }, cut))
}

/// The fit while it is worked at.
#[derive(Clone, Debug)]
pub struct NoiseAtWork {
    recording: NoiseRecording,
    cut: NoisyCut,
    file: String,
    scenario: Scenario,
    edits: Edits,
    found: Option<Result<NoiseFit, String>>,
}

/// The rows of a run at constant feed, with the noise of the scenario, without its first second.
pub(super) fn steady_rows(scenario: &Scenario, seed: u32) -> Result<Vec<Row>, String> {
    const BEGUN_S: f64 = 1.0;
    let steady = scenario.with(|s| {
        s.controller.kind = ControllerKind::ConstantFeed;
        s.run.seed = seed;
        if s.noise.level == 0.0 {
            s.noise.level = 1.0;
        }
    });
    let run = Run::complete(&steady.map_err(|error| error.to_string())?, &Edits::none());
    Ok(run.recording().rows().iter().filter(|row| row.time_s > BEGUN_S).cloned().collect())
}

impl MeasuredFit for NoiseFromData {
    const ABOUT: FitAbout = FitAbout {
        title: text!("Noise"),
        finds: text!(
            "Sizes of the sensor's noise, of band-limited noise, of the material's inhomogeneity and of the ripple at tooth passing."
        ),
        needs: text!(
            "The force of a steady cut, even in time, 256 samples and more, better some seconds at 1 kHz; the scenario has speed, teeth and feed of the cut."
        ),
        sample: "steadycut run table3-5-noise --set controller.kind=constant_feed --out trace.csv",
        timed: true,
        roles: &[FORCE],
        options: &[REST, OTHER_FEED, OTHER_SPEED, WITHIN],
        most_steps: 1,
    };
    type Work = NoiseAtWork;

    fn begin(request: &FitRequest) -> Result<NoiseAtWork, FitFault> {
        let (recording, cut) = recorded(request)?;
        let FitRequest { file, scenario, edits, .. } = request;
        let (file, scenario, edits) = (file.clone(), scenario.clone(), edits.clone());
        Ok(NoiseAtWork { recording, cut, file, scenario, edits, found: None })
    }

    /// The force that the sensor gives in a cut at constant feed, a thousand times a second where the plant allows it.
    fn sample(scenario: &Scenario, seed: u32) -> Result<String, String> {
        let fast = scenario.with(|s| {
            s.run.control_period_ms = 1.0;
            s.run.steps_per_control = 1;
            s.run.record_every = 1;
        });
        let rows = match fast {
            Ok(fast) => steady_rows(&fast, seed)?,
            Err(_) => steady_rows(scenario, seed)?,
        };
        let mut text = "time_s [s],force_measured_n [N]\n".to_owned();
        for row in &rows {
            // Into memory: it does not fail.
            let _ = writeln!(text, "{:.6},{:.4}", row.time_s, row.force_measured_n);
        }
        Ok(text)
    }
}

impl FitAtWork for NoiseAtWork {
    fn step(&mut self) -> bool {
        self.found = Some(identify_noise(&self.recording, &self.cut));
        false
    }

    fn outcome(&self) -> Result<FitOutcome, FitFault> {
        let fit = self.found.clone().ok_or_else(nothing_yet)??;
        let percent = "%";
        let mut estimates = vec![FitEstimate::new(tr("white noise"), fit.white_n, 3, "N")];
        if let Some((white, _)) = fit.rest {
            estimates.push(FitEstimate::new(tr("white noise in the air"), white, 3, "N"));
        }
        let band = tr("band-limited noise, of the force");
        estimates.push(FitEstimate::new(band, fit.band_percent, 3, percent));
        let slow = tr("inhomogeneity, of the force");
        estimates.push(FitEstimate::new(slow, fit.inhomogeneity_percent, 3, percent));
        let mut notes = Vec::new();
        for (name, ripple) in [
            (tr("ripple at tooth passing, of the force"), fit.tooth_percent),
            (tr("ripple at the spindle's turns, of the force"), fit.spindle_percent),
        ] {
            match ripple {
                Some(ripple) => estimates.push(FitEstimate::new(name, ripple, 3, percent)),
                None => notes.push(tr!(
                    "{name}: not seen, the samples are too far apart for it",
                    name = name
                )),
            }
        }
        let [low, high] = self.cut.band_hz;
        notes.push(tr!(
            "the shapes of the noise are those of the scenario: its band from {low} to {high} Hz, its correlation over {length} mm",
            low = low,
            high = high,
            length = self.cut.correlation_mm
        ));
        let source = format!("from {}", self.file);
        let made = in_english(|| noisy_scenario(&self.scenario, &self.edits, &fit, &source));
        let (settings, file) = FitOutcome::accepted(made);
        let mut left = left_over(fit.rest_n, "N", fit.r2);
        left[0].0 = tr("noise in all, rms").to_owned();
        left[1].0 = tr("R² of mean, drift and ripple").to_owned();
        left.push((tr("drift").to_owned(), format!("{} N/s", number(fit.drift_n_s))));
        let plot = FitPlot {
            title: tr("Density of the noise").to_owned(),
            over: (tr("frequency").to_owned(), "Hz"),
            unit: "N²/Hz".to_owned(),
            points: fit.spectrum,
            joined: true,
            logarithmic: true,
        };
        Ok(FitOutcome {
            summary: tr!(
                "{samples} samples about {mean:.2} N, {period} s apart",
                samples = fit.samples,
                mean = fit.mean_n,
                period = self.recording.period_s
            ),
            estimates,
            table: None,
            left,
            notes,
            plots: vec![plot],
            settings,
            file,
        })
    }
}
