//! A cut driven by hand against every way of control: the same part, the same noise seed, and what was changed in
//! the running cut met at the same places. Ranked is only who holds the tolerance over the whole part.

use std::sync::Arc;

use serde::Serialize;

use super::entrants::{Entrant, Method, OWN, methods, methods_and_own};
use super::outcome::Outcome;
use crate::base::language::{text, tr};
use crate::blocks::control::ControllerKind;
use crate::blocks::control::script::ScriptSettings;
use crate::blocks::reference::Reference;
use crate::run::constant_feed_twin::TwinBeside;
use crate::run::edits::Edits;
use crate::run::job::{Budget, Job, Progress};
use crate::run::metrics::HELD_PERCENT;
use crate::run::one_run::Run;
use crate::run::parts::{Making, Parts};
use crate::run::scenario::Scenario;

/// The setting that a hand turns: the feed override where no controller has the feed.
pub const HAND: &str = "controller.constant_feed.feed_percent";
/// Name of the hand's row.
pub const YOUR_HAND: &str = text!("Your hand");
/// Times that differ by less are the same in words, s: half of what is written.
const SAME_S: f64 = 0.05;

/// Whether a cut is driven by hand: the override was turned while it was cut.
#[must_use]
pub fn is_by_hand(edits: &Edits) -> bool {
    edits.list().iter().any(|edit| edit.path == HAND)
}

/// A row of the score.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Scored {
    /// Who cut.
    pub name: String,
    /// Id of the way of control; none for the hand.
    pub id: Option<&'static str>,
    /// What the cut gave.
    pub outcome: Outcome,
    /// Whether the part is cut to its end, with what is held in tolerance on [`HELD_PERCENT`] of its length.
    pub holds: bool,
    /// Place by time among those who hold the tolerance, from 1 on; none for the others.
    pub rank: Option<usize>,
}

/// The score so far.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct HandScore {
    /// The hand first, then the ways of control in the order of the comparison.
    pub rows: Vec<Scored>,
    /// What it comes to, in a sentence, once everybody has cut.
    pub verdict: Option<String>,
}

impl HandScore {
    /// The rows as they are told: those with a rank first, by it, the others by what they hold.
    #[must_use]
    pub fn in_order(&self) -> Vec<&Scored> {
        let mut rows: Vec<&Scored> = self.rows.iter().collect();
        let inside = |row: &Scored| row.outcome.in_tolerance_percent.unwrap_or(0.0);
        rows.sort_by(|a, b| {
            let by_rank = a.rank.unwrap_or(usize::MAX).cmp(&b.rank.unwrap_or(usize::MAX));
            by_rank.then(inside(b).total_cmp(&inside(a)))
        });
        rows
    }
}

/// Another way of control on the part, beside the hand's cut.
#[derive(Clone, Debug)]
struct PartCut {
    hand: Arc<Run>,
    beside: TwinBeside,
}

impl Job for PartCut {
    type Partial = ();

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        self.beside.advance(&self.hand, budget)
    }

    fn progress(&self) -> Progress {
        self.beside.run().progress()
    }

    fn partial(&self) {}
}

/// The score of a cut driven by hand, as a job.
///
/// ```
/// use steadycut_core::base::settings::Value;
/// use steadycut_core::run::{edits::{Edit, Edits}, job::Job, presets};
/// use steadycut_study::compare::by_hand::{HAND, ByHandJob};
///
/// let part = presets::load("depth-step").unwrap();
/// let scenario = ByHandJob::without_control(&part);
/// let mut edits = Edits::none();
/// for (at_s, percent) in [(0.0, 74.0), (8.3, 44.0), (21.0, 74.0)] {
///     let turn = Edit { at_s, path: HAND.to_owned(), value: Value::Float(percent) };
///     edits.push(&scenario, turn).unwrap();
/// }
/// let mut job = ByHandJob::new(&scenario, &edits);
/// job.to_end();
/// let score = job.partial();
/// assert!(score.rows[0].holds && score.rows[0].rank.is_some());
/// assert!(score.verdict.unwrap().starts_with("You held Ra in tolerance on 9"));
/// ```
#[derive(Clone, Debug)]
pub struct ByHandJob {
    hand: Arc<Run>,
    /// What the hand's cut gave, once it is over.
    own: Option<Outcome>,
    entrants: Vec<(&'static Method, Entrant)>,
    others: Parts<PartCut, Outcome>,
}

impl ByHandJob {
    /// The scenario of a part as a hand cuts it: no controller, and the override at 100 % at first.
    ///
    /// # Panics
    /// Never: constant feed goes with any scenario.
    #[must_use]
    pub fn without_control(part: &Scenario) -> Scenario {
        let by_hand = part.with(|settings| {
            settings.controller.kind = ControllerKind::ConstantFeed;
            settings.controller.constant_feed.feed_percent = 100.0;
        });
        by_hand.expect("constant feed goes with any scenario")
    }

