//! The machine behind the cutting process, where it is coupled to the cut: the plant's force drives it,
//! and its vibration shakes the force.

use crate::base::math;
use crate::base::window::WindowMax;
use crate::blocks::cutting::process::Force;
use crate::blocks::cutting::wear::ToolWear;
use crate::blocks::machine::coupled::{Coupled, CoupledSetup, CutState};
use crate::blocks::surface::produced::ToothPlace;
use crate::models::mechanistic::Cutting;
use crate::run::scenario::Scenario;

/// Micrometres in a metre, and millimetres.
const UM_PER_M: f64 = 1e6;
const MM_PER_M: f64 = 1e3;

/// Vibration and sound of a machine; nothing of one that is not coupled.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vibration {
    /// Displacement of the tooth off the work as the last tooth made the surface, um.
    pub tooth_um: f64,
    /// Trend of the sound, mm/s.
    pub sound_mm_s: f64,
    /// A tooth has jumped out of the cut.
    pub lost_contact: bool,
}

/// The coupled machine.
#[derive(Clone, Debug)]
pub struct Machine {
    coupled: Coupled,
    /// The largest force across the tool with vibration, tooth by tooth, N.
    largest: WindowMax<1>,
    position_mm: f64,
}

impl Machine {
    /// The machine at rest; `None` where the scenario leaves it out.
    #[must_use]
    pub fn new(scenario: &Scenario) -> Option<Box<Self>> {
        let settings = &scenario.machine;
        let machine = *scenario.coupled_machine()?;
        let tool = &scenario.tool;
        let setup = CoupledSetup {
            machine,
            teeth: tool.teeth,
            diameter_mm: tool.diameter_mm,
            stiffness_per_mm: settings.regeneration_n_m_mm(),
            dt_s: scenario.dt_s(),
        };
        Some(Box::new(Self {
            coupled: Coupled::new(&setup),
            largest: WindowMax::new(u64::from(scenario.run.steps_per_control)),
            position_mm: 0.0,
        }))
    }

    /// Takes the wear of the tool at the depth and speed of a cut.
    pub fn wear(&mut self, tool: &ToolWear, cut: &CutState) {
        let damping_n_s_m = tool.damping_n_s_m(cut.axial_depth_mm, cut.speed_rpm);
        self.coupled.wear(tool.stiffness_factor(), damping_n_s_m);
    }

    /// A new cut begins at `position_mm`.
    pub fn restart(&mut self, position_mm: f64) {
        self.position_mm = position_mm;
        self.largest.restart();
    }

    /// Plant step `tick` under a force, and what the teeth do where they are simulated, up to `position_mm`:
    /// shakes both, and calls `mark` with where the tooth was in every machine step.
    #[inline]
    pub fn shake(
        &mut self,
        force: &mut Force,
        teeth: Option<&mut Cutting>,
        cut: &CutState,
        tick: u64,
        position_mm: f64,
        mut mark: impl FnMut(&ToothPlace),
    ) {
        self.coupled.begin();
        let turns = self.coupled.turns(cut.speed_rpm);
        let in_cut = !force.air;
        match teeth {
            None => {
                let steps = self.coupled.steps();
                let advance_mm = (position_mm - self.position_mm) / f64::from(steps);
                for step in 1..=steps {
                    let displacement_m = self.coupled.pulse(force.dynamic_n, cut).displacement_m;
                    let position_mm = self.position_mm + advance_mm * f64::from(step);
                    mark(&ToothPlace { turns, position_mm, displacement_m, in_cut });
                }
                // A tooth out of contact carries no force, and none below that. Without a chip there is none
                // that the last tooth's vibration could add to.
                if force.model.value > 0.0 {
                    let added_n = self.coupled.added_force_n();
                    force.dynamic_n = math::positive(force.dynamic_n + added_n);
                }
            }
            // The same direction with another size.
            Some(teeth) => {
                let across_n = teeth.across_n();
                let motion = self.coupled.instant(across_n, &teeth.height_mm, cut);
                let displacement_m = motion.displacement_m;
                mark(&ToothPlace { turns, position_mm, displacement_m, in_cut });
                let share = if across_n > 0.0 { motion.force_n / across_n } else { 0.0 };
                teeth.forces_n = teeth.forces_n.map(|force| force * share);
                [force.dynamic_n] = self.largest.push(tick, [across_n * share]);
            }
        }
        force.model.valid &= self.coupled.holds_at(cut.speed_rpm);
        self.position_mm = position_mm;
    }

    /// Its vibration and sound.
    #[must_use]
    #[inline]
    pub fn vibration(&self) -> Vibration {
        Vibration {
            tooth_um: UM_PER_M * self.coupled.at_tooth_m(),
            sound_mm_s: MM_PER_M * self.coupled.sound_m_s(),
            lost_contact: self.coupled.lost_contact(),
        }
    }
}
