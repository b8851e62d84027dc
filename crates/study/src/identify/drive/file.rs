//! The file of a drive that was identified: versioned TOML.

use std::fmt::Write;

use super::DriveFit;
use crate::identify::estimate::EstimatedValue;

/// Version of the format.
const VERSION: u32 = 1;

/// The text of a drive's file: gain, poles and dead time, with their 95 % intervals and what is left.
#[must_use]
pub fn drive_file(fit: &DriveFit, source: &str, samples: usize) -> String {
    let mut text = String::new();
    let quoted = |text: &str| toml::Value::String(text.to_owned()).to_string();
    let poles: Vec<String> =
        fit.poles.iter().map(|[real, imaginary]| format!("[{real:?}, {imaginary:?}]")).collect();
    let half = |x: &EstimatedValue| x.half.map_or("inf".to_owned(), |half| format!("{half:?}"));
    // Into memory: it does not fail.
    let _ = write!(
        text,
        "# A feed drive: gain e^(-dead_time_s s) / product of (1 - s/pole), poles in rad/s as [real, imaginary].\n\
         version = {VERSION}\n\
         source = {}\n\
         structure = {}\n\
         gain = {:?}\n\
         dead_time_s = {:?}\n\
         poles = [{}]\n\n\
         # Halves of the 95 % intervals, and what is left in the unit of the feed (root mean square).\n\
         [fit]\n\
         samples = {samples}\n\
         gain_half = {}\n\
         dead_time_half_s = {}\n\
         lag_s = {:?}\n\
         lag_half_s = {}\n\
         rest = {:?}\n\
         aic = {:?}\n\
         bic = {:?}\n",
        quoted(source),
        quoted(fit.structure.id()),
        fit.gain.value,
        fit.dead_time_s.value,
        poles.join(", "),
        half(&fit.gain),
        half(&fit.dead_time_s),
        fit.lag_s.value,
        half(&fit.lag_s),
        fit.rest,
        fit.aic,
        fit.bic
    );
    text
}
