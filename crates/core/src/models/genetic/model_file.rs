//! Files of identified models, as `steadycut identify` writes them.

use serde::Deserialize;

use super::curve::Curve;
use super::exponential::Exponential;
use super::force_formula::ForceFormula;
use super::{
    Calibration, CutsAs, FeedLaw, ForceRoughness, GeneticModels, ModelSet, OwnModels, SpeedLaw,
};
use crate::base::files::from_toml;
use crate::base::language::tr;

/// K1..K4 of 2007.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Sdnrp2007File {
    k1: CurveEntry,
    k2: CurveEntry,
    k3: CurveEntry,
    k4: ForceEntry,
}

/// M1..M4 of 2013.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Strategy2013File {
    m1: CurveEntry,
    m2: CurveEntry,
    m3: ExponentialEntry,
    m4: ForceEntry,
}

/// K2..K4 of the milling simulator.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Milling2005File {
    k2: CurveEntry,
    k3: ExponentialEntry,
    k4: ForceEntry,
}

/// A quadratic and the range on which it is one.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "coefficients, low and high")]
struct CurveEntry {
    coefficients: [f64; 3],
    low: f64,
    high: f64,
}

impl CurveEntry {
    fn curve(self, name: &str) -> Result<Curve, String> {
        let Self { coefficients, low, high } = self;
        let [a, b, c] = coefficients;
        finite(name, [("coefficients", a), ("coefficients", b), ("coefficients", c)])?;
        finite(name, [("low", low), ("high", high)])?;
        let curve = Curve { coefficients, low, high };
        if curve.is_monotone() {
            Ok(curve)
        } else {
            Err(tr!(
                "`{name}` turns round within {low}..{high}: allowed is a monotone curve",
                name = name,
                low = low,
                high = high
            ))
        }
    }
}

/// An exponential law and the range on which it was identified.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "scale_rpm, rate_per_n, low and high")]
struct ExponentialEntry {
    scale_rpm: f64,
    rate_per_n: f64,
    low: f64,
    high: f64,
}

impl ExponentialEntry {
    fn law(self, name: &str) -> Result<SpeedLaw, String> {
        let Self { scale_rpm, rate_per_n, low, high } = self;
        finite(name, [("scale_rpm", scale_rpm), ("rate_per_n", rate_per_n)])?;
        finite(name, [("low", low), ("high", high)])?;
        Ok(SpeedLaw::Exponential(Exponential { scale_rpm, rate_per_n }, [low, high]))
    }
}

/// The coefficients of model 4.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "intercept_n, speed and feed")]
struct ForceEntry {
    intercept_n: f64,
    speed: f64,
    feed: f64,
}

impl ForceEntry {
    fn formula(self, name: &str) -> Result<ForceFormula, String> {
        let Self { intercept_n, speed, feed } = self;
        finite(name, [("intercept_n", intercept_n), ("speed", speed), ("feed", feed)])?;
        Ok(ForceFormula { intercept_n, speed, feed })
    }
}

fn finite<const N: usize>(name: &str, values: [(&str, f64); N]) -> Result<(), String> {
    match values.into_iter().find(|(_, value)| !value.is_finite()) {
        Some((field, value)) => Err(tr!(
            "`{name}.{field}` cannot be {value}: allowed is a finite number",
            name = name,
            field = field,
            value = value
        )),
        None => Ok(()),
    }
}

/// Reads the file of a set.
///
/// # Errors
/// Names the entry that is missing, unknown, not a finite number, or makes a curve that is not
/// monotone.
pub fn parse(set: ModelSet, text: &str) -> Result<GeneticModels, String> {
    let (roughness, feed, speed, force) = match set {
        ModelSet::Sdnrp2007 => {
            let file: Sdnrp2007File = from_toml(text)?;
            let speed = SpeedLaw::Curve(file.k3.curve("k3")?);
            let roughness = ForceRoughness::Curve(file.k1.curve("k1")?);
            (roughness, file.k2.curve("k2")?, speed, file.k4.formula("k4")?)
        }
        ModelSet::Strategy2013 => {
            let file: Strategy2013File = from_toml(text)?;
            let roughness = ForceRoughness::Curve(file.m1.curve("m1")?);
            (roughness, file.m2.curve("m2")?, file.m3.law("m3")?, file.m4.formula("m4")?)
        }
        ModelSet::Milling2005 => {
            let file: Milling2005File = from_toml(text)?;
            // The system of 2005 has no model of roughness: that of 2007 stands in.
            let stand_in = GeneticModels::new(ModelSet::Sdnrp2007, Calibration::Identified);
            let feed = file.k2.curve("k2")?;
            (stand_in.roughness, feed, file.k3.law("k3")?, file.k4.formula("k4")?)
        }
    };
    let own = OwnModels::default();
    Ok(GeneticModels {
        set,
        roughness,
        feed: FeedLaw::Curve(feed),
        speed,
        force,
        cuts_as: CutsAs::PAPERS,
        own,
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
            let error = parse(*set, &cut).unwrap_err();
            assert!(error.contains("`x9`") && error.contains(&format!("`{letter}2`")), "{error}");
            let bad = text.replacen("\nlow", "\nlowest", 1);
            let error = parse(*set, &bad).unwrap_err();
            assert!(error.contains("`lowest`") && error.contains("`low`"), "{error}");
            let bad = text.replacen("low = ", "low = \"x\" # ", 1);
            let error = parse(*set, &bad).unwrap_err();
            assert!(error.contains(".low`") && error.contains("allowed is a number"), "{error}");
            let bad = text.replacen("low = ", "low = nan # ", 1);
            assert!(parse(*set, &bad).unwrap_err().contains(".low` cannot be NaN"));
            let other = if letter == 'k' { ModelSet::Strategy2013 } else { ModelSet::Sdnrp2007 };
            assert!(parse(other, text).is_err(), "a file of the other set");
            assert!(parse(*set, "not = toml = here").is_err());
        }
    }
}
