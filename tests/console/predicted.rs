//! Missions as learners use them: what is to be predicted is seen nowhere before, and stays as it was said; what a check
//! comes to is in sight.

use egui::accesskit::Role;
use egui::{Key, Rect, Vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use steadycut::app::command::{
    Command, FileCommand, PlaybackCommand, SessionCommand, ShellCommand,
};
use steadycut::app::panels::{BroughtFile, panels};
use steadycut::base::settings::Value;
use steadycut::study::mission::shipped::{self, MISSIONS};
use steadycut::study::mission::{Mission, Prediction, TEMPLATE};

use crate::learn::{Hand, answer, click, console, give, key, open, push, skip, tab_to};
use crate::screen::{Screen, rest, texts};
use crate::views::{DESKTOP, PHONE};

const SIZES: [Vec2; 2] = [DESKTOP, PHONE];
const SAY: &str = "That is my prediction";
const SKIP: &str = "Go on without a prediction";
const CHECK: &str = "Check my answer";

fn begin(screen: &mut Screen<'_>, id: &str) -> Mission {
    let mission = shipped::load(id).unwrap();
    click(screen, &format!("Begin: {}", mission.title));
    mission
}

fn choose(screen: &mut Screen<'_>, option: &str) {
    screen.get_by_role_and_label(Role::RadioButton, option).click_accesskit();
    screen.run_steps(3);
}

/// Answers what the first mission asks of the cut that is seen.
fn look_up(screen: &mut Screen<'_>) {
    choose(screen, "It more than doubles");
    click(screen, "That is my answer");
}

fn check(screen: &mut Screen<'_>) {
    click(screen, CHECK);
    rest(screen);
    screen.run_steps(4);
}

#[test]
fn a_prediction_is_made_by_saying_so_and_is_fixed_once_the_cut_was_shown() {
    for size in SIZES {
        let mut screen = open(size);
        begin(&mut screen, MISSIONS[0].id);
        // What is merely marked can be marked anew, and shows nothing.
        for option in ["It gets rougher", "It gets smoother"] {
            choose(&mut screen, option);
            assert!(texts(&screen).contains("Predict first"), "{}", texts(&screen));
        }
        click(&mut screen, SAY);
        assert!(!texts(&screen).contains("Predict first"), "{}", texts(&screen));
        click(&mut screen, "Back");
        let said = texts(&screen);
        assert!(said.contains("Your prediction stays as it is: the cut has been shown."), "{said}");
        let other = screen.get_by_role_and_label(Role::RadioButton, "It gets rougher");
        assert!(other.accesskit_node().is_disabled());
        push(&mut screen, Command::set("controller.kind", Value::Text("tracking".to_owned())));
        click(&mut screen, "Next");
        look_up(&mut screen);
        click(&mut screen, "Cut from the start");
        check(&mut screen);
        let said = texts(&screen);
        assert!(said.contains("Passed: 2 of 3 stars"), "{said}");
        assert!(said.contains("Your prediction in step 1 was wrong"), "{said}");
    }
}

/// What must be right to pass can be answered anew, and is no prediction then.
#[test]
fn what_must_be_right_is_answered_anew_and_gives_no_third_star() {
    let mut screen = open(DESKTOP);
    let mission = begin(&mut screen, "wear-heard-and-seen");
    choose(&mut screen, "It gets quieter");
    click(&mut screen, SAY);
    for (param, value) in answer(&mission, "right").scenario.difference(&mission.scenario) {
        push(&mut screen, Command::set(&param.path, value));
    }
    check(&mut screen);
    assert!(texts(&screen).contains("Not passed yet"), "{}", texts(&screen));
    click(&mut screen, "Back");
    choose(&mut screen, "It gets louder");
    let note = "that counts for passing, not for the third star";
    assert!(texts(&screen).contains(note), "{}", texts(&screen));
    click(&mut screen, SAY);
    assert!(texts(&screen).contains("This is of before your last change"), "{}", texts(&screen));
    check(&mut screen);
    let said = texts(&screen);
    assert!(said.contains("Passed: 2 of 3 stars"), "{said}");
    assert!(said.contains("it came when the cut had been seen"), "{said}");
}

#[test]
fn nothing_of_the_cut_is_seen_or_cut_on_any_screen_before_it_is_predicted() {
    for size in SIZES {
        let mut screen = open(size);
        begin(&mut screen, MISSIONS[0].id);
        let stands = |screen: &Screen<'_>| {
            let playback = console(screen).session().playback();
            playback.playhead_s == 0.0 && !playback.playing
        };
        assert!(stands(&screen));
        for panel in panels() {
            push(&mut screen, Command::Shell(ShellCommand::ShowScreen(panel.id())));
            screen.run_steps(10);
            let said = texts(&screen);
            assert!(said.contains("Predict first"), "{}: {said}", panel.title());
            let shows = ["Ra in tolerance", "Ra now", "Roughness [", "Run the comparison"];
            assert!(!shows.iter().any(|word| said.contains(word)), "{}: {said}", panel.title());
            for pressed in [Key::Space, Key::End, Key::Home, Key::ArrowRight] {
                key(&mut screen, pressed);
            }
            push(&mut screen, Command::Playback(PlaybackCommand::SeekTo(9.0)));
            push(&mut screen, Command::Session(SessionCommand::CutAgain));
            assert!(stands(&screen), "{}", panel.title());
        }
        push(&mut screen, Command::File(FileCommand::ExportCsv));
        let told = console(&screen).messages().last().unwrap_or_default().to_owned();
        assert!(told.starts_with("Predict first: the cut begins"), "{told}");
        push(&mut screen, Command::Shell(ShellCommand::ShowScreen("learn")));
        choose(&mut screen, "It gets rougher");
        click(&mut screen, SAY);
        screen.run_steps(10);
        let playback = console(&screen).session().playback();
        let at_s = playback.playhead_s;
        assert!(playback.playing && 0.2 < at_s && at_s < 2.0, "from its start: {at_s} s");
        // What is left unpredicted goes on as well.
        click(&mut screen, "Leave");
        begin(&mut screen, MISSIONS[0].id);
        assert!(stands(&screen));
        click(&mut screen, "Leave");
        screen.run_steps(5);
        assert!(!stands(&screen));
    }
}

