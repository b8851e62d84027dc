//! Every job there is: its result depends neither on slices, nor on being cancelled and gone on with, nor
//! on the number of threads.

use std::collections::BTreeSet;
use std::fmt::Debug;
use std::sync::atomic::{AtomicU64, Ordering};

use steadycut_core::base::math;
use steadycut_core::base::settings::Value;
use steadycut_core::blocks::control::ControllerKind;
use steadycut_core::blocks::cutting::process::ForceModel;
use steadycut_core::models::genetic::Calibration;
use steadycut_core::models::plan::PlannedSection;
use steadycut_core::models::tool::Tool;
use steadycut_core::models::tool_life::Growth;
use steadycut_core::run::constant_feed_twin::BesideRun;
use steadycut_core::run::edits::{Edit, Edits};
use steadycut_core::run::job::{Budget, Job, OneThread, Threads};
use steadycut_core::run::one_run::Run;
use steadycut_core::run::presets::load;
use steadycut_core::run::revolution::RevolutionJob;
use steadycut_core::run::run_to::RunTo;
use steadycut_core::run::scenario::{Scenario, parse_value};
use steadycut_study::afc::TeachIn;
use steadycut_study::combined::Combined;
use steadycut_study::compare::by_hand::{ByHandJob, HAND};
use steadycut_study::compare::contest::ContestJob;
use steadycut_study::compare::entrants::{Entrant, TABLE_1, on};
use steadycut_study::compare::iterations::IterationsJob;
use steadycut_study::compare::tournament::Tournament;
use steadycut_study::experiment::assess::MeasuringNoise;
use steadycut_study::experiment::factor::PAPERS_BOX;
use steadycut_study::experiment::measure::MeasureJob;
use steadycut_study::experiment::way::cuts::plan as planned_cuts;
use steadycut_study::experiment::way::job::WayJob;
use steadycut_study::experiment::way::pilot::Pilot;
use steadycut_study::experiment::way::{WayPlant, WaySettings};
use steadycut_study::identify::fits::{
    FitRequest, MeasuredFitJob, MeasuredFitKind, likely_channels,
};
use steadycut_study::identify::genetic::GeneticJob;
use steadycut_study::identify::gp::job::{GpJob, GpSettings};
use steadycut_study::identify::gp::paper::PaperSearch;
use steadycut_study::identify::gp::problem::GpProblem;
use steadycut_study::identify::gp::watched::WatchedSearch;
use steadycut_study::machine_life::adaptive::AdaptiveLife;
use steadycut_study::machine_life::monte_carlo::{LifeMonteCarlo, Tools};
use steadycut_study::machine_life::{LifeJob, model};
use steadycut_study::measured::layout::DataLayout;
use steadycut_study::measured::reader::read;
use steadycut_study::mission::{Marking, MissionAnswer, shipped};
use steadycut_study::papers::{CalibrationsJob, TableJob};
use steadycut_study::part::blank::Blank;
use steadycut_study::part::gcode::GCodeProgram;
use steadycut_study::part::milling::MillingJob;
use steadycut_study::plan::PlanJob;
use steadycut_study::plan::flight::Flight;
use steadycut_study::plan::machine::MachineLimits;
use steadycut_study::plan::schedule::ScheduleJob;
use steadycut_study::published::PaperId;
use steadycut_study::recommend::Advisor;
use steadycut_study::recommend::table::Table;
use steadycut_study::robust::Robustness;
use steadycut_study::safe_feed::{SafeFeedJob, SafeFeedProblem};
use steadycut_study::stability::chart::{ChartJob, Range};
use steadycut_study::train::TrainingSession;
use steadycut_study::train::claim::ForceClaimJob;
use steadycut_study::train::comparison::ComparisonJob;
use steadycut_study::train::data::RowsJob;
use steadycut_study::train::genetic::GeneticForceJob;
use steadycut_study::train::recipe::{RecipeKind, TrainingRecipe};
use steadycut_study::train::unks::{NetworksJob, PatternsJob};
use steadycut_study::unks_passes::Passes;

/// Threads of the test.
struct Several(usize);

impl Threads for Several {
    fn count(&self) -> usize {
        self.0
    }

