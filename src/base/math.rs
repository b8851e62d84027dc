//! Transcendental functions with the same bits natively and in wasm.
//!
//! std's `exp`, `ln`, `pow`, `sin` come from the platform and differ in the last bit between
//! targets; `libm` is compiled from the same source everywhere. The pure layers take these
//! functions from here only (`clippy.toml` holds that). `sqrt`, `abs`, `floor` and the four
//! operations are exact by IEEE 754 and may be used from std.

pub use libm::{exp, log as ln, pow, sin};

/// Euler's number, e.
pub const E: f64 = std::f64::consts::E;
/// Half a turn, in radians.
pub const PI: f64 = std::f64::consts::PI;
/// A full turn, in radians.
pub const TAU: f64 = std::f64::consts::TAU;

/// Limits `x` to `low..=high`; unlike [`f64::clamp`] it never panics: with `low > high` it gives
/// `high`, and NaN gives `low`. By comparison, since `f64::max` may return either of two zeros.
#[must_use]
#[inline]
pub fn limit(x: f64, low: f64, high: f64) -> f64 {
    let x = if x >= low { x } else { low };
    if x > high { high } else { x }
}

/// `x` where it is positive, otherwise (also for NaN and -0) exactly +0.
#[must_use]
#[inline]
pub fn positive(x: f64) -> f64 {
    if x > 0.0 { x } else { 0.0 }
}
