//! Disturbances dropped into the running cut: by buttons, keys and a press on the part.

use crate::legible::each_text;
use crate::screen::{self, Screen, computed, texts};
use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, PointerButton, Rect, Theme, Vec2, vec2};
use egui_kittest::kittest::Queryable;
use egui_kittest::{SnapshotOptions, SnapshotResults};
use steadycut::app::Console;
use steadycut::app::command::{Command, SessionCommand};
use steadycut::app::session::Session;
use steadycut::base::settings::Value;
use steadycut::models::disturbances::Disturbance;
use steadycut::run::one_run::End;

const DESKTOP: Vec2 = vec2(1280.0, 800.0);
const PHONE: Vec2 = vec2(390.0, 844.0);

const KEYS: [(Key, Disturbance); 10] = [
    (Key::H, Disturbance::HardSpot),
    (Key::G, Disturbance::Gap),
    (Key::D, Disturbance::DepthStep),
    (Key::W, Disturbance::WearJump),
    (Key::B, Disturbance::BrokenTooth),
    (Key::C, Disturbance::ChatterBurst),
    (Key::S, Disturbance::SensorDropout),
    (Key::R, Disturbance::SensorDrift),
    (Key::T, Disturbance::DeadTime),
    (Key::O, Disturbance::Operator),
];

/// A screen some seconds into a running cut, paused there.
fn running<'a>(size: Vec2, title: &str) -> Screen<'a> {
    let mut screen = screen::open("table3-5", size, title, &[]);
    screen.key_press(Key::Space);
    screen.run_steps(2);
    screen.key_press(Key::Home);
    screen.run_steps(2);
    for _ in 0..4 {
        screen.key_press_modifiers(Modifiers::SHIFT, Key::ArrowRight);
        screen.run_steps(2);
    }
    screen
}

fn session<'a>(screen: &'a Screen<'_>) -> &'a Session {
    Console::session(screen.state().as_ref().expect("made in the first frame"))
}

/// By its name alone: it may be scrolled out of sight.
fn click(screen: &mut Screen, name: &str) {
    let found = screen.get_all_by_label(name).last();
    found.unwrap_or_else(|| panic!("no {name}")).click_accesskit();
    screen.run_steps(3);
}

/// The one of its kind begins a little ahead of the tool, as an edit at the playhead.
fn is_dropped(screen: &Screen, kind: Disturbance) {
    let session = session(screen);
    let zones = session.current().disturbances.of(kind);
    assert_eq!(zones.len(), 1, "{kind:?}");
    let ahead_mm = zones[0].at_mm - session.row().position_mm;
    assert!((0.4..0.7).contains(&ahead_mm), "{kind:?}: {ahead_mm} mm ahead");
    let edit = session.edits().list().last().expect("an edit");
    assert_eq!(edit.path, kind.path());
    assert!((edit.at_s - session.playback().playhead_s).abs() < 2e-3);
    assert!(session.scenario().disturbances.is_empty(), "the scenario itself stays");
}

#[test]
fn each_is_dropped_by_its_key_and_taken_back_by_undo() {
    let mut screen = running(DESKTOP, "Console");
    for (key, kind) in KEYS {
        let before = session(&screen).chosen().run().recording().rows().len();
        assert!(before > 1000);
        screen.key_press(key);
        screen.run_steps(3);
        is_dropped(&screen, kind);
        screen.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        screen.run_steps(3);
        assert!(session(&screen).current().disturbances.is_empty(), "{kind:?}");
        assert!(session(&screen).edits().list().is_empty(), "{kind:?}");
    }
}

#[test]
fn each_is_dropped_by_its_button_on_a_desktop_and_on_a_phone() {
    for size in [DESKTOP, PHONE] {
        let mut screen = running(size, "Console");
        if size == PHONE {
            click(&mut screen, "Disturb the cut\u{2026}");
        }
        for kind in Disturbance::ALL.iter().copied() {
            click(&mut screen, &format!("Drop {}", kind.in_text()));
            is_dropped(&screen, kind);
            assert!(texts(&screen).contains(kind.label()), "{kind:?}");
            screen.key_press_modifiers(Modifiers::COMMAND, Key::Z);
            screen.run_steps(3);
            assert!(session(&screen).current().disturbances.is_empty(), "{kind:?}");
        }
    }
}

