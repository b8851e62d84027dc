//! One run: a pure function of a scenario (with its seed) and its edits.
//!
//! A [`scenario`] goes in, from a file, a link or [`presets`], with [`edits`] for what changes on the way;
//! [`one_run`] advances the [`closed_loop`] and keeps a [`recording`], from which [`metrics`] and the
//! [`digest`] come.

pub mod against_twin;
pub mod closed_loop;
pub mod constant_feed_twin;
pub mod diagram;
pub mod digest;
pub mod edits;
pub mod end;
pub mod explanation;
pub mod glossary;
pub mod job;
pub mod met_disturbances;
pub mod metrics;
pub mod one_run;
pub mod packed;
pub mod parts;
pub mod presets;
pub mod recording;
pub mod revolution;
pub mod run_to;
pub mod scenario;
pub mod scenario_file;
pub mod scenario_link;
pub mod signals;
pub mod story;
pub mod tooth_marks;

/// What a console opens with.
#[derive(Clone, Debug)]
pub struct Start {
    /// The scenario.
    pub scenario: scenario::Scenario,
    /// Its edits.
    pub edits: edits::Edits,
    /// What went wrong on the way here (a bad link, for example), to be shown.
    pub notice: Option<String>,
}
