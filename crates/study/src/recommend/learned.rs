//! A neuro-fuzzy system that has learned one value of a cutting-data table.
//!
//! Its first input and the value enter by their logarithms, since tables follow powers; every input
//! is scaled to 0..1 over the table.

use serde::Serialize;

use super::EngagementCode;
use super::learning::{Pattern, SugenoRecipe, learn, leave_one_out};
use super::table::Entry;
use crate::base::language::{text, tr};
use crate::base::math::{self, extent, limit};
use crate::base::stats;
use crate::base::units::percent_from_ratio;
use crate::recommend::sugeno::Sugeno;

/// How the systems learn; the ridge, epochs, rate and widths of both.
const RECIPE: SugenoRecipe =
    SugenoRecipe { counts: [2, 2], ridge: 1e-3, epochs: 50, rate: 0.02, widths: [0.08, 2.0] };
/// Errors of a system, relative, in percent.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RecommendErrors {
    /// Root mean square.
    pub rms_percent: f64,
    /// Mean size.
    pub mean_percent: f64,
    /// Largest size.
    pub worst_percent: f64,
}

impl RecommendErrors {
    /// From errors of the logarithm.
    fn of(log_errors: &[f64]) -> Self {
        let relative: Vec<f64> = log_errors.iter().map(|e| (math::exp(*e) - 1.0).abs()).collect();
        // Without cuts left out there is no error to tell.
        let of = |ratio: Option<f64>| percent_from_ratio(ratio.unwrap_or(f64::NAN));
        Self {
            rms_percent: of(stats::rms(relative.iter().copied())),
            mean_percent: of(stats::mean(relative.iter().copied())),
            worst_percent: percent_from_ratio(relative.into_iter().fold(0.0, f64::max)),
        }
    }
}

/// A rule at work.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Firing {
    /// What it says, for example "hardness low, engagement high".
    pub rule: String,
    /// Its normalised strength; those of all rules make 1.
    pub strength: f64,
    /// What it alone would recommend.
    pub value: f64,
}

/// One recommended value.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Answer {
    /// The value, in m/min or mm.
    pub value: f64,
    /// Whether the question lies inside the table; otherwise the value is that of its edge.
    pub inside_table: bool,
    /// All rules, the strongest first.
    pub rules: Vec<Firing>,
}

/// A system that has learned one value of a table.
#[derive(Clone, Debug)]
pub struct Learned {
    /// Name of the input beside the engagement.
    input: &'static str,
    /// Ranges of the inputs in the table.
    range: [[f64; 2]; 2],
    recipe: SugenoRecipe,
    patterns: Vec<Pattern>,
    system: Sugeno,
}

impl Learned {
    /// Learns the entries with `counts` memberships of the two inputs; `input` names the first.
    #[must_use]
    pub(super) fn new(input: &'static str, counts: [usize; 2], entries: &[Entry]) -> Self {
        let range = [0, 1].map(|axis: usize| extent(entries.iter().map(|(x, _)| x[axis])));
        let recipe = SugenoRecipe { counts, ..RECIPE };
        let pattern = |(x, value): &Entry| (scaled(range, *x), math::ln(*value));
        let patterns: Vec<Pattern> = entries.iter().map(pattern).collect();
        let system = learn(&recipe, &patterns);
        Self { input, range, recipe, patterns, system }
    }

    /// The answer at an input beside the engagement.
    #[must_use]
    pub fn answer(&self, input: f64, engagement: EngagementCode) -> Answer {
        let asked = [input, engagement.number()];
        let held =
            [0, 1].map(|axis: usize| limit(asked[axis], self.range[axis][0], self.range[axis][1]));
        let x = scaled(self.range, held);
        let firing = |(rule, strength)| {
            let members = self.system.joined(rule);
            let [first, second] =
                [0, 1].map(|axis: usize| word(members[axis], self.recipe.counts[axis]));
            Firing {
                rule: tr!(
                    "{input} {first}, engagement {second}",
                    input = tr(self.input),
                    first = tr(first),
                    second = tr(second)
                ),
                strength,
                value: math::exp(self.system.rule_value(rule, x)),
            }
        };
        let strengths = self.system.strengths(x);
        let mut rules: Vec<Firing> = strengths.into_iter().enumerate().map(firing).collect();
        rules.sort_by(|a, b| b.strength.total_cmp(&a.strength));
        Answer { value: math::exp(self.system.value(x)), inside_table: held == asked, rules }
    }

    /// Errors on the rows that it learned.
    #[must_use]
    pub fn training_errors(&self) -> RecommendErrors {
        let errors = self.patterns.iter().map(|(x, target)| self.system.value(*x) - target);
        RecommendErrors::of(&errors.collect::<Vec<f64>>())
    }

    /// Errors of leave-one-out: each row is predicted by a training on all others.
    #[must_use]
    pub fn left_out_errors(&self) -> RecommendErrors {
        RecommendErrors::of(&leave_one_out(&self.recipe, &self.patterns))
    }

    /// Rows that it learned.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.patterns.len()
    }

    /// Memberships of its two inputs.
    #[must_use]
    pub fn counts(&self) -> [usize; 2] {
        self.recipe.counts
    }

    /// Range in the table of the input beside the engagement.
    #[must_use]
    pub fn input_range(&self) -> [f64; 2] {
        self.range[0]
    }
}

/// Inputs on 0..1: the first by its logarithm.
fn scaled([first, second]: [[f64; 2]; 2], x: [f64; 2]) -> [f64; 2] {
    let span = math::ln(first[1] / first[0]);
    [math::ln(x[0] / first[0]) / span, (x[1] - second[0]) / (second[1] - second[0])]
}

/// A membership's name by its place among `count`.
fn word(member: usize, count: usize) -> &'static str {
    match (member, count) {
        (0, _) => text!("low"),
        (1, 3) => text!("middle"),
        _ => text!("high"),
    }
}
