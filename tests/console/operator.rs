//! The operator mode: the feed override in the hand, by wheel, keys, drag and finger; its edits, its score, and its
//! trace beside a controller's.

use std::process::Command as Program;

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, MouseWheelUnit, Pos2, Rect, Theme, TouchPhase, Vec2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{Harness, SnapshotOptions, SnapshotResults};
use steadycut::app::Console;
use steadycut::app::command::{Command, HandCommand, PlaybackCommand, SessionCommand};
use steadycut::app::session::Session;
use steadycut::app::session::hand::KnobScale;
use steadycut::base::settings::Value;
use steadycut::blocks::control::ControllerKind;
use steadycut::run::edits::Edits;
use steadycut::run::job::Job;
use steadycut::run::one_run::{End, Run};
use steadycut::run::{Start, presets, scenario_file, scenario_link};
use steadycut::study::compare::by_hand::{ByHandJob, HAND};

use crate::drawn;
use crate::screen::{self, Screen, finger, rest, sliced, texts};

const DESKTOP: Vec2 = vec2(1280.0, 800.0);
const PHONE: Vec2 = vec2(390.0, 844.0);
const SIZES: [Vec2; 2] = [DESKTOP, PHONE];
const KNOB: &str = "Feed override by hand";
/// What a period of control is, s.
const PERIOD_S: f64 = 0.02;

/// The operator's view of the deeper stretch without a controller, paused at its start.
fn by_hand<'a>(size: Vec2, changes: &[(&str, Value)]) -> Screen<'a> {
    let constant = ("controller.kind", Value::Text("constant_feed".to_owned()));
    let changes: Vec<(&str, Value)> =
        std::iter::once(constant).chain(changes.iter().cloned()).collect();
    let mut screen = screen::open("depth-step", size, "Console", &changes);
    screen.key_press(Key::Space);
    screen.run_steps(2);
    screen.key_press(Key::Home);
    screen.run_steps(2);
    press(&mut screen, Key::M);
    screen
}

fn press(screen: &mut Screen<'_>, key: Key) {
    screen.key_press(key);
    screen.run_steps(2);
}

fn session<'a>(screen: &'a Screen<'_>) -> &'a Session {
    Console::session(screen.state().as_ref().expect("made in the first frame"))
}

fn push(screen: &mut Screen<'_>, command: Command) {
    screen.state().as_ref().expect("made in the first frame").push(command);
    screen.run_steps(3);
}

fn seek(screen: &mut Screen<'_>, to_s: f64) {
    push(screen, Command::Playback(PlaybackCommand::SeekTo(to_s)));
}

fn click(screen: &mut Screen<'_>, name: &str) {
    let found = screen.get_all_by_label(name).last();
    found.unwrap_or_else(|| panic!("no {name}: {}", texts(screen))).click_accesskit();
    screen.run_steps(3);
}

/// On a phone the choice of the scale stands in one line with who has the feed, whoever that is.
#[test]
fn the_scale_stands_beside_who_has_the_feed() {
    for kind in ControllerKind::ALL {
        let set = ("controller.kind", Value::Text(kind.id().to_owned()));
        let mut screen = screen::open("depth-step", PHONE, "Console", &[set]);
        screen.key_press(Key::Space);
        screen.run_steps(2);
        press(&mut screen, Key::M);
        let height = |name: &str| screen.get_by_label(name).rect().center().y;
        let line = match session(&screen).knob().by_hand {
            true => height("You have the feed"),
            false => height("Take it"),
        };
        for name in ["Scale to 120 %", "Scale to 250 %"] {
            let rect = screen.get_by_label(name).rect();
            assert!((rect.center().y - line).abs() < 2.0, "{kind:?}, {name}: {rect:?}, {line}");
            assert!(rect.right() < PHONE.x, "{kind:?}, {name}: {rect:?}");
        }
    }
}

/// Where the pointer of the knob stands for an override on the scale of a panel: on its ring.
fn on_ring(knob: Rect, percent: f64) -> Pos2 {
    let angle = (135.0 + 270.0 * percent / 120.0).to_radians() as f32;
    knob.center() + 0.36 * knob.width() * Vec2::angled(angle)
}

fn knob(screen: &Screen<'_>) -> Rect {
    screen.get_by_role_and_label(Role::Slider, KNOB).rect()
}

fn percent(screen: &Screen<'_>) -> f64 {
    session(screen).knob().percent
}

