//! The off-line optimisation against exhaustive search, another optimiser and the papers' figures.

use steadycut::base::settings::{Kind, Value};
use steadycut::run::edits::Edits;
use steadycut::run::job::Job;
use steadycut::run::one_run::Run;
use steadycut::run::presets::load;
use steadycut::run::scenario::{Scenario, parse_value, table};
use steadycut::run::scenario_file;
use steadycut::study::plan::PlanJob;
use steadycut::study::plan::constraints::{CONSTRAINTS, FORCE};
use steadycut::study::plan::field::{PlanField, exhaustive};
use steadycut::study::plan::machine::{HELLER_BEA_01, MachineLimits};
use steadycut::study::plan::optimum::Optimum;
use steadycut::study::plan::problem::Problem;

use super::program::steadycut;

#[path = "planning/search.rs"]
mod search;

type Sets<'a> = &'a [(&'a str, &'a str)];

fn scenario(sets: Sets) -> Scenario {
    let mut scenario = Scenario::default();
    for (path, value) in sets {
        scenario.set(path, parse_value(path, value).unwrap()).unwrap();
    }
    scenario
}

fn machine(from: &str, to: &str) -> MachineLimits {
    let text = HELLER_BEA_01.replacen(from, to, 1);
    assert!(from == to || text != HELLER_BEA_01, "{from}");
    MachineLimits::parse(&text).unwrap()
}

fn planned(sets: Sets, machine: &MachineLimits) -> Optimum {
    let mut job = PlanJob::on(&scenario(sets), machine).unwrap();
    job.to_end();
    job.optimum()
}

/// The 2005 paper's second experiment: 2.5 x 4 mm, 665 N.
const DEEP: [(&str, &str); 3] = [
    ("plan.force_limit", "fixed"),
    ("workpiece.axial_depth_mm", "2.5"),
    ("workpiece.radial_depth_mm", "4"),
];
const RATE: [(&str, &str); 2] = [("plan.weight_force", "0"), ("plan.weight_removal_rate", "1")];
const COST: [(&str, &str); 2] = [("plan.weight_force", "0"), ("plan.weight_cost", "1")];
const TIME: [(&str, &str); 2] = [("plan.weight_force", "0"), ("plan.weight_time", "1")];
const MIXED: [(&str, &str); 2] = [("plan.weight_removal_rate", "0.3"), ("plan.weight_cost", "1")];
const FIXED: [(&str, &str); 1] = [("plan.free_speed", "false")];

#[test]
fn a_plan_repeats_by_seed_and_slicing_changes_nothing() {
    let whole = PlanJob::complete(&scenario(&DEEP)).unwrap();
    let mut sliced = PlanJob::new(&scenario(&DEEP)).unwrap();
    let mut slices = [1, 0, 7, 3].iter().cycle();
    while !sliced.advance_by(*slices.next().unwrap()) {
        assert!(!sliced.counts().done);
    }
    assert_eq!(sliced.particles(), whole.particles());
    assert_eq!(sliced.history(), whole.history());
    assert_eq!(sliced.optimum(), whole.optimum());
    assert_eq!(sliced.counts(), whole.counts());
    assert_eq!(whole.counts().evaluations, 30 * whole.history().len() as u64);
    let other = PlanJob::complete(&scenario(&[&DEEP[..], &[("plan.seed", "2")]].concat())).unwrap();
    assert_ne!(other.history(), whole.history());
}

#[test]
fn every_constraint_can_bind() {
    // Force out of the way, the largest removal rate sought.
    let free = [&DEEP[..], &RATE, &[("plan.force_max_n", "10000")]].concat();
    let heavy =
        [&free[..], &[("workpiece.axial_depth_mm", "5"), ("workpiece.radial_depth_mm", "8")]]
            .concat();
    let short_lived = "least_tool_life_min = { value = 0.1";
    let life = "least_tool_life_min = { value = 30.0";
    let cases: [(&str, Sets, &str, &str); 7] = [
        ("speed", &free, "4500.0", "1200.0"),
        ("feed", &free, "2000.0", "300.0"),
        ("force", &DEEP, "", ""),
        ("power", &free, "power_max_kw = { value = 10.0", "power_max_kw = { value = 0.3"),
        ("roughness", &free, life, short_lived),
        ("deflection", &heavy, life, short_lived),
        ("tool_life", &free, "", ""),
    ];
    for ((id, sets, from, to), expected) in cases.iter().zip(CONSTRAINTS) {
        assert_eq!(*id, expected.id);
        let optimum = planned(sets, &machine(from, to));
        let active: Vec<&str> = optimum.active().map(|one| one.constraint.id).collect();
        assert!(optimum.feasible && active.contains(id), "{id}: {active:?} at {optimum:?}");
        assert!(optimum.verdict_text().contains(expected.label));
    }
}

