//! What disturbances do in a run: each against a value worked out by hand, and nothing outside its place.

use steadycut_core::base::settings::{SettingError, Value};
use steadycut_core::blocks::control::ControllerKind;
use steadycut_core::blocks::cutting::force_model::ForceModel;
use steadycut_core::models::disturbances::{Disturbance, Zone};
use steadycut_core::models::tool::Tool;
use steadycut_core::run::edits::{Edit, Edits};
use steadycut_core::run::one_run::Run;
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::{Scenario, parse_value};
use steadycut_core::run::signals::{Row, flag};
use steadycut_core::run::story::{EventKind, Story};
use steadycut_core::run::{constant_feed_twin, scenario_file, scenario_link};

/// Where the disturbances of these tests lie, mm.
const AT_MM: f64 = 30.0;
const LENGTH_MM: f64 = 6.0;

/// A cut at constant feed, without noise: what controls nothing shows what the disturbance itself does.
fn steady() -> Scenario {
    let mut scenario = load("table3-5").unwrap();
    scenario
        .change(|s| {
            s.controller.kind = ControllerKind::ConstantFeed;
            s.run.duration_s = 8.0;
        })
        .unwrap();
    scenario
}

fn zone(size: f64) -> Zone {
    Zone { at_mm: AT_MM, length_mm: LENGTH_MM, size }
}

fn with(scenario: &Scenario, kind: Disturbance, size: f64) -> Scenario {
    let mut disturbed = scenario.clone();
    disturbed.set(kind.path(), scenario.disturbances.with(kind, zone(size))).unwrap();
    disturbed
}

fn rows(scenario: &Scenario) -> Vec<Row> {
    Run::complete(scenario, &Edits::none()).recording().rows().to_vec()
}

/// The rows of a disturbed and of an undisturbed run at the same places, inside and outside.
struct Beside {
    inside: Vec<[Row; 2]>,
    before: Vec<[Row; 2]>,
    behind: Vec<[Row; 2]>,
}

/// Both runs of a cut whose motion no disturbance of it changes.
fn beside(kind: Disturbance, size: f64) -> Beside {
    let (disturbed, clean) = (rows(&with(&steady(), kind, size)), rows(&steady()));
    let mut found = Beside { inside: Vec::new(), before: Vec::new(), behind: Vec::new() };
    for (now, was) in disturbed.into_iter().zip(clean) {
        assert_eq!(now.position_mm, was.position_mm, "{kind:?}");
        let place = match now.position_mm {
            x if x < AT_MM => &mut found.before,
            x if x < AT_MM + LENGTH_MM => &mut found.inside,
            _ => &mut found.behind,
        };
        place.push([now, was]);
    }
    assert!(found.inside.len() > 500 && found.before.len() > 500 && found.behind.len() > 500);
    found
}

fn all_alike(rows: &[[Row; 2]]) -> bool {
    rows.iter().all(|[now, was]| now == was)
}

/// The least and the largest of now over before.
fn ratios(rows: &[[Row; 2]], of: impl Fn(&Row) -> f64) -> [f64; 2] {
    let ratio = |[now, was]: &[Row; 2]| of(now) / of(was);
    let each = || rows.iter().map(ratio);
    [each().fold(f64::INFINITY, f64::min), each().fold(f64::NEG_INFINITY, f64::max)]
}

fn near(found: [f64; 2], expected: f64) {
    let off = found.map(|ratio| (ratio / expected - 1.0).abs());
    assert!(off[0] < 1e-9 && off[1] < 1e-9, "{found:?}, expected {expected}");
}

#[test]
fn a_hard_spot_multiplies_the_force_on_its_length_and_nowhere_else() {
    let found = beside(Disturbance::HardSpot, 1.5);
    near(ratios(&found.inside, |row| row.force_n), 1.5);
    near(ratios(&found.inside, |row| row.force_dyn_n), 1.5);
    assert!(all_alike(&found.before));
    // The sample of the sensor is held: behind the spot it is read a control period later.
    near(ratios(&found.behind, |row| row.force_n), 1.0);
}

