//! Settings of several numbers, or of a text with a form: their type brings along how they are read,
//! printed, bounded, described and edited. Nothing here knows their meaning.

use std::fmt;
use std::marker::PhantomData;
use std::ops::Deref;
use std::sync::Arc;

use serde::{Serialize, Serializer};

use super::Value;

/// A structured setting: with this and a line [`structured!`](crate::structured!), its type is a
/// setting like any other. `range` is the one that the setting is declared with.
pub trait Structure: Sized + 'static {
    /// Name of its kind, for lists.
    const ID: &'static str;

    /// Its bounds by name.
    fn bounds(range: [f64; 2]) -> Vec<(&'static str, f64)>;
    /// What is allowed, in words.
    fn allowed(range: [f64; 2], unit: &str) -> String;
    /// The value in transit.
    fn write(&self) -> Value;
    /// The typed value, or none where it does not fit.
    fn read(value: &Value, range: [f64; 2]) -> Option<Self>;
    /// The value of a text on the command line or in a link.
    #[must_use]
    fn parse(text: &str) -> Option<Value> {
        serde_json::from_str::<serde_json::Value>(text).ok().map(Value::from)
    }
    /// What is wrong with a value that was refused, where that says more than the value.
    #[must_use]
    fn fault(_value: &Value) -> Option<String> {
        None
    }
    /// How it is edited.
    fn editor(range: [f64; 2]) -> Editor;
    /// A value that is allowed, for tests: numbers at `share` (0 to 1) of their ranges, all else by
    /// `pick`.
    fn example(range: [f64; 2], share: f64, pick: u32) -> Value;
}

/// How a structured setting is edited.
#[derive(Clone, Debug, PartialEq)]
pub enum Editor {
    /// Rows of numbers, to be added and removed.
    Rows(Rows),
    /// A list of numbers.
    Numbers(Numbers),
    /// How many of what there are; a window of its own edits them.
    Count(&'static str),
    /// Whether there is something, and a button that removes it; files bring it.
    Presence,
    /// A formula with units and ranges, or none.
    Formula(FormulaShape),
    /// A script of several lines.
    Script,
}

/// A formula that a setting takes.
#[derive(Clone, Debug, PartialEq)]
pub struct FormulaShape {
    /// Units of its inputs, in this order.
    pub inputs: &'static [&'static str],
    /// What the inputs are, in words.
    pub meaning: &'static str,
    /// Unit of the result; empty for a number without one.
    pub output: &'static str,
    /// One that is allowed, in one line.
    pub example: &'static str,
}

/// Rows of numbers, ascending in the first one.
#[derive(Clone, Debug, PartialEq)]
pub struct Rows {
    /// What a row is called.
    pub row: &'static str,
    /// Its numbers.
    pub columns: Vec<Column>,
    /// Most rows.
    pub most: usize,
    /// Least distance of two rows in the first number.
    pub gap: f64,
    /// A new row: the first number counts from that of the last row.
    pub next: Vec<f64>,
}

/// A list of numbers, each with its place in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Numbers {
    /// What a number belongs to.
    pub each: &'static str,
    /// What is allowed.
    pub range: [f64; 2],
    /// Most numbers.
    pub most: usize,
}

/// A number of a row.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// What it is called.
    pub name: &'static str,
    /// What stands behind it.
    pub suffix: &'static str,
    /// What is allowed.
    pub range: [f64; 2],
    /// How much a point of dragging changes it.
    pub speed: f64,
}

/// A [`Structure`] with its declared range.
pub trait Shape: Send + Sync {
    /// See [`Structure::ID`].
    fn id(&self) -> &'static str;
    /// See [`Structure::bounds`].
    fn bounds(&self) -> Vec<(&'static str, f64)>;
    /// See [`Structure::allowed`].
    fn allowed(&self, unit: &str) -> String;
    /// See [`Structure::parse`].
    fn parse(&self, text: &str) -> Option<Value>;
    /// See [`Structure::fault`].
    fn fault(&self, value: &Value) -> Option<String>;
    /// See [`Structure::editor`].
    fn editor(&self) -> Editor;
    /// See [`Structure::example`].
    fn example(&self, share: f64, pick: u32) -> Value;
    /// The range.
    fn range(&self) -> [f64; 2];
}

struct Ranged<T> {
    range: [f64; 2],
    of: PhantomData<fn() -> T>,
}

impl<T: Structure> Shape for Ranged<T> {
    fn id(&self) -> &'static str {
        T::ID
    }
    fn bounds(&self) -> Vec<(&'static str, f64)> {
        T::bounds(self.range)
    }
    fn allowed(&self, unit: &str) -> String {
        T::allowed(self.range, unit)
    }
    fn parse(&self, text: &str) -> Option<Value> {
        T::parse(text)
    }
    fn fault(&self, value: &Value) -> Option<String> {
        T::fault(value)
    }
    fn editor(&self) -> Editor {
        T::editor(self.range)
    }
    fn example(&self, share: f64, pick: u32) -> Value {
        T::example(self.range, share, pick)
    }
    fn range(&self) -> [f64; 2] {
        self.range
    }
}

/// The shape of a structured setting, whatever its type is.
#[derive(Clone)]
pub struct Structured(Arc<dyn Shape>);

impl Structured {
    /// The shape of `T` within a declared range.
    #[must_use]
    pub fn new<T: Structure>(range: [f64; 2]) -> Self {
        Self(Arc::new(Ranged::<T> { range, of: PhantomData }))
    }
}

impl Deref for Structured {
    type Target = dyn Shape;

    fn deref(&self) -> &Self::Target {
        &*self.0
    }
}

impl PartialEq for Structured {
    fn eq(&self, other: &Self) -> bool {
        self.id() == other.id() && self.range() == other.range()
    }
}

impl fmt::Debug for Structured {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {:?}", self.id(), self.bounds())
    }
}

impl Serialize for Structured {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        use serde::ser::SerializeMap;
        let bounds = self.bounds();
        let mut map = serializer.serialize_map(Some(1 + bounds.len()))?;
        map.serialize_entry("kind", self.id())?;
        for (name, bound) in bounds {
            map.serialize_entry(name, &bound)?;
        }
        map.end()
    }
}

/// Makes types that are a [`Structure`] settings.
#[macro_export]
macro_rules! structured {
    ($($ty:ty),+ $(,)?) => { $(
        impl $crate::base::settings::Field for $ty {
            fn kind(min: f64, max: f64) -> $crate::base::settings::Kind {
                let shape = $crate::base::settings::Structured::new::<Self>([min, max]);
                $crate::base::settings::Kind::Structured(shape)
            }
            fn to_value(&self) -> $crate::base::settings::Value {
                <Self as $crate::base::settings::Structure>::write(self)
            }
            fn from_value(
                value: &$crate::base::settings::Value,
                kind: &$crate::base::settings::Kind,
            ) -> Option<Self> {
                let $crate::base::settings::Kind::Structured(shape) = kind else { return None };
                <Self as $crate::base::settings::Structure>::read(value, shape.range())
            }
        }
    )+ };
}
