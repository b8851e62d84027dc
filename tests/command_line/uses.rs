//! Every setting with every command that takes `--set`: it changes what is printed, or it is refused with
//! the reason; nothing is dropped in silence. Tried, setting by setting, against what commands print.

use std::collections::BTreeMap;
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};

use steadycut::base::settings::{Kind, Value};
use steadycut::run::presets::load;
use steadycut::run::scenario::{Param, Scenario, parse_value, table};
use steadycut::study::uses::{Reader, Screen, SettingUse};

/// A command line without its `--set`s, and the scenarios that it is tried with: a preset, or the default
/// where it takes none, and what differs from it.
struct Tried {
    reader: Reader,
    words: &'static [&'static str],
    bases: &'static [(&'static str, &'static [&'static str])],
}

/// A short part for runs tooth by tooth.
const SHORT: [&str; 3] = [
    "workpiece.cuts=[[[4.0, 3.0, 2.0]], [[3.0, 2.5, 1.5]]]",
    "run.duration_s=6",
    "run.steps_per_control=288",
];

/// Commands that read less than a run, or other things.
const TRIED: &[Tried] = &[
    Tried {
        reader: Reader::Plan,
        words: &["plan"],
        bases: &[
            ("first-cut", &[]),
            (
                "strategy-2013",
                &[
                    "plan.force_limit=fixed",
                    "plan.free_speed=false",
                    "plan.weight_cost=0.5",
                    "plan.weight_time=0.3",
                ],
            ),
            ("first-cut", &["target.reference=force", "tool.shape=bull_nose"]),
        ],
    },
    Tried {
        reader: Reader::PlanPerCut,
        words: &["plan", "--per-cut", "lightest"],
        bases: &[
            ("experiment-2", &["target.reference=ra", "target.ra_um=2"]),
            (
                "experiment-2",
                &[
                    "plan.force_limit=fixed",
                    "tool.shape=bull_nose",
                    "tool.corner_radius_mm=4",
                    "plan.weight_cost=0.5",
                    "plan.weight_time=0.3",
                ],
            ),
            ("experiment-1", &[]),
        ],
    },
    Tried {
        reader: Reader::Robust,
        words: &["robust", "--runs", "2", "--scenario"],
        bases: &[
            ("experiment-2", &SHORT),
            ("table3-5-noise", &["run.duration_s=3", "controller.kind=tracking"]),
        ],
    },
    Tried {
        reader: Reader::Experiment,
        words: &["experiment", "--factor", "hardness", "--factor", "axial_depth", "--scenario"],
        bases: &[("first-cut", &[])],
    },
    Tried {
        reader: Reader::ExperimentRun,
        words: &["experiment", "--run", "--factor", "hardness", "--scenario"],
        bases: &[("table3-5-noise", &[]), ("machine-dynamics", &["noise.level=1"])],
    },
    Tried {
        reader: Reader::Unks,
        words: &["unks", "--passes", "1"],
        bases: &[("experiment-2", &SHORT), ("table3-5-noise", &["run.duration_s=3"])],
    },
    Tried {
        reader: Reader::Combine,
        words: &["combine", "--scenario"],
        bases: &[("experiment-2", &SHORT)],
    },
    Tried {
        reader: Reader::RunProfile,
        words: &["run", "--profile", "10,3.5,26,3.5"],
        bases: &[("machine-dynamics", &["run.duration_s=8"])],
    },
    Tried {
        reader: Reader::RunRevolution,
        words: &["run", "--revolution", "2"],
        bases: &[("experiment-2", &["run.duration_s=3"])],
    },
    Tried {
        reader: Reader::Run,
        words: &["run"],
        bases: &[("table3-5-noise", &["run.duration_s=3"])],
    },
    Tried {
        reader: Reader::RunTwin,
        words: &["run", "--story"],
        bases: &[("table3-5-noise", &["run.duration_s=3", "workpiece.length_mm=20"])],
    },
    Tried { reader: Reader::MachineModes, words: &["machine", "modes"], bases: &[("", &[])] },
    Tried { reader: Reader::MachineFrf, words: &["machine", "frf"], bases: &[("", &[])] },
    Tried {
        reader: Reader::MachineStability,
        words: &["machine", "stability", "--from", "1500", "--to", "1600", "--speeds", "2"],
        bases: &[
            ("", &[]),
            (
                "",
                &[
                    "workpiece.cuts=[[[30.0, 3.0, 2.0]]]",
                    "tool.shape=bull_nose",
                    "tool.corner_radius_mm=4",
                ],
            ),
            ("", &["machine.tip_modes=[[0.0, 122.0, 0.05, 3.0], [1.0, 140.0, 0.05, 3.0]]"]),
        ],
    },
    Tried {
        reader: Reader::MachineWear,
        words: &["machine", "wear"],
        bases: &[
            ("", &["wear.taylor_life_min=1"]),
            (
                "",
                &[
                    "wear.taylor_life_min=1",
                    "tool.shape=bull_nose",
                    "tool.corner_radius_mm=4",
                    "wear.indentation_n_mm3=50000",
                    "workpiece.axial_depth_mm=3",
                ],
            ),
        ],
    },
    Tried {
        reader: Reader::MachineLife,
        words: &["machine", "life", "--tools", "1"],
        bases: &[(
            "",
            &[
                "wear.taylor_life_min=1",
                "life.tool_life_min=10",
                "wear.indentation_n_mm3=50000",
                "workpiece.axial_depth_mm=3",
            ],
        )],
    },
    Tried {
        reader: Reader::MachineRoughness,
        words: &["machine", "roughness"],
        bases: &[("", &[])],
    },
];

