//! SteadyCut: the simulator's layers under one name, with its two front ends, command line and
//! console. The simulation itself is [`steadycut_core`], many runs are [`steadycut_study`], measured data
//! [`steadycut_measured`].

#![forbid(unsafe_code)]
#![warn(missing_docs)]
// A new command, screen, controller or force model must be met wherever there is a choice of them.
#![deny(clippy::wildcard_enum_match_arm)]

pub use steadycut_core::{base, blocks, models, run};
pub use steadycut_measured as measured;
pub use steadycut_study as study;

#[cfg(not(target_arch = "wasm32"))]
pub mod cli;

#[cfg(not(target_arch = "wasm32"))]
pub mod disk;

#[cfg(feature = "app")]
pub mod app;
