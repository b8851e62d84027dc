//! The controls of the cut: the few that matter first, all others below a fold, straight from the
//! table of settings.

use egui::{CollapsingHeader, ComboBox, RichText, Role, Ui, WidgetInfo};

use super::Windows;
use super::afc;
use super::operator;
use super::workpiece::EDIT_HELP;
use crate::app::command::{Command, HandCommand, SessionCommand, ShellCommand};
use crate::app::panels::View;
use crate::app::panels::machine::STABILITY;
use crate::app::session::NO_OTHER_SCENARIO;
use crate::app::theme::Palette;
use crate::app::widgets::beside::help_beside;
use crate::app::widgets::my_files::my_files;
use crate::app::widgets::setting::{Size, setting};
use crate::app::widgets::target::target as target_of;
use crate::base::language::{text, tr};
use crate::blocks::control::ControllerKind;
use crate::run::presets::{self, PresetGroup};
use crate::run::scenario::table;
use crate::study::library::LibraryKind;
use crate::study::uses::Screen;

/// Largest height of the list of scenarios, points.
const PRESETS_HEIGHT: f32 = 420.0;
/// Settings that stand above the fold.
const FIRST: [&str; 5] =
    ["plant.material", "plant.hardness_hb", "noise.level", "plant.wear_factor", "controller.kind"];
/// Shown with the first ones, by a widget of its own.
const TARGET: &str = "target.ra_um";

/// Groups below the fold, with their titles, around those of the controllers: what is asked for most first.
const BEFORE: &[(&str, &str)] = &[("target", text!("Target"))];
const AFTER: &[(&str, &str)] = &[
    ("workpiece", text!("Workpiece")),
    ("disturbances", text!("Disturbances")),
    ("economics", text!("What a cut costs")),
    ("program", text!("NC program")),
    ("twin", text!("What constant feed to compare with")),
    ("cnc", text!("CNC and dead time")),
    ("belief", text!("What the controller believes")),
    ("noise", text!("Noise")),
    ("plant", text!("Plant")),
    ("formula", text!("Own formulas of the models")),
    ("tool", text!("Cutter")),
    ("wear", text!("Wear over the tool's life")),
    ("feed_drive", text!("Feed drive")),
    ("spindle_drive", text!("Spindle drive")),
    ("machine", text!("Machine")),
    ("life", text!("Sound and tool life")),
    ("profile", text!("Roughness profile")),
    ("plan", text!("Off-line plan")),
    ("run", text!("Run")),
    ("", text!("Name")),
];

/// The groups below the fold, with their titles, in order.
fn groups() -> impl Iterator<Item = (&'static str, &'static str)> {
    let controllers = ControllerKind::ALL.iter().map(|kind| (kind.group(), kind.label()));
    BEFORE.iter().copied().chain(controllers).chain(AFTER.iter().copied())
}

/// The title of a group of settings.
pub fn group_title(group: &str) -> Option<&'static str> {
    groups().find_map(|(path, title)| (path == group).then_some(title))
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
        if ui.button(tr("Edit depths\u{2026}")).on_hover_text(tr(EDIT_HELP)).clicked() {
            windows.workpiece.toggle(view);
        }
        let help = tr(
            "The depth from which on this machine chatters, over the speed: on the screen Machine",
        );
        if ui.button(tr("Limit depth\u{2026}")).on_hover_text(help).clicked() {
            commands.push(Command::Shell(ShellCommand::ShowPart("machine", STABILITY)));
        }
        let help = tr("The forces on the tool at 28.8 kHz over the last turns before the playhead");
        if ui.button(tr("Within a revolution\u{2026}")).on_hover_text(help).clicked() {
            windows.revolution.open = !windows.revolution.open;
        }
        if ui.button(tr("Operator\u{2026}")).on_hover_text(tr(operator::HELP)).clicked() {
            commands.push(Command::hand(HandCommand::Toggle));
        }
        let chosen = view.session.current().controller.kind == ControllerKind::Afc;
        if chosen && ui.button("AFC\u{2026}").on_hover_text(tr(afc::HELP)).clicked() {
            windows.afc.open = !windows.afc.open;
        }
    });
    ui.add_space(6.0);
    CollapsingHeader::new(tr("More settings")).id_salt("more").show_unindented(ui, |ui| {
        let help = tr("A measured file over the plots: text, MATLAB, HDF5, TDMS or Parquet. It can also be dropped here.");
        ui.horizontal_wrapped(|ui| {
            if ui.button(tr("Measured data\u{2026}")).on_hover_text(help).clicked() {
                windows.measured.open = !windows.measured.open;
            }
            my_files(ui, view, None, commands);
        });
        let scenario = view.session.current();
        for (group, title) in groups() {
            if !concerns(group, scenario.controller.kind) {
                continue;
            }
            CollapsingHeader::new(tr(title)).id_salt(("group", group)).show(ui, |ui| {
                let rest = table().iter().filter(|param| {
                    param.group == group
                        && param.path != TARGET
                        && !FIRST.contains(&param.path.as_str())
                });
                for param in rest {
                    setting(ui, Screen::Console, &param.path, scenario, Size::Small, commands);
                }
                if let Some(kind) = kind_of(group) {
                    my_files(ui, view, Some(kind), commands);
                }
            });
        }
    });
}

