//! What the search works on: a sum of terms, each a product of factors, each a small formula in postfix.
//!
//! ```text
//! y = c_0 + sum_k c_k T_k,   T_k = product_j F_kj^(+1 or -1)
//! ```
//!
//! The coefficients c enter linearly and are found by least squares; constants and exponents inside the
//! factors by Levenberg and Marquardt's method (`fit.rs`). A sum keeps effects apart that a tree would have
//! to approximate by products, a product keeps the factors of a law together.

use serde::{Deserialize, Serialize};

/// An operation of a factor, in postfix.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Step {
    /// An input, by its number.
    Input(u8),
    /// A constant.
    Constant(f64),
    /// Sum of two.
    Add,
    /// Difference of two.
    Sub,
    /// Product of two.
    Mul,
    /// Quotient of two.
    Div,
    /// A constant power; a free exponent is fitted.
    Power {
        /// The exponent.
        exponent: f64,
        /// Whether it is fitted.
        free: bool,
    },
    /// Natural logarithm.
    Ln,
    /// Exponential function.
    Exp,
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
}

impl Step {
    /// How many values it takes.
    #[must_use]
    pub fn arity(self) -> usize {
        match self {
            Self::Input(_) | Self::Constant(_) => 0,
            Self::Add | Self::Sub | Self::Mul | Self::Div => 2,
            Self::Power { .. } | Self::Ln | Self::Exp | Self::Sin | Self::Cos => 1,
        }
    }

    /// The input that it reads.
    #[must_use]
    pub fn input(self) -> Option<u8> {
        match self {
            Self::Input(number) => Some(number),
            Self::Constant(_)
            | Self::Add
            | Self::Sub
            | Self::Mul
            | Self::Div
            | Self::Power { .. }
            | Self::Ln
            | Self::Exp
            | Self::Sin
            | Self::Cos => None,
        }
    }

    /// The exponent of a power, and whether it is fitted.
    #[must_use]
    pub fn power(self) -> Option<(f64, bool)> {
        match self {
            Self::Power { exponent, free } => Some((exponent, free)),
            Self::Input(_)
            | Self::Constant(_)
            | Self::Add
            | Self::Sub
            | Self::Mul
            | Self::Div
            | Self::Ln
            | Self::Exp
            | Self::Sin
            | Self::Cos => None,
        }
    }

    /// Nodes that it is printed with: a power has its exponent, but a square root is one node.
    fn size(self) -> usize {
        1 + usize::from(self.power().is_some_and(|power| power != (0.5, false)))
    }

    /// Whether a value of it is fitted.
    #[must_use]
    pub fn is_free(self) -> bool {
        matches!(self, Self::Constant(_)) || self.power().is_some_and(|(_, free)| free)
    }

    /// Whether it is periodic.
    #[must_use]
    pub fn is_periodic(self) -> bool {
        matches!(self, Self::Sin | Self::Cos)
    }
}

/// A small formula in postfix.
pub type Factor = Vec<Step>;

/// The reciprocal.
pub const RECIPROCAL: Step = Step::Power { exponent: -1.0, free: false };

/// A fixed exponent.
#[must_use]
pub fn fixed(exponent: f64) -> Step {
    Step::Power { exponent, free: false }
}

/// Where the part of a formula begins that ends at `end`.
#[must_use]
pub fn start_of(code: &[Step], end: usize) -> usize {
    let mut wanted = 1;
    let mut at = end + 1;
    while wanted > 0 {
        at -= 1;
        wanted = wanted - 1 + code[at].arity();
    }
    at
}

/// Nodes that a formula is printed with.
#[must_use]
pub fn size_of(code: &[Step]) -> usize {
    code.iter().map(|node| node.size()).sum()
}

/// A product of factors.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct Product {
    /// The factors, at least one.
    pub factors: Vec<Factor>,
}

impl Product {
    /// A term of one factor.
    #[must_use]
    pub fn of(factor: Factor) -> Self {
        Self { factors: vec![factor] }
    }

    /// The whole term as one formula.
    #[must_use]
    pub fn code(&self) -> Vec<Step> {
        let mut code = Vec::new();
        for (number, factor) in self.factors.iter().enumerate() {
            code.extend_from_slice(factor);
            if number > 0 {
                code.push(Step::Mul);
            }
        }
        code
    }

    /// Nodes that it is printed with, its coefficient and the sign before it included.
    #[must_use]
    pub fn size(&self) -> usize {
        let factor = |factor: &Factor| {
            let base = if factor.last() == Some(&RECIPROCAL) { 2 } else { 0 };
            1 + size_of(factor) - base
        };
        2 + self.factors.iter().map(factor).sum::<usize>()
    }

    /// Number of fitted constants inside.
    #[must_use]
    pub fn constants(&self) -> usize {
        self.nodes().filter(|node| node.is_free()).count()
    }

    /// All nodes of all factors.
    pub fn nodes(&self) -> impl Iterator<Item = &Step> {
        self.factors.iter().flatten()
    }

