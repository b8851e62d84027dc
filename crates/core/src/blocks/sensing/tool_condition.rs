//! Tool-condition estimator: predicts the tool's life from the sound of the cut (2019;
//! [`crate::models::tool_life`]).
//!
//! ```text
//! E = E_S / rms(F_b v(n))       both over the last second; v(n) the velocity that 1 N makes at a speed
//! a += time_scale dt T(programmed)/T(now)                        age in minutes at the programmed cut
//! ```
//!
//! F_b is the force of a sharp tool by the controller's force model, so that neither feed nor speed is
//! mistaken for wear; its error in size is E0, which the prediction eliminates. The sound of the modes
//! grows as the force does: E/E0 = 1 + kappa w, without process damping. Known: Taylor's exponents and
//! the wear's shape; unknown: the life of this very tool. One observation enters for each minute of the
//! tool's life.

use std::collections::VecDeque;

use crate::base::stats;
use crate::models::machine_trend::LifeSettings;
use crate::models::structure::engagement::EngagementAngles;
use crate::models::structure::pulses::velocity_m_s_n;
use crate::models::structure::reduction::Reduction;
use crate::models::tool_life::{Growth, LifePrediction, Predictor};
use crate::models::wear::{WearCut, WearSettings};

/// Window of the sound, s.
const WINDOW_S: f64 = 1.0;
/// Most samples of the window, at control periods of a millisecond; room for them is taken once.
const WINDOW_SAMPLES: usize = 1002;
/// Time in the cut before the sound is used: its window and the decay of the first impact, s.
const SETTLING_S: f64 = 1.5;

/// What is known beforehand.
#[derive(Clone, Debug)]
pub struct EstimatorSetup {
    /// The machine, reduced.
    pub machine: Reduction,
    /// Number of teeth.
    pub teeth: u32,
    /// Diameter of the cutter, mm.
    pub diameter_mm: f64,
    /// The law of wear.
    pub wear: WearSettings,
    /// What is expected of the sound.
    pub life: LifeSettings,
    /// The programmed cut, in whose minutes the age counts.
    pub programmed: WearCut,
}

/// What is observed of the cut over an interval of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutObservation {
    /// Length, s.
    pub dt_s: f64,
    /// What wears the tool.
    pub cut: WearCut,
    /// Spindle speed, 1/min.
    pub speed_rpm: f64,
    /// Radial depth, mm.
    pub radial_depth_mm: f64,
    /// Force of a sharp tool by the controller's model, N.
    pub sharp_force_n: f64,
    /// The sound, m/s.
    pub sound_m_s: f64,
    /// The tool is in the material.
    pub in_cut: bool,
}

/// The estimator: its knowledge of the cut and its belief about the tool.
#[derive(Clone, Debug)]
pub struct ToolConditionEstimator {
    setup: EstimatorSetup,
    predictor: Predictor,
    prior_min: f64,
    age_min: f64,
    minutes: f64,
    settled_s: f64,
    /// (F_b v)^2 over the window, the latest last.
    expected: VecDeque<f64>,
    /// Speed in 1/min and radial depth in mm, and the velocity v per newton there, m/s/N.
    sensitivity: ([f64; 2], f64),
}

impl ToolConditionEstimator {
    /// Before the first observation; the age is that of a tool that has used the stated fraction of
    /// its life.
    #[must_use]
    pub fn new(setup: EstimatorSetup) -> Self {
        let EstimatorSetup { wear, life, programmed, .. } = &setup;
        let prior_min = wear.usual_life_min(programmed);
        let growth = Growth::linear(wear.force_factor(1.0));
        let age_min =
            if wear.used_life > 0.0 { wear.used_life * wear.life_min(programmed) } else { 0.0 };
        Self {
            predictor: Predictor::new(wear, &growth, life, prior_min),
            prior_min,
            age_min,
            minutes: age_min.floor(),
            settled_s: 0.0,
            expected: VecDeque::with_capacity(WINDOW_SAMPLES),
            sensitivity: ([0.0; 2], 0.0),
            setup,
        }
    }

    /// Takes over the time scale and the exponents of Taylor's equation; the belief stays.
    pub fn reconfigure(&mut self, wear: &WearSettings) {
        self.setup.wear = wear.clone();
        self.prior_min = wear.usual_life_min(&self.setup.programmed);
    }

    /// Life at `cut` over that at the programmed one.
    #[must_use]
    pub fn life_ratio(&self, cut: &WearCut) -> f64 {
        self.setup.wear.usual_life_min(cut) / self.prior_min
    }

    /// Age of the tool in minutes at the programmed cut.
    #[must_use]
    pub fn age_min(&self) -> f64 {
        self.age_min
    }

    /// The square of the sound that a sharp tool should make, (m/s)^2.
    fn expect(&mut self, observation: &CutObservation) -> f64 {
        let at = [observation.speed_rpm, observation.radial_depth_mm];
        if at != self.sensitivity.0 {
            let EstimatorSetup { machine, teeth, diameter_mm, .. } = &self.setup;
            let engaged =
                EngagementAngles::side_milling(*teeth, observation.radial_depth_mm, *diameter_mm);
            self.sensitivity = (at, velocity_m_s_n(machine, &engaged, observation.speed_rpm));
        }
        let sound_m_s = observation.sharp_force_n * self.sensitivity.1;
        sound_m_s * sound_m_s
    }

