//! What would a trainer tell the class after seeing this, and is it true? A question a test.

use egui::accesskit::Role;
use egui::{Vec2, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use steadycut::app::command::{Command, PlaybackCommand};
use steadycut::app::playback::Speed;
use steadycut::app::session::Session;
use steadycut::app::widgets::chart::Axes;
use steadycut::base::settings::Value;
use steadycut::run::signals::{flag, signal};
use steadycut::run::story::EventKind;
use steadycut::run::{presets, scenario_file};

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

/// Frames until both runs are simulated, and the safe feed is found.
fn twin_found(screen: &mut Screen<'_>) {
    let found = screen::in_time(|| {
        screen.run_steps(1);
        session(screen).progress() >= 1.0
    });
    assert!(found, "{}", texts(screen));
    screen.run_steps(8);
}

/// A console on a preset, at the end of its cut.
fn ended<'a>(preset: &str, changes: &[(&str, Value)]) -> Screen<'a> {
    to_its_end(screen::open(preset, DESKTOP, "Console", changes))
}

fn to_its_end(mut screen: Screen<'_>) -> Screen<'_> {
    twin_found(&mut screen);
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
    crate::screen::in_time(|| {
        screen.run_steps(1);
        texts(&screen).contains("Chatter at")
    });
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
        let settles = response.settling_time_s.is_some();
        let said = if settles { "settles in" } else { "does not settle" };
        assert!(shown.contains(said), "{said} in {shown}");
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
        let held = ["Cut finished, ", "\nheld, ", "\nnot held, "];
        assert!(held.iter().any(|told| shown.contains(told)), "{shown}");
        assert!(shown.contains(", unstable"), "{shown}");
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
    assert!(shown.contains("not judged") && shown.contains("\nRa outside its model"), "{shown}");
    let chattered = session(&screen).story().stretches_until(EventKind::Chatter, 1e9);
    let [from_s, to_s] = chattered[chattered.len() - 1];
    assert!((3.4..3.8).contains(&from_s) && (6.9..7.4).contains(&to_s), "{chattered:?}");
    assert!(shown.contains(&format!("chattered {from_s:.1} to {to_s:.1} s")), "{shown}");
    assert!(!shown.contains("not at rest"), "{shown}");
    assert!(shown.contains("It chattered from 3."), "{shown}");
    let metrics = &session(&screen).comparison().chosen;
    let unknown = metrics.not_judged_percent.unwrap();
    assert!((30.0..95.0).contains(&unknown), "{unknown}");
    // By the name that the band below has for it.
    assert!(shown.contains(&format!("{unknown:.1} % outside the Ra model (K5)")), "{shown}");
    assert!(shown.contains("Outside model: ") && shown.contains("Ra (K5)"), "{shown}");
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
        twin_found(&mut screen);
        let steps = session(&screen).whole_story().events.iter();
        let step = steps.clone().find(|event| event.id == EventKind::DepthStep).unwrap().clone();
        assert!(step.from_s < 10.0, "{step:?}");
        for words in
            ["gets 0.20 mm deeper here", "safe constant feed", "the controller lowers the feed"]
        {
            assert!(step.sentence.contains(words), "{words} in {}", step.sentence);
        }
        seek(&mut screen, step.from_s - 0.1);
        assert!(!texts(&screen).contains("gets 0.20 mm deeper here"));
        seek(&mut screen, step.from_s + 0.1);
        assert!(texts(&screen).contains("gets 0.20 mm deeper here"), "{}", texts(&screen));
        seek(&mut screen, step.from_s + 4.0);
        assert!(texts(&screen).contains("the controller lowers the feed"), "{}", texts(&screen));
        // Each event is a way to its moment.
        seek(&mut screen, 0.0);
        let name = format!("{:.2} s Depth step", step.from_s);
        press(&mut screen, &name);
        let playhead_s = session(&screen).playback().playhead_s;
        assert!((playhead_s - step.from_s).abs() < 1e-9, "{playhead_s}");
    }
}

/// Does control win? A time is told as bought only where neither cut is scrap, and against whom is said.
#[test]
fn a_time_is_compared_only_where_neither_cut_is_scrap() {
    // SDNRP lets Ra drift in the deeper stretch; the safe feed is nowhere above the tolerance.
    let screen = ended("first-cut", &[]);
    let comparison = session(&screen).comparison();
    assert_eq!(comparison.twin.above_tolerance_percent, Some(0.0));
    assert!(comparison.chosen.above_tolerance_percent.unwrap() > 10.0);
    let shown = texts(&screen);
    // By the share that is too rough, and not in a word that the card of the tolerance uses in another sense.
    let over = comparison.chosen.above_tolerance_percent.unwrap();
    assert!(shown.contains(&format!("\nthis cut: {over:.1} % scrap")), "{shown}");
    assert!(!shown.contains("is scrap") && !shown.contains("holds Ra"), "{shown}");
    // As programmed it is too rough, too.
    let programmed = ("twin.kind", Value::Text("programmed".into()));
    let screen = ended("first-cut", std::slice::from_ref(&programmed));
    let compared = session(&screen).comparison();
    let [own, over] =
        [&compared.chosen, &compared.twin].map(|of| of.above_tolerance_percent.unwrap());
    let shown = texts(&screen);
    assert!(shown.contains(&format!("\nboth scrap: {own:.1} and {over:.1} %")), "{shown}");
    // Both hold it: then the time counts.
    for kind in ["safe", "programmed"] {
        let held = [
            ("target.ra_um", Value::Float(1.31)),
            ("target.tolerance_percent", Value::Float(50.0)),
            ("workpiece.depth_steps", Value::List(Vec::new())),
            ("twin.kind", Value::Text(kind.into())),
        ];
        let screen = ended("first-cut", &held);
        let compared = session(&screen).comparison();
        let above = [&compared.chosen, &compared.twin].map(|of| of.above_tolerance_percent);
        let most = above.map(Option::unwrap).into_iter().fold(0.0, f64::max);
        let equal = match format!("{most:.1}").as_str() {
            "0.0" => "neither is scrap".to_owned(),
            most => format!("\u{2264} {most} % is scrap"),
        };
        let shown = texts(&screen);
        assert!(shown.contains(&equal), "{equal} in {shown}");
    }
}

/// Does the plan make the cut better? SDNRP sets feed and speed by its own models: its cut stays as it
/// was, and no score may say otherwise.
#[test]
fn the_plan_s_values_make_no_score_better_that_the_cut_did_not() {
    let flat = ("workpiece.depth_steps", Value::List(Vec::new()));
    let programmed = ("twin.kind", Value::Text("programmed".into()));
    let planned = [
        ("program.feed_mm_min", Value::Float(156.0)),
        ("program.spindle_rpm", Value::Float(2206.0)),
        flat.clone(),
        programmed.clone(),
    ];
    let [before, after] = [vec![flat, programmed], planned.to_vec()].map(|sets| {
        let screen = ended("first-cut", &sets);
        let comparison = session(&screen).comparison();
        let twin_holds = comparison.twin.not_above() == Some(true);
        (comparison.chosen.time_of_cut_s, twin_holds, texts(&screen))
    });
    assert!((before.0 / after.0 - 1.0).abs() < 0.02, "{} and {} s", before.0, after.0);
    for (_, twin_holds, shown) in [before, after] {
        assert_eq!(shown.contains("is scrap"), twin_holds && shown.contains("saves"));
    }
}

/// Does the tile say what the curve says? Where the machine vibrates in the cut there are two curves of each, and the
/// tile names its own and tells the other.
#[test]
fn a_tile_names_which_of_two_curves_it_is_of_and_tells_the_other() {
    for (preset, is_shaken) in [("chatter", true), ("first-cut", false)] {
        for size in [DESKTOP, PHONE] {
            let mut screen = screen::open(preset, size, "Console", &[]);
            screen.run_steps(20);
            seek(&mut screen, 5.0);
            let shown = texts(&screen);
            let row = session(&screen).row();
            let value = signal("ra_dyn_um").and_then(|signal| (signal.value)(row));
            // A value outside its model's range has a mark.
            let told = |value: Option<f64>, models: u32| match value {
                Some(um) if row.has(models) => format!("\u{2248} {um:.3} µm"),
                Some(um) => format!("{um:.3} µm"),
                None => "outside model".to_owned(),
            };
            let with = told(value, flag::K5_OUTSIDE | flag::K6_OUTSIDE);
            let without = told((!row.ra_has_ended()).then_some(row.ra_um), flag::K5_OUTSIDE);
            let has = |line: &str| shown.contains(line);
            assert_eq!(has("Ra now\n"), !is_shaken, "{shown}");
            assert_eq!(has("With dynamics in tolerance\n"), is_shaken, "{shown}");
            // Where a part is not judged that is said in its place.
            let or_unknown = has("without dynamics ") || has("the Ra model (") || has("% no Ra (");
            assert!(if is_shaken { or_unknown } else { !has("without dynamics ") }, "{shown}");
            if is_shaken {
                assert!(has(&with) && has(&format!("without {without}")), "{without} in {shown}");
            }
        }
    }
    // Nor is anything good where vibration takes Ra out of the tolerance, in tiles, sentences and the end.
    let flat = [
        ("workpiece.depth_steps", Value::List(Vec::new())),
        ("workpiece.axial_depth_mm", Value::Float(1.6)),
    ];
    let ra_um = session(&ended("chatter", &flat)).row().ra_um;
    let target = [flat[0].clone(), flat[1].clone(), ("target.ra_um", Value::Float(ra_um))];
    for size in [DESKTOP, PHONE] {
        let screen = to_its_end(screen::open("chatter", size, "Console", &target));
        let row = session(&screen).row();
        let off = |ra_um: f64| (ra_um / row.ra_target_um - 1.0).abs();
        assert!(off(row.ra_um) < 0.1 && off(row.ra_dyn_um) > 0.1, "{row:?}");
        let metrics = session(&screen).chosen().run().metrics();
        let (with, without) =
            (metrics.in_tolerance_dyn_percent.unwrap(), metrics.in_tolerance_percent.unwrap());
        assert!(with < 20.0 && without > 99.0, "{with} {without}");
        let shown = texts(&screen);
        for told in [
            format!("{:.3} µm not as it should be", row.ra_dyn_um),
            format!("{with:.1} % not as it should be"),
            format!("without dynamics {without:.1} %"),
        ] {
            assert!(shown.contains(&told), "{told} in {shown}");
        }
        assert!(size == PHONE || shown.contains("with dynamics +"), "{shown}");
        let mut events = session(&screen).story().events.iter();
        let chatter = events.find(|event| event.id == EventKind::Chatter).expect("it is told");
        assert!(chatter.sentence.contains("Chatter at"), "{}", chatter.sentence);
        assert!(!shown.contains("target held") && !shown.contains("Cut finished, held"), "{shown}");
        assert!(!shown.contains("within the tolerance"), "{shown}");
    }
}

/// Does it settle? A loop that swings is not said to, and the band that it is judged by says where it comes from.
#[test]
fn a_loop_that_swings_is_not_said_to_settle_and_the_band_is_explained() {
    for (kp, noise, settles) in [(2.5, 0.5, false), (0.5, 0.0, true)] {
        for size in [DESKTOP, PHONE] {
            let sets =
                [("controller.sdnrp.kp", Value::Float(kp)), ("noise.level", Value::Float(noise))];
            let mut screen = to_its_end(screen::open("first-cut", size, "Console", &sets));
            let (_, response) = session(&screen).story().response_at(1e9).unwrap();
            let (band, swing) =
                (response.settling_band_percent.unwrap(), response.swing_percent.unwrap());
            assert_eq!(swing <= band, settles, "{response:?}");
            let shown = texts(&screen);
            let wide = size == DESKTOP;
            let settled = if wide { "settles in" } else { "force rests" };
            assert_eq!(shown.contains(settled), settles, "{shown}");
            assert!(settles || !shown.contains("settles at once"), "{shown}");
            if !settles {
                let told =
                    if wide { format!("swings by ±{swing:.1} %") } else { "no rest".into() };
                assert!(shown.contains(&told), "{told} in {shown}");
            }
            if wide {
                screen.get_by_label("Remaining error").hover();
                screen.run_steps(30);
                let shown = texts(&screen);
                let noise = band - 2.0;
                let why = match settles {
                    true => "since no noise moves the force at rest".to_owned(),
                    false => format!("and {noise:.1} % for what noise still moves the force by"),
                };
                for told in [format!("The band is ±{band:.1} % here"), why] {
                    assert!(shown.contains(&told), "{told} in {shown}");
                }
            }
        }
    }
}

/// What did I just do? After the end of the cut a changed depth is that of the whole part, and that is said.
#[test]
fn a_change_after_the_end_says_that_the_whole_part_is_cut_anew() {
    for size in [DESKTOP, PHONE] {
        let mut screen = to_its_end(screen::open("depth-step", size, "Console", &[]));
        let before = session(&screen).chosen().run().metrics().time_of_cut_s;
        let said = |screen: &Screen<'_>| -> Vec<String> {
            screen.state().as_ref().unwrap().messages().map(str::to_owned).collect()
        };
        assert!(said(&screen).is_empty());
        let steps = Value::from(vec![[45.0, 3.0], [85.0, 2.0]]);
        let set = Command::set("workpiece.depth_steps", steps);
        screen.state().as_ref().unwrap().push(set);
        screen.run_steps(8);
        let messages = said(&screen);
        assert_eq!(messages.len(), 1, "{messages:?}");
        for part in ["The cut is over: Depth profile is set for the whole part", "cut anew", "Undo"]
        {
            assert!(messages[0].contains(part), "{part} in {messages:?}");
        }
        assert!(session(&screen).edits().list().is_empty());
        twin_found(&mut screen);
        let after = session(&screen).chosen().run().metrics().time_of_cut_s;
        assert!(after > before + 1.0, "{before} {after}");
    }
}

