//! Formulas of a user's own in the place of models 1 to 5: what the calibration `formula` takes, of plant and
//! controller alike. A model without one stays the identified one.

use std::sync::Arc;

use super::force_formula::FEED_MIN_MM_MIN;
use super::{Calibration, GeneticModels, ModelSet};
use crate::base::math;
use crate::models::Valued;
use crate::models::formula_model::{FormulaModel, OwnFormula, role};

role!(
    /// Model 1: force from target roughness.
    ForceOfRa, "formula_force_of_ra", &["um"], "Ra in um", "N",
    r#"{"version":1,"formula":"140 + 55*Ra - 12*Ra^2","output":{"name":"F_d","unit":"N"},"inputs":[{"name":"Ra","unit":"um","low":0.4,"high":1.5}]}"#
);
role!(
    /// Model 2: feed command from force.
    FeedOfForce, "formula_feed", &["N"], "a force in N", "mm/min",
    r#"{"version":1,"formula":"25.4*(40 - 900000/F^2)","output":{"name":"f","unit":"mm/min"},"inputs":[{"name":"F","unit":"N","low":160,"high":200}]}"#
);
role!(
    /// Model 3: speed command from force.
    SpeedOfForce, "formula_speed", &["N"], "a force in N", "1/min",
    r#"{"version":1,"formula":"7641.3*exp(-0.0071*F)","output":{"name":"n","unit":"1/min"},"inputs":[{"name":"F","unit":"N","low":140,"high":200}]}"#
);
role!(
    /// Model 4: force from feed and speed.
    ForceOfCut, "formula_force", &["mm/min", "1/min"], "the feed in mm/min and the speed in 1/min", "N",
    r#"{"version":1,"formula":"390 - 182*(f/256)^-0.25 - 0.57*(n/1024)^3.1","output":{"name":"F","unit":"N"},"inputs":[{"name":"f","unit":"mm/min","low":150,"high":600},{"name":"n","unit":"1/min","low":800,"high":2500}]}"#
);
role!(
    /// Models 5 and 6: roughness from force.
    RaOfForce, "formula_ra", &["N"], "a force in N", "um",
    r#"{"version":1,"formula":"0.0254*(593/(300 - F))^2","output":{"name":"Ra","unit":"um"},"inputs":[{"name":"F","unit":"N","low":100,"high":250}]}"#
);

role!(
    /// Force of a material over that of Ck45 at 200 HB.
    MaterialOfHardness, "formula_material", &["HB"], "the hardness in HB", "",
    r#"{"version":1,"formula":"1.2*(HB/200)^0.6","output":{"name":"k","unit":""},"inputs":[{"name":"HB","unit":"HB","low":100,"high":400}]}"#
);

role!(
    /// Specific cutting force of a chip thickness.
    SpecificForce, "formula_specific_force", &["mm"], "the chip thickness in mm", "N/mm^2",
    r#"{"version":1,"formula":"1700*(h + 0.01)^-0.22","output":{"name":"kc","unit":"N/mm^2"},"inputs":[{"name":"h","unit":"mm","low":0,"high":0.4}]}"#
);
role!(
    /// Specific radial force of a chip thickness.
    SpecificRadialForce, "formula_specific_radial_force", &["mm"], "the chip thickness in mm", "N/mm^2",
    r#"{"version":1,"formula":"350*(h + 0.01)^-0.5","output":{"name":"kr","unit":"N/mm^2"},"inputs":[{"name":"h","unit":"mm","low":0,"high":0.4}]}"#
);

role!(
    /// Specific axial force of a chip thickness.
    SpecificAxialForce, "formula_specific_axial_force", &["mm"], "the chip thickness in mm", "N/mm^2",
    r#"{"version":1,"formula":"180*(h + 0.01)^-0.2","output":{"name":"ka","unit":"N/mm^2"},"inputs":[{"name":"h","unit":"mm","low":0,"high":0.4}]}"#
);

