//! The machine in the running cut.

pub mod coupled;
pub mod response;
