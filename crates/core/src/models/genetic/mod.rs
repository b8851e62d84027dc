//! The genetic-programming models of both papers behind one interface: a set (2007: K1..K6, 2013:
//! M1..M6) in one of four calibrations; and a third set in the form of the first, identified on the
//! milling simulator of 2005 (`steadycut identify milling`), for the papers' controllers there.
//!
//! The roles are the same in all sets: 1 force from target roughness, 2 feed command and 3 speed
//! command from force, 4 force from feed and speed, 5 = 6 roughness from force. What was printed
//! and what was corrected stands in [`sdnrp_2007`] and [`strategy_2013`]. Identified models
//! are continued with their end slopes, so commands are monotone over every force that a
//! controller can ask for; model 5 is then the exact inverse of model 1, and Ra is floored at 0.

pub mod curve;
pub mod exponential;
pub mod force_formula;
pub mod found;
pub mod model_file;
mod own;
pub mod quartic;
mod ranges;
pub mod sdnrp_2007;
pub mod strategy_2013;

use std::sync::LazyLock;

use self::curve::Curve;
use self::exponential::Exponential;
use self::force_formula::ForceFormula;
pub use self::own::{
    FeedOfForce, ForceOfCut, ForceOfRa, FormulaSettings, MaterialOfHardness, OwnModels, RaOfForce,
    SpecificAxialForce, SpecificForce, SpecificRadialForce, SpeedOfForce,
};
use self::quartic::Quartic;
use super::Valued;
use super::formula_model::FormulaModel;
use super::tool::{ShippedTool, Tool};
use crate::base::math;

crate::choice! {
    /// A published set of models.
    pub enum ModelSet {
        /// K1..K6 of SDNRP 2007.
        Sdnrp2007 = "sdnrp_2007", "SDNRP 2007 (K1..K6)";
        /// M1..M6 of the 2013 control strategy.
        Strategy2013 = "strategy_2013", "Strategy 2013 (M1..M6)";
        /// K2..K4 identified on the milling simulator of 2005; K1 and K5 are those of 2007.
        Milling2005 = "milling_2005", "Milling 2005 (K2..K4)";
    }
}

crate::choice! {
    /// Where the coefficients of a model set come from.
    pub enum Calibration {
        /// The equations exactly as printed in the paper.
        Printed = "printed", "as printed";
        /// The printed form with the fewest coefficients corrected.
        Restored = "restored", "restored";
        /// Re-identified by `steadycut identify` from the paper's own table; for the milling
        /// simulator of 2005, where nothing was printed, the only one.
        Identified = "identified", "identified";
        /// Formulas that `steadycut identify genetic` finds in the paper's own table by genetic programming; of
        /// model 4 only the constants, since the table's feeds and speeds lie on one line.
        Genetic = "genetic", "genetic programming";
        /// Formulas of one's own: give one under `formula` first (typed or opened in the console, there under Own
        /// formulas); a model without one stays the identified one.
        Formula = "formula", "own formulas";
    }
}

impl Calibration {
    /// Those that a published table can be run in: all but own formulas.
    pub const PUBLISHED: [Self; 4] =
        [Self::Printed, Self::Restored, Self::Identified, Self::Genetic];
}

impl ModelSet {
    /// The letter that the paper names its models with.
    #[must_use]
    pub fn letter(self) -> char {
        match self {
            Self::Sdnrp2007 | Self::Milling2005 => 'K',
            Self::Strategy2013 => 'M',
        }
    }

    /// Axial and radial depth of cut in mm at which model 4 holds.
    #[must_use]
    pub fn engagement_mm(self) -> [f64; 2] {
        match self {
            Self::Sdnrp2007 | Self::Strategy2013 => [2.0, 3.0],
            Self::Milling2005 => [MILLING_AXIAL_DEPTH_MM, MILLING_RADIAL_DEPTH_MM],
        }
    }

    /// The shipped file of identified models, written by `steadycut identify`.
    #[must_use]
    pub fn identified_file(self) -> &'static str {
        match self {
            Self::Sdnrp2007 => include_str!("../../../../../assets/models/identified_2007.toml"),
            Self::Strategy2013 => include_str!("../../../../../assets/models/identified_2013.toml"),
            Self::Milling2005 => {
                include_str!("../../../../../assets/models/identified_milling_2005.toml")
            }
        }
    }
}

