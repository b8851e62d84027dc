//! The screen "Learn", driven by its accessible names: each shipped mission is failed and passed there.

use egui::accesskit::Role;
use egui::{Event, Key, Modifiers, Vec2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{SnapshotOptions, SnapshotResults};
use steadycut::app::Console;
use steadycut::app::command::{
    Command, FileCommand, PlaybackCommand, SessionCommand, ShellCommand,
};
use steadycut::app::panels::BroughtFile;
use steadycut::base::settings::{Kind, Value};
use steadycut::models::disturbances::Disturbance;
use steadycut::run::scenario::Param;
use steadycut::study::mission::shipped::{self, MISSIONS};
use steadycut::study::mission::{
    Mission, MissionAnswer, Prediction, Question, QuestionKind, TEMPLATE,
};

use crate::drawn;
use crate::screen::{self, Screen, rest, texts};

/// High enough to show all of it.
const SIZES: [Vec2; 2] = [vec2(1280.0, 2400.0), vec2(390.0, 5200.0)];

pub fn open<'a>(size: Vec2) -> Screen<'a> {
    screen::open("first-cut", size, "Learn", &[])
}

/// What a mission is done with.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Hand {
    /// The names and actions that a screen reader has.
    Reader,
    /// The keyboard alone.
    Keys,
}

pub fn click(screen: &mut Screen<'_>, name: &str) {
    press(screen, Hand::Reader, name);
}

pub fn press(screen: &mut Screen<'_>, hand: Hand, name: &str) {
    match hand {
        Hand::Reader => {
            screen.get_by_role_and_label(Role::Button, name).click_accesskit();
            screen.run_steps(3);
        }
        Hand::Keys => {
            tab_to(screen, Role::Button, name);
            key(screen, Key::Enter);
        }
    }
}

pub fn key(screen: &mut Screen<'_>, key: Key) {
    screen.key_press(key);
    screen.run_steps(3);
}

/// Most controls of a screen that Tab goes through.
const MOST_TABS: usize = 150;

/// Presses Tab until what has this role and name has the focus.
pub fn tab_to(screen: &mut Screen<'_>, role: Role, name: &str) {
    let mut been = Vec::new();
    for _ in 0..MOST_TABS {
        let all = screen.root().children_recursive();
        let focused = all.filter(|node| node.is_focused());
        been.extend(focused.map(|node| node.accesskit_node().label().unwrap_or_default()));
        if screen.query_all_by_role_and_label(role, name).any(|node| node.is_focused()) {
            return;
        }
        screen.key_press(Key::Tab);
        screen.run_steps(2);
    }
    panic!("Tab does not come to {role:?} {name}, but to {been:?}");
}

/// Types a number into the field of this name.
fn type_number(screen: &mut Screen<'_>, hand: Hand, name: &str, value: f64) {
    match hand {
        Hand::Reader => {
            // Of fields of one name that of the chosen controller alone is open.
            screen
                .get_all_by_role_and_label(Role::SpinButton, name)
                .find(|field| !field.accesskit_node().is_disabled())
                .unwrap_or_else(|| panic!("{name} is open"))
                .set_value_accesskit(value);
            screen.run_steps(3);
        }
        Hand::Keys => {
            tab_to(screen, Role::SpinButton, name);
            screen.key_press_modifiers(Modifiers::COMMAND, Key::A);
            screen.run_steps(2);
            screen.event(Event::Text(value.to_string()));
            key(screen, Key::Enter);
        }
    }
}

/// Sets a setting by its editor on the screen.
fn set(screen: &mut Screen<'_>, hand: Hand, param: &Param, value: Value) {
    let label = param.spec.label;
    match (&param.spec.allowed, &value) {
        (Kind::Float { .. }, Value::Float(number)) => type_number(screen, hand, label, *number),
        (Kind::Int { .. }, Value::Int(number)) => {
            type_number(screen, hand, label, *number as f64);
        }
        (Kind::Bool, _) => match hand {
            Hand::Reader => {
                screen.get_by_role_and_label(Role::CheckBox, label).click_accesskit();
                screen.run_steps(3);
            }
            Hand::Keys => {
                tab_to(screen, Role::CheckBox, label);
                key(screen, Key::Enter);
            }
        },
        (Kind::Choice { options }, Value::Text(id)) => {
            let option = options.iter().find(|option| option.id == id).expect("an option");
            match hand {
                Hand::Reader => {
                    screen.get_by_role_and_label(Role::ComboBox, label).click_accesskit();
                    screen.run_steps(3);
                }
                Hand::Keys => {
                    tab_to(screen, Role::ComboBox, label);
                    key(screen, Key::Enter);
                }
            }
            press(screen, hand, option.label);
        }
        // Tables of numbers have an editor of their own, which other tests go through.
        (Kind::Structured(_) | Kind::Text { .. }, _) => {
            push(screen, Command::set(&param.path, value.clone()));
        }
        (kind, value) => panic!("{}: {value} is none of {kind:?}", param.path),
    }
    let now = console(screen).session().current().get(&param.path).expect("a setting");
    assert_eq!(now, value, "{}", param.path);
}

