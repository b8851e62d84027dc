//! What a plan can tell, before a chip is cut: the model matrix X of a declared model, whose columns are its
//! terms and whose rows its runs.
//!
//! ```text
//! X = Q R                                    by Gram and Schmidt, columns scaled to length 1
//! h_i = |row i of Q|^2                       leverage: how much run i pulls at its own value; sum = number of terms
//! C = (X'X)^-1, s_j = sigma C_jj^1/2         standard error of constant j at a measuring noise sigma
//! VIF_j = C_jj sum (x_ij - mean_j)^2         variance inflation: 1 where the term stands alone
//! kappa = largest / least singular value     condition
//! s(x) = sigma (x' C x)^1/2                  standard error of a prediction
//! ```
//!
//! A term whose column the terms before it give exactly is aliased with them: only sums of their constants can be
//! told. A variance inflation above 10 is the usual sign of terms that go together (Montgomery, Peck and Vining,
//! Introduction to linear regression analysis); above 100 they are hardly told apart.

use nalgebra::DMatrix;
use serde::Serialize;

use super::plan::ExperimentPlan;
use super::terms::TermSet;
use crate::base::stats;

/// What is left of a column of length 1 that counts as nothing.
const NOTHING: f64 = 1e-9;
/// Variance inflation above which a term is badly told, and hardly.
const WEAK: f64 = 10.0;
const HARDLY: f64 = 100.0;
/// Correlation of two terms from which on the pair is told.
const CORRELATED: f64 = 0.3;

steadycut_core::choice! {
    /// How well a plan tells a term from the others.
    pub enum TermVerdict {
        /// Well.
        Told = "told", "told";
        /// Badly: its variance inflation is above 10.
        Weak = "weak", "badly told";
        /// Hardly: it is above 100.
        Hardly = "hardly", "HARDLY TOLD";
        /// Not at all: other terms give its column exactly.
        Aliased = "aliased", "NOT TOLD";
    }
}

/// Standard deviations of a measured force and of a measured Ra.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct MeasuringNoise {
    /// Of the force, N.
    pub force_n: f64,
    /// Of the roughness, um.
    pub ra_um: f64,
}

impl Default for MeasuringNoise {
    /// Some 1 % of the papers' forces, and 3 % of their Ra (chosen).
    fn default() -> Self {
        Self { force_n: 2.0, ra_um: 0.02 }
    }
}

/// A term that is given by others: itself, and the factor of each of them.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TermRelation {
    /// The term.
    pub term: String,
    /// The terms that give it, with their factors.
    pub given_by: Vec<(String, f64)>,
}

impl std::fmt::Display for TermRelation {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} =", self.term)?;
        for (place, (term, by)) in self.given_by.iter().enumerate() {
            let sign = match (*by < 0.0, place) {
                (true, _) => " -",
                (false, 0) => "",
                (false, _) => " +",
            };
            let size = by.abs();
            if (size - 1.0).abs() < 1e-6 {
                write!(f, "{sign} {term}")?;
            } else {
                write!(f, "{sign} {size:.4} {term}")?;
            }
        }
        Ok(())
    }
}

/// What is told of a term.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TermAssessment {
    /// Its name.
    pub term: String,
    /// How well it is told.
    pub verdict: TermVerdict,
    /// Standard error of its constant for a force, in N over the term's unit; none where it is aliased.
    pub standard_error_n: Option<f64>,
    /// The same for Ra, in um.
    pub standard_error_um: Option<f64>,
    /// Its variance inflation; none of the constant, and where it is aliased.
    pub inflation: Option<f64>,
    /// The term that it goes with most, and their correlation.
    pub nearest: Option<(String, f64)>,
}

/// Standard errors of predictions over the runs and over the box of the factors, N for a force.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PredictionAssessment {
    /// Root of the mean square over the runs.
    pub at_runs_n: f64,
    /// The largest at corners, middles of edges and the middle of the box.
    pub worst_n: f64,
    /// That in the middle of the box, with the first cutter.
    pub middle_n: f64,
    /// The largest, for Ra, um.
    pub worst_um: f64,
}

/// What a plan can tell.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ExperimentAssessment {
    /// Number of runs.
    pub runs: usize,
    /// The terms.
    pub terms: Vec<TermAssessment>,
    /// Number of terms that can be told at the same time.
    pub rank: usize,
    /// Runs left over to estimate the noise from.
    pub freedom: usize,
    /// Of these, those that repeat another run: they tell noise from a lack of fit.
    pub repeated: usize,
    /// Terms that others give exactly.
    pub aliases: Vec<TermRelation>,
    /// Pairs of terms with their correlation, the largest first, from 0.3 on.
    pub correlated: Vec<(String, String, f64)>,
    /// Condition of the columns of length 1.
    pub condition: f64,
    /// Leverage of each run, in standard order.
    pub leverages: Vec<f64>,
    /// Predictions.
    pub prediction: PredictionAssessment,
    /// The noise that standard errors are for.
    pub noise: MeasuringNoise,
}

