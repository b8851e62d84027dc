//! Modes at the tool's tip from a measured frequency response.

use std::fmt::Write as _;

use super::outcome::{FitEstimate, FitOutcome, FitPlot, nothing_yet};
use super::request::{FitFault, FitOption, FitOptionKind, FitRequest, FitRole};
use super::{FitAbout, FitAtWork, MeasuredFit};
use crate::base::language::{fixed, in_english, text, tr};
use crate::base::math::{self, PI, TAU};
use crate::base::rng::Stream;
use crate::identify::response::{MeasuredResponse, ResponseFit, identify_structure};
use crate::models::structure::Complex;
use crate::models::tip_modes::{TipAxis, TipMode, TipModes, TipModesFile};
use crate::own_file::{OwnFile, OwnFileKind};
use crate::run::scenario::Scenario;

/// The fit.
#[derive(Debug)]
pub struct StructureFromData;

const FREQUENCY: FitRole = FitRole {
    option: "frequency",
    label: text!("Frequency"),
    about: text!("The column with the frequencies, Hz, ascending."),
    what: text!("a frequency"),
    unit: "Hz",
    needed: true,
    names: &["frequency_hz", "frequency", "f"],
    words: &["freq", "frek", "f_"],
};

const fn part(
    option: &'static str,
    label: &'static str,
    names: &'static [&'static str],
    words: &'static [&'static str],
) -> FitRole {
    FitRole {
        option,
        label,
        about: text!("Displacement over force: real and imaginary part, or magnitude and phase."),
        what: text!("a displacement over a force"),
        unit: "m/N",
        needed: false,
        names,
        words,
    }
}

const REAL: FitRole = part("real", text!("Real part"), &["real", "re"], &["real", "re"]);
const IMAGINARY: FitRole =
    part("imaginary", text!("Imaginary part"), &["imaginary", "imag", "im"], &["imag", "im"]);
const MAGNITUDE: FitRole =
    part("magnitude", text!("Magnitude"), &["magnitude", "mag"], &["mag", "ampl", "betrag"]);
const PHASE: FitRole = FitRole {
    option: "phase",
    label: text!("Phase"),
    about: text!("Displacement over force: real and imaginary part, or magnitude and phase."),
    what: text!("an angle"),
    unit: "deg",
    needed: false,
    names: &["phase_deg", "phase"],
    words: &["phase", "faz"],
};
const DIRECTION: FitOption = FitOption {
    option: "direction",
    label: text!("Direction"),
    about: text!("Whether the response is along or across the feed."),
    unit: "",
    kind: FitOptionKind::Choice(directions),
};

fn directions() -> Vec<(&'static str, String)> {
    TipAxis::ALL.iter().map(|axis| (axis.id(), tr(axis.label()).to_owned())).collect()
}

const MODES: FitOption = FitOption {
    option: "modes",
    label: text!("Number of modes"),
    about: text!("Number of modes; without it as many as there are peaks, up to 8."),
    unit: "",
    kind: FitOptionKind::Number { range: [1.0, 8.0], default: None, whole: true },
};
const KEEP: FitOption = FitOption {
    option: "keep-other",
    label: text!("Keep the other direction"),
    about: text!(
        "Keeps the modes that the scenario has in the other direction: so both come from two recordings, one after the other."
    ),
    unit: "",
    kind: FitOptionKind::Switch,
};

/// The fit while it is worked at.
#[derive(Clone, Debug)]
pub struct StructureAtWork {
    response: MeasuredResponse,
    axis: TipAxis,
    count: Option<usize>,
    kept: Vec<TipMode>,
    file: String,
    scenario: Scenario,
    found: Option<Result<ResponseFit, String>>,
}

