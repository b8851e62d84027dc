//! What is looked for is found: search from any screen, settings in the diagram's cards, words explained where
//! they stand.

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, Vec2, pos2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use steadycut::base::settings::Value;
use steadycut::run::glossary::{GLOSSARY, terms_in};
use steadycut::run::scenario::Scenario;

use crate::screen::{Screen, open, texts};

const DESKTOP: Vec2 = vec2(1280.0, 800.0);
const PHONE: Vec2 = vec2(390.0, 844.0);

fn current<'a>(screen: &'a Screen<'_>) -> &'a Scenario {
    screen.state().as_ref().expect("made in the first frame").session().current()
}

fn shown(screen: &Screen<'_>) -> String {
    let state = screen.state().as_ref().unwrap().state_json();
    serde_json::from_str::<serde_json::Value>(&state).unwrap()["screen"]
        .as_str()
        .unwrap()
        .to_owned()
}

fn find(screen: &mut Screen<'_>, words: &str) {
    // Else the word under it would be explained.
    screen.event(Event::PointerGone);
    screen.key_press(Key::Slash);
    screen.run_steps(3);
    screen.event(Event::Text(words.to_owned()));
    screen.run_steps(3);
}

/// A setting that nothing uses as things stand is found with the reason, in the words of the screen, and with what
/// would use it.
#[test]
fn what_is_not_used_is_found_with_the_way_to_use_it() {
    for size in [DESKTOP, PHONE] {
        let tracking = [("controller.kind", Value::Text("tracking".to_owned()))];
        let mut screen = open("first-cut", size, "Console", &tracking);
        find(&mut screen, "controller.sdnrp.kp");
        let said = texts(&screen);
        assert!(said.contains("Not used now: “Controller” is another one."), "{said}");
        assert!(!said.contains('`'), "{said}");
        screen.get_by_role_and_label(Role::Button, "Control by SDNRP").click();
        screen.run_steps(3);
        assert_eq!(current(&screen).controller.kind.id(), "sdnrp");
        assert!(!texts(&screen).contains("Not used now"), "{}", texts(&screen));
        // Any other reason: the setting that decides it stands below.
        find(&mut screen, "cnc.force_stop_n");
        let said = texts(&screen);
        assert!(said.contains("Not used now: "), "{said}");
        let decides = current(&screen).cnc.force_stop;
        assert!(!decides);
        screen.get_by_role_and_label(Role::CheckBox, "Stop on overload").click();
        screen.run_steps(3);
        assert!(current(&screen).cnc.force_stop);
        assert!(!texts(&screen).contains("Not used now"), "{}", texts(&screen));
    }
}

/// A slow machine puts the key that opens the search and the words typed after it into one frame: no letter of them
/// is a key of the console, and the key's own sign is no word.
#[test]
fn what_is_typed_in_the_frame_that_opens_the_search_is_looked_for() {
    let mut screen = open("first-cut", DESKTOP, "Console", &[]);
    screen.run_steps(3);
    let edits =
        |screen: &Screen<'_>| screen.state().as_ref().unwrap().session().edits().list().len();
    let before = edits(&screen);
    let strike = |key: Key, text: &str| {
        let key = |pressed| Event::Key {
            key,
            physical_key: None,
            pressed,
            repeat: false,
            modifiers: Modifiers::NONE,
        };
        [key(true), Event::Text(text.to_owned()), key(false)]
    };
    // H would drop a hard spot.
    for (key, text) in [(Key::Slash, "/"), (Key::H, "h"), (Key::O, "o"), (Key::S, "s")] {
        for event in strike(key, text) {
            screen.input_mut().events.push(event);
        }
    }
    screen.run_steps(4);
    let field = screen.get_by_role(Role::TextInput).accesskit_node();
    assert_eq!(field.value().as_deref(), Some("hos"));
    assert_eq!(edits(&screen), before);
    // What was looked for last is replaced by what is typed then.
    screen.key_press(Key::Escape);
    screen.run_steps(3);
    for (key, text) in [(Key::Slash, "/"), (Key::K, "k")] {
        for event in strike(key, text) {
            screen.input_mut().events.push(event);
        }
    }
    screen.run_steps(4);
    let field = screen.get_by_role(Role::TextInput).accesskit_node();
    assert_eq!(field.value().as_deref(), Some("k"));
}

