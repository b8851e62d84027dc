//! One offspring from its draw to its place: made, fitted, cleared of what is superfluous, judged.

use super::archive::{Archive, FittedSum};
use super::draw::{Draws, Grammar};
use super::families::{families, families_of};
use super::fit::{EXACT, Effort, Fitter};
use super::node::{Product, Step, Sum, start_of};
use super::rows::{DataRows, FEW_ROWS, Probes};
use super::template::Template;
use super::tidy::Tidy;
use super::units::UnitRule;
use super::vary::{SumBounds, Variation};
use super::written::joined;
use crate::base::formula::{CompiledFormula, Formula};
use crate::base::math;

/// Steps of the constants of an offspring.
const STEPS: usize = 10;
/// Rows by which offspring are looked at first.
const FIRST_ROWS: usize = 80;
/// How much worse than what survives an offspring may look on these.
const FIRST_LOOK: f64 = 1.8;

/// Share of the offspring that are survivors with a term taken out.
const PRUNED: f64 = 0.02;

/// Most that a term may vary, as a multiple of the target: terms that nearly cancel say nothing.
const CANCEL: f64 = 30.0;

/// Leverage of a row, among many, above which a formula owes a term to this row alone.
const ALONE: f64 = 0.9;

/// What offspring are made from and judged by.
#[derive(Clone, Debug)]
pub struct Nursery {
    /// The rows.
    pub rows: DataRows,
    /// A few of them.
    first: DataRows,
    /// For each island where its formulas must have values.
    probes: Vec<Probes>,
    languages: Vec<Grammar>,
    bounds: SumBounds,
    spread: f64,
    rule: Option<UnitRule>,
    lock: Option<Lock>,
}

/// What every formula has: the parts of a template, which are the last inputs.
#[derive(Clone, Debug)]
struct Lock {
    parts: Vec<CompiledFormula>,
    /// Inputs that the rest may read.
    free: Vec<u8>,
}

fn probes(rows: &DataRows, parts: &[CompiledFormula], languages: &[Grammar]) -> Vec<Probes> {
    languages.iter().map(|language| Probes::new(rows, parts, &language.positive)).collect()
}

impl Nursery {
    /// For rows, islands by their languages, and bounds of formulas.
    #[must_use]
    pub fn new(rows: DataRows, languages: Vec<Grammar>, bounds: SumBounds) -> Self {
        let first = rows.sample(FIRST_ROWS);
        let probes = probes(&rows, &[], &languages);
        let spread = rows.spread();
        Self { rows, first, probes, languages, bounds, spread, rule: None, lock: None }
    }

    /// With a rule that formulas be right in their units.
    #[must_use]
    pub fn with(mut self, rule: Option<UnitRule>) -> Self {
        self.rule = rule;
        self
    }

    /// With the parts of a template in every formula.
    #[must_use]
    pub fn locked(self, template: Option<&Template>) -> Self {
        let Some((template, free)) = template.and_then(|t| Some((t, t.free.clone()?))) else {
            return self;
        };
        let parts = template.parts.iter().map(Formula::compile).collect();
        self.relocked(Some(Lock { parts, free }))
    }

    fn relocked(mut self, lock: Option<Lock>) -> Self {
        if let Some(lock) = &lock {
            self.probes = probes(&self.rows, &lock.parts, &self.languages);
            let on = |language: Grammar| language.on(&lock.free);
            self.languages = self.languages.into_iter().map(on).collect();
        }
        self.lock = lock;
        self
    }

    /// The locked terms: the last inputs.
    fn locked_terms(&self) -> Vec<Product> {
        let count = self.lock.as_ref().map_or(0, |lock| lock.parts.len());
        let inputs = self.rows.inputs.len();
        let term = |input: usize| Product::of(vec![Step::Input(input as u8)]);
        (inputs - count..inputs).map(term).collect()
    }

    /// A formula with all locked terms, and without these inputs anywhere else.
    fn with_lock(&self, mut sum: Sum) -> Sum {
        let Some(lock) = &self.lock else { return sum };
        let reads = |step: &Step| match step {
            Step::Input(number) => lock.free.contains(number),
            Step::Constant(_)
            | Step::Add
            | Step::Sub
            | Step::Mul
            | Step::Div
            | Step::Power { .. }
            | Step::Ln
            | Step::Exp
            | Step::Sin
            | Step::Cos => true,
        };
        let locked = self.locked_terms();
        sum.terms.retain(|term| term.nodes().all(reads) && !locked.contains(term));
        sum.terms.extend(locked);
        sum
    }