crate::settings! {
    /// Formulas of one's own, which the calibration `formula` puts in the place of identified models, of plant
    /// and controller alike; each is the text of a model file (`steadycut formula --save`). Beyond its ranges
    /// a formula goes straight on, and is marked. Those of material and specific forces need no calibration.
    pub struct FormulaSettings {
        /// Model 1, K1 or M1: the force in N for a target Ra in um.
        force_of_ra: OwnFormula<ForceOfRa> = OwnFormula::default(), [], "", live, "Force for a target Ra";
        /// Model 2, K2 or M2: the feed command in mm/min for a force in N.
        feed: OwnFormula<FeedOfForce> = OwnFormula::default(), [], "", live, "Feed for a force";
        /// Model 3, K3 or M3: the speed command in 1/min for a force in N.
        speed: OwnFormula<SpeedOfForce> = OwnFormula::default(), [], "", live, "Speed for a force";
        /// Model 4, K4 or M4: the force in N of a feed in mm/min and a speed in 1/min, at the set's own
        /// engagement, with a sharp tool, in Ck45.
        force: OwnFormula<ForceOfCut> = OwnFormula::default(), [], "", live, "Force of the cut";
        /// Models 5 and 6, K5 or M5: the Ra in um that a force in N leaves.
        ra: OwnFormula<RaOfForce> = OwnFormula::default(), [], "", live, "Ra of a force";
        /// The material that is cut, in place of `plant.material`: its force over that of Ck45 at 200 HB, of the
        /// hardness in HB.
        material: OwnFormula<MaterialOfHardness> = OwnFormula::default(), [], "", live, "Material over hardness";
        /// Specific cutting force k_c in N/mm^2 of the chip thickness in mm, tooth by tooth, in place of Kienzle's
        /// k_c1.1 h^-m_c: of the steel, before the corrections for rake, speed and hardness.
        specific_force: OwnFormula<SpecificForce> = OwnFormula::default(), [], "", live, "Specific cutting force";
        /// Specific radial force k_r in N/mm^2 of the chip thickness in mm, tooth by tooth, as the specific cutting
        /// force: in place of Kienzle's k_r1.1 h^-m_r, before the same corrections.
        specific_radial_force: OwnFormula<SpecificRadialForce> = OwnFormula::default(), [], "", live, "Specific radial force";
        /// Specific axial force k_a in N/mm^2 of the chip thickness in mm, tooth by tooth, as the specific cutting
        /// force: in place of Kienzle's k_a1.1 h^-m_a, before the same corrections.
        specific_axial_force: OwnFormula<SpecificAxialForce> = OwnFormula::default(), [], "", live, "Specific axial force";
    }
}