/// What will this step do? Nobody can know before it is cut: neither a tile nor a sentence tells it.
#[test]
fn nothing_is_told_that_is_not_cut_yet() {
    let mut screen = screen::open("first-cut", DESKTOP, "Console", &[]);
    crate::screen::in_time(|| {
        screen.run_steps(1);
        session(&screen).progress() >= 1.0
    });
    let whole = session(&screen).whole_story().clone();
    let step = whole.events.iter().find(|event| event.id == EventKind::DepthStep).unwrap();
    for after_s in [0.0, 0.3, 1.0] {
        seek(&mut screen, step.from_s + after_s);
        let shown = texts(&screen);
        let so_far = session(&screen).story();
        assert!(so_far.events.iter().all(|event| event.from_s <= step.from_s + after_s + 1e-6));
        let (_, response) = so_far.response_at(1e9).unwrap();
        assert_eq!(response.settling_time_s, None, "{after_s}: {response:?}");
        assert!(shown.contains("\ntoo short to judge"), "{after_s}: {shown}");
        assert!(!shown.contains("lowers the feed"), "{after_s}: {shown}");
        assert!(!shown.contains("remaining error"), "{after_s}: {shown}");
    }
    // Its moments are known: a click goes there.
    seek(&mut screen, 0.0);
    let name = format!("{:.2} s Depth step", step.from_s);
    assert!(screen.query_by_role_and_label(Role::Button, &name).is_some());
    press(&mut screen, "End");
    screen.run_steps(8);
    assert_eq!(session(&screen).story(), session(&screen).whole_story());
}

