//! Formulas found in a table by genetic programming: what `steadycut identify gp` does, to be watched. The front grows
//! while the search works; a formula of it is looked at closely, saved, or put into the running cut. And settings fitted to
//! measured data (`fit`).

mod actions;
mod columns;
mod controls;
mod facts;
mod fit;
mod fit_plots;
mod form;
mod formula;
mod front;
mod front_plot;
mod places;
mod preview;
mod search;
mod symbols;
mod transport;
mod tree;
mod way;

use egui::{Panel as SidePanel, RichText, ScrollArea, Ui};

use super::{BroughtFile, DropTarget, Panel, View};
use crate::app::command::Command;
use crate::app::theme::{self, Palette};
use crate::app::widgets::scaffold;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::{text, tr};
use fit::FitView;
use form::IdentifyForm;
use places::Places;
use search::FormulaSearch;
use way::WayView;

/// Width of the settings beside the rest, points: the names of columns are long.
const CONTROLS_WIDTH: f32 = theme::CONTROLS_WIDTH + 64.0;

/// Id of the screen.
pub const IDENTIFY: &str = "identify";
/// Name of its part that fits settings to measured data.
pub const FITS: &str = text!("Fit settings");
/// Name of its part that searches for formulas.
const FORMULAS: &str = text!("Search formulas");

/// The parts of the screen.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
enum IdentifyPart {
    /// Formulas of a table.
    #[default]
    Formulas,
    /// Settings of measured data.
    Fits,
}

const PARTS: [(IdentifyPart, &str, &str); 2] = [
    (
        IdentifyPart::Formulas,
        FORMULAS,
        text!("Looks in a table for a formula of one column, by genetic programming"),
    ),
    (
        IdentifyPart::Fits,
        FITS,
        text!("Fits drive, forces, structure, noise, wear or material to a recording"),
    ),
];

/// The screen.
#[derive(Default)]
pub struct IdentifyPanel {
    part: IdentifyPart,
    fit: FitView,
    form: IdentifyForm,
    search: Option<FormulaSearch>,
    places: Places,
    way: WayView,
    /// Why something that was asked for was not done.
    refused: Option<String>,
}

impl Panel for IdentifyPanel {
    fn id(&self) -> &'static str {
        IDENTIFY
    }

    fn title(&self) -> &'static str {
        text!("Identify")
    }

    fn words(&self) -> &'static str {
        "own data measured measurements csv table model fit genetic programming symbolic regression formula gp experiment recording drive dead time force kienzle run-out noise wear taylor material modes"
    }

    fn has_timeline(&self) -> bool {
        false
    }

    fn tell_anew(&mut self) {
        self.fit.tell_anew();
    }

    fn show_part(&mut self, part: &str) {
        if let Some((part, ..)) = PARTS.into_iter().find(|(_, name, _)| *name == part) {
            self.part = part;
        }
    }

    fn drop_target(&self) -> DropTarget {
        match self.part {
            IdentifyPart::Formulas => DropTarget::Formulas,
            IdentifyPart::Fits => DropTarget::Fits,
        }
    }

    fn take(&mut self, file: &BroughtFile) {
        match file {
            BroughtFile::Table { name, text } => {
                self.part = IdentifyPart::Formulas;
                self.form.bring(name, text);
            }
            BroughtFile::Search { name, text } => {
                self.part = IdentifyPart::Formulas;
                self.form.resume(name, text);
            }
            BroughtFile::ToFit(file) => {
                self.part = IdentifyPart::Fits;
                self.fit.take(file);
            }
            BroughtFile::Mission { .. }
            | BroughtFile::Linked(_)
            | BroughtFile::Measured(_)
            | BroughtFile::Program { .. } => {}
        }
    }

    fn ui(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        if let Some((name, text)) = self.form.to_resume.take() {
            self.begin(view, Some((&name, &text)));
        }
        if let Some(search) = &mut self.search {
            search.refresh(commands);
        }
        self.fit.refresh();
        if view.narrow {
            scaffold::column(ui, "identify").show(ui, |ui| {
                scaffold::narrow().show(ui, |ui| {
                    self.controls(ui, view, commands);
                    ui.add_space(6.0);
                    self.page(ui, view, commands);
                });
            });
            return;
        }
        let settings = SidePanel::left("identify controls").exact_size(CONTROLS_WIDTH);
        settings.resizable(false).frame(scaffold::wide()).show(ui, |ui| {
            ScrollArea::vertical()
                .auto_shrink([false, false])
                .show(ui, |ui| self.controls(ui, view, commands));
        });
        scaffold::middle(ui, |ui| {
            scaffold::column(ui, "identified").show(ui, |ui| self.page(ui, view, commands));
        });
    }
}

impl IdentifyPanel {
    /// Begins what is asked for, or goes on with a search of a file.
    fn begin(&mut self, view: &View<'_>, resumed: Option<(&str, &str)>) {
        self.refused = None;
        let begun = self.form.problem().cloned().and_then(|problem| {
            FormulaSearch::begin(self.form.asked.clone(), problem, view.jobs, resumed)
        });
        match begun {
            Ok(search) => self.search = Some(search),
            Err(because) => self.refused = Some(because),
        }
    }

    /// The parts of the screen, to choose from.
    fn parts(&mut self, ui: &mut Ui) {
        ui.horizontal_wrapped(|ui| {
            for (part, name, help) in PARTS {
                let is = self.part == part;
                if touch::choice(ui, is, tr(name)).on_hover_text(tr(help)).clicked() {
                    self.part = part;
                }
            }
        });
        ui.add_space(4.0);
    }

    fn controls(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        self.parts(ui);
        match self.part {
            IdentifyPart::Formulas => {}
            IdentifyPart::Fits => return self.fit.controls(ui, view, commands),
        }
        controls::show(ui, &mut self.form, commands);
        ui.add_space(8.0);
        let searched = (self.form.asked.seed, self.form.asked.batches);
        self.way.controls(ui, view.session.current(), searched, view.jobs);
    }

    /// What was found: by the way, and by the search for one formula.
    fn page(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        match self.part {
            IdentifyPart::Formulas => {}
            IdentifyPart::Fits => return self.fit.page(ui, view, commands),
        }
        match transport::show(ui, &mut self.form, self.search.as_mut(), commands) {
            Some(transport::Wish::Begin) => self.begin(view, None),
            None => {}
        }
        if let Some(because) = &self.refused {
            Standing::Bad.label(ui, because, |text| text);
        }
        self.way.show(ui, commands);
        let Some(search) = &mut self.search else { return empty(ui) };
        ui.add_space(4.0);
        front::show(ui, search, view.narrow, commands);
        ui.add_space(8.0);
        formula::show(ui, search, &mut self.places, view, commands);
    }
}

/// What to do where nothing was searched for yet.
fn empty(ui: &mut Ui) {
    let palette = Palette::at(ui);
    ui.add_space(4.0);
    theme::card(palette).show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.label(RichText::new(tr("No formula was searched for yet")).strong());
        ui.label(tr(
            "Choose a table (a CSV can be dropped here), the column that the formula is to give, and the columns \
             that it may read; then press Search.",
        ));
        ui.label(tr(
            "The front grows while the search works: for every size the formula of the least error. Any of them can \
             be looked at, saved, and put into the running cut.",
        ));
        ui.label(tr(
            "Without a table of one's own: Go the whole way plans and measures cuts on the simulator, which can then \
             be searched as well.",
        ));
    });
}
