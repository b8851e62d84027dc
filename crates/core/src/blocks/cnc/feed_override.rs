//! Overrides: commands reach the machine in percent of the programmed values (2013: DNCFRO for the
//! feed, DNCSPO for the spindle, 0..250 %). A CNC takes whole percents and moves to a new override
//! no faster than a rate; both can be switched on, and are off in the papers' simulations.
//!
//! ```text
//! wanted  = limit(request, override range)                       in percent of the programmed value
//! ramp   += limit(wanted - ramp, -rate T, rate T)                rate-limited
//! sent    = round(ramp)                                          quantised
//! ```

use crate::base::math::{limit, positive};
use crate::base::units::{percent_from_ratio, ratio_from_percent};
use crate::models::feed_drive::DEAD_TIME_MAX_S;
use crate::models::feed_speed::FeedSpeed;

/// The largest feed of a machine without a limit of its own, mm/min: 250 % of the largest that can be programmed.
pub const FEED_WITHOUT_LIMIT_MM_MIN: f64 = 12_500.0;
/// The largest spindle speed of a machine without a limit of its own, 1/min: 250 % of the largest that can be programmed.
pub const SPEED_WITHOUT_LIMIT_RPM: f64 = 50_000.0;

crate::settings! {
    /// The command channel of the CNC.
    pub struct Cnc {
        /// Least override of feed and spindle, in percent of the programmed values.
        override_min_percent: f64 = 0.0, [0.0, 100.0], "%", live, "Least override";
        /// Largest override of feed and spindle, in percent of the programmed values.
        override_max_percent: f64 = 250.0, [100.0, 250.0], "%", live, "Largest override";
        /// Whether overrides are whole percents, as DNCFRO and DNCSPO are.
        override_quantised: bool = false, [], "", live, "Whole percents";
        /// Whether overrides move no faster than the override rate.
        override_rate_limited: bool = false, [], "", live, "Limit override rate";
        /// Fastest change of an override (chosen: no paper gives it).
        override_rate_percent_s: f64 = 500.0, [10.0, 10000.0], "%/s", live, "Override rate";
        /// Whether an overload stops the feed at once, past the dead time, for good.
        force_stop: bool = false, [], "", live, "Stop on overload";
        /// The force that stops the feed; 2000 N is three times the reference of Experiment 2 (chosen).
        force_stop_n: f64 = 2000.0, [50.0, 20000.0], "N", live, "Stopping force";
        /// Dead time of the command channel (the PLC): a whole number of plant steps. Choosing a
        /// feed drive sets the dead time published with it.
        dead_time_s: f64 = 0.08, [0.0, DEAD_TIME_MAX_S], "s", live, "Dead time";
        /// Largest feed of the machine, whatever is programmed and asked for; 12500 mm/min is none: nothing asks for
        /// more.
        feed_max_mm_min: f64 = FEED_WITHOUT_LIMIT_MM_MIN, [10.0, FEED_WITHOUT_LIMIT_MM_MIN], "mm/min", live, "Largest feed";
        /// Least spindle speed of the machine, whatever is programmed and asked for; 0 is none.
        speed_min_rpm: f64 = 0.0, [0.0, 20000.0], "1/min", live, "Least speed";
        /// Largest spindle speed of the machine, whatever is programmed and asked for; 50000 1/min is none: nothing asks
        /// for more.
        speed_max_rpm: f64 = SPEED_WITHOUT_LIMIT_RPM, [100.0, SPEED_WITHOUT_LIMIT_RPM], "1/min", live, "Largest speed";
    }
}

crate::settings! {
    /// The NC program.
    pub struct Program {
        /// Programmed feed: 100 % override, and the feed at the start of the run.
        feed_mm_min: f64 = 430.41, [10.0, 5000.0], "mm/min", setup, "Programmed feed";
        /// Programmed spindle speed: 100 % override, and the speed at the start of the run.
        spindle_rpm: f64 = 1571.0, [100.0, 20000.0], "1/min", setup, "Programmed speed";
        /// Programmed feed of each cut of the workpiece, for example as the plan finds them; a cut
        /// without one is programmed with the feed above.
        cut_feeds_mm_min: Vec<f64> = Vec::new(), [10.0, 5000.0], "mm/min", setup, "Feeds per cut";
    }
}

