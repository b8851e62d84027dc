//! Numbers beside the map: the values at a place, and the scale of the colours.

use egui::{Rect, RichText, Sense, Ui, WidgetInfo, pos2, vec2};

use super::picture::Picture;
use super::search::Found;
use crate::app::format;
use crate::app::theme::{self, Palette};
use crate::app::widgets::icon::{self, Icon};
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::tr;
use crate::run::scenario::Scenario;

/// The values at a place, as the plan has them and as the run cuts there, and what forbids it.
pub fn readout(ui: &mut Ui, found: &mut Found, scenario: &Scenario, point: [f64; 2]) {
    let palette = Palette::at(ui);
    let in_run = found.in_run(scenario, point);
    let cut = found.problem.cut(point);
    let mut lines = vec![
        (tr("Cutting speed"), format::quantity(point[0], "m/min")),
        (tr("Feed per tooth"), format::fine(point[1], "mm")),
        (tr("Spindle speed"), format::quantity(cut.speed_rpm, "1/min")),
        (tr("Feed"), format::quantity(cut.feed_mm_min, "mm/min")),
        (tr("Axial depth"), format::quantity(found.problem.depths_mm()[0], "mm")),
        (tr("Force by the network"), format::quantity(cut.force_n, "N")),
    ];
    if let Some(run) = &in_run {
        let off = format::deviation(run.above_plan_percent);
        let force = format!("{} ({off})", format::quantity(run.force_n, "N"));
        lines.push((tr("Force in the run"), force));
    }
    lines.extend([
        (tr("Ra of feed marks"), format::quantity(cut.ra_um, "um")),
        (tr("Spindle power"), format::quantity(cut.power_kw, "kW")),
        (tr("Deflection"), format::fine(cut.deflection_mm, "mm")),
        (tr("Tool life"), format::quantity(cut.tool_life_min, "min")),
    ]);
    ui.style_mut().wrap_mode = Some(egui::TextWrapMode::Extend);
    ui.spacing_mut().interact_size.y = 14.0;
    touch::grid(ui, "readout").num_columns(2).spacing([12.0, 1.0]).show(ui, |ui| {
        for (name, value) in lines {
            ui.label(RichText::new(name).color(palette.weak));
            ui.label(value);
            ui.end_row();
        }
    });
    if let Some(run) = &in_run {
        ui.label(tr!("In the run: {held}", held = run.held_text(scenario.target.reference)));
    }
    let checked = found.problem.check(point);
    let violated = checked.iter().filter(|one| one.violation > 0.0);
    let violated: Vec<&str> = violated.map(|one| tr(one.constraint.label)).collect();
    if violated.is_empty() {
        Standing::Good.label(ui, tr("allowed by the plan"), RichText::strong);
    } else {
        let text = tr!(
            "violated by the plan's own forces: {constraints}",
            constraints = violated.join(", ")
        );
        Standing::Bad.label(ui, &text, RichText::strong);
    }
}

/// The values at the pinned place, with a way to let go of it.
pub fn pinned(ui: &mut Ui, place: &mut Option<[f64; 2]>, found: &mut Found, scenario: &Scenario) {
    let Some(point) = *place else { return };
    let palette = Palette::at(ui);
    theme::card(palette).show(ui, |ui| {
        ui.horizontal_top(|ui| {
            ui.vertical(|ui| readout(ui, found, scenario, point));
            let right = egui::Layout::right_to_left(egui::Align::Min);
            ui.with_layout(right, |ui| {
                let help = tr("Let go of this place");
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
    let said = tr(
        "Force by the plan's network: in colour where the cut is allowed, grey where a constraint forbids it",
    );
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
