//! Exports of a run, and of tables of results.

pub mod csv;
pub mod sheet;