/// The response of a request.
fn response(request: &FitRequest) -> Result<MeasuredResponse, FitFault> {
    let frequency_hz = request.needed_cells(&FREQUENCY)?;
    let [real, imaginary] = [request.cells(&REAL)?, request.cells(&IMAGINARY)?];
    let [magnitude, phase] = [request.cells(&MAGNITUDE)?, request.cells(&PHASE)?];
    let pairs = |a: Vec<f64>, b: Vec<f64>| a.into_iter().zip(b);
    let response_m_n = match (real.zip(imaginary), magnitude.zip(phase)) {
        (Some((re, im)), _) => pairs(re, im).map(|(re, im)| Complex::new(re, im)).collect(),
        (None, Some((size, degrees))) => pairs(size, degrees)
            .map(|(size, degrees)| {
                let rad = degrees * (PI / 180.0);
                Complex::new(size * math::cos(rad), size * math::sin(rad))
            })
            .collect(),
        (None, None) => return Err(no_response()),
    };
    Ok(MeasuredResponse { frequency_hz, response_m_n })
}

fn no_response() -> FitFault {
    let text = tr("choose real and imaginary part, or magnitude and phase").to_owned();
    FitFault::at(REAL.option, text)
}

impl MeasuredFit for StructureFromData {
    const ABOUT: FitAbout = FitAbout {
        title: text!("Structure"),
        finds: text!(
            "Frequencies, damping ratios and masses of the modes at the tool's tip, from which stability follows."
        ),
        needs: text!(
            "A frequency response at the tip, as of an impact test: frequency, and real and imaginary part or magnitude and phase of displacement over force; 20 lines and more."
        ),
        sample: "frequency_hz,real_m_n,imaginary_m_n",
        timed: false,
        roles: &[FREQUENCY, REAL, IMAGINARY, MAGNITUDE, PHASE],
        options: &[DIRECTION, MODES, KEEP],
        most_steps: 1,
    };
    type Work = StructureAtWork;

    fn lacks(request: &FitRequest) -> Option<FitFault> {
        let both =
            |a: &FitRole, b: &FitRole| request.chosen(a).is_some() && request.chosen(b).is_some();
        (!both(&REAL, &IMAGINARY) && !both(&MAGNITUDE, &PHASE)).then(no_response)
    }

    fn begin(request: &FitRequest) -> Result<StructureAtWork, FitFault> {
        let axis = request.id(&DIRECTION).and_then(TipAxis::from_id).unwrap_or(TipAxis::X);
        let modes = request.scenario.machine.tip_modes.all().iter().copied();
        let kept = modes.filter(|mode| mode.axis != axis && request.is_on(&KEEP));
        Ok(StructureAtWork {
            response: response(request)?,
            axis,
            count: request.number(&MODES)?.map(|count| count as usize),
            kept: kept.collect(),
            file: request.file.clone(),
            scenario: request.scenario.clone(),
            found: None,
        })
    }

    /// The response along the feed of the scenario's own modes at the tip; of an example's where it has none.
    fn sample(scenario: &Scenario, seed: u32) -> Result<String, String> {
        /// Noise as a share of the largest response.
        const NOISE: f64 = 0.001;
        const LINES: u64 = 600;
        let own = &scenario.machine.tip_modes;
        let example = TipModesFile::parse(OwnFileKind::Structure.template())
            .map_err(|error| error.to_string())?
            .modes;
        let modes = if own.along(TipAxis::X).next().is_some() { own } else { &example };
        let last_hz =
            1.6 * modes.along(TipAxis::X).map(|mode| mode.frequency_hz).fold(0.0, f64::max);
        let frequency = |k: u64| last_hz * (k as f64 + 20.0) / (LINES as f64 + 19.0);
        let line = |k: u64| modes.compliance(TipAxis::X, Complex::new(0.0, TAU * frequency(k)));
        let size = (0..LINES).map(|k| line(k).norm_sqr().sqrt()).fold(0.0, f64::max);
        let stream = Stream::new(u64::from(seed), "recorded response");
        let mut text = "frequency_hz,real_m_n,imaginary_m_n\n".to_owned();
        for k in 0..LINES {
            let noise = |part: u64| NOISE * size * stream.normal(2 * k + part);
            let (here, f_hz) = (line(k), frequency(k));
            // Into memory: it does not fail.
            let _ =
                writeln!(text, "{f_hz:.3},{:.6e},{:.6e}", here.re + noise(0), here.im + noise(1));
        }
        Ok(text)
    }
}

