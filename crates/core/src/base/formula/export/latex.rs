//! A formula in LaTeX.

use crate::base::formula::text::{self, Binding};
use crate::base::formula::{Formula, Function, Node, Operator};

pub(super) fn latex(formula: &Formula) -> String {
    node(formula.root(), formula.inputs())
}

/// How tightly the LaTeX of a node binds: a fraction and a root are one thing, a power of ten is a product.
fn binding(part: &Node) -> Binding {
    match part {
        Node::Number(x) if *x >= 0.0 && text::number(*x).contains('e') => Binding::Product,
        Node::Binary(Operator::Divide, _) => Binding::Power,
        Node::Number(_)
        | Node::Input(_)
        | Node::Constant(_)
        | Node::Unary(..)
        | Node::Binary(..) => text::binding(part),
    }
}

fn operand(part: &Node, inputs: &[String], least: Binding) -> String {
    let text = node(part, inputs);
    if binding(part) >= least { text } else { format!(r"\left({text}\right)") }
}

fn node(part: &Node, inputs: &[String]) -> String {
    match part {
        Node::Number(x) => number(*x),
        Node::Input(index) => name(inputs.get(*index).map_or("?", |name| name)),
        Node::Constant(constant) if constant.name == "pi" => r"\pi".to_owned(),
        Node::Constant(constant) if constant.name == "e" => r"\mathrm{e}".to_owned(),
        Node::Constant(constant) => name(&constant.name),
        Node::Unary(Function::Negative, inner) => {
            format!("-{}", operand(inner, inputs, Binding::Power))
        }
        Node::Unary(Function::Sqrt, inner) => format!(r"\sqrt{{{}}}", node(inner, inputs)),
        Node::Unary(function, inner) => {
            format!(r"\{}\left({}\right)", function.name(), node(inner, inputs))
        }
        Node::Binary(operator, pair) => of_operator(*operator, pair, inputs),
    }
}

fn of_operator(operator: Operator, [a, b]: &[Node; 2], inputs: &[String]) -> String {
    let side = |part: &Node, least: Binding| operand(part, inputs, least);
    match operator {
        Operator::Add => format!("{} + {}", side(a, Binding::Sum), side(b, Binding::Product)),
        Operator::Subtract => format!("{} - {}", side(a, Binding::Sum), side(b, Binding::Product)),
        Operator::Multiply => {
            let (left, right) = (side(a, Binding::Product), side(b, Binding::Power));
            // Two numbers side by side would read as one.
            let sign =
                if right.starts_with(|c: char| c.is_ascii_digit()) { r" \cdot " } else { r"\, " };
            format!("{left}{sign}{right}")
        }
        Operator::Divide => format!(r"\frac{{{}}}{{{}}}", node(a, inputs), node(b, inputs)),
        Operator::Power => {
            let base = match a {
                // A fraction with an exponent reads as one of its numerator.
                Node::Binary(Operator::Divide, _) => format!(r"\left({}\right)", node(a, inputs)),
                Node::Number(_)
                | Node::Input(_)
                | Node::Constant(_)
                | Node::Unary(..)
                | Node::Binary(..) => side(a, Binding::Leaf),
            };
            format!("{base}^{{{}}}", node(b, inputs))
        }
    }
}

fn number(x: f64) -> String {
    let text = text::number(x);
    match text.split_once('e') {
        Some((digits, exponent)) => format!(r"{digits} \cdot 10^{{{exponent}}}"),
        None => text,
    }
}

/// A letter stays one; what follows its underscore is a subscript; words are set upright.
fn name(text: &str) -> String {
    let escape = |text: &str| {
        let mut escaped = String::new();
        for c in text.chars() {
            match c {
                '_' | '%' | '#' | '&' | '$' | '{' | '}' => escaped.extend(['\\', c]),
                ' ' => escaped.push('~'),
                '\\' => escaped += r"\backslash ",
                '^' => escaped += r"\hat{}",
                '~' => escaped += r"\sim ",
                other => escaped.push(other),
            }
        }
        escaped
    };
    if text.chars().count() == 1 && text.starts_with(char::is_alphabetic) {
        return text.to_owned();
    }
    match text.split_once('_') {
        Some((letter, rest)) if letter.chars().count() == 1 && !rest.is_empty() => {
            format!(r"{letter}_{{\mathrm{{{}}}}}", escape(rest))
        }
        Some(_) | None => format!(r"\mathrm{{{}}}", escape(text)),
    }
}