#[test]
fn where_nothing_is_feasible_the_least_violation_is_returned_and_marked() {
    let sets = [("workpiece.axial_depth_mm", "8"), ("workpiece.radial_depth_mm", "16")];
    let scenario = scenario(&sets);
    let job = PlanJob::complete(&scenario).unwrap();
    let optimum = job.optimum();
    assert!(!optimum.feasible && optimum.score.violation > 0.0);
    assert!(!optimum.inside_training_data, "the network was trained up to 5 x 8 mm");
    let active: Vec<&str> = optimum.active().map(|one| one.constraint.id).collect();
    assert!(active.contains(&"force"), "{active:?}");
    assert!(optimum.verdict_text().contains("nothing is feasible"), "{}", optimum.verdict_text());
    let grid = exhaustive(job.problem(), 100, 100);
    assert!(optimum.score.violation <= grid.score.violation * 1.005, "{grid:?}");
    assert!(job.history().iter().all(|iteration| iteration.feasible_share == 0.0));
}

#[test]
fn the_plan_of_the_2005_cut_is_the_prototypes() {
    let fixed = planned(&[&DEEP[..], &FIXED].concat(), &MachineLimits::heller_bea_01());
    assert_eq!(fixed.cutting_speed_m_min, 80.0);
    assert!((fixed.feed_per_tooth_mm / 0.1166 - 1.0).abs() < 0.05, "{fixed:?}");
    assert!((fixed.force_n / 665.0 - 1.0).abs() < 0.005);
    let free = planned(&[&DEEP[..], &RATE].concat(), &MachineLimits::heller_bea_01());
    assert!((free.cutting_speed_m_min / 85.7 - 1.0).abs() < 0.05, "{free:?}");
    assert!(free.inside_training_data);
    assert!((free.feed_per_tooth_mm / 0.1167 - 1.0).abs() < 0.05, "{free:?}");
    let active: Vec<&str> = free.active().map(|one| one.constraint.id).collect();
    assert_eq!(active, ["force", "tool_life"]);
}

#[test]
fn what_follows_from_a_point_follows_the_formulas() {
    let problem = Problem::new(&scenario(&DEEP), &MachineLimits::heller_bea_01()).unwrap();
    let optimum = Optimum::at(&problem, [80.0, 0.08]);
    let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-4, "{a} against {b}");
    near(optimum.speed_rpm, 1591.55);
    near(optimum.feed_mm_min, 254.648);
    let [x, y, _] = optimum.components_n;
    near(optimum.force_n, (x * x + y * y).sqrt());
    near(optimum.power_kw, y.abs() * 80.0 / 48_000.0);
    // 5 x 318 x 0.16^2 / 64 um; 64 F 40^3 / (3 pi 2.1e5 16^4) mm; 60 (2 / 2.5)^0.4 min.
    near(optimum.ra_um, 0.636);
    near(optimum.deflection_mm / optimum.force_n, 3.157_88e-5);
    near(optimum.tool_life_min, 54.876_2);
    near(optimum.removal_rate_cm3_min, 2.5 * 4.0 * 0.254_648);
    near(optimum.time_s, 120.0 / 254.648 * 60.0);
    near(optimum.production_time_s, optimum.time_s * (1.0 + 2.0 / 54.876_2));
    let minutes = optimum.time_s / 60.0;
    near(optimum.cost, minutes + minutes / 54.876_2 * (2.0 + 20.0));
    // At the reference cut each gain but the force's is 1.
    let rate =
        Problem::new(&scenario(&[&DEEP[..], &RATE].concat()), &MachineLimits::heller_bea_01());
    near(rate.unwrap().score([80.0, 0.08]).value, 1.0);
    near(problem.score([80.0, 0.08]).value, optimum.force_n / 665.0 + 0.1);
}

#[test]
fn the_force_limit_of_the_target_is_the_controllers_reference_force() {
    let scenario = load("table3-5").unwrap();
    let job = PlanJob::complete(&scenario).unwrap();
    let run = Run::complete(&scenario, &Edits::none());
    let limit = job.optimum().constraints[FORCE].high.unwrap();
    assert_eq!(limit, run.recording().rows()[0].force_ref_n);
    assert!(job.optimum().force_n <= limit);
}

