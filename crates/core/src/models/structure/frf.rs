//! Frequency response of the machine: Z(w) z = P with Z = K - w^2 M + i w C, z = Z e^{iwt}.
//!
//! The paper solves the five equations by Gauss at every frequency ([`gauss`]). The graph is a
//! tree, so eliminating from its ends inwards ([`Tree`]) is exact, without fill-in and without the
//! difference kappa - kappa^2 / d; that form serves where the response is needed often.

use nalgebra::SMatrix;
use nalgebra::SVector;

use super::{Complex, FiveMass};
use crate::base::math::TAU;

/// Last frequency of the paper's sweep, Hz.
pub const LAST_HZ: u32 = 3000;
/// Step of the paper's sweep, Hz.
pub const STEP_HZ: u32 = 10;

/// Responses at one frequency, m/N.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrequencyResponse {
    /// Frequency, Hz.
    pub f_hz: f64,
    /// Tooth under a force on the tooth.
    pub h33: Complex,
    /// Work under a force on the work.
    pub hww: Complex,
    /// Tooth under a force on the work.
    pub h3w: Complex,
    /// Between work and tooth under the pair of forces: h33 + hww - 2 h3w.
    pub grel: Complex,
}

/// The frequencies of the paper's sweep in Hz: 0, 10, .. 3000.
pub fn frequencies_hz() -> impl Iterator<Item = f64> {
    (0..=LAST_HZ).step_by(STEP_HZ as usize).map(f64::from)
}

/// T(s) = M s^2 + C s + K in N/m for s in rad/s (2019, eq. 2 with s = i w).
#[must_use]
pub fn dynamic_stiffness(machine: &FiveMass, s: Complex) -> SMatrix<Complex, 5, 5> {
    let (mass, damping, stiffness) = (machine.mass(), machine.damping(), machine.stiffness());
    let squared = s * s;
    SMatrix::from_fn(|i, j| squared * mass[(i, j)] + s * damping[(i, j)] + stiffness[(i, j)])
}

/// The responses at `f_hz` in Hz by Gaussian elimination with partial pivoting, as 2019 solves eq. 2; `None` for a singular
/// matrix, which springs greater than 0 exclude.
#[must_use]
pub fn gauss(machine: &FiveMass, f_hz: f64) -> Option<FrequencyResponse> {
    let lu = dynamic_stiffness(machine, Complex::new(0.0, TAU * f_hz)).lu();
    let work = machine.branch().1;
    let unit = |node: usize| {
        let mut load = SVector::<Complex, 5>::zeros();
        load[node] = Complex::new(1.0, 0.0);
        lu.solve(&load)
    };
    let (tooth, pushed) = (unit(2)?, unit(work)?);
    let mut pair = SVector::<Complex, 5>::zeros();
    pair[2] = Complex::new(-1.0, 0.0);
    pair[work] = Complex::new(1.0, 0.0);
    let relative = lu.solve(&pair)?;
    Some(FrequencyResponse {
        f_hz,
        h33: tooth[2],
        hww: pushed[work],
        h3w: pushed[2],
        grel: relative[work] - relative[2],
    })
}

/// The tree eliminated at one s: what does not depend on the loads.
#[derive(Clone, Copy, Debug)]
pub struct Tree {
    kappa: [Complex; 5],
    d: [Complex; 5],
    root: Complex,
    inner: usize,
    outer: usize,
}

impl Tree {
    /// Eliminates at the complex frequency `s` in rad/s; i w for the frequency response.
    #[must_use]
    #[inline]
    pub fn new(machine: &FiveMass, s: Complex) -> Self {
        let elements = &machine.elements;
        let (inner, outer) = machine.branch();
        let o = s * s;
        let kappa =
            [0, 1, 2, 3, 4].map(|i| s * elements.damping_n_s_m[i] + elements.stiffness_n_m[i]);
        let inertia = elements.mass_kg.map(|mass| o * mass);
        let mut d = kappa;
        // One branch: its end first, then its inner node; what it adds to the base.
        let mut branch = |near: usize, end: usize| {
            d[end] = kappa[end] + inertia[end];
            let carried = inertia[end] * kappa[end] / d[end] + inertia[near];
            d[near] = kappa[near] + carried;
            kappa[near] * carried / d[near]
        };
        let added = branch(1, 2) + branch(inner, outer);
        Self { kappa, d, root: kappa[0] + inertia[0] + added, inner, outer }
    }

