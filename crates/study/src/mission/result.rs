//! What came of a mission, as a file: JSON that `steadycut mission check` marks again, so that a result which was
//! edited by hand is found out.
//!
//! | entry | what stands there |
//! | --- | --- |
//! | `format`, `version` | `steadycut mission result`, 1 |
//! | `mission` | `id`, `title` and `digest` (XXH3 of its text without comments) |
//! | `name` | the learner's, as typed; left out where nothing was |
//! | `answer` | `predictions` (as in an answer's file; `late` are those that came when the cut had been seen) and `link`, the cut as the learner left it |
//! | `verdict` | `passed`, `stars`, `predictions`, `checks` and `stars_asked` with both sides as measured, `digest` of the cut; right answers only where it is passed |
//! | `hints` | how many were asked for |
//! | `tries` | `begun`, how often the mission was begun and its cut seen since the program was opened, and `checked`, how often an answer was handed in |
//! | `marked` | when, ISO 8601 in UTC |
//! | `program` | version of the program |

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::answer::{PredictionText, predictions};
use super::{Mission, MissionAnswer, MissionError, MissionVerdict, shipped};
use crate::base::files::from_json;
use crate::base::language::tr;
use crate::run::scenario_link;

/// What tells such a file from others.
const FORMAT: &str = "steadycut mission result";
/// Version of the format.
const RESULT_VERSION: u32 = 1;
/// Longest result that is read, bytes.
const MAX_BYTES: usize = 4_000_000;
/// Longest name of a learner, characters.
const MAX_NAME: usize = 200;

/// See the head of the module.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a mission's result")]
pub struct MissionResult {
    format: String,
    version: u32,
    /// The mission.
    pub mission: ResultOf,
    /// The learner's name, if one was typed.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub name: String,
    answer: ResultAnswer,
    /// What the answer came to.
    pub verdict: MissionVerdict,
    /// Hints that were asked for.
    pub hints: usize,
    /// In which try that was.
    #[serde(default)]
    pub tries: MissionTries,
    /// When it was marked, ISO 8601 in UTC.
    pub marked: String,
    /// Version of the program that marked it.
    pub program: String,
}

/// How often a mission was tried since the program was opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "begun and checked")]
pub struct MissionTries {
    /// How often it was begun and its cut seen.
    pub begun: u32,
    /// How often an answer was handed in.
    pub checked: u32,
}

/// What a result tells of itself: it was begun, and checked.
impl Default for MissionTries {
    fn default() -> Self {
        Self { begun: 1, checked: 1 }
    }
}

/// Which mission a result is of.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "id, title and digest")]
pub struct ResultOf {
    /// Its id.
    pub id: String,
    /// Its name for people.
    pub title: String,
    /// Its [`Mission::digest`].
    pub digest: String,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "predictions and link")]
struct ResultAnswer {
    #[serde(default)]
    predictions: Vec<PredictionText>,
    link: String,
}

impl MissionResult {
    /// The result of an answer that came to `verdict` after so many hints, at a time in ISO 8601, in the first try.
    /// What of the verdict gives right answers away is left out as long as it is not passed.
    #[must_use]
    pub fn new(
        mission: &Mission,
        answer: &MissionAnswer,
        verdict: MissionVerdict,
        hints: usize,
        marked: String,
    ) -> Self {
        let Mission { id, title, .. } = mission;
        Self {
            format: FORMAT.to_owned(),
            version: RESULT_VERSION,
            mission: ResultOf { id: id.clone(), title: title.clone(), digest: mission.digest() },
            name: String::new(),
            answer: ResultAnswer {
                predictions: (answer.predictions.iter())
                    .map(|(step, prediction)| {
                        PredictionText::of(*step, prediction, answer.late.contains(step))
                    })
                    .collect(),
                link: scenario_link::write(&answer.scenario, &answer.edits),
            },
            verdict: verdict.withheld(mission),
            hints,
            tries: MissionTries::default(),
            marked,
            program: env!("CARGO_PKG_VERSION").to_owned(),
        }
    }

