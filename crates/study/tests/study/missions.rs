//! Missions: every shipped one is failed by a wrong answer with a helpful word and passed by a right one; a file that
//! is wrong is refused where it is wrong.

use std::collections::BTreeSet;

use steadycut_core::base::settings::Value;
use steadycut_core::run::job::Job;
use steadycut_core::run::metrics::METRICS;
use steadycut_core::run::one_run::Run;
use steadycut_core::run::{edits::Edits, presets};
use steadycut_study::mission::shipped::{self, MISSIONS};
use steadycut_study::mission::{
    Marking, Mission, MissionAnswer, MissionVerdict, Prediction, QuestionKind, TEMPLATE,
};

fn marked(mission: &Mission, answer: MissionAnswer) -> MissionVerdict {
    let mut marking = Marking::new(mission, answer).unwrap_or_else(|error| panic!("{error}"));
    marking.to_end();
    marking.partial().unwrap()
}

fn answered(mission: &Mission, kind: &str) -> MissionVerdict {
    let path =
        format!("{}/tests/data/missions/{}.{kind}.toml", env!("CARGO_MANIFEST_DIR"), mission.id);
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    let answer =
        MissionAnswer::read(&text, mission).unwrap_or_else(|error| panic!("{path}: {error}"));
    marked(mission, answer)
}

#[test]
fn a_right_answer_passes_every_shipped_mission_and_a_wrong_one_is_helped() {
    let mut failed = Vec::new();
    for shipped in MISSIONS {
        let mission =
            shipped::load(shipped.id).unwrap_or_else(|error| panic!("{}: {error}", shipped.id));
        assert_eq!(mission.id, shipped.id);
        let idle = marked(&mission, MissionAnswer::untouched(&mission));
        let wrong = answered(&mission, "wrong");
        let right = answered(&mission, "right");
        let helped = wrong.words().any(|word| word.len() > 20);
        if idle.passed || wrong.passed || wrong.stars != 0 || !helped || right.stars != 3 {
            failed.push(format!("{}: {idle:#?} {wrong:#?} {right:#?}", shipped.id));
        }
    }
    assert!(failed.is_empty(), "{}", failed.join("\n\n"));
}

#[test]
fn every_shipped_mission_teaches_with_source_hints_and_words() {
    let mut titles = BTreeSet::new();
    for shipped in MISSIONS {
        let mission = shipped::load(shipped.id).unwrap();
        assert!(titles.insert(mission.title.clone()), "two are called {}", mission.title);
        assert!(!mission.hints.is_empty() && !mission.steps.is_empty(), "{}", mission.id);
        assert!(mission.questions().count() > 0, "{} predicts nothing", mission.id);
        assert!(!mission.debrief.source.is_empty(), "{} has no source", mission.id);
        for check in &mission.checks {
            assert!(check.otherwise.len() > 20, "{}: `{}` helps nobody", mission.id, check.when);
        }
        for (step, question) in mission.questions() {
            if let QuestionKind::Choice(options) = &question.kind {
                let helps = |word: &str| word.len() > 20 || question.otherwise.len() > 20;
                let known = marked(&mission, MissionAnswer::untouched(&mission));
                let solution = &known.predictions.iter().find(|p| p.step == step).unwrap().solution;
                assert!(!solution.is_empty(), "{}, step {step}: nothing is right", mission.id);
                for option in options.iter().filter(|option| !solution.contains(&option.text)) {
                    assert!(helps(&option.word), "{}, step {step}: {}", mission.id, option.text);
                }
            }
        }
    }
}

#[test]
fn the_template_is_a_mission_and_shows_an_answer_that_passes() {
    let mission = Mission::read(TEMPLATE).unwrap();
    // The answer stands at the end, as comments.
    let begin = TEMPLATE.find("# An answer to this mission").unwrap();
    let lines = TEMPLATE[begin..].lines().skip(2).map(|line| line.trim_start_matches('#'));
    let text: Vec<&str> = lines.collect();
    let answer = MissionAnswer::read(&text.join("\n"), &mission).unwrap();
    let verdict = marked(&mission, answer);
    assert!(verdict.passed, "{verdict:#?}");
    assert_eq!(verdict.stars, 3, "{verdict:#?}");
}

/// The words of an error of the template with one text put in place of another.
fn refused(from: &str, to: &str) -> String {
    assert_eq!(TEMPLATE.matches(from).count(), 1, "{from}");
    Mission::read(&TEMPLATE.replace(from, to)).unwrap_err().to_string()
}

