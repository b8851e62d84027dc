//! `steadycut papers --paper 2005`: the six methods of the 2005 paper on Experiment 2, beside its
//! Table 1, and its claims; with `--robustness` the same under changed
//! conditions, with `--beyond` what the product adds.

mod beyond;
mod print;
mod robustness;

use std::io::Write;
use std::process::ExitCode;

use serde::Serialize;
use serde_json::json;

use super::args::PapersArgs;
use super::{Outcome, progress};
use crate::run::job::Job;
use crate::study::compare::claims::{self, ControlClaim, Evidence};
use crate::study::compare::contest::ContestJob;
use crate::study::compare::cost::Replay;
use crate::study::compare::entrants::{self, Entrant};
use crate::study::compare::iterations::{IterationsJob, MANY_ITERATIONS};
use crate::study::compare::load_step::{self, Transient};
use crate::study::compare::table_1::{
    self, DISCLOSED, NOT_REACHED, TOLD_BY_VERSION, Table1Verdict,
};
use crate::study::compare::tournament::{Compared, Tournament};
use crate::study::errata::COMBINED_2005;

/// Passes of which the fastest counts, when a controller is timed.
const PASSES: usize = 5;
/// Seeds of Table 1, and of the robustness table.
const SEEDS: [u32; 2] = [20, 5];

/// What stands beside the table's columns of the optimisation step.
#[derive(Clone, Debug, Serialize)]
struct Step {
    transient: Transient,
    /// Cost of an update on this machine, ns.
    update_ns: f64,
}

/// All that the command prints.
struct Report {
    seeds: u32,
    table: Vec<Compared>,
    verdicts: Vec<Table1Verdict>,
    /// Who is best, and by how much.
    margin: Option<String>,
    /// The load step, N.
    load_step_n: [f64; 2],
    steps: Vec<Step>,
    claims: Vec<ControlClaim>,
}

pub fn execute(args: &PapersArgs) -> Outcome {
    if args.beyond {
        return beyond::execute(args.seeds.unwrap_or(SEEDS[0]), args.json);
    }
    if args.robustness {
        return robustness::execute(args.seeds.unwrap_or(SEEDS[1]), args.json);
    }
    let report = report(args.seeds.unwrap_or(SEEDS[0]), args.json)?;
    let mut out = std::io::stdout().lock();
    if args.json {
        let object = json!({
            "paper": "2005", "seeds": report.seeds, "printed": table_1::printed(),
            "methods": report.table, "verdicts": report.verdicts, "steps": report.steps,
            "claims": report.claims, "chosen_with_the_table_in_view": DISCLOSED,
            "not_reached": NOT_REACHED, "told_by_version": TOLD_BY_VERSION, "margin": report.margin,
            "errata": COMBINED_2005,
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&object)?)?;
    } else {
        print::report(&mut out, &report)?;
    }
    Ok(ExitCode::SUCCESS)
}

fn report(seeds: u32, quiet: bool) -> Result<Report, progress::NotDone> {
    let base = entrants::experiment_2();
    let methods = entrants::TABLE_1.iter().chain(entrants::BEYOND);
    let mut contest = ContestJob::new(methods.map(|method| method.on(&base)).collect(), seeds);
    progress::work(&mut contest, "Experiment 2", quiet)?;
    let each = contest.tournament().entrants().iter().zip(contest.transients());
    let steps = each.map(|(entrant, transient)| Step {
        transient: transient.clone(),
        update_ns: update_ns(entrant),
    });
    let steps: Vec<Step> = steps.collect();
    let table = contest.tournament().table();
    let load_step_n = load_step::forces_n(&base);
    let experiment_1 = Tournament::new(claims::both_on("experiment-1"), seeds);
    let mut iterations = IterationsJob::new(&base);
    progress::work(&mut iterations, "Iterations", quiet)?;
    let claims = claims::claims(&Evidence {
        experiment_1: &played(experiment_1, "Experiment 1", quiet)?,
        experiment_2: &table,
        transients: contest.transients(),
        load_step_n,
        iterations_needed: iterations.partial().unwrap_or(MANY_ITERATIONS),
    });
    Ok(Report {
        seeds,
        verdicts: table_1::verdicts(&table),
        margin: table_1::margin(&table, contest.transients()),
        table,
        load_step_n,
        steps,
        claims,
    })
}

/// The table of a tournament played to its end.
fn played(
    mut tournament: Tournament,
    what: &str,
    quiet: bool,
) -> Result<Vec<Compared>, progress::NotDone> {
    progress::work(&mut tournament, what, quiet)?;
    Ok(tournament.table())
}

/// Cost of an update of an entrant's controller on this machine, ns.
#[expect(clippy::disallowed_methods, reason = "the cost of an update needs a clock")]
fn update_ns(entrant: &Entrant) -> f64 {
    let replay = Replay::new(&entrant.scenario);
    let passes = (0..PASSES).map(|_| {
        let start = std::time::Instant::now();
        std::hint::black_box(replay.pass());
        start.elapsed().as_secs_f64()
    });
    let fastest_s = passes.fold(f64::INFINITY, f64::min);
    1e9 * fastest_s / replay.updates().max(1) as f64
}
