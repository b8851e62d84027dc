//! A model that is a formula: with the units of its inputs and its result, and the ranges in which it holds.
//!
//! Beyond a range it goes on with its end slopes, as every identified model does, and its answer is marked. So
//! its value and its slopes must be finite on the whole of its ranges: interval arithmetic certifies that, or
//! the model is refused.

mod file;
mod fit;
mod setting;

pub(super) use self::file::ModelText;
use super::Valued;
use super::tool::ShippedTool;
use crate::base::equation::number;
use crate::base::formula::{
    CompiledFormula, Formula, FormulaError, Interval, NumberUnits, Unit, UnitReport,
};
use crate::base::language::{fixed, tr};

pub use file::{FORMULA_MODEL_VERSION, MAX_MODEL_INPUTS};
pub use fit::FormulaFit;
pub(crate) use setting::role;
pub use setting::{FormulaRole, OwnFormula};

/// An input of a formula's model.
#[derive(Clone, Debug, PartialEq)]
pub struct FormulaInput {
    /// Its name in the formula.
    pub name: String,
    /// Its unit.
    pub unit: Unit,
    /// Where the formula holds.
    pub range: Interval,
}

/// The result of a formula's model.
#[derive(Clone, Debug, PartialEq)]
pub struct FormulaOutput {
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: Unit,
}

/// A formula with units and ranges, certified to be finite on them.
#[derive(Clone, Debug, PartialEq)]
pub struct FormulaModel {
    formula: Formula,
    inputs: Vec<FormulaInput>,
    output: FormulaOutput,
    source: String,
    tool: Option<ShippedTool>,
    compiled: CompiledFormula,
    slopes: Vec<CompiledFormula>,
    bounds: Interval,
    fit: Option<FormulaFit>,
}

impl FormulaModel {
    /// A model of a formula; `source` says where it comes from.
    ///
    /// # Errors
    /// Says what does not fit: inputs of other names than the formula's, too many, a range that is none, a
    /// value or a slope that is not certified to be finite, with the place.
    pub fn new(
        formula: Formula,
        inputs: Vec<FormulaInput>,
        output: FormulaOutput,
        source: String,
    ) -> Result<Self, String> {
        if inputs.len() > MAX_MODEL_INPUTS {
            return Err(tr!(
                "{n} inputs: allowed are at most {most}",
                n = inputs.len(),
                most = MAX_MODEL_INPUTS
            ));
        }
        if !inputs.iter().map(|input| &input.name).eq(formula.inputs()) {
            return Err(tr("the inputs are not those of the formula").to_owned());
        }
        let ranges: Vec<Interval> = inputs.iter().map(|input| input.range).collect();
        let bounds = finite(&formula, &ranges, None)?;
        let mut slopes = Vec::new();
        for (index, input) in inputs.iter().enumerate() {
            let slope = formula.derivative(index)?;
            finite(&slope, &ranges, Some(&input.name))?;
            slopes.push(slope.compile());
        }
        let compiled = formula.compile();
        Ok(Self {
            formula,
            inputs,
            output,
            source,
            tool: None,
            compiled,
            slopes,
            bounds,
            fit: None,
        })
    }

    /// Reads a model file: TOML, or JSON where it begins with a brace.
    ///
    /// # Errors
    /// Names the entry, its value and what is allowed, or the place in the formula.
    pub fn parse(text: &str) -> Result<Self, String> {
        ModelText::read(text)?.model()
    }

    /// The text of a model file (TOML).
    #[must_use]
    pub fn write(&self) -> String {
        ModelText::of(self).toml()
    }

    /// The same in one line (JSON): the value of a setting.
    #[must_use]
    pub fn write_line(&self) -> String {
        ModelText::of(self).json()
    }

    /// The formula.
    #[must_use]
    pub fn formula(&self) -> &Formula {
        &self.formula
    }

    /// Its inputs, in the order of their values.
    #[must_use]
    pub fn inputs(&self) -> &[FormulaInput] {
        &self.inputs
    }

    /// Its result.
    #[must_use]
    pub fn output(&self) -> &FormulaOutput {
        &self.output
    }

    /// Where it comes from, in words; may be empty.
    #[must_use]
    pub fn source(&self) -> &str {
        &self.source
    }

    /// The same as one that was found on a shipped cutter.
    #[must_use]
    pub fn found_on(self, tool: Option<ShippedTool>) -> Self {
        Self { tool, ..self }
    }

