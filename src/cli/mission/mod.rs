//! `steadycut mission`: lessons that are checked, without a window.

pub mod args;
mod pack;

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use self::args::{
    MissionArgs, MissionCheckArgs, MissionListArgs, MissionNewArgs, MissionShowArgs, MissionWhat,
};
use super::files::MissionPath;
use super::{Outcome, progress};
use crate::run::job::Job;
use crate::study::mission::shipped::{self, MISSIONS};
use crate::study::mission::{
    MOST_STARS, Marking, Mission, MissionAnswer, MissionResult, MissionVerdict, TEMPLATE,
};

/// Runs the command.
pub fn execute(args: &MissionArgs) -> Outcome {
    match &args.what {
        MissionWhat::List(args) => list(args),
        MissionWhat::New(args) => new(args),
        MissionWhat::Show(args) => show(args),
        MissionWhat::Check(args) => check(args),
        MissionWhat::Pack(args) => pack::execute(args),
    }
}

fn list(args: &MissionListArgs) -> Outcome {
    let missions: Vec<Mission> =
        MISSIONS.iter().map(|mission| shipped::load(mission.id)).collect::<Result<_, _>>()?;
    let mut out = std::io::stdout().lock();
    if args.json {
        let entries: Vec<_> = missions
            .iter()
            .map(|mission| {
                json!({
                    "id": mission.id, "title": mission.title, "about": mission.about,
                    "minutes": mission.minutes, "goal": mission.goal,
                    "scenario": mission.scenario.info.name, "open": mission.controls.open,
                    "steps": mission.steps.len(), "predictions": mission.questions().count(),
                })
            })
            .collect();
        writeln!(out, "{}", serde_json::to_string_pretty(&json!({ "missions": entries }))?)?;
        return Ok(ExitCode::SUCCESS);
    }
    for (number, mission) in (1..).zip(&missions) {
        writeln!(out, "{number:>2}. {} ({} min)", mission.title, mission.minutes)?;
        writeln!(out, "    {}\n    {}", mission.id, mission.about)?;
    }
    Ok(ExitCode::SUCCESS)
}

fn new(args: &MissionNewArgs) -> Outcome {
    match &args.out {
        Some(path) => path.write(TEMPLATE)?,
        None => write!(std::io::stdout().lock(), "{TEMPLATE}")?,
    }
    Ok(ExitCode::SUCCESS)
}

fn show(args: &MissionShowArgs) -> Outcome {
    // Loading it first gives the list of ids where there is none of this name.
    let mission = shipped::load(&args.id)?;
    let file = MISSIONS.iter().find(|shipped| shipped.id == mission.id);
    write!(std::io::stdout().lock(), "{}", file.map_or("", |shipped| shipped.text))?;
    Ok(ExitCode::SUCCESS)
}

/// What `mission check` is given.
enum Given {
    Mission(Box<Mission>),
    /// The name of a file, and the result in it.
    Result(String, Box<MissionResult>),
}

fn given(path: &MissionPath) -> Result<Given, Box<dyn std::error::Error>> {
    let file = match path.source() {
        Ok(file) => file,
        Err(id) => return Ok(Given::Mission(Box::new(shipped::load(id)?))),
    };
    let text = file.text()?;
    if MissionResult::is_meant_by(&text) {
        let result = MissionResult::read(&text).map_err(|problem| format!("{file}: {problem}"))?;
        return Ok(Given::Result(file.to_string(), Box::new(result)));
    }
    let mission = Mission::read(&text).map_err(|problem| format!("{file}: {problem}"))?;
    Ok(Given::Mission(Box::new(mission)))
}

/// Verifies a result whose mission is not named, so that it is a shipped one.
fn check_result(args: &MissionCheckArgs, file: &str, result: &MissionResult) -> Outcome {
    if let Some(answer) = &args.answer {
        return Err(format!("{file} is a result already: leave out --answer {answer}").into());
    }
    let id = &result.mission.id;
    let mission = shipped::load(id).map_err(|_| {
        format!(
            "{file} is of the mission `{id}`, which is not shipped: name its file, steadycut mission check \
             MISSION.toml --answer {file}"
        )
    })?;
    verify(args, &mission, file, result)
}

fn check(args: &MissionCheckArgs) -> Outcome {
    let mission = match given(&args.mission)? {
        Given::Mission(mission) => mission,
        Given::Result(file, result) => return check_result(args, &file, &result),
    };
    let Some(path) = &args.answer else {
        // Who does nothing must not pass: else the mission asks for nothing.
        let verdict = mark(&mission, MissionAnswer::untouched(&mission), args.json)?;
        return told_of_mission(args, &mission, &verdict);
    };
    let text = path.text()?;
    if MissionResult::is_meant_by(&text) {
        let result = MissionResult::read(&text).map_err(|problem| format!("{path}: {problem}"))?;
        return verify(args, &mission, &path.to_string(), &result);
    }
    let answer =
        MissionAnswer::read(&text, &mission).map_err(|problem| format!("{path}: {problem}"))?;
    let verdict = mark(&mission, answer, args.json)?;
    let mut out = std::io::stdout().lock();
    if args.json {
        writeln!(out, "{}", serde_json::to_string_pretty(&verdict)?)?;
    } else {
        print(&mut out, &mission, &verdict)?;
    }
    Ok(if verdict.passed { ExitCode::SUCCESS } else { ExitCode::from(1) })
}

