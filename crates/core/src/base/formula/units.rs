//! Whether a formula is right in its units, and which units its constants must have for that.
//!
//! Every number is an unknown unit; sums, functions and exponents are equations between units, which are linear
//! in the powers of the base quantities. They are solved in the order of the formula, so that an equation that
//! cannot hold is found at its place. Nothing of how the formula was made is used.

use std::collections::BTreeMap;
use std::ops::Range;

use super::unit::{self, Powers, QUANTITIES, Unit};
use super::{Formula, FormulaError, Function, Node, Operator, text};

use crate::base::language::tr;

/// Whether the numbers of a formula may have units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NumberUnits {
    /// Each may have the unit that makes the formula right; `pi`, `e` and exponents have none.
    Solved,
    /// None has one.
    Absent,
}

/// A constant of a formula with its unit.
#[derive(Clone, Debug, PartialEq)]
pub struct ConstantUnit {
    /// The number or name as printed.
    pub text: String,
    /// Where it stands in the printed formula, in bytes.
    pub at: Range<usize>,
    /// Its value.
    pub value: f64,
    /// Its unit; `1` for none.
    pub unit: String,
    /// Whether the formula and its inputs fix that unit; otherwise it shares one with another constant.
    pub fixed: bool,
}

/// A formula that is right in its units.
#[derive(Clone, Debug, PartialEq)]
pub struct UnitReport {
    /// All of its numbers and named constants, from left to right.
    pub constants: Vec<ConstantUnit>,
}

impl Formula {
    /// Checks the units: `inputs` in the order of [`Formula::inputs`].
    ///
    /// # Errors
    /// Names the first part whose units do not fit, with its place in the printed formula.
    pub fn check_units(
        &self,
        inputs: &[Unit],
        output: &Unit,
        numbers: NumberUnits,
    ) -> Result<UnitReport, FormulaError> {
        let (printed, spans) = text::print(self);
        if inputs.len() != self.inputs().len() {
            let [given, needed] = [inputs.len(), self.inputs().len()];
            let problem =
                tr!("{given} units were given for {needed} inputs", given = given, needed = needed);
            return Err(FormulaError::new(&printed, 0..printed.len(), problem));
        }
        let all = inputs.iter().chain([output]);
        let mut symbols: Vec<(String, Powers)> = Vec::new();
        for symbol in all.flat_map(|unit| &unit.symbols) {
            if !symbols.iter().any(|(known, _)| *known == symbol.0) {
                symbols.push(symbol.clone());
            }
        }
        let mut checker = Checker {
            inputs,
            numbers,
            printed: &printed,
            spans: &spans,
            symbols,
            next: 0,
            constants: Vec::new(),
            named: BTreeMap::new(),
            solved: Vec::new(),
        };
        let whole = checker.unit_of(self.root())?;
        let wanted = Form::known(output.powers);
        checker.equal(&whole, &wanted, 0, |a, _| {
            let shown =
                if output.to_string().is_empty() { "1".to_owned() } else { output.to_string() };
            tr!(
                "the formula has the unit {unit}, but its result is to have {wanted}",
                unit = a,
                wanted = shown
            )
        })?;
        Ok(checker.report())
    }
}

/// A unit in terms of unknown ones: known + sum of factor x unknown.
#[derive(Clone, Debug)]
struct Form {
    known: Powers,
    unknown: BTreeMap<usize, f64>,
}

impl Form {
    fn known(known: Powers) -> Self {
        Self { known, unknown: BTreeMap::new() }
    }

    fn none() -> Self {
        Self::known([0.0; QUANTITIES])
    }

    /// self + factor other.
    fn plus(mut self, other: &Self, factor: f64) -> Self {
        self.known = unit::plus(self.known, other.known, factor);
        for (index, x) in &other.unknown {
            *self.unknown.entry(*index).or_default() += factor * x;
        }
        self.unknown.retain(|_, x| x.abs() > 1e-9);
        self
    }
}

struct Checker<'a> {
    inputs: &'a [Unit],
    numbers: NumberUnits,
    printed: &'a str,
    spans: &'a [Range<usize>],
    symbols: Vec<(String, Powers)>,
    /// The number of the next node, from the outermost on.
    next: usize,
    /// Node, value and unit of each constant.
    constants: Vec<(usize, f64, Form)>,
    /// The unknown unit of a constant's name.
    named: BTreeMap<String, usize>,
    /// What each unknown was found to be.
    solved: Vec<Option<Form>>,
}

