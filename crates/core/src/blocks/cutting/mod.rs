//! Cutting: workpiece, material and the force of the cut.

pub mod contact;
pub mod disturbance;
pub mod field;
pub mod force_model;
pub mod material;
pub mod milling;
pub mod neural;
pub mod process;
pub mod tool_path;
pub mod wear;
pub mod workpiece;