#[test]
fn lengths_and_sizes_are_kept_for_the_next_one() {
    for size in [DESKTOP, PHONE] {
        let mut screen = running(size, "Console");
        let opener = if size == PHONE {
            "Disturb the cut\u{2026}"
        } else {
            "Names and sizes of disturbances"
        };
        click(&mut screen, opener);
        for (name, value) in [("Length of the hard spot", 3.5), ("Size of the hard spot", 2.0)] {
            screen.get_by_role_and_label(Role::SpinButton, name).set_value_accesskit(value);
            screen.run_steps(3);
        }
        for dropped in 1..=2 {
            click(&mut screen, "Drop hard spot");
            let zones = session(&screen).current().disturbances.of(Disturbance::HardSpot);
            let last = zones.last().expect("dropped");
            assert_eq!((last.length_mm, last.size), (3.5, 2.0));
            assert_eq!(zones.len(), dropped);
            screen.key_press_modifiers(Modifiers::SHIFT, Key::ArrowRight);
            screen.run_steps(2);
        }
        // It did what it says: twice the force before the controller answers.
        let run = session(&screen).chosen().run();
        let first = session(&screen).current().disturbances.of(Disturbance::HardSpot)[0];
        let rows = run.recording().rows();
        let at = rows.partition_point(|row| row.position_mm < first.at_mm);
        assert!((rows[at].force_n / rows[at - 1].force_n - 2.0).abs() < 0.05);
    }
}

#[test]
fn a_press_on_the_part_places_one_ahead_of_the_tool_or_behind_it() {
    for size in [DESKTOP, PHONE] {
        let mut screen = running(size, "Workpiece");
        for _ in 0..8 {
            screen.key_press_modifiers(Modifiers::SHIFT, Key::ArrowRight);
            screen.run_steps(2);
        }
        click(&mut screen, "Whole part");
        let rect = part(&screen);
        let tool_mm = session(&screen).row().position_mm;
        for (share, ahead) in [(0.7, true), (0.2, false)] {
            click(&mut screen, "Drop hard spot");
            assert!(texts(&screen).contains(ARMED), "{}", texts(&screen));
            press(&mut screen, at(rect, share), Modifiers::NONE);
            let zones = session(&screen).current().disturbances.of(Disturbance::HardSpot).to_vec();
            let found = zones.iter().find(|zone| (zone.at_mm > tool_mm) == ahead);
            let found = found.unwrap_or_else(|| panic!("{size} {share}: {zones:?}, {tool_mm}"));
            let said = &session(&screen).notices().last().expect("it says where").text;
            assert!(said.starts_with(&format!("Hard spot at {}", found.at_mm)), "{said}");
            assert_eq!(said.contains("behind the tool: the cut is done again"), !ahead, "{said}");
            // Once.
            assert!(!texts(&screen).contains(ARMED), "{}", texts(&screen));
            press(&mut screen, at(rect, 0.6), Modifiers::NONE);
            let after = session(&screen).current().disturbances.of(Disturbance::HardSpot).len();
            assert_eq!(after, zones.len());
        }
        let spots = session(&screen).scenario().disturbances.of(Disturbance::HardSpot);
        assert_eq!(spots.len(), 2, "what is behind the tool belongs to the scenario itself");
    }
}

/// What is said while the hard spot is chosen.
const ARMED: &str = "Hard spot: press on the part to place it; Escape leaves";

/// The picture of the part.
fn part(screen: &Screen) -> Rect {
    let named =
        screen.get_by(|node| node.label().is_some_and(|label| label.starts_with("Part in space")));
    named.rect()
}

fn at(rect: Rect, share: f32) -> egui::Pos2 {
    rect.left_top() + vec2(share * rect.width(), 0.5 * rect.height())
}

