//! Reading a formula. What is wrong is told with its place, what stands there and what was expected.
//!
//! ```text
//! sum     = product { ("+" | "-") product }
//! product = signed { ("*" | "/") signed }
//! signed  = "-" signed | power
//! power   = leaf [ "^" signed ]
//! leaf    = number | name | "quoted name" | function "(" sum ")" | "(" sum ")"
//! ```

use std::ops::Range;

use super::{Formula, FormulaError, Function, MAX_DEPTH, MAX_SIZE, NamedConstant, Node, Operator};
use crate::base::language::tr;
use crate::base::math;
use crate::base::text::nearest;

/// Longest text that is read, bytes.
const MAX_TEXT: usize = 100_000;
#[derive(Clone, Debug, PartialEq)]
enum Token {
    Number(f64),
    Name(String),
    Sign(char),
    End,
}

/// Reads a formula; with it where in the text every node stands, in the order of
/// [`text::print`](super::text::print).
pub(super) fn parse(
    text: &str,
    inputs: &[impl AsRef<str>],
    constants: &[NamedConstant],
) -> Result<(Formula, Vec<Range<usize>>), FormulaError> {
    if text.len() > MAX_TEXT {
        let problem =
            tr!("the formula has {n} bytes: allowed are {most}", n = text.len(), most = MAX_TEXT);
        return Err(FormulaError::new(text, 0..0, problem));
    }
    super::check_names(inputs)
        .map_err(|problem| FormulaError::new(text, 0..text.len(), problem))?;
    let inputs: Vec<&str> = inputs.iter().map(AsRef::as_ref).collect();
    let mut parser =
        Parser { text, inputs: &inputs, constants, at: 0..0, token: Token::End, nodes: 0 };
    parser.advance()?;
    let read = parser.sum(0)?;
    if parser.token != Token::End {
        return Err(parser.expected(&Expected::OperatorOrEnd));
    }
    let mut spans = Vec::new();
    let root = read.place(&mut spans);
    let formula = Formula::new(root, &inputs)
        .map_err(|problem| FormulaError::new(text, 0..text.len(), problem))?;
    Ok((formula, spans))
}

/// The names in a text that are neither functions nor known constants.
pub(super) fn names(text: &str) -> Result<Vec<String>, FormulaError> {
    let mut parser =
        Parser { text, inputs: &[], constants: &[], at: 0..0, token: Token::End, nodes: 0 };
    let mut names = Vec::new();
    loop {
        parser.advance()?;
        let quoted = text[parser.at.clone()].starts_with('"');
        match &parser.token {
            Token::End => return Ok(names),
            Token::Name(name) => {
                let function = Function::ALL.iter().any(|function| function.name() == name);
                // A name before a parenthesis is meant as a function, and is told as an unknown one.
                let called = text[parser.at.end..].trim_start().starts_with('(');
                let taken = (function || called) && !quoted;
                if !taken && known(name).is_none() && !names.contains(name) {
                    names.push(name.clone());
                }
            }
            Token::Number(_) | Token::Sign(_) => {}
        }
    }
}

/// What a formula goes on with.
enum Expected<'a> {
    OperatorOrEnd,
    Operand,
    OperatorOrClose,
    /// The parenthesis behind a function.
    Open(&'a str),
}

impl Expected<'_> {
    fn words(&self) -> String {
        match self {
            Self::OperatorOrEnd => tr("expected an operator (+ - * / ^) or the end").to_owned(),
            Self::Operand => tr("expected a number, a name, a function or `(`").to_owned(),
            Self::OperatorOrClose => tr("expected `)` or an operator (+ - * / ^)").to_owned(),
            Self::Open(name) => {
                tr!("expected `(` behind the function `{name}`", name = *name)
            }
        }
    }

    fn is_operator(&self) -> bool {
        match self {
            Self::OperatorOrEnd | Self::OperatorOrClose => true,
            Self::Operand | Self::Open(_) => false,
        }
    }
}

/// A node with the places of its parts.
struct Read {
    node: Node,
    /// Levels of the node.
    depth: usize,
    /// Of the node, then of its operands' nodes.
    spans: Vec<Range<usize>>,
}

impl Read {
    fn leaf(node: Node, at: Range<usize>) -> Self {
        Self { node, depth: 1, spans: vec![at] }
    }

    fn place(self, spans: &mut Vec<Range<usize>>) -> Node {
        spans.extend(self.spans);
        self.node
    }
}

struct Parser<'a> {
    text: &'a str,
    inputs: &'a [&'a str],
    constants: &'a [NamedConstant],
    /// Where the token stands.
    at: Range<usize>,
    token: Token,
    nodes: usize,
}

