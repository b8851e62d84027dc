//! The safe constant feed: against the formulas where they can be solved, and against true cuts elsewhere.

use steadycut_core::base::settings::Value;
use steadycut_core::run::constant_feed_twin::{self, BesideRun};
use steadycut_core::run::edits::{Edit, Edits};
use steadycut_core::run::job::Job;
use steadycut_core::run::one_run::{End, Run};
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::{Scenario, TwinKind, parse_value};
use steadycut_study::models::feed_speed::FeedSpeed;
use steadycut_study::safe_feed::trial::Broken;
use steadycut_study::safe_feed::{
    FEED_STEP_MM_MIN, SafeFeed, SafeFeedJob, SafeFeedProblem, SafeTwin, twin_scenario,
};

fn scenario(preset: &str, sets: &[(&str, &str)]) -> Scenario {
    let mut scenario = load(preset).unwrap();
    for (path, value) in sets {
        scenario.set(path, parse_value(path, value).unwrap()).unwrap();
    }
    scenario
}

fn solved(problem: SafeFeedProblem) -> SafeFeed {
    let mut search = SafeFeedJob::new(problem);
    search.to_end();
    search.partial().expect("a search that is over has an answer")
}

fn safe(part: &Scenario) -> SafeFeed {
    solved(SafeFeedProblem::new(part, Vec::new()))
}

fn found(part: &Scenario) -> SafeTwin {
    safe(part).found().unwrap_or_else(|| panic!("{:?}", safe(part)))
}

/// The whole part at a constant feed, cut and judged as any run: the share above the tolerance, percent, and the
/// time, s.
fn cut_at(part: &Scenario, feed_mm_min: f64) -> (f64, f64) {
    let at = FeedSpeed { feed_mm_min, speed_rpm: part.program.spindle_rpm };
    let mut twin = constant_feed_twin::scenario_at(part, at).unwrap();
    twin.set("run.duration_s", Value::Float(600.0)).unwrap();
    let run = Run::complete(&twin, &Edits::none());
    assert_eq!(run.end(), Some(&End::PathDone));
    let metrics = run.metrics();
    (metrics.above_tolerance_percent.unwrap(), metrics.time_of_cut_s)
}

/// Without noise and at one depth the feed is that whose force leaves the upper end of the tolerance: model 1 of that
/// Ra is the force, model 4 solved for the feed its feed.
#[test]
fn at_constant_depth_the_feed_is_the_one_that_the_formulas_give() {
    for (ra_um, speed) in [("0.81", "1571"), ("0.6", "2200"), ("1.2", "1571")] {
        let sets = [("target.ra_um", ra_um), ("program.spindle_rpm", speed), ("noise.level", "0")];
        let part = scenario("table3-5", &sets);
        let models = part.of_plant();
        let target = &part.target;
        let upper_um = target.ra_um * (1.0 + target.tolerance_percent / 100.0);
        let most_n = models.force_from_ra(upper_um).value;
        let speed_rpm = part.program.spindle_rpm;
        let exact = models.force.feed_for_force(most_n, speed_rpm, 5000.0, 300.0);
        assert!(exact.valid, "{exact:?}");
        let SafeTwin { feed_mm_min, spindle_rpm, time_of_cut_s } = found(&part);
        assert_eq!((feed_mm_min, spindle_rpm), (exact.value.floor(), speed_rpm), "{exact:?}");
        let straight_s = 60.0 * part.workpiece.length_mm / feed_mm_min;
        assert!((time_of_cut_s - straight_s).abs() < 0.01, "{time_of_cut_s} {straight_s}");
        // A true cut agrees, and the next step of the feed breaks it.
        assert_eq!(cut_at(&part, feed_mm_min).0, 0.0);
        assert!(cut_at(&part, feed_mm_min + FEED_STEP_MM_MIN).0 > 99.0);
    }
}

/// In a machine that vibrates the surface with the vibration counts: of the feed that is called safe it is nowhere
/// rougher than allowed for longer than a blow lasts, of the next one it is.
#[test]
fn where_the_machine_vibrates_the_safe_feed_does_not_chatter() {
    let part = scenario("chatter", &[]);
    let safe = found(&part);
    let most_um = part.target.ra_um * (1.0 + part.target.tolerance_percent / 100.0);
    let rough_s = |feed_mm_min: f64| {
        let at = FeedSpeed { feed_mm_min, speed_rpm: safe.spindle_rpm };
        let mut cut = constant_feed_twin::scenario_at(&part, at).unwrap();
        cut.set("run.duration_s", Value::Float(600.0)).unwrap();
        let run = Run::complete(&cut, &Edits::none());
        let (mut longest, mut now) = (0_u32, 0);
        for row in run.recording().rows() {
            now = if row.ra_dyn_um > most_um { now + 1 } else { 0 };
            longest = longest.max(now);
        }
        f64::from(longest) * run.recording().row_s()
    };
    assert!(rough_s(safe.feed_mm_min) <= 0.31, "{safe:?}: {} s", rough_s(safe.feed_mm_min));
    let next = safe.feed_mm_min + FEED_STEP_MM_MIN;
    let above = cut_at(&part, next).0 > 0.0;
    assert!(above || rough_s(next) > 0.29, "{safe:?}: {} s", rough_s(next));
}

