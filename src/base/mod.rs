//! What every layer needs and nothing of milling: math, units, random numbers, settings, and the
//! pure model functions that plant and controller share.

pub mod fft;
pub mod math;
pub mod model;
pub mod network;
pub mod rng;
pub mod settings;
pub mod units;
