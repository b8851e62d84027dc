//! The screens "Block diagram" and "Papers", driven by their accessible names.

use crate::screen::{self, Screen, texts};
use egui::accesskit::Role;
use egui_kittest::kittest::{NodeT, Queryable};
use steadycut::app::Console;
use steadycut::base::settings::Value;
use steadycut::blocks::control::ControllerKind;
use steadycut::blocks::cutting::process::ForceModel;
use steadycut::models::feed_drive::FeedDriveKind;
use steadycut::models::genetic::{Calibration, ModelSet};
use steadycut::run::diagram::{BLOCKS, Block};
use steadycut::study::errata;
use steadycut::study::published::PaperId;

/// The console on the screen with this title, at the end of a preset's cut.
fn open<'a>(preset: &str, size: [f32; 2], title: &str, change: &[(&str, Value)]) -> Screen<'a> {
    let mut harness = screen::open(preset, size.into(), title, change);
    // To the end of the cut, where the picture stands still.
    harness.key_press(egui::Key::End);
    harness.run_steps(4);
    harness
}

fn console<'a>(harness: &'a Screen<'_>) -> &'a Console {
    harness.state().as_ref().expect("made in the first frame")
}

const SIZES: [[f32; 2]; 2] = [[1280.0, 800.0], [390.0, 844.0]];

#[test]
fn a_click_on_a_block_opens_its_equation_card() {
    for size in SIZES {
        let mut harness = open("table3-5", size, "Block diagram", &[]);
        harness.get_by_role_and_label(Role::Button, "Reference K1").click();
        harness.run_steps(2);
        let shown = texts(&harness);
        assert!(shown.contains("F_d = 293 - 593 / √(39.37 Ra)"), "{shown}");
        assert!(shown.contains("SDNRP 2007, eq. 4"), "{shown}");
        assert!(shown.contains("identified"), "{shown}");
        let force = console(&harness).session().row().force_ref_n;
        assert!(shown.contains(&format!("= {force:.1} N")), "{force} in {shown}");

        assert!(!shown.contains("the finish constant"), "words only on request");
        harness.get_by_label("What is this?").click();
        harness.run_steps(2);
        assert!(texts(&harness).contains("the finish constant"));
    }
}

fn text(text: &str) -> Value {
    Value::Text(text.to_owned())
}

#[test]
fn every_card_opens_for_every_controller_calibration_set_and_force_model() {
    // A character that no font has would end the test. So many windows that every set meets every force
    // model and every controller is there; `live/tests.rs` has all of them with all, without a window.
    let (sets, forces) = (ModelSet::ALL, ForceModel::ALL);
    for i in 0..(sets.len() * forces.len()).max(ControllerKind::ALL.len()) {
        let kind = ControllerKind::ALL[i % ControllerKind::ALL.len()];
        let (set, force) = (sets[i % sets.len()], forces[i / sets.len() % forces.len()]);
        let published = Calibration::PUBLISHED;
        let calibration = published[i % published.len()].id();
        let change = [
            // Fine enough for the cut tooth by tooth.
            ("run.steps_per_control", Value::Int(576)),
            ("controller.kind", text(kind.id())),
            ("plant.model_set", text(set.id())),
            ("plant.force_model", text(force.id())),
            // After those that bring it with them.
            ("belief.model_set", text(set.id())),
            ("plant.calibration", text(calibration)),
            ("belief.calibration", text(calibration)),
            ("cnc.override_quantised", Value::Bool(i > 2)),
            ("cnc.override_rate_limited", Value::Bool(i > 2)),
            ("feed_drive.kind", text(FeedDriveKind::ALL[i % FeedDriveKind::ALL.len()].id())),
        ];
        let mut harness = open("table3-5-noise", [1280.0, 1400.0], "Block diagram", &change);
        let scenario = console(&harness).session().current().clone();
        for info in BLOCKS {
            harness.get_by_role_and_label(Role::Button, &info.title(&scenario)).click();
            harness.run_steps(2);
            let shown = texts(&harness);
            for printed in info.block.printed(&scenario) {
                assert!(shown.contains(printed.formula), "{} in {shown}", printed.formula);
            }
            if info.block == Block::Controller {
                assert_eq!(scenario.belief.model_set, set);
                for law in scenario.controller.printed(set) {
                    assert!(shown.contains(law.formula), "{kind:?}: {} in {shown}", law.formula);
                    assert!(shown.contains(law.source), "{kind:?}: {} in {shown}", law.source);
                }
            }
        }
    }
}