fn wheel(screen: &mut Screen<'_>, unit: MouseWheelUnit, y: f32) {
    let (phase, source) = (TouchPhase::Move, egui::MouseWheelSource::Unknown);
    let (delta, modifiers) = (vec2(0.0, y), Modifiers::NONE);
    screen.event(Event::MouseWheel { unit, delta, phase, modifiers, source });
    screen.run_steps(1);
}

/// The edits of the knob: time in s and percent.
fn turns(screen: &Screen<'_>) -> Vec<(f64, f64)> {
    let edits = session(screen).edits().list().iter();
    let turn = |value: &Value| match value {
        Value::Float(percent) => *percent,
        other => panic!("{other:?}"),
    };
    edits.filter(|edit| edit.path == HAND).map(|edit| (edit.at_s, turn(&edit.value))).collect()
}

/// Drives the part at three overrides, and looks at it from its end.
fn driven<'a>(size: Vec2, changes: &[(&str, Value)]) -> Screen<'a> {
    let mut screen = by_hand(size, changes);
    for (at_s, percent) in [(0.0, 74.0), (8.3, 44.0), (21.0, 74.0)] {
        seek(&mut screen, at_s);
        push(&mut screen, Command::hand(HandCommand::To(percent)));
        // The hand rests, so that the next one is another turn.
        screen.run_steps(20);
    }
    push(&mut screen, Command::Playback(PlaybackCommand::SeekToEnd));
    rest(&mut screen);
    screen.run_steps(5);
    screen
}

#[test]
fn the_wheel_turns_the_knob_by_clicks_at_the_next_control_sample() {
    for size in SIZES {
        let mut screen = by_hand(size, &[]);
        seek(&mut screen, 4.013);
        let at = knob(&screen).center();
        screen.event(Event::PointerMoved(at));
        screen.run_steps(2);
        wheel(&mut screen, MouseWheelUnit::Line, 1.0);
        screen.run_steps(2);
        assert_eq!(turns(&screen), [(4.02, 102.0)]);
        for _ in 0..3 {
            wheel(&mut screen, MouseWheelUnit::Line, -1.0);
        }
        assert_eq!(turns(&screen), [(4.02, 96.0)], "the cut rests: one edit");
        // A pad scrolls smoothly: so far is a click.
        for _ in 0..5 {
            wheel(&mut screen, MouseWheelUnit::Point, -10.0);
        }
        assert_eq!(percent(&screen), 92.0);
        // Elsewhere it scrolls.
        screen.event(Event::PointerMoved(at - vec2(0.0, 0.5 * knob(&screen).height() + 40.0)));
        screen.run_steps(2);
        wheel(&mut screen, MouseWheelUnit::Line, 1.0);
        assert_eq!(percent(&screen), 92.0);
    }
}

#[test]
fn keys_turn_it_from_anywhere_in_the_mode_and_nowhere_else() {
    for size in SIZES {
        let mut screen = by_hand(size, &[]);
        seek(&mut screen, 3.0);
        for (key, now) in [
            (Key::Plus, 102.0),
            (Key::Equals, 104.0),
            (Key::Minus, 102.0),
            (Key::PageDown, 92.0),
            (Key::PageUp, 102.0),
        ] {
            press(&mut screen, key);
            assert_eq!(percent(&screen), now, "{key:?}");
        }
        press(&mut screen, Key::M);
        assert!(!session(&screen).hand().is_on());
        press(&mut screen, Key::Minus);
        assert_eq!(percent(&screen), 102.0, "the mode is off");
        press(&mut screen, Key::M);
        // With the focus it has the arrows, which else move the playhead, and Home.
        screen.get_by_role_and_label(Role::Slider, KNOB).focus();
        screen.run_steps(2);
        let before_s = session(&screen).playback().playhead_s;
        for (key, now) in [
            (Key::ArrowUp, 104.0),
            (Key::ArrowRight, 106.0),
            (Key::ArrowDown, 104.0),
            (Key::ArrowLeft, 102.0),
            (Key::Home, 100.0),
        ] {
            press(&mut screen, key);
            assert_eq!(percent(&screen), now, "{key:?}");
        }
        assert_eq!(session(&screen).playback().playhead_s, before_s);
        // A screen reader sets it, and knows its ends.
        let node = screen.get_by_role_and_label(Role::Slider, KNOB);
        let inner = node.accesskit_node();
        assert_eq!(inner.numeric_value(), Some(100.0));
        assert_eq!(
            (inner.min_numeric_value(), inner.max_numeric_value()),
            (Some(0.0), Some(120.0))
        );
        node.set_value_accesskit(71.3);
        screen.run_steps(2);
        assert_eq!(percent(&screen), 72.0, "the nearest click");
    }
}

