//! Formulas that people write: read, evaluated, differentiated, simplified, checked for units, bounded over
//! ranges, and printed for other programs.
//!
//! A formula has `+ - * / ^`, a minus sign, `ln exp sqrt sin cos tanh`, numbers, named inputs and named
//! constants (`pi` and `e` are known). `^` is [`power`](crate::base::math::power), here and in every export.
//!
//! ```
//! use steadycut_core::base::formula::Formula;
//!
//! let law = Formula::parse("286.44 - 5.82e-10 n^3 - 8973 ln(0.039 f) / f", &["f", "n"]);
//! assert!(law.unwrap_err().to_string().contains("expected an operator"));
//! let law = Formula::parse("286.44 - 5.82e-10*n^3 - 8973*ln(0.039*f)/f", &["f", "n"]).unwrap();
//! assert_eq!(law.to_string(), "286.44 - 5.82e-10 * n^3 - 8973 * ln(0.039 * f) / f");
//! assert_eq!(law.size(), 16);
//! let value = law.compile().value(&[300.0, 1500.0]);
//! assert_eq!(value, law.value(&[300.0, 1500.0]));
//! ```

use crate::base::language::tr;

mod certificate;
mod derivative;
mod error;
mod export;
mod interval;
mod node;
mod parse;
mod program;
mod simplify;
#[cfg(test)]
mod tests;
mod text;
mod unit;
mod units;

use std::fmt;

pub use certificate::{Certificate, Trend, UncertifiedPlace, widened, widened_physically};
pub use error::FormulaError;
pub use export::FormulaLanguage;
pub use interval::Interval;
pub use node::{Function, NamedConstant, Node, Operator};
pub use program::CompiledFormula;
pub use unit::Unit;
pub use units::{ConstantUnit, NumberUnits, UnitReport};

/// Deepest nesting of a formula that is read or built: what goes over a formula is recursive.
pub const MAX_DEPTH: usize = 100;
/// Most nodes of a formula that is read or built.
pub const MAX_SIZE: usize = 4000;

/// A formula of named inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    root: Node,
    inputs: Vec<String>,
}

impl Formula {
    /// A formula from its tree.
    ///
    /// # Errors
    /// Says what is wrong: too deep, too large, an input that is not there, a number that is not finite, or a
    /// minus sign before a number, which is a negative number ([`Node::unary`] makes it so).
    pub fn new(root: Node, inputs: &[impl AsRef<str>]) -> Result<Self, String> {
        let inputs: Vec<String> = inputs.iter().map(|name| name.as_ref().to_owned()).collect();
        if root.depth(MAX_DEPTH) > MAX_DEPTH {
            return Err(tr!("the formula is nested more than {n} deep", n = MAX_DEPTH));
        }
        let size = root.size();
        if size > MAX_SIZE {
            return Err(tr!(
                "the formula has {n} nodes: allowed are {most}",
                n = size,
                most = MAX_SIZE
            ));
        }
        check_names(&inputs)?;
        check(&root, &inputs)?;
        Ok(Self { root, inputs })
    }

    /// Reads a formula whose inputs have these names.
    ///
    /// # Errors
    /// Names the place, what stands there and what was expected.
    pub fn parse(text: &str, inputs: &[impl AsRef<str>]) -> Result<Self, FormulaError> {
        parse::parse(text, inputs, &[]).map(|(formula, _)| formula)
    }

    /// The names that a formula reads besides functions, `pi` and `e`, in the order of their first place: its
    /// inputs, where nothing else names them.
    ///
    /// # Errors
    /// As [`Self::parse`].
    pub fn names(text: &str) -> Result<Vec<String>, FormulaError> {
        let names = parse::names(text)?;
        Self::parse(text, &names).map(|_| names)
    }

    /// The same with constants of its own; a name of these goes before `pi` and `e`.
    ///
    /// # Errors
    /// As [`Self::parse`].
    pub fn parse_with(
        text: &str,
        inputs: &[impl AsRef<str>],
        constants: &[NamedConstant],
    ) -> Result<Self, FormulaError> {
        parse::parse(text, inputs, constants).map(|(formula, _)| formula)
    }

    /// The outermost part.
    #[must_use]
    pub fn root(&self) -> &Node {
        &self.root
    }

    /// The names of the inputs, in the order of their values.
    #[must_use]
    pub fn inputs(&self) -> &[String] {
        &self.inputs
    }

    /// The number of nodes: every number, input, constant, function and operator counts.
    #[must_use]
    pub fn size(&self) -> usize {
        self.root.size()
    }

    /// The named constants that it has, other than `pi` and `e`.
    #[must_use]
    pub fn own_constants(&self) -> Vec<NamedConstant> {
        let mut found = Vec::new();
        constants(&self.root, &mut found);
        found
    }

