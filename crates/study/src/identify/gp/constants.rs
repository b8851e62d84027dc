//! The constants of a finished formula: fitted to the last bit, with intervals of confidence, by its
//! derivatives.

use super::fit::dot;
use super::rows::DataRows;
use crate::base::cholesky;
use crate::base::formula::{CompiledFormula, Formula, Node, Operator};
use crate::base::language::tr;

/// Share of a column that must be left for its constant to be determined.
const INDEPENDENT: f64 = 1e-7;
/// Steps of the fit.
const STEPS: usize = 30;
/// Rows above which a fit has few steps: it begins at constants that a sample of such rows has given.
const MANY: usize = 20_000;
/// Steps of the fit to so many.
const FEW_STEPS: usize = 5;

/// A constant with its interval.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedConstant {
    /// Its value.
    pub value: f64,
    /// The 95 % interval of confidence; none where the rows do not determine it at all.
    pub interval: Option<[f64; 2]>,
}

impl FittedConstant {
    /// Whether the rows determine it: its interval is narrower than the constant is large.
    #[must_use]
    pub fn is_determined(&self) -> bool {
        self.interval.is_some_and(|[low, high]| high - low <= self.value.abs())
    }
}

/// A formula fitted to rows.
#[derive(Clone, Debug)]
pub struct FittedFormula {
    /// The formula.
    pub formula: Formula,
    /// Its constants, from left to right; exponents that are whole or half are none.
    pub constants: Vec<FittedConstant>,
    /// Target minus formula, row by row.
    pub residuals: Vec<f64>,
    /// Leverage of each row.
    pub leverages: Vec<f64>,
    /// Number of constants that are fitted.
    pub fitted: usize,
    /// The formula's derivatives by its constants, with the constants as further inputs.
    slopes: Vec<CompiledFormula>,
    /// Covariance of the constants over the residual variance; none where they are not all determined.
    spread: Option<Vec<Vec<f64>>>,
}

impl FittedFormula {
    /// The same with its residuals and leverages on these rows, to which it was fitted.
    #[must_use]
    pub fn with_rows(self, rows: &DataRows) -> Self {
        let values: Vec<f64> = self.constants.iter().map(|constant| constant.value).collect();
        let target = &rows.target;
        let residuals = column(&self.formula.compile(), rows, &[]);
        let residuals = target.iter().zip(residuals).map(|(y, value)| y - value).collect();
        let jacobian: Vec<Vec<f64>> =
            self.slopes.iter().map(|slope| column(slope, rows, &values)).collect();
        let leverages = leverages(&jacobian, rows.len());
        Self { residuals, leverages, ..self }
    }

    /// Root mean square of the residuals.
    #[must_use]
    pub fn rms(&self) -> f64 {
        (dot(&self.residuals, &self.residuals) / self.residuals.len() as f64).sqrt()
    }