/// Was the cut good? The end says against what, and a tick stands only where the target was held.
#[test]
fn the_end_judges_the_whole_cut_and_ticks_only_what_was_held() {
    let flat = ("workpiece.depth_steps", Value::List(Vec::new()));
    let tracking = ("controller.kind", Value::Text("tracking".into()));
    let constant = ("controller.kind", Value::Text("constant_feed".into()));
    for (sets, held) in [(vec![flat, tracking], true), (vec![constant], false)] {
        for size in [DESKTOP, PHONE] {
            let screen = to_its_end(screen::open("first-cut", size, "Console", &sets));
            let verdict = *session(&screen).story().verdict().unwrap();
            assert_eq!(verdict.held, Some(held), "{verdict:?}");
            let inside = verdict.in_tolerance_percent.unwrap();
            let shown = texts(&screen);
            let said = if held { "target held" } else { "target not held" };
            let told = match size == DESKTOP {
                true => format!("Cut finished, {said}: {inside:.1} % in tolerance"),
                // A phone has room for the one word.
                false => said.replace("target ", "\n"),
            };
            assert!(shown.contains(&told), "{told} in {shown}");
            let out = verdict.longest_out_s;
            assert_eq!(out < 5.0, held, "{verdict:?}");
            let sentence = format!("and outside for {out:.2} s at the longest: the {said}")
                .replace("target held", "target was held")
                .replace("target not held", "target was not held");
            let told = &session(&screen).story().events.last().unwrap().sentence;
            assert!(
                told.contains(&sentence) && told.contains("within ±10 % of its target"),
                "{told}"
            );
        }
    }
}