    /// The same for other rows.
    #[must_use]
    pub fn on(&self, rows: DataRows) -> Self {
        let half = rows.len() / 2;
        let bounds = SumBounds { constants: self.bounds.constants.min(half), ..self.bounds };
        Self::new(rows, self.languages.clone(), bounds)
            .with(self.rule.clone())
            .relocked(self.lock.clone())
    }

    /// The families of curves that a search begins with, fitted.
    #[must_use]
    pub fn first(&self) -> Vec<FittedSum> {
        let mut fitter = Fitter::default();
        let empty = Archive::default();
        let families = match &self.lock {
            None => families(&self.rows, &self.languages[0].positive),
            Some(lock) => families_of(&self.rows, &self.languages[0].positive, &lock.free),
        };
        let locked = families.into_iter().map(|sum| self.with_lock(sum));
        locked.filter_map(|sum| self.judge(sum, (0, &empty), &mut fitter)).collect()
    }

    /// Whether a formula has values wherever those of an island must have some.
    #[must_use]
    pub fn is_at_home(&self, candidate: &FittedSum, island: usize) -> bool {
        self.has_values(&candidate.sum, island, &mut Fitter::default())
    }

    /// Number of islands.
    #[must_use]
    pub fn islands(&self) -> usize {
        self.languages.len()
    }

    /// Whether an error is no more than rounding.
    #[must_use]
    pub fn is_exact(&self, candidate: &FittedSum) -> bool {
        candidate.left <= EXACT * self.spread
    }

    /// The bounds.
    #[must_use]
    pub fn bounds(&self) -> SumBounds {
        self.bounds
    }

