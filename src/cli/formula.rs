//! `steadycut formula`: a formula on a table, or in all its forms.

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use super::Outcome;
use super::args::FormulaArgs;
use super::files::report;
use super::formula_told::{told, told_json};
use crate::base::formula::{Formula, Interval, Unit};
use crate::models::Valued;
use crate::models::formula_model::{FormulaInput, FormulaModel, FormulaOutput};
use crate::study::formula_table::{Beside, HalfWidth, PredictedTable};
use crate::study::identify::gp::band::FormulaBand;

/// Why a row has no value.
const NO_VALUE: &str = "the formula has no finite value there (a division by zero, a logarithm or power of a negative \
                        number, or an overflow)";

/// A formula as it was given.
pub enum Given {
    /// With units and ranges.
    Model(Box<FormulaModel>),
    /// A text, with the units of its inputs and of its result as far as they were given.
    Text {
        /// The formula.
        formula: Formula,
        /// Units of the inputs.
        units: Vec<Unit>,
        /// Name and unit of the result.
        output: FormulaOutput,
    },
}

impl Given {
    /// The formula.
    pub fn formula(&self) -> &Formula {
        match self {
            Self::Model(model) => model.formula(),
            Self::Text { formula, .. } => formula,
        }
    }

    fn output(&self) -> &FormulaOutput {
        match self {
            Self::Model(model) => model.output(),
            Self::Text { output, .. } => output,
        }
    }
}

pub fn execute(args: &FormulaArgs) -> Outcome {
    let written = args.out.as_ref().or(args.save.as_ref());
    let mut out = report(args.json, written)?;
    let given = given(args)?;
    if let Some(path) = &args.save {
        let Given::Model(model) = &given else {
            return Err("`--save` needs a range for every input: `--range NAME=LOW..HIGH`".into());
        };
        path.write(&model.write())?;
        if !args.json {
            writeln!(out, "model file written to {path}")?;
        }
    }
    if args.data.is_some() {
        return on_table(args, &given, &mut out);
    }
    if args.json {
        writeln!(out, "{}", serde_json::to_string_pretty(&told_json(&given))?)?;
    } else {
        write!(out, "{}", told(&given))?;
    }
    Ok(ExitCode::SUCCESS)
}

fn given(args: &FormulaArgs) -> Result<Given, Box<dyn std::error::Error>> {
    let text = match args.formula.source() {
        Ok(path) => {
            let named = [!args.range.is_empty(), !args.unit.is_empty(), args.result.is_some()];
            if named.contains(&true) {
                return Err(
                    "`--range`, `--unit` and `--result` are for a TEXT: the model file has them"
                        .into(),
                );
            }
            let model =
                FormulaModel::parse(&path.text()?).map_err(|error| format!("{path}: {error}"))?;
            return Ok(Given::Model(Box::new(model)));
        }
        Err(text) => text,
    };
    let mut names = Formula::names(&text).map_err(|error| format!("the formula, {error}"))?;
    // In the order of their ranges, where they have any: that is the order of the model.
    let place = |name: &String| args.range.iter().position(|(of, _)| of == name);
    names.sort_by_key(|name| place(name).unwrap_or(usize::MAX));
    let formula = Formula::parse(&text, &names).map_err(|error| format!("the formula, {error}"))?;
    let ranges = args.range.iter().map(|(name, _)| ("--range", name));
    let units = args.unit.iter().map(|(name, _)| ("--unit", name));
    let mut seen = Vec::new();
    for (option, name) in ranges.chain(units) {
        if !names.contains(name) {
            let known = if names.is_empty() { "none".to_owned() } else { names.join(", ") };
            return Err(format!("{option} {name}: no such input; the formula's are {known}").into());
        }
        if seen.contains(&(option, name)) {
            return Err(format!("{option} {name} was given twice").into());
        }
        seen.push((option, name));
    }
    let unit = |option: &str, text: &str| {
        Unit::parse(text).map_err(|problem| format!("{option}: {problem}"))
    };
    let mut all = Vec::new();
    for name in &names {
        let found = args.unit.iter().find(|(of, _)| of == name);
        all.push(unit(&format!("--unit {name}"), found.map_or("", |(_, text)| text))?);
    }
    let (name, text) = match &args.result {
        Some((name, text)) => (name.clone(), text.as_str()),
        None => ("result".to_owned(), ""),
    };
    let output = FormulaOutput { name, unit: unit("--result", text)? };
    if args.range.is_empty() {
        return Ok(Given::Text { formula, units: all, output });
    }
    let mut inputs = Vec::new();
    for (name, unit) in names.into_iter().zip(all) {
        let Some((_, [low, high])) = args.range.iter().find(|(of, _)| *of == name) else {
            return Err(format!("`{name}` has no range: `--range {name}=LOW..HIGH`").into());
        };
        if !(low.is_finite() && high.is_finite() && low < high) {
            return Err(
                format!("--range {name}={low}..{high} is none: allowed is low below high").into()
            );
        }
        inputs.push(FormulaInput { name, unit, range: Interval::new(*low, *high) });
    }
    let model = FormulaModel::new(formula, inputs, output, String::new())?;
    Ok(Given::Model(Box::new(model)))
}