#[test]
fn a_wrong_mission_is_refused_with_line_field_and_what_is_allowed() {
    let line_of = |text: &str| 1 + TEMPLATE[..TEMPLATE.find(text).unwrap()].lines().count();
    for (from, to, words) in [
        (
            "version = 1\n# Name in links",
            "version = 2\n# Name in links",
            vec!["`version` is 2", "allowed is 1"],
        ),
        ("id = \"my-mission\"", "id = \"My mission\"", vec!["`id`", "My mission", "a to z"]),
        ("scenario = \"depth-step\"", "scenario = \"depth\"", vec!["`scenario`", "depth-step"]),
        (
            "kind = \"constant_feed\"",
            "kind = \"constant\"",
            vec!["controller.kind", "constant", "tracking"],
        ),
        ("minutes = 5", "minutes = -5", vec!["minutes", "-5"]),
        ("minutes = 5", "minuets = 5", vec!["minuets", "minutes"]),
        (
            "locked = [\"target.ra_um\"]",
            "locked = [\"target.ra\"]",
            vec!["`controls.locked`", "target.ra_um"],
        ),
        (
            "[\"constant_feed\", \"sdnrp\", \"tracking\"]",
            "[\"constant_feed\", \"trackin\"]",
            vec!["`controls.options.controller.kind`", "`trackin`", "`tracking`", "allowed"],
        ),
        (
            "[\"constant_feed\", \"sdnrp\", \"tracking\"]",
            "[\"constant_feed\", \"constant_feed\"]",
            vec!["`controls.options.controller.kind`", "offers 1", "2 at least"],
        ),
        (
            "[\"constant_feed\", \"sdnrp\", \"tracking\"]",
            "[\"sdnrp\", \"tracking\"]",
            vec!["`controls.options.controller.kind`", "lacks `constant_feed`"],
        ),
        (
            "options = { \"controller.kind\" =",
            "options = { \"target.reference\" =",
            vec!["`controls.options.target.reference`", "is not open", "controller.kind"],
        ),
        (
            "options = { \"controller.kind\" =",
            "options = { \"controller.constant_feed.feed_percent\" =",
            vec!["is no choice"],
        ),
        (
            "when = \"finished == 1\"",
            "when = \"finised == 1\"",
            vec!["checks[1].when", "`finised`", "`finished`", "allowed"],
        ),
        (
            "when = \"finished == 1\"",
            "when = \"finished\"",
            vec!["checks[1].when", "compares nothing", "<="],
        ),
        (
            "when = \"finished == 1\"",
            "when = \"0 < finished < 2\"",
            vec!["checks[1].when", "twice"],
        ),
        ("when = \"finished == 1\"", "when = \"2 * == 1\"", vec!["checks[1].when", "expected"]),
        (
            "two = [\"in_tolerance_percent >= 96\"]",
            "two = [\"in_tolerance >= 98\"]",
            vec!["stars.two", "in_tolerance_percent"],
        ),
        (
            "right = \"ra_deep\", tolerance_percent = 10.0",
            "right = \"ra_deep\", tolerance_percent = 0.0",
            vec!["tolerance_percent", "is 0", "above 0 to 100"],
        ),
        (
            "signal = \"force_n\", run = \"given\"",
            "signal = \"force\", run = \"given\"",
            vec!["`force`", "force_n", "allowed"],
        ),
        (
            "finished = { ended = \"path_done\" }",
            "finished = { ended = \"done\" }",
            vec!["`values.finished.ended`", "`done`", "path_done"],
        ),
        (
            "finished = { ended = \"path_done\" }",
            "finished = { metric = \"path_mm\", ended = \"path_done\" }",
            vec!["`values.finished`", "one of metric, signal"],
        ),
        (
            "finished = { ended = \"path_done\" }",
            "finished = { ended = \"path_done\", take = \"max\" }",
            vec!["`values.finished`", "signal only"],
        ),
        (
            "finished = { ended = \"path_done\" }",
            "finished = { prediction = 9 }",
            vec!["`values.finished.prediction`", "is 9", "1 to 4"],
        ),
        (
            "run = \"constant_feed_twin\"",
            "run = \"twin\"",
            vec!["run", "`twin`", "constant_feed_twin", "tracking"],
        ),
        (
            "from_mm = 60.0, to_mm = 84.0",
            "from_mm = 84.0, to_mm = 60.0",
            vec!["values.ra_deep", "from 84 to 60"],
        ),
    ] {
        let error = refused(from, to);
        for word in words {
            assert!(error.contains(word), "{to}: {error} lacks {word}");
        }
    }
    let error = refused("when = \"finished == 1\"", "when = \"finised == 1\"");
    let line = line_of("when = \"finished == 1\"");
    assert!(error.contains(&format!("at line {line}")), "{error}: {line}");
}

