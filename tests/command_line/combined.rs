//! The combined system of 2005: recommendation, plan, neural control.

use std::process::Command;

use steadycut::base::settings::Value;
use steadycut::blocks::control::ControllerKind;
use steadycut::models::plan::PlannedSection;
use steadycut::run::edits::Edits;
use steadycut::run::job::Job;
use steadycut::run::one_run::Run;
use steadycut::run::presets::load;
use steadycut::run::scenario::Scenario;
use steadycut::study::combined::Combined;
use steadycut::study::plan::machine::MachineLimits;
use steadycut::study::recommend::Advisor;
use steadycut::study::recommend::table::Table;

fn combined(scenario: &Scenario, section: PlannedSection) -> Combined {
    let advisor = Advisor::new(&Table::shipped());
    Combined::new(scenario, &advisor, &MachineLimits::heller_bea_01(), section).unwrap()
}

#[test]
fn the_preset_holds_exactly_what_the_steps_give() {
    let preset = load("combined-2005").unwrap();
    let mut given = combined(&load("experiment-2").unwrap(), PlannedSection::Lightest);
    let planned = given.scenario().clone();
    assert_eq!(planned.program, preset.program);
    let renamed = planned.with(|settings| settings.info = preset.info.clone()).unwrap();
    assert_eq!(renamed, preset);
    // Planned once more it stays as it is.
    assert_eq!(*combined(&preset, PlannedSection::Lightest).scenario(), preset);

    // A second of the cut: the scheme sees forces and moves the override, step by step.
    assert_eq!(given.adjusted(), None, "the tool is in the air");
    assert!(!given.advance_by(576 * 150));
    let adjusted = given.adjusted().unwrap();
    assert!(adjusted.periods > 50 && adjusted.periods <= 150, "{adjusted:?}");
    let [low, mean, high] = adjusted.override_percent;
    assert!(low < mean && mean < high && high <= 150.0, "{adjusted:?}");
    assert!(adjusted.measured_mean_n > 300.0 && adjusted.measured_max_n < 1100.0, "{adjusted:?}");
}

#[test]
fn each_step_stays_within_the_one_before() {
    let scenario = load("experiment-2").unwrap();
    for section in [PlannedSection::Lightest, PlannedSection::Heaviest] {
        let given = combined(&scenario, section);
        let (first, second) = (given.recommended(), given.planned());
        let found = &first.recommendation;
        let optimum = &second.optimum;
        assert!(optimum.feasible && !first.checked.feasible, "{section:?}");
        assert!(optimum.cutting_speed_m_min <= found.cutting_speed_m_min.value);
        assert!(optimum.feed_per_tooth_mm <= found.feed_per_tooth_mm.value);
        let scenario = given.scenario();
        assert_eq!(scenario.program.feed_mm_min, optimum.feed_mm_min);
        assert_eq!(scenario.program.spindle_rpm, optimum.speed_rpm);
        assert_eq!(scenario.controller.kind, ControllerKind::Unks);
        let heaviest = section == PlannedSection::Heaviest;
        assert_eq!(found.engagement, if heaviest { "2" } else { "3" });
        // The sections of Experiment 2: A_D 4.75 and R_D 7.31 mm, 2.4 and 3.21 mm.
        let [axial, radial] = first.depths_mm;
        let expected = if heaviest { [4.75, 7.31] } else { [2.4, 3.21] };
        assert!((axial - expected[0]).abs() < 0.01 && (radial - expected[1]).abs() < 0.01);
        assert_eq!((second.heaviest_force_n - optimum.force_n).abs() < 1e-9, heaviest);
    }
}

#[test]
fn a_plan_without_an_answer_cuts_nothing_and_a_part_without_depth_is_refused() {
    let mut scenario = load("experiment-2").unwrap();
    scenario.set("target.force_n", Value::Float(20.0)).unwrap();
    let mut given = combined(&scenario, PlannedSection::Heaviest);
    assert!(!given.planned().optimum.feasible);
    assert!(given.advance_by(1) && given.run().is_none() && given.adjusted().is_none());
    assert_eq!(given.scenario().program, scenario.program);

    let mut air = load("first-cut").unwrap();
    air.change(|s| s.workpiece.axial_depth_mm = 0.0).unwrap();
    air.change(|s| s.workpiece.depth_steps.clear()).unwrap();
    let advisor = Advisor::new(&Table::shipped());
    let machine = MachineLimits::heller_bea_01();
    let error = Combined::new(&air, &advisor, &machine, PlannedSection::Lightest).unwrap_err();
    assert!(error.to_string().contains("workpiece.axial_depth_mm"), "{error}");
}

#[test]
fn the_command_prints_five_steps_and_the_figures_of_the_run() {
    let run = |args: &[&str]| {
        let args = [&["combine", "--scenario", "table3-5"], args].concat();
        let output = Command::new(env!("CARGO_BIN_EXE_steadycut")).args(args).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    };
    let file = std::path::PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("combined.toml");
    let text = run(&["--out", file.to_str().unwrap()]);
    for step in ["\n1  ", "\n2  ", "\n3  ", "\n4  ", "\n5  ", "time of cut", "synthetic"] {
        assert!(text.contains(step), "{step}: {text}");
    }
    let report: serde_json::Value = serde_json::from_str(&run(&["--json"])).unwrap();
    let written = std::fs::read_to_string(&file).unwrap();
    let (scenario, _) = steadycut::run::scenario_file::parse(&written).unwrap();
    assert_eq!(report["planned"]["optimum"]["feed_mm_min"], scenario.program.feed_mm_min);
    // The steps end in the run of the scenario that they give.
    let alone = Run::complete(&scenario, &Edits::none());
    assert_eq!(report["run"]["digest"], alone.recording().digest());
    assert!(report["adjusted"]["periods"].as_u64().unwrap() > 100);
}
