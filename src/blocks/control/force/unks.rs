//! UNKS, the neural control scheme of 2005: Kawato's hierarchical scheme with feedback-error
//! learning ([`crate::base::model::unks`] gives the three networks).
//!
//! ```text
//! 1  NM-1 learns: its prediction of H periods ago against the force that came of it
//! 2  u_ff = a_0 exp(NM-2(f, ln(F_ref/F_m)))                          inverse model, feed-forward
//! 3  internal loop, at most 4 times and without the plant: F^ = exp(f0 + NM-1(f, ln(u/a_0))),
//!    delta = NM-R(F_ref, F^) - 1, ends at |delta| < 0.02, u = u (1 + delta)
//! 4  u_fb = w_ext (NM-R(F_ref, F_m) - 1)                              external loop
//! 5  u = u + u_fb, at most 0.25 away from the last command
//! 6  NM-2 learns the whole feedback: ln u - ln u_ff (feedback-error learning), not at a limit
//! ```
//!
//! The first two samples after contact hold the override. Both networks really learn while the cut
//! runs; with the rates at zero they stay as shipped.

use super::{Law, Sample};
use crate::base::math::{self, limit};
use crate::base::model::unks::{REFERENCE_KN, UnksNetworks, log_force};
use crate::base::network::{Backprop, ScaledNetwork};

crate::settings! {
    /// Settings of the neural control scheme.
    pub struct UnksSettings {
        /// Weight of the external feedback loop (chosen).
        external_weight: f64 = 0.15, [0.0, 1.0], "", live, "External loop";
        /// Most iterations of the internal loop; 0 switches it off.
        internal_iterations: u32 = 4, [0.0, 10.0], "", live, "Internal loop";
        /// Learning rate of NM-1, the forward model, in the cut.
        forward_rate: f64 = 0.002, [0.0, 0.1], "", live, "NM-1 learning rate";
        /// Learning rate of NM-2, the inverse model, in the cut.
        inverse_rate: f64 = 0.002, [0.0, 0.1], "", live, "NM-2 learning rate";
        /// Whether the force is corrected for the dead time (Smith predictor); the horizon of the
        /// networks already looks beyond it.
        smith: bool = false, [], "", live, "Smith predictor";
    }
}

/// Longest horizon in control periods: half a second of dead time at 1 ms.
const MAX_HORIZON: usize = 512;
/// Samples after contact in which the override is held.
const HOLD: u32 = 2;
/// Limits of the override inside the scheme.
const LEAST: f64 = 0.02;
/// Most change of the override in a control period.
const STEP: f64 = 0.25;
/// Where the internal loop is content.
const CONTENT: f64 = 0.02;
/// Bounds of the logarithms that the networks are asked with.
const WANTED: f64 = 1.2;
const CANDIDATE: f64 = 1.5;
/// Largest normalised error that one sample may teach.
const LESSON: f64 = 0.2;
/// Overrides from the first on and up to the second teach nothing: the limits act there.
const TEACHES: [f64; 2] = [0.05, 1.49];

/// What NM-1 predicted from.
#[derive(Clone, Copy, Debug, Default)]
struct Moment {
    features: [f64; 3],
    actual: f64,
}

/// A network that learns in the cut.
#[derive(Clone, Debug)]
struct Learner {
    scaled: ScaledNetwork,
    memory: Backprop,
}

impl Learner {
    fn new(scaled: &ScaledNetwork) -> Self {
        Self { scaled: scaled.clone(), memory: Backprop::new(&scaled.network) }
    }

    fn predict(&self, features: [f64; 3], last: f64) -> f64 {
        let [a, b, c] = features;
        self.scaled.predict(&[a, b, c, last])[0]
    }