impl Parser<'_> {
    fn fault(&self, at: Range<usize>, problem: impl Into<String>) -> FormulaError {
        FormulaError::new(self.text, at, problem.into())
    }

    fn expected(&self, what: &Expected<'_>) -> FormulaError {
        let expected = what.words();
        let problem = match &self.token {
            Token::End => tr!("{expected}, but the formula ends here", expected = expected),
            Token::Number(_) | Token::Name(_) | Token::Sign(_) => tr!(
                "{expected}, but found `{found}`",
                expected = expected,
                found = &self.text[self.at.clone()]
            ),
        };
        let hint = match &self.token {
            Token::Sign(',') => Some(tr("a number has a decimal point, not a comma")),
            Token::Number(_) | Token::Name(_) | Token::Sign('(') if what.is_operator() => {
                Some(tr("a product needs its `*`"))
            }
            Token::Number(_) | Token::Name(_) | Token::Sign(_) | Token::End => None,
        };
        let problem = match hint {
            Some(hint) => format!("{problem}; {hint}"),
            None => problem,
        };
        self.fault(self.at.clone(), problem)
    }

    /// Reads the next token.
    fn advance(&mut self) -> Result<(), FormulaError> {
        let rest = &self.text[self.at.end..];
        let start = self.at.end + (rest.len() - rest.trim_start().len());
        let rest = &self.text[start..];
        let Some(first) = rest.chars().next() else {
            (self.at, self.token) = (start..start, Token::End);
            return Ok(());
        };
        let length =
            |inside: &dyn Fn(char) -> bool| rest.find(|c: char| !inside(c)).unwrap_or(rest.len());
        let (token, length) = if first.is_ascii_digit() || first == '.' {
            self.read_number(start)?
        } else if first.is_alphabetic() || first == '_' {
            let length = length(&|c| c.is_alphanumeric() || c == '_');
            (Token::Name(rest[..length].to_owned()), length)
        } else if first == '"' {
            let Some(end) = rest[1..].find('"') else {
                return Err(self.fault(start..self.text.len(), tr("a quoted name without its end")));
            };
            (Token::Name(rest[1..=end].to_owned()), end + 2)
        } else if "+-*/^(),".contains(first) {
            (Token::Sign(first), 1)
        } else {
            let at = start..start + first.len_utf8();
            let problem = tr!(
                "`{sign}` has no meaning in a formula: allowed are + - * / ^ ( )",
                sign = first
            );
            return Err(self.fault(at, problem));
        };
        (self.at, self.token) = (start..start + length, token);
        Ok(())
    }

    fn read_number(&self, start: usize) -> Result<(Token, usize), FormulaError> {
        let bytes = &self.text.as_bytes()[start..];
        let digits = |from: usize| bytes[from..].iter().take_while(|b| b.is_ascii_digit()).count();
        let mut length = digits(0);
        if bytes.get(length) == Some(&b'.') {
            length += 1 + digits(length + 1);
        }
        if matches!(bytes.get(length), Some(b'e' | b'E')) {
            let signed = matches!(bytes.get(length + 1), Some(b'+' | b'-'));
            let from = length + 1 + usize::from(signed);
            let exponent = if from <= bytes.len() { digits(from) } else { 0 };
            if exponent > 0 {
                length = from + exponent;
            }
        }
        let text = &self.text[start..start + length];
        match text.parse::<f64>() {
            Ok(x) if x.is_finite() => Ok((Token::Number(x), length)),
            Ok(_) => Err(self.fault(start..start + length, tr("the number is too large"))),
            Err(_) => Err(self.fault(start..start + length, tr("this is no number"))),
        }
    }

    fn count(&mut self, at: &Range<usize>, depth: usize) -> Result<(), FormulaError> {
        self.nodes += 1;
        if self.nodes > MAX_SIZE {
            let problem = tr!("the formula has more than {n} nodes", n = MAX_SIZE);
            return Err(self.fault(at.clone(), problem));
        }
        self.deep(at, depth)
    }

    fn deep(&self, at: &Range<usize>, depth: usize) -> Result<(), FormulaError> {
        if depth < MAX_DEPTH {
            return Ok(());
        }
        let problem = tr!("the formula is nested more than {n} deep", n = MAX_DEPTH);
        Err(self.fault(at.clone(), problem))
    }

    fn join(&mut self, operator: Operator, left: Read, right: Read) -> Result<Read, FormulaError> {
        let at = left.spans[0].start..right.spans[0].end;
        let depth = left.depth.max(right.depth);
        self.count(&at, depth)?;
        let mut spans = vec![at];
        let left = left.place(&mut spans);
        let right = right.place(&mut spans);
        Ok(Read { node: Node::binary(operator, left, right), depth: depth + 1, spans })
    }

    fn sum(&mut self, depth: usize) -> Result<Read, FormulaError> {
        let mut left = self.product(depth)?;
        loop {
            let operator = match self.token {
                Token::Sign('+') => Operator::Add,
                Token::Sign('-') => Operator::Subtract,
                Token::Sign(_) | Token::Number(_) | Token::Name(_) | Token::End => return Ok(left),
            };
            self.advance()?;
            let right = self.product(depth)?;
            left = self.join(operator, left, right)?;
        }
    }

    fn product(&mut self, depth: usize) -> Result<Read, FormulaError> {
        let mut left = self.signed(depth)?;
        loop {
            let operator = match self.token {
                Token::Sign('*') => Operator::Multiply,
                Token::Sign('/') => Operator::Divide,
                Token::Sign(_) | Token::Number(_) | Token::Name(_) | Token::End => return Ok(left),
            };
            self.advance()?;
            let right = self.signed(depth)?;
            left = self.join(operator, left, right)?;
        }
    }

    fn signed(&mut self, depth: usize) -> Result<Read, FormulaError> {
        if self.token != Token::Sign('-') {
            return self.power(depth);
        }
        let start = self.at.start;
        self.count(&self.at.clone(), depth)?;
        self.advance()?;
        let operand = self.signed(depth + 1)?;
        let at = start..operand.spans[0].end;
        if operand.node.number().is_some() {
            return Ok(Read::leaf(Node::unary(Function::Negative, operand.node), at));
        }
        let mut spans = vec![at];
        let depth = operand.depth + 1;
        let operand = operand.place(&mut spans);
        Ok(Read { node: Node::unary(Function::Negative, operand), depth, spans })
    }

    fn power(&mut self, depth: usize) -> Result<Read, FormulaError> {
        let base = self.leaf(depth)?;
        if self.token != Token::Sign('^') {
            return Ok(base);
        }
        self.advance()?;
        let exponent = self.signed(depth + 1)?;
        self.join(Operator::Power, base, exponent)
    }

    fn leaf(&mut self, depth: usize) -> Result<Read, FormulaError> {
        let at = self.at.clone();
        self.count(&at, depth)?;
        match self.token.clone() {
            Token::Number(x) => {
                self.advance()?;
                Ok(Read::leaf(Node::Number(x), at))
            }
            Token::Name(name) => {
                let quoted = self.text[at.clone()].starts_with('"');
                self.advance()?;
                self.named(&name, quoted, at, depth)
            }
            Token::Sign('(') => {
                self.advance()?;
                self.nodes -= 1;
                let mut inside = self.sum(depth + 1)?;
                let end = self.close()?;
                // The place of the whole, with its parentheses.
                inside.spans[0] = at.start..end;
                Ok(inside)
            }
            Token::Sign(_) | Token::End => Err(self.expected(&Expected::Operand)),
        }
    }

    /// Reads `)` and returns its end.
    fn close(&mut self) -> Result<usize, FormulaError> {
        if self.token != Token::Sign(')') {
            return Err(self.expected(&Expected::OperatorOrClose));
        }
        let end = self.at.end;
        self.advance()?;
        Ok(end)
    }

    fn named(
        &mut self,
        name: &str,
        quoted: bool,
        at: Range<usize>,
        depth: usize,
    ) -> Result<Read, FormulaError> {
        let function = Function::ALL.into_iter().find(|function| function.name() == name);
        if let Some(function) = function.filter(|_| !quoted) {
            if self.token != Token::Sign('(') {
                return Err(self.expected(&Expected::Open(name)));
            }
            self.advance()?;
            let operand = self.sum(depth + 1)?;
            let whole = at.start..self.close()?;
            let mut spans = vec![whole];
            let depth = operand.depth + 1;
            let operand = operand.place(&mut spans);
            return Ok(Read { node: Node::unary(function, operand), depth, spans });
        }
        if let Some(index) = self.inputs.iter().position(|input| *input == name) {
            return Ok(Read::leaf(Node::Input(index), at));
        }
        let own = self.constants.iter().find(|constant| constant.name == name).cloned();
        if let Some(constant) = own.or_else(|| known(name)) {
            return Ok(Read::leaf(Node::Constant(constant), at));
        }
        Err(self.fault(at, self.unknown(name)))
    }

    fn unknown(&self, name: &str) -> String {
        let called = self.token == Token::Sign('(');
        let functions = Function::ALL.into_iter().map(Function::name).filter(|name| *name != "-");
        if called && ["log", "Log", "LN", "Ln"].contains(&name) {
            return tr!("unknown function `{name}`: the natural logarithm is `ln`", name = name);
        }
        let constants = self.constants.iter().map(|constant| constant.name.as_str());
        let names: Vec<&str> = if called {
            functions.collect()
        } else {
            self.inputs.iter().copied().chain(constants).chain(["pi", "e"]).collect()
        };
        // A single letter is like every word that has it.
        let longer = names.iter().copied().filter(|known| known.len() > 1 || name.len() == 1);
        let near = nearest(name, longer, 0.7);
        match (near, called) {
            (Some(near), true) => {
                tr!("unknown function `{name}`: did you mean `{near}`?", name = name, near = near)
            }
            (Some(near), false) => {
                tr!("unknown name `{name}`: did you mean `{near}`?", name = name, near = near)
            }
            (None, true) => tr!(
                "unknown function `{name}`: known are {names}",
                name = name,
                names = names.join(", ")
            ),
            (None, false) => tr!(
                "unknown name `{name}`: known are {names}",
                name = name,
                names = names.join(", ")
            ),
        }
    }
}

/// The constants that every formula knows.
fn known(name: &str) -> Option<NamedConstant> {
    let value = match name {
        "pi" => math::PI,
        "e" => math::E,
        _ => return None,
    };
    Some(NamedConstant { name: name.to_owned(), value })
}

/// Whether it is one of these.
pub(super) fn is_known(constant: &NamedConstant) -> bool {
    known(&constant.name).as_ref() == Some(constant)
}