    #[expect(clippy::disallowed_methods, reason = "the test is a front end")]
    fn run(&self, lanes: usize, work: &(dyn Fn(usize) + Sync)) {
        std::thread::scope(|scope| {
            for lane in 0..lanes {
                scope.spawn(move || work(lane));
            }
        });
    }
}

const NEVER: &(dyn Fn() -> bool + Sync) = &|| false;

/// Checks a job; `slice` is a small part of its steps. What is printed of it has every digit of its
/// numbers.
fn check<J: Job<Partial: Debug> + Clone>(name: &str, job: &J, slice: u64) {
    let bits = |job: &J| {
        assert_eq!(job.refusal(), None, "{name}");
        format!("{:?}", job.partial())
    };
    let mut whole = job.clone();
    assert!(whole.advance(&Budget::all()), "{name}");
    let result = bits(&whole);
    assert_eq!(whole.progress().share(), 1.0, "{name}: {}", whole.progress());

    // In slices, read between them; progress never falls.
    for threads in [1, 4] {
        let mut sliced = job.clone();
        let (mut slices, mut share) = (0, 0.0);
        while !sliced.advance(&Budget::steps(slice).on(&Several(threads), NEVER)) {
            let now = sliced.progress();
            assert!(now.done <= now.total && !now.unit.is_empty(), "{name}: {now}");
            assert!(now.share() >= share, "{name}: {share} then {now:?}");
            share = now.share();
            drop(sliced.partial());
            slices += 1;
        }
        assert!(slices > 1, "{name}: {slices} slices");
        assert_eq!(bits(&sliced), result, "{name} in slices of {slice} on {threads} threads");
    }

    // All at once on four threads.
    let mut spread = job.clone();
    assert!(spread.advance(&Budget::all().on(&Several(4), NEVER)), "{name}");
    assert_eq!(bits(&spread), result, "{name} on 4 threads");

    // Cancelled at every third look, on one thread and on several, and gone on with.
    for threads in [&OneThread as &dyn Threads, &Several(3)] {
        let looks = AtomicU64::new(0);
        let cancel = || looks.fetch_add(1, Ordering::Relaxed) % 997 == 996;
        let mut stopped = job.clone();
        let mut times = 0;
        while !stopped.advance(&Budget::steps(50 * slice).on(threads, &cancel)) {
            times += 1;
            assert!(times < 1_000_000, "{name} does not come to its end");
        }
        assert_eq!(bits(&stopped), result, "{name} cancelled {times} times");
    }

    // What is over stays as it is.
    assert!(whole.advance_by(slice), "{name}");
    assert_eq!(bits(&whole), result, "{name}");
    let mut idle = job.clone();
    assert!(!idle.advance_by(0), "{name}: no steps, no end");
}

fn scenario(preset: &str, sets: &[(&str, &str)]) -> Scenario {
    let mut scenario = load(preset).unwrap();
    for (path, value) in sets {
        scenario.set(path, parse_value(path, value).unwrap()).unwrap();
    }
    scenario
}

/// A short cut tooth by tooth.
fn milled() -> Scenario {
    scenario("experiment-2", &[("workpiece.cuts", "[[[6.0, 3.0, 2.0]]]")])
}

fn entrants(seconds: f64) -> Vec<Entrant> {
    let mut base = load("table3-5-noise").unwrap();
    base.set("run.duration_s", Value::Float(seconds)).unwrap();
    on(&base, &TABLE_1[..3])
}

fn recipe(hidden: usize) -> TrainingRecipe {
    TrainingRecipe { epochs: 20, hidden: vec![hidden], ..RecipeKind::Literal.recipe() }
}

