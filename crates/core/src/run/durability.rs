//! The adaptive use of the forecast in the running cut: the programmed speed is adjusted so that the
//! tool reaches the desired durability (2019).
//!
//! ```text
//! n_new = n [ R/R_des ]^n_Taylor,   R = (T_hat - a) T(now)/T(programmed),   R_des = T_des - t
//! ```
//!
//! every ten minutes of the tool's life, which pass `wear.time_scale` times as fast as the run. The feed
//! per tooth stays, so the programmed feed goes with the speed. It is felt where a controller holds
//! the programmed speed: at constant feed and under the force controllers.

use super::scenario::Scenario;
use super::signals::{Row, flag};
use crate::base::math;
use crate::base::settings::SettingError;
use crate::blocks::control::FeedSpeed;
use crate::blocks::cutting::tool::R216_16B20_040;
use crate::blocks::sensing::listener::{Listened, Listener, ListenerSetup};
use crate::models::genetic::GeneticModels;
use crate::models::machine::FiveMass;
use crate::models::machine::reduction::Reduction;
use crate::models::wear::{WearCut, WearModel};

/// Minutes of the tool's life between two adjustments (chosen).
pub const PERIOD_MIN: f64 = 10.0;
/// The speed stays between these shares of the programmed one (chosen: the range of the overrides).
pub const SPEED_SHARES: [f64; 2] = [0.5, 1.5];
/// No adjustment in the last minutes: the rest that is wanted is too short to divide by.
pub const LAST_MIN: f64 = 10.0;

/// What of a cut at feed and speed wears the papers' tool, at an axial depth in mm.
#[must_use]
pub fn wear_cut(at: FeedSpeed, axial_depth_mm: f64) -> WearCut {
    let tool = R216_16B20_040;
    WearCut {
        cutting_speed_m_min: at.speed_rpm / tool.speed_rpm(1.0),
        feed_per_tooth_mm: at.feed_mm_min / (tool.teeth * at.speed_rpm),
        axial_depth_mm,
    }
}

/// The listener of a scenario before the cut.
///
/// # Errors
/// As [`Reduction::new`].
pub fn listener(scenario: &Scenario) -> Result<Listener, SettingError> {
    let tool = R216_16B20_040;
    Ok(Listener::new(ListenerSetup {
        machine: Reduction::new(&FiveMass::new(&scenario.machine))?,
        teeth: tool.teeth as u32,
        diameter_mm: tool.diameter_mm,
        wear: scenario.wear.clone(),
        life: scenario.life.clone(),
        programmed: wear_cut(scenario.programmed(0), scenario.workpiece.axial_depth_mm),
    }))
}

/// What a row lets hear, for `dt_s`; `belief` gives the force of a sharp tool.
#[must_use]
pub fn listened(row: &Row, belief: &GeneticModels, dt_s: f64) -> Listened {
    let at = FeedSpeed { feed_mm_min: row.feed_mm_min, speed_rpm: row.spindle_rpm };
    let force_n = belief.force(at.feed_mm_min, at.speed_rpm).value;
    Listened {
        dt_s,
        cut: wear_cut(at, row.axial_depth_mm),
        speed_rpm: row.spindle_rpm,
        radial_depth_mm: row.radial_depth_mm,
        sharp_force_n: force_n * row.axial_depth_mm,
        sound_m_s: 1e-3 * row.sound_mm_s,
        in_cut: !row.has(flag::AIR),
    }
}

/// The adjustment of the speed in a run.
#[derive(Clone, Debug)]
pub struct Durability {
    listener: Listener,
    desired_min: f64,
    taylor_exponent: f64,
    time_scale: f64,
    /// Minutes in cut; the next adjustment.
    time_min: f64,
    next_min: f64,
    /// Speed over the programmed one.
    share: f64,
}

impl Durability {
    /// The adjustment of a scenario; `None` where it is off, or nothing wears or is heard.
    #[must_use]
    pub fn new(scenario: &Scenario) -> Option<Box<Self>> {
        let (wear, machine) = (&scenario.wear, &scenario.machine);
        if !(wear.adjust_speed && wear.model == WearModel::Life && machine.coupled) {
            return None;
        }
        let listener = listener(scenario).ok()?;
        Some(Box::new(Self {
            desired_min: scenario.life.durability_min,
            taylor_exponent: wear.taylor_exponent,
            time_scale: wear.time_scale,
            time_min: listener.age_min(),
            next_min: listener.age_min() + PERIOD_MIN,
            share: 1.0,
            listener,
        }))
    }

    /// Takes over changed settings; what was heard stays.
    pub fn reconfigure(&mut self, scenario: &Scenario) {
        self.listener.reconfigure(&scenario.wear);
        self.desired_min = scenario.life.durability_min;
        self.taylor_exponent = scenario.wear.taylor_exponent;
        self.time_scale = scenario.wear.time_scale;
    }

    /// Feed and speed in place of the programmed ones.
    #[must_use]
    pub fn adjusted(&self, programmed: FeedSpeed) -> FeedSpeed {
        FeedSpeed {
            feed_mm_min: self.share * programmed.feed_mm_min,
            speed_rpm: self.share * programmed.speed_rpm,
        }
    }

    /// Lets `dt_s` of the cut in `row` pass.
    pub fn update(&mut self, row: &Row, belief: &GeneticModels, dt_s: f64) {
        let heard = listened(row, belief, dt_s);
        if heard.in_cut {
            self.time_min += self.time_scale * dt_s / 60.0;
        }
        let Some(forecast) = self.listener.hear(&heard) else { return };
        let wanted_min = self.desired_min - self.time_min;
        if self.time_min < self.next_min || wanted_min < LAST_MIN {
            return;
        }
        self.next_min = self.time_min + PERIOD_MIN;
        let rest_min = forecast.rest_min() * self.listener.stretch(&heard.cut);
        let ratio = math::pow(rest_min / wanted_min, self.taylor_exponent);
        let [low, high] = SPEED_SHARES;
        self.share = math::limit(self.share * ratio, low, high);
    }
}