#[test]
fn a_word_finds_a_setting_which_is_set_there_and_then() {
    for size in [DESKTOP, PHONE] {
        let mut screen = open("first-cut", size, "Compare", &[]);
        find(&mut screen, "assumed by");
        assert!(texts(&screen).contains("Nothing has these words"), "{}", texts(&screen));
        screen.key_press(Key::Escape);
        screen.run_steps(3);
        assert!(screen.query_by_role_and_label(Role::Window, "Find").is_none(), "Escape closes it");
        find(&mut screen, "dead time");
        screen.run_steps(20);
        // The glossary's own result, if it is among those in sight; nothing lies over the results.
        let meaning = terms_in("dead time").next().unwrap().meaning;
        assert!(
            screen.query_all_by_role_and_label(Role::Label, meaning).count() <= 1,
            "{}",
            texts(&screen)
        );
        let window = screen.get_by_role_and_label(Role::Window, "Find").rect();
        assert!(window.height() > 250.0, "several results are seen at once: {window:?}");
        screen.key_press(Key::Escape);
        screen.run_steps(3);
        find(&mut screen, "cnc.dead");
        let before = current(&screen).cnc.dead_time_s;
        let field = screen.get_by_role_and_label(Role::SpinButton, "Dead time");
        let inside = field.rect();
        assert!(screen.ctx.content_rect().contains_rect(inside), "{inside:?}");
        field.focus();
        screen.run_steps(2);
        screen.key_press_modifiers(Modifiers::NONE, Key::ArrowUp);
        screen.run_steps(3);
        assert!(current(&screen).cnc.dead_time_s > before, "{before}");
    }
}

#[test]
fn what_was_looked_for_last_stands_there_to_be_used_again_or_replaced() {
    for size in [DESKTOP, PHONE] {
        let mut screen = open("first-cut", size, "Console", &[]);
        let typed =
            |screen: &Screen<'_>| screen.get_by_role(Role::TextInput).accesskit_node().value();
        find(&mut screen, "dead time");
        screen.key_press(Key::Escape);
        screen.run_steps(3);
        find(&mut screen, "");
        assert_eq!(typed(&screen).as_deref(), Some("dead time"));
        screen.event(Event::Text("noise".to_owned()));
        screen.run_steps(3);
        assert_eq!(typed(&screen).as_deref(), Some("noise"), "all of it was selected");
    }
}

#[test]
fn scenarios_screens_and_words_are_found_too() {
    let mut screen = open("first-cut", DESKTOP, "Compare", &[]);
    find(&mut screen, "brings chatter");
    screen.key_press(Key::Enter);
    screen.run_steps(3);
    assert_eq!(current(&screen).info.name, "chatter", "Enter takes the best");
    find(&mut screen, "workpiece");
    screen.get_by_role_and_label(Role::Button, "screen: Workpiece").click();
    screen.run_steps(3);
    assert_eq!(shown(&screen), "workpiece");
    assert!(screen.query_by_role_and_label(Role::Window, "Find").is_none(), "it is closed");
    find(&mut screen, "nsn");
    assert!(
        texts(&screen).contains("Normalised standard error of the force"),
        "{}",
        texts(&screen)
    );
}

/// What people looked for without knowing what it is called here.
#[test]
fn what_has_another_name_here_is_found_by_the_words_that_people_type() {
    let mut screen = open("first-cut", PHONE, "Console", &[]);
    for (words, found) in [
        ("digest", "command: Copy a link to this state"),
        ("command line", "command: Copy a link to this state"),
        ("own data", "screen: Identify"),
        ("measurements", "command: Search formulas in a table of one's own"),
        ("data", "command: Export all signals as CSV"),
        ("help", "command: Keys and gestures"),
        ("dark", "command: Dark colours"),
        ("rerun", "command: Apply from the start"),
        ("lobes", "screen: Machine"),
    ] {
        find(&mut screen, words);
        let shown = screen.query_by_role_and_label(Role::Button, found);
        assert!(shown.is_some(), "{words}: {}", texts(&screen));
        screen.key_press(Key::Escape);
        screen.run_steps(3);
    }
    // A short word is not looked for inside of others, and what it means is told with what has it.
    find(&mut screen, "Kp");
    assert!(texts(&screen).contains("Gain Kp"), "{}", texts(&screen));
    let inside = screen.query_by_role_and_label(Role::Button, "screen: Workpiece");
    assert!(inside.is_none(), "{}", texts(&screen));
    screen.key_press(Key::Escape);
    screen.run_steps(3);
    find(&mut screen, "own data");
    screen.get_by_role_and_label(Role::Button, "screen: Identify").click();
    screen.run_steps(3);
    assert_eq!(shown(&screen), "identify");
}

#[test]
fn a_word_is_explained_beside_the_tooltip_of_what_it_stands_in() {
    let mut screen = open("first-cut", DESKTOP, "Console", &[]);
    let place = screen.get_by_label("Remaining error").rect().center();
    screen.event(Event::PointerMoved(place));
    screen.run_steps(40);
    assert!(explained(&screen, "remaining error"), "{}", texts(&screen));
    let meaning = terms_in("remaining error").next().unwrap().meaning;
    let word = screen.get_by_label(meaning).rect();
    let help = screen.get_by_label_contains("The steady-state error: how far").rect();
    assert!(!word.intersects(help), "{word:?} and {help:?}");
    let window = screen.ctx.content_rect();
    assert!(window.contains_rect(word) && window.contains_rect(help), "{word:?} and {help:?}");
}

