//! Model-reference adaptive control in two forms (2005; Landau and Lozano's direct form as used by
//! Daneshmend and Pak and by Tomizuka, and a form that adapts one gain).
//!
//! ```text
//! landau  phi(k) = [u(k), u(k-1), u(k-2), u(k-3), y(k)],  C = 1 + c1 q^-1,  d = 3
//!         e = y(k) + c1 y(k-1) - theta phi(k-d)
//!         P = (P - P phi phi' P / (lambda + phi' P phi)) / lambda,  theta += P phi e
//!         y_m = a_m y_m + (1 - a_m)
//!         u = [y_m + c1 y_m(k-1) - sum_(i>0) theta_i phi_i] / theta_0
//! gain    K += gamma u_a (y - K u_a) / (0.05 + u_a^2),  r = a_m r + (1 - a_m),  u = r / K
//! ```
//!
//! After another controller the reference model starts where it asks for the override that is being
//! sent. phi holds the override that was really sent, so limits do not wind it up. Five parameters are
//! badly excited by a steady cut: the Landau form bursts now and then, dipping the feed for less
//! than half a second. They are not adapted while the override stands at its upper limit.

use super::ControlSetup;
use super::law::{AtRest, ControlMoment};
use super::override_loop::{COMMAND_PATH, ForceController, ForceLaw, ForceSample};
use crate::base::equation::number;
use crate::base::language::{text, tr};
use crate::base::math::limit;
use crate::models::printed::Printed;

crate::choice! {
    /// What is adapted.
    pub enum Adapted {
        /// Five parameters (Landau).
        Landau = "landau", "five parameters";
        /// The force at 100 % override alone.
        Gain = "gain", "one gain";
    }
}

crate::settings! {
    /// Settings of the model-reference adaptive controller.
    pub struct MracSettings {
        /// What is adapted.
        adapted: Adapted = Adapted::Landau, [], "", live, "Adapted";
        /// Pole a_m of the reference model of the five-parameter form (chosen near Table 1).
        pole: f64 = 0.75, [0.0, 0.99], "", live, "Model pole";
        /// Coefficient c1 of the five-parameter form's regulation (chosen near Table 1).
        regulation: f64 = -0.6, [-0.95, 0.0], "", live, "Regulation";
        /// Forgetting factor lambda of the five-parameter form (chosen near Table 1).
        forgetting: f64 = 0.96, [0.8, 1.0], "", live, "Forgetting";
        /// Adaptation gain gamma of the one-gain form (chosen).
        adaptation: f64 = 0.5, [0.001, 1.5], "", live, "Adaptation";
        /// Pole of the reference model of the one-gain form (chosen).
        gain_pole: f64 = 0.5, [0.0, 0.99], "", live, "Model pole, one gain";
        /// Whether the force is corrected for the dead time (Smith predictor).
        smith: bool = false, [], "", live, "Smith predictor";
    }
}

const N: usize = 5;
/// Delay of the five-parameter form in control periods: 40 ms of dead time and one more.
const DELAY: usize = 3;
/// How far the override may fall and rise in a control period, five-parameter form. Rising as fast
/// as it falls, a burst now and then meets a heavy section with so much feed that an overload
/// stops the machine (chosen: with 0.3 upwards, 3 of 20 runs of Experiment 2).
const STEP: [f64; 2] = [0.3, 0.1];
const COVARIANCE_START: f64 = 5.0;
const COVARIANCE_TRACE_MAX: f64 = 50.0;
const THETA_START: [f64; N] = [0.25, 0.1, 0.1, 0.1, 0.3];
/// Bounds of the estimated gain, in units of F_ref.
const GAIN_RANGE: [f64; 2] = [0.3, 4.0];

/// The controller.
pub type Mrac = ForceController<MracLaw>;

/// The law with its estimates.
#[derive(Clone, Debug)]
pub struct MracLaw {
    settings: MracSettings,
    theta: [f64; N],
    covariance: [[f64; N]; N],
    /// The regressors of the last periods, newest first.
    past: [[f64; N]; DELAY],
    model: f64,
    y_before: f64,
    gain: f64,
}

fn diagonal(value: f64) -> [[f64; N]; N] {
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { value } else { 0.0 }))
}