    /// Moves the answer to these inputs by a step towards `error` more of it.
    fn learn(&mut self, features: [f64; 3], last: f64, error: f64, rate: f64) {
        if rate <= 0.0 {
            return;
        }
        let [a, b, c] = features;
        let inputs = self.scaled.scaling.normal_inputs(&[a, b, c, last]);
        let mut targets = self.scaled.network.forward(&inputs);
        let [slope, _] = self.scaled.scaling.output_map(0);
        targets[0] += limit(error / slope, -LESSON, LESSON);
        self.memory.step(&mut self.scaled.network, &inputs, &targets, rate, 0.0);
    }
}

/// The scheme with its learning networks.
#[derive(Clone, Debug)]
pub struct Unks {
    pub(super) settings: UnksSettings,
    networks: &'static UnksNetworks,
    forward: Learner,
    inverse: Learner,
    horizon: usize,
    /// Moments of the last periods in contact, a ring.
    past: Vec<Moment>,
    newest: usize,
    seen: u32,
    logs: [f64; 3],
}

impl Unks {
    pub(super) fn new(settings: &UnksSettings, horizon: usize) -> Self {
        let networks = UnksNetworks::shipped();
        Self {
            settings: settings.clone(),
            networks,
            forward: Learner::new(&networks.forward),
            inverse: Learner::new(&networks.inverse),
            horizon: horizon.clamp(1, MAX_HORIZON),
            past: vec![Moment::default(); MAX_HORIZON + 1],
            newest: 0,
            seen: 0,
            logs: [0.0; 3],
        }
    }

    pub(super) fn set_horizon(&mut self, horizon: usize) {
        self.horizon = horizon.clamp(1, MAX_HORIZON);
    }

    /// Step 1: what the override of H periods ago has come to.
    fn identify(&mut self, now: f64, actual: f64) {
        if (self.seen as usize) <= self.horizon {
            return;
        }
        let n = self.past.len();
        let then = self.past[(self.newest + n - self.horizon) % n];
        let reached = limit(math::ln(actual / then.actual), -CANDIDATE, CANDIDATE);
        let predicted = self.forward.predict(then.features, reached);
        let error = now - then.features[0] - predicted;
        self.forward.learn(then.features, reached, error, self.settings.forward_rate);
    }
}

impl Law for Unks {
    fn update(&mut self, sample: &Sample) -> f64 {
        let now = log_force(sample.y);
        if sample.entered {
            (self.seen, self.logs) = (0, [now; 3]);
        }
        self.logs = [now, self.logs[0], self.logs[1]];
        let features = [now, now - self.logs[1], now - self.logs[2]];
        self.newest = (self.newest + 1) % self.past.len();
        self.past[self.newest] = Moment { features, actual: sample.actual };
        self.seen += 1;
        if self.seen <= HOLD {
            return sample.sent;
        }
        self.identify(now, sample.actual);

        let most = sample.range[1];
        let wanted = limit(-math::ln(sample.y), -WANTED, WANTED);
        let asked = self.inverse.predict(features, wanted);
        let forward_n = limit(sample.actual * math::exp(asked), LEAST, most);
        let mut u = forward_n;
        for _ in 0..self.settings.internal_iterations {
            let candidate = limit(math::ln(u / sample.actual), -CANDIDATE, CANDIDATE);
            let force_kn = math::exp(now + self.forward.predict(features, candidate));
            let delta = self.networks.ratio(REFERENCE_KN, force_kn) - 1.0;
            if delta.abs() < CONTENT {
                break;
            }
            u = limit(u * (1.0 + delta), LEAST, most);
        }
        let external = self.networks.ratio(REFERENCE_KN, sample.y * REFERENCE_KN) - 1.0;
        u = limit(u + self.settings.external_weight * external, LEAST, most);
        u = limit(u, sample.sent - STEP, sample.sent + STEP);
        if u > TEACHES[0] && u < TEACHES[1].min(most) {
            let error = math::ln(u / forward_n);
            self.inverse.learn(features, wanted, error, self.settings.inverse_rate);
        }
        u
    }
}
