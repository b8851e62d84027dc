//! What `steadycut formula` tells of a formula: its forms, derivatives, units and what is certain over its ranges.

use std::fmt::Write;

use serde_json::{Value, json};

use super::formula::Given;
use crate::base::formula::{
    Certificate, Formula, FormulaLanguage, Interval, NumberUnits, Trend, UncertifiedPlace,
    UnitReport, widened_physically,
};
use crate::models::formula_model::FormulaModel;

/// How much wider than its ranges a formula is certified too, on each side.
const WIDER: f64 = 0.3;

fn units(given: &Given) -> Result<UnitReport, String> {
    let report = match given {
        Given::Model(model) => model.units(),
        Given::Text { formula, units, output } => {
            formula.check_units(units, &output.unit, NumberUnits::Solved)
        }
    };
    report.map_err(|error| error.to_string())
}

/// Ranges and wider ones, with what is certain there.
fn certificates(model: &FormulaModel) -> Vec<(&'static str, Result<Certificate, String>)> {
    let ranges: Vec<Interval> = model.inputs().iter().map(|input| input.range).collect();
    let wider = widened_physically(&ranges, WIDER);
    let formula = model.formula();
    vec![
        ("on its ranges", formula.certify(&ranges)),
        ("on ranges wider by 30 % on each side", formula.certify(&wider)),
    ]
}

/// All of it as text.
pub fn told(given: &Given) -> String {
    let formula = given.formula();
    let mut text = String::new();
    // Writing to a text does not fail.
    let _ = write_told(&mut text, given, formula);
    text
}

fn write_told(text: &mut String, given: &Given, formula: &Formula) -> std::fmt::Result {
    let simplified = formula.simplified();
    writeln!(text, "{formula}\n")?;
    writeln!(text, "{} nodes, every number, input, function and operator counted", formula.size())?;
    if simplified != *formula {
        writeln!(text, "simplified to {} nodes: {simplified}", simplified.size())?;
    }
    if let Given::Model(model) = given {
        writeln!(text, "{}", ranges(model))?;
        if !model.source().is_empty() {
            writeln!(text, "source: {}", model.source())?;
        }
    }
    writeln!(text, "\nDerivatives")?;
    for (index, name) in formula.inputs().iter().enumerate() {
        let derivative = formula.derivative(index);
        let shown = derivative.map_or_else(|problem| problem, |found| found.to_string());
        writeln!(text, "  by {name}: {shown}")?;
    }
    writeln!(text, "\nUnits")?;
    match units(given) {
        Ok(report) if report.constants.is_empty() => {
            writeln!(text, "  they fit; there are no constants")?
        }
        Ok(report) => {
            for constant in report.constants {
                let free = if constant.fixed { "" } else { " (shared with another constant)" };
                writeln!(text, "  {:<24} {}{free}", constant.text, constant.unit)?;
            }
        }
        Err(problem) => writeln!(text, "  they do not fit: {}", problem.replace('\n', "\n  "))?,
    }
    if let Given::Model(model) = given {
        for (place, certificate) in certificates(model) {
            writeln!(text, "\nCertain {place}")?;
            match certificate {
                Ok(certificate) => write_certificate(text, model, &certificate)?,
                Err(problem) => writeln!(text, "  {problem}")?,
            }
        }
    }
    for language in FormulaLanguage::ALL.iter().filter(|l| **l != FormulaLanguage::Text) {
        let written = formula.export(*language, "formula");
        writeln!(text, "\n{}\n{}", language.label(), written.trim_end())?;
    }
    Ok(())
}

fn ranges(model: &FormulaModel) -> String {
    let output = model.output();
    let unit = |text: &dyn std::fmt::Display| {
        let text = text.to_string();
        if text.is_empty() { String::new() } else { format!(" in {text}") }
    };
    let inputs: Vec<String> = (model.inputs().iter())
        .map(|input| {
            format!(
                "{} from {} to {}{}",
                input.name,
                input.range.low,
                input.range.high,
                unit(&input.unit)
            )
        })
        .collect();
    format!("{}{}: {}", output.name, unit(&output.unit), inputs.join(", "))
}

