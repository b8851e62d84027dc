//! The plant: the part, the tool and the machine that cuts it. One call in a plant step enters it.

use super::disturbed::Disturbed;
use super::machine::{Machine, Vibration};
use crate::base::units::mm_s_from_mm_min;
use crate::blocks::control::FeedSpeed;
use crate::blocks::cutting::breakage::{Breakage, LoadMoment, Strength};
use crate::blocks::cutting::crash::{self, Crash};
use crate::blocks::cutting::disturbance::DynamicForce;
use crate::blocks::cutting::process::{CutStep, Force, Process};
use crate::blocks::cutting::tool_path::{Engagement, ToolPath};
use crate::blocks::cutting::wear::ToolWear;
use crate::blocks::machine::coupled::CutState;
use crate::blocks::surface::produced::ToothPlace;
use crate::models::disturbances::Disturbances;
use crate::models::mechanistic::Cutting;
use crate::run::scenario::Scenario;

/// The plant with its state.
#[derive(Clone, Debug)]
pub struct Plant {
    dt_s: f64,
    /// Radius of the cutter, and the most that its turn can be fed, mm.
    radius_mm: f64,
    most_per_turn_mm: f64,
    path: ToolPath,
    disturbance: DynamicForce,
    process: Process,
    wear: ToolWear,
    /// Factor of the wear on the force, and of what disturbs it.
    life_factor: f64,
    disturbed: Disturbed,
    strength: Strength,
    /// Whether the wear is within the curve that gives it.
    wear_is_known: bool,
    /// The machine, where it is coupled to the cut.
    machine: Option<Box<Machine>>,
    now: CutNow,
}

/// What is cut at the end of a plant step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutNow {
    /// Actual feed and speed.
    pub motion: FeedSpeed,
    /// Position along the path, mm.
    pub position_mm: f64,
    /// Engagement at the tool's axis.
    pub place: Engagement,
    /// The force.
    pub force: Force,
    /// Vibration and sound of the machine.
    pub vibration: Vibration,
    /// Fraction of the tool's life that is used.
    pub used_life: f64,
}

fn process(scenario: &Scenario, path: &ToolPath, radial_depth_mm: f64, dt_s: f64) -> Process {
    let window = u64::from(scenario.run.steps_per_control);
    let mut process = Process::new(
        &scenario.plant,
        &scenario.formula,
        &scenario.tool,
        path,
        radial_depth_mm,
        dt_s,
        window,
    );
    if scenario.machine.coupled {
        process.make_rigid();
    }
    process
}

impl Plant {
    /// The plant at rest at the start of the path, with feed and speed as programmed.
    #[must_use]
    pub fn new(scenario: &Scenario, motion: FeedSpeed) -> Self {
        let dt_s = scenario.dt_s();
        let path = ToolPath::new(&scenario.workpiece, scenario.tool.outline())
            .disturbed(&scenario.disturbances);
        let wear = ToolWear::new(&scenario.wear, &scenario.tool);
        let now = CutNow {
            motion,
            position_mm: 0.0,
            place: Engagement::default(),
            force: Force::NONE,
            vibration: Vibration::default(),
            used_life: wear.used_life(),
        };
        Self {
            dt_s,
            radius_mm: 0.5 * scenario.tool.diameter_mm,
            most_per_turn_mm: crash::most_per_turn_mm(&scenario.tool),
            process: process(scenario, &path, scenario.workpiece.radial_depth_mm, dt_s),
            path,
            disturbance: DynamicForce::new(
                &scenario.noise,
                scenario.tool.teeth,
                scenario.run.seed,
                dt_s,
            ),
            life_factor: wear.force_factor(),
            disturbed: Disturbed::new(&scenario.disturbances),
            strength: Strength::new(&scenario.tool, scenario.control_period_s()),
            wear_is_known: wear.is_known(),
            wear,
            machine: Machine::new(scenario),
            now,
        }
    }

    /// Takes over changed live settings; path, tool, machine and disturbance go on.
    pub fn reconfigure(&mut self, scenario: &Scenario) {
        self.path.reconfigure(&scenario.workpiece, &scenario.disturbances);
        self.disturbed = Disturbed::new(&scenario.disturbances);
        self.strength.reconfigure(&scenario.tool);
        let place = self.path.place(self.now.position_mm);
        self.process.reconfigure(process(scenario, &self.path, place.radial_depth_mm, self.dt_s));
        self.wear.reconfigure(&scenario.wear);
        if scenario.disturbances.is_empty() {
            self.wear.jump(0.0);
        }
        self.follow_wear();
        self.disturbance.reconfigure(&scenario.noise, self.dt_s);
    }

