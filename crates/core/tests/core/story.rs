//! The story of a run, held against what is known beforehand.

use steadycut_core::base::settings::Value;
use steadycut_core::blocks::control::ControllerKind;
use steadycut_core::run::edits::{Edit, Edits};
use steadycut_core::run::one_run::Run;
use steadycut_core::run::scenario::Scenario;
use steadycut_core::run::signals::{Row, flag};
use steadycut_core::run::story::{
    Cause, ChangeEffect, ChatterEnd, EventKind, Figures, LimitedCommand, ResponseEnd, Story,
    StoryEvent,
};
use steadycut_core::run::{constant_feed_twin, presets};

fn changed(preset: &str, sets: &[(&str, Value)]) -> Scenario {
    let mut scenario = presets::load(preset).unwrap();
    let sets: Vec<_> = sets.iter().map(|(path, v)| ((*path).to_owned(), v.clone())).collect();
    scenario.set_all(&sets).unwrap();
    scenario
}

fn quiet(sets: &[(&str, Value)]) -> Scenario {
    let mut all = vec![("noise.level", Value::Float(0.0))];
    all.extend(sets.iter().cloned());
    changed("table3-5", &all)
}

fn told_with(scenario: &Scenario, edits: &Edits) -> (Run, Story) {
    let run = Run::complete(scenario, edits);
    let twin = constant_feed_twin::beside(&run);
    let story = Story::of(&run, Some(&twin));
    (run, story)
}

fn told(scenario: &Scenario) -> (Run, Story) {
    told_with(scenario, &Edits::none())
}

fn of_kind(story: &Story, kind: EventKind) -> Vec<&StoryEvent> {
    story.events.iter().filter(|event| event.id == kind).collect()
}

fn effect(event: &StoryEvent) -> &ChangeEffect {
    match &event.figures {
        Figures::Change(effect) => effect,
        other => panic!("{other:?}"),
    }
}

fn one_step() -> Value {
    Value::from(vec![[40.0, 2.3]])
}

#[test]
fn a_step_in_depth_is_told_where_it_comes_with_what_it_does() {
    let scenario = quiet(&[("workpiece.depth_steps", one_step())]);
    let (run, story) = told(&scenario);
    let steps = of_kind(&story, EventKind::DepthStep);
    assert_eq!(steps.len(), 1, "{story:#?}");
    let step = steps[0];
    let rows = run.recording().rows();
    let place = rows.iter().position(|row| row.position_mm >= 40.0).unwrap();
    assert_eq!((step.from_s, step.position_mm), (rows[place].time_s, rows[place].position_mm));
    let told = effect(step);
    assert_eq!(told.causes, [Cause::Depth { from_mm: 2.0, to_mm: 2.3 }]);
    // Means of the last second before and after, as anyone can form them.
    let feed = |range: std::ops::Range<usize>| {
        let count = range.len() as f64;
        rows[range].iter().map(|row| row.feed_mm_min).sum::<f64>() / count
    };
    let (before, after) = (told.before.unwrap(), told.after.unwrap());
    assert!((before.feed_mm_min - feed(place - 1000..place)).abs() < 1e-9);
    assert!((after.feed_mm_min - feed(rows.len() - 1000..rows.len())).abs() < 1e-9);
    assert!(after.feed_mm_min < 0.99 * before.feed_mm_min, "{told:#?}");
    // Without control the force grows with the cross-section: 2.3 of 2.0 mm.
    let (twin_before, twin_after) = (told.twin_before.unwrap(), told.twin_after.unwrap());
    assert!((twin_after.force_n / twin_before.force_n - 1.15).abs() < 1e-3, "{told:#?}");
    assert!((twin_after.feed_mm_min - 430.41).abs() < 1e-9);
    let lower = 100.0 * (1.0 - after.feed_mm_min / before.feed_mm_min);
    for words in [
        "gets 0.30 mm deeper here".to_owned(),
        format!("lowers the feed by {lower:.1} %"),
        "constant feed".to_owned(),
    ] {
        assert!(step.sentence.contains(&words), "{words:?} in {:?}", step.sentence);
    }
}

