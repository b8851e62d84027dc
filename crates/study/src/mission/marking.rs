//! Marking: the cuts that a mission's conditions read are run, and the conditions judged.

use std::collections::BTreeSet;

use super::answer::{MissionAnswer, Prediction};
use super::condition::Values;
use super::value::{MissionValue, RunOf, Window};
use super::verdict::{CheckVerdict, MissionVerdict, PredictionVerdict, StarVerdict};
use super::{Mission, MissionError, Question, QuestionKind, RightIf};
use crate::base::language::text;
use crate::base::settings::{Kind, Value};
use crate::base::stats;
use crate::base::units::percent_from_ratio;
use crate::run::constant_feed_twin::{TwinBeside, is_of_controller};
use crate::run::edits::Edits;
use crate::run::end::EndId;
use crate::run::job::{Budget, Job, Progress};
use crate::run::metrics::METRICS;
use crate::run::one_run::Run;
use crate::run::scenario::{Scenario, param};
use crate::run::signals::{SignalInfo, signal};

/// Marking of an answer, as a job.
#[derive(Clone, Debug)]
pub struct Marking {
    mission: Mission,
    answer: MissionAnswer,
    /// The runs that are read, the learner's first.
    runs: Vec<(RunOf, Run)>,
    /// The learner's cut at constant feed, where it is read.
    twin: Option<TwinBeside>,
    verdict: Option<MissionVerdict>,
}

impl Marking {
    /// A marking at its start.
    ///
    /// # Errors
    /// The answer does not fit the mission ([`MissionAnswer::check`]).
    pub fn new(mission: &Mission, answer: MissionAnswer) -> Result<Self, MissionError> {
        answer.check(mission)?;
        let mut wanted = BTreeSet::from([RunOf::Learner]);
        let curves = mission.questions().filter_map(|(_, question)| match &question.kind {
            QuestionKind::Curve { of, .. } => Some(of),
            QuestionKind::Choice(_) | QuestionKind::Number { .. } => None,
        });
        for value in mission.values.values().chain(curves) {
            wanted.extend(run_of(value));
        }
        let twin = wanted.remove(&RunOf::ConstantFeed).then(|| TwinBeside::new(&answer.scenario));
        let mut runs = Vec::new();
        for run in wanted {
            if let Some((scenario, edits)) = cut_of(run, mission, &answer)? {
                runs.push((run, Run::new(&scenario, &edits)));
            }
        }
        Ok(Self { mission: mission.clone(), answer, runs, twin, verdict: None })
    }

    fn run(&self, wanted: RunOf) -> Option<&Run> {
        if wanted == RunOf::ConstantFeed {
            return self.twin.as_ref().map(TwinBeside::run);
        }
        self.runs.iter().find(|(run, _)| *run == wanted).map(|(_, run)| run)
    }

    /// The learner's run.
    #[must_use]
    pub fn learners(&self) -> Option<&Run> {
        self.run(RunOf::Learner)
    }

    /// Metrics of the learner's run and the mission's own values.
    fn values(&self) -> Values {
        let mut values = Values::new();
        if let Some(metrics) = self.learners().map(Run::metrics) {
            values.extend(METRICS.iter().map(|(id, get)| ((*id).to_owned(), get(&metrics))));
        }
        for (name, value) in &self.mission.values {
            values.insert(name.clone(), self.value(value));
        }
        values
    }

    fn value(&self, value: &MissionValue) -> Option<f64> {
        match value {
            MissionValue::Metric(id, run) => {
                let metrics = self.run(*run)?.metrics();
                let (_, get) = METRICS.iter().find(|(name, _)| name == id)?;
                get(&metrics)
            }
            MissionValue::Signal { signal: id, run, window, taken } => {
                taken.of(signal(id)?, window, self.run(*run)?)
            }
            MissionValue::Setting(path) => {
                let run = self.learners()?;
                let end_s = run.recording().rows().last()?.time_s;
                setting(&self.answer.edits.scenario_at(&self.answer.scenario, end_s).ok()?, path)
            }
            MissionValue::Changes(path) => {
                let given = self.mission.edits.list();
                let of_learner = self.answer.edits.list().iter().filter(|edit| {
                    !given.contains(edit) && path.as_ref().is_none_or(|path| *path == edit.path)
                });
                Some(of_learner.count() as f64)
            }
            MissionValue::Prediction(step) => match self.answer.predictions.get(step)? {
                Prediction::Choice(number) => Some(*number as f64),
                Prediction::Number(number) => Some(*number),
                Prediction::Curve(_) => None,
            },
            MissionValue::Ended(end, run) => {
                let ended = self.run(*run)?.end()?.id() == *end;
                Some(if ended { 1.0 } else { 0.0 })
            }
        }
    }

