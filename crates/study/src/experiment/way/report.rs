//! What is told of the way.

use serde::Serialize;

use super::super::measure::MeasuredCut;
use super::models::{FoundModel, take};
use super::pilot::PilotResult;
use super::rows::{ENTRANTS, ModelSource, WayRow};
use super::{WayPlant, WaySettings};
use crate::run::digest::Digest;

/// How far an entrant holds Ra over the rows.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct EntrantSummary {
    /// The controller.
    pub controller: &'static str,
    /// Whose models.
    pub models: ModelSource,
    /// Largest deviation of Ra, percent, without its sign; none where a row has no Ra.
    pub worst_percent: Option<f64>,
    /// Root mean square of the deviations, percent; likewise.
    pub rms_percent: Option<f64>,
    /// Rows without Ra: the force lies below what the plant's model knows, or nothing was cut.
    pub without_ra: usize,
    /// Rows in which the force still swings at the end.
    pub swinging: usize,
    /// Rows outside the ranges that the models were found on.
    pub outside: usize,
}

/// What is told of the way.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WayReport {
    /// How it was gone.
    pub settings: WaySettings,
    /// What gives the force.
    pub plant: WayPlant,
    /// What the truth is, in words.
    pub truth: String,
    /// Depths of all cuts, axial and radial, mm.
    pub depths_mm: [f64; 2],
    /// What pilot cuts have found.
    pub pilot: Option<PilotTold>,
    /// Ranges of feed in mm/min and speed in 1/min.
    pub cut_box: Option<[[f64; 2]; 2]>,
    /// Name of the plan.
    pub plan: Option<String>,
    /// Cuts that were measured so far.
    pub measured: usize,
    /// Those of which something could not be measured, with why.
    pub unmeasured: Vec<(usize, String)>,
    /// The models.
    pub models: Vec<FoundModel>,
    /// The rows.
    pub rows: Vec<WayRow>,
    /// How far each entrant holds Ra.
    pub summary: Vec<EntrantSummary>,
    /// XXH3 over what was measured, the models and the final values of all rows, to the bit.
    pub digest: String,
}

/// Pilot cuts as they are told.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PilotTold {
    /// Number of pilot cuts.
    pub cuts: usize,
    /// Axial depth, mm.
    pub axial_depth_mm: f64,
}

impl From<PilotResult> for PilotTold {
    fn from(found: PilotResult) -> Self {
        Self { cuts: found.cuts, axial_depth_mm: found.axial_depth_mm }
    }
}

/// How far each entrant holds Ra over rows that are done.
#[must_use]
pub fn summary(rows: &[WayRow]) -> Vec<EntrantSummary> {
    let of = |(place, (controller, models)): (usize, &(_, ModelSource))| {
        let controller: &crate::blocks::control::ControllerKind = controller;
        let outcomes = || rows.iter().filter_map(move |row| row.outcomes.get(place));
        let deviations: Option<Vec<f64>> =
            outcomes().map(|outcome| outcome.ra_deviation_percent).collect();
        let deviations = deviations.filter(|all| !all.is_empty());
        let rms =
            |all: &Vec<f64>| (all.iter().map(|x| x * x).sum::<f64>() / all.len() as f64).sqrt();
        EntrantSummary {
            controller: controller.id(),
            models: *models,
            worst_percent: deviations
                .as_ref()
                .map(|all| all.iter().fold(0.0, |worst: f64, x| worst.max(x.abs()))),
            rms_percent: deviations.as_ref().map(rms),
            without_ra: outcomes().filter(|outcome| outcome.ra_um.is_none()).count(),
            swinging: outcomes().filter(|outcome| outcome.swings()).count(),
            outside: outcomes().filter(|outcome| outcome.within == Some(false)).count(),
        }
    };
    ENTRANTS.iter().enumerate().map(of).collect()
}

/// The digest of what is told.
#[must_use]
pub fn digest(cuts: &[MeasuredCut], models: &[FoundModel], rows: &[WayRow]) -> String {
    let mut digest = Digest::default();
    let bits = |value: Option<f64>| value.unwrap_or(f64::NAN).to_bits();
    for cut in cuts {
        [cut.force_n, cut.ra_um].into_iter().for_each(|value| digest.word(bits(value)));
    }
    models.iter().for_each(|found| take(&mut digest, found));
    for outcome in rows.iter().flat_map(|row| &row.outcomes) {
        let values =
            [outcome.ra_um, outcome.force_n, Some(outcome.feed_mm_min), Some(outcome.speed_rpm)];
        values.into_iter().for_each(|value| digest.word(bits(value)));
    }
    digest.hex()
}
