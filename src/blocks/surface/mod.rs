//! The surface: produced roughness from force.

pub mod profile;
pub mod roughness;
