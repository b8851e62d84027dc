//! The closed loop: every value that passes between blocks passes here. Read this first.
//!
//! ```text
//!  target Ra ─▶ reference ─F_d─▶ controller ─▶ override ─▶ dead time ─▶ feed drive ──f_a─┐
//!                 (K1)      ┌──▶ (K2, K3)      (percent)    (queue)    spindle drive ─n_a─┤
//!                           │                                                             ▼
//!                      dynamometer ◀──F_dyn── dynamic component ◀──F── cutting process (K4)
//!                                                    │                 depth, material, wear
//!                                     Ra_dyn = K6(F_dyn)   Ra = K5(F)
//! ```
//!
//! With `machine.coupled` the five-mass machine stands behind the cutting process
//! ([`coupling`]): F_dyn is the force with regeneration, Ra_dyn = Ra + what the teeth's marks add.
//!
//! Order of events in tick k (from t = k dt to (k + 1) dt):
//! 0. Every `steps_per_control` ticks the tool wears by what it cut since the last time; where the speed
//!    is adjusted to the tool's life ([`super::durability`]), its sound observed.
//! 1. Every `steps_per_control` ticks the controller sees the force sensed at the end of tick
//!    k - 1 and sends a command, limited by the overrides; it is held until the next sample.
//! 2. The command enters the dead-time queue; what leaves it is what the drives get.
//! 3. The drives advance over dt with that command held: feed f_a, speed n_a.
//! 4. The tool moves on by f_a dt; the workpiece gives the depth there.
//! 5. Force, dynamic component and roughness follow from f_a, n_a and depth; a coupled machine makes
//!    its steps of at most 0.1 ms over dt under that force.
//! 6. The row is complete; it belongs to the time (k + 1) dt. Row 0 is the state before tick 0.

mod coupling;

use self::coupling::{Coupling, Moved};
use super::durability::Durability;
use super::scenario::Scenario;
use super::signals::{Row, SIGNALS, flag};
use crate::base::math;
use crate::base::units::{mm_s_from_mm_min, ratio_from_percent};
use crate::blocks::cnc::dead_time::DeadTime;
use crate::blocks::cnc::feed_drive::FeedDrive;
use crate::blocks::cnc::feed_override::Override;
use crate::blocks::cnc::spindle_drive::SpindleDrive;
use crate::blocks::control::unks::Learning;
use crate::blocks::control::{ControlInput, Controller, FeedSpeed, Limits, Running};
use crate::blocks::cutting::disturbance::DynamicForce;
use crate::blocks::cutting::process::Process;
use crate::blocks::cutting::tool_path::Engagement;
use crate::blocks::cutting::tool_path::ToolPath;
use crate::blocks::cutting::wear::ToolWear;
use crate::blocks::machine::coupled::CutState;
use crate::blocks::reference;
use crate::blocks::sensing::dynamometer::Dynamometer;
use crate::blocks::sensing::peak::PeakWindow;
use crate::blocks::surface::roughness;
use crate::models::Valued;
use crate::models::genetic::GeneticModels;

/// Peak force below which a tool that goes through cuts with air between them counts as in the air, as
/// a share of the desired force: 40 of 665 N in 2005.
const AIR_SHARE: f64 = 0.06;

/// A value that stopped being finite: the run ends there, before anything spreads.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// The signal.
    pub signal: &'static str,
    /// The tick at which it happened.
    pub tick: u64,
}

impl std::fmt::Display for Fault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "`{}` is not finite at tick {}: the run ends", self.signal, self.tick)
    }
}

/// An overload has stopped the feed: to save the tool, for good.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ForceStop {
    /// The force, N.
    pub force_n: f64,
    /// The force that was allowed, N.
    pub limit_n: f64,
    /// Where along the way it happened, mm.
    pub position_mm: f64,
    /// When, s.
    pub time_s: f64,
}

