//! What a whole cut comes to, held against its target.

use serde::Serialize;

use super::super::metrics::{HELD_PERCENT, Judged};
use super::super::one_run::Run;
use crate::base::language::fixed;

/// See the head of this file. Judged by the tolerance that the run began with, around the target as it was at each
/// moment; where Ra is to be held and the machine vibrates in the cut, Ra with dynamics is judged, which is what is left
/// on the part.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct CutVerdict {
    /// Whether the target was held; none where what is not judged could decide it, and without contact.
    pub held: Option<bool>,
    /// Share of the cut length on which a target counts as held, percent.
    pub held_from_percent: f64,
    /// Half-width of the tolerance, percent of the target.
    pub tolerance_percent: f64,
    /// Share of the cut length within the tolerance, percent; none without contact.
    pub in_tolerance_percent: Option<f64>,
    /// The same of Ra without dynamics, where it is Ra with dynamics that is judged, percent.
    pub without_dynamics_percent: Option<f64>,
    /// Share of the cut length that is not judged, percent; none without contact.
    pub not_judged_percent: Option<f64>,
    /// Share of the cut length beyond the upper end of the tolerance, percent: too rough, or the force too large; none
    /// without contact.
    pub above_tolerance_percent: Option<f64>,
    /// Share of the time in which a model was asked outside its range, percent.
    pub outside_percent: f64,
    /// Longest time in contact outside the tolerance without a break, s.
    pub longest_out_s: f64,
}

impl CutVerdict {
    /// A share in percent, as people read it: what is short of being held is not rounded up to it.
    #[must_use]
    pub fn share_text(&self, percent: f64) -> String {
        let tenths = (10.0 * percent).round() / 10.0;
        let held = self.held_from_percent;
        let short = percent < held && tenths >= held;
        fixed(if short { held - 0.1 } else { tenths }, 1) + " %"
    }

    /// That of a run as it is recorded.
    pub(super) fn of(run: &Run) -> Self {
        let metrics = run.metrics();
        let recording = run.recording();
        let judged = Judged::by(run.scenario(), recording.control_every());
        let (mut longest_out_s, mut since_s) = (0.0_f64, None);
        for row in recording.rows() {
            if judged.strays(row) {
                let since_s = *since_s.get_or_insert(row.time_s);
                longest_out_s = longest_out_s.max(row.time_s - since_s);
            } else {
                since_s = None;
            }
        }
        Self {
            held: if judged.shakes() { metrics.held_with_dynamics() } else { metrics.held() },
            held_from_percent: HELD_PERCENT,
            tolerance_percent: run.scenario().target.tolerance_percent,
            in_tolerance_percent: metrics.judged_in_tolerance_percent(),
            without_dynamics_percent: judged
                .shakes()
                .then_some(metrics.in_tolerance_percent)
                .flatten(),
            not_judged_percent: metrics.not_judged_percent,
            above_tolerance_percent: metrics.judged_above_tolerance_percent(),
            outside_percent: metrics.outside_percent,
            longest_out_s,
        }
    }
}
