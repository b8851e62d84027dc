//! `steadycut experiment`: which cuts to make, and what they tell.

pub mod args;
mod told;
mod way;

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use self::args::{DesignArg, ExperimentArgs, ExperimentWhat};
use self::told::{fixed, print_assessment, print_measured, print_plan};
use super::files::report as report_to;
use super::scenarios::{apply, load};
use super::{Outcome, given, part, progress};
use crate::run::scenario::{Scenario, param};
use crate::study::experiment::assess::{ExperimentAssessment, MeasuringNoise, assess};
use crate::study::experiment::design::StarDistance;
use crate::study::experiment::factor::{ExperimentFactor, FactorKind};
use crate::study::experiment::filled::FilledSheet;
use crate::study::experiment::fraction::RegularFraction;
use crate::study::experiment::measure::{MeasureJob, MeasuredCut};
use crate::study::experiment::plan::{ExperimentDesign, ExperimentPlan, PlanRequest};
use crate::study::experiment::sheet::{SheetHead, csv, html};
use crate::study::experiment::terms::TermSet;
use crate::study::uses::Reader;

/// Points of a Latin hypercube, and runs in the middle of a composite design, without a number.
const POINTS: u32 = 20;
const CENTRE: u32 = 4;

/// Why a way of changing depths is no part of it.
const STEADY: &str =
    "every cut is short, straight and of one depth, that of the scenario or of a factor";

type Fallible<T> = Result<T, Box<dyn std::error::Error>>;

pub fn execute(args: &ExperimentArgs) -> Outcome {
    if let Some(ExperimentWhat::Way(args)) = &args.what {
        return way::execute(args);
    }
    let mut files = [args.out.as_ref(), args.page.as_ref()].into_iter().flatten();
    let mut out = report_to(args.json, files.find(|path| path.is_stdout()))?;
    let (scenario, plan) = match &args.table {
        Some(path) => {
            let plan = ExperimentPlan::given(&path.text()?);
            (None, plan.map_err(|problem| format!("{path}: {problem}"))?)
        }
        None => {
            let scenario = scenario(args)?;
            let plan = planned(args, &scenario)?;
            (Some(scenario), plan)
        }
    };
    let noise = MeasuringNoise { force_n: args.noise, ra_um: args.ra_noise };
    let terms = match args.term.is_empty() {
        true => TermSet::declared(args.model, &plan).map_err(|e| format!("--model: {e}"))?,
        false => TermSet::own(&args.term, &plan).map_err(|e| format!("--term: {e}"))?,
    };
    let assessment = assess(&plan, &terms, noise);
    let filled = match &args.read {
        Some(path) => {
            let filled = FilledSheet::read(&path.text()?, &plan);
            Some(filled.map_err(|problem| format!("{path}: {problem}"))?)
        }
        None => None,
    };
    let measured = match (&filled, &scenario) {
        (Some(filled), _) => Some(filled.cuts.clone()),
        (None, Some(scenario)) if args.run => Some(cut(args, scenario, &plan, noise)?),
        (None, _) => None,
    };
    if let Some(path) = &args.out {
        path.write(&passed_on(args, &plan, measured.as_deref()))?;
    }
    if let (Some(path), Some(scenario)) = (&args.page, &scenario) {
        path.write(&html(&plan, &head(scenario, &plan)))?;
    }
    if args.json {
        let report = to_json(&plan, scenario.as_ref(), &assessment, measured.as_deref());
        writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?;
    } else {
        print_plan(&mut out, &plan, scenario.as_ref(), &assessment.leverages)?;
        print_assessment(&mut out, &plan, &assessment)?;
        if let Some(measured) = &measured {
            print_measured(&mut out, &plan, measured)?;
        }
        let files = [args.out.as_ref(), args.page.as_ref()];
        for path in files.into_iter().flatten() {
            writeln!(out, "written: {path}")?;
        }
    }
    let whole =
        filled.is_none_or(|filled| filled.without_force.is_empty() && filled.without_ra.is_empty());
    Ok(if whole { ExitCode::SUCCESS } else { ExitCode::from(1) })
}

/// The cut that is varied, with its `--set`s.
fn scenario(args: &ExperimentArgs) -> Fallible<Scenario> {
    let reader = if args.run { Reader::ExperimentRun } else { Reader::Experiment };
    let (mut scenario, edits) = load(&args.scenario)?;
    given::no_edits(reader, &scenario.info.name, &edits)?;
    apply(&mut scenario, &args.set)?;
    part::refuse(reader, args.part.as_ref(), STEADY)?;
    given::all_used(reader, &scenario, &edits, &args.set)?;
    Ok(scenario)
}

fn planned(args: &ExperimentArgs, scenario: &Scenario) -> Fallible<ExperimentPlan> {
    let read = |text: &String| {
        ExperimentFactor::read(text, scenario).map_err(|problem| format!("--factor {problem}"))
    };
    let factors: Vec<ExperimentFactor> = args.factor.iter().map(read).collect::<Result<_, _>>()?;
    let paths: Vec<&str> = factors.iter().map(|factor| factor.kind.path()).collect();
    given::once("--factor", &paths, &args.set)?;
    if factors.iter().any(|factor| factor.kind == FactorKind::Cutter) {
        for set in &args.set {
            let path = &param(set.split_once('=').map_or(set.as_str(), |(path, _)| path))?.path;
            if path.starts_with("tool.") {
                return Err(
                    format!("--factor tool and --set {path} say the same: leave one out").into()
                );
            }
        }
    }
    let repeated = args.design == DesignArg::Composite;
    let numbers = factors.iter().filter(|factor| !repeated || factor.kind != FactorKind::Cutter);
    let design = design(args, numbers.count())?;
    let centre = match design {
        ExperimentDesign::Composite { .. } => args.centre.unwrap_or(CENTRE),
        ExperimentDesign::Full { .. }
        | ExperimentDesign::Fraction(_)
        | ExperimentDesign::Hypercube { .. } => args.centre.unwrap_or(0),
    };
    let request = PlanRequest {
        factors,
        design,
        centre: centre as usize,
        replicates: args.replicates as usize,
        seed: args.seed,
    };
    let plan = ExperimentPlan::new(&request).map_err(|problem| format!("plan: {problem}"))?;
    // Every cut goes with the scenario, whether the simulator is to make it or a shop.
    plan.runs.iter().try_for_each(|run| plan.scenario(scenario, run).map(drop))?;
    Ok(plan)
}

