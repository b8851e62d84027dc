//! One form for formulas that are the same: constants folded, what the coefficient of a term can say taken
//! out of it, products as factors, powers of one base as one power. The search then has fewer places to
//! look at, and sizes are what they seem.

use super::node::{Factor, Product, RECIPROCAL, Step};
use crate::base::math;

/// Largest exponent, fitted or not.
pub const MOST_EXPONENT: f64 = 8.0;
/// Least fitted exponent: nearer to 0 a power is a logarithm in disguise.
pub const LEAST_EXPONENT: f64 = 0.02;

/// A formula as a tree.
#[derive(Clone, Debug, PartialEq)]
enum Part {
    Input(u8),
    Constant(f64),
    Two(Step, Box<Part>, Box<Part>),
    One(Step, Box<Part>),
}

use Part::{Constant, Input, One, Two};

fn one(node: Step, part: Part) -> Part {
    One(node, Box::new(part))
}

fn two(node: Step, a: Part, b: Part) -> Part {
    Two(node, Box::new(a), Box::new(b))
}

fn tree(code: &[Step]) -> Part {
    let mut stack: Vec<Part> = Vec::new();
    for node in code {
        let part = match *node {
            Step::Input(number) => Input(number),
            Step::Constant(value) => Constant(value),
            Step::Add | Step::Sub | Step::Mul | Step::Div => {
                let (b, a) = (stack.pop(), stack.pop());
                two(*node, a.unwrap_or(Constant(0.0)), b.unwrap_or(Constant(0.0)))
            }
            Step::Power { .. } | Step::Ln | Step::Exp | Step::Sin | Step::Cos => {
                one(*node, stack.pop().unwrap_or(Constant(0.0)))
            }
        };
        stack.push(part);
    }
    stack.pop().unwrap_or(Constant(0.0))
}

fn write(part: &Part, code: &mut Factor) {
    match part {
        Input(number) => code.push(Step::Input(*number)),
        Constant(value) => code.push(Step::Constant(*value)),
        Two(node, a, b) => {
            write(a, code);
            write(b, code);
            code.push(*node);
        }
        One(node, a) => {
            write(a, code);
            code.push(*node);
        }
    }
}

/// Knows which inputs are positive.
pub struct Tidy<'a> {
    /// Whether all values of an input are positive.
    pub positive: &'a [bool],
}

fn is_whole(x: f64) -> bool {
    x == x.floor()
}

fn is_even(x: f64) -> bool {
    is_whole(0.5 * x)
}

