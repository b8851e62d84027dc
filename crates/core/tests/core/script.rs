//! A controller of one's own as a script: the same bits as the built-in law that it repeats, and a clear end where it
//! fails.

use steadycut_core::base::settings::Value;
use steadycut_core::blocks::control::script::{MAX_STEPS, TEMPLATES};
use steadycut_core::run::edits::{Edit, Edits};
use steadycut_core::run::end::End;
use steadycut_core::run::one_run::Run;
use steadycut_core::run::presets;
use steadycut_core::run::scenario::Scenario;
use steadycut_core::run::signals::flag;
use steadycut_core::run::{scenario_file, scenario_link};

fn with(code: &str, numbers: [f64; 2]) -> Scenario {
    let mut scenario = presets::load("table3-5-noise").unwrap();
    let text = |text: &str| Value::Text(text.to_owned());
    let sets = [
        ("controller.kind", text("script")),
        ("controller.script.code", text(code)),
        ("controller.script.a", Value::Float(numbers[0])),
        ("controller.script.b", Value::Float(numbers[1])),
        ("run.duration_s", Value::Float(6.0)),
    ];
    for (path, value) in sets {
        scenario.set(path, value).unwrap_or_else(|error| panic!("{path}: {error}"));
    }
    scenario
}

fn template(name: &str) -> &'static str {
    TEMPLATES.iter().find(|(known, _)| *known == name).unwrap().1
}

/// What moves the machine, to the bit, over a run.
fn bits(scenario: &Scenario, edits: &Edits) -> Vec<[u64; 3]> {
    let run = Run::complete(scenario, edits);
    assert_eq!(run.end(), Some(&End::TimeLimit));
    let rows = run.recording().rows().iter();
    rows.map(|row| {
        [row.feed_command_mm_min, row.spindle_command_rpm, row.force_n].map(f64::to_bits)
    })
    .collect()
}

#[test]
fn the_law_of_2007_as_a_script_is_the_built_in_one_to_the_bit() {
    let script = with(template("SDNRP"), [0.7, 0.0]);
    let mut built_in = script.clone();
    built_in.set("controller.kind", Value::Text("sdnrp".to_owned())).unwrap();
    built_in.set("controller.sdnrp.kp", Value::Float(0.7)).unwrap();
    let [script_run, built_in_run] =
        [&script, &built_in].map(|one| Run::complete(one, &Edits::none()));
    assert_eq!(bits(&script, &Edits::none()), bits(&built_in, &Edits::none()));
    // Whether the models hold is told of a script as well.
    let outside = |run: &Run| {
        let rows = run.recording().rows().iter();
        rows.filter(|row| row.has(flag::K2_OUTSIDE | flag::K3_OUTSIDE)).count()
    };
    assert_eq!(outside(&script_run), outside(&built_in_run));
    // A force that no model knows: far outside.
    let far = "fn update(now) { let f = now.models.feed(9000.0); 50.0 }";
    assert!(outside(&Run::complete(&with(far, [0.0, 0.0]), &Edits::none())) > 0);
}

/// The mean force over its reference in the last second.
fn at_rest(run: &Run) -> f64 {
    let rows = run.recording().rows();
    let last = &rows[rows.len() - 1000..];
    last.iter().map(|row| row.force_n / row.force_ref_n).sum::<f64>() / 1000.0
}

#[test]
fn the_integral_of_pi_holds_the_force_and_p_leaves_an_error() {
    let run = |name: &str, numbers: [f64; 2]| {
        let mut scenario = with(template(name), numbers);
        scenario.set("noise.level", Value::Float(0.0)).unwrap();
        scenario.set("cnc.override_quantised", Value::Bool(false)).unwrap();
        // Far from the feed that the reference asks for.
        scenario.set("program.feed_mm_min", Value::Float(250.0)).unwrap();
        Run::complete(&scenario, &Edits::none())
    };
    let [p, pi] = [run("P", [0.5, 0.0]), run("PI", [0.2, 0.3])];
    assert!((at_rest(&pi) - 1.0).abs() < 0.003, "{}", at_rest(&pi));
    let [of_p, of_pi] = [&p, &pi].map(|run| (at_rest(run) - 1.0).abs());
    assert!(of_p > 3.0 * of_pi && of_p > 0.004, "{of_p} of P, {of_pi} of PI");
}