fn write_certificate(
    text: &mut String,
    model: &FormulaModel,
    certificate: &Certificate,
) -> std::fmt::Result {
    let names: Vec<&str> = model.inputs().iter().map(|input| input.name.as_str()).collect();
    let place = |place: &UncertifiedPlace| {
        let at = names.iter().zip(&place.at);
        let at: Vec<String> =
            at.map(|(name, x)| format!("{name} {} to {}", x.low, x.high)).collect();
        format!("{}: {}", at.join(", "), place.why)
    };
    match certificate.values {
        Some(values) => {
            writeln!(text, "  finite everywhere, from {} to {}", values.low, values.high)?
        }
        None => {
            writeln!(text, "  not certified to be finite")?;
            for open in &certificate.not_finite {
                writeln!(text, "    {}", place(open))?;
            }
        }
    }
    for (name, trend) in names.iter().zip(&certificate.trends) {
        match trend {
            Trend::Constant => writeln!(text, "  does not depend on {name}")?,
            Trend::Rising => writeln!(text, "  never falls with {name}")?,
            Trend::Falling => writeln!(text, "  never rises with {name}")?,
            Trend::Turning => writeln!(text, "  turns with {name}: it rises here and falls there")?,
            Trend::Uncertified(places) => {
                writeln!(text, "  with {name}: not certified")?;
                for open in places {
                    writeln!(text, "    {}", place(open))?;
                }
            }
        }
    }
    Ok(())
}

/// All of it as JSON.
pub fn told_json(given: &Given) -> Value {
    let formula = given.formula();
    let simplified = formula.simplified();
    let derivative = |index: usize| match formula.derivative(index) {
        Ok(found) => json!({ "by": formula.inputs()[index], "formula": found.to_string() }),
        Err(problem) => json!({ "by": formula.inputs()[index], "problem": problem }),
    };
    let derivatives: Vec<Value> = (0..formula.inputs().len()).map(derivative).collect();
    let languages: serde_json::Map<String, Value> = (FormulaLanguage::ALL.iter())
        .map(|language| (language.id().to_owned(), formula.export(*language, "formula").into()))
        .collect();
    let units = match units(given) {
        Ok(report) => {
            let constants: Vec<Value> = (report.constants.iter())
                .map(|c| json!({ "constant": c.text, "value": c.value, "unit": c.unit, "fixed": c.fixed }))
                .collect();
            json!({ "fit": true, "constants": constants })
        }
        Err(problem) => json!({ "fit": false, "problem": problem }),
    };
    let mut told = json!({
        "formula": formula.to_string(), "inputs": formula.inputs(), "size": formula.size(),
        "simplified": { "formula": simplified.to_string(), "size": simplified.size() },
        "derivatives": derivatives, "units": units, "languages": languages,
    });
    if let Given::Model(model) = given {
        let all: Vec<Value> = certificates(model)
            .into_iter()
            .map(|(place, certificate)| match certificate {
                Ok(certificate) => certified(place, &certificate),
                Err(problem) => json!({ "place": place, "problem": problem }),
            })
            .collect();
        told["certificates"] = all.into();
    }
    told
}

fn pair(interval: &Interval) -> [f64; 2] {
    [interval.low, interval.high]
}

fn certified(place: &str, certificate: &Certificate) -> Value {
    let places = |all: &[UncertifiedPlace]| -> Vec<Value> {
        let told = |place: &UncertifiedPlace| json!({ "at": place.at.iter().map(pair).collect::<Vec<_>>(), "why": place.why });
        all.iter().map(told).collect()
    };
    let trend = |trend: &Trend| match trend {
        Trend::Constant => json!("constant"),
        Trend::Rising => json!("rising"),
        Trend::Falling => json!("falling"),
        Trend::Turning => json!("turning"),
        Trend::Uncertified(all) => json!({ "uncertified": places(all) }),
    };
    json!({
        "place": place, "ranges": certificate.ranges.iter().map(pair).collect::<Vec<_>>(),
        "finite": certificate.is_finite(), "values": certificate.values.as_ref().map(pair),
        "not_finite": places(&certificate.not_finite),
        "trends": certificate.trends.iter().map(trend).collect::<Vec<_>>(),
    })
}
