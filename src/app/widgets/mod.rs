//! Widgets that several screens use.

pub mod chart;
pub mod icon;
pub mod legend;
pub mod number;
pub mod plot;
pub mod scaffold;
pub mod setting;
pub mod target;
pub mod window;
pub mod zoom;
