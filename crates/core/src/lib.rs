#![doc = include_str!("lib.md")]
#![forbid(unsafe_code)]
#![warn(missing_docs)]
// A new choice must be found by the compiler wherever it matters.
#![deny(clippy::wildcard_enum_match_arm)]

pub mod base;

pub mod models;

pub mod blocks;

pub mod run;
