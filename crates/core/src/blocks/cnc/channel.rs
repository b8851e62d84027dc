//! The way of a command through the CNC: overrides, dead time, overload guard, drives.
//!
//! ```text
//! request ─▶ overrides ─▶ dead time ─▶ operator's hand ─▶ overload guard ─▶ feed drive ──▶ f_a
//!            (percent)     (queue)      (factor, or 1)     (feed to zero)   spindle drive ─▶ n_a
//! ```
//!
//! A request is taken once in a control period and held; the rest passes every plant step.

use super::dead_time::DeadTime;
use super::feed_drive::{FeedDrive, FeedDriveSettings};
use super::feed_override::{Cnc, Overridden, Override};
use super::overload::{Overload, OverloadGuard};
use super::spindle_drive::{SpindleDrive, SpindleDriveSettings};
use crate::models::feed_speed::{FeedSpeed, Limits};

/// What a channel is set up from.
#[derive(Clone, Debug)]
pub struct ChannelSetup<'a> {
    /// Settings of the CNC.
    pub cnc: &'a Cnc,
    /// The feed drive.
    pub feed_drive: &'a FeedDriveSettings,
    /// The spindle drive.
    pub spindle_drive: &'a SpindleDriveSettings,
    /// Programmed values and limits of each cut, at least one.
    pub cuts: Vec<(FeedSpeed, Limits)>,
    /// Dead time, plant steps.
    pub dead_ticks: usize,
    /// Plant step, s.
    pub dt_s: f64,
    /// Control period, s.
    pub period_s: f64,
}

/// The channel with its state.
#[derive(Clone, Debug)]
pub struct Channel {
    cuts: Vec<(FeedSpeed, Limits)>,
    programmed: FeedSpeed,
    limits: Limits,
    feed_override: Override,
    spindle_override: Override,
    dead_time: DeadTime,
    /// Plant steps that the dead time is longer by, and those that it has by itself.
    added_ticks: usize,
    dead_ticks: usize,
    /// Factor of the operator's hand on the feed.
    by_hand: f64,
    guard: OverloadGuard,
    feed_drive: FeedDrive,
    spindle_drive: SpindleDrive,
    dt_s: f64,
    /// What is sent until the next request.
    sent: [Overridden; 2],
    actual: FeedSpeed,
    /// How far the machine goes, whoever asks.
    cnc: Cnc,
}

/// The force that stops the feed, N; `None` where that is switched off.
fn limit_n(cnc: &Cnc) -> Option<f64> {
    cnc.force_stop.then_some(cnc.force_stop_n)
}

impl Channel {
    /// The channel at rest at the programmed values of the first cut, as far as the machine goes.
    #[must_use]
    pub fn new(setup: &ChannelSetup) -> Self {
        let ChannelSetup { cnc, dt_s, period_s, .. } = *setup;
        let (programmed, limits) = setup.cuts[0];
        let FeedSpeed { feed_mm_min, speed_rpm } = cnc.within(programmed);
        let feed_drive = FeedDrive::new(setup.feed_drive, dt_s, feed_mm_min);
        let spindle_drive = SpindleDrive::new(setup.spindle_drive, dt_s, speed_rpm);
        let actual =
            FeedSpeed { feed_mm_min: feed_drive.actual(), speed_rpm: spindle_drive.actual() };
        Self {
            cuts: setup.cuts.clone(),
            programmed,
            limits,
            feed_override: Override::new(cnc, feed_mm_min, programmed.feed_mm_min, period_s),
            spindle_override: Override::new(cnc, speed_rpm, programmed.speed_rpm, period_s),
            dead_time: DeadTime::new(setup.dead_ticks, [feed_mm_min, speed_rpm]),
            added_ticks: 0,
            dead_ticks: setup.dead_ticks,
            by_hand: 1.0,
            guard: OverloadGuard::new(limit_n(cnc)),
            feed_drive,
            spindle_drive,
            dt_s,
            sent: [
                Overridden::at_start(feed_mm_min, programmed.feed_mm_min),
                Overridden::at_start(speed_rpm, programmed.speed_rpm),
            ],
            actual,
            cnc: cnc.clone(),
        }
    }

    /// Takes over changed settings in the cut of this number; what is under way goes on.
    pub fn reconfigure(&mut self, setup: &ChannelSetup, cut: usize) {
        self.cnc.clone_from(setup.cnc);
        self.cuts.clone_from(&setup.cuts);
        self.limits = self.cuts[cut].1;
        self.guard.reconfigure(limit_n(setup.cnc));
        self.feed_override.reconfigure(setup.cnc, setup.period_s);
        self.spindle_override.reconfigure(setup.cnc, setup.period_s);
        self.dead_ticks = setup.dead_ticks;
        self.size_queue();
        self.feed_drive.reconfigure(setup.feed_drive, self.dt_s);
        self.spindle_drive.reconfigure(setup.spindle_drive, self.dt_s);
    }