    /// The same with the learner's name.
    #[must_use]
    pub fn named(self, name: &str) -> Self {
        Self { name: name.trim().chars().take(MAX_NAME).collect(), ..self }
    }

    /// The same, of this try.
    #[must_use]
    pub fn tried(self, tries: MissionTries) -> Self {
        Self { tries, ..self }
    }

    /// Under which name its stars are kept: the id of a shipped mission; for any other, which may have the id of a
    /// shipped one, the digest as well.
    #[must_use]
    pub fn kept_as(&self) -> String {
        let ResultOf { id, digest, .. } = &self.mission;
        match shipped::load(id).is_ok_and(|mission| mission.digest() == *digest) {
            true => id.clone(),
            false => format!("{id}@{digest}"),
        }
    }

    /// Whether a text is meant as one.
    #[must_use]
    pub fn is_meant_by(text: &str) -> bool {
        text.trim_start().starts_with('{') && text.contains(FORMAT)
    }

    /// Reads one.
    ///
    /// # Errors
    /// Names the entry, what stands there, and what is allowed.
    pub fn read(text: &str) -> Result<Self, String> {
        #[derive(Deserialize)]
        #[serde(expecting = "a mission's result")]
        struct Head {
            version: u32,
        }
        if text.len() > MAX_BYTES {
            return Err(tr!(
                "{bytes} bytes; at most {most} are read",
                bytes = text.len(),
                most = MAX_BYTES
            ));
        }
        // The version comes first: a file of another version may hold anything.
        let Head { version } = from_json(text)?;
        if version != RESULT_VERSION {
            return Err(tr!(
                "`version` is {version}: allowed is {allowed}",
                version = version,
                allowed = RESULT_VERSION
            ));
        }
        let result: Self = from_json(text)?;
        if result.format != FORMAT {
            let format: String = result.format.chars().take(60).collect();
            return Err(tr!(
                "`format` is `{format}`: allowed is `{allowed}`",
                format = format,
                allowed = FORMAT
            ));
        }
        Ok(result)
    }

    /// The file's text.
    #[must_use]
    pub fn write(&self) -> String {
        // There is nothing in it that JSON cannot hold.
        let text = serde_json::to_string_pretty(self).unwrap_or_default();
        format!("{text}\n")
    }

    /// The answer in it, to be marked again.
    ///
    /// # Errors
    /// It is of another mission, or the answer does not fit it.
    pub fn answer(&self, mission: &Mission) -> Result<MissionAnswer, MissionError> {
        let of = &self.mission;
        if of.id != mission.id {
            let problem = tr!(
                "`mission` is `{found}`: this mission is `{own}`",
                found = of.id,
                own = mission.id
            );
            return Err(MissionError::of_answer(problem));
        }
        if of.digest != mission.digest() {
            let problem = tr!(
                "`mission.digest` is {found}: this mission's is {own}; they differ in more than comments",
                found = of.digest,
                own = mission.digest()
            );
            return Err(MissionError::of_answer(problem));
        }
        let read = || -> Result<MissionAnswer, String> {
            let (predictions, late) = predictions(self.answer.predictions.clone())?;
            let (scenario, edits) = scenario_link::parse(&self.answer.link)
                .map_err(|error| format!("`answer.link`: {error}"))?;
            Ok(MissionAnswer { predictions, late, scenario, edits })
        };
        let answer = read().map_err(MissionError::of_answer)?;
        answer.check(mission)?;
        Ok(answer)
    }

    /// Where the result says something else than the verdict that its answer comes to: entry, what it says, and what
    /// is found. Empty if it is true; what it leaves out is not untrue.
    #[must_use]
    pub fn untrue(&self, found: &MissionVerdict) -> Vec<String> {
        let value = |verdict: &MissionVerdict| serde_json::to_value(verdict).unwrap_or_default();
        let mut untrue = Vec::new();
        let found = found.clone().limited_to(&self.verdict);
        differ("verdict", &value(&self.verdict), &value(&found), &mut untrue);
        untrue
    }
}

