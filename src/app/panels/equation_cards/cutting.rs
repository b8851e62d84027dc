//! The card of the cutting process.

use super::formula::number;
use super::live::Live;
use super::neural::neural;
use crate::base::model::force_formula::{FEED_MIN_MM_MIN, INCH, SPEED_MIN_RPM};
use crate::blocks::cutting::process::Process;
use crate::blocks::cutting::workpiece::{AXIAL_DEPTH_2007_MM, RADIAL_DEPTH_2007_MM};
use crate::run::scenario::Scenario;
use crate::run::signals::Row;

/// Model 4 of the plant, and what it does not know.
pub fn cutting(row: &Row, scenario: &Scenario) -> Vec<Live> {
    let plant = &scenario.plant;
    let mut process = Process::new(plant, scenario.workpiece.radial_depth_mm);
    let (feed, speed, depth) = (row.feed_mm_min, row.spindle_rpm, row.axial_depth_mm);
    let force = process.update(feed, speed, depth);
    if let Some(kind) = plant.force_model.network() {
        return neural(kind, row, scenario, force);
    }
    let models = process.models();
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
            "f from {} mm/min on (its least force), n from {} 1/min on",
            number(FEED_MIN_MM_MIN),
            number(SPEED_MIN_RPM)
        ),
        valid: k4.valid,
    };
    let engagement = depth * scenario.workpiece.radial_depth_mm;
    let reference = AXIAL_DEPTH_2007_MM * RADIAL_DEPTH_2007_MM;
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