impl std::fmt::Display for ForceStop {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { force_n, limit_n, position_mm, time_s } = self;
        write!(
            f,
            "stopped at {time_s:.2} s, {position_mm:.1} mm: {force_n:.0} N, allowed {limit_n:.0} N"
        )
    }
}

/// The loop with all its blocks and their state.
#[derive(Clone, Debug)]
pub struct ClosedLoop {
    // Set-up.
    dt_s: f64,
    steps_per_control: u64,
    /// Programmed values and limits of each cut, and of the present one.
    cuts: Vec<(FeedSpeed, Limits)>,
    programmed: FeedSpeed,
    limits: Limits,
    belief: GeneticModels,
    desired_force: Valued,
    target_ra_um: f64,
    // Blocks.
    controller: Controller,
    feed_override: Override,
    spindle_override: Override,
    dead_time: DeadTime,
    feed_drive: FeedDrive,
    spindle_drive: SpindleDrive,
    path: ToolPath,
    process: Process,
    wear: ToolWear,
    dynamic_force: DynamicForce,
    dynamometer: Dynamometer,
    peak: PeakWindow,
    /// The machine, where it is coupled to the cut.
    coupling: Option<Box<Coupling>>,
    /// Adjusts the programmed speed by the predicted tool life, where that is wanted.
    durability: Option<Box<Durability>>,
    // State.
    tick: u64,
    to_control: u64,
    position_mm: f64,
    command_flags: u32,
    /// What the sensor is given.
    sensed_n: f64,
    /// F_x, F_y, F_z on the tool now, tooth by tooth; what is sensed is then their peak.
    teeth_n: Option<[f64; 3]>,
    /// Force that stops the feed; infinite where that is switched off.
    stop_n: f64,
    stop: Option<ForceStop>,
    row: Row,
}

impl ClosedLoop {
    /// The loop at rest at the programmed feed and speed, at the start of the path.
    #[must_use]
    pub fn new(scenario: &Scenario) -> Self {
        let dt_s = scenario.dt_s();
        let cuts = programmed_cuts(scenario);
        let (programmed, limits) = cuts[0];
        let belief = scenario.believed();
        let ticks = scenario.ticks(scenario.cnc.dead_time_s) as usize;
        let (cnc, period_s) = (&scenario.cnc, scenario.control_period_s());
        let path = ToolPath::new(&scenario.workpiece, scenario.tool.outline());
        let mut this = Self {
            dt_s,
            steps_per_control: u64::from(scenario.run.steps_per_control),
            cuts,
            programmed,
            limits,
            belief,
            desired_force: reference::desired_force(&scenario.target, &belief),
            target_ra_um: reference::desired_ra(&scenario.target, &belief),
            controller: Controller::new(&scenario.control_setup(), programmed),
            feed_override: Override::new(cnc, programmed.feed_mm_min, period_s),
            spindle_override: Override::new(cnc, programmed.speed_rpm, period_s),
            dead_time: DeadTime::new(ticks, [programmed.feed_mm_min, programmed.speed_rpm]),
            feed_drive: FeedDrive::new(&scenario.feed_drive, dt_s, programmed.feed_mm_min),
            spindle_drive: SpindleDrive::new(&scenario.spindle_drive, dt_s, programmed.speed_rpm),
            process: Process::new(
                &scenario.plant,
                &scenario.tool,
                scenario.workpiece.radial_depth_mm,
                path.depth_max_mm(),
                dt_s,
            ),
            path,
            wear: ToolWear::new(&scenario.wear, &scenario.tool),
            dynamic_force: DynamicForce::new(
                &scenario.noise,
                scenario.tool.teeth,
                scenario.run.seed,
                dt_s,
            ),
            dynamometer: Dynamometer::new(scenario.noise.sensor_deviation_n(), scenario.run.seed),
            peak: PeakWindow::new(
                scenario.noise.sensor_deviation_n(),
                scenario.run.seed,
                u64::from(scenario.run.steps_per_control),
            ),
            coupling: Coupling::new(scenario),
            durability: Durability::new(scenario),
            tick: 0,
            to_control: 0,
            position_mm: 0.0,
            command_flags: 0,
            sensed_n: 0.0,
            teeth_n: None,
            stop_n: stop_n(scenario),
            stop: None,
            row: Row {
                feed_command_mm_min: programmed.feed_mm_min,
                feed_override_percent: 100.0,
                spindle_command_rpm: programmed.speed_rpm,
                spindle_override_percent: 100.0,
                gain_estimate: 1.0,
                ..Row::default()
            },
        };
        this.row.force_setpoint_n = this.desired_force.value;
        if this.coupling.is_some() {
            this.process.stiffen();
        }
        this.process.set_life_factor(this.wear.force_factor());
        this.cut(programmed.feed_mm_min, programmed.speed_rpm);
        this.row.force_measured_n = this.row.force_dyn_n;
        this
    }

