//! The surface: produced roughness from force.

pub mod finish;
pub mod profile;
pub mod roughness;
