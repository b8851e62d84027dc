//! What was guessed of a file's layout, and what a person says of it.

use egui::{Button, CollapsingHeader, RichText, ScrollArea, TextEdit, Ui, WidgetInfo};

use super::choice;
use crate::app::command::{Command, FileCommand};
use crate::app::format;
use crate::app::overlay::file::{MeasuredFile, NO_TIMES, ReadFile, common_rate_hz, sentence};
use crate::app::overlay::layouts::{LayoutMemory, beside};
use crate::app::panels::BroughtFile;
use crate::app::theme::Palette;
use crate::app::widgets::number::NumberField;
use crate::app::widgets::touch;
use crate::base::language::tr;
use crate::base::text::decode;
use crate::measured::reader::DataFormat;

/// Sample rates that can be said, Hz: those of the reader as far as a field shows them.
const RATES: [f64; 2] = [0.001, 1e9];
/// Height of the table of channels at most, points.
const TABLE: f32 = 150.0;

/// What is being typed.
#[derive(Default)]
pub struct LayoutFields {
    /// Entries of the layout.
    entries: String,
    /// Samples in a second; none where nothing was said.
    rate_hz: Option<f64>,
    /// Whether the file is read as a table, whose rows have no times.
    pub table: bool,
}

impl LayoutFields {
    /// Shows it; the file read again where something was said.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        file: &MeasuredFile,
        said: &mut Option<String>,
        commands: &mut Vec<Command>,
    ) -> Option<MeasuredFile> {
        let mut again = None;
        if let Ok(read) = file.contents() {
            ui.label(RichText::new(&file.name).strong());
            ui.label(sentence(&read.data));
            channels(ui, read);
            for note in &read.data.notes {
                ui.label(RichText::new(format::typeset(note)).small().color(Palette::at(ui).weak));
            }
            again = self.record(ui, file, read, said);
            if !self.table {
                again = self.times(ui, file, read, said).or(again);
            }
        }
        again = self.otherwise(ui, file, said).or(again);
        again = remembered(ui, file).or(again);
        let is_text = file.contents().map_or(true, |read| read.data.format == DataFormat::Text);
        if is_text
            && let Ok(text) = decode(file.bytes())
            && ui.button(tr("Search for formulas in it")).clicked()
        {
            let name = file.name.clone();
            commands.push(Command::File(FileCommand::Bring(BroughtFile::Table { name, text })));
        }
        again
    }

    /// What of a file with several records is read.
    fn record(
        &self,
        ui: &mut Ui,
        file: &MeasuredFile,
        read: &ReadFile,
        said: &mut Option<String>,
    ) -> Option<MeasuredFile> {
        let entries = &read.data.entries;
        if entries.is_empty() {
            return None;
        }
        let names: Vec<String> = std::iter::once(tr("as they come").to_owned())
            .chain(entries.iter().map(|entry| format!("{}: {}", entry.name, entry.about)))
            .collect();
        let is = |name: &String| entries.iter().position(|entry| entry.name == *name);
        let chosen = read.data.layout.variable.as_ref().and_then(is).map_or(0, |place| place + 1);
        match choice(ui, tr("Record"), &names, Some(chosen))?.checked_sub(1) {
            None => Some(file.with_records_as_they_come()),
            Some(place) => taken(file.with(&[("variable", &entries[place].name)]), said),
        }
    }

    /// Which column has the times, or how many samples there are in a second.
    fn times(
        &mut self,
        ui: &mut Ui,
        file: &MeasuredFile,
        read: &ReadFile,
        said: &mut Option<String>,
    ) -> Option<MeasuredFile> {
        let layout = &read.data.layout;
        let columns = layout.names.clone().unwrap_or_default();
        let time = layout.time.as_deref().unwrap_or(NO_TIMES);
        let names: Vec<String> =
            columns.iter().cloned().chain([tr("none: a sample rate").to_owned()]).collect();
        let chosen = columns.iter().position(|name| name == time).unwrap_or(columns.len());
        if let Some(place) = choice(ui, tr("Time column"), &names, Some(chosen)) {
            self.rate_hz = None;
            let column = columns.get(place).map_or(NO_TIMES, String::as_str);
            return Some(file.with_times(column, layout.rate_hz));
        }
        if chosen < columns.len() {
            return None;
        }
        let told_hz = layout.rate_hz.or_else(|| common_rate_hz(&read.data));
        let mut rate_hz = self.rate_hz.or(told_hz);
        let before = rate_hz;
        ui.horizontal(|ui| {
            let name = tr("Sample rate");
            ui.label(name);
            let field = NumberField {
                name,
                unit: "Hz",
                range: RATES,
                // Typed alone: the file is read again for every rate.
                speed: 0.0,
                decimals: 3,
                least: 0,
                suffix: " Hz",
            };
            let response = field.show_or_blank(ui, &mut rate_hz, said);
            response.widget_info(|| WidgetInfo {
                label: Some(name.to_owned()),
                ..WidgetInfo::drag_value(true, rate_hz.unwrap_or(0.0))
            });
            if rate_hz != before {
                self.rate_hz = rate_hz;
            }
            let left = response.lost_focus() || !response.has_focus();
            let other = self.rate_hz.filter(|rate| left && Some(*rate) != told_hz);
            other.map(|rate| file.with_times(NO_TIMES, Some(rate)))
        })
        .inner
    }

    /// A line for any entry of the layout, as the command takes them.
    fn otherwise(
        &mut self,
        ui: &mut Ui,
        file: &MeasuredFile,
        said: &mut Option<String>,
    ) -> Option<MeasuredFile> {
        ui.horizontal(|ui| {
            let name = tr("Read it otherwise");
            ui.label(name);
            let field = TextEdit::singleline(&mut self.entries)
                .hint_text("decimal=comma names_line=3")
                .desired_width(ui.available_width().min(220.0))
                .min_size(touch::least(ui));
            let response = ui.add(field);
            let text = self.entries.clone();
            response.widget_info(|| WidgetInfo::text_edit(true, "", &text, name));
            let help = tr(
                "Entries of the layout as the command steadycut measured has them, with blanks between: encoding, separator, \
                 decimal, thousands, names_line, units_line, first_line, names, units. Enter reads the file again.",
            );
            let entered = response.lost_focus() && ui.input(|i| i.key_pressed(egui::Key::Enter));
            response.on_hover_text(help);
            if !entered || text.trim().is_empty() {
                return None;
            }
            let entries: Option<Vec<(&str, &str)>> =
                text.split_whitespace().map(|entry| entry.split_once('=')).collect();
            match entries {
                Some(entries) => taken(file.with(&entries), said),
                None => {
                    *said = Some(tr("allowed is KEY=VALUE").to_owned());
                    None
                }
            }
        })
        .inner
    }
}

