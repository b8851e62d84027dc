//! The tables of this screen as files.

use super::deviations::Columns;
use super::table::columns;
use crate::app::format;
use crate::study::export::sheet::{Entry, Sheet};
use crate::study::papers::{CalibrationMet, PaperTable};
use crate::study::papers_2019;
use crate::study::published::PaperId;
use crate::study::train::claim::ForceClaim;

/// The table of a paper: of each cell what is printed, what it is compared with, what the run gave.
pub fn simulated(paper: PaperId, table: &PaperTable) -> Sheet {
    let columns = columns(paper);
    let of = |title: &str, unit: &str| {
        let unit = format::unit(unit);
        ["printed", "read", "run", "verdict"].map(|what| match what {
            "verdict" => format!("{title} verdict"),
            what => format!("{title} {what} [{unit}]"),
        })
    };
    let titles = columns.iter().flat_map(|column| of(column.title, column.unit));
    let mut sheet = Sheet::new(std::iter::once("Simulation".to_owned()).chain(titles));
    for row in &table.rows {
        let cells = columns.iter().flat_map(|column| {
            let cell = (column.cell)(row);
            let [printed, read, run] =
                [cell.printed, cell.reference, cell.reproduced].map(Entry::from);
            [printed, read, run, cell.verdict.id().into()]
        });
        sheet.row(std::iter::once(Entry::from(f64::from(row.sim))).chain(cells));
    }
    sheet
}

/// Final against desired values, as the screen has them.
pub fn deviations(columns: &Columns, table: &PaperTable) -> Sheet {
    let titles = columns.iter().map(|(title, _)| format!("{title} deviation"));
    let mut sheet = Sheet::new(std::iter::once("Simulation".to_owned()).chain(titles));
    for row in &table.rows {
        let words = columns.iter().map(|(_, text)| Entry::from(text(row).replace('\n', " ")));
        sheet.row(std::iter::once(Entry::from(f64::from(row.sim))).chain(words));
    }
    sheet
}

/// The rows of a table in all calibrations, as the screen has them.
pub fn calibrations(all: &[CalibrationMet]) -> Sheet {
    let of = |id: &str| [format!("{id} met"), format!("{id} of"), format!("{id} largest [bands]")];
    let titles = all.iter().flat_map(|calibration| of(calibration.calibration));
    let mut sheet = Sheet::new(std::iter::once("Simulation".to_owned()).chain(titles));
    for row in 0..all.first().map_or(0, |first| first.rows.len()) {
        let sim = Entry::from(f64::from(all[0].rows[row].sim));
        let cells = all.iter().flat_map(|calibration| {
            let row = &calibration.rows[row];
            [row.met as f64, row.of as f64, row.worst_bands].map(Entry::from)
        });
        sheet.row(std::iter::once(sim).chain(cells));
    }
    sheet
}

/// The claim about forces, as the screen has it.
pub fn claim(claim: &ForceClaim) -> Sheet {
    let mut sheet = Sheet::new([
        "Model",
        "What it is",
        "claimed [%]",
        "mean [%]",
        "median [%]",
        "95 % of the rows below [%]",
    ]);
    for contender in &claim.contenders {
        let errors = &contender.errors;
        sheet.row([
            contender.name.into(),
            contender.what.into(),
            contender.claimed_percent.into(),
            errors.mean_percent.into(),
            errors.median_percent.into(),
            errors.p95_percent.into(),
        ]);
    }
    sheet
}

/// Table 1 of 2019 beside its rules.
pub fn machine() -> Sheet {
    let mut sheet = Sheet::new([
        "Node",
        "m [kg]",
        "f [Hz]",
        "Q",
        "k printed [N/m]",
        "k by the rule [N/m]",
        "c printed [N s/m]",
        "c by the rule [N s/m]",
        "Verdict",
    ]);
    for row in papers_2019::table() {
        let numbers = [
            row.mass_kg,
            row.frequency_hz,
            row.quality,
            row.stiffness_printed_n_m,
            row.stiffness_rule_n_m,
            row.damping_printed_n_s_m,
            row.damping_rule_n_s_m,
        ];
        let numbers = numbers.map(Entry::from);
        let ends = [Entry::from(row.node)].into_iter().chain(numbers);
        sheet.row(ends.chain([row.verdict_text.into()]));
    }
    sheet
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::cutting::process::ForceModel;
    use crate::models::genetic::Calibration;
    use crate::study::papers;

    #[test]
    fn a_saved_table_holds_what_is_printed_and_what_the_run_gave() {
        let paper = PaperId::Sdnrp2007;
        let table = papers::table(paper, Calibration::Identified, ForceModel::Formula);
        let csv = simulated(paper, &table).csv();
        let lines: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
        assert_eq!(lines.len(), 1 + table.rows.len());
        let column = |title: &str| lines[0].iter().position(|of| *of == title).expect(title);
        let [printed, read] = ["printed", "read"].map(|s| column(&format!("Final force {s} [N]")));
        let [run, verdict] = [column("Produced Ra run [µm]"), column("Produced Ra verdict")];
        // Row 10 is the misprint of Table 3: 195.2 N printed, read as 190.2.
        assert_eq!([lines[10][printed], lines[10][read]], ["195.2", "190.2"]);
        for (line, row) in lines[1..].iter().zip(&table.rows) {
            assert_eq!(line[run].parse(), Ok(row.ra_produced_um.reproduced));
            assert_eq!(line[verdict], "met");
        }
    }

    #[test]
    fn the_table_of_2019_has_its_five_nodes_and_fourteen_digits() {
        let csv = machine().csv();
        assert_eq!(csv.lines().count(), 1 + papers_2019::table().len());
        let first = csv.lines().nth(1).expect("a row");
        let stiffness = papers_2019::table()[0].stiffness_rule_n_m.to_string();
        assert!(first.contains(&stiffness), "{first}");
    }
}
