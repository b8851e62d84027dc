//! What an answer to a mission came to, condition by condition.

use serde::{Deserialize, Serialize};

use super::Mission;

/// What a condition of a mission came to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "when, sides, holds and otherwise")]
pub struct CheckVerdict {
    /// The condition as written.
    pub when: String,
    /// The values of its sides; none where there is none.
    pub sides: [Option<f64>; 2],
    /// Whether it holds.
    pub holds: bool,
    /// What the learner is told if not.
    pub otherwise: String,
}

/// What a prediction came to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "what a prediction came to")]
pub struct PredictionVerdict {
    /// The step, from 1 on.
    pub step: usize,
    /// Whether anything was predicted.
    pub answered: bool,
    /// Whether it was right.
    pub right: bool,
    /// Whether the mission asks for the right one.
    pub must: bool,
    /// Whether it came, or was changed, when the cut had been seen: then it does not count as foreseen.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub late: bool,
    /// What it was off by, percent, of a number or a curve: above 0 where a number was too high.
    pub off_percent: Option<f64>,
    /// The right answer in words, as far as the runs tell one.
    pub solution: String,
    /// What the learner is told.
    pub word: String,
}

impl PredictionVerdict {
    /// Whether it is right and was made before the cut had been seen: what the third star asks of every question.
    #[must_use]
    pub fn is_foreseen(&self) -> bool {
        self.right && !self.late
    }
}

/// What a condition for a star came to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "star, when, sides and holds")]
pub struct StarVerdict {
    /// The star that it is for, 2 or 3.
    pub star: u8,
    /// The condition as written.
    pub when: String,
    /// The values of its sides; none where there is none.
    pub sides: [Option<f64>; 2],
    /// Whether it holds.
    pub holds: bool,
}

/// What an answer came to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "what the answer came to")]
pub struct MissionVerdict {
    /// The mission.
    pub mission: String,
    /// Whether all checks hold, and all predictions that must.
    pub passed: bool,
    /// 0 if not passed, else 1 to 3.
    pub stars: u8,
    /// Predictions in the order of the steps.
    pub predictions: Vec<PredictionVerdict>,
    /// Checks in their order.
    pub checks: Vec<CheckVerdict>,
    /// The conditions for the second star and the third, beside predictions that were foreseen.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub stars_asked: Vec<StarVerdict>,
    /// What went wrong in the script of the learner's run, with its line, in the chosen language; so it stands in no
    /// file.
    #[serde(skip)]
    pub script_fault: Option<String>,
    /// Digest of the learner's run: who repeats it gets the same.
    pub digest: String,
}

impl MissionVerdict {
    /// What the learner is told of what is missing: of a script that failed first, since all else follows from it; then
    /// of predictions, as they came first.
    pub fn words(&self) -> impl Iterator<Item = &str> {
        let wrong = self.predictions.iter().filter(|prediction| !prediction.right);
        let unmet = self.checks.iter().filter(|check| !check.holds);
        let wrong = wrong.map(|prediction| prediction.word.as_str());
        let fault = self.script_fault.iter().map(String::as_str);
        fault
            .chain(wrong)
            .chain(unmet.map(|check| check.otherwise.as_str()))
            .filter(|word| !word.is_empty())
    }

    /// Whether all questions were answered rightly before the cut had been seen.
    #[must_use]
    pub fn is_foreseen(&self) -> bool {
        self.predictions.iter().all(PredictionVerdict::is_foreseen)
    }

    /// The same as a learner may keep it: as long as it is not passed without the right answers, and without how far
    /// numbers are off, which with the number itself gives the right one away.
    #[must_use]
    pub fn withheld(mut self, mission: &Mission) -> Self {
        if self.passed {
            return self;
        }
        for prediction in &mut self.predictions {
            prediction.solution.clear();
            let question = mission.questions().find(|(step, _)| *step == prediction.step);
            if question.is_some_and(|(_, question)| question.kind.is_number()) {
                prediction.off_percent = None;
            }
        }
        self
    }

    /// The same without what `kept` leaves out of it: right answers, how far they are off, and the conditions for
    /// stars, which files of before have none of.
    pub(super) fn limited_to(mut self, kept: &Self) -> Self {
        for (own, kept) in self.predictions.iter_mut().zip(&kept.predictions) {
            if kept.solution.is_empty() {
                own.solution.clear();
            }
            if kept.off_percent.is_none() {
                own.off_percent = None;
            }
        }
        if kept.stars_asked.is_empty() {
            self.stars_asked.clear();
        }
        self
    }
}
