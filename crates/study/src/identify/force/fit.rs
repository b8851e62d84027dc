//! The fit to a folded recording: Gauss-Newton steps with Levenberg's damping from where [`super::start`] begins.

use nalgebra::DVector;

use super::fold::Folded;
use super::start::{Start, starts};
use super::{ForceFit, IdentifiedLaw, RecordedCut};
use crate::base::language::tr;
use crate::base::math;
use crate::base::units::mm_from_um;
use crate::identify::EstimatedValue;
use crate::identify::estimate::LinearisedFit;
use crate::identify::least_squares::{Patience, minimise_by};
use crate::models::mechanistic::{Cutter, Kienzle, MAX_TEETH, static_turn};
use crate::models::tool::runout_share;

/// The reference thickness of the chip as a share of the feed per tooth (chosen: where most of the force is).
const REFERENCE: f64 = 0.5;
/// Parameters of size one: run-out in mm, angle in rad.
const RUNOUT_MM: f64 = 0.01;
const PHASE_RAD: f64 = 0.05;
/// Steps of the central differences of coefficients, exponents and run-out.
const DIFFERENCE: f64 = 1e-3;
/// How far logarithms of coefficients, and exponents, may go.
const FARTHEST: [f64; 2] = [5.0, 1.5];
/// Share of the largest effect of a parameter below which it has none.
const NO_EFFECT: f64 = 1e-7;
/// Condition from which on parameters cannot be told apart (Belsley, Kuh and Welsch call 30 to 100 strong).
const NOT_APART: f64 = 300.0;
/// Share in the worst direction from which on a parameter is part of it.
const PART: f64 = 0.25;
const PATIENCE: Patience = Patience { steps: 40, gain: 1e-6 };
/// Another start is tried where it leaves less than so many times what the best one leaves.
const NEARLY: f64 = 1.5;

/// A parameter of the fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Free {
    /// Logarithm of a coefficient at the reference thickness.
    Size(usize),
    /// An exponent m.
    Exponent(usize),
    /// How far a tooth but the first stands out of the mean.
    Runout(usize),
    /// Angle at the first sample.
    Phase,
}

const LETTERS: [char; 3] = ['c', 'r', 'a'];

impl Free {
    fn name(self) -> String {
        match self {
            Self::Size(i) => format!("k_{}", LETTERS[i]),
            Self::Exponent(i) => format!("m_{}", LETTERS[i]),
            Self::Runout(_) => tr("the run-out").to_owned(),
            Self::Phase => tr("the angle").to_owned(),
        }
    }
}

/// The model at some values of its parameters.
#[derive(Clone, Debug)]
struct Guess {
    law: Kienzle,
    runout_mm: [f64; MAX_TEETH],
    phase_rad: f64,
}

/// The problem around a start.
struct Problem<'a> {
    folded: &'a Folded,
    cut: &'a RecordedCut,
    start: Start,
    free: Vec<Free>,
    reference_mm: f64,
    /// Roots of the numbers of samples, over the size of the forces.
    weights: Vec<f64>,
}

impl<'a> Problem<'a> {
    fn new(folded: &'a Folded, cut: &'a RecordedCut, start: Start) -> Self {
        let teeth = cut.tool.teeth as usize;
        let sizes = (0..3).map(Free::Size);
        let exponents = (0..3).filter(|i| !cut.held_exponents[*i]).map(Free::Exponent);
        let runout = (1..teeth).map(Free::Runout);
        let free = sizes.chain(exponents).chain(runout).chain([Free::Phase]).collect();
        let size = (folded.total / (folded.samples * folded.axes.len()) as f64).sqrt();
        Self {
            folded,
            cut,
            start,
            free,
            reference_mm: REFERENCE * cut.feed_per_tooth_mm(),
            weights: folded.counts.iter().map(|count| count.sqrt() / size).collect(),
        }
    }

    fn differences(&self) -> Vec<f64> {
        // An angle of a place: slices enter and leave the cut whole, so that a smaller one would see no edge move.
        let angle = math::TAU / self.folded.angles_rad.len() as f64 / PHASE_RAD;
        let step = |free: &Free| match free {
            Free::Size(_) | Free::Exponent(_) | Free::Runout(_) => DIFFERENCE,
            Free::Phase => angle,
        };
        self.free.iter().map(step).collect()
    }

