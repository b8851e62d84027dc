//! The window on measured data: as what a file was read, which channel of it lies over which plot, and where it lies.

pub(in crate::app::panels) mod layout;
mod place;
mod prepare;

use egui::{Button, Color32, ComboBox, RichText, Role, Ui, WidgetInfo};

use super::super::{BroughtFile, View};
use crate::app::command::{Command, FileCommand};
use crate::app::overlay::file::MeasuredFile;
use crate::app::overlay::layouts::LayoutMemory;
use crate::app::overlay::unit::{SIGNALS_OVER, units};
use crate::app::overlay::{MOST_OVERLAYS, Overlay, Overlays};
use crate::app::theme::{self, Palette};
use crate::app::widgets::chart::Axes;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::app::widgets::window::{self, WindowPlace};
use crate::base::language::{text, tr};
use crate::run::signals::signal;
use layout::LayoutFields;
use prepare::PrepareFields;

/// Width of the window, points: the plots beside it stay in sight.
const WIDTH: f32 = 400.0;
/// Its title.
const TITLE: &str = text!("Measured data");
/// Share of a phone's screen that it takes.
const SHARE: f32 = 0.5;

/// The window.
#[derive(Default)]
pub struct MeasuredWindow {
    /// Whether it is shown.
    pub open: bool,
    /// Whether it is no more than a line where it would cover a phone's plots.
    folded: bool,
    layout: LayoutFields,
    prepare: PrepareFields,
    /// What a field that was typed in has to say.
    said: Option<String>,
}

/// What is done with the data that the window shows.
enum Wish {
    /// Another one of those over the plots.
    Choose(usize),
    /// Another channel of its file as well.
    Another,
    /// No more of it.
    Remove,
    /// Settings are fitted to its file.
    Fit,
}

impl MeasuredWindow {
    /// Lays a file over the plots.
    pub fn take(&mut self, file: &MeasuredFile, overlays: &mut Overlays) {
        (self.open, self.folded) = (true, false);
        // One that could not be read is in the way of none.
        if overlays.chosen_mut().is_some_and(|overlay| overlay.file.contents().is_err()) {
            overlays.remove_chosen();
        }
        self.said = match overlays.take(file) {
            true => None,
            false => Some(tr!(
                "{name} is not shown: there are {most} measured channels over the plots already. Remove one first.",
                name = file.name,
                most = MOST_OVERLAYS
            )),
        };
        self.begin();
    }

    /// Forgets what was typed for other data.
    fn begin(&mut self) {
        self.layout = LayoutFields::default();
        self.prepare = PrepareFields::default();
    }

    /// Shows it, if it is open.
    pub fn show(
        &mut self,
        ui: &Ui,
        view: &View<'_>,
        (overlays, axes): (&mut Overlays, &mut Axes),
        commands: &mut Vec<Command>,
    ) {
        let size = [WIDTH, theme::OVERLAY_HEIGHTS[0]];
        let place = WindowPlace { screen: ui.max_rect(), narrow: view.narrow, size, share: SHARE };
        let mut open = self.open;
        if self.folded && view.narrow {
            let line = told(overlays);
            let unfold = tr("Unfold");
            self.folded = !window::line(ui.ctx(), TITLE, place, &mut open, (&line, unfold));
        } else {
            window::show(ui.ctx(), TITLE, place, &mut open, |ui| {
                self.content(ui, view.narrow, (overlays, axes), commands);
            });
        }
        self.open = open;
    }