#[test]
fn a_kind_stays_chosen_beside_the_part_and_with_shift_and_is_left_by_escape() {
    for size in [DESKTOP, PHONE] {
        let mut screen = running(size, "Workpiece");
        click(&mut screen, "Whole part");
        let count = |screen: &Screen| {
            session(screen).current().disturbances.of(Disturbance::HardSpot).len()
        };
        let armed = |screen: &Screen| texts(screen).contains(ARMED);
        let rect = part(&screen);
        let before = screen.get_by_label("Drop gap").rect();
        click(&mut screen, "Drop hard spot");
        assert!(armed(&screen));
        assert_eq!(screen.get_by_label("Drop gap").rect(), before, "nothing moves");
        press(&mut screen, rect.left_center() + vec2(3.0, 0.0), Modifiers::NONE);
        let said = session(&screen).notices().last().expect("said").text.clone();
        assert!(said.contains("beside the part") && said.contains(ARMED), "{said}");
        assert!(armed(&screen) && count(&screen) == 0);
        for placed in 1..=2 {
            press(&mut screen, at(rect, 0.5 + 0.1 * placed as f32), Modifiers::SHIFT);
            assert!(armed(&screen) && count(&screen) == placed, "{placed}");
        }
        // The messages first, as everywhere.
        for _ in 0..5 {
            screen.key_press(Key::Escape);
            screen.run_steps(3);
        }
        assert!(!armed(&screen));
        press(&mut screen, at(rect, 0.8), Modifiers::NONE);
        assert_eq!(count(&screen), 2);
        // So does another screen.
        click(&mut screen, "Drop hard spot");
        assert!(armed(&screen));
        for title in ["Console", "Workpiece"] {
            screen::show(&mut screen, title);
        }
        assert!(!armed(&screen));
    }
}

fn press(screen: &mut Screen, at: egui::Pos2, modifiers: Modifiers) {
    screen.event(Event::PointerMoved(at));
    screen.run_steps(2);
    for pressed in [true, false] {
        let button = PointerButton::Primary;
        screen.event_modifiers(
            Event::PointerButton { pos: at, button, pressed, modifiers },
            modifiers,
        );
        screen.run_steps(2);
    }
}

/// A range is read whole: no line is broken within it.
#[test]
fn ranges_of_lengths_and_sizes_stand_in_one_line_each() {
    for size in [DESKTOP, PHONE] {
        let mut screen = running(size, "Console");
        let opener = match size == PHONE {
            true => "Disturb the cut\u{2026}",
            false => "Names and sizes of disturbances",
        };
        screen.get_by_role_and_label(Role::Button, opener).click_accesskit();
        screen.run_steps(5);
        let mut ranges = 0;
        each_text(&screen, |text, _| {
            let words = &text.galley.job.text;
            if words.starts_with(|c: char| c.is_ascii_digit()) && words.contains(" to ") {
                ranges += 1;
                assert_eq!(text.galley.rows.len(), 1, "{words}");
            }
        });
        // On a phone the others are below the edge of the list.
        assert!(ranges > if size == PHONE { 1 } else { 3 }, "{ranges} ranges");
    }
}

#[test]
fn nothing_moves_on_the_screen_when_one_is_dropped() {
    for size in [DESKTOP, PHONE] {
        let mut screen = running(size, "Console");
        computed(&mut screen);
        let places = |screen: &Screen| -> Vec<Rect> {
            let names = ["Play", "Back to before it went wrong", "Controller: SDNRP"];
            let rects = names.iter().map(|name| screen.get_by_label(name).rect());
            rects.chain([screen.get_by_label_contains("Roughness from").rect()]).collect()
        };
        let events = |screen: &Screen| screen.get_by_label_contains("0.00 s Start").rect();
        let first = (events(&screen), screen.get_by_label_contains("Roughness from").rect());
        // The first change of all closes the introduction, which stands below the events on a phone.
        screen.key_press(Key::W);
        screen.run_steps(5);
        computed(&mut screen);
        let now = (events(&screen), screen.get_by_label_contains("Roughness from").rect());
        assert_eq!(now, first, "{size}");
        let before = places(&screen);
        screen.key_press(Key::G);
        screen.run_steps(5);
        is_dropped(&screen, Disturbance::Gap);
        assert_eq!(places(&screen), before);
    }
}

#[test]
fn what_does_not_go_is_refused_with_the_reason() {
    let mut screen = screen::open("machine-dynamics", DESKTOP, "Console", &[]);
    screen.key_press(Key::B);
    screen.run_steps(3);
    assert!(session(&screen).current().disturbances.is_empty());
    let said = &session(&screen).notices().last().expect("a notice").text;
    assert!(
        said.contains("disturbances.broken_teeth") && said.contains("machine.coupled"),
        "{said}"
    );
}

