//! Ways of control against each other: the same part and the same noise seeds for all of them.
//!
//! [`tournament`] is the job, [`contest`] the same after a load step, [`entrants`] the list of who takes
//! part, [`outcome`] what a run is judged by, [`spread`] what the seeds make of it. [`table_1`] sets the
//! six methods of 2005 beside the printed table, [`claims`] what the paper says beside what is found,
//! [`robustness`] changes the conditions; [`load_step`], [`iterations`] and [`cost`] are three meanings
//! of the paper's optimisation step. [`by_hand`] scores a cut driven by hand against everybody.

pub mod beyond;
pub mod by_hand;
pub mod claims;
pub mod contest;
pub mod cost;
pub mod entrants;
pub mod iterations;
pub mod load_step;
pub mod outcome;
pub mod outside;
pub mod robustness;
pub mod sections;
pub mod spread;
pub mod table_1;
pub mod tournament;