/// Is a longer dead time harmless? Until something has to move it does not show: the line says when it will.
#[test]
fn a_longer_dead_time_is_said_to_show_at_the_next_change_of_depth() {
    let later = [(5.0, "cnc.dead_time_s", Value::Float(0.3))];
    let mut screen = screen::edited("first-cut", DESKTOP, "Console", &[], &later);
    crate::screen::in_time(|| {
        screen.run_steps(1);
        session(&screen).progress() >= 1.0
    });
    let events = &session(&screen).whole_story().events;
    let step = events.iter().find(|event| event.id == EventKind::DepthStep).unwrap().from_s;
    for time_s in [5.1, 8.0] {
        seek(&mut screen, time_s);
        let shown = texts(&screen);
        let said = format!(
            "It acts only while feed or speed moves: it shows most at the next change of depth, at {step:.2} s."
        );
        assert!(shown.contains(&said), "{said} in {shown}");
    }
}

/// What does this dead time do to the cut? One button cuts it from the start with what is set now; Restart would repeat
/// the change at its time.
#[test]
fn the_cut_is_begun_anew_with_the_settings_of_now() {
    const CUT_AGAIN: &str = "Apply from the start";
    for size in [DESKTOP, PHONE] {
        let later =
            [(5.0, "cnc.dead_time_s", Value::Float(0.3)), (9.0, "noise.level", Value::Float(1.5))];
        let mut screen = screen::edited("first-cut", size, "Console", &[], &later);
        screen.run_steps(20);
        seek(&mut screen, 7.0);
        press(&mut screen, "Restart");
        assert_eq!(session(&screen).edits().list().len(), 2, "Restart repeats them");
        seek(&mut screen, 7.0);
        if size == PHONE {
            press(&mut screen, "Menu");
        }
        press(&mut screen, CUT_AGAIN);
        let now = session(&screen);
        assert!(now.edits().list().is_empty());
        assert_eq!(now.scenario().cnc.dead_time_s, 0.3);
        assert_eq!(now.scenario().noise.level, 0.5, "that of later is not in force yet");
        assert!(now.playback().playing && now.playback().playhead_s < 1.0);
        let console = screen.state().as_ref().unwrap();
        let said: Vec<&str> = console.messages().collect();
        let text = "Cut from its start. Set for the whole cut now: Dead time. The 2 changes made during \
                    the cut are not repeated; Undo brings them back.";
        assert_eq!(said, [text]);
        // File and link hold it as the scenario's own.
        let file = scenario_file::write(session(&screen).scenario(), session(&screen).edits());
        assert!(file.contains("dead_time_s = 0.3") && !file.contains("[[edit"), "{file}");
        screen.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::Z);
        screen.run_steps(3);
        assert_eq!(session(&screen).edits().list().len(), 2);
        assert_eq!(session(&screen).scenario().cnc.dead_time_s, 0.08);
    }
    let screen = screen::open("first-cut", DESKTOP, "Console", &[]);
    let button = screen.get_by_role_and_label(Role::Button, CUT_AGAIN);
    assert!(button.accesskit_node().is_disabled(), "nothing was changed during the cut");
}

