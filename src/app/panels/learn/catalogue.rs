//! The list of missions, in the order in which they teach.

use egui::{RichText, Role, Ui, WidgetInfo};

use super::told;
use crate::app::command::{Command, FileCommand, ShellCommand};
use crate::app::format;
use crate::app::panels::View;
use crate::app::remembered::Remembered;
use crate::app::theme::{self, Palette};
use crate::app::widgets::standing::Standing;
use crate::base::language::tr;
use crate::study::mission::shipped::{self, MISSIONS};
use crate::study::mission::{MOST_STARS, Mission};
use crate::study::opening::FramePart;

/// Shows the missions; gives the one that is to begin.
pub fn show(
    ui: &mut Ui,
    view: &View<'_>,
    refused: Option<&str>,
    commands: &mut Vec<Command>,
) -> Option<Mission> {
    let palette = Palette::at(ui);
    ui.heading(tr("Missions"));
    ui.label(tr(
        "Each takes some minutes: say what will happen, cut, and see whether you were right. What you do is checked \
         by the program that cuts.",
    ));
    if let Some(because) = refused {
        Standing::Bad.label(ui, because, |text| text);
    }
    ui.add_space(6.0);
    let mut chosen = None;
    for (number, entry) in (1..).zip(MISSIONS) {
        let Ok(mission) = shipped::load(entry.id) else { continue };
        let title = tr(&mission.title).to_owned();
        theme::card(palette).show(ui, |ui| {
            ui.set_width(ui.available_width());
            ui.label(RichText::new(format!("{number}. {title}")).strong());
            // A line of their own, low since nothing in it is pressed: stars are not parted.
            ui.scope(|ui| {
                ui.spacing_mut().interact_size.y = 0.0;
                ui.horizontal(|ui| time_and_stars(ui, view, &mission));
            });
            ui.label(RichText::new(told(&mission.about)).color(palette.weak));
            ui.horizontal(|ui| {
                let begin = ui.button(tr("Begin"));
                begin.widget_info(|| {
                    WidgetInfo::labeled(
                        Role::Button,
                        true,
                        tr!("Begin: {mission}", mission = title),
                    )
                });
                link_button(ui, view, &mission, commands);
                if begin.clicked() {
                    chosen = Some(mission);
                }
            });
        });
        ui.add_space(4.0);
    }
    ui.label(
        RichText::new(tr(
            "A mission of your own is a text file: steadycut mission new writes one to begin with. Drop it here.",
        ))
        .color(palette.weak),
    );
    stars(ui, view.remembered, commands);
    chosen
}

/// How long a mission takes, and the stars that were won in it.
fn time_and_stars(ui: &mut Ui, view: &View<'_>, mission: &Mission) {
    let minutes = format::beside(mission.minutes.to_string(), "min");
    ui.label(RichText::new(minutes).small().color(Palette::at(ui).weak));
    match view.remembered.stars(&mission.id) {
        Some(0) => {
            Standing::Watch.label(ui, tr("not passed yet"), RichText::small);
        }
        Some(won) => {
            let won = tr!("{won} of {most} stars", won = won, most = MOST_STARS);
            Standing::Best.label(ui, &won, RichText::small);
        }
        None => {}
    }
}

/// A link that opens a mission, with its code.
pub fn link_button(ui: &mut Ui, view: &View<'_>, mission: &Mission, commands: &mut Vec<Command>) {
    if view.frame.hides(FramePart::Files) {
        return;
    }
    let link = ui.button(tr("Link")).on_hover_text(tr("A link to this mission, with its QR code"));
    link.widget_info(|| {
        let name = tr!("Link: {mission}", mission = tr(&mission.title));
        WidgetInfo::labeled(Role::Button, true, name)
    });
    if link.clicked() {
        commands.push(Command::File(FileCommand::CopyLinkTo(mission.link())));
    }
}

/// Where the stars are kept, and how they are forgotten: asked twice, for they do not come back.
fn stars(ui: &mut Ui, remembered: &Remembered, commands: &mut Vec<Command>) {
    if !remembered.has_stars() {
        return;
    }
    ui.add_space(6.0);
    if remembered.forgets() {
        Standing::Watch.label(
            ui,
            tr("Stars are kept until the program ends: the place for more is refused here."),
            |text| text,
        );
    }
    let id = egui::Id::unique("forget all stars");
    let asked = ui.data(|data| data.get_temp::<bool>(id)).unwrap_or(false);
    ui.horizontal_wrapped(|ui| {
        if !asked {
            if ui.button(tr("Forget my stars\u{2026}")).clicked() {
                ui.data_mut(|data| data.insert_temp(id, true));
            }
            return;
        }
        ui.label(tr("All stars, of every mission?"));
        let forget = ui.button(tr("Forget them")).clicked();
        if forget {
            commands.push(Command::Shell(ShellCommand::ForgetStars));
        }
        if ui.button(tr("Keep them")).clicked() || forget {
            ui.data_mut(|data| data.insert_temp(id, false));
        }
    });
}
