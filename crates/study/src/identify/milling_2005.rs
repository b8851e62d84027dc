//! K2..K4 on the milling simulator of 2005: the formulas that SDNRP and Tracking compute with,
//! fitted to static peaks of the mechanistic force model.
//!
//! Cut: Ck45, run-out 3 um, slices of 0.25 mm, A_D 2.6 mm with the wall 2 mm off the axis: the
//! section that Experiment 2 has most of. Between sections the controllers see the force over this
//! one's, as a factor.
//!
//! ```text
//! K2   feed over force at the programmed speed, a quadratic
//! K3   the programmed speed at any force
//! K4   F over feed and speed, in the printed form, relative errors
//! ```
//!
//! The system of 2005 moves the feed override alone, and must: the peak of a control period of 20 ms
//! holds a tooth of this cutter only from 1500 1/min on.
//!
//! The system of 2005 holds the force and has no roughness model: K1 and K5 are those of 2007.

use nalgebra::{Matrix3, Vector3};

use super::sdnrp_2007::fit;
use super::{Fit, Identified};
use crate::base::math;
use crate::models::genetic::exponential::Exponential;
use crate::models::genetic::force_formula::{ForceFormula, INCH};
use crate::models::genetic::{
    Calibration, CutsAs, FeedLaw, GeneticModels, MILLING_AXIAL_DEPTH_MM, MILLING_RADIAL_DEPTH_MM,
    ModelSet, OwnModels, SpeedLaw,
};
use crate::models::mechanistic::{CK45, Cutter, Kienzle, StaticCut, static_peak};
use crate::models::tool::Tool;

/// The programmed cut of both experiments: cutting speed in m/min and feed per tooth in mm.
const PROGRAMMED: [f64; 2] = [80.0, 0.08];
/// Run-out of the cutter and height of its slices in the experiments, mm.
const RUNOUT_MM: f64 = 0.003;
const SLICE_MM: f64 = 0.25;
/// Feeds over the programmed one: up to the largest override of the experiments, and down to what
/// their heaviest section needs.
const FEEDS: [f64; 2] = [0.4, 1.5];
/// Number of feeds.
const POINTS: u32 = 21;
/// Speeds over the programmed one at which K4 is fitted.
const SPEEDS: [f64; 3] = [0.9, 1.0, 1.1];

/// The peak force in N at a feed and a speed over the programmed ones.
fn peak_n(tool: &Tool, feed: f64, speed: f64) -> f64 {
    let [speed_m_min, feed_per_tooth_mm] = PROGRAMMED;
    let cutter = Cutter::new(tool, RUNOUT_MM, SLICE_MM);
    let law = Kienzle::new(&CK45, speed * speed_m_min, tool.rake_deg, CK45.hardness_hb);
    let cut = StaticCut {
        feed_per_tooth_mm: feed_per_tooth_mm * feed / speed,
        axial_depth_mm: MILLING_AXIAL_DEPTH_MM,
        radial_depth_mm: MILLING_RADIAL_DEPTH_MM,
    };
    static_peak(&cutter, &law, &cut).fxy_n
}

/// `count` values from the first to the second of `range`, in equal ratios.
fn ratios([low, high]: [f64; 2], count: u32) -> impl Iterator<Item = f64> {
    let step = math::ln(high / low) / f64::from(count - 1);
    (0..count).map(move |i| low * math::exp(f64::from(i) * step))
}

/// Least squares of the relative errors of K4's form over (feed, speed, force).
fn force_formula(points: &[[f64; 3]]) -> Option<ForceFormula> {
    let mut normal = Matrix3::zeros();
    let mut right = Vector3::zeros();
    for [feed, speed, force] in points {
        // Sizes near one keep the normal equations well conditioned.
        let terms = [1.0, -speed * speed * speed * 1e-10, -math::ln(INCH * feed) / feed * 100.0];
        let row = Vector3::from(terms) / *force;
        normal += row * row.transpose();
        right += row;
    }
    let c = normal.lu().solve(&right)?;
    Some(ForceFormula { intercept_n: c[0], speed: c[1] * 1e-10, feed: c[2] * 100.0 })
}

/// Identifies K2..K4 for a cutter.
///
/// # Errors
/// Names the model whose points give no usable curve.
pub fn identify_milling(tool: &Tool) -> Result<Identified, String> {
    let [speed_m_min, feed_per_tooth_mm] = PROGRAMMED;
    let speed_rpm = tool.speed_rpm(speed_m_min);
    let feed_mm_min = tool.feed_mm_min(feed_per_tooth_mm, speed_rpm);
    let grid: Vec<[f64; 3]> = ratios(FEEDS, POINTS)
        .flat_map(|feed| SPEEDS.map(|speed| [feed, speed]))
        .map(|[feed, speed]| [feed * feed_mm_min, speed * speed_rpm, peak_n(tool, feed, speed)])
        .collect();
    let programmed = grid.iter().filter(|[_, speed, _]| *speed == speed_rpm);
    let points = programmed.map(|[feed, _, peak_n]| [*peak_n, *feed]).collect();
    let (k2, k2_fit) = fit("K2", "feed over the force of the reference cut", "mm/min", points)?;
    let k3 = Exponential { scale_rpm: speed_rpm, rate_per_n: 0.0 };
    let force = force_formula(&grid)
        .filter(|force| force.speed > 0.0 && force.feed > 0.0)
        .ok_or("K4: the peaks give no force that rises with feed and falls with speed")?;
    let residual = |[feed, speed, peak_n]: &[f64; 3]| force.at(*feed, *speed).value - peak_n;
    let k4_fit = Fit {
        model: "K4",
        meaning: "force over feed, at the programmed speed and 10 % beside it",
        points: grid.iter().map(|[feed, _, peak_n]| [*feed, *peak_n]).collect(),
        residuals: grid.iter().map(residual).collect(),
        unit: "N",
    };
    let models = GeneticModels {
        set: ModelSet::Milling2005,
        roughness: GeneticModels::new(ModelSet::Sdnrp2007, Calibration::Identified).roughness,
        feed: FeedLaw::Curve(k2),
        speed: SpeedLaw::Exponential(k3, [k2.low, k2.high]),
        force,
        cuts_as: CutsAs::PAPERS,
        own: OwnModels::default(),
    };
    Ok(Identified { models, fits: vec![k2_fit, k4_fit] })
}