#[test]
fn a_click_on_a_wire_plots_its_signal() {
    // High enough to show the whole card.
    let mut harness = open("table3-5", [1280.0, 1400.0], "Block diagram", &[]);
    harness.get_by_label("Plot Spindle command, after dead time").click();
    harness.run_steps(2);
    harness.get_by_role_and_label(Role::Label, "Spindle command, after dead time");
    // A signal that has no wire of its own is plotted from the card.
    harness.get_by_role_and_label(Role::Button, "Controller K2, K3").click();
    harness.run_steps(2);
    harness.get_by_role_and_label(Role::Button, "Force setpoint").click();
    harness.run_steps(2);
    harness.get_by_role_and_label(Role::Label, "Force setpoint");
}

#[test]
fn wires_and_lamps_tell_their_state() {
    let offset = ("plant.force_offset_n", Value::Float(100.0));
    let printed = ("belief.calibration", Value::Text("printed".to_owned()));
    let harness = open("table3-1", SIZES[0], "Block diagram", &[offset, printed]);
    let row = *console(&harness).session().row();
    let wire = harness.get_by_label("Plot Feed");
    let value = wire.accesskit_node().value().unwrap_or_default();
    assert_eq!(value, format!("{:.0} mm/min", row.feed_mm_min));
    let controller = harness.get_by_role_and_label(Role::Button, "Controller K2, K3");
    let state = controller.accesskit_node().value().unwrap_or_default();
    assert!(state.contains("K2 outside its range"), "{state}");
}

#[test]
fn the_diagram_can_be_used_from_the_keyboard() {
    let mut harness = open("table3-5", SIZES[0], "Block diagram", &[]);
    harness.get_by_role_and_label(Role::Button, "Dynamometer").focus();
    harness.run_steps(2);
    harness.key_press(egui::Key::Enter);
    harness.run_steps(2);
    assert!(texts(&harness).contains("sensor noise"));
}

#[test]
fn overrides_are_shown_as_the_cnc_takes_them() {
    let change = [
        ("cnc.override_quantised", Value::Bool(true)),
        ("cnc.override_rate_limited", Value::Bool(true)),
        ("cnc.override_rate_percent_s", Value::Float(20.0)),
    ];
    for size in SIZES {
        let mut harness = open("strategy-table1-5", size, "Block diagram", &change);
        harness.get_by_role_and_label(Role::Slider, "Playhead").set_value_accesskit(1.0);
        harness.run_steps(3);
        let row = *console(&harness).session().row();
        let wire = harness.get_by_label("Plot Feed override");
        let value = wire.accesskit_node().value().unwrap_or_default();
        assert_eq!(value, format!("{} %", row.feed_override_percent));
        let limits = harness.get_by_role_and_label(Role::Button, "Override limits");
        let state = limits.accesskit_node().value().unwrap_or_default();
        assert!(state.contains("feed override at its rate"), "{state}");
        limits.click();
        harness.run_steps(2);
        let shown = texts(&harness);
        assert!(shown.contains("DNCFRO") && shown.contains("round(ramp)"), "{shown}");
        harness.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::Num1);
        harness.run_steps(3);
        let said = format!("Feed override at the playhead: {} %", row.feed_override_percent);
        let shown = texts(&harness);
        assert!(shown.contains(&said), "{said} in {shown}");
        assert!(shown.contains("Override on its way: feed, spindle now"), "{shown}");
    }
}

#[test]
fn the_papers_screen_follows_the_calibration() {
    let mut harness = open("first-cut", SIZES[0], "Papers", &[]);
    screen::rest(&mut harness);
    assert!(texts(&harness).contains("40 of 40 final values met"));
    assert!(texts(&harness).contains("195.2 (compared with 190.2)"));
    assert!(texts(&harness).contains("taken as a misprint"));
    harness.get_by_label("as printed").click();
    screen::rest(&mut harness);
    let shown = texts(&harness);
    assert!(!shown.contains("40 of 40 final") && shown.contains("K2 outside its range"), "{shown}");
    harness.get_by_label("identified").click();
    screen::rest(&mut harness);
    assert!(texts(&harness).contains("40 of 40 final values met"));
}

