//! The milling simulator of 2005 and its force controllers against reference figures: noise-free
//! runs of Experiment 2, from an independent implementation of the same equations.

use std::sync::LazyLock;

use steadycut_core::base::settings::Value;
use steadycut_core::blocks::control::ControllerKind;
use steadycut_core::blocks::control::mrac::Adapted;
use steadycut_core::run::edits::Edits;
use steadycut_core::run::job::Job;
use steadycut_core::run::metrics::Metrics;
use steadycut_core::run::one_run::{End, Run};
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::Scenario;
use steadycut_study::compare::claims::{self, Evidence};
use steadycut_study::compare::entrants::{self, Entrant};
use steadycut_study::compare::iterations::IterationsJob;
use steadycut_study::compare::load_step::{self, Transient};
use steadycut_study::compare::outcome::Measure;
use steadycut_study::compare::table_1;
use steadycut_study::compare::tournament::{Compared, Tournament};
use steadycut_study::verdict::Verdict;

fn experiment_2(controller: &str) -> Scenario {
    let mut scenario = load("experiment-2").unwrap();
    scenario.change(|s| s.noise.level = 0.0).unwrap();
    // Rows are only needed once in a control period.
    scenario.change(|s| s.run.record_every = s.run.steps_per_control).unwrap();
    scenario.set("controller.kind", Value::Text(controller.to_owned())).unwrap();
    scenario
}

fn run(scenario: &Scenario) -> Metrics {
    let run = Run::complete(scenario, &Edits::none());
    assert_eq!(run.end(), Some(&End::PathDone));
    run.metrics()
}

/// Dense Nsn, time in s and largest force in kN within the tolerances of the reference figures.
fn agrees(metrics: &Metrics, nsn: f64, time_s: f64, force_kn: f64) {
    let found = metrics.normalized_standard_error.unwrap();
    assert!((found - nsn).abs() <= 0.005, "Nsn {found} against {nsn}");
    assert!((metrics.time_of_cut_s - time_s).abs() <= 0.3, "{} s", metrics.time_of_cut_s);
    let force = metrics.max_force_n / 1000.0;
    assert!((force / force_kn - 1.0).abs() <= 0.02, "{force} kN against {force_kn}");
}

#[test]
fn conventional_milling_agrees() {
    agrees(&run(&experiment_2("constant_feed")), 0.3529, 115.00, 1.373);
}

#[test]
fn the_divisional_controller_agrees() {
    agrees(&run(&experiment_2("division")), 0.2246, 96.70, 1.063);
}

#[test]
fn the_p_controller_agrees() {
    agrees(&run(&experiment_2("p")), 0.2286, 98.36, 1.028);
}

#[test]
fn the_adjustable_pi_controller_agrees() {
    agrees(&run(&experiment_2("adjustable_pi")), 0.1668, 88.58, 1.041);
}

#[test]
fn mrac_agrees_in_what_its_bursts_leave_alone() {
    // The five-parameter form is chaotic: the reference runs differ by as much among themselves.
    let five = run(&experiment_2("mrac"));
    let error = five.normalized_standard_error.unwrap();
    assert!((error / 0.2415 - 1.0).abs() < 0.1, "{five:?}");
    assert!((five.max_force_n / 1179.0 - 1.0).abs() < 0.1, "{five:?}");
    assert!((five.time_of_cut_s / 96.34 - 1.0).abs() < 0.1, "{five:?}");
    let mut scenario = experiment_2("mrac");
    scenario.change(|s| s.controller.mrac.adapted = Adapted::Gain).unwrap();
    let one = run(&scenario);
    assert!((one.normalized_standard_error.unwrap() - 0.170).abs() < 0.01, "{one:?}");
    assert!((one.time_of_cut_s - 88.5).abs() < 1.0, "{one:?}");
}

