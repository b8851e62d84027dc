//! UNKS from a cold start, its networks carried from pass to pass, and networks in a scenario.

use steadycut_core::base::settings::Value;
use steadycut_core::models::unks::{Stored, StoredNetworks, UnksNetworks, UnksStart};
use steadycut_core::run::edits::Edits;
use steadycut_core::run::job::Job;
use steadycut_core::run::one_run::Run;
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::Scenario;
use steadycut_core::run::{scenario_file, scenario_link};
use steadycut_study::unks_passes::{
    MAX_PASSES, Pass, Passes, REFERENCE, beginning_anew, beginning_with, learned,
};

fn experiment_2(start: UnksStart) -> Scenario {
    let mut scenario = load("experiment-2").unwrap();
    scenario.set_all(&beginning_anew(start)).unwrap();
    scenario
}

/// The beginning of Experiment 2: enough to learn from.
fn short(start: UnksStart) -> Scenario {
    let mut scenario = experiment_2(start);
    scenario.change(|s| s.run.duration_s = 8.0).unwrap();
    scenario
}

fn complete(scenario: &Scenario, passes: u32) -> Passes {
    let mut job = Passes::new(scenario, passes);
    while !job.advance_by(500) {}
    job
}

fn error(pass: &Pass) -> f64 {
    pass.normalized_standard_error.unwrap()
}

#[test]
fn from_a_cold_start_five_passes_hand_over_from_the_feedback_to_the_inverse_model() {
    let passes = complete(&experiment_2(UnksStart::Cold), 5);
    let verdict = passes.verdict().unwrap();
    assert!(verdict.feedback_falls, "{:?}", passes.done());
    assert!(verdict.error_better && verdict.error_gain >= 0.15, "{verdict:?}");
    assert!(!verdict.unchanged);
    // The reference has other noise and other first weights.
    let [_, first, fifth] = REFERENCE;
    for (pass, [reference, time_s]) in [(&passes.done()[0], first), (&passes.done()[4], fifth)] {
        assert!((error(pass) - reference).abs() <= 0.01, "{pass:?}");
        assert!((pass.time_of_cut_s - time_s).abs() <= 1.0, "{pass:?}");
    }
    for (fraction, reference) in
        passes.done()[4].feedback_by_quarter.iter().zip([0.054, 0.093, 0.076, 0.060])
    {
        assert!((fraction - reference).abs() <= 0.01, "{fraction} {reference}");
    }
}

#[test]
fn with_the_rate_at_zero_nothing_is_learned_and_the_scheme_is_the_division_controller() {
    let mut scenario = short(UnksStart::Cold);
    scenario.change(|s| s.controller.unks.cold_rate = 0.0).unwrap();
    let passes = complete(&scenario, 2);
    let [first, second] = passes.done() else { panic!("two passes") };
    assert_eq!(Pass { number: 2, ..first.clone() }, *second);
    let verdict = passes.verdict().unwrap();
    assert!(verdict.unchanged && !verdict.error_better && !verdict.feedback_falls);
    let untrained = UnksNetworks::at_start(UnksStart::Cold, 1);
    assert_eq!(passes.learned().unwrap().networks, untrained);
    scenario.set("controller.kind", Value::Text("division".to_owned())).unwrap();
    let division = Run::complete(&scenario, &Edits::none()).metrics();
    let apart = error(first) / division.normalized_standard_error.unwrap() - 1.0;
    assert!(apart.abs() < 0.03, "{apart}");
}