    fn content(
        &mut self,
        ui: &mut Ui,
        narrow: bool,
        (overlays, axes): (&mut Overlays, &mut Axes),
        commands: &mut Vec<Command>,
    ) {
        let mut wish = None;
        ui.horizontal_wrapped(|ui| {
            let open = Button::new(tr("Open a file\u{2026}")).min_size(touch::least(ui));
            if ui.add(open).clicked() {
                commands.push(Command::File(FileCommand::OpenMeasured));
            }
            if narrow {
                let help = tr("Leaves a line of it, and the plots in sight");
                let fold = Button::new(tr("Fold to a line")).min_size(touch::least(ui));
                self.folded = ui.add(fold).on_hover_text(help).clicked();
            }
            let several = overlays.all().len() > 1;
            for (place, overlay) in overlays.all().iter().enumerate().filter(|_| several) {
                let is = place == overlays.place();
                let name = format!("{}: {}", overlay.file.name, overlay.choice.channel);
                if touch::choice(ui, is, name).clicked() && !is {
                    wish = Some(Wish::Choose(place));
                }
            }
        });
        if let Some(said) = &self.said {
            Standing::Watch.label(ui, said, |text| text);
        }
        match overlays.chosen_mut() {
            None => {
                ui.label(tr(
                    "Text of any layout, MATLAB, HDF5, TDMS or Parquet; a file can also be dropped onto the plots.",
                ));
            }
            Some(overlay) => {
                ui.separator();
                if let Some(of_file) = self.file(ui, overlay, commands) {
                    wish = Some(of_file);
                }
                if overlay.file.contents().is_ok() {
                    ui.separator();
                    wish = self.channel(ui, overlay, axes).or(wish);
                }
            }
        }
        ui.separator();
        let note = tr(
            "No part of the scenario: neither a file nor a link holds it. Changes of the cut leave it where it is, until it is \
             removed or the program is closed.",
        );
        ui.label(RichText::new(note).small().color(Palette::at(ui).weak));
        match wish {
            None => return,
            Some(Wish::Choose(place)) => overlays.choose(place),
            Some(Wish::Remove) => overlays.remove_chosen(),
            Some(Wish::Fit) => {
                let file = overlays.chosen_mut().map(|overlay| Box::new(overlay.file.clone()));
                let bring = file.map(|file| FileCommand::Bring(BroughtFile::ToFit(file)));
                commands.extend(bring.map(Command::File));
                return;
            }
            Some(Wish::Another) => {
                if let Some(file) = overlays.chosen_mut().map(|overlay| overlay.file.clone()) {
                    self.take(&file, overlays);
                }
            }
        }
        self.begin();
    }

    /// As what the file was read.
    fn file(
        &mut self,
        ui: &mut Ui,
        overlay: &mut Overlay,
        commands: &mut Vec<Command>,
    ) -> Option<Wish> {
        let mut wish = None;
        let failed = match overlay.file.contents() {
            Ok(_) => None,
            Err(fault) => Some(format!("{}: {fault}", overlay.file.name)),
        };
        if let Some(failed) = failed {
            Standing::Bad.label(ui, &failed, |text| text);
            if ui.button(tr("Remove")).clicked() {
                wish = Some(Wish::Remove);
            }
        }
        if let Some(again) = self.layout.show(ui, &overlay.file, &mut self.said, commands) {
            // What does not go with the file is no help for the next one.
            if again.contents().is_ok() || *again.memory() == LayoutMemory::Guessed {
                let remember = FileCommand::RememberLayout(Box::new(again.clone()));
                commands.push(Command::File(remember));
            }
            overlay.read_again(again);
        }
        wish
    }