#[test]
fn an_answer_touches_nothing_but_what_the_mission_opens() {
    let mission = Mission::read(TEMPLATE).unwrap();
    let answer = |text: &str| {
        let text = format!("version = 1\nmission = \"my-mission\"\n{text}");
        MissionAnswer::read(&text, &mission).map_err(|error| error.to_string())
    };
    for (text, words) in [
        ("[set.target]\nra_um = 2.0", vec!["`target.ra_um`", "2", "controller.kind"]),
        ("[set.controller]\nkind = \"tracing\"", vec!["controller.kind", "tracing", "tracking"]),
        (
            "[set.controller]\nkind = \"mrac\"",
            vec!["`controller.kind` is set to mrac", "offers constant_feed, sdnrp, tracking"],
        ),
        (
            "[[edits]]\nat_s = 1.0\npath = \"controller.kind\"\nvalue = \"mrac\"",
            vec!["`controller.kind` is set to mrac", "offers constant_feed, sdnrp, tracking"],
        ),
        (
            "[[edits]]\nat_s = 1.0\npath = \"noise.level\"\nvalue = 1.0",
            vec!["`noise.level`", "1 s", "opens"],
        ),
        ("[[predictions]]\nstep = 4\nchoice = 1", vec!["step 4 asks nothing", "1, 2, 3"]),
        ("[[predictions]]\nstep = 1\nchoice = 4", vec!["choice is 4", "1 to 3"]),
        ("[[predictions]]\nstep = 1\nnumber = 4.0", vec!["step 1", "a choice"]),
        ("[[predictions]]\nstep = 2\nnumber = nan", vec!["step 2", "NaN", "finite"]),
        ("[[predictions]]\nstep = 3\ncurve = [[1.0, 2.0]]", vec!["1 points", "2 to"]),
        ("[[predictions]]\nstep = 3\ncurve = [[1.0, 2.0], [1.0, 3.0]]", vec!["ascend"]),
        ("[[predictions]]\nstep = 1", vec!["step 1", "one of choice, number and curve"]),
        (
            "[[predictions]]\nstep = 1\nchoice = 1\n[[predictions]]\nstep = 1\nchoice = 2",
            vec!["twice"],
        ),
        ("link = \"#nonsense\"", vec!["link"]),
    ] {
        let error = answer(text).unwrap_err();
        for word in words {
            assert!(error.contains(word), "{text}: {error} lacks {word}");
        }
    }
    let other =
        MissionAnswer::read("version = 1\nmission = \"other\"", &mission).unwrap_err().to_string();
    assert!(other.contains("`other`") && other.contains("my-mission"), "{other}");
}

/// A sketch that is the curve is right; one that is flat at half the curve's height is half of it off, by definition.
#[test]
fn a_sketched_curve_is_judged_by_its_distance() {
    let mission = Mission::read(TEMPLATE).unwrap();
    let flat = |part: f64| {
        let run = Run::complete(&mission.scenario, &mission.edits);
        let rows = run.recording().rows();
        let largest = rows.iter().filter(|row| row.time_s <= 20.0).map(|row| row.force_n);
        let height = part * largest.fold(0.0, f64::max);
        let mut answer = MissionAnswer::untouched(&mission);
        answer.predictions.insert(3, Prediction::Curve(vec![[0.0, height], [20.0, height]]));
        let verdict = marked(&mission, answer);
        let sketched = verdict.predictions.into_iter().find(|p| p.step == 3).unwrap();
        (sketched.off_percent.unwrap(), sketched.right)
    };
    let (near, is_near) = flat(0.95);
    let (far, is_far) = flat(0.5);
    assert!(near < 15.0 && is_near, "{near}");
    assert!((30.0..=50.0).contains(&far) && !is_far, "{far}");
}

/// Every metric of the JSON can be read by a condition, with the same value.
#[test]
fn conditions_read_all_metrics() {
    let run = Run::complete(&presets::load("depth-step").unwrap(), &Edits::none());
    let metrics = run.metrics();
    let serde_json::Value::Object(json) = serde_json::to_value(&metrics).unwrap() else { panic!() };
    assert_eq!(json.len(), METRICS.len());
    for (id, get) in METRICS {
        assert_eq!(json[*id].as_f64(), get(&metrics), "{id}");
    }
}

