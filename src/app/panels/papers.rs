//! Published tables against runs, Table 3 of SDNRP 2007 and Table 1 of the 2013 control strategy:
//! printed, reproduced, residual, verdict of every cell, the errata, and the paper's own
//! deviations. A click loads a row into the console. Table 1 of 2005 is compared on a screen of its
//! own; Table 1 of 2019 stands beside its own rules.

mod calibrations;
mod claim;
mod deviations;
mod machine;
mod sheets;
mod table;

use std::collections::BTreeMap;

use egui::{Frame, Margin, RichText, ScrollArea, Ui};

use super::{Panel, View, compare};
use crate::app::command::{Command, SessionCommand, ShellCommand};
use crate::app::format;
use crate::app::jobs::Work;
use crate::app::theme::{self, Palette};
use crate::app::widgets::save_table::{SavedTable, TableOf, save_table_of};
use crate::app::widgets::standing::Standing;
use crate::base::language::{self, Language, text, tr};
use crate::base::settings::Choice;
use crate::blocks::cutting::process::ForceModel;
use crate::models::genetic::Calibration;
use crate::study::errata::{self, COMBINED_2005, Erratum};
use crate::study::errata_2019::MACHINE_2019;
use crate::study::papers::{CalibrationsJob, CellVerdict, PaperTable, TableJob};
use crate::study::papers_2019;
use crate::study::published::PaperId;
use crate::study::train::claim::ForceClaimJob;

/// Steps of the plant in the first slice of a table.
const FIRST: u64 = 20_000;

/// The papers; two have a table of simulations.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Paper {
    Simulated(PaperId),
    Combined2005,
    Machine2019,
}

/// What is shown: a paper's table, re-run with a calibration and a force model of the plant.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Shown {
    paper: PaperId,
    calibration: Calibration,
    force_model: ForceModel,
}

/// The screen.
pub struct PapersPanel {
    paper: Paper,
    shown: Shown,
    /// What the 2019 paper's equations give: computed once in each language.
    measured: Option<(Language, Vec<String>)>,
    /// The tables so far: each is run once, and goes on when another one, or another screen, is shown.
    tables: BTreeMap<Shown, Work<TableJob>>,
    /// A table in all calibrations, begun when its first one is over.
    calibrations: BTreeMap<PaperId, Work<CalibrationsJob>>,
    /// The claim about forces, likewise.
    claim: Option<Work<ForceClaimJob>>,
}

impl Default for PapersPanel {
    fn default() -> Self {
        let shown = Shown {
            paper: PaperId::Sdnrp2007,
            calibration: Calibration::Identified,
            force_model: ForceModel::Formula,
        };
        let paper = Paper::Simulated(shown.paper);
        let (tables, calibrations) = (BTreeMap::new(), BTreeMap::new());
        Self { paper, shown, measured: None, tables, calibrations, claim: None }
    }
}

impl Panel for PapersPanel {
    fn id(&self) -> &'static str {
        "papers"
    }

    fn title(&self) -> &'static str {
        text!("Papers")
    }

    fn words(&self) -> &'static str {
        text!("tables errata reproduction published calibrations")
    }

    fn has_timeline(&self) -> bool {
        false
    }

    fn ui(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let side = if view.narrow { 8 } else { 12 };
        let margin = Frame::new().inner_margin(Margin::symmetric(side, 6));
        ScrollArea::vertical().id_salt("papers").auto_shrink(false).show(ui, |ui| {
            margin.show(ui, |ui| self.page(ui, view, commands));
        });
    }
}

