//! What was found, before anything of it is taken: values, comparison, what is left, notes; then use and save.

use egui::{Button, CollapsingHeader, Label, RichText, Ui};

use super::form::FitForm;
use super::plots;
use crate::app::command::{Command, FileCommand, SessionCommand, ShellCommand};
use crate::app::files::file_name;
use crate::app::format;
use crate::app::theme::{self, Palette};
use crate::app::widgets::scaffold;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::tr;
use crate::study::identify::fits::{FitOutcome, FitTable};

/// Longest value of a setting that is shown whole, characters.
const VALUE: usize = 60;

/// All of it; `stands` where the scenario has it already.
pub fn show(
    ui: &mut Ui,
    form: &FitForm,
    outcome: &FitOutcome,
    stands: bool,
    commands: &mut Vec<Command>,
) {
    let palette = Palette::at(ui);
    ui.add_space(4.0);
    theme::card(palette).show(ui, |ui| {
        ui.set_width(ui.available_width());
        let file = form.file.as_ref().map_or("", |file| file.name.as_str());
        let title = format!("{}, {file}", tr(form.kind.about().title));
        ui.label(RichText::new(title).strong());
        ui.label(format::typeset(&outcome.summary));
        values(ui, outcome);
        if let Some(of) = &outcome.table {
            ui.add_space(4.0);
            table(ui, of);
        }
        for note in &outcome.notes {
            Standing::Watch.label(ui, &format::sentence(&format::typeset(note)), |text| text);
        }
        ui.add_space(4.0);
        take(ui, form, outcome, stands, commands);
    });
    for plot in &outcome.plots {
        ui.add_space(6.0);
        plots::show(ui, plot);
    }
}

/// Values with intervals, and what is left.
fn values(ui: &mut Ui, outcome: &FitOutcome) {
    scaffold::across(ui, "fitted values", |ui| {
        touch::grid(ui, "fitted values").num_columns(2).striped(true).show(ui, |ui| {
            for estimate in &outcome.estimates {
                ui.label(&estimate.name);
                let value = format::beside(estimate.told(), &format::unit(estimate.unit));
                ui.label(RichText::new(value).strong());
                ui.end_row();
            }
            for (name, value) in &outcome.left {
                ui.label(name);
                ui.label(format::typeset(value));
                ui.end_row();
            }
        });
    });
    let weak = Palette::at(ui).weak;
    let text = tr("± is half a 95 % interval, from what is left, if the model is the true one.");
    ui.add(Label::new(RichText::new(text).small().color(weak)).wrap());
}

/// The table beside them.
fn table(ui: &mut Ui, of: &FitTable) {
    ui.label(RichText::new(&of.title).strong());
    let weak = Palette::at(ui).weak;
    scaffold::across(ui, "fitted table", |ui| {
        ui.style_mut().wrap_mode = Some(egui::TextWrapMode::Extend);
        touch::grid(ui, "fitted table").striped(true).show(ui, |ui| {
            for head in &of.heads {
                ui.label(RichText::new(format::typeset(head)).small().color(weak));
            }
            ui.end_row();
            for (place, row) in of.rows.iter().enumerate() {
                let taken = of.taken == Some(place);
                for (column, cell) in row.iter().enumerate() {
                    let cell = format::typeset(cell);
                    match (taken, column) {
                        (true, 0) => {
                            Standing::Best.label(ui, &cell, |text| text.strong());
                        }
                        (true, _) => {
                            ui.label(RichText::new(cell).strong());
                        }
                        (false, _) => {
                            ui.label(cell);
                        }
                    }
                }
                ui.end_row();
            }
        });
    });
}

/// The settings that it makes, and the buttons that take and save them.
fn take(
    ui: &mut Ui,
    form: &FitForm,
    outcome: &FitOutcome,
    stands: bool,
    commands: &mut Vec<Command>,
) {
    ui.horizontal_wrapped(|ui| {
        if let Ok(settings) = &outcome.settings {
            let button = Button::new(tr("Use in this scenario")).min_size(touch::least(ui));
            let help = tr("Sets these settings, in one step of undo; the cut plays from its start");
            if ui.add_enabled(!stands, button).on_hover_text(help).clicked() {
                commands.push(Command::Session(SessionCommand::SetUp(settings.clone())));
            }
        }
        if let Ok(text) = &outcome.file {
            let button = Button::new(tr("Save as a file")).min_size(touch::least(ui));
            let help = tr!(
                "The file that steadycut identify {id} --out writes, with source and intervals",
                id = form.kind.id()
            );
            if ui.add(button).on_hover_text(help).clicked() {
                let of = form.file.as_ref().map_or("", |file| file.name.as_str());
                let stem = of.rsplit_once('.').map_or(of, |(stem, _)| stem);
                let name = file_name(&format!("{stem}-{}", form.kind.id()), "toml");
                commands.push(Command::File(FileCommand::SaveText { name, text: text.clone() }));
            }
        }
        if stands {
            let show = Button::new(tr("Show the cut")).min_size(touch::least(ui));
            if ui.add(show).clicked() {
                commands.push(Command::Shell(ShellCommand::ShowScreen("console")));
            }
        }
    });
    if stands {
        let text = tr("It stands in the scenario. Undo takes it back.");
        Standing::Good.label(ui, text, |text| text);
    }
    match &outcome.settings {
        Ok(settings) => {
            let title = match settings.len() {
                1 => tr("1 setting").to_owned(),
                n => tr!("{n} settings", n = n),
            };
            let header = CollapsingHeader::new(title).id_salt("fitted settings");
            header.show_unindented(ui, |ui| {
                for (path, value) in settings {
                    let value = value.to_string();
                    let short: String = value.chars().take(VALUE).collect();
                    let cut = if short.len() < value.len() { "\u{2026}" } else { "" };
                    let text = RichText::new(format!("{path} = {short}{cut}")).small();
                    ui.add(Label::new(text).wrap());
                }
            });
        }
        Err(why) => {
            let text = tr!("This scenario does not take it: {why}", why = why);
            Standing::Bad.label(ui, &text, |text| text);
        }
    }
}
