//! What a stretch of rows comes to: its means, and how far it is from what it should be.

use serde::Serialize;

use super::super::signals::{Row, flag};
use crate::base::stats;
use crate::base::units::percent_from_ratio;
use crate::blocks::reference::Reference;

/// Most rows that a mean is taken over: a second at 1 kHz.
const MOST_ROWS: usize = 1000;

/// The produced Ra of a row, um; none in the air, and none where the model ends at zero.
#[must_use]
pub fn produced_ra_um(row: &Row) -> Option<f64> {
    (!row.has(flag::AIR) && !row.ra_has_ended()).then_some(row.ra_um)
}

/// Deviation of what is to be held from its reference, as a fraction of that; none in the air.
#[must_use]
pub fn deviation(row: &Row, held: Reference) -> Option<f64> {
    let relative = |value: f64, reference: f64| (value - reference) / reference;
    match held {
        Reference::Ra => produced_ra_um(row).map(|ra| relative(ra, row.ra_target_um)),
        Reference::Force => (!row.has(flag::AIR)).then(|| force_error(row)),
    }
}

/// Deviation of the force from its reference, as a fraction of that, which is never zero.
#[must_use]
pub fn force_error(row: &Row) -> f64 {
    (row.force_n - row.force_ref_n) / row.force_ref_n
}

/// Deviation of Ra with dynamics from the target, as a fraction of that; none in the air, and where its model or that
/// of Ra has ended at zero.
#[must_use]
pub fn shaken_deviation(row: &Row) -> Option<f64> {
    shaken_ra_um(row).map(|ra_um| (ra_um - row.ra_target_um) / row.ra_target_um)
}

/// Ra with dynamics of a row, um; none as [`shaken_deviation`] has it.
pub(super) fn shaken_ra_um(row: &Row) -> Option<f64> {
    let ended = row.has(flag::K6_OUTSIDE) && row.ra_dyn_um == 0.0;
    produced_ra_um(row).and((!ended).then_some(row.ra_dyn_um))
}

/// The values of rows in contact, row by row; those that a row does not have are left out.
#[derive(Default)]
struct Values {
    ra_um: Vec<f64>,
    shaken_ra_um: Vec<f64>,
    force_n: Vec<f64>,
    feed_mm_min: Vec<f64>,
    spindle_rpm: Vec<f64>,
    deviation: Vec<f64>,
    shaken_deviation: Vec<f64>,
}

impl Values {
    fn add(&mut self, row: &Row, held: Reference) {
        self.ra_um.extend(produced_ra_um(row));
        self.shaken_ra_um.extend(shaken_ra_um(row));
        self.force_n.push(row.force_n);
        self.feed_mm_min.push(row.feed_mm_min);
        self.spindle_rpm.push(row.spindle_rpm);
        self.deviation.extend(deviation(row, held));
        self.shaken_deviation.extend(shaken_deviation(row));
    }
}

/// Means over a stretch of rows in contact.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct StretchMeans {
    /// Produced Ra, um; none where it has no value on more than half of the stretch.
    pub ra_um: Option<f64>,
    /// Ra with dynamics, um; none as before.
    pub ra_dyn_um: Option<f64>,
    /// Force, N.
    pub force_n: f64,
    /// Feed, mm/min.
    pub feed_mm_min: f64,
    /// Standard deviation of the feed within the stretch, mm/min: what noise moves it by.
    pub feed_scatter_mm_min: f64,
    /// Spindle speed, 1/min.
    pub spindle_rpm: f64,
    /// Deviation of what is to be held from its reference, percent.
    pub deviation_percent: Option<f64>,
    /// Whether that lies within the tolerance.
    pub in_tolerance: Option<bool>,
    /// Deviation of Ra with dynamics from the target Ra, percent.
    pub deviation_dyn_percent: Option<f64>,
    /// Whether that lies within the tolerance.
    pub in_tolerance_dyn: Option<bool>,
}

impl StretchMeans {
    /// Those of rows with what is held and the tolerance in percent; none without contact.
    #[must_use]
    pub fn of(rows: &[Row], held: Reference, tolerance_percent: f64) -> Option<Self> {
        let step = rows.len() / MOST_ROWS + 1;
        // Once over the rows, which are wide: this is told anew while the cut plays.
        let mut all = Values::default();
        let taken = rows.iter().step_by(step).filter(|row| !row.has(flag::AIR));
        taken.for_each(|row| all.add(row, held));
        let known = |values: &Vec<f64>| {
            if 2 * values.len() > all.force_n.len() {
                stats::mean(values.iter().copied())
            } else {
                None
            }
        };
        let mean = |values: &Vec<f64>| stats::mean(values.iter().copied());
        let deviation_percent = known(&all.deviation).map(percent_from_ratio);
        let deviation_dyn_percent = known(&all.shaken_deviation).map(percent_from_ratio);
        let inside = |percent: f64| percent.abs() <= tolerance_percent;
        Some(Self {
            ra_um: known(&all.ra_um),
            ra_dyn_um: known(&all.shaken_ra_um),
            force_n: mean(&all.force_n)?,
            feed_mm_min: mean(&all.feed_mm_min)?,
            feed_scatter_mm_min: stats::deviation(&all.feed_mm_min)?,
            spindle_rpm: mean(&all.spindle_rpm)?,
            deviation_percent,
            in_tolerance: deviation_percent.map(inside),
            deviation_dyn_percent,
            in_tolerance_dyn: deviation_dyn_percent.map(inside),
        })
    }
}