/// Axial depth of the section that Experiment 2 of 2005 has most of, with the wall 2 mm from the
/// tool's axis, mm.
pub const MILLING_AXIAL_DEPTH_MM: f64 = 2.6;
/// Its radial depth, sqrt(A_D (16 mm - A_D)) - 2 mm, mm.
pub const MILLING_RADIAL_DEPTH_MM: f64 = 3.902_541_825_349_482;
/// Least reference force that a target roughness can ask for, N: keeps relative errors defined
/// where the printed K1 turns negative.
pub const FORCE_REF_MIN_N: f64 = 10.0;
/// Where the restored M2 is used as it is: from the least final force of Table 1 of 2013 to the
/// largest desired force of Table 3 of 2007, N. It turns round near 149 N.
pub const M2_RESTORED_RANGE_N: [f64; 2] = [157.5, 197.0];

/// Models 1 and 5 = 6: force from roughness, and roughness from force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ForceRoughness {
    /// 2007 eq. 4 and eq. 8.
    K1K5,
    /// 2013 eq. 2, and eq. 6 with this leading coefficient in um/N^2.
    M1M5 {
        /// Leading coefficient of M5, um/N^2.
        leading: f64,
    },
    /// F as a monotone quadratic in Ra; model 5 is its exact inverse.
    Curve(Curve),
}

/// Model 2: feed command from force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FeedLaw {
    /// 2007 eq. 5.
    K2,
    /// 2013 eq. 3 as printed.
    M2,
    /// 2013 eq. 3 restored, on [`M2_RESTORED_RANGE_N`], continued with its end slopes.
    M2Restored(Quartic),
    /// A monotone quadratic in the force.
    Curve(Curve),
}

/// Model 3: spindle speed command from force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SpeedLaw {
    /// 2007 eq. 6.
    K3,
    /// The form of 2013 eq. 4, with the range of forces in N that it was fitted on.
    Exponential(Exponential, [f64; 2]),
    /// A monotone quadratic in the force.
    Curve(Curve),
}

/// The shipped cutter that a cutter cuts as.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutsAs {
    shipped: Option<ShippedTool>,
    /// Whether that is the papers': asked for in every step.
    papers: bool,
}

impl CutsAs {
    /// The papers' cutter.
    pub const PAPERS: Self = Self { shipped: Some(ShippedTool::R21616B20), papers: true };

    /// Of a cutter.
    #[must_use]
    pub fn of(tool: &Tool) -> Self {
        let shipped = tool.shipped_alike();
        Self { shipped, papers: shipped == Self::PAPERS.shipped }
    }
}

/// Models 1..6 of one set in one calibration.
#[derive(Clone, Debug, PartialEq)]
pub struct GeneticModels {
    /// The set.
    pub set: ModelSet,
    /// Models 1 and 5 = 6.
    pub roughness: ForceRoughness,
    /// Model 2.
    pub feed: FeedLaw,
    /// Model 3.
    pub speed: SpeedLaw,
    /// Model 4.
    pub force: ForceFormula,
    /// The shipped cutter that the cutter cuts as. The set's own models hold for the papers' one, a formula for
    /// that which it was found on; with another one an answer is marked as outside the range.
    pub cuts_as: CutsAs,
    /// Formulas in the place of the set's models.
    pub own: OwnModels,
}

impl GeneticModels {
    /// The same for a cutter: the forces and roughness that they were fitted to are the papers' cutter's.
    #[must_use]
    pub fn for_tool(self, tool: &Tool) -> Self {
        Self { cuts_as: CutsAs::of(tool), ..self }
    }

    /// Whether a model holds for the cutter: a formula of one's own, or one of the set.
    #[must_use]
    #[inline]
    pub fn of_tool(&self, own: Option<&FormulaModel>) -> bool {
        match own {
            Some(own) => own.holds_for(self.cuts_as.shipped),
            None => self.cuts_as.papers,
        }
    }

    #[inline]
    fn within(&self, found: Valued) -> Valued {
        Valued { valid: found.valid && self.cuts_as.papers, ..found }
    }

    /// The same of a formula of one's own.
    fn of_own(&self, own: &FormulaModel, found: Valued) -> Valued {
        Valued { valid: found.valid && self.of_tool(Some(own)), ..found }
    }

