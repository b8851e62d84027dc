//! A formula as a function in a programming language, and in a spreadsheet.

use crate::base::formula::text::{self, Binding};
use crate::base::formula::{Formula, Function, Node, Operator};

/// Words that are no names in one of the languages, or that stand in what is written beside the formula.
const RESERVED: &str = "as async await break case char const continue crate default def del do double elif \
    else enum exp except extern f32 f64 false False float fn for from global goto if impl import in inline int \
    is lambda let ln loop long match math mod move mut None nonlocal not or and pass power pub raise ref \
    register restrict return self Self short signed sizeof static struct super switch trait true True try type \
    typedef union unsafe unsigned use void volatile where while whole_power with yield sqrt sin cos tanh main \
    formula_power formula_ln formula_exp formula_whole_power auto class assert finally INFINITY NAN memcpy \
    ldexp fabs floor abs dyn box macro override priv typeof unsized virtual become abstract final gen static";

/// How a language writes the parts of a formula.
struct Style {
    number: fn(f64) -> String,
    function: fn(Function) -> &'static str,
    /// The function for a power; none for the sign `^`.
    power: Option<&'static str>,
    /// What stands on both sides of an operator.
    space: &'static str,
    names: Vec<String>,
}

pub(super) fn rust(formula: &Formula, name: &str) -> String {
    let names = identifiers(formula.inputs());
    let parameters: Vec<String> = names.iter().map(|name| format!("{name}: f64")).collect();
    let function = |function| match function {
        Function::Negative => "-",
        Function::Ln => "ln",
        Function::Exp => "exp",
        Function::Sqrt => "f64::sqrt",
        Function::Sin => "f64::sin",
        Function::Cos => "f64::cos",
        Function::Tanh => "f64::tanh",
    };
    let style = Style { number: with_point, function, power: Some("power"), space: " ", names };
    let body = style.node(formula.root());
    let support = if needs_powers(formula.root()) { include_str!("powers.rs.in") } else { "" };
    format!(
        "{}#[allow(unused_variables, unused_parens)]\npub fn {}({}) -> f64 {{\n    {body}\n}}\n{}{support}",
        comment(formula, "// "),
        identifier(name),
        parameters.join(", "),
        if support.is_empty() { "" } else { "\n" },
    )
}

pub(super) fn c(formula: &Formula, name: &str) -> String {
    let names = identifiers(formula.inputs());
    let parameters: Vec<String> = names.iter().map(|name| format!("double {name}")).collect();
    let parameters = if parameters.is_empty() { "void".to_owned() } else { parameters.join(", ") };
    let function = |function| match function {
        Function::Negative => "-",
        Function::Ln => "formula_ln",
        Function::Exp => "formula_exp",
        Function::Sqrt => "sqrt",
        Function::Sin => "sin",
        Function::Cos => "cos",
        Function::Tanh => "tanh",
    };
    let style =
        Style { number: with_point, function, power: Some("formula_power"), space: " ", names };
    let body = style.node(formula.root());
    let support = if needs_powers(formula.root()) { include_str!("powers.c.in") } else { "" };
    let includes = if support.is_empty() {
        "#include <math.h>\n"
    } else {
        "#include <math.h>\n#include <stdint.h>\n#include <string.h>\n"
    };
    format!(
        "{includes}\n{support}{}{}double {}({parameters}) {{\n    return {body};\n}}\n",
        if support.is_empty() { "" } else { "\n" },
        comment(formula, "// "),
        identifier(name),
    )
}

pub(super) fn python(formula: &Formula, name: &str) -> String {
    let names = identifiers(formula.inputs());
    let parameters = names.join(", ");
    let function = |function| match function {
        Function::Negative => "-",
        Function::Ln => "math.log",
        Function::Exp => "math.exp",
        Function::Sqrt => "math.sqrt",
        Function::Sin => "math.sin",
        Function::Cos => "math.cos",
        Function::Tanh => "math.tanh",
    };
    let style = Style { number: with_point, function, power: Some("_power"), space: " ", names };
    let body = style.node(formula.root());
    let support = if has(formula.root(), &|node| matches!(node, Node::Binary(Operator::Power, _))) {
        format!("{}\n\n", include_str!("powers.py.in"))
    } else {
        String::new()
    };
    format!(
        "import math\n\n\n{support}{}def {}({parameters}):\n    return {body}\n",
        comment(formula, "# "),
        identifier(name),
    )
}