#[test]
fn runs_and_what_is_made_of_one() {
    check("Run", &Run::new(&scenario("table3-5-noise", &[]), &Edits::none()), 500);
    let changed = Edit { at_s: 3.0, path: "target.ra_um".to_owned(), value: Value::Float(1.2) };
    let mut edits = Edits::none();
    let cut = scenario("table3-5-noise", &[]);
    edits.push(&cut, changed).unwrap();
    check("BesideRun", &BesideRun::new(&Run::complete(&cut, &edits)), 5000);
    let run = Run::complete(&milled(), &Edits::none());
    let safe = SafeFeedProblem::of(&Run::complete(&cut, &edits));
    check("SafeFeedJob", &SafeFeedJob::new(safe), 5_003);
    let short = [("workpiece.length_mm", "10"), ("twin.free_speed", "true")];
    let any_speed = SafeFeedProblem::new(&scenario("table3-5-noise", &short), Vec::new());
    check("SafeFeedJob", &SafeFeedJob::new(any_speed), 777);
    check("RunTo", &RunTo::new(&milled(), &Edits::none(), 20_000), 777);
    check("RevolutionJob", &RevolutionJob::new(&run, 2.0, 2, None), 777);
    let short = scenario("combined-2005", &[("run.duration_s", "2")]);
    let advisor = Advisor::new(&Table::shipped());
    let machine = MachineLimits::heller_bea_01();
    let combined = Combined::new(&short, &advisor, &machine, PlannedSection::Lightest).unwrap();
    check("Combined", &combined, 5_000);
    let passes = scenario("experiment-2", &[("workpiece.cuts", "[[[10.0, 3.0, 2.0]]]")]);
    check("Passes", &Passes::new(&passes, 2), 37);
    check("TeachIn", &TeachIn::new(&scenario("afc", &[])), 777);
}

#[test]
fn fits_of_measured_data() {
    for kind in MeasuredFitKind::ALL.iter().copied() {
        let preset = match kind {
            MeasuredFitKind::ForceFromData => "square-12-4-42crmo4",
            MeasuredFitKind::DriveFromData
            | MeasuredFitKind::StructureFromData
            | MeasuredFitKind::NoiseFromData
            | MeasuredFitKind::WearFromData
            | MeasuredFitKind::MaterialFromData => "table3-5-noise",
        };
        let cut = load(preset).unwrap();
        let text = kind.sample(&cut, 1).unwrap();
        let time = (!kind.about().timed).then(|| "none".to_owned());
        let layout = DataLayout { time, ..DataLayout::default() };
        let channels = read(text.as_bytes(), &layout).unwrap().channels;
        let request = FitRequest {
            file: "sample.csv".to_owned(),
            roles: likely_channels(kind.about().roles, &channels),
            channels,
            values: Vec::new(),
            scenario: cut,
            edits: Edits::none(),
        };
        check("MeasuredFitJob", &MeasuredFitJob::new(kind, request), 1);
    }
}

#[test]
fn a_program_cut_from_a_blank() {
    let program =
        GCodeProgram::read("G0 X-10 Y5 Z-1\nG1 X20 F200\nG3 X20 Y9 I0 J2\nG0 X-10").unwrap();
    let blank = Blank::new([30.0, 20.0, 5.0], None).unwrap();
    let outline = Tool::default().outline();
    check("MillingJob", &MillingJob::new(&program, blank, outline, 0.5).unwrap(), 7);
}

#[test]
fn comparisons_of_runs() {
    check("Tournament", &Tournament::new(entrants(1.0), 3), 777);
    let mut milling = on(&milled(), &TABLE_1[..2]);
    for entrant in &mut milling {
        entrant.scenario.set("run.duration_s", Value::Float(0.5)).unwrap();
    }
    let table = TableJob::new(PaperId::Sdnrp2007, Calibration::Identified, ForceModel::Formula);
    check("TableJob", &table, 7_001);
    check("CalibrationsJob", &CalibrationsJob::new(PaperId::Strategy2013), 20_011);
    check("ContestJob", &ContestJob::new(milling, 2), 5_000);
    check("IterationsJob", &IterationsJob::new(&milled()), 10_007);
    let mut by_hand = ByHandJob::without_control(&load("table3-5-noise").unwrap());
    by_hand.set("run.duration_s", Value::Float(0.5)).unwrap();
    let turned = Edit { at_s: 0.1, path: HAND.to_owned(), value: Value::Float(80.0) };
    let mut edits = Edits::none();
    edits.push(&by_hand, turned).unwrap();
    check("ByHandJob", &ByHandJob::new(&by_hand, &edits), 777);
    check("Robustness", &Robustness::new(&milled(), ControllerKind::Preview, 3, 7), 10_007);
}

