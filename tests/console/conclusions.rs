//! What would a trainer tell the class after seeing this, and is it true? A question a test.

use egui::accesskit::Role;
use egui::{Vec2, vec2};
use egui_kittest::kittest::Queryable as _;
use steadycut::app::session::Session;
use steadycut::base::settings::Value;
use steadycut::run::signals::signal;
use steadycut::run::story::EventKind;

use crate::screen::{self, Screen, texts};

const DESKTOP: Vec2 = vec2(1280.0, 800.0);
const PHONE: Vec2 = vec2(390.0, 844.0);

fn session<'a>(screen: &'a Screen<'_>) -> &'a Session {
    screen.state().as_ref().expect("made in the first frame").session()
}

fn press(screen: &mut Screen<'_>, name: &str) {
    screen.get_by_role_and_label(Role::Button, name).click_accesskit();
    screen.run_steps(2);
}

/// A console on a preset, at the end of its cut.
fn ended<'a>(preset: &str, changes: &[(&str, Value)]) -> Screen<'a> {
    to_its_end(screen::open(preset, DESKTOP, "Console", changes))
}

fn to_its_end(mut screen: Screen<'_>) -> Screen<'_> {
    for _ in 0..100 {
        screen.run_steps(1);
        if session(&screen).progress() >= 1.0 {
            break;
        }
    }
    press(&mut screen, "End");
    screen.run_steps(8);
    screen
}

fn seek(screen: &mut Screen<'_>, time_s: f64) {
    if session(screen).playback().playing {
        press(screen, "Pause");
    }
    screen.get_by_role_and_label(Role::Slider, "Playhead").set_value_accesskit(time_s);
    screen.run_steps(8);
}

fn kp_and_dead_time(kp: f64, dead_time_s: f64) -> [(&'static str, Value); 3] {
    [
        ("controller.sdnrp.kp", Value::Float(kp)),
        ("cnc.dead_time_s", Value::Float(dead_time_s)),
        ("workpiece.depth_steps", Value::List(Vec::new())),
    ]
}

/// Did this cut chatter? It did, at 2 mm, though at its end it is 1.2 mm deep and quiet.
#[test]
fn a_cut_that_chattered_is_not_called_stable_at_its_end() {
    let mut screen = ended("chatter", &[]);
    // The story leads there.
    press(&mut screen, "Stability and sound");
    for _ in 0..400 {
        screen.run_steps(1);
        if texts(&screen).contains("Chatter at") {
            break;
        }
    }
    let shown = texts(&screen);
    assert!(shown.contains("Chatter at 1800 1/min and 2.00 mm deep, from 35.0"), "{shown}");
    assert!(shown.contains("At the playhead, 1800 1/min and 1.20 mm deep: no chatter"), "{shown}");
    assert!(!shown.contains("Stable at 1800"), "{shown}");
}

/// What is Ra to be? What the field says, also while the cut stands still.
#[test]
fn the_target_beside_ra_is_that_of_its_field() {
    let mut screen = screen::open("first-cut", DESKTOP, "Console", &[]);
    screen.run_steps(40);
    press(&mut screen, "Pause");
    screen.get_by_role_and_label(Role::Slider, "Target Ra").set_value_accesskit(0.6);
    screen.run_steps(8);
    let shown = texts(&screen);
    let target = session(&screen).current().target.ra_um;
    assert!(shown.contains(&format!("target {target:.3} µm")), "{shown}");
    assert!(!shown.contains("target 0.810 µm"), "{shown}");
}

/// Is the surface good? One answer: the remaining error has a name, a sign and a verdict in words.
#[test]
fn an_error_that_remains_is_named_with_its_sign_and_judged_once() {
    for (target, word) in [(0.5, "outside"), (0.81, "within")] {
        let mut sets = kp_and_dead_time(0.5, 0.08).to_vec();
        sets.push(("target.ra_um", Value::Float(target)));
        let screen = ended("first-cut", &sets);
        let (_, response) = session(&screen).story().response_at(1e9).unwrap();
        let error = response.remaining_error_percent.unwrap();
        let shown = texts(&screen);
        assert!(shown.contains(&format!("{error:+.1} % {word}")), "{error} in {shown}");
        assert!(shown.contains("Remaining error"), "{shown}");
        assert!(shown.contains("overshoot") || shown.contains("swings by ±"), "{shown}");
        assert!(shown.contains("settles in"), "{shown}");
        // And Ra says in a word where it lies.
        let side = if word == "within" { "within target" } else { "above target" };
        assert!(shown.contains(side), "{shown}");
    }
}

/// Is the loop stable? With Kp 4 and a dead time of 0.3 s it is not, and says so; with Kp 0.5 it is.
#[test]
fn a_limit_cycle_is_called_unstable() {
    let shown = texts(&ended("first-cut", &kp_and_dead_time(4.0, 0.3)));
    assert!(shown.contains("unstable") && shown.contains("limit cycle"), "{shown}");
    let shown = texts(&ended("first-cut", &kp_and_dead_time(0.5, 0.08)));
    assert!(!shown.to_lowercase().contains("unstable"), "{shown}");
}

/// Was it a good cut? It swung for a quarter of a minute: its calm end is no tick for it.
#[test]
fn a_cut_that_swung_says_from_when_to_when_and_gets_no_tick() {
    for size in [DESKTOP, PHONE] {
        let tuned = [(3.0, 4.0), (20.0, 0.5)];
        let later = tuned.map(|(at_s, kp)| (at_s, "controller.sdnrp.kp", Value::Float(kp)));
        let sets = [
            ("cnc.dead_time_s", Value::Float(0.2)),
            ("workpiece.depth_steps", Value::List(Vec::new())),
        ];
        let screen = screen::edited("first-cut", size, "Console", &sets, &later);
        let screen = to_its_end(screen);
        let (_, last) = session(&screen).story().response_at(1e9).unwrap();
        let error = last.remaining_error_percent.unwrap();
        assert!(error.abs() < 10.0, "the end itself is calm: {last:?}");
        let shown = texts(&screen);
        let was = if size == PHONE { "unstable\n" } else { "unstable 3.6 to 20.0 s" };
        assert!(shown.contains(was) && shown.contains("3.6 to 20.0 s\n"), "{shown}");
        assert!(
            shown.contains("It was unstable from 3.5") && shown.contains(" to 20.0"),
            "{shown}"
        );
        let told = format!("{error:+.1} %");
        let verdict = shown.lines().find(|line| line.starts_with(&told)).unwrap();
        assert!(verdict.ends_with("to be looked at"), "{verdict}");
        assert!(shown.contains("Cut finished, not steady"), "{shown}");
        // Nor does the surface get one where it swings through its target.
        let mut screen = screen;
        let mut within = 0;
        for step in 0..12 {
            seek(&mut screen, 15.0 + 0.05 * f64::from(step));
            let row = *session(&screen).row();
            let is_within = (row.ra_um / row.ra_target_um - 1.0).abs() < 0.1;
            within += u32::from(is_within);
            let shown = texts(&screen);
            let good = |line: &str| line.ends_with(" µm as it should be");
            assert!(!is_within || !shown.lines().any(good), "{shown}");
        }
        assert!(within > 0, "it swings through its target");
    }
}

/// What did the step do to the loop? Nothing beyond the noise: then no time and no overshoot are told.
#[test]
fn a_change_without_transient_is_called_so() {
    let sets = [("controller.kind", Value::Text("constant_feed".into()))];
    let shown = texts(&ended("first-cut", &sets));
    assert!(shown.contains("settles at once (±2.0 %)"), "{shown}");
    assert!(shown.contains("no transient"), "{shown}");
    assert!(!shown.contains("0.00 s (") && !shown.contains("overshoot"), "{shown}");
}

/// Is the chattering cut's surface within its tolerance? The model cannot tell, and nothing else is told.
#[test]
fn what_the_model_cannot_judge_is_not_judged_and_not_drawn() {
    let screen = ended("chatter", &[]);
    let shown = texts(&screen);
    assert!(shown.contains("not judged") && shown.contains("\noutside the model"), "{shown}");
    assert!(shown.contains("chattered 3.7 to 7.3 s"), "{shown}");
    assert!(!shown.contains("not at rest"), "{shown}");
    assert!(shown.contains("It chattered from 3."), "{shown}");
    let metrics = &session(&screen).comparison().chosen;
    let unknown = metrics.not_judged_percent.unwrap();
    assert!((30.0..95.0).contains(&unknown), "{unknown}");
    assert!(shown.contains(&format!("{unknown:.1} % outside the model")), "{shown}");
    // Nor is Ra with dynamics drawn there: what vibration adds would stand alone.
    assert!(shown.contains("Ra at the playhead: outside model"), "{shown}");
    let rows = session(&screen).chosen().run().recording().rows();
    let dynamic = signal("ra_dyn_um").unwrap();
    let ended = rows.iter().filter(|row| row.ra_has_ended());
    assert!(ended.map(|row| (dynamic.value)(row)).all(|value| value.is_none()));
}

/// What does the step in depth do? It comes within the first ten seconds, and the line says it.
#[test]
fn the_first_scenario_says_what_its_step_does_within_ten_seconds() {
    for size in [DESKTOP, PHONE] {
        let mut screen = screen::open("first-cut", size, "Console", &[]);
        screen.run_steps(20);
        let steps = session(&screen).story().events.iter();
        let step = steps.clone().find(|event| event.id == EventKind::DepthStep).unwrap().clone();
        assert!(step.from_s < 10.0, "{step:?}");
        for words in ["gets 0.20 mm deeper here", "constant feed", "the controller lowers the feed"]
        {
            assert!(step.sentence.contains(words), "{words} in {}", step.sentence);
        }
        seek(&mut screen, step.from_s - 0.1);
        assert!(!texts(&screen).contains(&step.sentence));
        seek(&mut screen, step.from_s + 0.1);
        assert!(texts(&screen).contains(&step.sentence), "{}", texts(&screen));
        // Each event is a way to its moment.
        seek(&mut screen, 0.0);
        let name = format!("{:.2} s Depth step", step.from_s);
        press(&mut screen, &name);
        let playhead_s = session(&screen).playback().playhead_s;
        assert!((playhead_s - step.from_s).abs() < 1e-9, "{playhead_s}");
    }
}

/// Does constant feed win? A time outside the tolerance is no victory, for neither of them.
#[test]
fn a_time_is_compared_only_where_the_tolerance_is_held() {
    let screen = ended("first-cut", &[]);
    let comparison = session(&screen).comparison();
    assert!(comparison.twin.in_tolerance_percent.unwrap() < 90.0);
    let shown = texts(&screen);
    assert!(shown.contains("not compared: "), "{shown}");
    assert!(!shown.contains("than constant feed"), "{shown}");
    // Both hold it: then the time counts.
    let held = [
        ("target.ra_um", Value::Float(1.31)),
        ("target.tolerance_percent", Value::Float(50.0)),
        ("workpiece.depth_steps", Value::List(Vec::new())),
    ];
    let screen = ended("first-cut", &held);
    let shown = texts(&screen);
    assert!(
        shown.contains("than constant feed") || shown.contains("as long as constant feed"),
        "{shown}"
    );
}

/// Does the plan make the cut better? SDNRP sets feed and speed by its own models: its cut stays as it
/// was, and no score may say otherwise.
#[test]
fn the_plan_s_values_make_no_score_better_that_the_cut_did_not() {
    let flat = ("workpiece.depth_steps", Value::List(Vec::new()));
    let planned = [
        ("program.feed_mm_min", Value::Float(156.0)),
        ("program.spindle_rpm", Value::Float(2206.0)),
        flat.clone(),
    ];
    let [before, after] = [vec![flat], planned.to_vec()].map(|sets| {
        let screen = ended("first-cut", &sets);
        let comparison = session(&screen).comparison();
        let twin_holds = comparison.twin.in_tolerance_percent.unwrap() >= 90.0;
        (comparison.chosen.time_of_cut_s, twin_holds, texts(&screen))
    });
    assert!((before.0 / after.0 - 1.0).abs() < 0.02, "{} and {} s", before.0, after.0);
    for (_, twin_holds, shown) in [before, after] {
        assert_eq!(
            shown.contains("% shorter than constant feed"),
            twin_holds && shown.contains("saved")
        );
    }
}

/// How good was constant feed there? Its line stands at the same place of the part as the cut's, and says so.
#[test]
fn the_line_of_constant_feed_goes_by_place_and_says_so() {
    let mut screen = screen::open("first-cut", DESKTOP, "Console", &[]);
    screen.run_steps(20);
    let entry = screen.get_all_by_role_and_label(Role::CheckBox, "constant feed").last();
    entry.unwrap().hover();
    screen.run_steps(30);
    let shown = texts(&screen);
    assert!(shown.contains("drawn at the same place of the part"), "{shown}");
}
