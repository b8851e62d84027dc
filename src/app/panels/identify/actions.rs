//! What can be done with the formula: saved, copied, put into the running cut.

use egui::{Button, Ui};

use super::places::Places;
use super::search::FormulaSearch;
use crate::app::command::{Command, FileCommand, SessionCommand, ShellCommand};
use crate::app::files::file_name;
use crate::app::format;
use crate::app::panels::View;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::formula::FormulaLanguage;
use crate::base::language::tr;
use crate::models::formula_model::FormulaModel;
use crate::study::identify::gp::inspect::FormulaInspection;

/// The buttons, and what stands against them.
pub fn show(
    ui: &mut Ui,
    search: &FormulaSearch,
    seen: &FormulaInspection,
    places: &mut Places,
    view: &View<'_>,
    commands: &mut Vec<Command>,
) {
    let button = |ui: &mut Ui, name: &str, help: &str| {
        let button = Button::new(name).min_size(touch::least(ui));
        ui.add(button).on_hover_text(help).clicked()
    };
    ui.horizontal_wrapped(|ui| {
        if let Ok(model) = &seen.model {
            let help = tr("With units and ranges, as `steadycut identify gp --out` writes it");
            if button(ui, tr("Save as a model"), help) {
                let name = file_name(&search.problem().target, "model.toml");
                commands.push(Command::File(FileCommand::SaveText { name, text: model.write() }));
            }
        }
        for (language, name) in [
            (FormulaLanguage::Text, tr("Copy as text")),
            (FormulaLanguage::Latex, tr("Copy as LaTeX")),
        ] {
            if button(ui, name, tr("Puts the formula into the clipboard")) {
                ui.ctx().copy_text(seen.formula.export(language, ""));
                let form = tr(language.label());
                let said = tr!("The formula is in the clipboard ({form}).", form = form);
                commands.push(Command::notify(said));
            }
        }
    });
    match &seen.model {
        Ok(model) => in_the_cut(ui, model, places, view, commands),
        Err(because) => {
            let because = because.lines().next().unwrap_or_default();
            let text = tr!("Neither a model nor for the cut: {because}.", because = because);
            Standing::Bad.label(ui, &text, |text| text);
        }
    }
}

/// The buttons that put it into the running cut, or why none does.
fn in_the_cut(
    ui: &mut Ui,
    model: &FormulaModel,
    places: &mut Places,
    view: &View<'_>,
    commands: &mut Vec<Command>,
) {
    let scenario = view.session.scenario();
    // What is meant is told by its units: of the places that do not fit, none has to say so but where all do not.
    let all = places.of(model, view.session);
    let by_units = |fit: &&super::places::Fit| fit.0.value(model).is_ok();
    if !all.iter().any(|fit| by_units(&fit)) {
        let made = model.inputs().iter().map(|input| {
            tr!(
                "`{input}` in {unit}",
                input = input.name,
                unit = format::unit(&input.unit.to_string())
            )
        });
        let made: Vec<String> = made.collect();
        let made = match made.is_empty() {
            true => tr("nothing").to_owned(),
            false => made.join(tr(" and ")),
        };
        let makes = match model.output().unit.to_string() {
            unit if unit.is_empty() => tr("a number without a unit").to_owned(),
            unit => format::unit(&unit),
        };
        let text = tr!(
            "The cut has no place for it by its units: it makes {makes} of {made}.",
            makes = makes,
            made = made
        );
        Standing::Watch.label(ui, &text, |text| text);
        return;
    }
    for (place, settings) in all.iter().filter(by_units) {
        let label = tr(place.label());
        let name = tr!("Use in the cut: {place}", place = label);
        match settings {
            Err(because) => {
                let text = format!("{name}: {because}.");
                Standing::Watch.label(ui, &text, |text| text);
            }
            Ok(settings) => {
                let is = |(path, value): &(String, _)| scenario.get(path).as_ref() == Ok(value);
                if settings.iter().all(is) {
                    ui.horizontal_wrapped(|ui| {
                        let text = tr!("In the running cut: {place}.", place = label);
                        Standing::Good.label(ui, &text, |text| text);
                        let show = Button::new(tr("Show the cut")).min_size(touch::least(ui));
                        if ui.add(show).clicked() {
                            commands.push(Command::Shell(ShellCommand::ShowScreen("console")));
                        }
                    });
                    continue;
                }
                let button = Button::new(&name).min_size(touch::least(ui));
                let help = tr(
                    "Plant and controller compute with it from now on (calibration: own formulas); Undo takes it \
                               back",
                );
                if ui.add(button).on_hover_text(help).clicked() {
                    commands.push(Command::Session(SessionCommand::SetUp(settings.clone())));
                    let said = tr!(
                        "{place}: the formula stands in the running cut, with the calibration own formulas. Undo takes it \
                         back.",
                        place = label
                    );
                    commands.push(Command::notify(said));
                }
            }
        }
    }
}