#[test]
fn a_drag_around_it_is_one_turn_and_undo_takes_it_back() {
    for (size, by_finger) in [(DESKTOP, false), (PHONE, true)] {
        let mut screen = by_hand(size, &[]);
        seek(&mut screen, 5.0);
        let rect = knob(&screen);
        let way: Vec<Pos2> = (0..=20).map(|i| on_ring(rect, 100.0 - 2.0 * f64::from(i))).collect();
        if by_finger {
            finger(&mut screen, way[0], TouchPhase::Start);
            way[1..].iter().for_each(|at| finger(&mut screen, *at, TouchPhase::Move));
            finger(&mut screen, way[20], TouchPhase::End);
        } else {
            screen.hover_at(way[0]);
            screen.run_steps(2);
            screen.drag_at(way[0]);
            screen.run_steps(1);
            for at in &way[1..] {
                screen.hover_at(*at);
                screen.run_steps(1);
            }
            screen.drop_at(way[20]);
        }
        screen.run_steps(3);
        assert_eq!(percent(&screen), 60.0, "{size}");
        assert_eq!(turns(&screen), [(5.0, 60.0)]);
        screen.run_steps(20);
        press(&mut screen, Key::Minus);
        assert_eq!(percent(&screen), 58.0);
        for now in [60.0, 100.0] {
            screen.key_press_modifiers(Modifiers::COMMAND, Key::Z);
            screen.run_steps(3);
            assert_eq!(percent(&screen), now);
        }
        assert!(turns(&screen).is_empty());
        screen.key_press_modifiers(Modifiers::COMMAND, Key::Y);
        screen.run_steps(3);
        assert_eq!(percent(&screen), 60.0);
    }
}

#[test]
fn the_buttons_beside_it_turn_it_and_all_is_large_enough_for_a_thumb() {
    for size in SIZES {
        let mut screen = by_hand(size, &[]);
        click(&mut screen, "Override 2 % up");
        click(&mut screen, "Override 2 % down");
        click(&mut screen, "Override 2 % down");
        assert_eq!(turns(&screen), [(0.0, 98.0)], "at the start, too, it is an edit");
        assert_eq!(screen.unnamed_widgets(), Vec::<String>::new());
        if size == PHONE {
            let rect = knob(&screen);
            assert!(rect.top() > 0.5 * size.y, "a thumb holds the phone at its lower end: {rect}");
            assert!(rect.width() >= 120.0);
            for name in ["Override 2 % up", "Override 2 % down", "Cut by hand", "Leave"] {
                let target = screen.get_by_label(name).rect().size() + Vec2::splat(0.1);
                assert!(target.min_elem() >= 44.0, "{name}: {target}");
            }
        }
    }
}

#[test]
fn a_storm_of_turns_is_a_short_link_and_changes_nothing_that_is_cut() {
    let mut screen = by_hand(DESKTOP, &[("program.feed_mm_min", Value::Float(180.0))]);
    press(&mut screen, Key::Space);
    let at = knob(&screen).center();
    screen.event(Event::PointerMoved(at));
    screen.run_steps(2);
    // 40 s in frames of 50 ms, the wheel turned in every one of them, to and fro.
    let mut told: Vec<(f64, f64)> = Vec::new();
    for frame in 0..800 {
        let now_s = session(&screen).playback().playhead_s;
        let cut: Vec<_> =
            turns(&screen).into_iter().filter(|(at_s, _)| *at_s < now_s - 1e-3).collect();
        assert!(cut.starts_with(&told), "frame {frame}: {told:?} is {cut:?} now");
        told = cut;
        let y = if frame % 14 < 7 { -1.0 } else { 1.0 };
        wheel(&mut screen, MouseWheelUnit::Line, y);
    }
    let all = turns(&screen);
    assert!(session(&screen).playback().playhead_s > 39.0 && all.len() > 200, "{}", all.len());
    for pair in all.windows(2) {
        assert!(pair[1].0 - pair[0].0 > 0.099, "{pair:?}");
    }
    for (at_s, _) in &all {
        let samples = at_s / PERIOD_S;
        assert!((samples - samples.round()).abs() < 1e-6, "{at_s} s is no control sample");
    }
    let link = scenario_link::write(session(&screen).scenario(), session(&screen).edits());
    assert!(link.len() < 2000, "{} characters for {} edits", link.len(), all.len());
    // All of it was one turn.
    screen.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    screen.run_steps(3);
    assert!(turns(&screen).is_empty());
}

