//! Material files: versioned TOML, one material by Kienzle's constants, k_c = k_c1.1 h^-m_c at its hardness.
//!
//! ```text
//! force over that of Ck45 at 200 HB   k_c1.1 0.1^-m_c / (2220 0.1^-0.14) (HB/HB_0)^e      chips of 0.1 mm, as all maps
//! tooth by tooth                      that factor times 2220 0.1^-0.14 (h / 0.1 mm)^-m_c = k_c1.1 h^-m_c (HB/HB_0)^e
//! ```
//!
//! The two formulas are those of the settings `formula.material` and `formula.specific_force`; corrections for rake and
//! speed stay the force model's, and radial and axial forces go with the tangential one.

use serde::Deserialize;

use super::entry::FileEntry;
use crate::base::files::from_toml;
use crate::base::language::{text, tr};
use crate::base::math;
use crate::base::settings::{SettingError, Value};
use crate::blocks::cutting::material::Material;
use crate::models::formula_model::FormulaModel;

const WHAT: &str = text!("material file");
/// Chip thickness at which materials are compared, mm, as for the shipped ones.
const COMPARED_MM: f64 = 0.1;
/// Exponent of the hardness where the file says none: that of the shipped materials (chosen).
const USUAL_EXPONENT: f64 = 0.4;
/// k_c1.1, N/mm^2: what is allowed.
const KC11_N_MM2: [f64; 2] = [100.0, 10_000.0];
/// m_c: what is allowed.
const MC: [f64; 2] = [0.0, 0.6];
/// Hardness, HB: what is allowed, as for `plant.hardness_hb`.
const HARDNESS_HB: [f64; 2] = [60.0, 500.0];
/// Exponent of the hardness: what is allowed.
const EXPONENT: [f64; 2] = [0.0, 2.0];
/// Chips for which Kienzle's law is taken, mm.
const CHIPS_MM: [f64; 2] = [0.001, 1.0];

/// A material as its file describes it.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialFile {
    /// What it is called.
    pub title: String,
    /// Where its values come from.
    pub source: String,
    /// Specific cutting force at a chip of 1 mm x 1 mm, N/mm^2.
    pub kc11_n_mm2: f64,
    /// Kienzle's exponent.
    pub mc: f64,
    /// Hardness at which they hold, HB.
    pub hardness_hb: f64,
    /// Exponent of the force over the hardness.
    pub hardness_exponent: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Whole {
    version: i64,
    title: String,
    source: String,
    kc11_n_mm2: f64,
    mc: f64,
    hardness_hb: f64,
    hardness_exponent: Option<f64>,
}

fn specific_n_mm2(kc11_n_mm2: f64, mc: f64) -> f64 {
    kc11_n_mm2 * math::pow(COMPARED_MM, -mc)
}

impl MaterialFile {
    /// Reads a material file.
    ///
    /// # Errors
    /// Names line, entry and value, and what is allowed.
    pub fn parse(file: &str) -> Result<Self, SettingError> {
        let read: Whole = from_toml(file)
            .map_err(|problem| SettingError::Format { what: tr(WHAT).to_owned(), problem })?;
        let at = |key| FileEntry { what: WHAT, text: file, section: "", key };
        at("version").version(read.version)?;
        let exponent = read.hardness_exponent.unwrap_or(USUAL_EXPONENT);
        Ok(Self {
            title: at("title").words(read.title)?,
            source: at("source").words(read.source)?,
            kc11_n_mm2: at("kc11_n_mm2").number(read.kc11_n_mm2, KC11_N_MM2)?,
            mc: at("mc").number(read.mc, MC)?,
            hardness_hb: at("hardness_hb").number(read.hardness_hb, HARDNESS_HB)?,
            hardness_exponent: at("hardness_exponent").number(exponent, EXPONENT)?,
        })
    }

    /// The settings that it makes.
    ///
    /// # Errors
    /// A formula that is not certain to be finite, which the ranges of the entries exclude.
    pub fn changes(&self) -> Result<Vec<(String, Value)>, SettingError> {
        let Self { kc11_n_mm2, mc, hardness_hb, hardness_exponent, .. } = self;
        let (kc11, m, _) = Material::Ck45.constants();
        let reference = specific_n_mm2(kc11, m);
        let factor = specific_n_mm2(*kc11_n_mm2, *mc) / reference;
        let [least, largest] = HARDNESS_HB;
        let material = self.model(
            &format!("{factor:?}*(HB/{hardness_hb:?})^{hardness_exponent:?}"),
            ["k", ""],
            ["HB", "HB"],
            [least, largest],
        )?;
        let specific = self.model(
            &format!("{:?}*(h/{COMPARED_MM:?})^{:?}", reference, -mc),
            ["kc", "N/mm^2"],
            ["h", "mm"],
            CHIPS_MM,
        )?;
        Ok(vec![
            ("plant.hardness_hb".to_owned(), Value::Float(*hardness_hb)),
            ("formula.material".to_owned(), Value::Text(material)),
            ("formula.specific_force".to_owned(), Value::Text(specific)),
        ])
    }

    /// The text of a formula's model.
    fn model(
        &self,
        formula: &str,
        [name, unit]: [&str; 2],
        [input, input_unit]: [&str; 2],
        [low, high]: [f64; 2],
    ) -> Result<String, SettingError> {
        let quoted = |text: &str| toml::Value::String(text.to_owned()).to_string();
        let model = format!(
            "version = 1\nformula = {}\nsource = {}\n[output]\nname = \"{name}\"\nunit = \"{unit}\"\n\
             [[inputs]]\nname = \"{input}\"\nunit = \"{input_unit}\"\nlow = {low:?}\nhigh = {high:?}\n",
            quoted(formula),
            quoted(&self.title)
        );
        let fault = |problem: String| SettingError::Format { what: tr(WHAT).to_owned(), problem };
        FormulaModel::parse(&model).map(|model| model.write_line()).map_err(fault)
    }
}