/// Questions that follow each other at once are asked before anything is seen; what is to be looked up is not hidden.
#[test]
fn questions_in_a_row_are_asked_before_the_cut() {
    let mut screen = open(DESKTOP);
    begin(&mut screen, "teach-in-feed-control");
    choose(&mut screen, "It watches: the feed stays, and an overload is told");
    click(&mut screen, SAY);
    assert!(texts(&screen).contains("Predict first"), "{}", texts(&screen));
    skip(&mut screen, Hand::Reader, SKIP);
    assert!(!texts(&screen).contains("Predict first"), "{}", texts(&screen));
    click(&mut screen, "Leave");
    begin(&mut screen, "read-the-errata");
    assert!(!texts(&screen).contains("Predict first"), "{}", texts(&screen));
    push(&mut screen, Command::Shell(ShellCommand::ShowScreen("papers")));
    assert!(texts(&screen).contains("as printed"), "{}", texts(&screen));
}

#[test]
fn a_number_that_is_not_said_is_no_zero_and_a_zero_that_is_typed_is_one() {
    let mut screen = open(DESKTOP);
    begin(&mut screen, "outside-its-range");
    let field = |screen: &Screen<'_>| {
        let field = screen.get_by_role_and_label(Role::SpinButton, "Your prediction");
        field.accesskit_node().value().unwrap_or_default()
    };
    assert_eq!(field(&screen), "", "what is seen there is a hint");
    let say = |screen: &Screen<'_>| {
        !screen.get_by_role_and_label(Role::Button, SAY).accesskit_node().is_disabled()
    };
    assert!(!say(&screen));
    tab_to(&mut screen, Role::SpinButton, "Your prediction");
    key(&mut screen, Key::Enter);
    assert!(!say(&screen), "{}", texts(&screen));
    assert!(console(&screen).messages().next().is_none(), "nothing was typed");
    tab_to(&mut screen, Role::SpinButton, "Your prediction");
    screen.event(egui::Event::Text("0".to_owned()));
    key(&mut screen, Key::Enter);
    assert!(field(&screen).starts_with('0'), "{}", field(&screen));
    assert!(say(&screen), "{}", texts(&screen));
}

