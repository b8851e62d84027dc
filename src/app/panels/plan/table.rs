//! The seven constraints at the best cut: value, limit, margin; a click on a name opens its
//! formula, reason and origin.

use egui::{Button, RichText, Role, Ui, WidgetInfo};

use super::legend::{explain, limits};
use crate::app::format;
use crate::app::theme::{self, Look, Palette};
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::tr;
use crate::study::export::sheet::Sheet;
use crate::study::plan::constraints::{Checked, ORIGIN};
use crate::study::plan::machine::Source;
use crate::study::plan::optimum::Optimum;

/// Least and largest width of the names, points: longer ones are cut.
const NAME_WIDTHS: [f32; 2] = [96.0, 172.0];
/// Room for what stands beside them, points.
const BESIDE: f32 = 236.0;

/// The table; `open` is the number of the constraint that is explained below it.
pub fn show(ui: &mut Ui, optimum: &Optimum, open: &mut Option<usize>) {
    let (palette, checked) = (Palette::at(ui), &optimum.constraints);
    let depth = format::quantity(optimum.axial_depth_mm, "mm");
    let title = tr!("The seven constraints there, at {depth} depth", depth = depth);
    ui.label(RichText::new(title).strong());
    let origin = tr!("The list is {origin}.", origin = tr(ORIGIN));
    ui.label(RichText::new(origin).small().color(palette.weak));
    let name_width = (ui.available_width() - BESIDE).clamp(NAME_WIDTHS[0], NAME_WIDTHS[1]);
    ui.scope(|ui| {
        ui.style_mut().wrap_mode = Some(egui::TextWrapMode::Extend);
        ui.spacing_mut().button_padding = egui::vec2(3.0, 1.0);
        touch::low_rows(ui, 18.0);
        touch::grid(ui, "constraints").num_columns(4).striped(true).spacing([7.0, 3.0]).show(
            ui,
            |ui| {
                for title in [tr("Constraint"), tr("Value"), tr("Limit"), tr("Margin")] {
                    ui.label(RichText::new(title).small().color(palette.weak));
                }
                ui.end_row();
                for (number, one) in checked.iter().enumerate() {
                    row(ui, number, one, name_width, open);
                    ui.end_row();
                }
            },
        );
    });
    if let Some(number) = *open {
        theme::card(palette).show(ui, |ui| {
            ui.label(RichText::new(tr(checked[number].constraint.label)).strong());
            explain(ui, &checked[number]);
        });
    }
    let placeholders = checked.iter().filter(|one| one.source == Source::Placeholder).count();
    if placeholders > 0 {
        let text = tr!(
            "* {n} limits of the machine are placeholders: no public data were found.",
            n = placeholders,
        );
        Standing::Watch.label(ui, &text, RichText::small);
    }
}

/// The mark of where a limit comes from.
fn mark(source: Source) -> &'static str {
    match source {
        Source::Placeholder => " *",
        Source::Chosen | Source::Given => "",
    }
}

fn row(ui: &mut Ui, number: usize, one: &Checked, name_width: f32, open: &mut Option<usize>) {
    let palette = Palette::at(ui);
    let constraint = &one.constraint;
    let (stroke, _) = Look::Constraint(number).line(palette);
    let is_open = *open == Some(number);
    let text = RichText::new(tr(constraint.label)).small().color(stroke.color);
    let button = Button::new(text).frame_when_inactive(false).selected(is_open);
    let button = button.min_size(touch::least(ui)).wrap();
    let left = egui::Layout::left_to_right(egui::Align::Center);
    let size = egui::vec2(name_width, ui.spacing().interact_size.y);
    let response = ui.allocate_ui_with_layout(size, left, |ui| ui.add(button)).inner;
    response.widget_info(|| {
        let name = tr!("Explain {constraint}", constraint = tr(constraint.label));
        WidgetInfo::selected(Role::Button, true, is_open, name)
    });
    if response.on_hover_ui(|ui| explain(ui, one)).clicked() {
        *open = (!is_open).then_some(number);
    }
    ui.label(RichText::new(format::fine(one.value, constraint.unit)).small());
    let limit = limits(one) + mark(one.source);
    ui.label(RichText::new(limit).small().color(palette.weak));
    let margin = format::beside(format::signed(format!("{:+.0}", one.margin_percent)), "%");
    let (text, standing) = match (one.violation > 0.0, one.binding) {
        (true, _) => (margin, Standing::Bad),
        (false, true) => (tr("binding").to_owned(), Standing::Good),
        (false, false) => (margin, Standing::Good),
    };
    standing.label(ui, &text, RichText::small);
}

/// The best cut and its constraints as a file.
pub fn sheet(optimum: &Optimum) -> Sheet {
    let mut sheet =
        Sheet::new(["Name", "Value", "Unit", "Least", "Largest", "Margin [%]", "Limit from"]);
    for (name, value, unit) in [
        ("Axial depth", optimum.axial_depth_mm, "mm"),
        ("Radial depth", optimum.radial_depth_mm, "mm"),
        ("Feed", optimum.feed_mm_min, "mm/min"),
        ("Speed", optimum.speed_rpm, "1/min"),
        ("Feed per tooth", optimum.feed_per_tooth_mm, "mm"),
        ("Cutting speed", optimum.cutting_speed_m_min, "m/min"),
        ("Force", optimum.force_n, "N"),
        ("Removal", optimum.removal_rate_cm3_min, "cm3/min"),
        ("Time at this feed", optimum.time_s, "s"),
        ("Time with tool changes", optimum.production_time_s, "s"),
        ("Cost of cut", optimum.cost, ""),
        ("Objective", optimum.score.value, ""),
    ] {
        sheet.row([name.into(), value.into(), unit.into()]);
    }
    for one in &optimum.constraints {
        sheet.row([
            one.constraint.label.into(),
            one.value.into(),
            one.constraint.unit.into(),
            one.low.into(),
            one.high.into(),
            one.margin_percent.into(),
            one.source.id().into(),
        ]);
    }
    sheet
}
