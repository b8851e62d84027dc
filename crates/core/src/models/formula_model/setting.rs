//! A formula's model as a setting, or none: its value is the text of the model's file in one line, so that a run
//! stays a pure function of its scenario.

use std::marker::PhantomData;
use std::sync::Arc;

use super::{FormulaModel, all_of};
use crate::base::formula::Unit;
use crate::base::language::tr;
use crate::base::settings::{Editor, FormulaShape, Structure, Value};

/// What a model stands for: the units of its inputs, in their order, and of its result.
pub trait FormulaRole: Clone + std::fmt::Debug + PartialEq + 'static {
    /// Name of the setting's kind.
    const ID: &'static str;
    /// Units of the inputs, in this order; their names are free.
    const INPUTS: &'static [&'static str];
    /// What the inputs are, in words.
    const MEANING: &'static str;
    /// Unit of the result.
    const OUTPUT: &'static str;
    /// A model for tests and as an example, in one line.
    const EXAMPLE: &'static str;
}

/// Declares what a model stands for.
macro_rules! role {
    ($(#[doc = $doc:literal])+ $name:ident, $id:literal, $inputs:expr, $meaning:literal, $output:literal, $example:expr) => {
        $(#[doc = $doc])+
        #[derive(Clone, Debug, PartialEq)]
        pub struct $name;

        impl $crate::models::formula_model::FormulaRole for $name {
            const ID: &'static str = $id;
            const INPUTS: &'static [&'static str] = $inputs;
            const MEANING: &'static str = $meaning;
            const OUTPUT: &'static str = $output;
            const EXAMPLE: &'static str = $example;
        }
    };
}
pub(crate) use role;

/// A formula of a user's own in a role, or none. Shared, so that a scenario is copied quickly.
#[derive(Clone, Debug, PartialEq)]
pub struct OwnFormula<R: FormulaRole> {
    model: Option<Arc<FormulaModel>>,
    role: PhantomData<R>,
}

/// A unit as people read it.
fn told(unit: &str) -> &str {
    if unit.is_empty() { tr("a number without a unit") } else { unit }
}

impl<R: FormulaRole> Default for OwnFormula<R> {
    fn default() -> Self {
        Self { model: None, role: PhantomData }
    }
}

impl<R: FormulaRole> OwnFormula<R> {
    /// The model, if there is one.
    #[must_use]
    pub fn get(&self) -> Option<&Arc<FormulaModel>> {
        self.model.as_ref()
    }

    /// Takes a model into this role.
    ///
    /// # Errors
    /// Says which inputs and which result the role has.
    pub fn of(model: FormulaModel) -> Result<Self, String> {
        let known = |text: &str| Unit::parse(text).unwrap_or_else(|_| Unit::none());
        let output = &model.output().unit;
        // The units tell the inputs apart, whatever their order is; of those of one unit the order counts.
        let mut order: Option<Vec<usize>> = Some(Vec::new());
        for text in R::INPUTS {
            let unit = known(text);
            order = order.and_then(|mut taken| {
                let place = (0..model.inputs().len()).find(|place| {
                    !taken.contains(place) && model.inputs()[*place].unit.is_same(&unit)
                })?;
                taken.push(place);
                Some(taken)
            });
        }
        let order = order.filter(|_| {
            model.inputs().len() == R::INPUTS.len() && output.is_same(&known(R::OUTPUT))
        });
        let Some(order) = order else {
            let given: Vec<String> = model
                .inputs()
                .iter()
                .map(|input| {
                    let unit = input.unit.to_string();
                    tr!("`{name}` in {unit}", name = &input.name, unit = told(&unit))
                })
                .collect();
            return Err(tr!(
                "it makes {output} of {inputs}: allowed is {wanted} of {of}",
                output = told(&output.to_string()),
                inputs = all_of(given),
                wanted = told(R::OUTPUT),
                of = tr(R::MEANING)
            ));
        };
        let model = model.in_order(&order)?.without_fit();
        Ok(Self { model: Some(Arc::new(model)), role: PhantomData })
    }

    /// Reads the setting's text; none for no text.
    fn from_text(text: &str) -> Result<Self, String> {
        if text.trim().is_empty() {
            Ok(Self::default())
        } else {
            Self::of(FormulaModel::parse(text)?)
        }
    }
}

impl<R: FormulaRole> Structure for OwnFormula<R> {
    const ID: &'static str = R::ID;

    fn bounds(_: [f64; 2]) -> Vec<(&'static str, f64)> {
        Vec::new()
    }
    fn allowed(_: [f64; 2], _: &str) -> String {
        tr!(
            "nothing, or the text of a formula's model file: {wanted} of {of}, finite on its ranges",
            wanted = told(R::OUTPUT),
            of = tr(R::MEANING)
        )
    }
    fn write(&self) -> Value {
        Value::Text(self.model.as_ref().map_or_else(String::new, |model| model.write_line()))
    }
    fn read(value: &Value, _: [f64; 2]) -> Option<Self> {
        let Value::Text(text) = value else { return None };
        Self::from_text(text).ok()
    }
    fn parse(text: &str) -> Option<Value> {
        Some(Value::Text(text.to_owned()))
    }
    fn fault(value: &Value) -> Option<String> {
        let Value::Text(text) = value else { return None };
        // The line with the caret does not go into a message of one line.
        let fault = Self::from_text(text).err()?;
        let fault = fault.lines().next().unwrap_or_default();
        Some(tr!("this text ({problem})", problem = fault))
    }
    fn editor(_: [f64; 2]) -> Editor {
        Editor::Formula(FormulaShape {
            inputs: R::INPUTS,
            meaning: R::MEANING,
            output: R::OUTPUT,
            example: R::EXAMPLE,
        })
    }
    fn example(_: [f64; 2], _: f64, _: u32) -> Value {
        Value::Text(R::EXAMPLE.to_owned())
    }
}

impl<R: FormulaRole> crate::base::settings::Field for OwnFormula<R> {
    fn kind(min: f64, max: f64) -> crate::base::settings::Kind {
        let shape = crate::base::settings::Structured::new::<Self>([min, max]);
        crate::base::settings::Kind::Structured(shape)
    }
    fn to_value(&self) -> Value {
        Structure::write(self)
    }
    fn from_value(value: &Value, kind: &crate::base::settings::Kind) -> Option<Self> {
        let crate::base::settings::Kind::Structured(shape) = kind else { return None };
        <Self as Structure>::read(value, shape.range())
    }
}