impl Tidy<'_> {
    fn is_positive(&self, part: &Part) -> bool {
        match part {
            Input(number) => self.positive[usize::from(*number)],
            Constant(value) => *value > 0.0,
            Two(Step::Add | Step::Mul | Step::Div, a, b) => {
                self.is_positive(a) && self.is_positive(b)
            }
            Two(..) => false,
            One(Step::Exp, _) => true,
            One(Step::Power { exponent, free: false }, a) => {
                is_even(*exponent) || self.is_positive(a)
            }
            One(Step::Power { .. }, a) => self.is_positive(a),
            One(..) => false,
        }
    }

    /// Whether `a c` is a power of something positive times something positive.
    fn is_scaled_power(&self, a: &Part, c: &Part) -> bool {
        let power = matches!(a, One(Step::Power { .. }, base) if self.is_positive(base));
        power && matches!(c, Constant(c) if *c > 0.0)
    }

    fn simplify(&self, part: Part) -> Part {
        match part {
            Input(_) | Constant(_) => part,
            One(node, a) => self.function(node, self.simplify(*a)),
            Two(node, a, b) => self.operation(node, self.simplify(*a), self.simplify(*b)),
        }
    }

    fn operation(&self, node: Step, a: Part, b: Part) -> Part {
        match (node, a, b) {
            (Step::Add, Constant(a), Constant(b)) => Constant(a + b),
            (Step::Sub, Constant(a), Constant(b)) => Constant(a - b),
            (Step::Mul, Constant(a), Constant(b)) => Constant(a * b),
            (Step::Div, Constant(a), Constant(b)) => Constant(a / b),
            (Step::Sub, a, Constant(b)) => self.operation(Step::Add, a, Constant(-b)),
            (Step::Div, a, Constant(b)) => self.operation(Step::Mul, a, Constant(1.0 / b)),
            (Step::Div, Constant(a), b) => {
                let reciprocal = self.function(RECIPROCAL, b);
                self.operation(Step::Mul, reciprocal, Constant(a))
            }
            (Step::Add | Step::Mul, Constant(a), b) => self.operation(node, b, Constant(a)),
            (Step::Add, a, Constant(0.0)) => a,
            (Step::Mul, a, Constant(1.0)) => a,
            (Step::Mul, _, Constant(0.0)) => Constant(0.0),
            (Step::Add, Two(Step::Add, a, c), Constant(b)) if matches!(*c, Constant(_)) => {
                let c = self.operation(Step::Add, *c, Constant(b));
                self.operation(Step::Add, *a, c)
            }
            (Step::Mul, Two(Step::Mul, a, c), Constant(b)) if matches!(*c, Constant(_)) => {
                let c = self.operation(Step::Mul, *c, Constant(b));
                self.operation(Step::Mul, *a, c)
            }
            (Step::Sub, a, b) if a == b => Constant(0.0),
            (Step::Div, a, b) if a == b => Constant(1.0),
            (Step::Add, a, b) if a == b => self.operation(Step::Mul, a, Constant(2.0)),
            (Step::Mul, a, b) if a == b => {
                self.function(Step::Power { exponent: 2.0, free: false }, a)
            }
            (node, a, b) => two(node, a, b),
        }
    }

    fn function(&self, node: Step, a: Part) -> Part {
        let power = |exponent: f64, free: bool| Step::Power { exponent, free };
        match (node, a) {
            (Step::Power { exponent, .. }, Constant(a)) => Constant(math::power(a, exponent)),
            (Step::Power { exponent: 1.0, free: false }, a) => a,
            (Step::Power { exponent: 0.0, free: false }, _) => Constant(1.0),
            (Step::Power { exponent, free }, One(Step::Power { exponent: inner, free: f }, a))
                if (exponent * inner).abs() <= MOST_EXPONENT
                    && (self.is_positive(&a) || is_whole(exponent) && !free && !f) =>
            {
                self.function(power(exponent * inner, free || f), *a)
            }
            (Step::Power { exponent, .. }, One(Step::Exp, a)) => {
                let a = self.operation(Step::Mul, *a, Constant(exponent));
                self.function(Step::Exp, a)
            }
            (Step::Power { exponent, free }, Two(Step::Mul, a, c)) if matches!(*c, Constant(c) if c > 0.0) =>
            {
                let a = self.function(power(exponent, free), *a);
                let c = self.function(Step::Power { exponent, free: false }, *c);
                self.operation(Step::Mul, a, c)
            }
            (Step::Power { exponent, free }, a) => one(power(exponent, free), a),
            (Step::Ln, Constant(a)) => Constant(math::ln(a)),
            (Step::Ln, One(Step::Exp, a)) => *a,
            (Step::Ln, One(Step::Power { exponent, .. }, a)) if self.is_positive(&a) => {
                let a = self.function(Step::Ln, *a);
                self.operation(Step::Mul, a, Constant(exponent))
            }
            // ln(c a^p) is p ln(c^(1/p) a).
            (Step::Ln, Two(Step::Mul, a, c)) if self.is_scaled_power(&a, &c) => {
                let (One(Step::Power { exponent, .. }, a), Constant(c)) = (*a, *c) else {
                    return Constant(f64::NAN);
                };
                let c = Constant(math::power(c, 1.0 / exponent));
                let a = self.operation(Step::Mul, *a, c);
                let a = self.function(Step::Ln, a);
                self.operation(Step::Mul, a, Constant(exponent))
            }
            (Step::Exp, Constant(a)) => Constant(math::exp(a)),
            (Step::Exp, One(Step::Ln, a)) => *a,
            (Step::Exp, Two(Step::Add, a, c)) if matches!(*c, Constant(_)) => {
                let a = self.function(Step::Exp, *a);
                let c = self.function(Step::Exp, *c);
                self.operation(Step::Mul, a, c)
            }
            (Step::Sin, Constant(a)) => Constant(math::sin(a)),
            (Step::Cos, Constant(a)) => Constant(math::cos(a)),
            (node, a) => one(node, a),
        }
    }

    /// The factors of a formula; its constant factor is left out.
    fn split(&self, part: Part, factors: &mut Vec<Part>) {
        match part {
            Constant(_) => {}
            Two(Step::Mul, a, b) => {
                self.split(*a, factors);
                self.split(*b, factors);
            }
            Two(Step::Div, a, b) => {
                self.split(*a, factors);
                let b = self.function(RECIPROCAL, *b);
                self.split(b, factors);
            }
            One(Step::Power { exponent, free: false }, a)
                if is_whole(exponent) && matches!(*a, Two(Step::Mul | Step::Div, ..)) =>
            {
                let mut inner = Vec::new();
                self.split(*a, &mut inner);
                let power = Step::Power { exponent, free: false };
                factors.extend(inner.into_iter().map(|part| self.function(power, part)));
            }
            part @ (Input(_) | Two(..) | One(..)) => factors.push(part),
        }
    }

    /// The term in its one form; without factors where it does not vary.
    pub fn term(&self, term: &Product) -> Product {
        let mut parts = Vec::new();
        for factor in &term.factors {
            let part = self.simplify(tree(factor));
            self.split(part, &mut parts);
        }
        // Powers of one base become one power.
        let mut powers: Vec<(Part, f64, bool)> = Vec::new();
        for part in parts {
            let (base, exponent, free) = match part {
                One(Step::Power { exponent, free }, base) => (*base, exponent, free),
                part @ (Input(_) | Constant(_) | Two(..) | One(..)) => (part, 1.0, false),
            };
            let same = |(other, sum, _): &&mut (Part, f64, bool)| {
                *other == base && (*sum + exponent).abs() <= MOST_EXPONENT
            };
            match powers.iter_mut().find(same) {
                Some((_, sum, other_free)) => {
                    *sum += exponent;
                    *other_free |= free;
                }
                None => powers.push((base, exponent, free)),
            }
        }
        let mut factors = Vec::new();
        for (base, exponent, free) in powers {
            if exponent == 0.0 {
                continue;
            }
            let part = if exponent == 1.0 && !free {
                base
            } else {
                self.function(Step::Power { exponent, free }, base)
            };
            let mut factor = Vec::new();
            write(&part, &mut factor);
            if factor.iter().any(|node| matches!(node, Step::Input(_))) {
                factors.push(factor);
            }
        }
        Product { factors }
    }
}

