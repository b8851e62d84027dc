//! The settings of machine, wear and sound.

use egui::{CollapsingHeader, RichText, Ui};

use crate::app::command::Command;
use crate::app::panels::View;
use crate::app::theme::Palette;
use crate::app::widgets::my_files::my_files;
use crate::app::widgets::setting::{Size, setting};
use crate::base::language::{text, tr};
use crate::run::scenario::table;
use crate::study::library::LibraryKind;
use crate::study::uses::Screen;

/// Settings that are always in sight.
const FIRST: [&str; 6] = [
    "machine.variant",
    "machine.parameters",
    "machine.spindle_quality",
    "life.contact_force_n",
    "life.tool_life_min",
    "wear.tool_life_factor",
];
/// Groups below a fold, with their titles.
const FOLDS: [(&str, &str); 3] = [
    ("machine", text!("Machine and chip")),
    ("wear", text!("Wear")),
    ("life", text!("Sound, noise and prediction")),
];

/// All of them.
pub fn show(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let scenario = view.session.current();
    for path in FIRST {
        setting(ui, Screen::Machine, path, scenario, Size::Large, commands);
    }
    ui.add_space(4.0);
    for (group, title) in FOLDS {
        CollapsingHeader::new(tr(title)).id_salt(("machine", group)).show(ui, |ui| {
            let all = table().iter().filter(|param| param.group == group);
            for param in all.filter(|param| !FIRST.contains(&param.path.as_str())) {
                setting(ui, Screen::Machine, &param.path, scenario, Size::Small, commands);
            }
        });
    }
    my_files(ui, view, Some(LibraryKind::Structure), commands);
    ui.add_space(4.0);
    let note = tr("The programmed feed, speed and depth of cut are those of the Console.");
    ui.label(RichText::new(note).small().color(Palette::at(ui).weak));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_setting_in_sight_is_one_of_the_folded_groups() {
        for path in FIRST {
            let param = table().iter().find(|param| param.path == path);
            let group = param.map(|param| param.group);
            assert!(FOLDS.iter().any(|(fold, _)| Some(*fold) == group), "{path}");
        }
        for param in table() {
            let folded = FOLDS.iter().any(|(fold, _)| *fold == param.group);
            assert_eq!(folded, Screen::Machine.offers(param), "{}", param.path);
        }
    }
}
