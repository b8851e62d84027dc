//! Models that are declared before a chip is cut: which terms a plan has to tell apart.
//!
//! Terms of factors are in coded levels, -1 at the low and 1 at the high end of a range; those of the papers and
//! one's own are in the factors' units.

use super::factor::FactorKind;
use super::plan::ExperimentPlan;
use crate::base::formula::{CompiledFormula, Formula};

steadycut_core::choice! {
    /// A declared model.
    pub enum DeclaredModel {
        /// A constant and every factor.
        Linear = "linear", "linear";
        /// The same and all products of two factors.
        Interactions = "interactions", "with interactions";
        /// The same and all squares.
        Quadratic = "quadratic", "quadratic";
        /// The structure of K4 and M4: a + b n^3 + c ln(0.039 f) / f (2007 eq. 7, 2013 eq. 5).
        Papers = "papers", "as K4 of the papers";
    }
}

/// What a column of the model matrix is made of.
#[derive(Clone, Debug)]
enum Part {
    /// A product of variables.
    Product(Vec<usize>),
    /// A formula of the factors in their units.
    Formula(Box<CompiledFormula>),
}

/// A variable: a factor in coded levels, or one cutter against the last one.
#[derive(Clone, Debug)]
struct Variable {
    name: String,
    factor: usize,
    cutter: Option<usize>,
}

/// The terms of a declared model.
#[derive(Clone, Debug)]
pub struct TermSet {
    /// Names of the terms.
    pub names: Vec<String>,
    parts: Vec<Part>,
    variables: Vec<Variable>,
}

fn variables(plan: &ExperimentPlan) -> Vec<Variable> {
    let mut all = Vec::new();
    for (factor, one) in plan.factors.iter().enumerate() {
        match one.cutters() {
            None => {
                all.push(Variable { name: one.kind.id().to_owned(), factor, cutter: None });
            }
            Some(cutters) => {
                for (cutter, tool) in cutters.iter().enumerate().skip(1) {
                    let name = format!("tool {}", tool.id());
                    all.push(Variable { name, factor, cutter: Some(cutter) });
                }
            }
        }
    }
    all
}

impl TermSet {
    /// The terms of a declared model for a plan.
    ///
    /// # Errors
    /// The papers' terms without feed and speed among the factors.
    pub fn declared(model: DeclaredModel, plan: &ExperimentPlan) -> Result<Self, String> {
        let products = match model {
            DeclaredModel::Linear => 1,
            DeclaredModel::Interactions => 2,
            DeclaredModel::Quadratic => 3,
            DeclaredModel::Papers => {
                let has = |kind| plan.factors.iter().any(|factor| factor.kind == kind);
                if !has(FactorKind::Feed) || !has(FactorKind::Speed) {
                    return Err("the papers' terms need the factors feed and speed".to_owned());
                }
                let [f, n] = [FactorKind::Feed, FactorKind::Speed].map(FactorKind::column);
                return Self::own(&[format!("{n}^3"), format!("ln(0.039*{f})/{f}")], plan);
            }
        };
        let variables = variables(plan);
        let mut parts = vec![vec![]];
        parts.extend((0..variables.len()).map(|variable| vec![variable]));
        for a in 0..variables.len() {
            for b in a + 1..variables.len() {
                if products >= 2 && variables[a].factor != variables[b].factor {
                    parts.push(vec![a, b]);
                }
            }
        }
        let squares = (0..variables.len()).filter(|a| variables[*a].cutter.is_none());
        parts.extend(squares.filter(|_| products >= 3).map(|a| vec![a, a]));
        let name = |part: &Vec<usize>| match part[..] {
            [] => "1".to_owned(),
            [a] => variables[a].name.clone(),
            [a, b] if a == b => format!("{}^2", variables[a].name),
            _ => {
                let names: Vec<&str> = part.iter().map(|a| variables[*a].name.as_str()).collect();
                names.join(" * ")
            }
        };
        let names = parts.iter().map(name).collect();
        Ok(Self { names, parts: parts.into_iter().map(Part::Product).collect(), variables })
    }

    /// A constant and formulas of the columns of the plan's factors.
    ///
    /// # Errors
    /// Names the formula that cannot be read, or has no finite value at a run.
    pub fn own(formulas: &[String], plan: &ExperimentPlan) -> Result<Self, String> {
        let columns: Vec<&str> = plan.factors.iter().map(|factor| factor.kind.column()).collect();
        let mut set = Self {
            names: vec!["1".to_owned()],
            parts: vec![Part::Product(Vec::new())],
            variables: Vec::new(),
        };
        for text in formulas {
            let formula = Formula::parse(text, &columns)
                .map_err(|error| format!("term `{text}`: {error}"))?;
            if formula.reads().iter().all(|reads| !reads) {
                return Err(format!("term `{text}`: it reads no factor"));
            }
            let program = formula.compile();
            if let Some(run) = plan.runs.iter().find(|run| !program.value(&run.values).is_finite())
            {
                return Err(format!("term `{text}`: run {} has no finite value", run.run));
            }
            set.names.push(formula.to_string());
            set.parts.push(Part::Formula(Box::new(program)));
        }
        Ok(set)
    }

    /// The values of all terms at values of the factors.
    #[must_use]
    pub fn row(&self, plan: &ExperimentPlan, values: &[f64]) -> Vec<f64> {
        let level = |variable: &Variable| {
            let factor = &plan.factors[variable.factor];
            let value = values[variable.factor];
            match variable.cutter {
                None => factor.coded(value),
                // Effects against the mean of all cutters: the first one has all at -1.
                Some(_) if value == 0.0 => -1.0,
                Some(cutter) => f64::from(u8::from(value as usize == cutter)),
            }
        };
        let levels: Vec<f64> = self.variables.iter().map(level).collect();
        let term = |part: &Part| match part {
            Part::Product(of) => of.iter().map(|variable| levels[*variable]).product(),
            Part::Formula(formula) => formula.value(values),
        };
        self.parts.iter().map(term).collect()
    }
}
