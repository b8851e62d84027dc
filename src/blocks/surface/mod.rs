//! The surface: produced roughness from force.

pub mod roughness;