    /// Residual standard deviation, for the freedom that the constants leave.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        let freedom = self.residuals.len().saturating_sub(self.fitted).max(1);
        (dot(&self.residuals, &self.residuals) / freedom as f64).sqrt()
    }

    /// Leverage of a place that is no row: the variance of the formula there over that of the residuals.
    #[must_use]
    pub fn leverage_at(&self, inputs: &[f64]) -> Option<f64> {
        let spread = self.spread.as_ref()?;
        let mut values = inputs.to_vec();
        values.extend(self.constants.iter().map(|constant| constant.value));
        let slopes: Vec<f64> = self.slopes.iter().map(|slope| slope.value(&values)).collect();
        let row = |row: &Vec<f64>| dot(row, &slopes);
        let leverage: f64 = spread.iter().zip(&slopes).map(|(of, slope)| row(of) * slope).sum();
        leverage.is_finite().then_some(leverage.max(0.0))
    }

    /// Standard deviation of a new value of the target at a place.
    #[must_use]
    pub fn prediction_deviation(&self, inputs: &[f64]) -> Option<f64> {
        Some(self.deviation() * (1.0 + self.leverage_at(inputs)?).sqrt())
    }

    /// The 95 % band of the formula at a place: half its width.
    #[must_use]
    pub fn band(&self, inputs: &[f64]) -> Option<f64> {
        Some(self.band_scale() * self.leverage_at(inputs)?.sqrt())
    }

    /// The same at every row.
    #[must_use]
    pub fn bands(&self, rows: &DataRows) -> Vec<Option<f64>> {
        // It goes over all rows, so only once.
        let scale = self.band_scale();
        let mut at = vec![0.0; rows.inputs.len()];
        let mut band = |row: usize| {
            at.iter_mut().zip(&rows.inputs).for_each(|(x, column)| *x = column[row]);
            Some(scale * self.leverage_at(&at)?.sqrt())
        };
        (0..rows.len()).map(&mut band).collect()
    }

    /// Half the width of the band over the root of the leverage.
    fn band_scale(&self) -> f64 {
        let freedom = self.residuals.len().saturating_sub(self.fitted);
        t_quantile(freedom) * self.deviation()
    }

    /// Residuals in units of their own standard deviation, each estimated without its row (externally
    /// studentised).
    #[must_use]
    pub fn studentised(&self) -> Vec<f64> {
        let freedom = self.residuals.len().saturating_sub(self.fitted) as f64;
        let squares = dot(&self.residuals, &self.residuals);
        let one = |(residual, leverage): (&f64, &f64)| {
            let left = (1.0 - leverage).max(1e-9);
            let without = (squares - residual * residual / left) / (freedom - 1.0);
            if freedom > 1.0 && without > 0.0 { residual / (without * left).sqrt() } else { 0.0 }
        };
        self.residuals.iter().zip(&self.leverages).map(one).collect()
    }
}

/// Whether a part is a constant that is called by its name and fitted.
#[must_use]
pub fn is_named(node: &Node) -> bool {
    matches!(node, Node::Constant(constant) if constant.name != "pi" && constant.name != "e")
}

/// Whether an exponent is whole or half, and so not fitted.
#[must_use]
pub fn is_exponent(x: f64) -> bool {
    (2.0 * x).floor() == 2.0 * x
}

/// Which numbers of a formula are fitted.
struct Numbers {
    /// The names of its constants, where it has some: these are fitted then, and its numbers stay.
    names: Vec<String>,
    values: Vec<f64>,
}

impl Numbers {
    fn of(formula: &Formula) -> Self {
        fn collect(node: &Node, names: &mut Vec<String>) {
            if let Node::Constant(constant) = node
                && is_named(node)
                && !names.contains(&constant.name)
            {
                names.push(constant.name.clone());
            }
            node.operands().iter().for_each(|operand| collect(operand, names));
        }
        let mut names = Vec::new();
        collect(formula.root(), &mut names);
        Self { values: vec![0.0; names.len()], names }
    }

    /// The formula with every fitted number replaced: `by` is given its place and its value.
    fn replaced(&mut self, node: &Node, exponent: bool, by: &dyn Fn(usize, f64) -> Node) -> Node {
        match node {
            Node::Constant(constant) if is_named(node) => {
                let place = self.names.iter().position(|name| *name == constant.name).unwrap_or(0);
                self.values[place] = constant.value;
                by(place, constant.value)
            }
            Node::Number(x) if self.names.is_empty() && !(exponent && is_exponent(*x)) => {
                self.values.push(*x);
                by(self.values.len() - 1, *x)
            }
            Node::Number(_) | Node::Input(_) | Node::Constant(_) => node.clone(),
            Node::Unary(function, a) => Node::unary(*function, self.replaced(a, false, by)),
            Node::Binary(operator, pair) => {
                let [a, b] = &**pair;
                let a = self.replaced(a, false, by);
                let b = self.replaced(b, *operator == Operator::Power, by);
                Node::binary(*operator, a, b)
            }
        }
    }
}