#[test]
fn a_gap_is_air_and_a_depth_step_cuts_as_deep_as_it_says() {
    let gap = beside(Disturbance::Gap, 1.0);
    assert!(gap.inside.iter().all(|[now, _]| now.has(flag::AIR) && now.force_n == 0.0));
    assert!(gap.behind.iter().all(|[now, _]| !now.has(flag::AIR)));
    let deeper = beside(Disturbance::DepthStep, 0.5);
    assert!(deeper.inside.iter().all(|[now, _]| now.axial_depth_mm == 2.5));
    let mut programmed = steady();
    programmed.change(|s| s.workpiece.axial_depth_mm = 2.5).unwrap();
    let programmed = rows(&programmed);
    // The tool came as fast: where it is, it cuts what it would cut of a part that deep.
    for [now, _] in &deeper.inside {
        let row = programmed.iter().find(|row| row.time_s == now.time_s).unwrap();
        assert!((now.force_n / row.force_n - 1.0).abs() < 1e-12);
    }
    for found in [gap, deeper] {
        assert!(all_alike(&found.before));
        near(ratios(&found.behind, |row| row.force_n), 1.0);
    }
}

#[test]
fn a_wear_jump_and_a_broken_tooth_stay_and_grow_the_force_as_worked_out() {
    // 0.1 of 0.3 mm are a third of the wear: 0.6/3 more force. Felt from the next control period on.
    let worn = beside(Disturbance::WearJump, 0.1);
    near(ratios(&worn.inside[20..], |row| row.force_n), 1.2);
    near(ratios(&worn.behind, |row| row.force_n), 1.2);
    // Twice the chip with Kienzle's m_c = 0.14 of Ck45: 2^0.86 = 1.81504.
    let broken = beside(Disturbance::BrokenTooth, 1.0);
    let [least, largest] = ratios(&broken.inside, |row| row.force_n);
    assert!((least - 1.81504).abs() < 1e-5 && (largest - least).abs() < 1e-9, "{least} {largest}");
    near(ratios(&broken.behind, |row| row.force_n), least);
    for found in [worn, broken] {
        assert!(all_alike(&found.before));
    }
}

#[test]
fn tooth_by_tooth_a_broken_tooth_leaves_a_cutter_with_one_less() {
    let by_teeth = |teeth: u32| {
        let mut scenario = steady();
        scenario
            .change(|s| {
                s.plant.force_model = ForceModel::Mechanistic;
                s.run.steps_per_control = 576;
                s.run.record_every = 576;
                s.run.duration_s = 6.5;
                s.tool = Tool { teeth, runout_um: 0.0, compliance_um_n: 0.0, ..Tool::default() };
            })
            .unwrap();
        scenario
    };
    let broken = rows(&with(&by_teeth(2), Disturbance::BrokenTooth, 1.0));
    let [two, one] = [2, 1].map(|teeth| rows(&by_teeth(teeth)));
    // The largest over two seconds: the one tooth does not pass in every control period.
    let largest = |rows: &[Row], from_mm: f64, to_mm: f64| {
        let there = rows.iter().filter(|row| (from_mm..to_mm).contains(&row.position_mm));
        there.map(|row| row.force_n).fold(0.0, f64::max)
    };
    assert_eq!(largest(&broken, 10.0, AT_MM), largest(&two, 10.0, AT_MM));
    let [left, alone] = [&broken, &one].map(|rows| largest(rows, AT_MM + 1.0, AT_MM + 14.0));
    assert!((left / alone - 1.0).abs() < 1e-3, "{left} N, a cutter of one tooth {alone} N");
    // The factor that the maps take lies near what the teeth do.
    let grown = left / largest(&two, AT_MM + 1.0, AT_MM + 14.0);
    assert!((grown / 1.815 - 1.0).abs() < 0.05, "{grown}");
}

#[test]
fn a_chatter_burst_swings_the_dynamic_force_with_its_amplitude_and_frequency() {
    let found = beside(Disturbance::ChatterBurst, 20.0);
    assert!(found.inside.iter().all(|[now, was]| now.force_n == was.force_n), "F itself stays");
    let swing: Vec<f64> =
        found.inside.iter().map(|[now, _]| now.force_dyn_n / now.force_n - 1.0).collect();
    let [least, largest] =
        [swing.iter().copied().fold(0.0, f64::min), swing.iter().copied().fold(0.0, f64::max)];
    assert!((largest - 0.2).abs() < 2e-3 && (least + 0.2).abs() < 2e-3, "{least} {largest}");
    let mean = swing.iter().sum::<f64>() / swing.len() as f64;
    assert!(mean.abs() < 2e-3, "{mean}");
    let crossings = swing.windows(2).filter(|pair| pair[0] < 0.0 && pair[1] >= 0.0).count();
    let hz = crossings as f64 / (swing.len() as f64 * 1e-3);
    assert!((hz - 230.0).abs() < 3.0, "{hz} Hz");
    assert!(all_alike(&found.before));
    near(ratios(&found.behind, |row| row.force_dyn_n), 1.0);
}