    /// Which channel lies over which signal, and where.
    fn channel(&mut self, ui: &mut Ui, overlay: &mut Overlay, axes: &mut Axes) -> Option<Wish> {
        let mut wish = None;
        let names: Vec<String> =
            overlay.channels().iter().map(|channel| channel.name.clone()).collect();
        let chosen = overlay.choice.channel.clone();
        let peaks = overlay.choice.preparation.peaks.is_some();
        let titles: Vec<String> = overlay.channels().iter().map(|c| c.title()).collect();
        ui.add_enabled_ui(!peaks, |ui| {
            if let Some(place) = choice(ui, tr("Channel"), &titles, position(&names, &chosen)) {
                overlay.choose_channel(&names[place]);
            }
        });
        let labels: Vec<String> = SIGNALS_OVER
            .iter()
            .filter_map(|id| signal(id))
            .map(|signal| tr(signal.label).to_owned())
            .collect();
        let of = SIGNALS_OVER.iter().position(|id| *id == overlay.choice.signal);
        if let Some(place) = choice(ui, tr("Laid over"), &labels, of) {
            overlay.choose_signal(SIGNALS_OVER[place]);
        }
        let unit = signal(overlay.choice.signal).map_or("", |signal| signal.unit);
        let as_it_is = [tr("as it is, not converted").to_owned()];
        let known = units(unit).iter().map(|unit| crate::app::format::unit(unit.names[0]));
        let known: Vec<String> = known.chain(as_it_is).collect();
        let of = overlay.choice.unit.unwrap_or(known.len() - 1);
        if let Some(place) = choice(ui, tr("Its unit"), &known, Some(of)) {
            overlay.choice.unit = Some(place).filter(|place| *place + 1 < known.len());
        }
        let channels = names;
        self.prepare.show(ui, &channels, &mut overlay.choice.preparation, &mut self.said);
        ui.separator();
        place::show(ui, overlay, &mut self.said);
        ui.separator();
        ui.horizontal_wrapped(|ui| {
            let mut shown = axes.shows_measured(overlay.id);
            if ui.checkbox(&mut shown, tr("Show it")).changed() {
                axes.show_measured(overlay.id, shown);
            }
            if ui.button(tr("Remove")).clicked() {
                wish = Some(Wish::Remove);
            }
            if ui.button(tr("Another channel of this file")).clicked() {
                wish = Some(Wish::Another);
            }
            let help = tr("Drive, forces, structure, noise, wear or material of this file, on the screen Identify");
            if ui.button(tr("Fit settings to it")).on_hover_text(help).clicked() {
                wish = Some(Wish::Fit);
            }
        });
        wish
    }
}

/// What lies over the plots, in a line.
fn told(overlays: &Overlays) -> String {
    let all = overlays.all();
    let Some(overlay) = all.get(overlays.place()) else { return tr(TITLE).to_owned() };
    let more = if all.len() > 1 { format!(" (+{})", all.len() - 1) } else { String::new() };
    match overlay.file.contents() {
        Ok(_) => {
            let over = signal(overlay.choice.signal).map_or("", |signal| tr(signal.label));
            tr!(
                "{channel} over {signal}{more}",
                channel = &overlay.choice.channel,
                signal = over,
                more = more
            )
        }
        Err(_) => format!("{}{more}", overlay.file.name),
    }
}

fn position(names: &[String], name: &str) -> Option<usize> {
    names.iter().position(|known| known == name)
}

/// A list to choose from behind its name; the place of what was chosen now.
pub(in crate::app::panels) fn choice(
    ui: &mut Ui,
    name: &str,
    options: &[String],
    chosen: Option<usize>,
) -> Option<usize> {
    /// Width of the names before the lists, points.
    const NAMES: f32 = 110.0;
    let mut found = None;
    ui.horizontal(|ui| {
        let font = egui::TextStyle::Body.resolve(ui.style());
        let wide =
            ui.painter().layout_no_wrap(name.to_owned(), font, Color32::PLACEHOLDER).size().x;
        ui.label(name);
        ui.add_space((NAMES - wide).max(0.0));
        let shown = chosen.and_then(|place| options.get(place)).map_or("", String::as_str);
        let list = ComboBox::from_id_salt(name).selected_text(shown).truncate();
        let response = list
            .width(ui.available_width().min(220.0))
            .show_ui(ui, |ui| {
                for (place, option) in options.iter().enumerate() {
                    let is = Some(place) == chosen;
                    if ui.selectable_label(is, option).clicked() {
                        ui.close();
                        found = Some(place).filter(|_| !is);
                    }
                }
            })
            .response;
        response.widget_info(|| WidgetInfo {
            current_text_value: Some(shown.to_owned()),
            ..WidgetInfo::labeled(Role::ComboBox, true, name)
        });
    });
    found
}