#[test]
fn missions() {
    let mission = shipped::load("depth-step-at-constant-feed").unwrap();
    let text = include_str!("../data/missions/depth-step-at-constant-feed.right.toml");
    let marking = Marking::new(&mission, MissionAnswer::read(text, &mission).unwrap()).unwrap();
    check("Marking", &marking, 7_001);
}

#[test]
fn plans() {
    let plan = PlanJob::new(&Scenario::default()).unwrap();
    check("PlanJob", &plan, 3);
    check("Flight", &Flight::new(plan), 3);
    let (machine, sized_by) = (MachineLimits::heller_bea_01(), PlannedSection::Lightest);
    let schedule = ScheduleJob::on(&scenario("experiment-2", &[]), &machine, sized_by).unwrap();
    check("ScheduleJob", &schedule, 7);
}

#[test]
fn machine_and_tool_life() {
    let scenario = Scenario::default();
    let range =
        Range { from_rpm: 1100.0, to_rpm: 2300.0, speeds: 5, highest_mm: 60.0, simulate: false };
    check("ChartJob", &ChartJob::new(&scenario, range).unwrap(), 1);
    check("LifeJob", &LifeJob::new(model(&scenario), 3.0), 7);
    let mut worn = scenario.clone();
    worn.change(|settings| settings.wear.tool_life_factor = 0.4).unwrap();
    check("AdaptiveLife", &AdaptiveLife::new(&worn, true), 9);
    let growth = Growth::linear(1.844);
    let tools = Tools {
        wear: scenario.wear.clone(),
        life: scenario.life.clone(),
        believed: growth.clone(),
        truth: growth,
        prior_min: 240.0,
        other_shapes: true,
        seed: 3,
    };
    check("LifeMonteCarlo", &LifeMonteCarlo::new(tools, 12), 1);
}

/// The search for K4 in three batches.
fn search_for_k4() -> GpJob {
    let text = include_str!("../data/gp/k4_clean.csv");
    let inputs = ["feed_mm_min", "speed_rpm"].map(str::to_owned);
    let problem = GpProblem::read(text, "force_n", &inputs).unwrap();
    GpJob::new(problem, &GpSettings { seed: 1, batches: 3, paper: None }).unwrap()
}

#[test]
fn a_search_has_the_same_bits_on_any_number_of_threads_in_slices_of_any_size() {
    let gone = |threads: usize, slice: u64| {
        let mut job = search_for_k4();
        while !job.advance(&Budget::steps(slice).on(&Several(threads), NEVER)) {}
        job.report().digest
    };
    let whole = gone(1, u64::MAX);
    // A step is one formula, 128 of them a batch.
    let batches = 128 * 1000;
    for (threads, slice) in [(1, 1), (1, batches), (2, batches), (3, batches), (8, 1), (8, batches)]
    {
        assert_eq!(gone(threads, slice), whole, "{threads} threads, slices of {slice}");
    }
}

/// Within 100 ms, and what was found until then is kept: gone on with, it comes to the same end.
#[test]
#[expect(clippy::disallowed_methods, reason = "the test is a front end")]
fn a_search_stops_soon_and_keeps_what_it_has_found() {
    let mut whole = search_for_k4();
    whole.to_end();
    let mut least_s = f64::INFINITY;
    // The best of some tries: the machine may have other work.
    for _ in 0..8 {
        let mut job = search_for_k4();
        let begin = std::time::Instant::now();
        let asked_s = 0.005;
        let stopped = || begin.elapsed().as_secs_f64() > asked_s;
        assert!(!job.advance(&Budget::all().on(&Several(2), &stopped)));
        least_s = f64::min(least_s, begin.elapsed().as_secs_f64() - asked_s);
        assert!(!job.standing().front.is_empty());
        job.to_end();
        assert_eq!(job.report().digest, whole.report().digest);
    }
    assert!(least_s < 0.1, "{least_s} s");
}

