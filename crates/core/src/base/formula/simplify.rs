//! A shorter formula of the same values.
//!
//! Sums are taken apart into terms with a factor each, products into factors above and below the line with an
//! exponent each; equal ones are joined and the rest is put together again. Nothing is cancelled between above
//! and below, and no even root or logarithm is undone: those would give the formula values where it has none.

use super::{Function, Node, Operator};
use crate::base::math::MAX_WHOLE;

/// A formula shrinks in each pass or is left as it is.
const PASSES: usize = 8;

/// The simplified node: of the same values but for rounding, with no more nodes.
pub(super) fn simplify(node: &Node) -> Node {
    let mut best = node.clone();
    for _ in 0..PASSES {
        let next = pass(&best);
        if next == best || next.size() > best.size() {
            break;
        }
        best = next;
    }
    best
}

/// Whether a node has a value at all finite inputs (but for overflow).
fn always(node: &Node) -> bool {
    let own = match node {
        Node::Number(_) | Node::Input(_) | Node::Constant(_) => true,
        Node::Unary(function, _) => match function {
            Function::Negative | Function::Sin | Function::Cos | Function::Tanh => true,
            Function::Ln | Function::Exp | Function::Sqrt => false,
        },
        Node::Binary(operator, pair) => match operator {
            Operator::Add | Operator::Subtract | Operator::Multiply => true,
            Operator::Divide => false,
            Operator::Power => {
                pair[1].number().is_some_and(|y| (0.0..=MAX_WHOLE).contains(&y) && y.fract() == 0.0)
            }
        },
    };
    own && node.operands().iter().all(always)
}

/// Operands first, then the node.
fn pass(node: &Node) -> Node {
    match node {
        Node::Number(_) | Node::Input(_) | Node::Constant(_) => node.clone(),
        Node::Unary(function, operand) => {
            let made = Node::unary(*function, pass(operand));
            if *function == Function::Negative { together(&made) } else { folded(made) }
        }
        Node::Binary(operator, pair) => {
            let made = Node::binary(*operator, pass(&pair[0]), pass(&pair[1]));
            together(&folded(made))
        }
    }
}

/// The number that an operation on numbers gives, where it is finite.
fn folded(node: Node) -> Node {
    let numbers = node.operands().iter().all(|operand| operand.number().is_some());
    let value = if numbers { node.value(&[]) } else { f64::NAN };
    if value.is_finite() { Node::Number(value) } else { node }
}

/// Takes sums and products apart and puts them together again, where that is no longer than before.
fn together(node: &Node) -> Node {
    let made = match node {
        Node::Binary(Operator::Add | Operator::Subtract, _) => Sum::of(node).node(),
        Node::Unary(Function::Negative, _)
        | Node::Binary(Operator::Multiply | Operator::Divide | Operator::Power, _) => {
            let product = Product::of(node);
            match &*product.above {
                [factor] if factor.exponent == 1.0 && product.is_sign_of_one() => {
                    Sum::of(node).node()
                }
                _ => product.node(),
            }
        }
        Node::Number(_) | Node::Input(_) | Node::Constant(_) | Node::Unary(..) => node.clone(),
    };
    if made.size() <= node.size() { made } else { node.clone() }
}

/// A base with a positive exponent.
#[derive(Clone, Debug, PartialEq)]
struct Factor {
    base: Node,
    exponent: f64,
}

impl Factor {
    fn node(&self) -> Node {
        let base = self.base.clone();
        if self.exponent == 1.0 {
            base
        } else if self.exponent == 0.5 {
            Node::unary(Function::Sqrt, base)
        } else {
            Node::binary(Operator::Power, base, Node::Number(self.exponent))
        }
    }
}

/// number / divisor * above / below.
#[derive(Clone, Debug, PartialEq)]
struct Product {
    number: f64,
    divisor: f64,
    above: Vec<Factor>,
    below: Vec<Factor>,
}

