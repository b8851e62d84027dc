//! The card of the cutting process.

use super::formula::number;
use super::neural::neural;
use crate::base::equation::Live;
use crate::base::units::mm_from_um;
use crate::blocks::cutting::force_map::ForceMap;
use crate::blocks::cutting::process::ForceModel;
use crate::blocks::cutting::tool_path::Engagement;
use crate::models::Valued;
use crate::models::genetic::force_formula::{FEED_MIN_MM_MIN, INCH, SPEED_MIN_RPM};
use crate::models::neural_force::NeuralKind;
use crate::run::scenario::Scenario;
use crate::run::signals::Row;

/// The plant's force model.
pub fn cutting(row: &Row, scenario: &Scenario) -> Vec<Live> {
    match scenario.plant.force_model {
        ForceModel::Formula => formula(row, scenario),
        ForceModel::Neural => neural(NeuralKind::Improved, row, scenario),
        ForceModel::NeuralLiteral => neural(NeuralKind::Literal, row, scenario),
        ForceModel::Mechanistic => tooth_by_tooth(row, scenario),
    }
}

/// The plant's map of force as it stands at a row, and the force that it gives.
pub fn map_at(row: &Row, scenario: &Scenario) -> (ForceMap, Valued) {
    let (axial_depth_mm, radial_depth_mm) = (row.axial_depth_mm, row.radial_depth_mm);
    let mut map = ForceMap::new(&scenario.plant, &scenario.tool, radial_depth_mm);
    let engagement = Engagement { axial_depth_mm, radial_depth_mm };
    let force = map.force(row.feed_mm_min, row.spindle_rpm, &engagement, 1.0);
    (map, force)
}

/// Model 4 of the plant, and what it does not know.
fn formula(row: &Row, scenario: &Scenario) -> Vec<Live> {
    let plant = &scenario.plant;
    let (feed, speed, depth) = (row.feed_mm_min, row.spindle_rpm, row.axial_depth_mm);
    let radial_depth_mm = row.radial_depth_mm;
    let (map, force) = map_at(row, scenario);
    let models = map.models();
    let k4 = models.force(feed, speed);
    let name = format!("{}4", models.set.letter());
    let [intercept, feed_coefficient, inch, speed_coefficient] =
        [models.force.intercept_n, models.force.feed, INCH, models.force.speed * 1e10].map(number);
    let formula = |f: &str, n: &str, times: &str| {
        format!(
            "{intercept} - {speed_coefficient}·10^{{-10}}{times}{n}^3 \
             - {feed_coefficient} ln({inch}{times}{f}) / {f}"
        )
    };
    let with = formula(&number(feed.max(FEED_MIN_MM_MIN)), &number(speed), " · ");
    let with = if k4.value == 0.0 { format!("max(0, {with})") } else { with };
    let model = Live {
        formula: format!("{name} = {}", formula("f", "n", " ")),
        values: format!("{name} = {with} = {} N", number(k4.value)),
        range: format!(
            "f from {} mm/min on (its least force), n from {} 1/min on{}",
            number(FEED_MIN_MM_MIN),
            number(SPEED_MIN_RPM),
            if models.of_tool { "" } else { "; of the papers' cutter alone" }
        ),
        valid: k4.valid,
    };
    let engagement = depth * radial_depth_mm;
    let [axial_mm, radial_mm] = models.set.engagement_mm();
    let reference = axial_mm * radial_mm;
    let product = Live::everywhere(
        format!("F = {name} · material · (A_D R_D / {} mm^2) · wear", number(reference)),
        format!(
            "F = {} · {} · {} / {} · {} = {} N  ({}, {} HB)",
            number(k4.value),
            number(plant.material.force_factor(plant.hardness_hb)),
            number(engagement),
            number(reference),
            number(plant.wear_factor),
            number(force.value),
            plant.material.label(),
            number(plant.hardness_hb),
        ),
    );
    vec![model, product]
}

/// The mechanistic model: what a tooth meets now, and the peak of the control period.
fn tooth_by_tooth(row: &Row, scenario: &Scenario) -> Vec<Live> {
    let tool = &scenario.tool;
    let per_tooth_mm = tool.feed_per_tooth_mm(row.feed_mm_min, row.spindle_rpm.max(1.0));
    vec![
        Live::everywhere(
            "f_t = f_a / (z n_a)",
            format!(
                "f_t = {} / ({} · {}) = {} mm, run-out ± {} mm",
                number(row.feed_mm_min),
                number(f64::from(tool.teeth)),
                number(row.spindle_rpm),
                number(per_tooth_mm),
                number(mm_from_um(scenario.tool.runout_um))
            ),
        ),
        Live::everywhere(
            "F = largest √(F_x^2 + F_y^2) of a control period",
            format!(
                "F = {} N; with vibration {} N  (A_D {} mm, R_D {} mm)",
                number(row.force_n),
                number(row.force_dyn_n),
                number(row.axial_depth_mm),
                number(row.radial_depth_mm)
            ),
        ),
    ]
}
