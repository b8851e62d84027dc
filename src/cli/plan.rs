//! `steadycut plan`: the best feed and speed for a scenario's cut.

use std::io::Write;
use std::process::ExitCode;

use serde::Serialize;

use super::args::PlanArgs;
use super::files::report as report_to;
use super::scenarios::{apply, load};
use super::{Outcome, own, part, progress};
use crate::run::edits::Edits;
use crate::run::scenario_file;
use crate::study::plan::PlanJob;
use crate::study::plan::constraints::{Checked, ORIGIN};
use crate::study::plan::field::exhaustive;
use crate::study::plan::machine::{MachineLimits, Source};
use crate::study::plan::optimum::{Optimum, PlanVerdict};
use crate::study::plan::over_depths::OverDepths;
use crate::study::plan::remarks::{Remark, remarks};
use crate::study::plan::swarm::Iteration;
use crate::study::train::data::NOTE;
use crate::study::uses::Reader;

/// Points per axis of the exhaustive search printed beside the swarm.
const GRID: usize = 200;

/// The JSON object of a plan.
#[derive(Serialize)]
struct Report<'a> {
    scenario: &'a str,
    machine: &'a MachineLimits,
    verdict: PlanVerdict,
    verdict_text: String,
    /// Ids of the constraints that bind, or that are violated where nothing is feasible.
    active: Vec<&'static str>,
    optimum: &'a Optimum,
    iterations: u32,
    evaluations: u64,
    history: &'a [Iteration],
    grid: &'a Optimum,
    grid_evaluations: u64,
    constraints_origin: &'static str,
    remarks: Vec<Remark>,
    /// The planned feed and speed at all depths of the part, by the network and in the run.
    over_depths: OverDepths,
}

/// Runs the command.
pub fn execute(args: &PlanArgs) -> Outcome {
    let (mut scenario, edits) = load(&args.scenario)?;
    let mut brought = own::take(&mut scenario, Some(&args.own_cut), None, None)?;
    let machine = own::planned_machine(&mut scenario, args.machine.as_ref(), &mut brought)?;
    apply(&mut scenario, &args.set)?;
    part::take(&mut scenario, args.part.as_ref(), &args.set)?;
    let reader = if args.per_cut.is_some() { Reader::PlanPerCut } else { Reader::Plan };
    own::all_used(reader, &scenario, &Edits::none(), &args.set, &brought)?;
    if let Some(sized_by) = args.per_cut {
        return super::schedule::execute(args, &scenario, &edits, &machine, sized_by);
    }
    let mut out = report_to(args.json, args.out.as_ref())?;
    let mut job = PlanJob::on(&scenario, &machine)?;
    progress::work(&mut job, "plan", args.json)?;
    let optimum = job.optimum();
    let grid = exhaustive(job.problem(), GRID, GRID);
    let over_depths = OverDepths::of(&scenario, &machine, &optimum);
    let machine = machine.within(&scenario.cnc);
    let report = Report {
        scenario: &scenario.info.name,
        machine: &machine,
        verdict: optimum.verdict(),
        verdict_text: over_depths.verdict_text(&optimum),
        active: optimum.active().map(|one| one.constraint.id).collect(),
        optimum: &optimum,
        iterations: job.counts().iteration,
        evaluations: job.counts().evaluations,
        history: job.history(),
        grid: &Optimum::at(job.problem(), grid.point),
        grid_evaluations: grid.evaluations,
        constraints_origin: ORIGIN,
        remarks: remarks(&scenario),
        over_depths,
    };
    if args.json {
        writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?;
    } else {
        print(&mut out, &report)?;
    }
    if let Some(path) = &args.out {
        if !optimum.feasible {
            return Err(format!("{path}: not written: {}", report.verdict_text).into());
        }
        let text = scenario_file::write(&optimum.apply(&scenario)?, &edits);
        path.write(&text)?;
        if !args.json {
            writeln!(out, "scenario with these programmed values written to {path}")?;
        }
    }
    // Nothing feasible is a finding about the cut, not an error of the program.
    Ok(if optimum.feasible { ExitCode::SUCCESS } else { ExitCode::from(1) })
}

