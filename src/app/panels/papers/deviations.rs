//! What a paper's own table says about its findings: final against desired values.

use egui::Ui;

use super::sheets;
use crate::app::command::Command;
use crate::app::format;
use crate::app::widgets::save_table::{SavedTable, TableOf, save_table};
use crate::app::widgets::scaffold;
use crate::app::widgets::touch;
use crate::base::language::{text, tr};
use crate::study::papers::{PaperRow, PaperTable};
use crate::study::published::PaperId;

fn off(is: f64, wanted: f64) -> f64 {
    100.0 * (is / wanted - 1.0)
}

/// A column: its title in English, and the deviation in a row in words.
type Column = (&'static str, fn(&PaperRow) -> String);
/// The columns of a paper.
pub type Columns = Vec<&'static Column>;

const RA: [Column; 2] = [
    (text!("Ra printed"), |row| format::deviation(row.ra_deviation_printed_percent)),
    (text!("Ra run"), |row| format::deviation(row.ra_deviation_reproduced_percent)),
];

/// Final against desired force; only Table 3 of 2007 prints the desired one.
const FORCE: [Column; 2] = [
    (text!("force printed"), |row| {
        let (end, wanted) = (&row.force_final_n, row.force_start_n.printed);
        let [printed, read] =
            [end.printed, end.reference].map(|is| format::deviation(off(is, wanted)));
        if printed == read {
            printed
        } else {
            tr!("{printed}\n({read} corrected)", printed = printed, read = read)
        }
    }),
    (text!("force run"), |row| {
        format::deviation(off(row.force_final_n.reproduced, row.force_start_n.reproduced))
    }),
];

/// What the paper finds, what its table says, and what the runs leave.
fn words(paper: PaperId, table: &PaperTable) -> String {
    match paper {
        PaperId::Sdnrp2007 => tr!(
            "The findings speak of at most 4.1 % in Ra and 5.2 % in force. Table 3 itself, final \
             value against desired value, says more: {extremes}. Proportional feedback leaves a steady-state \
             error. With the identified models the runs leave the same one.",
            extremes = extremes(table),
        ),
        PaperId::Strategy2013 => tr!(
            "Section 4 makes the difference between desired and simulated Ra the criterion and \
             finds the model \"efficient at gaining the desired surface roughness\", without a \
             figure for it. Table 1 itself gives one: {extremes}. Proportional feedback leaves a steady-state \
             error. With the identified models the runs leave one of the same kind: too rough in the \
             fine cuts, too fine in the rough ones.",
            extremes = extremes(table),
        ),
    }
}

/// The largest printed deviations of Ra either way, with their simulations.
fn extremes(table: &PaperTable) -> String {
    let deviation = |row: &&PaperRow| row.ra_deviation_printed_percent;
    let by = |a: &&PaperRow, b: &&PaperRow| deviation(a).total_cmp(&deviation(b));
    let (Some(low), Some(high)) = (table.rows.iter().min_by(by), table.rows.iter().max_by(by))
    else {
        return String::new();
    };
    tr!(
        "Ra is off by {high} in simulation {first} to {low} in simulation {second}",
        high = format::deviation(high.ra_deviation_printed_percent),
        first = high.sim,
        low = format::deviation(low.ra_deviation_printed_percent),
        second = low.sim,
    )
}

/// The section of the screen.
pub fn show(ui: &mut Ui, paper: PaperId, table: &PaperTable, commands: &mut Vec<Command>) {
    ui.add_space(10.0);
    ui.heading(tr("The paper's own deviations"));
    ui.label(words(paper, table));
    let force: &[Column] = if paper == PaperId::Sdnrp2007 { &FORCE } else { &[] };
    let columns: Columns = RA.iter().chain(force).collect();
    let grid = touch::grid(ui, "deviations").striped(true).min_col_width(24.0).spacing([12.0, 3.0]);
    let figures = |ui: &mut Ui| {
        ui.strong(tr("Sim"));
        columns.iter().for_each(|(title, _)| {
            ui.strong(tr(title));
        });
        ui.end_row();
        for row in &table.rows {
            ui.label(row.sim.to_string());
            columns.iter().for_each(|(_, text)| {
                ui.label(text(row));
            });
            ui.end_row();
        }
    };
    scaffold::across(ui, "deviations", |ui| {
        grid.show(ui, figures);
    });
    let what = format!("deviations-{}", paper.id());
    save_table(
        ui,
        &SavedTable { what: &what, of: TableOf::Nothing, partial: None },
        || sheets::deviations(&columns, table),
        commands,
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::cutting::process::ForceModel;
    use crate::models::genetic::Calibration;
    use crate::study::papers;

    fn identified(paper: PaperId) -> PaperTable {
        papers::table(paper, Calibration::Identified, ForceModel::Formula)
    }

    #[test]
    fn the_runs_of_2007_leave_the_deviations_that_are_printed() {
        let table = identified(PaperId::Sdnrp2007);
        for row in &table.rows {
            let [run, printed] =
                [row.ra_deviation_reproduced_percent, row.ra_deviation_printed_percent];
            assert!((run - printed).abs() < 3.0, "simulation {}: {run} %", row.sim);
        }
        assert_eq!(
            extremes(&table),
            "Ra is off by +31.6\u{a0}% in simulation 1 to \u{2212}22.4\u{a0}% in simulation 10"
        );
    }

    #[test]
    fn the_runs_of_2013_are_too_rough_in_fine_cuts_and_too_fine_in_rough_ones() {
        let table = identified(PaperId::Strategy2013);
        let (fine, rough) = table.rows.split_at(table.rows.len() / 2);
        assert!(fine.iter().all(|row| row.ra_deviation_reproduced_percent > 1.0));
        assert!(rough.iter().all(|row| row.ra_deviation_reproduced_percent < 0.0));
    }
}