/// Where the result stands is in sight of who has pressed, and what was pressed stays under the pointer.
#[test]
fn the_result_of_a_check_is_in_sight_and_moves_nothing_under_the_pointer() {
    for size in SIZES {
        for kind in ["wrong", "right"] {
            let mission = shipped::load(MISSIONS[0].id).unwrap();
            let mut given = answer(&mission, kind);
            given.edits = mission.edits.clone();
            let mut screen = open(size);
            click(&mut screen, &format!("Begin: {}", mission.title));
            choose(&mut screen, "It gets rougher");
            click(&mut screen, SAY);
            look_up(&mut screen);
            for (param, value) in given.scenario.difference(&mission.scenario) {
                push(&mut screen, Command::set(&param.path, value));
            }
            click(&mut screen, "Cut from the start");
            screen.run_steps(5);
            let rect = |screen: &Screen<'_>, role, name: &str| -> Rect {
                screen.get_by_role_and_label(role, name).rect()
            };
            let before = rect(&screen, Role::Button, CHECK);
            let window = screen.ctx.content_rect();
            assert!(window.contains_rect(before), "{size}: {before}");
            screen.get_by_role_and_label(Role::Button, CHECK).click();
            // In every frame from then on.
            for _ in 0..40 {
                screen.run_steps(1);
                assert_eq!(rect(&screen, Role::Button, CHECK), before, "{size} {kind}");
            }
            rest(&mut screen);
            let told = if kind == "right" { "Passed: 3 of 3 stars" } else { "Not passed yet" };
            let found = screen.get_by_label(told).rect();
            assert!(window.contains_rect(found), "{size}: {found}");
            assert!(found.bottom() < before.top(), "{size}: above what was pressed");
            assert_eq!(rect(&screen, Role::Button, CHECK), before, "{size} {kind}");
            // The charts are beside it; on a phone the first of them was in sight before.
            click(&mut screen, "Close the result");
            assert!(screen.query_by_label(told).is_none());
            let chart = screen.get_by_label_contains("Roughness from").rect();
            assert!(window.contains(chart.center()), "{size}: {chart}");
        }
    }
}

#[test]
fn a_result_says_when_it_is_of_before_a_change() {
    const OLD: &str = "This is of before your last change: check again.";
    for size in SIZES {
        let mut screen = open(size);
        let mission = shipped::load(MISSIONS[0].id).unwrap();
        give(&mut screen, Hand::Reader, &mission, &answer(&mission, "wrong"));
        assert!(!texts(&screen).contains(OLD), "{}", texts(&screen));
        push(&mut screen, Command::set("controller.kind", Value::Text("sdnrp".to_owned())));
        assert!(texts(&screen).contains(OLD), "{}", texts(&screen));
        check(&mut screen);
        assert!(!texts(&screen).contains(OLD), "{}", texts(&screen));
    }
}

#[test]
fn a_mission_shows_the_options_that_it_offers_and_refuses_others() {
    let mut screen = open(DESKTOP);
    begin(&mut screen, MISSIONS[0].id);
    skip(&mut screen, Hand::Reader, SKIP);
    skip(&mut screen, Hand::Reader, "Go on without an answer");
    screen.get_by_role_and_label(Role::ComboBox, "Controller").click();
    screen.run_steps(4);
    let said = texts(&screen);
    for (name, offered) in [("SDNRP", true), ("Tracking", true), ("MRAC", false), ("UNKS", false)] {
        assert_eq!(said.lines().any(|line| line == name), offered, "{name} in {said}");
    }
    key(&mut screen, Key::Escape);
    push(&mut screen, Command::set("controller.kind", Value::Text("mrac".to_owned())));
    let told = console(&screen).messages().last().unwrap_or_default().to_owned();
    assert!(told.contains("it offers: Conventional (constant feed), SDNRP, Tracking."), "{told}");
    assert_ne!(console(&screen).session().current().controller.kind.id(), "mrac");
    // Elsewhere, and once it is left, there are all.
    click(&mut screen, "Leave");
    push(&mut screen, Command::set("controller.kind", Value::Text("mrac".to_owned())));
    assert_eq!(console(&screen).session().current().controller.kind.id(), "mrac");
}

