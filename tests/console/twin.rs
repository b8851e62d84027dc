//! The constant feed that stands beside the cut: which one it is, that it is said everywhere, and what it costs.

use egui::accesskit::Role;
use egui::{Vec2, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use steadycut::app::command::{PlaybackCommand, SessionCommand};
use steadycut::app::session::{Session, TwinStand};
use steadycut::base::settings::Value;
use steadycut::run::edits::Edits;
use steadycut::run::{presets, scenario_link};

use crate::screen::{self, Screen, texts};

const SIZES: [Vec2; 2] = [vec2(1280.0, 800.0), vec2(390.0, 844.0)];

fn session<'a>(screen: &'a Screen<'_>) -> &'a Session {
    screen.state().as_ref().expect("made in the first frame").session()
}

fn found(screen: &mut Screen<'_>) {
    let found = screen::in_time(|| {
        screen.run_steps(1);
        session(screen).progress() >= 1.0
    });
    assert!(found, "{}", texts(screen));
    screen.run_steps(8);
}

/// A session without a window, simulated and its twin found.
fn settled(preset: &str, sets: &[(&str, Value)]) -> Session {
    let mut scenario = presets::load(preset).unwrap();
    for (path, value) in sets {
        scenario.set(path, value.clone()).unwrap();
    }
    let mut session = Session::new(scenario, Edits::none());
    to_rest(&mut session);
    session
}

fn to_rest(session: &mut Session) {
    let rested = screen::in_time(|| {
        session.advance(0.02);
        session.progress() >= 1.0
    });
    assert!(rested, "{:?}", session.twin_stand());
}

fn set(session: &mut Session, path: &str, value: Value) {
    session.execute(SessionCommand::Set { path: path.to_owned(), value });
}

/// What does control buy on the first screen? The step is there, and the time against the safe feed, with its numbers.
#[test]
fn the_first_screen_says_what_control_buys_against_which_feed() {
    for size in SIZES {
        let first = presets::PRESETS[0].name;
        let mut screen = screen::open(first, size, "Console", &[]);
        found(&mut screen);
        screen.get_by_role_and_label(Role::Button, "End").click_accesskit();
        screen.run_steps(8);
        let shown = texts(&screen);
        let TwinStand::Safe(safe) = session(&screen).twin_stand().clone() else {
            panic!("{shown}")
        };
        let title = format!(
            "safe constant feed: {:.0} mm/min at {:.0} 1/min",
            safe.feed_mm_min, safe.spindle_rpm
        );
        assert!(shown.contains(&title), "{title} in {shown}");
        let comparison = session(&screen).comparison();
        // In what they are equal is said with its figure.
        let above = [&comparison.chosen, &comparison.twin].map(|of| of.above_tolerance_percent);
        let most = above.map(Option::unwrap).into_iter().fold(0.0, f64::max);
        let equal = match format!("{most:.1}").as_str() {
            "0.0" => " %, neither is scrap".to_owned(),
            most => format!(" %, \u{2264} {most} % is scrap"),
        };
        let saved = shown.lines().find(|line| line.ends_with(&equal));
        let saved = saved.unwrap_or_else(|| panic!("{equal} in {shown}"));
        let percent: f64 = saved.split(' ').nth(1).unwrap().parse().unwrap();
        let truly = 100.0 * comparison.time_saved_s / comparison.twin.time_of_cut_s;
        assert!((percent - truly).abs() <= 0.5 && percent >= 10.0, "{saved}: {truly}");
        assert_eq!(comparison.twin.above_tolerance_percent, Some(0.0));
        // What lies outside its tolerance on the smooth side alone reads so beside that.
        let inside = comparison.twin.in_tolerance_percent.unwrap();
        let name = if size.x > 500.0 { "safe feed" } else { "safe" };
        let told = format!("{name} {inside:.1} %, rest smoother");
        assert!(inside < 99.0 && shown.contains(&told), "{told} in {shown}");
    }
}

/// Until it is found nothing is told of it, and nothing moves when it is.
#[test]
fn while_it_is_found_that_is_said_and_nothing_jumps() {
    for size in SIZES {
        let mut screen = screen::open("first-cut", size, "Console", &[]);
        let playhead =
            |screen: &Screen<'_>| screen.get_by_role_and_label(Role::Slider, "Playhead").rect();
        let plot = |screen: &Screen<'_>| {
            let figures = screen.root().children_recursive().filter(|node| {
                let node = node.accesskit_node();
                node.label().is_some_and(|label| label.starts_with("Roughness from"))
            });
            figures.map(|node| node.rect()).next()
        };
        let places = |screen: &Screen<'_>| (playhead(screen), plot(screen).map(|rect| rect.top()));
        let finding = |screen: &Screen<'_>| texts(screen).contains("finding \u{2026}");
        // From the first frames on, found or not yet.
        let begun = places(&screen);
        found(&mut screen);
        assert!(!finding(&screen), "{}", texts(&screen));
        assert_eq!(begun, places(&screen));
        // A drag of the target waits until it pauses.
        screen.get_by_role_and_label(Role::Slider, "Target Ra").set_value_accesskit(0.9);
        screen.run_steps(2);
        assert!(!session(&screen).twin_stand().is_settled());
        assert!(finding(&screen), "{}", texts(&screen));
        assert_eq!(begun, places(&screen));
        found(&mut screen);
        assert!(!finding(&screen), "{}", texts(&screen));
        assert_eq!(begun, places(&screen));
    }
}