/// The design; options of another one are refused.
fn design(args: &ExperimentArgs, factors: usize) -> Fallible<ExperimentDesign> {
    let fractions = [DesignArg::Fraction, DesignArg::Composite];
    let given = [
        ("--levels", args.levels.is_some(), &[DesignArg::Full][..]),
        ("--drop", args.drop.is_some(), &fractions),
        ("--generator", !args.generator.is_empty(), &fractions),
        ("--stars", args.stars.is_some(), &[DesignArg::Composite]),
        ("--points", args.points.is_some(), &[DesignArg::Latin]),
    ];
    for (option, given, of) in given {
        if given && !of.contains(&args.design) {
            let name = |design: &DesignArg| format!("{design:?}").to_lowercase();
            let of: Vec<String> = of.iter().map(name).collect();
            return Err(
                format!("{option} is for --design {}: leave it out", of.join(" or ")).into()
            );
        }
    }
    let fraction = || -> Result<RegularFraction, String> {
        match args.generator.is_empty() {
            true => RegularFraction::standard(factors, args.drop.unwrap_or(0) as usize)
                .map_err(|problem| format!("--drop: {problem}")),
            false => RegularFraction::new(factors, &args.generator),
        }
    };
    Ok(match args.design {
        DesignArg::Full => ExperimentDesign::Full { levels: args.levels.unwrap_or(2) as usize },
        DesignArg::Fraction => {
            if args.drop.is_none() && args.generator.is_empty() {
                return Err("--design fraction needs --drop NUMBER or --generator D=ABC".into());
            }
            ExperimentDesign::Fraction(fraction()?)
        }
        DesignArg::Composite => ExperimentDesign::Composite {
            corners: fraction()?,
            stars: stars(args.stars.as_deref())?,
        },
        DesignArg::Latin => {
            ExperimentDesign::Hypercube { points: args.points.unwrap_or(POINTS) as usize }
        }
    })
}

fn stars(text: Option<&str>) -> Fallible<StarDistance> {
    Ok(match text {
        None | Some("faced") => StarDistance::Faced,
        Some("rotatable") => StarDistance::Rotatable,
        Some(text) => {
            let alpha = text.parse::<f64>().ok().filter(|alpha| (0.1..=10.0).contains(alpha));
            StarDistance::Given(alpha.ok_or_else(|| {
                format!("--stars {text}: allowed is faced, rotatable or a number from 0.1 to 10")
            })?)
        }
    })
}

fn cut(
    args: &ExperimentArgs,
    scenario: &Scenario,
    plan: &ExperimentPlan,
    noise: MeasuringNoise,
) -> Fallible<Vec<MeasuredCut>> {
    let mut job = MeasureJob::new(plan, scenario, noise, args.seed)?;
    progress::work(&mut job, "cuts", args.json)?;
    Ok(job.measured().to_vec())
}

/// The sheet; of one that was filled in, the rows that were measured whole.
fn passed_on(
    args: &ExperimentArgs,
    plan: &ExperimentPlan,
    measured: Option<&[MeasuredCut]>,
) -> String {
    let Some(cuts) = measured.filter(|_| args.read.is_some()) else { return csv(plan, measured) };
    let whole = |run: usize| cuts.get(run - 1).is_some_and(MeasuredCut::is_whole);
    let mut rows = plan.clone();
    rows.runs.retain(|run| whole(run.run));
    csv(&rows, measured)
}

fn head(scenario: &Scenario, plan: &ExperimentPlan) -> SheetHead {
    let program: Vec<String> = std::env::args().skip(1).map(|word| quoted(&word)).collect();
    SheetHead {
        title: format!("Experiment: {}", scenario.info.name),
        fixed: fixed(scenario, plan).into_iter().map(|(_, label, value)| (label, value)).collect(),
        command: format!("steadycut {}", program.join(" ")),
    }
}

/// A word as a shell takes it.
fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./=,:".contains(c);
    if word.chars().all(plain) && !word.is_empty() {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', "'\\''"))
    }
}

fn to_json(
    plan: &ExperimentPlan,
    scenario: Option<&Scenario>,
    assessment: &ExperimentAssessment,
    measured: Option<&[MeasuredCut]>,
) -> serde_json::Value {
    let fixed: serde_json::Map<String, serde_json::Value> = scenario
        .map(|scenario| fixed(scenario, plan))
        .unwrap_or_default()
        .into_iter()
        .map(|(path, _, value)| (path.to_owned(), value.into()))
        .collect();
    let fraction = plan.fraction.as_ref().map(|fraction| {
        json!({
            "defining": fraction.defining(), "resolution": fraction.resolution(),
            "aliases": fraction.aliases(),
        })
    });
    json!({
        "scenario": scenario.map(|scenario| &scenario.info.name), "plan": plan.id,
        "factors": plan.told(), "fixed": fixed, "fraction": fraction, "runs": plan.runs,
        "assessment": assessment, "measured": measured,
    })
}
