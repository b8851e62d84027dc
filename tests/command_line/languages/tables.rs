//! Texts that stand in tables of the program, and in its missions.

use steadycut::base::network::Activation;
use steadycut::base::settings::{Choice, Editor, Kind};
use steadycut::models::disturbances::Disturbance;
use steadycut::models::tip_modes::TipAxis;
use steadycut::run::end::EndId;
use steadycut::run::glossary::GLOSSARY;
use steadycut::run::presets::{self, PRESETS, PresetGroup};
use steadycut::run::scenario::table;
use steadycut::run::signals::SIGNALS;
use steadycut::study::compare::outcome::Measure;
use steadycut::study::experiment::way::WayPlant;
use steadycut::study::experiment::way::rows::ModelSource;
use steadycut::study::formula_place::FormulaPlace;
use steadycut::study::identify::drive::DriveStructure;
use steadycut::study::library::LibraryKind;
use steadycut::study::mission::{Relation, Taken, shipped};
use steadycut::study::own_file::OwnFileKind;
use steadycut::study::papers::CellVerdict;
use steadycut::study::papers_2019::MachineTableVerdict;
use steadycut::study::plan::optimum::PlanVerdict;
use steadycut::study::published::PaperId;
use steadycut::study::recommend::EngagementCode;
use steadycut::study::verdict::Verdict;

type Found = Vec<(&'static str, String, String)>;

/// File, where it stands, and the text.
pub fn texts() -> Found {
    let mut found = Found::new();
    let mut add =
        |place: &str, text: &str| found.push(("tables", place.to_owned(), text.to_owned()));
    for param in table() {
        add("settings", param.spec.label);
        add("settings", param.spec.doc);
        if let Kind::Choice { options } = &param.spec.allowed {
            for option in *options {
                add("settings", option.label);
                add("settings", option.doc);
            }
        }
        if let Kind::Structured(shape) = &param.spec.allowed {
            match shape.editor() {
                Editor::Rows(rows) => {
                    add("settings", rows.row);
                    for column in &rows.columns {
                        add("settings", column.name);
                        add("settings", column.suffix);
                    }
                }
                Editor::Numbers(numbers) => add("settings", numbers.each),
                Editor::Count(what) => add("settings", what),
                Editor::Formula(shape) => add("settings", shape.meaning),
                Editor::Presence | Editor::Script => {}
            }
        }
    }
    // Choices that are no settings.
    let choices: [(&str, &[Choice]); 5] = [
        ("ends", EndId::OPTIONS),
        ("disturbances", Disturbance::OPTIONS),
        ("activations", Activation::OPTIONS),
        ("files of one's own", OwnFileKind::OPTIONS),
        ("folder of one's own", LibraryKind::OPTIONS),
    ];
    for (place, options) in choices {
        options.iter().for_each(|option| add(place, option.label));
    }
    for kind in Disturbance::ALL {
        add("disturbances", kind.in_text());
    }
    for signal in SIGNALS {
        add("signals", signal.label);
        add("signals", signal.doc);
    }
    for term in GLOSSARY {
        add("glossary", term.meaning);
        if let Some(key) = term.key() {
            add("glossary", &key);
        }
    }
    for option in Disturbance::OPTIONS {
        add("disturbances", option.doc);
    }
    for group in PresetGroup::ALL {
        add("scenarios", group.label());
    }
    for preset in PRESETS {
        add("scenarios", preset.title);
        let scenario = presets::load(preset.name).unwrap();
        add("scenarios", &scenario.info.description);
    }
    for label in study_choices() {
        found.push(("study", "choices of the studies".to_owned(), label.to_owned()));
    }
    found.extend(missions());
    found
}

/// Labels of choices of the studies that screens show.
fn study_choices() -> Vec<&'static str> {
    let all: [&[Choice]; 14] = [
        CellVerdict::OPTIONS,
        DriveStructure::OPTIONS,
        EngagementCode::OPTIONS,
        FormulaPlace::OPTIONS,
        MachineTableVerdict::OPTIONS,
        Measure::OPTIONS,
        ModelSource::OPTIONS,
        PaperId::OPTIONS,
        PlanVerdict::OPTIONS,
        Relation::OPTIONS,
        Taken::OPTIONS,
        TipAxis::OPTIONS,
        Verdict::OPTIONS,
        WayPlant::OPTIONS,
    ];
    let worded = |label: &&str| label.chars().filter(|sign| sign.is_alphabetic()).count() > 2;
    all.into_iter().flatten().map(|choice| choice.label).filter(worded).collect()
}

/// Entries of a mission that people read.
const READ: [&str; 12] = [
    "title",
    "about",
    "story",
    "goal",
    "hints",
    "text",
    "ask",
    "otherwise",
    "source",
    "formula",
    "label",
    "word",
];

fn missions() -> Found {
    fn walk(value: &toml::Value, read: bool, place: &str, found: &mut Found) {
        match value {
            toml::Value::String(text) if read => {
                found.push(("missions", place.to_owned(), text.clone()))
            }
            toml::Value::Array(values) => {
                values.iter().for_each(|value| walk(value, read, place, found))
            }
            toml::Value::Table(table) => {
                for (key, value) in table {
                    walk(value, READ.contains(&key.as_str()), place, found);
                }
            }
            _ => {}
        }
    }
    let mut found = Found::new();
    for mission in shipped::MISSIONS {
        let (id, value) = (mission.id, toml::from_str::<toml::Value>(mission.text).unwrap());
        walk(&value, false, &format!("assets/missions/{id}.toml"), &mut found);
    }
    found
}