    fn judge(&self) -> MissionVerdict {
        let values = self.values();
        let predictions: Vec<PredictionVerdict> = (self.mission.questions())
            .map(|(step, question)| self.predicted(step, question, &values))
            .collect();
        let checks: Vec<CheckVerdict> = (self.mission.checks.iter())
            .map(|check| CheckVerdict {
                when: check.when.to_string(),
                sides: check.when.sides(&values),
                holds: check.when.holds(&values),
                otherwise: check.otherwise.clone(),
            })
            .collect();
        let passed = checks.iter().all(|check| check.holds)
            && predictions.iter().all(|prediction| prediction.right || !prediction.must);
        let [two, three] = &self.mission.stars;
        let all = |conditions: &[super::Condition]| {
            conditions.iter().all(|condition| condition.holds(&values))
        };
        let foreseen = predictions.iter().all(PredictionVerdict::is_foreseen);
        let stars_asked = [(2, two), (3, three)].into_iter().flat_map(|(star, conditions)| {
            let values = &values;
            conditions.iter().map(move |condition| StarVerdict {
                star,
                when: condition.to_string(),
                sides: condition.sides(values),
                holds: condition.holds(values),
            })
        });
        let stars_asked = stars_asked.collect();
        let stars = match (passed, all(two), all(three) && foreseen) {
            (false, ..) => 0,
            (true, false, _) => 1,
            (true, true, false) => 2,
            (true, true, true) => 3,
        };
        let digest = self.learners().map_or(String::new(), |run| run.recording().digest());
        let end = self.learners().and_then(Run::end).filter(|end| end.id() == EndId::Script);
        MissionVerdict {
            mission: self.mission.id.clone(),
            passed,
            stars,
            predictions,
            checks,
            stars_asked,
            script_fault: end.map(ToString::to_string),
            digest,
        }
    }

    fn predicted(&self, step: usize, question: &Question, values: &Values) -> PredictionVerdict {
        let given = self.answer.predictions.get(&step);
        let mut verdict = PredictionVerdict {
            step,
            answered: given.is_some(),
            right: false,
            must: question.must,
            late: given.is_some() && self.answer.late.contains(&step),
            off_percent: None,
            solution: String::new(),
            word: if given.is_some() { question.otherwise.clone() } else { String::new() },
        };
        match &question.kind {
            QuestionKind::Choice(options) => {
                let is_right = |right: &RightIf| match right {
                    RightIf::Known(right) => *right,
                    RightIf::Holds(condition) => condition.holds(values),
                };
                let right = options.iter().filter(|option| is_right(&option.right));
                let right: Vec<&str> = right.map(|option| option.text.as_str()).collect();
                verdict.solution = right.join(" / ");
                if let Some(Prediction::Choice(number)) = given
                    && let Some(option) = number.checked_sub(1).and_then(|at| options.get(at))
                {
                    verdict.right = is_right(&option.right);
                    if !option.word.is_empty() {
                        verdict.word.clone_from(&option.word);
                    }
                }
            }
            QuestionKind::Number { unit, right, tolerance_percent } => {
                let right = right.value(values);
                verdict.solution = right.map_or(String::new(), |right| format!("{right} {unit}"));
                if let Some(Prediction::Number(number)) = given {
                    verdict.off_percent = right
                        .filter(|right| *right != 0.0)
                        .map(|right| percent_from_ratio((number - right) / right.abs()));
                    verdict.right = verdict
                        .off_percent
                        .map_or(right == Some(*number), |off| off.abs() <= *tolerance_percent);
                }
            }
            QuestionKind::Curve { of, tolerance_percent } => {
                if let (Some(Prediction::Curve(points)), Some(curve)) = (given, self.curve(of)) {
                    verdict.off_percent = off_percent(points, &curve);
                    verdict.right =
                        verdict.off_percent.is_some_and(|off| off <= *tolerance_percent);
                }
            }
        }
        verdict
    }

    /// The points of a curve that was to be sketched: time in s and the signal's value.
    #[must_use]
    pub fn curve(&self, of: &MissionValue) -> Option<Vec<[f64; 2]>> {
        let MissionValue::Signal { signal: id, run, window, .. } = of else { return None };
        Some(points(signal(id)?, window, self.run(*run)?))
    }
}

