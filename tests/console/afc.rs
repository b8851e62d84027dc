//! The window AFC over the console, driven by its accessible names, and its pictures.

use egui::accesskit::Role;
use egui::{Theme, Vec2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{Harness, SnapshotOptions, SnapshotResults};
use steadycut::app::Console;
use steadycut::app::command::{Command, PlaybackCommand};
use steadycut::base::settings::Value;
use steadycut::run::edits::Edits;
use steadycut::run::{Start, presets};

use crate::drawn;
use crate::screen::{self, Screen, computed, rest, sliced, texts};

const SIZES: [Vec2; 2] = [vec2(1280.0, 800.0), vec2(390.0, 844.0)];
const PATH: &str = "controller.afc.references_n";

/// Presses what has this name, also where it is scrolled out of sight.
fn click(screen: &mut Screen<'_>, name: &str) {
    screen.get_all_by_label(name).last().unwrap_or_else(|| panic!("no {name}")).click_accesskit();
    screen.run_steps(5);
}

fn open_window(screen: &mut Screen<'_>, size: Vec2) {
    if size == SIZES[1] {
        click(screen, "Settings");
    }
    click(screen, "AFC\u{2026}");
    if size == SIZES[1] {
        click(screen, "Settings");
    }
}

fn play(screen: &mut Screen<'_>, command: PlaybackCommand) {
    screen.state().as_ref().unwrap().push(Command::Playback(command));
    screen.run_steps(3);
}

fn references(screen: &Screen<'_>) -> Vec<f64> {
    let session = screen.state().as_ref().unwrap().session();
    session.scenario().controller.afc.references_n.clone()
}

#[test]
fn teach_in_finds_the_references_and_the_log_tells_the_cut() {
    for size in SIZES {
        let changes = [(PATH, Value::List(Vec::new())), ("plant.wear_factor", Value::Float(1.0))];
        let mut screen = screen::open("afc", size, "Console", &changes);
        open_window(&mut screen, size);
        let said = texts(&screen);
        assert!(said.contains("Teach-in: the feed stays as programmed."), "{said}");
        click(&mut screen, "Teach in");
        rest(&mut screen);
        screen.run_steps(5);
        // As shipped, to the tenth of a newton.
        let shipped = presets::load("afc").unwrap().controller.afc.references_n.clone();
        let found = references(&screen);
        assert_eq!(found.len(), 3);
        for (found, shipped) in found.iter().zip(&shipped) {
            assert!((found - shipped).abs() <= 0.05 + 1e-9, "{found} {shipped}");
        }
        assert!(texts(&screen).contains("Taught in."), "{}", texts(&screen));
        rest(&mut screen);
        play(&mut screen, PlaybackCommand::SeekToEnd);
        let said = texts(&screen);
        for word in ["least %", "Cut 3: feed", &format!("{:.1}", found[1])] {
            assert!(said.contains(word), "{word}: {said}");
        }
        let saved = screen.get_by_role_and_label(Role::Button, "Save afc log as CSV");
        assert!(!saved.accesskit_node().is_disabled());
        assert_eq!(screen.unnamed_widgets(), Vec::<String>::new());
    }
}

#[test]
fn a_set_up_changed_meanwhile_takes_nothing_over() {
    let mut screen = screen::open("afc", SIZES[0], "Console", &[(PATH, Value::List(Vec::new()))]);
    open_window(&mut screen, SIZES[0]);
    click(&mut screen, "Teach in");
    let changed = vec![("plant.wear_factor".to_owned(), Value::Float(1.1))];
    let set_up = steadycut::app::command::SessionCommand::SetUp(changed);
    screen.state().as_ref().unwrap().push(Command::Session(set_up));
    rest(&mut screen);
    screen.run_steps(5);
    if references(&screen).is_empty() {
        assert!(texts(&screen).contains("Teach in again"), "{}", texts(&screen));
    } else {
        // It was over before the change came.
        assert!(texts(&screen).contains("Taught in."), "{}", texts(&screen));
    }
}

#[test]
fn the_window_is_offered_to_afc_alone() {
    let screen = screen::open("first-cut", SIZES[0], "Console", &[]);
    assert!(!texts(&screen).contains("AFC\u{2026}"));
}

#[test]
fn the_window_looks_as_it_should() {
    if !drawn::in_software() {
        return;
    }
    let mut results = SnapshotResults::new();
    for (size, theme, name) in [
        (SIZES[0], Theme::Dark, "afc-dark"),
        (SIZES[0], Theme::Light, "afc-light"),
        (SIZES[1], Theme::Light, "afc-phone"),
    ] {
        let builder = Harness::builder().with_size(size).with_step_dt(0.05).with_theme(theme);
        let mut screen: Screen<'_> = builder.wgpu().build_ui_state(
            |ui, console: &mut Option<Console>| {
                let console = console.get_or_insert_with(|| {
                    let scenario = presets::load("afc").unwrap();
                    let start = Start { scenario, edits: Edits::none(), notice: None };
                    sliced(Console::new(ui.ctx(), start))
                });
                console.ui(ui);
            },
            None,
        );
        screen.run_steps(3);
        play(&mut screen, PlaybackCommand::TogglePlay);
        rest(&mut screen);
        play(&mut screen, PlaybackCommand::SeekTo(28.0));
        computed(&mut screen);
        open_window(&mut screen, size);
        rest(&mut screen);
        screen.run_steps(20);
        results.add(screen.try_snapshot_options(name, &SnapshotOptions::default()));
    }
}
