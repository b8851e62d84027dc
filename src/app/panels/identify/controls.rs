//! What is searched, and how.

use egui::{Button, Label, RichText, Role, TextEdit, Ui, WidgetInfo};

use super::columns;
use super::form::IdentifyForm;
use super::preview;
use super::symbols::short;
use crate::app::command::{Command, FileCommand};
use crate::app::theme::Palette;
use crate::app::widgets::number::NumberField;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::tr;
use crate::study::published::PaperId;

/// Least and largest seed, and number of batches: those of the command line as far as a field shows them whole.
const SEEDS: [f64; 2] = [0.0, 4_294_967_295.0];
/// See [`SEEDS`].
const BATCHES: [f64; 2] = [1.0, 1_000_000.0];
/// Longest name of a table on a button, characters.
const NAME: usize = 30;

/// The settings.
pub fn show(ui: &mut Ui, form: &mut IdentifyForm, commands: &mut Vec<Command>) {
    tables(ui, form, commands);
    ui.add_space(6.0);
    if let Some(table) = form.asked.table.clone() {
        columns::show(ui, &mut form.asked, &table);
    }
    ui.add_space(6.0);
    search(ui, form);
}

fn tables(ui: &mut Ui, form: &mut IdentifyForm, commands: &mut Vec<Command>) {
    let palette = Palette::at(ui);
    ui.label(RichText::new(tr("Table")).strong());
    let mut chosen = None;
    ui.horizontal_wrapped(|ui| {
        for table in &form.tables {
            let is = form.asked.table.as_ref() == Some(table);
            let name = tr(&table.name);
            let response = touch::choice(ui, is, short(name, NAME));
            let label = tr!("Table: {table}", table = name);
            response.widget_info(|| WidgetInfo::selected(Role::Button, true, is, label.clone()));
            if response.on_hover_text(name).clicked() {
                chosen = Some(table.clone());
            }
        }
        let open = ui.add(Button::new(tr("Open a CSV\u{2026}")).min_size(touch::least(ui)));
        let help = tr("A table with a line of names; it can also be dropped here");
        if open.on_hover_text(help).clicked() {
            commands.push(Command::File(FileCommand::OpenTable));
        }
    });
    if let Some(table) = chosen {
        form.choose(&table);
    }
    if let Some(because) = &form.refused {
        Standing::Bad.label(ui, because, |text| text);
    }
    if let Some(table) = &form.asked.table {
        let (rows, columns) = (table.offered.rows, table.offered.columns.len());
        let text = tr!(
            "{table}: {rows} rows, {columns} columns.",
            table = short(tr(&table.name), 2 * NAME),
            rows = rows,
            columns = columns
        );
        ui.add(Label::new(RichText::new(text).small().color(palette.weak)).wrap());
        preview::show(ui, &table.offered);
    }
}

fn search(ui: &mut Ui, form: &mut IdentifyForm) {
    let palette = Palette::at(ui);
    ui.label(RichText::new(tr("Search")).strong());
    let IdentifyForm { asked, said, .. } = form;
    let number = |ui: &mut Ui, name, range, speed, value: &mut u64, said: &mut Option<String>| {
        ui.horizontal(|ui| {
            let label = ui.label(name).id;
            let field =
                NumberField { name, unit: "", range, speed, decimals: 0, least: 0, suffix: "" };
            let mut shown = *value as f64;
            field.show(ui, &mut shown, said).labelled_by(label);
            *value = shown.round() as u64;
        });
    };
    number(ui, tr("Seed"), SEEDS, 0.2, &mut asked.seed, said);
    number(ui, tr("Most batches"), BATCHES, 2.0, &mut asked.batches, said);
    let stop =
        tr("It ends earlier where nothing is gained for 200 batches, or a formula is exact.");
    ui.label(RichText::new(stop).small().color(palette.weak));
    let label = ui.label(tr("Known part of the formula")).id;
    let field = TextEdit::singleline(&mut asked.template)
        .hint_text(tr("none, or as a + b*n^3 + T(f)"))
        .desired_width(f32::INFINITY);
    let help = tr(
        "Columns by their names; other names are constants that are fitted. T(...) stands for what is searched for, \
                   a formula of the columns in its brackets",
    );
    ui.add(field).on_hover_text(help).labelled_by(label);
    ui.checkbox(&mut asked.strict, tr("Only formulas that are right in their units"));
    ui.label(tr("Beside it, as searched in a paper:"));
    ui.horizontal_wrapped(|ui| {
        let options = [(None, tr("none")), (Some(PaperId::Sdnrp2007), "2007"), (Some(PaperId::Strategy2013), "2013")];
        for (paper, name) in options {
            let is = asked.paper == paper;
            let response = touch::choice(ui, is, name);
            let label = tr!("Paper's search beside: {paper}", paper = name);
            response.widget_info(|| WidgetInfo::selected(Role::Button, true, is, label.clone()));
            let help = tr("Its functions, constants, population and probabilities; the report says which search found \
                           the formula of the smaller error");
            if response.on_hover_text(help).clicked() {
                asked.paper = paper;
            }
        }
    });
    if let Some(said) = &form.said {
        Standing::Bad.label(ui, said, |text| text);
    }
}
