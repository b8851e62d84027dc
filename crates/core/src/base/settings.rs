//! Settings as data: one table entry per setting serves the scenario file, the link, `--set`, the
//! editor widgets, `steadycut list`, validation and the fuzz tests.
//!
//! A settings struct is declared with [`settings!`](crate::settings!), a closed choice with
//! [`choice!`](crate::choice!). Everything that changes a setting goes through [`Group::set`],
//! which refuses what is outside the declared range, so a struct never holds a bad value.

use std::fmt;

use serde::Serialize;

/// A point of the depth profile: from `position_mm` along the path on, the axial depth of cut is
/// `axial_depth_mm`.
pub type DepthStep = [f64; 2];

/// A section of a straight cut: length along the cut, axial depth of cut and position y_e of the side
/// wall across the cut relative to the tool's axis, all in mm.
pub type Section = [f64; 3];

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
    /// A depth profile: pairs of position and depth, both in mm.
    Steps(Vec<DepthStep>),
    /// Straight cuts, each a list of sections.
    Cuts(Vec<Vec<Section>>),
    /// A list of real numbers.
    Numbers(Vec<f64>),
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Int(x) => write!(f, "{x}"),
            Self::Float(x) => write!(f, "{x}"),
            Self::Bool(x) => write!(f, "{x}"),
            Self::Text(x) => write!(f, "{x}"),
            Self::Steps(steps) => {
                write!(f, "[")?;
                for (i, [position, depth]) in steps.iter().enumerate() {
                    let comma = if i == 0 { "" } else { ", " };
                    write!(f, "{comma}[{position:?}, {depth:?}]")?;
                }
                write!(f, "]")
            }
            // Nested lists of floats are written alike in TOML, in JSON and here.
            Self::Cuts(cuts) => write!(f, "{cuts:?}"),
            Self::Numbers(numbers) => write!(f, "{numbers:?}"),
        }
    }
}

/// One option of a closed choice.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Choice {
    /// Its name in files and on the command line.
    pub id: &'static str,
    /// Its name for people.
    pub label: &'static str,
    /// What it is, with its source.
    pub doc: &'static str,
}

/// What a setting may hold.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Kind {
    /// A finite real number within the range.
    Float {
        /// Least value allowed.
        min: f64,
        /// Largest value allowed.
        max: f64,
    },
    /// A whole number within the range.
    Int {
        /// Least value allowed.
        min: i64,
        /// Largest value allowed.
        max: i64,
    },
    /// `true` or `false`.
    Bool,
    /// One of the listed ids.
    Choice {
        /// The options.
        options: &'static [Choice],
    },
    /// Text of at most this many characters.
    Text {
        /// Most characters allowed.
        max_chars: usize,
    },
    /// A depth profile: at most 64 pairs, positions ascending, both within 0 and the bounds.
    Steps {
        /// Largest position allowed, in mm.
        max_position_mm: f64,
        /// Largest depth allowed, in mm.
        max_depth_mm: f64,
    },
    /// Straight cuts: at most 16, each of at most 32 sections.
    Cuts {
        /// Largest length of a section, in mm.
        max_length_mm: f64,
        /// Largest depth allowed, in mm; walls lie between minus and plus this.
        max_depth_mm: f64,
    },
    /// At most 16 finite real numbers within the range: one for each cut.
    Numbers {
        /// Least value allowed.
        min: f64,
        /// Largest value allowed.
        max: f64,
    },
    /// The three networks of UNKS as text, or none.
    Networks,
}

impl Kind {
    /// What is allowed, in words, with the unit.
    #[must_use]
    pub fn allowed(&self, unit: &str) -> String {
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        match self {
            Self::Float { min, max } => format!("a number from {min} to {max}{unit}"),
            Self::Int { min, max } => format!("a whole number from {min} to {max}{unit}"),
            Self::Bool => "true or false".to_owned(),
            Self::Choice { options } => {
                let ids: Vec<&str> = options.iter().map(|option| option.id).collect();
                format!("one of {}", ids.join(", "))
            }
            Self::Text { max_chars } => format!("text of at most {max_chars} characters"),
            Self::Steps { max_position_mm, max_depth_mm } => format!(
                "at most {MAX_STEPS} pairs [position mm, depth mm], positions ascending from 0 to \
                 {max_position_mm}, depths from 0 to {max_depth_mm}"
            ),
            Self::Cuts { max_length_mm, max_depth_mm } => format!(
                "at most {MAX_CUTS} cuts of 1 to {MAX_SECTIONS} sections [length mm, axial depth mm, \
                 wall mm], lengths from {MIN_SECTION_MM} to {max_length_mm}, depths from 0 to \
                 {max_depth_mm}, walls from -{max_depth_mm} to {max_depth_mm}"
            ),
            Self::Numbers { min, max } => {
                format!("at most {MAX_CUTS} numbers, one for each cut, from {min} to {max}{unit}")
            }
            Self::Networks => "nothing, or the text of a file that `steadycut unks --save` \
                               writes: finite weights of NM-R 2-12-1, NM-1 4-8-1, NM-2 4-8-1"
                .to_owned(),
        }
    }
}

