//! What every layer needs and nothing of milling: math, units, random numbers, networks, settings.

pub mod cholesky;
pub mod column_unit;
pub mod crc32;
pub mod dense;
pub mod equation;
pub mod fft;
pub mod files;
pub mod formula;
pub mod language;
pub mod math;
pub mod network;
pub mod rng;
pub mod settings;
pub mod stats;
pub mod text;
pub mod units;
pub mod window;