    /// The next cut begins at its start; the tool comes to it through the air.
    fn restart(&mut self, position_mm: f64) {
        self.now.position_mm = position_mm;
        self.disturbed.look_again();
        self.process.restart();
        if let Some(machine) = &mut self.machine {
            machine.restart(position_mm);
        }
    }

    /// The tool wears over a control period of `period_s` by what was cut at its end: little changes
    /// in between.
    pub fn wear(&mut self, period_s: f64) {
        let FeedSpeed { feed_mm_min, speed_rpm } = self.now.motion;
        let depth_mm = if self.now.force.air { 0.0 } else { self.now.place.axial_depth_mm };
        self.wear.update(feed_mm_min, speed_rpm, depth_mm, period_s);
        self.apply_wear();
    }

    /// Lets force and machine feel the wear of the tool as it is.
    pub fn apply_wear(&mut self) {
        if let Some(all) = self.disturbed.all() {
            self.wear.jump(all.wear_land_mm(self.now.position_mm));
        }
        if let Some(machine) = &mut self.machine {
            machine.wear(&self.wear, &self.now.cut());
        }
        self.follow_wear();
        self.now.used_life = self.wear.used_life();
    }

    fn follow_wear(&mut self) {
        self.life_factor = self.wear.force_factor();
        self.wear_is_known = self.wear.is_known();
    }

    /// Plant step `tick` at the feed and speed that the drives have reached: the tool moves on, at the
    /// end of a cut to the next one, and cuts. A force below `air_n` in N counts as none where air lies
    /// between cuts; `mark` gets where the tooth was in every step of a machine that vibrates. Gives the
    /// number of the cut that begins in this step, counted from 0, if one does.
    #[inline]
    pub fn step(
        &mut self,
        tick: u64,
        motion: FeedSpeed,
        air_n: f64,
        mark: impl FnMut(&ToothPlace),
    ) -> Option<usize> {
        self.now.position_mm += mm_s_from_mm_min(motion.feed_mm_min) * self.dt_s;
        let next_mm = self.path.next_cut(self.now.position_mm);
        let began = next_mm.map(|position_mm| {
            self.restart(position_mm);
            self.path.cut()
        });
        self.cut(tick, motion, air_n);
        if let Some(machine) = &mut self.machine {
            let CutNow { position_mm, place, .. } = self.now;
            // A standing tool has no chip that could grow by vibration.
            let loaded = if motion.feeds() {
                self.path.loaded(position_mm, place)
            } else {
                Engagement::default()
            };
            let cut = CutState {
                speed_rpm: motion.speed_rpm,
                axial_depth_mm: loaded.axial_depth_mm,
                radial_depth_mm: loaded.radial_depth_mm,
            };
            let teeth = self.process.teeth_mut();
            machine.shake(&mut self.now.force, teeth, &cut, tick, position_mm, mark);
            self.now.vibration = machine.vibration();
        }
        began
    }

    /// The force where the tool stands, before any machine vibrates.
    #[inline]
    pub fn cut(&mut self, tick: u64, motion: FeedSpeed, air_n: f64) {
        let FeedSpeed { feed_mm_min, speed_rpm } = motion;
        let position_mm = self.now.position_mm;
        if self.disturbed.is_due(position_mm) {
            self.disturbed.meet(position_mm, &mut self.process, &mut self.strength);
        }
        let place = self.path.place(position_mm);
        let step = CutStep {
            tick,
            feed_mm_min,
            speed_rpm,
            place,
            under: self.path.cut_at(position_mm),
            life_factor: self.life_factor * self.disturbed.force_factor(),
            air_n,
        };
        let disturbance = &mut self.disturbance;
        let chatter = self.disturbed.chatter(tick as f64 * self.dt_s);
        let dynamic = || disturbance.update(tick, position_mm, speed_rpm) + chatter;
        self.now.force = self.process.cut(&step, dynamic);
        self.now.force.model.valid &= self.wear_is_known;
        (self.now.motion, self.now.place) = (motion, place);
    }

