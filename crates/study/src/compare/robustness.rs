//! Experiment 2 under changed conditions, nothing retuned: other dead times (the controllers know
//! them) and another steel (they do not), beside the figures of an independent prototype.

use serde::{Deserialize, Serialize};

use super::claims::ControlClaim;
use super::entrants::{BEYOND, Entrant, Method, OWN, TABLE_1, experiment_2, set_dead_time};
use super::outcome::Measure;
use super::tournament::Compared;
use crate::base::language::{text, tr};
use crate::blocks::control::script::ScriptSettings;
use crate::blocks::cutting::material::Material;
use crate::run::scenario::Settings;

/// The prototype's figures.
pub const REFERENCE: &str = include_str!("../../../../assets/data/robustness_2005.csv");

/// What is changed about the plant.
#[derive(Clone, Copy, Debug)]
pub struct RobustnessCondition {
    /// Its name in the reference table.
    pub id: &'static str,
    /// Its name for people.
    pub label: &'static str,
    apply: fn(&mut Settings),
}

/// The conditions; the second is that of Table 1.
pub const CONDITIONS: [RobustnessCondition; 4] = [
    RobustnessCondition {
        id: "dead_time_0",
        label: text!("no dead time"),
        apply: |s| set_dead_time(s, 0.0),
    },
    RobustnessCondition {
        id: "dead_time_40",
        label: text!("dead time 40 ms"),
        apply: |s| set_dead_time(s, 0.04),
    },
    RobustnessCondition {
        id: "dead_time_80",
        label: text!("dead time 80 ms"),
        apply: |s| set_dead_time(s, 0.08),
    },
    RobustnessCondition {
        id: "16mncrsi5",
        label: text!("16MnCrSi5 in place of Ck45"),
        apply: |s| {
            s.plant.material = Material::MnCrSi5;
            s.plant.hardness_hb = s.plant.material.hardness_hb();
        },
    },
];

/// The methods of Table 1, P with the Smith predictor, and a script of one's own where there is one.
pub fn methods(with_script: bool) -> impl Iterator<Item = &'static Method> {
    let own = OWN.iter().filter(move |_| with_script);
    TABLE_1.iter().chain(BEYOND.iter().take(1)).chain(own)
}

/// All entrants, condition by condition; a script of one's own takes part where one is given.
#[must_use]
pub fn entrants(script: Option<&ScriptSettings>) -> Vec<Entrant> {
    let mut base = experiment_2();
    if let Some(script) = script {
        let own = base.change(|settings| settings.controller.script = script.clone());
        own.expect("no rule joins a script with other settings");
    }
    let under = |condition: &RobustnessCondition| {
        let changed = base.with(condition.apply).expect("tested: every condition is in range");
        methods(script.is_some()).map(|method| method.on(&changed)).collect::<Vec<Entrant>>()
    };
    CONDITIONS.iter().flat_map(under).collect()
}

/// A row of the prototype's figures.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct RobustnessReference {
    /// The condition's id.
    pub condition: String,
    /// The method's name.
    pub method: String,
    /// Normalised standard error over all samples in contact, if known.
    pub normalized_standard_error: Option<f64>,
    /// Time of the cut, s, if known.
    pub time_of_cut_s: Option<f64>,
    /// Largest force, kN, if known.
    pub max_force_kn: Option<f64>,
}

impl RobustnessReference {
    /// The figure of a measure, if known.
    #[must_use]
    pub fn get(&self, measure: Measure) -> Option<f64> {
        match measure {
            Measure::Nsn => self.normalized_standard_error,
            Measure::Time => self.time_of_cut_s,
            Measure::Force => self.max_force_kn,
            Measure::Nsn20
            | Measure::InTolerance
            | Measure::Held
            | Measure::Recovery
            | Measure::Travel => None,
        }
    }
}

/// The prototype's figures.
///
/// # Panics
/// Never: a test reads the shipped table.
#[must_use]
pub fn reference() -> Vec<RobustnessReference> {
    let mut reader =
        csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(REFERENCE.as_bytes());
    let rows: Result<Vec<RobustnessReference>, csv::Error> = reader.deserialize().collect();
    rows.expect("the shipped table is checked by a test")
}

/// One method under one condition.
#[derive(Clone, Debug, Serialize)]
pub struct RobustnessRow {
    /// The condition's id.
    pub condition: &'static str,
    /// The condition's name for people.
    pub label: &'static str,
    /// What the runs gave.
    pub found: Compared,
    /// What the prototype had, if anything.
    pub reference: Option<RobustnessReference>,
}