#[test]
fn space_presses_what_has_the_focus_and_plays_where_nothing_has() {
    let mut screen = open(DESKTOP);
    let mission = begin(&mut screen, MISSIONS[0].id);
    skip(&mut screen, Hand::Reader, SKIP);
    let playing = |screen: &Screen<'_>| console(screen).session().playback().playing;
    assert!(playing(&screen));
    key(&mut screen, Key::Space);
    assert!(!playing(&screen));
    tab_to(&mut screen, Role::Button, "Leave");
    key(&mut screen, Key::Space);
    screen.get_by_role_and_label(Role::Button, &format!("Begin: {}", mission.title));
    assert!(!playing(&screen), "it was pressed, and did nothing else");
}

/// Numbers keep to their units, and formulas are not broken within a term.
#[test]
fn no_line_of_a_mission_is_broken_between_a_number_and_its_unit() {
    let mut broken = Vec::new();
    let look = |screen: &Screen<'_>, broken: &mut Vec<String>| {
        crate::legible::each_text(screen, |text, _| {
            let words = &text.galley.job.text;
            // What is never broken, as the labels of an axis, may have any spaces.
            let breaks = text.galley.job.wrap.max_width.is_finite();
            if breaks && steadycut::app::format::typeset(words) != *words {
                broken.push(words.clone());
            }
        });
    };
    for size in SIZES {
        let mut screen = open(size);
        look(&screen, &mut broken);
        for id in MISSIONS.iter().map(|mission| mission.id) {
            let mission = shipped::load(id).unwrap();
            click(&mut screen, &format!("Begin: {}", mission.title));
            look(&screen, &mut broken);
            click(&mut screen, "Leave");
            give(&mut screen, Hand::Reader, &mission, &answer(&mission, "wrong"));
            look(&screen, &mut broken);
            click(&mut screen, "Leave");
        }
    }
    broken.sort();
    broken.dedup();
    assert!(broken.is_empty(), "{broken:#?}");
}

/// A file of one's own that hides nothing may have its first question later.
#[test]
fn a_template_is_predicted_in_a_row() {
    let mut screen = open(DESKTOP);
    let own = BroughtFile::Mission { name: "own.toml".to_owned(), text: TEMPLATE.to_owned() };
    push(&mut screen, Command::File(FileCommand::Bring(own)));
    for _ in 0..3 {
        assert!(texts(&screen).contains("Predict first"), "{}", texts(&screen));
        skip(&mut screen, Hand::Reader, SKIP);
    }
    assert!(!texts(&screen).contains("Predict first"), "{}", texts(&screen));
}

const KNOWN: &str = "You have seen this cut before";

/// Who leaves a mission whose cut was shown, and begins it again, knows the cut: another prediction is late, and in which
/// try it was is told.
#[test]
fn a_mission_that_is_begun_again_is_not_foreseen_anew() {
    let mission = shipped::load(MISSIONS[0].id).unwrap();
    let right = answer(&mission, "right");
    let mut wrong = right.clone();
    wrong.predictions.insert(1, Prediction::Choice(1));
    let mut screen = open(DESKTOP);
    give(&mut screen, Hand::Reader, &mission, &wrong);
    let said = texts(&screen);
    assert!(said.contains("Passed: 2 of 3 stars") && said.contains("begun 1, checked 1"), "{said}");
    click(&mut screen, "Leave");
    give(&mut screen, Hand::Reader, &mission, &right);
    let said = texts(&screen);
    assert!(said.contains("Passed: 2 of 3 stars") && said.contains("begun 2, checked 2"), "{said}");
    assert!(said.contains("it came when the cut had been seen"), "{said}");
    let tries = serde_json::from_str::<serde_json::Value>(&console(&screen).state_json()).unwrap();
    assert_eq!(tries["result"]["tries"], serde_json::json!({ "begun": 2, "checked": 2 }));
    // What was predicted in time the first time is foreseen still.
    let mut screen = open(DESKTOP);
    for _ in 0..2 {
        give(&mut screen, Hand::Reader, &mission, &right);
        assert!(texts(&screen).contains("Passed: 3 of 3 stars"), "{}", texts(&screen));
        click(&mut screen, "Leave");
    }
}

