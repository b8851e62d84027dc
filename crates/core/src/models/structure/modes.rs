//! Modes of the machine: natural frequencies without damping, poles and shapes with it.
//!
//! The eigenvalues of the 10 x 10 state matrix (real Schur form, nalgebra) carry errors of the
//! tooth's 2.6e7 rad/s; each is refined on T(s) x = (s^2 M + s C + K) x = 0 itself by inverse
//! iteration with the quotient
//!
//! ```text
//! x <- T(s)^-1 T'(s) x ,   s <- s - x^T T(s) x / x^T T'(s) x ,   T'(s) = 2 s M + C
//! ```
//!
//! which converges cubically because T is symmetric. (b^T x)^2 / (x^T T' x) is the residue of
//! G_rel at the pole.

use nalgebra::SMatrix;
use nalgebra::SVector;
use nalgebra::linalg::Schur;

use super::frf::dynamic_stiffness;
use super::{Complex, FiveMass, Matrix5};
use crate::base::math::TAU;

/// Iterations of the Schur form at most; some 30 are needed.
const SCHUR_ITERATIONS: usize = 2000;
/// Steps of the refinement; two suffice from the Schur form's eigenvalues.
const REFINEMENTS: usize = 6;

/// A pole with its shape; of a conjugate pair the one with positive imaginary part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mode {
    /// Pole, rad/s; real where the mode is overdamped.
    pub pole: Complex,
    /// Displacements of the nodes, scaled so that x^T T'(s) x = 1.
    pub shape: [Complex; 5],
    /// Residue of G_rel at the pole, m/(N s).
    pub residue: Complex,
}

impl Mode {
    /// |s| / 2 pi, Hz.
    #[must_use]
    pub fn natural_hz(&self) -> f64 {
        size(self.pole) / TAU
    }

    /// Im s / 2 pi, Hz.
    #[must_use]
    pub fn damped_hz(&self) -> f64 {
        self.pole.im / TAU
    }

    /// Damping ratio -Re s / |s|.
    #[must_use]
    pub fn damping_ratio(&self) -> f64 {
        -self.pole.re / size(self.pole)
    }
}

/// A mode without damping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UndampedMode {
    /// Natural frequency, Hz.
    pub frequency_hz: f64,
    /// Mass-normalised shape x^T M x = 1, kg^-1/2; the largest displacement is positive.
    pub shape: [f64; 5],
}

fn size(z: Complex) -> f64 {
    z.norm_sqr().sqrt()
}

/// Eigenvalues in rad/s of M z'' + C z' + K z = 0 with the masses `mass_kg` > 0 and any `damping`
/// and `stiffness`, symmetric or not; `None` if the iteration does not converge.
#[must_use]
pub fn eigenvalues(
    mass_kg: &[f64; 5],
    damping: &Matrix5,
    stiffness: &Matrix5,
) -> Option<Vec<Complex>> {
    // State (y, v): y = sqrt(m) z, y' = sigma v. Every node is scaled to its own frequency.
    let root = mass_kg.map(f64::sqrt);
    let scaled = |matrix: &Matrix5, i: usize, j: usize| matrix[(i, j)] / (root[i] * root[j]);
    let sigma = [0, 1, 2, 3, 4].map(|i| scaled(stiffness, i, i).abs().sqrt().max(1.0));
    let mut state = SMatrix::<f64, 10, 10>::zeros();
    for i in 0..5 {
        state[(i, 5 + i)] = sigma[i];
        for j in 0..5 {
            state[(5 + i, j)] = -scaled(stiffness, i, j) / sigma[i];
            state[(5 + i, 5 + j)] = -scaled(damping, i, j) / sigma[i] * sigma[j];
        }
    }
    let schur = Schur::try_new(state, f64::EPSILON, SCHUR_ITERATIONS)?;
    Some(schur.complex_eigenvalues().iter().copied().collect())
}

