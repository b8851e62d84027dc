//! Widgets that several screens use.

pub mod beside;
pub mod chart;
pub mod drop;
pub mod focus;
pub mod icon;
pub mod knob;
pub mod legend;
pub mod my_files;
pub mod number;
pub mod plot;
pub mod save_table;
pub mod scaffold;
pub mod setting;
pub mod spoken;
pub mod standing;
pub mod strip;
pub mod target;
pub mod touch;
pub mod window;
pub mod zoom;