    /// Takes over changed live settings; the state of every block goes on.
    pub fn reconfigure(&mut self, scenario: &Scenario) {
        let actual =
            FeedSpeed { feed_mm_min: self.row.feed_mm_min, speed_rpm: self.row.spindle_rpm };
        self.cuts = programmed_cuts(scenario);
        self.limits = self.cuts[self.path.cut()].1;
        self.stop_n = stop_n(scenario);
        self.belief = scenario.believed();
        self.desired_force = reference::desired_force(&scenario.target, &self.belief);
        self.target_ra_um = reference::desired_ra(&scenario.target, &self.belief);
        let command = [self.row.feed_command_mm_min, self.row.spindle_command_rpm];
        let sent = FeedSpeed { feed_mm_min: command[0], speed_rpm: command[1] };
        let running = Running { programmed: self.programmed, actual, sent };
        self.controller.reconfigure(&scenario.control_setup(), &running);
        let period_s = scenario.control_period_s();
        self.feed_override.reconfigure(&scenario.cnc, period_s);
        self.spindle_override.reconfigure(&scenario.cnc, period_s);
        self.dead_time.resize(scenario.ticks(scenario.cnc.dead_time_s) as usize, command);
        self.feed_drive.reconfigure(&scenario.feed_drive, self.dt_s);
        self.spindle_drive.reconfigure(&scenario.spindle_drive, self.dt_s);
        self.path.reconfigure(&scenario.workpiece);
        let place = self.path.place(self.position_mm);
        let depth_max_mm = self.path.depth_max_mm();
        self.process.reconfigure(&scenario.plant, &scenario.tool, &place, depth_max_mm, self.dt_s);
        if let Some(coupling) = &mut self.coupling {
            coupling.reconfigure(scenario);
            self.process.stiffen();
        }
        self.wear.reconfigure(&scenario.wear);
        match (&mut self.durability, Durability::new(scenario)) {
            (Some(durability), Some(_)) => durability.reconfigure(scenario),
            (durability, new) => *durability = new,
        }
        self.process.set_life_factor(self.wear.force_factor());
        self.dynamic_force.reconfigure(&scenario.noise, self.dt_s);
        self.dynamometer.reconfigure(scenario.noise.sensor_deviation_n());
        self.peak.reconfigure(scenario.noise.sensor_deviation_n());
    }

    /// Steps done so far.
    #[must_use]
    pub fn tick(&self) -> u64 {
        self.tick
    }

    /// What has stopped the feed, if anything has.
    #[must_use]
    pub fn stop(&self) -> Option<ForceStop> {
        self.stop
    }

    /// Fraction of the tool's life that is used: 1 at its end.
    #[must_use]
    pub fn used_life(&self) -> f64 {
        self.wear.used_life()
    }

    /// The row of the present moment.
    #[must_use]
    pub fn row(&self) -> &Row {
        &self.row
    }