/// Refines the pole `start` of a machine with symmetric matrices.
fn refine(machine: &FiveMass, start: Complex) -> Mode {
    let (mass, damping) = (machine.mass(), machine.damping());
    let slope = |s: Complex| SMatrix::from_fn(|i, j| s * (2.0 * mass[(i, j)]) + damping[(i, j)]);
    let mut s = start;
    let mut x: SVector<Complex, 5> = SVector::from([1.0, -0.9, 1.1, 0.8, -1.2].map(Complex::from));
    for _ in 0..REFINEMENTS {
        let derivative: SMatrix<Complex, 5, 5> = slope(s);
        // A little beside s: at the pole itself there is no inverse, and with the printed spring of
        // 6.3e12 N/m rounding makes a zero pivot nearby.
        let beside = dynamic_stiffness(machine, s * (1.0 + 1e-8)).lu();
        let Some(next) = beside.solve(&(derivative * x)) else { break };
        let largest = next.iter().map(|z| z.norm_sqr()).fold(0.0, f64::max).sqrt();
        x = next / Complex::from(largest);
        let moved = (x.transpose() * dynamic_stiffness(machine, s) * x)[0]
            / (x.transpose() * derivative * x)[0];
        s -= moved;
    }
    let norm = (x.transpose() * slope(s) * x)[0];
    let across = machine.load().iter().zip(&x).map(|(b, x)| *x * *b).sum::<Complex>();
    let root = principal_root(norm);
    Mode { pole: s, shape: x.map(|x| x / root).into(), residue: across * across / norm }
}

/// Square root with non-negative real part, by exact operations.
fn principal_root(z: Complex) -> Complex {
    let length = size(z);
    let re = (0.5 * (length + z.re)).max(0.0).sqrt();
    let im = (0.5 * (length - z.re)).max(0.0).sqrt();
    Complex::new(re, if z.im < 0.0 { -im } else { im })
}

/// All modes by rising |s|; `None` if the eigenvalues do not converge.
#[must_use]
pub fn damped(machine: &FiveMass) -> Option<Vec<Mode>> {
    let starts = eigenvalues(&machine.elements.mass_kg, &machine.damping(), &machine.stiffness())?;
    Some(from_starts(machine, starts))
}

/// The modes of `machine` near the given eigenvalues.
pub(super) fn from_starts(machine: &FiveMass, mut starts: Vec<Complex>) -> Vec<Mode> {
    starts.retain(|s| s.im >= 0.0);
    starts.sort_by(|x, y| x.norm_sqr().total_cmp(&y.norm_sqr()));
    starts.into_iter().map(|start| refine(machine, start)).collect()
}

/// The five modes without damping by rising frequency; `None` if the eigenvalues do not converge.
#[must_use]
pub fn undamped(machine: &FiveMass) -> Option<Vec<UndampedMode>> {
    let mut free = *machine;
    free.elements.damping_n_s_m = [0.0; 5];
    let starts = eigenvalues(&free.elements.mass_kg, &free.damping(), &free.stiffness())?;
    // The eigenvalues lie on the imaginary axis; what the iteration adds beside it is its error.
    let starts = starts.into_iter().map(|s| Complex::new(0.0, s.im)).collect();
    let modes = from_starts(&free, starts);
    Some(
        modes
            .into_iter()
            .filter(|mode| mode.pole.im > 0.0)
            .map(|mode| {
                // x^T 2 i w M x = 1: up to a common phase the shape is real.
                let lead =
                    mode.shape.iter().copied().max_by(|x, y| x.norm_sqr().total_cmp(&y.norm_sqr()));
                let lead = lead.unwrap_or(Complex::from(1.0));
                let real = mode.shape.map(|x| (x / lead).re);
                let mass: f64 =
                    real.iter().zip(free.elements.mass_kg).map(|(x, m)| m * (x * x)).sum();
                UndampedMode {
                    frequency_hz: mode.natural_hz(),
                    shape: real.map(|x| x / mass.sqrt()),
                }
            })
            .collect(),
    )
}

#[cfg(test)]
mod tests;