/// Of these a run's own test says which settings it uses: here it counts that nothing is refused by
/// mistake, and that what is refused says why.
const AS_RUN: [Reader; 8] = [
    Reader::ExperimentRun,
    Reader::Run,
    Reader::RunTwin,
    Reader::RunProfile,
    Reader::RunRevolution,
    Reader::Robust,
    Reader::Unks,
    Reader::Combine,
];

fn scenario((preset, changes): &(&str, &[&str])) -> Scenario {
    let mut scenario = if preset.is_empty() { Scenario::default() } else { load(preset).unwrap() };
    let changes: Vec<(String, Value)> = changes
        .iter()
        .map(|change| {
            let (path, value) = change.split_once('=').unwrap();
            (path.to_owned(), parse_value(path, value).unwrap())
        })
        .collect();
    scenario.set_all(&changes).unwrap();
    scenario
}

/// Other allowed values of a setting, as texts.
fn others(param: &Param, now: &Value) -> Vec<String> {
    let all: Vec<Value> = match &param.spec.allowed {
        Kind::Float { min, max } => {
            let Value::Float(now) = now else { panic!("{now:?}") };
            let near = if *now == 0.0 { 0.01 * (max - min) } else { 1.05 * now };
            [near, 0.9 * now, 0.5 * (min + max), *max, *min].map(Value::Float).to_vec()
        }
        Kind::Int { min, max } => {
            let Value::Int(now) = now else { panic!("{now:?}") };
            [now + 1, now * 2, *min, (*max).min(7)].map(Value::Int).to_vec()
        }
        Kind::Bool => [true, false].map(Value::Bool).to_vec(),
        Kind::Choice { options } => {
            options.iter().map(|option| Value::Text(option.id.to_owned())).collect()
        }
        Kind::Text { .. } => vec![Value::Text("another".to_owned())],
        // Learned networks are too long for a command line, and have an option of their own.
        Kind::Structured(_) if param.path == "controller.unks.networks" => Vec::new(),
        Kind::Structured(shape) => (0..3).map(|pick| shape.example(0.5, pick)).collect(),
    };
    let all = all.into_iter().filter(|value| value != now);
    all.map(|value| value.to_string()).collect()
}

/// What a command prints, or its error.
fn printed(
    tried: &Tried,
    (preset, changes): &(&str, &[&str]),
    set: &[String],
) -> Result<String, String> {
    let mut command = Command::new(env!("CARGO_BIN_EXE_steadycut"));
    command.args(tried.words);
    if !preset.is_empty() {
        command.arg(preset);
    }
    for change in changes.iter().map(|change| (*change).to_owned()).chain(set.iter().cloned()) {
        command.args(["--set", &change]);
    }
    if tried.reader != Reader::RunRevolution {
        command.arg("--json");
    }
    let output = command.output().unwrap();
    // A plan that is not feasible, and a study that is not passed, end with 1.
    match output.stdout.is_empty() {
        false => Ok(String::from_utf8(output.stdout).unwrap()),
        true => Err(String::from_utf8(output.stderr).unwrap()),
    }
}

