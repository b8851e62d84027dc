//! Conditions: two formulas over named values with a comparison between them.

use std::collections::BTreeMap;
use std::fmt;

use crate::base::formula::Formula;
use crate::base::language::tr;

/// Named values; one that there is none of (a settling time of a loop that does not settle) is `None`.
pub type Values = BTreeMap<String, Option<f64>>;

steadycut_core::choice! {
    /// How two numbers are compared.
    pub enum Relation {
        /// At most.
        AtMost = "<=", "at most";
        /// At least.
        AtLeast = ">=", "at least";
        /// The same.
        Equal = "==", "the same as";
        /// Not the same.
        NotEqual = "!=", "other than";
        /// Less.
        Less = "<", "less than";
        /// More.
        More = ">", "more than";
    }
}

impl Relation {
    fn holds(self, left: f64, right: f64) -> bool {
        match self {
            Self::AtMost => left <= right,
            Self::AtLeast => left >= right,
            Self::Equal => left == right,
            Self::NotEqual => left != right,
            Self::Less => left < right,
            Self::More => left > right,
        }
    }
}

/// A formula over named values.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    text: String,
    formula: Formula,
}

impl Quantity {
    /// Reads a formula whose names `known` has.
    ///
    /// # Errors
    /// Names the place in the text, or the name that nothing has, with the nearest one that there is.
    pub fn read(text: &str, known: &dyn Fn(&str) -> Result<(), String>) -> Result<Self, String> {
        let names = Formula::names(text).map_err(|error| error.to_string())?;
        names.iter().try_for_each(|name| known(name))?;
        let formula = Formula::parse(text, &names).map_err(|error| error.to_string())?;
        Ok(Self { text: text.trim().to_owned(), formula })
    }

    /// The names that it reads.
    pub fn names(&self) -> &[String] {
        self.formula.inputs()
    }

    /// The name that it is, if it is one alone.
    #[must_use]
    pub fn as_name(&self) -> Option<&str> {
        self.names().first().map(String::as_str).filter(|name| *name == self.text)
    }

    /// Its value; none where a value that it reads is none, or where the formula has none.
    #[must_use]
    pub fn value(&self, values: &Values) -> Option<f64> {
        let of = |name: &String| values.get(name).copied().flatten();
        let inputs: Vec<f64> = self.names().iter().map(of).collect::<Option<_>>()?;
        Some(self.formula.value(&inputs)).filter(|value| value.is_finite())
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// A comparison of two formulas.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    left: Quantity,
    comparison: Relation,
    right: Quantity,
}

impl Condition {
    /// Reads `left comparison right`.
    ///
    /// # Errors
    /// There is not exactly one comparison, or as [`Quantity::read`].
    pub fn read(text: &str, known: &dyn Fn(&str) -> Result<(), String>) -> Result<Self, String> {
        let (left, comparison, right) = split(text)?;
        Ok(Self {
            left: Quantity::read(left, known)?,
            comparison,
            right: Quantity::read(right, known)?,
        })
    }

    /// Whether it holds: `false` where one side has no value.
    #[must_use]
    pub fn holds(&self, values: &Values) -> bool {
        let [left, right] = self.sides(values);
        left.zip(right).is_some_and(|(left, right)| self.comparison.holds(left, right))
    }

    /// Its sides.
    #[must_use]
    pub fn quantities(&self) -> [&Quantity; 2] {
        [&self.left, &self.right]
    }

    /// How they are compared.
    #[must_use]
    pub fn comparison(&self) -> Relation {
        self.comparison
    }

    /// What stands on its sides.
    #[must_use]
    pub fn sides(&self, values: &Values) -> [Option<f64>; 2] {
        [self.left.value(values), self.right.value(values)]
    }

    /// The names that it reads.
    pub fn names(&self) -> impl Iterator<Item = &String> {
        self.left.names().iter().chain(self.right.names())
    }
}

impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} {}", self.left, self.comparison.id(), self.right)
    }
}

/// The sides of the only comparison in a text.
fn split(text: &str) -> Result<(&str, Relation, &str), String> {
    let allowed = || {
        let all: Vec<&str> = Relation::ALL.iter().map(|comparison| comparison.id()).collect();
        tr!("allowed is one of {list} between two formulas", list = all.join(" "))
    };
    let mut found = None;
    let mut at = 0;
    while at < text.len() {
        // The two-letter ones stand before those that they begin with.
        let here = Relation::ALL.iter().find(|one| text[at..].starts_with(one.id()));
        let Some(&comparison) = here else {
            at += text[at..].chars().next().map_or(1, char::len_utf8);
            continue;
        };
        if found.is_some() {
            return Err(tr!(
                "`{text}` compares twice: {allowed}; write two conditions",
                text = text,
                allowed = allowed()
            ));
        }
        found = Some((at, comparison));
        at += comparison.id().len();
    }
    let (at, comparison) = found.ok_or_else(|| {
        tr!("`{text}` compares nothing: {allowed}", text = text, allowed = allowed())
    })?;
    Ok((&text[..at], comparison, &text[at + comparison.id().len()..]))
}