#[test]
fn nothing_is_told_without_a_cause() {
    // Constant feed in a part that stays the same: it begins, and it ends.
    let kind = ("controller.kind", Value::Text("constant_feed".into()));
    let (_, story) = told(&quiet(&[kind]));
    let kinds: Vec<EventKind> = story.events.iter().map(|event| event.id).collect();
    assert_eq!(kinds, [EventKind::Start, EventKind::End], "{story:#?}");
    assert!(
        story.events[1].sentence.contains("time limit")
            || story.events[1].sentence.contains("finished")
    );
    // With a controller that answers, after its dead time.
    let (_, story) = told(&quiet(&[]));
    let kinds: Vec<EventKind> = story.events.iter().map(|event| event.id).collect();
    assert_eq!(kinds, [EventKind::Start, EventKind::DeadTime, EventKind::End], "{story:#?}");
    let (_, story) = told(&quiet(&[("cnc.dead_time_s", Value::Float(0.0))]));
    assert!(of_kind(&story, EventKind::DeadTime).is_empty());
}

#[test]
fn the_first_answer_comes_after_the_dead_time() {
    for dead_time_s in [0.08, 0.3] {
        let scenario = quiet(&[
            ("workpiece.depth_steps", one_step()),
            ("cnc.dead_time_s", Value::Float(dead_time_s)),
        ]);
        let (_, story) = told(&scenario);
        let step = of_kind(&story, EventKind::DepthStep)[0];
        let dead = of_kind(&story, EventKind::DeadTime);
        let dead = dead.iter().find(|event| event.from_s == step.from_s).unwrap();
        let Figures::Answer(answer) = &dead.figures else { panic!("{dead:?}") };
        // The next control sample sees it, 20 ms later at most; the feed then waits for the channel.
        assert!(answer.command_after_s > 0.0 && answer.command_after_s <= 0.0211, "{answer:?}");
        let waits_s = answer.feed_after_s - answer.command_after_s;
        assert!((dead_time_s - 1e-9..dead_time_s + 0.03).contains(&waits_s), "{answer:?}");
    }
}

#[test]
fn saturation_lasts_exactly_while_its_flag_is_set() {
    let most = ("cnc.override_max_percent", Value::Float(100.0));
    let scenario = quiet(&[most, ("program.feed_mm_min", Value::Float(200.0))]);
    let (run, story) = told(&scenario);
    let limits = of_kind(&story, EventKind::Saturation);
    let feed: Vec<_> = limits
        .iter()
        .filter(|event| {
            matches!(&event.figures,
            Figures::Limit(limit) if limit.command == LimitedCommand::Feed)
        })
        .collect();
    assert!(!feed.is_empty(), "{story:#?}");
    for row in run.recording().rows() {
        let told = feed.iter().any(|event| (event.from_s..=event.to_s).contains(&row.time_s));
        assert_eq!(told, row.has(flag::FEED_SATURATED), "at {} s", row.time_s);
    }
    let Figures::Limit(limit) = &feed[0].figures else { unreachable!() };
    assert!(limit.upper && (limit.value - 200.0).abs() < 1e-9, "{limit:?}");
    assert!((limit.override_percent - 100.0).abs() < 1e-9);
    // The twin of it has no limit to meet.
    let (_, free) = told(&quiet(&[]));
    assert!(of_kind(&free, EventKind::Saturation).is_empty());
}

#[test]
fn a_model_outside_its_range_is_named_with_input_value_and_range() {
    // K1 was identified from 0.38 to 1.52 um.
    let (run, story) = told(&quiet(&[("target.ra_um", Value::Float(1.7))]));
    let outside = of_kind(&story, EventKind::OutsideModel);
    let k1 = outside.iter().find_map(|event| match &event.figures {
        Figures::Outside(left) if left.model == "K1" => Some((event, left)),
        _ => None,
    });
    let (event, left) = k1.unwrap();
    let input = left.input.unwrap();
    assert_eq!((input.name, input.value, input.range), ("target Ra", 1.7, [0.38, 1.52]));
    assert_eq!((event.from_s, left.share_percent), (0.0, 100.0));
    assert_eq!(event.to_s, run.recording().rows().last().unwrap().time_s);
    assert!(event.sentence.contains("K1") && event.sentence.contains("0.38 to 1.52 µm"));
}