#[test]
fn beyond_its_ends_it_is_refused_with_the_reason() {
    for size in SIZES {
        let least = ("cnc.override_min_percent", Value::Float(40.0));
        let mut screen = by_hand(size, &[least]);
        seek(&mut screen, 2.0);
        push(&mut screen, Command::hand(HandCommand::To(150.0)));
        assert_eq!(percent(&screen), 120.0);
        let said = texts(&screen);
        assert!(said.contains("150 % is refused: the scale of the panel ends at 120 %."), "{said}");
        push(&mut screen, Command::hand(HandCommand::To(10.0)));
        assert_eq!(percent(&screen), 40.0);
        let said = texts(&screen);
        assert!(said.contains("the override (cnc.override_min_percent) ends at 40 %"), "{said}");
        press(&mut screen, Key::Plus);
        assert!(!texts(&screen).contains("is refused"));
        // As far as controllers may, if one asks for it.
        click(&mut screen, "Scale to 250 %");
        assert_eq!(session(&screen).hand().scale(), KnobScale::Whole);
        push(&mut screen, Command::hand(HandCommand::To(150.0)));
        assert_eq!(percent(&screen), 150.0);
        push(&mut screen, Command::hand(HandCommand::To(300.0)));
        assert!(texts(&screen).contains("(cnc.override_max_percent) ends at 250 %"));
    }
}

#[test]
fn the_feed_is_taken_from_a_controller_and_given_back() {
    for size in SIZES {
        let mut screen = screen::open("depth-step", size, "Console", &[]);
        press(&mut screen, Key::Space);
        seek(&mut screen, 8.0);
        press(&mut screen, Key::M);
        assert!(texts(&screen).contains("Tracking has the feed"), "{}", texts(&screen));
        let sent = session(&screen).row().feed_override_percent;
        assert_eq!(percent(&screen), sent, "the pointer follows the controller");
        click(&mut screen, "Take it");
        assert_eq!(turns(&screen), [(8.0, sent.round())]);
        let kind = |screen: &Screen<'_>| session(screen).current().controller.kind;
        assert_eq!(kind(&screen), ControllerKind::ConstantFeed);
        assert!(session(&screen).twin().run().edits().list().is_empty(), "it is the hand's alone");
        screen.run_steps(20);
        seek(&mut screen, 12.0);
        click(&mut screen, "Give it back to Tracking");
        assert_eq!(kind(&screen), ControllerKind::Tracking);
        // A turn takes it as well; one step of undo gives it back.
        screen.run_steps(20);
        seek(&mut screen, 13.0);
        press(&mut screen, Key::Minus);
        assert_eq!(kind(&screen), ControllerKind::ConstantFeed);
        assert!(texts(&screen).contains("You have the feed"));
        screen.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        screen.run_steps(3);
        assert_eq!(kind(&screen), ControllerKind::Tracking);
    }
}

#[test]
fn a_cut_driven_by_hand_replays_to_the_same_bits_from_file_and_link() {
    let screen = driven(DESKTOP, &[]);
    let session = session(&screen);
    let run = session.chosen().run();
    assert_eq!(run.end(), Some(&End::PathDone));
    let digest = run.recording().digest();
    let text = scenario_file::write(session.scenario(), session.edits());
    let (scenario, edits) = scenario_file::parse(&text).unwrap();
    assert_eq!(Run::complete(&scenario, &edits).recording().digest(), digest);
    // And by the program without a window.
    let file = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("by-hand.toml");
    std::fs::write(&file, &text).unwrap();
    let link = format!("#{}", scenario_link::write(session.scenario(), session.edits()));
    for cut in [file.to_str().unwrap(), &link] {
        let mut program = Program::new(env!("CARGO_BIN_EXE_steadycut"));
        let output = program.args(["run", cut, "--json"]).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let told: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(told["digest"].as_str(), Some(digest.as_str()), "{cut}");
    }
}