#[test]
fn a_deeper_stretch_decides_for_the_whole_part() {
    let stepped = scenario("depth-step", &[]);
    let deep = scenario(
        "depth-step",
        &[("workpiece.axial_depth_mm", "2.3"), ("workpiece.depth_steps", "[]")],
    );
    let shallow = scenario("depth-step", &[("workpiece.depth_steps", "[]")]);
    assert_eq!(found(&stepped).feed_mm_min, found(&deep).feed_mm_min);
    assert!(found(&shallow).feed_mm_min > 1.2 * found(&stepped).feed_mm_min);
    // The whole of it counts, however soon the run's time limit comes.
    let short = scenario("depth-step", &[("run.duration_s", "3")]);
    assert_eq!(found(&short), found(&stepped));
    let (above, time_s) = cut_at(&stepped, found(&stepped).feed_mm_min);
    assert_eq!((above, time_s), (0.0, found(&stepped).time_of_cut_s));
    assert!(cut_at(&stepped, found(&stepped).feed_mm_min + FEED_STEP_MM_MIN).0 > 1.0);
}

/// More depth, harder material, more wear or a finer target never allow a larger feed.
#[test]
fn what_makes_the_cut_harder_never_allows_more() {
    for (path, values) in [
        ("workpiece.axial_depth_mm", ["1.6", "1.9", "2.0", "2.2", "2.35"]),
        ("plant.hardness_hb", ["180", "200", "205", "210", "220"]),
        ("plant.wear_factor", ["1.0", "1.02", "1.05", "1.1", "1.15"]),
        ("target.ra_um", ["1.4", "1.2", "1.0", "0.81", "0.7"]),
        ("target.tolerance_percent", ["20", "15", "10", "5", "1"]),
    ] {
        let feeds = values.map(|value| found(&scenario("table3-5", &[(path, value)])).feed_mm_min);
        assert!(feeds.windows(2).all(|pair| pair[0] > pair[1]), "{path}: {feeds:?}");
    }
}

#[test]
fn where_no_feed_is_safe_it_is_said_and_the_programmed_one_stands_in_its_place() {
    // Below 70 mm/min the force of model 4 does not fall any more, and so deep it is too large.
    let part = scenario("table3-5", &[("workpiece.axial_depth_mm", "4")]);
    let SafeFeed::NoneHolds(none) = safe(&part) else { panic!("{:?}", safe(&part)) };
    assert_eq!((none.least_feed_mm_min, none.spindle_rpm), (10.0, 1571.0));
    assert!(matches!(none.broken, Broken::Above { of_ra: true, .. }), "{none:?}");
    let told = none.to_string();
    assert!(told.contains("no constant feed is safe") && told.contains("rougher"), "{told}");
    let twin = twin_scenario(&part, Some(&SafeFeed::NoneHolds(none)));
    let limit_s = twin.run.duration_s;
    let programmed = constant_feed_twin::scenario(&part);
    assert_eq!(twin, programmed.with(|settings| settings.run.duration_s = limit_s).unwrap());
    assert_eq!(twin.twin.kind, TwinKind::Programmed, "it does not pass for the safe one");
    // A feed that stops is none either.
    let sets = [("cnc.force_stop", "true"), ("cnc.force_stop_n", "50")];
    let SafeFeed::NoneHolds(none) = safe(&scenario("table3-5", &sets)) else { panic!("it stops") };
    assert!(matches!(none.broken, Broken::Ends(_)), "{none:?}");
}

