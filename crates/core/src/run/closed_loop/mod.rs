//! The closed loop: every value that passes between blocks passes here. Read this first.
//!
//! ```text
//!  Ra_target ─▶ reference ─F_d─▶ controller ─feed %, spindle %─▶ override limits ─f_c, n_c─▶ dead time
//!                 (K1)       ┌─▶ (K2, K3)                                                  (queue)
//!                           F_m                                                     f_c, n_c delayed
//!                            │                                                             ▼
//!                       dynamometer                               A_D            feed drive, spindle drive
//!                            ▲                                     ▼                       │
//!                          F_dyn ◀── dynamic component ◀──F── cutting process ◀──f_a, n_a──┘
//!                            ▼                           ▼        (K4)
//!                     surface (K6) ─▶ Ra_dyn      surface (K5) ─▶ Ra
//! ```
//!
//! The plant's force is a map, or simulated tooth by tooth; with `machine.coupled` the five-mass machine
//! stands behind it ([`machine`]): F_dyn is then the force with regeneration, Ra_dyn = Ra + what the
//! teeth's marks add.
//!
//! Order of events in tick k (from t = k dt to (k + 1) dt):
//! 0. Every `steps_per_control` ticks the tool wears by what it cut since the last time; where the speed
//!    is adjusted to the tool's life ([`life`]), its sound is observed.
//!    Disturbances along the way are looked up by place: those of tool, sensor, dead time and operator then, those of
//!    part and force in 4 and 5.
//! 1. Every `steps_per_control` ticks the controller sees the force sensed at the end of tick
//!    k - 1 and asks for a command, limited by the overrides; it is held until the next sample. One
//!    with a limit of its own may ask for a stop, which does not wait for the dead time.
//! 2. The command enters the dead-time queue; what leaves it is what the drives get.
//! 3. The drives advance over dt with that command held: feed f_a, speed n_a.
//! 4. The tool moves on by f_a dt, at the end of a cut to the next one; the workpiece gives the depth. A
//!    tool fed into it faster than its teeth clear it ends the run: a crash. A tooth loaded beyond what it stands
//!    breaks; the last one ends the run ([`crate::blocks::cutting::breakage`]).
//! 5. Force and dynamic component follow from f_a, n_a and depth; a coupled machine makes its steps of
//!    at most 0.1 ms over dt under that force and shakes it.
//! 6. The sensor takes the force, the overload guard looks at it, the surface is left.
//! 7. The row is written; it belongs to the time (k + 1) dt. Row 0 is the state before tick 0.

mod clock;
mod disturbed;
pub mod life;
pub mod machine;
mod plant;
mod record;
mod setup;

use serde::Serialize;

use self::clock::Clock;
use self::life::{Stretch, ToolLife};
use self::plant::Plant;
use self::record::{Sample, bit};
pub use self::setup::limits;
use super::signals::{Row, flag};
use crate::base::language::tr;
use crate::blocks::cnc::channel::Channel;
use crate::blocks::cnc::overload::Overload;
use crate::blocks::control::script::ScriptProblem;
use crate::blocks::control::unks::Learning;
use crate::blocks::control::{ControlInput, Controller, Exceeded, OverloadReaction};
use crate::blocks::cutting::breakage::Breakage;
use crate::blocks::cutting::crash::Crash;
use crate::blocks::reference::Desired;
use crate::blocks::sensing::force_sensor::ForceSensor;
use crate::blocks::surface::produced::Surface;

/// A value that stopped being finite: the run ends there, before anything spreads.
#[derive(Clone, Debug, PartialEq, Serialize, thiserror::Error)]
#[error("{}", tr!("`{signal}` is not finite at tick {tick}: the run ends", signal = *signal, tick = *tick))]
pub struct Fault {
    /// The signal.
    pub signal: &'static str,
    /// The tick at which it happened.
    pub tick: u64,
}

/// A script that failed: the run ends at that control sample.
#[derive(Clone, Debug, PartialEq, Serialize, thiserror::Error)]
#[error("{}", tr!("The script failed at {time:.2} s, {problem}: the run ends", time = *time_s, problem = problem.to_string()))]
pub struct ScriptFault {
    /// What went wrong, and where in the script.
    #[serde(flatten)]
    pub problem: ScriptProblem,
    /// When, s.
    pub time_s: f64,
}

/// What ends a run within a step: the row of that step is not written.
#[derive(Clone, Debug, PartialEq)]
pub enum Halt {
    /// The tool was fed into the work without cutting its way.
    Crash(Crash),
    /// The last tooth broke.
    Breakage(Breakage),
    /// A signal stopped being finite.
    Fault(Fault),
    /// The controller's script failed.
    Script(ScriptFault),
}

/// The loop with all its blocks and their state.
#[derive(Clone, Debug)]
pub struct ClosedLoop {
    clock: Clock,
    desired: Desired,
    controller: Controller,
    /// What adjusts the programmed speed to the tool's life, where that is wanted.
    life: Option<Box<ToolLife>>,
    cnc: Channel,
    plant: Plant,
    sensor: ForceSensor,
    surface: Surface,
    /// What the last control sample has read and asked for.
    sample: Sample,
    /// The record of the present moment.
    row: Row,
}