#[test]
fn the_score_is_that_of_the_study_and_tells_it_in_a_sentence() {
    for size in SIZES {
        let screen = driven(size, &[]);
        let session = session(&screen);
        let mut job = ByHandJob::new(session.scenario(), session.edits());
        job.to_end();
        let score = job.partial();
        let said = texts(&screen);
        assert!(said.contains(score.verdict.as_deref().unwrap()), "{said}");
        for row in &score.rows {
            assert!(said.contains(&row.name), "{}", row.name);
            let time = format!("{:.1}", row.outcome.time_s.unwrap());
            assert!(said.contains(&time), "{}: {time}", row.name);
            let name = format!("Cut by {}", row.name);
            let button = screen.query_by_label(&name);
            assert_eq!(button.is_some(), row.id.is_some(), "{}", row.name);
        }
        assert_eq!(score.rows[0].outcome.digest, session.chosen().run().recording().digest());
        assert_eq!(screen.unnamed_widgets(), Vec::<String>::new());
    }
}

/// A script that has the feed before the hand takes it is one of the others, and can be watched.
#[test]
fn a_script_of_ones_own_is_an_opponent_of_the_hand() {
    let code = "fn update(now) { if now.a > 1.0 { 60.0 } else { 40.0 } }";
    let of_own = [
        ("controller.kind", Value::Text("script".to_owned())),
        ("controller.script.code", Value::Text(code.to_owned())),
        ("controller.script.a", Value::Float(2.0)),
    ];
    let cut = |is_played: bool| {
        let mut screen = screen::open("depth-step", DESKTOP, "Console", &of_own);
        if is_played {
            press(&mut screen, Key::Space);
        }
        press(&mut screen, Key::M);
        click(&mut screen, "Cut by hand");
        assert_eq!(session(&screen).scenario().controller.kind, ControllerKind::ConstantFeed);
        push(&mut screen, Command::hand(HandCommand::To(70.0)));
        push(&mut screen, Command::Playback(PlaybackCommand::SeekToEnd));
        rest(&mut screen);
        screen.run_steps(5);
        screen
    };
    // What was brought and never let run takes no part.
    let screen = cut(false);
    assert!(texts(&screen).contains("Cut by Tracking"), "{}", texts(&screen));
    assert!(!texts(&screen).contains("Own script"), "{}", texts(&screen));
    let mut screen = cut(true);
    assert!(texts(&screen).contains("Own script"), "{}", texts(&screen));
    click(&mut screen, "Cut by Own script");
    let now = session(&screen).scenario();
    assert_eq!(now.controller.kind, ControllerKind::Script);
    assert_eq!((now.controller.script.code.text(), now.controller.script.a), (code, 2.0));
    // Without one it is none of the others.
    let screen = driven(DESKTOP, &[]);
    assert!(!texts(&screen).contains("Own script"));
}

#[test]
fn a_controller_cuts_the_same_part_next_with_the_hand_beside_it() {
    for size in SIZES {
        let mut screen = driven(size, &[]);
        assert!(session(&screen).hand_trace().is_none(), "it is the cut itself");
        click(&mut screen, "Cut by Tracking");
        let now = session(&screen);
        assert_eq!(now.scenario().controller.kind, ControllerKind::Tracking);
        assert!(now.playback().playhead_s < 1.0 && !now.is_by_hand());
        assert!(now.hand_trace().is_some());
        assert!(screen.query_all_by_label("your hand").next().is_some(), "{}", texts(&screen));
        // One step of undo brings the cut by hand back; another part has no use for it.
        screen.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        screen.run_steps(3);
        assert_eq!(turns(&screen).len(), 3);
        assert!(session(&screen).hand_trace().is_none());
        let other = SessionCommand::LoadPreset("first-cut".to_owned());
        push(&mut screen, Command::Session(other));
        assert!(session(&screen).hand_trace().is_none());
    }
}

#[test]
fn before_a_cut_and_after_one_without_a_turn_it_says_what_to_do() {
    for size in SIZES {
        let mut screen = by_hand(size, &[]);
        let said = texts(&screen);
        assert!(said.contains("Asked for is Ra 0.810 µm ± 10 %"), "{said}");
        push(&mut screen, Command::Playback(PlaybackCommand::SeekToEnd));
        rest(&mut screen);
        let said = texts(&screen);
        assert!(said.contains("This cut was not driven by hand"), "{said}");
        // The knob is of no use at the end, and says so.
        press(&mut screen, Key::Minus);
        assert!(turns(&screen).is_empty());
        assert!(texts(&screen).contains("The cut is over"), "{}", texts(&screen));
        click(&mut screen, "Cut by hand");
        assert!(session(&screen).playback().playhead_s < 1.0);
        assert!(session(&screen).playback().playing);
    }
}

