//! Where the cut is among its disturbances: what acts between two of their borders, kept from one border to the
//! next, so that a plant step without one compares a single number.

use crate::blocks::cutting::breakage::Strength;
use crate::blocks::cutting::process::Process;
use crate::models::disturbances::Disturbances;

/// The disturbances of a run, and what of them acts on the force now.
#[derive(Clone, Debug)]
pub struct Disturbed {
    /// None where there are none.
    all: Option<Box<Disturbances>>,
    /// Where along the way something changes next, mm.
    next_mm: f64,
    hardness_factor: f64,
    force_factor: f64,
    chatter_share: f64,
}

impl Disturbed {
    /// Before the first look.
    #[must_use]
    pub fn new(disturbances: &Disturbances) -> Self {
        Self {
            all: (!disturbances.is_empty()).then(|| Box::new(disturbances.clone())),
            next_mm: f64::NEG_INFINITY,
            hardness_factor: 1.0,
            force_factor: 1.0,
            chatter_share: 0.0,
        }
    }

    /// All disturbances; none where there are none.
    #[must_use]
    pub fn all(&self) -> Option<&Disturbances> {
        self.all.as_deref()
    }

    /// The tool is elsewhere, or another process cuts: at the next step all is looked at again.
    pub fn look_again(&mut self) {
        self.next_mm = f64::NEG_INFINITY;
    }

    /// Whether something changes at a place along the way in mm.
    #[must_use]
    #[inline]
    pub fn is_due(&self, position_mm: f64) -> bool {
        position_mm >= self.next_mm
    }

    /// Finds what acts at a place along the way in mm, up to the next border; breaks the teeth of the process.
    #[cold]
    pub fn meet(&mut self, position_mm: f64, process: &mut Process, strength: &mut Strength) {
        // Those that broke by load are broken whatever else disturbs.
        let Some(all) = &self.all else {
            self.next_mm = f64::INFINITY;
            strength.give(0);
            return self.break_teeth(strength, process);
        };
        strength.give(all.broken_teeth(position_mm));
        self.hardness_factor = all.hardness_factor(position_mm);
        self.chatter_share = all.chatter_share(position_mm);
        self.next_mm = all.next_border_mm(position_mm);
        self.break_teeth(strength, process);
    }

    /// Breaks the teeth of the process that are broken, and takes in how the force grows by it.
    pub fn break_teeth(&mut self, strength: &Strength, process: &mut Process) {
        self.force_factor = self.hardness_factor * process.break_teeth(strength.broken());
    }

    /// Factor on the force.
    #[must_use]
    #[inline]
    pub fn force_factor(&self) -> f64 {
        self.force_factor
    }

    /// What the chatter adds to the factor of the dynamic component at a time in s.
    #[must_use]
    #[inline]
    pub fn chatter(&self, time_s: f64) -> f64 {
        match &self.all {
            Some(all) if self.chatter_share > 0.0 => {
                self.chatter_share * all.chatter_course(time_s)
            }
            Some(_) | None => 0.0,
        }
    }
}
