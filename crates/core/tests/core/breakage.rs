//! What breaks a tooth in a run, what comes of it, and what scrap costs.

use steadycut_core::base::settings::Value;
use steadycut_core::blocks::control::ControllerKind;
use steadycut_core::blocks::cutting::breakage::BreaksBy;
use steadycut_core::models::disturbances::{Disturbance, Disturbances, Zone};
use steadycut_core::run::edits::{Edit, Edits};
use steadycut_core::run::one_run::{End, Run};
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::Scenario;
use steadycut_core::run::signals::flag;
use steadycut_core::run::story::Story;

/// A cut at constant feed: 430.41 mm/min at 1571 1/min and two teeth are 0.137 mm per tooth.
fn steady() -> Scenario {
    let mut scenario = load("table3-5").unwrap();
    scenario
        .change(|s| {
            s.controller.kind = ControllerKind::ConstantFeed;
            s.run.duration_s = 6.0;
        })
        .unwrap();
    scenario
}

fn run(scenario: &Scenario) -> Run {
    Run::complete(scenario, &Edits::none())
}

#[test]
fn a_chip_limit_above_the_cut_changes_nothing_and_one_below_breaks_tooth_after_tooth() {
    let whole = run(&steady());
    let above = run(&steady().with(|s| s.tool.chip_max_mm = 0.3).unwrap());
    assert_eq!(whole.recording().digest(), above.recording().digest());
    assert!(above.breakages().is_empty());
    // One broken tooth doubles the chip to 0.274 mm: within 0.3 it goes on, beyond 0.25 the tool goes.
    for (chip_max_mm, ends) in [(0.3, false), (0.25, true)] {
        let mut scenario = steady().with(|s| s.tool.chip_max_mm = chip_max_mm).unwrap();
        let zone = Zone { at_mm: 20.0, length_mm: f64::INFINITY, size: 1.0 };
        let broken = scenario.disturbances.with(Disturbance::BrokenTooth, zone);
        scenario.set(Disturbance::BrokenTooth.path(), broken).unwrap();
        let run = run(&scenario);
        match (ends, run.end()) {
            (false, Some(End::TimeLimit)) => assert!(run.breakages().is_empty()),
            (true, Some(End::Breakage(broke))) => {
                assert_eq!((broke.by, broke.broken), (BreaksBy::Chip, 2));
                assert!((broke.load - 0.274).abs() < 0.002 && broke.stands == 0.25, "{broke:?}");
                assert!((broke.position_mm - 20.0).abs() < 0.1, "{broke:?}");
                let last = run.recording().rows().last().unwrap();
                assert!(last.position_mm < 20.1, "the rest is uncut");
            }
            (_, end) => panic!("{chip_max_mm}: {end:?}"),
        }
    }
    let weak = run(&steady().with(|s| s.tool.chip_max_mm = 0.1).unwrap());
    let times: Vec<f64> = weak.breakages().iter().map(|broke| broke.time_s).collect();
    assert_eq!(times.len(), 2);
    // Not two in one turn of 38 ms.
    assert!(times[1] - times[0] >= 60.0 / 1571.0 - 1e-9, "{times:?}");
}

#[test]
fn a_force_limit_breaks_a_tooth_in_a_hard_spot_and_the_run_goes_on() {
    let mut scenario = steady();
    let force_n = run(&scenario).recording().rows()[3000].force_n;
    let zone = Zone { at_mm: 20.0, length_mm: 0.2, size: 3.0 };
    let spot = scenario.disturbances.with(Disturbance::HardSpot, zone);
    scenario.set(Disturbance::HardSpot.path(), spot).unwrap();
    scenario.set("tool.force_max_n", Value::Float(2.5 * force_n)).unwrap();
    let run = run(&scenario);
    assert_eq!(run.end(), Some(&End::TimeLimit));
    let [broke] = run.breakages() else { panic!("{:?}", run.breakages()) };
    assert_eq!((broke.by, broke.broken), (BreaksBy::Force, 1));
    assert!((broke.load / force_n - 3.0).abs() < 0.01, "{broke:?}");
    // Behind the spot the force is that of the one tooth that is left: 2^0.86 times as large.
    let last = run.recording().rows().last().unwrap();
    assert!((last.force_n / force_n - 1.81504).abs() < 1e-3, "{}", last.force_n / force_n);
    let story = Story::of(&run, None);
    let told: Vec<&str> = story.events.iter().map(|event| event.sentence.as_str()).collect();
    assert!(
        told.iter().any(|told| told.to_lowercase().contains("a tooth breaks here")),
        "{told:#?}"
    );
}

