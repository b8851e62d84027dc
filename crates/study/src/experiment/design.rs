//! The designs: which combinations of coded levels are cut, -1 the low and 1 the high end of a range.

use super::fraction::RegularFraction;
use super::latin::latin_hypercube;
use crate::base::math;

steadycut_core::choice! {
    /// What a run of a design is.
    pub enum RunRole {
        /// A corner or grid point of a factorial.
        Factorial = "factorial", "factorial";
        /// On the axis of one factor, beside the factorial of a composite design.
        Star = "star", "star";
        /// All factors in the middle.
        Centre = "centre", "centre";
        /// A point of a Latin hypercube.
        Hypercube = "hypercube", "hypercube";
        /// On the line from the corner of least feed and largest speed to the opposite one.
        Line = "line", "line";
        /// A row of a table.
        Given = "given", "given";
    }
}

/// How far the stars of a composite design stand from the middle, over its factorial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StarDistance {
    /// 1: every factor has three levels.
    Faced,
    /// The fourth root of the number of factorial runs: the variance of a prediction depends on the distance
    /// from the middle alone (Box and Hunter 1957).
    Rotatable,
    /// Another one.
    Given(f64),
}

impl StarDistance {
    /// The distance beside `runs` factorial runs.
    #[must_use]
    pub fn alpha(self, runs: usize) -> f64 {
        match self {
            Self::Faced => 1.0,
            Self::Rotatable => math::power(runs as f64, 0.25),
            Self::Given(alpha) => alpha,
        }
    }
}

/// A point of a design.
#[derive(Clone, Debug, PartialEq)]
pub struct DesignPoint {
    /// Coded levels of the factors with a range, -1 to 1.
    pub coded: Vec<f64>,
    /// What it is.
    pub role: RunRole,
}

fn points(coded: impl IntoIterator<Item = Vec<f64>>, role: RunRole) -> Vec<DesignPoint> {
    coded.into_iter().map(|coded| DesignPoint { coded, role }).collect()
}

/// `count` runs with all of `factors` in the middle.
#[must_use]
pub fn centres(factors: usize, count: usize) -> Vec<DesignPoint> {
    points(vec![vec![0.0; factors]; count], RunRole::Centre)
}

/// All combinations of evenly spaced levels, the first factor fastest.
#[must_use]
pub fn full_factorial(levels: &[usize]) -> Vec<DesignPoint> {
    let runs: usize = levels.iter().product();
    let run = |number: usize| {
        let mut rest = number;
        levels
            .iter()
            .map(|levels| {
                let level = rest % levels;
                rest /= levels;
                if *levels > 1 { 2.0 * level as f64 / (levels - 1) as f64 - 1.0 } else { 0.0 }
            })
            .collect()
    };
    points((0..runs).map(run), RunRole::Factorial)
}

/// The runs of a two-level fraction.
#[must_use]
pub fn two_levels(fraction: &RegularFraction) -> Vec<DesignPoint> {
    points(fraction.points(), RunRole::Factorial)
}

/// A composite design of a two-level factorial, two stars a factor, and the middle. Its outermost points stand at
/// the ends of the ranges: with stars further out than the factorial the factorial stands within.
#[must_use]
pub fn composite(
    fraction: &RegularFraction,
    stars: StarDistance,
    middle: usize,
) -> Vec<DesignPoint> {
    let corners = fraction.points();
    let factors = corners.first().map_or(0, Vec::len);
    let alpha = stars.alpha(fraction.runs());
    let outermost = alpha.max(1.0);
    let scaled = |x: f64| if x.abs() == outermost { x.signum() } else { x / outermost };
    let corners = corners.into_iter().map(|run| run.into_iter().map(scaled).collect());
    let star = |number: usize| {
        let mut point = vec![0.0; factors];
        point[number / 2] = scaled(if number.is_multiple_of(2) { -alpha } else { alpha });
        point
    };
    let mut all = points(corners, RunRole::Factorial);
    all.extend(points((0..2 * factors).map(star), RunRole::Star));
    all.extend(centres(factors, middle));
    all
}

