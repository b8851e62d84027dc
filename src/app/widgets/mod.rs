//! Widgets that several screens use.

pub mod chart;
mod curves;
pub mod icon;
pub mod legend;
pub mod setting;
pub mod target;
