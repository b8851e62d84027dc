//! UNKS, the neural control scheme of 2005: Kawato's hierarchical scheme with feedback-error
//! learning ([`crate::models::unks`] gives the three networks).
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
//! runs; with the rates at zero they stay as they began. `unks/cold.rs` is the scheme without networks
//! that were trained before.

mod cold;
mod learner;

use learner::Learner;

use super::ControlSetup;
use super::law::{AtRest, ControlMoment};
use super::override_loop::{ForceController, ForceLaw, ForceSample, periods};
use crate::base::language::text;
use crate::base::math::{self, limit};
use crate::base::network::ScaledNetwork;
use crate::models::printed::Printed;
use crate::models::unks::{
    HORIZON_BEYOND, REFERENCE_KN, StoredNetworks, UnksNetworks, UnksStart, log_force,
};

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
        /// What the scheme begins with, and by which law it works.
        start: UnksStart = UnksStart::Shipped, [], "", setup, "Start";
        /// Learning rate of NM-2 from a cold start; larger ones learn in seconds and drift later.
        cold_rate: f64 = 0.003, [0.0, 0.1], "", live, "Cold learning rate";
        /// Seed of NM-2's first weights from a cold start. How much a first pass already learns
        /// depends on them.
        first_weights: u32 = 1, [0.0, 4_294_967_295.0], "", setup, "First weights";
        /// Networks to begin with, learned in a cut before; empty for those of the start.
        networks: StoredNetworks = StoredNetworks::default(), [], "", setup, "Learned networks";
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
/// Relative error below which the internal loop stops iterating.
const CONTENT: f64 = 0.02;
/// Bounds of the logarithms that enter the networks: the wanted change of the force, and the change of
/// the override.
const WANTED: f64 = 1.2;
const CANDIDATE: f64 = 1.5;
/// Largest normalised error that one sample may train with.
const LESSON: f64 = 0.2;
/// Only overrides between these two train the networks: outside, the limits act.
const TEACHES: [f64; 2] = [0.05, 1.49];

/// Whether an override is far enough from its limits that the feedback's request may train.
fn free(u: f64, most: f64) -> bool {
    u > TEACHES[0] && u < TEACHES[1].min(most)
}

/// What NM-1 predicted from.
#[derive(Clone, Copy, Debug, Default)]
struct Moment {
    features: [f64; 3],
    actual: f64,
}

/// What the scheme did last, for display; nothing of it acts back.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LearningTrace {
    /// Samples in contact so far, without those in which the override was held.
    pub samples: u32,
    /// Override that NM-2 asked for.
    pub feed_forward: f64,
    /// What the feedback added to it, as a fraction of the programmed feed: all loops of the trained
    /// scheme, u_fb from a cold start.
    pub feedback: f64,
    /// Whether the override stood between its limits, so that the feedback could act and train NM-2.
    pub free: bool,
    /// Iterations of the internal loop.
    pub iterations: u32,
    /// Error of NM-1's prediction, ln F; 0 where there was none to judge.
    pub prediction_error: f64,
    /// Mean of |feedback| over about 50 samples between the limits, a second of the papers' control
    /// period.
    pub feedback_mean: f64,
    /// Mean of |prediction_error| over about 50 samples.
    pub error_mean: f64,
    /// Samples in the two means.
    counts: [u32; 2],
}

/// Weight of a new sample in the running means after 1/WEIGHT = 50 samples; before that, their plain mean.
const WEIGHT: f64 = 0.02;

/// Updates the running mean of |value|; `count` is the number of samples so far.
fn average(mean: &mut f64, count: &mut u32, value: f64) {
    *count = count.saturating_add(1);
    *mean += WEIGHT.max(1.0 / f64::from(*count)) * (value.abs() - *mean);
}

impl LearningTrace {
    fn note(&mut self, feed_forward: f64, feedback: f64, iterations: u32, free: bool) {
        (self.feed_forward, self.feedback) = (feed_forward, feedback);
        (self.iterations, self.free) = (iterations, free);
        if free {
            average(&mut self.feedback_mean, &mut self.counts[0], feedback);
        }
        self.samples = self.samples.saturating_add(1);
    }

    fn note_error(&mut self, error: f64) {
        self.prediction_error = error;
        average(&mut self.error_mean, &mut self.counts[1], error);
    }
}

/// The state of the learning, for display.
#[derive(Clone, Copy, Debug)]
pub struct Learning<'a> {
    /// What the scheme began with, and so its law.
    pub start: UnksStart,
    /// The networks it began with.
    pub initial: &'a UnksNetworks,
    /// NM-1 as it is now.
    pub forward: &'a ScaledNetwork,
    /// NM-2 as it is now.
    pub inverse: &'a ScaledNetwork,
    /// Number of samples that NM-1 and NM-2 were trained with.
    pub lessons: [u32; 2],
    /// What the scheme did last.
    pub trace: LearningTrace,
}

impl Learning<'_> {
    /// The networks as they are now.
    #[must_use]
    pub fn now(&self) -> UnksNetworks {
        UnksNetworks {
            reference: self.initial.reference.clone(),
            forward: self.forward.clone(),
            inverse: self.inverse.clone(),
        }
    }
}

/// What the scheme has no use for from a cold start.
const COLD: &[&str] = &["external_weight", "internal_iterations", "forward_rate", "inverse_rate"];
/// The same where its networks are given.
const COLD_AND_LEARNED: &[&str] =
    &["external_weight", "internal_iterations", "forward_rate", "inverse_rate", "first_weights"];

/// The controller.
pub type Unks = ForceController<UnksLaw>;

