//! Entrants against each other over seeds: a job of independent runs.
//!
//! The runs go seed by seed, so the table fills evenly and can be read while it does. Seed k of
//! every entrant is the same k: the same material, the same sensor noise.

use std::collections::BTreeMap;

use serde::Serialize;

use super::entrants::Entrant;
use super::outcome::{Measure, Outcome};
use super::outside::Outside;
use super::spread::Spread;
use crate::base::language::text;
use crate::run::edits::Edits;
use crate::run::job::{Budget, Job, Progress};
use crate::run::one_run::Run;
use crate::run::parts::{Making, Parts};
use crate::run::scenario::Scenario;

/// An entrant's spreads so far.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Compared {
    /// Its name.
    pub name: String,
    /// Runs that are done.
    pub runs: usize,
    /// Runs of them that an overload stopped.
    pub force_stops: usize,
    /// Runs of them that came to the end of the part.
    pub finished: usize,
    /// Runs of them whose loop was unstable in any stretch.
    pub unstable: usize,
    /// Runs of them in which the machine chattered.
    pub chattered: usize,
    /// Whether its runs of two seeds or more are the same to the bit: nothing random acts, and they tell no spread.
    pub same: bool,
    /// Digest of its run of seed 1, once that is done.
    pub digest: Option<String>,
    /// Where its runs lie outside the tolerance, in the mean; none before one has cut.
    pub outside: Option<Outside>,
    /// Spread of each measure by its id; none where no run has given the value yet.
    spreads: BTreeMap<&'static str, Spread>,
}

impl Compared {
    /// The spread of a measure, if any run has given it.
    #[must_use]
    pub fn get(&self, measure: Measure) -> Option<Spread> {
        self.spreads.get(measure.id()).copied()
    }

    /// The mean of a measure; NaN, which fails every comparison, where there is none.
    #[must_use]
    pub fn mean(&self, measure: Measure) -> f64 {
        self.get(measure).map_or(f64::NAN, |spread| spread.mean)
    }
}

/// All runs of a comparison.
///
/// ```
/// use steadycut_core::blocks::control::ControllerKind;
/// use steadycut_core::run::{job::Job, presets};
/// use steadycut_study::compare::{entrants::Entrant, outcome::Measure, tournament::Tournament};
///
/// let base = presets::load("table3-5-noise").unwrap();
/// let entrant = |name: &str, kind| Entrant {
///     name: name.to_owned(),
///     scenario: base.with(|settings| settings.controller.kind = kind).unwrap(),
/// };
/// let mut tournament = Tournament::new(
///     vec![entrant("SDNRP", ControllerKind::Sdnrp), entrant("Tracking", ControllerKind::Tracking)],
///     3,
/// );
/// tournament.to_end();
/// let table = tournament.table();
/// // Under noise, Tracking moves the override less than the proportional loop.
/// assert!(table[1].mean(Measure::Travel) < table[0].mean(Measure::Travel), "{table:?}");
/// ```
#[derive(Clone, Debug)]
pub struct Tournament {
    entrants: Vec<Entrant>,
    seeds: u32,
    /// Runs seed by seed, entrant by entrant.
    runs: Parts<Run, Outcome>,
}

impl Tournament {
    /// A tournament over seeds 1 to `seeds` (at least one), not yet begun.
    #[must_use]
    pub fn new(entrants: Vec<Entrant>, seeds: u32) -> Self {
        Self { entrants, seeds: seeds.max(1), runs: Parts::default() }
    }

    /// Changes the number of seeds; runs that are done or under way are never given up.
    pub fn set_seeds(&mut self, seeds: u32) {
        let entrants = self.entrants.len().max(1);
        self.seeds = seeds.max(self.runs.begun().div_ceil(entrants) as u32).max(1);
    }

    /// The entrants in order.
    #[must_use]
    pub fn entrants(&self) -> &[Entrant] {
        &self.entrants
    }

    fn count(&self) -> usize {
        self.entrants.len() * self.seeds as usize
    }

    /// Every entrant's spreads over the runs that are done, in the order of the entrants.
    #[must_use]
    pub fn table(&self) -> Vec<Compared> {
        (0..self.entrants.len()).map(|index| self.compared(index)).collect()
    }

    /// The outcomes of an entrant, seed 1 first.
    pub fn outcomes(&self, entrant: usize) -> impl Iterator<Item = &Outcome> {
        self.runs.done().iter().skip(entrant).step_by(self.entrants.len().max(1))
    }

    fn compared(&self, entrant: usize) -> Compared {
        let values = |measure: Measure| -> Vec<f64> {
            self.outcomes(entrant).filter_map(|outcome| outcome.get(measure)).collect()
        };
        let spreads = Measure::ALL
            .iter()
            .filter_map(|measure| Some((measure.id(), Spread::of(&values(*measure))?)));
        Compared {
            name: self.entrants[entrant].name.clone(),
            runs: self.outcomes(entrant).count(),
            force_stops: self.outcomes(entrant).filter(|outcome| outcome.force_stop).count(),
            finished: self.outcomes(entrant).filter(|outcome| outcome.time_s.is_some()).count(),
            unstable: self.outcomes(entrant).filter(|outcome| outcome.unstable).count(),
            chattered: self.outcomes(entrant).filter(|outcome| outcome.chattered).count(),
            same: self.outcomes(entrant).count() > 1 && {
                let mut digests = self.outcomes(entrant).map(|outcome| &outcome.digest);
                let first = digests.next();
                digests.all(|digest| Some(digest) == first)
            },
            digest: self.outcomes(entrant).next().map(|outcome| outcome.digest.clone()),
            outside: Outside::mean(
                &self.outcomes(entrant).filter_map(|outcome| outcome.outside).collect::<Vec<_>>(),
            ),
            spreads: spreads.collect(),
        }
    }
}

