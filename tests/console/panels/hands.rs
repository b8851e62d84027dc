//! What hands do to the console: click, type, and touch.

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, TouchPhase, pos2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use steadycut::app::Console;
use steadycut::base::settings::Value;
use steadycut::run::edits::Edits;
use steadycut::run::{Start, presets};

use super::{DESKTOP, PHONE, Window, click, console, playing, press, target_um, window};
use crate::screen::finger;

/// A click of a mouse, with the frames that a hand takes for it.
fn click_at(window: &mut Window, at: egui::Pos2) {
    window.hover_at(at);
    window.run_steps(2);
    window.drag_at(at);
    window.run_steps(2);
    window.drop_at(at);
    window.run_steps(3);
}

#[test]
fn choices_are_made_with_the_mouse() {
    let mut window = window(DESKTOP);
    for (list, entry, path, id) in [
        ("Controller", "Tracking", "controller.kind", "tracking"),
        ("Material", "S235JR (1.0038)", "plant.material", "s235jr"),
    ] {
        let rect = window.get_by_role_and_label(Role::ComboBox, list).rect();
        click_at(&mut window, rect.center());
        let rect = window.get_by_role_and_label(Role::Button, entry).rect();
        click_at(&mut window, rect.center());
        let now = console(&window).session().current().get(path).unwrap();
        assert_eq!(now, Value::Text(id.to_owned()), "{list}");
    }
}

/// Types into the field of the target roughness, as it stands beside its name.
fn type_target(window: &mut Window, text: &str) {
    let rect = window.get_by_role_and_label(Role::SpinButton, "Target Ra").rect();
    click_at(window, rect.center());
    press(window, Modifiers::COMMAND, Key::A);
    window.event(Event::Text(text.to_owned()));
    window.run_steps(1);
    press(window, Modifiers::NONE, Key::Enter);
    window.run_steps(2);
}

fn notices(window: &Window) -> Vec<String> {
    console(window).messages().map(str::to_owned).collect()
}

#[test]
fn numbers_are_typed_with_comma_and_unit_and_faults_are_answered() {
    let mut window = window(DESKTOP);
    click(&mut window, "Pause");
    for (text, target) in [("1,2", 1.2), ("0.6 um", 0.6), ("0,9 µm", 0.9)] {
        type_target(&mut window, text);
        assert_eq!(target_um(&window), target, "{text}");
    }
    assert_eq!(notices(&window), Vec::<String>::new());
    for (text, target) in [("fine", 0.9), ("77", 4.0)] {
        type_target(&mut window, text);
        assert_eq!(target_um(&window), target, "{text}");
        let said = notices(&window).join("\n");
        for part in ["Target Ra", text, "from 0.05 to 4"] {
            assert!(said.contains(part), "{part} in {said}");
        }
        click(&mut window, "Dismiss");
        assert_eq!(notices(&window), Vec::<String>::new());
    }
}

#[test]
fn a_finger_scrolls_the_plots_and_zooms_none() {
    let mut window = window(PHONE);
    press(&mut window, Modifiers::NONE, Key::Space);
    let chart = |window: &Window| window.get_by_label("Roughness from 0.00 s to 20.00 s").rect();
    let before = chart(&window);
    let axis = pos2(before.left() - 20.0, before.center().y);
    for (from, first_top) in [(before.center(), before.top()), (axis, before.top() - 80.0)] {
        let from = pos2(from.x, from.y.min(700.0));
        finger(&mut window, from, TouchPhase::Start);
        for step in 1..=8 {
            let at = from - egui::vec2(0.0, 10.0 * step as f32);
            finger(&mut window, at, TouchPhase::Move);
        }
        // It rests before it is lifted: no swing.
        window.run_steps(8);
        finger(&mut window, from - egui::vec2(0.0, 80.0), TouchPhase::End);
        window.run_steps(20);
        // Still the same times in the picture, which has moved with the finger.
        let top = chart(&window).top();
        assert!(top < first_top - 50.0, "from {first_top} to {top}");
    }
}

#[test]
fn the_end_of_a_long_run_is_followed_until_it_is_reached() {
    let mut scenario = presets::load("first-cut").unwrap();
    scenario.set("workpiece.length_mm", Value::Float(20000.0)).unwrap();
    scenario.set("run.record_every", Value::Int(20)).unwrap();
    scenario.set("run.duration_s", Value::Float(3600.0)).unwrap();
    let mut window: Window =
        Harness::builder().with_size(DESKTOP).with_step_dt(0.05).build_ui_state(
            move |ui, console: &mut Option<Console>| {
                let start =
                    || Start { scenario: scenario.clone(), edits: Edits::none(), notice: None };
                console
                    .get_or_insert_with(|| crate::screen::sliced(Console::new(ui.ctx(), start())))
                    .ui(ui);
            },
            None,
        );
    window.run_steps(1);
    click(&mut window, "End");
    let session = |window: &Window| console(window).session().chosen().is_over();
    assert!(!session(&window), "the run is not long enough for this test");
    crate::screen::in_time(|| {
        window.run_steps(1);
        session(&window)
    });
    window.run_steps(2);
    assert!(!playing(&window) && console(&window).session().finished().is_some());
}

#[test]
fn the_present_values_stand_beside_their_charts() {
    let mut window = window(DESKTOP);
    window.run_steps(40);
    click(&mut window, "Pause");
    let row = *console(&window).session().row();
    window.get_by_label(&format!("Ra at the playhead: {:.3} µm", row.ra_um));
    window.get_by_label(&format!("Maximum force at the playhead: {:.1} N", row.force_n));
    window.get_by_label(&format!("Feed at the playhead: {:.0} mm/min", row.feed_mm_min));
    window.get_by_label(&format!("within target {:.3} µm", row.ra_target_um));
}