#[test]
fn a_change_of_the_target_and_of_a_setting_are_told_with_both_values() {
    let scenario = quiet(&[]);
    let mut edits = Edits::none();
    for (at_s, path, value) in [
        (4.0, "target.ra_um", 0.6),
        (8.0, "plant.hardness_hb", 260.0),
        (8.1, "plant.hardness_hb", 280.0),
    ] {
        let edit = Edit { at_s, path: path.to_owned(), value: Value::Float(value) };
        edits.push(&scenario, edit).unwrap();
    }
    let (_, story) = told_with(&scenario, &edits);
    let targets = of_kind(&story, EventKind::TargetChange);
    assert_eq!(targets.len(), 1);
    assert!((targets[0].from_s - 4.0).abs() < 0.0211, "{}", targets[0].from_s);
    assert_eq!(effect(targets[0]).causes, [Cause::TargetRa { from_um: 0.81, to_um: 0.6 }]);
    let settings = of_kind(&story, EventKind::SettingChange);
    assert_eq!(settings.len(), 1, "two changes of a drag are one: {settings:#?}");
    let [Cause::Setting { path, from, to }] = &effect(settings[0]).causes[..] else {
        panic!("{settings:#?}")
    };
    assert_eq!((path.as_str(), to.as_str()), ("plant.hardness_hb", "280 HB"));
    assert_ne!(from, to);
}

/// The twin ends in half of the time: what is changed after that is changed at its place, too.
#[test]
fn constant_feed_meets_a_change_at_the_place_where_the_cut_does() {
    let scenario = changed(
        "first-cut",
        &[
            ("noise.level", Value::Float(0.0)),
            ("program.feed_mm_min", Value::Float(800.0)),
            ("workpiece.depth_steps", Value::List(Vec::new())),
        ],
    );
    let mut edits = Edits::none();
    for (at_s, path, value) in [
        (5.0, "plant.hardness_hb", 230.0),
        (40.0, "controller.sdnrp.kp", 0.6),
        (45.0, "workpiece.axial_depth_mm", 2.2),
    ] {
        edits
            .push(&scenario, Edit { at_s, path: path.to_owned(), value: Value::Float(value) })
            .unwrap();
    }
    let run = Run::complete(&scenario, &edits);
    let twin = constant_feed_twin::beside(&run);
    let rows = |run: &Run| run.recording().rows().to_vec();
    let (cut, alone) = (rows(&run), rows(&twin));
    let ended_s = alone.last().unwrap().time_s;
    assert!(ended_s < 40.0, "{ended_s}");
    // The depth of both is the same at each place, to a step of feed.
    for [at_mm, depth_mm] in [[100.0, 2.0], [290.0, 2.2]] {
        let at =
            |rows: &[Row]| rows[rows.partition_point(|row| row.position_mm < at_mm)].axial_depth_mm;
        assert_eq!([at(&cut), at(&alone)], [depth_mm; 2], "at {at_mm} mm");
    }
    let step = |rows: &[Row]| rows.iter().find(|row| row.axial_depth_mm > 2.1).unwrap().position_mm;
    assert!((step(&cut) - step(&alone)).abs() < 0.03, "{} and {}", step(&cut), step(&alone));
    // And the story can compare before and after it.
    let story = Story::of(&run, Some(&twin));
    let changes = of_kind(&story, EventKind::DepthStep);
    let told = effect(changes[0]);
    let (before, after) = (told.twin_before.unwrap(), told.twin_after.unwrap());
    assert!((after.force_n / before.force_n - 1.1).abs() < 1e-3, "{told:#?}");
}

fn response(sets: &[(&str, Value)]) -> (Story, ResponseEnd) {
    let (_, story) = told(&changed("first-cut", sets));
    let ends = story.response_at(20.0).unwrap().1.ends;
    (story, ends)
}

