//! Begin, pause, go on, end, save and take up again; how far the search is.

use egui::{Button, Label, ProgressBar, RichText, Ui};

use super::form::IdentifyForm;
use super::search::FormulaSearch;
use crate::app::command::{Command, FileCommand};
use crate::app::jobs::time_left;
use crate::app::theme::Palette;
use crate::app::widgets::icon::{self, Icon};
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::tr;
use crate::study::identify::gp::standing::GpStage;

/// What is wished for.
pub enum Wish {
    /// To search for what the form asks for.
    Begin,
}

/// The row of buttons, how far it is, and what has changed since it was begun.
pub fn show(
    ui: &mut Ui,
    form: &mut IdentifyForm,
    search: Option<&mut FormulaSearch>,
    commands: &mut Vec<Command>,
) -> Option<Wish> {
    let mut wish = None;
    let missing = form.problem().err();
    let possible = missing.is_none();
    let button = |ui: &mut Ui, possible, name: &str, help: &str| {
        let button = Button::new(name).min_size(touch::least(ui));
        ui.add_enabled(possible, button).on_hover_text(help).clicked()
    };
    let Some(search) = search else {
        ui.horizontal_wrapped(|ui| {
            let help = tr("Searches for formulas; it goes on while other screens are shown");
            if button(ui, possible, tr("Search"), help) {
                wish = Some(Wish::Begin);
            }
            resume(ui, possible, commands);
        });
        if let Some(missing) = missing {
            Standing::Watch.label(ui, &missing, |text| text);
        }
        return wish;
    };
    let (over, running) = (search.work().is_over(), search.work().is_running());
    let changed = form.asked.differs(&search.asked);
    ui.horizontal_wrapped(|ui| {
        if running {
            let help = tr("Stands still; what was found stays");
            if icon::button(ui, Icon::Pause, tr("Pause the search"), help, true).clicked() {
                search.work().stop();
            }
        } else {
            let help = tr("Goes on where it was paused");
            if icon::button(ui, Icon::Play, tr("Go on with the search"), help, !over).clicked() {
                search.work().go_on();
            }
        }
        let searching = search.standing().stage == GpStage::Search;
        let help =
            tr("Ends the search with its last whole batch; what was found is still judged at rows left out");
        if button(ui, searching, tr("End here"), help) {
            search.end_here();
        }
        let anew = !changed.is_empty() && possible;
        let help = tr("Searches for what is set now, and gives this search up");
        if button(ui, anew, tr("Begin anew"), help) {
            wish = Some(Wish::Begin);
        }
        let help = tr("Writes a file to go on with later, here or with --resume");
        if button(ui, true, tr("Save the search"), help) {
            search.save();
        }
        resume(ui, possible, commands);
    });
    progress(ui, search);
    if !changed.is_empty() {
        let changed: Vec<&str> = changed.into_iter().map(tr).collect();
        let text = tr!(
            "Changed since this search was begun: {changed}. It stays as it was begun; `Begin anew` searches for what is set \
             now.",
            changed = changed.join(", ")
        );
        Standing::Watch.label(ui, &text, |text| text);
        if let Some(missing) = &missing {
            Standing::Watch.label(ui, missing, |text| text);
        }
        let help = tr("Sets table, columns and numbers to those of this search");
        if button(ui, true, tr("Set back"), help) {
            form.asked = search.asked.clone();
        }
    }
    wish
}

fn resume(ui: &mut Ui, possible: bool, commands: &mut Vec<Command>) {
    let button = Button::new(tr("Resume\u{2026}")).min_size(touch::least(ui));
    let help = tr(
        "Goes on with a saved search of the same table, columns, units and seed; its file can also be dropped here",
    );
    if ui.add_enabled(possible, button).on_hover_text(help).clicked() {
        commands.push(Command::File(FileCommand::OpenSearch));
    }
}

/// How far it is, in a bar and in words.
fn progress(ui: &mut Ui, search: &FormulaSearch) {
    let palette = Palette::at(ui);
    let standing = search.standing();
    let running = search.work().is_running();
    let stage = match standing.stage {
        GpStage::Search => tr!(
            "batch {batch} of at most {most}",
            batch = standing.batches,
            most = standing.most_batches
        ),
        GpStage::Paper => tr("the paper's own search").to_owned(),
        GpStage::LeftOut => tr("judging the front at rows left out").to_owned(),
        GpStage::Over => tr!("done after {n} batches", n = standing.batches),
    };
    let mut told = vec![stage, tr!("{n} formulas", n = standing.evaluations)];
    if !search.work().is_over() {
        match (running, search.work().left_s()) {
            (true, Some(left_s)) => told.push(tr!("at most {left} left", left = time_left(left_s))),
            (true, None) => {}
            (false, _) => told.push(tr("paused").to_owned()),
        }
    }
    let text = told.join(", ");
    ui.horizontal_wrapped(|ui| {
        let share = search.work().progress().share() as f32;
        ui.scope(|ui| {
            ui.visuals_mut().extreme_bg_color = palette.line;
            ui.add(ProgressBar::new(share).desired_width(140.0).desired_height(10.0));
        });
        ui.add(Label::new(RichText::new(text).color(palette.weak)).wrap());
    });
}
