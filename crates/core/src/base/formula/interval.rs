//! Bounds of a formula over ranges of its inputs, by interval arithmetic: whatever values the inputs take, the
//! value that [`Formula::value`](super::Formula::value) computes lies within.
//!
//! Sums, products, quotients, roots and whole powers are rounded the same way for neighbours, so their order is
//! kept and the ends bound all between; functions of the mathematics library may be wrong in the last bits, so
//! their ends are moved outwards.

use super::{Function, Node, Operator};
use crate::base::language::text;
use crate::base::math;

/// All numbers from `low` to `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Least number.
    pub low: f64,
    /// Largest number.
    pub high: f64,
}

/// A part of a formula that may have no value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hole {
    /// The number of the part, from the outermost on, a part before its operands.
    pub index: usize,
    /// What may happen there.
    pub why: &'static str,
}

/// Bound of the relative error of a function of the mathematics library, several times what it has.
const FUNCTION_ERROR: f64 = 4.0 * f64::EPSILON;

impl Interval {
    /// One number.
    #[must_use]
    pub fn point(x: f64) -> Self {
        Self { low: x, high: x }
    }

    /// From `low` to `high`.
    #[must_use]
    pub fn new(low: f64, high: f64) -> Self {
        Self { low, high }
    }

    /// Whether `x` is in it.
    #[must_use]
    pub fn contains(self, x: f64) -> bool {
        self.low <= x && x <= self.high
    }

    /// Its width.
    #[must_use]
    pub fn width(self) -> f64 {
        self.high - self.low
    }

    fn hull(all: impl IntoIterator<Item = f64>) -> Self {
        let [low, high] = math::extent(all.into_iter());
        Self { low, high }
    }

    /// One unit in the last place more on both sides.
    fn outward(self) -> Self {
        Self { low: self.low.next_down(), high: self.high.next_up() }
    }

    /// More on both sides by a part of the ends' magnitude.
    fn outward_by(self, part: f64) -> Self {
        let more = |x: f64| x.abs() * part;
        Self { low: self.low - more(self.low), high: self.high + more(self.high) }.outward()
    }

    fn is_finite(self) -> bool {
        self.low.is_finite() && self.high.is_finite()
    }
}

/// The bounds of a part over bounds of the inputs; `next` counts the parts.
pub(super) fn bounds(node: &Node, inputs: &[Interval], next: &mut usize) -> Result<Interval, Hole> {
    let index = *next;
    *next += 1;
    let hole = |why: &'static str| Hole { index, why };
    let found = match node {
        Node::Number(x) => Interval::point(*x),
        Node::Constant(constant) => Interval::point(constant.value),
        Node::Input(input) => {
            inputs.get(*input).copied().ok_or(hole(text!("there is no such input")))?
        }
        Node::Unary(function, operand) => {
            of_function(*function, bounds(operand, inputs, next)?).map_err(hole)?
        }
        Node::Binary(operator, pair) => {
            let a = bounds(&pair[0], inputs, next)?;
            let b = bounds(&pair[1], inputs, next)?;
            of_operator(*operator, a, b).map_err(hole)?
        }
    };
    if found.is_finite() { Ok(found) } else { Err(hole(text!("it may be too large for a number"))) }
}

fn of_function(function: Function, x: Interval) -> Result<Interval, &'static str> {
    let ends = [function.at(x.low), function.at(x.high)];
    match function {
        Function::Negative => Ok(Interval::new(-x.high, -x.low)),
        Function::Ln if x.low <= 0.0 => Err(text!("the logarithm of 0 or a negative number")),
        Function::Sqrt if x.low < 0.0 => Err(text!("the root of a negative number")),
        Function::Sqrt => Ok(Interval::hull(ends)),
        Function::Exp => Ok(nonnegative(Interval::hull(ends).outward_by(FUNCTION_ERROR))),
        Function::Ln | Function::Tanh => Ok(Interval::hull(ends).outward_by(FUNCTION_ERROR)),
        Function::Sin => Ok(wave(x, ends, 0.25)),
        Function::Cos => Ok(wave(x, ends, 0.0)),
    }
}

fn nonnegative(x: Interval) -> Interval {
    Interval { low: math::positive(x.low), ..x }
}

/// Sine or cosine, whose crests lie `crest` and whole numbers of turns from 0.
fn wave(x: Interval, ends: [f64; 2], crest: f64) -> Interval {
    // A crest too many makes the bounds wider, one too few would make them wrong.
    let has = |at: f64| {
        let [low, high] = [x.low / math::TAU - at, x.high / math::TAU - at];
        let slack = 1e-12 * (1.0 + low.abs().max(high.abs()));
        (high + slack).floor() >= (low - slack).ceil()
    };
    let own = Interval::hull(ends).outward_by(FUNCTION_ERROR);
    let slack = 1e-15;
    Interval {
        low: if has(crest + 0.5) { -1.0 } else { (own.low - slack).max(-1.0) },
        high: if has(crest) { 1.0 } else { (own.high + slack).min(1.0) },
    }
}

fn of_operator(operator: Operator, a: Interval, b: Interval) -> Result<Interval, &'static str> {
    let corners = [(a.low, b.low), (a.low, b.high), (a.high, b.low), (a.high, b.high)];
    let all = || Interval::hull(corners.map(|(x, y)| operator.at(x, y)));
    match operator {
        Operator::Add | Operator::Subtract | Operator::Multiply => Ok(all()),
        Operator::Divide if b.contains(0.0) => Err(text!("a division by 0")),
        Operator::Divide => Ok(all()),
        Operator::Power => of_power(a, b),
    }
}

/// By [`math::power`]: products for fixed whole and half exponents, exp(y ln x) otherwise.
fn of_power(base: Interval, exponent: Interval) -> Result<Interval, &'static str> {
    // Where a range of exponents meets one that is multiplied out: at most 2 x 6 products.
    const PRODUCTS: f64 = 32.0 * f64::EPSILON;
    let y = exponent.low;
    let fixed = y == exponent.high;
    let whole = fixed && y.fract() == 0.0 && y.abs() <= math::MAX_WHOLE;
    if y <= 0.0 && base.contains(0.0) && !(fixed && y == 0.0) {
        return Err(text!("0 to a power that is not positive"));
    }
    if base.low < 0.0 && !whole {
        return Err(text!("a negative number to a power that is not whole"));
    }
    let exponents = [exponent.low, exponent.high];
    let corners =
        [base.low, base.high].into_iter().flat_map(|x| exponents.map(|y| math::power(x, y)));
    let mut found = Interval::hull(corners);
    if whole {
        let even = y.rem_euclid(2.0) == 0.0;
        if even && y > 0.0 && base.contains(0.0) {
            found.low = 0.0;
        }
        return Ok(found);
    }
    if fixed && y.fract().abs() == 0.5 && y.abs() <= math::MAX_HALF {
        return Ok(found);
    }
    // The exponent's error is relative to itself, and so grows with its magnitude.
    let exponent = [found.low, found.high].map(|x| if x > 0.0 { math::ln(x).abs() } else { 0.0 });
    let error = FUNCTION_ERROR * (16.0 + exponent[0].max(exponent[1]));
    Ok(nonnegative(found.outward_by(error + PRODUCTS)))
}
