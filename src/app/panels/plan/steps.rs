//! The control strategy in eight steps (2013, section 2), each with its values in the present run.

use egui::{RichText, Ui};

use super::search::Found;
use crate::app::format;
use crate::app::panels::View;
use crate::app::theme::Palette;
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
        None => "no plan".to_owned(),
        Some((optimum, progress)) => {
            let state = match (progress.done, optimum.feasible) {
                (_, false) => "nothing feasible",
                (true, true) => "found",
                (false, true) => "best so far",
            };
            format!(
                "{state}: {}, {}",
                feed_speed(optimum.feed_mm_min, optimum.speed_rpm),
                format::quantity(optimum.force_n, "N")
            )
        }
    };
    let program = &session.scenario().program;
    let ended = optimum.filter(|(optimum, progress)| progress.done && optimum.feasible);
    let compared = ended.map_or("", |(optimum, _)| {
        let same = |a: f64, b: f64| (a - b).abs() <= SAME * b;
        let is = same(program.feed_mm_min, optimum.feed_mm_min)
            && same(program.spindle_rpm, optimum.speed_rpm);
        if is { ", the optimum" } else { ", not the optimum" }
    });
    let air = row.has(flag::AIR);
    let deviation = percent_from_ratio(row.force_measured_n / row.force_ref_n - 1.0);
    let measured = format::quantity(row.force_measured_n, "N");
    let samples = |time_s: f64| (time_s / now.control_period_s() + 1e-6).floor();
    [
        step("The optimal cutting conditions are found by PSO-NN", answer),
        step(
            "They are programmed",
            feed_speed(program.feed_mm_min, program.spindle_rpm) + compared,
        ),
        step("The desired roughness is set", format::quantity(row.ra_target_um, "um")),
        step(
            &format!("The reference force follows from {letter}1"),
            format::quantity(row.force_ref_n, "N"),
        ),
        step(
            &format!("Feed and speed are commanded ({})", now.controller.kind.label()),
            feed_speed(row.feed_command_mm_min, row.spindle_command_rpm),
        ),
        step(
            "The measured force is compared with the reference",
            if air {
                "in the air".to_owned()
            } else {
                format!("{measured}, {}", format::deviation(deviation))
            },
        ),
        step(
            "The overrides go back to the machine",
            format!(
                "DNCFRO {}, DNCSPO {}",
                format::override_percent(row.feed_override_percent, now.cnc.override_quantised),
                format::override_percent(row.spindle_override_percent, now.cnc.override_quantised)
            ),
        ),
        step(
            "Steps 5 to 7 are repeated to the end",
            format!(
                "control sample {:.0} of {:.0}",
                samples(session.playback().playhead_s),
                samples(session.length_s())
            ),
        ),
    ]
}

/// The list.
pub fn show(ui: &mut Ui, view: &View<'_>, found: Option<&Found>) {
    let palette = Palette::at(ui);
    ui.label(RichText::new("The strategy in eight steps").strong());
    let note = "Control strategy 2013, section 2; values at the playhead of the run.";
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