/// The formula with its fitted numbers as further inputs, and these numbers.
fn opened(formula: &Formula) -> Option<(Formula, Vec<f64>)> {
    let first = formula.inputs().len();
    let mut numbers = Numbers::of(formula);
    let root = numbers.replaced(formula.root(), false, &|place, _| Node::Input(first + place));
    let mut names = formula.inputs().to_vec();
    // Names that no column can have.
    names.extend((0..numbers.values.len()).map(|number| format!("\u{1}{number}")));
    Some((Formula::new(root, &names).ok()?, numbers.values))
}

/// The formula with other fitted numbers, in the same order.
#[must_use]
pub fn closed(formula: &Formula, values: &[f64]) -> Option<Formula> {
    let mut numbers = Numbers::of(formula);
    let value = |place: usize, own: f64| Node::Number(values.get(place).copied().unwrap_or(own));
    Formula::new(numbers.replaced(formula.root(), false, &value), formula.inputs()).ok()
}

/// Digits that the constants of an exact formula are rounded to where it stays exact.
const DIGITS: usize = 12;
/// Residuals over the largest value of the target that are rounding.
const ROUNDING: f64 = 4e-15;

/// An exact formula with its constants rounded to twelve digits, where that leaves no more than rounding: what
/// was 0.039 is 0.039 then.
#[must_use]
pub fn rounded(fit: FittedFormula, rows: &DataRows) -> FittedFormula {
    let short = |constant: &FittedConstant| {
        format!("{:.*e}", DIGITS - 1, constant.value).parse().unwrap_or(constant.value)
    };
    let numbers: Vec<f64> = fit.constants.iter().map(short).collect();
    let Some(formula) = closed(&fit.formula, &numbers) else { return fit };
    let values = column(&formula.compile(), rows, &[]);
    let residuals: Vec<f64> = rows.target.iter().zip(values).map(|(y, value)| y - value).collect();
    let most = rows.target.iter().fold(0.0_f64, |most, y| most.max(y.abs()));
    let rms = (dot(&residuals, &residuals) / rows.len() as f64).sqrt();
    if rms > (2.0 * fit.rms()).max(ROUNDING * most) {
        return fit;
    }
    let by = |(constant, number): (FittedConstant, f64)| FittedConstant {
        value: number,
        interval: constant.interval.map(|[low, high]| {
            let shift = number - constant.value;
            [low + shift, high + shift]
        }),
    };
    let constants = fit.constants.into_iter().zip(numbers).map(by).collect();
    FittedFormula { formula, constants, residuals, ..fit }
}

/// Values over rows, with the numbers behind the inputs.
pub(super) fn column(program: &CompiledFormula, rows: &DataRows, numbers: &[f64]) -> Vec<f64> {
    let count = rows.inputs.len();
    let mut values = vec![0.0; count + numbers.len()];
    values[count..].copy_from_slice(numbers);
    (0..rows.len())
        .map(|row| {
            for (value, input) in values.iter_mut().zip(&rows.inputs) {
                *value = input[row];
            }
            program.value(&values)
        })
        .collect()
}

