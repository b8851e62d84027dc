//! The 2013 paper's five findings about its 40 networks, judged by the networks trained here.

use serde::Serialize;

use super::comparison::Trial;
use crate::base::network::Activation;
use crate::verdict::Verdict;

/// A statement that the trials hold or not.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TrainingClaim {
    /// The statement, as it is tested.
    pub statement: String,
    /// Whether it holds here.
    pub found: bool,
}

/// A finding of the paper beside what is found here.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Finding {
    /// Which finding.
    pub id: &'static str,
    /// Whether it is found here.
    pub verdict: Verdict,
    /// What the paper says.
    pub paper: &'static str,
    /// What it comes to.
    pub claims: Vec<TrainingClaim>,
    /// The figures that decide: errors, and cycles in brackets.
    pub figures: String,
}

impl Finding {
    fn new(
        id: &'static str,
        paper: &'static str,
        claims: Vec<TrainingClaim>,
        figures: String,
    ) -> Self {
        let verdict = match claims.iter().filter(|claim| claim.found).count() {
            0 => Verdict::Not,
            all if all == claims.len() => Verdict::Holds,
            _ => Verdict::InPart,
        };
        Self { id, verdict, paper, claims, figures }
    }
}

fn claims(all: &[(&str, bool)]) -> Vec<TrainingClaim> {
    let claim = |(statement, found): &(&str, bool)| TrainingClaim {
        statement: (*statement).to_owned(),
        found: *found,
    };
    all.iter().map(claim).collect()
}

/// All findings, and the spread of the seeds that they are measured by.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TrainingFindings {
    /// Largest less smallest error of the centre over its seeds, percentage points: smaller
    /// differences mean nothing.
    pub seed_spread_percent: f64,
    /// The findings.
    pub findings: Vec<Finding>,
}

/// Errors and cycles over a factor.
fn listed<K: std::fmt::Display>(trials: &[&Trial], key: impl Fn(&Trial) -> K) -> String {
    let cells = trials.iter().map(|trial| {
        let cycles = trial.epochs_to_level.map_or("never".to_owned(), |epochs| epochs.to_string());
        format!("{}: {:.1} % ({cycles})", key(trial), trial.error_percent)
    });
    cells.collect::<Vec<_>>().join(", ")
}

/// Epochs to the level, where never more than any number.
fn cycles(trial: &Trial) -> u32 {
    trial.epochs_to_level.unwrap_or(u32::MAX)
}

fn least<'a>(trials: &[&'a Trial], key: impl Fn(&Trial) -> f64) -> Option<&'a Trial> {
    trials.iter().copied().min_by(|a, b| key(a).total_cmp(&key(b)))
}

/// Judges the findings by the trials of [`super::comparison::recipes`], the centre first.
#[must_use]
pub fn findings(trials: &[Trial]) -> Option<TrainingFindings> {
    let centre = trials.first()?;
    let varied = |same: &dyn Fn(&Trial) -> bool, key: &dyn Fn(&Trial) -> f64| {
        let mut group: Vec<&Trial> = trials.iter().filter(|trial| same(trial)).collect();
        group.sort_by(|a, b| key(a).total_cmp(&key(b)));
        group
    };
    let arctan = |t: &Trial| {
        t.activation == centre.activation && t.target == centre.target && t.seed == centre.seed
    };
    let (rate, momentum, hidden) = (centre.rate, centre.momentum, centre.hidden);
    let rates = varied(&|t| arctan(t) && t.momentum == momentum && t.hidden == hidden, &|t| t.rate);
    let momenta = varied(&|t| arctan(t) && t.rate == rate && t.hidden == hidden, &|t| t.momentum);
    let sizes =
        varied(&|t| arctan(t) && t.rate == rate && t.momentum == momentum, &|t| t.hidden as f64);
    let seeds = varied(
        &|t| {
            let same = t.rate == rate && t.momentum == momentum && t.hidden == hidden;
            same && t.activation == centre.activation && t.target == centre.target
        },
        &|t| t.error_percent,
    );
    let spread = seeds.last()?.error_percent - seeds.first()?.error_percent;
    Some(TrainingFindings {
        seed_spread_percent: spread,
        findings: vec![
            of_rates(&rates)?,
            of_momenta(&momenta)?,
            of_sizes(&sizes, centre, spread),
            of_activations(trials, centre, &ERRORS)?,
            of_activations(trials, centre, &CYCLES)?,
        ],
    })
}