impl Product {
    fn number(x: f64) -> Self {
        Self { number: x, divisor: 1.0, above: Vec::new(), below: Vec::new() }
    }

    fn factor(base: Node, exponent: f64) -> Self {
        Self { above: vec![Factor { base, exponent }], ..Self::number(1.0) }
    }

    fn coefficient(&self) -> f64 {
        self.number / self.divisor
    }

    fn is_sign_of_one(&self) -> bool {
        self.coefficient().abs() == 1.0 && self.below.is_empty()
    }

    /// The node as a product; of one factor, itself, where it is none.
    fn of(node: &Node) -> Self {
        let itself = || Self::factor(node.clone(), 1.0);
        match node {
            Node::Number(x) => Self::number(*x),
            Node::Unary(Function::Negative, operand) => {
                let inner = Self::of(operand);
                Self { number: -inner.number, ..inner }
            }
            Node::Binary(Operator::Multiply, pair) => {
                Self::of(&pair[0]).times(Self::of(&pair[1])).unwrap_or_else(itself)
            }
            Node::Binary(Operator::Divide, pair) => Self::of(&pair[1])
                .inverse()
                .and_then(|inverse| Self::of(&pair[0]).times(inverse))
                .unwrap_or_else(itself),
            Node::Binary(Operator::Power, pair) => match pair[1].number() {
                Some(0.0) => Self::number(1.0),
                Some(exponent) if exponent > 0.0 => Self::factor(pair[0].clone(), exponent),
                Some(exponent) if pair[0].number().is_none() => {
                    Self::factor(pair[0].clone(), -exponent).inverse().unwrap_or_else(itself)
                }
                Some(_) | None => itself(),
            },
            Node::Input(_)
            | Node::Constant(_)
            | Node::Unary(..)
            | Node::Binary(Operator::Add | Operator::Subtract, _) => itself(),
        }
    }

    fn inverse(self) -> Option<Self> {
        let Self { number, divisor, above, below } = self;
        let inverse = Self { number: divisor, divisor: number, above: below, below: above };
        (number != 0.0).then_some(inverse)
    }

    /// None where the numbers overflow or vanish.
    fn times(mut self, other: Self) -> Option<Self> {
        let nothing = self.number == 0.0 || other.number == 0.0;
        self.number *= other.number;
        self.divisor *= other.divisor;
        let coefficient = self.coefficient();
        let good = self.number.is_finite() && self.divisor.is_normal() && coefficient.is_finite();
        other.above.into_iter().for_each(|factor| join(&mut self.above, factor));
        other.below.into_iter().for_each(|factor| join(&mut self.below, factor));
        (good && (coefficient != 0.0) != nothing).then_some(self)
    }

    /// Whether it is 0 wherever there are inputs.
    fn is_nothing(&self) -> bool {
        let always = |factor: &Factor| always(&factor.node());
        self.number == 0.0 && self.below.is_empty() && self.above.iter().all(always)
    }

    fn node(&self) -> Node {
        if self.is_nothing() {
            return Node::Number(0.0);
        }
        // x / 3 rather than 0.3333333333333333 * x.
        let third = self.number.abs() == 1.0 && !self.above.is_empty() && self.below.is_empty();
        let (number, divisor) = if third && self.divisor.abs() != 1.0 {
            (self.number * self.divisor.signum(), Some(Node::Number(self.divisor.abs())))
        } else {
            (self.coefficient(), chain(None, &self.below))
        };
        let above = if self.above.is_empty() || number.abs() != 1.0 {
            chain(Some(Node::Number(number)), &self.above)
        } else {
            chain(None, &self.above)
        };
        let above = above.unwrap_or(Node::Number(number));
        let node = match divisor {
            Some(divisor) => Node::binary(Operator::Divide, above, divisor),
            None => above,
        };
        let negative = number == -1.0 && !self.above.is_empty();
        if negative { Node::unary(Function::Negative, node) } else { node }
    }