/// The end of a run of a script, with the line and the rows before it.
fn fault(code: &str) -> (Option<usize>, String, f64, usize) {
    let run = Run::complete(&with(code, [0.0, 0.0]), &Edits::none());
    let Some(End::Script(fault)) = run.end() else { panic!("{code}: {:?}", run.end()) };
    let rows = run.recording().rows();
    assert!(rows.iter().all(|row| row.force_n.is_finite()), "{code}");
    (fault.problem.line, fault.problem.what.clone(), fault.time_s, rows.len())
}

#[test]
fn a_script_that_fails_ends_the_run_with_its_line_and_what_was_recorded_stays() {
    let (_, what, time_s, rows) = fault(
        "fn init(start) { #{ n: 0 } }\nfn update(now) {\n  this.n += 1;\n  if this.n > 50 { loop { this.n += 1; } }\n  80.0\n}",
    );
    assert!(what.contains(&format!("more than {MAX_STEPS} steps")), "{what}");
    // At the fifty-first control sample, 20 ms apart from 0 on.
    assert!((time_s - 1.0).abs() < 1e-9, "{time_s}");
    assert!((999..=1001).contains(&rows), "{rows}");
    let (_, what, time_s, _) = fault("fn update(now) { 0.0 / 0.0 }");
    assert!(what.contains("NaN") && time_s == 0.0, "{what}");
    let (_, what, ..) = fault("fn update(now) { #{ feed: 80.0 } }");
    assert!(what.contains("`feed`") && what.contains("feed_percent"), "{what}");
    let (_, what, ..) = fault("fn update(now) { \"fast\" }");
    assert!(what.contains("allowed is a number"), "{what}");
    let (line, what, ..) = fault("fn update(now) {\n  let x = now.no_such + 1.0;\n  80.0\n}");
    assert!(line == Some(2) && !what.is_empty(), "{line:?} {what}");
    let (line, ..) = fault("fn init(start) {\n  throw \"no\"; }\nfn update(now) { 80.0 }");
    assert_eq!(line, Some(2));
    let (_, what, ..) = fault("fn update(now) { let x = []; loop { x.push(1.0); } }");
    assert!(!what.is_empty());
}

#[test]
fn another_script_is_taken_over_in_the_running_cut() {
    let scenario = with("fn update(now) { 80.0 }", [0.0, 0.0]);
    let code =
        "fn init(start) { #{ from: start.feed_percent } }\nfn update(now) { this.from - 10.0 }";
    let path = "controller.script.code".to_owned();
    let edit = Edit { at_s: 2.0, path, value: Value::Text(code.to_owned()) };
    let mut edits = Edits::none();
    edits.push(&scenario, edit).unwrap();
    let run = Run::complete(&scenario, &edits);
    let percent =
        |at_s: f64| run.recording().rows()[run.recording().index_at(at_s)].feed_override_percent;
    assert_eq!(percent(1.5), 80.0);
    assert_eq!(percent(3.0), 70.0, "what the machine ran at is known to the new one");
}

/// A number of its own is the same each time, and another one with another seed.
#[test]
fn chance_has_a_seed() {
    let code = |seed: u32| {
        format!(
            "fn init(start) {{ #{{ r: random({seed}) }} }}\nfn update(now) {{ 60.0 + 20.0 * this.r.next() }}"
        )
    };
    let of = |seed: u32| bits(&with(&code(seed), [0.0, 0.0]), &Edits::none());
    assert_eq!(of(1), of(1));
    assert_ne!(of(1), of(2));
}

#[test]
fn a_script_goes_into_files_and_links_and_a_wrong_one_is_refused_with_its_line() {
    for (_, code) in TEMPLATES {
        let scenario = with(code, [0.5, 0.1]);
        let text = scenario_file::write(&scenario, &Edits::none());
        assert_eq!(scenario_file::parse(&text).unwrap().0, scenario, "{text}");
        let link = scenario_link::write(&scenario, &Edits::none());
        assert_eq!(scenario_link::parse(&link).unwrap().0, scenario);
    }
    let mut scenario = presets::load("first-cut").unwrap();
    let wrong = Value::Text("fn update(now) {\n  now.\n}".to_owned());
    let said = scenario.set("controller.script.code", wrong).unwrap_err().to_string();
    assert!(said.contains("controller.script.code") && said.contains("line 3"), "{said}");
}
