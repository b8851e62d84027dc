//! How far the rows of a table are met in every calibration, side by side.

use egui::{RichText, Ui};

use super::sheets;
use crate::app::command::Command;
use crate::app::jobs::Work;
use crate::app::theme::Palette;
use crate::app::widgets::save_table::{SavedTable, TableOf, save_table};
use crate::app::widgets::scaffold;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::tr;
use crate::models::genetic::Calibration;
use crate::study::papers::{CalibrationMet, CalibrationsJob, RowMet};
use crate::study::published::PaperId;

/// A calibration's label as a heading.
fn heading(id: &'static str) -> String {
    let option = Calibration::OPTIONS.iter().find(|option| option.id == id);
    let label = option.map_or(id, |option| tr(option.label));
    let mut letters = label.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

fn cell(ui: &mut Ui, row: &RowMet) {
    let text =
        tr!("{met} of {all}, {worst:.1}", met = row.met, all = row.of, worst = row.worst_bands,);
    Standing::either(row.met == row.of).label(ui, &text, |text| text);
}

fn rows(ui: &mut Ui, all: &[CalibrationMet]) {
    ui.strong(tr("Sim"));
    for calibration in all {
        ui.strong(heading(calibration.calibration));
    }
    ui.end_row();
    for row in 0..all.first().map_or(0, |first| first.rows.len()) {
        ui.label(all[0].rows[row].sim.to_string());
        all.iter().for_each(|calibration| cell(ui, &calibration.rows[row]));
        ui.end_row();
    }
    ui.strong(tr("all"));
    for calibration in all {
        let [met, of] = calibration.met();
        ui.strong(tr!("{met} of {all}", met = met, all = of));
    }
    ui.end_row();
}

/// The section of the screen.
pub fn show(
    ui: &mut Ui,
    paper: PaperId,
    work: &Work<CalibrationsJob>,
    commands: &mut Vec<Command>,
) {
    ui.add_space(10.0);
    ui.heading(tr("The calibrations side by side"));
    ui.label(tr(
        "In each cell: final values of the row within their bands, and the largest residual in bands. Plant and \
         controller have the same calibration, the plant's force is the formula's.",
    ));
    let all = work.partial();
    if !work.is_over() {
        let text = tr!("{progress} done.", progress = work.progress().to_string());
        ui.label(RichText::new(text).color(Palette::at(ui).accent));
        return;
    }
    let grid =
        touch::grid(ui, "calibrations").striped(true).min_col_width(24.0).spacing([12.0, 3.0]);
    scaffold::across(ui, "calibrations", |ui| {
        grid.show(ui, |ui| rows(ui, &all));
    });
    let what = format!("calibrations-{}", paper.id());
    save_table(
        ui,
        &SavedTable { what: &what, of: TableOf::Nothing, partial: None },
        || sheets::calibrations(&all),
        commands,
    );
}
