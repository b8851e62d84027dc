//! Listens to the cut and foretells the tool's life (2019; [`crate::models::tool_life`]).
//!
//! ```text
//! E = E_S / rms(F_b v(n))       both over the last second; v(n) the velocity that 1 N makes at a speed
//! a += time_scale dt T(programmed)/T(now)                        age in minutes at the programmed cut
//! ```
//!
//! F_b is what the controller's force model says of a sharp tool, so that neither feed nor speed is
//! heard as wear; its error in size is E0, which the forecast eliminates. The sound of the modes grows as
//! the force does: E/E0 = 1 + kappa w, without process damping. Known: Taylor's exponents and the wear's
//! shape; not known: how long this very tool lives. Heard once in a minute of the tool's life.

use std::collections::VecDeque;

use crate::models::machine::engagement::EngagementAngles;
use crate::models::machine::pulses::velocity_m_s_n;
use crate::models::machine::reduction::Reduction;
use crate::models::machine_trend::LifeSettings;
use crate::models::tool_life::{Forecast, Growth, Predictor};
use crate::models::wear::{WearCut, WearSettings};

/// Window of the sound, s.
const WINDOW_S: f64 = 1.0;
/// Time in the cut before anything is taken from the sound: its window and the first strike's decay, s.
const SETTLING_S: f64 = 1.5;

/// What is known beforehand.
#[derive(Clone, Debug)]
pub struct ListenerSetup {
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

/// The cut over a stretch of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Listened {
    /// Length, s.
    pub dt_s: f64,
    /// What wears the tool.
    pub cut: WearCut,
    /// Spindle speed, 1/min.
    pub speed_rpm: f64,
    /// Radial depth, mm.
    pub radial_depth_mm: f64,
    /// Force of a sharp tool as far as known, N.
    pub sharp_force_n: f64,
    /// The sound, m/s.
    pub sound_m_s: f64,
    /// The tool is in the material.
    pub in_cut: bool,
}

/// The listener with its belief.
#[derive(Clone, Debug)]
pub struct Listener {
    setup: ListenerSetup,
    predictor: Predictor,
    prior_min: f64,
    age_min: f64,
    minutes: f64,
    settled_s: f64,
    /// (F_b v)^2 over the window, the latest last.
    expected: VecDeque<f64>,
    /// Speed in 1/min and radial depth in mm, and v there.
    loudness: ([f64; 2], f64),
}

impl Listener {
    /// Before anything is heard; the age is that of a tool that has its stated share of the life
    /// behind it.
    #[must_use]
    pub fn new(setup: ListenerSetup) -> Self {
        let ListenerSetup { wear, life, programmed, .. } = &setup;
        let prior_min = wear.taylor_min(programmed);
        let growth = Growth::linear(wear.force_factor(1.0));
        let age_min =
            if wear.used_life > 0.0 { wear.used_life * wear.life_min(programmed) } else { 0.0 };
        Self {
            predictor: Predictor::new(wear, &growth, life, prior_min),
            prior_min,
            age_min,
            minutes: age_min.floor(),
            settled_s: 0.0,
            expected: VecDeque::new(),
            loudness: ([0.0; 2], 0.0),
            setup,
        }
    }

    /// Takes over how fast the life passes and what the speed does to it; the belief stays.
    pub fn reconfigure(&mut self, wear: &WearSettings) {
        self.setup.wear = wear.clone();
        self.prior_min = wear.taylor_min(&self.setup.programmed);
    }

    /// Life at `cut` over that at the programmed one.
    #[must_use]
    pub fn stretch(&self, cut: &WearCut) -> f64 {
        self.setup.wear.taylor_min(cut) / self.prior_min
    }

    /// Age of the tool in minutes at the programmed cut.
    #[must_use]
    pub fn age_min(&self) -> f64 {
        self.age_min
    }

    /// The square of the sound that a sharp tool should make, (m/s)^2.
    fn expect(&mut self, heard: &Listened) -> f64 {
        let at = [heard.speed_rpm, heard.radial_depth_mm];
        if at != self.loudness.0 {
            let ListenerSetup { machine, teeth, diameter_mm, .. } = &self.setup;
            let engaged =
                EngagementAngles::side_milling(*teeth, heard.radial_depth_mm, *diameter_mm);
            self.loudness = (at, velocity_m_s_n(machine, &engaged, heard.speed_rpm));
        }
        let sound_m_s = heard.sharp_force_n * self.loudness.1;
        sound_m_s * sound_m_s
    }

