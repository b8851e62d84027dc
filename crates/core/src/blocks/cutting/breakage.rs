//! Breakage: a tooth that is loaded beyond what it stands breaks; the next one then cuts its feed too.
//!
//! ```text
//! f (1 + b) / (z n) > h_max        thickest chip behind b broken teeth, of a full immersion, without run-out
//! F_dyn             > F_max        the largest force with all that shakes it
//! ```
//!
//! One tooth breaks at a time, and the next one not before the cutter has turned once and a control period is over: the
//! rest of the teeth have then met what is left. With the last tooth the tool is broken and the run ends, as it does at
//! once where a machine in the cut counts every tooth. Limits, and that nothing breaks by fatigue, are chosen.

use crate::base::language::tr;
use crate::models::tool::Tool;

crate::choice! {
    /// What broke a tooth.
    pub enum BreaksBy {
        /// A chip that was too thick.
        Chip = "chip", "too thick a chip";
        /// A force that was too large.
        Force = "force", "too large a force";
    }
}

/// A tooth that broke.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Breakage {
    /// What broke it.
    pub by: BreaksBy,
    /// Chip in mm or force in N that it met.
    pub load: f64,
    /// Chip in mm or force in N that it stands.
    pub stands: f64,
    /// Teeth that are broken now.
    pub broken: usize,
    /// Where along the way it happened, mm.
    pub position_mm: f64,
    /// When, s.
    pub time_s: f64,
}

impl std::fmt::Display for Breakage {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { by, load, stands, position_mm, time_s, .. } = *self;
        f.write_str(&match by {
            BreaksBy::Chip => tr!(
                "The tool broke at {time:.2} s, {position:.1} mm by too thick a chip, {load:.2} mm: it \
                 stands {stands:.2} mm",
                time = time_s,
                position = position_mm,
                load = load,
                stands = stands
            ),
            BreaksBy::Force => tr!(
                "The tool broke at {time:.2} s, {position:.1} mm by too large a force, {load:.0} N: it \
                 stands {stands:.0} N",
                time = time_s,
                position = position_mm,
                load = load,
                stands = stands
            ),
        })
    }
}

/// A moment of the cut, as far as it can break a tooth.
#[derive(Clone, Copy, Debug)]
pub struct LoadMoment {
    /// Actual feed, mm/min.
    pub feed_mm_min: f64,
    /// Actual speed, 1/min.
    pub speed_rpm: f64,
    /// The force with all that shakes it, N.
    pub force_n: f64,
    /// Where along the way, mm.
    pub position_mm: f64,
    /// When, s.
    pub time_s: f64,
}

/// What the teeth stand, and those that are broken.
#[derive(Clone, Debug)]
pub struct Strength {
    teeth: usize,
    chip_max_mm: f64,
    force_max_n: f64,
    /// Most feed in mm/min for every 1/min; infinite without a limit.
    feed_per_rpm: f64,
    /// Teeth broken by disturbances, and by load.
    given: usize,
    /// What broke by load, in order.
    breakages: Vec<Breakage>,
    /// No other tooth breaks before this time, s.
    not_before_s: f64,
    /// Control period, s.
    period_s: f64,
}

fn or_none(limit: f64) -> f64 {
    if limit > 0.0 { limit } else { f64::INFINITY }
}

impl Strength {
    /// Of a cutter whose load is seen anew after a control period of `period_s`.
    #[must_use]
    pub fn new(tool: &Tool, period_s: f64) -> Self {
        let mut this = Self {
            teeth: tool.teeth as usize,
            chip_max_mm: 0.0,
            force_max_n: 0.0,
            feed_per_rpm: 0.0,
            given: 0,
            breakages: Vec::new(),
            not_before_s: 0.0,
            period_s,
        };
        this.reconfigure(tool);
        this
    }

    /// Takes over changed limits; what is broken stays so.
    pub fn reconfigure(&mut self, tool: &Tool) {
        self.chip_max_mm = or_none(tool.chip_max_mm);
        self.force_max_n = or_none(tool.force_max_n);
        self.count();
    }

    fn count(&mut self) {
        let share = (1 + self.broken()) as f64;
        // Where no tooth is left, any feed is too much.
        let gone = self.is_gone();
        self.feed_per_rpm = if gone { 0.0 } else { self.chip_max_mm * self.teeth as f64 / share };
    }

    /// So many teeth are broken by disturbances.
    pub fn give(&mut self, broken: usize) {
        self.given = broken;
        self.count();
    }

    /// Teeth that are broken, at most all.
    #[must_use]
    pub fn broken(&self) -> usize {
        (self.given + self.breakages.len()).min(self.teeth)
    }

    /// What broke by load, in order.
    #[must_use]
    pub fn breakages(&self) -> &[Breakage] {
        &self.breakages
    }

