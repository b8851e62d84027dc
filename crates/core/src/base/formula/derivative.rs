//! The derivative of a formula by an input.

use super::{Function, Node, Operator};

const ONE: Node = Node::Number(1.0);
const TWO: Node = Node::Number(2.0);

/// Whether a node reads an input.
fn reads(node: &Node, input: usize) -> bool {
    *node == Node::Input(input) || node.operands().iter().any(|operand| reads(operand, input))
}

fn product(left: Node, right: Node) -> Node {
    match (left.number(), right.number()) {
        (Some(1.0), _) => right,
        (_, Some(1.0)) => left,
        (_, _) => Node::binary(Operator::Multiply, left, right),
    }
}

fn quotient(left: Node, right: Node) -> Node {
    Node::binary(Operator::Divide, left, right)
}

/// The derivative of `node`; not simplified, but without terms of parts that do not read the input.
pub(super) fn derivative(node: &Node, input: usize) -> Node {
    if !reads(node, input) {
        return Node::Number(0.0);
    }
    match node {
        Node::Number(_) | Node::Constant(_) => Node::Number(0.0),
        Node::Input(_) => ONE,
        Node::Unary(function, operand) => {
            let inner = derivative(operand, input);
            of_function(*function, node, operand, inner)
        }
        Node::Binary(operator, pair) => of_operator(*operator, node, pair, input),
    }
}

fn of_function(function: Function, node: &Node, operand: &Node, inner: Node) -> Node {
    let operand = || operand.clone();
    match function {
        Function::Negative => Node::unary(Function::Negative, inner),
        Function::Ln => quotient(inner, operand()),
        Function::Exp => product(inner, node.clone()),
        Function::Sqrt => quotient(inner, product(TWO, node.clone())),
        Function::Sin => product(inner, Node::unary(Function::Cos, operand())),
        Function::Cos => {
            let sine = Node::unary(Function::Sin, operand());
            Node::unary(Function::Negative, product(inner, sine))
        }
        Function::Tanh => {
            let square = Node::binary(Operator::Power, node.clone(), TWO);
            product(inner, Node::binary(Operator::Subtract, ONE, square))
        }
    }
}

fn of_operator(operator: Operator, node: &Node, pair: &[Node; 2], input: usize) -> Node {
    let [a, b] = pair;
    let by = |part: &Node| derivative(part, input);
    match (operator, reads(a, input), reads(b, input)) {
        (Operator::Add, true, true) => Node::binary(Operator::Add, by(a), by(b)),
        (Operator::Subtract, true, true) => Node::binary(Operator::Subtract, by(a), by(b)),
        (Operator::Add | Operator::Subtract, _, false) => by(a),
        (Operator::Add, false, true) => by(b),
        (Operator::Subtract, false, true) => Node::unary(Function::Negative, by(b)),
        (Operator::Multiply, true, true) => {
            let (left, right) = (product(by(a), b.clone()), product(a.clone(), by(b)));
            Node::binary(Operator::Add, left, right)
        }
        (Operator::Multiply, true, false) => product(by(a), b.clone()),
        (Operator::Multiply, false, _) => product(a.clone(), by(b)),
        (Operator::Divide, _, false) => quotient(by(a), b.clone()),
        (Operator::Divide, on_left, true) => {
            let square = Node::binary(Operator::Power, b.clone(), TWO);
            let second = quotient(product(a.clone(), by(b)), square);
            if on_left {
                Node::binary(Operator::Subtract, quotient(by(a), b.clone()), second)
            } else {
                Node::unary(Function::Negative, second)
            }
        }
        (Operator::Power, _, false) => {
            let less = match b.number() {
                Some(exponent) => Node::Number(exponent - 1.0),
                None => Node::binary(Operator::Subtract, b.clone(), ONE),
            };
            let power = Node::binary(Operator::Power, a.clone(), less);
            product(product(b.clone(), power), by(a))
        }
        (Operator::Power, false, true) => {
            product(product(node.clone(), Node::unary(Function::Ln, a.clone())), by(b))
        }
        (Operator::Power, true, true) => {
            let of_exponent = product(by(b), Node::unary(Function::Ln, a.clone()));
            let of_base = quotient(product(b.clone(), by(a)), a.clone());
            product(node.clone(), Node::binary(Operator::Add, of_exponent, of_base))
        }
    }
}
