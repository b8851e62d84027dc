//! The table itself: a grid on a desktop, a card for every row where it is narrow.

use egui::{Grid, RichText, Role, ScrollArea, TextWrapMode, Ui, WidgetInfo};

use crate::app::command::Command;
use crate::app::theme::{self, Palette};
use crate::base::model::gp::Calibration;
use crate::blocks::cutting::process::ForceModel;
use crate::run::edits::Edits;
use crate::run::scenario_file;
use crate::run::signals::FLAGS;
use crate::study::papers::{self, Cell, PaperRow, PaperTable, Verdict};
use crate::study::published::PaperId;

/// Size of type of units and verdicts.
const NOTE: f32 = 11.5;

/// A column of Table 3.
struct Column {
    title: &'static str,
    unit: &'static str,
    /// Digits after the point in the paper, at least.
    decimals: usize,
    /// Whether the residual is told in the unit; otherwise in percent.
    absolute: bool,
    cell: fn(&PaperRow) -> &Cell,
}

const COLUMNS: [Column; 8] = [
    Column {
        title: "Desired Ra",
        unit: "um",
        decimals: 2,
        absolute: true,
        cell: |row| &row.ra_desired_um,
    },
    Column {
        title: "Desired force",
        unit: "N",
        decimals: 1,
        absolute: false,
        cell: |row| &row.force_start_n,
    },
    Column {
        title: "Start feed",
        unit: "mm/min",
        decimals: 2,
        absolute: false,
        cell: |row| &row.feed_initial_mm_min,
    },
    Column {
        title: "Start speed",
        unit: "1/min",
        decimals: 0,
        absolute: false,
        cell: |row| &row.spindle_initial_rpm,
    },
    Column {
        title: "Final force",
        unit: "N",
        decimals: 1,
        absolute: false,
        cell: |row| &row.force_final_n,
    },
    Column {
        title: "Final feed",
        unit: "mm/min",
        decimals: 2,
        absolute: false,
        cell: |row| &row.feed_final_mm_min,
    },
    Column {
        title: "Final speed",
        unit: "1/min",
        decimals: 0,
        absolute: false,
        cell: |row| &row.spindle_final_rpm,
    },
    Column {
        title: "Produced Ra",
        unit: "um",
        decimals: 2,
        absolute: true,
        cell: |row| &row.ra_produced_um,
    },
];

/// The button that loads a row's scenario into the console, in the calibration that is shown.
fn load(ui: &mut Ui, row: &PaperRow, calibration: &str, commands: &mut Vec<Command>) {
    let name = format!("table3-{}", row.sim);
    let button = ui.button("Load");
    button.widget_info(|| WidgetInfo::labeled(Role::Button, true, format!("Load {name}")));
    let hint = format!("Opens the scenario {name} in the console");
    if button.on_hover_text(hint).clicked() {
        let calibration = Calibration::from_id(calibration).unwrap_or(Calibration::Identified);
        let mut scenario =
            papers::scenario(PaperId::Sdnrp2007, row.sim, calibration, ForceModel::Formula);
        if calibration != Calibration::Identified {
            scenario.info.name = format!("{name} ({})", calibration.label());
        }
        let text = scenario_file::write(&scenario, &Edits::none());
        commands.push(Command::LoadText { name, text });
        commands.push(Command::ShowScreen("console"));
    }
}

/// Residual and verdict of a cell in words.
fn verdict(cell: &Cell, column: &Column) -> String {
    let residual = if column.absolute {
        format!("{:+.3} {}", cell.residual, theme::unit(column.unit))
    } else {
        format!("{:+.2} %", cell.residual_percent)
    };
    match cell.verdict {
        Verdict::Given => "given".to_owned(),
        Verdict::Reported => residual,
        Verdict::Met => format!("{residual} met"),
        Verdict::Missed => format!("{residual} missed"),
    }
}

fn verdict_text(cell: &Cell, column: &Column, palette: &Palette) -> RichText {
    let text = RichText::new(verdict(cell, column)).size(NOTE);
    match cell.verdict {
        Verdict::Given | Verdict::Reported => text.color(palette.weak),
        Verdict::Met => text.color(palette.good),
        Verdict::Missed => text.color(palette.bad).strong(),
    }
}

/// What was printed; a misprint with what it is compared with.
fn printed(cell: &Cell, column: &Column) -> String {
    let as_printed = |x: f64| {
        let (exact, fixed) = (format!("{x}"), format!("{x:.*}", column.decimals));
        if exact.len() > fixed.len() { exact } else { fixed }
    };
    if cell.printed == cell.reference {
        as_printed(cell.printed)
    } else {
        format!("{} (read {})", as_printed(cell.printed), as_printed(cell.reference))
    }
}

