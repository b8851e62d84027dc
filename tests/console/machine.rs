//! The screen "Machine", driven by its accessible names, and pictures of its parts.

use crate::screen;

use crate::screen::{Screen, texts};
use egui::Theme;
use egui::accesskit::Role;
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{Harness, SnapshotOptions, SnapshotResults};
use steadycut::app::Console;
use steadycut::app::session::Session;
use steadycut::base::settings::Value;
use steadycut::run::edits::Edits;
use steadycut::run::{Start, presets};
use steadycut::study::stability::{StabilityCut, interrupted};

use crate::drawn;

const SIZES: [(&str, [f32; 2]); 2] = [("desktop", [1280.0, 800.0]), ("phone", [390.0, 844.0])];

fn session<'a>(screen: &'a Screen<'_>) -> &'a Session {
    screen.state().as_ref().expect("made in the first frame").session()
}

fn open<'a>(size: [f32; 2], changes: &[(&str, Value)]) -> Screen<'a> {
    screen::open("first-cut", size.into(), "Machine", changes)
}

fn press(screen: &mut Screen<'_>, name: &str) {
    // By its name alone: it may be scrolled out of sight.
    screen.get_by_role_and_label(Role::Button, name).click_accesskit();
    screen.run_steps(2);
}

fn slide(screen: &mut Screen<'_>, name: &str, to: f64) {
    screen.get_by_role_and_label(Role::Slider, name).set_value_accesskit(to);
    screen.run_steps(2);
}

/// Lets frames pass until the screen says this.
fn wait_for(screen: &mut Screen<'_>, text: &str) -> String {
    let said = crate::screen::in_time(|| {
        screen.run_steps(1);
        texts(screen).contains(text)
    });
    let shown = texts(screen);
    assert!(said, "{text} in {shown}");
    shown
}

#[test]
fn masses_move_and_the_response_is_read_at_the_cursor() {
    for (_, size) in SIZES {
        let mut screen = open(size, &[]);
        let shown = texts(&screen);
        // Modes of the reference: the first one, and the tooth's.
        assert!(shown.contains("109.93") && shown.contains("4.14 MHz"), "{shown}");
        slide(&mut screen, "Cursor frequency", 300.0);
        slide(&mut screen, "Cursor frequency", 110.0);
        let shown = texts(&screen);
        // G_rel = 5.84e-9 - 6.147e-7 i m/N and H33 = 9.62e-10 - 6.164e-7 i m/N at 110 Hz.
        assert!(shown.contains("|G_rel| 614.8 µm/kN, -89.5°"), "{shown}");
        assert!(shown.contains("|H33| 616.4 µm/kN, -89.9°"), "{shown}");
        assert!(shown.contains("Five masses at 110.0 Hz") && shown.contains("drawn ×"), "{shown}");
        // 107 N bend tooth against work by 107 times as much: 66 um, nearly all of it the tooth's.
        assert!(shown.contains("tooth 65."), "{shown}");
        press(&mut screen, "Mode 2");
        let shown = texts(&screen);
        assert!(shown.contains("Mode 2: 154.5 Hz") && shown.contains("its size means nothing"));
        press(&mut screen, "Passing teeth ×2");
        let tooth_hz = session(&screen).row().spindle_rpm / 30.0;
        let said = format!("Five masses at {:.1} Hz", 2.0 * tooth_hz);
        assert!(texts(&screen).contains(&said), "{said} in {}", texts(&screen));
        press(&mut screen, "Stop the masses");
        assert!(screen.query_by_label("Move the masses").is_some());
    }
}

