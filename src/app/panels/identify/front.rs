//! The front: error against size as a picture and as a table, where a formula is picked.

use egui::{Align, Button, Label, Layout, RichText, Role, Ui, WidgetInfo};

use super::front_plot;
use super::search::{FormulaSearch, FrontRow};
use super::symbols::{rounded, symbols};
use crate::app::command::Command;
use crate::app::panels::equation_cards::formula::typeset;
use crate::app::theme::{self, Palette};
use crate::app::widgets::save_table::save_table;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::equation::number;
use crate::base::formula::Formula;
use crate::study::export::sheet::Sheet;

/// From this width on, points, picture and table stand beside each other.
const BESIDE_FROM: f32 = 720.0;
/// Height of the picture, points.
const HEIGHT: f32 = 260.0;
/// Size of the formulas in the table, points, and the digits of their numbers.
const FORMULA: f32 = 13.0;
/// See [`FORMULA`].
const DIGITS: usize = 4;
/// Widths of the columns for size, errors and sign, points.
const CELLS: [f32; 4] = [44.0, 60.0, 60.0, 76.0];

/// Picture and table.
pub fn show(ui: &mut Ui, search: &mut FormulaSearch, narrow: bool, commands: &mut Vec<Command>) {
    ui.label(RichText::new("Front: the formula of the least error of each size").strong());
    if search.rows().is_empty() {
        ui.weak("No formula has a finite value on all rows yet.");
        return;
    }
    let shown = search.shown().map(|row| row.size);
    let picked = if ui.available_width() >= BESIDE_FROM {
        let width = ui.available_width();
        ui.horizontal_top(|ui| {
            let left = ui.allocate_ui(egui::vec2(0.42 * width, HEIGHT), |ui| {
                front_plot::show(ui, search, shown, HEIGHT)
            });
            ui.add_space(8.0);
            let right = ui.vertical(|ui| table(ui, search, shown, narrow));
            left.inner.or(right.inner)
        })
        .inner
    } else {
        let above = front_plot::show(ui, search, shown, HEIGHT);
        above.or(table(ui, search, shown, narrow))
    };
    if let Some(size) = picked {
        search.pick(size);
    }
    notes(ui, search);
    save_table(ui, "front", || sheet(search), commands);
}

/// A cell of the table: so wide, whatever stands in it.
fn cell(ui: &mut Ui, width: f32, add: impl FnOnce(&mut Ui)) {
    let size = egui::vec2(width, ui.spacing().interact_size.y);
    ui.allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), |ui| {
        ui.set_min_width(width);
        add(ui);
    });
}

/// A row for each formula; the size of the one that was clicked.
fn table(ui: &mut Ui, search: &FormulaSearch, shown: Option<usize>, narrow: bool) -> Option<usize> {
    let palette = Palette::at(ui);
    ui.scope(|ui| {
        // As low as its text.
        ui.spacing_mut().interact_size.y = 14.0;
        ui.horizontal(|ui| {
            for (title, width) in ["size", "error", "left out"].iter().zip(CELLS) {
                cell(ui, width, |ui| {
                    ui.label(RichText::new(*title).small().color(palette.weak));
                });
            }
        });
    });
    let names: Vec<&str> = search.problem().inputs.iter().map(String::as_str).collect();
    let words = symbols(&names);
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let mut picked = None;
    for row in search.rows() {
        let is = shown == Some(row.size);
        let found = Formula::parse(&row.formula, &names);
        let equation = found.map(|found| rounded(&found, DIGITS).equation(&words));
        let equation = equation.unwrap_or_else(|_| row.formula.clone());
        let mut line = |ui: &mut Ui| {
            cell(ui, CELLS[0], |ui| {
                let button = Button::selectable(is, row.size.to_string());
                let least = touch::least(ui).max(egui::vec2(CELLS[0], 0.0));
                let response = ui.add(button.min_size(least));
                let label = format!("Formula of size {}", row.size);
                response
                    .widget_info(|| WidgetInfo::selected(Role::Button, true, is, label.clone()));
                if response.clicked() {
                    picked = Some(row.size);
                }
            });
            cell(ui, CELLS[1], |ui| {
                ui.label(number(row.error));
            });
            cell(ui, CELLS[2], |ui| {
                ui.label(row.left_out.map(number).unwrap_or_default());
            });
            cell(ui, CELLS[3], |ui| {
                sign(row).line(ui, RichText::new(word(row)), egui::TextWrapMode::Extend);
            });
        };
        let note = theme::note(ui.ctx()).size;
        let set = typeset(&equation, FORMULA, note, palette.text);
        if narrow {
            ui.horizontal(&mut line);
            ui.add(Label::new(set).wrap());
        } else {
            ui.horizontal(|ui| {
                line(ui);
                ui.add(Label::new(set).truncate()).on_hover_text(&row.formula);
            });
        }
    }
    picked
}

fn sign(row: &FrontRow) -> Standing {
    match (row.chosen, row.doubt) {
        (true, _) => Standing::Best,
        (false, "") => Standing::Plain,
        (false, _) => Standing::Watch,
    }
}

fn word(row: &FrontRow) -> &'static str {
    match (row.chosen, row.exact, row.doubt) {
        (true, true, _) => "chosen, exact",
        (true, false, _) => "chosen",
        (false, true, _) => "exact",
        (false, false, "") => "",
        (false, false, _) => "unsure",
    }
}

/// What the signs mean, and what the paper's search has found.
fn notes(ui: &mut Ui, search: &FormulaSearch) {
    let palette = Palette::at(ui);
    let note = |ui: &mut Ui, text: String| {
        ui.add(Label::new(RichText::new(text).small().color(palette.weak)).wrap());
    };
    let Some(report) = search.report() else {
        let text = "Errors are root mean squares of what is left over. At rows left out they are found once the \
                    search is over.";
        return note(ui, text.to_owned());
    };
    let told = report.left_out.unwrap_or("nothing");
    note(
        ui,
        format!(
            "Left out: {told}. Unsure: more than twice the least error there, or not certain to be finite."
        ),
    );
    if report.searched_rows < report.rows {
        let (searched, rows) = (report.searched_rows, report.rows);
        note(
            ui,
            format!(
                "Searched on {searched} of {rows} rows, drawn by the seed; constants are fitted to all."
            ),
        );
    }
    if let Some(paper) = &report.paper {
        let found = paper.formula.as_deref().unwrap_or("no formula");
        let reached = if paper.reached { "reached" } else { "not reached" };
        note(
            ui,
            format!(
                "As the paper of {} searched: {found}, size {}, R2 {:.5} after {} generations, stop at {} {reached}. \
                 The smaller error is that of the {} search.",
                paper.paper,
                paper.size,
                paper.fitness,
                paper.generations,
                paper.stop,
                report.found_by
            ),
        );
    }
    note(ui, format!("Digest {}: the same on the command line.", report.digest));
}

fn sheet(search: &FormulaSearch) -> Sheet {
    let titles = [
        "Size",
        "Error",
        "Error at rows left out",
        "Largest share of the target",
        "Formula",
        "Remark",
    ];
    let mut sheet = Sheet::new(titles);
    for row in search.rows() {
        sheet.row([
            (row.size as f64).into(),
            row.error.into(),
            row.left_out.into(),
            row.worst_share.into(),
            row.formula.as_str().into(),
            word(row).into(),
        ]);
    }
    sheet
}