/// Micrometres in a metre.
const UM: f64 = 1e6;

impl FitAtWork for StructureAtWork {
    fn step(&mut self) -> bool {
        self.found = Some(identify_structure(&self.response, self.axis, self.count));
        false
    }

    fn outcome(&self) -> Result<FitOutcome, FitFault> {
        let fit = match self.found.clone().ok_or_else(nothing_yet)? {
            Ok(fit) => fit,
            // What is none of a mode was most likely a peak of the noise.
            Err(problem) if self.count.is_none() => {
                let text = tr!(
                    "{problem}; where noise makes peaks, say how many modes there are",
                    problem = problem
                );
                return Err(FitFault::at(MODES.option, text));
            }
            Err(problem) => return Err(problem.into()),
        };
        let mut estimates = Vec::new();
        for (r, [frequency, damping, mass]) in fit.estimated.iter().enumerate() {
            let number = r + 1;
            estimates.extend([
                FitEstimate::new(
                    tr!("mode {number}: frequency", number = number),
                    *frequency,
                    2,
                    "Hz",
                ),
                FitEstimate::new(
                    tr!("mode {number}: damping ratio", number = number),
                    *damping,
                    5,
                    "",
                ),
                FitEstimate::new(tr!("mode {number}: modal mass", number = number), *mass, 5, "kg"),
            ]);
        }
        let mut all = self.kept.clone();
        all.extend(fit.modes.iter().copied());
        all.sort_by_key(|mode| mode.axis);
        let mut source = vec![format!("{} from {}", self.axis.id(), self.file)];
        let mut notes = Vec::new();
        if let Some(kept) = self.kept.first() {
            source.push(format!("{} as before", kept.axis.id()));
            notes.push(tr!(
                "kept from the scenario: {n} modes {direction}",
                n = self.kept.len(),
                direction = tr(kept.axis.label())
            ));
        }
        if !self.scenario.machine.coupled {
            notes.push(
                tr("the machine does not stand in the loop (machine.coupled): the modes act in the stability chart until it does")
                    .to_owned(),
            );
        }
        notes.push(tr!(
            "flexibility of stiffer modes {flexibility} um/N, which is no mode",
            flexibility = super::outcome::number(UM * fit.residual_m_n)
        ));
        let file = TipModes::new(all).map(|modes| {
            let title = "Measured modes at the tool's tip".to_owned();
            in_english(|| TipModesFile { title, source: source.join(", "), modes }.write())
        });
        let settings = file.clone().and_then(|file| {
            let own = OwnFile::parse(OwnFileKind::Structure, &file);
            let own = own.map_err(|error| error.to_string())?;
            let set = self.scenario.clone().set_all(&own.changes);
            set.map_err(|error| error.to_string())?;
            Ok(own.changes)
        });
        let MeasuredResponse { frequency_hz, response_m_n } = &self.response;
        let plot = |title: &str, of: fn(&Complex) -> f64| FitPlot {
            title: title.to_owned(),
            over: (tr("frequency").to_owned(), "Hz"),
            unit: "um/N".to_owned(),
            points: frequency_hz
                .iter()
                .zip(response_m_n)
                .map(|(f_hz, measured)| [*f_hz, UM * of(measured), UM * of(&fit.at(*f_hz))])
                .collect(),
            joined: true,
            logarithmic: false,
        };
        let plots = vec![plot(tr("Real part"), |g| g.re), plot(tr("Imaginary part"), |g| g.im)];
        let left = vec![
            (
                tr("left over, rms").to_owned(),
                tr!("{share} % of the response", share = fixed(100.0 * fit.rest, 3)),
            ),
            ("R²".to_owned(), fixed(1.0 - fit.rest * fit.rest, 5)),
        ];
        Ok(FitOutcome {
            summary: tr!(
                "{lines} lines {direction}; modes: {n}",
                lines = frequency_hz.len(),
                direction = tr(self.axis.label()),
                n = fit.modes.len()
            ),
            estimates,
            table: None,
            left,
            notes,
            plots,
            settings,
            file,
        })
    }
}