    /// The models of a set in a calibration, for the papers' cutter.
    ///
    /// ```
    /// use steadycut_core::models::genetic::{Calibration, GeneticModels, ModelSet};
    ///
    /// let models = GeneticModels::new(ModelSet::Sdnrp2007, Calibration::Identified);
    /// let force_n = models.force_from_ra(0.81).value;
    /// let feed_mm_min = models.feed_from_force(force_n).value;
    /// let speed_rpm = models.speed_from_force(force_n).value;
    /// assert!(models.force(feed_mm_min, speed_rpm).valid, "a point inside K4's range");
    /// ```
    #[must_use]
    pub fn new(set: ModelSet, calibration: Calibration) -> Self {
        match (set, calibration) {
            (ModelSet::Sdnrp2007, Calibration::Identified | Calibration::Formula) => {
                IDENTIFIED_2007.clone()
            }
            (ModelSet::Strategy2013, Calibration::Identified | Calibration::Formula) => {
                IDENTIFIED_2013.clone()
            }
            (ModelSet::Sdnrp2007, Calibration::Genetic) => GENETIC_2007.clone(),
            (ModelSet::Strategy2013, Calibration::Genetic) => GENETIC_2013.clone(),
            (ModelSet::Milling2005, _) => IDENTIFIED_MILLING_2005.clone(),
            (ModelSet::Sdnrp2007, Calibration::Printed | Calibration::Restored) => Self {
                set,
                roughness: ForceRoughness::K1K5,
                feed: FeedLaw::K2,
                speed: SpeedLaw::K3,
                force: if calibration == Calibration::Printed {
                    sdnrp_2007::K4
                } else {
                    sdnrp_2007::K4_RESTORED
                },
                cuts_as: CutsAs::PAPERS,
                own: OwnModels::default(),
            },
            (ModelSet::Strategy2013, Calibration::Printed) => Self {
                set,
                roughness: ForceRoughness::M1M5 { leading: strategy_2013::M5_LEADING },
                feed: FeedLaw::M2,
                speed: SpeedLaw::Exponential(strategy_2013::M3, strategy_2013::FORCE_RANGE_N),
                force: strategy_2013::M4,
                cuts_as: CutsAs::PAPERS,
                own: OwnModels::default(),
            },
            (ModelSet::Strategy2013, Calibration::Restored) => Self {
                set,
                roughness: ForceRoughness::M1M5 { leading: strategy_2013::M5_LEADING_RESTORED },
                feed: FeedLaw::M2Restored(strategy_2013::M2_RESTORED),
                speed: SpeedLaw::Exponential(
                    strategy_2013::M3_RESTORED,
                    strategy_2013::FORCE_RANGE_N,
                ),
                force: strategy_2013::M4,
                cuts_as: CutsAs::PAPERS,
                own: OwnModels::default(),
            },
        }
    }

    /// Model 1 (2007 eq. 4; 2013 eq. 2): the desired force F_d in N for a target Ra in um (positive). At least
    /// [`FORCE_REF_MIN_N`]; invalid where that floor or a continuation was used.
    #[must_use]
    pub fn force_from_ra(&self, ra_um: f64) -> Valued {
        let least = |force: Valued| {
            let low = Valued::new(FORCE_REF_MIN_N, false);
            if force.value >= FORCE_REF_MIN_N { force } else { low }
        };
        if let Some(own) = &self.own.force_of_ra {
            return self.of_own(own, least(own.at(&[ra_um])));
        }
        self.within(least(match self.roughness {
            ForceRoughness::K1K5 => sdnrp_2007::k1(ra_um),
            ForceRoughness::M1M5 { .. } => strategy_2013::m1(ra_um),
            ForceRoughness::Curve(curve) => curve.at(ra_um),
        }))
    }

    /// Model 5 = 6 (2007 eq. 8; 2013 eq. 6): the produced Ra in um of a cut with the force in N. Never negative.
    #[must_use]
    #[inline]
    pub fn ra_from_force(&self, force_n: f64) -> Valued {
        let positive = |ra: Valued| if ra.value >= 0.0 { ra } else { Valued::new(0.0, false) };
        if let Some(own) = &self.own.ra {
            return self.of_own(own, positive(own.at(&[force_n])));
        }
        self.within(positive(match self.roughness {
            ForceRoughness::K1K5 => sdnrp_2007::k5(force_n),
            ForceRoughness::M1M5 { leading } => strategy_2013::m5(force_n, leading),
            ForceRoughness::Curve(curve) => curve.inverse(force_n),
        }))
    }

    /// Model 2 (2007 eq. 5; 2013 eq. 3): the feed command in mm/min for a force in N. May be negative outside its range, as
    /// printed: the caller limits it.
    #[must_use]
    pub fn feed_from_force(&self, force_n: f64) -> Valued {
        if let Some(own) = &self.own.feed {
            return self.of_own(own, own.at(&[force_n]));
        }
        self.within(match self.feed {
            FeedLaw::K2 => sdnrp_2007::k2(force_n),
            FeedLaw::M2 => {
                let feed = strategy_2013::M2.at(force_n);
                let rising = strategy_2013::M2.slope(force_n) > 0.0;
                Valued::new(feed, feed > 0.0 && rising)
            }
            FeedLaw::M2Restored(quartic) => quartic.continued(force_n, M2_RESTORED_RANGE_N),
            FeedLaw::Curve(curve) => curve.at(force_n),
        })
    }

