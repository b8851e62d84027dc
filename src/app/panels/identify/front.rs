//! The front: error against size as a picture and as a table, where a formula is picked.

use egui::{Align, Button, Label, Layout, RichText, Role, Ui, WidgetInfo};

use super::front_plot;
use super::search::{FormulaSearch, FrontRow};
use super::symbols::{in_language, rounded, symbols, told_number};
use crate::app::command::Command;
use crate::app::panels::equation_cards::formula::typeset;
use crate::app::theme::{self, Palette};
use crate::app::widgets::save_table::{SavedTable, TableOf, save_table_of};
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::formula::Formula;
use crate::base::language::{text, tr};
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
    ui.horizontal_wrapped(|ui| {
        let title = tr("Front: the formula of the least error of each size");
        ui.label(RichText::new(title).strong());
        let work = search.work();
        let done = || work.progress().to_string();
        let partial = (!work.is_over()).then_some(&done as &dyn Fn() -> String);
        let of = TableOf::Named(&search.problem().target);
        let saved = SavedTable { what: "front", of, partial };
        save_table_of(ui, &saved, !search.rows().is_empty(), || sheet(search), commands);
    });
    if search.rows().is_empty() {
        ui.weak(tr("No formula has a finite value on all rows yet."));
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
            for (title, width) in [tr("size"), tr("error"), tr("left out")].into_iter().zip(CELLS) {
                cell(ui, width, |ui| {
                    ui.label(RichText::new(title).small().color(palette.weak));
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
        let equation = found.map(|found| in_language(&rounded(&found, DIGITS).equation(&words)));
        let equation = equation.unwrap_or_else(|_| row.formula.clone());
        let mut line = |ui: &mut Ui| {
            cell(ui, CELLS[0], |ui| {
                let button = Button::selectable(is, row.size.to_string());
                let least = touch::least(ui).max(egui::vec2(CELLS[0], 0.0));
                let response = ui.add(button.min_size(least));
                let label = tr!("Formula of size {size}", size = row.size);
                response
                    .widget_info(|| WidgetInfo::selected(Role::Button, true, is, label.clone()));
                if response.clicked() {
                    picked = Some(row.size);
                }
            });
            cell(ui, CELLS[1], |ui| {
                ui.label(told_number(row.error));
            });
            cell(ui, CELLS[2], |ui| {
                ui.label(row.left_out.map(told_number).unwrap_or_default());
            });
            cell(ui, CELLS[3], |ui| {
                sign(row).line(ui, RichText::new(tr(word(row))), egui::TextWrapMode::Extend);
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

/// What its sign says, in English.
fn word(row: &FrontRow) -> &'static str {
    match (row.chosen, row.exact, row.doubt) {
        (true, true, _) => text!("chosen, exact"),
        (true, false, _) => text!("chosen"),
        (false, true, _) => text!("exact"),
        (false, false, "") => "",
        (false, false, _) => text!("unsure"),
    }
}

/// What the signs mean, and what the paper's search has found.
fn notes(ui: &mut Ui, search: &FormulaSearch) {
    let palette = Palette::at(ui);
    let note = |ui: &mut Ui, text: String| {
        ui.add(Label::new(RichText::new(text).small().color(palette.weak)).wrap());
    };
    let Some(report) = search.report() else {
        let text = tr(
            "Errors are root mean squares of what is left over. At rows left out they are found once the \
                       search is over.",
        );
        return note(ui, text.to_owned());
    };
    let told = tr(report.left_out.unwrap_or(text!("nothing")));
    note(
        ui,
        tr!(
            "Left out: {rows}. Unsure: more than twice the least error there, or not certain to be finite.",
            rows = told
        ),
    );
    if report.searched_rows < report.rows {
        let (searched, rows) = (report.searched_rows, report.rows);
        note(
            ui,
            tr!(
                "Searched on {searched} of {n} rows, drawn by the seed; constants are fitted to all.",
                searched = searched,
                n = rows
            ),
        );
    }
    if let Some(paper) = &report.paper {
        let found = paper.formula.as_deref().map(in_language);
        let found = found.as_deref().unwrap_or(tr("no formula"));
        let by = match report.found_by {
            "paper" => tr("The smaller error is that of the paper search."),
            _ => tr("The smaller error is that of the default search."),
        };
        let reached = if paper.reached {
            tr!("stop at {stop} reached", stop = paper.stop)
        } else {
            tr!("stop at {stop} not reached", stop = paper.stop)
        };
        let searched = tr!(
            "As the paper of {paper} searched: {formula}, size {size}, R2 {fitness:.5} after {n} generations, {reached}.",
            paper = paper.paper,
            formula = found,
            size = paper.size,
            fitness = paper.fitness,
            n = paper.generations,
            reached = reached
        );
        note(ui, format!("{searched} {by}"));
    }
    let digest = tr!("Digest {digest}: the same on the command line.", digest = report.digest);
    note(ui, digest);
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
