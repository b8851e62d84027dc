//! The cut as the neural force model sees it, times what the network does not know.
//!
//! The networks know Ck45 and 16MnCrSi5 over a range of hardness. Any other material is taken as
//! Ck45 at its reference hardness times the ratio of the two materials' forces
//! ([`Material::force_factor`], chosen); a hardness beyond the trained range scales the force at its
//! end in the same way. They learned from ball ends with two teeth of one helix; another tool is taken by
//! its feed per tooth, and is outside their training data.

use super::material::Material;
use crate::base::math;
use crate::models::Valued;
use crate::models::neural_force::{
    CutPoint, HARDNESS_HB, NeuralForce, NeuralForceAt, NeuralKind, TEETH,
};
use crate::models::tool::Tool;

/// A tool in a material: the network's inputs, with feed and speed left at zero, and the
/// factor on its force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NeuralCut {
    /// The network's inputs.
    pub point: CutPoint,
    /// Factor on the network's force for what it does not know.
    pub factor: f64,
    /// Factor on the feed: the network counts it by the teeth of its training data.
    pub feed_factor: f64,
    /// Whether the network knows this material at this hardness.
    pub material_known: bool,
    /// Whether it knows teeth like the tool's.
    pub teeth_known: bool,
}

impl NeuralCut {
    /// The cut of a tool in a material of a hardness in HB at axial and radial depth in mm.
    #[must_use]
    pub fn new(
        tool: &Tool,
        material: Material,
        hardness_hb: f64,
        [axial_depth_mm, radial_depth_mm]: [f64; 2],
    ) -> Self {
        let code = match material {
            Material::Ck45 => Some((1.0, HARDNESS_HB[0])),
            Material::MnCrSi5 => Some((2.0, HARDNESS_HB[1])),
            Material::S235
            | Material::Crmo42
            | Material::X5CrNi
            | Material::NiCrMoV
            | Material::Gjl250
            | Material::Gjs600
            | Material::Al7075
            | Material::Brass
            | Material::Ti64 => None,
        };
        let (base, material_code, base_hb) = match code {
            Some((code, [low, high])) => (material, code, math::limit(hardness_hb, low, high)),
            None => (Material::Ck45, 1.0, Material::Ck45.hardness_hb()),
        };
        Self {
            point: CutPoint {
                feed_mm_min: 0.0,
                speed_rpm: 0.0,
                radial_depth_mm,
                axial_depth_mm,
                material_code,
                hardness_hb: base_hb,
                diameter_mm: tool.diameter_mm,
                geometry_code: tool.geometry_code(),
            },
            factor: material.force_factor(hardness_hb) / base.force_factor(base_hb),
            feed_factor: TEETH / f64::from(tool.teeth),
            material_known: code.is_some() && base_hb == hardness_hb,
            teeth_known: tool.teeth_as_in_the_papers(),
        }
    }
}

impl NeuralCut {
    /// The same in a material whose force is this times that of Ck45 at its reference hardness.
    #[must_use]
    pub fn of_ck45_times(self, factor: Valued) -> Self {
        let hardness_hb = Material::Ck45.hardness_hb();
        let point = CutPoint { material_code: 1.0, hardness_hb, ..self.point };
        Self { point, factor: factor.value, material_known: factor.valid, ..self }
    }

    /// Whether the network knows material and teeth.
    #[must_use]
    #[inline]
    pub fn known(&self) -> bool {
        self.material_known && self.teeth_known
    }
}

/// Most depths that are kept set up.
const KEPT: usize = 16;

/// A network in one material, set up for the depths that it has met.
#[derive(Clone, Debug)]
pub struct NeuralLaw {
    network: &'static NeuralForce,
    cut: NeuralCut,
    /// Axial and radial depth in mm, and the network there; `last` was used last.
    at: Vec<([f64; 2], NeuralForceAt)>,
    last: usize,
}

impl NeuralLaw {
    /// A shipped network for a cut.
    #[must_use]
    pub fn new(kind: NeuralKind, cut: NeuralCut) -> Self {
        let mut law = Self {
            network: NeuralForce::shipped(kind),
            cut,
            at: Vec::with_capacity(KEPT),
            last: 0,
        };
        law.set_up([cut.point.axial_depth_mm, cut.point.radial_depth_mm]);
        law
    }

    /// The cut that it is set up for.
    #[must_use]
    pub fn cut(&self) -> NeuralCut {
        self.cut
    }

