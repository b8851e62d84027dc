//! The table itself: a grid on a desktop, a card for every row where it is narrow.

use egui::{RichText, Role, TextWrapMode, Ui, WidgetInfo};

use super::Shown;
use crate::app::command::{Command, SessionCommand, ShellCommand};
use crate::app::format;
use crate::app::theme::{self, Palette};
use crate::app::widgets::scaffold;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::{decimal, text, tr};
use crate::models::genetic::Calibration;
use crate::run::diagram::Names;
use crate::run::edits::Edits;
use crate::run::scenario_file;
use crate::run::signals::FLAGS;
use crate::study::papers::{self, Cell, CellVerdict, PaperRow, PaperTable};
use crate::study::published::PaperId;

/// A column of a table.
pub struct PaperColumn {
    /// Its title, in English.
    pub title: &'static str,
    /// Unit of its values.
    pub unit: &'static str,
    /// Digits after the point in the paper, at least.
    decimals: usize,
    /// Its cell of a row.
    pub cell: fn(&PaperRow) -> &Cell,
}

impl PaperColumn {
    /// Whether the residual is shown in the unit; otherwise in percent.
    fn absolute(&self) -> bool {
        self.unit == "um"
    }
}

type Read = fn(&PaperRow) -> &Cell;

/// The columns, as in the paper.
pub fn columns(paper: PaperId) -> [PaperColumn; 8] {
    let columns: [(&'static str, &'static str, usize, Read); 8] = [
        (text!("Desired Ra"), "um", 2, |row| &row.ra_desired_um),
        (paper.start_force(), "N", 1, |row| &row.force_start_n),
        (text!("Start feed"), "mm/min", 2, |row| &row.feed_initial_mm_min),
        (text!("Start speed"), "1/min", 0, |row| &row.spindle_initial_rpm),
        (text!("Final force"), "N", 1, |row| &row.force_final_n),
        (text!("Final feed"), "mm/min", 2, |row| &row.feed_final_mm_min),
        (text!("Final speed"), "1/min", 0, |row| &row.spindle_final_rpm),
        (text!("Produced Ra"), "um", 2, |row| &row.ra_produced_um),
    ];
    columns.map(|(title, unit, decimals, cell)| PaperColumn { title, unit, decimals, cell })
}
/// The button that loads a row's scenario into the console, in the calibration and with the force
/// model that are shown.
fn load(ui: &mut Ui, shown: Shown, row: &PaperRow, commands: &mut Vec<Command>) {
    let Shown { paper, calibration, force_model } = shown;
    let name = paper.preset(row.sim);
    let button = ui.button(tr("Load"));
    button.widget_info(|| WidgetInfo::labeled(Role::Button, true, tr!("Load {name}", name = name)));
    let hint = tr!("Opens the scenario {name} in the console", name = name);
    if button.on_hover_text(hint).clicked() {
        let mut scenario = papers::scenario(paper, row.sim, calibration, force_model);
        let mut changed = Vec::new();
        if calibration != Calibration::Identified {
            changed.push(calibration.label());
        }
        if !force_model.is_formula() {
            changed.push(force_model.label());
        }
        if !changed.is_empty() {
            let named = format!("{name} ({})", changed.join(", "));
            scenario.change(|s| s.info.name = named).expect("these names are short");
        }
        let text = scenario_file::write(&scenario, &Edits::none());
        commands.push(Command::Session(SessionCommand::LoadText { name, text }));
        commands.push(Command::Shell(ShellCommand::ShowScreen("console")));
    }
}

/// Residual and verdict of a cell in words.
fn verdict(cell: &Cell, column: &PaperColumn) -> String {
    let residual = if column.absolute() {
        format::beside(
            format::signed(decimal(format!("{:+.3}", cell.residual))),
            &format::unit(column.unit),
        )
    } else {
        format::beside(format::signed(decimal(format!("{:+.2}", cell.residual_percent))), "%")
    };
    match cell.verdict {
        CellVerdict::Given => tr("given").to_owned(),
        CellVerdict::Reported => residual,
        CellVerdict::Met => tr!("{residual} met", residual = residual),
        CellVerdict::Missed => tr!("{residual} missed", residual = residual),
    }
}

fn verdict_line(ui: &mut Ui, cell: &Cell, column: &PaperColumn) {
    let text = verdict(cell, column);
    match cell.verdict {
        CellVerdict::Given | CellVerdict::Reported => {
            ui.label(RichText::new(text).small().color(Palette::at(ui).weak))
        }
        CellVerdict::Met => Standing::Good.label(ui, &text, RichText::small),
        CellVerdict::Missed => Standing::Bad.label(ui, &text, |text| text.small().strong()),
    };
}

