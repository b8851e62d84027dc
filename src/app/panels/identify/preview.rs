//! The first rows of a table below the units that were read of its header: to see that it was read as it is meant.

use egui::{RichText, TextWrapMode, Ui};

use super::symbols::{column_words, short};
use crate::app::format;
use crate::app::theme::Palette;
use crate::app::widgets::scaffold;
use crate::app::widgets::touch;
use crate::base::language::{decimal, tr};
use crate::study::identify::gp::columns::OfferedTable;

/// Longest name or cell that is shown whole, characters.
const CELL: usize = 18;

/// Names, units and the first rows.
pub fn show(ui: &mut Ui, offered: &OfferedTable) {
    let palette = Palette::at(ui);
    scaffold::across(ui, "first rows", |ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
        ui.spacing_mut().interact_size.y = 16.0;
        let grid = touch::grid(ui, "first rows").striped(true).spacing([10.0, 1.0]);
        grid.min_col_width(0.0).show(ui, |ui| {
            for column in &offered.columns {
                let name = RichText::new(short(column_words(&column.name), CELL)).small().strong();
                ui.label(name).on_hover_text(&column.name);
            }
            ui.end_row();
            for column in &offered.columns {
                let unit = match (&column.range, column.unit.as_str()) {
                    (Err(_), _) => tr("no numbers").to_owned(),
                    (Ok(_), "") => tr("unit not told").to_owned(),
                    (Ok(_), unit) => format::unit(unit),
                };
                ui.label(RichText::new(unit).small().color(palette.weak));
            }
            ui.end_row();
            for row in &offered.first {
                for cell in row {
                    // A number as it was read: the file may have another decimal sign.
                    let read = cell.trim().parse::<f64>();
                    let cell = read.map_or_else(|_| cell.clone(), |_| decimal(cell.clone()));
                    ui.label(RichText::new(short(&cell, CELL)).small());
                }
                ui.end_row();
            }
        });
    });
}