/// An answer that came when the cut had been seen is judged, and passes what must be right; it was not foreseen.
#[test]
fn what_came_late_is_not_foreseen() {
    for id in ["depth-step-at-constant-feed", "wear-heard-and-seen"] {
        let mission = shipped::load(id).unwrap();
        let path = format!("{}/tests/data/missions/{id}.right.toml", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(&path).unwrap();
        let late = text.replace("step = 1\n", "step = 1\nlate = true\n");
        assert_ne!(late, text);
        let answer = MissionAnswer::read(&late, &mission).unwrap();
        let verdict = marked(&mission, answer);
        assert_eq!((verdict.passed, verdict.stars), (true, 2), "{verdict:#?}");
        assert!(verdict.predictions[0].right && verdict.predictions[0].late);
    }
}

/// Every step of a shipped mission does something: it asks, or it is the one in which the cut is changed and checked.
#[test]
fn no_step_of_a_shipped_mission_can_be_passed_over() {
    for shipped in MISSIONS {
        let mission = shipped::load(shipped.id).unwrap();
        let last = mission.steps.len() - 1;
        for (number, step) in mission.steps.iter().enumerate() {
            assert!(step.predict.is_some() || number == last, "{}: {}", mission.id, step.title);
        }
    }
}

/// The mean of a force that swings may be near the desired one: that is no rest, and is told as what it is.
#[test]
fn a_loop_that_swings_passes_no_mission_on_rest() {
    for (id, settings, told) in [
        ("gain-leaves-an-error", [("controller.sdnrp.kp", 4.0)], "it swings"),
        ("integral-action-holds", [("controller.p.ki", 0.7)], "the loop is unstable"),
    ] {
        let mission = shipped::load(id).unwrap();
        let mut answer = MissionAnswer::untouched(&mission);
        let settings = settings.map(|(path, value)| (path.to_owned(), Value::Float(value)));
        answer.scenario.set_all(&settings).unwrap();
        let verdict = marked(&mission, answer);
        let words: Vec<&str> = verdict.words().collect();
        assert!(!verdict.passed && words.iter().any(|word| word.contains(told)), "{words:?}");
    }
}

/// What is missing for a star is told with the learner's own value.
#[test]
fn stars_are_told_condition_by_condition() {
    let mission = shipped::load("gain-leaves-an-error").unwrap();
    let mut answer = MissionAnswer::untouched(&mission);
    let gain = ("controller.sdnrp.kp".to_owned(), Value::Float(3.5));
    answer.scenario.set_all(&[gain]).unwrap();
    let verdict = marked(&mission, answer);
    assert_eq!((verdict.passed, verdict.stars), (true, 1), "{verdict:#?}");
    let [two, three] = &verdict.stars_asked[..] else { panic!("{verdict:#?}") };
    assert_eq!((two.star, two.when.as_str(), two.holds), (2, "overshoot_percent <= 5", false));
    assert!(two.sides[0].is_some_and(|own| own > 5.0) && two.sides[1] == Some(5.0));
    assert_eq!((three.star, three.holds), (3, false));
    assert!(!verdict.is_foreseen(), "nothing was predicted");
}

/// A mission may let the learner write the controller: the template with a script among what is offered, and opened.
#[test]
fn a_script_can_pass_a_mission_and_one_that_fails_is_told_in_plain_words() {
    let text = TEMPLATE
        .replacen(
            "\"controller.constant_feed.feed_percent\"]",
            "\"controller.script.code\", \"controller.script.a\"]",
            1,
        )
        .replacen("\"sdnrp\", \"tracking\"]", "\"script\"]", 1);
    let mission = Mission::read(&text).unwrap_or_else(|error| panic!("{error}"));
    let answer = |code: &str| {
        let text = format!(
            "version = 1\nmission = \"my-mission\"\n[set.controller]\nkind = \"script\"\n\
             [set.controller.script]\na = 0.2\ncode = \"\"\"\n{code}\"\"\"\n"
        );
        MissionAnswer::read(&text, &mission).unwrap_or_else(|error| panic!("{error}"))
    };
    let integral = "fn update(now) {\n    \
                    100.0 * max(now.feed_percent / 100.0 + now.a * (1.0 - now.y), 0.05)\n}\n";
    let verdict = marked(&mission, answer(integral));
    assert!(verdict.passed && verdict.script_fault.is_none(), "{verdict:#?}");
    let failing = "fn update(now) {\n    if now.x_mm > 10.0 { no_such_thing() }\n    100.0\n}\n";
    let verdict = marked(&mission, answer(failing));
    assert!(!verdict.passed && verdict.stars == 0);
    let word = verdict.words().next().unwrap();
    assert!(word.contains("script failed at") && word.contains("line 2"), "{word}");
    // What the mission does not open the learner's script does not have either.
    let closed = "version = 1\nmission = \"my-mission\"\n[set.controller.script]\nb = 0.1\n";
    let refused = MissionAnswer::read(closed, &mission).unwrap_err().to_string();
    assert!(refused.contains("controller.script.b") && refused.contains("script.a"), "{refused}");
}
