//! A formula as [`equation`](crate::base::equation) has it: plain text with `^{2}` raised, and other words in the
//! place of its inputs.

use crate::base::formula::text::{self, Binding};
use crate::base::formula::{Formula, Function, Node, Operator};
use crate::base::language::decimal;

impl Formula {
    /// The formula as an equation is shown, with `words` in the place of the inputs: symbols, or the values of a
    /// moment.
    #[must_use]
    pub fn equation(&self, words: &[&str]) -> String {
        node(self.root(), words)
    }
}

/// A small or large number is a product with a power of ten.
fn is_product(x: f64) -> bool {
    text::number(x).contains('e')
}

fn binding(part: &Node) -> Binding {
    match part {
        Node::Number(x) if *x >= 0.0 && is_product(*x) => Binding::Product,
        Node::Number(_)
        | Node::Input(_)
        | Node::Constant(_)
        | Node::Unary(..)
        | Node::Binary(..) => text::binding(part),
    }
}

fn operand(part: &Node, words: &[&str], least: Binding) -> String {
    let text = node(part, words);
    if binding(part) >= least { text } else { format!("({text})") }
}

fn number(x: f64) -> String {
    let text = text::number(x);
    decimal(match text.split_once('e') {
        Some((digits, exponent)) => format!("{digits}·10^{{{exponent}}}"),
        None => text,
    })
}

fn node(part: &Node, words: &[&str]) -> String {
    match part {
        Node::Number(x) => number(*x),
        Node::Input(index) => (*words.get(*index).unwrap_or(&"?")).to_owned(),
        Node::Constant(constant) => constant.name.clone(),
        Node::Unary(Function::Negative, inner) => {
            format!("-{}", operand(inner, words, Binding::Power))
        }
        Node::Unary(Function::Sqrt, inner) => format!("√({})", node(inner, words)),
        Node::Unary(function, inner) => format!("{}({})", function.name(), node(inner, words)),
        Node::Binary(Operator::Power, pair) => power(&pair[0], &pair[1], words),
        Node::Binary(operator, pair) => {
            let (left, right) = match operator {
                Operator::Add | Operator::Subtract => (Binding::Sum, Binding::Product),
                Operator::Multiply | Operator::Divide | Operator::Power => {
                    (Binding::Product, Binding::Power)
                }
            };
            let sign = match operator {
                Operator::Multiply => '·',
                Operator::Add | Operator::Subtract | Operator::Divide | Operator::Power => {
                    operator.sign()
                }
            };
            let [a, b] = &**pair;
            format!("{} {sign} {}", operand(a, words, left), operand(b, words, right))
        }
    }
}

/// Raised text has one level: an exponent that is no number or symbol is not raised.
fn power(base: &Node, exponent: &Node, words: &[&str]) -> String {
    let simple = match exponent {
        Node::Number(x) => !is_product(*x),
        Node::Input(_) | Node::Constant(_) => true,
        Node::Unary(..) | Node::Binary(..) => false,
    };
    let shown = node(exponent, words);
    if !simple {
        return format!("pow({}, {shown})", node(base, words));
    }
    let base = operand(base, words, Binding::Leaf);
    if shown.chars().count() == 1 {
        format!("{base}^{shown}")
    } else {
        format!("{base}^{{{shown}}}")
    }
}
