//! An answer to a mission: what was predicted, and the cut as the learner left it.

use std::collections::{BTreeMap, BTreeSet};

use serde::{Deserialize, Serialize};

use super::cut::changed;
use super::{Mission, MissionError, QuestionKind};
use crate::base::files::from_toml;
use crate::base::language::tr;
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;
use crate::run::scenario_link;

/// Version of the format of answers.
const ANSWER_VERSION: i64 = 1;
/// Longest answer that is read, bytes.
const MAX_BYTES: usize = 4_000_000;
/// Most points of a sketched curve.
const MAX_POINTS: usize = 10_000;

/// A prediction.
#[derive(Clone, Debug, PartialEq)]
pub enum Prediction {
    /// The number of the option, from 1 on.
    Choice(usize),
    /// A number.
    Number(f64),
    /// A curve: points of time in s, ascending, and the signal's value.
    Curve(Vec<[f64; 2]>),
}

/// What a learner answered.
#[derive(Clone, Debug, PartialEq)]
pub struct MissionAnswer {
    /// Predictions by the number of their step, from 1 on.
    pub predictions: BTreeMap<usize, Prediction>,
    /// Steps whose question was answered, or answered anew, when the cut had been seen already: such an answer is
    /// judged, and does not count as foreseen.
    pub late: BTreeSet<usize>,
    /// The scenario as the learner left it.
    pub scenario: Scenario,
    /// All changes during the cut, those of the mission among them.
    pub edits: Edits,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "an answer")]
struct AnswerText {
    version: i64,
    mission: String,
    #[serde(default)]
    predictions: Vec<PredictionText>,
    link: Option<String>,
    #[serde(default)]
    set: toml::Table,
    #[serde(default)]
    edits: Vec<toml::Value>,
}

/// A prediction as files have it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "step, and choice, number or curve, and late")]
pub(super) struct PredictionText {
    step: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    choice: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    number: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    curve: Option<Vec<[f64; 2]>>,
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    late: bool,
}

impl PredictionText {
    /// The prediction of a step; `late` where it came when the cut had been seen.
    pub(super) fn of(step: usize, prediction: &Prediction, late: bool) -> Self {
        let none = Self { step, late, ..Self::default() };
        match prediction {
            Prediction::Choice(choice) => Self { choice: Some(*choice), ..none },
            Prediction::Number(number) => Self { number: Some(*number), ..none },
            Prediction::Curve(curve) => Self { curve: Some(curve.clone()), ..none },
        }
    }
}

/// Predictions by their steps, and which of them came late.
pub(super) type ByStep = (BTreeMap<usize, Prediction>, BTreeSet<usize>);

/// Predictions as files have them.
pub(super) fn predictions(texts: Vec<PredictionText>) -> Result<ByStep, String> {
    let (mut predictions, mut all_late) = (BTreeMap::new(), BTreeSet::new());
    for PredictionText { step, choice, number, curve, late } in texts {
        let prediction = match (choice, number, curve) {
            (Some(choice), None, None) => Prediction::Choice(choice),
            (None, Some(number), None) => Prediction::Number(number),
            (None, None, Some(curve)) => Prediction::Curve(curve),
            (..) => {
                return Err(tr!(
                    "`predictions`, step {step}: allowed is one of choice, number and curve",
                    step = step
                ));
            }
        };
        if predictions.insert(step, prediction).is_some() {
            return Err(tr!("`predictions`: step {step} is answered twice", step = step));
        }
        if late {
            all_late.insert(step);
        }
    }
    Ok((predictions, all_late))
}

impl MissionAnswer {
    /// The answer of who did nothing.
    #[must_use]
    pub fn untouched(mission: &Mission) -> Self {
        Self {
            predictions: BTreeMap::new(),
            late: BTreeSet::new(),
            scenario: mission.scenario.clone(),
            edits: mission.edits.clone(),
        }
    }

    /// Reads an answer to a mission.
    ///
    /// # Errors
    /// Names the entry and what is allowed; so does a changed setting that the mission does not open.
    pub fn read(text: &str, mission: &Mission) -> Result<Self, MissionError> {
        read(text, mission).map_err(MissionError::of_answer)
    }

    /// Checks that predictions answer questions that there are, and that nothing was changed but what the mission
    /// opens.
    ///
    /// # Errors
    /// Names what does not fit.
    pub fn check(&self, mission: &Mission) -> Result<(), MissionError> {
        self.fits(mission).map_err(MissionError::of_answer)
    }