/// A mission that is left before its prediction lies open on every other screen.
#[test]
fn a_cut_that_was_to_be_seen_on_another_screen_is_known() {
    let mut screen = open(DESKTOP);
    begin(&mut screen, MISSIONS[0].id);
    click(&mut screen, "Leave");
    begin(&mut screen, MISSIONS[0].id);
    assert!(!texts(&screen).contains(KNOWN), "nothing was shown: {}", texts(&screen));
    click(&mut screen, "Leave");
    for shown in ["console", "learn"] {
        push(&mut screen, Command::Shell(ShellCommand::ShowScreen(shown)));
    }
    begin(&mut screen, MISSIONS[0].id);
    assert!(texts(&screen).contains(KNOWN), "{}", texts(&screen));
    // The same where it is left there.
    let mut screen = open(DESKTOP);
    begin(&mut screen, MISSIONS[0].id);
    push(&mut screen, Command::Shell(ShellCommand::ShowScreen("console")));
    click(&mut screen, "Leave the mission");
    push(&mut screen, Command::Shell(ShellCommand::ShowScreen("learn")));
    begin(&mut screen, MISSIONS[0].id);
    assert!(texts(&screen).contains(KNOWN), "{}", texts(&screen));
}

/// By how much a number is off gives the true one away: until a mission is passed it is too high or too low.
#[test]
fn the_true_number_is_told_once_a_mission_is_passed() {
    let mission = shipped::load("gain-leaves-an-error").unwrap();
    for (kind, number, told) in [
        ("wrong", 90.0, "too high; allowed is 20 % to either side"),
        ("wrong", 1.0, "too low; allowed is 20 % to either side"),
        ("right", 90.0, "too high; allowed is 20 % to either side; the true value is"),
        ("right", 9.5, "within 20 % of the true value; the true value is"),
    ] {
        let mut given = answer(&mission, kind);
        given.predictions.insert(2, Prediction::Number(number));
        let mut screen = open(DESKTOP);
        give(&mut screen, Hand::Reader, &mission, &given);
        let said = texts(&screen);
        assert!(said.contains(told), "{kind} {number}: {said}");
        assert_eq!(said.contains("the true value is"), kind == "right", "{said}");
    }
}

#[test]
fn what_is_being_typed_is_taken_by_the_first_press() {
    let mut screen = open(DESKTOP);
    begin(&mut screen, "outside-its-range");
    let say = |screen: &Screen<'_>| {
        !screen.get_by_role_and_label(Role::Button, SAY).accesskit_node().is_disabled()
    };
    tab_to(&mut screen, Role::SpinButton, "Your prediction");
    for (typed, is_number) in [("0", true), ("x", false)] {
        screen.event(egui::Event::Text(typed.to_owned()));
        screen.run_steps(3);
        assert_eq!(say(&screen), is_number, "{typed}");
    }
    key(&mut screen, Key::Backspace);
    screen.event(egui::Event::Text(",5".to_owned()));
    screen.run_steps(3);
    screen.get_by_role_and_label(Role::Button, SAY).click();
    screen.run_steps(4);
    assert!(texts(&screen).contains("Step 2 of"), "{}", texts(&screen));
    // A setting that is being typed is set before the answer is handed in.
    let mut screen = open(DESKTOP);
    begin(&mut screen, MISSIONS[0].id);
    choose(&mut screen, "It gets rougher");
    click(&mut screen, SAY);
    look_up(&mut screen);
    push(&mut screen, Command::Playback(PlaybackCommand::SeekToEnd));
    tab_to(&mut screen, Role::SpinButton, "Feed override");
    screen.key_press_modifiers(egui::Modifiers::COMMAND, Key::A);
    screen.run_steps(2);
    screen.event(egui::Event::Text("93".to_owned()));
    screen.run_steps(2);
    screen.get_by_role_and_label(Role::Button, CHECK).click();
    rest(&mut screen);
    screen.run_steps(4);
    let now = console(&screen).session().current().controller.constant_feed.feed_percent;
    let said = texts(&screen);
    assert_eq!(now, 93.0);
    assert!(said.contains("Not passed yet"), "{said}");
    assert!(!said.contains("This is of before your last change"), "{said}");
}