/// What was changed? A drag is one change, from the value before it to the value at its end.
#[test]
fn a_drag_is_told_as_one_change_from_before_it_to_its_end() {
    for speed in [1.0, 10.0] {
        let mut screen = screen::open("first-cut", DESKTOP, "Console", &[]);
        screen.run_steps(20);
        let command = PlaybackCommand::Speed(Speed::Times(speed));
        screen.state().as_ref().unwrap().push(Command::Playback(command));
        screen.run_steps(4);
        let before_s = session(&screen).playback().playhead_s;
        let rect = screen.get_by_role_and_label(Role::Slider, "Target Ra").rect();
        let at = |fraction: f32| egui::pos2(egui::lerp(rect.x_range(), fraction), rect.center().y);
        let begin = (session(&screen).current().target.ra_um * 100.0).round() / 100.0;
        // As long as a hand takes: at 0.05 s a frame it lasts for two seconds.
        screen.drag_at(at(0.63));
        for step in 0..40 {
            screen.hover_at(at(0.63 - 0.008 * step as f32));
            screen.run_steps(1);
        }
        screen.drop_at(at(0.31));
        screen.run_steps(20);
        let end = session(&screen).current().target.ra_um;
        assert!(end < begin - 0.1, "{begin} to {end}");
        let events = &session(&screen).story().events;
        let told: Vec<_> = events
            .iter()
            .filter(|event| event.from_s >= before_s && event.id == EventKind::TargetChange)
            .collect();
        assert_eq!(told.len(), 1, "{speed}: {events:#?}");
        let said = format!("The target Ra goes from {begin:.2} µm to {end:.2} µm");
        assert!(told[0].sentence.contains(&said), "{said} in {}", told[0].sentence);
    }
}

