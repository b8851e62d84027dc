//! What those meet who see the console for the first time, at a desk and with a phone in their hand.

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, Pos2, Rect, Vec2, pos2, vec2};
use egui_kittest::kittest::Queryable;
use steadycut::app::Console;
use steadycut::app::command::{Command, FileCommand};
use steadycut::app::panels::BroughtFile;
use steadycut::base::settings::Value;
use steadycut::run::glossary::terms_in;

use crate::legible::each_text;
use crate::screen::{Screen, edited, open, show, texts};
use crate::shell::swipe;

const DESKTOP: Vec2 = vec2(1280.0, 800.0);
const SMALL: Vec2 = vec2(1024.0, 768.0);
const PHONE: Vec2 = vec2(390.0, 844.0);
/// The start of the sentence that says what the program is.
const INTRODUCTION: &str = "SteadyCut simulates milling";

fn console<'a>(screen: &'a Screen<'_>) -> &'a Console {
    screen.state().as_ref().expect("made in the first frame")
}

fn press(screen: &mut Screen<'_>, key: Key) {
    screen.key_press_modifiers(Modifiers::NONE, key);
    screen.run_steps(3);
}

fn click(screen: &mut Screen<'_>, name: &str) {
    screen.get_by_role_and_label(Role::Button, name).click_accesskit();
    screen.run_steps(12);
}

fn seek(screen: &mut Screen<'_>, time_s: f64) {
    screen.get_by_role_and_label(Role::Slider, "Playhead").set_value_accesskit(time_s);
    screen.run_steps(8);
}

/// Where the timeline begins, at the foot of the window.
fn foot(screen: &Screen<'_>) -> f32 {
    screen.get_by_role_and_label(Role::Slider, "Playhead").rect().top()
}

fn roughness(screen: &Screen<'_>) -> Rect {
    screen.get_by_label_contains("Roughness from").rect()
}

/// The label of the sentence that is told at the playhead.
fn sentence(screen: &Screen<'_>) -> Rect {
    let session = console(screen).session();
    let event = session.story().change_at(session.row().time_s + 1e-9).expect("told");
    screen.get_by_label(&event.sentence).rect()
}

/// The console on the first scenario, standing where the part has got deeper.
fn at_the_step<'a>(size: Vec2) -> Screen<'a> {
    let mut screen = open("first-cut", size, "Console", &[]);
    press(&mut screen, Key::Space);
    screen.run_steps(30);
    seek(&mut screen, 9.5);
    if size.x == PHONE.x {
        // The screen was chosen as with a mouse; from now on by fingers.
        swipe(&mut screen, pos2(0.6 * size.x, 30.0), Vec2::ZERO);
    }
    screen
}

#[test]
fn the_first_screen_says_what_the_program_is_until_it_is_used() {
    for size in [DESKTOP, SMALL, PHONE] {
        let mut screen = open("first-cut", size, "Console", &[]);
        press(&mut screen, Key::Space);
        let line = screen.get_by_label_contains(INTRODUCTION).rect();
        assert!(line.bottom() < foot(&screen) && line.right() < size.x, "{line:?}");
        screen.get_by_role_and_label(Role::SpinButton, "Target Ra").focus();
        screen.run_steps(2);
        press(&mut screen, Key::ArrowUp);
        screen.run_steps(3);
        assert!(screen.query_by_label_contains(INTRODUCTION).is_none(), "it was used");
        // It can be read again.
        screen.key_press(Key::Escape);
        screen.run_steps(3);
        screen.key_press(Key::Questionmark);
        screen.run_steps(3);
        assert!(screen.query_by_label_contains(INTRODUCTION).is_some(), "{}", texts(&screen));
        let mut screen = open("first-cut", size, "Console", &[]);
        click(&mut screen, "Close the introduction");
        assert!(screen.query_by_label_contains(INTRODUCTION).is_none(), "it was closed");
    }
}

#[test]
fn a_phone_shows_name_chart_and_sentence_at_once() {
    let screen = at_the_step(PHONE);
    assert!(screen.query_by_label("SteadyCut").is_some());
    let foot = foot(&screen);
    let (chart, told) = (roughness(&screen), sentence(&screen));
    assert!(chart.bottom() < foot && told.bottom() < foot, "{chart:?} {told:?} {foot}");
    // The row of events in whole, a finger's height.
    let event = screen.get_by_label("8.61 s Depth step").rect();
    assert!(event.height() >= 40.0 && event.bottom() < foot, "{event:?}");
    for title in ["Ra now", "Ra in tolerance", "Remaining error"] {
        let card = screen.get_by_label(title).rect();
        assert!(card.right() < PHONE.x, "{title}: {card:?}");
    }
    // The other cards are moved into sight, and a finger that goes along over them scrolls.
    let mut screen = screen;
    let at = screen.get_by_label("Ra in tolerance").rect().center();
    let top = chart.top();
    for _ in 0..3 {
        swipe(&mut screen, at, vec2(-200.0, 6.0));
    }
    assert!(screen.get_by_label("Metal removed").rect().right() < PHONE.x);
    swipe(&mut screen, pos2(200.0, at.y), vec2(3.0, -150.0));
    assert!(roughness(&screen).top() < top - 60.0, "{top} to {:?}", roughness(&screen));
}

