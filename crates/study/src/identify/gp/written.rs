//! A formula of the search as one that people read: terms with their signs, divisions for negative powers,
//! terms that belong together joined.

use super::node::{Product, Step, Sum};
use crate::base::formula::{Formula, Function, Node as Tree, Operator};

fn product(a: Option<Tree>, b: Tree) -> Tree {
    match a {
        Some(a) => Tree::binary(Operator::Multiply, a, b),
        None => b,
    }
}

fn power(base: Tree, exponent: f64) -> Tree {
    if exponent == 1.0 {
        base
    } else if exponent == 0.5 {
        Tree::unary(Function::Sqrt, base)
    } else {
        Tree::binary(Operator::Power, base, Tree::Number(exponent))
    }
}

/// A factor as a tree.
fn tree(code: &[Step], parts: &Columns) -> Tree {
    let mut stack: Vec<Tree> = Vec::new();
    let missing = || Tree::Number(f64::NAN);
    for node in code {
        let mut pop = || stack.pop().unwrap_or_else(missing);
        let tree = match *node {
            Step::Input(number) => parts.tree(usize::from(number)),
            Step::Constant(value) => Tree::Number(value),
            Step::Add => match (pop(), pop()) {
                (Tree::Number(b), a) if b < 0.0 => {
                    Tree::binary(Operator::Subtract, a, Tree::Number(-b))
                }
                (b, a) => Tree::binary(Operator::Add, a, b),
            },
            Step::Sub => {
                let (b, a) = (pop(), pop());
                Tree::binary(Operator::Subtract, a, b)
            }
            Step::Mul => match (pop(), pop()) {
                // Scales stand first, as people write them.
                (b @ Tree::Number(_), a) => Tree::binary(Operator::Multiply, b, a),
                (b, a) => Tree::binary(Operator::Multiply, a, b),
            },
            Step::Div => {
                let (b, a) = (pop(), pop());
                Tree::binary(Operator::Divide, a, b)
            }
            Step::Power { exponent, .. } if exponent < 0.0 => {
                let base = power(pop(), -exponent);
                Tree::binary(Operator::Divide, Tree::Number(1.0), base)
            }
            Step::Power { exponent, .. } => power(pop(), exponent),
            Step::Ln => Tree::unary(Function::Ln, pop()),
            Step::Exp => Tree::unary(Function::Exp, pop()),
            Step::Sin => Tree::unary(Function::Sin, pop()),
            Step::Cos => Tree::unary(Function::Cos, pop()),
        };
        stack.push(tree);
    }
    stack.pop().unwrap_or_else(missing)
}

/// A term times a number that is not negative.
fn term(term: &Product, coefficient: f64, parts: &Columns) -> Tree {
    let mut above = (coefficient != 1.0).then_some(Tree::Number(coefficient));
    let mut below = None;
    for factor in &term.factors {
        match factor.split_last() {
            Some((Step::Power { exponent, .. }, base)) if *exponent < 0.0 => {
                below = Some(product(below, power(tree(base, parts), -exponent)));
            }
            _ => above = Some(product(above, tree(factor, parts))),
        }
    }
    match (above, below) {
        (above, Some(below)) => {
            Tree::binary(Operator::Divide, above.unwrap_or(Tree::Number(1.0)), below)
        }
        (above, None) => above.unwrap_or(Tree::Number(1.0)),
    }
}

/// What the inputs of the search stand for: columns by their names, then the parts of a template.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Columns {
    /// Names of the columns.
    pub names: Vec<String>,
    /// Formulas of the columns.
    pub parts: Vec<Formula>,
}

impl Columns {
    fn tree(&self, input: usize) -> Tree {
        match input.checked_sub(self.names.len()).and_then(|part| self.parts.get(part)) {
            Some(part) => part.root().clone(),
            None => Tree::Input(input),
        }
    }
}

/// The formula of the columns, simplified.
///
/// # Errors
/// A constant is not finite, or a name does not do.
pub fn formula(sum: &Sum, columns: &Columns) -> Result<Formula, String> {
    let mut whole = sum.intercept.then(|| Tree::Number(sum.coefficients[0]));
    // What is added first, so that no formula begins with a sign where that can be helped.
    let terms = sum.terms.iter().zip(&sum.coefficients[1..]);
    let (added, taken): (Vec<_>, Vec<_>) = terms.partition(|(_, c)| **c >= 0.0);
    for (next, coefficient) in added.into_iter().chain(taken) {
        whole = Some(match whole {
            None => {
                let tree = term(next, coefficient.abs(), columns);
                if *coefficient < 0.0 { term_with_sign(next, *coefficient, columns) } else { tree }
            }
            Some(whole) => {
                let operator = if *coefficient < 0.0 { Operator::Subtract } else { Operator::Add };
                Tree::binary(operator, whole, term(next, coefficient.abs(), columns))
            }
        });
    }
    let raw = Formula::new(whole.unwrap_or(Tree::Number(0.0)), &columns.names)?;
    Ok(raw.simplified())
}

fn term_with_sign(next: &Product, coefficient: f64, parts: &Columns) -> Tree {
    if coefficient == -1.0 {
        Tree::unary(Function::Negative, term(next, 1.0, parts))
    } else {
        term(next, coefficient, parts)
    }
}

/// Formulas with fewer nodes that may say the same: two terms with common factors joined.
#[must_use]
pub fn joined(sum: &Sum, kept: &[Product]) -> Vec<Sum> {
    let mut found = Vec::new();
    for a in 0..sum.terms.len() {
        for b in 0..sum.terms.len() {
            if a == b || kept.contains(&sum.terms[a]) || kept.contains(&sum.terms[b]) {
                continue;
            }
            let (one, other) = (&sum.terms[a], &sum.terms[b]);
            // c1 A X + c2 A becomes c1 A (X + c2 / c1), with X = ln u it becomes c1 A ln(e^(c2 / c1) u).
            let Some(extra) = only_extra(one, other) else { continue };
            let ratio = sum.coefficients[b + 1] / sum.coefficients[a + 1];
            let mut next = sum.clone();
            let factor = &mut next.terms[a].factors[extra];
            if factor.last() == Some(&Step::Ln) {
                let scale = crate::base::math::exp(ratio);
                factor.pop();
                let scaled = factor.len() >= 3
                    && factor[factor.len() - 1] == Step::Mul
                    && matches!(factor[factor.len() - 2], Step::Constant(_));
                if scaled {
                    let at = factor.len() - 2;
                    if let Step::Constant(k) = &mut factor[at] {
                        *k *= scale;
                    }
                    factor.push(Step::Ln);
                } else {
                    factor.extend([Step::Constant(scale), Step::Mul, Step::Ln]);
                }
            } else {
                factor.extend([Step::Constant(ratio), Step::Add]);
            }
            next.terms.remove(b);
            next.coefficients.remove(b + 1);
            found.push(next);
        }
    }
    found
}

/// The one factor that `one` has beyond all of `other`.
fn only_extra(one: &Product, other: &Product) -> Option<usize> {
    if one.factors.len() != other.factors.len() + 1 || other.factors.is_empty() {
        return None;
    }
    let mut left: Vec<usize> = (0..one.factors.len()).collect();
    for factor in &other.factors {
        let at = left.iter().position(|index| one.factors[*index] == *factor)?;
        left.remove(at);
    }
    left.first().copied()
}
