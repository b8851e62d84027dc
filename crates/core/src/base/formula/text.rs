//! A formula as text that reads back to the same formula.

use std::ops::Range;

use super::{Formula, Function, Node, Operator};

/// How tightly the outermost operation of a text binds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Binding {
    Sum,
    Product,
    Sign,
    Power,
    Leaf,
}

/// The text of a number: the shortest that reads back to the same bits.
pub(super) fn number(x: f64) -> String {
    let magnitude = x.abs();
    if magnitude == 0.0 || (1e-4..1e15).contains(&magnitude) {
        format!("{x}")
    } else {
        format!("{x:e}")
    }
}

/// A name, quoted where it is not letters, digits and underscores.
pub(super) fn name(text: &str) -> String {
    let mut letters = text.chars();
    let plain = letters.next().is_some_and(|c| c.is_alphabetic() || c == '_')
        && letters.all(|c| c.is_alphanumeric() || c == '_')
        && Function::ALL.iter().all(|function| function.name() != text);
    if plain { text.to_owned() } else { format!("\"{text}\"") }
}

/// The text, and where in it (in bytes) every node stands, in the order of their first parts: a node before
/// its operands, left before right.
pub(super) fn print(formula: &Formula) -> (String, Vec<Range<usize>>) {
    let mut printer = Printer { inputs: formula.inputs(), text: String::new(), spans: Vec::new() };
    printer.node(formula.root());
    (printer.text, printer.spans)
}

struct Printer<'a> {
    inputs: &'a [String],
    text: String,
    spans: Vec<Range<usize>>,
}

/// How tightly the text of a node binds.
pub(super) fn binding(node: &Node) -> Binding {
    match node {
        Node::Number(x) if x.is_sign_negative() => Binding::Sign,
        Node::Number(_) | Node::Input(_) | Node::Constant(_) => Binding::Leaf,
        Node::Unary(Function::Negative, _) => Binding::Sign,
        Node::Unary(..) => Binding::Leaf,
        Node::Binary(Operator::Add | Operator::Subtract, _) => Binding::Sum,
        Node::Binary(Operator::Multiply | Operator::Divide, _) => Binding::Product,
        Node::Binary(Operator::Power, _) => Binding::Power,
    }
}

impl Printer<'_> {
    /// Writes a node; its place goes to the spans.
    fn node(&mut self, node: &Node) {
        let (index, start) = (self.spans.len(), self.text.len());
        self.spans.push(start..start);
        match node {
            Node::Number(x) => self.text += &number(*x),
            Node::Input(input) => {
                let named = self.inputs.get(*input).map_or("?", |input| input);
                self.text += &name(named);
            }
            Node::Constant(constant) => self.text += &name(&constant.name),
            Node::Unary(Function::Negative, operand) => {
                self.text.push('-');
                self.operand(operand, Some(Binding::Sign));
            }
            Node::Unary(function, operand) => {
                self.text += function.name();
                self.operand(operand, None);
            }
            Node::Binary(operator, pair) => {
                let (left, right) = match operator {
                    Operator::Add | Operator::Subtract => (Binding::Sum, Binding::Product),
                    Operator::Multiply | Operator::Divide => (Binding::Product, Binding::Sign),
                    Operator::Power => (Binding::Leaf, Binding::Sign),
                };
                self.operand(&pair[0], Some(left));
                match operator {
                    Operator::Power => self.text.push('^'),
                    Operator::Add | Operator::Subtract | Operator::Multiply | Operator::Divide => {
                        self.text += &format!(" {} ", operator.sign());
                    }
                }
                self.operand(&pair[1], Some(right));
            }
        }
        self.spans[index].end = self.text.len();
    }

    /// An operand, in parentheses where it binds less than asked for, or always for `None`.
    fn operand(&mut self, node: &Node, least: Option<Binding>) {
        if least.is_some_and(|least| binding(node) >= least) {
            self.node(node);
        } else {
            self.text.push('(');
            self.node(node);
            self.text.push(')');
        }
    }
}