#[test]
fn no_message_lies_on_the_sentence_or_on_the_figures() {
    for size in [DESKTOP, PHONE] {
        let mut screen = at_the_step(size);
        let said =
            "The scenario file was not read: it is empty, and so long a text takes three lines.";
        console(&screen).push(Command::notify(said.to_owned()));
        screen.run_steps(4);
        let (message, told) = (screen.get_by_label(said).rect(), sentence(&screen));
        assert!(!message.expand(6.0).intersects(told), "{message:?} {told:?}");
        let figure = screen.get_by_label("Ra now").rect();
        assert!(!message.expand(6.0).intersects(figure), "{message:?} {figure:?}");
    }
}

#[test]
fn a_swipe_scrolls_wherever_it_begins() {
    let places: [fn(&Screen<'_>) -> Pos2; 3] = [
        |screen| sentence(screen).center(),
        |screen| {
            let events = ["8.61 s Depth step", "8.70 s Outside model", "8.61 s Dead time"];
            let events = events.into_iter().filter_map(|name| screen.query_by_label(name));
            let mut places = events.map(|event| event.rect().center());
            places.find(|at| (30.0..PHONE.x - 30.0).contains(&at.x)).expect("one is in sight")
        },
        |screen| screen.get_by_label("Ra in tolerance").rect().center(),
    ];
    for (number, place) in places.into_iter().enumerate() {
        // A little longer, so that the row of events is in sight.
        let mut screen = at_the_step(PHONE + vec2(0.0, 160.0));
        let (from, top) = (place(&screen), roughness(&screen).top());
        swipe(&mut screen, from, vec2(4.0, -160.0));
        let now = roughness(&screen).top();
        assert!(now < top - 60.0, "{number}: {top} to {now} from {from:?}");
        let marked = screen.ctx.plugin_or_default::<egui::text_selection::LabelSelectionState>();
        assert!(!marked.lock().has_selection(), "no text is marked");
    }
}

/// Texts that are cut off, on the whole window.
fn cut_off(screen: &Screen<'_>) -> Vec<String> {
    let mut found = Vec::new();
    each_text(screen, |text, clip| {
        let seen = clip.intersects(text.visual_bounding_rect());
        if text.galley.elided && seen {
            found.push(text.galley.job.text.clone());
        }
    });
    found
}

#[test]
fn no_text_of_the_console_is_cut_off() {
    for size in [DESKTOP, SMALL, PHONE] {
        for (preset, times_s) in [
            ("first-cut", [0.5, 9.5, 40.0]),
            ("chatter", [1.0, 4.0, 9.0]),
            ("own-formula", [1.0, 8.0, 20.0]),
        ] {
            let mut screen = open(preset, size, "Console", &[]);
            press(&mut screen, Key::Space);
            screen.run_steps(40);
            for time_s in times_s {
                seek(&mut screen, time_s);
                let found = cut_off(&screen);
                // The list of scenarios shows the whole title once it is open.
                let found: Vec<_> =
                    found.into_iter().filter(|text| !text.starts_with("Scenario: ")).collect();
                assert!(found.is_empty(), "{preset} at {time_s} s, {size}: {found:#?}");
            }
        }
    }
}

#[test]
fn depths_are_set_from_the_screen_of_the_part() {
    for size in [DESKTOP, PHONE] {
        let mut screen = open("first-cut", size, "Workpiece", &[]);
        click(&mut screen, "Edit depths\u{2026}");
        let field = screen.get_by_role_and_label(Role::SpinButton, "Axial depth of stretch 2");
        field.set_value_accesskit(2.5);
        screen.run_steps(3);
        let steps = console(&screen).session().current().workpiece.depth_steps.clone();
        assert_eq!(steps[0][1], 2.5, "{steps:?}");
    }
}

#[test]
fn the_gain_is_in_sight_as_soon_as_the_controller_is_opened() {
    for size in [DESKTOP, PHONE] {
        let kind = Value::Text("sdnrp".to_owned());
        let mut screen = open("first-cut", size, "Block diagram", &[("controller.kind", kind)]);
        click(&mut screen, "Controller K2, K3");
        let gain = screen.get_by_role_and_label(Role::SpinButton, "Gain Kp").rect();
        assert!(gain.bottom() < foot(&screen), "{size}: {gain:?}");
        // What comes of it is seen beside it.
        let plot = screen.get_all_by_role_and_label(Role::Label, "Ra").next().expect("plotted");
        assert!(plot.rect().bottom() < foot(&screen), "{:?}", plot.rect());
    }
}

#[test]
fn stability_opens_on_its_chart_whatever_was_seen_of_the_machine() {
    for size in [DESKTOP, PHONE] {
        let mut screen = open("chatter", size, "Machine", &[]);
        click(&mut screen, "Wear and sound");
        // Far down on that part.
        screen.event(Event::PointerMoved(pos2(0.7 * size.x, 500.0)));
        let (unit, phase) = (egui::MouseWheelUnit::Point, egui::TouchPhase::Move);
        let (delta, modifiers) = (vec2(0.0, -2000.0), Modifiers::NONE);
        let source = egui::MouseWheelSource::Unknown;
        screen.event(Event::MouseWheel { unit, delta, phase, modifiers, source });
        screen.run_steps(10);
        show(&mut screen, "Console");
        press(&mut screen, Key::Space);
        seek(&mut screen, 5.0);
        click(&mut screen, "Stability and sound");
        let part = screen.get_by_role_and_label(Role::Button, "Stability").rect();
        assert!(part.top() > 0.0 && part.bottom() < 200.0, "{part:?}");
        assert!(screen.query_by_label_contains("Charted: ").is_some(), "{}", texts(&screen));
    }
}

#[test]
fn nothing_moves_the_buttons_of_a_table_that_fills() {
    for size in [vec2(1280.0, 2400.0), vec2(390.0, 4200.0)] {
        let changes = [("run.duration_s", Value::Float(2.0))];
        let mut screen = open("table3-5-noise", size, "Compare", &changes);
        let place = |screen: &Screen<'_>| {
            screen.get_by_role_and_label(Role::Button, "Save comparison as CSV").rect()
        };
        let before = place(&screen);
        click(&mut screen, "Run the comparison");
        for _ in 0..40 {
            screen.run_steps(1);
            assert_eq!(place(&screen), before);
        }
        assert!(texts(&screen).contains(" runs"));
    }
}

