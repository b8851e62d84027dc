//! Cutting: workpiece, material and the force of the cut.

pub mod material;
pub mod neural;
pub mod process;
pub mod tool;
pub mod workpiece;