    /// The score of the cut of a scenario with the edits of a hand, not yet begun.
    #[must_use]
    pub fn new(scenario: &Scenario, edits: &Edits) -> Self {
        Self::against(scenario, edits, None)
    }

    /// The same score with a script of one's own among the others, where there is one.
    #[must_use]
    pub fn against(scenario: &Scenario, edits: &Edits, script: Option<&ScriptSettings>) -> Self {
        // A scenario may begin at another override than the programmed one: that is the hand's, not the others'.
        let part = Self::without_control(scenario);
        let brought = methods().map(|method| (method, method.on(&part)));
        let own = OWN.iter().filter_map(|method| {
            let script = script?;
            Some((method, method.on(&with_script(&part, script))))
        });
        let entrants = brought.chain(own).collect();
        let hand = Arc::new(Run::new(scenario, edits));
        Self { hand, own: None, entrants, others: Parts::default() }
    }

    /// Scenario of a way of control by its id, as it is scored; a script of one's own only where there is one.
    #[must_use]
    pub fn entrant(
        scenario: &Scenario,
        script: Option<&ScriptSettings>,
        id: &str,
    ) -> Option<Entrant> {
        let method = methods_and_own().find(|method| method.id == id)?;
        let part = Self::without_control(scenario);
        if !OWN.iter().any(|own| own.id == id) {
            return Some(method.on(&part));
        }
        script.map(|script| method.on(&with_script(&part, script)))
    }

