//! What the metrics of a run are made of, summed up plant step by plant step, so that they do not depend
//! on which steps are recorded.

use super::SETTLED;
use crate::base::units::ratio_from_percent;
use crate::blocks::reference::Reference;
use crate::models::feed_speed::STANDSTILL_MM_MIN;
use crate::run::scenario::Scenario;
use crate::run::signals::{Row, flag};

/// Relative error of the force.
pub(super) fn relative_error(row: &Row) -> f64 {
    // The reference is at least FORCE_REF_MIN_N, never zero.
    (row.force_n - row.force_ref_n) / row.force_ref_n
}

/// What a run is judged by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Judged {
    /// Half-width of the tolerance band, a fraction of its middle.
    tolerance: f64,
    /// What the tolerance is of.
    reference: Reference,
    /// Whether Ra is to be held and the machine vibrates in the cut, so that there is an Ra with that, too.
    shakes: bool,
    /// Plant steps in a control period.
    control_every: u64,
}

impl Judged {
    /// By the target of a scenario, with so many plant steps to a control period.
    #[must_use]
    pub fn by(scenario: &Scenario, control_every: u64) -> Self {
        let target = &scenario.target;
        let tolerance = ratio_from_percent(target.tolerance_percent);
        let shakes = scenario.machine.coupled && target.reference == Reference::Ra;
        Self { tolerance, reference: target.reference, shakes, control_every }
    }

    /// Whether Ra with dynamics is judged as well: Ra is to be held, and the machine vibrates in the cut.
    #[must_use]
    pub fn shakes(&self) -> bool {
        self.shakes
    }

    /// Whether there is a value to judge.
    #[must_use]
    pub fn knows(&self, row: &Row) -> bool {
        match self.reference {
            Reference::Ra => !row.ra_has_ended(),
            Reference::Force => true,
        }
    }

    /// Whether that lies beyond the upper end of the tolerance: rougher than allowed, or the force above it. Where
    /// the roughness model has ended at zero the surface is smoother than it can tell.
    #[must_use]
    pub fn above(&self, row: &Row) -> bool {
        match self.reference {
            Reference::Ra => row.ra_um - row.ra_target_um > self.tolerance * row.ra_target_um,
            Reference::Force => relative_error(row) > self.tolerance,
        }
    }

    /// Whether vibration takes Ra beyond the upper end of its tolerance; where a force is held it is judged without.
    #[must_use]
    pub fn shaken_above(&self, row: &Row) -> bool {
        match self.reference {
            Reference::Ra => row.ra_dyn_um - row.ra_target_um > self.tolerance * row.ra_target_um,
            Reference::Force => false,
        }
    }

    /// Whether Ra with dynamics lies within the tolerance of its target.
    pub(in crate::run) fn shaken_in_tolerance(&self, row: &Row) -> bool {
        (row.ra_dyn_um - row.ra_target_um).abs() <= self.tolerance * row.ra_target_um
    }

    /// Whether the tool cuts and what is judged, with dynamics where that is, is known and lies outside the tolerance.
    pub(in crate::run) fn strays(&self, row: &Row) -> bool {
        let inside =
            if self.shakes { self.shaken_in_tolerance(row) } else { self.in_tolerance(row) };
        !row.has(flag::AIR) && self.knows(row) && !inside
    }

    /// Whether that lies within the tolerance.
    pub(in crate::run) fn in_tolerance(&self, row: &Row) -> bool {
        match self.reference {
            Reference::Ra => {
                (row.ra_um - row.ra_target_um).abs() <= self.tolerance * row.ra_target_um
            }
            Reference::Force => relative_error(row).abs() <= self.tolerance,
        }
    }
}

/// Sums over the plant steps of a control period that are in contact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Period {
    /// Steps of the period so far.
    steps: u64,
    /// Steps in contact, a whole number in a whole period.
    pub(super) contact: f64,
    /// Those among them whose roughness does not lie beyond the end of its model.
    known_ra: f64,
    /// Sums of Ra and its target, um; force and its reference, N; feed, mm/min; speed, 1/min.
    pub(super) sums: [f64; 6],
}