fn print(out: &mut impl Write, report: &Report) -> std::io::Result<()> {
    let o = report.optimum;
    writeln!(out, "{}: {}", report.scenario, report.verdict_text)?;
    let [x, y, z] = o.components_n;
    let lines = [
        ("programmed feed", format!("{:.2} mm/min", o.feed_mm_min)),
        ("programmed speed", format!("{:.1} 1/min", o.speed_rpm)),
        ("cutting speed", format!("{:.2} m/min", o.cutting_speed_m_min)),
        ("feed per tooth", format!("{:.4} mm", o.feed_per_tooth_mm)),
        ("force", format!("{:.1} N (x {x:.1}, y {y:.1}, z {z:.1})", o.force_n)),
        ("removal rate", format!("{:.3} cm3/min", o.removal_rate_cm3_min)),
        ("time at this feed", format!("{:.2} s", o.time_s)),
        ("  with tool changes", format!("{:.2} s", o.production_time_s)),
        ("cost of cut", format!("{:.4}", o.cost)),
    ];
    for (name, value) in lines {
        writeln!(out, "  {name:<24}{value}")?;
    }
    writeln!(out, "\n{}", report.over_depths.title())?;
    for line in report.over_depths.lines() {
        writeln!(out, "  {line}")?;
    }
    writeln!(
        out,
        "\nconstraints at {} mm depth ({})",
        o.axial_depth_mm, report.constraints_origin
    )?;
    for one in &o.constraints {
        constraint(out, one)?;
    }
    let first = report.history.iter().position(|iteration| iteration.best.feasible());
    let last = report.history.last().map_or(0.0, |iteration| iteration.feasible_share);
    writeln!(out, "\nconvergence")?;
    let reached = match o.feasible {
        true => format!("{:.5}", o.score.value),
        false => format!("violation {:.5}", o.score.violation),
    };
    writeln!(
        out,
        "  swarm: {reached} after {} iterations, {} evaluations{}; {:.0} % of particles feasible",
        report.iterations,
        report.evaluations,
        first.map_or(String::new(), |i| format!(", feasible from iteration {i}")),
        100.0 * last,
    )?;
    let grid = report.grid;
    let place = format!(
        "at {:.2} m/min and {:.4} mm, {} evaluations",
        grid.cutting_speed_m_min, grid.feed_per_tooth_mm, report.grid_evaluations
    );
    if grid.feasible && o.feasible {
        let gap = 100.0 * (o.score.value / grid.score.value - 1.0);
        writeln!(out, "  grid:  {:.5} {place}; swarm {gap:+.3} %", grid.score.value)?;
    } else {
        writeln!(out, "  grid:  violation {:.5} {place}", grid.score.violation)?;
    }
    writeln!(out, "\nThe force comes from a network. {NOTE}")?;
    if !o.inside_training_data {
        writeln!(
            out,
            "\nThe network does not know this cut: material, hardness or depths lie outside its \
             training data, and the force is continued."
        )?;
    }
    let placeholders = o.constraints.iter().filter(|one| one.source == Source::Placeholder).count();
    if placeholders > 0 {
        writeln!(
            out,
            "\n{placeholders} of 7 limits are placeholders: no public data of a {} were found. Give \
             your machine's with --machine FILE.toml.",
            report.machine.name
        )?;
    }
    writeln!(out, "Costs, tool life and process limits are chosen values.")?;
    report.remarks.iter().try_for_each(|remark| writeln!(out, "{}.", remark.text))
}

fn constraint(out: &mut impl Write, one: &Checked) -> std::io::Result<()> {
    let text = one.constraint;
    let limits = match (one.low, one.high) {
        (Some(low), Some(high)) => format!("{low} to {high}"),
        (Some(low), None) => format!("at least {low}"),
        (None, Some(high)) => format!("at most {}", rounded(high)),
        (None, None) => "no limit".to_owned(),
    };
    let state = match (one.violation > 0.0, one.binding) {
        (true, _) => "VIOLATED",
        (false, true) => "binding",
        (false, false) => "",
    };
    writeln!(
        out,
        "  {:<28}{:>9} {:<7}{:<16}{:>+8.1} %  {:<12}{state}",
        text.label,
        rounded(one.value),
        text.unit,
        limits,
        one.margin_percent,
        one.source.id(),
    )?;
    writeln!(out, "      {}: {}", text.formula, text.why)
}

/// About four significant digits.
fn rounded(x: f64) -> String {
    match x.abs() {
        size if size >= 1000.0 => format!("{x:.0}"),
        size if size >= 10.0 => format!("{x:.1}"),
        size if size >= 0.1 => format!("{x:.3}"),
        _ => format!("{x:.5}"),
    }
}
