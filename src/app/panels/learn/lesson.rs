//! A mission under way.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use crate::app::clock;
use crate::app::jobs::{Jobs, Work};
use crate::app::session::Session;
use crate::base::language::text;
use crate::study::mission::{
    Marking, Mission, MissionAnswer, MissionError, MissionResult, MissionTries, MissionVerdict,
    Prediction,
};

/// Name of the work that marks an answer.
const MARKING: &str = text!("Marking of the mission");
/// Plant steps of the first slice of a marking.
const FIRST: u64 = 20_000;

/// What earlier beginnings of a mission have shown, as long as the program is open: who begins it again knows it.
#[derive(Clone)]
pub struct Past {
    /// Steps whose answer was seen.
    seen: BTreeSet<usize>,
    /// Predictions that were made before that.
    in_time: BTreeMap<usize, Prediction>,
    /// How often it was begun, with its cut seen, and checked.
    pub tries: MissionTries,
}

impl Default for Past {
    fn default() -> Self {
        let tries = MissionTries { begun: 0, checked: 0 };
        Self { seen: BTreeSet::new(), in_time: BTreeMap::new(), tries }
    }
}

impl Past {
    /// Notes that the whole cut of a mission was to be seen somewhere.
    pub fn see_all(&mut self, mission: &Mission) {
        let asked = mission.questions().filter(|(_, question)| !question.look_up);
        self.seen.extend(asked.map(|(step, _)| step));
    }
}

/// A mission with what the learner has done in it.
pub struct Lesson {
    /// The mission.
    pub mission: Mission,
    /// Predictions that were made, by the number of their step.
    predictions: BTreeMap<usize, Prediction>,
    /// What stands in a question and was not said yet.
    drafts: BTreeMap<usize, Prediction>,
    /// Steps whose question is left without an answer.
    skipped: BTreeSet<usize>,
    /// Steps whose answer the cut, or a check, has shown: a prediction of them is fixed.
    seen: BTreeSet<usize>,
    /// Those of them that were answered, or answered anew, after that.
    late: BTreeSet<usize>,
    /// What was known of it before.
    past: Past,
    /// Whether this beginning is counted among the tries: its cut was seen.
    counted: bool,
    /// The step under way, from 1 on.
    pub step: usize,
    /// Whether it is asked again if its question is to be left without an answer.
    pub leaves: bool,
    /// Whether the answer is to be handed in, once what was typed last is set.
    pub hands_in: bool,
    /// Hints that were asked for.
    pub hints: usize,
    marking: Option<Work<Marking>>,
    /// The answer that was handed in last.
    answer: Option<MissionAnswer>,
    /// How many changes the session had seen then.
    marked_at: u64,
    /// When the verdict came, ISO 8601.
    marked: String,
    /// What the last answer came to.
    pub verdict: Option<Arc<Option<MissionVerdict>>>,
    /// Whether the verdict was not shown yet.
    pub is_news: bool,
    /// Why the last answer was not marked.
    pub refused: Option<String>,
    /// Whether the session has taken the mission over.
    taken: bool,
}

impl Lesson {
    /// A mission at its beginning, of which this is known from before.
    #[must_use]
    pub fn new(mission: Mission, past: Past) -> Self {
        Self {
            mission,
            predictions: BTreeMap::new(),
            drafts: BTreeMap::new(),
            skipped: BTreeSet::new(),
            seen: BTreeSet::new(),
            late: BTreeSet::new(),
            past,
            counted: false,
            step: 1,
            leaves: false,
            hands_in: false,
            hints: 0,
            marking: None,
            answer: None,
            marked_at: 0,
            marked: String::new(),
            verdict: None,
            is_news: false,
            refused: None,
            taken: false,
        }
    }

    /// Whether the session has gone on to something else than this mission's cut.
    pub fn is_left(&mut self, session: &Session) -> bool {
        let here = session.mission().is_some_and(|lock| lock.title == self.mission.title);
        let left = self.taken && !here;
        self.taken |= here;
        left
    }

    /// The mission is put away: what is known of it from now on.
    #[must_use]
    pub fn into_past(mut self) -> Past {
        self.see();
        self.past.seen.extend(&self.seen);
        self.past
    }

    /// In which try this is.
    #[must_use]
    pub fn tries(&self) -> MissionTries {
        self.past.tries
    }

    /// Whether the question of a step is neither answered nor left.
    fn is_open(&self, step: usize) -> bool {
        let asks = self.mission.questions().any(|(number, _)| number == step);
        asks && !self.predictions.contains_key(&step) && !self.skipped.contains(&step)
    }

    /// Whether the step under way asks for an answer that is not given yet.
    #[must_use]
    pub fn asks(&self) -> bool {
        self.is_open(self.step)
    }

    /// Whether a prediction is asked for that is not made yet, here or in the steps that follow at once: the cut would
    /// tell it.
    #[must_use]
    pub fn hides_the_cut(&self) -> bool {
        let steps = (1..).zip(&self.mission.steps).skip(self.step - 1);
        let asked = steps.take_while(|(_, step)| {
            step.predict.as_ref().is_some_and(|question| !question.look_up)
        });
        asked.into_iter().any(|(step, _)| self.is_open(step))
    }