impl PapersPanel {
    fn page(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        self.choose_paper(ui);
        match self.paper {
            Paper::Simulated(paper) => self.shown.paper = paper,
            Paper::Combined2005 => return combined(ui, commands),
            Paper::Machine2019 => {
                let now = language::chosen();
                let kept = self.measured.take().filter(|(language, _)| *language == now);
                let kept = kept.unwrap_or_else(|| (now, papers_2019::measured()));
                machine::show(ui, &self.measured.insert(kept).1, commands);
                return show_errata(ui, MACHINE_2019);
            }
        }
        let Shown { calibration, force_model, .. } = &mut self.shown;
        let whose = tr("Calibration of plant and controller:");
        choose(ui, whose, &Calibration::PUBLISHED, Calibration::OPTIONS, calibration);
        let from = tr("Plant's force from:");
        choose(ui, from, ForceModel::maps(), ForceModel::OPTIONS, force_model);
        let shown = self.shown;
        let work = self.tables.entry(shown).or_insert_with(|| {
            let job = TableJob::new(shown.paper, shown.calibration, shown.force_model);
            let name = tr!("Papers: {paper}", paper = tr(shown.paper.label()));
            view.jobs.begin(name, job, FIRST)
        });
        // In this order: what is over has all its rows.
        let over = work.is_over();
        let table = &*work.partial();
        ui.add_space(4.0);
        let what = format!("table-{}", shown.paper.id());
        let sheet = || sheets::simulated(shown.paper, table);
        let done = || work.progress().to_string();
        let partial = (!over).then_some(&done as &dyn Fn() -> String);
        let saved = SavedTable { what: &what, of: TableOf::Nothing, partial };
        save_table_of(ui, &saved, !table.rows.is_empty(), sheet, commands);
        summary(ui, shown, table, over);
        on_the_way(ui, work, over);
        if view.narrow {
            table::cards(ui, shown, table, commands);
        } else {
            table::table(ui, shown, table, commands);
        }
        if over {
            deviations::show(ui, shown.paper, table, commands);
            self.beside(ui, view, commands);
        }
        show_errata(ui, errata::of(shown.paper));
    }

    /// What stands beside the table: its rows in all calibrations, and of 2013 the claim about forces.
    fn beside(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let paper = self.shown.paper;
        let all = self.calibrations.entry(paper).or_insert_with(|| {
            let name = tr!("Calibrations: {paper}", paper = tr(paper.label()));
            view.jobs.begin(name, CalibrationsJob::new(paper), FIRST)
        });
        calibrations::show(ui, paper, all, commands);
        if paper == PaperId::Strategy2013 {
            let claim = self.claim.get_or_insert_with(|| {
                view.jobs.begin(text!("Claim about forces"), ForceClaimJob::default(), 1)
            });
            claim::show(ui, claim, commands);
        }
    }

    fn choose_paper(&mut self, ui: &mut Ui) {
        let simulated = PaperId::ALL.iter().map(|id| (Paper::Simulated(*id), id.label()));
        let others = [
            (Paper::Combined2005, text!("Combined system 2005, Table 1")),
            (Paper::Machine2019, text!("Dynamic model 2019, Table 1")),
        ];
        ui.horizontal_wrapped(|ui| {
            ui.label(tr("Paper:"));
            for (paper, label) in simulated.chain(others) {
                ui.selectable_value(&mut self.paper, paper, tr(label));
            }
        });
    }
}

/// The 2005 paper: its table is compared elsewhere.
fn combined(ui: &mut Ui, commands: &mut Vec<Command>) {
    let palette = Palette::at(ui);
    ui.add_space(4.0);
    ui.label(tr(
        "Table 1 compares six ways of control on Experiment 2. Its figures stand beside runs over \
         many seeds, with what was chosen in view of them, on the screen Compare.",
    ));
    ui.horizontal_wrapped(|ui| {
        if ui.button(tr("Open Compare")).clicked() {
            let part = ShellCommand::ShowPart("compare", compare::PART_OF_2005);
            commands.push(Command::Shell(part));
        }
        for (label, preset) in [
            (text!("Load Experiment 1"), "experiment-1"),
            (text!("Load Experiment 2"), "experiment-2"),
            (text!("Load the five steps"), "combined-2005"),
        ] {
            let hint = tr!("Opens the scenario {name} in the console", name = preset);
            if ui.button(tr(label)).on_hover_text(hint).clicked() {
                commands.push(Command::Session(SessionCommand::LoadPreset(preset.to_owned())));
                commands.push(Command::Shell(ShellCommand::ShowScreen("console")));
            }
        }
    });
    let text =
        tr("On the command line: steadycut papers --paper 2005, with --robustness and --beyond.");
    ui.label(RichText::new(text).color(palette.weak));
    show_errata(ui, COMBINED_2005);
}

/// A row of choices, one of them taken.
fn choose<T: Copy + PartialEq>(
    ui: &mut Ui,
    title: &str,
    all: &[T],
    options: &[Choice],
    chosen: &mut T,
) {
    ui.horizontal_wrapped(|ui| {
        ui.label(title);
        for (value, option) in all.iter().zip(options) {
            ui.selectable_value(chosen, *value, tr(option.label))
                .on_hover_text(tr(option.doc).replace('\n', " "));
        }
    });
}