#[test]
fn the_planned_section_is_the_deepest_or_the_shallowest_that_is_cut() {
    let depth = |section: &str, steps: &str| {
        let sets = [("plan.section", section), ("workpiece.depth_steps", steps)];
        Problem::new(&scenario(&sets), &MachineLimits::heller_bea_01()).unwrap().depths_mm()[0]
    };
    let steps = "[[20, 3.5], [40, 0], [60, 1.5], [500, 8]]";
    assert_eq!([depth("heaviest", steps), depth("lightest", steps)], [3.5, 1.5]);
    assert_eq!(depth("heaviest", "[[0, 1.2]]"), 1.2, "the first step is at the very start");
}

#[test]
fn the_optimum_becomes_the_programmed_values_of_a_run() {
    let scenario = scenario(&DEEP);
    let optimum = PlanJob::complete(&scenario).unwrap().optimum();
    let planned = optimum.apply(&scenario).unwrap();
    let changed: Vec<&str> =
        planned.difference(&scenario).iter().map(|(param, _)| param.path.as_str()).collect();
    assert_eq!(changed, ["program.feed_mm_min", "program.spindle_rpm"]);
    let row = Run::complete(&planned, &Edits::none()).recording().rows()[0];
    assert_eq!([row.feed_mm_min, row.spindle_rpm], [optimum.feed_mm_min, optimum.speed_rpm]);
    let slow = machine("feed_min_mm_min = { value = 10.0", "feed_min_mm_min = { value = 1.0");
    let slow = Problem::new(&scenario, &slow).unwrap();
    assert!(
        Optimum { feed_mm_min: 2.0, ..Optimum::at(&slow, [80.0, 0.1]) }.apply(&scenario).is_err()
    );
}

#[test]
fn the_field_shows_the_boundaries_where_the_constraints_change_sides() {
    let heavy = [&DEEP[..], &[("workpiece.axial_depth_mm", "4")]].concat();
    let problem = Problem::new(&scenario(&heavy), &machine("4500.0", "2000.0")).unwrap();
    let field = PlanField::new(&problem, 60, 50);
    assert_eq!((field.cutting_speed_m_min.len(), field.feed_per_tooth_mm.len()), (60, 50));
    assert!(field.force_n.len() == 3000 && field.excess.iter().all(|one| one.len() == 3000));
    for (i, constraint) in CONSTRAINTS.iter().enumerate() {
        let boundary = field.boundary(i);
        let shown =
            field.excess[i].iter().any(|x| *x > 0.0) && field.excess[i].iter().any(|x| *x < 0.0);
        assert_eq!(shown, !boundary.is_empty(), "{}", constraint.id);
        for point in boundary.as_flattened() {
            let excess = problem.bounds()[i].excess(problem.cut(*point).values()[i]);
            assert!(excess.abs() < 0.02, "{} at {point:?}: {excess}", constraint.id);
        }
    }
    let seen = (0..7).filter(|i| !field.boundary(*i).is_empty()).count();
    assert_eq!(seen, 4, "speed, force, roughness and tool life cross the domain");
    for point in field.force_line(500.0).as_flattened() {
        assert!((problem.cut(*point).force_n - 500.0).abs() < 5.0);
    }
    // The grid search is at least as good as every feasible sample.
    let best = exhaustive(&problem, 60, 50).score;
    let feasible = field.value.iter().zip(&field.violation).filter(|(_, v)| **v == 0.0);
    assert!(feasible.clone().count() > 100);
    assert!(feasible.into_iter().all(|(value, _)| *value <= best.value));
}

#[test]
fn a_plan_that_cannot_be_made_is_refused_by_name() {
    let refused = |sets: Sets| PlanJob::new(&scenario(sets)).unwrap_err().to_string();
    let text = refused(&[("plan.weight_force", "0")]);
    assert!(text.contains("plan.weight_force") && text.contains("weight_cost"), "{text}");
    let text = refused(&[("workpiece.axial_depth_mm", "0")]);
    assert!(text.contains("workpiece.axial_depth_mm") && text.contains("0 mm"), "{text}");
    let text = refused(&[("workpiece.radial_depth_mm", "0.001")]);
    assert!(text.contains("workpiece.radial_depth_mm") && text.contains("0.001"), "{text}");
    let free = [("plan.machine_cost_per_min", "0"), ("plan.tool_cost", "0")];
    let text = refused(&[&COST[..], &free].concat());
    assert!(text.contains("plan.machine_cost_per_min") && text.contains("tool_cost"), "{text}");
}