    /// Whether a feed in mm/min at a speed in 1/min, or a force in N, is more than a tooth stands.
    #[must_use]
    #[inline]
    pub fn is_exceeded(&self, feed_mm_min: f64, speed_rpm: f64, force_n: f64) -> bool {
        feed_mm_min > self.feed_per_rpm * speed_rpm || force_n > self.force_max_n
    }

    /// Breaks a tooth by what exceeds its limit in this moment; none where one has just broken.
    pub fn break_tooth(&mut self, moment: &LoadMoment) -> Option<Breakage> {
        let LoadMoment { feed_mm_min, speed_rpm, force_n, position_mm, time_s } = *moment;
        if self.is_gone() {
            // The last one was broken by a disturbance behind those that broke by load.
            return self.breakages.last().map(|last| Breakage {
                broken: self.broken(),
                position_mm,
                time_s,
                ..*last
            });
        }
        if time_s < self.not_before_s {
            return None;
        }
        let by = if force_n > self.force_max_n { BreaksBy::Force } else { BreaksBy::Chip };
        let share = (1 + self.broken()) as f64;
        let (load, stands) = match by {
            BreaksBy::Force => (force_n, self.force_max_n),
            BreaksBy::Chip => {
                (share * feed_mm_min / (self.teeth as f64 * speed_rpm), self.chip_max_mm)
            }
        };
        let broken = self.broken() + 1;
        let breakage = Breakage { by, load, stands, broken, position_mm, time_s };
        self.breakages.push(breakage);
        self.count();
        let turn_s = if speed_rpm > 0.0 { 60.0 / speed_rpm } else { 0.0 };
        self.not_before_s = time_s + turn_s.max(self.period_s);
        Some(breakage)
    }

    /// Whether no tooth is left.
    #[must_use]
    pub fn is_gone(&self) -> bool {
        self.broken() >= self.teeth
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn moment(feed_mm_min: f64, force_n: f64, time_s: f64) -> LoadMoment {
        LoadMoment { feed_mm_min, speed_rpm: 1000.0, force_n, position_mm: 5.0, time_s }
    }

    #[test]
    fn a_tooth_breaks_beyond_its_chip_and_the_next_one_meets_twice_the_feed() {
        let tool = Tool { chip_max_mm: 0.3, force_max_n: 0.0, ..Tool::default() };
        let mut strength = Strength::new(&tool, 0.02);
        // 600 mm/min at 1000 1/min and two teeth are 0.3 mm.
        assert!(!strength.is_exceeded(600.0, 1000.0, 1e9), "no limit of the force");
        assert!(strength.is_exceeded(601.0, 1000.0, 0.0));
        let first = strength.break_tooth(&moment(610.0, 0.0, 1.0)).unwrap();
        assert_eq!((first.by, first.broken), (BreaksBy::Chip, 1));
        assert!((first.load - 0.305).abs() < 1e-12 && first.stands == 0.3);
        assert!(strength.is_exceeded(301.0, 1000.0, 0.0), "half the feed is as much now");
        assert_eq!(strength.break_tooth(&moment(610.0, 0.0, 1.05)), None, "not within a turn");
        assert!(!strength.is_gone());
        let last = strength.break_tooth(&moment(610.0, 0.0, 1.07)).unwrap();
        assert!(strength.is_gone() && (last.load - 0.61).abs() < 1e-12);
        assert!(last.to_string().contains("broke at 1.07 s, 5.0 mm by too thick a chip, 0.61 mm"));
    }

    #[test]
    fn a_force_breaks_too_and_without_limits_nothing_does() {
        let tool = Tool { chip_max_mm: 0.0, force_max_n: 2000.0, ..Tool::default() };
        let mut strength = Strength::new(&tool, 0.02);
        assert!(
            !strength.is_exceeded(1e9, 1000.0, 2000.0) && strength.is_exceeded(0.0, 1.0, 2001.0)
        );
        let found = strength.break_tooth(&moment(100.0, 2500.0, 0.5)).unwrap();
        assert_eq!((found.by, found.load, found.stands), (BreaksBy::Force, 2500.0, 2000.0));
        strength.reconfigure(&Tool { chip_max_mm: 0.0, force_max_n: 0.0, ..Tool::default() });
        assert!(!strength.is_exceeded(1e9, 1.0, 1e9));
        assert_eq!(strength.broken(), 1, "what is broken stays so");
        strength.give(1);
        assert!(strength.is_gone() && strength.is_exceeded(1.0, 1000.0, 0.0));
        let gone = strength.break_tooth(&moment(100.0, 10.0, 0.51)).unwrap();
        assert_eq!((gone.broken, gone.time_s), (2, 0.51));
    }
}
