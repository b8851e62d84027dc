//! The parts of a formula.

use crate::base::math;

/// A function of one operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    /// Change of sign.
    Negative,
    /// Natural logarithm.
    Ln,
    /// Exponential.
    Exp,
    /// Square root.
    Sqrt,
    /// Sine of radians.
    Sin,
    /// Cosine of radians.
    Cos,
    /// Hyperbolic tangent.
    Tanh,
}

impl Function {
    /// All of them.
    pub const ALL: [Self; 7] =
        [Self::Negative, Self::Ln, Self::Exp, Self::Sqrt, Self::Sin, Self::Cos, Self::Tanh];

    /// The name in a formula; `-` for the sign.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Negative => "-",
            Self::Ln => "ln",
            Self::Exp => "exp",
            Self::Sqrt => "sqrt",
            Self::Sin => "sin",
            Self::Cos => "cos",
            Self::Tanh => "tanh",
        }
    }

    /// The value at `x`.
    #[must_use]
    #[inline]
    pub fn at(self, x: f64) -> f64 {
        match self {
            Self::Negative => -x,
            Self::Ln => math::ln(x),
            Self::Exp => math::exp(x),
            Self::Sqrt => x.sqrt(),
            Self::Sin => math::sin(x),
            Self::Cos => math::cos(x),
            Self::Tanh => math::tanh(x),
        }
    }
}

/// An operator between two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Operator {
    /// Sum.
    Add,
    /// Difference.
    Subtract,
    /// Product.
    Multiply,
    /// Quotient.
    Divide,
    /// [`power`](math::power).
    Power,
}

impl Operator {
    /// All of them.
    pub const ALL: [Self; 5] =
        [Self::Add, Self::Subtract, Self::Multiply, Self::Divide, Self::Power];

    /// The sign in a formula.
    #[must_use]
    pub fn sign(self) -> char {
        match self {
            Self::Add => '+',
            Self::Subtract => '-',
            Self::Multiply => '*',
            Self::Divide => '/',
            Self::Power => '^',
        }
    }

    /// The value of `x` and `y` in this order.
    #[must_use]
    #[inline]
    pub fn at(self, x: f64, y: f64) -> f64 {
        match self {
            Self::Add => x + y,
            Self::Subtract => x - y,
            Self::Multiply => x * y,
            Self::Divide => x / y,
            Self::Power => math::power(x, y),
        }
    }
}

/// A constant that a formula calls by its name.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedConstant {
    /// The name.
    pub name: String,
    /// The value.
    pub value: f64,
}

/// A part of a formula: a leaf, or an operation on smaller parts.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// A number; a negative one is one node, not a minus sign before a number.
    Number(f64),
    /// An input, by its place in [`Formula::inputs`](super::Formula::inputs).
    Input(usize),
    /// A constant with a name.
    Constant(NamedConstant),
    /// A function of one operand.
    Unary(Function, Box<Node>),
    /// An operator between two operands.
    Binary(Operator, Box<[Node; 2]>),
}

impl Node {
    /// A function of an operand; the sign of a number goes into the number.
    #[must_use]
    pub fn unary(function: Function, operand: Self) -> Self {
        match (function, operand.number()) {
            (Function::Negative, Some(x)) => Self::Number(-x),
            (_, _) => Self::Unary(function, Box::new(operand)),
        }
    }

    /// An operator between two operands.
    #[must_use]
    pub fn binary(operator: Operator, left: Self, right: Self) -> Self {
        Self::Binary(operator, Box::new([left, right]))
    }

    /// The number, where it is one.
    #[must_use]
    pub fn number(&self) -> Option<f64> {
        if let Self::Number(x) = self { Some(*x) } else { None }
    }

    /// Its operands, from left to right.
    #[must_use]
    pub fn operands(&self) -> &[Self] {
        match self {
            Self::Number(_) | Self::Input(_) | Self::Constant(_) => &[],
            Self::Unary(_, operand) => std::slice::from_ref(&**operand),
            Self::Binary(_, pair) => &**pair,
        }
    }

    /// The number of nodes: every number, input, constant, function and operator counts.
    #[must_use]
    pub fn size(&self) -> usize {
        1 + self.operands().iter().map(Self::size).sum::<usize>()
    }

    /// The value at `inputs`; NaN for an input that is not there.
    #[must_use]
    pub fn value(&self, inputs: &[f64]) -> f64 {
        match self {
            Self::Number(x) => *x,
            Self::Input(index) => inputs.get(*index).copied().unwrap_or(f64::NAN),
            Self::Constant(constant) => constant.value,
            Self::Unary(function, operand) => function.at(operand.value(inputs)),
            Self::Binary(operator, pair) => {
                operator.at(pair[0].value(inputs), pair[1].value(inputs))
            }
        }
    }

    /// The number of levels, without recursion deeper than `limit`.
    pub(super) fn depth(&self, limit: usize) -> usize {
        if limit == 0 {
            return 1;
        }
        1 + self.operands().iter().map(|node| node.depth(limit - 1)).max().unwrap_or(0)
    }
}