    /// The fitted constants, to be changed.
    pub fn constants_mut(&mut self) -> impl Iterator<Item = &mut f64> {
        self.factors.iter_mut().flatten().filter_map(|node| match node {
            Step::Constant(value) | Step::Power { exponent: value, free: true } => Some(value),
            Step::Power { .. }
            | Step::Input(_)
            | Step::Add
            | Step::Sub
            | Step::Mul
            | Step::Div
            | Step::Ln
            | Step::Exp
            | Step::Sin
            | Step::Cos => None,
        })
    }

    /// The same but for constants and free exponents, for comparison.
    #[must_use]
    pub fn shape(&self) -> u64 {
        let mut shapes: Vec<u64> = self
            .factors
            .iter()
            .map(|factor| factor.iter().fold(17, |hash, node| mix(hash, node_code(*node))))
            .collect();
        shapes.sort_unstable();
        shapes.into_iter().fold(3, mix)
    }
}

fn mix(hash: u64, next: u64) -> u64 {
    let mut z = (hash ^ next).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z ^= z >> 29;
    z.wrapping_mul(0xbf58_476d_1ce4_e5b9) ^ (z >> 32)
}

fn node_code(node: Step) -> u64 {
    match node {
        Step::Input(number) => 100 + u64::from(number),
        Step::Constant(_) => 1,
        Step::Add => 2,
        Step::Sub => 3,
        Step::Mul => 4,
        Step::Div => 5,
        Step::Power { free: true, .. } => 6,
        Step::Power { exponent, free: false } => exponent.to_bits(),
        Step::Ln => 7,
        Step::Exp => 8,
        Step::Sin => 9,
        Step::Cos => 10,
    }
}

/// A formula of the search: terms and what they are multiplied by.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sum {
    /// Whether it has a constant term.
    pub intercept: bool,
    /// The terms.
    pub terms: Vec<Product>,
    /// The constant term, 0 where there is none, then the coefficient of each term.
    pub coefficients: Vec<f64>,
}

impl Default for Sum {
    /// A constant.
    fn default() -> Self {
        Self::of(true, Vec::new())
    }
}

impl Sum {
    /// A formula before its fit.
    #[must_use]
    pub fn of(intercept: bool, terms: Vec<Product>) -> Self {
        Self { intercept, terms, coefficients: Vec::new() }
    }

    /// Nodes that it is printed with.
    #[must_use]
    pub fn size(&self) -> usize {
        let terms = self.terms.iter().map(Product::size).sum::<usize>();
        // Without a constant term, the first one needs no sign before it.
        if self.intercept { terms + 1 } else { terms.saturating_sub(1) }
    }

    /// Number of coefficients that are fitted, the constant term included.
    #[must_use]
    pub fn linear(&self) -> usize {
        usize::from(self.intercept) + self.terms.len()
    }

    /// Number of fitted constants, coefficients included.
    #[must_use]
    pub fn constants(&self) -> usize {
        self.linear() + self.terms.iter().map(Product::constants).sum::<usize>()
    }

    /// The same but for constants, whatever the order of the terms.
    #[must_use]
    pub fn shape(&self) -> u64 {
        let mut shapes: Vec<u64> = self.terms.iter().map(Product::shape).collect();
        shapes.sort_unstable();
        shapes.into_iter().fold(5 + u64::from(self.intercept), mix)
    }

    /// Whether it can be evaluated on this many inputs: one coefficient for each term, every part whole.
    #[must_use]
    pub fn is_sound(&self, inputs: usize) -> bool {
        let whole = |factor: &Factor| {
            let mut depth = 0_usize;
            let fits = factor.iter().all(|node| {
                let known = match node {
                    Step::Input(number) => usize::from(*number) < inputs,
                    Step::Constant(value) => value.is_finite(),
                    Step::Power { exponent, .. } => exponent.is_finite(),
                    Step::Add
                    | Step::Sub
                    | Step::Mul
                    | Step::Div
                    | Step::Ln
                    | Step::Exp
                    | Step::Sin
                    | Step::Cos => true,
                };
                let enough = depth >= node.arity();
                depth = (depth + 1).saturating_sub(node.arity());
                known && enough
            });
            fits && depth == 1
        };
        self.coefficients.len() == self.terms.len() + 1
            && self.coefficients.iter().all(|c| c.is_finite())
            && self.terms.iter().all(|term| !term.factors.is_empty())
            && self.terms.iter().flat_map(|term| &term.factors).all(whole)
    }

    /// A constant that stands beside a whole term is the constant term: the same formula has one form.
    pub fn settle(&mut self) {
        for term in &mut self.terms {
            let [factor] = &mut term.factors[..] else { continue };
            while let [.., Step::Constant(_), Step::Add] = factor[..] {
                factor.truncate(factor.len() - 2);
                self.intercept = true;
            }
        }
    }

    /// How many sines and cosines it has.
    #[must_use]
    pub fn periodic(&self) -> usize {
        self.terms.iter().flat_map(Product::nodes).filter(|node| node.is_periodic()).count()
    }
}
