//! The controls of the cut: the few that matter first, all others below a fold, straight from the
//! table of settings.

use egui::{CollapsingHeader, ComboBox, RichText, Role, Ui, WidgetInfo};

use super::Windows;
use crate::app::command::{Command, SessionCommand};
use crate::app::panels::View;
use crate::app::theme::Palette;
use crate::app::widgets::setting::{Size, setting};
use crate::app::widgets::target::target as target_of;
use crate::blocks::control::ControllerKind;
use crate::run::presets::PRESETS;
use crate::run::scenario::table;
use crate::study::published::PaperId;

/// Largest height of the list of scenarios, points.
const PRESETS_HEIGHT: f32 = 420.0;
/// Settings that stand above the fold.
const FIRST: [&str; 5] =
    ["plant.material", "plant.hardness_hb", "noise.level", "plant.wear_factor", "controller.kind"];
/// Shown with the first ones, by a widget of its own.
const TARGET: &str = "target.ra_um";

/// Groups below the fold, with their titles, around those of the controllers.
const BEFORE: &[(&str, &str)] = &[("target", "Target")];
const AFTER: &[(&str, &str)] = &[
    ("belief", "What the controller believes"),
    ("plant", "Plant"),
    ("noise", "Noise"),
    ("feed_drive", "Feed drive"),
    ("spindle_drive", "Spindle drive"),
    ("cnc", "CNC"),
    ("program", "NC program"),
    ("tool", "Cutter"),
    ("workpiece", "Workpiece"),
    ("machine", "Machine"),
    ("run", "Run"),
    ("plan", "Off-line plan"),
    ("wear", "Wear over the tool's life"),
    ("life", "Sound and tool life"),
    ("profile", "Roughness profile"),
    ("", "Name"),
];

/// The groups below the fold, with their titles, in order.
fn groups() -> impl Iterator<Item = (&'static str, &'static str)> {
    let controllers = ControllerKind::ALL.iter().map(|kind| (kind.group(), kind.label()));
    BEFORE.iter().copied().chain(controllers).chain(AFTER.iter().copied())
}

/// The first controls: target Ra, material and hardness, noise, wear, controller.
pub fn first(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let scenario = view.session.current();
    target_of(ui, scenario, commands);
    for path in FIRST {
        setting(ui, path, scenario, Size::Large, commands);
    }
}

/// The slider of the target alone, for narrow windows.
pub fn target(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    target_of(ui, view.session.current(), commands);
}

/// The first controls but the target, for narrow windows.
pub fn first_but_target(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    for path in FIRST {
        setting(ui, path, view.session.current(), Size::Large, commands);
    }
}

/// Whether a group says something about the chosen controller.
fn concerns(group: &str, kind: ControllerKind) -> bool {
    group.strip_prefix("controller.").is_none_or(|id| id == kind.id())
}

/// The window into a revolution, and all other settings by group.
pub fn more(ui: &mut Ui, view: &View<'_>, windows: &mut Windows, commands: &mut Vec<Command>) {
    let help = "The forces on the tool at 28.8 kHz over the last turns before the playhead";
    let button = ui.button("Within a revolution\u{2026}").on_hover_text(help);
    if button.clicked() {
        windows.revolution.open = !windows.revolution.open;
    }
    ui.add_space(6.0);
    CollapsingHeader::new("More settings").id_salt("more").show_unindented(ui, |ui| {
        let scenario = view.session.current();
        for (group, title) in groups() {
            if !concerns(group, scenario.controller.kind) {
                continue;
            }
            CollapsingHeader::new(title).id_salt(("group", group)).show(ui, |ui| {
                let rest = table().iter().filter(|param| {
                    param.group == group
                        && param.path != TARGET
                        && !FIRST.contains(&param.path.as_str())
                });
                if group == "workpiece" && ui.button("Edit cuts\u{2026}").clicked() {
                    windows.workpiece.toggle(view);
                }
                for param in rest {
                    setting(ui, &param.path, scenario, Size::Small, commands);
                }
            });
        }
    });
}

/// The shipped scenarios by group: first those of no paper's table, then the tables'.
fn preset_groups() -> Vec<(&'static str, Vec<&'static str>)> {
    let of_paper: Vec<(&str, Vec<String>)> = PaperId::ALL
        .iter()
        .map(|paper| {
            (paper.label(), paper.rows().iter().map(|row| paper.preset(row.sim)).collect())
        })
        .collect();
    let group = |wanted: &dyn Fn(&str) -> bool| {
        PRESETS.iter().map(|preset| preset.name).filter(|name| wanted(name)).collect()
    };
    let has = |names: &[String], name: &str| names.iter().any(|other| other == name);
    let mut groups =
        vec![("Scenarios", group(&|name| !of_paper.iter().any(|(_, names)| has(names, name))))];
    groups.extend(of_paper.iter().map(|(title, names)| (*title, group(&|name| has(names, name)))));
    groups
}

/// The choice of a shipped scenario, and what the present one is about.
pub fn presets(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let info = &view.session.scenario().info;
    let width = ui.available_width();
    let response = ComboBox::from_id_salt("preset")
        .width(width)
        .truncate()
        .selected_text(format!("Scenario: {}", info.name))
        .height(PRESETS_HEIGHT)
        .show_ui(ui, |ui| {
            for (title, names) in preset_groups() {
                ui.label(RichText::new(title).small().color(Palette::at(ui).weak));
                for name in names {
                    if ui.selectable_label(name == info.name, name).clicked() {
                        commands
                            .push(Command::Session(SessionCommand::LoadPreset(name.to_owned())));
                    }
                }
            }
        })
        .response;
    response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, "Scenario"));
    response.on_hover_text("The shipped scenarios");
    if !info.description.is_empty() && !view.narrow {
        ui.label(RichText::new(&info.description).small().color(Palette::at(ui).weak));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_setting_has_its_place() {
        for param in table() {
            let placed = param.path == TARGET
                || FIRST.contains(&param.path.as_str())
                || groups().any(|(group, _)| group == param.group);
            assert!(placed, "no group of controls shows `{}`", param.path);
        }
    }

    #[test]
    fn every_preset_stands_in_one_group_and_no_group_is_empty() {
        let groups = preset_groups();
        assert_eq!(groups.len(), 1 + PaperId::ALL.len());
        assert!(groups.iter().all(|(title, names)| !names.is_empty() && !title.is_empty()));
        let mut names: Vec<&str> = groups.into_iter().flat_map(|(_, names)| names).collect();
        let mut all: Vec<&str> = PRESETS.iter().map(|preset| preset.name).collect();
        names.sort_unstable();
        all.sort_unstable();
        assert_eq!(names, all);
    }
}
