//! The file of a mission: TOML. Reading it names the entry, its line, what stands there and what is allowed.

mod controls;

use std::collections::BTreeMap;

use serde::Deserialize;
use toml::Spanned;

use self::controls::ControlsText;
use super::cut::changed;
use super::value::{MissionValue, RunOf, Taken, Window};
use super::{
    Check, ChoiceOption, Condition, Debrief, MISSION_VERSION, Mission, MissionError, MissionStep,
    Quantity, Question, QuestionKind, RightIf,
};
use crate::base::files::from_toml;
use crate::base::language::tr;
use crate::base::text::nearest;
use crate::run::edits::Edits;
use crate::run::end::EndId;
use crate::run::metrics::METRICS;
use crate::run::presets;
use crate::run::scenario::{Scenario, param};
use crate::run::signals::{SIGNALS, signal};

/// Longest mission that is read, bytes.
pub(super) const MAX_BYTES: usize = 200_000;
/// Most steps, hints, checks, values and options of a question, each.
const MAX_ENTRIES: usize = 100;

#[derive(Deserialize)]
#[serde(expecting = "a mission")]
struct VersionText {
    version: i64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a mission")]
struct MissionText {
    #[serde(rename = "version")]
    _version: i64,
    id: Spanned<String>,
    title: Spanned<String>,
    about: String,
    minutes: u32,
    story: String,
    goal: String,
    scenario: Spanned<String>,
    #[serde(default)]
    set: toml::Table,
    #[serde(default)]
    edits: Vec<toml::Value>,
    #[serde(default)]
    controls: ControlsText,
    #[serde(default)]
    steps: Vec<StepText>,
    #[serde(default)]
    hints: Vec<String>,
    #[serde(default)]
    values: BTreeMap<String, Spanned<ValueText>>,
    checks: Vec<CheckText>,
    #[serde(default)]
    stars: StarsText,
    debrief: DebriefText,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "title, text and predict")]
struct StepText {
    title: String,
    #[serde(default)]
    text: String,
    predict: Option<Spanned<QuestionText>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a question")]
struct QuestionText {
    ask: String,
    #[serde(default)]
    must: bool,
    #[serde(default)]
    look_up: bool,
    #[serde(default)]
    otherwise: String,
    options: Option<Vec<OptionText>>,
    number: Option<NumberText>,
    curve: Option<CurveText>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "text, right or right_if, and word")]
struct OptionText {
    text: String,
    right: Option<bool>,
    right_if: Option<Spanned<String>>,
    #[serde(default)]
    word: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "unit, right and tolerance_percent")]
struct NumberText {
    unit: String,
    right: Spanned<String>,
    tolerance_percent: Spanned<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "signal, run, from_s, to_s and tolerance_percent")]
struct CurveText {
    signal: Spanned<String>,
    run: Option<Spanned<String>>,
    from_s: Option<f64>,
    to_s: Option<f64>,
    tolerance_percent: Spanned<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "what a value is")]
struct ValueText {
    metric: Option<Spanned<String>>,
    signal: Option<Spanned<String>>,
    setting: Option<Spanned<String>>,
    changes: Option<Spanned<String>>,
    prediction: Option<Spanned<usize>>,
    ended: Option<Spanned<String>>,
    run: Option<Spanned<String>>,
    take: Option<Spanned<String>>,
    from_s: Option<f64>,
    to_s: Option<f64>,
    from_mm: Option<f64>,
    to_mm: Option<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "when and otherwise")]
struct CheckText {
    when: Spanned<String>,
    otherwise: String,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields, expecting = "two and three")]
struct StarsText {
    #[serde(default)]
    two: Vec<Spanned<String>>,
    #[serde(default)]
    three: Vec<Spanned<String>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "text, formula and source")]
struct DebriefText {
    text: String,
    #[serde(default)]
    formula: String,
    #[serde(default)]
    source: String,
}