/// A finger that comes down twice leaves no question without an answer.
#[test]
fn a_question_is_left_by_two_presses_at_two_places() {
    let mut screen = open(PHONE);
    begin(&mut screen, MISSIONS[0].id);
    let place = screen.get_by_role_and_label(Role::Button, SKIP).rect();
    click(&mut screen, SKIP);
    assert!(texts(&screen).contains("there is no third star"), "{}", texts(&screen));
    assert_eq!(screen.get_by_role_and_label(Role::Button, SKIP).rect(), place);
    let sure = screen.get_by_role_and_label(Role::Button, "Go on all the same").rect();
    assert!(!sure.intersects(place), "{sure} {place}");
    click(&mut screen, SKIP);
    assert!(texts(&screen).contains("Step 1 of"), "it is asked still: {}", texts(&screen));
    assert!(!texts(&screen).contains("Go on all the same"), "{}", texts(&screen));
}

/// What leads on is in sight, and nothing that leads nowhere stands beside it.
#[test]
fn the_next_mission_is_in_sight_once_one_is_passed() {
    for size in SIZES {
        let mission = shipped::load(MISSIONS[0].id).unwrap();
        let mut screen = open(size);
        give(&mut screen, Hand::Reader, &mission, &answer(&mission, "right"));
        let next = shipped::load(MISSIONS[1].id).unwrap();
        let name = format!("Next mission: {}", next.title);
        let button = screen.get_by_role_and_label(Role::Button, &name).rect();
        let check = screen.get_by_role_and_label(Role::Button, CHECK).rect();
        assert!(screen.ctx.content_rect().contains_rect(button), "{size}: {button}");
        assert!(button.bottom() < check.top(), "{size}: {button} {check}");
        assert!(screen.query_by_role_and_label(Role::Button, "Next").is_none());
    }
}

#[test]
fn what_a_mission_locks_looks_locked_on_other_screens_and_a_phone_leaves_it_there() {
    let mut screen = open(DESKTOP);
    begin(&mut screen, MISSIONS[0].id);
    skip(&mut screen, Hand::Reader, SKIP);
    push(&mut screen, Command::Shell(ShellCommand::ShowScreen("console")));
    let disabled = |screen: &Screen<'_>, role, name: &str| {
        let mut all = screen.query_all_by_role(role).filter(|node| {
            node.accesskit_node().label().is_some_and(|label| label.starts_with(name))
        });
        all.next().unwrap_or_else(|| panic!("{name}")).accesskit_node().is_disabled()
    };
    assert!(disabled(&screen, Role::Button, "Drop "), "no disturbance is open");
    assert!(disabled(&screen, Role::SpinButton, "Target Ra"));
    assert!(!disabled(&screen, Role::ComboBox, "Controller"), "it is open");
    click(&mut screen, "Leave the mission");
    screen.run_steps(3);
    assert!(!disabled(&screen, Role::Button, "Drop "));
    assert!(!disabled(&screen, Role::SpinButton, "Target Ra"));
    let mut screen = open(PHONE);
    begin(&mut screen, MISSIONS[0].id);
    push(&mut screen, Command::Shell(ShellCommand::ShowScreen("console")));
    click(&mut screen, "Leave");
    assert!(console(&screen).session().mission().is_none());
}

#[test]
fn there_is_no_way_back_before_the_start() {
    let mut screen = open(DESKTOP);
    begin(&mut screen, MISSIONS[0].id);
    skip(&mut screen, Hand::Reader, SKIP);
    let back = |screen: &Screen<'_>| {
        let button = screen.get_by_role_and_label(Role::Button, "Back to before it went wrong");
        !button.accesskit_node().is_disabled()
    };
    push(&mut screen, Command::Playback(PlaybackCommand::SeekToEnd));
    rest(&mut screen);
    assert!(back(&screen), "the deeper stretch is scrap at constant feed");
    push(&mut screen, Command::Playback(PlaybackCommand::SeekTo(0.0)));
    assert!(!back(&screen));
}