impl Period {
    /// Those of the rows of a period, each a plant step.
    pub(in crate::run) fn of(rows: &[Row]) -> Self {
        let mut period = Self::default();
        rows.iter().for_each(|row| period.add(row));
        period
    }

    fn add(&mut self, row: &Row) {
        self.steps += 1;
        if !row.has(flag::AIR) {
            self.contact += 1.0;
            self.known_ra += f64::from(!row.ra_has_ended());
            let values = [
                row.ra_um,
                row.ra_target_um,
                row.force_n,
                row.force_ref_n,
                row.feed_mm_min,
                row.spindle_rpm,
            ];
            self.sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += value);
        }
    }

    /// With those of an earlier period, or as much of them as makes `most` steps in contact.
    pub(super) fn with(mut self, other: &Self, most: f64) -> Self {
        let missing = most - self.contact;
        let share = if other.contact > missing { missing / other.contact } else { 1.0 };
        self.contact += share * other.contact;
        self.known_ra += share * other.known_ra;
        self.sums.iter_mut().zip(other.sums).for_each(|(sum, value)| *sum += share * value);
        self
    }

    /// Mean of Ra where it is known, um; beyond the end of its model the sum is 0.
    pub(super) fn mean_ra_um(&self) -> Option<f64> {
        let [ra_um, ..] = self.sums;
        (self.known_ra > 0.0).then(|| ra_um / self.known_ra)
    }

    /// The means of the sums, where there was contact.
    pub(super) fn means(&self) -> Option<[f64; 6]> {
        (self.contact > 0.0).then(|| self.sums.map(|sum| sum / self.contact))
    }
}

/// The sums and extremes over all plant steps so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Tally {
    judged: Judged,
    /// Plant steps so far.
    pub(super) steps: u64,
    position_mm: f64,
    axial_depth_mm: f64,
    force_ref_n: f64,
    time_s: f64,
    /// Path in contact, and the part of it in tolerance, mm.
    pub(super) in_contact_mm: f64,
    pub(super) good_mm: f64,
    /// Path in contact beyond the upper end of the tolerance, mm.
    pub(super) above_mm: f64,
    /// The same two of Ra with dynamics, where that is judged, mm.
    pub(super) shaken_good_mm: f64,
    pub(super) shaken_above_mm: f64,
    /// Path in contact on which there is nothing to judge: Ra is held and lies outside the model, mm.
    pub(super) unknown_mm: f64,
    pub(super) removed_mm3: f64,
    pub(super) max_force_n: f64,
    /// Largest relative error in contact after the first second, signed.
    pub(super) worst: Option<f64>,
    /// Steps with a command at a limit, and with a model outside its range.
    pub(super) saturated: u64,
    pub(super) outside: u64,
    /// Steps in contact.
    pub(super) contact: u64,
    /// Steps that the tool has stood still by now.
    pub(super) standing: u64,
    /// Time of the last change, s; whether the force was out since then; since when it is settled, s.
    changed_s: f64,
    was_out: bool,
    settled_s: Option<f64>,
    /// On which side of its reference the force stood after the last change.
    side: f64,
    overshoot: f64,
    /// The present control period.
    pub(super) period: Period,
}

impl Tally {
    /// With the row before the first step.
    #[must_use]
    pub fn new(judged: Judged, row: &Row) -> Self {
        let mut tally = Self {
            judged,
            steps: 0,
            position_mm: row.position_mm,
            axial_depth_mm: row.axial_depth_mm,
            force_ref_n: row.force_ref_n,
            time_s: row.time_s,
            in_contact_mm: 0.0,
            good_mm: 0.0,
            above_mm: 0.0,
            shaken_good_mm: 0.0,
            shaken_above_mm: 0.0,
            unknown_mm: 0.0,
            removed_mm3: 0.0,
            max_force_n: row.force_n,
            worst: None,
            saturated: 0,
            outside: 0,
            contact: 0,
            standing: 0,
            changed_s: 0.0,
            was_out: false,
            settled_s: None,
            side: 0.0,
            overshoot: 0.0,
            period: Period::of(&[*row]),
        };
        tally.change(row);
        tally.follow(row);
        // The row before the first step is a period of its own.
        tally.period.steps = judged.control_every;
        tally
    }