pub fn console<'a>(screen: &'a Screen<'_>) -> &'a Console {
    screen.state().as_ref().expect("made in the first frame")
}

pub fn push(screen: &mut Screen<'_>, command: Command) {
    screen.state().as_ref().unwrap().push(command);
    screen.run_steps(3);
}

pub fn answer(mission: &Mission, kind: &str) -> MissionAnswer {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/crates/study/tests/data/missions");
    let text = std::fs::read_to_string(format!("{folder}/{}.{kind}.toml", mission.id)).unwrap();
    MissionAnswer::read(&text, mission).unwrap()
}

/// Leaves the question of the step under way without an answer: that is asked twice.
pub fn skip(screen: &mut Screen<'_>, hand: Hand, name: &str) {
    press(screen, hand, name);
    press(screen, hand, "Go on all the same");
}

/// The names of the buttons that say an answer, and that leave a question without one.
fn said_and_left(question: &Question) -> (&'static str, &'static str) {
    match question.look_up {
        false => ("That is my prediction", "Go on without a prediction"),
        true => ("That is my answer", "Go on without an answer"),
    }
}

/// Goes through the steps, predicting, then sets what the answer sets, and hands it in.
pub fn give(screen: &mut Screen<'_>, hand: Hand, mission: &Mission, answer: &MissionAnswer) {
    press(screen, hand, &format!("Begin: {}", mission.title));
    for (number, step) in (1..).zip(&mission.steps) {
        if let Some(question) = &step.predict {
            assert_eq!(texts(screen).contains("Predict first"), !question.look_up);
            let (say, leave) = said_and_left(question);
            match (&question.kind, answer.predictions.get(&number)) {
                (_, None) => {
                    skip(screen, hand, leave);
                    continue;
                }
                (QuestionKind::Choice(options), Some(Prediction::Choice(chosen))) => {
                    let text = &options[chosen - 1].text;
                    match hand {
                        Hand::Reader => {
                            screen.get_by_role_and_label(Role::RadioButton, text).click_accesskit();
                        }
                        Hand::Keys => {
                            tab_to(screen, Role::RadioButton, text);
                            key(screen, Key::Enter);
                        }
                    }
                }
                (QuestionKind::Number { .. }, Some(Prediction::Number(value))) => {
                    type_number(screen, hand, "Your prediction", *value);
                }
                (kind, given) => panic!("{kind:?} is not answered by {given:?}"),
            }
            screen.run_steps(3);
            // It leads on to the next step.
            press(screen, hand, say);
        } else if number < mission.steps.len() {
            press(screen, hand, "Next");
        }
    }
    assert!(!texts(screen).contains("Predict first"), "{}", mission.id);
    let mut changes = answer.scenario.difference(&mission.scenario);
    // The limits of feed control act from its references on.
    changes.sort_by_key(|(param, _)| !matches!(param.spec.allowed, Kind::Structured(_)));
    let changed = !changes.is_empty();
    for (param, value) in changes {
        set(screen, hand, param, value);
    }
    // So that it acts from the start.
    if changed && answer.edits.list().is_empty() {
        press(screen, hand, "Cut from the start");
    }
    // What is changed during the cut is changed at its moment.
    for edit in answer.edits.list() {
        rest(screen);
        let seek = PlaybackCommand::SeekTo(edit.at_s);
        push(screen, Command::Playback(seek));
        push(screen, Command::set(&edit.path, edit.value.clone()));
    }
    rest(screen);
    press(screen, hand, "Check my answer");
    rest(screen);
    screen.run_steps(3);
}

