//! The sections of Experiments 1 and 2 as static cuts: their peak forces at 100 % override beside
//! the reference figures, and what the height of the slices does to them.

use serde::Serialize;

use crate::base::units::percent_from_ratio;
use crate::models::mechanistic::{CK45, Cutter, Kienzle, StaticCut, static_peak};
use crate::models::tool::Tool;

/// Feed per tooth of both experiments, mm.
const FEED_PER_TOOTH_MM: f64 = 0.08;
/// Run-out of both experiments, mm.
const RUNOUT_MM: f64 = 0.003;
/// Slices of the simulator and of the reference figures, mm.
pub const SLICE_MM: f64 = 0.25;
/// The two thinnest slices, from which the limit is drawn as a line, mm.
const THIN_MM: [f64; 2] = [0.05, 0.025];

/// Experiment, axial depth and wall in mm, peak force in N of an independent implementation of the
/// same model with the same slices.
pub const REFERENCE: [(u32, f64, f64, f64); 13] = [
    (1, 2.0, 1.2915, 453.0),
    (1, 2.4, 1.2915, 551.0),
    (1, 2.8, 1.2915, 648.0),
    (2, 2.6, 2.0, 493.0),
    (2, 3.0, 2.0, 582.0),
    (2, 4.75, 0.0, 1373.0),
    (2, 2.75, 2.0, 527.0),
    (2, 2.4, 2.5, 373.0),
    (2, 2.6, 2.5, 416.0),
    (2, 2.7, 1.5, 588.0),
    (2, 3.25, 0.0, 957.0),
    (2, 2.25, 1.5, 485.0),
    (2, 3.5, 1.5, 772.0),
];

/// A section as a static cut.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ComparedSection {
    /// Experiment 1 or 2.
    pub experiment: u32,
    /// Axial depth A_D, mm.
    pub axial_depth_mm: f64,
    /// Side wall's place y_e from the tool's axis, mm.
    pub wall_mm: f64,
    /// Nominal radial depth R_D, mm.
    pub radial_depth_mm: f64,
    /// Reference peak force, N.
    pub reference_n: f64,
    /// Peak force with the simulator's slices, N.
    pub force_n: f64,
    /// Peak force in the limit of thin slices over that, percent.
    pub limit_percent: f64,
}

/// Every section.
#[must_use]
pub fn table() -> Vec<ComparedSection> {
    REFERENCE.iter().map(|row| section(*row, true)).collect()
}

fn section(
    (experiment, axial_depth_mm, wall_mm, reference_n): (u32, f64, f64, f64),
    with_limit: bool,
) -> ComparedSection {
    let tool = Tool::default();
    let law = Kienzle::new(&CK45, 80.0, tool.rake_deg, CK45.hardness_hb);
    let cutter = |slice_mm: f64| Cutter::new(&tool, RUNOUT_MM, slice_mm);
    let radial_depth_mm = cutter(SLICE_MM).radius_mm(axial_depth_mm) - wall_mm;
    let cut = StaticCut { feed_per_tooth_mm: FEED_PER_TOOTH_MM, axial_depth_mm, radial_depth_mm };
    let peak_n = |slice_mm: f64| static_peak(&cutter(slice_mm), &law, &cut).fxy_n;
    let force_n = peak_n(SLICE_MM);
    let limit_n = if with_limit {
        let [thin, thinnest] = THIN_MM.map(peak_n);
        2.0 * thinnest - thin
    } else {
        force_n
    };
    ComparedSection {
        experiment,
        axial_depth_mm,
        wall_mm,
        radial_depth_mm,
        reference_n,
        force_n,
        limit_percent: percent_from_ratio(limit_n / force_n - 1.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::presets;

    #[test]
    fn section_forces_meet_the_reference_within_one_percent() {
        for row in REFERENCE {
            let section = section(row, false);
            assert!((section.force_n / section.reference_n - 1.0).abs() < 0.01, "{section:?}");
        }
    }

    #[test]
    fn the_presets_are_made_of_these_sections() {
        for (experiment, name) in [(1, "experiment-1"), (2, "experiment-2")] {
            for [_, depth, wall] in presets::load(name).unwrap().workpiece.cuts.concat() {
                let same = |row: &&(u32, f64, f64, f64)| {
                    (row.0, row.1, row.2) == (experiment, depth, wall)
                };
                assert_eq!(REFERENCE.iter().filter(same).count(), 1, "{name}: {depth} {wall}");
            }
        }
    }
}
