//! What is asked: a column of a table as a formula of other columns.

use super::range::WIDER;
use super::rows::{DataRows, widened};
use super::template::Template;
use super::units::{UnitRule, by_name};
use super::written::Columns;
use crate::base::formula::Unit;
use crate::base::language::tr;
use crate::base::math;
use crate::base::rng::Stream;
use crate::base::stats;
use crate::csv_table::CsvCells;

/// Fewest rows.
pub(super) const FEWEST: usize = 5;
/// Most inputs.
const MOST_INPUTS: usize = 20;
/// Most rows that a search goes over.
pub const MOST_SEARCHED: usize = 2000;
/// Up to so many rows a table is small: correlated inputs cannot be told apart then.
pub const SMALL: usize = 30;
/// Correlation of two inputs above which a small table does not tell their effects apart (variance
/// inflation above 5).
const COLLINEAR_SMALL: f64 = 0.89;
/// The same for many rows (variance inflation above 100).
const COLLINEAR: f64 = 0.995;

/// Levels of a column from which they are many.
const MANY_LEVELS: usize = 20;

/// Says that there are too few rows.
pub(super) fn too_few(rows: usize) -> String {
    match rows {
        1 => tr!("1 row: at least {fewest} are needed", fewest = FEWEST),
        rows => tr!("{rows} rows: at least {fewest} are needed", rows = rows, fewest = FEWEST),
    }
}

/// A target, its inputs and their rows.
#[derive(Clone, Debug, PartialEq)]
pub struct GpProblem {
    /// Column of the target.
    pub target: String,
    /// Columns of the inputs.
    pub inputs: Vec<String>,
    /// The rows.
    pub rows: DataRows,
    /// The rule that formulas be right in their units, where there is one.
    pub rule: Option<UnitRule>,
    /// The part that is known, where there is one.
    pub template: Option<Template>,
    /// What the inputs of the search stand for.
    pub columns: Columns,
    /// Columns whose units were told, though their names do not tell them.
    pub told: Vec<String>,
}

impl GpProblem {
    /// Reads the columns of a table.
    ///
    /// # Errors
    /// Names the column, line and value that do not do, and what is allowed.
    pub fn read(text: &str, target: &str, inputs: &[String]) -> Result<Self, String> {
        if inputs.is_empty() || inputs.len() > MOST_INPUTS {
            return Err(tr!(
                "{count} inputs: allowed are 1 to {most}",
                count = inputs.len(),
                most = MOST_INPUTS
            ));
        }
        for (index, input) in inputs.iter().enumerate() {
            if input == target {
                return Err(tr!("`{input}` is the target and an input", input = input));
            }
            if inputs[..index].contains(input) {
                return Err(tr!("the input `{input}` is named twice", input = input));
            }
        }
        let names: Vec<[&str; 1]> =
            inputs.iter().map(|input| [input.as_str()]).chain([[target]]).collect();
        let columns: Vec<&[&str]> = names.iter().map(<[&str; 1]>::as_slice).collect();
        // Straight into columns of numbers: a table may have a million rows.
        let mut values = CsvCells::of(text, &columns)?.numbers()?;
        let last = values.pop().unwrap_or_default();
        let problem = Self {
            target: target.to_owned(),
            inputs: inputs.to_vec(),
            rows: DataRows { inputs: values, target: last },
            rule: None,
            template: None,
            columns: Columns { names: inputs.to_vec(), parts: Vec::new() },
            told: Vec::new(),
        };
        problem.check()?;
        Ok(problem)
    }

    /// The same with the rule that formulas be right in their units.
    ///
    /// # Errors
    /// Names a column without a unit, or one of another table.
    pub fn strict(mut self, given: &[(String, Unit)]) -> Result<Self, String> {
        let columns = self.inputs.iter().chain([&self.target]);
        let mut units = columns
            .map(|column| {
                let own = given.iter().find(|(name, _)| name == column);
                own.map(|(_, unit)| unit.clone()).or_else(|| by_name(column)).ok_or_else(|| {
                    tr!(
                        "the unit of `{column}` is not known: give it with `--unit {column}=UNIT`, `1` for none",
                        column = column
                    )
                })
            })
            .collect::<Result<Vec<Unit>, String>>()?;
        let output = units.pop().unwrap_or_else(Unit::none);
        self.rule = Some(UnitRule { columns: self.columns.clone(), inputs: units, output });
        Ok(self)
    }

    /// The same where the units of some columns are told: an input with a unit is as positive as its rows.
    #[must_use]
    pub fn told(mut self, given: &[(String, Unit)]) -> Self {
        let new = given.iter().map(|(name, _)| name).filter(|name| by_name(name).is_none());
        self.told = new.cloned().collect();
        self
    }

    fn tells_unit(&self, name: &String) -> bool {
        by_name(name).is_some() || self.told.contains(name)
    }

    /// The same with a part of the formula that is known.
    ///
    /// # Errors
    /// The template does not do for these inputs and rows.
    pub fn with_template(mut self, text: &str) -> Result<Self, String> {
        let template = Template::read(text, &self.inputs)?;
        template.extended(&self.rows)?;
        self.columns.parts.clone_from(&template.parts);
        if let Some(rule) = &mut self.rule {
            rule.columns = self.columns.clone();
        }
        self.template = Some(template);
        Ok(self)
    }

