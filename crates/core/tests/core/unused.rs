//! Every setting is used by a run, or the table says why not: checked against runs, to the bit.

use std::collections::BTreeMap;

use steadycut_core::base::settings::{Kind, Value};
use steadycut_core::run::edits::Edits;
use steadycut_core::run::one_run::Run;
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::{Param, Scenario, UNUSED, param, parse_value, table};

/// Scenarios in which, together, every setting has a part: a preset and what differs from it.
const BASES: &[(&str, &[&str])] = &[
    ("first-cut", &[]),
    ("first-cut", &["tool.force_max_n=150"]),
    ("table3-5", &["cnc.force_stop=true", "cnc.force_stop_n=100"]),
    (
        "table3-5",
        &["disturbances.chatter_bursts=[[1.0, 5.0, 20.0]]", "disturbances.wear_jumps=[[1.0, 0.1]]"],
    ),
    ("table3-5-noise", &["cnc.override_rate_limited=true", "noise.inhomogeneity_percent=0"]),
    ("own-formula", &["controller.kind=sdnrp", "run.duration_s=2.6"]),
    ("table3-5", &["workpiece.radial_steps=[[4.0, 2.0]]"]),
    ("depth-step", &["noise.level=1", "cnc.force_stop=true", "workpiece.depth_steps=[[8.0, 3.0]]"]),
    ("strategy-2013", &["tool.shape=bull_nose", "controller.kind=division"]),
    (
        "experiment-1",
        &[
            "controller.kind=preview",
            "target.force_n=300",
            "workpiece.cuts=[[[1.0, 2.0, 1.3], [20.0, 3.5, 1.3]]]",
        ],
    ),
    ("experiment-1", &["tool.shape=bull_nose", "controller.unks.smith=true"]),
    ("experiment-1", &["controller.unks.start=cold", "noise.level=0"]),
    (
        "experiment-1",
        &["controller.kind=division", "controller.division.divided=command", "target.force_n=300"],
    ),
    ("experiment-1", &["controller.kind=mrac", "machine.coupled=true"]),
    ("experiment-1", &["controller.kind=mrac", "controller.mrac.adapted=gain"]),
    (
        "experiment-1",
        &["controller.kind=adjustable_pi", "workpiece.cuts=[]", "plant.model_set=milling_2005"],
    ),
    ("experiment-1", &["controller.kind=p", "program.cut_feeds_mm_min=[200.0]"]),
    ("experiment-2-neural", &["controller.kind=p", "controller.p.smith=true"]),
    (
        "table3-5",
        &[
            r#"feed_drive.curve={"version":1,"formula":"0.97*x","output":{"name":"y","unit":"mm/min"},"inputs":[{"name":"x","unit":"mm/min","low":1,"high":2000}]}"#,
            r#"spindle_drive.curve={"version":1,"formula":"0.98*x","output":{"name":"y","unit":"1/min"},"inputs":[{"name":"x","unit":"1/min","low":1,"high":9000}]}"#,
        ],
    ),
    (
        "table3-5",
        &[
            "feed_drive.poles=[[-22.0, 0.0], [-60.0, 140.0]]",
            "feed_drive.gain=0.98",
            "spindle_drive.poles=[[-5.0, 0.0]]",
            "spindle_drive.gain=0.99",
        ],
    ),
    ("machine-dynamics", &["machine.tip_modes=[[1.0, 160.0, 0.05, 20.0]]"]),
    ("afc", &["controller.afc.references_n=[150.0]", "controller.afc.overload_s=0.1"]),
    ("afc", &["controller.afc.references_n=[900.0]", "controller.afc.entry_percent=119"]),
    ("afc", &["controller.afc.f_min_percent=100", "controller.afc.f_max_percent=100"]),
    ("afc", &["controller.afc.references_n=[]"]),
    ("machine-dynamics", &["profile.long_mm=0.08", "machine.spindle_quality=10"]),
    ("machine-dynamics", &["machine.roughness_from=random", "controller.kind=constant_feed"]),
    ("tool-life", &["controller.kind=tracking", "workpiece.axial_depth_mm=0.5"]),
    (
        "machine-life",
        &[
            "wear.time_scale=900",
            r#"wear.curve={"version":1,"formula":"0.4*x^0.5 + 0.6*x^4","output":{"name":"w","unit":""},"inputs":[{"name":"x","unit":"","low":0.001,"high":1.2}]}"#,
            r#"wear.force_curve={"version":1,"formula":"1 + 0.3*w + 0.3*w^2","output":{"name":"k","unit":""},"inputs":[{"name":"w","unit":"","low":0,"high":2}]}"#,
            r#"wear.stiffness_curve={"version":1,"formula":"1 - 0.2*w","output":{"name":"k","unit":""},"inputs":[{"name":"w","unit":"","low":0,"high":2}]}"#,
            r#"wear.life_curve={"version":1,"formula":"15*(v/160)^-3.9*(fz/0.135)^-0.7*(ap/2)^-0.2","output":{"name":"T","unit":"min"},"inputs":[{"name":"v","unit":"m/min","low":20,"high":300},{"name":"fz","unit":"mm","low":0.02,"high":0.4},{"name":"ap","unit":"mm","low":0.1,"high":8}]}"#,
        ],
    ),
    (
        "machine-life",
        &[
            "wear.indentation_n_mm3=100000",
            "wear.adjust_speed=true",
            "wear.used_life=0.1",
            "wear.time_scale=900",
            "life.tool_life_min=150",
            "run.duration_s=10",
            "noise.level=1",
        ],
    ),
];

