//! Numbers beside the map: the values at a place, and the scale of the colours.

use egui::{Rect, RichText, Sense, Ui, WidgetInfo, pos2, vec2};

use super::picture::Picture;
use crate::app::format;
use crate::app::theme::{self, Palette};
use crate::app::widgets::icon::{self, Icon};
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::study::plan::problem::Problem;

/// The values at a place, and what forbids it.
pub fn readout(ui: &mut Ui, problem: &Problem, point: [f64; 2]) {
    let palette = Palette::at(ui);
    let cut = problem.cut(point);
    let lines = [
        ("Cutting speed", format::quantity(point[0], "m/min")),
        ("Feed per tooth", format::fine(point[1], "mm")),
        ("Spindle speed", format::quantity(cut.speed_rpm, "1/min")),
        ("Feed", format::quantity(cut.feed_mm_min, "mm/min")),
        ("Force", format::quantity(cut.force_n, "N")),
        ("Ra of feed marks", format::quantity(cut.ra_um, "um")),
        ("Spindle power", format::quantity(cut.power_kw, "kW")),
        ("Deflection", format::fine(cut.deflection_mm, "mm")),
        ("Tool life", format::quantity(cut.tool_life_min, "min")),
    ];
    ui.style_mut().wrap_mode = Some(egui::TextWrapMode::Extend);
    ui.spacing_mut().interact_size.y = 14.0;
    touch::grid(ui, "readout").num_columns(2).spacing([12.0, 1.0]).show(ui, |ui| {
        for (name, value) in lines {
            ui.label(RichText::new(name).color(palette.weak));
            ui.label(value);
            ui.end_row();
        }
    });
    let checked = problem.check(point);
    let violated: Vec<&str> =
        checked.iter().filter(|one| one.violation > 0.0).map(|one| one.constraint.label).collect();
    if violated.is_empty() {
        Standing::Good.label(ui, "allowed", RichText::strong);
    } else {
        let text = format!("violated: {}", violated.join(", "));
        Standing::Bad.label(ui, &text, RichText::strong);
    }
}

/// The values at the pinned place, with a way to let go of it.
pub fn pinned(ui: &mut Ui, place: &mut Option<[f64; 2]>, problem: &Problem) {
    let Some(point) = *place else { return };
    let palette = Palette::at(ui);
    theme::card(palette).show(ui, |ui| {
        ui.horizontal_top(|ui| {
            ui.vertical(|ui| readout(ui, problem, point));
            let right = egui::Layout::right_to_left(egui::Align::Min);
            ui.with_layout(right, |ui| {
                let help = "Let go of this place";
                if icon::button(ui, Icon::Close, help, help, true).clicked() {
                    *place = None;
                }
            });
        });
    });
}

/// The scale of the colours: what is allowed, and below it what is not.
pub fn scale(ui: &mut Ui, picture: &Picture) {
    const SIZE: egui::Vec2 = vec2(110.0, 12.0);
    const STEPS: usize = 40;
    let palette = Palette::at(ui);
    let [low, high] = picture.range_n();
    ui.label(RichText::new(format::quantity(low, "N")).small().color(palette.weak));
    let (rect, response) = ui.allocate_exact_size(SIZE, Sense::hover());
    let said = "Force: in colour where the cut is allowed, grey where a constraint forbids it";
    response.widget_info(|| WidgetInfo::labeled(egui::Role::Label, true, said));
    for step in 0..STEPS {
        let fraction = step as f32 / STEPS as f32;
        let force_n = low + (high - low) * f64::from(fraction);
        let left = rect.left() + fraction * rect.width();
        let right = left + rect.width() / STEPS as f32 + 0.5;
        for (allowed, top, bottom) in
            [(true, rect.top(), rect.center().y), (false, rect.center().y, rect.bottom())]
        {
            let piece = Rect::from_min_max(pos2(left, top), pos2(right, bottom));
            let color = picture.color(palette, force_n, allowed);
            ui.painter().rect_filled(piece, 0.0, color);
        }
    }
    response.on_hover_text(said);
    ui.label(RichText::new(format::quantity(high, "N")).small().color(palette.weak));
}