#[test]
fn a_pass_is_a_scenario_that_can_be_saved_and_run_again() {
    for start in [UnksStart::Cold, UnksStart::Shipped] {
        let scenario = short(start);
        let two = complete(&scenario, 2);
        let one = complete(&scenario, 1);
        let saved = one.learned().unwrap().write();
        let stored = Stored::parse(&saved).unwrap();
        assert_ne!(stored.networks.inverse, UnksNetworks::at_start(start, 1).inverse);
        assert_eq!(
            stored.networks.forward == UnksNetworks::shipped().forward,
            start == UnksStart::Cold
        );

        let mut second = scenario.clone();
        second.set_all(&beginning_with(&stored)).unwrap();
        // Through file and link, to the bit.
        let text = scenario_file::write(&second, &Edits::none());
        let (second, _) = scenario_file::parse(&text).unwrap();
        let link = scenario_link::write(&second, &Edits::none());
        assert!(link.len() < 16_000, "{} bytes", link.len());
        let (mut second, _) = scenario_link::parse(&link).unwrap();
        assert_eq!(second.controller.unks.networks.get(), Some(&stored));
        let again = complete(&second, 1);
        assert_eq!(Pass { number: 2, ..again.done()[0].clone() }, two.done()[1]);
        assert_eq!(again.learned().unwrap().networks, two.learned().unwrap().networks);

        // Where the scheme stops learning, it stays what it was.
        second.change(|s| s.controller.unks.cold_rate = 0.0).unwrap();
        second
            .change(|s| {
                (s.controller.unks.forward_rate, s.controller.unks.inverse_rate) = (0.0, 0.0)
            })
            .unwrap();
        let run = Run::complete(&second, &Edits::none());
        assert_eq!(learned(&run, 1).unwrap().networks, stored.networks);
    }
}

#[test]
fn slices_change_nothing() {
    let scenario = short(UnksStart::Cold);
    let whole = complete(&scenario, 2);
    let mut sliced = Passes::new(&scenario, 2);
    let mut progress = 0.0;
    while !sliced.advance_by(37) {
        assert!((progress..1.0).contains(&sliced.progress().share()) && sliced.verdict().is_none());
        progress = sliced.progress().share();
    }
    assert_eq!(sliced.done(), whole.done());
    assert_eq!(sliced.learned(), whole.learned());
}

#[test]
fn networks_are_refused_by_field_and_where_they_do_not_belong() {
    let mut scenario = short(UnksStart::Shipped);
    let before = scenario.clone();
    let mut refused = |text: &str| {
        let value = Value::Text(text.to_owned());
        scenario.set("controller.unks.networks", value).unwrap_err().to_string()
    };
    let error = refused("{\"version\": 1}");
    assert!(error.contains("`controller.unks.networks`") && error.contains("`start`"), "{error}");
    assert!(refused("x").contains("not JSON"));
    let cold = complete(&short(UnksStart::Cold), 1);
    let error = refused(&cold.learned().unwrap().write());
    assert!(error.contains("networks of the start `cold`") && error.contains("shipped"), "{error}");
    assert_eq!(scenario, before);
    scenario.set_all(&beginning_with(cold.learned().unwrap())).unwrap();
    let error = scenario.set("controller.unks.start", Value::Text("shipped".to_owned()));
    assert!(error.unwrap_err().to_string().contains("set both together"));
    scenario.set_all(&beginning_anew(UnksStart::Shipped)).unwrap();
    assert_eq!(scenario, before);
    assert_eq!(StoredNetworks::default(), scenario.controller.unks.networks);
}

#[test]
fn bad_inputs_are_contained() {
    let mut scenario = short(UnksStart::Cold);
    // A limit of zero passes, or of too many, is moved to the nearest that can be done.
    scenario.change(|s| s.run.duration_s = 0.1).unwrap();
    assert_eq!(complete(&scenario, 0).done().len(), 1);
    assert_eq!(complete(&scenario, u32::MAX).done().len(), MAX_PASSES as usize);
    // In the air there is nothing to judge.
    assert_eq!(complete(&scenario, 2).verdict(), None);
    // The largest rate does not spoil the run.
    let mut scenario = short(UnksStart::Cold);
    scenario.change(|s| s.controller.unks.cold_rate = 0.1).unwrap();
    let passes = complete(&scenario, 2);
    assert!(passes.done().iter().all(|pass| error(pass).is_finite() && pass.feedback.is_finite()));
}