impl ClosedLoop {
    /// One tick, in the order given at the head of this file.
    ///
    /// # Errors
    /// A crash, or the first signal that is not finite; the state is then that of the fault.
    #[inline]
    pub fn step(&mut self) -> Result<(), Halt> {
        if let Some(sample) = self.clock.control_sample() {
            self.wear();
            self.control(sample).map_err(Halt::Script)?;
        }
        let motion = self.cnc.advance();
        let (tick, air_n) = (self.clock.advance(), self.desired.air_n());
        let surface = &mut self.surface;
        let began = self.plant.step(tick, motion, air_n, |tooth| surface.pass(tooth));
        if let Some(number) = began {
            self.restart(number);
        }
        if self.plant.crashes() {
            return Err(Halt::Crash(self.plant.crash(self.clock.time_s())));
        }
        if self.plant.is_overloaded()
            && let Some(broke) = self.plant.break_tooth(self.clock.time_s())
        {
            return Err(Halt::Breakage(broke));
        }
        let cut = self.plant.now();
        let force = &cut.force;
        self.sensor.take(tick, force.dynamic_n, self.plant.across_n());
        self.cnc.guard(self.plant.acting_n(), cut.position_mm, self.clock.time_s());
        let ra = self.surface.leave(force.model.value, force.dynamic_n, force.air);
        self.record(ra);
        self.check().map_err(Halt::Fault)
    }

    /// The tool wears over the last control period; its sound may change the speed.
    fn wear(&mut self) {
        if self.clock.tick() == 0 {
            return self.plant.apply_wear();
        }
        let period_s = self.clock.period_s();
        self.plant.wear(period_s);
        if let Some(life) = &mut self.life {
            let now = self.plant.now();
            let stretch = Stretch {
                dt_s: period_s,
                feed_mm_min: now.motion.feed_mm_min,
                cut: now.cut(),
                sound_mm_s: now.vibration.sound_mm_s,
                in_cut: !now.force.air,
            };
            life.observe(&stretch, &self.desired.models);
        }
    }

    /// What disturbs sensor and channel where the tool is: gives what the sensor tells of a force in N.
    fn disturb(&mut self, read_n: f64) -> f64 {
        let Some(all) = self.plant.disturbances() else {
            return read_n;
        };
        let position_mm = self.plant.now().position_mm;
        let added_ticks = (all.added_dead_time_s(position_mm) / self.clock.dt_s()).round() as usize;
        self.cnc.disturb(added_ticks, all.operator_factor(position_mm));
        all.sensed_n(position_mm, read_n)
    }

    /// The controller's turn: from the sensed force to the command that is sent.
    fn control(&mut self, sample: u64) -> Result<(), ScriptFault> {
        let force_measured_n = self.disturb(self.sensor.read(sample));
        let programmed = self.cnc.programmed();
        let (cut, x_mm) = self.plant.place_in_cut();
        let output = self.controller.update(&ControlInput {
            force_measured_n,
            force_ref_n: self.desired.force.value,
            programmed: self.life.as_ref().map_or(programmed, |life| life.adjust(programmed)),
            applied: self.cnc.command_sent(),
            limits: self.cnc.limits(),
            models: &self.desired.models,
            cut,
            x_mm,
            by_hand: self.cnc.by_hand(),
        });
        if let Some(problem) = self.controller.problem() {
            return Err(ScriptFault { problem: problem.clone(), time_s: self.clock.time_s() });
        }
        self.cnc.command(output.request);
        let [feed, speed] = self.cnc.sent();
        self.sample = Sample {
            force_measured_n,
            force_setpoint_n: output.force_setpoint_n,
            gain_estimate: output.gain_estimate,
            flags: bit(feed.saturated, flag::FEED_SATURATED)
                | bit(speed.saturated, flag::SPEED_SATURATED)
                | bit(feed.rate_limited, flag::FEED_RATE_LIMITED)
                | bit(speed.rate_limited, flag::SPEED_RATE_LIMITED)
                | bit(!output.feed_model_valid, flag::K2_OUTSIDE)
                | bit(!output.speed_model_valid, flag::K3_OUTSIDE)
                | bit(output.exceeded.is_some(), flag::OVER_LIMIT)
                | bit(output.switched_off, flag::CONTROL_OFF),
        };
        if let Some(exceeded) = output.exceeded {
            self.react(&exceeded, force_measured_n);
        }
        Ok(())
    }

    /// A controller's own limit is exceeded: what it wants done.
    fn react(&mut self, exceeded: &Exceeded, force_n: f64) {
        let retracted = match exceeded.reaction {
            OverloadReaction::Message => return,
            OverloadReaction::Stop => false,
            OverloadReaction::RetractStop => true,
        };
        let (limit_n, time_s) = (exceeded.limit_n, self.clock.time_s());
        let position_mm = self.plant.now().position_mm;
        self.cnc.stop(Overload { force_n, limit_n, position_mm, time_s, retracted });
    }

    /// Steps done so far.
    #[must_use]
    pub fn tick(&self) -> u64 {
        self.clock.tick()
    }

    /// What has stopped the feed, if anything has.
    #[must_use]
    pub fn overload(&self) -> Option<Overload> {
        self.cnc.overload()
    }

    /// Fraction of the tool's life that is used: 1 at its end.
    #[must_use]
    pub fn used_life(&self) -> f64 {
        self.plant.used_life()
    }

    /// The teeth that broke under their load so far, in order.
    #[must_use]
    pub fn breakages(&self) -> &[Breakage] {
        self.plant.breakages()
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
        self.plant.teeth()
    }

    /// What can be seen of the controller's networks that learn in the cut, if it has any.
    #[must_use]
    pub fn learning(&self) -> Option<Learning<'_>> {
        self.controller.learning()
    }
}
