//! Training data of the neural force model: static cuts of the mechanistic ball-end model.
//!
//! The papers' 3500 measurements were never published. In their place: a Latin hypercube (McKay,
//! Beckman, Conover 1979) over the ranges of `models/neural_force`, forces of
//! `models/mechanistic`, and the noise of a measurement. Run-out, slice and noise are chosen.

use crate::base::language::text;
use crate::base::math;
use crate::base::rng::Stream;
use crate::models::mechanistic::{CK45, Cutter, Kienzle, MNCRSI5, StaticCut, static_peak};
use crate::models::neural_force::{
    AXIAL_DEPTH_MM, AXIAL_PER_DIAMETER, CutPoint, FEED_PER_TOOTH_MM, HARDNESS_HB,
    RADIAL_PER_DIAMETER, SPEED_M_MIN, TEETH, speed_m_min,
};
use crate::run::job::{Budget, Job, Progress};
use crate::run::parts::{Making, OneStep, Parts};

/// Cutter diameters, mm.
pub const DIAMETERS_MM: [f64; 4] = [10.0, 12.0, 16.0, 20.0];
/// Run-out of the two teeth, +- mm.
pub const RUNOUT_MM: f64 = 0.003;
/// Height of the model's slices, mm.
pub const SLICE_MM: f64 = 0.25;
/// Multiplicative noise of a measured component, standard deviation.
pub const NOISE_RATIO: f64 = 0.03;
/// Additive noise of a measured component, standard deviation in N.
pub const NOISE_N: f64 = 3.0;
/// Fresh rows without noise that judge a network.
pub const FRESH_ROWS: u32 = 1000;
/// What the data are, in one sentence.
pub const NOTE: &str = text!(
    "The papers' 3500 measurements were never published: the training data come \
from the mechanistic ball-end model (Latin hypercube, run-out 3 um, slices of 0.25 mm) with noise \
of 3 % and 3 N."
);

/// A cut and the forces found in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrainingRow {
    /// The cut.
    pub cut: CutPoint,
    /// Fx, Fy, Fz in N at the instant of the largest F_xy.
    pub forces_n: [f64; 3],
}

/// F_xy in N of force components.
#[must_use]
pub fn fxy_n(forces_n: &[f64]) -> f64 {
    (forces_n[0] * forces_n[0] + forces_n[1] * forces_n[1]).sqrt()
}

/// Forces in N of the mechanistic model in a cut.
#[must_use]
pub fn mechanistic_n(cut: &CutPoint) -> [f64; 3] {
    let steel = if cut.material_code < 1.5 { CK45 } else { MNCRSI5 };
    let rake_deg = 3.0 + 3.0 * cut.geometry_code;
    let speed = speed_m_min(cut.diameter_mm, cut.speed_rpm);
    let law = Kienzle::new(&steel, speed, rake_deg, cut.hardness_hb);
    let cutter = Cutter::two_teeth(cut.diameter_mm, RUNOUT_MM, SLICE_MM);
    let cut = StaticCut {
        feed_per_tooth_mm: cut.feed_per_tooth_mm(),
        axial_depth_mm: cut.axial_depth_mm,
        radial_depth_mm: cut.radial_depth_mm,
    };
    static_peak(&cutter, &law, &cut).components_n
}

/// Rows in the making: a job of independent rows.
#[derive(Clone, Debug)]
pub struct RowsJob {
    cuts: Vec<CutPoint>,
    noise: Option<Stream>,
    rows: Parts<OneStep, TrainingRow>,
}

impl RowsJob {
    /// `rows` measured rows (with noise), for training and hold-out.
    #[must_use]
    pub fn measured(rows: u32, seed: u32) -> Self {
        let noise = Some(Stream::new(seed.into(), "train.noise"));
        Self { cuts: latin_hypercube(rows, seed, "train"), noise, rows: Parts::default() }
    }

    /// `rows` rows without noise that share no draw with the measured ones.
    #[must_use]
    pub fn fresh(rows: u32, seed: u32) -> Self {
        let cuts = latin_hypercube(rows, seed, "fresh");
        Self { cuts, noise: None, rows: Parts::default() }
    }

    /// The rows so far, in order.
    #[must_use]
    pub fn rows(&self) -> &[TrainingRow] {
        self.rows.done()
    }

    /// All rows, made on one thread.
    #[must_use]
    pub fn complete(mut self) -> Vec<TrainingRow> {
        self.to_end();
        self.rows.done().to_vec()
    }
}

/// The forces of a cut, with the noise of row `index`.
fn row(cut: CutPoint, noise: Option<&Stream>, index: usize) -> TrainingRow {
    let mut forces_n = mechanistic_n(&cut);
    if let Some(noise) = noise {
        let drawn = 2 * forces_n.len() * index;
        for (force, draw) in forces_n.iter_mut().zip((drawn as u64..).step_by(2)) {
            *force *= 1.0 + NOISE_RATIO * noise.normal(draw);
            *force += NOISE_N * noise.normal(draw + 1);
        }
    }
    TrainingRow { cut, forces_n }
}