/// A twin that is slower than the cut has the time to do all of the way, or it would be compared without its end.
#[test]
fn a_twin_has_the_time_to_cut_the_whole_part() {
    let mut short = scenario("first-cut", &[]);
    short.set("run.duration_s", Value::Float(20.0)).unwrap();
    let found = safe(&short);
    let cut = Run::complete(&short, &Edits::none());
    let mut beside = BesideRun::of(&cut, &twin_scenario(&short, Some(&found)));
    beside.to_end();
    assert_eq!(cut.end(), Some(&End::TimeLimit));
    assert_eq!(beside.twin().end(), Some(&End::PathDone));
    assert!(beside.twin().metrics().time_of_cut_s > 20.0);
    // The longest way at the least feed stays within what a run may be.
    let mut slow = scenario("table3-5", &[("workpiece.length_mm", "1000")]);
    slow.set("program.feed_mm_min", Value::Float(10.0)).unwrap();
    assert!(twin_scenario(&slow, None).run.duration_s <= 3600.0);
}

/// What is changed during the run counts where it happens: a finer target in the deeper stretch decides.
#[test]
fn a_change_during_the_run_is_met_at_its_place() {
    let part = scenario("depth-step", &[]);
    let mut edits = Edits::none();
    let finer = Edit { at_s: 12.0, path: "target.ra_um".to_owned(), value: Value::Float(0.6) };
    edits.push(&part, finer).unwrap();
    let run = Run::complete(&part, &edits);
    let with = solved(SafeFeedProblem::of(&run)).found().unwrap();
    assert!(with.feed_mm_min < found(&part).feed_mm_min - 5.0, "{with:?}");
    // The twin that is drawn meets it at the same place and holds.
    let mut beside = BesideRun::of(&run, &twin_scenario(&part, Some(&SafeFeed::Found(with))));
    beside.to_end();
    let metrics = beside.twin().metrics();
    assert_eq!(metrics.above_tolerance_percent, Some(0.0));
    assert_eq!(beside.twin().edits().list().len(), 1);
    // What only the controller knows changes nothing.
    let mut own = Edits::none();
    let path = "controller.kind".to_owned();
    let other = Edit { at_s: 5.0, path, value: Value::Text("constant_feed".to_owned()) };
    own.push(&part, other).unwrap();
    let problem = SafeFeedProblem::of(&Run::complete(&part, &own));
    assert_eq!(problem, SafeFeedProblem::new(&part, Vec::new()));
}

/// The answer is about the part: whichever controller stands in the scenario, it is the same problem.
#[test]
fn the_problem_is_that_of_the_part_alone() {
    let of = |sets: &[(&str, &str)]| SafeFeedProblem::new(&scenario("depth-step", sets), vec![]);
    for sets in [
        [("controller.kind", "sdnrp"), ("controller.sdnrp.kp", "3")],
        [("twin.kind", "programmed"), ("name", "another")],
    ] {
        assert_eq!(of(&sets), of(&[]), "{sets:?}");
    }
    for sets in [("run.seed", "7"), ("twin.free_speed", "true"), ("plant.wear_factor", "1.1")] {
        assert_ne!(of(&[sets]), of(&[]), "{sets:?}");
    }
}

/// Tooth by tooth the material's inhomogeneity moves what is judged: another draw of it allows another feed, and some
/// take their share.
#[test]
fn noise_counts_where_it_moves_what_is_judged() {
    let cut = [("workpiece.cuts", "[[[4.0, 3.0, 2.0]]]")];
    let of = |more: &[(&str, &str)]| found(&scenario("experiment-2", &[&cut[..], more].concat()));
    let quiet = of(&[("noise.level", "0")]);
    let noisy = ["1", "2", "3", "4"].map(|seed| {
        of(&[("noise.level", "1"), ("noise.inhomogeneity_percent", "8"), ("run.seed", seed)])
    });
    assert!(
        noisy.iter().any(|one| one.feed_mm_min < quiet.feed_mm_min - 5.0),
        "{noisy:?} {quiet:?}"
    );
    assert!(noisy[1..].iter().any(|one| one.feed_mm_min != noisy[0].feed_mm_min), "{noisy:?}");
    // In a map it moves what is sensed alone.
    let map = |level: &str| found(&scenario("depth-step", &[("noise.level", level)]));
    assert_eq!(map("2"), map("0"));
}

#[test]
fn at_any_speed_it_takes_no_more_time() {
    let programmed = found(&scenario("depth-step", &[]));
    let free = found(&scenario("depth-step", &[("twin.free_speed", "true")]));
    assert!(free.time_of_cut_s < programmed.time_of_cut_s, "{free:?} {programmed:?}");
    assert_eq!(programmed.spindle_rpm, 1571.0);
    let mut at_its_speed = scenario("depth-step", &[]);
    at_its_speed.set("program.spindle_rpm", Value::Float(free.spindle_rpm)).unwrap();
    assert_eq!(found(&at_its_speed), free, "it is the safe feed at its speed");
}
