//! A plan as a sheet for a shop: a table with empty columns for what is measured, as CSV and as a page to print.

use std::fmt::Write as _;

use super::measure::MeasuredCut;
use super::plan::ExperimentPlan;
use crate::export::sheet::{Entry, Sheet};

/// Name of the column with the plan's name.
pub const PLAN: &str = "plan";
/// Name of the column with the number of a run in standard order.
pub const RUN: &str = "run";
/// Name of the column with the place of a run in the order of cutting.
pub const ORDER: &str = "order";
/// Name of the column for the measured force.
pub const FORCE: &str = "force_n";
/// Name of the column for the measured roughness.
pub const ROUGHNESS: &str = "ra_um";
/// Settings that a shop has to know where they are no factors: what is told of a plan, and so all that planning reads.
pub const TOLD_SETTINGS: &[&str] = &[
    "name",
    "tool.name",
    "tool.diameter_mm",
    "tool.teeth",
    "plant.material",
    "plant.hardness_hb",
    "plant.wear_factor",
    "workpiece.axial_depth_mm",
    "workpiece.radial_depth_mm",
    "program.feed_mm_min",
    "program.spindle_rpm",
];

fn number(value: Option<f64>) -> Entry {
    value.map_or(Entry::Empty, Entry::Number)
}

/// The sheet as CSV, a line for each run in the order of cutting; what was measured, in standard order, where it
/// was. `identify gp --data` reads it.
#[must_use]
pub fn csv(plan: &ExperimentPlan, measured: Option<&[MeasuredCut]>) -> String {
    let columns = plan.factors.iter().map(|factor| factor.kind.column());
    let titles = [ORDER, RUN].into_iter().chain(columns).chain([FORCE, ROUGHNESS, PLAN]);
    let mut sheet = Sheet::new(titles);
    for run in plan.in_order() {
        let cut = measured.and_then(|cuts| cuts.get(run.run - 1));
        let mut row = vec![Entry::Number(run.order as f64), Entry::Number(run.run as f64)];
        row.extend(plan.factors.iter().zip(&run.values).map(
            |(factor, value)| match factor.cutters() {
                Some(_) => Entry::Word(factor.text(*value)),
                None => Entry::Number(*value),
            },
        ));
        row.push(number(cut.and_then(|cut| cut.force_n)));
        row.push(number(cut.and_then(|cut| cut.ra_um)));
        row.push(Entry::Word(plan.id.clone()));
        sheet.row(row);
    }
    sheet.csv()
}

/// What stands above the table of a page.
#[derive(Clone, Debug, PartialEq)]
pub struct SheetHead {
    /// Title.
    pub title: String,
    /// What is the same in all cuts: name and value.
    pub fixed: Vec<(String, String)>,
    /// How the plan is made again.
    pub command: String,
}

/// Text without what a page would take for its own.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

const STYLE: &str = "body{font:14px/1.4 sans-serif;margin:2em;color:#000;background:#fff}\
h1{font-size:20px;margin:0 0 .3em}p{margin:.3em 0}code{font-size:12px;word-break:break-all}\
table{border-collapse:collapse;margin-top:1em;width:100%}\
th,td{border:1px solid #444;padding:.3em .5em;text-align:right}th{background:#eee}\
td.fill{min-width:6em;height:1.9em}dl{display:grid;grid-template-columns:max-content auto;gap:0 1em;margin:.5em 0}\
dt{font-weight:bold}dd{margin:0}thead{display:table-header-group}tr{break-inside:avoid}\
.signed{display:flex;gap:2em;margin:1em 0}.signed span{border-bottom:1px solid #444;flex:1}\
@media print{body{margin:0;font-size:11pt}@page{margin:15mm}}";

/// The sheet as one page that needs nothing besides: to be printed and filled in.
#[must_use]
pub fn html(plan: &ExperimentPlan, head: &SheetHead) -> String {
    let title = escaped(&head.title);
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n"
    );
    let _ = writeln!(
        page,
        "<p>{} cuts in random order; cut them in the order of the first column. Plan <strong>{}</strong>.</p>",
        plan.runs.len(),
        plan.id
    );
    page.push_str("<dl>\n");
    for (name, value) in &head.fixed {
        let _ = writeln!(page, "<dt>{}</dt><dd>{}</dd>", escaped(name), escaped(value));
    }
    page.push_str(
        "</dl>\n<p class=\"signed\"><span>Date</span><span>Machine</span><span>By</span></p>\n",
    );
    page.push_str("<table>\n<thead><tr><th>Order</th><th>Run</th>");
    for factor in &plan.factors {
        let unit = factor.kind.unit();
        let unit = if unit.is_empty() { String::new() } else { format!("<br>{unit}") };
        let _ = write!(page, "<th>{}{unit}</th>", escaped(factor.kind.label()));
    }
    page.push_str(
        "<th>Force<br>N</th><th>Ra<br>&micro;m</th><th>Remarks</th></tr></thead>\n<tbody>\n",
    );
    for run in plan.in_order() {
        let _ = write!(page, "<tr><td>{}</td><td>{}</td>", run.order, run.run);
        for (factor, value) in plan.factors.iter().zip(&run.values) {
            let _ = write!(page, "<td>{}</td>", escaped(&factor.text(*value)));
        }
        page.push_str(
            "<td class=\"fill\"></td><td class=\"fill\"></td><td class=\"fill\"></td></tr>\n",
        );
    }
    let _ = write!(
        page,
        "</tbody>\n</table>\n<p>Force: the largest of a revolution across the tool, in the steady cut. Ra: along the \
         feed.</p>\n<p>The plan is made again by <code>{}</code></p>\n</body>\n</html>\n",
        escaped(&head.command)
    );
    page
}
