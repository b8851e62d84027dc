//! Types that can be a setting, and structs of them.

use serde::Serialize;

use super::{Kind, Value};

/// The description of one setting.
#[derive(Clone, Debug, Serialize)]
pub struct Spec {
    /// Name within its group.
    #[serde(skip)]
    pub key: &'static str,
    /// Name for people.
    pub label: &'static str,
    /// Unit, empty for none.
    pub unit: &'static str,
    /// What it does, and its source.
    pub doc: &'static str,
    /// What it may hold.
    #[serde(flatten)]
    pub allowed: Kind,
    /// Default value.
    pub default: Value,
    /// Whether a change acts at once in a running cut; otherwise it belongs to the set-up.
    pub live: bool,
}

/// A type that can be a setting.
pub trait Field: Sized {
    /// The kind for a declared range `min..=max`.
    fn kind(min: f64, max: f64) -> Kind;
    /// The value in transit.
    fn to_value(&self) -> Value;
    /// The typed value, or `None` where type or range do not fit `kind`.
    fn from_value(value: &Value, kind: &Kind) -> Option<Self>;
}

impl Field for f64 {
    fn kind(min: f64, max: f64) -> Kind {
        Kind::Float { min, max }
    }
    fn to_value(&self) -> Value {
        Value::Float(*self)
    }
    fn from_value(value: &Value, kind: &Kind) -> Option<Self> {
        let x = value.number()?;
        // + 0.0 turns -0.0 into 0.0, so that equal settings have equal bits.
        matches!(kind, Kind::Float { min, max } if x >= *min && x <= *max).then_some(x + 0.0)
    }
}

impl Field for u32 {
    fn kind(min: f64, max: f64) -> Kind {
        Kind::Int { min: min as i64, max: max as i64 }
    }
    fn to_value(&self) -> Value {
        Value::Int(i64::from(*self))
    }
    fn from_value(value: &Value, kind: &Kind) -> Option<Self> {
        let x = match value {
            Value::Int(x) => *x,
            Value::Float(x) if x.fract() == 0.0 && x.abs() < 9e15 => *x as i64,
            Value::Float(_) | Value::Bool(_) | Value::Text(_) | Value::List(_) => return None,
        };
        let fits = matches!(kind, Kind::Int { min, max } if x >= *min && x <= *max);
        if fits { u32::try_from(x).ok() } else { None }
    }
}

impl Field for bool {
    fn kind(_: f64, _: f64) -> Kind {
        Kind::Bool
    }
    fn to_value(&self) -> Value {
        Value::Bool(*self)
    }
    fn from_value(value: &Value, _: &Kind) -> Option<Self> {
        if let Value::Bool(x) = value { Some(*x) } else { None }
    }
}

impl Field for String {
    fn kind(_: f64, max: f64) -> Kind {
        Kind::Text { max_chars: max as usize }
    }
    fn to_value(&self) -> Value {
        Value::Text(self.clone())
    }
    fn from_value(value: &Value, kind: &Kind) -> Option<Self> {
        match (value, kind) {
            (Value::Text(text), Kind::Text { max_chars })
                if text.chars().count() <= *max_chars
                    && !text.chars().any(|c| c.is_control() && c != '\n') =>
            {
                Some(text.clone())
            }
            _ => None,
        }
    }
}

/// A settings struct, addressed by key.
pub trait Group {
    /// Descriptions of its settings, in order.
    fn specs() -> Vec<Spec>
    where
        Self: Sized;
    /// The value of `key`.
    fn get(&self, key: &str) -> Option<Value>;
    /// Sets `key`; `None` where the key is unknown or the value does not fit `kind`.
    fn set(&mut self, key: &str, value: &Value, kind: &Kind) -> Option<()>;
    /// The groups within this one, each with the full path that it stands under; most have none.
    fn parts() -> Vec<(&'static str, Vec<Spec>)>
    where
        Self: Sized,
    {
        Vec::new()
    }
    /// The group within this one that stands under `path`.
    fn part(&self, _path: &str) -> Option<&dyn Group> {
        None
    }
    /// The same, to change it.
    fn part_mut(&mut self, _path: &str) -> Option<&mut dyn Group> {
        None
    }
}