#[test]
fn the_sensor_reads_nothing_or_more_and_more_and_the_cut_stays_as_it_is() {
    let control_mm = 0.2;
    let out = beside(Disturbance::SensorDropout, 1.0);
    let drift = beside(Disturbance::SensorDrift, 50.0);
    for found in [&out, &drift] {
        assert!(all_alike(&found.before));
        let all = found.inside.iter().chain(&found.behind);
        assert!(all.clone().all(|[now, was]| now.force_n == was.force_n));
    }
    let late = |rows: &[[Row; 2]]| rows[30..].to_vec();
    assert!(late(&out.inside).iter().all(|[now, _]| now.force_measured_n == 0.0));
    near(ratios(&late(&out.behind), |row| row.force_measured_n), 1.0);
    for [now, was] in late(&drift.inside) {
        let expected_n = 50.0 * (now.position_mm - AT_MM) / LENGTH_MM;
        let offset_n = now.force_measured_n - was.force_measured_n;
        let held_n = 50.0 * control_mm / LENGTH_MM;
        assert!((expected_n - held_n..=expected_n).contains(&offset_n), "{offset_n} {expected_n}");
    }
    let stays = late(&drift.behind);
    assert!(
        stays.iter().all(|[now, was]| {
            (now.force_measured_n - was.force_measured_n - 50.0).abs() < 1e-9
        })
    );
}

#[test]
fn the_operators_hand_slows_the_feed_to_its_share_and_lets_it_go_again() {
    let rows = rows(&with(&steady(), Disturbance::Operator, 60.0));
    let feed_at = |place_mm: f64| {
        let row = rows.iter().find(|row| row.position_mm >= place_mm).unwrap();
        (row.feed_mm_min, row.feed_command_mm_min)
    };
    let (free, commanded) = feed_at(AT_MM - 0.5);
    let (by_hand, still) = feed_at(AT_MM + LENGTH_MM - 0.1);
    assert!((by_hand / free - 0.6).abs() < 1e-3, "{by_hand} of {free}");
    assert_eq!(commanded, still, "the command is the controller's");
    let (again, _) = feed_at(AT_MM + LENGTH_MM + 5.0);
    assert!((again / free - 1.0).abs() < 1e-3);
}

#[test]
fn a_longer_dead_time_delays_the_answer_by_as_much() {
    let mut scenario = load("table3-5").unwrap();
    scenario.change(|s| s.run.duration_s = 8.0).unwrap();
    // The target changes within the zone; when the actual feed first moves after that.
    let answered_s = |scenario: &Scenario| {
        let clean = Run::complete(scenario, &Edits::none());
        let rows = clean.recording().rows();
        let inside = rows.iter().position(|row| row.position_mm >= AT_MM + 1.0).unwrap();
        let at_s = (rows[inside].time_s / 0.02).ceil() * 0.02;
        let mut edits = Edits::none();
        let finer = Edit { at_s, path: "target.ra_um".to_owned(), value: Value::Float(0.6) };
        edits.push(scenario, finer).unwrap();
        let edited = Run::complete(scenario, &edits);
        let pairs = edited.recording().rows().iter().zip(rows);
        let moved = pairs.clone().find(|(now, was)| now.feed_mm_min != was.feed_mm_min).unwrap();
        assert!(moved.0.position_mm < AT_MM + 40.0);
        moved.0.time_s - at_s
    };
    let mut long = scenario.clone();
    let place = Zone { length_mm: 40.0, ..zone(0.2) };
    let kind = Disturbance::DeadTime;
    long.set(kind.path(), scenario.disturbances.with(kind, place)).unwrap();
    let later_s = answered_s(&long) - answered_s(&scenario);
    assert!((later_s - 0.2).abs() < 1.5e-3, "{later_s}");
}