    /// Whether both are the same but for their coefficients and the order of their factors.
    fn is_like(&self, other: &Self) -> bool {
        alike(&self.above, &other.above) && alike(&self.below, &other.below)
    }
}

fn alike(a: &[Factor], b: &[Factor]) -> bool {
    let count = |all: &[Factor], one: &Factor| all.iter().filter(|factor| *factor == one).count();
    a.len() == b.len() && a.iter().all(|factor| count(a, factor) == count(b, factor))
}

/// Joins a factor with an equal base, where both have values at the same places: two roots of x are not x,
/// and x^40 x^40 has values below 0, where x^80 is no product any more.
fn join(factors: &mut Vec<Factor>, new: Factor) {
    let joins = |factor: &Factor| {
        let sum = factor.exponent + new.exponent;
        let whole = [factor.exponent, new.exponent].map(|x| x.fract() == 0.0 && x <= MAX_WHOLE);
        match whole {
            [true, true] => sum <= MAX_WHOLE,
            [true, false] | [false, true] => true,
            [false, false] => sum.fract() != 0.0,
        }
    };
    match factors.iter_mut().find(|factor| factor.base == new.base && joins(factor)) {
        Some(factor) => factor.exponent += new.exponent,
        None => factors.push(new),
    }
}

/// The product of factors behind a first one; none where there are none.
fn chain(first: Option<Node>, factors: &[Factor]) -> Option<Node> {
    let nodes = first.into_iter().chain(factors.iter().map(Factor::node));
    nodes.reduce(|left, right| Node::binary(Operator::Multiply, left, right))
}

/// A sum of products, those of numbers alone first joined to one.
struct Sum {
    terms: Vec<Product>,
}

impl Sum {
    fn of(node: &Node) -> Self {
        let mut sum = Self { terms: Vec::new() };
        sum.add(node, 1.0);
        sum
    }

    fn add(&mut self, node: &Node, sign: f64) {
        if let Node::Binary(Operator::Add, pair) = node {
            self.add(&pair[0], sign);
            return self.add(&pair[1], sign);
        }
        if let Node::Binary(Operator::Subtract, pair) = node {
            self.add(&pair[0], sign);
            return self.add(&pair[1], -sign);
        }
        let mut product = Product::of(node);
        product.number *= sign;
        if let [factor] = &*product.above
            && factor.exponent == 1.0
            && product.is_sign_of_one()
            && factor.base != *node
        {
            let (base, sign) = (factor.base.clone(), product.coefficient());
            return self.add(&base, sign);
        }
        let like = self.terms.iter_mut().find(|term| term.is_like(&product));
        let sum = like.as_ref().map(|term| term.coefficient() + product.coefficient());
        match (like, sum) {
            (Some(term), Some(sum)) if sum.is_finite() => (term.number, term.divisor) = (sum, 1.0),
            (_, _) => self.terms.push(product),
        }
    }

    fn node(mut self) -> Node {
        // What adds nothing wherever it has a value, and has one everywhere.
        self.terms.retain(|term| !term.is_nothing());
        // A sum does not begin with a sign that its second term could bear.
        let positive = self.terms.iter().position(|term| term.coefficient() > 0.0);
        if let Some(positive) = positive
            && self.terms[0].coefficient() < 0.0
        {
            let first = self.terms.remove(positive);
            self.terms.insert(0, first);
        }
        let mut terms = self.terms.into_iter();
        let first = terms.next().map_or(Node::Number(0.0), |term| term.node());
        terms.fold(first, |sum, mut term| {
            if term.coefficient() < 0.0 {
                (term.number, term.divisor) = (term.number.abs(), term.divisor.abs());
                Node::binary(Operator::Subtract, sum, term.node())
            } else {
                Node::binary(Operator::Add, sum, term.node())
            }
        })
    }
}
