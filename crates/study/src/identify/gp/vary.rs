//! How offspring come from parents.

use super::draw::{Draws, Grammar};
use super::fit::Fitter;
use super::node::{Factor, Product, RECIPROCAL, Step, Sum, fixed, start_of};
use super::rows::DataRows;
use super::tidy::{MOST_EXPONENT, Tidy};
use crate::base::math;

/// Most terms, factors of a term and nodes of a factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SumBounds {
    /// Most terms.
    pub terms: usize,
    /// Most factors of a term.
    pub factors: usize,
    /// Most nodes of a factor.
    pub nodes: usize,
    /// Most nodes of a formula, as it is printed.
    pub size: usize,
    /// Most fitted constants.
    pub constants: usize,
}

/// Candidates for a new term.
const CANDIDATES: usize = 24;

/// Share of the changes of a term that give it a swing, where there are swings.
const SWUNG: f64 = 0.1;

/// Everything that variation needs besides the parents.
pub struct Variation<'a> {
    /// What new parts are drawn from.
    pub language: &'a Grammar,
    /// What formulas may be.
    pub bounds: SumBounds,
    /// The rows by which candidates for a term are compared.
    pub rows: &'a DataRows,
}

impl Variation<'_> {
    /// A formula from two parents, before its constants are fitted.
    pub fn offspring(&self, a: &Sum, b: &Sum, draws: &mut Draws, fitter: &mut Fitter) -> Sum {
        let mut sum = a.clone();
        if draws.chance(0.1) {
            sum.intercept = !sum.intercept;
        }
        match draws.below(100) {
            0..25 => self.pursue(&mut sum, draws, fitter),
            25..40 => {
                if !sum.terms.is_empty() {
                    let gone = draws.below(sum.terms.len());
                    sum.terms.remove(gone);
                }
                self.pursue(&mut sum, draws, fitter);
            }
            40..47 => self.cross(&mut sum, b, draws),
            47..52 => self.extend(&mut sum, draws, fitter),
            52..62 => self.hone(&mut sum, b, draws, fitter),
            62..78 => {
                self.mutate(&mut sum, b, draws);
                if draws.chance(0.3) {
                    self.mutate(&mut sum, b, draws);
                }
            }
            78..82 => self.join_or_split(&mut sum, draws),
            82..88 => shake(&mut sum, draws),
            88..92 => {
                if sum.terms.len() > 1 {
                    let gone = draws.below(sum.terms.len());
                    sum.terms.remove(gone);
                }
            }
            _ => {
                sum = Sum::of(draws.chance(0.8), Vec::new());
                for _ in 0..1 + draws.below(2) {
                    self.pursue(&mut sum, draws, fitter);
                }
            }
        }
        sum.terms.retain(|term| !term.factors.is_empty());
        self.trim(&mut sum, draws);
        sum
    }

    /// Whether a formula is within the bounds.
    #[must_use]
    pub fn fits(&self, sum: &Sum) -> bool {
        sum.size() <= self.bounds.size && sum.constants() <= self.bounds.constants
    }

    /// Takes terms out until a formula is within the bounds.
    fn trim(&self, sum: &mut Sum, draws: &mut Draws) {
        while sum.terms.len() > self.bounds.terms || sum.terms.len() > 1 && !self.fits(sum) {
            let gone = draws.below(sum.terms.len());
            sum.terms.remove(gone);
        }
    }

    /// Adds the one of some random terms that explains most of what the formula leaves (matching
    /// pursuit).
    fn pursue(&self, sum: &mut Sum, draws: &mut Draws, fitter: &mut Fitter) {
        let mut best: Option<(f64, Product)> = None;
        let known = fitter.explain(sum, self.rows);
        let mut room = Vec::new();
        for _ in 0..CANDIDATES {
            let mut term = self.language.term(draws);
            self.tidy(&mut term, draws);
            if term.factors.is_empty() {
                continue;
            }
            let gain = if known {
                fitter.gain(&term.code(), sum, self.rows, &mut room)
            } else {
                draws.uniform()
            };
            // A longer term has to gain more.
            let gain = gain / (3.0 + term.size() as f64);
            if best.as_ref().is_none_or(|(most, _)| gain > *most) {
                best = Some((gain, term));
            }
        }
        sum.terms.extend(best.map(|(_, term)| term));
    }

    /// Adds one of the terms times another one, the one that explains most of what the formula leaves: a
    /// factor in brackets, as in A (B + c), comes about so.
    fn extend(&self, sum: &mut Sum, draws: &mut Draws, fitter: &mut Fitter) {
        if sum.terms.is_empty() || !fitter.explain(sum, self.rows) || sum.terms.is_empty() {
            return;
        }
        let term = sum.terms[draws.below(sum.terms.len())].clone();
        let mut best: Option<(f64, Product)> = None;
        let mut room = Vec::new();
        for _ in 0..CANDIDATES {
            let mut other = self.language.term(draws);
            other.factors.extend(term.factors.iter().cloned());
            self.tidy(&mut other, draws);
            if other.factors.is_empty() {
                continue;
            }
            let gain = fitter.gain(&other.code(), sum, self.rows, &mut room);
            if best.as_ref().is_none_or(|(most, _)| gain > *most) {
                best = Some((gain, other));
            }
        }
        sum.terms.extend(best.map(|(_, term)| term));
    }

    /// Terms of both parents.
    fn cross(&self, sum: &mut Sum, b: &Sum, draws: &mut Draws) {
        sum.terms.retain(|_| draws.chance(0.65));
        for term in &b.terms {
            if draws.chance(0.5) && !sum.terms.contains(term) {
                sum.terms.push(term.clone());
            }
        }
    }

    /// Changes one term, the best of some ways: the one that explains most of what the others leave.
    fn hone(&self, sum: &mut Sum, b: &Sum, draws: &mut Draws, fitter: &mut Fitter) {
        if sum.terms.is_empty() {
            return self.pursue(sum, draws, fitter);
        }
        let term = sum.terms.remove(draws.below(sum.terms.len()));
        let known = fitter.explain(sum, self.rows);
        let mut best: Option<(f64, Product)> = None;
        let mut room = Vec::new();
        for _ in 0..CANDIDATES {
            let mut other = term.clone();
            self.change(&mut other, b, draws);
            if draws.chance(0.3) {
                self.change(&mut other, b, draws);
            }
            if other.factors.is_empty() || other == term {
                continue;
            }
            let gain = if known {
                fitter.gain(&other.code(), sum, self.rows, &mut room)
            } else {
                draws.uniform()
            };
            if best.as_ref().is_none_or(|(most, _)| gain > *most) {
                best = Some((gain, other));
            }
        }
        sum.terms.push(best.map_or(term, |(_, other)| other));
    }

    /// Changes one term in one way.
    fn mutate(&self, sum: &mut Sum, b: &Sum, draws: &mut Draws) {
        if sum.terms.is_empty() {
            sum.terms.push(self.language.term(draws));
            return;
        }
        let k = draws.below(sum.terms.len());
        self.change(&mut sum.terms[k], b, draws);
        sum.terms.retain(|term| !term.factors.is_empty());
    }

    /// Two terms become one, or one two.
    fn join_or_split(&self, sum: &mut Sum, draws: &mut Draws) {
        if sum.terms.len() > 1 && draws.chance(0.5) {
            let other = sum.terms.remove(draws.below(sum.terms.len()));
            let at = draws.below(sum.terms.len());
            let room = self.bounds.factors.saturating_sub(sum.terms[at].factors.len());
            sum.terms[at].factors.extend(other.factors.into_iter().take(room));
            self.tidy(&mut sum.terms[at], draws);
        } else if !sum.terms.is_empty() {
            let mut copy = sum.terms[draws.below(sum.terms.len())].clone();
            self.change(&mut copy, &Sum::default(), draws);
            if !copy.factors.is_empty() {
                sum.terms.push(copy);
            }
        }
    }

    fn change(&self, term: &mut Product, b: &Sum, draws: &mut Draws) {
        if term.factors.is_empty() {
            *term = self.language.term(draws);
            return;
        }
        if self.language.swings() && draws.chance(SWUNG) {
            return self.swing(term, draws);
        }
        let j = draws.below(term.factors.len());
        match draws.below(12) {
            0 | 1 if term.factors.len() < self.bounds.factors => {
                let mut factor = self.language.factor(draws);
                if draws.chance(0.3) && !matches!(factor.last(), Some(Step::Power { .. })) {
                    factor.push(RECIPROCAL);
                }
                term.factors.push(factor);
            }
            2 if term.factors.len() > 1 => {
                term.factors.remove(j);
            }
            3 => term.factors[j] = self.language.factor(draws),
            4 | 5 => self.exponent(&mut term.factors[j], draws),
            6 | 7 => self.part(&mut term.factors[j], draws),
            8 => self.operation(&mut term.factors[j], draws),
            9 if !b.terms.is_empty() => {
                // A factor from the other parent.
                let other = &b.terms[draws.below(b.terms.len())];
                let factor = other.factors[draws.below(other.factors.len())].clone();
                if draws.chance(0.5) && term.factors.len() < self.bounds.factors {
                    term.factors.push(factor);
                } else {
                    term.factors[j] = factor;
                }
            }
            10 => {
                // Something beside a part inside.
                let beside = self.language.part(draws);
                let at = draws.below(term.factors[j].len());
                let tail = term.factors[j].split_off(at + 1);
                term.factors[j].extend(beside);
                term.factors[j].push(draws.of(&[Step::Add, Step::Mul, Step::Sub]));
                term.factors[j].extend(tail);
            }
            _ => {
                let function = self.language.function(draws);
                term.factors[j].push(function);
            }
        }
        self.tidy(term, draws);
    }

    /// Other factors of one input, or one more factor of each kind, as swings have them.
    fn swing(&self, term: &mut Product, draws: &mut Draws) {
        let swing = self.language.swing(draws);
        let read = |factor: &Factor| {
            let mut inputs: Vec<u8> = factor.iter().filter_map(|step| step.input()).collect();
            inputs.sort_unstable();
            inputs.dedup();
            inputs
        };
        let own = swing.factors.first().map(read).unwrap_or_default();
        if draws.chance(0.5) {
            term.factors.retain(|factor| read(factor) != own);
        }
        term.factors.extend(swing.factors);
        self.tidy(term, draws);
    }

    fn tidy(&self, term: &mut Product, draws: &mut Draws) {
        *term = Tidy { positive: &self.language.positive }.term(term);
        let most = self.bounds.nodes;
        for factor in &mut term.factors {
            if factor.len() > most {
                *factor = self.language.factor(draws);
            }
        }
        term.factors.truncate(self.bounds.factors);
    }

    /// Another exponent somewhere in a factor.
    fn exponent(&self, factor: &mut Factor, draws: &mut Draws) {
        let places: Vec<usize> =
            (0..factor.len()).filter(|at| matches!(factor[*at], Step::Power { .. })).collect();
        if places.is_empty() {
            factor.push(fixed(draws.of(&[2.0, -1.0, 3.0, 0.5])));
            return;
        }
        let at = draws.of(&places);
        if let Step::Power { exponent, free } = &mut factor[at] {
            match draws.below(4) {
                0 => *exponent += draws.of(&[-1.0, -0.5, 0.5, 1.0]),
                1 => {
                    *free = true;
                    *exponent += 0.3 * draws.normal();
                }
                2 => {
                    *free = false;
                    *exponent = (2.0 * *exponent).round() * 0.5;
                }
                _ => *exponent = draws.of(&[2.0, 3.0, -1.0, 0.5, -2.0, 1.5, 4.0, -0.5]),
            }
            *exponent = math::limit(*exponent, -MOST_EXPONENT, MOST_EXPONENT);
            if *exponent == 0.0 || *exponent == 1.0 && !*free {
                factor.remove(at);
            }
        }
    }

    /// Another part somewhere in a factor.
    fn part(&self, factor: &mut Factor, draws: &mut Draws) {
        let end = draws.below(factor.len());
        let start = start_of(factor, end);
        let new = self.language.part(draws);
        factor.splice(start..=end, new);
    }

    /// Another operation somewhere in a factor.
    fn operation(&self, factor: &mut Factor, draws: &mut Draws) {
        let at = draws.below(factor.len());
        match factor[at].arity() {
            2 => factor[at] = draws.of(&[Step::Add, Step::Sub, Step::Mul, Step::Div]),
            1 => {
                if draws.chance(0.4) {
                    factor.remove(at);
                } else {
                    factor[at] = self.language.function(draws);
                }
            }
            _ => factor[at] = Step::Input(self.language.input(draws) as u8),
        }
    }
}

/// Other constants, to fit from another place.
fn shake(sum: &mut Sum, draws: &mut Draws) {
    let width = if draws.chance(0.5) { 0.2 } else { 1.0 };
    for term in &mut sum.terms {
        for constant in term.constants_mut() {
            *constant *= 1.0 + width * draws.normal();
        }
    }
}