fn dot(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

impl MracLaw {
    fn landau(&mut self, sample: &ForceSample) -> f64 {
        let MracSettings { pole, regulation: c1, forgetting, .. } = self.settings;
        if sample.entered {
            (self.model, self.y_before) = (sample.y, sample.y);
            self.past = [[sample.sent, sample.sent, sample.sent, sample.sent, sample.y]; DELAY];
        }
        // The newest regressor so far lacks the command that was sent in its period.
        self.past[0][0] = sample.sent;
        let phi = self.past[DELAY - 1];
        if sample.sent < sample.range[1] && !sample.entered {
            self.adapt(&phi, sample.y + c1 * self.y_before - dot(&self.theta, &phi), forgetting);
        }
        let model_before = self.model;
        self.model = pole * self.model + (1.0 - pole);
        self.past.rotate_right(1);
        let [sent, older, oldest, ..] = self.past[1];
        // The command of this period takes the first place once it is known to have been sent.
        self.past[0] = [0.0, sent, older, oldest, sample.y];
        let known = dot(&self.theta, &self.past[0]);
        let model = if sample.taken_over {
            // A reference model at rest where it asks for what is being sent; it goes to 1 from there.
            self.model = (known + self.theta[0] * sample.sent) / (1.0 + c1);
            (1.0 + c1) * self.model
        } else {
            self.model + c1 * model_before
        };
        let asked = (model - known) / self.theta[0];
        self.y_before = sample.y;
        limit(asked, sample.sent - STEP[0], sample.sent + STEP[1])
    }

    /// One step of recursive least squares with forgetting factor lambda.
    fn adapt(&mut self, phi: &[f64; N], error: f64, forgetting: f64) {
        let spread: [f64; N] = std::array::from_fn(|i| dot(&self.covariance[i], phi));
        let power = dot(&spread, phi);
        let share = forgetting + power;
        let entry = |i: usize, j: usize| {
            // The mean of both triangles: rounding must not make the matrix lopsided.
            let mean = 0.5 * (self.covariance[i][j] + self.covariance[j][i]);
            (mean - spread[i] * spread[j] / share) / forgetting
        };
        let next: [[f64; N]; N] = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
        let trace: f64 = (0..N).map(|i| next[i][i]).sum();
        let scale = if trace > COVARIANCE_TRACE_MAX { COVARIANCE_TRACE_MAX / trace } else { 1.0 };
        let lost = power < 0.0 || (0..N).any(|i| next[i][i] * scale <= 1e-9);
        self.covariance =
            if lost { diagonal(COVARIANCE_START) } else { next.map(|row| row.map(|x| x * scale)) };
        for (theta, row) in self.theta.iter_mut().zip(&self.covariance) {
            *theta = limit(*theta + dot(row, phi) * error, -3.0, 3.0);
        }
        self.theta[0] = self.theta[0].max(0.05);
    }

    fn one_gain(&mut self, sample: &ForceSample) -> f64 {
        let (y, a) = (sample.y, sample.actual);
        if sample.entered {
            (self.gain, self.model) = (y / a, y);
        }
        self.gain += self.settings.adaptation * a * (y - self.gain * a) / (0.05 + a * a);
        self.gain = limit(self.gain, GAIN_RANGE[0], GAIN_RANGE[1]);
        let pole = self.settings.gain_pole;
        self.model = if sample.taken_over {
            self.gain * sample.sent
        } else {
            pole * self.model + (1.0 - pole)
        };
        self.model / self.gain
    }
}

impl ForceLaw for MracLaw {
    type Settings = MracSettings;
    const ABOUT: &'static str = "Model-reference adaptive control (2005).";

    fn new(settings: &MracSettings, _: &ControlSetup) -> Self {
        Self {
            settings: settings.clone(),
            theta: THETA_START,
            covariance: diagonal(COVARIANCE_START),
            past: [[1.0, 1.0, 1.0, 1.0, 0.0]; DELAY],
            model: 1.0,
            y_before: 0.0,
            gain: 1.0,
        }
    }

    fn configure(&mut self, settings: &MracSettings, _: &ControlSetup) {
        self.settings = settings.clone();
    }

    fn smith(settings: &MracSettings) -> bool {
        settings.smith
    }

    fn update(&mut self, sample: &ForceSample) -> f64 {
        match self.settings.adapted {
            Adapted::Landau => self.landau(sample),
            Adapted::Gain => self.one_gain(sample),
        }
    }

    fn gain(&self) -> f64 {
        match self.settings.adapted {
            Adapted::Landau => 1.0,
            Adapted::Gain => self.gain,
        }
    }

    fn at_rest(_: &MracSettings) -> AtRest {
        AtRest::OnReference
    }

    /// What was reached is asked for by the one-gain form, and by the Smith predictor.
    fn believes(settings: &MracSettings) -> &'static [&'static str] {
        if settings.smith || settings.adapted == Adapted::Gain { COMMAND_PATH } else { &[] }
    }

    fn left_out(settings: &MracSettings) -> &'static [&'static str] {
        match settings.adapted {
            Adapted::Landau => &["adaptation", "gain_pole"],
            Adapted::Gain => &["pole", "regulation", "forgetting"],
        }
    }

    fn printed(settings: &MracSettings) -> Printed {
        match settings.adapted {
            Adapted::Landau => Printed::new(
                "u = [y_m + c_1 y_{m,before} - Σ_{i>0} θ_i φ_i] / θ_0",
                text!(
                    "Landau and Lozano's direct form, as Daneshmend and Pak and Tomizuka, cited in \
                 Combined system 2005, used it; numbers chosen"
                ),
            ),
            Adapted::Gain => Printed::new(
                "u = r / K,  K' = γ u_a (y - K u_a) / (0.05 + u_a^2)",
                text!(
                    "chosen: model-reference adaptive control of Combined system 2005 with one gain"
                ),
            ),
        }
    }

    fn explain(settings: &MracSettings, moment: &ControlMoment) -> (String, String) {
        match settings.adapted {
            Adapted::Landau => (tr("u from five adapted parameters θ φ").to_owned(), String::new()),
            Adapted::Gain => {
                ("u = r / K".to_owned(), format!("K = {}", number(moment.gain_estimate)))
            }
        }
    }
}