/// How far the simulations are, and what goes on with them where they were stopped. The line stays when they are over:
/// nothing below it moves.
fn on_the_way(ui: &mut Ui, work: &Work<TableJob>, over: bool) {
    ui.horizontal_wrapped(|ui| {
        let palette = Palette::at(ui);
        let color = if over { palette.weak } else { palette.accent };
        let text = tr!("{progress} done.", progress = work.progress().to_string());
        ui.label(RichText::new(text).color(color));
        if !over && !work.is_running() && ui.button(tr("Go on with the table")).clicked() {
            work.go_on();
        }
    });
}

/// What is said where nothing is judged.
const AS_THEY_ARE: &str = text!(
    "Final values as they are: the table's forces come from the formula, another force model of the plant gives others by nature"
);

/// How many cells are met, and what that means.
fn summary(ui: &mut Ui, shown: Shown, table: &PaperTable, over: bool) {
    let palette = Palette::at(ui);
    let judged = || {
        let cells = table.rows.iter().flat_map(|row| row.compared());
        cells.filter(|cell| cell.verdict != CellVerdict::Reported)
    };
    let (met, all) =
        (judged().filter(|cell| cell.verdict == CellVerdict::Met).count(), judged().count());
    let (text, standing) = if table.rows.is_empty() {
        (tr("No simulation is done yet").to_owned(), Standing::Plain)
    } else if all == 0 {
        (tr(AS_THEY_ARE).to_owned(), Standing::Plain)
    } else {
        (met_of(met, all, shown.calibration, over), Standing::either(met == all))
    };
    // Room for the longest words from the beginning: the table below does not move as rows come in.
    let is_judged = if table.rows.is_empty() { shown.force_model.is_formula() } else { all > 0 };
    let longest = match is_judged {
        true => format!("\u{a0}\u{a0}{}", met_of(88, 88, shown.calibration, false)),
        false => tr(AS_THEY_ARE).to_owned(),
    };
    let font = egui::TextStyle::Body.resolve(ui.style());
    let longest = ui.painter().layout(longest, font, palette.text, ui.available_width());
    ui.scope(|ui| {
        ui.set_min_height(longest.size().y);
        standing.label(ui, &text, RichText::strong);
    });
    let run =
        tr("Each row is run in time from its printed start values, noise off, SDNRP; the final \
                  values are means over the last of 15 s.");
    let bands = &table.bands;
    let bands = tr!(
        "Met: force within {force} %, feed {feed} %, speed {speed} %, Ra {ra}.",
        force = bands.force_percent,
        feed = bands.feed_percent,
        speed = bands.speed_percent,
        ra = format::quantity(bands.ra_um, "um"),
    );
    let text = if is_judged { format!("{run} {bands}") } else { run.to_owned() };
    ui.label(RichText::new(format::typeset(&text)).color(palette.weak));
    ui.add_space(4.0);
}

fn show_errata(ui: &mut Ui, errata: &[Erratum]) {
    let palette = Palette::at(ui);
    ui.add_space(10.0);
    ui.heading(tr("Errata"));
    for erratum in errata {
        theme::card(palette).show(ui, |ui| {
            ui.set_width(ui.available_width());
            let title = format!("{}. {}", erratum.number, tr(erratum.printed));
            ui.label(RichText::new(format::typeset(&title)).strong());
            ui.label(format::typeset(tr(erratum.problem)));
            let here = tr!("Here: {resolution}", resolution = tr(erratum.resolution));
            ui.label(RichText::new(format::typeset(&here)).color(palette.weak));
        });
    }
    ui.add_space(8.0);
}

/// How many final values are met, and by what.
fn met_of(met: usize, all: usize, calibration: Calibration, over: bool) -> String {
    // A tick beside a fit is no proof of what was fitted.
    match (calibration, over) {
        (Calibration::Printed | Calibration::Restored, true) => {
            tr!("{met} of {n} final values met", met = met, n = all)
        }
        (Calibration::Printed | Calibration::Restored, false) => {
            tr!("{met} of {n} final values met so far", met = met, n = all)
        }
        (Calibration::Identified | Calibration::Genetic, true) => tr!(
            "{met} of {n} final values met, by models fitted to these very rows",
            met = met,
            n = all,
        ),
        (Calibration::Identified | Calibration::Genetic, false) => tr!(
            "{met} of {n} final values met so far, by models fitted to these very rows",
            met = met,
            n = all,
        ),
        (Calibration::Formula, true) => {
            tr!("{met} of {n} final values met, by formulas of one's own", met = met, n = all)
        }
        (Calibration::Formula, false) => tr!(
            "{met} of {n} final values met so far, by formulas of one's own",
            met = met,
            n = all,
        ),
    }
}