pub(super) fn spreadsheet(formula: &Formula) -> String {
    let names = (0..formula.inputs().len()).map(|index| format!("{}2", column(index))).collect();
    let function = |function| match function {
        Function::Negative => "-",
        Function::Ln => "LN",
        Function::Exp => "EXP",
        Function::Sqrt => "SQRT",
        Function::Sin => "SIN",
        Function::Cos => "COS",
        Function::Tanh => "TANH",
    };
    let number = |x| text::number(x).to_uppercase();
    let style = Style { number, function, power: None, space: "", names };
    format!("={}", style.node(formula.root()))
}

/// The letters of a column of a spreadsheet, from 0: A..Z, AA..
fn column(index: usize) -> String {
    let letter = char::from(b'A' + u8::try_from(index % 26).unwrap_or(0));
    if index < 26 { letter.to_string() } else { format!("{}{letter}", column(index / 26 - 1)) }
}

impl Style {
    fn node(&self, node: &Node) -> String {
        match node {
            Node::Number(x) => (self.number)(*x),
            Node::Constant(constant) => (self.number)(constant.value),
            Node::Input(index) => self.names.get(*index).cloned().unwrap_or_default(),
            // Two signs side by side would be another operator in C, a sign before a power another base in a
            // spreadsheet.
            Node::Unary(Function::Negative, operand) => {
                let least = if self.power.is_some() { Binding::Power } else { Binding::Leaf };
                format!("-{}", self.operand(operand, least))
            }
            Node::Unary(function, operand) => {
                format!("{}({})", (self.function)(*function), self.node(operand))
            }
            Node::Binary(operator, pair) => self.of_operator(*operator, pair),
        }
    }

    fn of_operator(&self, operator: Operator, [a, b]: &[Node; 2]) -> String {
        let (left, right) = match (operator, self.power) {
            (Operator::Power, Some(power)) => {
                return format!("{power}({}, {})", self.node(a), self.node(b));
            }
            (Operator::Power, None) => (Binding::Leaf, Binding::Leaf),
            (Operator::Add | Operator::Subtract, _) => (Binding::Sum, Binding::Product),
            (Operator::Multiply | Operator::Divide, _) => (Binding::Product, Binding::Sign),
        };
        let (sign, space) = (operator.sign(), self.space);
        format!("{}{space}{sign}{space}{}", self.operand(a, left), self.operand(b, right))
    }

    fn operand(&self, node: &Node, least: Binding) -> String {
        let text = self.node(node);
        if text::binding(node) >= least { text } else { format!("({text})") }
    }
}

/// A number that is no integer of the language.
fn with_point(x: f64) -> String {
    format!("{x:?}")
}

/// The formula and its inputs, behind a mark of comments.
fn comment(formula: &Formula, mark: &str) -> String {
    let text = text::print(formula).0.replace(['\n', '\r'], " ");
    // A backslash at the end would join the next line in C.
    format!("{mark}{}\n", text.trim_end_matches('\\'))
}

fn has(node: &Node, wanted: &dyn Fn(&Node) -> bool) -> bool {
    wanted(node) || node.operands().iter().any(|operand| has(operand, wanted))
}

fn needs_powers(node: &Node) -> bool {
    has(node, &|node| {
        matches!(
            node,
            Node::Binary(Operator::Power, _) | Node::Unary(Function::Ln | Function::Exp, _)
        )
    })
}

/// Letters, digits and underscores, no word of a language.
fn identifier(name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let name: String = name.chars().map(plain).collect();
    let starts = name.starts_with(|c: char| c.is_ascii_alphabetic());
    let name = if starts { name } else { format!("x_{name}") };
    if RESERVED.split_whitespace().any(|word| word == name) { format!("{name}_") } else { name }
}

/// Names of the inputs, no two the same.
fn identifiers(names: &[String]) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    for name in names {
        let name = identifier(name);
        let numbered = (2..).map(|n| format!("{name}_{n}"));
        let free = std::iter::once(name.clone()).chain(numbered).find(|name| !all.contains(name));
        all.push(free.unwrap_or(name));
    }
    all
}