/// Adds where two values differ, entry by entry.
fn differ(entry: &str, says: &Value, is: &Value, found: &mut Vec<String>) {
    if let (Value::Object(says), Value::Object(is)) = (says, is) {
        for (name, says) in says {
            differ(&format!("{entry}.{name}"), says, &is[name], found);
        }
        return;
    }
    if let (Value::Array(says), Value::Array(is)) = (says, is)
        && says.len() == is.len()
    {
        for (number, (says, is)) in (1..).zip(says.iter().zip(is)) {
            differ(&format!("{entry}[{number}]"), says, is, found);
        }
        return;
    }
    if says != is {
        let clip = |value: &Value| value.to_string().chars().take(80).collect::<String>();
        found.push(tr!(
            "`{entry}` says {said}: the answer gives {found}",
            entry = entry,
            said = clip(says),
            found = clip(is)
        ));
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Marking, Prediction, TEMPLATE};
    use super::*;
    use crate::run::job::Job;

    fn marked(mission: &Mission, answer: &MissionAnswer) -> MissionVerdict {
        let mut marking = Marking::new(mission, answer.clone()).unwrap();
        marking.to_end();
        marking.partial().unwrap()
    }

    fn result() -> (Mission, MissionResult) {
        let mission = shipped::load("depth-step-at-constant-feed").unwrap();
        let text = include_str!("../../tests/data/missions/depth-step-at-constant-feed.right.toml");
        let mut answer = MissionAnswer::read(text, &mission).unwrap();
        answer.predictions.insert(1, Prediction::Choice(1));
        let verdict = marked(&mission, &answer);
        let time = "2026-01-02T03:04:05Z".to_owned();
        let result = MissionResult::new(&mission, &answer, verdict, 2, time);
        (mission, result.named(" Ada "))
    }

    #[test]
    fn a_result_is_read_marked_again_and_found_true() {
        let (mission, result) = result();
        let text = result.write();
        assert!(MissionResult::is_meant_by(&text));
        let read = MissionResult::read(&text).unwrap();
        assert_eq!(read, result);
        assert_eq!((read.name.as_str(), read.hints), ("Ada", 2));
        let verdict = marked(&mission, &read.answer(&mission).unwrap());
        assert_eq!(read.untrue(&verdict), [""; 0]);
        assert_eq!(read.kept_as(), mission.id);
        let mut own = read;
        own.mission.digest = "0".repeat(16);
        assert_eq!(own.kept_as(), format!("{}@{}", mission.id, own.mission.digest));
    }

    /// A number of the mission `gain-leaves-an-error`, and the verdict on it with a gain.
    fn of_a_number(number: f64, kp: f64) -> (Mission, MissionAnswer, MissionVerdict) {
        let mission = shipped::load("gain-leaves-an-error").unwrap();
        let mut answer = MissionAnswer::untouched(&mission);
        answer.predictions.insert(2, Prediction::Number(number));
        answer.scenario.change(|settings| settings.controller.sdnrp.kp = kp).unwrap();
        let verdict = marked(&mission, &answer);
        (mission, answer, verdict)
    }

    /// A file that is not passed holds no right answer, nor what one could be worked out of; it is verified all the same.
    #[test]
    fn a_file_holds_right_answers_only_once_it_is_passed() {
        let (mission, answer, verdict) = of_a_number(3.0, 1.0);
        let solution = verdict.predictions[1].solution.clone();
        assert!(!verdict.passed && solution.ends_with('%'), "{verdict:?}");
        assert!(verdict.predictions[1].off_percent.is_some_and(|off| off < -50.0), "{verdict:?}");
        let time = || "2026-01-02T03:04:05Z".to_owned();
        let result = MissionResult::new(&mission, &answer, verdict.clone(), 0, time());
        let text = result.write();
        for prediction in &result.verdict.predictions {
            assert!(prediction.solution.is_empty() && prediction.off_percent.is_none(), "{text}");
        }
        assert!(!text.contains(solution.split(' ').next().unwrap()), "{text}");
        let read = MissionResult::read(&text).unwrap();
        assert_eq!(read.untrue(&verdict), [""; 0]);
        // A right answer that was written in by hand is found out all the same.
        let mut forged = read;
        forged.verdict.predictions[1].solution = "3 %".to_owned();
        assert_eq!(forged.untrue(&verdict).len(), 1);

        let (mission, answer, verdict) = of_a_number(3.0, 2.0);
        assert!(verdict.passed, "{verdict:?}");
        let result = MissionResult::new(&mission, &answer, verdict.clone(), 0, time());
        assert_eq!(result.verdict, verdict);
    }

    #[test]
    fn a_result_tells_in_which_try_it_was() {
        let (_, result) = result();
        assert_eq!(result.tries, MissionTries { begun: 1, checked: 1 });
        let text = result.tried(MissionTries { begun: 2, checked: 5 }).write();
        let read = MissionResult::read(&text).unwrap();
        assert_eq!((read.tries.begun, read.tries.checked), (2, 5));
        // A file of before counts none.
        let mut old: Value = serde_json::from_str(&text).unwrap();
        old.as_object_mut().unwrap().remove("tries");
        old["verdict"].as_object_mut().unwrap().remove("stars_asked");
        let old = MissionResult::read(&old.to_string()).unwrap();
        assert_eq!(old.tries, MissionTries::default());
        let mission = shipped::load("depth-step-at-constant-feed").unwrap();
        let found = marked(&mission, &old.answer(&mission).unwrap());
        assert_eq!(old.untrue(&found), [""; 0]);
    }

    #[test]
    fn what_was_edited_by_hand_is_found_out() {
        let (mission, mut result) = result();
        let verdict = marked(&mission, &result.answer(&mission).unwrap());
        let stars = result.verdict.stars;
        result.verdict.stars = stars % 3 + 1;
        result.verdict.checks[0].sides[0] = Some(-1.0);
        let untrue = MissionResult::read(&result.write()).unwrap().untrue(&verdict);
        assert_eq!(untrue.len(), 2, "{untrue:?}");
        assert!(untrue.iter().any(|said| said.contains("`verdict.stars` says")), "{untrue:?}");
        assert!(
            untrue.iter().any(|said| said.contains("checks[1].sides[1]` says -1")),
            "{untrue:?}"
        );
        // The cut itself edited: what it gives is another digest.
        let given = scenario_link::write(&mission.scenario, &mission.edits);
        let idle =
            MissionResult { answer: ResultAnswer { link: given, predictions: vec![] }, ..result };
        let found = marked(&mission, &idle.answer(&mission).unwrap());
        assert!(idle.untrue(&found).iter().any(|said| said.contains("verdict.digest")));
    }

    #[test]
    fn what_is_wrong_in_a_result_is_named() {
        let (mission, result) = result();
        let text = result.write();
        let said = |text: &str| MissionResult::read(text).unwrap_err();
        assert!(said(&text.replace("\"version\": 1", "\"version\": 9")).contains("allowed is 1"));
        assert!(said(&text.replace("\"hints\": 2", "\"hints\": -2")).contains("`hints`"));
        assert!(said(&text.replace("\"hints\"", "\"hint\"")).contains("hint"));
        assert!(said("[]").contains("a mission's result"));
        let other = Mission::read(TEMPLATE).unwrap();
        let problem = result.answer(&other).unwrap_err().to_string();
        assert!(problem.contains("`my-mission`"), "{problem}");
        let mut changed = result.clone();
        changed.mission.digest = "0".repeat(16);
        let problem = changed.answer(&mission).unwrap_err().to_string();
        assert!(problem.contains("mission.digest"), "{problem}");
        let mut closed = result;
        closed.answer.link = "v=1&target.ra_um=3".to_owned();
        let problem = closed.answer(&mission).unwrap_err().to_string();
        assert!(problem.contains("the mission opens"), "{problem}");
    }
}
