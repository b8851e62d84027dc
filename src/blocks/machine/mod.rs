//! The machine in the running cut.

pub mod response;