impl Program {
    /// Programmed feed of a cut, counted from 0, mm/min.
    #[must_use]
    pub fn feed_of_cut_mm_min(&self, cut: usize) -> f64 {
        self.cut_feeds_mm_min.get(cut).copied().unwrap_or(self.feed_mm_min)
    }
}

impl Cnc {
    /// The range that the overrides leave of commands, in the unit of `programmed`.
    #[must_use]
    pub fn range(&self, programmed: f64) -> [f64; 2] {
        [
            programmed * ratio_from_percent(self.override_min_percent),
            programmed * ratio_from_percent(self.override_max_percent),
        ]
    }

    /// A feed in mm/min as far as the machine goes.
    #[must_use]
    #[inline]
    pub fn feed_within(&self, feed_mm_min: f64) -> f64 {
        limit(feed_mm_min, 0.0, self.feed_max_mm_min)
    }

    /// A spindle speed in 1/min as far as the machine goes.
    #[must_use]
    pub fn speed_within(&self, speed_rpm: f64) -> f64 {
        limit(speed_rpm, self.speed_min_rpm, self.speed_max_rpm)
    }

    /// Feed and speed as far as the machine goes.
    #[must_use]
    pub fn within(&self, asked: FeedSpeed) -> FeedSpeed {
        FeedSpeed {
            feed_mm_min: self.feed_within(asked.feed_mm_min),
            speed_rpm: self.speed_within(asked.speed_rpm),
        }
    }
}

/// One override channel's answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overridden {
    /// The command that is sent, in the unit of the programmed value; never negative, never NaN.
    pub command: f64,
    /// The same in percent of the programmed value.
    pub percent: f64,
    /// Whether a limit acted.
    pub saturated: bool,
    /// Whether the rate limit acted.
    pub rate_limited: bool,
}

impl Overridden {
    /// What is sent at the start of a cut: what is `programmed`, as far as the machine goes.
    #[must_use]
    pub fn at_start(command: f64, programmed: f64) -> Self {
        let percent = percent_of(command, programmed);
        Self { command, percent, saturated: command != programmed, rate_limited: false }
    }
}

/// A command in percent of what is programmed: 100 to the bit where it is that.
fn percent_of(command: f64, programmed: f64) -> f64 {
    if command == programmed { 100.0 } else { percent_from_ratio(command / programmed) }
}

/// One channel, of feed or spindle.
#[derive(Clone, Debug)]
pub struct Override {
    programmed: f64,
    quantised: bool,
    /// Largest change per control period in percent; infinite without a rate limit.
    step_percent: f64,
    /// The rate-limited override before it is made a whole percent: with a slow rate it moves by
    /// less than a percent a period and must not stand still.
    ramp_percent: f64,
}

impl Override {
    /// A channel that sends `command` of what is `programmed`, for control periods of `period_s`.
    #[must_use]
    pub fn new(cnc: &Cnc, command: f64, programmed: f64, period_s: f64) -> Self {
        let ramp_percent = percent_of(command, programmed);
        let mut this = Self { programmed, quantised: false, step_percent: 0.0, ramp_percent };
        this.reconfigure(cnc, period_s);
        this
    }

    /// Sends `command` of what is `programmed` for the cut that begins.
    pub fn restart(&mut self, command: f64, programmed: f64) {
        self.programmed = programmed;
        self.ramp_percent = percent_of(command, programmed);
    }

    /// Takes over changed settings; the override keeps its present value.
    pub fn reconfigure(&mut self, cnc: &Cnc, period_s: f64) {
        self.quantised = cnc.override_quantised;
        self.step_percent = if cnc.override_rate_limited {
            cnc.override_rate_percent_s * period_s
        } else {
            f64::INFINITY
        };
    }