/// Most pairs in a depth profile.
pub const MAX_STEPS: usize = 64;
/// Most straight cuts.
pub const MAX_CUTS: usize = 16;
/// Most sections of a cut.
pub const MAX_SECTIONS: usize = 32;
/// Shortest section, mm.
pub const MIN_SECTION_MM: f64 = 0.1;

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

/// Why a setting was refused; the text names field, value and what is allowed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SettingError {
    /// No setting has this path.
    #[error("unknown setting `{path}`; {}", instead(suggestion.as_deref()))]
    Unknown {
        /// The path given.
        path: String,
        /// The nearest known path.
        suggestion: Option<String>,
    },
    /// The value does not fit.
    #[error("`{path}` cannot be {value}: allowed is {allowed}")]
    Refused {
        /// The setting's path.
        path: String,
        /// The value given.
        value: String,
        /// What is allowed.
        allowed: String,
    },
    /// The text is not in the expected format.
    #[error("{what}: {problem}")]
    Format {
        /// What was read (a file, a link, an argument).
        what: String,
        /// What is wrong with it.
        problem: String,
    },
}

/// What to do about an unknown setting.
fn instead(near: Option<&str>) -> String {
    near.map_or_else(
        || "`steadycut list` prints all settings".to_owned(),
        |near| format!("did you mean `{near}`?"),
    )
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
        let x = match value {
            Value::Float(x) => *x,
            Value::Int(x) => *x as f64,
            _ => return None,
        };
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
            _ => return None,
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
        match value {
            Value::Bool(x) => Some(*x),
            _ => None,
        }
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

impl Field for Vec<DepthStep> {
    fn kind(min: f64, max: f64) -> Kind {
        // The macro's range reads `max_depth..=max_position` for profiles.
        Kind::Steps { max_position_mm: max, max_depth_mm: min }
    }
    fn to_value(&self) -> Value {
        Value::Steps(self.clone())
    }
    fn from_value(value: &Value, kind: &Kind) -> Option<Self> {
        let (Value::Steps(steps), Kind::Steps { max_position_mm, max_depth_mm }) = (value, kind)
        else {
            return None;
        };
        let in_range = steps.iter().all(|[position, depth]| {
            (0.0..=*max_position_mm).contains(position) && (0.0..=*max_depth_mm).contains(depth)
        });
        let ascending = steps.windows(2).all(|pair| pair[0][0] < pair[1][0]);
        (in_range && ascending && steps.len() <= MAX_STEPS).then(|| steps.clone())
    }
}

impl Field for Vec<Vec<Section>> {
    fn kind(min: f64, max: f64) -> Kind {
        // The macro's range reads `max_depth..=max_length` here.
        Kind::Cuts { max_length_mm: max, max_depth_mm: min }
    }
    fn to_value(&self) -> Value {
        Value::Cuts(self.clone())
    }
    fn from_value(value: &Value, kind: &Kind) -> Option<Self> {
        let Kind::Cuts { max_length_mm, max_depth_mm } = kind else { return None };
        let cuts = match value {
            Value::Cuts(cuts) => cuts.clone(),
            // An empty list reads as an empty profile too.
            Value::Steps(steps) if steps.is_empty() => Self::new(),
            _ => return None,
        };
        let fits = |[length, depth, wall]: &Section| {
            (MIN_SECTION_MM..=*max_length_mm).contains(length)
                && (0.0..=*max_depth_mm).contains(depth)
                && (-max_depth_mm..=*max_depth_mm).contains(wall)
        };
        let cut_fits =
            |cut: &Vec<Section>| (1..=MAX_SECTIONS).contains(&cut.len()) && cut.iter().all(fits);
        (cuts.len() <= MAX_CUTS && cuts.iter().all(cut_fits)).then_some(cuts)
    }
}

impl Field for Vec<f64> {
    fn kind(min: f64, max: f64) -> Kind {
        Kind::Numbers { min, max }
    }
    fn to_value(&self) -> Value {
        Value::Numbers(self.clone())
    }
    fn from_value(value: &Value, kind: &Kind) -> Option<Self> {
        let Kind::Numbers { min, max } = kind else { return None };
        let numbers = match value {
            Value::Numbers(numbers) => numbers,
            // An empty list reads as an empty profile too.
            Value::Steps(steps) if steps.is_empty() => return Some(Self::new()),
            _ => return None,
        };
        let fit = numbers.iter().all(|x| (*min..=*max).contains(x));
        (fit && numbers.len() <= MAX_CUTS).then(|| numbers.iter().map(|x| x + 0.0).collect())
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

/// Declares a settings struct: `name: type = default, min..=max, "unit", live|setup, "Label";`
/// with the documentation as doc comment. For choices and switches the range is `..`.
#[macro_export]
macro_rules! settings {
    (
        $(#[doc = $sdoc:literal])+
        pub struct $name:ident {
            $(
                $(#[doc = $doc:literal])+
                $field:ident : $ty:ty = $default:expr, [$($min:expr, $max:expr)?], $unit:literal, $live:ident, $label:literal;
            )*
        }
    ) => {
        $(#[doc = $sdoc])+
        #[derive(Clone, Debug, PartialEq)]
        pub struct $name {
            $( $(#[doc = $doc])+ pub $field: $ty, )*
        }

        impl Default for $name {
            fn default() -> Self {
                Self { $( $field: $default, )* }
            }
        }

        impl $crate::base::settings::Group for $name {
            fn specs() -> Vec<$crate::base::settings::Spec> {
                use $crate::base::settings::{Field, Spec};
                let default = Self::default();
                vec![ $( Spec {
                    key: stringify!($field),
                    label: $label,
                    unit: $unit,
                    doc: concat!($($doc),+).trim_ascii_start(),
                    allowed: <$ty as Field>::kind($crate::settings!(@min $($min)?), $crate::settings!(@max $($max)?)),
                    default: default.$field.to_value(),
                    live: $crate::settings!(@live $live),
                }, )* ]
            }
            fn get(&self, key: &str) -> Option<$crate::base::settings::Value> {
                use $crate::base::settings::Field;
                match key {
                    $( stringify!($field) => Some(self.$field.to_value()), )*
                    _ => None,
                }
            }
            fn set(
                &mut self,
                key: &str,
                value: &$crate::base::settings::Value,
                kind: &$crate::base::settings::Kind,
            ) -> Option<()> {
                use $crate::base::settings::Field;
                match key {
                    $( stringify!($field) => self.$field = <$ty as Field>::from_value(value, kind)?, )*
                    _ => return None,
                }
                Some(())
            }
        }
    };
    (@min) => { 0.0 };
    (@min $min:expr) => { $min };
    (@max) => { 0.0 };
    (@max $max:expr) => { $max };
    (@live live) => { true };
    (@live setup) => { false };
}

/// Declares a closed choice: an enum whose variants have an id, a label and a documentation.
#[macro_export]
macro_rules! choice {
    (
        $(#[doc = $edoc:literal])+
        pub enum $name:ident {
            $( $(#[doc = $doc:literal])+ $variant:ident = $id:literal, $label:literal; )+
        }
    ) => {
        $(#[doc = $edoc])+
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum $name {
            $( $(#[doc = $doc])+ $variant, )+
        }

        $crate::choice!(@options $name {
            $( $variant = $id, $label, concat!($($doc),+).trim_ascii_start(); )+
        });
    };
    // What an enum of these variants can do as a choice.
    (@options $name:ident { $( $variant:ident = $id:literal, $label:literal, $doc:expr; )+ }) => {
        impl $name {
            /// All options with their ids and labels, in the order of [`Self::ALL`].
            pub const OPTIONS: &'static [$crate::base::settings::Choice] = &[
                $( $crate::base::settings::Choice {
                    id: $id,
                    label: $label,
                    doc: $doc,
                }, )+
            ];
            /// All variants.
            pub const ALL: &'static [Self] = &[ $( Self::$variant, )+ ];

            /// Its name in files and on the command line.
            #[must_use]
            pub fn id(self) -> &'static str {
                match self { $( Self::$variant => $id, )+ }
            }
            /// Its name for people.
            #[must_use]
            pub fn label(self) -> &'static str {
                match self { $( Self::$variant => $label, )+ }
            }
            /// The variant with this id.
            #[must_use]
            pub fn from_id(id: &str) -> Option<Self> {
                match id { $( $id => Some(Self::$variant), )+ _ => None }
            }
        }

        impl $crate::base::settings::Field for $name {
            fn kind(_: f64, _: f64) -> $crate::base::settings::Kind {
                $crate::base::settings::Kind::Choice { options: Self::OPTIONS }
            }
            fn to_value(&self) -> $crate::base::settings::Value {
                $crate::base::settings::Value::Text(self.id().to_owned())
            }
            fn from_value(
                value: &$crate::base::settings::Value,
                _: &$crate::base::settings::Kind,
            ) -> Option<Self> {
                match value {
                    $crate::base::settings::Value::Text(id) => Self::from_id(id),
                    _ => None,
                }
            }
        }
    };
}
