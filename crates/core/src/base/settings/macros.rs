//! The declarations of settings structs and of closed choices.

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

/// Declares a closed choice: an enum whose variants have an id, a label and a documentation. As JSON it
/// is its id.
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

        impl serde::Serialize for $name {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_str(self.id())
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
                let $crate::base::settings::Value::Text(id) = value else { return None };
                Self::from_id(id)
            }
        }
    };
}
