//! Missions: lessons on the closed loop as data. A mission tells a story, gives the learner a cut and some of its
//! settings, asks for predictions before the cut, and checks what came out of it by conditions over metrics,
//! signals and what the learner did.
//!
//! [`Mission::read`] reads the file; [`Marking`] runs the learner's cut, and those that it is compared with, and
//! gives the [`MissionVerdict`]. Command line, window and page use the same code.
//!
//! ```
//! use steadycut_core::run::job::Job;
//! use steadycut_study::mission::{MissionAnswer, Marking, shipped};
//!
//! let mission = shipped::load("depth-step-at-constant-feed").unwrap();
//! // Nothing predicted, nothing changed: the goal is not reached, and it says why.
//! let mut marking = Marking::new(&mission, MissionAnswer::untouched(&mission)).unwrap();
//! marking.to_end();
//! let verdict = marking.partial().unwrap();
//! assert!(!verdict.passed);
//! assert!(verdict.words().next().is_some());
//! ```

mod answer;
mod condition;
mod cut;
mod file;
mod link;
mod marking;
mod result;
pub mod shipped;
mod template;
mod value;
mod verdict;
mod words;

use std::collections::BTreeMap;

use serde::Serialize;

pub use answer::{MissionAnswer, Prediction};
pub use condition::{Condition, Quantity, Relation, Values};
pub use link::{PACKED, SHIPPED, of_link};
pub use marking::Marking;
pub use result::{MissionResult, MissionTries, ResultOf};
pub use template::TEMPLATE;
pub use value::{MissionValue, RunOf, Taken, Window};
pub use verdict::{CheckVerdict, MissionVerdict, PredictionVerdict, StarVerdict};
pub use words::WriteNumber;

use crate::base::language::{text, tr};
use crate::base::settings::Value;
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;

/// Version of the format of missions.
pub const MISSION_VERSION: i64 = 1;

/// Most stars that a mission gives.
pub const MOST_STARS: u8 = 3;

/// What is wrong with a mission, or with an answer to one: where, what, and what is allowed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}: {problem}", tr(what))]
pub struct MissionError {
    /// What was read: a mission or an answer.
    what: &'static str,
    /// What is wrong, with the entry and its line where there is one.
    problem: String,
}

impl MissionError {
    fn of_mission(problem: impl Into<String>) -> Self {
        Self { what: text!("mission"), problem: problem.into() }
    }

    fn of_answer(problem: impl Into<String>) -> Self {
        Self { what: text!("answer"), problem: problem.into() }
    }
}

/// A lesson that is checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Mission {
    /// The text that it was read from.
    pub text: String,
    /// Its name in files, links and lists.
    pub id: String,
    /// Its name for people.
    pub title: String,
    /// What it teaches, in one line.
    pub about: String,
    /// About how long it takes, min.
    pub minutes: u32,
    /// What happens in the shop.
    pub story: String,
    /// What the learner is to reach.
    pub goal: String,
    /// The cut that the learner is given.
    pub scenario: Scenario,
    /// Changes during that cut, which happen whatever the learner does.
    pub edits: Edits,
    /// What the learner may touch.
    pub controls: Controls,
    /// What is done, in order.
    pub steps: Vec<MissionStep>,
    /// Hints, the least telling first.
    pub hints: Vec<String>,
    /// Named values that conditions and predictions read, beside the metrics.
    pub values: BTreeMap<String, MissionValue>,
    /// All of these must hold.
    pub checks: Vec<Check>,
    /// What gives the second star, and the third beside it.
    pub stars: [Vec<Condition>; 2],
    /// What there is to learn from it.
    pub debrief: Debrief,
}

/// What of the program a mission shows and lets be changed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Controls {
    /// Settings that the learner may change.
    pub open: Vec<String>,
    /// Settings that are shown and cannot be changed. All others are hidden.
    pub locked: Vec<String>,
    /// Of open settings that are a choice: the ids of the options that are offered. All where nothing is said.
    pub options: BTreeMap<String, Vec<String>>,
}

