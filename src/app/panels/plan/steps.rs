//! The control strategy in eight steps (2013, section 2), each with its values in the present run.

use egui::{RichText, Ui};

use super::search::Found;
use crate::app::format;
use crate::app::panels::View;
use crate::app::theme::Palette;
use crate::base::language::tr;
use crate::base::units::percent_from_ratio;
use crate::run::signals::flag;

/// A step: what it does, and its values.
struct Step {
    doing: String,
    values: String,
}

/// A programmed value counts as the optimum's within this fraction of it.
const SAME: f64 = 5e-4;

fn steps(view: &View<'_>, found: Option<&Found>) -> [Step; 8] {
    let step = |doing: &str, values: String| Step { doing: doing.to_owned(), values };
    let session = view.session;
    let (now, row) = (session.current(), session.row());
    let letter = now.belief.model_set.letter();
    let feed_speed = |feed: f64, speed: f64| {
        format!("{}, {}", format::quantity(feed, "mm/min"), format::quantity(speed, "1/min"))
    };
    let optimum = found.map(|found| (found.optimum(), found.stage().counts));
    let answer = match &optimum {
        None => tr("no plan").to_owned(),
        Some((optimum, progress)) => {
            let values = format!(
                "{}, {}",
                feed_speed(optimum.feed_mm_min, optimum.speed_rpm),
                format::quantity(optimum.force_n, "N")
            );
            match (progress.done, optimum.feasible) {
                (_, false) => tr!("nothing feasible: {values}", values = values),
                (true, true) => tr!("found: {values}", values = values),
                (false, true) => tr!("best so far: {values}", values = values),
            }
        }
    };
    let program = &session.scenario().program;
    let ended = optimum.filter(|(optimum, progress)| progress.done && optimum.feasible);
    let is_optimum = ended.map(|(optimum, _)| {
        let same = |a: f64, b: f64| (a - b).abs() <= SAME * b;
        same(program.feed_mm_min, optimum.feed_mm_min)
            && same(program.spindle_rpm, optimum.speed_rpm)
    });
    let values = feed_speed(program.feed_mm_min, program.spindle_rpm);
    let programmed = match is_optimum {
        None => values,
        Some(true) => tr!("{values}, the optimum", values = values),
        Some(false) => tr!("{values}, not the optimum", values = values),
    };
    let air = row.has(flag::AIR);
    let deviation = percent_from_ratio(row.force_measured_n / row.force_ref_n - 1.0);
    let measured = format::quantity(row.force_measured_n, "N");
    let samples = |time_s: f64| (time_s / now.control_period_s() + 1e-6).floor();
    [
        step(tr("The optimal cutting conditions are found by PSO-NN"), answer),
        step(tr("They are programmed"), programmed),
        step(tr("The desired roughness is set"), format::quantity(row.ra_target_um, "um")),
        step(
            &tr!("The reference force follows from {letter}1", letter = letter),
            format::quantity(row.force_ref_n, "N"),
        ),
        step(
            &tr!(
                "Feed and speed are commanded ({controller})",
                controller = tr(now.controller.kind.label()),
            ),
            feed_speed(row.feed_command_mm_min, row.spindle_command_rpm),
        ),
        step(
            tr("The measured force is compared with the reference"),
            if air {
                tr("in the air").to_owned()
            } else {
                format!("{measured}, {}", format::deviation(deviation))
            },
        ),
        step(
            tr("The overrides go back to the machine"),
            format!(
                "DNCFRO {}, DNCSPO {}",
                format::override_percent(row.feed_override_percent, now.cnc.override_quantised),
                format::override_percent(row.spindle_override_percent, now.cnc.override_quantised)
            ),
        ),
        step(
            tr("Steps 5 to 7 are repeated to the end"),
            tr!(
                "control sample {number:.0} of {all:.0}",
                number = samples(session.playback().playhead_s),
                all = samples(session.length_s()),
            ),
        ),
    ]
}

/// The list.
pub fn show(ui: &mut Ui, view: &View<'_>, found: Option<&Found>) {
    let palette = Palette::at(ui);
    ui.label(RichText::new(tr("The strategy in eight steps")).strong());
    let note = tr("Control strategy 2013, section 2; values at the playhead of the run.");
    ui.label(RichText::new(note).small().color(palette.weak));
    for (number, step) in (1..).zip(steps(view, found)) {
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            let badge = RichText::new(format!("{number}")).strong().color(palette.accent);
            ui.add_sized(egui::vec2(14.0, 16.0), egui::Label::new(badge));
            ui.vertical(|ui| {
                ui.spacing_mut().item_spacing.y = 0.0;
                ui.label(RichText::new(step.doing).color(palette.weak).small());
                ui.label(step.values);
            });
        });
    }
}