/// What is the safe feed once the cut was changed under way? One from the start on, found for the whole part: it is called
/// so, and is not before.
#[test]
fn a_safe_feed_that_a_later_change_asks_for_is_said_to_hold_from_the_start() {
    let mut session = settled("depth-step", &[]);
    let before = session.twin_title();
    assert!(before.starts_with("safe constant feed: "), "{before}");
    session.play(PlaybackCommand::SeekTo(3.0));
    set(&mut session, "target.ra_um", Value::Float(0.7));
    to_rest(&mut session);
    let now = session.twin_title();
    assert!(now.starts_with("safe feed from start: "), "{now}");
    session.execute(SessionCommand::Undo);
    to_rest(&mut session);
    assert_eq!(session.twin_title(), before);
}

/// A drag of the target keeps the feed of before until it pauses; the way back finds its own at once.
#[test]
fn a_drag_waits_and_a_way_back_is_known() {
    let mut session = settled("depth-step", &[]);
    let TwinStand::Safe(first) = session.twin_stand().clone() else { panic!("found") };
    for target in [0.78, 0.74, 0.7] {
        set(&mut session, "target.ra_um", Value::Float(target));
        session.advance(0.02);
        assert_eq!(session.twin_stand(), &TwinStand::Finding(Some(first)));
    }
    to_rest(&mut session);
    let TwinStand::Safe(finer) = session.twin_stand().clone() else { panic!("found") };
    assert!(finer.feed_mm_min < first.feed_mm_min, "{finer:?} {first:?}");
    let set_up = session.scenario().target.ra_um;
    session.execute(SessionCommand::Undo);
    to_rest(&mut session);
    assert_eq!(session.twin_stand(), &TwinStand::Safe(first), "from {set_up}");
    // Another controller cuts the same part: nothing is searched for.
    let sdnrp = Value::Text("sdnrp".to_owned());
    session.execute(SessionCommand::SetUp(vec![("controller.kind".to_owned(), sdnrp)]));
    assert_eq!(session.twin_stand(), &TwinStand::Safe(first));
}

/// Where none is safe that is said in words, and the programmed one stands there under its own name.
#[test]
fn where_none_is_safe_the_programmed_one_says_so() {
    let deep = [("workpiece.axial_depth_mm", Value::Float(4.0))];
    for size in SIZES {
        let mut screen = screen::open("table3-5", size, "Console", &deep);
        found(&mut screen);
        let TwinStand::NoneSafe(why) = session(&screen).twin_stand() else { panic!("none is") };
        assert!(why.contains("no constant feed is safe"), "{why}");
        let shown = texts(&screen);
        // In fewer words where those have no room: the legend stays one line.
        let said = match size.x < 900.0 {
            true => "constant feed, none is safe: 430 mm/min",
            false => "none is safe; constant feed as programmed: 430 mm/min",
        };
        assert!(shown.contains(said), "{shown}");
        assert!(screen.get_by_label_contains(said).rect().height() < 20.0);
    }
}

/// The choice is a setting: it is in the link, it is undone, and a mission keeps its own.
#[test]
fn the_choice_survives_in_the_link() {
    let mut session = settled("first-cut", &[]);
    set(&mut session, "twin.kind", Value::Text("programmed".to_owned()));
    assert_eq!(session.twin_stand(), &TwinStand::Programmed);
    assert!(session.ghost().is_none(), "the cut is as it was");
    let link = scenario_link::write(session.scenario(), session.edits());
    let (scenario, edits) = scenario_link::parse(&link).unwrap();
    let mut again = Session::new(scenario, edits);
    to_rest(&mut again);
    assert_eq!(again.twin_stand(), &TwinStand::Programmed);
    let title = again.twin_title().replace('\u{a0}', " ");
    assert!(title.starts_with("constant feed as programmed: 430 mm/min"), "{title}");
    session.execute(SessionCommand::Undo);
    assert!(matches!(session.twin_stand(), TwinStand::Safe(_)));
}