    /// Forces F_x, F_y, F_z on the tool in N and the spindle's turn from 0 to below 1 at the present
    /// moment, where the force is simulated tooth by tooth.
    #[must_use]
    pub fn teeth(&self) -> Option<([f64; 3], f64)> {
        self.teeth_n.zip(self.process.spindle_turn())
    }

    /// The controller's networks that learn in the cut, for display, if it has any.
    #[must_use]
    pub fn learning(&self) -> Option<Learning<'_>> {
        self.controller.learning()
    }

    /// One tick, in the order given at the head of this file.
    ///
    /// # Errors
    /// The first signal that is not finite; the state is then that of the fault.
    #[inline]
    pub fn step(&mut self) -> Result<(), Fault> {
        if self.to_control == 0 {
            self.age();
            self.control();
            self.to_control = self.steps_per_control;
        }
        self.to_control -= 1;

        let command = [self.row.feed_command_mm_min, self.row.spindle_command_rpm];
        let [feed_command, speed_command] = self.dead_time.pass(command);
        // A stop does not wait in the queue.
        let feed_command = if self.stop.is_some() { 0.0 } else { feed_command };
        let feed_mm_min = self.feed_drive.update(feed_command);
        let speed_rpm = self.spindle_drive.update(speed_command);
        self.position_mm += mm_s_from_mm_min(feed_mm_min) * self.dt_s;
        self.tick += 1;
        self.next_cut();
        self.cut(feed_mm_min, speed_rpm);
        self.check()
    }

    /// The tool wears over the last control period, in which little changes.
    fn age(&mut self) {
        let row = &self.row;
        let in_air = row.state_flags as u32 & flag::AIR != 0;
        let depth_mm = if in_air { 0.0 } else { row.axial_depth_mm };
        let period_s = self.dt_s * self.steps_per_control as f64;
        if self.tick > 0 {
            self.wear.update(row.feed_mm_min, row.spindle_rpm, depth_mm, period_s);
        }
        if let Some(coupling) = &mut self.coupling {
            coupling.wear(&self.wear, row);
        }
        if let Some(durability) = self.durability.as_mut().filter(|_| self.tick > 0) {
            durability.update(row, &self.belief, period_s);
        }
        self.process.set_life_factor(self.wear.force_factor());
    }

    /// The controller's turn: from the sensed force to the commands that are sent.
    fn control(&mut self) {
        let sample = self.tick / self.steps_per_control;
        // The peak of a window has its sensor noise already.
        let force_measured_n = if self.teeth_n.is_some() {
            self.sensed_n
        } else {
            self.dynamometer.read(self.sensed_n, sample)
        };
        let x_mm = self.path.cut_at(self.position_mm).1;
        let output = self.controller.update(&ControlInput {
            force_measured_n,
            force_ref_n: self.desired_force.value,
            programmed: match &self.durability {
                Some(durability) => durability.adjusted(self.programmed),
                None => self.programmed,
            },
            applied: FeedSpeed {
                feed_mm_min: self.row.feed_command_mm_min,
                speed_rpm: self.row.spindle_command_rpm,
            },
            limits: self.limits,
            models: &self.belief,
            cut: self.path.cut(),
            x_mm,
        });
        let feed = self.feed_override.update(output.request.feed_mm_min, self.limits.feed_mm_min);
        let speed = self.spindle_override.update(output.request.speed_rpm, self.limits.speed_rpm);
        self.row.force_measured_n = force_measured_n;
        self.row.force_setpoint_n = output.force_setpoint_n;
        self.row.gain_estimate = output.gain_estimate;
        self.row.feed_command_mm_min = feed.command;
        self.row.feed_override_percent = feed.percent;
        self.row.spindle_command_rpm = speed.command;
        self.row.spindle_override_percent = speed.percent;
        self.command_flags = bit(feed.saturated, flag::FEED_SATURATED)
            | bit(speed.saturated, flag::SPEED_SATURATED)
            | bit(feed.rate_limited, flag::FEED_RATE_LIMITED)
            | bit(speed.rate_limited, flag::SPEED_RATE_LIMITED)
            | bit(!output.feed_model_valid, flag::K2_OUTSIDE)
            | bit(!output.speed_model_valid, flag::K3_OUTSIDE);
    }

    /// At the end of a cut the next one begins: at rest at the programmed values, before the part.
    fn next_cut(&mut self) {
        let Some(position_mm) = self.path.next_cut(self.position_mm) else { return };
        (self.programmed, self.limits) = self.cuts[self.path.cut()];
        let FeedSpeed { feed_mm_min, speed_rpm } = self.programmed;
        self.position_mm = position_mm;
        self.controller.restart(self.programmed);
        self.feed_override.restart(feed_mm_min);
        self.spindle_override.restart(speed_rpm);
        self.dead_time.restart([feed_mm_min, speed_rpm]);
        self.feed_drive.restart(feed_mm_min);
        self.process.restart();
        self.peak.restart();
        if let Some(coupling) = &mut self.coupling {
            coupling.restart(position_mm);
        }
        self.row.feed_command_mm_min = feed_mm_min;
        self.row.feed_override_percent = 100.0;
        self.row.spindle_command_rpm = speed_rpm;
        self.row.spindle_override_percent = 100.0;
    }

    /// Depth, force, dynamic component and roughness at the present feed, speed and position.
    #[inline]
    fn cut(&mut self, feed_mm_min: f64, speed_rpm: f64) {
        let place = self.path.place(self.position_mm);
        let dynamic = self.dynamic_force.update(self.tick, self.position_mm, speed_rpm);
        let under = self.path.cut_at(self.position_mm);
        let mut milled = self.process.mill(feed_mm_min, speed_rpm, under, dynamic);
        let moved = |in_cut| {
            let Engagement { axial_depth_mm, radial_depth_mm } =
                self.path.loaded(self.position_mm, place);
            let cut = CutState { speed_rpm, axial_depth_mm, radial_depth_mm };
            Moved { cut, position_mm: self.position_mm, in_cut }
        };
        if let (Some(forces_n), Some(coupling)) = (&mut milled, &mut self.coupling) {
            // Between two teeth the force is zero as well: the air shows in the last row.
            *forces_n = coupling.instant(*forces_n, &moved(!self.row.has(flag::AIR)));
        }
        // Mechanistic plant: force_n is the peak of the last control period, force_dyn_n the
        // force now, and K6 is fed with the sensor's peak.
        let (force, mut force_dyn_n, mut sensed_n, in_air) = if let Some([x, y, _]) = milled {
            let peak = self.peak.push(self.tick, [x, y]);
            let air = peak.true_n < AIR_SHARE * self.desired_force.value;
            let now_n = (x * x + y * y).sqrt();
            (Valued::new(peak.true_n, true), now_n, peak.measured_n, air)
        } else if self.path.is_several() {
            // The part's inhomogeneity is part of its force, as tooth by tooth.
            let map = self.process.update_along(feed_mm_min, speed_rpm, under);
            let force_n = math::positive(map.value * dynamic);
            let air = force_n < AIR_SHARE * self.desired_force.value;
            (Valued::new(force_n, map.valid), force_n, force_n, air)
        } else {
            let force = self.process.update(feed_mm_min, speed_rpm, &place);
            let force_dyn_n = math::positive(force.value * dynamic);
            (force, force_dyn_n, force_dyn_n, !self.process.engaged(place.axial_depth_mm))
        };
        if let (None, Some(coupling)) = (&milled, &mut self.coupling)
            && self.tick > 0
        {
            force_dyn_n = coupling.pulses(force_dyn_n, &moved(!in_air));
            sensed_n = force_dyn_n;
        }
        if force_dyn_n > self.stop_n && self.stop.is_none() {
            self.stop = Some(ForceStop {
                force_n: force_dyn_n,
                limit_n: self.stop_n,
                position_mm: self.position_mm,
                time_s: self.tick as f64 * self.dt_s,
            });
        }
        self.teeth_n = milled;
        self.sensed_n = sensed_n;
        let (ra, ra_dyn) = if in_air {
            (Valued::new(0.0, true), Valued::new(0.0, true))
        } else {
            let by_force = roughness::produced(force.value, sensed_n, self.process.models());
            let added_um = self.coupling.as_ref().and_then(|coupling| coupling.added_ra_um());
            match added_um {
                Some(um) => (by_force.0, roughness::with_marks(by_force.0, um)),
                None => by_force,
            }
        };
        let row = &mut self.row;
        row.time_s = self.tick as f64 * self.dt_s;
        row.position_mm = self.position_mm;
        row.axial_depth_mm = place.axial_depth_mm;
        row.radial_depth_mm = place.radial_depth_mm;
        row.ra_target_um = self.target_ra_um;
        row.force_ref_n = self.desired_force.value;
        row.force_n = force.value;
        row.force_dyn_n = force_dyn_n;
        row.feed_mm_min = feed_mm_min;
        row.spindle_rpm = speed_rpm;
        row.ra_um = ra.value;
        row.ra_dyn_um = ra_dyn.value;
        row.used_life = self.wear.used_life();
        let mut lost_contact = false;
        if let Some(coupling) = &self.coupling {
            coupling.record(row);
            lost_contact = coupling.lost_contact();
        }
        let flags = self.command_flags
            | bit(!self.desired_force.valid, flag::K1_OUTSIDE)
            | bit(!force.valid, flag::K4_OUTSIDE)
            | bit(!ra.valid, flag::K5_OUTSIDE)
            | bit(!ra_dyn.valid, flag::K6_OUTSIDE)
            | bit(in_air, flag::AIR)
            | bit(lost_contact, flag::LOST_CONTACT);
        row.state_flags = f64::from(flags);
    }

    #[inline]
    fn check(&self) -> Result<(), Fault> {
        let values = self.row.values();
        // Sums instead of a test each: any NaN or infinity makes them not finite. Four at a time,
        // since one long sum would wait for itself.
        let mut sums = [0.0; 4];
        for (i, value) in values.iter().enumerate() {
            sums[i % 4] += value;
        }
        if ((sums[0] + sums[1]) + (sums[2] + sums[3])).is_finite() {
            return Ok(());
        }
        let signal = values.iter().position(|value| !value.is_finite());
        match signal {
            Some(index) => Err(Fault { signal: SIGNALS[index].id, tick: self.tick }),
            None => Ok(()),
        }
    }
}