#[test]
fn the_cursor_is_moved_by_keys_and_by_the_mouse() {
    let mut screen = open(SIZES[0].1, &[]);
    slide(&mut screen, "Cursor frequency", 200.0);
    screen.get_by_role_and_label(Role::Slider, "Cursor frequency").focus();
    screen.run_steps(1);
    let playhead_s = session(&screen).playback().playhead_s;
    screen.key_press(egui::Key::ArrowRight);
    screen.run_steps(2);
    assert!(texts(&screen).contains("At 201.0 Hz"), "{}", texts(&screen));
    // The key has not moved the playhead.
    assert!(session(&screen).playback().playhead_s - playhead_s < 0.31);
    let plot = screen.get_by_label("Response from 0 Hz to 3000 Hz").rect();
    for step in [Screen::hover_at, Screen::drag_at, Screen::drop_at] {
        step(&screen, plot.center());
        screen.run_steps(2);
    }
    assert!(!texts(&screen).contains("At 201.0 Hz"), "{}", texts(&screen));
}

#[test]
fn readings_and_parameters_change_the_machine() {
    let reading = [("machine.variant", Value::Text("B".to_owned()))];
    assert!(texts(&open(SIZES[0].1, &reading)).contains("122.60"));
    // As printed the reduction has no four vibrating modes: the chart says why there is none.
    let printed = [("machine.parameters", Value::Text("printed".to_owned()))];
    for (_, size) in SIZES {
        let mut screen = open(size, &printed);
        for part in ["Wear and sound", "Stability"] {
            press(&mut screen, part);
            screen.run_steps(4);
        }
        let shown = texts(&screen);
        assert!(shown.contains("No chart can be made") && shown.contains("machine.parameters"));
    }
}

#[test]
fn trends_are_solved_in_slices_and_stand_beside_the_papers_claim() {
    // A life of a quarter of an hour: its trends are those of a longer one.
    let short = [("wear.taylor_life_min", Value::Float(1.0))];
    for (_, size) in SIZES {
        let mut screen = open(size, &short);
        press(&mut screen, "Wear and sound");
        assert!(texts(&screen).contains("The equations are being solved"));
        slide(&mut screen, "Share of the tool's life", 1.0);
        let shown = texts(&screen);
        assert!(shown.contains("wear land 0.300 mm, force 171.2 N, sound 9.939 mm/s"), "{shown}");
        let shown = wait_for(&mut screen, "found R =");
        assert!(shown.contains("sound trend and roughness trend are identical"), "{shown}");
        assert!(shown.contains("found R = 0.9991, largest difference 0.039"), "{shown}");
        let shown = wait_for(&mut screen, "worn out after");
        assert!(shown.contains("Predicted life from 0 min"), "{shown}");
    }
}

#[test]
fn a_speed_that_is_adjusted_brings_the_tool_to_its_desired_life() {
    let changes = [("wear.tool_life_factor", Value::Float(0.7))];
    let mut screen = open(SIZES[0].1, &changes);
    press(&mut screen, "Wear and sound");
    wait_for(&mut screen, "worn out after 17");
    screen.get_by_role_and_label(Role::CheckBox, "Adjust the speed").click();
    let shown = wait_for(&mut screen, "worn out after 2");
    let end = shown.split("worn out after ").nth(1).unwrap().split(' ').next().unwrap();
    let end_min: f64 = end.parse().unwrap();
    assert!((end_min / 240.0 - 1.0).abs() < 0.1, "{end}");
}

#[test]
fn the_life_looked_at_is_that_of_a_tool_that_wears_in_the_cut() {
    for (_, size) in SIZES {
        let mut screen = screen::open("tool-life", size.into(), "Machine", &[]);
        press(&mut screen, "Wear and sound");
        screen.run_steps(60);
        press(&mut screen, "Pause");
        let slider = |screen: &Screen<'_>| {
            let slider = screen.get_by_role_and_label(Role::Slider, "Share of the tool's life");
            slider.accesskit_node().numeric_value().unwrap()
        };
        let used_life = session(&screen).row().used_life;
        assert!(used_life > 0.02 && (slider(&screen) - used_life).abs() < 0.006, "{used_life}");
        // A hand on the slider looks ahead.
        slide(&mut screen, "Share of the tool's life", 0.9);
        screen.run_steps(3);
        assert_eq!(slider(&screen), 0.9);
        screen.get_by_role_and_label(Role::CheckBox, "As in the cut").click();
        screen.run_steps(3);
        assert!((slider(&screen) - used_life).abs() < 0.006);
    }
    // A tool that keeps its edge has no life to follow.
    let mut screen = open(SIZES[0].1, &[]);
    press(&mut screen, "Wear and sound");
    assert!(!texts(&screen).contains("As in the cut"));
}