    fn score(&self) -> HandScore {
        let Some(own) = &self.own else { return HandScore::default() };
        let hand = row(YOUR_HAND, None, own.clone());
        let others = self.others.done().iter().zip(&self.entrants);
        let others = others.map(|(outcome, (method, entrant))| {
            row(&entrant.name, Some(method.id), outcome.clone())
        });
        let mut rows: Vec<Scored> = std::iter::once(hand).chain(others).collect();
        rank(&mut rows);
        let over = self.others.done().len() == self.entrants.len();
        let reference = self.hand.scenario().target.reference;
        let verdict = over.then(|| verdict(&rows, &self.hand, reference));
        HandScore { rows, verdict }
    }
}

/// A part whose script is this one.
fn with_script(part: &Scenario, script: &ScriptSettings) -> Scenario {
    let own = part.with(|settings| settings.controller.script = script.clone());
    own.expect("no rule joins a script with other settings")
}

fn row(name: &str, id: Option<&'static str>, outcome: Outcome) -> Scored {
    let inside = outcome.in_tolerance_percent;
    let holds = outcome.time_s.is_some() && inside.is_some_and(|share| share >= HELD_PERCENT);
    Scored { name: name.to_owned(), id, outcome, holds, rank: None }
}

/// Ranks those who hold the tolerance by their time; who takes the same time has the same rank.
fn rank(rows: &mut [Scored]) {
    let times: Vec<f64> =
        rows.iter().filter(|row| row.holds).filter_map(|row| row.outcome.time_s).collect();
    for row in rows.iter_mut().filter(|row| row.holds) {
        let faster = |own_s: f64| times.iter().filter(|time_s| **time_s < own_s).count();
        row.rank = row.outcome.time_s.map(|own_s| faster(own_s) + 1);
    }
}

/// What it comes to: whether the hand held the tolerance, its rank, and how far the fastest of the others is.
fn verdict(rows: &[Scored], hand: &Run, reference: Reference) -> String {
    let [own, others @ ..] = rows else { return String::new() };
    let holding = others.iter().filter(|row| row.holds);
    let count = holding.clone().count();
    let time_s = |row: &Scored| row.outcome.time_s.unwrap_or(f64::INFINITY);
    let fastest = holding.min_by(|a, b| time_s(a).total_cmp(&time_s(b)));
    let best = match fastest {
        Some(best) if count == 1 => {
            tr!("{name} alone holds it, in {time:.1} s", name = tr(&best.name), time = time_s(best))
        }
        Some(best) => {
            tr!(
                "{count} ways of control hold it, {name} the fastest in {time:.1} s",
                count = count,
                name = tr(&best.name),
                time = time_s(best)
            )
        }
        None => tr("no way of control holds it either").to_owned(),
    };
    if own.outcome.time_s.is_none() {
        let why = hand.end().map_or_else(String::new, ToString::to_string);
        return tr!(
            "Your cut did not come to its end, so it has no rank ({why}); {best}.",
            why = why,
            best = best
        );
    }
    let Some(inside) = own.outcome.in_tolerance_percent else {
        return tr!("Nothing of your cut can be judged, so it has no rank; {best}.", best = best);
    };
    let Some(rank) = own.rank else {
        return match reference {
            Reference::Ra => tr!(
                "You held Ra in tolerance on {inside:.1} % of the length, and {asked:.0} % are asked for: no rank; {best}.",
                inside = inside,
                asked = HELD_PERCENT,
                best = best
            ),
            Reference::Force => tr!(
                "You held the force in tolerance on {inside:.1} % of the length, and {asked:.0} % are asked for: no rank; {best}.",
                inside = inside,
                asked = HELD_PERCENT,
                best = best
            ),
        };
    };
    let begin = match reference {
        Reference::Ra => {
            tr!("You held Ra in tolerance on {inside:.1} % of the length", inside = inside)
        }
        Reference::Force => {
            tr!("You held the force in tolerance on {inside:.1} % of the length", inside = inside)
        }
    };
    match fastest {
        None => {
            tr!("{begin}, and no way of control holds it: the cut is yours.", begin = begin)
        }
        Some(best) => {
            let (behind_s, name) = (time_s(own) - time_s(best), tr(&best.name));
            let than = match () {
                () if behind_s.abs() < SAME_S => tr!("as fast as {name}", name = name),
                () if behind_s > 0.0 => {
                    tr!("{time:.1} s slower than {name}", time = behind_s, name = name)
                }
                () => tr!("{time:.1} s faster than {name}", time = -behind_s, name = name),
            };
            tr!(
                "{begin} and come in as number {rank} of the {of} who hold it: {than}, the fastest of the controllers.",
                begin = begin,
                rank = rank,
                of = count + 1,
                than = than
            )
        }
    }
}

/// A step is one of the plant.
impl Job for ByHandJob {
    type Partial = HandScore;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        if self.own.is_none() {
            if !Job::advance(Arc::make_mut(&mut self.hand), budget) {
                return false;
            }
            self.own = Some(Outcome::of(&self.hand));
        }
        let (hand, entrants) = (&self.hand, &self.entrants);
        let begin = |index: usize| {
            let beside = TwinBeside::of(&entrants[index].1.scenario);
            Ok(PartCut { hand: Arc::clone(hand), beside })
        };
        let end = |_: usize, cut: &PartCut| Outcome::of(cut.beside.run());
        self.others.advance(entrants.len(), budget, &Making { begin: &begin, end: &end })
    }

    fn progress(&self) -> Progress {
        let own = self.hand.progress().share();
        let total = (1 + self.entrants.len()) as f64;
        Progress { done: own + self.others.progress(), total, unit: text!("cuts") }
    }

