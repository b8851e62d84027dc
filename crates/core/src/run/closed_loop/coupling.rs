//! The extra stage of the step when the machine is coupled: takes the cutting force, returns it with
//! vibration and what vibration adds to Ra. The blocks meet here, as in [`super`].

use crate::base::math;
use crate::base::units::mm_from_um;
use crate::blocks::cutting::wear::ToolWear;
use crate::blocks::machine::coupled::{Coupled, CoupledSetup, CutState};
use crate::blocks::surface::finish::Finish;
use crate::models::structure::RoughnessFrom;
use crate::run::scenario::Scenario;
use crate::run::signals::Row;

/// Micrometres in a metre, and millimetres.
const UM_PER_M: f64 = 1e6;
const MM_PER_M: f64 = 1e3;

/// Where the tool is at the end of a plant step, and whether it cuts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moved {
    /// The cut.
    pub cut: CutState,
    /// Position along the path, mm.
    pub position_mm: f64,
    /// The tool is in the material.
    pub in_cut: bool,
}

/// Machine and surface of a coupled run.
#[derive(Clone, Debug)]
pub struct Coupling {
    machine: Coupled,
    /// The surface, where Ra with dynamics is to come from it.
    finish: Option<Finish>,
    position_mm: f64,
}

impl Coupling {
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
            // N/mm^2 x mm = N/mm per mm of depth; 1000 N/m are one N/mm.
            stiffness_per_mm: 1000.0
                * settings.specific_cutting_force_n_mm2
                * settings.directional_factor,
            dt_s: scenario.dt_s(),
        };
        // Run-out is a property of the cutter that is simulated tooth by tooth.
        let by_teeth = scenario.plant.force_model.tooth_by_tooth();
        let runout_um = if by_teeth { 2.0 * scenario.plant.runout_um } else { 0.0 };
        Some(Box::new(Self {
            machine: Coupled::new(&setup),
            finish: (settings.roughness_from == RoughnessFrom::Vibration).then(|| {
                let runout_mm = mm_from_um(runout_um);
                Finish::new(&scenario.profile, tool.outline(), tool.teeth as usize, runout_mm)
            }),
            position_mm: 0.0,
        }))
    }

    /// Takes over changed live settings.
    pub fn reconfigure(&mut self, scenario: &Scenario) {
        if let Some(finish) = &mut self.finish {
            finish.reconfigure(&scenario.profile);
        }
    }

    /// Takes the wear of the tool at the depth and speed of `row`.
    pub fn wear(&mut self, tool: &ToolWear, row: &Row) {
        let damping_n_s_m = tool.damping_n_s_m(row.axial_depth_mm, row.spindle_rpm);
        self.machine.wear(tool.stiffness_factor(), damping_n_s_m);
    }

    /// A new cut begins at `position_mm`.
    pub fn restart(&mut self, position_mm: f64) {
        if let Some(finish) = &mut self.finish {
            finish.clear();
        }
        self.position_mm = position_mm;
    }

    /// The machine over a plant step under pulses of peak `force_n`: the peak with vibration, N.
    #[inline]
    pub fn pulses(&mut self, force_n: f64, to: &Moved) -> f64 {
        self.machine.begin();
        let steps = self.machine.steps();
        let advance_mm = (to.position_mm - self.position_mm) / f64::from(steps);
        let turns = self.machine.turns(to.cut.speed_rpm);
        for step in 1..=steps {
            let motion = self.machine.pulse(force_n, &to.cut);
            if let Some(finish) = &mut self.finish {
                let at_mm = self.position_mm + advance_mm * f64::from(step);
                finish.update(turns, at_mm, motion.displacement_m, to.in_cut);
            }
        }
        self.arrive(to);
        math::positive(force_n + self.machine.added_force_n())
    }

    /// The machine over a plant step under the forces F_x, F_y, F_z of an instant without vibration, N:
    /// the forces with it, in the same direction.
    #[inline]
    pub fn instant(&mut self, forces_n: [f64; 3], to: &Moved) -> [f64; 3] {
        self.machine.begin();
        let [x, y, _] = forces_n;
        let across_n = (x * x + y * y).sqrt();
        let motion = self.machine.instant(across_n, &to.cut);
        let turns = self.machine.turns(to.cut.speed_rpm);
        if let Some(finish) = &mut self.finish {
            finish.update(turns, to.position_mm, motion.displacement_m, to.in_cut);
        }
        self.arrive(to);
        let share = if across_n > 0.0 { motion.force_n / across_n } else { 0.0 };
        forces_n.map(|force| force * share)
    }

    fn arrive(&mut self, to: &Moved) {
        self.position_mm = to.position_mm;
        if let Some(finish) = self.finish.as_mut().filter(|_| !to.in_cut) {
            finish.clear();
        }
    }

    /// What the machine adds to Ra = K5(F), um; `None` where Ra with dynamics comes from the force.
    #[must_use]
    #[inline]
    pub fn added_ra_um(&self) -> Option<f64> {
        self.finish.as_ref().map(Finish::added_um)
    }

    /// Whether a tooth has jumped out of the cut in the last plant step.
    #[must_use]
    pub fn lost_contact(&self) -> bool {
        self.machine.lost_contact()
    }

    /// Writes the machine's vibration and sound.
    #[inline]
    pub fn record(&self, row: &mut Row) {
        row.vibration_um = UM_PER_M * self.machine.at_tooth_m();
        row.sound_mm_s = MM_PER_M * self.machine.sound_m_s();
    }
}