#[test]
fn a_large_gain_with_dead_time_is_unstable_and_a_small_one_is_not() {
    let sets = |kp: f64, dead_time_s: f64, noise: f64| {
        [
            ("controller.sdnrp.kp", Value::Float(kp)),
            ("cnc.dead_time_s", Value::Float(dead_time_s)),
            ("noise.level", Value::Float(noise)),
            ("workpiece.depth_steps", Value::List(Vec::new())),
        ]
    };
    for noise in [0.0, 0.5] {
        let (story, ends) = response(&sets(4.0, 0.3, noise));
        assert_eq!(ends, ResponseEnd::Unstable, "noise {noise}: {story:#?}");
        let cycles = of_kind(&story, EventKind::LimitCycle);
        let Figures::LimitCycle(cycle) = &cycles[0].figures else { panic!() };
        // A loop of proportional feedback with a dead time swings with two to four of it and of the lags.
        let of = cycle.oscillation;
        assert!((0.6..2.5).contains(&of.period_s), "{of:?}");
        assert!(of.force_percent > 2.0 && of.feed_percent > 5.0, "{of:?}");
        for (kp, dead_time_s) in [(0.1, 0.3), (0.5, 0.08), (0.5, 0.3), (1.0, 0.08)] {
            let (story, ends) = response(&sets(kp, dead_time_s, noise));
            assert_eq!(ends, ResponseEnd::AtRest, "Kp {kp}, {dead_time_s} s, noise {noise}");
            assert!(of_kind(&story, EventKind::LimitCycle).is_empty());
        }
    }
}

#[test]
fn noise_alone_is_never_called_unstable() {
    for seed in 1..=12 {
        for noise in [1.0, 3.0] {
            let sets = [
                ("run.seed", Value::Int(seed)),
                ("noise.level", Value::Float(noise)),
                ("run.duration_s", Value::Float(60.0)),
            ];
            for kind in ["sdnrp", "tracking", "mrac"] {
                let mut all = sets.to_vec();
                all.push(("controller.kind", Value::Text(kind.into())));
                let (_, story) = told(&changed("first-cut", &all));
                let cycles = of_kind(&story, EventKind::LimitCycle);
                assert!(cycles.is_empty(), "{kind}, seed {seed}, noise {noise}: {cycles:#?}");
            }
        }
    }
}

#[test]
fn settling_and_overshoot_are_about_the_value_at_rest_and_the_remaining_error_apart() {
    for sets in [vec![], vec![("workpiece.depth_steps", one_step())]] {
        let (run, story) = told(&quiet(&sets));
        let (event, response) = story.response_at(f64::MAX).unwrap();
        // As anyone can form it from the rows.
        let recording = run.recording();
        let rows = &recording.rows()[recording.index_at(event.from_s)..];
        let rest_n = rows[rows.len() - 1000..].iter().map(|row| row.force_n).sum::<f64>() / 1000.0;
        let off = |force_n: f64| (force_n - rest_n) / rest_n;
        let last = rows.iter().rposition(|row| off(row.force_n).abs() > 0.02);
        let known_s = last.map_or(0.0, |last| rows[last].time_s - event.from_s);
        let settling_s = response.settling_time_s.unwrap();
        assert!((settling_s - known_s).abs() < 0.03, "{settling_s} for {known_s}");
        assert_eq!(response.is_without_transient(), last.is_none());
        let side = off(rows[0].force_n).signum();
        let most = rows.iter().map(|row| -side * off(row.force_n)).fold(0.0, f64::max);
        let overshoot = response.overshoot_percent.unwrap();
        assert!((overshoot - 100.0 * most).abs() < 0.1, "{overshoot} for {most}");
        let error = response.remaining_error_percent.unwrap();
        assert!((error - run.metrics().ra_deviation_percent.unwrap()).abs() < 0.05, "{error}");
    }
    // Proportional feedback leaves an error: a deeper part leaves more force.
    let (_, story) = told(&quiet(&[("workpiece.depth_steps", one_step())]));
    let step = of_kind(&story, EventKind::DepthStep)[0];
    let error = effect(step).response.unwrap().remaining_error_percent.unwrap();
    assert!(error > 0.0, "{error}");
    assert!(step.sentence.contains("remaining error") && step.sentence.contains("above"));
}

/// Kp at a moment of the first scenario's cut, with a dead time, a noise level and a seed.
fn changed_gain(kp: f64, at_s: f64, dead_time_s: f64, noise: f64, seed: i64) -> Story {
    let scenario = changed(
        "first-cut",
        &[
            ("cnc.dead_time_s", Value::Float(dead_time_s)),
            ("noise.level", Value::Float(noise)),
            ("run.seed", Value::Int(seed)),
        ],
    );
    let mut edits = Edits::none();
    let edit = Edit { at_s, path: "controller.sdnrp.kp".to_owned(), value: Value::Float(kp) };
    edits.push(&scenario, edit).unwrap();
    Story::of(&Run::complete(&scenario, &edits), None)
}