    /// The shipped cutter that it was found on, where it says so.
    #[must_use]
    pub fn tool(&self) -> Option<ShippedTool> {
        self.tool
    }

    /// The same with how sure the rows make its constants.
    ///
    /// # Errors
    /// Names the entry of the fit that cannot be, and what is allowed.
    pub fn with_fit(self, fit: FormulaFit) -> Result<Self, String> {
        fit.check(&self.formula)?;
        Ok(Self { fit: Some(fit), ..self })
    }

    /// The same without it: a run reads the values alone.
    #[must_use]
    pub fn without_fit(self) -> Self {
        Self { fit: None, ..self }
    }

    /// How sure the rows make its constants, where it says so.
    #[must_use]
    pub fn fit(&self) -> Option<&FormulaFit> {
        self.fit.as_ref()
    }

    /// Whether it holds for a cutter that cuts as this shipped one; a model that names none is taken for one of
    /// the papers' cutter.
    #[must_use]
    #[inline]
    pub fn holds_for(&self, cuts_as: Option<ShippedTool>) -> bool {
        cuts_as == Some(self.tool.unwrap_or(ShippedTool::R21616B20))
    }

    /// Bounds of its values on its ranges.
    #[must_use]
    pub fn bounds(&self) -> Interval {
        self.bounds
    }

    /// The value at inputs in the order of [`Self::inputs`]; beyond a range straight on with the slopes at
    /// the nearest place of the ranges, and marked. NaN where there are fewer inputs than it has.
    #[must_use]
    #[inline]
    pub fn at(&self, inputs: &[f64]) -> Valued {
        let within = |(x, input): (&f64, &FormulaInput)| input.range.contains(*x);
        if inputs.len() == self.inputs.len() && inputs.iter().zip(&self.inputs).all(within) {
            return Valued::new(self.compiled.value(inputs), true);
        }
        self.continued(inputs)
    }

    fn continued(&self, inputs: &[f64]) -> Valued {
        let mut nearest = [0.0; MAX_MODEL_INPUTS];
        let nearest = &mut nearest[..self.inputs.len()];
        if inputs.len() != nearest.len() {
            return Valued::new(f64::NAN, false);
        }
        for ((place, input), x) in nearest.iter_mut().zip(&self.inputs).zip(inputs) {
            *place = x.max(input.range.low).min(input.range.high);
        }
        let mut value = self.compiled.value(nearest);
        for ((slope, place), x) in self.slopes.iter().zip(&*nearest).zip(inputs) {
            if x != place {
                value += slope.value(nearest) * (x - place);
            }
        }
        Valued::new(value, false)
    }

    /// The slope by an input, at the nearest place of the ranges: that of [`Self::at`].
    #[must_use]
    pub fn slope(&self, input: usize, inputs: &[f64]) -> f64 {
        let mut nearest = [0.0; MAX_MODEL_INPUTS];
        for ((place, input), x) in nearest.iter_mut().zip(&self.inputs).zip(inputs) {
            *place = x.max(input.range.low).min(input.range.high);
        }
        self.slopes.get(input).map_or(f64::NAN, |slope| slope.value(&nearest))
    }

    /// The same model with its inputs in another order.
    pub(super) fn in_order(self, order: &[usize]) -> Result<Self, String> {
        if order.iter().copied().eq(0..self.inputs.len()) {
            return Ok(self);
        }
        let inputs: Vec<FormulaInput> =
            order.iter().filter_map(|place| self.inputs.get(*place).cloned()).collect();
        let names: Vec<&str> = inputs.iter().map(|input| input.name.as_str()).collect();
        let constants = self.formula.own_constants();
        let formula = Formula::parse_with(&self.formula.to_string(), &names, &constants)
            .map_err(|error| error.to_string())?;
        Ok(Self::new(formula, inputs, self.output, self.source)?.found_on(self.tool))
    }

    /// The formula with its inputs called by other names, and with values in their place, as an equation is shown;
    /// beyond the ranges with the way straight on.
    #[must_use]
    pub fn shown(&self, names: &[&str], inputs: &[f64]) -> [String; 2] {
        let value = |x: f64| if x < 0.0 { format!("({})", number(x)) } else { number(x) };
        let mut nearest = Vec::new();
        let mut beyond = String::new();
        for (index, (input, x)) in self.inputs.iter().zip(inputs).enumerate() {
            let place = x.max(input.range.low).min(input.range.high);
            if place != *x {
                // A long way beyond, each digit of a small slope counts.
                let slope = self.slope(index, inputs);
                let digits = (1e-5..1.0).contains(&slope.abs());
                let text = if digits { fixed(slope, 6) } else { number(slope) };
                let slope = if slope < 0.0 { format!("({text})") } else { text };
                beyond += &format!(" + {slope} · ({} - {})", number(*x), value(place));
            }
            nearest.push(value(place));
        }
        let nearest: Vec<&str> = nearest.iter().map(String::as_str).collect();
        [self.formula.equation(names), self.formula.equation(&nearest) + beyond.as_str()]
    }