    fn fits(&self, mission: &Mission) -> Result<(), String> {
        for (step, prediction) in &self.predictions {
            fits_question(*step, prediction, mission)?;
        }
        let open = || match mission.controls.open.as_slice() {
            [] => tr("nothing").to_owned(),
            open => open.join(", "),
        };
        for (param, value) in self.scenario.difference(&mission.scenario) {
            if !mission.is_open(&param.path) {
                return Err(tr!(
                    "`{path}` is set to {value}: the mission opens {open}",
                    path = param.path,
                    value = value.to_string(),
                    open = open()
                ));
            }
            mission.offers(&param.path, &value)?;
        }
        let given = mission.edits.list();
        for edit in self.edits.list() {
            if !mission.is_open(&edit.path) && !given.contains(edit) {
                let (path, at_s) = (&edit.path, edit.at_s);
                return Err(tr!(
                    "`{path}` is changed at {time} s: the mission opens {open}",
                    path = path,
                    time = at_s,
                    open = open()
                ));
            }
            if !given.contains(edit) {
                mission.offers(&edit.path, &edit.value)?;
            }
        }
        if let Some(missing) = given.iter().find(|edit| !self.edits.list().contains(edit)) {
            let (path, at_s) = (&missing.path, missing.at_s);
            return Err(tr!(
                "the change of `{path}` at {time} s is part of the mission and is missing",
                path = path,
                time = at_s
            ));
        }
        Ok(())
    }
}

fn fits_question(step: usize, prediction: &Prediction, mission: &Mission) -> Result<(), String> {
    let Some((_, question)) = mission.questions().find(|(number, _)| *number == step) else {
        let all: Vec<String> = mission.questions().map(|(number, _)| number.to_string()).collect();
        let all = if all.is_empty() { tr("none").to_owned() } else { all.join(", ") };
        return Err(tr!(
            "`predictions`: step {step} asks nothing; steps that ask: {all}",
            step = step,
            all = all
        ));
    };
    let entry = tr!("`predictions`, step {step}", step = step);
    match (&question.kind, prediction) {
        (QuestionKind::Choice(options), Prediction::Choice(number)) => {
            if (1..=options.len()).contains(number) {
                return Ok(());
            }
            Err(tr!(
                "{entry}: choice is {number}: allowed is 1 to {most}",
                entry = entry,
                number = *number,
                most = options.len()
            ))
        }
        (QuestionKind::Number { .. }, Prediction::Number(number)) => {
            if number.is_finite() {
                return Ok(());
            }
            Err(tr!(
                "{entry}: number is {number}: allowed are finite ones",
                entry = entry,
                number = *number
            ))
        }
        (QuestionKind::Curve { .. }, Prediction::Curve(points)) => fits_curve(&entry, points),
        (QuestionKind::Choice(_), _) => Err(tr!("{entry}: allowed is a choice", entry = entry)),
        (QuestionKind::Number { .. }, _) => Err(tr!("{entry}: allowed is a number", entry = entry)),
        (QuestionKind::Curve { .. }, _) => Err(tr!("{entry}: allowed is a curve", entry = entry)),
    }
}

fn fits_curve(entry: &str, points: &[[f64; 2]]) -> Result<(), String> {
    if !(2..=MAX_POINTS).contains(&points.len()) {
        return Err(tr!(
            "{entry}: curve has {count} points: allowed are 2 to {most}",
            entry = entry,
            count = points.len(),
            most = MAX_POINTS
        ));
    }
    if !points.iter().flatten().all(|x| x.is_finite()) {
        return Err(tr!("{entry}: curve has a number that is not finite", entry = entry));
    }
    if !points.is_sorted_by(|a, b| a[0] < b[0]) {
        return Err(tr!("{entry}: the times of the curve do not ascend", entry = entry));
    }
    Ok(())
}

fn read(text: &str, mission: &Mission) -> Result<MissionAnswer, String> {
    if text.len() > MAX_BYTES {
        return Err(tr!(
            "{bytes} bytes; at most {most} are read",
            bytes = text.len(),
            most = MAX_BYTES
        ));
    }
    let file: AnswerText = from_toml(text)?;
    if file.version != ANSWER_VERSION {
        return Err(tr!(
            "`version` is {version}: allowed is {allowed}",
            version = file.version,
            allowed = ANSWER_VERSION
        ));
    }
    if file.mission != mission.id {
        return Err(tr!(
            "`mission` is `{found}`: this mission is `{own}`",
            found = file.mission,
            own = mission.id
        ));
    }
    let (predictions, late) = predictions(file.predictions)?;
    let (scenario, edits) = match file.link {
        Some(_) if !file.set.is_empty() || !file.edits.is_empty() => {
            return Err(tr(
                "`link` holds settings and changes: allowed is a link, or set and edits",
            )
            .to_owned());
        }
        Some(link) => scenario_link::parse(&link).map_err(|error| format!("`link`: {error}"))?,
        None => cut(mission, &file.set, &file.edits)?,
    };
    let answer = MissionAnswer { predictions, late, scenario, edits };
    answer.fits(mission)?;
    Ok(answer)
}

/// The mission's cut with settings and changes of the learner.
fn cut(
    mission: &Mission,
    set: &toml::Table,
    edits: &[toml::Value],
) -> Result<(Scenario, Edits), String> {
    let (scenario, learners) = changed(&mission.scenario, set, edits)?;
    let mut all = mission.edits.clone();
    for edit in learners.list() {
        all.push(&scenario, edit.clone()).map_err(|error| format!("`edits`: {error}"))?;
    }
    Ok((scenario, all))
}
