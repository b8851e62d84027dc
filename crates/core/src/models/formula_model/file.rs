//! The file of a formula's model: TOML as people write it, or JSON in one line as a scenario holds it.

use serde::{Deserialize, Serialize};

use super::{FormulaFit, FormulaInput, FormulaModel, FormulaOutput};
use crate::base::files::{JsonLayout, from_json, from_toml, to_json};
use crate::base::formula::{Formula, Interval, NamedConstant, Unit};
use crate::base::language::tr;
use crate::models::tool::ShippedTool;

/// Version of the format.
pub const FORMULA_MODEL_VERSION: u64 = 1;
/// Most inputs of a formula's model.
pub const MAX_MODEL_INPUTS: usize = 8;
/// Longest text read, bytes.
const MAX_BYTES: usize = 60_000;

/// What every version has.
#[derive(Deserialize)]
#[serde(expecting = "the model of a formula")]
struct Version {
    version: u64,
}

/// The fields of the file, in order.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "the model of a formula")]
pub(in crate::models) struct ModelText {
    version: u64,
    formula: String,
    #[serde(default, skip_serializing_if = "String::is_empty")]
    source: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    tool: Option<String>,
    output: OutputText,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    constants: Vec<ConstantText>,
    inputs: Vec<InputText>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    fit: Option<FormulaFit>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "name and unit")]
struct OutputText {
    name: String,
    unit: String,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "name and value")]
struct ConstantText {
    name: String,
    value: f64,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "name, unit, low and high")]
struct InputText {
    name: String,
    unit: String,
    low: f64,
    high: f64,
}

fn from_text<T: serde::de::DeserializeOwned>(text: &str) -> Result<T, String> {
    if text.trim_start().starts_with('{') { from_json(text) } else { from_toml(text) }
}

fn unit(path: &str, text: &str) -> Result<Unit, String> {
    Unit::parse(text).map_err(|problem| format!("`{path}`: {problem}"))
}

fn tool(id: &str) -> Result<ShippedTool, String> {
    ShippedTool::from_id(id).ok_or_else(|| {
        let all: Vec<&str> = ShippedTool::ALL.iter().map(|tool| tool.id()).collect();
        tr!("`tool` cannot be `{id}`: allowed is one of {ids}", id = id, ids = all.join(", "))
    })
}

impl ModelText {
    pub(super) fn read(text: &str) -> Result<Self, String> {
        if text.len() > MAX_BYTES {
            return Err(tr!(
                "{n} bytes; at most {most} are read",
                n = text.len(),
                most = MAX_BYTES
            ));
        }
        // The version comes first: a file of another version may hold anything.
        let Version { version } = from_text(text)?;
        if version != FORMULA_MODEL_VERSION {
            return Err(tr!(
                "`version` cannot be {version}: allowed is {known}",
                version = version,
                known = FORMULA_MODEL_VERSION
            ));
        }
        from_text(text)
    }

    pub(in crate::models) fn model(self) -> Result<FormulaModel, String> {
        let names: Vec<&str> = self.inputs.iter().map(|input| input.name.as_str()).collect();
        let constants: Vec<NamedConstant> = (self.constants.iter())
            .map(|ConstantText { name, value }| NamedConstant { name: name.clone(), value: *value })
            .collect();
        let formula = Formula::parse_with(&self.formula, &names, &constants)
            .map_err(|error| format!("`formula`: {error}"))?;
        let mut inputs = Vec::new();
        for (index, InputText { name, unit: text, low, high }) in
            self.inputs.into_iter().enumerate()
        {
            if !(low.is_finite() && high.is_finite() && low < high) {
                return Err(tr!(
                    "`inputs[{index}]`: the range {low} to {high} of `{name}` is none: allowed is low below high",
                    index = index,
                    low = low,
                    high = high,
                    name = name
                ));
            }
            let unit = unit(&format!("inputs[{index}].unit"), &text)?;
            inputs.push(FormulaInput { name, unit, range: Interval::new(low, high) });
        }
        let unit = unit("output.unit", &self.output.unit)?;
        let output = FormulaOutput { name: self.output.name, unit };
        let tool = self.tool.map(|id| tool(&id)).transpose()?;
        let model = FormulaModel::new(formula, inputs, output, self.source)?.found_on(tool);
        match self.fit {
            Some(fit) => model.with_fit(fit).map_err(|problem| format!("`fit`: {problem}")),
            None => Ok(model),
        }
    }

    pub(in crate::models) fn of(model: &FormulaModel) -> Self {
        let output = model.output();
        let input = |input: &FormulaInput| InputText {
            name: input.name.clone(),
            unit: input.unit.to_string(),
            low: input.range.low,
            high: input.range.high,
        };
        let constants = model.formula().own_constants().into_iter();
        Self {
            version: FORMULA_MODEL_VERSION,
            formula: model.formula().to_string(),
            source: model.source().to_owned(),
            tool: model.tool().map(|tool| tool.id().to_owned()),
            output: OutputText { name: output.name.clone(), unit: output.unit.to_string() },
            constants: constants
                .map(|NamedConstant { name, value }| ConstantText { name, value })
                .collect(),
            inputs: model.inputs().iter().map(input).collect(),
            fit: model.fit().cloned(),
        }
    }

    pub(super) fn toml(&self) -> String {
        toml::to_string(self).unwrap_or_default()
    }

    pub(super) fn json(&self) -> String {
        to_json(self, JsonLayout::Line)
    }
}
