//! The story of a run, held against what is known beforehand.

use steadycut_core::base::settings::Value;
use steadycut_core::blocks::control::ControllerKind;
use steadycut_core::run::edits::{Edit, Edits};
use steadycut_core::run::one_run::Run;
use steadycut_core::run::scenario::Scenario;
use steadycut_core::run::signals::{Row, flag};
use steadycut_core::run::story::{
    Cause, ChangeEffect, ChatterEnd, EventKind, Figures, LimitedCommand, ModelInput, ResponseEnd,
    Scan, Story, StoryEvent,
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
    assert_eq!((input.name, input.value, input.range), (ModelInput::TargetRa, 1.7, [0.38, 1.52]));
    assert_eq!((event.from_s, left.share_percent), (0.0, 100.0));
    assert_eq!(event.to_s, run.recording().rows().last().unwrap().time_s);
    let told = "The model of the force for a target Ra (K1) is used outside its range";
    assert!(event.sentence.starts_with(told), "{}", event.sentence);
    assert!(event.sentence.contains("0.38 to 1.52 µm"));
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

/// What is told up to a moment is what is told where nothing has followed yet: no sentence knows what comes.
#[test]
fn up_to_a_moment_it_is_told_as_if_nothing_followed() {
    let mut edits = Edits::none();
    let scenario = changed("first-cut", &[]);
    let edit = Edit { at_s: 12.0, path: "target.ra_um".to_owned(), value: Value::Float(0.7) };
    edits.push(&scenario, edit).unwrap();
    for (scenario, edits) in [
        (scenario, edits),
        (changed("chatter", &[]), Edits::none()),
        (changed("depth-step", &[]), Edits::none()),
        (quiet(&[("cnc.dead_time_s", Value::Float(0.3))]), Edits::none()),
    ] {
        let whole = Run::complete(&scenario, &edits);
        let mut scan = Scan::default();
        scan.extend(whole.recording().rows());
        let end = whole.recording().rows().len();
        let name = &scenario.info.name;
        for share in [0.001, 0.01, 0.1, 0.15, 0.153, 0.16, 0.3, 0.35, 0.5, 0.72, 0.9, 0.999] {
            let rows = (share * end as f64) as usize;
            let mut cut = Run::new(&scenario, &edits);
            cut.advance(whole.recording().tick_of(whole.recording().rows()[rows - 1].time_s));
            assert_eq!(cut.recording().rows().len(), rows);
            let told = Story::until(&whole, &scan, rows, None);
            assert_eq!(told, Story::of(&cut, None), "{name} at {share}");
            assert!(of_kind(&told, EventKind::End).is_empty());
        }
        assert_eq!(Story::until(&whole, &scan, end, None), Story::of(&whole, None), "{name}");
    }
}

/// A step that was cut a moment ago is no state yet; and what swings for good is found, while it is cut, where it is.
#[test]
fn while_it_is_cut_nothing_is_called_at_rest_or_unstable_that_is_not() {
    let scenario = changed("first-cut", &[]);
    let run = Run::complete(&scenario, &Edits::none());
    let mut scan = Scan::default();
    scan.extend(run.recording().rows());
    let step = of_kind(&Story::of(&run, None), EventKind::DepthStep)[0].from_s;
    let until = |time_s: f64| Story::until(&run, &scan, run.recording().index_at(time_s) + 1, None);
    for after_s in [0.0, 0.05, 0.2, 1.0] {
        let told = until(step + after_s);
        let event = of_kind(&told, EventKind::DepthStep)[0];
        assert_eq!(effect(event).response.unwrap().ends, ResponseEnd::TooShort, "{after_s}");
        assert!(event.sentence.ends_with("gets 0.20 mm deeper here."), "{}", event.sentence);
    }
    for preset in ["first-cut", "table3-5-noise", "depth-step"] {
        let run = Run::complete(&changed(preset, &[]), &Edits::none());
        let mut scan = Scan::default();
        scan.extend(run.recording().rows());
        for rows in (1..run.recording().rows().len()).step_by(700) {
            let told = Story::until(&run, &scan, rows, None);
            let cycles = of_kind(&told, EventKind::LimitCycle);
            assert!(cycles.is_empty(), "{preset} at row {rows}: {cycles:#?}");
        }
    }
}

/// A hand that drags makes a change every quarter of a second: they are told as one.
#[test]
fn a_drag_is_one_change_from_its_first_value_to_its_last() {
    let scenario = quiet(&[("run.duration_s", Value::Float(30.0))]);
    let mut edits = Edits::none();
    let paths = [("target.ra_um", 0.81, -0.03, 6.0), ("plant.hardness_hb", 200.0, 5.0, 15.0)];
    for (path, from, step, begin_s) in paths {
        for i in 1..=8 {
            let at_s = begin_s + 0.3 * f64::from(i);
            let value = Value::Float(from + step * f64::from(i));
            edits.push(&scenario, Edit { at_s, path: path.to_owned(), value }).unwrap();
        }
    }
    let (_, story) = told_with(&scenario, &edits);
    let targets = of_kind(&story, EventKind::TargetChange);
    assert_eq!(targets.len(), 1, "{targets:#?}");
    let [Cause::TargetRa { from_um, to_um }] = effect(targets[0]).causes[..] else { panic!() };
    assert!((from_um - 0.81).abs() < 1e-9 && (to_um - 0.57).abs() < 1e-9, "{from_um} {to_um}");
    let settings = of_kind(&story, EventKind::SettingChange);
    assert_eq!(settings.len(), 1, "{settings:#?}");
    let [Cause::Setting { from, to, .. }] = &effect(settings[0]).causes[..] else { panic!() };
    assert_eq!([from.as_str(), to.as_str()], ["200 HB", "240 HB"]);
    // It settles after the drag, not after its beginning: the loop follows a slow hand.
    let settled_s = effect(targets[0]).response.unwrap().settling_time_s.unwrap();
    assert!(settled_s < 1.5, "{settled_s}, the drag takes 2.1 s");
}

/// Share, longest time outside, and a target that is held only from nine tenths of the length on.
#[test]
fn the_end_tells_what_the_whole_cut_comes_to() {
    for (kind, held) in [("constant_feed", false), ("tracking", true)] {
        let sets = [
            ("controller.kind", Value::Text(kind.into())),
            ("workpiece.depth_steps", Value::List(Vec::new())),
        ];
        let (run, story) = told(&changed("first-cut", &sets));
        let verdict = story.verdict().unwrap();
        assert_eq!(verdict.held, Some(held), "{verdict:?}");
        assert_eq!(verdict.in_tolerance_percent, run.metrics().in_tolerance_percent);
        // As anyone can form it.
        let (mut longest_s, mut begun_s) = (0.0_f64, None);
        for row in run.recording().rows() {
            let out = (row.ra_um / row.ra_target_um - 1.0).abs() > 0.1 && !row.has(flag::AIR);
            begun_s = out.then(|| begun_s.unwrap_or(row.time_s));
            longest_s = longest_s.max(begun_s.map_or(0.0, |begun_s| row.time_s - begun_s));
        }
        assert!((verdict.longest_out_s - longest_s).abs() < 1e-9, "{verdict:?}, {longest_s}");
        let sentence = &story.events.last().unwrap().sentence;
        let said =
            if held { "the target was held (that takes 90 %)" } else { "the target was not held" };
        assert!(
            sentence.contains(said) && sentence.contains("within ±10 % of its target"),
            "{sentence}"
        );
    }
    // Where the model cannot judge most of it, nobody knows; that what it can is shaken out of it, one does.
    let run = Run::complete(&changed("chatter", &[]), &Edits::none());
    let ra_um = run.recording().rows()[run.recording().index_at(5.0)].ra_um;
    for (coupled, held, said) in [(false, None, "is not known"), (true, Some(false), "not held")] {
        let sets =
            [("target.ra_um", Value::Float(ra_um)), ("machine.coupled", Value::Bool(coupled))];
        let (_, story) = told(&changed("chatter", &sets));
        assert_eq!(story.verdict().unwrap().held, held, "{:?}", story.verdict());
        assert!(story.events.last().unwrap().sentence.contains(said));
    }
}

/// A dead time that is made longer at rest shows only when something moves: the sentence says when that is.
#[test]
fn what_a_loop_at_rest_does_not_show_is_said_to_show_later() {
    let scenario = quiet(&[("workpiece.depth_steps", one_step())]);
    for (at_s, ahead) in [(4.0, true), (14.0, false)] {
        let mut edits = Edits::none();
        let (path, value) = ("cnc.dead_time_s".to_owned(), Value::Float(0.3));
        edits.push(&scenario, Edit { at_s, path, value }).unwrap();
        let (_, story) = told_with(&scenario, &edits);
        let step_s = of_kind(&story, EventKind::DepthStep)[0].from_s;
        let sentence = &of_kind(&story, EventKind::SettingChange)[0].sentence;
        let said = match ahead {
            true => format!("it shows most at the next change of depth, at {step_s:.2} s."),
            false => "no change of depth lies ahead.".to_owned(),
        };
        assert!(sentence.ends_with(&said), "{said} in {sentence}");
    }
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
        // What the step itself makes, before the loop can answer.
        let first = rows.iter().map(|row| side * off(row.force_n)).fold(0.0, f64::max);
        let jump = response.jump_percent.unwrap();
        assert!((jump - side * 100.0 * first).abs() < 0.1, "{jump} for {first}");
        assert!(first >= off(rows[0].force_n).abs());
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

/// A slow swing that has not lasted long enough to be called unstable is no rest either.
#[test]
fn a_slow_swing_is_never_called_rest() {
    let scenario = changed("first-cut", &[("cnc.dead_time_s", Value::Float(0.4))]);
    let mut edits = Edits::none();
    let path = "controller.sdnrp.kp".to_owned();
    edits.push(&scenario, Edit { at_s: 11.0, path, value: Value::Float(5.0) }).unwrap();
    let run = Run::complete(&scenario, &edits);
    let mut scan = Scan::default();
    scan.extend(run.recording().rows());
    let mut ends = Vec::new();
    for tenth in 130..=210 {
        let time_s = f64::from(tenth) / 10.0;
        let told = Story::until(&run, &scan, run.recording().index_at(time_s) + 1, None);
        let (_, response) = told.response_at(time_s).unwrap();
        assert_ne!(response.ends, ResponseEnd::AtRest, "at {time_s} s: {response:?}");
        ends.push(response.ends);
    }
    assert!(ends.contains(&ResponseEnd::Unstable), "it lasts, and is called so at last: {ends:?}");
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
        let band = response.settling_band_percent.unwrap();
        assert!(band > 2.0 && band - 2.0 == response.band_of_noise_percent().unwrap());
        // 0.46 s without noise within 2 %; some 0.24 s within what noise leaves of it.
        match response.settling_time_s {
            Some(settling_s) => assert!(settling_s < 0.5, "seed {seed}: {response:?}"),
            None => assert!(response.swing_percent.unwrap() > band, "seed {seed}: {response:?}"),
        }
    }
}

/// Does it settle? Not where it swings by more than what it would settle within, whoever moves it.
#[test]
fn what_swings_by_more_than_the_band_does_not_settle() {
    for (kp, noise, settles) in [(0.5, 0.0, true), (2.5, 0.0, true), (2.5, 0.5, false)] {
        let (_, story) = told(&changed(
            "first-cut",
            &[("controller.sdnrp.kp", Value::Float(kp)), ("noise.level", Value::Float(noise))],
        ));
        let (event, response) = story.response_at(1e9).unwrap();
        let band = response.settling_band_percent.unwrap();
        assert_eq!(response.swing_percent.unwrap() <= band, settles, "{kp} {noise}: {response:?}");
        assert_eq!(response.settling_time_s.is_some(), settles, "{kp} {noise}: {response:?}");
        assert_eq!(response.overshoot_percent.is_some(), settles);
        assert_eq!(event.sentence.contains("nothing settles within"), !settles, "{event:#?}");
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
    // Where the playhead stands in the middle of it, nothing is said of an end.
    let mut scan = Scan::default();
    scan.extend(run.recording().rows());
    let last = found.last().expect("there is one");
    let middle = run.recording().index_at(0.5 * (last.from_s + last.to_s));
    let so_far = Story::until(&run, &scan, middle, None);
    let now = of_kind(&so_far, EventKind::Chatter).pop().expect("it has begun");
    let Figures::Chatter(chatter) = &now.figures else { panic!() };
    assert_eq!(chatter.ends, ChatterEnd::SoFar);
    assert!(now.sentence.ends_with("It still goes on."), "{}", now.sentence);
    // A tooth that jumps as it enters the part, 1.2 mm deep, is no chatter.
    let in_it = |t: f64| found.iter().any(|event| (event.from_s..=event.to_s).contains(&t));
    let lost = run.recording().rows().iter().filter(|row| row.has(flag::LOST_CONTACT));
    assert!(lost.filter(|row| row.axial_depth_mm > 1.5).map(|row| row.time_s).all(in_it));
}

/// The chatter preset's machine at one depth, with a target.
fn shaken(depth_mm: f64, ra_um: f64) -> Scenario {
    changed(
        "chatter",
        &[
            ("workpiece.depth_steps", Value::List(Vec::new())),
            ("workpiece.axial_depth_mm", Value::Float(depth_mm)),
            ("target.ra_um", Value::Float(ra_um)),
        ],
    )
}

/// Vibration that grows or stays from tooth to tooth is chatter, whether or not a tooth loses contact.
#[test]
fn chatter_that_keeps_contact_is_told_and_what_dies_down_is_not() {
    let steps = Value::from(vec![[35.0, 1.6], [70.0, 1.2]]);
    let deep = changed("chatter", &[("workpiece.depth_steps", steps)]);
    let (run, story) = told(&deep);
    let rows = run.recording().rows();
    let there = rows.iter().filter(|row| row.axial_depth_mm == 1.6);
    assert!(there.clone().count() > 3000 && there.clone().all(|row| !row.has(flag::LOST_CONTACT)));
    let found = of_kind(&story, EventKind::Chatter);
    assert_eq!(found.len(), 1, "{found:#?}");
    let Figures::Chatter(chatter) = &found[0].figures else { panic!() };
    assert!(!chatter.loses_contact && chatter.ends == ChatterEnd::Depth, "{chatter:?}");
    let most = there.map(|row| row.force_dyn_n).fold(0.0, f64::max);
    assert_eq!(chatter.largest_force_n, most);
    assert!(chatter.from_tooth_to_tooth_um > 5.0, "{chatter:?}");
    let [with, without] = chatter.ra_um.unwrap();
    assert!(with > 2.0 * without, "{chatter:?}");
    for part in ["keep contact", "does not die down", &format!("Ra is {with:.2} µm")] {
        assert!(found[0].sentence.contains(part), "{part} in {}", found[0].sentence);
    }
    assert!(story.has_swung() && story.events.last().unwrap().sentence.contains("It chattered"));
    for (depth_mm, noise) in [(1.3, 0.0), (1.4, 0.5), (1.5, 0.0)] {
        let steps = Value::from(vec![[35.0, depth_mm], [70.0, 1.2]]);
        let noise_level = ("noise.level", Value::Float(noise));
        let sets = [("workpiece.depth_steps", steps), noise_level];
        let (_, quiet) = told(&changed("chatter", &sets));
        let found = of_kind(&quiet, EventKind::Chatter);
        assert!(found.is_empty(), "{depth_mm} mm, noise {noise}: {found:#?}");
    }
}

/// Is the part good? What is left on it is Ra with dynamics, and that is judged wherever the tolerance is spoken of.
#[test]
fn the_tolerance_is_that_of_ra_with_dynamics_where_the_machine_vibrates() {
    let quiet_um = {
        let (run, _) = told(&shaken(1.6, 0.81));
        run.recording().rows().last().unwrap().ra_um
    };
    let (run, story) = told(&shaken(1.6, quiet_um));
    let metrics = run.metrics();
    let (with, without) =
        (metrics.in_tolerance_dyn_percent.unwrap(), metrics.in_tolerance_percent.unwrap());
    assert!(with < 20.0 && without > 99.0, "{with} {without}");
    assert_eq!((metrics.held(), metrics.held_with_dynamics()), (Some(true), Some(false)));
    assert_eq!(metrics.not_above(), Some(false), "a time counts only where it is no scrap");
    let verdict = story.verdict().unwrap();
    assert_eq!((verdict.held, verdict.in_tolerance_percent), (Some(false), Some(with)));
    assert_eq!(verdict.without_dynamics_percent, Some(without));
    let end = &story.events.last().unwrap().sentence;
    for part in ["Ra with dynamics was within", "(without dynamics on 100.0 %)", "was not held"] {
        assert!(end.contains(part), "{part} in {end}");
    }
    let start = &story.events[0];
    assert!(start.sentence.contains("leaves the tolerance (Ra with dynamics "), "{start:#?}");
    for event in &story.events {
        let judged = event.sentence.replace("outside the tolerance", "");
        assert!(!judged.contains("within the tolerance"), "{}", event.sentence);
    }
    // Without a machine there is no other Ra to judge.
    let (run, story) = told(&quiet(&[]));
    assert_eq!(run.metrics().in_tolerance_dyn_percent, None);
    assert!(story.events.iter().all(|event| !event.sentence.contains("dynamics")));
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

/// What stays within the tolerance does so all the time, and how long it was outside is counted in the rows.
#[test]
fn a_tolerance_that_was_left_on_the_way_is_not_said_to_be_kept() {
    let mut left = 0;
    for preset in ["first-cut", "depth-step", "table3-5", "disturbed-cut", "strategy-2013"] {
        let scenario = presets::load(preset).unwrap();
        let (run, story) = told(&scenario);
        let tolerance = scenario.target.tolerance_percent / 100.0;
        for event in &story.events {
            let Figures::Change(effect) = &event.figures else { continue };
            let own = event.sentence.split("the controller ").nth(1).unwrap_or_default();
            let rows = run.recording().rows().iter();
            let rows = rows.filter(|row| row.time_s > event.from_s && row.time_s <= event.to_s);
            let outside: Vec<&Row> = rows
                .filter(|row| !row.has(flag::AIR) && !row.ra_has_ended())
                // Below its model's range it is only known to be smooth.
                .filter(|row| !row.has(flag::K5_OUTSIDE) || row.ra_um > row.ra_target_um)
                .filter(|row| (row.ra_um - row.ra_target_um).abs() > tolerance * row.ra_target_um)
                .collect();
            if own.contains("stays within the tolerance (") {
                assert!(outside.len() <= 1, "{preset}, {} s: {own}", event.from_s);
            }
            if let Some(out) = effect.excursion.filter(|_| own.contains("is back in")) {
                left += 1;
                let counted_s = outside.len() as f64 * run.recording().row_s();
                assert!((out.outside_s - counted_s).abs() < 0.05, "{out:?} and {counted_s} s");
                // What is too rough comes before what is smoother.
                let all = || outside.iter().map(|row| row.ra_um);
                let most = all().fold(0.0, f64::max);
                let is_rough = most > scenario.target.ra_um;
                let furthest = if is_rough { most } else { all().fold(f64::INFINITY, f64::min) };
                assert!((out.furthest - furthest).abs() < 1e-6, "{out:?} and {furthest}");
                assert!(own.contains(&format!("furthest {furthest:.2} µm")), "{own}");
            }
        }
    }
    assert!(left > 0, "none of them leaves it and comes back");
}