    /// Displacements of the nodes in m under forces in N on the tooth and on the work.
    #[must_use]
    #[inline]
    pub fn solve(&self, tooth_n: f64, work_n: f64) -> [Complex; 5] {
        let Self { kappa, d, root, inner, outer } = self;
        let f2 = kappa[2] / d[2] * tooth_n;
        let f_inner = kappa[*outer] / d[*outer] * work_n;
        let mut z = [Complex::new(0.0, 0.0); 5];
        z[0] = (kappa[1] / d[1] * f2 + kappa[*inner] / d[*inner] * f_inner) / root;
        z[1] = (f2 + kappa[1] * z[0]) / d[1];
        z[2] = (kappa[2] * z[1] + tooth_n) / d[2];
        z[*inner] = (f_inner + kappa[*inner] * z[0]) / d[*inner];
        z[*outer] = (kappa[*outer] * z[*inner] + work_n) / d[*outer];
        z
    }

    /// G_rel, m/N: between work and tooth under the pair of unit forces.
    #[must_use]
    #[inline]
    pub fn relative(&self) -> Complex {
        let z = self.solve(-1.0, 1.0);
        z[self.outer] - z[2]
    }
}

/// The responses at `f_hz` in Hz by elimination along the tree; the same numbers as [`gauss`].
#[must_use]
pub fn tree(machine: &FiveMass, f_hz: f64) -> FrequencyResponse {
    let tree = Tree::new(machine, Complex::new(0.0, TAU * f_hz));
    let (tooth, work) = (tree.solve(1.0, 0.0), tree.solve(0.0, 1.0));
    FrequencyResponse {
        f_hz,
        h33: tooth[2],
        hww: work[tree.outer],
        h3w: work[2],
        grel: tree.relative(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::structure::parameters::Parameters;
    use crate::models::structure::{MachineSettings, Variant};

    fn named(name: &str) -> FiveMass {
        let variant = if name.ends_with("_B") { Variant::Names } else { Variant::Equations };
        let parameters = if name.starts_with('T') { Parameters::Table } else { Parameters::Rules };
        let spindle_quality = if name.contains("Q2=17") { 17.0 } else { 5.0 };
        let settings =
            MachineSettings { variant, parameters, spindle_quality, ..MachineSettings::default() };
        FiveMass::new(&settings)
    }

    fn distance(response: &FrequencyResponse, reference: &[Complex]) -> f64 {
        [response.h33, response.hww, response.h3w, response.grel]
            .iter()
            .zip(reference)
            .map(|(x, y)| (x - y).norm_sqr().sqrt() / y.norm_sqr().sqrt())
            .fold(0.0, f64::max)
    }

    #[test]
    fn gauss_and_tree_meet_the_60_digit_reference() {
        let text = include_str!("../../../tests/data/reference_frf_2019.csv");
        let mut rows = 0;
        for line in text.lines().skip(1) {
            let (name, numbers) = line.split_once(',').unwrap();
            let x: Vec<f64> = numbers.split(',').map(|cell| cell.parse().unwrap()).collect();
            let reference: Vec<Complex> =
                x[1..].chunks(2).map(|pair| Complex::new(pair[0], pair[1])).collect();
            let machine = named(name);
            let solved = gauss(&machine, x[0]).unwrap();
            assert!(distance(&solved, &reference) < 1e-10, "{line}");
            assert!(distance(&tree(&machine, x[0]), &reference) < 1e-12, "{line}");
            rows += 1;
        }
        assert_eq!(rows, 78);
    }

    #[test]
    fn both_solvers_agree_over_the_whole_sweep() {
        for name in ["D_A", "D_B", "T_A"] {
            let machine = named(name);
            for f_hz in frequencies_hz() {
                let FrequencyResponse { h33, hww, h3w, grel, .. } = gauss(&machine, f_hz).unwrap();
                let gap = distance(&tree(&machine, f_hz), &[h33, hww, h3w, grel]);
                assert!(gap < 1e-10, "{name} at {f_hz} Hz: {gap:e}");
            }
        }
        assert_eq!(frequencies_hz().count(), 301);
    }

    fn largest(machine: &FiveMass, of: fn(&FrequencyResponse) -> Complex) -> (f64, f64, usize) {
        let sizes: Vec<f64> =
            frequencies_hz().map(|f| of(&tree(machine, f)).norm_sqr().sqrt()).collect();
        let maxima = (1..sizes.len() - 1)
            .filter(|i| sizes[*i] > sizes[i - 1] && sizes[*i] > sizes[i + 1])
            .count();
        let top = (0..sizes.len()).max_by(|a, b| sizes[*a].total_cmp(&sizes[*b])).unwrap();
        (10.0 * top as f64, sizes[top], maxima)
    }

    #[test]
    fn the_only_peak_is_the_spindle_and_the_rest_is_the_tooth() {
        let a = named("D_A");
        for (of, size) in [
            ((|r| r.h33) as fn(&FrequencyResponse) -> Complex, 6.164e-7),
            (|r: &FrequencyResponse| r.grel, 6.148e-7),
        ] {
            let (at, peak, maxima) = largest(&a, of);
            assert_eq!((at, maxima), (110.0, 1));
            assert!((peak / size - 1.0).abs() < 2e-4, "{peak:e}");
        }
        let (at, peak, _) = largest(&a, |r| r.hww);
        assert!(at == 150.0 && (peak / 1.04e-8 - 1.0).abs() < 5e-3, "{at} {peak:e}");
        let (at, peak, _) = largest(&named("D_B"), |r| r.hww);
        assert!(at == 120.0 && (peak / 1.39e-8 - 1.0).abs() < 5e-3, "{at} {peak:e}");
        let sharp = largest(&named("D_Q2=17_A"), |r| r.grel);
        assert!(sharp.0 == 110.0 && (sharp.1 / 2.080e-6 - 1.0).abs() < 1e-3, "{sharp:?}");
        // Antiresonance of the tooth's spring against the spindle, and the plateau at 1 / k3.
        for (machine, at) in [(a, 580.0), (named("D_B"), 570.0)] {
            let size = |f: f64| tree(&machine, f).grel.norm_sqr();
            let least = frequencies_hz().min_by(|x, y| size(*x).total_cmp(&size(*y)));
            assert_eq!(least, Some(at));
        }
        let plateau = 1.0 / a.elements.stiffness_n_m[2];
        let at_3_khz = tree(&a, 3000.0).grel.re;
        assert!((at_3_khz / plateau - 1.0).abs() < 0.05, "{at_3_khz:e} {plateau:e}");
    }

    #[test]
    fn variants_and_sets_differ_as_little_as_stated() {
        let gap = |x: &str, y: &str| {
            let (x, y) = (named(x), named(y));
            let (mut off, mut all) = (0.0, 0.0);
            for f in frequencies_hz() {
                let (a, b) = (tree(&x, f).grel, tree(&y, f).grel);
                off += (a - b).norm_sqr();
                all += a.norm_sqr();
            }
            (off / all).sqrt()
        };
        assert!((gap("D_A", "D_B") - 0.0285).abs() < 2e-4, "{}", gap("D_A", "D_B"));
        assert!((gap("D_A", "T_A") - 0.010).abs() < 6e-4, "{}", gap("D_A", "T_A"));
    }
}