#[test]
fn files_links_edits_and_the_twin_keep_every_disturbance() {
    let mut all = load("first-cut").unwrap();
    let mut edits = Edits::none();
    for (i, kind) in Disturbance::ALL.iter().copied().enumerate() {
        let size = kind.size().map_or(1.0, |size| size.usual);
        all = with(&all, kind, size);
        let later = Zone { at_mm: 60.0 + i as f64, length_mm: 1.5, size };
        // One tooth is left.
        if kind != Disturbance::BrokenTooth {
            let value = all.disturbances.with(kind, later);
            edits.push(&all, Edit { at_s: 1.0, path: kind.path().to_owned(), value }).unwrap();
        }
    }
    let written = scenario_file::write(&all, &edits);
    assert_eq!(scenario_file::parse(&written).unwrap(), (all.clone(), edits.clone()), "{written}");
    let link = scenario_link::write(&all, &edits);
    assert_eq!(scenario_link::parse(&link).unwrap(), (all.clone(), edits.clone()), "{link}");
    let digest =
        |scenario: &Scenario, edits: &Edits| Run::complete(scenario, edits).recording().digest();
    assert_eq!(digest(&all, &edits), digest(&all, &edits), "the same bits twice");
    let twin = constant_feed_twin::scenario(&all);
    assert_eq!(twin.disturbances, all.disturbances);
    assert_eq!(constant_feed_twin::edits(&edits), edits);
}

#[test]
fn dropped_into_the_running_cut_it_is_as_if_it_had_always_been_there() {
    for (kind, size) in [
        (Disturbance::HardSpot, 1.5),
        (Disturbance::Gap, 1.0),
        (Disturbance::DepthStep, 0.5),
        (Disturbance::BrokenTooth, 1.0),
        (Disturbance::WearJump, 0.1),
        (Disturbance::ChatterBurst, 20.0),
        (Disturbance::SensorDropout, 1.0),
        (Disturbance::SensorDrift, 50.0),
        (Disturbance::DeadTime, 0.2),
        (Disturbance::Operator, 60.0),
    ] {
        let scenario = load("table3-5").unwrap();
        let always = rows(&with(&scenario, kind, size));
        let mut edits = Edits::none();
        let value = scenario.disturbances.with(kind, zone(size));
        edits.push(&scenario, Edit { at_s: 1.0, path: kind.path().to_owned(), value }).unwrap();
        let mut run = Run::complete(&scenario, &edits);
        assert!(run.recording().rows() == always, "{kind:?}");
        // Taken back, the run is the one without.
        run.branch(1.0, &Edits::none());
        run.advance(u64::MAX);
        assert!(run.recording().rows() == rows(&scenario), "{kind:?}");
    }
}

#[test]
fn several_cuts_and_every_force_model_meet_them() {
    for model in ForceModel::ALL.iter().copied() {
        let mut scenario = load("experiment-1").unwrap();
        scenario
            .change(|s| {
                s.plant.force_model = model;
                s.controller.kind = ControllerKind::ConstantFeed;
                s.run.duration_s = 10.0;
                s.noise.level = 0.0;
                if model.tooth_by_tooth() {
                    s.run.steps_per_control = 240;
                    s.run.record_every = 60;
                }
            })
            .unwrap();
        let clean = rows(&scenario);
        let reached_mm = clean.last().unwrap().position_mm;
        assert!(reached_mm > AT_MM + LENGTH_MM, "{model:?}: {reached_mm}");
        for (kind, size) in [
            (Disturbance::HardSpot, 1.5),
            (Disturbance::Gap, 1.0),
            (Disturbance::DepthStep, 0.5),
            (Disturbance::BrokenTooth, 1.0),
            (Disturbance::WearJump, 0.2),
            (Disturbance::ChatterBurst, 20.0),
        ] {
            let disturbed = rows(&with(&scenario, kind, size));
            let differs = |row: &&(&Row, &Row)| row.0.force_dyn_n != row.1.force_dyn_n;
            let pairs: Vec<(&Row, &Row)> = disturbed.iter().zip(&clean).collect();
            let first = pairs.iter().find(differs).map(|(row, _)| row.position_mm);
            // The teeth meet it before the axis does, by a radius at most.
            let met = first.is_some_and(|x| (AT_MM - 8.0..AT_MM + LENGTH_MM).contains(&x));
            assert!(met, "{model:?} {kind:?}: {first:?}");
        }
    }
}

