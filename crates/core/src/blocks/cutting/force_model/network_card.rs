//! A neural network's force with the values of a moment: inputs, ranges of training, components, peak
//! force.

use super::law::ForceMoment;
use crate::base::equation::{Live, number};
use crate::base::language::tr;
use crate::blocks::cutting::material::Material;
use crate::blocks::cutting::neural::NeuralCut;
use crate::blocks::cutting::process::PlantSettings;
use crate::models::Valued;
use crate::models::neural_force::{
    AXIAL_DEPTH_MM, AXIAL_PER_DIAMETER, CutPoint, DIAMETER_MM, FEED_PER_TOOTH_MM, GEOMETRY_CODE,
    HARDNESS_HB, NeuralForce, NeuralKind, RADIAL_PER_DIAMETER, SPEED_M_MIN, speed_m_min,
};

/// From the network's inputs to the force that the process gives.
pub(super) fn lines(kind: NeuralKind, moment: &ForceMoment, force: Valued) -> Vec<Live> {
    let ForceMoment { plant, tool, place, .. } = *moment;
    let depths_mm = [place.axial_depth_mm, place.radial_depth_mm];
    let cut = NeuralCut::new(tool, plant.material, plant.hardness_hb, depths_mm);
    let own = moment.formulas.material_factor(plant.hardness_hb);
    let cut = own.map_or(cut, |material| cut.of_ck45_times(material));
    let feed_mm_min = cut.feed_factor * moment.feed_mm_min;
    let point = CutPoint { feed_mm_min, speed_rpm: moment.speed_rpm, ..cut.point };
    let network = NeuralForce::shipped(kind);
    let [fx, fy, fz] = network.components(&point).map(|component| component * cut.factor);
    let (peak, wear) = ((fx * fx + fy * fy).sqrt(), plant.wear_factor);
    let mut lines = vec![
        inputs(network, &point),
        Live {
            formula: tr!("F_x, F_y, F_z = {factor}NN(inputs)", factor = factor(&cut)),
            values: format!(
                "F_x = {} N, F_y = {} N, F_z = {} N",
                number(fx),
                number(fy),
                number(fz)
            ),
            range: ranges(&point, &cut, plant),
            valid: force.valid,
        },
        Live::everywhere(
            tr("F_{xy} = √(F_x^2 + F_y^2), at the instant of its largest value"),
            format!("F_{{xy}} = √({}^2 + {}^2) = {} N", size(fx), size(fy), number(peak)),
        ),
    ];
    // In the air the offset cuts nothing either.
    let offset = if peak == 0.0 { 0.0 } else { plant.force_offset_n };
    let sign = if offset < 0.0 { '-' } else { '+' };
    let sum = format!("({} {sign} {}) · {}", number(peak), size(offset), number(wear));
    let sum = if peak + offset < 0.0 { format!("max(0, {sum})") } else { sum };
    lines.push(Live::everywhere(
        "F = (F_{xy} + offset) · wear",
        format!("F = {sum} = {} N", number(force.value)),
    ));
    lines.push(origin(network));
    lines
}

/// Without its sign, which a square does not need.
fn size(value: f64) -> String {
    number(value.abs())
}

/// What the force is scaled by for a material that the network does not know.
fn factor(cut: &NeuralCut) -> String {
    if cut.factor == 1.0 { String::new() } else { format!("{} · ", number(cut.factor)) }
}

fn inputs(network: &NeuralForce, point: &CutPoint) -> Live {
    let network = &network.network().network;
    let sizes: Vec<String> = network.sizes().iter().map(usize::to_string).collect();
    Live::everywhere(
        format!(
            "NN(f, n, R_D, A_D, material, HB, D, geometry): {}, {}",
            sizes.join("-"),
            tr(network.activation().label())
        ),
        tr!(
            "f {feed} mm/min, n {speed} 1/min, R_D {radial} mm, A_D {axial} mm, material {material}, \
             {hardness} HB, D {diameter} mm, geometry {geometry}",
            feed = number(point.feed_mm_min),
            speed = number(point.speed_rpm),
            radial = number(point.radial_depth_mm),
            axial = number(point.axial_depth_mm),
            material = number(point.material_code),
            hardness = number(point.hardness_hb),
            diameter = number(point.diameter_mm),
            geometry = number(point.geometry_code),
        ),
    )
}

/// The ranges of the training data; only those that are left, where any are.
fn ranges(point: &CutPoint, cut: &NeuralCut, plant: &PlantSettings) -> String {
    let PlantSettings { material, hardness_hb, .. } = *plant;
    let diameter = point.diameter_mm;
    let axial_max = (diameter * AXIAL_PER_DIAMETER).min(AXIAL_DEPTH_MM[1]);
    let speed = speed_m_min(diameter, point.speed_rpm);
    let values = [
        (tr("feed per tooth"), point.feed_per_tooth_mm(), FEED_PER_TOOTH_MM, "mm"),
        (tr("cutting speed"), speed, SPEED_M_MIN, "m/min"),
        ("A_D", point.axial_depth_mm, [AXIAL_DEPTH_MM[0], axial_max], "mm"),
        ("R_D", point.radial_depth_mm, RADIAL_PER_DIAMETER.map(|part| part * diameter), "mm"),
    ];
    let tool = [
        ("D", diameter, DIAMETER_MM, "mm"),
        (tr("geometry"), point.geometry_code, GEOMETRY_CODE, ""),
    ];
    let range =
        |[low, high]: [f64; 2]| tr!("{low} to {high}", low = number(low), high = number(high));
    let mut left: Vec<String> = values
        .iter()
        .chain(&tool)
        .filter(|(_, value, [low, high], _)| value < low || value > high)
        .map(|(name, value, trained, unit)| {
            tr!(
                "{name} {value} {unit}, trained on {range}",
                name = *name,
                value = number(*value),
                unit = *unit,
                range = range(*trained)
            )
        })
        .collect();
    let [ck45, mn_cr_si5] = HARDNESS_HB.map(range);
    let materials = format!(
        "{} {ck45} HB, {} {mn_cr_si5} HB",
        tr(Material::Ck45.label()),
        tr(Material::MnCrSi5.label())
    );
    if !cut.teeth_known {
        left.push(
            tr("this cutter, trained on ball ends with two teeth and the papers' helix").to_owned(),
        );
    }
    if !cut.material_known {
        let hardness = number(hardness_hb);
        left.push(tr!(
            "{material} at {hardness} HB, trained on {materials}",
            material = tr(material.label()),
            hardness = hardness,
            materials = materials
        ));
    }
    if !left.is_empty() {
        return left.join("; ");
    }
    let all = values.map(|(name, _, trained, unit)| format!("{name} {} {unit}", range(trained)));
    format!("{}; {materials}", all.join(", "))
}

/// What the network was trained on.
fn origin(network: &NeuralForce) -> Live {
    let from = network.provenance();
    Live::everywhere(
        from.note.clone(),
        tr!(
            "{rows} rows, {epochs} epochs, seed {seed}",
            rows = from.rows,
            epochs = from.epochs,
            seed = from.seed
        ),
    )
}
