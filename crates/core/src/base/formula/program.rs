//! The form of a formula that a loop evaluates: operations on a small stack, in an order in which the stack
//! stays small, so that nothing is allocated.

use super::{Function, Node, Operator};
use crate::base::math;

/// Places of the stack. Of two operands the one that needs more places goes first, so that n places serve
/// every formula of fewer than 2^n leaves.
const STACK: usize = 12;

const _: () = assert!(super::MAX_SIZE < 1 << STACK);

#[derive(Clone, Copy, Debug, PartialEq)]
enum Step {
    /// Puts a number on the stack.
    Number(f64),
    /// Puts an input on the stack.
    Input(usize),
    /// Replaces the top.
    Unary(Function),
    /// Replaces the two on top, the right operand above.
    Binary(Operator),
    /// The same with the left operand above.
    Swapped(Operator),
    /// The top with a number to the right of it.
    WithNumber(Operator, f64),
    /// The top with an input to the right of it.
    WithInput(Operator, usize),
    /// A number to the left of the top.
    NumberWith(f64, Operator),
    /// The top to a power that is a product.
    Whole(u32),
}

/// A formula ready for a loop; see [`Formula::compile`](super::Formula::compile).
#[derive(Clone, Debug, PartialEq)]
pub struct CompiledFormula {
    steps: Vec<Step>,
    inputs: usize,
}

impl CompiledFormula {
    pub(super) fn new(root: &Node, inputs: usize) -> Self {
        let mut steps = Vec::new();
        compile(root, &mut steps);
        Self { steps, inputs }
    }

    /// The number of inputs.
    #[must_use]
    pub fn inputs(&self) -> usize {
        self.inputs
    }

    /// The value at `inputs`, the same bits as [`Formula::value`](super::Formula::value); NaN where there are
    /// fewer inputs than the formula has.
    #[must_use]
    #[inline]
    pub fn value(&self, inputs: &[f64]) -> f64 {
        if inputs.len() < self.inputs {
            return f64::NAN;
        }
        let mut stack = [0.0; STACK];
        // The top of the stack is kept apart.
        let (mut top, mut count) = (0.0, 0);
        for step in &self.steps {
            match *step {
                Step::Number(x) => {
                    stack[count % STACK] = top;
                    count += 1;
                    top = x;
                }
                Step::Input(index) => {
                    stack[count % STACK] = top;
                    count += 1;
                    top = inputs[index];
                }
                Step::Unary(function) => top = function.at(top),
                Step::Binary(operator) => {
                    count -= 1;
                    top = operator.at(stack[count % STACK], top);
                }
                Step::Swapped(operator) => {
                    count -= 1;
                    top = operator.at(top, stack[count % STACK]);
                }
                Step::WithNumber(operator, x) => top = operator.at(top, x),
                Step::WithInput(operator, index) => top = operator.at(top, inputs[index]),
                Step::NumberWith(x, operator) => top = operator.at(x, top),
                Step::Whole(exponent) => top = math::whole_power(top, exponent),
            }
        }
        top
    }
}

/// A number that stands in the formula, as a literal or by its name.
fn fixed(node: &Node) -> Option<f64> {
    match node {
        Node::Number(x) => Some(*x),
        Node::Constant(constant) => Some(constant.value),
        Node::Input(_) | Node::Unary(..) | Node::Binary(..) => None,
    }
}

/// Appends the steps of a node; returns how many places they need.
fn compile(node: &Node, steps: &mut Vec<Step>) -> usize {
    match node {
        Node::Number(x) => push(steps, Step::Number(*x)),
        Node::Constant(constant) => push(steps, Step::Number(constant.value)),
        Node::Input(index) => push(steps, Step::Input(*index)),
        Node::Unary(function, operand) => {
            let places = compile(operand, steps);
            steps.push(Step::Unary(*function));
            places
        }
        Node::Binary(operator, pair) => binary(*operator, &pair[0], &pair[1], steps),
    }
}

fn push(steps: &mut Vec<Step>, step: Step) -> usize {
    steps.push(step);
    1
}

fn binary(operator: Operator, left: &Node, right: &Node, steps: &mut Vec<Step>) -> usize {
    if let Some(x) = fixed(right) {
        let places = compile(left, steps);
        let product =
            operator == Operator::Power && (1.0..=math::MAX_WHOLE).contains(&x) && x.fract() == 0.0;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1..=64")]
        steps.push(if product { Step::Whole(x as u32) } else { Step::WithNumber(operator, x) });
        return places;
    }
    if let Node::Input(index) = right {
        let places = compile(left, steps);
        steps.push(Step::WithInput(operator, *index));
        return places;
    }
    if let Some(x) = fixed(left) {
        let places = compile(right, steps);
        steps.push(Step::NumberWith(x, operator));
        return places;
    }
    let start = steps.len();
    let on_left = compile(left, steps);
    let middle = steps.len();
    let on_right = compile(right, steps);
    if on_left >= on_right {
        steps.push(Step::Binary(operator));
    } else {
        steps[start..].rotate_left(middle - start);
        steps.push(Step::Swapped(operator));
    }
    if on_left == on_right { on_left + 1 } else { on_left.max(on_right) }
}