pub(super) fn read(text: &str) -> Result<Mission, MissionError> {
    if text.len() > MAX_BYTES {
        let problem =
            tr!("{bytes} bytes; at most {most} are read", bytes = text.len(), most = MAX_BYTES);
        return Err(MissionError::of_mission(problem));
    }
    let mission = || -> Result<Mission, String> {
        // The version comes first: a file of another version may hold anything.
        let VersionText { version } = from_toml(text)?;
        if version != MISSION_VERSION {
            return Err(tr!(
                "`version` is {version}: allowed is {allowed}",
                version = version,
                allowed = MISSION_VERSION
            ));
        }
        Reader { text }.mission(from_toml(text)?)
    };
    mission().map_err(MissionError::of_mission)
}

/// What turns the entries of a text into a mission.
struct Reader<'a> {
    text: &'a str,
}

impl Reader<'_> {
    /// An error of an entry, with the line where it stands.
    fn at<T>(&self, entry: &str, place: &Spanned<T>, problem: &str) -> String {
        let start = place.span().start.min(self.text.len());
        let line = self.text.as_bytes()[..start].iter().filter(|byte| **byte == b'\n').count() + 1;
        tr!("`{entry}` at line {line}: {problem}", entry = entry, line = line, problem = problem)
    }

    fn mission(&self, file: MissionText) -> Result<Mission, String> {
        let counts = [
            ("steps", file.steps.len()),
            ("hints", file.hints.len()),
            ("values", file.values.len()),
            ("checks", file.checks.len()),
            ("stars.two", file.stars.two.len()),
            ("stars.three", file.stars.three.len()),
        ];
        if let Some((entry, count)) = counts.iter().find(|(_, count)| *count > MAX_ENTRIES) {
            return Err(tr!(
                "`{entry}` has {count} entries: allowed are {most}",
                entry = *entry,
                count = *count,
                most = MAX_ENTRIES
            ));
        }
        if file.checks.is_empty() {
            let problem = tr("`checks` is empty: a mission checks at least one condition");
            return Err(problem.to_owned());
        }
        let id = file.id.get_ref();
        let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        if id.is_empty() || id.len() > 60 || !id.chars().all(plain) {
            let problem = tr!("is `{id}`: allowed are 1 to 60 of a to z, 0 to 9 and -", id = id);
            return Err(self.at("id", &file.id, &problem));
        }
        if file.title.get_ref().trim().is_empty() {
            return Err(self.at("title", &file.title, tr("is empty: a mission has a title")));
        }
        let (scenario, edits) = self.scenario(&file)?;
        let controls = self.controls(&file.controls, &scenario)?;
        let mut values = BTreeMap::new();
        for (name, value) in &file.values {
            if is_metric(name) {
                let problem = tr("is the name of a metric: allowed is another name");
                return Err(self.at(&format!("values.{name}"), value, problem));
            }
            let read = self.value(&format!("values.{name}"), value, file.steps.len())?;
            values.insert(name.clone(), read);
        }
        let known = |name: &str| known(name, &values);
        let mut steps = Vec::new();
        for (number, step) in (1..).zip(file.steps) {
            let StepText { title, text, predict } = step;
            let entry = format!("steps[{number}].predict");
            let predict = predict.map(|question| self.question(&entry, question, &known));
            steps.push(MissionStep { title, text, predict: predict.transpose()? });
        }
        let mut checks = Vec::new();
        for (number, CheckText { when, otherwise }) in (1..).zip(file.checks) {
            let when = self.condition(&format!("checks[{number}].when"), &when, &known)?;
            checks.push(Check { when, otherwise });
        }
        let stars = |entry: &str, list: &[Spanned<String>]| {
            list.iter().map(|text| self.condition(entry, text, &known)).collect::<Result<_, _>>()
        };
        let stars =
            [stars("stars.two", &file.stars.two)?, stars("stars.three", &file.stars.three)?];
        let DebriefText { text, formula, source } = file.debrief;
        Ok(Mission {
            text: self.text.to_owned(),
            id: file.id.into_inner(),
            title: file.title.into_inner(),
            about: file.about,
            minutes: file.minutes,
            story: file.story,
            goal: file.goal,
            scenario,
            edits,
            controls,
            steps,
            hints: file.hints,
            values,
            checks,
            stars,
            debrief: Debrief { text, formula, source },
        })
    }

    /// The cut: a shipped scenario with what `set` and `edits` make of it, read like a scenario file.
    fn scenario(&self, file: &MissionText) -> Result<(Scenario, Edits), String> {
        let name = file.scenario.get_ref();
        let shipped = presets::load(name)
            .map_err(|error| self.at("scenario", &file.scenario, &error.to_string()))?;
        changed(&shipped, &file.set, &file.edits)
    }

    /// Paths of settings.
    fn settings(&self, entry: &str, list: &[Spanned<String>]) -> Result<Vec<String>, String> {
        let path = |text: &Spanned<String>| {
            let found = param(text.get_ref());
            found
                .map(|param| param.path.clone())
                .map_err(|error| self.at(entry, text, &error.to_string()))
        };
        list.iter().map(path).collect()
    }

    fn condition(
        &self,
        entry: &str,
        text: &Spanned<String>,
        known: &dyn Fn(&str) -> Result<(), String>,
    ) -> Result<Condition, String> {
        Condition::read(text.get_ref(), known).map_err(|problem| self.at(entry, text, &problem))
    }

    fn question(
        &self,
        entry: &str,
        place: Spanned<QuestionText>,
        known: &dyn Fn(&str) -> Result<(), String>,
    ) -> Result<Question, String> {
        let allowed = tr("allowed is one of options, number and curve");
        let question = place.get_ref();
        let given =
            [question.options.is_some(), question.number.is_some(), question.curve.is_some()];
        if given.iter().filter(|given| **given).count() != 1 {
            return Err(self.at(entry, &place, allowed));
        }
        let tolerance = |percent: &Spanned<f64>| {
            let value = *percent.get_ref();
            if value > 0.0 && value <= 100.0 {
                return Ok(value);
            }
            let problem = tr!("is {value}: allowed is above 0 to 100 %", value = value);
            Err(self.at(&format!("{entry}.tolerance_percent"), percent, &problem))
        };
        let kind = if let Some(options) = &question.options {
            self.options(entry, &place, options, known)?
        } else if let Some(NumberText { unit, right, tolerance_percent }) = &question.number {
            let quantity = Quantity::read(right.get_ref(), known)
                .map_err(|problem| self.at(&format!("{entry}.number.right"), right, &problem))?;
            let tolerance_percent = tolerance(tolerance_percent)?;
            QuestionKind::Number { unit: unit.clone(), right: quantity, tolerance_percent }
        } else if let Some(curve) = &question.curve {
            let of = MissionValue::Signal {
                signal: self.signal(entry, &curve.signal)?,
                run: self.run(entry, curve.run.as_ref())?,
                window: self.window(entry, &place, [curve.from_s, curve.to_s], [None, None])?,
                taken: Taken::Mean,
            };
            QuestionKind::Curve { of, tolerance_percent: tolerance(&curve.tolerance_percent)? }
        } else {
            return Err(self.at(entry, &place, allowed));
        };
        let QuestionText { ask, must, look_up, otherwise, .. } = place.into_inner();
        Ok(Question { ask, must, look_up, kind, otherwise })
    }

    fn options(
        &self,
        entry: &str,
        place: &Spanned<QuestionText>,
        options: &[OptionText],
        known: &dyn Fn(&str) -> Result<(), String>,
    ) -> Result<QuestionKind, String> {
        if !(2..=MAX_ENTRIES).contains(&options.len()) {
            let problem = tr!(
                "has {count} options: allowed are 2 to {most}",
                count = options.len(),
                most = MAX_ENTRIES
            );
            return Err(self.at(entry, place, &problem));
        }
        let mut read = Vec::new();
        for (number, option) in (1..).zip(options) {
            let right = match (option.right, &option.right_if) {
                (Some(_), Some(text)) => {
                    let problem = tr("has `right` and `right_if`: allowed is one of them");
                    return Err(self.at(&format!("{entry}.options[{number}]"), text, problem));
                }
                (right, None) => RightIf::Known(right.unwrap_or(false)),
                (None, Some(text)) => {
                    let entry = format!("{entry}.options[{number}].right_if");
                    RightIf::Holds(self.condition(&entry, text, known)?)
                }
            };
            read.push(ChoiceOption { text: option.text.clone(), right, word: option.word.clone() });
        }
        if read.iter().all(|option| option.right == RightIf::Known(false)) {
            return Err(self.at(
                entry,
                place,
                tr("no option is right: at least one has right = true or right_if"),
            ));
        }
        Ok(QuestionKind::Choice(read))
    }

    fn value(
        &self,
        entry: &str,
        place: &Spanned<ValueText>,
        steps: usize,
    ) -> Result<MissionValue, String> {
        let text = place.get_ref();
        let kinds = [
            text.metric.is_some(),
            text.signal.is_some(),
            text.setting.is_some(),
            text.changes.is_some(),
            text.prediction.is_some(),
            text.ended.is_some(),
        ];
        if kinds.iter().filter(|given| **given).count() != 1 {
            let problem =
                tr("allowed is one of metric, signal, setting, changes, prediction and ended");
            return Err(self.at(entry, place, problem));
        }
        let windowed =
            [text.from_s, text.to_s, text.from_mm, text.to_mm].iter().any(Option::is_some);
        if text.signal.is_none() && (text.take.is_some() || windowed) {
            let problem = tr("has take, from or to: allowed with a signal only");
            return Err(self.at(entry, place, problem));
        }
        let of_run = text.metric.is_some() || text.signal.is_some() || text.ended.is_some();
        if text.run.is_some() && !of_run {
            let problem = tr("has a run: allowed with a metric, a signal or an end only");
            return Err(self.at(entry, place, problem));
        }
        let run = self.run(entry, text.run.as_ref())?;
        if let Some(metric) = &text.metric {
            let id = self.one_of(&format!("{entry}.metric"), metric, &metrics())?;
            return Ok(MissionValue::Metric(id.to_owned(), run));
        }
        if let Some(name) = &text.signal {
            let allowed: Vec<&str> = Taken::ALL.iter().map(|taken| taken.id()).collect();
            let taken = text
                .take
                .as_ref()
                .map(|take| self.one_of(&format!("{entry}.take"), take, &allowed));
            let taken = taken.transpose()?.and_then(Taken::from_id).unwrap_or(Taken::Mean);
            let (time_s, place_mm) = ([text.from_s, text.to_s], [text.from_mm, text.to_mm]);
            let window = self.window(entry, place, time_s, place_mm)?;
            return Ok(MissionValue::Signal {
                signal: self.signal(entry, name)?,
                run,
                window,
                taken,
            });
        }
        if let Some(path) = &text.setting {
            let found = self.settings(&format!("{entry}.setting"), std::slice::from_ref(path))?;
            return Ok(MissionValue::Setting(found.concat()));
        }
        if let Some(path) = &text.changes {
            if path.get_ref() == "any" {
                return Ok(MissionValue::Changes(None));
            }
            let found = self.settings(&format!("{entry}.changes"), std::slice::from_ref(path))?;
            return Ok(MissionValue::Changes(Some(found.concat())));
        }
        if let Some(number) = &text.prediction {
            let step = *number.get_ref();
            if !(1..=steps).contains(&step) {
                let problem = tr!(
                    "is {step}: allowed is the number of a step, 1 to {most}",
                    step = step,
                    most = steps
                );
                return Err(self.at(&format!("{entry}.prediction"), number, &problem));
            }
            return Ok(MissionValue::Prediction(step));
        }
        let Some(end) = &text.ended else { return Err(self.at(entry, place, tr("is empty"))) };
        let allowed: Vec<&str> = EndId::ALL.iter().map(|end| end.id()).collect();
        let id = self.one_of(&format!("{entry}.ended"), end, &allowed)?;
        let end = EndId::from_id(id)
            .ok_or_else(|| tr!("`{entry}.ended`: no end `{id}`", entry = entry, id = id))?;
        Ok(MissionValue::Ended(end, run))
    }

    fn window(
        &self,
        entry: &str,
        place: &Spanned<impl Sized>,
        time_s: [Option<f64>; 2],
        place_mm: [Option<f64>; 2],
    ) -> Result<Window, String> {
        let filled =
            |[from, to]: [Option<f64>; 2]| [from.unwrap_or(0.0), to.unwrap_or(f64::INFINITY)];
        let window = Window { time_s: filled(time_s), place_mm: filled(place_mm) };
        for [from, to] in [window.time_s, window.place_mm] {
            if !(from >= 0.0 && from < to) {
                let problem = tr!(
                    "goes from {from} to {to}: allowed is from 0 on, and from below to",
                    from = from,
                    to = to
                );
                return Err(self.at(entry, place, &problem));
            }
        }
        Ok(window)
    }

    fn signal(&self, entry: &str, name: &Spanned<String>) -> Result<&'static str, String> {
        let all: Vec<&str> = SIGNALS.iter().map(|signal| signal.id).collect();
        let id = self.one_of(&format!("{entry}.signal"), name, &all)?;
        signal(id)
            .map(|signal| signal.id)
            .ok_or_else(|| tr!("`{entry}.signal`: no signal `{id}`", entry = entry, id = id))
    }

    fn run(&self, entry: &str, name: Option<&Spanned<String>>) -> Result<RunOf, String> {
        let Some(name) = name else { return Ok(RunOf::Learner) };
        let all: Vec<&str> = RunOf::all().map(RunOf::id).collect();
        let id = self.one_of(&format!("{entry}.run"), name, &all)?;
        Ok(RunOf::all().find(|run| run.id() == id).unwrap_or_default())
    }

    /// One of the ids that there are.
    fn one_of<'t>(
        &self,
        entry: &str,
        text: &'t Spanned<String>,
        all: &[&str],
    ) -> Result<&'t str, String> {
        let id = text.get_ref();
        if all.contains(&id.as_str()) {
            return Ok(id);
        }
        let problem = match near(id, all) {
            Some(near) => tr!(
                "there is no `{id}` (did you mean `{near}`?): allowed is one of {list}",
                id = id,
                near = near,
                list = all.join(", ")
            ),
            None => {
                tr!("there is no `{id}`: allowed is one of {list}", id = id, list = all.join(", "))
            }
        };
        Err(self.at(entry, text, &problem))
    }
}

/// The nearest name, where one is near.
fn near<'a>(name: &str, all: &[&'a str]) -> Option<&'a str> {
    nearest(name, all.iter().copied(), 0.75)
}

/// Whether a condition can read a name.
fn known(name: &str, values: &BTreeMap<String, MissionValue>) -> Result<(), String> {
    if values.contains_key(name) || is_metric(name) {
        return Ok(());
    }
    let all: Vec<&str> = values.keys().map(String::as_str).chain(metrics()).collect();
    let list = metrics().join(", ");
    Err(match near(name, &all) {
        Some(near) => tr!(
            "there is no value or metric `{name}` (did you mean `{near}`?): allowed are those of [values] and {list}",
            name = name,
            near = near,
            list = list
        ),
        None => tr!(
            "there is no value or metric `{name}`: allowed are those of [values] and {list}",
            name = name,
            list = list
        ),
    })
}

/// The ids of all metrics.
fn metrics() -> Vec<&'static str> {
    METRICS.iter().map(|(id, _)| *id).collect()
}

fn is_metric(name: &str) -> bool {
    METRICS.iter().any(|(id, _)| *id == name)
}
