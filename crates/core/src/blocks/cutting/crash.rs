//! A crash: a tool that is fed into the work faster than its teeth clear it.
//!
//! ```text
//! f / (z n) > D / 2        in front of material
//! ```
//!
//! Between two teeth the cutter then moves on by more than its radius, so that its body, and not an edge,
//! meets the work (chosen; real cutters break at a fraction of it). A standing spindle is the limit of it.

use crate::base::language::tr;
use crate::models::tool::Tool;

/// A crash that has ended a run.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Crash {
    /// Actual feed, mm/min.
    pub feed_mm_min: f64,
    /// Actual speed, 1/min.
    pub speed_rpm: f64,
    /// Radius of the cutter: the most that a tooth can be fed, mm.
    pub radius_mm: f64,
    /// Where along the way it happened, mm.
    pub position_mm: f64,
    /// When, s.
    pub time_s: f64,
}

impl std::fmt::Display for Crash {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { feed_mm_min, speed_rpm, radius_mm, position_mm, time_s } = *self;
        f.write_str(&tr!(
            "The tool crashed at {time:.2} s, {position:.1} mm: a feed of {feed:.0} mm/min at {speed:.1} \
             1/min is more than the cutter's radius, {radius} mm, for each tooth",
            time = time_s,
            position = position_mm,
            feed = feed_mm_min,
            speed = speed_rpm,
            radius = radius_mm
        ))
    }
}

/// Most that a turn of a cutter can be fed without a crash, mm: its radius for each tooth.
#[must_use]
pub fn most_per_turn_mm(tool: &Tool) -> f64 {
    0.5 * tool.diameter_mm * f64::from(tool.teeth)
}