#[test]
fn the_chart_judges_the_present_cut() {
    for (_, size) in SIZES {
        let mut screen =
            open(size, &[("machine.specific_cutting_force_n_mm2", Value::Float(6000.0))]);
        press(&mut screen, "Stability");
        wait_for(&mut screen, "Stable at");
        screen.key_press(egui::Key::Space);
        screen.run_steps(40);
        let shown = wait_for(&mut screen, "(limit depth)");
        let told = shown.split(" Quiet at ").nth(1).unwrap();
        let (speed, depth) = told.split_once(" 1/min up to ").unwrap();
        let (depth, any) = depth.split_once(" mm (limit depth), at any speed up to ").unwrap();
        let any_mm: f64 = any.split_once(" mm.").unwrap().0.parse().unwrap();
        let [speed_rpm, depth_mm] = [speed, depth].map(|text| text.parse::<f64>().unwrap());
        assert!((speed_rpm - session(&screen).row().spindle_rpm).abs() <= 20.0, "{told}");
        let cut = StabilityCut::new(session(&screen).current()).unwrap();
        let limit_mm = interrupted::limit_mm(&cut, speed_rpm, 1000.0).unwrap();
        assert!((depth_mm / limit_mm - 1.0).abs() < 0.01, "{told} against {limit_mm}");
        assert!(any_mm > 0.0 && any_mm <= depth_mm, "{told}");
        assert_eq!(session(&screen).current().machine.spindle_quality, 5.0);
        press(&mut screen, "Q 17, as printed");
        assert_eq!(session(&screen).current().machine.spindle_quality, 17.0);
        let quality = |screen: &Screen<'_>| session(screen).current().machine.spindle_quality;
        screen.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::Z);
        screen.run_steps(2);
        assert_eq!(quality(&screen), 5.0);
    }
    let deep = [
        ("machine.specific_cutting_force_n_mm2", Value::Float(20_000.0)),
        ("machine.spindle_quality", Value::Float(60.0)),
    ];
    let none = [("machine.directional_factor", Value::Float(0.0))];
    let mut screen = open(SIZES[0].1, &none);
    press(&mut screen, "Stability");
    assert!(wait_for(&mut screen, "Stable at").contains("Nothing can chatter"));
    let mut screen = open(SIZES[0].1, &deep);
    press(&mut screen, "Stability");
    assert!(wait_for(&mut screen, "Chatter at").contains("a disturbance grows"));
}

/// Does it chatter? A phone says so at once, before anything that is pressed.
#[test]
fn the_verdict_of_the_stability_chart_is_in_sight_at_once() {
    let (_, size) = SIZES[1];
    let mut screen = open(size, &[]);
    press(&mut screen, "Stability");
    wait_for(&mut screen, "Stable at");
    wait_for(&mut screen, "At the playhead, ");
    let lowest = 0.5 * size[1];
    for text in ["Stable at ", "At the playhead, "] {
        let told = screen.query_all_by_label_contains(text).next().unwrap().rect();
        assert!(told.bottom() < lowest, "{text}: {told:?}");
        let button = screen.get_by_role_and_label(Role::Button, "Q 5, by its damper").rect();
        assert!(told.bottom() <= button.top(), "{text}: {told:?} and {button:?}");
    }
}