    /// A parent: half of the time from the front, otherwise any survivor.
    fn parent<'a>(&self, archive: &'a Archive, most: usize, draws: &mut Draws) -> Option<&'a Sum> {
        if draws.chance(0.5) {
            let front = archive.front();
            let front: Vec<_> = front.into_iter().filter(|c| c.size <= most).collect();
            return (!front.is_empty()).then(|| &front[draws.below(front.len())].sum);
        }
        let all: Vec<_> = archive.all().filter(|c| c.size <= most).collect();
        (!all.is_empty()).then(|| &all[draws.below(all.len())].sum)
    }

    /// Makes offspring from the survivors of its island, now and then with a parent from another one.
    #[must_use]
    pub fn offspring(
        &self,
        islands: &[Archive],
        island: usize,
        most: usize,
        draws: &mut Draws,
    ) -> Option<FittedSum> {
        let mut fitter = Fitter::default();
        let own = &islands[island];
        let a = self.parent(own, most.saturating_add(6), draws).cloned().unwrap_or_default();
        let other = if draws.chance(0.05) { draws.below(islands.len()) } else { island };
        let b = self
            .parent(&islands[other], most.saturating_add(6), draws)
            .cloned()
            .unwrap_or_default();
        let bounds = SumBounds { size: self.bounds.size.min(most), ..self.bounds };
        let language = &self.languages[island];
        let variation = Variation { language, bounds, rows: &self.first };
        let sum = match draws.chance(PRUNED) {
            true => self.pruned(&a, &mut fitter)?,
            false => variation.offspring(&a, &b, draws, &mut fitter),
        };
        let sum = self.with_lock(sum);
        if !variation.fits(&sum) || sum.terms.is_empty() {
            return None;
        }
        self.judge(sum, (island, own), &mut fitter)
    }

    /// A survivor without the term whose loss is felt least: terms that once explained scatter go so.
    fn pruned(&self, sum: &Sum, fitter: &mut Fitter) -> Option<Sum> {
        let locked = self.locked_terms();
        let mut least: Option<(f64, Sum)> = None;
        for number in 0..sum.terms.len() {
            if sum.terms.len() < 2 || locked.contains(&sum.terms[number]) {
                continue;
            }
            let mut other = sum.clone();
            other.terms.remove(number);
            let Some(left) = fitter.fit(&mut other, &self.first, Effort { steps: 2, goal: 0.0 })
            else {
                continue;
            };
            if least.as_ref().is_none_or(|(least, _)| left < *least) {
                least = Some((left, other));
            }
        }
        least.map(|(_, sum)| sum)
    }

    /// Fits a formula and judges it against the survivors of an island; none where it has no place among them.
    pub fn judge(
        &self,
        mut sum: Sum,
        (island, own): (usize, &Archive),
        fitter: &mut Fitter,
    ) -> Option<FittedSum> {
        let n = self.rows.len() as f64;
        sum.settle();
        if self.first.len() < self.rows.len() {
            let few = self.first.len() as f64;
            let goal = own.goal(sum.size());
            let effort = Effort { steps: STEPS, goal: goal * goal * few };
            let left = fitter.fit(&mut sum, &self.first, effort)?;
            self.join(&mut sum);
            let most = FIRST_LOOK * own.goal(sum.size());
            if left > most * most * few {
                return None;
            }
        }
        let goal = own.goal(sum.size());
        let effort = Effort { steps: STEPS, goal: goal * goal * n };
        let mut left = fitter.fit(&mut sum, &self.rows, effort)?;
        if self.join(&mut sum) {
            left = fitter.fit(&mut sum, &self.rows, effort)?;
        }
        let candidate = self.candidate(sum, left, fitter)?;
        if candidate.error >= own.goal(candidate.size) {
            return None;
        }
        // A spike or a pole beside one row, which alone decides it.
        let alone = |leverage: &f64| *leverage > ALONE;
        let many = self.rows.len() > FEW_ROWS && !self.is_exact(&candidate);
        if many && fitter.leverages(&candidate.sum, self.rows.len()).iter().any(alone) {
            return None;
        }
        let parts = self.is_exact(&candidate) || self.leads(&candidate, own);
        let candidate = self.clear(candidate, parts, fitter);
        (self.is_allowed(&candidate) && self.has_values(&candidate.sum, island, fitter))
            .then_some(candidate)
    }

    /// Joins terms that share their factors: it is the same formula with fewer nodes, and has to be judged by them.
    fn join(&self, sum: &mut Sum) -> bool {
        let locked = self.locked_terms();
        let mut changed = false;
        while let Some(next) =
            joined(sum, &locked).into_iter().find(|next| next.size() < sum.size())
        {
            *sum = next;
            changed = true;
        }
        changed
    }

    /// Whether no survivor of its size or a smaller one is nearly as good.
    fn leads(&self, candidate: &FittedSum, own: &Archive) -> bool {
        let smaller = (0..=candidate.size).filter_map(|size| own.best(size));
        smaller.map(|best| best.error).fold(f64::INFINITY, f64::min) > 1.1 * candidate.error
    }

    /// Judges a fitted formula; none where it has too many constants for the rows, or terms that all but
    /// cancel each other.
    fn candidate(&self, sum: Sum, left: f64, fitter: &mut Fitter) -> Option<FittedSum> {
        if fitter.cancellation(&sum) > CANCEL * self.spread.sqrt() {
            return None;
        }
        let error = fitter.prediction_error(&sum, &self.rows, left);
        let size = sum.size();
        error.is_finite().then_some(FittedSum { sum, size, left, error })
    }

    /// Fits a formula anew; its constants are near already.
    fn refit(&self, mut sum: Sum, fitter: &mut Fitter) -> Option<FittedSum> {
        let left = fitter.fit(&mut sum, &self.rows, Effort { steps: 6, goal: 0.0 })?;
        self.candidate(sum, left, fitter)
    }

    /// Whether `simpler` says as much as `candidate`: the same up to rounding, or with an error that the
    /// scatter of the rows does not tell from it.
    fn says_as_much(&self, simpler: &FittedSum, candidate: &FittedSum) -> bool {
        let exact = EXACT * self.spread;
        if candidate.left <= exact {
            return self.is_allowed(simpler) && simpler.left <= exact.max(4.0 * candidate.left);
        }
        simpler.error <= candidate.error * (1.0 + 0.5 / self.rows.len() as f64)
            && self.is_allowed(simpler)
    }

    fn is_allowed(&self, candidate: &FittedSum) -> bool {
        self.rule.as_ref().is_none_or(|rule| rule.allows(&candidate.sum))
    }

    /// Takes out what does not matter: terms at the level of rounding, free exponents that are whole or
    /// half, and with `parts` whatever else of a term is not needed.
    fn clear(&self, mut candidate: FittedSum, parts: bool, fitter: &mut Fitter) -> FittedSum {
        let locked = self.locked_terms();
        let mut number = 0;
        while number < candidate.sum.terms.len() && candidate.sum.terms.len() > 1 {
            if locked.contains(&candidate.sum.terms[number]) {
                number += 1;
                continue;
            }
            let mut sum = candidate.sum.clone();
            sum.terms.remove(number);
            match self.refit(sum, fitter) {
                Some(simpler) if self.says_as_much(&simpler, &candidate) => candidate = simpler,
                _ => number += 1,
            }
        }
        if candidate.sum.intercept && !candidate.sum.terms.is_empty() {
            let sum = Sum { intercept: false, ..candidate.sum.clone() };
            if let Some(simpler) = self.refit(sum, fitter)
                && self.says_as_much(&simpler, &candidate)
            {
                candidate = simpler;
            }
        }
        let mut place = 0;
        while let Some(sum) = snapped(&candidate.sum, place) {
            place += 1;
            if let Some(sum) = sum
                && let Some(simpler) = self.refit(sum, fitter)
                && self.says_as_much(&simpler, &candidate)
            {
                // One place fewer is free now.
                place -= 1;
                candidate = simpler;
            }
        }
        if parts {
            for sum in joined(&candidate.sum, &locked) {
                if let Some(simpler) = self.refit(sum, fitter)
                    && simpler.size < candidate.size
                    && self.says_as_much(&simpler, &candidate)
                {
                    candidate = simpler;
                    break;
                }
            }
            let mut number = 0;
            while let Some(sum) = self.shorter(&candidate.sum, number) {
                number += 1;
                if sum.size() < candidate.size
                    && let Some(simpler) = self.refit(sum, fitter)
                    && self.says_as_much(&simpler, &candidate)
                {
                    candidate = simpler;
                    number = 0;
                }
            }
        }
        candidate
    }

    /// The formula with its part number `number` shortened to one of what it is made of; none past the last.
    fn shorter(&self, sum: &Sum, mut number: usize) -> Option<Sum> {
        let tidy = Tidy { positive: &self.languages[0].positive };
        for (k, term) in sum.terms.iter().enumerate() {
            let several = if term.factors.len() > 1 { term.factors.len() } else { 0 };
            let mut other = term.clone();
            if number < several {
                other.factors.remove(number);
            } else {
                number -= several;
                let mut found = false;
                'factors: for (j, factor) in term.factors.iter().enumerate() {
                    for end in 0..factor.len() {
                        let arity = factor[end].arity();
                        if number >= arity {
                            number -= arity;
                            continue;
                        }
                        // The last part, or the first.
                        let last = start_of(factor, end - 1);
                        let part =
                            if number == 0 { last..end } else { start_of(factor, end)..last };
                        let part = factor[part].to_vec();
                        other.factors[j].splice(start_of(factor, end)..=end, part);
                        found = true;
                        break 'factors;
                    }
                }
                if !found {
                    continue;
                }
            }
            let other = tidy.term(&other);
            let mut sum = sum.clone();
            if other.factors.is_empty() {
                sum.terms.remove(k);
            } else {
                sum.terms[k] = other;
            }
            return Some(sum);
        }
        None
    }

    /// Whether a formula has values at the probes of an island, and in the box no wild ones.
    fn has_values(&self, sum: &Sum, island: usize, fitter: &mut Fitter) -> bool {
        let mut values = Vec::new();
        let probes = &self.probes[island];
        let [low, high] = probes.bounds;
        fitter.predict(sum, &probes.inputs, &mut values)
            && values[..probes.inside].iter().all(|value| (low..=high).contains(value))
    }
}

/// The formula with its free exponent number `place` at the next half; none past the last exponent, and
/// none inside where the next half is far.
fn snapped(sum: &Sum, place: usize) -> Option<Option<Sum>> {
    let mut snapped = sum.clone();
    let mut at = 0;
    for term in &mut snapped.terms {
        for factor in &mut term.factors {
            for index in 0..factor.len() {
                let Step::Power { exponent, free: true } = factor[index] else { continue };
                if at < place {
                    at += 1;
                    continue;
                }
                let half = math::limit((2.0 * exponent).round() * 0.5, -32.0, 32.0);
                if (exponent - half).abs() > 0.15 || half == 0.0 {
                    return Some(None);
                }
                if half == 1.0 {
                    factor.remove(index);
                } else {
                    factor[index] = Step::Power { exponent: half, free: false };
                }
                return Some(Some(snapped));
            }
        }
    }
    None
}
