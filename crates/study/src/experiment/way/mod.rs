//! The whole way of the papers: cuts, models from the cuts, a controller on the models, and how far it holds Ra.
//!
//! | step | how | module |
//! | --- | --- | --- |
//! | The plant | the papers' cut by K4 (restored) and K5; any other cutter or material tooth by tooth | [`plant`] |
//! | Pilot cuts | tooth by tooth: depth and feeds at which the forces are those of the papers' table | [`pilot`] |
//! | The cuts | a third on a line, from least feed and largest speed to the opposite corner, the others a Latin hypercube over the box; with measuring noise | [`cuts`] |
//! | The models | genetic programming: K1 F(Ra), K4 F(f, n), K5 = K6 Ra(F) from all cuts; K2 f(F), K3 n(F) from those on the line | [`models`] |
//! | Kept, to go on later | the searches, as a file | [`state`] |
//! | The rows | the ten rows of 2007 Table 3 with SDNRP and Tracking, on the models found and on the papers' own | [`rows`] |
//!
//! Feed and speed for a force (K2, K3) are a choice: one force can be had by many pairs of feed and speed, and the
//! papers take the pairs of one line (final feeds and speeds of Table 3 lie on one, r = -0.995). So does the plan,
//! and K2 and K3 are formulas of the force over its cuts, as in the papers. The papers' 185 (2007) data were never
//! published.
//!
//! What the plant's Ra is: what a force leaves by the papers' K5, whatever cutter and material. No source tells it
//! for another cutter, and the simulator marks it; what is new to the models there is the force.

pub mod cuts;
pub mod job;
pub mod models;
pub mod pilot;
pub mod plant;
pub mod report;
pub mod rows;
pub mod state;

use serde::Serialize;

use super::assess::MeasuringNoise;
use crate::blocks::cutting::material::Material;
use crate::identify::gp::job::BATCHES;
use crate::models::tool::ShippedTool;

/// Cuts of the 2007 paper.
pub const CUTS_2007: usize = 185;
/// Fewest cuts: the search wants some on the line and some beside it.
pub const FEWEST_CUTS: usize = 30;
/// Most cuts.
pub const MOST_CUTS: usize = 2000;

steadycut_core::choice! {
    /// What is cut.
    pub enum WayPlant {
        /// The force by the papers' K4, restored.
        Formula = "formula", "K4 of the papers";
        /// The force tooth by tooth.
        Mechanistic = "mechanistic", "tooth by tooth";
    }
}

/// What the way is gone with.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WaySettings {
    /// The cutter.
    pub tool: ShippedTool,
    /// The workpiece's material.
    pub material: Material,
    /// Its hardness, HB; none for that of the material.
    pub hardness_hb: Option<f64>,
    /// What gives the force; none for the papers' formula with their cutter in their steel, tooth by tooth
    /// otherwise.
    pub plant: Option<WayPlant>,
    /// Axial depth, mm; none for the papers' one or, tooth by tooth, the one that pilot cuts find.
    pub axial_depth_mm: Option<f64>,
    /// Radial depth, mm; none for the papers' one.
    pub radial_depth_mm: Option<f64>,
    /// Number of cuts.
    pub cuts: usize,
    /// Noise of what is measured.
    pub noise: MeasuringNoise,
    /// Seed of plan, noise and search.
    pub seed: u64,
    /// Most batches of each search.
    pub batches: u64,
}

impl Default for WaySettings {
    fn default() -> Self {
        Self {
            tool: ShippedTool::R21616B20,
            material: Material::Ck45,
            hardness_hb: None,
            plant: None,
            axial_depth_mm: None,
            radial_depth_mm: None,
            cuts: CUTS_2007,
            noise: MeasuringNoise::default(),
            seed: 1,
            batches: BATCHES,
        }
    }
}
