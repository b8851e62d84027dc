//! The seven constraints at the best cut: value, limit, margin; a click on a name opens its
//! formula, reason and origin.

use egui::{Button, Grid, RichText, Role, Ui, WidgetInfo};

use super::legend::{explain, limits};
use crate::app::format;
use crate::app::theme::{self, Look, Palette};
use crate::study::plan::constraints::{Checked, ORIGIN};
use crate::study::plan::machine::Source;

/// Width of the names, points: longer ones are cut.
const NAME_WIDTH: f32 = 161.0;
/// Size of type of names and values.
const NOTE: f32 = 11.5;

/// The table; `open` is the number of the constraint that is explained below it.
pub fn show(ui: &mut Ui, checked: &[Checked; 7], open: &mut Option<usize>) {
    let palette = Palette::at(ui);
    ui.label(RichText::new("The seven constraints there").strong());
    ui.label(RichText::new(format!("The list is {ORIGIN}.")).small().color(palette.weak));
    ui.scope(|ui| {
        ui.style_mut().wrap_mode = Some(egui::TextWrapMode::Extend);
        ui.spacing_mut().button_padding = egui::vec2(3.0, 1.0);
        ui.spacing_mut().interact_size.y = 18.0;
        Grid::new("constraints").num_columns(4).striped(true).spacing([7.0, 3.0]).show(ui, |ui| {
            for title in ["Constraint", "Value", "Limit", "Margin"] {
                ui.label(RichText::new(title).small().color(palette.weak));
            }
            ui.end_row();
            for (number, one) in checked.iter().enumerate() {
                row(ui, number, one, open);
                ui.end_row();
            }
        });
    });
    if let Some(number) = *open {
        theme::card(palette).show(ui, |ui| {
            ui.label(RichText::new(checked[number].constraint.label).strong());
            explain(ui, &checked[number]);
        });
    }
    let placeholders = checked.iter().filter(|one| one.source == Source::Placeholder).count();
    if placeholders > 0 {
        let text = format!(
            "* {placeholders} limits of the machine are placeholders: no public data were found."
        );
        ui.label(RichText::new(text).small().color(palette.warn));
    }
}

/// The mark of where a limit comes from.
fn mark(source: Source) -> &'static str {
    match source {
        Source::Placeholder => " *",
        Source::Chosen | Source::Given => "",
    }
}

fn row(ui: &mut Ui, number: usize, one: &Checked, open: &mut Option<usize>) {
    let palette = Palette::at(ui);
    let constraint = &one.constraint;
    let (stroke, _) = Look::Constraint(number).line(palette);
    let is_open = *open == Some(number);
    let text = RichText::new(constraint.label).size(NOTE).color(stroke.color);
    let button = Button::new(text).frame_when_inactive(false).selected(is_open).truncate();
    let left = egui::Layout::left_to_right(egui::Align::Center);
    let size = egui::vec2(NAME_WIDTH, ui.spacing().interact_size.y);
    let response = ui.allocate_ui_with_layout(size, left, |ui| ui.add(button)).inner;
    response.widget_info(|| {
        WidgetInfo::selected(Role::Button, true, is_open, format!("Explain {}", constraint.label))
    });
    if response.on_hover_ui(|ui| explain(ui, one)).clicked() {
        *open = (!is_open).then_some(number);
    }
    ui.label(RichText::new(format::fine(one.value, constraint.unit)).size(NOTE));
    let limit = limits(one) + mark(one.source);
    ui.label(RichText::new(limit).small().color(palette.weak));
    let margin = format!("{:+.0} %", one.margin_percent);
    let (text, color) = match (one.violation > 0.0, one.binding) {
        (true, _) => (margin, palette.bad),
        (false, true) => ("binding".to_owned(), palette.accent),
        (false, false) => (margin, palette.text),
    };
    ui.label(RichText::new(text).size(NOTE).color(color));
}
