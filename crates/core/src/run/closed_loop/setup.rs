//! How the blocks of the loop are wired to a scenario: at the start, when a setting changes in the cut,
//! and when the next cut begins. Every block answers to the same three verbs, `new`, `reconfigure` and
//! `restart`.

use super::life::ToolLife;
use super::plant::Plant;
use super::{Clock, ClosedLoop, Sample};
use crate::base::units::mm_from_um;
use crate::blocks::cnc::channel::{Channel, ChannelSetup};
use crate::blocks::cnc::limits as cnc_limits;
use crate::blocks::control::{Controller, Limits, Running};
use crate::blocks::reference::Desired;
use crate::blocks::sensing::force_sensor::{ForceSensor, SensorSetup};
use crate::blocks::surface::finish::Finish;
use crate::blocks::surface::produced::Surface;
use crate::models::genetic::GeneticModels;
use crate::models::structure::RoughnessFrom;
use crate::run::scenario::Scenario;
use crate::run::signals::Row;

impl ClosedLoop {
    /// The loop at rest where the drives come to at the programmed feed and speed, as far as the machine goes, at the
    /// start of the path.
    #[must_use]
    pub fn new(scenario: &Scenario) -> Self {
        let cnc = Channel::new(&channel(scenario));
        let desired = Desired::new(&scenario.target, scenario.believed());
        let mut this = Self {
            clock: Clock::new(scenario.dt_s(), scenario.run.steps_per_control),
            controller: Controller::new(&scenario.control_setup(), cnc.programmed()),
            life: ToolLife::new(scenario),
            plant: Plant::new(scenario, cnc.actual()),
            cnc,
            sensor: ForceSensor::new(&sensor(scenario)),
            surface: Surface::new(true_models(scenario), finish(scenario)),
            sample: Sample::before_the_first(desired.force.value),
            desired,
            row: Row::default(),
        };
        this.plant.cut(0, this.cnc.actual(), this.desired.air_n());
        let cut = this.plant.now();
        this.sensor.take(0, cut.force.dynamic_n, this.plant.across_n());
        this.sample.force_measured_n = cut.force.dynamic_n;
        this.cnc.guard(this.plant.acting_n(), cut.position_mm, 0.0);
        let ra = this.surface.leave(cut.force.model.value, cut.force.dynamic_n, cut.force.air);
        this.record(ra);
        this
    }

    /// Takes over changed live settings; the state of every block goes on.
    pub fn reconfigure(&mut self, scenario: &Scenario) {
        let (cut, _) = self.plant.place_in_cut();
        let running = Running {
            programmed: self.cnc.programmed(),
            actual: self.cnc.actual(),
            sent: self.cnc.command_sent(),
        };
        self.desired = Desired::new(&scenario.target, scenario.believed());
        self.controller.reconfigure(&scenario.control_setup(), &running);
        self.cnc.reconfigure(&channel(scenario), cut);
        self.plant.reconfigure(scenario);
        if scenario.disturbances.is_empty() {
            self.cnc.disturb(0, 1.0);
        }
        match (&mut self.life, ToolLife::new(scenario)) {
            (Some(life), Some(_)) => life.reconfigure(scenario),
            (life, new) => *life = new,
        }
        self.sensor.reconfigure(&sensor(scenario));
        self.surface.reconfigure(true_models(scenario), &scenario.profile);
    }

    /// The cut of this number begins: at rest at the programmed values, before the part. The plant has
    /// moved there by itself.
    pub(super) fn restart(&mut self, cut: usize) {
        self.cnc.restart(cut);
        self.controller.restart(self.cnc.programmed());
        self.sensor.restart();
        self.surface.restart();
    }
}

/// The models of what really is cut.
fn true_models(scenario: &Scenario) -> GeneticModels {
    scenario.of_plant()
}

/// The CNC with the programmed values and limits of every cut; one cut where the path is one.
fn channel(scenario: &Scenario) -> ChannelSetup<'_> {
    let cuts = 0..scenario.workpiece.cuts.len().max(1);
    ChannelSetup {
        cnc: &scenario.cnc,
        feed_drive: &scenario.feed_drive,
        spindle_drive: &scenario.spindle_drive,
        cuts: cuts.map(|cut| (scenario.programmed(cut), limits(scenario, cut))).collect(),
        dead_ticks: scenario.ticks(scenario.cnc.dead_time_s) as usize,
        dt_s: scenario.dt_s(),
        period_s: scenario.control_period_s(),
    }
}

fn sensor(scenario: &Scenario) -> SensorSetup {
    SensorSetup {
        by_instants: scenario.plant.force_model.tooth_by_tooth(),
        deviation_n: scenario.noise.sensor_deviation_n(),
        seed: scenario.run.seed,
        steps: u64::from(scenario.run.steps_per_control),
        dt_s: scenario.dt_s(),
    }
}

/// The marks of the teeth, where Ra with dynamics comes from the vibration of a coupled machine.
fn finish(scenario: &Scenario) -> Option<Finish> {
    let machine = &scenario.machine;
    (machine.coupled && machine.roughness_from == RoughnessFrom::Vibration).then(|| {
        let tool = &scenario.tool;
        // Run-out is a property of the cutter that is simulated tooth by tooth.
        let by_teeth = scenario.plant.force_model.tooth_by_tooth();
        let runout_um = if by_teeth { 2.0 * scenario.tool.runout_um } else { 0.0 };
        let (outline, teeth) = (tool.outline(), tool.teeth as usize);
        Finish::new(&scenario.profile, outline, teeth, mm_from_um(runout_um))
    })
}

/// Limits of the commands in a cut, counted from 0: those of overrides and machine, and the controller's own.
#[must_use]
pub fn limits(scenario: &Scenario, cut: usize) -> Limits {
    let of_machine = cnc_limits::of_machine(&scenario.cnc, scenario.programmed(cut));
    scenario.controller.kind.limits(of_machine)
}