#[test]
fn extremes_of_all_settings_give_a_finite_plan_or_an_error() {
    for param in table() {
        let mut values = match &param.spec.allowed {
            Kind::Float { min, max } => vec![Value::Float(*min), Value::Float(*max)],
            Kind::Int { min, max } => vec![Value::Int(*min), Value::Int(*max)],
            Kind::Choice { options } => {
                options.iter().map(|option| Value::Text(option.id.to_owned())).collect()
            }
            _ => vec![Value::Bool(true), Value::Bool(false)],
        };
        values.push(Value::Float(5e-324));
        for value in values {
            for sets in [&MIXED[..], &[&DEEP[..], &TIME].concat()] {
                let mut scenario = scenario(sets);
                scenario.change(|s| s.plan.iterations = 10).unwrap();
                if scenario.set(&param.path, value.clone()).is_err() {
                    continue;
                }
                scenario.change(|s| s.plan.iterations = s.plan.iterations.min(50)).unwrap();
                match PlanJob::complete(&scenario) {
                    Ok(job) => {
                        let optimum = job.optimum();
                        let cut = job.problem().cut([40.0, 0.02]);
                        let all = cut.values().into_iter().chain([
                            optimum.score.value,
                            optimum.score.violation,
                            optimum.cost,
                            optimum.production_time_s,
                        ]);
                        for x in all {
                            assert!(x.is_finite() && x >= 0.0, "{} = {value}: {x}", param.path);
                        }
                    }
                    Err(error) => assert!(error.to_string().contains('`'), "{error}"),
                }
            }
        }
    }
}

#[test]
fn the_command_line_plans_prints_and_writes() {
    let folder = std::path::PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    let (file, other) = (folder.join("planned.toml"), folder.join("machine.toml"));
    let (file, other) = (file.to_str().unwrap(), other.to_str().unwrap());
    let limit = ["--set", "plan.force_limit=fixed"];
    let output = steadycut(&[&["plan", "first-cut", "--json", "--out", file], &limit[..]].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let optimum = &report["optimum"];
    for key in ["feed_mm_min", "speed_rpm", "force_n", "tool_life_min", "cost", "feasible"] {
        assert!(!optimum[key].is_null(), "`{key}` is missing");
    }
    assert_eq!(optimum["constraints"].as_array().unwrap().len(), 7);
    assert!(report["constraints_origin"].as_str().unwrap().starts_with("chosen"));
    assert_eq!(report["machine"]["power_max_kw"]["source"], "placeholder");
    let (swarm, grid) = (&report["optimum"]["value"], &report["grid"]["value"]);
    assert!((swarm.as_f64().unwrap() / grid.as_f64().unwrap() - 1.0).abs() < 0.005);
    let iterations = report["iterations"].as_u64().unwrap();
    assert_eq!(report["history"].as_array().unwrap().len() as u64, iterations + 1);
    let (written, _) = scenario_file::parse(&std::fs::read_to_string(file).unwrap()).unwrap();
    assert_eq!(written.program.feed_mm_min, optimum["feed_mm_min"].as_f64().unwrap());

    std::fs::write(other, HELLER_BEA_01.replace("4500.0", "1000.0")).unwrap();
    let output = steadycut(&[&["plan", "first-cut", "--machine", other], &limit[..]].concat());
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("binding: Spindle speed"), "{text}");
    assert!(text.contains("placeholder") && text.contains("chosen"), "{text}");
    assert!(text.contains("3500 measurements were never published"), "{text}");
    for constraint in CONSTRAINTS {
        assert!(text.contains(constraint.label) && text.contains(constraint.formula));
    }

    let deep = ["--set", "workpiece.axial_depth_mm=8", "--set", "workpiece.radial_depth_mm=16"];
    let output = steadycut(&[&["plan", "table3-5"], &deep[..]].concat());
    assert_eq!(output.status.code(), Some(1), "nothing feasible");
    assert!(String::from_utf8(output.stdout).unwrap().contains("VIOLATED"));
    let output = steadycut(&[&["plan", "table3-5", "--out", file], &deep[..]].concat());
    assert_eq!(output.status.code(), Some(2), "an infeasible plan is not written");
    let output = steadycut(&["plan", "table3-5", "--machine", "missing.toml"]);
    assert!(String::from_utf8(output.stderr).unwrap().contains("missing.toml"));
}