fn refused(scenario: &Scenario, path: &str, text: &str) -> String {
    let value = parse_value(path, text);
    let error = value.and_then(|value| scenario.clone().set(path, value)).unwrap_err();
    assert!(matches!(error, SettingError::Refused { .. }), "{error}");
    error.to_string()
}

#[test]
fn what_has_no_meaning_is_refused_with_the_field_the_value_and_what_is_allowed() {
    let scenario = steady();
    for (path, text, words) in [
        ("disturbances.hard_spots", "[[10.0, 5.0, 99.0]]", "factor from 0.2 to 5"),
        ("disturbances.hard_spots", "[[10.0, 5.0]]", "[position mm, length mm, factor]"),
        ("disturbances.gaps", "[[10.0, 0.0]]", "lengths from 0.1 to 20000 mm"),
        ("disturbances.gaps", "[[20.0, 1.0], [10.0, 1.0]]", "positions ascending"),
        ("disturbances.wear_jumps", "[[10.0, 2.0]]", "wear land from 0.01 to 1 mm"),
        ("disturbances.operator_overrides", "[[10.0, 5.0, 0.0]]", "override from 10 to 200 %"),
        (
            "disturbances.broken_teeth",
            "[[10.0], [20.0]]",
            "at most 1, one fewer than `tool.teeth`, 2",
        ),
        ("disturbances.depth_steps", "[[10.0, 5.0, 7.0]]", "at most 8 mm deep"),
    ] {
        let error = refused(&scenario, path, text);
        assert!(error.contains(path) && error.contains(words), "{error}");
    }
    let mut coarse = with(&scenario, Disturbance::ChatterBurst, 20.0);
    let error = refused(&coarse, "run.steps_per_control", "10");
    assert!(error.contains("disturbances.chatter_hz") && error.contains("166.7 Hz"), "{error}");
    coarse.set("disturbances.chatter_hz", Value::Float(100.0)).unwrap();
    coarse.set("run.steps_per_control", Value::Int(10)).unwrap();
    let coupled = load("machine-dynamics").unwrap();
    let error = refused(&coupled, "disturbances.broken_teeth", "[[10.0]]");
    assert!(error.contains("machine.coupled") && error.contains("every tooth"), "{error}");
}

#[test]
fn the_story_tells_what_begins_and_where_it_ends() {
    for (kind, size, begins, ends) in [
        (
            Disturbance::HardSpot,
            1.5,
            "A hard spot begins here: 1.5 times the force over 6.0 mm",
            Some("The hard spot ends here"),
        ),
        (Disturbance::Gap, 1.0, "A gap begins here: over 6.0 mm. The tool is in the air", None),
        (Disturbance::BrokenTooth, 1.0, "A tooth breaks here", None),
        (
            Disturbance::SensorDropout,
            1.0,
            "The sensor drops out here and reads 0 over 6.0 mm",
            Some("The sensor dropout ends here"),
        ),
        (
            Disturbance::Operator,
            60.0,
            "An operator's override begins here: 60 % of the feed over 6.0 mm",
            Some("The operator's override ends here"),
        ),
    ] {
        let scenario = with(&load("table3-5").unwrap(), kind, size);
        let run = Run::complete(&scenario, &Edits::none());
        let story = Story::of(&run, None);
        let told = |words: &str| story.events.iter().find(|event| event.sentence.contains(words));
        let all: Vec<&str> = story.events.iter().map(|event| event.sentence.as_str()).collect();
        let event = told(begins).unwrap_or_else(|| panic!("{begins}: {all:#?}"));
        assert!((event.position_mm - AT_MM).abs() < 0.1, "{kind:?} at {}", event.position_mm);
        if let Some(ends) = ends {
            assert_eq!(event.id, EventKind::Disturbance);
            let end = told(ends).unwrap_or_else(|| panic!("{ends}: {all:#?}"));
            assert!((end.position_mm - AT_MM - LENGTH_MM).abs() < 0.1);
        }
        // Not told before it is cut.
        let mut scan = steadycut_core::run::story::Scan::default();
        scan.extend(run.recording().rows());
        let early = Story::until(&run, &scan, 200, None);
        assert!(early.events.iter().all(|event| !event.sentence.contains(begins)), "{kind:?}");
    }
}
