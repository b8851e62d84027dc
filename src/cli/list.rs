//! `steadycut list`: what there is to choose from, and every setting.

mod diagram;
mod uses;

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use super::Outcome;
use super::args::ListArgs;
use crate::base::settings::Choice;
use crate::blocks::control::ControllerKind;
use crate::blocks::cutting::material::Material;
use crate::blocks::cutting::process::ForceModel;
use crate::models::feed_drive::FeedDriveKind;
use crate::models::genetic::{Calibration, ModelSet};
use crate::models::tool::ShippedTool;
use crate::run::end::EndId;
use crate::run::presets::{self, PRESETS, PresetGroup};
use crate::run::scenario::{COMPANIONS, RULES, table};

const CHOICES: &[(&str, &[Choice])] = &[
    ("controllers", ControllerKind::OPTIONS),
    ("model_sets", ModelSet::OPTIONS),
    ("models", Calibration::OPTIONS),
    ("force_models", ForceModel::OPTIONS),
    ("drives", FeedDriveKind::OPTIONS),
    ("materials", Material::OPTIONS),
    ("tools", ShippedTool::OPTIONS),
    ("ends", EndId::OPTIONS),
];

pub fn execute(args: &ListArgs) -> Outcome {
    if args.diagram {
        return diagram::print(args.json);
    }
    if args.uses {
        return uses::print(args.json);
    }
    let mut described = Vec::new();
    for preset in PRESETS {
        described.push((preset, presets::load(preset.name)?.info.description.clone()));
    }
    let mut out = std::io::stdout().lock();
    if args.json {
        let mut object = serde_json::Map::new();
        let list: Vec<_> = described
            .iter()
            .map(|(preset, description)| {
                json!({
                    "name": preset.name,
                    "title": preset.title,
                    "group": preset.group,
                    "description": description,
                })
            })
            .collect();
        object.insert("presets".to_owned(), list.into());
        for (name, options) in CHOICES {
            object.insert((*name).to_owned(), serde_json::to_value(options)?);
        }
        let settings: Result<Vec<_>, _> = table()
            .iter()
            .map(|param| {
                serde_json::to_value(&param.spec).map(|mut value| {
                    value["path"] = param.path.clone().into();
                    value
                })
            })
            .collect();
        object.insert("settings".to_owned(), settings?.into());
        let rules = RULES.iter().map(|rule| json!({"paths": rule.paths, "rule": rule.words}));
        object.insert("rules".to_owned(), rules.collect());
        let companions = COMPANIONS.iter().map(|companion| {
            json!({"of": companion.of, "brings": companion.brings, "rule": companion.words})
        });
        object.insert("companions".to_owned(), companions.collect());
        writeln!(out, "{}", serde_json::to_string_pretty(&object)?)?;
        return Ok(ExitCode::SUCCESS);
    }
    for (i, group) in PresetGroup::ALL.iter().enumerate() {
        writeln!(out, "{}{}", if i == 0 { "" } else { "\n" }, group.label())?;
        for (preset, description) in described.iter().filter(|(preset, _)| preset.group == *group) {
            writeln!(out, "  {:<50}run {}\n      {description}", preset.title, preset.name)?;
        }
    }
    for (name, options) in CHOICES {
        writeln!(out, "\n{name}")?;
        for option in *options {
            writeln!(out, "  {:<18}{}: {}", option.id, option.label, option.doc)?;
            if let Some(tool) = ShippedTool::from_id(option.id) {
                let file = tool.load();
                writeln!(out, "{:20}{}", "", file.source)?;
            }
            if let Some(material) = Material::from_id(option.id) {
                let hardness = material.hardness_hb();
                let factor = material.force_factor(hardness);
                writeln!(out, "{:20}{hardness} HB, force {factor:.2} times Ck45's", "")?;
            }
        }
    }
    writeln!(out, "\nsettings (--set path=value; (*) can change during a run)")?;
    for param in table() {
        let spec = &param.spec;
        let mark = if spec.live { " (*)" } else { "" };
        let default = match &spec.default {
            value if value.to_string().is_empty() => "empty".to_owned(),
            value => value.to_string(),
        };
        let allowed = spec.allowed.allowed(spec.unit);
        writeln!(
            out,
            "  {}{mark}\n      default {default}; {allowed}\n      {}",
            param.path, spec.doc
        )?;
    }
    writeln!(out, "\nrules between settings (the first one named is what is refused)")?;
    for rule in RULES {
        writeln!(out, "  {}\n      {}", rule.paths.join(", "), rule.words)?;
    }
    writeln!(out, "\ncompanions: chosen alone, a setting brings another one with it")?;
    for companion in COMPANIONS {
        let words = companion.words;
        writeln!(out, "  {} brings {}\n      {words}", companion.of, companion.brings)?;
    }
    Ok(ExitCode::SUCCESS)
}
