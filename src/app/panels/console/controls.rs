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
use crate::run::presets::{self, PresetGroup};
use crate::run::scenario::table;
use crate::study::uses::Screen;

/// Largest height of the list of scenarios, points.
const PRESETS_HEIGHT: f32 = 420.0;
/// Settings that stand above the fold.
const FIRST: [&str; 5] =
    ["plant.material", "plant.hardness_hb", "noise.level", "plant.wear_factor", "controller.kind"];
/// Shown with the first ones, by a widget of its own.
const TARGET: &str = "target.ra_um";

/// Groups below the fold, with their titles, around those of the controllers: what is asked for most first.
const BEFORE: &[(&str, &str)] = &[("target", "Target")];
const AFTER: &[(&str, &str)] = &[
    ("workpiece", "Workpiece"),
    ("program", "NC program"),
    ("cnc", "CNC and dead time"),
    ("belief", "What the controller believes"),
    ("noise", "Noise"),
    ("plant", "Plant"),
    ("formula", "Own formulas of the models"),
    ("tool", "Cutter"),
    ("wear", "Wear over the tool's life"),
    ("feed_drive", "Feed drive"),
    ("spindle_drive", "Spindle drive"),
    ("machine", "Machine"),
    ("life", "Sound and tool life"),
    ("profile", "Roughness profile"),
    ("plan", "Off-line plan"),
    ("run", "Run"),
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
    target_of(ui, Screen::Console, scenario, commands);
    for path in FIRST {
        setting(ui, Screen::Console, path, scenario, Size::Large, commands);
    }
}

/// The slider of the target alone, for narrow windows.
pub fn target(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    target_of(ui, Screen::Console, view.session.current(), commands);
}

/// The first controls but the target, for narrow windows.
pub fn first_but_target(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    for path in FIRST {
        setting(ui, Screen::Console, path, view.session.current(), Size::Large, commands);
    }
}

/// Whether a group says something about the chosen controller.
fn concerns(group: &str, kind: ControllerKind) -> bool {
    group.strip_prefix("controller.").is_none_or(|id| id == kind.id())
}

/// The windows on part and revolution, and all other settings by group.
pub fn more(ui: &mut Ui, view: &View<'_>, windows: &mut Windows, commands: &mut Vec<Command>) {
    ui.horizontal_wrapped(|ui| {
        let help = "The part from the side: drag its depths and its ends, or type them in a table";
        if ui.button("Edit depths\u{2026}").on_hover_text(help).clicked() {
            windows.workpiece.toggle(view);
        }
        let help = "The forces on the tool at 28.8 kHz over the last turns before the playhead";
        if ui.button("Within a revolution\u{2026}").on_hover_text(help).clicked() {
            windows.revolution.open = !windows.revolution.open;
        }
    });
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
                for param in rest {
                    setting(ui, Screen::Console, &param.path, scenario, Size::Small, commands);
                }
            });
        }
    });
}

/// The choice of a shipped scenario, and what the present one is about.
pub fn scenarios(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let info = &view.session.scenario().info;
    let width = ui.available_width();
    let shown = presets::title(&info.name).unwrap_or(&info.name);
    let response = ComboBox::from_id_salt("preset")
        .width(width)
        .truncate()
        .selected_text(format!("Scenario: {shown}"))
        .height(PRESETS_HEIGHT)
        .show_ui(ui, |ui| {
            for group in PresetGroup::ALL {
                ui.label(RichText::new(group.label()).small().color(Palette::at(ui).weak));
                for preset in presets::of_group(*group) {
                    let help = format!("{}: steadycut run {0}", preset.name);
                    let choice = ui.selectable_label(preset.name == info.name, preset.title);
                    if choice.on_hover_text(help).clicked() {
                        let load = SessionCommand::LoadPreset(preset.name.to_owned());
                        commands.push(Command::Session(load));
                    }
                }
            }
        })
        .response;
    response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, "Scenario"));
    response.on_hover_text("The shipped scenarios");
    if !info.description.is_empty() {
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
}