/// One step of a mission.
#[derive(Clone, Debug, PartialEq)]
pub struct MissionStep {
    /// What is done.
    pub title: String,
    /// More on it.
    pub text: String,
    /// What is predicted in it, before the cut shows it.
    pub predict: Option<Question>,
}

/// A prediction that is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// The question.
    pub ask: String,
    /// Whether the mission is passed only with the right answer.
    pub must: bool,
    /// Whether the answer is to be looked up: then the cut and all screens are open before it is given.
    pub look_up: bool,
    /// How it is answered.
    pub kind: QuestionKind,
    /// What a wrong answer is told.
    pub otherwise: String,
}

/// How a prediction is made, and which one is right.
#[derive(Clone, Debug, PartialEq)]
pub enum QuestionKind {
    /// One of several.
    Choice(Vec<ChoiceOption>),
    /// A number.
    Number {
        /// Its unit as text.
        unit: String,
        /// The right one: a formula over values and metrics.
        right: Quantity,
        /// Most that it may be off by, percent of the right one.
        tolerance_percent: f64,
    },
    /// A curve of a signal over time, sketched by hand.
    Curve {
        /// The signal, of which run and in which part of it.
        of: MissionValue,
        /// Root mean square that it may be off by, percent of the largest less the smallest value of the curve
        /// and zero.
        tolerance_percent: f64,
    },
}

impl QuestionKind {
    /// Whether a number is asked for.
    #[must_use]
    pub fn is_number(&self) -> bool {
        matches!(self, Self::Number { .. })
    }
}

/// One of the answers to choose from.
#[derive(Clone, Debug, PartialEq)]
pub struct ChoiceOption {
    /// What it says.
    pub text: String,
    /// Whether it is right.
    pub right: RightIf,
    /// What who chooses it is told.
    pub word: String,
}

/// When an answer is right.
#[derive(Clone, Debug, PartialEq)]
pub enum RightIf {
    /// Always or never.
    Known(bool),
    /// If the runs say so.
    Holds(Condition),
}

/// A condition that must hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// The condition.
    pub when: Condition,
    /// What who does not meet it is told.
    pub otherwise: String,
}

/// What there is to learn from a mission.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Debrief {
    /// The lesson.
    pub text: String,
    /// The formula behind it.
    pub formula: String,
    /// Where it comes from.
    pub source: String,
}

impl Mission {
    /// Reads a mission.
    ///
    /// # Errors
    /// Names the entry, its line, and what is allowed.
    pub fn read(text: &str) -> Result<Self, MissionError> {
        file::read(text)
    }

    /// Whether a text is meant as a mission rather than as a scenario: it has what only missions have.
    #[must_use]
    pub fn is_meant_by(text: &str) -> bool {
        let head = |line: &str| line.trim_start().starts_with("[[checks]]");
        text.lines().any(head) && text.lines().any(|line| line.trim_start().starts_with("goal"))
    }

    /// The questions with the numbers of their steps, counted from 1.
    pub fn questions(&self) -> impl Iterator<Item = (usize, &Question)> {
        (1..).zip(&self.steps).filter_map(|(number, step)| Some((number, step.predict.as_ref()?)))
    }

    /// Whether the learner may change a setting.
    #[must_use]
    pub fn is_open(&self, path: &str) -> bool {
        self.controls.open.iter().any(|open| open == path)
    }

    /// Whether the mission offers this value of a setting.
    ///
    /// # Errors
    /// It does not: the value, and the options that there are.
    pub fn offers(&self, path: &str, value: &Value) -> Result<(), String> {
        let (Some(options), Value::Text(id)) = (self.controls.options.get(path), value) else {
            return Ok(());
        };
        if options.contains(id) {
            return Ok(());
        }
        Err(tr!(
            "`{path}` is set to {value}: the mission offers {list}",
            path = path,
            value = id,
            list = options.join(", ")
        ))
    }
}
