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
use steadycut::study::mission::{Mission, TEMPLATE};

use crate::learn::{Hand, answer, click, console, give, key, open, push, tab_to};
use crate::screen::{Screen, rest, texts};
use crate::views::{DESKTOP, PHONE};

const SIZES: [Vec2; 2] = [DESKTOP, PHONE];
const SAY: &str = "That is my prediction";
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
    click(&mut screen, "Go on without a prediction");
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
    assert_eq!(field(&screen), "\u{2013}");
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
    click(&mut screen, "Go on without a prediction");
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
    click(&mut screen, "Go on without a prediction");
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
        click(&mut screen, "Go on without a prediction");
    }
    assert!(!texts(&screen).contains("Predict first"), "{}", texts(&screen));
}
