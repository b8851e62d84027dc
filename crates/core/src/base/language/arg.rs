//! A value in a text.

use std::borrow::Cow;

use fluent_bundle::FluentValue;

use super::decimal;
use super::source::Spec;

/// A value in a text: a number is written in it as the language writes numbers, a whole one also chooses among plurals.
#[derive(Clone, Debug, PartialEq)]
pub enum Arg<'a> {
    /// A number that is written with so many digits as the text says.
    Number(f64),
    /// A count.
    Whole(i64),
    /// A text, as it is.
    Text(Cow<'a, str>),
}

impl<'a> Arg<'a> {
    /// The value as the catalogue's texts take it.
    pub(super) fn value(&self, spec: Spec) -> FluentValue<'a> {
        match self {
            Self::Number(value) => signed(decimal(spec.number(*value))).into(),
            Self::Whole(value) => (*value).into(),
            Self::Text(text) => FluentValue::String(text.clone()),
        }
    }
}

impl From<&f64> for Arg<'_> {
    fn from(value: &f64) -> Self {
        Self::Number(*value)
    }
}

impl From<&f32> for Arg<'_> {
    fn from(value: &f32) -> Self {
        Self::Number(f64::from(*value))
    }
}

/// With the sign minus: what is said in another language than English is for people.
fn signed(number: String) -> String {
    match number.strip_prefix('-') {
        Some(size) => format!("\u{2212}{size}"),
        None => number,
    }
}

macro_rules! whole {
    ($($kind:ty),+) => { $(
        impl From<&$kind> for Arg<'_> {
            fn from(value: &$kind) -> Self {
                // Counts beyond that have no plural of their own; they are written as they are.
                i64::try_from(*value).map_or_else(|_| Self::Text(value.to_string().into()), Self::Whole)
            }
        }
    )+ };
}
whole!(u8, u16, u32, u64, usize, i32, i64, isize, u128);

impl<'a> From<&'a String> for Arg<'a> {
    fn from(value: &'a String) -> Self {
        Self::Text(Cow::Borrowed(value))
    }
}

impl<'a> From<&'a &str> for Arg<'a> {
    fn from(value: &'a &str) -> Self {
        Self::Text(Cow::Borrowed(value))
    }
}

impl<'a> From<&'a Cow<'_, str>> for Arg<'a> {
    fn from(value: &'a Cow<'_, str>) -> Self {
        Self::Text(Cow::Borrowed(value))
    }
}

impl<'a> From<&'a &String> for Arg<'a> {
    fn from(value: &'a &String) -> Self {
        Self::Text(Cow::Borrowed(value))
    }
}

impl From<&char> for Arg<'_> {
    fn from(value: &char) -> Self {
        Self::Text(value.to_string().into())
    }
}