/// At a dead time of 0.2 s the loop is critical at a gain of some 2.7, at 0.08 s of 3.9.
#[test]
fn a_damped_loop_under_noise_is_never_called_unstable_however_short_the_stretch() {
    for (kp, dead_time_s) in [(1.5, 0.2), (2.1, 0.2), (3.0, 0.08)] {
        for seed in 1..=6 {
            for noise in [0.5, 1.0, 3.0] {
                // Four seconds before a step among them.
                for at_s in [3.0, 12.0, 25.0] {
                    let story = changed_gain(kp, at_s, dead_time_s, noise, seed);
                    let found = of_kind(&story, EventKind::LimitCycle);
                    assert!(
                        found.is_empty(),
                        "Kp {kp} at {at_s} s, {dead_time_s} s, noise {noise}, seed {seed}: {found:#?}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_limit_cycle_is_found_under_noise() {
    for kp in [3.8, 4.0, 4.3] {
        for seed in 1..=6 {
            for noise in [0.0, 0.5, 1.0] {
                let story = changed_gain(kp, 15.0, 0.2, noise, seed);
                let (_, response) = story.response_at(1e9).unwrap();
                assert!(
                    response.is_unstable(),
                    "Kp {kp}, noise {noise}, seed {seed}: {response:?}"
                );
            }
        }
    }
}

/// Noise moves no figure of a step by much, and what it moves is told.
#[test]
fn settling_does_not_jump_with_noise() {
    for seed in 1..=12 {
        let story = changed_gain(1.0, 12.0, 0.2, 0.5, seed);
        let (_, response) = story.response_at(1e9).unwrap();
        let settling_s = response.settling_time_s.unwrap();
        // 0.46 s without noise within 2 %; some 0.24 s within what noise leaves of it.
        assert!(settling_s < 0.5, "seed {seed}: {response:?}");
        assert!(response.settling_band_percent.unwrap() > 2.0);
    }
}

/// Who sees the end of a cut is told what it was on the way.
#[test]
fn a_cut_that_swung_or_chattered_says_so_at_its_end() {
    let scenario = changed("first-cut", &[("cnc.dead_time_s", Value::Float(0.2))]);
    let mut edits = Edits::none();
    for (at_s, kp) in [(3.0, 4.0), (20.0, 0.5)] {
        let edit = Edit { at_s, path: "controller.sdnrp.kp".to_owned(), value: Value::Float(kp) };
        edits.push(&scenario, edit).unwrap();
    }
    let (_, story) = told_with(&scenario, &edits);
    let spans = story.stretches_until(EventKind::LimitCycle, 1e9);
    let [[from_s, to_s]] = spans[..] else { panic!("{spans:?}") };
    assert!((3.0..4.5).contains(&from_s) && (to_s - 20.0).abs() < 0.1, "{spans:?}");
    let end = &story.events.last().unwrap().sentence;
    assert!(end.contains(&format!("It was unstable from {from_s:.2} to {to_s:.2} s.")), "{end}");
    assert_eq!(story.stretches_until(EventKind::LimitCycle, 10.0), [[from_s, 10.0]]);
    assert!(story.stretches_until(EventKind::LimitCycle, 2.0).is_empty());
    let (_, quiet) = told(&quiet(&[]));
    assert!(!quiet.events.last().unwrap().sentence.contains("It was"));
    let (_, chatter) = told(&presets::load("chatter").unwrap());
    let end = &chatter.events.last().unwrap().sentence;
    assert!(end.contains("It chattered from 3.") && end.contains(" to 7."), "{end}");
}

#[test]
fn chatter_begins_and_ends_with_the_deep_part() {
    let scenario = presets::load("chatter").unwrap();
    let (run, story) = told(&scenario);
    let found = of_kind(&story, EventKind::Chatter);
    assert!(!found.is_empty(), "{story:#?}");
    let Figures::Chatter(chatter) = &found[0].figures else { panic!() };
    let steps = &scenario.workpiece.depth_steps;
    let deepest = steps.iter().map(|[_, depth_mm]| *depth_mm).fold(0.0, f64::max);
    assert_eq!(chatter.axial_depth_mm, deepest);
    assert!(chatter.largest_force_n > 1.2 * chatter.mean_force_n, "{chatter:?}");
    assert_eq!(
        found.last().map(|event| match &event.figures {
            Figures::Chatter(chatter) => chatter.ends,
            other => panic!("{other:?}"),
        }),
        Some(ChatterEnd::Depth)
    );
    // A tooth that jumps as it enters the part, 1.2 mm deep, is no chatter.
    let in_it = |t: f64| found.iter().any(|event| (event.from_s..=event.to_s).contains(&t));
    let lost = run.recording().rows().iter().filter(|row| row.has(flag::LOST_CONTACT));
    assert!(lost.filter(|row| row.axial_depth_mm > 1.5).map(|row| row.time_s).all(in_it));
}

#[test]
fn air_is_told_and_nothing_is_judged_in_it() {
    let steps = Value::from(vec![[30.0, 0.0], [40.0, 2.0]]);
    let (run, story) = told(&quiet(&[("workpiece.depth_steps", steps)]));
    let air = of_kind(&story, EventKind::Air);
    assert_eq!(air.len(), 1, "{story:#?}");
    let Figures::Air(cut) = &air[0].figures else { panic!() };
    assert!((cut.length_mm - 10.0).abs() < 0.1, "{cut:?}");
    assert_eq!(of_kind(&story, EventKind::Contact).len(), 1);
    assert!(of_kind(&story, EventKind::DepthStep).is_empty());
    for row in run.recording().rows() {
        let told = (air[0].from_s..=air[0].to_s).contains(&row.time_s);
        assert_eq!(told, row.has(flag::AIR), "at {} s", row.time_s);
    }
}

#[test]
fn a_stop_and_the_end_have_their_cause() {
    let stop = [("cnc.force_stop", Value::Bool(true)), ("cnc.force_stop_n", Value::Float(100.0))];
    let (_, story) = told(&quiet(&stop));
    let end = story.events.last().unwrap();
    assert_eq!(end.id, EventKind::End);
    assert!(end.sentence.contains("allowed 100 N"), "{}", end.sentence);
}

#[test]
fn wear_is_told_with_what_it_costs() {
    let (_, story) = told(&presets::load("tool-life").unwrap());
    let wear = of_kind(&story, EventKind::Wear);
    assert!(wear[0].sentence.contains("the force grows by"), "{}", wear[0].sentence);
    assert_eq!(wear.len(), 1, "{story:#?}");
    let Figures::Wear(effect) = &wear[0].figures else { panic!() };
    assert!(effect.used_to_percent > effect.used_from_percent + 1.0, "{effect:?}");
    let (_, fresh) = told(&quiet(&[]));
    assert!(of_kind(&fresh, EventKind::Wear).is_empty());
}

#[test]
fn every_preset_has_a_story_whose_sentences_read_well() {
    for preset in presets::PRESETS {
        let scenario = presets::load(preset.name).unwrap();
        let (run, story) = told(&scenario);
        assert!(story.events.len() >= 2, "{}", preset.name);
        let last_s = run.recording().rows().last().unwrap().time_s;
        for event in &story.events {
            let text = &event.sentence;
            assert!(event.from_s <= event.to_s + 1e-9 && event.to_s <= last_s, "{event:#?}");
            assert!(text.ends_with('.') && !text.contains("..") && !text.contains("  "), "{text}");
            assert!(!text.contains("NaN") && !text.contains("inf"), "{}: {text}", preset.name);
            assert!(text.len() < 420, "{}: {text}", preset.name);
        }
        assert!(story.events.len() < 200, "{}: {} events", preset.name, story.events.len());
    }
}

#[test]
fn no_controller_and_setting_makes_an_event_that_json_cannot_hold() {
    for kind in ControllerKind::ALL {
        let kind = ("controller.kind", Value::Text(kind.id().into()));
        let (_, story) = told(&quiet(&[kind, ("workpiece.depth_steps", one_step())]));
        let json = serde_json::to_value(&story).unwrap();
        let steps = json["events"].as_array().unwrap().iter().filter(|e| e["id"] == "depth_step");
        assert_eq!(steps.count(), 1);
    }
}
