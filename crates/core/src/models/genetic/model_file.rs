//! Files of identified models, as `steadycut identify` writes them.

use super::curve::Curve;
use super::exponential::Exponential;
use super::force_formula::ForceFormula;
use super::{Calibration, FeedLaw, ForceRoughness, GeneticModels, ModelSet, SpeedLaw};

struct Reader {
    table: toml::Table,
}

impl Reader {
    fn number(&self, section: &str, name: &str) -> Result<f64, String> {
        let value = self.table.get(section).and_then(|entry| entry.get(name));
        number(&format!("{section}.{name}"), value)
    }

    fn curve(&self, section: &str) -> Result<Curve, String> {
        let entry = self.table.get(section).ok_or_else(|| format!("`{section}` is missing"))?;
        let list = entry.get("coefficients").and_then(toml::Value::as_array);
        let list = list.filter(|list| list.len() == 3);
        let list = list.ok_or_else(|| format!("`{section}.coefficients` must be three numbers"))?;
        let mut coefficients = [0.0; 3];
        for (i, coefficient) in coefficients.iter_mut().enumerate() {
            *coefficient = number(&format!("{section}.coefficients"), list.get(i))?;
        }
        let (low, high) = (self.number(section, "low")?, self.number(section, "high")?);
        let curve = Curve { coefficients, low, high };
        if curve.is_monotone() {
            Ok(curve)
        } else {
            Err(format!("`{section}` turns round within {low}..{high}"))
        }
    }
}

fn number(name: &str, value: Option<&toml::Value>) -> Result<f64, String> {
    value
        .and_then(|v| v.as_float().or_else(|| v.as_integer().map(|i| i as f64)))
        .filter(|x| x.is_finite())
        .ok_or_else(|| format!("`{name}` must be a finite number"))
}

/// Reads the file of a set.
///
/// # Errors
/// Names the entry that is missing, not a number, or makes a curve that is not monotone.
pub fn parse(set: ModelSet, text: &str) -> Result<GeneticModels, String> {
    let table = text.parse().map_err(|error| format!("not TOML: {error}"))?;
    let reader = Reader { table };
    let name = |role: u32| format!("{}{role}", set.letter().to_ascii_lowercase());
    let speed = match set {
        ModelSet::Sdnrp2007 => SpeedLaw::Curve(reader.curve(&name(3))?),
        ModelSet::Strategy2013 | ModelSet::Milling2005 => {
            let of = |field: &str| reader.number(&name(3), field);
            let law = Exponential { scale_rpm: of("scale_rpm")?, rate_per_n: of("rate_per_n")? };
            SpeedLaw::Exponential(law, [of("low")?, of("high")?])
        }
    };
    let roughness = match set {
        // The system of 2005 has no model of roughness: that of 2007 stands in.
        ModelSet::Milling2005 => {
            GeneticModels::new(ModelSet::Sdnrp2007, Calibration::Identified).roughness
        }
        _ => ForceRoughness::Curve(reader.curve(&name(1))?),
    };
    let of = |field: &str| reader.number(&name(4), field);
    Ok(GeneticModels {
        set,
        roughness,
        feed: FeedLaw::Curve(reader.curve(&name(2))?),
        speed,
        force: ForceFormula {
            intercept_n: of("intercept_n")?,
            speed: of("speed")?,
            feed: of("feed")?,
        },
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn model_files_with_faults_are_refused_by_name() {
        for set in ModelSet::ALL {
            let (text, letter) = (set.identified_file(), set.letter().to_ascii_lowercase());
            parse(*set, text).expect("the shipped file");
            let cut = text.replacen(&format!("[{letter}2]"), "[x9]", 1);
            assert!(parse(*set, &cut).unwrap_err().contains(&format!("`{letter}2`")));
            let bad = text.replacen("\nlow", "\nlowest", 1);
            assert!(parse(*set, &bad).unwrap_err().contains(".low"));
            let other = if letter == 'k' { ModelSet::Strategy2013 } else { ModelSet::Sdnrp2007 };
            assert!(parse(other, text).is_err(), "a file of the other set");
            assert!(parse(*set, "not = toml = here").is_err());
        }
    }
}
