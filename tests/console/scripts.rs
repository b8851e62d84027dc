//! A controller's script in the console: written, told what is wrong with its line, used in the running cut; one that
//! comes with a file waits to be run.

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, Vec2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use steadycut::app::command::{Command, SessionCommand};
use steadycut::base::settings::Value;
use steadycut::run::edits::Edits;
use steadycut::run::end::End;
use steadycut::run::{presets, scenario_file};

use crate::screen::{Screen, in_time, open, texts};

/// Frames until something holds.
fn wait(screen: &mut Screen<'_>, what: &str, holds: impl Fn(&Screen<'_>) -> bool) {
    let came = in_time(|| {
        screen.run_steps(1);
        holds(screen)
    });
    assert!(came, "{what}");
}

const SIZES: [Vec2; 2] = [vec2(1280.0, 800.0), vec2(390.0, 844.0)];

fn session<'a>(screen: &'a Screen<'_>) -> &'a steadycut::app::session::Session {
    screen.state().as_ref().expect("made in the first frame").session()
}

/// The card of the controller in the diagram, the cut paused in its course.
fn card<'a>(size: Vec2) -> Screen<'a> {
    let mut screen = open("own-controller", size, "Block diagram", &[]);
    wait(&mut screen, "the cut is under way", |screen| session(screen).row().time_s > 1.0);
    screen.key_press(Key::Space);
    screen.run_steps(2);
    screen.get_by_role_and_label(Role::Button, "Controller K2, K3").click_accesskit();
    screen.run_steps(4);
    screen
}

fn write(screen: &mut Screen<'_>, text: &str) {
    screen.get_by_role_and_label(Role::MultilineTextInput, "Script").focus();
    screen.run_steps(2);
    screen.key_press_modifiers(Modifiers::COMMAND, Key::A);
    screen.event(Event::Text(text.to_owned()));
    screen.run_steps(3);
}

fn can_be_used(screen: &Screen<'_>) -> bool {
    let button = screen.get_by_role_and_label(Role::Button, "Use this script");
    !button.accesskit_node().is_disabled()
}

#[test]
fn a_script_is_written_told_its_wrong_line_and_used_in_the_running_cut() {
    for size in SIZES {
        let mut screen = card(size);
        assert!(!can_be_used(&screen), "it is the one that runs");
        let before = session(&screen).edits().list().len();
        write(&mut screen, "fn update(now) {\n    now.\n}");
        assert!(texts(&screen).contains("line 3: "), "{}", texts(&screen));
        assert!(!can_be_used(&screen));
        write(&mut screen, "fn update(now) { 70.0 }");
        assert!(can_be_used(&screen), "{}", texts(&screen));
        assert_eq!(session(&screen).edits().list().len(), before, "not before it is used");
        screen.get_by_role_and_label(Role::Button, "Use this script").click_accesskit();
        screen.run_steps(4);
        assert_eq!(session(&screen).edits().list().len(), before + 1);
        wait(&mut screen, "it is cut on", |screen| session(screen).simulated() >= 1.0);
        let run = session(&screen).chosen().run();
        let last = run.recording().rows().last().unwrap();
        assert_eq!(last.feed_override_percent, 70.0, "what was written is what controls");
    }
}

#[test]
fn a_script_that_comes_with_a_file_is_not_run_before_it_is_asked_for() {
    let mut screen = open("first-cut", SIZES[0], "Console", &[]);
    let mut scenario = presets::load("own-controller").unwrap();
    let code = "fn update(now) { let x = 1.0; loop { x += 1.0; } }";
    scenario.set("controller.script.code", Value::Text(code.to_owned())).unwrap();
    let text = scenario_file::write(&scenario, &Edits::none());
    let load = SessionCommand::LoadText { name: "own.toml".to_owned(), text };
    screen.state_mut().as_mut().unwrap().push(Command::Session(load));
    screen.run_steps(30);
    assert!(session(&screen).waits_for_consent());
    assert_eq!(session(&screen).row().time_s, 0.0);
    assert!(session(&screen).simulated() < 1.0);
    assert!(texts(&screen).contains("it is not run before you press Play"), "{}", texts(&screen));
    screen.key_press(Key::Space);
    wait(&mut screen, "the script fails", |screen| session(screen).chosen().run().end().is_some());
    let end = session(&screen).chosen().run().end().cloned();
    assert!(matches!(end, Some(End::Script(_))), "{end:?}");
    screen.run_steps(20);
    assert!(texts(&screen).contains("an endless loop?"), "{}", texts(&screen));
    // A shipped one is the program's own.
    let shipped = Command::Session(SessionCommand::LoadPreset("own-controller".to_owned()));
    screen.state_mut().as_mut().unwrap().push(shipped);
    screen.run_steps(5);
    assert!(!session(&screen).waits_for_consent());
}
