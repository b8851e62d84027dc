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
    let mut screen = screen::open("table3-5-noise", size, "Compare", &changes);
    unfold(&mut screen);
    screen
}

/// The settings of the comparison, which a phone folds away.
fn unfold(screen: &mut Screen) {
    if screen.query_by_label("Settings of the comparison").is_some() {
        click(screen, "Settings of the comparison");
        screen.run_steps(6);
    }
}

fn console<'a>(screen: &'a Screen<'_>) -> &'a Console {
    screen.state().as_ref().expect("made in the first frame")
}

fn click(screen: &mut Screen, name: &str) {
    screen.get_by_label(name).click();
    screen.run_steps(2);
}

/// Everybody but these is taken out of what is compared.
fn leave(screen: &mut Screen, names: &[&str]) {
    let all = ["Conventional", "Division", "P", "Adjustable PI", "MRAC", "UNKS"];
    let all = all.into_iter().chain(["P, Smith predictor", "MRAC, one gain", "Preview"]);
    for name in all.chain(["SDNRP", "Tracking", "AFC"]).filter(|name| !names.contains(name)) {
        if screen.query_by_label(&format!("Load {name}")).is_some() {
            screen.get_by_role_and_label(Role::Button, name).click();
            screen.run_steps(2);
        }
    }
}

/// To the end of the comparison.
fn finish(screen: &mut Screen) {
    click(screen, "Run the comparison");
    let done = crate::screen::in_time(|| {
        screen.run_steps(1);
        texts(screen).contains("\ndone")
    });
    assert!(done, "{}", texts(screen));
}

#[test]
fn table_1_stands_with_what_was_chosen_in_view_of_it() {
    for size in SIZES {
        let mut screen = open(size);
        click(&mut screen, "Part: Experiment 2");
        let shown = texts(&screen);
        assert!(shown.contains("printed 0.35") && shown.contains("printed 115"), "{shown}");
        for line in DISCLOSED.iter().chain(NOT_REACHED) {
            assert!(shown.contains(&line.replace("um", "µm")), "{line}");
        }
        assert!(shown.contains("(figures of version ") && !shown.contains("least Nsn"), "{shown}");
        assert!(shown.contains("From a section of 493 N into one of 772 N"), "{shown}");
        assert!(shown.contains("0 of 180 runs done"), "{shown}");
        assert!(shown.contains("judged when the six methods of the table have run"));
        // Why two are off here.
        assert!(
            shown.contains("its Table 1 does not know them. Off until they are chosen."),
            "{shown}"
        );
    }
}

#[test]
fn the_open_scenario_is_compared_and_the_table_fills() {
    for size in SIZES {
        let mut screen = open(size);
        let shown = texts(&screen);
        assert!(shown.contains("(table3-5-noise), from its start, with the settings"), "{shown}");
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
        assert!(shown.contains("Box plots of Nsn, 24 of 24 runs"), "{shown}");
        // Below the table of everybody it may be out of sight.
        screen.get_by_label("Spread of Largest force").click_accesskit();
        screen.run_steps(2);
        assert!(texts(&screen).contains("Box plots of Largest force [kN]"));
        // What was done is kept, and more seeds go on from there.
        click(&mut screen, "Dead time: 0 ms");
        assert!(texts(&screen).contains("0 of 24 runs done"));
        click(&mut screen, "Dead time: as it is");
        screen.get_by_role_and_label(Role::SpinButton, "Seeds").set_value_accesskit(3.0);
        screen.run_steps(2);
        assert!(texts(&screen).contains("24 of 36 runs done"), "{}", texts(&screen));
    }
}

/// Is my own script better? It takes part where the console runs it, on the parts of 2005 as well, and nowhere else.
#[test]
fn a_script_of_ones_own_takes_part_where_the_console_runs_one() {
    let mut without = open(SIZES[0]);
    assert!(
        without.query_by_label("Own script").is_none() && !texts(&without).contains("Own script")
    );
    without.run_steps(1);
    assert!(texts(&without).contains("0 of 56 runs"), "{}", texts(&without));
    let mut screen = screen::open("own-controller", SIZES[0], "Compare", &[]);
    // It meets the changed conditions, too: four, with two seeds.
    assert!(texts(&screen).contains("0 of 64 runs"), "{}", texts(&screen));
    assert!(screen.query_by_label("Load Own script").is_some(), "{}", texts(&screen));
    leave(&mut screen, &["P"]);
    screen.get_by_role_and_label(Role::SpinButton, "Seeds").set_value_accesskit(1.0);
    screen.run_steps(2);
    finish(&mut screen);
    assert!(texts(&screen).contains("2 of 2 runs done") || texts(&screen).contains("\ndone"));
    click(&mut screen, "Part: Experiment 2");
    assert!(screen.query_by_label("Load Own script").is_some(), "{}", texts(&screen));
}

#[test]
fn who_takes_part_can_be_chosen_and_a_run_loaded() {
    let mut screen = open(SIZES[0]);
    // The two of the first screen take part in its cut.
    for name in ["SDNRP", "Tracking"] {
        assert!(screen.query_by_label(&format!("Load {name}")).is_some(), "{name}");
    }
    leave(&mut screen, &["Adjustable PI", "Preview"]);
    for name in ["SDNRP", "UNKS"] {
        assert!(screen.query_by_label(&format!("Load {name}")).is_none(), "{name}");
    }
    click(&mut screen, "Load Adjustable PI");
    let session = console(&screen).session();
    assert_eq!(session.scenario().controller.kind, ControllerKind::AdjustablePi);
    assert!(console(&screen).state_json().contains("\"screen\":\"console\""));
}