fn of_rates(rates: &[&Trial]) -> Option<Finding> {
    let best = least(rates, |trial| trial.error_percent)?;
    let errors = |low: bool| {
        rates.iter().filter(move |t| (t.rate < 0.2) == low).map(|trial| trial.error_percent)
    };
    let below = errors(true).fold(f64::NEG_INFINITY, f64::max);
    let above = errors(false).fold(f64::INFINITY, f64::min);
    Some(Finding::new(
        "learning_rate",
        "Learning rates below 0.2 give acceptable errors, 0.03 to 0.1 the least error in few cycles.",
        claims(&[
            ("every rate below 0.2 errs less than every rate from 0.2 on", below < above),
            ("the least error lies within 0.03..0.1", (0.03..=0.1).contains(&best.rate)),
        ]),
        listed(rates, |trial| trial.rate),
    ))
}

fn of_momenta(momenta: &[&Trial]) -> Option<Finding> {
    let best = least(momenta, |trial| trial.error_percent)?;
    let small = momenta.iter().filter(|trial| trial.momentum <= 0.004).map(|t| cycles(t)).min()?;
    let large = momenta.iter().filter(|trial| trial.momentum > 0.004).map(|t| cycles(t)).min()?;
    Some(Finding::new(
        "momentum",
        "Momentum of 0.008 to 0.01 gives the least error; at most 0.004 the fewest cycles.",
        claims(&[
            ("the least error lies within 0.008..0.01", (0.008..=0.01).contains(&best.momentum)),
            ("0.004 needs fewer cycles than any larger momentum", small < large),
        ]),
        listed(momenta, |trial| trial.momentum),
    ))
}

fn of_sizes(sizes: &[&Trial], centre: &Trial, spread: f64) -> Finding {
    let all = |holds: &dyn Fn(&Trial) -> bool| sizes.iter().all(|trial| holds(trial));
    let worse = |trial: &Trial| trial.error_percent - centre.error_percent;
    let near = |trial: &Trial| (9..=17).contains(&trial.hidden) && trial.hidden != centre.hidden;
    Finding::new(
        "hidden_neurons",
        "15 hidden neurons are the optimum, more change nothing; 9 to 17 do fairly well but need \
         more cycles.",
        claims(&[
            (
                "fewer than 9 err more, by more than the seeds' spread",
                all(&|trial| trial.hidden >= 9 || worse(trial) > spread),
            ),
            (
                "more than 15 gain less than that spread",
                all(&|trial| trial.hidden <= centre.hidden || -worse(trial) < spread),
            ),
            (
                "all others of 9..17 need more cycles than 15",
                all(&|trial| !near(trial) || cycles(trial) > cycles(centre)),
            ),
        ]),
        listed(sizes, |trial| trial.hidden),
    )
}

/// A finding about the order of the four activations.
struct Order {
    id: &'static str,
    paper: &'static str,
    /// What they are ordered by.
    key: fn(&Trial) -> f64,
    /// Place from the front, activation, and what is claimed.
    claims: [(usize, &'static str, &'static str); 3],
}

const ERRORS: Order = Order {
    id: "activation_errors",
    paper: "tanh gives the least error, sigmoid the highest, sine the next highest.",
    key: |trial| trial.error_percent,
    claims: [
        (0, "tanh", "tanh errs least"),
        (3, "sigmoid", "sigmoid errs most"),
        (2, "sine", "sine errs second most"),
    ],
};

const CYCLES: Order = Order {
    id: "activation_cycles",
    paper: "Sine needs the fewest cycles, then the arc tangent; tanh needs the most.",
    key: |trial| f64::from(cycles(trial)),
    claims: [
        (0, "sine", "sine needs the fewest"),
        (1, "arctan", "the arc tangent needs the second fewest"),
        (3, "tanh", "tanh needs the most"),
    ],
};