    fn guess(&self, x: &[f64]) -> Guess {
        let log_reference = math::ln(self.reference_mm);
        let began = &self.cut.law;
        let mut exponents = began.exponents.map(|power| 1.0 - power);
        let mut sizes = [0.0; 3];
        let mut runout_mm = [0.0; MAX_TEETH];
        let mut phase_rad = self.start.phase_rad;
        let [farthest_size, farthest_exponent] = FARTHEST;
        for (free, x) in self.free.iter().zip(x) {
            match *free {
                Free::Size(i) => sizes[i] = math::limit(*x, -farthest_size, farthest_size),
                Free::Exponent(i) => {
                    exponents[i] += math::limit(*x, -farthest_exponent, farthest_exponent);
                }
                Free::Runout(j) => {
                    runout_mm[j] = RUNOUT_MM * x;
                    runout_mm[0] -= RUNOUT_MM * x;
                }
                Free::Phase => phase_rad += PHASE_RAD * x,
            }
        }
        let k = |i: usize| {
            let began_m = 1.0 - began.exponents[i];
            // k at the reference thickness is what the size is a factor on.
            let log = sizes[i] + (exponents[i] - began_m) * log_reference;
            self.start.factors[i] * began.k_n_mm2[i] * math::exp(log)
        };
        let law = Kienzle { k_n_mm2: [k(0), k(1), k(2)], exponents: exponents.map(|m| 1.0 - m) };
        Guess { law, runout_mm, phase_rad }
    }

    fn forces(&self, x: &[f64]) -> Vec<[f64; 3]> {
        let guess = self.guess(x);
        let cutter = Cutter {
            runout_mm: guess.runout_mm,
            ..Cutter::new(&self.cut.tool, 0.0, self.cut.slice_mm)
        };
        let angles: Vec<f64> =
            self.folded.angles_rad.iter().map(|angle| angle + guess.phase_rad).collect();
        static_turn(&cutter, &guess.law, &self.cut.static_cut(), &angles)
    }

    fn residuals(&self, x: &[f64]) -> Vec<f64> {
        let forces = self.forces(x);
        let mut residuals = Vec::with_capacity(forces.len() * self.folded.axes.len());
        for (axis, means) in self.folded.axes.iter().zip(&self.folded.means_n) {
            let of_axis = means.iter().zip(&forces).zip(&self.weights);
            residuals
                .extend(of_axis.map(|((mean, force), weight)| weight * (mean - axis.of(*force))));
        }
        residuals
    }

    /// Leaves out what the forces do not tell.
    fn without_unseen(mut self) -> Self {
        let at = vec![0.0; self.free.len()];
        let fit = LinearisedFit::new(&at, &self.differences(), &|x| self.residuals(x));
        let lengths = fit.lengths();
        let most = lengths.iter().fold(0.0, |most: f64, x| most.max(*x));
        let free = self.free.iter().zip(lengths).filter(|(_, length)| *length > NO_EFFECT * most);
        self.free = free.map(|(free, _)| *free).collect();
        self
    }

    /// The parameters that fit best, and the sum of squares that they leave.
    fn solved(&self) -> (Vec<f64>, f64) {
        let begin = DVector::<f64>::zeros(self.free.len());
        let found = minimise_by(begin, &self.differences(), PATIENCE, |x: &DVector<f64>| {
            self.residuals(x.as_slice())
        });
        let x = found.as_slice().to_vec();
        let left = self.residuals(&x).iter().map(|r| r * r).sum();
        (x, left)
    }
}

/// The fits from one start after the other.
#[derive(Clone, Debug)]
pub(super) struct Fitting {
    folded: Folded,
    cut: RecordedCut,
    starts: Vec<Start>,
    next: usize,
    /// The best one so far: its start, its parameters, what they leave.
    best: Option<(usize, Vec<f64>, f64)>,
}

impl Fitting {
    pub fn new(folded: Folded, cut: RecordedCut) -> Self {
        let mut starts = starts(&folded, &cut);
        let least = starts.iter().map(|start| start.left).fold(f64::INFINITY, f64::min);
        starts.retain(|start| start.left <= NEARLY * least);
        Self { folded, cut, starts, next: 0, best: None }
    }

    pub fn starts(&self) -> usize {
        self.starts.len()
    }

    fn problem(&self, start: usize) -> Problem<'_> {
        Problem::new(&self.folded, &self.cut, self.starts[start]).without_unseen()
    }

    /// Fits from the next start; `true` while there are more.
    pub fn step(&mut self) -> bool {
        if self.next < self.starts.len() {
            let (x, left) = self.problem(self.next).solved();
            let better = |(_, _, least): &(usize, Vec<f64>, f64)| left.total_cmp(least).is_lt();
            if self.best.as_ref().is_none_or(better) {
                self.best = Some((self.next, x, left));
            }
            self.next += 1;
        }
        self.next < self.starts.len()
    }

    /// The best fit.
    pub fn found(&self) -> Result<ForceFit, String> {
        let Some((start, x, left)) = &self.best else {
            return Err(tr("no place to begin the fit").to_owned());
        };
        if !left.is_finite() {
            return Err(tr("the model gives no forces in this cut").to_owned());
        }
        Ok(told(&self.problem(*start), x, *left))
    }
}

