//! The console under a test's hands, for the tests of single screens.

use std::time::{Duration, Instant};

use egui::accesskit::Role;
use egui::{Event, Modifiers, TouchDeviceId, TouchId, TouchPhase, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use steadycut::app::Console;
use steadycut::base::settings::Value;
use steadycut::run::edits::{Edit, Edits};
use steadycut::run::{Start, presets};

/// The console, made in the first frame.
pub type Screen<'a> = Harness<'a, Option<Console>>;

/// A console that does its long work in its frames, as in a page: so many frames, so much of it.
pub fn sliced(console: Console) -> Console {
    console.jobs().work_in_slices();
    console
}

/// The screen with this title two frames after it was opened, on a preset with these changes.
pub fn open<'a>(preset: &str, size: Vec2, title: &str, changes: &[(&str, Value)]) -> Screen<'a> {
    edited(preset, size, title, changes, &[])
}

/// The same with changes of settings at their times in the running cut, s.
pub fn edited<'a>(
    preset: &str,
    size: Vec2,
    title: &str,
    changes: &[(&str, Value)],
    later: &[(f64, &str, Value)],
) -> Screen<'a> {
    let mut scenario = presets::load(preset).expect("shipped");
    for (path, value) in changes {
        scenario.set(path, value.clone()).expect("a valid setting");
    }
    let mut edits = Edits::none();
    for (at_s, path, value) in later {
        let edit = Edit { at_s: *at_s, path: (*path).to_owned(), value: value.clone() };
        edits.push(&scenario, edit).expect("a valid edit");
    }
    let mut screen = Harness::builder().with_size(size).with_step_dt(0.05).build_ui_state(
        move |ui, console: &mut Option<Console>| {
            let console = console.get_or_insert_with(|| {
                let start =
                    Start { scenario: scenario.clone(), edits: edits.clone(), notice: None };
                sliced(Console::new(ui.ctx(), start))
            });
            console.ui(ui);
        },
        None,
    );
    screen.run_steps(2);
    show(&mut screen, title);
    screen
}

/// Shows the screen with this title, by its tab or from the list that narrow windows have.
pub fn show(screen: &mut Screen<'_>, title: &str) {
    if let Some(list) = screen.query_by_role_and_label(Role::ComboBox, "Screen") {
        list.click();
        screen.run_steps(2);
    }
    screen.get_by_role_and_label(Role::Button, title).click();
    screen.run_steps(2);
}

/// Frames until no long work goes on, nor is begun in the two frames after: what has been found may be
/// what the next work needs.
pub fn rest(screen: &mut Screen<'_>) {
    let at_rest = |screen: &Screen<'_>| {
        screen.state().as_ref().expect("made in the first frame").jobs().is_at_rest()
    };
    let rested = in_time(|| {
        screen.run_steps(2);
        if at_rest(screen) {
            screen.run_steps(2);
            if at_rest(screen) {
                return true;
            }
        }
        std::thread::sleep(Duration::from_millis(1));
        false
    });
    assert!(rested, "{}", texts(screen));
}

/// Goes step by step until something is done; `false` where that takes too long. By time and not by the number of
/// steps: how much is done in one depends on the machine and on what else it does.
#[expect(clippy::disallowed_methods, reason = "a limit of time")]
pub fn in_time(mut step: impl FnMut() -> bool) -> bool {
    const MOST: Duration = Duration::from_secs(300);
    let begun = Instant::now();
    while begun.elapsed() < MOST {
        if step() {
            return true;
        }
    }
    false
}

/// Frames until the cut, its twin and what is told of them are worked out.
/// The playhead of a cut that plays moves on meanwhile.
pub fn computed(screen: &mut Screen<'_>) {
    let done = in_time(|| {
        let session = screen.state().as_ref().expect("made in the first frame").session();
        let done = session.simulated() >= 1.0 && session.twin_stand().is_settled();
        // What was found in the last frame is drawn in the next one.
        screen.run_steps(if done { 2 } else { 1 });
        done
    });
    assert!(done, "{}", texts(screen));
}

/// Every text on the screen, as it is told.
pub fn texts(screen: &Screen<'_>) -> String {
    let nodes = screen.root().children_recursive().map(|node| {
        let node = node.accesskit_node();
        node.label().or_else(|| node.value()).unwrap_or_default()
    });
    nodes.collect::<Vec<String>>().join("\n")
}

/// One state of a finger, as window systems report it: with a pointer that follows, all at once.
pub fn finger<State>(window: &mut Harness<'_, State>, at: egui::Pos2, phase: TouchPhase) {
    let (device_id, id) = (TouchDeviceId(1), TouchId(1));
    let events = &mut window.input_mut().events;
    events.push(Event::Touch { device_id, id, phase, pos: at, force: None });
    events.push(Event::PointerMoved(at));
    if phase != TouchPhase::Move {
        let pressed = phase == TouchPhase::Start;
        let (button, modifiers) = (egui::PointerButton::Primary, Modifiers::NONE);
        events.push(Event::PointerButton { pos: at, button, pressed, modifiers });
    }
    if phase == TouchPhase::End {
        events.push(Event::PointerGone);
    }
    window.run_steps(1);
}