fn points(signal: &SignalInfo, window: &Window, run: &Run) -> Vec<[f64; 2]> {
    let rows = run.recording().rows().iter().filter(|row| window.holds(row));
    rows.filter_map(|row| Some([row.time_s, (signal.value)(row)?])).collect()
}

/// What a sketch is off by: root mean square of the difference over the curve's times, a sketch ending at its first
/// and last height, in percent of the largest less the smallest of the curve's values and zero.
fn off_percent(sketch: &[[f64; 2]], curve: &[[f64; 2]]) -> Option<f64> {
    let at = |time_s: f64| {
        let next = sketch.partition_point(|[t, _]| *t < time_s);
        let (before, after) = (sketch.get(next.wrapping_sub(1)), sketch.get(next));
        match (before, after) {
            (Some([t0, y0]), Some([t1, y1])) => Some(y0 + (y1 - y0) * (time_s - t0) / (t1 - t0)),
            (Some([_, y]), None) | (None, Some([_, y])) => Some(*y),
            (None, None) => None,
        }
    };
    let (mut least, mut most) = (0.0_f64, 0.0_f64);
    let mut errors = Vec::with_capacity(curve.len());
    for [time_s, value] in curve {
        (least, most) = (least.min(*value), most.max(*value));
        let error = at(*time_s)? - value;
        errors.push(error);
    }
    let rms = stats::rms(errors)?;
    (most > least).then(|| percent_from_ratio(rms / (most - least)))
}

/// Whose run a value is of, if of one.
fn run_of(value: &MissionValue) -> Option<RunOf> {
    match value {
        MissionValue::Metric(_, run)
        | MissionValue::Signal { run, .. }
        | MissionValue::Ended(_, run) => Some(*run),
        MissionValue::Setting(_) | MissionValue::Changes(_) | MissionValue::Prediction(_) => None,
    }
}

/// The cut of a run; none of the twin, which is made beside the learner's.
fn cut_of(
    run: RunOf,
    mission: &Mission,
    answer: &MissionAnswer,
) -> Result<Option<(Scenario, Edits)>, MissionError> {
    Ok(match run {
        RunOf::Learner => Some((answer.scenario.clone(), answer.edits.clone())),
        RunOf::Given => Some((mission.scenario.clone(), mission.edits.clone())),
        RunOf::ConstantFeed => None,
        RunOf::Controller(kind) => {
            let scenario = (mission.scenario.with(|settings| settings.controller.kind = kind))
                .map_err(|error| MissionError::of_mission(error.to_string()))?;
            Some((scenario, mission.edits.only(|edit| !is_of_controller(&edit.path))))
        }
    })
}

/// A setting as a number: for a choice the number of its option from 1 on, 1 and 0 for yes and no.
fn setting(scenario: &Scenario, path: &str) -> Option<f64> {
    match scenario.get(path).ok()? {
        Value::Float(x) => Some(x),
        Value::Int(x) => Some(x as f64),
        Value::Bool(on) => Some(if on { 1.0 } else { 0.0 }),
        Value::Text(id) => {
            let Kind::Choice { options } = &param(path).ok()?.spec.allowed else { return None };
            options.iter().position(|option| option.id == id).map(|at| (at + 1) as f64)
        }
        Value::List(_) => None,
    }
}

/// A step is one of the plant.
impl Job for Marking {
    type Partial = Option<MissionVerdict>;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        for (_, run) in &mut self.runs {
            if !Job::advance(run, budget) {
                return false;
            }
        }
        if let (Some(twin), Some((_, learners))) = (&mut self.twin, self.runs.first())
            && !twin.advance(learners, budget)
        {
            return false;
        }
        if self.verdict.is_none() {
            self.verdict = Some(self.judge());
        }
        true
    }

    fn progress(&self) -> Progress {
        let twin = self.twin.iter().map(|twin| twin.run().progress());
        let of_runs = self.runs.iter().map(|(_, run)| run.progress()).chain(twin);
        of_runs.fold(Progress { done: 0.0, total: 0.0, unit: text!("steps") }, |all, one| {
            Progress { done: all.done + one.done, total: all.total + one.total, unit: all.unit }
        })
    }

    fn partial(&self) -> Self::Partial {
        self.verdict.clone()
    }
}