/// What was found, with its intervals.
fn told(problem: &Problem<'_>, x: &[f64], left: f64) -> ForceFit {
    let Problem { folded, cut, reference_mm, .. } = problem;
    let fit = LinearisedFit::new(x, &problem.differences(), &|x| problem.residuals(x));
    let seen = |i: usize| problem.free.contains(&Free::Size(i));
    let estimated = |is_seen: bool, of: &dyn Fn(&[f64]) -> f64| {
        if is_seen { fit.estimated(of) } else { EstimatedValue::given(of(x)) }
    };
    let law = |i: usize| {
        let m = |x: &[f64]| 1.0 - problem.guess(x).law.exponents[i];
        let k = |x: &[f64]| problem.guess(x).law.k_n_mm2[i];
        let moves = problem.free.contains(&Free::Exponent(i));
        IdentifiedLaw {
            letter: LETTERS[i],
            k_n_mm2: estimated(seen(i), &k),
            exponent: estimated(moves, &m),
            at_reference_n_mm2: estimated(seen(i), &|x| {
                k(x) * math::exp(-m(x) * math::ln(*reference_mm))
            }),
            seen: seen(i),
        }
    };
    // Teeth are counted from the one furthest out.
    let teeth = cut.tool.teeth as usize;
    let guess = problem.guess(x);
    let first = (0..teeth)
        .fold(0, |best, j| if guess.runout_mm[j] > guess.runout_mm[best] { j } else { best });
    let out_um = |x: &[f64], j: usize| 1000.0 * problem.guess(x).runout_mm[(first + j) % teeth];
    let runout_um: Vec<EstimatedValue> =
        (0..teeth).map(|j| estimated(teeth > 1, &|x| out_um(x, j))).collect();
    let share = |j: usize| runout_share(j, teeth);
    let shares: f64 = (0..teeth).map(|j| share(j) * share(j)).sum();
    let shift =
        |x: &[f64]| (0..teeth).map(|j| share(j) * out_um(x, j)).sum::<f64>() / shares.max(1e-12);
    let shift_um = if teeth > 1 { fit.estimated(&shift) } else { EstimatedValue::given(0.0) };
    let off = |j: usize| (out_um(x, j) - shift_um.value * share(j)).abs();
    let turned = |phase_rad: f64| {
        let turns = (phase_rad - math::TAU * first as f64 / teeth as f64) / math::TAU;
        360.0 * (turns - turns.floor())
    };
    let phase = fit.estimated(&|x| 360.0 / math::TAU * problem.guess(x).phase_rad);
    let (condition, shares) = fit.weakest();
    let mut not_apart: Vec<String> = Vec::new();
    if condition > NOT_APART || !condition.is_finite() {
        let part = problem.free.iter().zip(&shares).filter(|(_, share)| **share > PART);
        not_apart.extend(part.map(|(free, _)| free.name()));
        not_apart.dedup();
    }
    let size = 1.0 / (problem.weights[0] / folded.counts[0].sqrt());
    let squares = left * size * size;
    let count = (folded.samples * folded.axes.len()) as f64;
    let places = (folded.counts.len() * folded.axes.len()) as f64;
    let misfit = (count > 2.0 * places && folded.within > 0.0).then(|| {
        let between = squares / (places - x.len() as f64).max(1.0);
        between / (folded.within / (count - places))
    });
    let forces = problem.forces(x);
    let most_out = guess.runout_mm[..teeth].iter().fold(0.0, |most: f64, x| most.max(*x));
    let least_out = guess.runout_mm[..teeth].iter().fold(0.0, |least: f64, x| least.min(*x));
    let mut squares_of_means = 0.0;
    let mut turn = Vec::with_capacity(forces.len());
    for (i, force) in forces.iter().enumerate() {
        let pairs: Vec<[f64; 2]> = folded
            .axes
            .iter()
            .zip(&folded.means_n)
            .map(|(axis, means)| [means[i], axis.of(*force)])
            .collect();
        squares_of_means += pairs.iter().map(|[a, b]| (a - b) * (a - b)).sum::<f64>();
        turn.push((360.0 / math::TAU * folded.angles_rad[i], pairs));
    }
    ForceFit {
        laws: [law(0), law(1), law(2)],
        reference_mm: *reference_mm,
        thickest_mm: cut.feed_per_tooth_mm() + (most_out - least_out) + mm_from_um(1.0),
        runout_um,
        shift_rest_um: (0..teeth).map(off).fold(0.0, f64::max),
        shift_um,
        phase_deg: EstimatedValue { value: turned(guess.phase_rad), half: phase.half },
        speed_rpm: folded.speed_rpm,
        samples: folded.samples,
        turns: folded.turns,
        places: folded.counts.len(),
        rest_n: ((folded.within + squares) / count).sqrt(),
        place_rest_n: (squares_of_means / (forces.len() * folded.axes.len()) as f64).sqrt(),
        r2: 1.0 - (folded.within + squares) / folded.total,
        repeated_r2: 1.0 - squares / (folded.total - folded.within).max(f64::MIN_POSITIVE),
        misfit,
        condition,
        not_apart,
        turn,
    }
}