/// A Latin hypercube.
#[must_use]
pub fn hypercube(count: usize, factors: usize, seed: u64) -> Vec<DesignPoint> {
    points(latin_hypercube(count, factors, seed), RunRole::Hypercube)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dot(all: &[DesignPoint], a: usize, b: usize) -> f64 {
        all.iter().map(|point| point.coded[a] * point.coded[b]).sum()
    }

    #[test]
    fn factorials_are_balanced_and_orthogonal() {
        let all = full_factorial(&[3, 4, 2]);
        assert_eq!(all.len(), 24);
        for a in 0..3 {
            let sum: f64 = all.iter().map(|point| point.coded[a]).sum();
            assert!(sum.abs() < 1e-12, "factor {a}: {sum}");
            for b in 0..a {
                assert!(dot(&all, a, b).abs() < 1e-12, "{a} {b}");
            }
        }
        assert_eq!(all[0].coded, [-1.0, -1.0, -1.0]);
        assert_eq!(all[1].coded, [0.0, -1.0, -1.0]);
        assert_eq!(all[23].coded, [1.0, 1.0, 1.0]);
    }

    /// Montgomery, table 11.9: 2^(k/4), 1.414 for two factors, 1.682 for three, 2 for four.
    #[test]
    fn rotatable_stars_stand_at_the_fourth_root_of_the_factorial() {
        for (factors, expected) in [(2, 1.414), (3, 1.682), (4, 2.0), (5, 2.378)] {
            let full = RegularFraction::full(factors).unwrap();
            let alpha = StarDistance::Rotatable.alpha(full.runs());
            assert!((alpha - expected).abs() < 5e-4, "{factors}: {alpha}");
        }
        let half = RegularFraction::standard(5, 1).unwrap();
        assert!((StarDistance::Rotatable.alpha(half.runs()) - 2.0).abs() < 1e-12);
    }

    /// Sum of x^4 is three times that of x^2 y^2 in a rotatable design of second order, and with it all of
    /// its moments of fourth order are those of a sphere.
    #[test]
    fn a_rotatable_design_has_the_moments_of_a_sphere_and_a_faced_one_not() {
        for factors in [2, 3, 4] {
            let full = RegularFraction::full(factors).unwrap();
            let moments = |stars| {
                let all = composite(&full, stars, 3);
                assert_eq!(all.len(), (1 << factors) + 2 * factors + 3);
                let most =
                    all.iter().flat_map(|point| &point.coded).fold(0.0, |a: f64, x| a.max(x.abs()));
                assert_eq!(most, 1.0, "nothing stands outside the ranges");
                let fourth: f64 =
                    all.iter().map(|p| p.coded[0] * p.coded[0] * p.coded[0] * p.coded[0]).sum();
                let mixed: f64 =
                    all.iter().map(|p| p.coded[0] * p.coded[0] * p.coded[1] * p.coded[1]).sum();
                fourth / mixed
            };
            assert!((moments(StarDistance::Rotatable) - 3.0).abs() < 1e-12);
            assert!((moments(StarDistance::Faced) - 3.0).abs() > 0.1);
        }
    }

    #[test]
    fn a_faced_design_has_three_levels_and_given_stars_may_stand_inside() {
        let full = RegularFraction::full(2).unwrap();
        let levels = |stars| {
            let mut all: Vec<f64> =
                composite(&full, stars, 1).iter().map(|point| point.coded[0]).collect();
            all.sort_by(f64::total_cmp);
            all.dedup();
            all
        };
        assert_eq!(levels(StarDistance::Faced), [-1.0, 0.0, 1.0]);
        assert_eq!(levels(StarDistance::Given(0.5)), [-1.0, -0.5, 0.0, 0.5, 1.0]);
        assert_eq!(levels(StarDistance::Given(2.0)), [-1.0, -0.5, 0.0, 0.5, 1.0]);
    }
}