#[test]
fn every_shipped_mission_is_failed_with_help_and_passed_at_both_sizes() {
    for shipped in MISSIONS {
        let mission = shipped::load(shipped.id).unwrap();
        for size in SIZES {
            let mut screen = open(size);
            give(&mut screen, Hand::Reader, &mission, &answer(&mission, "wrong"));
            let said = texts(&screen);
            assert!(said.contains("Not passed yet"), "{}: {said}", mission.id);
            // Who begins it again knows the cut.
            let mut screen = open(size);
            give(&mut screen, Hand::Reader, &mission, &answer(&mission, "right"));
            let said = texts(&screen);
            assert!(said.contains("Passed: 3 of 3 stars"), "{}: {said}", mission.id);
            assert!(said.contains(&mission.debrief.source), "{}: {said}", mission.id);
        }
    }
}

#[test]
fn every_shipped_mission_is_done_by_keyboard_alone() {
    for shipped in MISSIONS {
        let mission = shipped::load(shipped.id).unwrap();
        let mut screen = open(SIZES[0]);
        give(&mut screen, Hand::Keys, &mission, &answer(&mission, "right"));
        let said = texts(&screen);
        assert!(said.contains("Passed: 3 of 3 stars"), "{}: {said}", mission.id);
    }
}

#[test]
fn what_was_passed_leads_on_to_the_next_mission() {
    let [first, second] = [0, 1].map(|place| shipped::load(MISSIONS[place].id).unwrap());
    let name = format!("Next mission: {}", second.title);
    let mut screen = open(SIZES[0]);
    give(&mut screen, Hand::Reader, &first, &answer(&first, "wrong"));
    assert!(!texts(&screen).contains("Next mission"), "it is not passed");
    click(&mut screen, "Leave");
    give(&mut screen, Hand::Reader, &first, &answer(&first, "right"));
    tab_to(&mut screen, Role::Button, &name);
    key(&mut screen, Key::Enter);
    let said = texts(&screen);
    assert!(said.contains(&second.title) && said.contains("Step 1 of"), "{said}");
    assert!(!said.contains("Passed:"), "{said}");
    // After the last one there is none.
    click(&mut screen, "Leave");
    let last = shipped::load(MISSIONS.last().unwrap().id).unwrap();
    give(&mut screen, Hand::Reader, &last, &answer(&last, "right"));
    let said = texts(&screen);
    assert!(said.contains("This was the last mission") && !said.contains("Next mission"), "{said}");
}

/// What is marked is the whole cut: it says so while the cut runs, and the cut is seen to its end.
#[test]
fn an_answer_that_is_checked_in_the_running_cut_runs_it_to_its_end_first() {
    for size in SIZES {
        let mut screen = open(size);
        let mission = shipped::load(MISSIONS[0].id).unwrap();
        click(&mut screen, &format!("Begin: {}", mission.title));
        skip(&mut screen, Hand::Reader, "Go on without a prediction");
        skip(&mut screen, Hand::Reader, "Go on without an answer");
        rest(&mut screen);
        push(&mut screen, Command::Playback(PlaybackCommand::SeekTo(6.0)));
        let said = texts(&screen);
        let line = said.lines().find(|line| line.starts_with("The cut still runs"));
        let line = line.unwrap_or_else(|| panic!("{said}"));
        assert!(line.contains(" %): the check runs it to its end first"), "{line}");
        assert!(console(&screen).session().finished().is_none());
        click(&mut screen, "Check my answer");
        rest(&mut screen);
        assert!(console(&screen).session().finished().is_some());
        let said = texts(&screen);
        assert!(said.contains("The cut is over: the check marks all of it."), "{said}");
        assert!(said.contains("Not passed yet"), "{said}");
    }
}

/// What more stars ask for is told in words; the names of a mission's file are for files.
#[test]
fn what_more_stars_ask_for_is_told_in_words() {
    let mission = shipped::load(MISSIONS[0].id).unwrap();
    let mut given = answer(&mission, "right");
    given.predictions.clear();
    let mut screen = open(SIZES[0]);
    give(&mut screen, Hand::Reader, &mission, &given);
    let said = texts(&screen);
    for wanted in [
        "For all three stars:",
        "reached: Share of the length in tolerance: at least 96 % (yours: ",
        "reached: Time of cut: at most 1.1 × the value of the cut as given (yours: ",
        "missed: predictions that are right, made before the cut",
        "No prediction was made in step 1: that costs the third star",
        "No answer was given in step 2: that costs the third star",
        "Tries: begun 1, checked 1",
    ] {
        assert!(said.contains(wanted), "{wanted} in {said}");
    }
    assert!(!said.contains("in_tolerance_percent"), "{said}");
}