impl FormulaSettings {
    /// Roles of the formulas of models 1 to 5: what the calibration `formula` takes.
    pub const OF_MODELS: [&'static str; 5] = ["force_of_ra", "feed", "speed", "force", "ra"];
    /// Those of them that the plant has, too; the controller has all.
    pub const OF_PLANT: [&'static str; 2] = ["force", "ra"];

    /// Whether the setting at a path is the formula of one of models 1 to 5.
    #[must_use]
    pub fn is_model(path: &str) -> bool {
        path.strip_prefix("formula.").is_some_and(|role| Self::OF_MODELS.contains(&role))
    }

    /// Whether no model 1 to 5 is a formula of one's own.
    #[must_use]
    pub fn has_no_model(&self) -> bool {
        *self
            == Self {
                material: self.material.clone(),
                specific_force: self.specific_force.clone(),
                specific_radial_force: self.specific_radial_force.clone(),
                specific_axial_force: self.specific_axial_force.clone(),
                ..Self::default()
            }
    }

    /// The specific forces that are formulas: cutting, radial, axial.
    #[must_use]
    pub fn specific_forces(&self) -> [Option<&Arc<FormulaModel>>; 3] {
        [
            self.specific_force.get(),
            self.specific_radial_force.get(),
            self.specific_axial_force.get(),
        ]
    }

    /// The force of the material over that of Ck45 at 200 HB by its formula, where there is one; never negative.
    #[must_use]
    pub fn material_factor(&self, hardness_hb: f64) -> Option<Valued> {
        let found = self.material.get()?.at(&[hardness_hb]);
        Some(Valued::new(math::positive(found.value), found.valid && found.value >= 0.0))
    }
}

/// Own formulas in the place of models of a set; none where the set's own model stands.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OwnModels {
    /// Model 1.
    pub force_of_ra: Option<Arc<FormulaModel>>,
    /// Model 2.
    pub feed: Option<Arc<FormulaModel>>,
    /// Model 3.
    pub speed: Option<Arc<FormulaModel>>,
    /// Model 4.
    pub force: Option<Arc<FormulaModel>>,
    /// Models 5 and 6.
    pub ra: Option<Arc<FormulaModel>>,
    /// Added to model 4, N.
    pub force_offset_n: f64,
}

impl GeneticModels {
    /// The models of a set in a calibration, where that is `formula` with these in the place of the set's.
    #[must_use]
    pub fn with_formulas(
        set: ModelSet,
        calibration: Calibration,
        formulas: &FormulaSettings,
    ) -> Self {
        let mut models = Self::new(set, calibration);
        if calibration == Calibration::Formula && set != ModelSet::Milling2005 {
            models.own = OwnModels {
                force_of_ra: formulas.force_of_ra.get().cloned(),
                feed: formulas.feed.get().cloned(),
                speed: formulas.speed.get().cloned(),
                force: formulas.force.get().cloned(),
                ra: formulas.ra.get().cloned(),
                force_offset_n: 0.0,
            };
        }
        models
    }

