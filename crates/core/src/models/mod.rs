//! Pure model functions that both the plant (truth) and the controllers (belief) need.

pub mod disturbances;
pub mod drive_curve;
pub mod economics;
pub mod feed_drive;
pub mod feed_speed;
pub mod formula_model;
pub mod genetic;
pub mod machine_trend;
pub mod mechanistic;
pub mod neural_force;
pub mod part;
pub mod plan;
pub mod printed;
pub mod roughness_profile;
pub mod roughness_trend;
pub mod spindle;
pub mod structure;
pub mod tip_modes;
pub mod tool;
pub mod tool_life;
pub mod transfer;
pub mod unks;
pub mod wear;

/// A model's answer and whether its input lay inside the model's range of validity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Valued {
    /// The answer; finite also outside the range (the model is continued, see each model).
    pub value: f64,
    /// `false` where the model was continued beyond its range.
    pub valid: bool,
}

impl Valued {
    /// An answer inside the range if `valid`.
    #[must_use]
    pub fn new(value: f64, valid: bool) -> Self {
        Self { value, valid }
    }
}