/// Time that the runs are given, s.
const DURATION_S: f64 = 2.6;
/// Scenarios in which a reason is tried for a setting.
const TRIED: u32 = 2;

fn base((preset, changes): &(&str, &[&str])) -> Scenario {
    let mut scenario = load(preset).unwrap();
    let changes: Vec<(String, Value)> = changes
        .iter()
        .map(|change| {
            let (path, value) = change.split_once('=').unwrap();
            (path.to_owned(), parse_value(path, value).unwrap())
        })
        .collect();
    scenario.set_all(&changes).unwrap();
    if scenario.plant.force_model.tooth_by_tooth() {
        // 0.1 ms, to be quick.
        let steps = [("run.steps_per_control", 200), ("run.record_every", 50)];
        scenario.set_all(&steps.map(|(path, value)| (path.to_owned(), Value::Int(value)))).unwrap();
    }
    // A prediction of the tool's life takes longer.
    let given = changes.iter().any(|(path, _)| path == "run.duration_s");
    let longest_s = if given { f64::INFINITY } else { DURATION_S };
    let duration_s = scenario.run.duration_s.min(longest_s);
    scenario.set("run.duration_s", Value::Float(duration_s)).unwrap();
    scenario
}

/// Other allowed values of a setting.
fn others(param: &Param, now: &Value) -> Vec<Value> {
    let texts = |ids: &[&str]| ids.iter().map(|id| Value::Text((*id).to_owned())).collect();
    let all: Vec<Value> = match &param.spec.allowed {
        Kind::Float { min, max } => {
            let Value::Float(now) = now else { panic!("{now:?}") };
            let near = if *now == 0.0 { 0.01 * (max - min) } else { 1.1 * now };
            [near, 0.9 * now, 0.5 * (min + max), *max, *min].map(Value::Float).to_vec()
        }
        Kind::Int { min, max } => {
            let Value::Int(now) = now else { panic!("{now:?}") };
            [now + 1, now * 2, *min, (*max).min(1000)].map(Value::Int).to_vec()
        }
        Kind::Bool => [true, false].map(Value::Bool).to_vec(),
        Kind::Choice { options } => texts(&options.iter().map(|o| o.id).collect::<Vec<_>>()),
        Kind::Text { .. } => texts(&["another"]),
        Kind::Structured(shape) => {
            (0..3).flat_map(|pick| [0.5, 0.9].map(|share| shape.example(share, pick))).collect()
        }
    };
    all.into_iter().filter(|value| value != now).collect()
}

/// All that a run says.
fn told(scenario: &Scenario) -> String {
    let run = Run::complete(scenario, &Edits::none());
    let info = &scenario.info;
    let (digest, metrics) = (run.recording().digest(), run.metrics());
    format!("{} {} {digest} {metrics:?} {:?}", info.name, info.description, run.end())
}

#[test]
fn what_is_said_to_be_left_out_changes_nothing_and_everything_else_does_somewhere() {
    let mut seen: BTreeMap<&str, bool> = BTreeMap::new();
    let mut tried: BTreeMap<(&str, &str), u32> = BTreeMap::new();
    let mut wrong = Vec::new();
    for described in BASES {
        let base = base(described);
        let before = told(&base);
        for param in table() {
            let why = base.unused(&param.path).unwrap();
            let known = seen.entry(&param.path).or_default();
            let enough = match why {
                None => *known,
                Some(why) => {
                    let tried = tried.entry((&param.path, why)).or_default();
                    *tried += 1;
                    *tried > TRIED
                }
            };
            if enough {
                continue;
            }
            let now = base.get(&param.path).unwrap();
            for value in others(param, &now) {
                let mut changed = base.clone();
                // With what it brings along: a setting that brings another one is used.
                if changed.set(&param.path, value.clone()).is_err() {
                    continue;
                }
                let same = told(&changed) == before;
                if let Some(why) = why {
                    if !same {
                        wrong.push(format!("{described:?}: {} = {value}: {why}", param.path));
                    }
                    break;
                }
                if !same {
                    *known = true;
                    break;
                }
            }
        }
    }
    assert!(wrong.is_empty(), "said to be left out, but they move a run: {wrong:#?}");
    // Those that only other commands read: no base asks for them.
    let never =
        |path: &str| BASES.iter().all(|described| base(described).unused(path).unwrap().is_some());
    let silent: Vec<&str> =
        seen.iter().filter(|(path, used)| !**used && !never(path)).map(|(path, _)| *path).collect();
    assert!(silent.is_empty(), "neither used nor said to be left out: {silent:?}");
}

#[test]
fn every_reason_names_known_settings_and_is_met_somewhere() {
    for row in UNUSED {
        for path in row.paths.iter().chain(row.but) {
            let known = match path.strip_suffix('.') {
                Some(group) => table().iter().any(|param| param.group == group),
                None => param(path).is_ok(),
            };
            assert!(known, "{path}");
        }
        let met = BASES.iter().any(|described| row.holds(&base(described)));
        assert!(met, "no scenario here leaves out {:?}: {}", row.paths, row.because);
    }
}
