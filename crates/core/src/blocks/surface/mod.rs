//! The surface: produced roughness from force, and the machined surface point by point.

pub mod finish;
pub mod produced;
pub mod profile;
pub mod roughness;
pub mod topography;