#[test]
fn searches_for_formulas() {
    let rows = (0..12).map(|i| 0.5 * f64::from(i) + 1.0);
    let line = |x: f64| format!("{x},{}\n", 3.0 + 2.0 / x + 0.01 * math::sin(7.0 * x));
    let text = format!("x,y\n{}", rows.map(line).collect::<String>());
    let problem = GpProblem::read(&text, "y", &["x".to_owned()]).unwrap();
    let job = GpJob::new(problem, &GpSettings { seed: 2, batches: 4, paper: None }).unwrap();
    let paper = PaperSearch::new(PaperId::Sdnrp2007, job.problem().rows.clone(), 1);
    check("PaperSearch", &paper, 137);
    check("GpSearch", job.search(), 37);
    check("GpJob", &job, 7);
    check("WatchedSearch", &WatchedSearch::new(job.clone()), 7);
    let rows = PaperId::Strategy2013.rows();
    let found = GeneticJob::new(PaperId::Strategy2013, &rows).of_batches(1);
    check("GeneticJob", &found, 11);
    check("GeneticForceJob", &GeneticForceJob::new(40, 1), 11);
}

#[test]
fn experiments() {
    let [feeds, speeds] = PAPERS_BOX;
    let noise = MeasuringNoise::default();
    let plan = planned_cuts(30, feeds, speeds, 2);
    let cuts = MeasureJob::new(&plan, &scenario("table3-5-noise", &[]), noise, 2).unwrap();
    check("MeasureJob", &cuts, 777);
    let settings = WaySettings { cuts: 30, batches: 2, seed: 2, ..WaySettings::default() };
    check("WayJob", &WayJob::new(&settings).unwrap().with_rows(1), 777);
    let settings = WaySettings { plant: Some(WayPlant::Mechanistic), ..settings };
    check("Pilot", &Pilot::new(&settings.scenario().unwrap(), false), 20_011);
}

#[test]
fn training() {
    check("RowsJob", &RowsJob::measured(40, 3), 3);
    check("ForceClaimJob", &ForceClaimJob::new(40), 3);
    let rows = RowsJob::measured(60, 3).complete();
    check("TrainingSession", &TrainingSession::new(&recipe(5), &rows).unwrap(), 3);
    check("ComparisonJob", &ComparisonJob::new(vec![recipe(3), recipe(4), recipe(5)], &rows), 7);
    let mut patterns = PatternsJob::default();
    patterns.advance_by(1);
    let few: Vec<_> = patterns.patterns().iter().copied().take(40).collect();
    check("NetworksJob", &NetworksJob::new(&few), 25);
}

#[test]
fn patterns_of_unks_are_the_same_however_they_are_sliced() {
    // All of them would take some minutes: three cuts, of two workpieces.
    let [mut whole, mut sliced] = [PatternsJob::default(), PatternsJob::default()];
    assert!(!whole.advance_by(3));
    (0..3).for_each(|_| assert!(!sliced.advance_by(1)));
    assert_eq!(whole.patterns(), sliced.patterns());
    assert_eq!(whole.progress().to_string(), "3 of 20 cuts");
}

/// Independent jobs in the sources: parts of others are checked with them.
#[test]
fn every_job_is_checked_here() {
    let parts = ["CutPlan", "PartCut", "PointJob", "TrialJob", "NetworkJob", "OneStep"];
    let mut found = BTreeSet::new();
    for folder in ["src", "../core/src"] {
        let mut folders = vec![std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)];
        while let Some(folder) = folders.pop() {
            for entry in std::fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    folders.push(path);
                } else if path.extension().is_some_and(|extension| extension == "rs") {
                    let text = std::fs::read_to_string(&path).unwrap();
                    let jobs = text.split("impl Job for ").skip(1);
                    found
                        .extend(jobs.map(|rest| rest.split([' ', '<']).next().unwrap().to_owned()));
                }
            }
        }
    }
    assert!(found.len() > 15, "{found:?}");
    let here = include_str!("jobs.rs");
    for job in found.iter().filter(|job| !parts.contains(&job.as_str())) {
        let checked = here.contains(&format!("check(\"{job}\""));
        assert!(checked || job == "PatternsJob", "{job} is not checked");
    }
}