#[test]
fn a_curve_is_sketched_by_keys() {
    let mut screen = open(SIZES[0]);
    let own = BroughtFile::Mission { name: "own.toml".to_owned(), text: TEMPLATE.to_owned() };
    push(&mut screen, Command::File(FileCommand::Bring(own)));
    for _ in 0..9 {
        let sketch = "Sketch: right and left draw, up and down lift and lower the pen";
        if screen.query_by_role_and_label(Role::Slider, sketch).is_some() {
            tab_to(&mut screen, Role::Slider, sketch);
            (0..3).for_each(|_| key(&mut screen, Key::ArrowUp));
            (0..50).for_each(|_| key(&mut screen, Key::ArrowRight));
            press(&mut screen, Hand::Keys, "That is my prediction");
            let said = texts(&screen);
            assert!(!said.contains("Go on without"), "{said}");
            return;
        }
        let leave = "Go on without a prediction";
        match screen.query_by_role_and_label(Role::Button, leave).is_some() {
            true => skip(&mut screen, Hand::Keys, leave),
            false => press(&mut screen, Hand::Keys, "Next"),
        }
    }
    panic!("the template has a sketch: {}", texts(&screen));
}

#[test]
fn what_a_mission_does_not_open_is_refused_with_the_reason_until_it_is_left() {
    let mut screen = open(SIZES[0]);
    let mission = shipped::load(MISSIONS[0].id).unwrap();
    click(&mut screen, &format!("Begin: {}", mission.title));
    let target =
        |screen: &Screen<'_>| screen.state().as_ref().unwrap().session().current().target.ra_um;
    let before = target(&screen);
    push(&mut screen, Command::set("target.ra_um", Value::Float(2.0)));
    assert_eq!(target(&screen), before);
    let said = texts(&screen);
    let title = &mission.title;
    let told = format!(
        "The mission \u{201c}{title}\u{201d} is open and locks \u{201c}Target Ra\u{201d}. It lets you change: \
         Controller, Feed override. Leave the mission to change anything else."
    );
    assert!(said.contains(&told), "{said}");
    assert!(!said.contains("target.ra_um"), "names of files are for files: {said}");
    click(&mut screen, "Leave");
    push(&mut screen, Command::set("target.ra_um", Value::Float(2.0)));
    assert_eq!(target(&screen), 2.0);
}

/// What a mission locks is refused on other screens too: there they say that it is open, and lead back.
#[test]
fn other_screens_say_that_a_mission_is_open_and_lead_back_to_it() {
    let mission = shipped::load(MISSIONS[0].id).unwrap();
    for size in [vec2(1280.0, 800.0), vec2(390.0, 844.0)] {
        let mut screen = open(size);
        assert!(!texts(&screen).contains("Back to the mission"));
        click(&mut screen, &format!("Begin: {}", mission.title));
        assert!(!texts(&screen).contains("Back to the mission"), "it is seen itself");
        push(&mut screen, Command::Shell(ShellCommand::ShowScreen("console")));
        let said = texts(&screen);
        let sign =
            said.lines().find(|line| line.starts_with("Mission") && line.contains(&mission.title));
        assert!(sign.is_some(), "{said}");
        push(&mut screen, Command::drop(Disturbance::HardSpot));
        let said = texts(&screen);
        let locks = format!(
            "\u{201c}{}\u{201d} is open and locks \u{201c}Hard spots\u{201d}",
            mission.title
        );
        assert!(said.contains(&locks), "{said}");
        tab_to(&mut screen, Role::Button, "Back to the mission");
        key(&mut screen, Key::Enter);
        click(&mut screen, "Leave");
        push(&mut screen, Command::Shell(ShellCommand::ShowScreen("console")));
        assert!(!texts(&screen).contains("Back to the mission"));
    }
}