    /// Whether the tool is being fed into the work faster than its teeth clear it.
    #[must_use]
    #[inline]
    pub fn crashes(&self) -> bool {
        let CutNow { motion, position_mm, place, .. } = self.now;
        if motion.feed_mm_min <= self.most_per_turn_mm * motion.speed_rpm || !motion.feeds() {
            return false;
        }
        let loaded = self.path.loaded(position_mm, place);
        loaded.axial_depth_mm * loaded.radial_depth_mm > 0.0
    }

    /// Whether a tooth is loaded by more than it stands.
    #[must_use]
    #[inline]
    pub fn is_overloaded(&self) -> bool {
        let CutNow { motion, force, .. } = &self.now;
        let FeedSpeed { feed_mm_min, speed_rpm } = *motion;
        self.strength.is_exceeded(feed_mm_min, speed_rpm, force.dynamic_n)
            && !force.air
            && motion.feeds()
    }

    /// Breaks a tooth that is overloaded at a time in s; gives what happened where no tooth is left, or where a
    /// machine in the cut counts every one.
    #[cold]
    pub fn break_tooth(&mut self, time_s: f64) -> Option<Breakage> {
        let CutNow { motion, position_mm, force, .. } = self.now;
        let FeedSpeed { feed_mm_min, speed_rpm } = motion;
        let force_n = force.dynamic_n;
        let moment = LoadMoment { feed_mm_min, speed_rpm, force_n, position_mm, time_s };
        let broke = self.strength.break_tooth(&moment)?;
        self.disturbed.break_teeth(&self.strength, &mut self.process);
        (self.strength.is_gone() || self.machine.is_some()).then_some(broke)
    }

    /// The teeth that broke under their load, in order.
    #[must_use]
    pub fn breakages(&self) -> &[Breakage] {
        self.strength.breakages()
    }

    /// How many teeth are broken, by load or by a disturbance.
    #[must_use]
    #[inline]
    pub fn broken_teeth(&self) -> usize {
        self.strength.broken()
    }

    /// The crash of this moment, at a time in s.
    #[must_use]
    pub fn crash(&self, time_s: f64) -> Crash {
        let CutNow { motion, position_mm, .. } = self.now;
        let FeedSpeed { feed_mm_min, speed_rpm } = motion;
        Crash { feed_mm_min, speed_rpm, radius_mm: self.radius_mm, position_mm, time_s }
    }

    /// All disturbances of the cut; none where there are none.
    #[must_use]
    pub fn disturbances(&self) -> Option<&Disturbances> {
        self.disturbed.all()
    }

    /// What is cut now.
    #[must_use]
    #[inline]
    pub fn now(&self) -> &CutNow {
        &self.now
    }

    /// F_x and F_y of this instant, N; of a map its largest force.
    #[must_use]
    #[inline]
    pub fn across_n(&self) -> [f64; 2] {
        match self.process.teeth() {
            Some(Cutting { forces_n: [x, y, _], .. }) => [*x, *y],
            None => [self.now.force.dynamic_n, 0.0],
        }
    }

    /// The force across the tool that acts in this plant step, N.
    #[must_use]
    #[inline]
    pub fn acting_n(&self) -> f64 {
        self.process.teeth().map_or(self.now.force.dynamic_n, Cutting::across_n)
    }

    /// The cut that the machine is in, counted from 0, and where along it the tool's axis stands, mm.
    #[must_use]
    pub fn place_in_cut(&self) -> (usize, f64) {
        (self.path.cut(), self.path.cut_at(self.now.position_mm).1)
    }

    /// Fraction of the tool's life that is used: 1 at its end.
    #[must_use]
    pub fn used_life(&self) -> f64 {
        self.wear.used_life()
    }

    /// Forces F_x, F_y, F_z on the tool in N and the spindle's turn from 0 to below 1 now, where the
    /// force is simulated tooth by tooth.
    #[must_use]
    pub fn teeth(&self) -> Option<([f64; 3], f64)> {
        let teeth = self.process.teeth()?;
        Some((teeth.forces_n, self.process.spindle_turn()?))
    }
}

impl CutNow {
    /// Speed and engagement at the tool's axis.
    #[must_use]
    pub fn cut(&self) -> CutState {
        CutState {
            speed_rpm: self.motion.speed_rpm,
            axial_depth_mm: self.place.axial_depth_mm,
            radial_depth_mm: self.place.radial_depth_mm,
        }
    }
}
