//! Many runs of the loop in `steadycut-core`, and what is made of them.
//!
//! | question | module |
//! | --- | --- |
//! | Which controller is better on the same part with the same noise? | [`compare`] |
//! | How does one controller do on plants drawn at random? | [`robust`] |
//! | Do the published tables come out of runs in time? | [`papers`], [`papers_2019`], [`published`] |
//! | What is wrong with what was printed? | [`errata`], [`errata_2019`] |
//! | Where do the shipped models and networks come from? | [`identify`], [`mod@train`] |
//! | Which cuts should be made to identify models, and what can they tell? | [`experiment`] |
//! | Which feed and speed should be programmed? | [`plan`], [`recommend`], [`combined`] |
//! | Which constant feed keeps the tolerance everywhere? | [`safe_feed`] |
//! | Does the machine chatter, and how does its tool age? | [`stability`], [`machine_life`], [`sound`] |
//! | What does UNKS learn from pass to pass? | [`unks_passes`] |
//! | What does adaptive feed control learn from the first part, and what does it gain? | [`afc`] |
//! | How rough is the machined surface? | [`profilometer`] |
//! | How does a part of one's own get into a run, from a table or from G-code? | [`part`] |
//! | What is in a folder of one's own? | [`library`] |
//! | Has a learner reached the goal of a lesson? | [`mission`] |
//! | What does a link open, and what of the program is shown then? | [`opening`] |
//! | Are the bits the same here as elsewhere? | [`golden`] |
//! | Which command and screen uses which setting? | [`uses`] |
//! | How does a run get into a spreadsheet, and a table out of one? | [`export`], [`csv_table`] |
//! | What does a formula make of a table? | [`formula_table`] |
//! | Where in a run can a formula stand? | [`formula_place`] |
//! | How does a measured channel lie over a signal of a run? | [`over_run`], [`channel_unit`] |
//!
//! One run is `steadycut_core`: dead time, controllers and plant are there, in `blocks`.

#![forbid(unsafe_code)]
#![warn(missing_docs)]
// A new choice must be found by the compiler wherever it matters.
#![deny(clippy::wildcard_enum_match_arm)]

// The layers below, under the names that they have in the whole project.
pub use steadycut_core::{base, blocks, models, run};
pub use steadycut_measured as measured;

pub mod afc;
pub mod channel_unit;
pub mod combined;
pub mod compare;
pub mod csv_table;
pub mod errata;
pub mod errata_2019;
pub mod experiment;
pub mod export;
pub mod formula_place;
pub mod formula_table;
pub mod golden;
pub mod identify;
pub mod library;
pub mod machine_life;
pub mod mission;
pub mod opening;
pub mod over_run;
pub mod own_file;
pub mod papers;
pub mod papers_2019;
pub mod part;
pub mod plan;
pub mod profilometer;
pub mod published;
pub mod recommend;
pub mod robust;
pub mod safe_feed;
pub mod sound;
pub mod stability;
pub mod train;
pub mod unks_passes;
pub mod uses;
pub mod verdict;