#[test]
fn pictures_of_a_disturbed_cut() {
    let mut results = SnapshotResults::new();
    for (name, size, theme, title) in [
        ("disturbed-desktop-dark", DESKTOP, Theme::Dark, "Console"),
        ("disturbed-phone-light", PHONE, Theme::Light, "Console"),
        ("disturbed-part-desktop-light", DESKTOP, Theme::Light, "Workpiece"),
    ] {
        let mut screen = screen::open("disturbed-cut", size, title, &[]);
        screen.ctx.set_theme(theme);
        screen.key_press(Key::Space);
        screen.run_steps(2);
        for _ in 0..7 {
            screen.key_press_modifiers(Modifiers::SHIFT, Key::ArrowRight);
            screen.run_steps(2);
        }
        if title == "Workpiece" {
            click(&mut screen, "Whole part");
        }
        screen.run_steps(10);
        screen::rest(&mut screen);
        results.add(screen.try_snapshot_options(name, &SnapshotOptions::new().threshold(1.2)));
    }
}

#[test]
fn after_a_broken_tool_one_key_goes_back_and_the_next_change_branches_there() {
    for size in [DESKTOP, PHONE] {
        let weak = [("tool.chip_max_mm", Value::Float(0.3))];
        let mut screen = screen::open("table3-5", size, "Console", &weak);
        screen.key_press(Key::Space);
        screen.run_steps(2);
        screen.key_press(Key::Home);
        screen.run_steps(2);
        for _ in 0..5 {
            screen.key_press_modifiers(Modifiers::SHIFT, Key::ArrowRight);
            screen.run_steps(2);
        }
        // A tooth breaks, and the next one does not stand the chip of both.
        let limit =
            SessionCommand::Set { path: "tool.chip_max_mm".to_owned(), value: Value::Float(0.02) };
        screen.state().as_ref().unwrap().push(Command::Session(limit));
        screen.run_steps(3);
        screen.key_press(Key::End);
        screen.run_steps(5);
        let broke_s = session(&screen).chosen().simulated_s();
        assert!(matches!(session(&screen).finished(), Some(End::Breakage(_))), "{size}");
        assert!(texts(&screen).contains("The tool broke at"), "{}", texts(&screen));
        screen.key_press(Key::Backspace);
        screen.run_steps(3);
        let now_s = session(&screen).playback().playhead_s;
        assert!((broke_s - now_s - 2.0).abs() < 0.05, "{broke_s} {now_s}");
        // The next change branches there: slower by hand, and the edit that broke it is gone.
        screen.key_press(Key::H);
        screen.run_steps(5);
        let edits = session(&screen).edits().list();
        assert_eq!(edits.len(), 1, "{edits:?}");
        assert!((edits[0].at_s - now_s).abs() < 2e-3);
        // By the button as well.
        screen.key_press(Key::End);
        screen.run_steps(5);
        click(&mut screen, "Back to before it went wrong");
        let back_s = session(&screen).playback().playhead_s;
        assert!(back_s < session(&screen).length_s());
    }
}

/// Where a phone begins: one press opens the list, a second one drops the hard spot; nothing is to be unfolded or
/// scrolled before.
#[test]
fn a_hard_spot_is_two_presses_away_on_a_phone() {
    let mut screen = running(PHONE, "Console");
    let window = screen.ctx.content_rect();
    let opener = screen.get_by_role_and_label(Role::Button, "Disturb the cut\u{2026}").rect();
    assert!(window.contains_rect(opener) && opener.height() >= 40.0, "{opener}");
    press(&mut screen, opener.center(), Modifiers::NONE);
    screen.run_steps(5);
    let spot = screen.get_by_role_and_label(Role::Button, "Drop hard spot").rect();
    assert!(window.contains_rect(spot), "{spot}");
    press(&mut screen, spot.center(), Modifiers::NONE);
    is_dropped(&screen, Disturbance::HardSpot);
    // The settings are unfolded beside it as before.
    for _ in 0..3 {
        screen.key_press(Key::Escape);
        screen.run_steps(3);
    }
    click(&mut screen, "Settings");
    screen.run_steps(10);
    assert!(texts(&screen).contains("More settings"), "{}", texts(&screen));
}