#[cfg(test)]
mod tests {
    use super::super::draw::{Draws, Functions, Grammar};
    use super::super::evaluate::Sweeps;
    use super::super::rows::DataRows;
    use super::*;

    #[test]
    fn a_tidied_term_is_a_multiple_of_what_it_was_and_never_larger() {
        let column = |from: f64, by: f64| (0..50).map(|i| from + f64::from(i) * by).collect();
        let inputs: Vec<Vec<f64>> = vec![column(0.5, 0.03), column(-1.0, 0.041)];
        let rows = DataRows { target: inputs[0].clone(), inputs: inputs.clone() };
        let functions = Functions { ln: true, exp: true, periodic: true, scaled: false };
        let language = Grammar::new(&rows, rows.positive(), functions);
        let tidy = Tidy { positive: &[true, false] };
        let mut sweeps = Sweeps::default();
        let mut compared = 0;
        for number in 0..3000 {
            let mut draws = Draws::new(1, "tidy", number);
            let mut term = language.term(&mut draws);
            term.factors.push(language.part(&mut draws));
            let tidied = tidy.term(&term);
            let [mut before, mut after] = [vec![0.0; 50], vec![0.0; 50]];
            if tidied.factors.is_empty()
                || !sweeps.run(&term.code(), &inputs, &mut before, None)
                || before.iter().any(|x| x.abs() > 1e10)
            {
                continue;
            }
            assert!(sweeps.run(&tidied.code(), &inputs, &mut after, None), "{term:?}");
            assert_eq!(tidy.term(&tidied), tidied, "{term:?}");
            assert!(tidied.size() <= term.size() + 3, "{term:?} {tidied:?}");
            let product: f64 = before.iter().zip(&after).map(|(a, b)| a * b).sum();
            let square: f64 = after.iter().map(|b| b * b).sum();
            if !(square > 1e-200 && square < 1e200) {
                continue;
            }
            let most = before.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            for (before, after) in before.iter().zip(&after) {
                let error = (before - product / square * after).abs();
                assert!(error <= 1e-6 * most, "{term:?} {tidied:?}: {error}");
            }
            compared += 1;
        }
        assert!(compared > 1000, "{compared}");
    }
}