impl Checker<'_> {
    fn unit_of(&mut self, node: &Node) -> Result<Form, FormulaError> {
        let index = self.next;
        self.next += 1;
        match node {
            Node::Number(x) => {
                let form = self.unknown(None);
                self.constants.push((index, *x, form.clone()));
                Ok(form)
            }
            Node::Constant(constant) => {
                let plain = ["pi", "e"].contains(&constant.name.as_str());
                let form = if plain { Form::none() } else { self.unknown(Some(&constant.name)) };
                self.constants.push((index, constant.value, form.clone()));
                Ok(form)
            }
            Node::Input(input) => {
                Ok(self.inputs.get(*input).map_or_else(Form::none, |unit| Form::known(unit.powers)))
            }
            Node::Unary(function, operand) => {
                let at = self.next;
                let inner = self.unit_of(operand)?;
                match function {
                    Function::Negative => Ok(inner),
                    Function::Sqrt => Ok(Form::none().plus(&inner, 0.5)),
                    Function::Ln
                    | Function::Exp
                    | Function::Sin
                    | Function::Cos
                    | Function::Tanh => {
                        let name = function.name();
                        self.equal(&inner, &Form::none(), at, |a, _| {
                            tr!(
                                "`{name}` needs a plain number, but this has the unit {unit}",
                                name = name,
                                unit = a
                            )
                        })?;
                        Ok(Form::none())
                    }
                }
            }
            Node::Binary(operator, pair) => self.of_operator(*operator, pair, index),
        }
    }

    fn of_operator(
        &mut self,
        operator: Operator,
        pair: &[Node; 2],
        index: usize,
    ) -> Result<Form, FormulaError> {
        let left = self.unit_of(&pair[0])?;
        let at = self.next;
        let right = self.unit_of(&pair[1])?;
        match operator {
            Operator::Multiply => Ok(left.plus(&right, 1.0)),
            Operator::Divide => Ok(left.plus(&right, -1.0)),
            Operator::Add | Operator::Subtract => {
                self.equal(&left, &right, index, |a, b| {
                    if operator == Operator::Add {
                        tr!("cannot add {second} to {first}", second = b, first = a)
                    } else {
                        tr!("cannot subtract {second} from {first}", second = b, first = a)
                    }
                })?;
                Ok(self.reduced(&left))
            }
            Operator::Power => {
                self.equal(&right, &Form::none(), at, |a, _| {
                    tr!("an exponent is a plain number, but this has the unit {unit}", unit = a)
                })?;
                if has_input(&pair[1]) {
                    self.equal(&left, &Form::none(), index + 1, |a, _| {
                        tr!(
                            "with an exponent that changes, the base must be a plain number, but this has the \
                             unit {unit}",
                            unit = a
                        )
                    })?;
                    return Ok(Form::none());
                }
                Ok(Form::none().plus(&left, pair[1].value(&[])))
            }
        }
    }

    /// A new unknown unit, or that of a name, as the numbers may have one.
    fn unknown(&mut self, name: Option<&str>) -> Form {
        if self.numbers == NumberUnits::Absent {
            return Form::none();
        }
        let new = self.solved.len();
        let index = match name {
            Some(name) => *self.named.entry(name.to_owned()).or_insert(new),
            None => new,
        };
        if index == new {
            self.solved.push(None);
        }
        Form { unknown: BTreeMap::from([(index, 1.0)]), ..Form::none() }
    }

    /// The same with every unknown that was found replaced.
    fn reduced(&self, form: &Form) -> Form {
        let mut result = form.clone();
        // Each replacement may bring unknowns that were found before or after; none brings itself.
        while let Some((index, factor, found)) =
            result.unknown.iter().find_map(|(index, factor)| {
                self.solved[*index].as_ref().map(|found| (*index, *factor, found))
            })
        {
            result.unknown.remove(&index);
            result = result.plus(found, factor);
        }
        result
    }

    /// Makes both equal by fixing an unknown; where none is left, they must be.
    fn equal(
        &mut self,
        left: &Form,
        right: &Form,
        index: usize,
        problem: impl Fn(&str, &str) -> String,
    ) -> Result<(), FormulaError> {
        let (left, right) = (self.reduced(left), self.reduced(right));
        let difference = left.clone().plus(&right, -1.0);
        let largest = difference.unknown.iter().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        let Some((unknown, factor)) = largest.map(|(index, factor)| (*index, *factor)) else {
            if unit::is_none(difference.known) {
                return Ok(());
            }
            let shown = |form: &Form| unit::text(form.known, &self.symbols);
            let at = self.spans.get(index).cloned().unwrap_or(0..self.printed.len());
            let part = &self.printed[at.clone()];
            let problem = format!("`{part}`: {}", problem(&shown(&left), &shown(&right)));
            return Err(FormulaError::new(self.printed, at, problem));
        };
        let mut rest = difference;
        rest.unknown.remove(&unknown);
        self.solved[unknown] = Some(Form::none().plus(&rest, -1.0 / factor));
        Ok(())
    }

    fn report(&self) -> UnitReport {
        let constants = self.constants.iter().map(|(index, value, form)| {
            let form = self.reduced(form);
            let at = self.spans[*index].clone();
            ConstantUnit {
                text: self.printed[at.clone()].to_owned(),
                at,
                value: *value,
                unit: unit::text(form.known, &self.symbols),
                fixed: form.unknown.is_empty(),
            }
        });
        UnitReport { constants: constants.collect() }
    }
}

fn has_input(node: &Node) -> bool {
    matches!(node, Node::Input(_)) || node.operands().iter().any(has_input)
}