/// States at the end of the run, in words.
fn states(row: &PaperRow) -> Option<String> {
    let words = row
        .out_of_range
        .iter()
        .map(|id| FLAGS.iter().find(|flag| flag.id == *id).map_or(*id, |flag| flag.label));
    let words: Vec<&str> = words.collect();
    (!words.is_empty()).then(|| format!("simulation {}: {}", row.sim, words.join(", ")))
}

fn remarks(ui: &mut Ui, row: &PaperRow) {
    let palette = Palette::at(ui);
    if let Some(note) = row.note {
        let text = format!("Simulation {}: {note}.", row.sim);
        ui.label(RichText::new(text).color(palette.warn));
    }
    if let Some(states) = states(row) {
        ui.label(RichText::new(format!("At the end of {states}.")).color(palette.bad));
    }
}

/// The table as a grid.
pub fn table(ui: &mut Ui, paper: &PaperTable, commands: &mut Vec<Command>) {
    let palette = Palette::at(ui);
    ui.label(RichText::new("In each cell: printed, then run; below: residual and verdict.").weak());
    ScrollArea::horizontal().id_salt("table").show(ui, |ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
        Grid::new("table3").striped(true).spacing([20.0, 6.0]).show(ui, |ui| {
            ui.strong("Sim");
            ui.label("");
            for column in &COLUMNS {
                ui.vertical(|ui| {
                    ui.strong(column.title);
                    let unit = theme::unit(column.unit);
                    ui.label(RichText::new(unit).size(NOTE).weak());
                });
            }
            ui.end_row();
            for row in &paper.rows {
                ui.strong(row.sim.to_string());
                load(ui, row, paper.calibration, commands);
                for column in &COLUMNS {
                    let cell = (column.cell)(row);
                    ui.vertical(|ui| {
                        ui.horizontal(|ui| {
                            ui.label(RichText::new(printed(cell, column)).color(palette.weak));
                            if cell.verdict != Verdict::Given {
                                ui.strong(theme::number(cell.reproduced, column.unit));
                            }
                        });
                        ui.label(verdict_text(cell, column, palette));
                    });
                }
                ui.end_row();
            }
        });
    });
    paper.rows.iter().for_each(|row| remarks(ui, row));
}

/// The figures of one row, a line for each column of the table.
fn figures(ui: &mut Ui, row: &PaperRow) {
    let palette = Palette::at(ui);
    Grid::new(("row", row.sim)).min_col_width(20.0).spacing([7.0, 2.0]).show(ui, |ui| {
        for title in ["", "printed", "run", "residual"] {
            ui.label(RichText::new(title).size(NOTE).weak());
        }
        ui.end_row();
        for column in &COLUMNS {
            let cell = (column.cell)(row);
            let unit = theme::unit(column.unit);
            ui.label(RichText::new(format!("{}, {unit}", column.title)).size(NOTE));
            ui.label(printed(cell, column).replace(" (", "\n("));
            ui.strong(theme::number(cell.reproduced, column.unit));
            ui.label(verdict_text(cell, column, palette));
            ui.end_row();
        }
    });
}

/// The table as a card for every row.
pub fn cards(ui: &mut Ui, paper: &PaperTable, commands: &mut Vec<Command>) {
    let palette = Palette::at(ui);
    for row in &paper.rows {
        theme::card(palette).show(ui, |ui| {
            ui.set_width(ui.available_width());
            ui.horizontal(|ui| {
                ui.strong(format!("Simulation {}", row.sim));
                load(ui, row, paper.calibration, commands);
            });
            // A card is never wider than the window; its figures may be.
            ScrollArea::horizontal().id_salt(("row", row.sim)).show(ui, |ui| figures(ui, row));
            remarks(ui, row);
        });
    }
}

/// Deviation of the final from the desired values in percent: printed, and in the runs.
pub fn deviations(ui: &mut Ui, paper: &PaperTable) {
    let percent = |is: f64, wanted: f64| format!("{:+.1} %", 100.0 * (is / wanted - 1.0));
    let grid = Grid::new("deviations").striped(true).min_col_width(24.0).spacing([12.0, 3.0]);
    let figures = |ui: &mut Ui| {
        for title in ["Sim", "Ra printed", "Ra run", "force printed", "force run"] {
            ui.strong(title);
        }
        ui.end_row();
        for row in &paper.rows {
            let (ra, force) = (&row.ra_produced_um, &row.force_final_n);
            ui.label(row.sim.to_string());
            ui.label(percent(ra.printed, row.ra_desired_um.printed));
            ui.label(percent(ra.reproduced, row.ra_desired_um.reproduced));
            let printed = percent(force.printed, row.force_start_n.printed);
            let read = percent(force.reference, row.force_start_n.printed);
            ui.label(if printed == read { printed } else { format!("{printed}\n(read {read})") });
            ui.label(percent(force.reproduced, row.force_start_n.reproduced));
            ui.end_row();
        }
    };
    ScrollArea::horizontal().id_salt("deviations").show(ui, |ui| grid.show(ui, figures));
}
