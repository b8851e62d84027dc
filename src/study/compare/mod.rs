//! Ways of control against each other: the same part and the same noise seeds for all of them.
//!
//! [`tournament`] is the job, [`entrants`] the list of who takes part, [`outcome`] what a run is
//! judged by; [`table_1`] sets the six methods of 2005 beside the printed table.

pub mod claims;
pub mod cost;
pub mod entrants;
pub mod load_step;
pub mod outcome;
pub mod robustness;
pub mod sections;
pub mod table_1;
pub mod tournament;
