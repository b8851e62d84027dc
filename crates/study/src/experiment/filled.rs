//! A sheet that a shop has filled in, read back: whether it belongs to the plan, what is missing, and the rows.

use serde::Serialize;

use super::measure::MeasuredCut;
use super::plan::{ExperimentPlan, PlannedRun};
use super::sheet::{FORCE, PLAN, ROUGHNESS, RUN};
use crate::csv_table::{ColumnNames, CsvRow, CsvTable};

/// Relative difference up to which a value of a factor is the planned one: spreadsheets may round.
const SAME: f64 = 1e-6;

/// A sheet as it was filled in.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FilledSheet {
    /// What was measured, run by run in standard order.
    pub cuts: Vec<MeasuredCut>,
    /// Runs without a force.
    pub without_force: Vec<usize>,
    /// Runs without a roughness.
    pub without_ra: Vec<usize>,
}

impl FilledSheet {
    /// Runs with neither.
    #[must_use]
    pub fn missing(&self) -> Vec<usize> {
        let both = self.without_force.iter().filter(|run| self.without_ra.contains(run));
        both.copied().collect()
    }

    /// Reads a sheet of a plan.
    ///
    /// # Errors
    /// Names the line, column and value that do not belong to the plan or cannot be measured values.
    pub fn read(text: &str, plan: &ExperimentPlan) -> Result<Self, String> {
        let factors: Vec<[&str; 1]> =
            plan.factors.iter().map(|factor| [factor.kind.column()]).collect();
        let mut columns: Vec<ColumnNames<'_>> = vec![&[PLAN], &[RUN], &[FORCE], &[ROUGHNESS]];
        columns.extend(factors.iter().map(<[&str; 1]>::as_slice));
        let table = CsvTable::parse(text, &columns)?;
        let mut cuts: Vec<Option<MeasuredCut>> = vec![None; plan.runs.len()];
        for row in &table.rows {
            let line = row.line;
            let run = belongs(&table, row, plan)?;
            let place = run.run - 1;
            if cuts[place].is_some() {
                return Err(format!("line {line}: run {} stands there twice", run.run));
            }
            let value = |place: usize| measured(&table, row, place, columns[place][0]);
            cuts[place] = Some(MeasuredCut { force_n: value(2)?, ra_um: value(3)?, problem: None });
        }
        let cuts: Vec<MeasuredCut> = cuts.into_iter().map(Option::unwrap_or_default).collect();
        let without = |of: fn(&MeasuredCut) -> Option<f64>| {
            let empty = cuts.iter().enumerate().filter(|(_, cut)| of(cut).is_none());
            empty.map(|(place, _)| place + 1).collect()
        };
        Ok(Self {
            without_force: without(|cut| cut.force_n),
            without_ra: without(|cut| cut.ra_um),
            cuts,
        })
    }
}

/// The run of a row.
fn belongs<'a>(
    table: &CsvTable,
    row: &CsvRow,
    plan: &'a ExperimentPlan,
) -> Result<&'a PlannedRun, String> {
    let line = row.line;
    if row.cells[0] != plan.id {
        let (other, own) = (&row.cells[0], &plan.id);
        return Err(format!(
            "line {line}: the row belongs to `{other}`, and this plan is `{own}`: give the factors, design and seed \
             that made the sheet"
        ));
    }
    let count = plan.runs.len();
    let run = table.number(&row.cells[1]).filter(|run| run.fract() == 0.0);
    let run = run.filter(|run| (1.0..=count as f64).contains(run)).ok_or_else(|| {
        format!("line {line}: `{RUN}` cannot be `{}`: allowed is 1 to {count}", row.cells[1])
    })?;
    let run = &plan.runs[run as usize - 1];
    for ((factor, planned), cell) in plan.factors.iter().zip(&run.values).zip(&row.cells[4..]) {
        let same = match factor.cutters() {
            Some(_) => *cell == factor.text(*planned),
            None => table
                .number(cell)
                .is_some_and(|value| (value - planned).abs() <= SAME * planned.abs().max(1.0)),
        };
        if !same {
            let (column, planned) = (factor.kind.column(), factor.text(*planned));
            return Err(format!(
                "line {line}: run {}: `{column}` is `{cell}`, planned was {planned}: cut it as planned, or give the \
                 table to `identify gp` as it is",
                run.run
            ));
        }
    }
    Ok(run)
}

fn measured(
    table: &CsvTable,
    row: &CsvRow,
    place: usize,
    column: &str,
) -> Result<Option<f64>, String> {
    let cell = &row.cells[place];
    if cell.is_empty() {
        return Ok(None);
    }
    let value = table.number(cell).filter(|value| value.is_finite() && *value > 0.0);
    let line = row.line;
    value.map(Some).ok_or_else(|| {
        format!(
            "line {line}: `{column}` cannot be `{cell}`: allowed is a positive number, or nothing where the cut was \
             not measured"
        )
    })
}
