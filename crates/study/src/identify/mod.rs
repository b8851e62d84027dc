//! Identification of the shipped models: from the published tables by least squares (`steadycut identify
//! tables`) and by genetic programming (`steadycut identify genetic`), and from the mechanistic force model
//! (`steadycut identify milling`). From recordings: a feed drive by a step ([`drive`]), the cutting force tooth by tooth
//! ([`force`]), Taylor's constants by readings of the wear land ([`wear`]), noise and ripple ([`noise`]),
//! the material by its force ([`material`]); modes by a frequency response ([`response`]); all of them as front ends ask for
//! them ([`fits`]).

pub mod drive;
mod estimate;
pub mod fits;
pub mod force;
pub mod genetic;
pub mod gp;
mod least_squares;
pub mod material;
mod milling_2005;
pub mod noise;
pub mod response;
mod sdnrp_2007;
mod strategy_2013;
pub mod wear;

use std::fmt::Write as _;

pub use estimate::EstimatedValue;
pub use milling_2005::identify_milling;

use super::published::{PaperId, TableRow};
use crate::base::stats;
use crate::models::genetic::curve::Curve;
use crate::models::genetic::{FeedLaw, ForceRoughness, GeneticModels, ModelSet, SpeedLaw};

/// One fitted quantity with its points and residuals.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// Name of the model, K1..K4 or M2..M5.
    pub model: &'static str,
    /// What is fitted over what.
    pub meaning: &'static str,
    /// Points (x, y).
    pub points: Vec<[f64; 2]>,
    /// Fitted minus given y, per point.
    pub residuals: Vec<f64>,
    /// Unit of y.
    pub unit: &'static str,
}

impl Fit {
    /// Root mean square of the residuals.
    #[must_use]
    pub fn rms(&self) -> f64 {
        stats::rms(self.residuals.iter().copied()).unwrap_or(0.0)
    }

    /// Largest absolute residual.
    #[must_use]
    pub fn worst(&self) -> f64 {
        self.residuals.iter().fold(0.0, |worst: f64, r| worst.max(r.abs()))
    }
}

/// The result of an identification.
#[derive(Clone, Debug)]
pub struct Identified {
    /// The models.
    pub models: GeneticModels,
    /// The fits, with residuals.
    pub fits: Vec<Fit>,
}

/// Identifies the models of a paper from rows of its table.
///
/// # Errors
/// Names the model whose points give no monotone curve.
pub fn identify(paper: PaperId, rows: &[TableRow]) -> Result<Identified, String> {
    match paper {
        PaperId::Sdnrp2007 => sdnrp_2007::identify(rows),
        PaperId::Strategy2013 => strategy_2013::identify(rows),
    }
}

/// The model file that is shipped as `assets/models/identified_<year>.toml`.
#[must_use]
pub fn model_file(identified: &Identified) -> String {
    let models = &identified.models;
    let letter = models.set.letter();
    let (source, command) = match models.set {
        ModelSet::Sdnrp2007 => ("SDNRP 2007, identified from its Table 3", "tables"),
        ModelSet::Strategy2013 => {
            ("the 2013 control strategy, identified from its Table 1", "tables --paper 2013")
        }
        ModelSet::Milling2005 => ("the 2005 milling simulator, identified on it", "milling"),
    };
    let mut text = format!(
        "# Models of {source} by `steadycut identify {command}`.\n\
         # Quadratics c0 + c1 x + c2 x^2 on low..high, continued with their end slopes.\n"
    );
    let mut section = |role: u32, doc: &str, body: String| {
        let name = letter.to_ascii_lowercase();
        let _ = write!(text, "\n# {doc}\n[{name}{role}]\n{body}\n");
    };
    let quadratic = |curve: &Curve| {
        let Curve { coefficients, low, high } = curve;
        format!("coefficients = {coefficients:?}\nlow = {low:?}\nhigh = {high:?}")
    };
    // The milling simulator takes its roughness from the models of 2007.
    if let ForceRoughness::Curve(curve) = &models.roughness
        && models.set != ModelSet::Milling2005
    {
        let doc = format!("Force in N over Ra in um; {letter}5 = {letter}6 is its exact inverse.");
        section(1, &doc, quadratic(curve));
    }
    if let FeedLaw::Curve(curve) = &models.feed {
        section(2, "Feed command in mm/min over the force setpoint in N.", quadratic(curve));
    }
    match &models.speed {
        SpeedLaw::Curve(curve) => {
            let doc = "Spindle speed command in 1/min over the force setpoint in N.";
            section(3, doc, quadratic(curve));
        }
        SpeedLaw::Exponential(law, [low, high]) => {
            let doc = "Spindle speed command scale e^(rate F) in 1/min over the force setpoint F.";
            let (scale, rate) = (law.scale_rpm, law.rate_per_n);
            let body = format!(
                "scale_rpm = {scale:?}\nrate_per_n = {rate:?}\nlow = {low:?}\nhigh = {high:?}"
            );
            section(3, doc, body);
        }
        SpeedLaw::K3 => {}
    }
    let doc = match models.set {
        ModelSet::Sdnrp2007 => {
            "Force intercept - speed n^3 - feed ln(0.039 f) / f: K4 as printed, its intercept restored."
        }
        ModelSet::Strategy2013 => {
            "Force intercept - speed n^3 - feed ln(0.039 f) / f: M4, its speed coefficient as printed."
        }
        ModelSet::Milling2005 => {
            "Force intercept - speed n^3 - feed ln(0.039 f) / f at A_D 2.6 mm, wall 2 mm off the axis."
        }
    };
    let formula = models.force;
    let body = format!(
        "intercept_n = {:?}\nspeed = {:?}\nfeed = {:?}",
        formula.intercept_n, formula.speed, formula.feed
    );
    section(4, doc, body);
    text
}
