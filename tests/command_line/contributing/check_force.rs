//! Asks a core that has the force model of CONTRIBUTING.md for all that the guide promises of it.

use steadycut_core::base::settings::Value;
use steadycut_core::blocks::control::ControllerKind;
use steadycut_core::blocks::cutting::process::ForceModel;
use steadycut_core::models::genetic::ModelSet;
use steadycut_core::run::diagram::Block;
use steadycut_core::run::edits::Edits;
use steadycut_core::run::explanation::explain_force;
use steadycut_core::run::one_run::Run;
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario_file;

fn main() {
    let model = ForceModel::from_id("power").expect("in the list");
    assert_eq!(ForceModel::ALL.last(), Some(&model));
    assert!(model.is_map() && ForceModel::maps().contains(&model) && !model.is_formula());
    assert_eq!(
        (model.label(), model.short_name(ModelSet::Sdnrp2007)),
        ("Power law", "power".into())
    );
    assert_eq!((model.longest_step_s(), model.network()), (f64::INFINITY, None));

    // In a file, and back.
    let mut scenario = load("table3-5").expect("shipped");
    scenario.set("plant.force_model", Value::Text("power".to_owned())).expect("a force model");
    let file = scenario_file::write(&scenario, &Edits::none());
    assert_eq!(scenario_file::parse(&file).expect("as written").0, scenario);

    // The plant runs by it: F = 1500 A_D f_z^0.75, worn by 1.2.
    let run = |constant: bool, cuts: bool| {
        let mut scenario = scenario.clone();
        let change = scenario.change(|s| {
            s.plant.wear_factor = 1.2;
            if constant {
                s.controller.kind = ControllerKind::ConstantFeed;
            }
            if cuts {
                s.workpiece.cuts = vec![vec![[20.0, 2.0, 2.0]], vec![[20.0, 3.0, 2.0]]];
            }
        });
        change.expect("these settings fit");
        (scenario.clone(), Run::complete(&scenario, &Edits::none()))
    };
    let (scenario, cut) = run(true, false);
    let last = *cut.recording().rows().last().expect("a row");
    let per_tooth_mm = last.feed_mm_min / (2.0 * last.spindle_rpm);
    let expected_n = 1.2 * 1500.0 * 2.0 * per_tooth_mm.powf(0.75);
    assert!((last.force_n / expected_n - 1.0).abs() < 1e-9, "{last:?}");
    // A controller holds it, and several cuts are entered and left.
    let (_, held) = run(false, false);
    assert!(held.metrics().force_final_n != Some(last.force_n));
    let (_, several) = run(true, true);
    let forces: Vec<f64> = several.recording().rows().iter().map(|row| row.force_n).collect();
    assert!(forces.iter().filter(|force| **force == 0.0).count() > 100, "there is air");
    let largest = forces.iter().copied().fold(0.0, f64::max);
    assert!((largest / expected_n - 1.5).abs() < 1e-6, "{largest} N in the deeper one");

    // Its equation, with its source and with values.
    let printed = Block::Cutting.printed(&scenario);
    assert!(printed[0].formula.contains("f_z") && printed[0].source.contains("textbook"));
    let lines = explain_force(&scenario, &last);
    assert_eq!(lines[0].formula, "F = 1500 A_D f_z^{0.75}");
    assert!(lines[0].values.starts_with("F = "), "{lines:?}");
}