    /// Which inputs it reads.
    #[must_use]
    pub fn reads(&self) -> Vec<bool> {
        let mut reads = vec![false; self.inputs.len()];
        mark(&self.root, &mut reads);
        reads
    }

    /// The value at inputs in the order of [`Self::inputs`], NaN where there is none. [`Self::compile`] is
    /// faster and gives the same bits.
    #[must_use]
    pub fn value(&self, inputs: &[f64]) -> f64 {
        self.root.value(inputs)
    }

    /// The derivative by an input, simplified.
    ///
    /// # Errors
    /// The derivative is too deep or too large, or there is no such input.
    pub fn derivative(&self, input: usize) -> Result<Self, String> {
        if input >= self.inputs.len() {
            return Err(tr!(
                "there is no input {input}: there are {n}",
                input = input,
                n = self.inputs.len()
            ));
        }
        let raw = derivative::derivative(&self.root, input);
        let root = simplify::simplify(&raw);
        Self::new(root, &self.inputs).map_err(|problem| {
            tr!(
                "the derivative by `{input}` cannot be written: {problem}",
                input = &self.inputs[input],
                problem = problem
            )
        })
    }

    /// A formula of the same values but for rounding, with no more nodes: constants folded, neutral elements
    /// dropped, like terms and factors collected. What it keeps is every place where the formula has no value:
    /// x / x stays, since it has none at 0. Where a part is infinite the values may differ: zero has no sign in
    /// `x * 0`, and -1 / (x * 0) goes to one infinity or the other.
    #[must_use]
    pub fn simplified(&self) -> Self {
        let root = simplify::simplify(&self.root);
        Self::new(root, &self.inputs).unwrap_or_else(|_| self.clone())
    }

    /// Bounds of the value over ranges of the inputs; none where a part may have no value.
    #[must_use]
    pub fn bounds(&self, ranges: &[Interval]) -> Option<Interval> {
        interval::bounds(&self.root, ranges, &mut 0).ok()
    }

    /// The form that a loop evaluates, without allocation.
    #[must_use]
    pub fn compile(&self) -> CompiledFormula {
        CompiledFormula::new(&self.root, self.inputs.len())
    }
}

/// With as few parentheses as needed and the shortest numbers that read back to the same bits.
impl fmt::Display for Formula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&text::print(self).0)
    }
}

/// Whether inputs can have these names.
fn check_names(inputs: &[impl AsRef<str>]) -> Result<(), String> {
    for (index, name) in inputs.iter().map(AsRef::as_ref).enumerate() {
        if name.is_empty() || name.contains('"') {
            return Err(tr!(
                "`{name}` is no name of an input: allowed is any without `\"`",
                name = name
            ));
        }
        if inputs[..index].iter().any(|other| other.as_ref() == name) {
            return Err(tr!("two inputs have the name `{name}`", name = name));
        }
    }
    Ok(())
}

fn check(node: &Node, inputs: &[String]) -> Result<(), String> {
    match node {
        Node::Input(index) if *index >= inputs.len() => {
            return Err(tr!(
                "the formula reads input {input}: there are {n}",
                input = *index,
                n = inputs.len()
            ));
        }
        Node::Number(x) if !x.is_finite() => {
            return Err(tr!(
                "the formula has the number {number}: allowed are finite ones",
                number = *x
            ));
        }
        Node::Constant(constant) if !constant.value.is_finite() => {
            let NamedConstant { name, value } = constant;
            return Err(tr!(
                "the constant `{name}` is {value}: allowed are finite ones",
                name = name,
                value = *value
            ));
        }
        Node::Constant(constant) if inputs.contains(&constant.name) => {
            return Err(tr!("`{name}` is an input and a constant", name = &constant.name));
        }
        Node::Unary(Function::Negative, operand) if operand.number().is_some() => {
            let problem = tr("a minus sign before a number: write a negative number");
            return Err(problem.to_owned());
        }
        Node::Number(_)
        | Node::Input(_)
        | Node::Constant(_)
        | Node::Unary(..)
        | Node::Binary(..) => {}
    }
    node.operands().iter().try_for_each(|operand| check(operand, inputs))
}

fn mark(node: &Node, reads: &mut [bool]) {
    if let Node::Input(index) = node
        && let Some(read) = reads.get_mut(*index)
    {
        *read = true;
    }
    node.operands().iter().for_each(|operand| mark(operand, reads));
}

fn constants(node: &Node, found: &mut Vec<NamedConstant>) {
    if let Node::Constant(constant) = node
        && !parse::is_known(constant)
        && !found.contains(constant)
    {
        found.push(constant.clone());
    }
    node.operands().iter().for_each(|operand| constants(operand, found));
}
