//! The columns of the table: which is the target, which may be read, and in which units.

use egui::{Align, Align2, Button, Label, Layout, RichText, Role, TextEdit, Ui, WidgetInfo, vec2};

use super::form::{Asked, LoadedTable};
use super::symbols::{column_words, told_number};
use crate::app::theme::Palette;
use crate::app::widgets::touch;
use crate::base::language::tr;

/// Width of the field of a unit, points.
const UNIT_WIDTH: f32 = 96.0;

/// A line for every column, and the units of those that are chosen.
pub fn show(ui: &mut Ui, asked: &mut Asked, table: &LoadedTable) {
    let palette = Palette::at(ui);
    ui.label(RichText::new(tr("Target and inputs")).strong());
    for column in &table.offered.columns {
        match &column.range {
            Ok(range) => line(ui, asked, table, &column.name, *range),
            Err(because) => {
                let said = tr!("left out: {because}", because = because);
                ui.add(Label::new(RichText::new(said).small().color(palette.weak)).wrap());
            }
        }
    }
    let chosen: Vec<String> = asked.columns().cloned().collect();
    if chosen.is_empty() {
        return;
    }
    ui.add_space(4.0);
    ui.label(RichText::new(tr("Units")).strong());
    for name in chosen {
        unit(ui, asked, table, &name);
    }
}

/// A line that is filled from the right: its name takes what is left.
fn beside(ui: &mut Ui, add: impl FnOnce(&mut Ui)) {
    ui.horizontal(|ui| ui.with_layout(Layout::right_to_left(Align::Center), add));
}

fn line(ui: &mut Ui, asked: &mut Asked, table: &LoadedTable, name: &str, [low, high]: [f64; 2]) {
    beside(ui, |ui| {
        let is_input = asked.inputs.iter().any(|input| input == name);
        let is_target = asked.target.as_deref() == Some(name);
        let least = touch::least(ui);
        let mut choice = |what: &str, is: bool| {
            let response = ui.add(Button::selectable(is, what).min_size(least));
            let label = format!("{}: {what}", column_words(name));
            response.widget_info(|| WidgetInfo::selected(Role::Button, true, is, label.clone()));
            response.clicked()
        };
        // From the right.
        let input = choice(tr("input"), is_input);
        let target = choice(tr("target"), is_target);
        if target {
            asked.target = (!is_target).then(|| name.to_owned());
            asked.inputs.retain(|input| input != name);
        } else if input {
            if is_target {
                asked.target = None;
            }
            // In the order of the table, whatever was pressed first.
            let wanted = |other: &str| {
                let was = asked.inputs.iter().any(|input| input == other);
                was != (other == name)
            };
            let names = table.offered.columns.iter().map(|column| column.name.as_str());
            let inputs: Vec<String> =
                names.filter(|name| wanted(name)).map(str::to_owned).collect();
            asked.inputs = inputs;
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            let [low, high] = [low, high].map(told_number);
            let range = tr!("{name}: {low} to {high}", name = name, low = low, high = high);
            ui.add(Label::new(column_words(name)).truncate()).on_hover_text(range);
        });
    });
}

/// The unit of a column that is chosen; an empty one is none.
fn unit(ui: &mut Ui, asked: &mut Asked, table: &LoadedTable, name: &str) {
    let column = table.offered.columns.iter().find(|column| column.name == name);
    let told = column.map(|column| column.unit.clone()).unwrap_or_default();
    let mut text = asked.unit(name);
    beside(ui, |ui| {
        let height = ui.spacing().interact_size.y;
        let field = TextEdit::singleline(&mut text)
            .hint_text(tr("none"))
            .desired_width(UNIT_WIDTH)
            .min_size(vec2(0.0, height))
            .align(Align2::LEFT_CENTER);
        let response = ui.add(field);
        let label = tr!("Unit of {name}", name = column_words(name));
        let now = text.clone();
        response.widget_info(|| WidgetInfo::text_edit(true, "", &now, label.clone()));
        let help = tr(
            "As mm/min, 1/min, N, um; empty or 1 for none. The ending of the column's name tells it first",
        );
        if response.on_hover_text(help).changed() {
            if text == told {
                asked.units.remove(name);
            } else {
                asked.units.insert(name.to_owned(), text.clone());
            }
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            ui.add(Label::new(column_words(name)).truncate()).on_hover_text(name);
        });
    });
}