fn on_table(args: &FormulaArgs, given: &Given, out: &mut dyn Write) -> Outcome {
    let Some(data) = &args.data else { return Ok(ExitCode::SUCCESS) };
    let text = data.text()?;
    let inputs = given.formula().inputs();
    let made = match given {
        Given::Model(model) => {
            let band = FormulaBand::of(model);
            let half = |at: &[f64]| band.as_ref()?.half_width(at);
            let half: HalfWidth<'_> = &half;
            let beside = Beside { marked: true, band: band.is_some().then_some(half) };
            PredictedTable::new(&text, inputs, beside, |at| model.at(at))
        }
        Given::Text { formula, .. } => {
            let compiled = formula.compile();
            let at = |at: &[f64]| Valued::new(compiled.value(at), true);
            PredictedTable::new(&text, inputs, Beside::default(), at)
        }
    };
    let made = made.map_err(|error| format!("{data}: {error}"))?;
    let errors = made.errors(&given.output().name);
    if let Some(path) = &args.out {
        path.write(&made.csv()?)?;
    }
    if args.json {
        let values: Vec<Option<f64>> =
            made.values.iter().map(|value| Some(value.value).filter(|x| x.is_finite())).collect();
        let extrapolated: Vec<bool> = made.values.iter().map(|value| !value.valid).collect();
        let errors = errors.map(|e| json!({ "rows": e.rows, "rms": e.rms, "worst": e.worst }));
        let end = |end: usize| {
            let all = made.bands.as_ref();
            all.map(|all| all.iter().map(|band| band.map(|band| band[end])).collect::<Vec<_>>())
        };
        let told = json!({
            "low": end(0), "high": end(1), "formula": given.formula().to_string(), "rows": values.len(), "predicted": values,
            "extrapolated": extrapolated, "errors": errors, "without_value": made.without_value(),
            "without_value_because": (made.without_value() > 0).then_some(NO_VALUE),
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&told)?)?;
        return Ok(ExitCode::SUCCESS);
    }
    let mut notes = vec![format!("{} rows", made.values.len())];
    if made.outside() > 0 {
        notes.push(format!("{} outside the formula's ranges, marked", made.outside()));
    }
    if made.without_value() > 0 {
        notes.push(format!("{} left empty: {NO_VALUE}", made.without_value()));
    }
    if let Some(errors) = errors {
        let (name, rms, worst) = (&given.output().name, errors.rms, errors.worst);
        notes.push(format!("against the column {name}: rms {rms:.6}, worst {worst:.6}"));
    }
    let notes = notes.join("; ");
    match &args.out {
        Some(path) => writeln!(out, "table written to {path}: {notes}")?,
        None => {
            write!(out, "{}", made.csv()?)?;
            eprintln!("{notes}");
        }
    }
    Ok(ExitCode::SUCCESS)
}