    fn set_up(&mut self, depths_mm: [f64; 2]) {
        if let Some(found) = self.at.iter().position(|(depths, _)| *depths == depths_mm) {
            self.last = found;
            return;
        }
        if self.at.len() == KEPT {
            self.at.clear();
        }
        [self.cut.point.axial_depth_mm, self.cut.point.radial_depth_mm] = depths_mm;
        self.last = self.at.len();
        self.at.push((depths_mm, self.network.at(&self.cut.point)));
    }

    /// The peak force in N of a sharp tool at axial and radial depths in mm; invalid where the
    /// network does not know the cut.
    #[inline]
    pub fn update(&mut self, feed_mm_min: f64, speed_rpm: f64, depths_mm: [f64; 2]) -> Valued {
        if depths_mm != self.at[self.last].0 {
            self.set_up(depths_mm);
        }
        let peak = self.at[self.last].1.peak(feed_mm_min * self.cut.feed_factor, speed_rpm);
        Valued::new(peak.value * self.cut.factor, peak.valid && self.cut.known())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::tool::EndShape;

    fn law(material: Material, hardness_hb: f64) -> NeuralLaw {
        of_tool(&Tool::default(), material, hardness_hb)
    }

    fn of_tool(tool: &Tool, material: Material, hardness_hb: f64) -> NeuralLaw {
        let cut = NeuralCut::new(tool, material, hardness_hb, [2.0, 3.0]);
        NeuralLaw::new(NeuralKind::Improved, cut)
    }

    #[test]
    fn another_tool_is_outside_the_training_data_unless_diameter_and_rake_are_within() {
        let papers = Tool::default();
        for (tool, known) in [
            (Tool { diameter_mm: 12.0, ..papers.clone() }, true),
            (Tool { rake_deg: 6.0, ..papers.clone() }, true),
            (Tool { diameter_mm: 9.0, ..papers.clone() }, false),
            (Tool { rake_deg: 5.0, ..papers.clone() }, false),
            (Tool { helix_deg: 30.0, ..papers.clone() }, false),
            (Tool { shape: EndShape::Square, ..papers.clone() }, false),
            (Tool { teeth: 4, ..papers.clone() }, false),
        ] {
            let found = of_tool(&tool, Material::Ck45, 200.0).update(320.0, 1600.0, [2.0, 3.0]);
            assert_eq!(found.valid, known, "{tool:?}");
        }
        let mut four = of_tool(&Tool { teeth: 4, ..papers }, Material::Ck45, 200.0);
        let mut two = law(Material::Ck45, 200.0);
        let [four, two] =
            [four.update(640.0, 1600.0, [2.0, 3.0]), two.update(320.0, 1600.0, [2.0, 3.0])];
        assert_eq!(four.value, two.value, "by the feed per tooth");
    }

    #[test]
    fn the_network_knows_two_materials_within_their_hardness() {
        for (material, hardness_hb, known) in [
            (Material::Ck45, 200.0, true),
            (Material::Ck45, 260.0, false),
            (Material::MnCrSi5, 180.0, true),
            (Material::Ti64, 330.0, false),
        ] {
            let force = law(material, hardness_hb).update(320.0, 1600.0, [2.0, 3.0]);
            assert_eq!(force.valid, known, "{material:?} {hardness_hb}");
            assert!(force.value > 50.0 && force.value < 1000.0, "{material:?}: {force:?}");
        }
    }

    #[test]
    fn force_goes_on_beyond_the_trained_hardness_and_other_materials_scale_it() {
        let at = |material, hb| law(material, hb).update(320.0, 1600.0, [2.0, 3.0]).value;
        let ratio = at(Material::Ck45, 300.0) / at(Material::Ck45, 240.0);
        assert!((ratio - math::pow(300.0 / 240.0, 0.4)).abs() < 1e-12);
        let ratio = at(Material::Al7075, 150.0) / at(Material::Ck45, 200.0);
        assert!((ratio - Material::Al7075.force_factor(150.0)).abs() < 1e-12);
    }

    #[test]
    fn depth_is_followed() {
        let mut law = law(Material::Ck45, 200.0);
        let shallow = law.update(320.0, 1600.0, [1.0, 3.0]).value;
        let deep = law.update(320.0, 1600.0, [3.0, 3.0]).value;
        assert!(deep > 1.5 * shallow && law.update(320.0, 1600.0, [1.0, 3.0]).value == shallow);
        assert_eq!(law.update(320.0, 1600.0, [0.0, 3.0]).value, 0.0, "in the air");
        for i in 0..40 {
            law.update(320.0, 1600.0, [1.0 + 0.1 * f64::from(i), 3.0]);
        }
        assert_eq!(law.update(320.0, 1600.0, [1.0, 3.0]).value, shallow, "more than it keeps");
    }
}
