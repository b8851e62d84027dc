//! Sensing: the force sensors, and the tool-condition estimator that evaluates the sound.

pub mod dynamometer;
pub mod force_sensor;
pub mod peak;
pub mod tool_condition;
