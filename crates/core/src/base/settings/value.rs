//! The value of a setting in transit.

use std::fmt;

use serde::Serialize;

/// The value of a setting in transit (file, link, command line, edit).
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Value {
    /// A whole number.
    Int(i64),
    /// A real number.
    Float(f64),
    /// Yes or no.
    Bool(bool),
    /// Free text, or the id of a choice.
    Text(String),
    /// A list, of lists or of numbers.
    List(Vec<Value>),
}

impl Value {
    /// The number, whole or not.
    #[must_use]
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Int(x) => Some(*x as f64),
            Self::Float(x) => Some(*x),
            Self::Bool(_) | Self::Text(_) | Self::List(_) => None,
        }
    }

    /// The entries of a list.
    #[must_use]
    pub fn list(&self) -> Option<&[Self]> {
        match self {
            Self::List(list) => Some(list),
            Self::Int(_) | Self::Float(_) | Self::Bool(_) | Self::Text(_) => None,
        }
    }

    /// A list of numbers.
    #[must_use]
    pub fn numbers(&self) -> Option<Vec<f64>> {
        self.list()?.iter().map(Self::number).collect()
    }

    /// A list of `N` numbers.
    #[must_use]
    pub fn array<const N: usize>(&self) -> Option<[f64; N]> {
        self.numbers()?.try_into().ok()
    }
}

impl From<f64> for Value {
    fn from(x: f64) -> Self {
        Self::Float(x)
    }
}

impl<T: Into<Value>> From<Vec<T>> for Value {
    fn from(list: Vec<T>) -> Self {
        Self::List(list.into_iter().map(Into::into).collect())
    }
}

impl<T: Into<Value>, const N: usize> From<[T; N]> for Value {
    fn from(list: [T; N]) -> Self {
        Self::List(list.into_iter().map(Into::into).collect())
    }
}

impl From<serde_json::Value> for Value {
    fn from(value: serde_json::Value) -> Self {
        use serde_json::Value as Json;
        match value {
            Json::Array(list) => Self::List(list.into_iter().map(Self::from).collect()),
            Json::Bool(on) => Self::Bool(on),
            Json::Number(number) => match number.as_i64() {
                Some(whole) => Self::Int(whole),
                None => Self::Float(number.as_f64().unwrap_or(f64::NAN)),
            },
            Json::String(text) => Self::Text(text),
            other @ (Json::Null | Json::Object(_)) => Self::Text(other.to_string()),
        }
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Int(x) => write!(f, "{x}"),
            Self::Float(x) => write!(f, "{x}"),
            Self::Bool(x) => write!(f, "{x}"),
            Self::Text(x) => write!(f, "{x}"),
            // Nested lists of numbers are written alike in TOML, in JSON and here.
            Self::List(list) => {
                write!(f, "[")?;
                for (i, value) in list.iter().enumerate() {
                    let comma = if i == 0 { "" } else { ", " };
                    match value {
                        // {:?} keeps the decimal point, so that a number stays a float in TOML.
                        Self::Float(x) => write!(f, "{comma}{x:?}")?,
                        Self::Int(_) | Self::Bool(_) | Self::Text(_) | Self::List(_) => {
                            write!(f, "{comma}{value}")?;
                        }
                    }
                }
                write!(f, "]")
            }
        }
    }
}