/// The table of a tournament over [`entrants`], with the prototype's figures.
#[must_use]
pub fn rows(table: Vec<Compared>) -> Vec<RobustnessRow> {
    let known = reference();
    let each = (table.len() / CONDITIONS.len()).max(1);
    let row = |(index, found): (usize, Compared)| {
        let condition = &CONDITIONS[(index / each).min(CONDITIONS.len() - 1)];
        let same =
            |row: &&RobustnessReference| row.condition == condition.id && row.method == found.name;
        let reference = known.iter().find(same).cloned();
        RobustnessRow { condition: condition.id, label: condition.label, found, reference }
    };
    table.into_iter().enumerate().map(row).collect()
}

/// Growth in error and largest force that still counts as insensitive (chosen).
const INSENSITIVE: f64 = 1.05;

/// The paper's claim about materials; none while one of its runs is missing.
#[must_use]
pub fn material_claim(rows: &[RobustnessRow]) -> Option<ControlClaim> {
    let find = |condition: &str, name: &str| {
        let mut all = rows.iter().filter(|row| row.condition == condition);
        all.find(|row| row.found.name == name && row.found.runs > 0)
    };
    let mean = |condition: &str, name: &str, measure: Measure| {
        Some(find(condition, name)?.found.mean(measure))
    };
    let [ck45, other] = ["dead_time_40", "16mncrsi5"];
    let both = |name: &str, measure: Measure| {
        Some([mean(ck45, name, measure)?, mean(other, name, measure)?])
    };
    let [nsn_before, nsn] = both("UNKS", Measure::Nsn)?;
    let [before_kn, force_kn] = both("UNKS", Measure::Force)?;
    let told = |name: &str| {
        let [before, after] = both(name, Measure::Force)?;
        Some(tr!(
            "{name} {before:.2} and {after:.2} kN",
            name = tr(name),
            before = before,
            after = after
        ))
    };
    let told: Vec<String> =
        ["UNKS", "Adjustable PI", "P", "Conventional"].into_iter().filter_map(told).collect();
    Some(ControlClaim {
        id: "insensitive_to_material",
        paper: text!("UNKS is insensitive to the workpiece's material"),
        verdict: (nsn <= INSENSITIVE * nsn_before && force_kn <= INSENSITIVE * before_kn).into(),
        found: tr!("largest force in Ck45 and in 16MnCrSi5: {list}", list = told.join(", ")),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::tournament::Tournament;

    #[test]
    fn every_reference_finds_its_row_and_conditions_change_only_the_plant_and_what_is_known() {
        let tournament = Tournament::new(entrants(None), 1);
        let rows = rows(tournament.table());
        assert_eq!(rows.len(), 4 * 7);
        assert_eq!(material_claim(&rows), None, "nothing has run yet");
        assert_eq!(rows.iter().filter(|row| row.reference.is_some()).count(), reference().len());
        for (row, entrant) in rows.iter().zip(tournament.entrants()) {
            let s = &entrant.scenario;
            assert_eq!(row.found.name, entrant.name);
            assert_eq!(s.cnc.dead_time_s, s.belief.dead_time_s, "{row:?}");
            let steel = s.plant.material == Material::MnCrSi5;
            assert_eq!(steel, row.condition == "16mncrsi5");
            assert_eq!(s.plant.hardness_hb, if steel { 180.0 } else { 200.0 });
        }
    }

    /// It meets every condition, after the others, whose figures it moves in nothing.
    #[test]
    fn a_script_of_ones_own_takes_part_under_every_condition() {
        use crate::blocks::control::ControllerKind;
        use crate::run::presets;
        let script = presets::load("own-controller").unwrap().controller.script.clone();
        let tournament = Tournament::new(entrants(Some(&script)), 1);
        let with = rows(tournament.table());
        assert_eq!(with.len(), 4 * 8);
        for (row, entrant) in with.iter().zip(tournament.entrants()) {
            let own = row.found.name == "Own script";
            assert_eq!(own, entrant.scenario.controller.kind == ControllerKind::Script, "{row:?}");
            assert!(!own || entrant.scenario.controller.script == script);
        }
        let known = |rows: &[RobustnessRow]| {
            let others = rows.iter().filter(|row| row.found.name != "Own script");
            others.map(|row| (row.condition, row.reference.clone())).collect::<Vec<_>>()
        };
        let without = rows(Tournament::new(entrants(None), 1).table());
        assert_eq!(known(&with), known(&without));
    }
}