/// Columns by Gram and Schmidt.
struct Orthogonal {
    /// Numbers of the terms that are kept.
    kept: Vec<usize>,
    q: Vec<Vec<f64>>,
    /// Upper triangle, a column for each kept term.
    r: Vec<Vec<f64>>,
    /// Lengths of all columns.
    lengths: Vec<f64>,
    /// For a term that is not kept, its factors of the kept ones before it, in columns of length 1.
    dropped: Vec<(usize, Vec<f64>)>,
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl Orthogonal {
    fn new(columns: &[Vec<f64>]) -> Self {
        let mut this = Self {
            kept: Vec::new(),
            q: Vec::new(),
            r: Vec::new(),
            lengths: columns.iter().map(|column| dot(column, column).sqrt()).collect(),
            dropped: Vec::new(),
        };
        for (term, column) in columns.iter().enumerate() {
            let length = this.lengths[term];
            let unit = if length > 0.0 { 1.0 / length } else { 0.0 };
            let mut rest: Vec<f64> = column.iter().map(|x| x * unit).collect();
            let mut shares = vec![0.0; this.q.len()];
            // Twice is enough (Kahan).
            for _ in 0..2 {
                for (share, q) in shares.iter_mut().zip(&this.q) {
                    let part = dot(q, &rest);
                    *share += part;
                    rest.iter_mut().zip(q).for_each(|(x, q)| *x -= part * q);
                }
            }
            let left = dot(&rest, &rest).sqrt();
            if left < NOTHING {
                let factors = this.back(&shares);
                this.dropped.push((term, factors));
                continue;
            }
            rest.iter_mut().for_each(|x| *x /= left);
            shares.push(left);
            this.kept.push(term);
            this.q.push(rest);
            this.r.push(shares);
        }
        this
    }

    /// Solves R x = b.
    fn back(&self, b: &[f64]) -> Vec<f64> {
        let mut x = b.to_vec();
        for j in (0..x.len()).rev() {
            x[j] /= self.r[j][j];
            let at = x[j];
            for (x, r) in x[..j].iter_mut().zip(&self.r[j]) {
                *x -= r * at;
            }
        }
        x
    }

    /// x' C x for a row of all terms.
    fn variance(&self, row: &[f64]) -> f64 {
        let mut z: Vec<f64> = Vec::with_capacity(self.kept.len());
        for (j, term) in self.kept.iter().enumerate() {
            let known = dot(&self.r[j][..j], &z);
            z.push((row[*term] / self.lengths[*term] - known) / self.r[j][j]);
        }
        dot(&z, &z)
    }

    /// C_jj of the kept columns of length 1.
    fn variances(&self) -> Vec<f64> {
        let count = self.kept.len();
        let mut variances = vec![0.0; count];
        for column in 0..count {
            let mut unit = vec![0.0; count];
            unit[column] = 1.0;
            for (variance, x) in variances.iter_mut().zip(self.back(&unit)) {
                *variance += x * x;
            }
        }
        variances
    }

    fn condition(&self) -> f64 {
        let count = self.kept.len();
        let r = DMatrix::from_fn(count, count, |i, j| if i <= j { self.r[j][i] } else { 0.0 });
        let values = r.singular_values();
        values.max() / values.min()
    }
}

/// Rows at corners, middles of edges and faces, and the middle of the box, for every cutter.
fn box_rows(plan: &ExperimentPlan, terms: &TermSet) -> Vec<Vec<f64>> {
    let levels: Vec<usize> =
        plan.factors.iter().map(|factor| factor.cutters().map_or(3, <[_]>::len)).collect();
    let count: usize = levels.iter().product();
    let row = |number: usize| {
        let mut rest = number;
        let values: Vec<f64> = plan
            .factors
            .iter()
            .zip(&levels)
            .map(|(factor, levels)| {
                let level = rest % levels;
                rest /= levels;
                match factor.cutters() {
                    Some(_) => level as f64,
                    None => {
                        let [low, high] = factor.range();
                        low + 0.5 * level as f64 * (high - low)
                    }
                }
            })
            .collect();
        terms.row(plan, &values)
    };
    (0..count).map(row).filter(|row: &Vec<f64>| row.iter().all(|x| x.is_finite())).collect()
}

fn middle(plan: &ExperimentPlan) -> Vec<f64> {
    let value = |factor: &super::factor::ExperimentFactor| match factor.cutters() {
        Some(_) => 0.0,
        None => 0.5 * (factor.range()[0] + factor.range()[1]),
    };
    plan.factors.iter().map(value).collect()
}

/// Says what a plan can tell of the terms of a declared model.
#[must_use]
pub fn assess(
    plan: &ExperimentPlan,
    terms: &TermSet,
    noise: MeasuringNoise,
) -> ExperimentAssessment {
    let rows: Vec<Vec<f64>> = plan.runs.iter().map(|run| terms.row(plan, &run.values)).collect();
    let column = |term: usize| rows.iter().map(|row| row[term]).collect::<Vec<f64>>();
    let columns: Vec<Vec<f64>> = (0..terms.names.len()).map(column).collect();
    let parts = Orthogonal::new(&columns);
    let variances = parts.variances();
    let aliases: Vec<TermRelation> = parts
        .dropped
        .iter()
        .map(|(term, factors)| relation(*term, factors, &parts, terms))
        .collect();
    let mixed = |name: &String| {
        aliases.iter().any(|alias| {
            alias.term == *name || alias.given_by.iter().any(|(other, _)| other == name)
        })
    };
    let correlated = correlated(&columns, terms);
    let told = |term: usize| {
        let name = &terms.names[term];
        let aliased = mixed(name);
        let place = parts.kept.iter().position(|kept| *kept == term).filter(|_| !aliased);
        let unit = place.map(|place| variances[place].sqrt() / parts.lengths[term]);
        let inflation = place.and_then(|place| inflation(&columns[term], variances[place]));
        let nearest = nearest(term, &columns, terms);
        let verdict = match inflation {
            _ if aliased => TermVerdict::Aliased,
            Some(inflation) if inflation > HARDLY => TermVerdict::Hardly,
            Some(inflation) if inflation > WEAK => TermVerdict::Weak,
            Some(_) | None => TermVerdict::Told,
        };
        TermAssessment {
            term: name.clone(),
            verdict,
            standard_error_n: unit.map(|unit| unit * noise.force_n),
            standard_error_um: unit.map(|unit| unit * noise.ra_um),
            inflation,
            nearest,
        }
    };
    let told: Vec<TermAssessment> = (0..terms.names.len()).map(told).collect();
    let leverage = |run: usize| parts.q.iter().map(|q| q[run] * q[run]).sum();
    let leverages: Vec<f64> = (0..rows.len()).map(leverage).collect();
    let worst = box_rows(plan, terms).iter().map(|row| parts.variance(row)).fold(0.0, f64::max);
    let worst = worst.sqrt();
    let at_runs = (leverages.iter().sum::<f64>() / rows.len().max(1) as f64).sqrt();
    let rank = parts.kept.len();
    ExperimentAssessment {
        runs: rows.len(),
        terms: told,
        rank,
        freedom: rows.len().saturating_sub(rank),
        repeated: repeated(plan),
        aliases,
        correlated,
        condition: parts.condition(),
        leverages,
        prediction: PredictionAssessment {
            at_runs_n: at_runs * noise.force_n,
            worst_n: worst * noise.force_n,
            middle_n: parts.variance(&terms.row(plan, &middle(plan))).sqrt() * noise.force_n,
            worst_um: worst * noise.ra_um,
        },
        noise,
    }
}

fn relation(term: usize, factors: &[f64], parts: &Orthogonal, terms: &TermSet) -> TermRelation {
    let length = parts.lengths[term];
    let given_by = factors
        .iter()
        .zip(&parts.kept)
        .filter(|(factor, _)| factor.abs() > 1e-7)
        .map(|(factor, kept)| (terms.names[*kept].clone(), factor * length / parts.lengths[*kept]))
        .collect();
    TermRelation { term: terms.names[term].clone(), given_by }
}

/// None of a column that does not vary.
fn inflation(column: &[f64], variance: f64) -> Option<f64> {
    let mean = stats::mean(column.iter().copied())?;
    let about: f64 = column.iter().map(|x| (x - mean) * (x - mean)).sum();
    let whole = dot(column, column);
    (about > 1e-12 * whole).then(|| variance * about / whole)
}

fn correlated(columns: &[Vec<f64>], terms: &TermSet) -> Vec<(String, String, f64)> {
    let pairs = (0..columns.len()).flat_map(|a| (a + 1..columns.len()).map(move |b| (a, b)));
    let mut found: Vec<(String, String, f64)> = pairs
        .filter_map(|(a, b)| {
            let r = stats::correlation(&columns[a], &columns[b])?;
            (r.abs() >= CORRELATED).then(|| (terms.names[a].clone(), terms.names[b].clone(), r))
        })
        .collect();
    found.sort_by(|a, b| b.2.abs().total_cmp(&a.2.abs()));
    found
}

fn nearest(term: usize, columns: &[Vec<f64>], terms: &TermSet) -> Option<(String, f64)> {
    let others = (0..columns.len()).filter(|other| *other != term).filter_map(|other| {
        let r = stats::correlation(&columns[term], &columns[other])?;
        (r.abs() >= CORRELATED).then(|| (terms.names[other].clone(), r))
    });
    others.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))
}

/// Runs that repeat an earlier one.
fn repeated(plan: &ExperimentPlan) -> usize {
    let runs = &plan.runs;
    let is_again =
        |place: usize| runs[..place].iter().any(|other| other.values == runs[place].values);
    (0..runs.len()).filter(|place| is_again(*place)).count()
}