#[test]
fn a_stop_by_overload_while_driving_ends_the_cut_and_can_be_tried_again() {
    for size in SIZES {
        let stop =
            [("cnc.force_stop", Value::Bool(true)), ("cnc.force_stop_n", Value::Float(225.0))];
        let mut screen = by_hand(size, &stop);
        assert!(texts(&screen).contains("225 N stops the feed"), "{}", texts(&screen));
        press(&mut screen, Key::Space);
        screen.run_steps(20);
        press(&mut screen, Key::PageUp);
        press(&mut screen, Key::PageUp);
        crate::screen::in_time(|| {
            screen.run_steps(1);
            session(&screen).finished().is_some()
        });
        let end = session(&screen).finished().cloned();
        assert!(matches!(end, Some(End::Overload(_))), "{end:?}");
        rest(&mut screen);
        screen.run_steps(5);
        let said = texts(&screen);
        assert!(said.contains("did not come to its end"), "{said}");
        click(&mut screen, "Back to before it went wrong");
        assert!(session(&screen).finished().is_none());
        (0..3).for_each(|_| press(&mut screen, Key::PageDown));
        assert!(!matches!(session(&screen).chosen().run().end(), Some(End::Overload(_))));
    }
}

#[test]
fn the_mission_gives_the_knob_and_its_keys() {
    for size in SIZES {
        let mut screen = screen::open("first-cut", size, "Learn", &[]);
        click(&mut screen, "Begin: Beat the controller by hand");
        assert!(session(&screen).hand().is_on());
        click(&mut screen, "Go on without a prediction");
        click(&mut screen, "Go on all the same");
        screen.run_steps(5);
        press(&mut screen, Key::Space);
        seek(&mut screen, 6.0);
        press(&mut screen, Key::Minus);
        assert_eq!(percent(&screen), 98.0, "{}", texts(&screen));
        assert!(screen.query_by_role_and_label(Role::Slider, KNOB).is_some());
        // No controller is open there.
        push(&mut screen, Command::hand(HandCommand::CutBy("tracking")));
        assert_eq!(session(&screen).scenario().controller.kind, ControllerKind::ConstantFeed);
        push(&mut screen, Command::Session(SessionCommand::EndMission));
        assert!(!session(&screen).hand().is_on());
    }
}

/// The console in a window that is drawn.
fn drawn_screen<'a>(size: Vec2, theme: Theme) -> Screen<'a> {
    let builder = Harness::builder().with_size(size).with_step_dt(0.05).with_theme(theme);
    let mut screen: Screen<'_> = builder.wgpu().build_ui_state(
        |ui, console: &mut Option<Console>| {
            let console = console.get_or_insert_with(|| {
                let part = presets::load("depth-step").unwrap();
                let scenario = ByHandJob::without_control(&part);
                let start = Start { scenario, edits: Edits::none(), notice: None };
                sliced(Console::new(ui.ctx(), start))
            });
            console.ui(ui);
        },
        None,
    );
    screen.run_steps(3);
    press(&mut screen, Key::Space);
    press(&mut screen, Key::M);
    for (at_s, percent) in [(0.0, 74.0), (8.3, 44.0), (21.0, 74.0)] {
        seek(&mut screen, at_s);
        push(&mut screen, Command::hand(HandCommand::To(percent)));
        screen.run_steps(20);
    }
    screen
}

#[test]
fn it_looks_as_it_should() {
    if !drawn::in_software() {
        return;
    }
    let mut results = SnapshotResults::new();
    for (size, theme, name) in [
        (DESKTOP, Theme::Dark, "operator-dark"),
        (DESKTOP, Theme::Light, "operator-light"),
        (PHONE, Theme::Light, "operator-phone"),
        (PHONE, Theme::Dark, "operator-phone-dark"),
    ] {
        let mut screen = drawn_screen(size, theme);
        seek(&mut screen, 9.0);
        rest(&mut screen);
        screen.run_steps(80);
        results.add(screen.try_snapshot_options(name, &SnapshotOptions::default()));
        push(&mut screen, Command::Playback(PlaybackCommand::SeekToEnd));
        rest(&mut screen);
        screen.run_steps(10);
        let scored = format!("{name}-score");
        results.add(screen.try_snapshot_options(&scored, &SnapshotOptions::default()));
        click(&mut screen, "Cut by Tracking");
        press(&mut screen, Key::Space);
        seek(&mut screen, 12.0);
        rest(&mut screen);
        screen.run_steps(80);
        let beside = format!("{name}-beside");
        results.add(screen.try_snapshot_options(&beside, &SnapshotOptions::default()));
    }
}