#[test]
fn the_papers_screen_has_both_papers_and_every_force_model() {
    for size in SIZES {
        let mut harness = open("first-cut", size, "Papers", &[]);
        screen::rest(&mut harness);
        harness.get_by_label(PaperId::Strategy2013.label()).click();
        screen::rest(&mut harness);
        let shown = texts(&harness);
        assert!(shown.contains("32 of 32 final values met"), "{shown}");
        assert!(shown.contains("Initial force") && !shown.contains("Desired force"), "{shown}");
        assert!(shown.contains("Ra is off by +10.0 % in simulation 1"), "{shown}");
        for erratum in errata::of(PaperId::Strategy2013) {
            let problem = erratum.problem.replace(" um", " \u{b5}m");
            assert!(shown.contains(&problem), "{problem} in {shown}");
        }
        harness.get_by_label("as printed").click();
        screen::rest(&mut harness);
        assert!(texts(&harness).contains("M2 outside its range"), "{}", texts(&harness));
        harness.get_by_label("identified").click();
        for force_model in &ForceModel::maps()[1..] {
            harness.get_by_label(force_model.label()).click();
            screen::rest(&mut harness);
            let shown = texts(&harness);
            assert!(shown.contains("Final values as they are"), "{shown}");
            assert!(!shown.contains("missed"), "{shown}");
        }
    }
}

#[test]
fn no_row_of_a_table_moves_while_the_others_come_in() {
    for size in SIZES {
        for force_model in ForceModel::maps() {
            let mut harness = screen::open("first-cut", size.into(), "Papers", &[]);
            harness.get_by_label(force_model.label()).click();
            harness.run_steps(1);
            let first = |harness: &Screen<'_>| {
                let load = harness.query_by_label("Load table3-1").map(|load| load.rect().top());
                (harness.get_by_label_contains("Each row is run in time").rect(), load)
            };
            let (text, _) = first(&harness);
            let mut tops: Vec<f32> = Vec::new();
            let rested = screen::in_time(|| {
                harness.run_steps(1);
                let (now, load) = first(&harness);
                assert_eq!(now, text, "{size:?} {}", force_model.label());
                tops.extend(load);
                console(&harness).jobs().is_at_rest()
            });
            assert!(rested, "{}", texts(&harness));
            // Its grid knows the height of a row in the frame after that in which it comes.
            let [_, before, .., last] = tops[..] else { panic!("{tops:?}") };
            assert!((last - before).abs() < 1.0, "{size:?}: {tops:?}");
        }
    }
}

#[test]
fn load_brings_a_row_into_the_console() {
    for size in SIZES {
        let mut harness = open("first-cut", size, "Papers", &[]);
        screen::rest(&mut harness);
        harness.get_by_label("restored").click();
        screen::rest(&mut harness);
        harness.get_by_label("Load table3-2").click_accesskit();
        harness.run_steps(3);
        let scenario = console(&harness).session().scenario();
        assert_eq!(scenario.info.name, "table3-2 (restored)");
        assert_eq!(scenario.plant.calibration, Calibration::Restored);
        assert_eq!(scenario.belief.calibration, Calibration::Restored);
        assert!(console(&harness).state_json().contains("\"screen\":\"console\""));
    }
}

#[test]
fn load_keeps_paper_and_force_model() {
    let mut harness = open("first-cut", SIZES[0], "Papers", &[]);
    screen::rest(&mut harness);
    harness.get_by_label(PaperId::Strategy2013.label()).click();
    screen::rest(&mut harness);
    harness.get_by_label(ForceModel::Neural.label()).click();
    screen::rest(&mut harness);
    harness.get_by_label("Load strategy-table1-3").click();
    harness.run_steps(3);
    let scenario = console(&harness).session().scenario();
    assert_eq!(scenario.info.name, "strategy-table1-3 (Neural network)");
    assert_eq!(scenario.plant.model_set, ModelSet::Strategy2013);
    assert_eq!(scenario.plant.force_model, ForceModel::Neural);
}

#[test]
fn the_papers_screen_has_the_combined_system_and_the_machine() {
    for size in SIZES {
        let mut harness = open("first-cut", size, "Papers", &[]);
        screen::rest(&mut harness);
        harness.get_by_label("Dynamic model 2019, Table 1").click();
        screen::rest(&mut harness);
        let shown = texts(&harness);
        assert!(shown.contains("exponent of the spring wrong: 8, not 12"), "{shown}");
        assert!(shown.contains("109.93") && shown.contains("no published curve"), "{shown}");
        harness.get_by_label("Combined system 2005, Table 1").click();
        screen::rest(&mut harness);
        let shown = texts(&harness);
        for erratum in errata::COMBINED_2005 {
            let problem = erratum.problem.replace(" um", " \u{b5}m");
            assert!(shown.contains(&problem), "{problem} in {shown}");
        }
        harness.get_by_label("Open Compare").click();
        harness.run_steps(3);
        assert!(console(&harness).state_json().contains("\"screen\":\"compare\""));
    }
}