    /// Whether it is right in its units, and the units of its constants.
    ///
    /// # Errors
    /// Names the part of the formula whose units do not fit.
    pub fn units(&self) -> Result<UnitReport, FormulaError> {
        let units: Vec<Unit> = self.inputs.iter().map(|input| input.unit.clone()).collect();
        self.formula.check_units(&units, &self.output.unit, NumberUnits::Solved)
    }
}

/// A list as a sentence has it, the last one behind an `and`.
fn all_of(texts: Vec<String>) -> String {
    let joined =
        |first: String, last: String| tr!("{first} and {last}", first = first, last = last);
    texts.into_iter().reduce(joined).unwrap_or_default()
}

/// Bounds over the ranges, or why it may not be finite, of a formula or of its slope by the named input.
fn finite(
    formula: &Formula,
    ranges: &[Interval],
    slope_by: Option<&str>,
) -> Result<Interval, String> {
    let (values, places) = formula.certify_values(ranges)?;
    let place = match (values, places.first()) {
        (Some(values), None) => return Ok(values),
        (_, place) => place,
    };
    let Some(place) = place else {
        return Err(match slope_by {
            None => tr("the formula has no bounds on its ranges").to_owned(),
            Some(input) => tr!(
                "its slope by `{input}`, {slope}, has no bounds on its ranges",
                input = input,
                slope = formula.to_string()
            ),
        });
    };
    let at: Vec<String> = (formula.inputs().iter().zip(&place.at))
        .map(|(name, Interval { low, high })| {
            tr!("`{name}` from {low} to {high}", name = name, low = *low, high = *high)
        })
        .collect();
    let (place, why) = (all_of(at), &place.why);
    Err(match slope_by {
        None => tr!(
            "the formula is not certain to have a finite value on its ranges: for {place}, {why}",
            place = place,
            why = why
        ),
        Some(input) => tr!(
            "its slope by `{input}`, {slope}, is not certain to have a finite value on its ranges: for \
             {place}, {why}",
            input = input,
            slope = formula.to_string(),
            place = place,
            why = why
        ),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const MODEL: &str = r#"
version = 1
formula = "253.66 - 5.82e-10*n^3 - 8973*ln(0.039*f)/f"
source = "K4 of 2007, restored"

[output]
name = "F"
unit = "N"

[[inputs]]
name = "f"
unit = "mm/min"
low = 69.7
high = 600

[[inputs]]
name = "n"
unit = "1/min"
low = 412.5
high = 4000
"#;

    #[test]
    fn file_and_line_give_the_model_back() {
        let model = FormulaModel::parse(MODEL).unwrap();
        assert_eq!(FormulaModel::parse(&model.write()).unwrap(), model);
        assert_eq!(FormulaModel::parse(&model.write_line()).unwrap(), model);
        assert!(!model.write_line().contains('\n'));
        assert_eq!(model.source(), "K4 of 2007, restored");
        assert_eq!(model.tool(), None);
        let square = MODEL.replacen("[output]", "tool = \"square-12-4\"\n[output]", 1);
        let square = FormulaModel::parse(&square).unwrap();
        assert_eq!(square.tool(), Some(ShippedTool::Square12));
        assert_eq!(FormulaModel::parse(&square.write()).unwrap(), square);
        assert_eq!(FormulaModel::parse(&square.write_line()).unwrap(), square);
        assert_eq!(model.units().unwrap().constants[0].unit, "N");
    }

    /// Two of its five numbers were fitted.
    const FIT: &str = "\n[fit]\nrows = 20\ndeviation = 0.5\nconstants = [253.66, 8973]\ncovariance = [[0.04], [-0.1, 9]]\n";

    #[test]
    fn a_fit_is_kept_in_the_file_and_not_in_a_setting() {
        let model = FormulaModel::parse(&format!("{MODEL}{FIT}")).unwrap();
        let fit = model.fit().unwrap();
        assert_eq!((fit.freedom(), fit.covariance(0, 1), fit.covariance(1, 1)), (18, -0.1, 9.0));
        assert_eq!(FormulaModel::parse(&model.write()).unwrap(), model);
        assert_eq!(model.clone().without_fit(), FormulaModel::parse(MODEL).unwrap());
        for (from, to, parts) in [
            ("rows = 20", "rows = 2", ["`rows` cannot be 2", "the 2 constants"]),
            ("0.5", "-0.5", ["`deviation` cannot be -0.5", "0 or more"]),
            ("8973", "8974", ["cannot have 8974", "from left to right"]),
            ("[253.66, 8973]", "[8973, 253.66]", ["cannot have 253.66", "numbers of the formula"]),
            (", 9]]", "]]", ["`covariance` is none of 2", "lower triangle"]),
            (", 9]]", ", -9]]", ["`covariance` is none of 2", "diagonal"]),
            ("rows", "row", ["unknown field `row`", "line"]),
        ] {
            let error = FormulaModel::parse(&format!("{MODEL}{}", FIT.replacen(from, to, 1)));
            let error = error.unwrap_err();
            assert!(parts.iter().all(|part| error.contains(part)), "{to}: {error}");
        }
    }

    #[test]
    fn beyond_its_ranges_it_goes_straight_on_and_is_marked() {
        let model = FormulaModel::parse(MODEL).unwrap();
        let inside = model.at(&[300.0, 2000.0]);
        assert!(inside.valid);
        assert_eq!(inside.value, model.formula().value(&[300.0, 2000.0]));
        let [edge, near, far] = [600.0, 610.0, 700.0].map(|f| model.at(&[f, 2000.0]));
        assert!(edge.valid && !near.valid && !far.valid);
        let slope = model.slope(0, &[600.0, 2000.0]);
        assert_eq!(model.slope(0, &[650.0, 2000.0]), slope);
        assert!((near.value - edge.value - 10.0 * slope).abs() < 1e-9);
        assert!((far.value - edge.value - 100.0 * slope).abs() < 1e-9);
        // At a corner by both slopes.
        let corner = model.at(&[600.0, 4000.0]).value;
        let both = [0, 1].map(|input| model.slope(input, &[600.0, 4000.0]));
        let beyond = model.at(&[620.0, 4100.0]);
        assert!((beyond.value - corner - 20.0 * both[0] - 100.0 * both[1]).abs() < 1e-9);
        assert!(model.at(&[300.0]).value.is_nan());
    }

    #[test]
    fn what_is_no_model_is_refused_by_name() {
        for (from, to, parts) in [
            ("version = 1", "version = 2", ["`version` cannot be 2", "allowed is 1"]),
            ("ln(0.039", "log(0.039", ["`formula`: column 30", "`ln`"]),
            ("*n^3", "*m^3", ["`formula`: column 19", "known are f, n"]),
            ("low = 69.7", "low = 0", ["for `f` from 0 to", "the logarithm of 0"]),
            ("low = 69.7", "low = 700", ["`inputs[0]`", "low below high"]),
            ("low = 69.7", "low = nan", ["`inputs[0]`", "NaN"]),
            ("low = 69.7", "low = \"x\"", ["`inputs[0].low`", "a number"]),
            ("unit = \"N\"", "unit = \"newton\"", ["`output.unit`", "`newton` is no unit"]),
            ("name = \"F\"", "nam = \"F\"", ["unknown field `nam`", "line"]),
            ("source =", "origin =", ["unknown field `origin`", "line"]),
            ("source =", "tool = \"saw\"\nsource =", ["`tool` cannot be `saw`", "square-12-4"]),
            ("name = \"n\"", "name = \"f\"", ["`formula`", "two inputs have the name `f`"]),
            ("8973*ln(0.039*f)/f", "1/(f-100)", ["a division by 0", "`1 / (f - 100)`"]),
            ("8973*ln(0.039*f)/f", "sqrt(f-69.7)", ["its slope by `f`", "finite"]),
        ] {
            let text = MODEL.replacen(from, to, 1);
            assert_ne!(text, MODEL, "{from}");
            let error = FormulaModel::parse(&text).unwrap_err();
            for part in parts {
                assert!(error.contains(part), "{to}: {part}: {error}");
            }
        }
        let two = MODEL.replacen("*n^3", "", 1);
        let two = FormulaModel::parse(&two).unwrap();
        assert_eq!(two.slope(1, &[300.0, 2000.0]), 0.0, "an input need not be read");
    }
}
