#![doc = include_str!("lib.md")]
#![forbid(unsafe_code)]
#![warn(missing_docs)]

pub mod base;

pub mod models;

pub mod blocks;

pub mod run;
