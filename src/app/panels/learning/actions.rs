//! What can be done with the networks: how the cut begins, learning rates, files.

use egui::{RichText, Ui};

use crate::app::command::{Command, FileCommand, PlaybackCommand, SessionCommand};
use crate::app::panels::View;
use crate::app::theme::Palette;
use crate::app::widgets::setting::{Size, setting};
use crate::base::language::tr;
use crate::models::unks::UnksStart;
use crate::study::unks_passes::{beginning_anew, beginning_with, learned};
use crate::study::uses::Screen;

/// The controls.
pub fn show(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let palette = Palette::at(ui);
    let settings = &view.session.scenario().controller.unks;
    let stored = settings.networks.get();
    ui.label(RichText::new(tr("The cut begins with networks")).strong());
    ui.horizontal_wrapped(|ui| {
        for (start, option) in UnksStart::ALL.iter().zip(UnksStart::OPTIONS) {
            let chosen = stored.is_none() && settings.start == *start;
            let button = ui.selectable_label(chosen, tr(option.label));
            if button.on_hover_text(tr(option.doc).replace('\n', " ")).clicked() {
                commands.push(Command::Session(SessionCommand::SetUp(beginning_anew(*start))));
            }
        }
        if stored.is_some() {
            let _ = ui.selectable_label(true, tr("learned before"));
        }
    });
    if let Some(stored) = stored {
        let note = &stored.origins[2].note;
        let text = format!("{note}; {}", tr(settings.start.label()));
        ui.label(RichText::new(text).small().color(palette.weak));
    }
    let first: &[&str] = match settings.start {
        UnksStart::Shipped => &["forward_rate", "inverse_rate"],
        UnksStart::Cold => &["cold_rate", "first_weights"],
    };
    for name in first {
        let path = format!("controller.unks.{name}");
        setting(ui, Screen::Learning, &path, view.session.current(), Size::Small, commands);
    }
    ui.add_space(4.0);
    ui.horizontal_wrapped(|ui| {
        let over = view.session.chosen().is_over();
        let help = tr("Begin the same cut with what has been learned at its end");
        let again = egui::Button::new(tr("Cut again with what was learned"));
        let again = ui.add_enabled(over, again);
        if again.on_hover_text(help).clicked()
            && let Some(stored) = learned(view.session.chosen().run(), 1)
        {
            commands.push(Command::Session(SessionCommand::SetUp(beginning_with(&stored))));
            commands.push(Command::Playback(PlaybackCommand::Restart));
        }
        let help = tr("Save NM-R, NM-1 and NM-2 as they are at the end of the cut");
        let save = ui.add_enabled(over, egui::Button::new(tr("Save networks")));
        if save.on_hover_text(help).clicked() {
            commands.push(Command::File(FileCommand::SaveNetworks));
        }
        let help = tr("Begin with the networks of a file; one can also be dropped here");
        if ui.button(tr("Load networks")).on_hover_text(help).clicked() {
            commands.push(Command::File(FileCommand::OpenNetworks));
        }
    });
}