/// How good was constant feed there? Its line stands at the same place of the part as the cut's, and says so.
#[test]
fn the_line_of_constant_feed_goes_by_place_and_says_so() {
    let mut screen = screen::open("first-cut", DESKTOP, "Console", &[]);
    twin_found(&mut screen);
    // As it is told: what is drawn has firm spaces.
    let title = session(&screen).twin_title().replace('\u{a0}', " ");
    let entry = screen.get_all_by_role_and_label(Role::CheckBox, &title).last();
    entry.unwrap().hover();
    screen.run_steps(30);
    let shown = texts(&screen);
    assert!(shown.contains("drawn at the same place of the part"), "{shown}");
}

/// Is a surface smoother than asked bad? It is no scrap: only what is too rough gets a cross.
#[test]
fn smoother_than_asked_is_to_be_looked_at_and_too_rough_is_bad() {
    let flat = ("workpiece.depth_steps", Value::List(Vec::new()));
    let constant = ("controller.kind", Value::Text("constant_feed".into()));
    let quiet = ("noise.level", Value::Float(0.0));
    for (target_um, side, mark) in
        [(2.0, "below", "to be looked at"), (0.8, "above", "not as it should be")]
    {
        let target = ("target.ra_um", Value::Float(target_um));
        let sets = [flat.clone(), constant.clone(), quiet.clone(), target];
        let screen = ended("first-cut", &sets);
        let shown = texts(&screen);
        let ra_um = session(&screen).row().ra_um;
        for tile in [format!("{ra_um:.3} µm {mark}"), format!("{side} target {target_um:.3} µm")]
        {
            assert!(shown.contains(&tile), "{tile} in {shown}");
        }
        let error = format!("{:+.1} % ", 100.0 * (ra_um / target_um - 1.0));
        let told = shown.lines().find(|line| line.starts_with(&error)).unwrap();
        assert!(told.ends_with(mark), "{told}");
    }
}