/// Where the layout comes from, and the way back to what is guessed.
fn remembered(ui: &mut Ui, file: &MeasuredFile) -> Option<MeasuredFile> {
    let keys: Vec<&str> = file.said().entries().iter().map(|(key, _)| *key).collect();
    let keys = keys.join(", ");
    let beside =
        file.path().map(|path| beside(path).file_name().map(|x| x.to_string_lossy().into_owned()));
    let text = match file.memory() {
        LayoutMemory::Guessed => return None,
        LayoutMemory::NotAlike(why) => why.clone(),
        LayoutMemory::Alike => {
            tr!("As you said for a file with the same columns: {keys}.", keys = keys)
        }
        LayoutMemory::Beside => tr!(
            "As the file {name} beside it says: {keys}.",
            name = beside.flatten().unwrap_or_default(),
            keys = keys
        ),
        LayoutMemory::Said => match beside.flatten() {
            Some(name) => tr!(
                "Remembered in {name}, and for files with the same columns: {keys}.",
                name = name,
                keys = keys
            ),
            None => tr!("Remembered for files with the same columns: {keys}.", keys = keys),
        },
    };
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(format::typeset(&text)).small().color(Palette::at(ui).weak));
        let help =
            tr("Read it as it is guessed, and forget what is remembered, beside the file as well");
        let button = Button::new(tr("Guess again")).min_size(touch::least(ui));
        ui.add(button).on_hover_text(help).clicked().then(|| file.guessed_again())
    })
    .inner
}

/// The file, or what there is to say.
fn taken(file: Result<MeasuredFile, String>, said: &mut Option<String>) -> Option<MeasuredFile> {
    match file {
        Ok(file) => {
            *said = None;
            Some(file)
        }
        Err(why) => {
            *said = Some(why);
            None
        }
    }
}

/// The channels with their units.
fn channels(ui: &mut Ui, read: &ReadFile) {
    let channels = &read.data.channels;
    let title = match channels.len() {
        1 => tr("1 channel").to_owned(),
        n => tr!("{n} channels", n = n),
    };
    let open = channels.len() <= 4;
    let header = CollapsingHeader::new(title).id_salt("channels").default_open(open);
    header.show_unindented(ui, |ui| {
        let area = ScrollArea::both().id_salt("channels").max_height(TABLE);
        area.show(ui, |ui| {
            let weak = Palette::at(ui).weak;
            touch::grid(ui, "channels").num_columns(5).striped(true).show(ui, |ui| {
                let heads = [tr("channel"), tr("samples"), tr("least"), tr("mean"), tr("largest")];
                for title in heads {
                    ui.label(RichText::new(title).small().color(weak));
                }
                ui.end_row();
                for (channel, summary) in channels.iter().zip(&read.summaries) {
                    ui.label(channel.title());
                    ui.label(channel.values.len().to_string());
                    for value in [summary.min, summary.mean, summary.max] {
                        let known = value.is_finite();
                        ui.label(if known { format::fine(value, "") } else { "-".to_owned() });
                    }
                    ui.end_row();
                }
            });
        });
    });
}
