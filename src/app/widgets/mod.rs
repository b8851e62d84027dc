//! Widgets that several screens use.

pub mod chart;
mod curves;
pub mod icon;
pub mod legend;
pub mod number;
mod reading;
pub mod setting;
pub mod target;
pub mod window;
pub mod zoom;