#[test]
fn the_sound_is_off_until_it_is_switched_on() {
    for (_, size) in SIZES {
        let mut screen = open(size, &[]);
        let on = |screen: &Screen<'_>| {
            let button = screen.get_by_role_and_label(Role::Button, "Sound of the cut");
            button.accesskit_node().toggled() == Some(egui::accesskit::Toggled::True)
        };
        assert!(!on(&screen));
        press(&mut screen, "Sound of the cut");
        // A computer without a loudspeaker says so, and the sound stays off.
        let told = texts(&screen).contains("No sound: ");
        assert!(on(&screen) != told, "{}", texts(&screen));
        screen.run_steps(10);
        press(&mut screen, "Pause");
        assert_eq!(texts(&screen).contains("silent while the cut is paused"), on(&screen));
        screen::show(&mut screen, "Plan");
        screen::show(&mut screen, "Machine");
        screen.run_steps(2);
        assert!(on(&screen) != told);
    }
}

#[test]
fn every_widget_of_the_machine_has_a_name() {
    for (_, size) in SIZES {
        let mut screen = open(size, &[]);
        for part in ["Vibration", "Wear and sound", "Stability"] {
            press(&mut screen, part);
            assert_eq!(screen.unnamed_widgets(), Vec::<String>::new(), "{part}");
        }
    }
}

#[test]
fn screens_without_room_for_tabs_are_chosen_from_a_list() {
    for (name, size) in SIZES {
        let mut screen = open(size, &[]);
        let list = screen.query_by_role_and_label(Role::ComboBox, "Screen").is_some();
        assert_eq!(list, name == "phone");
        for panel in steadycut::app::panels::panels() {
            screen::show(&mut screen, panel.title());
            let state = screen.state().as_ref().unwrap().state_json();
            assert!(state.contains(&format!("\"screen\":\"{}\"", panel.id())), "{state}");
        }
    }
}

/// Pictures of the parts once all is worked out. `UPDATE_SNAPSHOTS=1` renews them.
#[test]
fn every_part_looks_as_its_picture() {
    if !drawn::in_software() {
        return;
    }
    // One window for all pictures: what is worked out is worked out once.
    let mut results = SnapshotResults::new();
    let builder = Harness::builder().with_size(SIZES[0].1).with_step_dt(0.05);
    let mut screen: Screen<'_> = builder.wgpu().build_ui_state(
        |ui, console: &mut Option<Console>| {
            let scenario = presets::load("first-cut").expect("shipped");
            let start = || Start { scenario, edits: Edits::none(), notice: None };
            console
                .get_or_insert_with(|| crate::screen::sliced(Console::new(ui.ctx(), start())))
                .ui(ui);
        },
        None,
    );
    screen.run_steps(40);
    screen.key_press(egui::Key::Space);
    screen.run_steps(2);
    screen::show(&mut screen, "Machine");
    let parts = [
        ("life", "Wear and sound", "worn out after"),
        ("stability", "Stability", "stable at every speed"),
    ];
    for (part_name, part, done) in parts {
        press(&mut screen, part);
        while !screen.query_all_by_role(Role::ProgressIndicator).collect::<Vec<_>>().is_empty() {
            screen.run_steps(5);
        }
        wait_for(&mut screen, done);
        for (size_name, size) in SIZES {
            screen.set_size(size.into());
            for (theme_name, theme) in [("light", Theme::Light), ("dark", Theme::Dark)] {
                screen.ctx.set_theme(theme);
                screen.run_steps(6);
                let options = SnapshotOptions::new().threshold(1.0).max_failed_pixels(40);
                let name = format!("machine-{part_name}-{size_name}-{theme_name}");
                results.add(screen.try_snapshot_options(name, &options));
            }
        }
    }
}

#[test]
fn the_running_cut_predicts_the_life_of_its_own_tool() {
    for (_, size) in SIZES {
        let mut screen = screen::open("machine-life", size.into(), "Machine", &[]);
        press(&mut screen, "Wear and sound");
        screen.key_press(egui::Key::End);
        let shown = wait_for(&mut screen, "left at the programmed cut");
        assert!(!shown.contains("Adjust the speed"), "{shown}");
        screen.get_by_role_and_label(Role::CheckBox, "In the cut").click_accesskit();
        screen.run_steps(2);
        let shown = texts(&screen);
        assert!(!shown.contains("left at the programmed cut"), "{shown}");
        assert!(shown.contains("Adjust the speed"), "{shown}");
    }
}