    /// Listens to a stretch of the cut; a forecast with every minute of the tool's life that is heard.
    pub fn hear(&mut self, heard: &Listened) -> Option<Forecast> {
        let stretch = self.stretch(&heard.cut);
        if !(heard.in_cut && stretch.is_finite() && stretch > 0.0) {
            self.settled_s = 0.0;
            self.expected.clear();
            return None;
        }
        let rate_min_s = self.setup.wear.time_scale / (60.0 * stretch);
        self.age_min += rate_min_s * heard.dt_s;
        self.settled_s += heard.dt_s;
        let expected = self.expect(heard);
        self.expected.push_back(expected);
        if self.expected.len() as f64 * heard.dt_s > WINDOW_S {
            self.expected.pop_front();
        }
        if self.age_min < self.minutes + 1.0 {
            return None;
        }
        self.minutes = self.age_min.floor();
        if self.settled_s < SETTLING_S {
            return None;
        }
        let mean = self.expected.iter().sum::<f64>() / self.expected.len() as f64;
        let middle_min = self.age_min - 0.5 * WINDOW_S * rate_min_s;
        self.predictor.hear(middle_min, heard.sound_m_s / mean.sqrt());
        self.predictor.forecast()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::machine::{FiveMass, MachineSettings};

    const CUT: WearCut =
        WearCut { cutting_speed_m_min: 80.0, feed_per_tooth_mm: 0.135, axial_depth_mm: 2.0 };

    fn listener() -> Listener {
        Listener::new(ListenerSetup {
            machine: Reduction::new(&FiveMass::new(&MachineSettings::default())).unwrap(),
            teeth: 2,
            diameter_mm: 16.0,
            wear: WearSettings::default(),
            life: LifeSettings::default(),
            programmed: CUT,
        })
    }

    /// A tool of 180 min; from minute 60 on at another speed, by whose loudness the sound changes.
    #[test]
    fn another_speed_is_not_heard_as_wear() {
        let mut listener = listener();
        let (machine, wear) = (listener.setup.machine, WearSettings::default());
        let engaged = EngagementAngles::side_milling(2, 3.0, 16.0);
        let mut last = None;
        for second in 0..9000 {
            let speed_rpm = if second < 3600 { 1592.0 } else { 1400.0 };
            let cut = WearCut { cutting_speed_m_min: 80.0 * speed_rpm / 1592.0, ..CUT };
            let x = listener.age_min() / 180.0;
            let force = 170.0 * wear.force_factor(wear.wear(x));
            let heard = Listened {
                dt_s: 1.0,
                cut,
                speed_rpm,
                radial_depth_mm: 3.0,
                sharp_force_n: 200.0,
                sound_m_s: force * velocity_m_s_n(&machine, &engaged, speed_rpm),
                in_cut: true,
            };
            last = listener.hear(&heard).or(last);
        }
        let age = listener.age_min();
        // Taylor: 60 min, and 90 min at a speed that wears (1400/1592)^4 as fast.
        assert!((age - (60.0 + 90.0 * 0.598)).abs() < 0.1, "{age}");
        let forecast = last.unwrap();
        assert!((forecast.life_min / 180.0 - 1.0).abs() < 0.1, "{forecast:?}");
        assert!((forecast.first_sound - 0.85).abs() < 0.02, "{forecast:?}");
    }

    #[test]
    fn the_air_and_nonsense_are_not_heard() {
        let mut listener = listener();
        let air = Listened {
            dt_s: 60.0,
            cut: CUT,
            speed_rpm: 1592.0,
            radial_depth_mm: 3.0,
            sharp_force_n: 0.0,
            sound_m_s: f64::NAN,
            in_cut: false,
        };
        assert_eq!(listener.hear(&air), None);
        assert_eq!(listener.age_min(), 0.0);
        let forecast = listener.hear(&Listened { in_cut: true, ..air }).unwrap();
        assert!((forecast.life_min / 240.0 - 1.0).abs() < 1e-9, "the prior alone: {forecast:?}");
    }
}
