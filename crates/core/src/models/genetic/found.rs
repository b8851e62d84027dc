//! Models that this program's own genetic programming has found in the published tables, as `steadycut
//! identify genetic` writes them: the formulas of models 1 to 5 of a set in one file.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::{ModelSet, OwnModels};
use crate::base::files::from_toml;
use crate::models::formula_model::{FormulaModel, FormulaRole, ModelText, OwnFormula};

use super::own::{FeedOfForce, ForceOfCut, ForceOfRa, RaOfForce, SpeedOfForce};

/// The sections of the file, in order.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "the formulas of models 1 to 5")]
struct FoundFile {
    force_of_ra: ModelText,
    feed: ModelText,
    speed: ModelText,
    force: ModelText,
    ra: ModelText,
}

impl ModelSet {
    /// The shipped file of the models found by genetic programming; none for the milling simulator of 2005,
    /// for which no table was printed.
    #[must_use]
    pub fn found_file(self) -> Option<&'static str> {
        match self {
            Self::Sdnrp2007 => Some(include_str!("../../../../../assets/models/genetic_2007.toml")),
            Self::Strategy2013 => {
                Some(include_str!("../../../../../assets/models/genetic_2013.toml"))
            }
            Self::Milling2005 => None,
        }
    }
}

fn of<R: FormulaRole>(section: &str, text: ModelText) -> Result<Option<Arc<FormulaModel>>, String> {
    let model = text.model().and_then(OwnFormula::<R>::of);
    model.map(|own| own.get().cloned()).map_err(|problem| format!("[{section}]: {problem}"))
}

/// Reads a file of found models.
///
/// # Errors
/// Names the section and entry that is missing, unknown, or no model of its role.
pub fn parse(text: &str) -> Result<OwnModels, String> {
    let FoundFile { force_of_ra, feed, speed, force, ra } = from_toml(text)?;
    Ok(OwnModels {
        force_of_ra: of::<ForceOfRa>("force_of_ra", force_of_ra)?,
        feed: of::<FeedOfForce>("feed", feed)?,
        speed: of::<SpeedOfForce>("speed", speed)?,
        force: of::<ForceOfCut>("force", force)?,
        ra: of::<RaOfForce>("ra", ra)?,
        force_offset_n: 0.0,
    })
}

/// The text of the file: models 1 to 5, in this order.
#[must_use]
pub fn write(models: [&FormulaModel; 5]) -> String {
    let [force_of_ra, feed, speed, force, ra] = models.map(ModelText::of);
    toml::to_string(&FoundFile { force_of_ra, feed, speed, force, ra }).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn file_gives_the_models_back_and_faults_are_named() {
        for set in ModelSet::ALL {
            let Some(text) = set.found_file() else { continue };
            let own = parse(text).expect("the shipped file");
            let all = [&own.force_of_ra, &own.feed, &own.speed, &own.force, &own.ra];
            let models = all.map(|model| FormulaModel::clone(model.as_ref().expect("a model")));
            let written = write(models.each_ref());
            assert_eq!(parse(&written).expect("what is written can be read"), own);
            for (from, to, part) in [
                ("[speed]", "[sped]", "`sped`"),
                (
                    "[feed.output]\nname = \"f\"\nunit = \"mm/min\"",
                    "[feed.output]\nname = \"f\"\nunit = \"N\"",
                    "[feed]",
                ),
                (
                    "[ra]\nversion = 1\nformula = \"",
                    "[ra]\nversion = 1\nformula = \"2 x + ",
                    "column",
                ),
            ] {
                let bad = written.replacen(from, to, 1);
                assert_ne!(bad, written, "{from}");
                let said = parse(&bad).expect_err(to);
                assert!(said.contains(part), "{to}: {said}");
            }
        }
        assert!(ModelSet::Milling2005.found_file().is_none());
    }
}