/// Fits the constants of a formula to rows, from where they are, and gives their intervals.
///
/// # Errors
/// The formula has no finite value on a row, or more constants than there are rows.
pub fn fitted(formula: &Formula, rows: &DataRows) -> Result<FittedFormula, String> {
    let (open, mut numbers) = opened(formula).ok_or_else(|| tr("the formula is too large"))?;
    let first = formula.inputs().len();
    if numbers.len() >= rows.len() {
        return Err(tr!(
            "{constants} constants cannot be fitted to {rows} rows",
            constants = numbers.len(),
            rows = rows.len()
        ));
    }
    let program = open.compile();
    let derived: Vec<Formula> =
        (0..numbers.len()).map(|k| open.derivative(first + k)).collect::<Result<_, String>>()?;
    let slopes: Vec<CompiledFormula> = derived.iter().map(Formula::compile).collect();
    let residuals = |numbers: &[f64]| -> Vec<f64> {
        let values = column(&program, rows, numbers);
        rows.target.iter().zip(values).map(|(y, value)| y - value).collect()
    };
    let mut left = residuals(&numbers);
    let mut squares = dot(&left, &left);
    if !squares.is_finite() {
        return Err(tr("the formula has no finite value on some row").to_owned());
    }
    let mut damping = 1e-6;
    if !Numbers::of(formula).names.is_empty() {
        // They may be far off: those that enter linearly come first, by least squares.
        let linear = linear(&derived, first);
        let jacobian: Vec<Vec<f64>> =
            linear.iter().map(|k| column(&slopes[*k], rows, &numbers)).collect();
        let some: Vec<f64> = linear.iter().map(|k| numbers[*k]).collect();
        let whole = |some: &[f64]| {
            let mut whole = numbers.clone();
            linear.iter().zip(some).for_each(|(k, value)| whole[*k] = *value);
            whole
        };
        let of = |some: &[f64]| residuals(&whole(some));
        let mut none = 0.0;
        if let Some((next, less, residual)) = step(&jacobian, &left, &some, squares, &mut none, &of)
        {
            (numbers, squares, left) = (whole(&next), less, residual);
        }
    }
    let steps = if rows.len() > MANY { FEW_STEPS } else { STEPS };
    for _ in 0..steps {
        let jacobian: Vec<Vec<f64>> =
            slopes.iter().map(|slope| column(slope, rows, &numbers)).collect();
        let Some((next, less, residual)) =
            step(&jacobian, &left, &numbers, squares, &mut damping, &residuals)
        else {
            break;
        };
        let done = less > squares * (1.0 - 1e-14);
        (numbers, squares, left) = (next, less, residual);
        if done {
            break;
        }
    }
    let jacobian: Vec<Vec<f64>> =
        slopes.iter().map(|slope| column(slope, rows, &numbers)).collect();
    let formula = closed(formula, &numbers).ok_or_else(|| tr("a constant is not finite"))?;
    Ok(with_intervals(formula, &numbers, jacobian, left, slopes))
}

/// Constants that enter linearly, all of them at once: the slope by none reads another of them.
fn linear(slopes: &[Formula], first: usize) -> Vec<usize> {
    let mut found: Vec<usize> = Vec::new();
    for k in 0..slopes.len() {
        let reads = |slope: usize, constant: usize| slopes[slope].reads()[first + constant];
        let apart = found.iter().all(|other| !reads(k, *other) && !reads(*other, k));
        if apart && !reads(k, k) {
            found.push(k);
        }
    }
    found
}

type Step = (Vec<f64>, f64, Vec<f64>);

/// A damped step that lowers the sum of squares, with columns of unit length.
fn step(
    jacobian: &[Vec<f64>],
    left: &[f64],
    numbers: &[f64],
    squares: f64,
    damping: &mut f64,
    residuals: &dyn Fn(&[f64]) -> Vec<f64>,
) -> Option<Step> {
    let norms: Vec<f64> =
        jacobian.iter().map(|j| dot(j, j).sqrt().max(f64::MIN_POSITIVE)).collect();
    if norms.iter().any(|norm| !norm.is_finite()) {
        return None;
    }
    for _ in 0..8 {
        let lower = (0..numbers.len())
            .map(|i| {
                let product = |j: usize| dot(&jacobian[i], &jacobian[j]) / (norms[i] * norms[j]);
                let mut row: Vec<f64> = (0..=i).map(product).collect();
                row[i] = 1.0 + *damping;
                row
            })
            .collect();
        let slope = jacobian.iter().zip(&norms).map(|(j, norm)| dot(j, left) / norm).collect();
        if let Some(step) = cholesky::solve(lower, slope, 0.0) {
            let scaled = step.iter().zip(&norms).map(|(step, norm)| step / norm);
            let next: Vec<f64> = numbers.iter().zip(scaled).map(|(x, step)| x + step).collect();
            let residual = residuals(&next);
            let less = dot(&residual, &residual);
            if less < squares {
                *damping *= 0.1;
                return Some((next, less, residual));
            }
        }
        *damping *= 10.0;
    }
    None
}