/// On the plant that the paper draws, the force a map of feed and engagement; the figures are those of
/// an independent implementation with another network and other noise, means of three seeds.
#[test]
fn on_the_neural_plant_the_methods_stand_as_in_the_reference() {
    let reference = [
        (ControllerKind::ConstantFeed, 0.345, 115.0, 1.43),
        (ControllerKind::Division, 0.234, 98.9, 1.06),
        (ControllerKind::Proportional, 0.234, 100.3, 0.985),
        (ControllerKind::AdjustablePi, 0.189, 91.8, 0.87),
        (ControllerKind::Mrac, 0.201, 92.5, 0.906),
        (ControllerKind::Unks, 0.186, 91.9, 0.81),
    ];
    let mut scenario = load("experiment-2-neural").unwrap();
    for (kind, nsn, time_s, force_kn) in reference {
        scenario.change(|s| s.controller.kind = kind).unwrap();
        let mut means = [0.0; 3];
        for seed in 1..=3 {
            scenario.change(|s| s.run.seed = seed).unwrap();
            let found = run(&scenario);
            let error = found.normalized_standard_error.unwrap();
            let values = [error, found.time_of_cut_s, found.max_force_n / 1000.0];
            means.iter_mut().zip(values).for_each(|(mean, value)| *mean += value / 3.0);
        }
        for ((mean, expected), share) in
            means.iter().zip([nsn, time_s, force_kn]).zip([0.2, 0.04, 0.12])
        {
            assert!((mean / expected - 1.0).abs() <= share, "{kind:?}: {mean} against {expected}");
        }
    }
}

#[test]
fn the_ball_meets_sections_gradually_on_the_neural_plant_too() {
    let at = |force_model: &str| {
        let mut scenario = experiment_2("constant_feed");
        scenario.set("plant.force_model", Value::Text(force_model.to_owned())).unwrap();
        scenario
            .change(|s| s.workpiece.cuts = vec![vec![[30.0, 3.0, 2.0], [20.0, 4.75, 0.0]]])
            .unwrap();
        Run::complete(&scenario, &Edits::none())
    };
    let (by_teeth, neural) = (at("mechanistic"), at("neural"));
    // Where the force passes half of each section's, and where it leaves the part.
    let crossings = |run: &Run| {
        let rows = run.recording().rows();
        let rising =
            |force_n: f64| rows.iter().find(|row| row.force_n > force_n).unwrap().position_mm;
        let leaves = rows.iter().rfind(|row| row.force_n > 650.0).unwrap().position_mm;
        [rising(290.0), rising(960.0), leaves]
    };
    for (teeth, map) in crossings(&by_teeth).into_iter().zip(crossings(&neural)) {
        assert!((teeth - map).abs() < 1.5, "{teeth} mm against {map} mm");
    }
}

/// The controllers of 2007 and 2013 compute with models identified on this plant.
#[test]
fn sdnrp_and_tracking_hold_the_force_tooth_by_tooth() {
    let under = |controller: &str| {
        let mut scenario = load("experiment-1").unwrap();
        scenario
            .change(|s| {
                s.noise.level = 0.0;
                s.run.record_every = s.run.steps_per_control;
            })
            .unwrap();
        scenario.set("controller.kind", Value::Text(controller.to_owned())).unwrap();
        let metrics = run(&scenario);
        (metrics.normalized_standard_error.unwrap(), metrics.max_force_n, metrics.time_of_cut_s)
    };
    let (conventional, ..) = under("constant_feed");
    let (error, max_force_n, time_s) = under("sdnrp");
    assert!(
        error < 0.7 * conventional && max_force_n < 900.0,
        "{error} {max_force_n} N {time_s} s"
    );
    // As near as the controllers of 2005: UNKS leaves 0.12 here.
    let (error, max_force_n, time_s) = under("tracking");
    assert!(error < 0.13 && max_force_n < 850.0 && time_s < 27.0, "{error} {max_force_n} {time_s}");
}

#[test]
fn the_smith_predictor_calms_the_p_controller_at_a_long_dead_time() {
    let mut scenario = experiment_2("p");
    scenario
        .change(|s| {
            s.cnc.dead_time_s = 0.08;
            s.belief.dead_time_s = 0.08;
        })
        .unwrap();
    let plain = run(&scenario).max_force_n;
    scenario
        .change(|s| {
            s.controller.proportional.smith = true;
            s.controller.proportional.kp = 1.6;
        })
        .unwrap();
    let predicted = run(&scenario).max_force_n;
    assert!(plain > 1400.0, "it oscillates: {plain} N");
    assert!(predicted < 1050.0, "{predicted} N");
}

