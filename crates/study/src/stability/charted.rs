//! What is charted: the five masses with one direction, or measured modes at the tool's tip with both.

use super::chart::DT_S;
use super::simulated::{self, ForcedTeeth};
use super::tip::{TipCut, semi_discrete, window_rad, zero_order};
use super::{StabilityCut, charted_radial_mm, interrupted, lobes};
use crate::base::settings::SettingError;
use crate::run::scenario::Scenario;

/// The cut of a stability chart.
#[derive(Clone, Debug, PartialEq)]
pub enum ChartedCut {
    /// On the five masses of 2019.
    FiveMass(Box<StabilityCut>),
    /// On modes at the tip.
    Tip(Box<TipCut>),
}

impl ChartedCut {
    /// The scenario's structure with its cutter at its radial depth.
    ///
    /// # Errors
    /// As [`StabilityCut::new`].
    pub fn new(scenario: &Scenario) -> Result<Self, SettingError> {
        let machine = &scenario.machine;
        if machine.tip_modes.is_empty() {
            return Ok(Self::FiveMass(Box::new(StabilityCut::new(scenario)?)));
        }
        let radial_depth_mm = charted_radial_mm(scenario)?;
        let diameter_mm = scenario.tool.diameter_mm;
        Ok(Self::Tip(Box::new(TipCut {
            modes: machine.tip_modes.clone(),
            teeth: scenario.tool.teeth,
            window_rad: window_rad(radial_depth_mm, diameter_mm, machine.down_milling),
            radial_depth_mm,
            diameter_mm,
            tangential_n_mm2: machine.specific_cutting_force_n_mm2,
            radial_ratio: machine.radial_ratio,
            down_milling: machine.down_milling,
        })))
    }

    /// The speeds that a chart usually spans, 1/min: those of the papers' cut, or of the first lobes of measured modes,
    /// up to the speed at which a tooth passes at every period of the highest mode.
    #[must_use]
    pub fn usual_speeds_rpm(&self) -> [f64; 2] {
        match self {
            Self::FiveMass(_) => [800.0, 4000.0],
            Self::Tip(cut) => {
                let lobe_rpm = 60.0 * cut.highest_hz() / f64::from(cut.teeth);
                [0.15, 1.1].map(|share| share * lobe_rpm)
            }
        }
    }

    /// The depth in mm that is stable at every speed, by the lobes; infinite where nothing chatters.
    #[must_use]
    pub fn any_speed_mm(&self) -> f64 {
        match self {
            Self::FiveMass(cut) => cut.depth_mm(lobes::at_any_speed(cut).stiffness_n_m),
            Self::Tip(cut) => zero_order::at_any_speed_mm(cut),
        }
    }

    /// The lobes' limit at a speed: depth in mm and chatter frequency in Hz.
    #[must_use]
    pub fn lobe(&self, speed_rpm: f64) -> Option<[f64; 2]> {
        match self {
            Self::FiveMass(cut) => lobes::limit(cut, speed_rpm)
                .map(|limit| [cut.depth_mm(limit.stiffness_n_m), limit.frequency_hz]),
            Self::Tip(cut) => {
                zero_order::limit(cut, speed_rpm).map(|limit| [limit.depth_mm, limit.frequency_hz])
            }
        }
    }

    /// The limit of the interrupted cut at a speed, mm, up to `highest_mm`.
    #[must_use]
    pub fn interrupted_mm(&self, speed_rpm: f64, highest_mm: f64) -> Option<f64> {
        match self {
            Self::FiveMass(cut) => interrupted::limit_mm(cut, speed_rpm, highest_mm),
            Self::Tip(cut) => semi_discrete::limit_mm(cut, speed_rpm, highest_mm),
        }
    }

    /// The limit of the time simulation with the mean number of teeth, mm, up to `highest_mm`; of modes at the tip there
    /// is none, since no cut runs with mean coefficients there.
    #[must_use]
    pub fn simulated_mean_mm(&self, speed_rpm: f64, highest_mm: f64) -> Option<f64> {
        match self {
            Self::FiveMass(cut) => {
                simulated::limit_mm(cut, ForcedTeeth::Mean, speed_rpm, DT_S, highest_mm)
            }
            Self::Tip(_) => None,
        }
    }

    /// The limit of the time simulation with teeth that come and go, mm, up to `highest_mm`.
    #[must_use]
    pub fn simulated_mm(&self, speed_rpm: f64, highest_mm: f64) -> Option<f64> {
        match self {
            Self::FiveMass(cut) => {
                simulated::limit_mm(cut, ForcedTeeth::Interrupted, speed_rpm, DT_S, highest_mm)
            }
            Self::Tip(cut) => super::tip::simulated::limit_mm(cut, speed_rpm, highest_mm),
        }
    }

    /// Factor by which a disturbance grows from tooth to tooth, by semi-discretisation. Speed and depth are positive.
    #[must_use]
    pub fn multiplier(&self, speed_rpm: f64, depth_mm: f64) -> f64 {
        match self {
            Self::FiveMass(cut) => interrupted::multiplier(cut, speed_rpm, depth_mm),
            Self::Tip(cut) => semi_discrete::multiplier(cut, speed_rpm, depth_mm),
        }
    }

    /// The engagement in words.
    #[must_use]
    pub fn engagement_text(&self) -> String {
        match self {
            Self::FiveMass(cut) => cut.engagement_text(),
            Self::Tip(cut) => cut.engagement_text(),
        }
    }

    /// Radial depth and diameter of the cutter, mm.
    #[must_use]
    pub fn width_mm(&self) -> [f64; 2] {
        match self {
            Self::FiveMass(cut) => [cut.radial_depth_mm, cut.diameter_mm],
            Self::Tip(cut) => [cut.radial_depth_mm, cut.diameter_mm],
        }
    }

    /// Number of teeth, and the mean number of those in the cut.
    #[must_use]
    pub fn teeth(&self) -> (u32, f64) {
        match self {
            Self::FiveMass(cut) => (cut.engagement.teeth, cut.engagement.mean_teeth()),
            Self::Tip(cut) => (cut.teeth, cut.mean_teeth()),
        }
    }

    /// What a displacement changes the force by, N/m for a millimetre of depth: K_s gamma, or K_t.
    #[must_use]
    pub fn stiffness_per_mm(&self) -> f64 {
        match self {
            Self::FiveMass(cut) => cut.stiffness_per_mm,
            Self::Tip(cut) => cut.stiffness_n_m(1.0),
        }
    }

    /// Whether the mean cut can be simulated.
    #[must_use]
    pub fn simulates_mean(&self) -> bool {
        match self {
            Self::FiveMass(_) => true,
            Self::Tip(_) => false,
        }
    }
}
