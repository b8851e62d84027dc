//! The networks of UNKS beside the block diagram, driven by their accessible names.

use crate::screen;

use crate::screen::{Screen, texts};
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use steadycut::app::command::SessionCommand;
use steadycut::app::session::Session;
use steadycut::base::settings::Value;
use steadycut::blocks::control::ControllerKind;
use steadycut::models::unks::UnksStart;
use steadycut::run::edits::Edits;
use steadycut::run::one_run::Run;
use steadycut::run::presets::load;
use steadycut::study::unks_passes::{beginning_anew, learned};

const SIZES: [[f32; 2]; 2] = [[1280.0, 800.0], [390.0, 844.0]];

fn session<'a>(screen: &'a Screen<'_>) -> &'a Session {
    screen.state().as_ref().expect("made in the first frame").session()
}

fn press(screen: &mut Screen<'_>, name: &str) {
    // By its name alone: it may be scrolled out of sight.
    screen.get_by_role_and_label(Role::Button, name).click_accesskit();
    screen.run_steps(2);
}

fn to_the_end(screen: &mut Screen<'_>) {
    while session(screen).progress() < 1.0 {
        screen.run_steps(5);
    }
    screen.key_press(egui::Key::End);
    screen.run_steps(3);
}

/// The networks in the beginning of Experiment 2, at its end.
fn open<'a>(size: [f32; 2], start: UnksStart) -> Screen<'a> {
    let changes = [
        ("run.duration_s", Value::Float(4.0)),
        ("controller.unks.start", Value::Text(start.id().to_owned())),
    ];
    let mut screen = screen::open("experiment-2", size.into(), "Block diagram", &changes);
    to_the_end(&mut screen);
    press(&mut screen, "Networks that learn");
    screen
}

#[test]
fn the_networks_are_shown_with_what_they_have_learned() {
    for size in SIZES {
        for start in UnksStart::ALL {
            let mut screen = open(size, *start);
            let shown = texts(&screen);
            let history = session(&screen).chosen().learning().until(f64::INFINITY).to_vec();
            let [forward, inverse] = history.last().unwrap().lessons;
            assert!(inverse > 20 && (forward > 20) == (*start == UnksStart::Shipped));
            assert!(shown.contains(&format!("NM-2 Weights: {inverse} lessons")), "{shown}");
            assert!(shown.contains(&format!("NM-1 Weights: {forward} lessons")), "{shown}");
            assert_eq!(shown.contains("has no part in the cold start"), forward == 0);
            assert_eq!(shown.contains("Error of NM-1"), *start == UnksStart::Shipped);
            press(&mut screen, "Change since the start");
            assert!(texts(&screen).contains("NM-2 Change since the start"));
            assert_eq!(screen.get_all_by_role(Role::Image).count(), 2);

            // At the start nothing is learned yet.
            screen.key_press(egui::Key::Home);
            screen.run_steps(3);
            assert!(texts(&screen).contains("0 lessons"), "{}", texts(&screen));
        }
    }
}

#[test]
fn what_was_learned_is_carried_on_and_the_start_chosen_anew() {
    for size in SIZES {
        let mut screen = open(size, UnksStart::Cold);
        let expected = learned(session(&screen).chosen().run(), 1).unwrap();
        press(&mut screen, "Cut again with what was learned");
        assert_eq!(session(&screen).scenario().controller.unks.networks.get(), Some(&expected));
        assert!(texts(&screen).contains("learned before"), "{}", texts(&screen));
        // Longer than a gesture lasts: two steps of undo.
        screen.run_steps(20);
        press(&mut screen, "trained before");
        let unks = &session(&screen).scenario().controller.unks;
        assert_eq!((unks.start, unks.networks.get()), (UnksStart::Shipped, None));
        screen.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::Z);
        screen.run_steps(2);
        assert_eq!(session(&screen).scenario().controller.unks.networks.get(), Some(&expected));
    }
}

#[test]
fn passes_are_worked_off_and_their_networks_can_be_used() {
    let mut screen = open(SIZES[0], UnksStart::Cold);
    press(&mut screen, "Cut 5 passes");
    assert!(texts(&screen).contains("Stop the passes"));
    crate::screen::in_time(|| {
        screen.run_steps(1);
        texts(&screen).contains("Use these networks")
    });
    let shown = texts(&screen);
    assert!(shown.contains("The feedback's share falls pass by pass."), "{shown}");
    press(&mut screen, "Use these networks");
    let stored = session(&screen).scenario().controller.unks.networks.get().unwrap().clone();
    assert_eq!((stored.start, stored.origins[2].epochs), (UnksStart::Cold, 5));
    assert!(texts(&screen).contains("Made with other settings than those of now."));
}

#[test]
fn other_controllers_show_the_loop_alone() {
    let mut screen = open(SIZES[0], UnksStart::Shipped);
    screen.key_press(egui::Key::Home);
    screen.run_steps(2);
    let mut other = screen::open("first-cut", SIZES[0].into(), "Block diagram", &[]);
    other.run_steps(2);
    assert!(!texts(&other).contains("Networks that learn"));
    press(&mut screen, "Closed loop");
    assert!(screen.query_by_label("Dynamometer").is_some());
    for size in SIZES {
        assert_eq!(open(size, UnksStart::Shipped).unnamed_widgets(), Vec::<String>::new());
    }
}

#[test]
fn a_file_of_networks_brings_its_controller_and_a_bad_one_becomes_a_notice() {
    let mut scenario = load("experiment-2").unwrap();
    scenario.change(|s| s.run.duration_s = 2.0).unwrap();
    scenario.set_all(&beginning_anew(UnksStart::Cold)).unwrap();
    let stored = learned(&Run::complete(&scenario, &Edits::none()), 1).unwrap();
    let mut session = Session::new(load("first-cut").unwrap(), Edits::none());
    let command = |text: String| SessionCommand::LoadNetworks { name: "my.json".to_owned(), text };
    let bad = stored.write().replace("\"version\": 1", "\"version\": 7");
    session.execute(command(bad));
    let said = session.notices().last().map(|notice| notice.text.clone()).unwrap();
    assert!(said.contains("my.json: `version` cannot be 7: allowed is 1"), "{said}");
    assert_eq!(session.scenario(), &load("first-cut").unwrap());
    session.execute(command(stored.write()));
    assert_eq!(session.scenario().controller.kind, ControllerKind::Unks);
    assert_eq!(session.scenario().controller.unks.networks.get(), Some(&stored));
    assert_eq!(session.notices().len(), 1);
}