#[test]
fn nobody_is_said_so() {
    let mut screen = open(SIZES[0]);
    leave(&mut screen, &[]);
    assert!(texts(&screen).contains("Nobody takes part"));
}

/// Everything fits a phone once there are results of the part of 2005, printed figures among them.
#[test]
fn the_results_of_the_2005_part_fit_a_phone() {
    let mut screen = screen::open("table3-5-noise", SIZES[1], "Compare", &[]);
    unfold(&mut screen);
    click(&mut screen, "Part: Experiment 2");
    leave(&mut screen, &["Conventional", "P"]);
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

/// With which settings? Those that the console shows: what was changed in the running cut holds from the start.
#[test]
fn the_console_s_cut_is_compared_with_the_settings_of_now() {
    let later =
        [(0.02, "target.ra_um", Value::Float(0.7)), (40.0, "noise.level", Value::Float(2.0))];
    for (later, changed) in [(&later[..], true), (&[][..], false)] {
        let mut screen = screen::edited("first-cut", SIZES[0], "Console", &[], later);
        screen.run_steps(10);
        screen::show(&mut screen, "Compare");
        let shown = texts(&screen);
        let said =
            "Not repeated at their times: Target Ra (last at 0.02 s), Noise (last at 40.00 s).";
        assert_eq!(shown.contains(said), changed, "{shown}");
        click(&mut screen, "Load SDNRP");
        let opened = console(&screen).session().scenario();
        let now = if changed { 0.7 } else { 0.81 };
        assert_eq!((opened.target.ra_um, opened.noise.level), (now, 0.5));
        assert!(console(&screen).session().edits().list().is_empty());
    }
}

/// Who won? It stands above the table, and while runs are missing it says of how many it is, as the saved file does.
#[test]
fn what_it_comes_to_stands_above_the_table_and_says_of_how_many_runs() {
    for size in SIZES {
        let mut screen = open(size);
        leave(&mut screen, &["SDNRP", "Tracking"]);
        screen.get_by_role_and_label(Role::SpinButton, "Seeds").set_value_accesskit(500.0);
        screen.run_steps(2);
        click(&mut screen, "Run the comparison");
        crate::screen::in_time(|| {
            screen.run_steps(1);
            texts(&screen).contains("So far, ")
        });
        // A row as soon as its first run is done, and the time that is left.
        let shown = texts(&screen);
        assert!(shown.contains("So far, ") && shown.contains(" of 1000 runs done: "), "{shown}");
        assert!(shown.contains(" left"), "{shown}");
        let summary = screen.get_by_label_contains("So far, ").rect();
        assert!(summary.bottom() <= screen.get_by_label("Load SDNRP").rect().top());
        click(&mut screen, "Pause the comparison");
        screen.get_by_label("Save comparison as CSV").hover();
        screen.run_steps(30);
        assert!(
            texts(&screen).contains("Save comparison as CSV, not whole yet: "),
            "{}",
            texts(&screen)
        );
    }
}

/// Is Conventional the constant feed of the console? It says so, where it is chosen and under its own name there.
#[test]
fn conventional_says_what_it_is_on_the_console() {
    let mut screen = open(SIZES[0]);
    screen.get_by_role_and_label(Role::Button, "Conventional").hover();
    screen.run_steps(30);
    let shown = texts(&screen);
    for told in
        ["Conventional (constant feed): ", "the papers call conventional", "safe constant feed"]
    {
        assert!(shown.contains(told), "{told} in {shown}");
    }
}

/// Is it unstable? As the console says it: no error "at rest", nothing put down to noise where there is none, and no
/// spread over seeds that change nothing.
#[test]
fn an_unstable_loop_is_called_so_and_equal_seeds_have_no_spread() {
    for size in SIZES {
        let changes = [
            ("run.duration_s", Value::Float(20.0)),
            ("noise.level", Value::Float(0.0)),
            ("controller.sdnrp.kp", Value::Float(4.0)),
            ("cnc.dead_time_s", Value::Float(0.3)),
        ];
        let mut screen = screen::open("first-cut", size, "Compare", &changes);
        unfold(&mut screen);
        leave(&mut screen, &["Conventional", "SDNRP"]);
        screen.get_by_role_and_label(Role::SpinButton, "Seeds").set_value_accesskit(2.0);
        screen.run_steps(2);
        finish(&mut screen);
        click(&mut screen, "Why not all hold the tolerance");
        screen.run_steps(8);
        let shown = texts(&screen);
        assert!(shown.contains("2 of 2 unstable"), "{shown}");
        assert!(shown.contains("it is unstable, feed and force swing"), "{shown}");
        assert!(!shown.contains("at rest") && !shown.contains("noise moves it"), "{shown}");
        assert!(shown.contains("Every seed gave the same run") && !shown.contains('±'), "{shown}");
    }
}

/// Where is the table? On the first screen, before a run and after it.
#[test]
fn the_table_is_in_sight_at_once() {
    for size in [vec2(1280.0, 800.0), vec2(390.0, 844.0)] {
        let changes = [("run.duration_s", Value::Float(2.0))];
        let mut screen = screen::open("first-cut", size, "Compare", &changes);
        for ran in [false, true] {
            let first = screen.get_by_label("Load Conventional").rect();
            assert!(first.bottom() < 0.62 * size.y, "{first:?} of {size:?}, ran: {ran}");
            if !ran {
                screen.get_by_role_and_label(Role::SpinButton, "Seeds").set_value_accesskit(1.0);
                screen.run_steps(2);
                finish(&mut screen);
            }
        }
    }
}