/// Marks the answer of a result again, and says what in the result is not so.
fn verify(
    args: &MissionCheckArgs,
    mission: &Mission,
    file: &str,
    result: &MissionResult,
) -> Outcome {
    let answer = result.answer(mission).map_err(|problem| format!("{file}: {problem}"))?;
    let verdict = mark(mission, answer, args.json)?;
    let untrue = result.untrue(&verdict);
    let mut out = std::io::stdout().lock();
    if args.json {
        let report = json!({
            "name": result.name, "marked": result.marked, "program": result.program, "hints": result.hints,
            "tries": result.tries, "true": untrue.is_empty(), "untrue": untrue, "verdict": verdict,
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?;
    } else {
        print(&mut out, mission, &verdict)?;
        let MissionResult { name, marked, program, hints, tries, .. } = result;
        let whose = if name.is_empty() { String::new() } else { format!(" of {name}") };
        let tries = format!("begun {} times, checked {} times", tries.begun, tries.checked);
        writeln!(
            out,
            "\nresult{whose}, marked {marked} with version {program}, {hints} hints, {tries}"
        )?;
        match untrue.is_empty() {
            true => writeln!(out, "the result is true: its answer gives what it says")?,
            false => writeln!(out, "the result is NOT true:")?,
        }
        untrue.iter().try_for_each(|said| told(&mut out, said))?;
        let here = env!("CARGO_PKG_VERSION");
        if !untrue.is_empty() && program != here {
            writeln!(out, "    it was marked with version {program}, this is {here}")?;
        }
    }
    let good = verdict.passed && untrue.is_empty();
    Ok(if good { ExitCode::SUCCESS } else { ExitCode::from(1) })
}

fn mark(
    mission: &Mission,
    answer: MissionAnswer,
    quiet: bool,
) -> Result<MissionVerdict, Box<dyn std::error::Error>> {
    let mut marking = Marking::new(mission, answer)?;
    progress::work(&mut marking, "marking", quiet)?;
    marking.partial().ok_or_else(|| "the marking did not come to its end".into())
}

/// What `mission check` says without an answer.
fn told_of_mission(args: &MissionCheckArgs, mission: &Mission, idle: &MissionVerdict) -> Outcome {
    let mut out = std::io::stdout().lock();
    if args.json {
        let report = json!({ "mission": mission.id, "passed_by_doing_nothing": idle.passed });
        writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?;
    } else {
        writeln!(
            out,
            "{}: ok, {} steps, {} checks",
            mission.id,
            mission.steps.len(),
            mission.checks.len()
        )?;
        if idle.passed {
            writeln!(out, "  who does nothing passes: no check and no `must` asks for anything")?;
        }
    }
    Ok(if idle.passed { ExitCode::from(1) } else { ExitCode::SUCCESS })
}

fn print(out: &mut impl Write, mission: &Mission, verdict: &MissionVerdict) -> std::io::Result<()> {
    writeln!(out, "{}\n", mission.title)?;
    for prediction in &verdict.predictions {
        let came_to = match (prediction.answered, prediction.right) {
            (false, _) => "none was made",
            (true, true) => "right",
            (true, false) => "wrong",
        };
        write!(out, "  step {}, prediction: {came_to}", prediction.step)?;
        if prediction.late {
            write!(out, ", when the cut had been seen")?;
        }
        let question = mission.questions().find(|(step, _)| *step == prediction.step);
        let is_number = question.is_some_and(|(_, question)| question.kind.is_number());
        // With the number itself the percentage gives the right one away.
        match prediction.off_percent {
            Some(off) if is_number && !verdict.passed && !prediction.right => {
                write!(out, ", too {}", if off < 0.0 { "low" } else { "high" })?;
            }
            Some(off) if !is_number || verdict.passed => write!(out, ", {off:+.1} % off")?,
            Some(_) | None => {}
        }
        writeln!(out)?;
        told(out, if prediction.right { "" } else { &prediction.word })?;
    }
    if let Some(fault) = &verdict.script_fault {
        writeln!(out, "  {fault}")?;
    }
    for check in &verdict.checks {
        let [left, right] = check.sides.map(told_value);
        let holds = if check.holds { "holds" } else { "does NOT hold" };
        writeln!(out, "  {}: {holds} ({left}; {right})", check.when)?;
        told(out, if check.holds { "" } else { &check.otherwise })?;
    }
    let missed = verdict.stars_asked.iter().filter(|asked| verdict.passed && !asked.holds);
    for asked in missed {
        let [left, right] = asked.sides.map(told_value);
        writeln!(out, "  star {}, {}: does NOT hold ({left}; {right})", asked.star, asked.when)?;
    }
    if verdict.passed && !verdict.is_foreseen() {
        writeln!(out, "  star 3: not every prediction was made before the cut, and right")?;
    }
    let word = if verdict.passed { "passed" } else { "NOT passed" };
    writeln!(out, "\n{word}, {} of {MOST_STARS} stars; digest {}", verdict.stars, verdict.digest)?;
    if verdict.passed {
        writeln!(out, "\n{}", mission.debrief.text.trim())?;
        for line in [&mission.debrief.formula, &mission.debrief.source] {
            told(out, line)?;
        }
    }
    Ok(())
}

fn told_value(value: Option<f64>) -> String {
    value.map_or_else(|| "no value".to_owned(), |value| format!("{value:.4}"))
}

fn told(out: &mut impl Write, word: &str) -> std::io::Result<()> {
    if word.is_empty() { Ok(()) } else { writeln!(out, "    {word}") }
}