fn with_intervals(
    formula: Formula,
    numbers: &[f64],
    jacobian: Vec<Vec<f64>>,
    residuals: Vec<f64>,
    slopes: Vec<CompiledFormula>,
) -> FittedFormula {
    let (n, p) = (residuals.len(), numbers.len());
    let freedom = n - p;
    let variance = dot(&residuals, &residuals) / freedom as f64;
    let quantile = t_quantile(freedom);
    // Orthonormal columns; a constant's variance is that of 1 over what of its column the others leave.
    let norms: Vec<f64> = jacobian.iter().map(|column| dot(column, column)).collect();
    let mut constants = Vec::with_capacity(p);
    for k in 0..p {
        let mut own = jacobian[k].clone();
        let others: Vec<usize> = (0..p).filter(|other| *other != k).collect();
        let basis = orthonormal(others.iter().map(|other| &jacobian[*other]));
        for _ in 0..2 {
            for q in &basis {
                let share = dot(&own, q);
                own.iter_mut().zip(q).for_each(|(x, q)| *x -= share * q);
            }
        }
        let left = dot(&own, &own);
        let determined = left > INDEPENDENT * INDEPENDENT * norms[k] && left.is_finite();
        let half = quantile * (variance / left).sqrt();
        let value = numbers[k];
        let interval = determined.then_some([value - half, value + half]);
        constants.push(FittedConstant { value, interval });
    }
    let leverages = leverages(&jacobian, n);
    let spread = covariance(&jacobian);
    FittedFormula { formula, constants, residuals, leverages, fitted: p, slopes, spread }
}

/// Leverage of each row.
fn leverages(jacobian: &[Vec<f64>], rows: usize) -> Vec<f64> {
    let mut leverages = vec![0.0; rows];
    for q in orthonormal(jacobian.iter()) {
        leverages.iter_mut().zip(&q).for_each(|(leverage, q)| *leverage += q * q);
    }
    leverages
}

/// The inverse of the columns' products; none where they all but depend on each other.
pub(super) fn covariance(columns: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    let norms: Vec<f64> = columns.iter().map(|column| dot(column, column).sqrt()).collect();
    let lower: Vec<Vec<f64>> = (0..columns.len())
        .map(|i| (0..=i).map(|j| dot(&columns[i], &columns[j]) / (norms[i] * norms[j])).collect())
        .collect();
    let column = |k: usize| {
        let unit = (0..columns.len()).map(|i| f64::from(u8::from(i == k))).collect();
        let solved = cholesky::solve(lower.clone(), unit, 1e-14)?;
        Some(solved.iter().zip(&norms).map(|(x, norm)| x / (norm * norms[k])).collect())
    };
    (0..columns.len()).map(column).collect()
}

/// An orthonormal basis of columns; what depends on those before it is left out.
fn orthonormal<'a>(columns: impl Iterator<Item = &'a Vec<f64>>) -> Vec<Vec<f64>> {
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for column in columns {
        let whole = dot(column, column);
        let mut own = column.clone();
        for _ in 0..2 {
            for q in &basis {
                let share = dot(&own, q);
                own.iter_mut().zip(q).for_each(|(x, q)| *x -= share * q);
            }
        }
        let left = dot(&own, &own);
        if left > INDEPENDENT * INDEPENDENT * whole && left.is_finite() {
            let norm = left.sqrt();
            own.iter_mut().for_each(|x| *x /= norm);
            basis.push(own);
        }
    }
    basis
}

