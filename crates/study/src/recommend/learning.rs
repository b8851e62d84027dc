//! Hybrid learning of a Sugeno system (Jang 1993): in every epoch the consequents by least squares
//! for the premises as they are, then one step of the premises down the gradient.

use crate::base::cholesky;
use crate::base::math::limit;
use crate::recommend::sugeno::Sugeno;

/// How a system learns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SugenoRecipe {
    /// Memberships of the two inputs.
    pub counts: [usize; 2],
    /// Weight of the squared consequents beside the squared errors; positive.
    pub ridge: f64,
    /// Epochs of both steps.
    pub epochs: u32,
    /// Rate of a premise step down the gradient of half the squared errors, and its largest length.
    pub rate: f64,
    /// Least and largest width of a membership.
    pub widths: [f64; 2],
}

/// One pattern: normalised inputs and target.
pub type Pattern = ([f64; 2], f64);

/// Learns the patterns. With any ridge above zero there is one answer, however few they are.
#[must_use]
pub fn learn(recipe: &SugenoRecipe, patterns: &[Pattern]) -> Sugeno {
    let mut system = Sugeno::on_grid(recipe.counts);
    for _ in 0..recipe.epochs {
        fit_consequents(&mut system, recipe.ridge, patterns);
        step_premises(&mut system, recipe, patterns);
    }
    fit_consequents(&mut system, recipe.ridge, patterns);
    system
}

/// Error of each pattern when all others are learned and it is asked.
#[must_use]
pub fn leave_one_out(recipe: &SugenoRecipe, patterns: &[Pattern]) -> Vec<f64> {
    let left_out = |i: usize| {
        let others: Vec<Pattern> = [&patterns[..i], &patterns[i + 1..]].concat();
        let (x, target) = patterns[i];
        learn(recipe, &others).value(x) - target
    };
    (0..patterns.len()).map(left_out).collect()
}

/// Regressors of a pattern: strength times x_1, x_2 and 1, rule by rule.
fn regressors(system: &Sugeno, x: [f64; 2]) -> Vec<f64> {
    system.strengths(x).into_iter().flat_map(|w| [w * x[0], w * x[1], w]).collect()
}

fn fit_consequents(system: &mut Sugeno, ridge: f64, patterns: &[Pattern]) {
    let n = 3 * system.consequents.len();
    let mut normal = vec![vec![0.0; n]; n];
    let mut right = vec![0.0; n];
    for (i, row) in normal.iter_mut().enumerate() {
        row[i] = ridge;
    }
    for (x, target) in patterns {
        let regressors = regressors(system, *x);
        for (i, a) in regressors.iter().enumerate() {
            right[i] += a * target;
            for (j, b) in regressors.iter().enumerate().take(i + 1) {
                normal[i][j] += a * b;
            }
        }
    }
    // The ridge keeps the matrix positive definite; where rounding leaves nothing of it, the
    // consequents stay.
    if let Some(solved) = cholesky::solve(normal, right, 0.0) {
        for (rule, part) in system.consequents.iter_mut().zip(solved.chunks_exact(3)) {
            rule.copy_from_slice(part);
        }
    }
}

fn step_premises(system: &mut Sugeno, recipe: &SugenoRecipe, patterns: &[Pattern]) {
    let mut gradient = system.memberships.each_ref().map(|axis| vec![[0.0; 2]; axis.len()]);
    for (x, target) in patterns {
        let error = system.value(*x) - target;
        for (sums, slopes) in gradient.iter_mut().zip(system.premise_slopes(*x)) {
            for (sum, slope) in sums.iter_mut().zip(slopes) {
                *sum = [sum[0] + error * slope[0], sum[1] + error * slope[1]];
            }
        }
    }
    let squares = gradient.iter().flatten().flatten().map(|slope| slope * slope);
    // No step is longer than the rate, so that large errors of a large table do not throw the
    // premises about.
    let step = recipe.rate / squares.sum::<f64>().sqrt().max(1.0);
    let [least, largest] = recipe.widths;
    for (members, slopes) in system.memberships.iter_mut().zip(gradient) {
        for (one, [centre, width]) in members.iter_mut().zip(slopes) {
            one.centre -= step * centre;
            one.width = limit(one.width - step * width, least, largest);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RECIPE: SugenoRecipe =
        SugenoRecipe { counts: [2, 3], ridge: 1e-9, epochs: 20, rate: 0.02, widths: [0.08, 2.0] };

    fn patterns(of: impl Fn([f64; 2]) -> f64) -> Vec<Pattern> {
        let inputs =
            (0..7).flat_map(|i| (0..7).map(move |k| [f64::from(i) / 6.0, f64::from(k) / 6.0]));
        inputs.map(|x| (x, of(x))).collect()
    }

    fn rms(errors: &[f64]) -> f64 {
        (errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64).sqrt()
    }

    #[test]
    fn a_plane_is_reproduced_also_between_and_without_one_of_its_points() {
        let plane = |[x, y]: [f64; 2]| 2.0 - 0.7 * x + 1.3 * y;
        let patterns = patterns(plane);
        let system = learn(&RECIPE, &patterns);
        for x in [[0.0, 0.0], [0.41, 0.87], [1.0, 0.5]] {
            let off = system.value(x) - plane(x);
            assert!(off.abs() < 1e-6, "{x:?}: {off}");
        }
        let left_out = leave_one_out(&SugenoRecipe { epochs: 2, ..RECIPE }, &patterns);
        assert_eq!(left_out.len(), patterns.len());
        assert!(rms(&left_out) < 1e-4, "{left_out:?}");
    }

    #[test]
    fn least_squares_leave_residuals_across_every_regressor() {
        let patterns = patterns(|[x, y]| (x - 0.3) * (x - 0.3) * y + x);
        let mut system = Sugeno::on_grid([2, 2]);
        let ridge = 1e-3;
        fit_consequents(&mut system, ridge, &patterns);
        // The normal equations: A'(A t - y) + ridge t = 0.
        let mut left = system.consequents.concat().iter().map(|t| ridge * t).collect::<Vec<_>>();
        for (x, target) in &patterns {
            let error = system.value(*x) - target;
            for (sum, a) in left.iter_mut().zip(regressors(&system, *x)) {
                *sum += a * error;
            }
        }
        assert!(left.iter().all(|sum| sum.abs() < 1e-12), "{left:?}");
    }

    #[test]
    fn premises_learn_what_consequents_cannot_and_keep_their_widths() {
        let patterns = patterns(|[x, y]| if x > 0.6 { 1.0 + y } else { 0.0 });
        let error = |recipe: &SugenoRecipe| {
            let system = learn(recipe, &patterns);
            for one in system.memberships.iter().flatten() {
                assert!((recipe.widths[0]..=recipe.widths[1]).contains(&one.width));
            }
            let errors: Vec<f64> = patterns.iter().map(|(x, t)| system.value(*x) - t).collect();
            rms(&errors)
        };
        let still = error(&SugenoRecipe { epochs: 0, ..RECIPE });
        assert!(error(&SugenoRecipe { epochs: 50, ..RECIPE }) < 0.8 * still, "{still}");
        // Few patterns, many parameters: the ridge still gives one answer.
        let few = learn(&SugenoRecipe { ridge: 1e-3, ..RECIPE }, &patterns[..3]);
        assert!(few.value([0.5, 0.5]).is_finite());
    }
}
