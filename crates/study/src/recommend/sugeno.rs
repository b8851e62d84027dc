//! A first-order Sugeno system with two inputs (Takagi and Sugeno 1985), as in ANFIS (Jang 1993).
//!
//! ```text
//! mu(x) = exp(-(x - c)^2 / (2 s^2))          one Gaussian per membership of an input
//! w_ij  = mu_i(x_1) mu_j(x_2)                one rule per pair: a grid
//! y     = sum w_ij (p_ij x_1 + q_ij x_2 + r_ij) / sum w_ij
//! ```
//!
//! Inputs are normalised: their training data lie in 0 to 1. Far outside all strengths would
//! underflow together; callers keep inputs inside.

use crate::base::math;

/// A Gaussian membership.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gaussian {
    /// Centre c, where the membership is 1.
    pub centre: f64,
    /// Width s, positive.
    pub width: f64,
}

impl Gaussian {
    /// Membership of `x`, above 0 up to 1.
    #[must_use]
    pub fn of(&self, x: f64) -> f64 {
        let off = (x - self.centre) / self.width;
        math::exp(-0.5 * off * off)
    }

    /// Derivatives of the membership's logarithm by centre and width.
    fn log_slopes(&self, x: f64) -> [f64; 2] {
        let off = (x - self.centre) / self.width;
        [off / self.width, off * off / self.width]
    }
}

/// The system.
#[derive(Clone, Debug, PartialEq)]
pub struct Sugeno {
    /// Memberships of the two inputs.
    pub memberships: [Vec<Gaussian>; 2],
    /// [p, q, r] of every rule; rule i n + j joins membership i of the first input with membership
    /// j of the second, which has n.
    pub consequents: Vec<[f64; 3]>,
}

impl Sugeno {
    /// A system with `counts` memberships evenly spaced over 0 to 1, neighbours crossing at one
    /// half, and consequents of zero. Each count is at least 1.
    #[must_use]
    pub fn on_grid(counts: [usize; 2]) -> Self {
        let memberships = counts.map(|count| {
            let distance = 1.0 / (count.max(2) - 1) as f64;
            // At half the distance the membership is 1/2: s = d / (2 sqrt(2 ln 2)).
            let width = distance / (2.0 * (2.0 * math::ln(2.0)).sqrt());
            (0..count).map(|i| Gaussian { centre: i as f64 * distance, width }).collect()
        });
        Self { memberships, consequents: vec![[0.0; 3]; counts[0] * counts[1]] }
    }

    /// The two memberships that rule `rule` joins.
    #[must_use]
    pub fn joined(&self, rule: usize) -> [usize; 2] {
        let second = self.memberships[1].len();
        [rule / second, rule % second]
    }

    /// Normalised strengths of all rules: positive, their sum is 1.
    #[must_use]
    pub fn strengths(&self, x: [f64; 2]) -> Vec<f64> {
        let [first, second] = [0, 1].map(|axis| {
            self.memberships[axis].iter().map(|one| one.of(x[axis])).collect::<Vec<f64>>()
        });
        let all = first.iter().flat_map(|a| second.iter().map(move |b| a * b));
        let all: Vec<f64> = all.collect();
        let sum: f64 = all.iter().sum();
        all.into_iter().map(|strength| strength / sum).collect()
    }

    /// What rule `rule` alone would answer.
    #[must_use]
    pub fn rule_value(&self, rule: usize, x: [f64; 2]) -> f64 {
        let [p, q, r] = self.consequents[rule];
        p * x[0] + q * x[1] + r
    }

    /// The answer.
    #[must_use]
    pub fn value(&self, x: [f64; 2]) -> f64 {
        let strengths = self.strengths(x);
        strengths.iter().enumerate().map(|(rule, w)| w * self.rule_value(rule, x)).sum()
    }

    /// Derivatives of the answer by centre and width of every membership, input by input: with
    /// w the normalised strength of a rule and f its value, dy = sum w (f - y) dln(mu).
    #[must_use]
    pub fn premise_slopes(&self, x: [f64; 2]) -> [Vec<[f64; 2]>; 2] {
        let strengths = self.strengths(x);
        let values: Vec<f64> = (0..strengths.len()).map(|rule| self.rule_value(rule, x)).collect();
        let y: f64 = strengths.iter().zip(&values).map(|(w, f)| w * f).sum();
        let mut slopes = [0, 1].map(|axis: usize| vec![[0.0; 2]; self.memberships[axis].len()]);
        for (rule, (w, f)) in strengths.iter().zip(&values).enumerate() {
            for (axis, member) in self.joined(rule).into_iter().enumerate() {
                let log = self.memberships[axis][member].log_slopes(x[axis]);
                for (slope, log) in slopes[axis][member].iter_mut().zip(log) {
                    *slope += w * (f - y) * log;
                }
            }
        }
        slopes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn example() -> Sugeno {
        let mut system = Sugeno::on_grid([2, 3]);
        for (i, rule) in system.consequents.iter_mut().enumerate() {
            let i = i as f64;
            *rule = [1.0 - 0.3 * i, 0.2 * i, 0.5 * i - 1.0];
        }
        system.memberships[1][1] = Gaussian { centre: 0.4, width: 0.3 };
        system
    }

    #[test]
    fn strengths_share_one_and_neighbours_cross_at_a_half() {
        let system = example();
        for x in [[0.0, 0.0], [0.31, 0.77], [1.0, 0.2], [0.5, 1.0]] {
            let strengths = system.strengths(x);
            assert!((strengths.iter().sum::<f64>() - 1.0).abs() < 1e-15);
            assert!(strengths.iter().all(|w| *w > 0.0));
            // The answer lies between those of the rules.
            let values: Vec<f64> = (0..6).map(|rule| system.rule_value(rule, x)).collect();
            let [low, high] = math::extent(values.into_iter());
            assert!((low..=high).contains(&system.value(x)));
        }
        let grid = Sugeno::on_grid([3, 2]);
        assert!((grid.memberships[0][1].of(0.75) - 0.5).abs() < 1e-15);
        assert!((grid.memberships[1][0].of(0.5) - 0.5).abs() < 1e-15);
        assert_eq!((grid.memberships[0][2].centre, grid.joined(3)), (1.0, [1, 1]));
    }

    #[test]
    fn a_rule_s_answer_is_reached_where_it_alone_fires() {
        let mut system = example();
        for one in system.memberships.iter_mut().flatten() {
            one.width = 0.05;
        }
        assert!((system.value([1.0, 0.4]) - system.rule_value(4, [1.0, 0.4])).abs() < 1e-9);
    }

    #[test]
    fn slopes_agree_with_differences() {
        let system = example();
        let x = [0.37, 0.62];
        let slopes = system.premise_slopes(x);
        for (axis, members) in slopes.iter().enumerate() {
            for (member, pair) in members.iter().enumerate() {
                for (k, slope) in pair.iter().enumerate() {
                    let moved = |by: f64| {
                        let mut moved = system.clone();
                        let one = &mut moved.memberships[axis][member];
                        *(if k == 0 { &mut one.centre } else { &mut one.width }) += by;
                        moved.value(x)
                    };
                    let difference = (moved(1e-6) - moved(-1e-6)) / 2e-6;
                    assert!((slope - difference).abs() < 1e-8, "{axis} {member} {k}");
                }
            }
        }
    }
}