/// What is wrong about a setting with a command.
fn wrong(tried: &Tried, param: &Param, before: &[String]) -> Option<String> {
    let path = &param.path;
    let named = format!("{}: {path}", tried.reader.label());
    let mut accepted = 0;
    for (base, before) in tried.bases.iter().zip(before) {
        let scenario = scenario(base);
        let now = scenario.get(path).unwrap();
        for value in others(param, &now) {
            let mut changed = scenario.clone();
            let fits =
                changed.set_all(&[(path.clone(), parse_value(path, &value).unwrap())]).is_ok();
            let why = tried.reader.unused(&changed, path).unwrap();
            match (printed(tried, base, &[format!("{path}={value}")]), why) {
                (Err(error), Some(why)) if fits => {
                    let said = error.contains("has no use for it") && error.contains(&why);
                    if !said {
                        return Some(format!("{named} = {value}: refused without {why}: {error}"));
                    }
                    break;
                }
                (Ok(_), Some(why)) => return Some(format!("{named} = {value}: taken, but {why}")),
                (Ok(after), None) if after != *before => return None,
                (Ok(_), None) => accepted += 1,
                (Err(error), None) if error.contains(&format!("--set {path}: ")) => {
                    return Some(format!("{named} = {value}: {error}"));
                }
                // A value that does not go with the others.
                (Err(_), _) => {}
            }
        }
    }
    let counts = !AS_RUN.contains(&tried.reader) && accepted > 0;
    counts.then(|| format!("{named}: taken, and nothing printed moves"))
}

#[test]
#[expect(clippy::disallowed_methods, reason = "programs are tried beside each other")]
fn every_setting_is_obeyed_or_refused_by_every_command() {
    let every: Vec<Reader> = TRIED.iter().map(|tried| tried.reader).collect();
    assert!(Reader::ALL.iter().all(|reader| every.contains(reader)), "a command is not tried");
    let before: Vec<Vec<String>> = TRIED
        .iter()
        .map(|tried| tried.bases.iter().map(|base| printed(tried, base, &[]).unwrap()).collect())
        .collect();
    let all: Vec<(usize, &Param)> =
        (0..TRIED.len()).flat_map(|i| table().iter().map(move |param| (i, param))).collect();
    let next = AtomicUsize::new(0);
    let work = || {
        let mut found = Vec::new();
        while let Some((i, param)) = all.get(next.fetch_add(1, Ordering::Relaxed)) {
            found.extend(wrong(&TRIED[*i], param, &before[*i]));
        }
        found
    };
    let threads = std::thread::available_parallelism().map_or(2, usize::from);
    let found: Vec<String> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        threads.into_iter().flat_map(|thread| thread.join().unwrap()).collect()
    });
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn a_screen_greys_what_nothing_on_it_uses_and_says_why() {
    let scenario = Scenario::default();
    let because = |screen: Screen, path: &str| screen.greyed(&scenario, path);
    for (path, named) in [
        ("noise.sensor_n", "`noise.level`"),
        ("machine.spindle_quality", "`machine.coupled`"),
        ("controller.mrac.pole", "`controller.kind`"),
        ("wear.taylor_exponent", "`wear.model`"),
    ] {
        let because = because(Screen::Console, path).unwrap();
        assert!(because.contains(named), "{path}: {because}");
    }
    assert_eq!(because(Screen::Console, "noise.level"), None);
    // Charts have it whether the cut feels the machine or not.
    assert_eq!(because(Screen::Machine, "machine.spindle_quality"), None);
    assert_eq!(because(Screen::Plan, "plan.particles"), None);
    assert!(because(Screen::Plan, "plan.force_max_n").unwrap().contains("`plan.force_limit`"));
}

#[test]
fn the_table_of_uses_is_printed_whole() {
    let output =
        Command::new(env!("CARGO_BIN_EXE_steadycut")).args(["list", "--uses", "--json"]).output();
    let list: serde_json::Value = serde_json::from_slice(&output.unwrap().stdout).unwrap();
    let rows = list["settings"].as_array().unwrap();
    let by_path: BTreeMap<&str, &serde_json::Value> =
        rows.iter().map(|row| (row["path"].as_str().unwrap(), row)).collect();
    for param in table() {
        let row = by_path[param.path.as_str()];
        for reader in Reader::ALL {
            let told = &row["commands"][reader.id()];
            match reader.uses(param) {
                SettingUse::Used { .. } => assert_eq!(told["use"], "used"),
                SettingUse::Refused { because } => {
                    assert_eq!(
                        (&told["use"], &told["because"]),
                        (&"refused".into(), &because.into())
                    );
                }
            }
        }
        assert!(row["screens"]["console"].is_string(), "{row}");
    }
    let text = Command::new(env!("CARGO_BIN_EXE_steadycut")).args(["list", "--uses"]).output();
    let text = String::from_utf8(text.unwrap().stdout).unwrap();
    assert!(table().iter().all(|param| text.lines().any(|line| line == param.path)));
}