    /// Model 3 (2007 eq. 6; 2013 eq. 4): the spindle speed command in 1/min for a force in N; 0 where the radicand of the
    /// printed K3 is negative.
    #[must_use]
    pub fn speed_from_force(&self, force_n: f64) -> Valued {
        if let Some(own) = &self.own.speed {
            return self.of_own(own, own.at(&[force_n]));
        }
        self.within(match self.speed {
            SpeedLaw::K3 => sdnrp_2007::k3(force_n),
            SpeedLaw::Exponential(law, [low, high]) => {
                Valued::new(law.at(force_n), math::limit(force_n, low, high) == force_n)
            }
            SpeedLaw::Curve(curve) => curve.at(force_n),
        })
    }

    /// Model 4 (2007 eq. 7; 2013 eq. 5): see [`ForceFormula::at`].
    #[must_use]
    #[inline]
    pub fn force(&self, feed_mm_min: f64, speed_rpm: f64) -> Valued {
        let Some(own) = &self.own.force else {
            return self.within(self.force.at(feed_mm_min, speed_rpm));
        };
        let found = own.at(&[feed_mm_min, speed_rpm]);
        let force = found.value + self.own.force_offset_n;
        self.of_own(own, Valued::new(math::positive(force), found.valid && force >= 0.0))
    }
}

fn shipped(set: ModelSet) -> GeneticModels {
    model_file::parse(set, set.identified_file())
        .expect("the shipped model files are checked by a test")
}

static IDENTIFIED_2007: LazyLock<GeneticModels> = LazyLock::new(|| shipped(ModelSet::Sdnrp2007));
static IDENTIFIED_2013: LazyLock<GeneticModels> = LazyLock::new(|| shipped(ModelSet::Strategy2013));
static IDENTIFIED_MILLING_2005: LazyLock<GeneticModels> =
    LazyLock::new(|| shipped(ModelSet::Milling2005));

fn found(set: ModelSet) -> GeneticModels {
    let text = set.found_file().expect("only sets with a table are asked for");
    let own = found::parse(text).expect("the shipped model files are checked by a test");
    GeneticModels { own, ..shipped(set) }
}

static GENETIC_2007: LazyLock<GeneticModels> = LazyLock::new(|| found(ModelSet::Sdnrp2007));
static GENETIC_2013: LazyLock<GeneticModels> = LazyLock::new(|| found(ModelSet::Strategy2013));

#[cfg(test)]
mod tests {
    use super::*;

    fn all() -> impl Iterator<Item = (ModelSet, Calibration)> {
        let sets = ModelSet::ALL.iter();
        sets.flat_map(|set| Calibration::ALL.iter().map(|calibration| (*set, *calibration)))
    }

    #[test]
    fn no_force_makes_a_non_finite_or_negative_roughness_or_a_non_finite_command() {
        for (set, calibration) in all() {
            let models = GeneticModels::new(set, calibration);
            assert_eq!(models.set, set);
            for force in [-1e6, 0.0, 100.0, 142.0, 170.0, 262.9, 263.1, 293.0, 400.0, 1e9] {
                let ra = models.ra_from_force(force).value;
                assert!(ra.is_finite() && ra >= 0.0, "{set:?} {calibration:?} at {force} N: {ra}");
                assert!(models.feed_from_force(force).value.is_finite());
                assert!(models.speed_from_force(force).value.is_finite());
            }
        }
    }

    #[test]
    fn the_commands_of_usable_calibrations_are_monotone_over_every_force() {
        for (set, calibration) in all() {
            let models = GeneticModels::new(set, calibration);
            if matches!(models.feed, FeedLaw::K2 | FeedLaw::M2) {
                continue;
            }
            for force in 0..1000 {
                let step = |of: fn(&GeneticModels, f64) -> Valued| {
                    let force = f64::from(force);
                    of(&models, force + 1.0).value - of(&models, force).value
                };
                assert!(
                    step(GeneticModels::feed_from_force) > 0.0,
                    "{set:?} {calibration:?} {force} N"
                );
                let speed = step(GeneticModels::speed_from_force);
                let held = set == ModelSet::Milling2005;
                assert!(if held { speed == 0.0 } else { speed < 0.0 }, "{set:?} {force} N");
            }
        }
    }

    #[test]
    fn the_identified_model_5_is_the_exact_inverse_of_model_1() {
        for set in ModelSet::ALL {
            let models = GeneticModels::new(*set, Calibration::Identified);
            for i in 5..300 {
                let ra_um = f64::from(i) * 0.01;
                let force = models.force_from_ra(ra_um).value;
                assert!((models.ra_from_force(force).value - ra_um).abs() < 1e-12);
            }
        }
    }
}