/// What was printed; a misprint with what it is compared with.
fn printed(cell: &Cell, column: &PaperColumn) -> String {
    let as_printed = |x: f64| {
        let (exact, fixed) = (format!("{x}"), format!("{x:.*}", column.decimals));
        decimal(if exact.len() > fixed.len() { exact } else { fixed })
    };
    if cell.printed == cell.reference {
        as_printed(cell.printed)
    } else {
        tr!(
            "{printed} (compared with {read})",
            printed = as_printed(cell.printed),
            read = as_printed(cell.reference),
        )
    }
}

/// States at the end of the run, in words.
fn states(shown: Shown, row: &PaperRow) -> Option<String> {
    let names = Names::both(shown.paper.model_set(), shown.force_model);
    let word = |id: &&str| match FLAGS.iter().find(|flag| flag.id == *id) {
        Some(flag) => names.flag(flag),
        None => id.replace('_', " "),
    };
    let words: Vec<String> = row.out_of_range.iter().map(word).collect();
    (!words.is_empty()).then(|| {
        tr!(
            "At the end of simulation {number}: {states}.",
            number = row.sim,
            states = words.join(", "),
        )
    })
}

fn remarks(ui: &mut Ui, shown: Shown, row: &PaperRow) {
    if let Some(note) = row.note {
        let text = tr!("Simulation {number}: {note}.", number = row.sim, note = tr(note));
        Standing::Watch.label(ui, &text, |text| text);
    }
    if let Some(states) = states(shown, row) {
        Standing::Bad.label(ui, &states, |text| text);
    }
}

/// Why the force at the start has no verdict, where it has none.
fn about_start(ui: &mut Ui, paper: PaperId) {
    if paper == PaperId::Strategy2013 {
        let text = tr!(
            "{force}: without a verdict, the paper does not say how it gets it.",
            force = tr(paper.start_force()),
        );
        ui.label(RichText::new(text).weak());
    }
}

/// The table as a grid.
pub fn table(ui: &mut Ui, shown: Shown, table: &PaperTable, commands: &mut Vec<Command>) {
    let palette = Palette::at(ui);
    let columns = columns(shown.paper);
    let text = tr("In each cell: printed, then run; below: residual and verdict.");
    ui.label(RichText::new(text).weak());
    about_start(ui, shown.paper);
    scaffold::across(ui, "table", |ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
        touch::grid(ui, "rows").striped(true).spacing([20.0, 6.0]).show(ui, |ui| {
            ui.strong(tr("Sim"));
            ui.label("");
            for column in &columns {
                ui.vertical(|ui| {
                    ui.strong(tr(column.title));
                    let unit = format::unit(column.unit);
                    ui.label(RichText::new(unit).small().weak());
                });
            }
            ui.end_row();
            for row in &table.rows {
                ui.strong(row.sim.to_string());
                load(ui, shown, row, commands);
                for column in &columns {
                    let cell = (column.cell)(row);
                    ui.vertical(|ui| {
                        ui.horizontal(|ui| {
                            ui.label(RichText::new(printed(cell, column)).color(palette.weak));
                            if cell.verdict != CellVerdict::Given {
                                ui.strong(format::number(cell.reproduced, column.unit));
                            }
                        });
                        verdict_line(ui, cell, column);
                    });
                }
                ui.end_row();
            }
        });
    });
    table.rows.iter().for_each(|row| remarks(ui, shown, row));
}

/// The figures of one row, a line for each column of the table.
fn figures(ui: &mut Ui, paper: PaperId, row: &PaperRow) {
    let columns = columns(paper);
    touch::grid(ui, ("row", row.sim)).min_col_width(20.0).spacing([7.0, 2.0]).show(ui, |ui| {
        for title in ["", tr("printed"), tr("run"), tr("residual")] {
            ui.label(RichText::new(title).small().weak());
        }
        ui.end_row();
        for column in &columns {
            let cell = (column.cell)(row);
            let unit = format::unit(column.unit);
            ui.label(RichText::new(format!("{}, {unit}", tr(column.title))).small());
            ui.label(printed(cell, column).replace(" (", "\n("));
            ui.strong(format::number(cell.reproduced, column.unit));
            verdict_line(ui, cell, column);
            ui.end_row();
        }
    });
}

/// The table as a card for every row.
pub fn cards(ui: &mut Ui, shown: Shown, table: &PaperTable, commands: &mut Vec<Command>) {
    let palette = Palette::at(ui);
    about_start(ui, shown.paper);
    for row in &table.rows {
        theme::card(palette).show(ui, |ui| {
            ui.set_width(ui.available_width());
            ui.horizontal(|ui| {
                ui.strong(tr!("Simulation {number}", number = row.sim));
                load(ui, shown, row, commands);
            });
            // A card is never wider than the window; its figures may be.
            scaffold::across(ui, ("row", row.sim), |ui| figures(ui, shown.paper, row));
            remarks(ui, shown, row);
        });
    }
}