/// A step is a row.
impl Job for RowsJob {
    type Partial = Vec<TrainingRow>;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        let (cuts, noise) = (&self.cuts, self.noise.as_ref());
        let end = |index: usize, _: &OneStep| row(cuts[index], noise, index);
        let making = Making { begin: &|_| Ok(OneStep::default()), end: &end };
        self.rows.advance(cuts.len(), budget, &making)
    }

    fn progress(&self) -> Progress {
        Progress { done: self.rows.progress(), total: self.cuts.len() as f64, unit: text!("rows") }
    }

    fn partial(&self) -> Vec<TrainingRow> {
        self.rows().to_vec()
    }
}

/// Cuts spread over all ranges: in each of the eight dimensions every one of `rows` equal strata
/// holds one cut.
fn latin_hypercube(rows: u32, seed: u32, label: &str) -> Vec<CutPoint> {
    let rows = rows as usize;
    let column = |dimension: u32| {
        let order = Stream::new(seed.into(), &format!("{label}.order.{dimension}"));
        let place = Stream::new(seed.into(), &format!("{label}.place.{dimension}"));
        let mut strata: Vec<usize> = (0..rows).collect();
        for i in (1..rows).rev() {
            strata.swap(i, order.below(i as u64, i as u64 + 1) as usize);
        }
        let within = (0_u64..).map(|i| place.uniform(i));
        strata.into_iter().zip(within).map(|(s, u)| (s as f64 + u) / rows as f64).collect()
    };
    let columns: [Vec<f64>; 8] = [0, 1, 2, 3, 4, 5, 6, 7].map(column);
    (0..rows).map(|row| cut_at(std::array::from_fn(|k| columns[k][row]))).collect()
}

/// The cut at a point of the unit cube.
fn cut_at(unit: [f64; 8]) -> CutPoint {
    let between = |[low, high]: [f64; 2], u: f64| low + (high - low) * u;
    let one_of = |options: usize, u: f64| ((u * options as f64) as usize).min(options - 1);
    let diameter_mm = DIAMETERS_MM[one_of(DIAMETERS_MM.len(), unit[0])];
    let axial_max_mm = AXIAL_DEPTH_MM[1].min(AXIAL_PER_DIAMETER * diameter_mm);
    let material = one_of(2, unit[5]);
    let speed_rpm = between(SPEED_M_MIN, unit[1]) * 1000.0 / (math::PI * diameter_mm);
    CutPoint {
        feed_mm_min: between(FEED_PER_TOOTH_MM, unit[2]) * TEETH * speed_rpm,
        speed_rpm,
        radial_depth_mm: between(RADIAL_PER_DIAMETER, unit[3]) * diameter_mm,
        axial_depth_mm: between([AXIAL_DEPTH_MM[0], axial_max_mm], unit[4]),
        material_code: 1.0 + material as f64,
        hardness_hb: between(HARDNESS_HB[material], unit[6]),
        diameter_mm,
        geometry_code: 1.0 + one_of(3, unit[7]) as f64,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_stratum_of_every_range_is_met_once() {
        let cuts = latin_hypercube(40, 9, "test");
        let strata = |of: &dyn Fn(&CutPoint) -> f64| {
            let mut strata: Vec<usize> = cuts.iter().map(|cut| (40.0 * of(cut)) as usize).collect();
            strata.sort_unstable();
            strata
        };
        let all: Vec<usize> = (0..40).collect();
        assert_eq!(strata(&|cut| (cut.feed_per_tooth_mm() - 0.02) / 0.18), all);
        assert_eq!(
            strata(&|cut| (speed_m_min(cut.diameter_mm, cut.speed_rpm) - 40.0) / 110.0),
            all
        );
        assert_eq!(strata(&|cut| (cut.radial_depth_mm / cut.diameter_mm - 0.12) / 0.38), all);
        for diameter in DIAMETERS_MM {
            assert_eq!(cuts.iter().filter(|cut| cut.diameter_mm == diameter).count(), 10);
        }
        for cut in &cuts {
            assert!(cut.axial_depth_mm <= cut.diameter_mm / 3.0 && cut.axial_depth_mm <= 5.0);
        }
        assert_eq!(cuts.iter().filter(|cut| cut.material_code == 2.0).count(), 20);
    }

    #[test]
    fn measured_rows_carry_the_stated_noise_and_repeat() {
        let rows: Vec<TrainingRow> = RowsJob::measured(60, 1).complete();
        assert_eq!(rows, RowsJob::measured(60, 1).complete());
        assert_ne!(rows[0], RowsJob::measured(60, 2).complete()[0]);
        let mut sum = 0.0;
        for row in &rows {
            for (measured, exact) in row.forces_n.iter().zip(mechanistic_n(&row.cut)) {
                let sd = (9e-4 * exact * exact + 9.0).sqrt();
                sum += (measured - exact) * (measured - exact) / (sd * sd);
            }
        }
        // 180 squares of standard normal deviates: mean 1, standard deviation 0.105.
        assert!((sum / 180.0 - 1.0).abs() < 0.35, "{}", sum / 180.0);
        let fresh = RowsJob::fresh(1, 1).complete()[0];
        assert_eq!(fresh.forces_n, mechanistic_n(&fresh.cut));
    }
}