/// Every activation at its better rate, in order; the order depends on the range of the targets, so
/// there is one for each.
fn of_activations(trials: &[Trial], centre: &Trial, order: &Order) -> Option<Finding> {
    let (mut claims, mut figures) = (Vec::new(), Vec::new());
    for (whose, range) in [(true, "targets 0..1"), (false, "targets inside the bounds")] {
        let mut best: Vec<&Trial> = Vec::new();
        for activation in Activation::ALL {
            let here = |t: &&Trial| {
                let rate = super::comparison::ACTIVATION_RATES.contains(&t.rate);
                let same = t.momentum == centre.momentum && t.hidden == centre.hidden;
                let target = (t.target == centre.target) == whose;
                t.activation == activation.id() && rate && same && target && t.seed == centre.seed
            };
            let here: Vec<&Trial> = trials.iter().filter(here).collect();
            best.push(least(&here, order.key)?);
        }
        best.sort_by(|a, b| (order.key)(a).total_cmp(&(order.key)(b)));
        for (place, activation, statement) in order.claims {
            let found = best[place].activation == activation;
            claims.push(TrainingClaim { statement: format!("{statement} ({range})"), found });
        }
        let list = listed(&best, |trial| format!("{} at {}", trial.activation, trial.rate));
        figures.push(format!("{range}: {list}"));
    }
    Some(Finding::new(order.id, order.paper, claims, figures.join("; ")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::train::comparison::{EPOCHS, recipes};

    /// Trials as the paper describes them.
    fn as_in_the_paper() -> Vec<Trial> {
        let trial = |recipe: &crate::train::recipe::TrainingRecipe| {
            let hidden = recipe.hidden[0];
            let rate = recipe.learning.rate;
            let momentum = recipe.learning.momentum;
            let off = |x: f64, best: f64| (x - best).abs();
            let (error, cycles) = match recipe.activation.id() {
                "tanh" => (4.0, 400),
                "sine" => (7.0, 100),
                "sigmoid" => (8.0, 300),
                _ => (5.0, 200),
            };
            let mut error = error + 30.0 * off(rate, 0.05) + 2.0 * off(momentum, 0.01);
            error += if hidden < 15 { 0.5 * off(hidden as f64, 15.0) } else { 0.0 };
            error += 0.01 * f64::from(recipe.seed);
            let quicker = u32::from(momentum <= 0.004);
            Trial {
                activation: recipe.activation.id(),
                target: recipe.target,
                rate,
                momentum,
                hidden,
                seed: recipe.seed,
                error_percent: error,
                epochs_to_level: Some(cycles + hidden.abs_diff(15) as u32 - quicker),
            }
        };
        recipes().iter().map(trial).collect()
    }

    #[test]
    fn forty_different_networks_with_the_same_budget() {
        let recipes = recipes();
        assert_eq!(recipes.len(), 40);
        for (i, recipe) in recipes.iter().enumerate() {
            assert!(recipe.epochs == EPOCHS && !recipes[..i].contains(recipe), "{i}");
        }
    }

    #[test]
    fn findings_follow_the_trials() {
        let found = |trials: &[Trial]| -> Vec<Verdict> {
            findings(trials).unwrap().findings.iter().map(|finding| finding.verdict).collect()
        };
        use Verdict::{Holds, InPart, Not};
        let trials = as_in_the_paper();
        assert_eq!(found(&trials), [Holds; 5]);
        assert!((findings(&trials).unwrap().seed_spread_percent - 0.03).abs() < 1e-9);
        let changed = |change: &dyn Fn(&mut Trial)| {
            let mut trials = trials.clone();
            trials.iter_mut().for_each(change);
            found(&trials)
        };
        let low =
            |t: &mut Trial| t.error_percent = if t.rate == 0.3 { 1.0 } else { t.error_percent };
        assert_eq!(changed(&low), [Not, Holds, Holds, Holds, Holds]);
        let quick = |t: &mut Trial| {
            if t.momentum == 0.5 {
                t.epochs_to_level = Some(1);
            }
        };
        assert_eq!(changed(&quick), [Holds, InPart, Holds, Holds, Holds]);
        let large = |t: &mut Trial| t.error_percent -= if t.hidden == 21 { 2.0 } else { 0.0 };
        assert_eq!(changed(&large), [Holds, Holds, InPart, Holds, Holds]);
        let sine = |t: &mut Trial| {
            if t.activation == "sine" {
                (t.error_percent, t.epochs_to_level) = (1.0, None);
            }
        };
        assert_eq!(changed(&sine), [Holds, Holds, Holds, InPart, Not]);
        assert!(findings(&[]).is_none());
    }
}
