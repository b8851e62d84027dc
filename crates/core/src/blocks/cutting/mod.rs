//! Cutting, the plant: the true force of the cut, as opposed to what a controller believes.
//!
//! [`process`] computes the force in the way that [`force_model`] chooses; [`tool_path`] and [`workpiece`]
//! give the depth at the tool, [`crash`] what cannot be cut, [`material`] and [`wear`] factors on the force, [`disturbance`] its dynamic
//! component.

pub mod breakage;
pub mod contact;
pub mod crash;
pub mod disturbance;
pub mod field;
pub mod force_model;
pub mod material;
pub mod milling;
pub mod neural;
pub mod process;
pub mod surface_left;
pub mod tool_path;
pub mod wear;
pub mod workpiece;