    /// Whether the cut is there to be tried: nothing is asked first.
    #[must_use]
    pub fn is_tried(&self) -> bool {
        !self.asks() && !self.hides_the_cut()
    }

    /// What stands in the question of the step under way.
    #[must_use]
    pub fn said(&self) -> Option<&Prediction> {
        self.drafts.get(&self.step).or_else(|| self.predictions.get(&self.step))
    }

    /// Whether something stands in it that was not said yet.
    #[must_use]
    pub fn has_draft(&self) -> bool {
        self.drafts.contains_key(&self.step)
    }

    /// Puts an answer into the question of the step under way; it is said by [`Self::say`].
    pub fn draft(&mut self, prediction: Prediction) {
        if self.predictions.get(&self.step) == Some(&prediction) {
            self.drafts.remove(&self.step);
        } else {
            self.drafts.insert(self.step, prediction);
        }
    }

    /// Takes what stands in the question of the step under way, and was not said, out of it.
    pub fn put_draft_away(&mut self) {
        self.drafts.remove(&self.step);
    }

    /// Says what stands in the question of the step under way.
    pub fn say(&mut self) {
        let step = self.step;
        if let Some(prediction) = self.drafts.remove(&step) {
            // Who has begun it before knows the cut; what was predicted in time then is still foreseen.
            let repeated = || self.past.in_time.get(&step) == Some(&prediction);
            if self.is_seen() || self.was_seen() && !repeated() {
                self.late.insert(step);
            } else {
                self.past.in_time.insert(step, prediction.clone());
            }
            self.predictions.insert(step, prediction);
            self.skipped.remove(&step);
            self.go_on();
        }
    }

    /// Leaves the question of the step under way without an answer.
    pub fn leave_open(&mut self) {
        self.drafts.remove(&self.step);
        self.skipped.insert(self.step);
        self.go_on();
    }

    /// Goes on to the next step, if there is one.
    pub fn go_on(&mut self) {
        self.leaves = false;
        self.step = (self.step + 1).min(self.mission.steps.len());
    }

    /// Whether the answer to the question of the step under way was seen.
    #[must_use]
    pub fn is_seen(&self) -> bool {
        self.seen.contains(&self.step)
    }

    /// Whether it was seen when the mission was begun before.
    #[must_use]
    pub fn was_seen(&self) -> bool {
        self.past.seen.contains(&self.step)
    }

    /// Whether that question was answered, or answered anew, after that.
    #[must_use]
    pub fn is_late(&self) -> bool {
        self.late.contains(&self.step)
    }

    /// Notes what the cut shows now: all that was to be predicted so far.
    fn see(&mut self) {
        if !self.hides_the_cut() {
            self.past.tries.begun += u32::from(!self.counted);
            self.counted = true;
            let asked = self.mission.questions().filter(|(_, question)| !question.look_up);
            let asked = asked.map(|(step, _)| step).filter(|step| *step <= self.step);
            self.seen.extend(asked.collect::<Vec<usize>>());
        }
    }

    /// Hands the answer in; what it comes to tells the answers to all questions.
    pub fn mark(&mut self, session: &Session, jobs: &Jobs) {
        self.hands_in = false;
        self.past.tries.checked += 1;
        self.seen.extend(self.mission.questions().map(|(step, _)| step));
        self.marked_at = session.changes();
        let answer = MissionAnswer {
            predictions: self.predictions.clone(),
            late: self.late.clone(),
            scenario: session.scenario().clone(),
            edits: session.edits().clone(),
        };
        self.verdict = None;
        self.answer = Some(answer.clone());
        match Marking::new(&self.mission, answer) {
            Ok(marking) => {
                self.marking = Some(jobs.begin_brief(MARKING, marking, FIRST));
                self.refused = None;
            }
            Err(error) => self.refused = Some(MissionError::to_string(&error)),
        }
    }

    /// Whether an answer is being marked.
    #[must_use]
    pub fn is_marked_now(&self) -> bool {
        self.marking.is_some()
    }

    /// Whether something was changed since the answer was handed in: the verdict is of before that.
    #[must_use]
    pub fn is_stale(&self, session: &Session) -> bool {
        let predictions = self.answer.as_ref().map(|answer| &answer.predictions);
        session.changes() != self.marked_at || predictions != Some(&self.predictions)
    }

    /// Takes the verdict when it is there; whether it has just come.
    pub fn refresh(&mut self) -> bool {
        self.see();
        let Some(work) = self.marking.as_ref().filter(|work| work.is_over()) else { return false };
        self.verdict = Some(work.partial());
        self.marking = None;
        self.marked = clock::utc();
        self.is_news = true;
        true
    }

    /// The result as a file has it, for the learner of this name.
    #[must_use]
    pub fn result(&self, name: &str) -> Option<MissionResult> {
        let verdict = Option::clone(self.verdict.as_deref()?)?;
        let answer = self.answer.as_ref()?;
        let result =
            MissionResult::new(&self.mission, answer, verdict, self.hints, self.marked.clone());
        Some(result.tried(self.tries()).named(name))
    }

    /// Puts the verdict away.
    pub fn close_verdict(&mut self) {
        (self.verdict, self.refused) = (None, None);
    }
}