/// Is this the shipped scenario? Not any more once something is changed, in it or in its cut.
#[test]
fn what_was_changed_does_not_go_by_the_shipped_name_alone() {
    let noise = [("noise.level", Value::Float(0.0))];
    let later = [(1.0, "noise.level", Value::Float(0.0))];
    for (sets, later, changed) in
        [(&[][..], &[][..], false), (&noise[..], &[][..], true), (&[][..], &later[..], true)]
    {
        let screen = screen::edited("first-cut", DESKTOP, "Console", sets, later);
        let list = screen.get_by_role_and_label(Role::ComboBox, "Scenario");
        let shown = list.accesskit_node().value().unwrap();
        assert!(shown.starts_with(presets::title("first-cut").unwrap()), "{shown}");
        assert_eq!(shown.ends_with(", changed"), changed, "{shown}");
        // Nor does its text speak of figures that are others now.
        let shipped = presets::load("first-cut").unwrap();
        let text = &shipped.info.description;
        let told = format!("As shipped: {text}");
        assert_eq!(screen.query_by_label(&told).is_some(), changed, "{}", texts(&screen));
        assert_eq!(screen.query_by_label(text).is_some(), !changed, "{}", texts(&screen));
    }
}

/// Why does an error stay? A law that does not integrate leaves one: the line says so, of SDNRP and of no other.
#[test]
fn an_error_that_stays_by_the_law_is_said_to() {
    for (kind, stays) in [("sdnrp", true), ("tracking", false)] {
        let sets = [
            ("controller.kind", Value::Text(kind.into())),
            ("target.ra_um", Value::Float(0.5)),
            ("noise.level", Value::Float(0.0)),
        ];
        let screen = ended("first-cut", &sets);
        let told: Vec<&str> =
            session(&screen).story().events.iter().map(|event| &*event.sentence).collect();
        let why = "the law has no integral";
        assert_eq!(told.iter().any(|sentence| sentence.contains(why)), stays, "{told:#?}");
    }
}

/// Is the twin's figure that of the whole way? A safe feed that is slower must not end on the way by the cut's own
/// time limit, before the part gets hard.
#[test]
fn the_safe_feed_cuts_the_whole_way_that_it_is_compared_over() {
    let screen = ended("disturbed-cut", &[("run.duration_s", Value::Float(12.0))]);
    let session = session(&screen);
    let [own, twin] = [session.chosen(), session.twin()]
        .map(|cut| cut.run().recording().rows().last().unwrap().position_mm);
    assert!(twin >= own, "the twin ends at {twin} mm of {own} mm");
    let compared = session.comparison();
    assert!((compared.twin.path_mm - compared.chosen.path_mm).abs() < 0.1, "{compared:?}");
}

