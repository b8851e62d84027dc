#![doc = include_str!("lib.md")]
#![forbid(unsafe_code)]
#![warn(missing_docs)]

pub mod base;

pub mod blocks;

pub mod run;

pub mod study;

#[cfg(not(target_arch = "wasm32"))]
pub mod cli;

#[cfg(feature = "app")]
pub mod app;