#[test]
fn a_broken_tooth_is_whole_again_before_it_broke() {
    let scenario = steady().with(|s| s.tool.chip_max_mm = 0.3).unwrap();
    let mut edits = Edits::none();
    let weaker = Edit { at_s: 3.0, path: "tool.chip_max_mm".to_owned(), value: Value::Float(0.12) };
    edits.push(&scenario, weaker).unwrap();
    let mut run = Run::complete(&scenario, &edits);
    assert!(matches!(run.end(), Some(End::Breakage(_))), "{:?}", run.end());
    run.branch(1.0, &Edits::none());
    run.advance(u64::MAX);
    assert!(run.breakages().is_empty());
    assert_eq!(
        run.recording().digest(),
        Run::complete(&scenario, &Edits::none()).recording().digest()
    );
}

#[test]
fn with_a_machine_in_the_cut_the_first_tooth_is_the_tool() {
    let mut scenario = load("machine-dynamics").unwrap();
    scenario.set("tool.chip_max_mm", Value::Float(0.01)).unwrap();
    let run = run(&scenario);
    let Some(End::Breakage(broke)) = run.end() else { panic!("{:?}", run.end()) };
    assert_eq!(broke.broken, 1);
}

#[test]
fn a_broken_tooth_costs_the_whole_tool_and_stands_in_every_row_after_it() {
    let whole = run(&steady());
    assert!(whole.metrics().cut_cost < 1.0, "{:?}", whole.metrics());
    let mut scenario = steady();
    scenario.set("tool.teeth", Value::Int(4)).unwrap();
    scenario.set("tool.chip_max_mm", Value::Float(0.05)).unwrap();
    let broke = run(&scenario);
    let at_s = broke.breakages()[0].time_s;
    for row in broke.recording().rows() {
        if row.time_s != at_s {
            assert_eq!(row.has(flag::TOOTH_BROKEN), row.time_s > at_s, "{}", row.time_s);
        }
    }
    let minutes = broke.metrics().time_of_cut_s / 60.0;
    assert!((broke.metrics().cut_cost - (20.0 + minutes)).abs() < 1e-9);
}

#[test]
fn in_the_scenarios_for_lessons_the_cutter_breaks_where_its_feed_is_turned_up_four_times() {
    let mut scenario = load("disturbed-cut").unwrap();
    scenario.change(|s| s.disturbances = Disturbances::default()).unwrap();
    scenario.set("controller.kind", Value::Text("constant_feed".to_owned())).unwrap();
    assert!(run(&scenario).breakages().is_empty());
    scenario.set("program.feed_mm_min", Value::Float(1900.0)).unwrap();
    let broke = run(&scenario);
    assert!(!broke.breakages().is_empty(), "{:?}", broke.end());
}

#[test]
fn scrap_is_the_length_that_is_too_rough_and_costs_by_the_millimetre() {
    let mut scenario = steady();
    // Some 430 mm/min leave a rougher surface than 0.81 um: all is scrap but what is within the tolerance.
    let rough = run(&scenario).metrics();
    let judged = run(&scenario);
    let rows = judged.recording().rows();
    let by_hand: f64 = rows
        .windows(2)
        .filter(|pair| {
            pair[1].ra_um > 1.001 * 0.81 && {
                let off = (pair[1].ra_um - 0.81).abs();
                off > scenario.target.tolerance_percent / 100.0 * 0.81
            }
        })
        .map(|pair| pair[1].position_mm - pair[0].position_mm)
        .sum();
    assert!(rough.scrap_mm > 10.0 && (rough.scrap_mm - by_hand).abs() < 1e-6, "{rough:?}");
    assert!((rough.scrap_cost - 0.1 * rough.scrap_mm).abs() < 1e-12);
    assert!((rough.cut_cost - 6.0 / 60.0).abs() < 1e-9, "a minute costs 1: {}", rough.cut_cost);
    scenario.set("economics.scrap_cost_per_mm", Value::Float(2.0)).unwrap();
    let dear = run(&scenario);
    assert!((dear.metrics().scrap_cost - 2.0 * rough.scrap_mm).abs() < 1e-9);
    assert_eq!(dear.recording().digest(), judged.recording().digest(), "it only judges");
    // Smoother than asked is no scrap.
    scenario.set("target.ra_um", Value::Float(3.0)).unwrap();
    let smooth = run(&scenario).metrics();
    assert_eq!(smooth.scrap_mm, 0.0, "{smooth:?}");
}
