//! The mechanistic model of the end mill, tooth by tooth: the milling simulator of 2005
//! ([`crate::blocks::cutting::milling`]), and the largest force of every control period.

use super::law::{ForceModelLaw, ForceMoment, ForceSetup};
use crate::base::equation::{Live, number};
use crate::base::language::{text, tr};
use crate::base::math;
use crate::base::units::mm_from_um;
use crate::base::window::WindowMax;
use crate::blocks::cutting::milling::{Milling, MillingSetup};
use crate::blocks::cutting::process::{CutStep, Force, PlantSettings};
use crate::models::Valued;
use crate::models::genetic::{FormulaSettings, ModelSet};
use crate::models::mechanistic::{CK45, Cutter, Cutting};
use crate::models::printed::Printed;
use crate::models::spindle::SLOWEST_RPM;
use crate::models::tool::Tool;

const PRINTED: &[Printed] = &[
    Printed::new(
        "h = [(f_t + X_m) sin φ + Y_m cos φ + Δρ] sin κ",
        text!("Combined system 2005, Fig. 3 (lost), as ball-end geometry after Lee and Altintas"),
    ),
    Printed::new(
        "X_m = G [F_x(t) - F_x(t - T)],  Y_m = G [F_y(t) - F_y(t - T)]",
        text!("Combined system 2005, eq. 1: compliance with the delay of one tooth period"),
    ),
    Printed::new(
        "dF_i = k_i h^{1 - m} db",
        text!(
            "Kienzle's laws, tangential, radial and axial (constants of published tables, in part chosen)"
        ),
    ),
];

/// The teeth with the largest of what they make.
#[derive(Clone, Debug)]
pub struct Mechanistic {
    milling: Milling,
    largest: WindowMax<1>,
    /// What the teeth do at the last instant.
    now: Cutting,
    wear_factor: f64,
    /// Whether the hardness lies where the material's factor is known.
    material_known: bool,
    /// Feed per turn up to which the chips are no thicker than the specific cutting force is known for, mm.
    known_per_turn_mm: f64,
}

/// The tool in the plant's material; by a formula it is Ck45 times that.
fn milling_setup(
    plant: &PlantSettings,
    own: Option<Valued>,
    tool: &Tool,
    dt_s: f64,
) -> MillingSetup {
    let (steel, factor) = match own {
        Some(own) => (CK45, own.value),
        None => plant.material.steel(plant.hardness_hb),
    };
    MillingSetup {
        cutter: Cutter::new(tool, mm_from_um(tool.runout_um), plant.slice_mm),
        steel,
        rake_deg: tool.rake_deg,
        hardness_hb: steel.hardness_hb,
        factor,
        dt_s,
    }
}

/// Feed per turn up to which the formulas of the specific forces hold: no chip is thicker than the feed per
/// tooth, run-out aside. Below its range, where every chip runs out, it goes on without being marked.
fn known_per_turn_mm(formulas: &FormulaSettings, tool: &Tool) -> f64 {
    let inputs = formulas.specific_forces().into_iter().flatten().flat_map(|own| own.inputs());
    let thickest_mm = inputs.map(|input| input.range.high).fold(f64::INFINITY, f64::min);
    thickest_mm * f64::from(tool.teeth)
}

impl ForceModelLaw for Mechanistic {
    const ABOUT: &'static str = "The mechanistic model of the end mill, tooth by tooth (2005 milling \
                                 simulator); wants plant steps of some 30 us.";
    const MAP: bool = false;
    /// Some 180 samples for a tooth period of the papers' cut.
    const LONGEST_STEP_S: f64 = 1e-4;
    const IDENTIFIED_SET: Option<ModelSet> = Some(ModelSet::Milling2005);

    fn new(setup: &ForceSetup) -> Self {
        let own = setup.formulas.material_factor(setup.plant.hardness_hb);
        let milling = milling_setup(setup.plant, own, setup.tool, setup.dt_s);
        Self {
            milling: Milling::new(&milling, setup.depth_max_mm)
                .with_specific_forces(setup.formulas.specific_forces().map(Option::<&_>::cloned)),
            largest: WindowMax::new(setup.window),
            now: Cutting::default(),
            wear_factor: setup.plant.wear_factor,
            material_known: own.is_none_or(|own| own.valid),
            known_per_turn_mm: known_per_turn_mm(setup.formulas, setup.tool),
        }
    }

    /// A turning cutter goes on.
    fn take_over(&mut self, before: &Self) {
        self.milling.take_over(&before.milling);
        self.largest = before.largest.clone();
        self.now = before.now;
    }

    /// They are gone: what they would have cut, the next one meets.
    fn break_teeth(&mut self, broken: usize) -> f64 {
        self.milling.break_teeth(broken);
        1.0
    }

    fn make_rigid(&mut self) {
        self.milling.make_rigid();
    }

    fn restart(&mut self) {
        self.milling.restart();
        self.largest.restart();
    }

    fn teeth(&self) -> Option<&Cutting> {
        Some(&self.now)
    }

    fn teeth_mut(&mut self) -> Option<&mut Cutting> {
        Some(&mut self.now)
    }

    fn spindle_turn(&self) -> Option<f64> {
        Some(self.milling.spindle_turn())
    }

    #[inline]
    fn cut(&mut self, step: &CutStep, dynamic: impl FnOnce() -> f64) -> Force {
        let CutStep { feed_mm_min, speed_rpm, life_factor, .. } = *step;
        let (cut, x_mm) = step.under;
        let factor = self.wear_factor * life_factor * math::positive(dynamic());
        self.now = self.milling.update(feed_mm_min, speed_rpm, x_mm, cut, factor);
        let [x, y, _] = self.now.forces_n;
        let known = speed_rpm >= SLOWEST_RPM
            && self.material_known
            && feed_mm_min <= self.known_per_turn_mm * speed_rpm;
        let [largest_n] = self.largest.push(step.tick, [(x * x + y * y).sqrt()]);
        Force {
            model: Valued::new(largest_n, known),
            dynamic_n: largest_n,
            air: largest_n < step.air_n,
        }
    }

    fn short_name(_: ModelSet) -> String {
        tr("by teeth").to_owned()
    }

    fn printed(_: ModelSet) -> &'static [Printed] {
        PRINTED
    }

    /// What a tooth meets now, and the peak of the control period.
    fn explain(moment: &ForceMoment) -> Vec<Live> {
        let ForceMoment { tool, feed_mm_min, speed_rpm, place, .. } = *moment;
        let per_tooth_mm = tool.feed_per_tooth_mm(feed_mm_min, speed_rpm.max(1.0));
        vec![
            Live::everywhere(
                "f_t = f_a / (z n_a)",
                tr!(
                    "f_t = {feed} / ({teeth} · {speed}) = {chip} mm, run-out ± {runout} mm",
                    feed = number(feed_mm_min),
                    teeth = number(f64::from(tool.teeth)),
                    speed = number(speed_rpm),
                    chip = number(per_tooth_mm),
                    runout = number(mm_from_um(tool.runout_um))
                ),
            ),
            Live::everywhere(
                tr("F = largest √(F_x^2 + F_y^2) of a control period"),
                tr!(
                    "F = {force} N; with vibration {shaken} N  (A_D {axial} mm, R_D {radial} mm)",
                    force = number(moment.force_n),
                    shaken = number(moment.force_dyn_n),
                    axial = number(place.axial_depth_mm),
                    radial = number(place.radial_depth_mm)
                ),
            ),
        ]
    }
}
