//! The screen "Compare", driven by its accessible names.

use crate::screen;

use crate::screen::{Screen, texts};
use egui::accesskit::Role;
use egui::{Vec2, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable};
use steadycut::app::Console;
use steadycut::base::settings::Value;
use steadycut::blocks::control::ControllerKind;
use steadycut::study::compare::table_1::{DISCLOSED, NOT_REACHED};

const SIZES: [Vec2; 2] = [vec2(1280.0, 2400.0), vec2(390.0, 4200.0)];

/// The screen on a scenario of two seconds.
fn open<'a>(size: Vec2) -> Screen<'a> {
    let changes = [("run.duration_s", Value::Float(2.0))];
    screen::open("table3-5-noise", size, "Compare", &changes)
}

fn console<'a>(screen: &'a Screen<'_>) -> &'a Console {
    screen.state().as_ref().expect("made in the first frame")
}

fn click(screen: &mut Screen, name: &str) {
    screen.get_by_label(name).click();
    screen.run_steps(2);
}

/// To the end of the comparison.
fn finish(screen: &mut Screen) {
    click(screen, "Run the comparison");
    for _ in 0..400 {
        screen.run_steps(1);
        if texts(screen).contains("\ndone") {
            return;
        }
    }
    panic!("{}", texts(screen));
}

#[test]
fn it_opens_on_table_1_with_what_was_chosen_in_view_of_it() {
    for size in SIZES {
        let screen = open(size);
        let shown = texts(&screen);
        assert!(shown.contains("printed 0.35") && shown.contains("printed 115"), "{shown}");
        for line in DISCLOSED.iter().chain(NOT_REACHED) {
            assert!(shown.contains(&line.replace("um", "µm")), "{line}");
        }
        assert!(shown.contains("(figures of version ") && !shown.contains("least Nsn"), "{shown}");
        assert!(shown.contains("From a section of 493 N into one of 772 N"), "{shown}");
        assert!(shown.contains("0 of 180 runs done"), "{shown}");
        assert!(shown.contains("judged when the six methods of the table have run"));
    }
}

#[test]
fn the_open_scenario_is_compared_and_the_table_fills() {
    for size in SIZES {
        let mut screen = open(size);
        click(&mut screen, "Part: Open scenario");
        let shown = texts(&screen);
        assert!(!shown.contains("printed 0.35"), "Table 1 does not belong to it");
        assert!(shown.contains("No values yet"));
        screen.get_by_role_and_label(Role::SpinButton, "Seeds").set_value_accesskit(2.0);
        screen.run_steps(2);
        finish(&mut screen);
        let shown = texts(&screen);
        assert!(shown.contains("2 of 2 not finished"), "two seconds are too short: {shown}");
        assert!(shown.contains('±') && !shown.contains("No values yet"), "{shown}");
        // A time or a low force is no victory outside the tolerance.
        assert!(shown.contains("the tolerance on 90 % of the length"), "{shown}");
        assert!(shown.contains("Box plots of Nsn, 18 of 18 runs"), "{shown}");
        click(&mut screen, "Spread of Largest force");
        assert!(texts(&screen).contains("Box plots of Largest force [kN]"));
        // What was done is kept, and more seeds go on from there.
        click(&mut screen, "Dead time: 0 ms");
        assert!(texts(&screen).contains("0 of 18 runs done"));
        click(&mut screen, "Dead time: as it is");
        screen.get_by_role_and_label(Role::SpinButton, "Seeds").set_value_accesskit(3.0);
        screen.run_steps(2);
        assert!(texts(&screen).contains("18 of 27 runs done"), "{}", texts(&screen));
    }
}

#[test]
fn who_takes_part_can_be_chosen_and_a_run_loaded() {
    let mut screen = open(SIZES[0]);
    click(&mut screen, "Part: Open scenario");
    let all =
        ["Conventional", "Division", "P", "MRAC", "UNKS", "P, Smith predictor", "MRAC, one gain"];
    for name in all {
        screen.get_by_role_and_label(Role::Button, name).click();
        screen.run_steps(2);
    }
    assert!(screen.query_by_label("Load UNKS").is_none());
    // The two of the first screen can take part.
    for name in ["SDNRP", "Tracking"] {
        assert!(screen.query_by_label(&format!("Load {name}")).is_none());
        screen.get_by_role_and_label(Role::Button, name).click();
        screen.run_steps(2);
        assert!(screen.query_by_label(&format!("Load {name}")).is_some(), "{name}");
    }
    click(&mut screen, "Load Adjustable PI");
    let session = console(&screen).session();
    assert_eq!(session.scenario().controller.kind, ControllerKind::AdjustablePi);
    assert!(console(&screen).state_json().contains("\"screen\":\"console\""));
}

#[test]
fn nobody_is_said_so() {
    let mut screen = open(SIZES[0]);
    let all = ["Conventional", "Division", "P", "Adjustable PI", "MRAC", "UNKS"];
    for name in all.into_iter().chain(["P, Smith predictor", "MRAC, one gain", "Preview"]) {
        screen.get_by_role_and_label(Role::Button, name).click();
        screen.run_steps(2);
    }
    assert!(texts(&screen).contains("Nobody takes part"));
}

/// Everything fits a phone once there are results of the part of 2005, printed figures among them.
#[test]
fn the_results_of_the_2005_part_fit_a_phone() {
    let mut screen = screen::open("table3-5-noise", SIZES[1], "Compare", &[]);
    let away = ["Division", "Adjustable PI", "MRAC", "UNKS", "P, Smith predictor"];
    for name in away.into_iter().chain(["MRAC, one gain", "Preview"]) {
        screen.get_by_role_and_label(Role::Button, name).click();
        screen.run_steps(2);
    }
    screen.get_by_role_and_label(Role::SpinButton, "Seeds").set_value_accesskit(2.0);
    screen.run_steps(2);
    click(&mut screen, "Run the comparison");
    for _ in 0..20_000 {
        screen.run_steps(1);
        if texts(&screen).contains("\ndone") {
            break;
        }
    }
    screen.run_steps(4);
    let shown = texts(&screen);
    assert!(shown.contains("\ndone") && shown.contains("printed 115, "), "{shown}");
    assert!(shown.contains("within the spread") || shown.contains("the best"), "{shown}");
    let width = SIZES[1].x;
    let figures = ["printed ", "± ", "Longest overload", "Box plots of", "Mean and standard"];
    let mut seen = 0;
    for node in screen.root().children_recursive() {
        let told = node.accesskit_node();
        let label = told.label().or_else(|| told.value()).unwrap_or_default();
        if figures.iter().any(|begin| label.starts_with(begin)) {
            let right = node.rect().right();
            assert!(right <= width, "{label}: up to {right} of {width} points");
            seen += 1;
        }
    }
    assert!(seen > 20, "{seen} figures");
}

/// Changes in the running cut are not compared, and that is said.
#[test]
fn the_open_scenario_s_edits_are_said_to_be_left_out() {
    let later = [(1.0, "target.ra_um", Value::Float(0.7))];
    for (later, left_out) in [(&later[..], true), (&[][..], false)] {
        let mut screen = screen::edited("first-cut", SIZES[0], "Compare", &[], later);
        assert!(!texts(&screen).contains("left out, since"));
        click(&mut screen, "Part: Open scenario");
        let shown = texts(&screen);
        assert_eq!(shown.contains("1 change in its running cut left out"), left_out, "{shown}");
    }
}
