//! What a controller costs per update: its inputs of a run, to be given to it again and again. The
//! clock is the front end's.

use super::load_step;
use crate::blocks::control::{ControlInput, Controller, FeedSpeed};
use crate::models::genetic::GeneticModels;
use crate::models::part::APPROACH_MM;
use crate::run::closed_loop::limits;
use crate::run::edits::Edits;
use crate::run::one_run::Run;
use crate::run::scenario::Scenario;
use crate::run::signals::Row;

/// A controller's inputs over the load step.
#[derive(Clone, Debug)]
pub struct Replay {
    scenario: Scenario,
    programmed: FeedSpeed,
    models: GeneticModels,
    /// Measured force in N, the command applied before and the place along the one cut in mm, once
    /// in a control period.
    samples: Vec<(f64, FeedSpeed, f64)>,
}

impl Replay {
    /// The inputs of an entrant's controller over the load step.
    #[must_use]
    pub fn new(entrant: &Scenario) -> Self {
        let scenario = load_step::scenario(entrant);
        let run = Run::complete(&scenario, &Edits::none());
        let recording = run.recording();
        let rows = recording.samples(usize::MAX);
        let sample = |row: &Row| {
            let applied = FeedSpeed {
                feed_mm_min: row.feed_command_mm_min,
                speed_rpm: row.spindle_command_rpm,
            };
            (row.force_measured_n, applied, row.position_mm - APPROACH_MM)
        };
        Self {
            programmed: FeedSpeed {
                feed_mm_min: scenario.program.feed_mm_min,
                speed_rpm: scenario.program.spindle_rpm,
            },
            models: scenario.believed(),
            samples: rows.map(sample).collect(),
            scenario,
        }
    }

    /// Number of updates of a pass.
    #[must_use]
    pub fn updates(&self) -> usize {
        self.samples.len()
    }

    /// A fresh controller over all inputs; gives the sum of the feeds asked for in mm/min, so that
    /// nothing of it can be left out.
    #[must_use]
    pub fn pass(&self) -> f64 {
        let mut controller = Controller::new(&self.scenario.control_setup(), self.programmed);
        let limits = limits(&self.scenario, 0);
        let update = |(force_measured_n, applied, x_mm): &(f64, FeedSpeed, f64)| {
            let output = controller.update(&ControlInput {
                force_measured_n: *force_measured_n,
                force_ref_n: self.scenario.target.force_n,
                programmed: self.programmed,
                applied: *applied,
                limits,
                models: &self.models,
                cut: 0,
                x_mm: *x_mm,
                by_hand: 1.0,
            });
            output.request.feed_mm_min
        };
        self.samples.iter().map(update).sum()
    }
}