    /// One control period: the command for a request, within `range`, both in the unit of the
    /// programmed value.
    #[must_use]
    pub fn update(&mut self, request: f64, range: [f64; 2]) -> Overridden {
        let mut command = positive(limit(request, range[0], range[1]));
        let saturated = command != request;
        let mut percent = percent_from_ratio(command / self.programmed);
        let (lowest, highest) =
            (self.ramp_percent - self.step_percent, self.ramp_percent + self.step_percent);
        let ramp = limit(percent, lowest, highest);
        let rate_limited = ramp != percent;
        self.ramp_percent = ramp;
        if rate_limited || self.quantised {
            percent = if self.quantised { self.whole(ramp, range) } else { ramp };
            command = self.programmed * ratio_from_percent(percent);
        }
        Overridden { command, percent, saturated, rate_limited }
    }

    /// The nearest whole percent, inside the range where a whole percent fits into it.
    fn whole(&self, percent: f64, range: [f64; 2]) -> f64 {
        let of = |command: f64| percent_from_ratio(command / self.programmed);
        // 1e-9: 250 % of a programmed value must not become 249.99.. %.
        let (lowest, highest) = ((of(range[0]) - 1e-9).ceil(), (of(range[1]) + 1e-9).floor());
        let nearest = percent.round();
        // A ramp may be outside a range that has just become narrower: it goes on from there.
        if nearest < lowest && percent >= of(range[0]) {
            lowest
        } else if nearest > highest && percent <= of(range[1]) {
            highest
        } else {
            nearest
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RANGE: [f64; 2] = [69.7, 1000.0];

    fn channel(cnc: &Cnc) -> Override {
        Override::new(cnc, 400.0, 400.0, 0.02)
    }

    #[test]
    fn without_switches_only_the_range_acts() {
        let mut channel = channel(&Cnc::default());
        let inside = channel.update(300.0, RANGE);
        assert_eq!((inside.command, inside.percent), (300.0, 75.0));
        assert!(!inside.saturated && !inside.rate_limited);
        let above = channel.update(1e9, RANGE);
        assert_eq!((above.command, above.percent, above.saturated), (1000.0, 250.0, true));
        assert_eq!(channel.update(f64::NAN, RANGE).command, 69.7);
    }

    #[test]
    fn quantised_overrides_are_whole_percents_within_the_range() {
        let mut channel = channel(&Cnc { override_quantised: true, ..Cnc::default() });
        for request in [-1.0, 0.0, 69.8, 71.0, 75.9, 301.3, 555.0, 999.9, 1e6] {
            let out = channel.update(request, RANGE);
            assert_eq!(out.percent, out.percent.round());
            assert_eq!(out.command, 400.0 * out.percent / 100.0);
            assert!(out.command >= RANGE[0] && out.command <= RANGE[1], "{request}: {out:?}");
            let wanted = limit(request, RANGE[0], RANGE[1]);
            assert!((out.command - wanted).abs() <= 4.0, "at most a percent away");
        }
        assert_eq!(channel.update(69.7, RANGE).percent, 18.0, "17 % would be below the range");
        assert_eq!(channel.update(1e6, RANGE).percent, 250.0);
    }

    #[test]
    fn a_rate_limited_override_ramps_and_a_slow_one_does_not_stick() {
        let rate = |override_rate_percent_s, override_quantised| Cnc {
            override_rate_limited: true,
            override_rate_percent_s,
            override_quantised,
            ..Cnc::default()
        };
        let mut fast = channel(&rate(500.0, false));
        let ramp: Vec<f64> = (0..4).map(|_| fast.update(500.0, RANGE).percent).collect();
        assert_eq!(ramp, [110.0, 120.0, 125.0, 125.0]);
        let mut slow = channel(&rate(10.0, true));
        let steps: Vec<Overridden> = (0..500).map(|_| slow.update(800.0, RANGE)).collect();
        assert!(steps[499].percent == 200.0 && steps[0].rate_limited);
        assert!(steps.windows(2).all(|w| (w[1].percent - w[0].percent).abs() <= 1.0));
    }
}