#[test]
fn slices_and_branches_change_nothing_tooth_by_tooth() {
    let mut scenario = experiment_2("adjustable_pi");
    scenario
        .change(|s| {
            s.run.duration_s = 30.0;
            s.noise.level = 1.0;
        })
        .unwrap();
    let whole = Run::complete(&scenario, &Edits::none());
    let mut sliced = Run::new(&scenario, &Edits::none());
    while !sliced.advance(70_001) {}
    assert_eq!(whole.recording().digest(), sliced.recording().digest());
    // Back to before the second cut and on again.
    sliced.branch(20.0, &Edits::none());
    sliced.advance(u64::MAX);
    assert_eq!(whole.recording().digest(), sliced.recording().digest());
}

#[test]
fn unks_agrees_with_the_networks_as_shipped() {
    let metrics = run(&experiment_2("unks"));
    let nsn = metrics.normalized_standard_error.unwrap();
    assert!((nsn - 0.1639).abs() <= 0.01, "Nsn {nsn}");
    assert!((metrics.time_of_cut_s - 88.18).abs() <= 1.0, "{} s", metrics.time_of_cut_s);
    assert!((metrics.max_force_n / 963.0 - 1.0).abs() <= 0.05, "{} N", metrics.max_force_n);
}

#[test]
fn unks_learns_while_it_cuts() {
    let learning = Run::complete(&experiment_2("unks"), &Edits::none());
    let mut scenario = experiment_2("unks");
    scenario
        .change(|s| (s.controller.unks.forward_rate, s.controller.unks.inverse_rate) = (0.0, 0.0))
        .unwrap();
    let fixed = Run::complete(&scenario, &Edits::none());
    assert_ne!(learning.recording().digest(), fixed.recording().digest());
}

fn played(entrants: Vec<Entrant>) -> Vec<Compared> {
    let mut tournament = Tournament::new(entrants, 1);
    tournament.to_end();
    tournament.table()
}

/// The six methods on Experiment 2, and their load steps: played once, by the first test to ask.
static METHODS: LazyLock<Vec<Entrant>> =
    LazyLock::new(|| entrants::on(&entrants::experiment_2(), &entrants::TABLE_1));
static TABLE: LazyLock<Vec<Compared>> = LazyLock::new(|| played(METHODS.clone()));
static TRANSIENTS: LazyLock<Vec<Transient>> =
    LazyLock::new(|| METHODS.iter().map(load_step::transient).collect());

#[test]
fn load_steps_of_2005_settle_as_in_the_reference() {
    let periods: Vec<Option<usize>> = TRANSIENTS.iter().map(|step| step.periods).collect();
    // Constant feed, division and P hold a steady offset; the reference has 33 and 6.
    assert_eq!(periods[..3], [None; 3]);
    assert!((25..=40).contains(&periods[3].unwrap()), "adjustable PI {periods:?}");
    assert!((4..=8).contains(&periods[5].unwrap()), "UNKS {periods:?}");
}