/// The kind of one's own files that brings the settings of a group.
fn kind_of(group: &str) -> Option<LibraryKind> {
    match group {
        "tool" => Some(LibraryKind::Tool),
        "plant" | "formula" => Some(LibraryKind::Material),
        "cnc" | "feed_drive" | "spindle_drive" => Some(LibraryKind::Machine),
        "machine" => Some(LibraryKind::Structure),
        "workpiece" => Some(LibraryKind::Part),
        "controller.script" => Some(LibraryKind::Script),
        _ => None,
    }
}

/// The choice of a shipped scenario, and what the present one is about.
pub fn scenarios(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let info = &view.session.scenario().info;
    let width = ui.available_width();
    let title = presets::title(&info.name).map_or(info.name.as_str(), tr);
    // What is not the shipped scenario any more does not go by its name alone.
    let edited = !view.session.edits().list().is_empty();
    let changed = edited || presets::is_changed(view.session.scenario());
    let shown = match changed {
        true => tr!("{scenario}, changed", scenario = title),
        false => title.to_owned(),
    };
    let locked = view.session.has_locks();
    let list = ComboBox::from_id_salt("preset")
        .width(width)
        .truncate()
        .selected_text(tr!("Scenario: {scenario}", scenario = shown))
        .height(PRESETS_HEIGHT);
    let show = |ui: &mut Ui| {
        let shown = list.show_ui(ui, |ui| {
            for (number, group) in PresetGroup::ALL.iter().enumerate() {
                if number > 0 {
                    ui.separator();
                }
                ui.strong(tr(group.label()));
                for preset in presets::of_group(*group) {
                    let help = format!("{}: steadycut run {0}", preset.name);
                    let choice = ui.selectable_label(preset.name == info.name, tr(preset.title));
                    help_beside(&choice, &help);
                    if choice.clicked() {
                        let load = SessionCommand::LoadPreset(preset.name.to_owned());
                        commands.push(Command::Session(load));
                        ui.close();
                    }
                }
            }
        });
        shown.response
    };
    let response = ui.add_enabled_ui(!locked, show).inner;
    response.widget_info(|| WidgetInfo {
        current_text_value: Some(shown.clone()),
        ..WidgetInfo::labeled(Role::ComboBox, !locked, tr("Scenario"))
    });
    let help = tr("The shipped scenarios");
    response.on_hover_text(help).on_disabled_hover_text(tr(NO_OTHER_SCENARIO));
    if let Some(lock) = view.session.mission() {
        // The scenario's text is of the settings that it is shipped with, another controller among them.
        let told = tr!(
            "The cut of the mission \u{201c}{title}\u{201d}; its task is on the screen Learn.",
            title = tr(&lock.title)
        );
        ui.label(RichText::new(told).small().color(Palette::at(ui).weak));
    } else if !info.description.is_empty() {
        // What was changed since may be other than its text says.
        let told = match (presets::title(&info.name).is_some(), changed) {
            (_, false) => tr(&info.description).to_owned(),
            (true, true) => tr!("As shipped: {about}", about = tr(&info.description)),
            (false, true) => {
                tr!("Without the changes made in the cut: {about}", about = tr(&info.description))
            }
        };
        ui.label(RichText::new(told).small().color(Palette::at(ui).weak));
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