/// The scheme with its learning networks.
#[derive(Clone, Debug)]
pub struct UnksLaw {
    settings: UnksSettings,
    networks: UnksNetworks,
    forward: Learner,
    inverse: Learner,
    horizon: usize,
    /// Moments of the last periods in contact, a ring.
    past: Vec<Moment>,
    newest: usize,
    seen: u32,
    logs: [f64; 3],
    trace: LearningTrace,
}

/// How far the scheme looks ahead, in control periods.
fn horizon(setup: &ControlSetup) -> usize {
    (periods(setup) + HORIZON_BEYOND).clamp(1, MAX_HORIZON)
}

impl UnksLaw {
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
        self.trace.note_error(error);
        let rate = self.settings.forward_rate;
        self.forward.learn((then.features, reached), error, LESSON, rate);
    }

    /// Steps 1 to 6 of the scheme with networks that were trained before.
    fn trained(&mut self, sample: &ForceSample, features: [f64; 3]) -> f64 {
        let now = features[0];
        self.identify(now, sample.actual);
        let most = sample.range[1];
        let wanted = limit(-math::ln(sample.y), -WANTED, WANTED);
        let asked = self.inverse.predict(features, wanted);
        let feed_forward = limit(sample.actual * math::exp(asked), LEAST, most);
        let mut u = feed_forward;
        let mut iterations = 0;
        for _ in 0..self.settings.internal_iterations {
            let candidate = limit(math::ln(u / sample.actual), -CANDIDATE, CANDIDATE);
            let force_kn = math::exp(now + self.forward.predict(features, candidate));
            let delta = self.networks.ratio(REFERENCE_KN, force_kn) - 1.0;
            if delta.abs() < CONTENT {
                break;
            }
            u = limit(u * (1.0 + delta), LEAST, most);
            iterations += 1;
        }
        let external = self.networks.ratio(REFERENCE_KN, sample.y * REFERENCE_KN) - 1.0;
        u = limit(u + self.settings.external_weight * external, LEAST, most);
        u = limit(u, sample.sent - STEP, sample.sent + STEP);
        let free = free(u, most);
        self.trace.note(feed_forward, u - feed_forward, iterations, free);
        if free {
            let error = math::ln(u / feed_forward);
            let rate = self.settings.inverse_rate;
            self.inverse.learn((features, wanted), error, LESSON, rate);
        }
        u
    }
}

impl ForceLaw for UnksLaw {
    type Settings = UnksSettings;
    const ABOUT: &'static str =
        "The neural control scheme of 2005, its networks learning in the cut.";
    const LEARNS: bool = true;

    fn new(settings: &UnksSettings, setup: &ControlSetup) -> Self {
        let stored = settings.networks.get().map(|stored| stored.networks.clone());
        let networks = stored
            .unwrap_or_else(|| UnksNetworks::at_start(settings.start, settings.first_weights));
        Self {
            settings: settings.clone(),
            forward: Learner::new(&networks.forward),
            inverse: Learner::new(&networks.inverse),
            networks,
            trace: LearningTrace::default(),
            horizon: horizon(setup),
            past: vec![Moment::default(); MAX_HORIZON + 1],
            newest: 0,
            seen: 0,
            logs: [0.0; 3],
        }
    }

    fn configure(&mut self, settings: &UnksSettings, setup: &ControlSetup) {
        self.settings = settings.clone();
        self.horizon = horizon(setup);
    }

    fn smith(settings: &UnksSettings) -> bool {
        settings.smith
    }

    fn learning(&self) -> Option<Learning<'_>> {
        Some(Learning {
            start: self.settings.start,
            initial: &self.networks,
            forward: &self.forward.scaled,
            inverse: &self.inverse.scaled,
            lessons: [self.forward.lessons, self.inverse.lessons],
            trace: self.trace,
        })
    }

    fn update(&mut self, sample: &ForceSample) -> f64 {
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
        match self.settings.start {
            UnksStart::Shipped => self.trained(sample, features),
            UnksStart::Cold => self.cold(sample, self.logs),
        }
    }

    fn at_rest(_: &UnksSettings) -> AtRest {
        AtRest::NearReference
    }

    fn left_out(settings: &UnksSettings) -> &'static [&'static str] {
        match settings.start {
            UnksStart::Shipped => &["cold_rate", "first_weights"],
            UnksStart::Cold if settings.networks.get().is_some() => COLD_AND_LEARNED,
            UnksStart::Cold => COLD,
        }
    }

    fn printed(settings: &UnksSettings) -> Printed {
        match settings.start {
            UnksStart::Shipped => Printed::new(
                "u = a_0 e^{NM-2} · internal loop + w_{ext} (NM-R(F_{ref}, F_m) - 1)",
                text!(
                    "Combined system 2005: UNKS, after Kawato's hierarchical scheme; weights and rates \
                 were never published"
                ),
            ),
            UnksStart::Cold => Printed::new(
                "u = e^{NM-2} + NM-R(F_{ref}, F_m) - 1",
                text!(
                    "feedback-error learning (Miyamoto, Kawato, Setoyama, Suzuki 1988), on which UNKS of \
                 Combined system 2005 rests"
                ),
            ),
        }
    }

    fn explain(settings: &UnksSettings, _: &ControlMoment) -> (String, String) {
        let formula = match settings.start {
            UnksStart::Shipped => {
                "u = a_0 e^{NM-2} · internal loop + w_{ext} (NM-R(F_{ref}, F_m) - 1)"
            }
            UnksStart::Cold => "u = e^{NM-2} + NM-R(F_{ref}, F_m) - 1",
        };
        (formula.to_owned(), String::new())
    }
}