#[test]
fn a_mission_is_left_from_another_screen() {
    let mission = shipped::load(MISSIONS[0].id).unwrap();
    let mut screen = open(vec2(1280.0, 800.0));
    click(&mut screen, &format!("Begin: {}", mission.title));
    screen::show(&mut screen, "Console");
    click(&mut screen, "Leave the mission");
    push(&mut screen, Command::drop(Disturbance::HardSpot));
    assert!(!texts(&screen).contains("is open and locks"), "{}", texts(&screen));
    screen::show(&mut screen, "Learn");
    screen.get_by_role_and_label(Role::Button, &format!("Begin: {}", mission.title));
}

#[test]
fn another_cut_leaves_the_mission_and_says_so() {
    let mut screen = open(SIZES[0]);
    let mission = shipped::load(MISSIONS[0].id).unwrap();
    click(&mut screen, &format!("Begin: {}", mission.title));
    push(&mut screen, Command::Session(SessionCommand::LoadPreset("chatter".to_owned())));
    let said = texts(&screen);
    assert!(said.contains("is left"), "{said}");
    screen.get_by_role_and_label(Role::Button, &format!("Begin: {}", mission.title));
}

/// What was there before a mission is not lost by it: undo leads back, once the mission is left.
#[test]
fn undo_leads_back_to_the_cut_before_a_mission_once_it_is_left() {
    let mut screen = open(SIZES[0]);
    let mission = shipped::load(MISSIONS[0].id).unwrap();
    let own = vec![("target.ra_um".to_owned(), Value::Float(1.1))];
    push(&mut screen, Command::Session(SessionCommand::SetUp(own)));
    let target =
        |screen: &Screen<'_>| screen.state().as_ref().unwrap().session().scenario().target.ra_um;
    click(&mut screen, &format!("Begin: {}", mission.title));
    push(&mut screen, Command::Session(SessionCommand::Undo));
    assert_eq!(target(&screen), mission.scenario.target.ra_um, "no way out of it");
    click(&mut screen, "Leave");
    push(&mut screen, Command::Session(SessionCommand::Undo));
    assert_eq!(target(&screen), 1.1);
}

#[test]
fn hints_come_one_by_one() {
    let mut screen = open(SIZES[0]);
    let mission = shipped::load(MISSIONS[0].id).unwrap();
    click(&mut screen, &format!("Begin: {}", mission.title));
    skip(&mut screen, Hand::Reader, "Go on without a prediction");
    skip(&mut screen, Hand::Reader, "Go on without an answer");
    let count = mission.hints.len();
    for (number, hint) in (1..).zip(&mission.hints) {
        assert!(!texts(&screen).contains(hint.as_str()), "{hint}");
        click(&mut screen, &format!("Hint {number} of {count}"));
        assert!(texts(&screen).contains(hint.as_str()), "{hint}");
    }
}

#[test]
fn a_mission_of_ones_own_is_dropped_and_a_wrong_one_says_where_it_is_wrong() {
    let mut screen = open(SIZES[0]);
    let bring = |text: String| {
        let name = "mine.toml".to_owned();
        Command::File(FileCommand::Bring(BroughtFile::Mission { name, text }))
    };
    push(&mut screen, bring(TEMPLATE.replace("finished == 1", "finised == 1")));
    let said = texts(&screen);
    assert!(said.contains("mine.toml") && said.contains("at line"), "{said}");
    assert!(Mission::is_meant_by(TEMPLATE));
    push(&mut screen, bring(TEMPLATE.to_owned()));
    let said = texts(&screen);
    assert!(said.contains("Hold the roughness over a deeper stretch"), "{said}");
}

/// The list, and a mission that was passed.
#[test]
fn learn_looks_as_it_should() {
    if !drawn::in_software() {
        return;
    }
    let mut results = SnapshotResults::new();
    for (size, name) in [(vec2(1280.0, 800.0), "desktop"), (vec2(390.0, 844.0), "phone")] {
        let mut screen = open(size);
        let options = SnapshotOptions::default();
        results.add(screen.try_snapshot_options(format!("learn-list-{name}"), &options));
        let mission = shipped::load(MISSIONS[0].id).unwrap();
        click(&mut screen, &format!("Begin: {}", mission.title));
        results.add(screen.try_snapshot_options(format!("learn-step-{name}"), &options));
        click(&mut screen, "Leave");
        give(&mut screen, Hand::Reader, &mission, &answer(&mission, "right"));
        push(&mut screen, Command::Playback(PlaybackCommand::SeekToEnd));
        results.add(screen.try_snapshot_options(format!("learn-passed-{name}"), &options));
    }
}