#[test]
fn table_1_of_2005_is_met_where_it_can_be() {
    let verdicts = table_1::verdicts(&TABLE);
    assert_eq!(verdicts.len(), 12);
    // A single seed: its largest force may lie a deviation of the seeds, some 5 %, beyond the bands.
    let (forces, others): (Vec<_>, Vec<_>) =
        verdicts.iter().partition(|verdict| verdict.band.contains("Largest force"));
    assert!(forces.len() == 2 && others.iter().all(|verdict| verdict.kept()), "{verdicts:#?}");
    let force_kn = |row: usize| TABLE[row].mean(Measure::Force);
    assert!((force_kn(0) / 1.4 - 1.0).abs() <= 0.1, "{} kN", force_kn(0));
    assert!(force_kn(5) <= 1.05 * 1.05, "{} kN", force_kn(5));
    // The cap of 150 % and 100 % on average leave the time no more room.
    let nsn = |method: &Compared| method.mean(Measure::Nsn);
    for method in TABLE.iter() {
        let time_s = method.mean(Measure::Time);
        assert!((76.7..=115.0).contains(&time_s), "{method:?}");
        assert!(nsn(&TABLE[0]) >= nsn(method), "{method:?}");
        assert_eq!(method.force_stops, 0, "{method:?}");
    }
    // Adjustable PI and UNKS are equal in error and time.
    let [pi, unks] = [&TABLE[3], &TABLE[5]];
    assert!((nsn(pi) / nsn(unks) - 1.0).abs() < 0.05, "{pi:?} {unks:?}");
    assert!((pi.mean(Measure::Time) - unks.mean(Measure::Time)).abs() < 1.0, "{pi:?} {unks:?}");
}

#[test]
fn the_claims_of_2005_are_told_as_found() {
    let mut heaviest = entrants::experiment_2();
    heaviest.change(|s| s.workpiece.cuts = vec![vec![[12.0, 3.0, 2.0], [9.0, 4.75, 0.0]]]).unwrap();
    let mut job = IterationsJob::new(&heaviest);
    job.to_end();
    let iterations_needed = job.partial().unwrap();
    assert!(iterations_needed <= 4, "{iterations_needed}");
    let claims = claims::claims(&Evidence {
        experiment_1: &played(claims::both_on("experiment-1")),
        experiment_2: &TABLE,
        transients: &TRANSIENTS,
        load_step_n: load_step::forces_n(&entrants::experiment_2()),
        iterations_needed,
    });
    let holds: Vec<bool> = claims.iter().map(|claim| claim.verdict == Verdict::Holds).collect();
    assert_eq!(holds, [false, true, true, false, false, false], "{claims:#?}");
}

#[test]
fn experiment_1_agrees_in_both_readings() {
    // Normalised error, time in s and largest force in kN, means over the seeds of the reference;
    // here one seed of other noise: controllers' times differ by some 0.3 s between seeds.
    let reference = [
        ("experiment-1", 0, [0.271, 32.44, 0.706]),
        ("experiment-1", 2, [0.178, 28.26, 0.710]),
        ("experiment-1", 5, [0.122, 25.17, 0.778]),
        ("experiment-1-sl", 0, [0.251, 32.4, 0.353]),
    ];
    for (preset, method, [nsn, time_s, force_kn]) in reference {
        let method = entrants::TABLE_1[method].on(&load(preset).unwrap());
        let found = &played(vec![method])[0];
        let what = format!("{preset}: {found:?}");
        assert!((found.mean(Measure::Nsn) - nsn).abs() <= 0.012, "{what}");
        assert!((found.mean(Measure::Time) - time_s).abs() <= 0.6, "{what}");
        assert!((found.mean(Measure::Force) / force_kn - 1.0).abs() <= 0.08, "{what}");
    }
}

#[test]
fn overload_stops_the_machine_for_good_and_says_why() {
    let mut scenario = experiment_2("constant_feed");
    scenario.change(|s| s.workpiece.cuts = vec![vec![[50.0, 3.0, 2.0], [40.0, 7.5, 0.0]]]).unwrap();
    let run = Run::complete(&scenario, &Edits::none());
    let Some(End::Overload(stop)) = run.end() else { panic!("{:?}", run.end()) };
    assert!(stop.force_n > 2000.0 && stop.force_n < 2100.0, "{stop:?}");
    // It advances by the braking path alone: 2 tau v = 0.27 mm, without the dead time.
    let last = run.recording().rows().last().unwrap();
    assert!(last.feed_mm_min < 0.5, "{last:?}");
    assert!(last.position_mm - stop.position_mm < 0.3, "{stop:?} {last:?}");
    assert!(stop.to_string().contains("allowed 2000 N"), "{stop}");
    scenario.change(|s| s.cnc.force_stop = false).unwrap();
    assert_eq!(Run::complete(&scenario, &Edits::none()).end(), Some(&End::PathDone));
}