    /// Takes an interval of the cut; returns a prediction after every minute of the tool's life.
    pub fn observe(&mut self, observation: &CutObservation) -> Option<LifePrediction> {
        let life_ratio = self.life_ratio(&observation.cut);
        if !(observation.in_cut && life_ratio.is_finite() && life_ratio > 0.0) {
            self.settled_s = 0.0;
            self.expected.clear();
            return None;
        }
        let rate_min_s = self.setup.wear.time_scale / (60.0 * life_ratio);
        self.age_min += rate_min_s * observation.dt_s;
        self.settled_s += observation.dt_s;
        let expected = self.expect(observation);
        self.expected.push_back(expected);
        if self.expected.len() as f64 * observation.dt_s > WINDOW_S {
            self.expected.pop_front();
        }
        if self.age_min < self.minutes + 1.0 {
            return None;
        }
        self.minutes = self.age_min.floor();
        if self.settled_s < SETTLING_S {
            return None;
        }
        let mean = stats::mean(self.expected.iter().copied()).unwrap_or(f64::NAN);
        let middle_min = self.age_min - 0.5 * WINDOW_S * rate_min_s;
        self.predictor.observe(middle_min, observation.sound_m_s / mean.sqrt());
        self.predictor.prediction()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::structure::{FiveMass, MachineSettings};

    const CUT: WearCut =
        WearCut { cutting_speed_m_min: 80.0, feed_per_tooth_mm: 0.135, axial_depth_mm: 2.0 };

    fn estimator() -> ToolConditionEstimator {
        ToolConditionEstimator::new(EstimatorSetup {
            machine: Reduction::new(&FiveMass::new(&MachineSettings::default())).unwrap(),
            teeth: 2,
            diameter_mm: 16.0,
            wear: WearSettings::default(),
            life: LifeSettings::default(),
            programmed: CUT,
        })
    }

    /// A tool of 180 min; from minute 60 on at another speed, with whose sensitivity the sound changes.
    #[test]
    fn another_speed_is_not_mistaken_for_wear() {
        let mut estimator = estimator();
        let (machine, wear) = (estimator.setup.machine, WearSettings::default());
        let engaged = EngagementAngles::side_milling(2, 3.0, 16.0);
        let mut last = None;
        for second in 0..9000 {
            let speed_rpm = if second < 3600 { 1592.0 } else { 1400.0 };
            let cut = WearCut { cutting_speed_m_min: 80.0 * speed_rpm / 1592.0, ..CUT };
            let x = estimator.age_min() / 180.0;
            let force = 170.0 * wear.force_factor(wear.wear(x));
            let observation = CutObservation {
                dt_s: 1.0,
                cut,
                speed_rpm,
                radial_depth_mm: 3.0,
                sharp_force_n: 200.0,
                sound_m_s: force * velocity_m_s_n(&machine, &engaged, speed_rpm),
                in_cut: true,
            };
            last = estimator.observe(&observation).or(last);
        }
        let age = estimator.age_min();
        // Taylor: 60 min, and 90 min at a speed that wears (1400/1592)^4 as fast.
        assert!((age - (60.0 + 90.0 * 0.598)).abs() < 0.1, "{age}");
        let prediction = last.unwrap();
        assert!((prediction.life_min / 180.0 - 1.0).abs() < 0.1, "{prediction:?}");
        assert!((prediction.first_sound - 0.85).abs() < 0.02, "{prediction:?}");
    }

    #[test]
    fn the_sound_counts_once_it_has_settled_and_at_the_middle_of_its_second() {
        let mut estimator = estimator();
        estimator.setup.wear.time_scale = 60.0;
        let observation = CutObservation {
            dt_s: 0.5,
            cut: CUT,
            speed_rpm: 1592.0,
            radial_depth_mm: 3.0,
            sharp_force_n: 200.0,
            sound_m_s: 1e-3,
            in_cut: true,
        };
        let seen: Vec<Option<f64>> = (0..4)
            .map(|_| estimator.observe(&observation).map(|prediction| prediction.age_min))
            .collect();
        // A minute of the tool in a second: the first one ends before the machine has settled.
        assert_eq!(seen, [None, None, None, Some(1.5)]);
    }

    #[test]
    fn air_and_values_that_are_not_finite_are_not_observed() {
        let mut estimator = estimator();
        let air = CutObservation {
            dt_s: 60.0,
            cut: CUT,
            speed_rpm: 1592.0,
            radial_depth_mm: 3.0,
            sharp_force_n: 0.0,
            sound_m_s: f64::NAN,
            in_cut: false,
        };
        assert_eq!(estimator.observe(&air), None);
        assert_eq!(estimator.age_min(), 0.0);
        let prediction = estimator.observe(&CutObservation { in_cut: true, ..air }).unwrap();
        assert!(
            (prediction.life_min / 240.0 - 1.0).abs() < 1e-9,
            "the prior alone: {prediction:?}"
        );
    }
}