    fn size_queue(&mut self) {
        let ticks = self.dead_ticks + self.added_ticks;
        self.dead_time.resize(ticks, self.sent.map(|sent| sent.command));
    }

    /// Makes the dead time longer by so many plant steps, and turns the feed by hand to so many times what is
    /// commanded. The hand is at the machine: it does not wait in the queue, and no limit of commands holds it but how far
    /// the machine goes.
    pub fn disturb(&mut self, added_ticks: usize, by_hand: f64) {
        if self.added_ticks != added_ticks {
            self.added_ticks = added_ticks;
            self.size_queue();
        }
        self.by_hand = by_hand;
    }

    /// Factor of the operator's hand on the feed.
    #[must_use]
    pub fn by_hand(&self) -> f64 {
        self.by_hand
    }

    /// The cut of this number begins: at rest at its programmed values, as far as the machine goes. The spindle turns on.
    pub fn restart(&mut self, cut: usize) {
        (self.programmed, self.limits) = self.cuts[cut];
        let programmed = self.programmed;
        let FeedSpeed { feed_mm_min, speed_rpm } = self.cnc.within(programmed);
        self.feed_override.restart(feed_mm_min, programmed.feed_mm_min);
        self.spindle_override.restart(speed_rpm, programmed.speed_rpm);
        self.dead_time.restart([feed_mm_min, speed_rpm]);
        self.feed_drive.restart(feed_mm_min);
        let starts = [(feed_mm_min, programmed.feed_mm_min), (speed_rpm, programmed.speed_rpm)];
        for (sent, (command, programmed)) in self.sent.iter_mut().zip(starts) {
            let start = Overridden::at_start(command, programmed);
            (sent.command, sent.percent) = (start.command, start.percent);
        }
    }

    /// A control period: what is sent for a request until the next one.
    pub fn command(&mut self, request: FeedSpeed) {
        self.sent = [
            self.feed_override.update(request.feed_mm_min, self.limits.feed_mm_min),
            self.spindle_override.update(request.speed_rpm, self.limits.speed_rpm),
        ];
    }

    /// A plant step: feed and speed at its end.
    #[inline]
    pub fn advance(&mut self) -> FeedSpeed {
        let [feed, speed_rpm] = self.dead_time.pass(self.sent.map(|sent| sent.command));
        // A stop does not wait in the queue.
        let feed_mm_min = if self.guard.met().is_some() {
            0.0
        } else {
            self.cnc.feed_within(feed * self.by_hand)
        };
        self.actual = FeedSpeed {
            feed_mm_min: self.feed_drive.update(feed_mm_min),
            speed_rpm: self.spindle_drive.update(speed_rpm),
        };
        self.actual
    }

    /// Shows the guard the force in N that acts at a position in mm and a time in s.
    #[inline]
    pub fn guard(&mut self, force_n: f64, position_mm: f64, time_s: f64) {
        self.guard.watch(force_n, position_mm, time_s);
    }

    /// Stops the feed at once, past the dead time, for good: a controller has met its own limit.
    pub fn stop(&mut self, overload: Overload) {
        self.guard.stop(overload);
    }

    /// What has stopped the feed, if anything has.
    #[must_use]
    pub fn overload(&self) -> Option<Overload> {
        self.guard.met()
    }

    /// Programmed values of the present cut.
    #[must_use]
    pub fn programmed(&self) -> FeedSpeed {
        self.programmed
    }

    /// Limits of the commands in the present cut.
    #[must_use]
    pub fn limits(&self) -> Limits {
        self.limits
    }

    /// What is sent now, of feed and speed.
    #[must_use]
    #[inline]
    pub fn sent(&self) -> &[Overridden; 2] {
        &self.sent
    }

    /// The command that is sent now.
    #[must_use]
    pub fn command_sent(&self) -> FeedSpeed {
        let [feed, speed] = &self.sent;
        FeedSpeed { feed_mm_min: feed.command, speed_rpm: speed.command }
    }

    /// Whether both drives know what they reach: the commands lie within the ranges of formulas of one's own.
    #[must_use]
    #[inline]
    pub fn drives_are_known(&self) -> bool {
        self.feed_drive.is_known() && self.spindle_drive.is_known()
    }

    /// Feed and speed that the drives have reached.
    #[must_use]
    pub fn actual(&self) -> FeedSpeed {
        self.actual
    }
}