    fn partial(&self) -> HandScore {
        self.score()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::settings::Value;
    use crate::run::edits::Edit;
    use crate::run::presets;

    /// The score of the deeper stretch, driven by turns of the override: times in s and percents.
    fn scored(changes: &[(&str, Value)], turns: &[(f64, f64)]) -> HandScore {
        let mut scenario = ByHandJob::without_control(&presets::load("depth-step").unwrap());
        for (path, value) in changes {
            scenario.set(path, value.clone()).unwrap();
        }
        let mut edits = Edits::none();
        for (at_s, percent) in turns {
            let (path, value) = (HAND.to_owned(), Value::Float(*percent));
            edits.push(&scenario, Edit { at_s: *at_s, path, value }).unwrap();
        }
        assert_eq!(is_by_hand(&edits), !turns.is_empty());
        let mut job = ByHandJob::new(&scenario, &edits);
        job.to_end();
        job.partial()
    }

    fn told(score: &HandScore) -> &str {
        score.verdict.as_deref().unwrap()
    }

    #[test]
    fn only_who_holds_the_tolerance_has_a_rank_and_the_sentence_has_the_figures() {
        let none = scored(&[], &[(1.0, 120.0)]);
        let own = &none.rows[0];
        assert_eq!(
            (own.name.as_str(), own.id, own.holds, own.rank),
            (YOUR_HAND, None, false, None)
        );
        assert!(told(&none).contains("no rank"), "{}", told(&none));
        let inside = format!("{:.1} %", own.outcome.in_tolerance_percent.unwrap());
        assert!(told(&none).contains(&inside), "{}", told(&none));
        assert_eq!(none.rows.len(), 1 + methods().count());
        for row in &none.rows {
            let held = row.outcome.in_tolerance_percent.is_some_and(|share| share >= HELD_PERCENT);
            assert_eq!(row.rank.is_some(), row.holds, "{row:?}");
            assert_eq!(row.holds, held && row.outcome.time_s.is_some(), "{row:?}");
        }
        let ranked: Vec<_> = none.in_order().iter().filter_map(|row| row.rank).collect();
        assert!(!ranked.is_empty() && ranked.is_sorted() && ranked[0] == 1, "{ranked:?}");
        let best = none.in_order()[0];
        assert!(told(&none).contains(&best.name), "{}", told(&none));
    }

    #[test]
    fn a_hand_that_holds_the_tolerance_is_ranked_by_its_time() {
        let score = scored(&[], &[(0.0, 74.0), (8.3, 44.0), (21.0, 74.0)]);
        let own = &score.rows[0];
        let faster = |row: &&Scored| row.holds && row.outcome.time_s < own.outcome.time_s;
        let rank = 1 + score.rows.iter().filter(faster).count();
        assert_eq!((own.holds, own.rank), (true, Some(rank)), "{own:?}");
        let words = told(&score);
        let holding = score.rows.iter().filter(|row| row.holds).count();
        assert!(words.contains(&format!("number {rank} of the {holding} who hold it")), "{words}");
        assert!(words.contains(&score.in_order()[0].name), "{words}");
    }

    #[test]
    fn a_cut_that_is_stopped_has_no_rank_and_says_why() {
        let stop =
            [("cnc.force_stop", Value::Bool(true)), ("cnc.force_stop_n", Value::Float(225.0))];
        let score = scored(&stop, &[(1.0, 120.0)]);
        let own = &score.rows[0];
        assert!(own.outcome.force_stop && own.outcome.time_s.is_none(), "{own:?}");
        let words = told(&score);
        assert!(words.contains("did not come to its end") && words.contains("225 N"), "{words}");
    }

    #[test]
    fn the_others_meet_what_was_changed_in_the_cut_and_not_the_hand() {
        let quiet = scored(&[], &[(1.0, 50.0)]);
        let fast = scored(&[], &[(1.0, 110.0)]);
        assert_ne!(quiet.rows[0].outcome.digest, fast.rows[0].outcome.digest);
        for (a, b) in quiet.rows.iter().zip(&fast.rows).skip(1) {
            assert_eq!(a.outcome.digest, b.outcome.digest, "{}", a.name);
        }
        // The way of control that is constant feed is that at 100 %.
        let part = presets::load("depth-step").unwrap();
        let cut = Run::complete(&ByHandJob::without_control(&part), &Edits::none());
        assert_eq!(quiet.rows[1].outcome.digest, cut.recording().digest());
        let entrant = ByHandJob::entrant(&part, None, "preview").unwrap();
        assert_eq!(entrant.scenario.controller.kind, ControllerKind::Preview);
        assert_eq!(ByHandJob::entrant(&part, None, "nobody"), None);
    }

    #[test]
    fn a_script_of_ones_own_is_among_the_others_where_there_is_one() {
        let part = presets::load("depth-step").unwrap();
        assert_eq!(ByHandJob::entrant(&part, None, "script"), None);
        let script = presets::load("own-controller").unwrap().controller.script.clone();
        let entrant = ByHandJob::entrant(&part, Some(&script), "script").unwrap();
        assert_eq!(entrant.scenario.controller.kind, ControllerKind::Script);
        assert_eq!(entrant.scenario.controller.script, script);
        let mut edits = Edits::none();
        let turn = Edit { at_s: 1.0, path: HAND.to_owned(), value: Value::Float(50.0) };
        let by_hand = ByHandJob::without_control(&part);
        edits.push(&by_hand, turn).unwrap();
        let mut job = ByHandJob::against(&by_hand, &edits, Some(&script));
        job.to_end();
        let score = job.partial();
        let own = score.rows.last().unwrap();
        assert_eq!((own.id, own.name.as_str()), (Some("script"), "Own script"));
        // It cuts as it does alone.
        let alone = Run::complete(&entrant.scenario, &Edits::none());
        assert_eq!(own.outcome.digest, alone.recording().digest());
        assert_eq!(score.rows.len(), 2 + methods().count());
        assert!(score.verdict.is_some());
    }
}