#[test]
fn another_card_begins_at_its_head() {
    for size in [DESKTOP, PHONE] {
        let mut screen = open("table3-5", size, "Block diagram", &[]);
        let block = |screen: &mut Screen<'_>, name: &str| {
            screen.get_by_role_and_label(Role::Button, name).click_accesskit();
            screen.run_steps(3);
        };
        block(&mut screen, "Controller K2, K3");
        let heading = |screen: &Screen<'_>, name: &str| {
            screen.get_all_by_role_and_label(Role::Label, name).next().unwrap().rect()
        };
        let top = heading(&screen, "Controller K2, K3").top();
        let inside = heading(&screen, "Controller K2, K3").center() + vec2(0.0, 60.0);
        screen.event(Event::PointerMoved(inside));
        let (unit, phase) = (egui::MouseWheelUnit::Point, egui::TouchPhase::Move);
        let (delta, modifiers) = (vec2(0.0, -120.0), Modifiers::NONE);
        let source = egui::MouseWheelSource::Unknown;
        screen.event(Event::MouseWheel { unit, delta, phase, modifiers, source });
        screen.run_steps(20);
        assert!(heading(&screen, "Controller K2, K3").top() < top - 60.0, "it is scrolled");
        block(&mut screen, "Reference K1");
        assert!((heading(&screen, "Reference K1").top() - top).abs() < 1.0);
    }
}

#[test]
fn the_card_of_a_box_sets_what_it_shows() {
    for size in [DESKTOP, PHONE] {
        let kind = Value::Text("sdnrp".to_owned());
        let mut screen = open("first-cut", size, "Block diagram", &[("controller.kind", kind)]);
        screen.get_by_role_and_label(Role::Button, "Controller K2, K3").click();
        screen.run_steps(3);
        let before = current(&screen).controller.sdnrp.kp;
        screen.get_by_role_and_label(Role::SpinButton, "Gain Kp").focus();
        screen.run_steps(2);
        screen.key_press(Key::ArrowUp);
        screen.run_steps(3);
        assert!(current(&screen).controller.sdnrp.kp > before, "{before}");
    }
}

/// The meaning of a term, if it is on the screen.
fn explained(screen: &Screen<'_>, word: &str) -> bool {
    let meaning = terms_in(word).next().expect("in the glossary").meaning;
    screen.query_by_label(meaning).is_some()
}

#[test]
fn a_pointer_that_rests_on_a_word_is_told_what_it_means() {
    let mut screen = open("first-cut", DESKTOP, "Console", &[]);
    assert!(!explained(&screen, "in tolerance"));
    let place = screen.get_by_label_contains("Ra in tolerance").rect().center();
    screen.event(Event::PointerMoved(place));
    screen.run_steps(4);
    assert!(!explained(&screen, "in tolerance"), "not at once: it would be in the way");
    // After the tooltip of the card that it stands on, to those who stay.
    screen.run_steps(34);
    assert!(explained(&screen, "in tolerance"));
    screen.event(Event::PointerMoved(place + vec2(0.0, 300.0)));
    screen.run_steps(3);
    assert!(!explained(&screen, "in tolerance"));
}

#[test]
fn the_keyboard_is_told_too_while_the_pointer_lies_still() {
    let mut screen = open("first-cut", DESKTOP, "Console", &[]);
    screen.event(Event::PointerMoved(pos2(640.0, 700.0)));
    screen.run_steps(20);
    assert!(!explained(&screen, "Ra"));
    screen.get_by_role_and_label(Role::SpinButton, "Target Ra").focus();
    screen.run_steps(20);
    // A field that is being typed in is told nothing; the slider below it is.
    screen.get_by_role_and_label(Role::Slider, "Target Ra").focus();
    screen.run_steps(20);
    screen.get_by_role_and_label(Role::ComboBox, "Controller").focus();
    screen.run_steps(20);
    assert!(explained(&screen, "SDNRP"));
}

/// Words that everybody here knows, names, and what stands in files.
const PLAIN: &[&str] = &["SteadyCut", "OK", "ISO", "OUTSIDE", "MHz"];

/// Whether a word looks like an abbreviation or a symbol: two capitals, or a capital with a figure.
fn is_short(word: &str) -> bool {
    let capitals = word.chars().filter(char::is_ascii_uppercase).count();
    let figures = word.chars().filter(char::is_ascii_digit).count();
    word.len() <= 8
        && word.starts_with(|c: char| c.is_ascii_uppercase())
        && (capitals >= 2 || (capitals == 1 && word.len() == 2 && figures == 1))
}

#[test]
fn every_abbreviation_on_the_screens_is_in_the_glossary() {
    let mut missing: Vec<String> = Vec::new();
    for preset in ["first-cut", "chatter", "experiment-2"] {
        for title in [
            "Console",
            "Block diagram",
            "Workpiece",
            "Plan",
            "Machine",
            "Compare",
            "Papers",
            "Identify",
        ] {
            let screen = open(preset, DESKTOP, title, &[]);
            for word in texts(&screen).split(|c: char| !c.is_alphanumeric() && c != '_') {
                let known = PLAIN.contains(&word) || terms_in(word).next().is_some();
                if is_short(word) && !known && !missing.iter().any(|m| m.starts_with(word)) {
                    missing.push(format!("{word} ({title})"));
                }
            }
        }
    }
    assert!(missing.is_empty(), "nowhere explained: {missing:?}");
    assert!(is_short("SDNRP") && is_short("K1") && !is_short("Ra now") && !GLOSSARY.is_empty());
}