/// What an entrant's run of a seed is of.
///
/// # Panics
/// Never: no rule joins seed and recording with others.
#[must_use]
pub fn scenario_of(entrant: &Scenario, seed: u32) -> Scenario {
    let scenario = entrant.with(|settings| {
        settings.run.seed = seed;
        // A row for every control sample is what the measures need.
        settings.run.record_every = settings.run.steps_per_control;
    });
    scenario.expect("any seed, and a row a control period, go with any scenario")
}

/// The scenario of run `index`.
fn scenario(entrants: &[Entrant], index: usize) -> Scenario {
    let seed = 1 + (index / entrants.len()) as u32;
    scenario_of(&entrants[index % entrants.len()].scenario, seed)
}

/// A step is one of the plant in one of the runs.
impl Job for Tournament {
    type Partial = Vec<Compared>;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        let (count, entrants) = (self.count(), &self.entrants);
        let begin = |index: usize| Ok(Run::new(&scenario(entrants, index), &Edits::none()));
        let end = |_: usize, run: &Run| Outcome::of(run);
        self.runs.advance(count, budget, &Making { begin: &begin, end: &end })
    }

    fn progress(&self) -> Progress {
        Progress { done: self.runs.progress(), total: self.count() as f64, unit: text!("runs") }
    }

    fn partial(&self) -> Vec<Compared> {
        self.table()
    }
}

#[cfg(test)]
mod tests {
    use super::super::entrants::{OWN, on};
    use super::*;
    use crate::blocks::control::ControllerKind;
    use crate::run::presets;

    fn entrants() -> Vec<Entrant> {
        let kinds = [ControllerKind::ConstantFeed, ControllerKind::AdjustablePi];
        let entrant = |kind: ControllerKind| {
            let mut scenario = presets::load("table3-5-noise").unwrap();
            scenario
                .change(|s| {
                    s.controller.kind = kind;
                    s.run.duration_s = 2.0;
                })
                .unwrap();
            Entrant { name: kind.label().to_owned(), scenario }
        };
        kinds.map(entrant).to_vec()
    }

    /// The script of the scenario is what runs, as it does alone, whatever has the feed in the scenario.
    #[test]
    fn a_script_of_ones_own_takes_part_as_it_runs_alone() {
        let base = presets::load("own-controller").unwrap();
        let alone = Run::complete(&scenario_of(&base, 1), &Edits::none());
        let base = base.with(|s| s.controller.kind = ControllerKind::Tracking).unwrap();
        let mut tournament = Tournament::new(on(&base, OWN), 1);
        tournament.to_end();
        let [own] = &tournament.table()[..] else { panic!("one entrant") };
        assert_eq!(own.digest, Some(alone.recording().digest()));
    }

    #[test]
    fn slices_change_nothing_and_the_table_can_be_read_meanwhile() {
        let mut whole = Tournament::new(entrants(), 3);
        whole.to_end();
        let mut sliced = Tournament::new(entrants(), 3);
        let (mut before, mut slices) = (-1.0, 0);
        while !sliced.advance_by(777) {
            let Progress { done, total, .. } = sliced.progress();
            assert!(done > before && done < total, "{done} of {total} after {before}");
            assert_eq!(sliced.table().len(), 2);
            (before, slices) = (done, slices + 1);
        }
        assert_eq!(slices, 6 * 2000 / 777);
        assert_eq!(sliced.table(), whole.table());
        assert_eq!(sliced.progress().to_string(), "6 of 6 runs");
        for compared in whole.table() {
            assert_eq!((compared.runs, compared.force_stops, compared.finished), (3, 0, 0));
            assert_eq!(compared.get(Measure::Time), None, "the path is longer than two seconds");
        }
        // Anybody can repeat the run that the digest is of.
        let first = Run::complete(&scenario_of(&entrants()[1].scenario, 1), &Edits::none());
        assert_eq!(whole.table()[1].digest, Some(first.recording().digest()));
        let pi = whole.table()[1].get(Measure::Nsn).unwrap();
        assert!(pi.deviation > 0.0, "three seeds differ");
        // The constant feed does not touch the override; the PI controller does.
        let travel = |index: usize| whole.table()[index].mean(Measure::Travel);
        assert_eq!(travel(0), 0.0);
        assert!(travel(1) > 1.0);
    }

    /// Without noise a seed decides nothing: all its runs are one, and are said to be.
    #[test]
    fn runs_of_different_seeds_are_the_same_where_nothing_is_random() {
        for (level, same) in [(0.0, true), (1.0, false)] {
            let mut entrants = entrants();
            for entrant in &mut entrants {
                entrant.scenario.change(|s| s.noise.level = level).unwrap();
            }
            let mut tournament = Tournament::new(entrants.clone(), 3);
            tournament.to_end();
            assert!(tournament.table().iter().all(|one| one.same == same), "noise {level}");
            let mut one = Tournament::new(entrants, 1);
            one.to_end();
            assert!(one.table().iter().all(|one| !one.same), "one run is no comparison");
        }
    }

    #[test]
    fn a_tournament_without_entrants_is_over() {
        let mut empty = Tournament::new(Vec::new(), 5);
        assert!(empty.advance_by(1));
        assert_eq!(empty.progress().share(), 1.0);
        assert!(empty.table().is_empty());
    }
}