/// The value that a Student t with so many degrees of freedom exceeds with 2.5 %: the expansion of
/// Abramowitz and Stegun, 26.7.5, and below 5 degrees the exact values.
#[must_use]
pub fn t_quantile(freedom: usize) -> f64 {
    match freedom {
        0 => f64::INFINITY,
        1 => 12.706_204_736,
        2 => 4.302_652_730,
        3 => 3.182_446_305,
        4 => 2.776_445_105,
        _ => {
            let n = freedom as f64;
            let z: f64 = 1.959_963_984_540_054;
            let (z3, z5, z7) = (z * z * z, z * z * z * z * z, z * z * z * z * z * z * z);
            let z9 = z7 * z * z;
            z + (z3 + z) / (4.0 * n)
                + (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * n * n)
                + (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / (384.0 * n * n * n)
                + (79.0 * z9 + 776.0 * z7 + 1482.0 * z5 - 1920.0 * z3 - 945.0 * z)
                    / (92160.0 * n * n * n * n)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::rng::Stream;

    #[test]
    fn quantiles_are_those_of_the_tables() {
        for (freedom, table) in
            [(1, 12.706), (2, 4.303), (3, 3.182), (5, 2.571), (10, 2.228), (60, 2.000)]
        {
            assert!((t_quantile(freedom) - table).abs() < 3e-3, "{freedom}");
        }
    }

    #[test]
    fn intervals_cover_the_true_constants_as_often_as_they_say() {
        let stream = Stream::new(3, "coverage");
        let n = 60;
        let x: Vec<f64> = (0..n).map(|i| 150.0 + 450.0 * stream.uniform(i)).collect();
        let z: Vec<f64> = (0..n).map(|i| 800.0 + 1700.0 * stream.uniform(1000 + i)).collect();
        let names = ["f", "n"];
        let truth = [286.44, 5.82e-10, 3.0, 8973.0, 0.039];
        let law = Formula::parse("286.44 - 5.82e-10*n^3.001 - 8973*ln(0.039*f)/f", &names).unwrap();
        let exact = Formula::parse("286.44 - 5.82e-10*n^3 - 8973*ln(0.039*f)/f", &names).unwrap();
        let mut covered = [0; 5];
        // In the middle of the box, at an edge and in a corner.
        let places = [[375.0, 1650.0], [160.0, 1650.0], [590.0, 2490.0]];
        let mut banded = [0; 3];
        let redraws = 1000;
        for redraw in 0..redraws {
            let noise = Stream::new(redraw, "noise");
            let target = (0..n)
                .map(|i| exact.value(&[x[i as usize], z[i as usize]]) + 0.01 * noise.normal(i));
            let rows = DataRows { target: target.collect(), inputs: vec![x.clone(), z.clone()] };
            let found = fitted(&law, &rows).unwrap();
            for (k, constant) in found.constants.iter().enumerate() {
                let [low, high] = constant.interval.unwrap();
                covered[k] += i32::from(low <= truth[k] && truth[k] <= high);
            }
            for (place, banded) in places.iter().zip(&mut banded) {
                let off = found.formula.value(place) - exact.value(place);
                *banded += i32::from(off.abs() <= found.band(place).unwrap());
            }
        }
        for covered in covered.into_iter().chain(banded) {
            assert!((930..=970).contains(&covered), "{covered:?}");
        }
    }

    #[test]
    fn what_the_rows_do_not_determine_has_no_interval() {
        let x: Vec<f64> = (1..30).map(f64::from).collect();
        let rows = DataRows { target: x.iter().map(|x| 3.0 * x + 1.0).collect(), inputs: vec![x] };
        let twice = Formula::parse("2*(1.2*x) + 0.5", &["x"]).unwrap();
        let found = fitted(&twice, &rows).unwrap();
        let determined: Vec<bool> =
            found.constants.iter().map(FittedConstant::is_determined).collect();
        assert_eq!(determined, [false, false, true]);
        assert!(found.rms() < 1e-9);
    }
}