    /// The feed in mm/min at which model 4 gives `force_n` at `speed_rpm`, up to `feed_max_mm_min`;
    /// `near_mm_min` is a guess that only saves time. Invalid where the force is out of reach.
    #[must_use]
    pub fn feed_for_force(
        &self,
        force_n: f64,
        speed_rpm: f64,
        feed_max_mm_min: f64,
        near_mm_min: f64,
    ) -> Valued {
        match &self.own.force {
            None => self.force.feed_for_force(force_n, speed_rpm, feed_max_mm_min, near_mm_min),
            Some(own) => {
                let wanted_n = force_n - self.own.force_offset_n;
                inverse(own, wanted_n, speed_rpm, feed_max_mm_min, near_mm_min)
            }
        }
    }
}

/// Newton's method inside a bracket of feeds; bisects when it leaves it. Where the formula does not rise over
/// the whole bracket, any feed that gives the force.
fn inverse(own: &FormulaModel, force_n: f64, speed_rpm: f64, feed_max: f64, near: f64) -> Valued {
    let error_at = |feed: f64| own.at(&[feed, speed_rpm]).value - force_n;
    let (mut low, mut high) = (FEED_MIN_MM_MIN, feed_max.max(FEED_MIN_MM_MIN));
    if error_at(low) >= 0.0 {
        return Valued::new(low, false);
    }
    if error_at(high) <= 0.0 {
        return Valued::new(high, false);
    }
    let mut feed = if near > low && near < high { near } else { math::power(low * high, 0.5) };
    for _ in 0..60 {
        let error = error_at(feed);
        if error > 0.0 {
            high = feed;
        } else {
            low = feed;
        }
        let newton = feed - error / own.slope(0, &[feed, speed_rpm]);
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if (next - feed).abs() <= 1e-10 * feed {
            feed = next;
            break;
        }
        feed = next;
    }
    Valued::new(feed, own.at(&[feed, speed_rpm]).valid)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::settings::{Structure, Value};
    use crate::models::formula_model::FormulaRole;

    fn example<R: FormulaRole>() -> OwnFormula<R> {
        OwnFormula::read(&Value::Text(R::EXAMPLE.to_owned()), [0.0; 2]).expect("the example")
    }

    fn all() -> FormulaSettings {
        FormulaSettings {
            force_of_ra: example(),
            feed: example(),
            speed: example(),
            force: example(),
            ra: example(),
            ..FormulaSettings::default()
        }
    }

    #[test]
    fn formulas_stand_in_the_place_of_the_models_and_only_in_their_calibration() {
        for set in [ModelSet::Sdnrp2007, ModelSet::Strategy2013] {
            let own = GeneticModels::with_formulas(set, Calibration::Formula, &all());
            assert_eq!(own.force_from_ra(1.0), Valued::new(183.0, true));
            assert_eq!(own.force_from_ra(1.6).value, 140.0 + 55.0 * 1.5 - 27.0 + 0.1 * 19.0);
            assert!(!own.force_from_ra(1.6).valid);
            assert_eq!(own.feed_from_force(180.0).value, 25.4 * (40.0 - 900_000.0 / 32_400.0));
            assert_eq!(own.speed_from_force(150.0).value, 7641.3 * math::exp(-0.0071 * 150.0));
            assert_eq!(
                own.ra_from_force(200.0).value,
                0.0254 * (593.0_f64 / 100.0) * (593.0 / 100.0)
            );
            let plain = GeneticModels::new(set, Calibration::Identified);
            for calibration in Calibration::ALL {
                let models = GeneticModels::with_formulas(set, *calibration, &all());
                if *calibration != Calibration::Formula {
                    assert_eq!(models, GeneticModels::new(set, *calibration));
                }
                let none =
                    GeneticModels::with_formulas(set, *calibration, &FormulaSettings::default());
                assert_eq!(none, GeneticModels::new(set, *calibration));
            }
            let bare = GeneticModels::new(set, Calibration::Formula);
            assert_eq!(bare.force(300.0, 1500.0), plain.force(300.0, 1500.0));
        }
    }

    #[test]
    fn the_feed_for_a_force_inverts_a_formula() {
        let own = GeneticModels::with_formulas(ModelSet::Sdnrp2007, Calibration::Formula, &all());
        for feed in [80.0, 151.0, 324.6, 590.0, 900.0] {
            for speed in [700.0, 1500.0, 2400.0] {
                let force = own.force(feed, speed);
                for near in [0.0, 100.0, 2900.0, f64::NAN] {
                    let found = own.feed_for_force(force.value, speed, 3000.0, near);
                    assert!((found.value - feed).abs() < 1e-5 * feed, "{feed} {speed}: {found:?}");
                    assert_eq!(found.valid, force.valid);
                }
            }
        }
        assert!(!own.feed_for_force(-500.0, 1500.0, 3000.0, 300.0).valid);
        assert!(!own.feed_for_force(5000.0, 1500.0, 3000.0, 300.0).valid);
    }

    #[test]
    fn a_formula_of_other_units_is_refused_and_one_in_another_order_turned() {
        let text = ForceOfCut::EXAMPLE;
        let fault = |text: String| OwnFormula::<ForceOfCut>::fault(&Value::Text(text)).unwrap();
        let said = fault(text.replace("mm/min", "m/min"));
        assert!(said.contains("`f` in m/min") && said.contains("the feed in mm/min"), "{said}");
        let said = fault(RaOfForce::EXAMPLE.to_owned());
        assert!(said.contains("it makes um of `F` in N"), "{said}");
        let said = fault(text.replace("n/1024", "m/1024"));
        assert!(said.contains("column") && !said.contains('\n'), "{said}");
        let turned = r#"{"version":1,"formula":"f/n","output":{"name":"F","unit":"N"},"inputs":[{"name":"n","unit":"1/min","low":800,"high":2500},{"name":"f","unit":"mm/min","low":150,"high":600}]}"#;
        let turned = OwnFormula::<ForceOfCut>::read(&Value::Text(turned.to_owned()), [0.0; 2]);
        assert_eq!(turned.unwrap().get().unwrap().at(&[300.0, 1000.0]).value, 0.3);
    }
}