/// Is nothing moved by words? The cards, the plots and the buttons of the transport stay where they are from the first
/// moment to the end, whatever is told.
#[test]
fn nothing_moves_from_the_first_moment_of_a_cut_to_its_end() {
    for (size, preset) in
        [(DESKTOP, "first-cut"), (PHONE, "first-cut"), (DESKTOP, "chatter"), (PHONE, "chatter")]
    {
        let mut screen = screen::open(preset, size, "Console", &[]);
        screen.run_steps(4);
        let twin_s = session(&screen).length_s();
        let places = |screen: &Screen<'_>| {
            let top = |role, name: &str| screen.get_by_role_and_label(role, name).rect().top();
            let plot = screen.get_by_label("Roughness [µm]").rect().top();
            [top(Role::Button, "Restart"), top(Role::Slider, "Playhead"), plot]
        };
        let first = places(&screen);
        twin_found(&mut screen);
        for share in [0.0, 0.1, 0.3, 0.6, 0.9, 1.0] {
            seek(&mut screen, share * twin_s);
            screen.run_steps(4);
            at_rest(&places(&screen), &first, &format!("{preset} at {share}"));
        }
        let screen = to_its_end(screen);
        assert!(session(&screen).finished().is_some());
        at_rest(&places(&screen), &first, &format!("{preset} at its end"));
    }
}

/// Lines of other fonts are a fraction of a point higher; a line that comes or goes is fifteen.
fn at_rest(now: &[f32], first: &[f32], when: &str) {
    let moved = now.iter().zip(first).any(|(now, first)| (now - first).abs() > 2.0);
    assert!(!moved, "{when}: {now:?}, not {first:?}");
}

/// Is the whole cut seen at its end? The plots that followed the playhead show all of it then.
#[test]
fn at_the_end_the_plots_show_the_whole_cut() {
    let mut screen = screen::open("first-cut", DESKTOP, "Console", &[]);
    twin_found(&mut screen);
    let length_s = session(&screen).length_s();
    assert!(length_s > 25.0, "it does not fit into the followed range: {length_s} s");
    seek(&mut screen, 0.7 * length_s);
    let range = |screen: &Screen<'_>| Axes::default().range(session(screen));
    assert!(range(&screen)[0] > 0.0);
    let screen = to_its_end(screen);
    assert!(session(&screen).playback().follow, "nothing was unticked");
    assert_eq!(range(&screen), [0.0, length_s]);
}

/// Does a number outside the model's range look like one inside? It has a mark, and the mark is explained.
#[test]
fn a_roughness_outside_the_range_of_its_model_has_a_mark() {
    let screen = ended("first-cut", &[]);
    let rows = session(&screen).chosen().run().recording().rows().to_vec();
    let outside = rows.iter().find(|row| row.has(flag::K5_OUTSIDE) && !row.ra_has_ended());
    let inside = rows.iter().find(|row| !row.has(flag::K5_OUTSIDE)).unwrap();
    let mut screen = screen;
    for (row, marked) in outside.map(|row| (row, true)).into_iter().chain([(inside, false)]) {
        seek(&mut screen, row.time_s);
        let told = format!("\u{2248} {:.3} µm", session(&screen).row().ra_um);
        assert_eq!(texts(&screen).contains(&told), marked, "{told}");
    }
}

/// What did the cut come to? The strip says it at any width, on nothing else and within the window.
#[test]
fn the_verdict_is_in_sight_at_any_width() {
    for width in [390.0, 700.0, 900.0, 960.0, 1024.0, 1280.0] {
        let size = vec2(width, 800.0);
        let screen = to_its_end(screen::open("first-cut", size, "Console", &[]));
        // Where the bar is a menu there is room for the one word.
        let narrow = screen.query_by_label("Menu").is_some();
        let told = if narrow { "not held" } else { "Cut finished, target not held" };
        let of_strip = screen
            .query_all_by_label_contains(told)
            .map(|node| node.rect())
            .find(|rect| rect.top() > 600.0 && rect.width() > 20.0);
        let verdict = of_strip.unwrap_or_else(|| panic!("{width}: {}", texts(&screen)));
        assert!(verdict.right() <= width, "{width}: {verdict:?}");
        for name in ["Restart", "End"] {
            let button = screen.get_by_role_and_label(Role::Button, name).rect();
            assert!(!button.intersects(verdict), "{width}: {verdict:?} on {name} {button:?}");
        }
    }
}