#[test]
fn a_tooltip_comes_alone_and_the_word_only_to_those_who_stay() {
    let mut screen = open("table3-5-noise", DESKTOP, "Compare", &[]);
    let nsn = "Nsn";
    let meaning = terms_in(nsn).next().expect("in the glossary").meaning;
    let place = screen.get_all_by_role_and_label(Role::Label, nsn).next().unwrap().rect().center();
    screen.event(Event::PointerMoved(place));
    screen.run_steps(22);
    assert!(screen.query_by_label(meaning).is_none(), "one at a time");
    screen.run_steps(20);
    assert!(screen.query_by_label(meaning).is_some(), "{}", texts(&screen));
}

#[test]
fn a_phone_sets_controllers_side_by_side() {
    let changes = [("run.duration_s", Value::Float(2.0))];
    let mut screen = open("table3-5-noise", vec2(390.0, 2400.0), "Compare", &changes);
    click(&mut screen, "By measure");
    let below = |name: &str| {
        let title = screen.get_by_label_contains("Time of cut [").rect().top();
        let names = screen.get_all_by_role_and_label(Role::Label, name);
        let tops = names.map(|node| node.rect().top()).filter(|top| *top > title);
        tops.fold(f32::INFINITY, f32::min) - title
    };
    // In one card: within a hand's breadth.
    assert!(below("P") < 260.0 && below("MRAC") < 260.0, "{} {}", below("P"), below("MRAC"));
}

#[test]
fn a_table_is_shown_as_it_was_read_and_all_that_is_wrong_is_said_at_once() {
    for size in [DESKTOP, PHONE] {
        let mut screen = open("first-cut", size, "Identify", &[]);
        let bring = |screen: &mut Screen<'_>, text: &str| {
            let (name, text) = ("mine.csv".to_owned(), text.to_owned());
            let brought = FileCommand::Bring(BroughtFile::Table { name, text });
            console(screen).push(Command::File(brought));
            screen.run_steps(4);
        };
        bring(&mut screen, "Force [N];n (1/min)\n100;x\n120;y\n");
        let shown = texts(&screen);
        for part in ["2 rows: at least 5 are needed", "line 2: `n (1/min)` is `x`"] {
            assert!(shown.contains(part), "{part} in {shown}");
        }
        bring(&mut screen, "Force [N];n (1/min)\n100;1\n120,5;2\n130;4\n140;5\n150;7\n");
        let shown = texts(&screen);
        assert!(
            shown.contains("choose the column") && shown.contains("choose at least one"),
            "{shown}"
        );
        // A label is there twice, as a widget and as its text.
        let mut seen: Vec<&str> = shown.lines().collect();
        seen.dedup();
        let read = ["Force [N]", "n (1/min)", "N", "1/min", "100", "1", "120,5", "2"];
        assert!(seen.windows(read.len()).any(|part| part == read), "{shown}");
    }
}

#[test]
fn a_link_with_many_changes_says_that_it_is_not_worked_out_until_it_is() {
    let changes: Vec<(f64, &str, Value)> = (0..150)
        .map(|i| {
            (0.3 * f64::from(i), "plant.wear_factor", Value::Float(1.0 + 0.001 * f64::from(i)))
        })
        .collect();
    let mut screen = edited("first-cut", DESKTOP, "Console", &[], &changes);
    crate::screen::in_time(|| {
        screen.run_steps(1);
        console(&screen).session().progress() >= 1.0
    });
    let session = console(&screen).session();
    let met = session.twin().run().edits().list().len();
    assert_eq!((session.progress(), met), (1.0, session.edits().list().len()));
}