    fn check(&self) -> Result<(), String> {
        let count = self.rows.len();
        if count < FEWEST {
            return Err(too_few(count));
        }
        let columns = self.inputs.iter().zip(&self.rows.inputs);
        for (name, column) in columns.chain([(&self.target, &self.rows.target)]) {
            if column.iter().all(|x| *x == column[0]) {
                return Err(tr!(
                    "`{name}` is {value} in every row: nothing can be told by it",
                    name = name,
                    value = column[0]
                ));
            }
            if column.iter().any(|x| x.abs() > 1e100) {
                return Err(tr!(
                    "`{name}` has values above 1e100: choose another unit",
                    name = name
                ));
            }
        }
        Ok(())
    }

    /// Which inputs are positive, in the rows and beyond them, the parts of a template after the columns. A column
    /// that tells its unit is where all its rows are. One that tells none may be a variable of any sign, and is where
    /// it is not laid out evenly so near to 0 that the next value down would lie beyond.
    #[must_use]
    pub fn positive(&self) -> Vec<bool> {
        let columns = self.rows.inputs.iter().zip(&self.inputs);
        let one = |(column, name): (&Vec<f64>, &String)| {
            let [low, _] = math::extent(column.iter().copied());
            low > 0.0 && (self.tells_unit(name) || !passes_zero(column))
        };
        let mut positive: Vec<bool> = columns.map(one).collect();
        if let Some(template) = &self.template
            && let Ok(extended) = template.extended(&self.rows)
        {
            positive.extend(&extended.positive()[self.inputs.len()..]);
        }
        positive
    }

    /// The same without the inputs of which it is no more than likely: they tell no unit, and their range wider by
    /// 30 % has 0 in it.
    #[must_use]
    pub fn surely_positive(&self) -> Vec<bool> {
        let mut positive = self.positive();
        let inputs = self.inputs.iter().zip(self.rows.ranges());
        for (positive, (name, range)) in positive.iter_mut().zip(inputs) {
            *positive &= self.tells_unit(name) || widened(range, false, WIDER)[0] > 0.0;
        }
        positive
    }

    /// The range of each input, widened by `share` of its width on both sides where that is not 0; what is surely
    /// positive stays so.
    #[must_use]
    pub fn ranges(&self, share: f64) -> Vec<[f64; 2]> {
        let ranges = self.rows.ranges();
        if share == 0.0 {
            return ranges;
        }
        let wide = |(range, positive): ([f64; 2], bool)| widened(range, positive, share);
        ranges.into_iter().zip(self.surely_positive()).map(wide).collect()
    }

    /// Two inputs that lie so nearly on one line that the rows do not tell their effects apart.
    #[must_use]
    pub fn collinear(&self) -> Option<Collinear> {
        let most = if self.rows.len() <= SMALL { COLLINEAR_SMALL } else { COLLINEAR };
        let columns = &self.rows.inputs;
        let pairs = (0..columns.len()).flat_map(|a| (a + 1..columns.len()).map(move |b| (a, b)));
        let found = pairs.filter_map(|(a, b)| {
            let correlation = stats::correlation(&columns[a], &columns[b])?;
            let inputs = [self.inputs[a].clone(), self.inputs[b].clone()];
            (correlation.abs() > most).then_some(Collinear { inputs, correlation })
        });
        found.max_by(|a, b| a.correlation.abs().total_cmp(&b.correlation.abs()))
    }

    /// The rows that the search goes over, with the parts of a template as further columns.
    #[must_use]
    pub fn searched(&self, seed: u64) -> DataRows {
        let rows = self.sample(seed);
        match &self.template {
            Some(template) => template.extended(&rows).unwrap_or(rows),
            None => rows,
        }
    }

    /// All rows, or of many a sample drawn with the seed.
    #[must_use]
    pub fn sample(&self, seed: u64) -> DataRows {
        let count = self.rows.len();
        if count <= MOST_SEARCHED {
            return self.rows.clone();
        }
        let stream = Stream::new(seed, "identify.gp.sample");
        let mut order: Vec<(u64, usize)> =
            (0..count).map(|row| (stream.bits(row as u64), row)).collect();
        order.sort_unstable();
        let mut keep = vec![false; count];
        order[..MOST_SEARCHED].iter().for_each(|(_, row)| keep[*row] = true);
        self.rows.only(|row| keep[row])
    }
}

/// Whether values are laid out evenly so that the next one down would be below 0: on many levels, or far below it.
fn passes_zero(column: &[f64]) -> bool {
    let mut levels = column.to_vec();
    levels.sort_by(f64::total_cmp);
    levels.dedup();
    let [low, .., high] = levels[..] else { return false };
    let step = (high - low) / (levels.len() - 1) as f64;
    let even = levels.windows(2).all(|pair| (pair[1] - pair[0] - step).abs() < 1e-6 * step);
    let below = match levels.len() {
        MANY_LEVELS.. => step,
        FEWEST.. => 0.25 * step,
        _ => 0.0,
    };
    even && low < below * (1.0 - 1e-6)
}

/// Two inputs on one line.
#[derive(Clone, Debug, PartialEq)]
pub struct Collinear {
    /// Their names.
    pub inputs: [String; 2],
    /// Their correlation.
    pub correlation: f64,
}

impl std::fmt::Display for Collinear {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [a, b] = &self.inputs;
        let inflation = 1.0 / (1.0 - self.correlation * self.correlation);
        f.write_str(&tr!(
            "`{a}` and `{b}` lie on one line (correlation {correlation:.3}, variance inflation {inflation:.0}): these \
             rows do not tell their effects apart, and a free formula of both would be an accident",
            a = a,
            b = b,
            correlation = self.correlation,
            inflation = inflation
        ))
    }
}