/// Programmed values and limits of every cut; one entry where the path is one.
fn programmed_cuts(scenario: &Scenario) -> Vec<(FeedSpeed, Limits)> {
    let cuts = 0..scenario.workpiece.cuts.len().max(1);
    let of = |cut| (scenario.programmed(cut), limits(scenario, cut));
    cuts.map(of).collect()
}

/// The force that stops the feed.
fn stop_n(scenario: &Scenario) -> f64 {
    if scenario.cnc.force_stop { scenario.cnc.force_stop_n } else { f64::INFINITY }
}

#[inline]
fn bit(on: bool, bit: u32) -> u32 {
    if on { bit } else { 0 }
}

/// Limits of the commands in a cut, counted from 0: those of the overrides, and the controller's own.
#[must_use]
pub fn limits(scenario: &Scenario, cut: usize) -> Limits {
    let programmed = scenario.programmed(cut);
    let percent = if scenario.cnc.override_quantised { ratio_from_percent(1.0) } else { 0.0 };
    scenario.controller.kind.limits(Limits {
        feed_mm_min: scenario.cnc.range(programmed.feed_mm_min),
        speed_rpm: scenario.cnc.range(programmed.speed_rpm),
        resolution: FeedSpeed {
            feed_mm_min: programmed.feed_mm_min * percent,
            speed_rpm: programmed.speed_rpm * percent,
        },
    })
}
