//! Many runs, and what is made of them: identification, published tables against runs, exports.

#![forbid(unsafe_code)]
#![warn(missing_docs)]

// The layers below, under the names that they have in the whole project.
pub use steadycut_core::{base, blocks, models, run};

pub mod combined;
pub mod compare;
pub mod errata;
pub mod errata_2019;
pub mod export;
pub mod golden;
pub mod identify;
pub mod machine_life;
pub mod papers;
pub mod papers_2019;
pub mod plan;
pub mod profilometer;
pub mod published;
pub mod recommend;
pub mod robust;
pub mod sound;
pub mod stability;
pub mod train;
pub mod unks_passes;