    /// The next plant step, which begins with an edit that moves the loop or does not.
    #[inline]
    pub fn add(&mut self, row: &Row, edited: bool) {
        let step_mm = row.position_mm - self.position_mm;
        self.steps += 1;
        let contact = !row.has(flag::AIR);
        if contact {
            self.in_contact_mm += step_mm;
            if self.judged.in_tolerance(row) {
                self.good_mm += step_mm;
            } else if self.judged.above(row) {
                self.above_mm += step_mm;
            } else if !self.judged.knows(row) {
                self.unknown_mm += step_mm;
            }
            if self.judged.shakes && self.judged.knows(row) {
                if self.judged.shaken_in_tolerance(row) {
                    self.shaken_good_mm += step_mm;
                } else if self.judged.shaken_above(row) {
                    self.shaken_above_mm += step_mm;
                }
            }
            let error = relative_error(row);
            let larger = self.worst.is_none_or(|worst| error.abs() > worst.abs());
            if row.time_s >= 1.0 && larger {
                self.worst = Some(error);
            }
        }
        self.removed_mm3 += row.axial_depth_mm * row.radial_depth_mm * step_mm;
        self.max_force_n = self.max_force_n.max(row.force_n);
        self.saturated += u64::from(row.has(flag::SATURATED));
        self.outside += u64::from(row.has(flag::OUTSIDE));
        self.standing = if row.feed_mm_min < STANDSTILL_MM_MIN { self.standing + 1 } else { 0 };
        if edited
            || row.force_ref_n != self.force_ref_n
            || row.axial_depth_mm != self.axial_depth_mm
        {
            self.change(row);
        }
        self.follow(row);
        if self.period.steps >= self.judged.control_every {
            self.period = Period::default();
        }
        self.period.add(row);
    }

    /// The loop begins to move anew: the change came with the row before this one.
    fn change(&mut self, row: &Row) {
        (self.changed_s, self.was_out) = (self.time_s, false);
        self.side = relative_error(row).signum();
    }

    /// Takes a row into account that the next one is compared with.
    fn follow(&mut self, row: &Row) {
        let error = relative_error(row);
        if error.abs() > SETTLED {
            (self.was_out, self.settled_s) = (true, None);
        } else if self.settled_s.is_none() {
            self.settled_s = Some(row.time_s);
        }
        if !row.has(flag::AIR) {
            self.contact += 1;
            self.overshoot = self.overshoot.max(-self.side * error);
        }
        self.position_mm = row.position_mm;
        self.axial_depth_mm = row.axial_depth_mm;
        self.force_ref_n = row.force_ref_n;
        self.time_s = row.time_s;
    }

    /// What it is judged by.
    pub(super) fn judged(&self) -> &Judged {
        &self.judged
    }

    /// The present control period, whole at its control sample.
    #[must_use]
    pub fn period(&self) -> &Period {
        &self.period
    }

    /// Number of whole control periods before the present one, that of the row before the first step
    /// among them.
    pub(super) fn periods_before(&self) -> u64 {
        self.steps.div_ceil(self.judged.control_every)
    }

    /// Time from the last change until the force stays near its reference, s; none if it does not, or without
    /// contact.
    pub(super) fn settling_s(&self) -> Option<f64> {
        if self.contact == 0 {
            return None;
        }
        if !self.was_out {
            return Some(0.0);
        }
        self.settled_s.map(|settled_s| settled_s - self.changed_s)
    }

    /// Overshoot as a fraction of the reference; none without contact.
    pub(super) fn overshoot(&self) -> Option<f64> {
        (self.contact > 0).then_some(self.overshoot)
    }
}
