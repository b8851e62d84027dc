//! Where a formula holds: the ranges of the rows, and what interval arithmetic certifies there and on ranges
//! that are wider by 30 % of their width.

use serde::Serialize;

use super::problem::GpProblem;
use crate::base::formula::{Certificate, Formula, Interval, Trend, UncertifiedPlace};
use crate::base::language::text;

/// By how much of their width the ranges are widened on each side.
pub const WIDER: f64 = 0.3;

/// A place where something is not certain.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct UncertainPlace {
    /// Range of each input there.
    pub at: Vec<[f64; 2]>,
    /// What may happen.
    pub why: String,
}

/// What is certain over ranges.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RangeCertificate {
    /// Range of each input.
    pub ranges: Vec<[f64; 2]>,
    /// Whether the formula is finite everywhere there.
    pub finite: bool,
    /// SumBounds of its values, where it is.
    pub values: Option<[f64; 2]>,
    /// Places where it may not be.
    pub not_finite: Vec<UncertainPlace>,
    /// For each input: `rising`, `falling`, `constant`, `turning`, or `uncertain`.
    pub slopes: Vec<&'static str>,
}

/// Where a formula holds.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RangeReport {
    /// Names of the inputs.
    pub inputs: Vec<String>,
    /// On the ranges of the rows. Beyond them every value is an extrapolation.
    pub training: RangeCertificate,
    /// On the wider ranges; an input that is surely positive, as one with a unit, stays so.
    pub widened: RangeCertificate,
}

fn pair(interval: Interval) -> [f64; 2] {
    [interval.low, interval.high]
}

fn place(place: &UncertifiedPlace) -> UncertainPlace {
    UncertainPlace { at: place.at.iter().copied().map(pair).collect(), why: place.why.clone() }
}

impl RangeCertificate {
    fn of(certificate: &Certificate) -> Self {
        let slope = |trend: &Trend| match trend {
            Trend::Constant => text!("constant"),
            Trend::Rising => text!("rising"),
            Trend::Falling => text!("falling"),
            Trend::Turning => text!("turning"),
            Trend::Uncertified(_) => text!("uncertain"),
        };
        Self {
            ranges: certificate.ranges.iter().copied().map(pair).collect(),
            finite: certificate.is_finite(),
            values: certificate.values.map(pair),
            not_finite: certificate.not_finite.iter().map(place).collect(),
            slopes: certificate.trends.iter().map(slope).collect(),
        }
    }

    fn unknown(ranges: &[[f64; 2]], why: String) -> Self {
        let place = UncertainPlace { at: ranges.to_vec(), why };
        let slopes = vec!["uncertain"; ranges.len()];
        Self {
            ranges: ranges.to_vec(),
            finite: false,
            values: None,
            not_finite: vec![place],
            slopes,
        }
    }
}

impl RangeReport {
    /// Certifies a formula on the ranges of the rows and on wider ones.
    #[must_use]
    pub fn of(problem: &GpProblem, formula: &Formula) -> Self {
        let certify = |share: f64| {
            let ranges = problem.ranges(share);
            let boxed: Vec<Interval> =
                ranges.iter().map(|[low, high]| Interval::new(*low, *high)).collect();
            match formula.certify(&boxed) {
                Ok(certificate) => RangeCertificate::of(&certificate),
                Err(problem) => RangeCertificate::unknown(&ranges, problem),
            }
        };
        Self { inputs: problem.inputs.clone(), training: certify(0.0), widened: certify(WIDER) }
    }
}
