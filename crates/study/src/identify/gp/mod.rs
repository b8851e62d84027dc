//! Formulas found by genetic programming (symbolic regression): `steadycut identify gp`.
//!
//! | step | module |
//! | --- | --- |
//! | What is asked, and whether the rows can tell it | [`problem`] |
//! | The formulas of the search: sums of products of small parts | [`node`], [`tidy`] |
//! | Their values and derivatives over rows | [`evaluate`], [`lanes`] |
//! | Their constants: least squares, Levenberg and Marquardt | [`fit`] |
//! | Where they come from: families of curves, draws, variation | [`families`], [`draw`], [`vary`] |
//! | Which survive, island by island and size by size | [`archive`], [`breed`], [`search`] |
//! | How they do on rows left out | [`folds`] |
//! | Formulas as people write them, constants with intervals | [`written`], [`constants`] |
//! | The papers' own search, beside | [`paper`] |
//! | A formula of the front as a model file, with its band | [`model`], [`band`] |
//! | What a screen shows of a table and of a formula | [`columns`], [`inspect`] |
//! | Formulas of which a part is known | [`template`] |
//! | What is told: front, choice, range, outliers | [`report`], [`range`], [`outliers`] |
//! | What is told on the way | [`standing`], [`watched`] |
//!
//! A search is a job ([`job`]): offspring are pure functions of (seed, batch, number) and the survivors before
//! the batch, so that threads, slices and pauses do not show in the bits.

pub mod archive;
pub mod band;
pub mod breed;
pub mod columns;
pub mod constants;
pub mod declared;
pub mod draw;
pub mod evaluate;
pub mod families;
pub mod fit;
pub mod folds;
pub mod inspect;
pub mod job;
pub mod lanes;
pub mod model;
pub mod node;
pub mod outliers;
pub mod paper;
pub mod problem;
pub mod range;
pub mod report;
pub mod rows;
pub mod search;
pub mod standing;
pub mod state;
pub mod template;
pub mod tidy;
pub mod units;
pub mod vary;
pub mod watched;
pub mod written;
