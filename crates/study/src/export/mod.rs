//! Exports of a run to any writer.

pub mod csv;
