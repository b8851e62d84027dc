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

use super::{Panel, View};
use crate::app::command::{Command, SessionCommand, ShellCommand};
use crate::app::format;
use crate::app::jobs::Work;
use crate::app::theme::{self, Palette};
use crate::app::widgets::save_table::save_table;
use crate::app::widgets::standing::Standing;
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
    /// What the 2019 paper's equations give: computed once.
    measured: Option<Vec<String>>,
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
        "Papers"
    }

    fn words(&self) -> &'static str {
        "tables errata reproduction published calibrations"
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
                let measured = self.measured.get_or_insert_with(papers_2019::measured);
                machine::show(ui, measured, commands);
                return show_errata(ui, MACHINE_2019);
            }
        }
        let Shown { calibration, force_model, .. } = &mut self.shown;
        let whose = "Calibration of plant and controller:";
        choose(ui, whose, &Calibration::PUBLISHED, Calibration::OPTIONS, calibration);
        choose(ui, "Plant's force from:", ForceModel::maps(), ForceModel::OPTIONS, force_model);
        let shown = self.shown;
        let work = self.tables.entry(shown).or_insert_with(|| {
            let job = TableJob::new(shown.paper, shown.calibration, shown.force_model);
            let name = format!("Papers: {}", shown.paper.label());
            view.jobs.begin(name, job, FIRST)
        });
        // In this order: what is over has all its rows.
        let over = work.is_over();
        let table = &*work.partial();
        ui.add_space(4.0);
        summary(ui, shown.calibration, table, over);
        if !over {
            on_the_way(ui, work);
        }
        if view.narrow {
            table::cards(ui, shown, table, commands);
        } else {
            table::table(ui, shown, table, commands);
        }
        let what = format!("table-{}", shown.paper.id());
        save_table(ui, &what, || sheets::simulated(shown.paper, table), commands);
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
            let name = format!("Calibrations: {}", paper.label());
            view.jobs.begin(name, CalibrationsJob::new(paper), FIRST)
        });
        calibrations::show(ui, paper, all, commands);
        if paper == PaperId::Strategy2013 {
            let claim = self.claim.get_or_insert_with(|| {
                view.jobs.begin("Claim about forces", ForceClaimJob::default(), 1)
            });
            claim::show(ui, claim, commands);
        }
    }

    fn choose_paper(&mut self, ui: &mut Ui) {
        let simulated = PaperId::ALL.iter().map(|id| (Paper::Simulated(*id), id.label()));
        let others = [
            (Paper::Combined2005, "Combined system 2005, Table 1"),
            (Paper::Machine2019, "Dynamic model 2019, Table 1"),
        ];
        ui.horizontal_wrapped(|ui| {
            ui.label("Paper:");
            for (paper, label) in simulated.chain(others) {
                ui.selectable_value(&mut self.paper, paper, label);
            }
        });
    }
}

/// The 2005 paper: its table is compared elsewhere.
fn combined(ui: &mut Ui, commands: &mut Vec<Command>) {
    let palette = Palette::at(ui);
    ui.add_space(4.0);
    ui.label(
        "Table 1 compares six ways of control on Experiment 2. Its figures stand beside runs over \
         many seeds, with what was chosen in view of them, on the screen Compare.",
    );
    ui.horizontal_wrapped(|ui| {
        if ui.button("Open Compare").clicked() {
            commands.push(Command::Shell(ShellCommand::ShowScreen("compare")));
        }
        for (label, preset) in [
            ("Load Experiment 1", "experiment-1"),
            ("Load Experiment 2", "experiment-2"),
            ("Load the five steps", "combined-2005"),
        ] {
            let hint = format!("Opens the scenario {preset} in the console");
            if ui.button(label).on_hover_text(hint).clicked() {
                commands.push(Command::Session(SessionCommand::LoadPreset(preset.to_owned())));
                commands.push(Command::Shell(ShellCommand::ShowScreen("console")));
            }
        }
    });
    let text =
        "On the command line: steadycut papers --paper 2005, with --robustness and --beyond.";
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
            ui.selectable_value(chosen, *value, option.label)
                .on_hover_text(option.doc.replace('\n', " "));
        }
    });
}

/// How far the simulations are, and what goes on with them where they were stopped.
fn on_the_way(ui: &mut Ui, work: &Work<TableJob>) {
    ui.horizontal_wrapped(|ui| {
        let progress = work.progress();
        ui.label(RichText::new(format!("{progress} done.")).color(Palette::at(ui).accent));
        if !work.is_running() && ui.button("Go on with the table").clicked() {
            work.go_on();
        }
    });
}

/// How many cells are met, and what that means.
fn summary(ui: &mut Ui, calibration: Calibration, table: &PaperTable, over: bool) {
    let palette = Palette::at(ui);
    let judged = || {
        let cells = table.rows.iter().flat_map(|row| row.compared());
        cells.filter(|cell| cell.verdict != CellVerdict::Reported)
    };
    let (met, all) =
        (judged().filter(|cell| cell.verdict == CellVerdict::Met).count(), judged().count());
    let (text, standing) = if table.rows.is_empty() {
        ("No simulation is done yet".to_owned(), Standing::Plain)
    } else if all == 0 {
        let text = "Final values as they are: the table's forces come from the formula, another \
                    force model of the plant gives others by nature";
        (text.to_owned(), Standing::Plain)
    } else {
        let so_far = if over { "" } else { " so far" };
        // A tick beside a fit is no proof of what was fitted.
        let fitted = match calibration {
            Calibration::Printed | Calibration::Restored => "",
            Calibration::Identified | Calibration::Genetic => {
                ", by models fitted to these very rows"
            }
            Calibration::Formula => ", by formulas of one's own",
        };
        let text = format!("{met} of {all} final values met{so_far}{fitted}");
        (text, Standing::either(met == all))
    };
    standing.label(ui, &text, RichText::strong);
    let run = "Each row is run in time from its printed start values, noise off, SDNRP; the final \
               values are means over the last of 15 s.";
    let bands = &table.bands;
    let bands = format!(
        "Met: force within {} %, feed {} %, speed {} %, Ra {}.",
        bands.force_percent,
        bands.feed_percent,
        bands.speed_percent,
        format::quantity(bands.ra_um, "um"),
    );
    let text = if all == 0 { run.to_owned() } else { format!("{run} {bands}") };
    ui.label(RichText::new(text).color(palette.weak));
    ui.add_space(4.0);
}

fn show_errata(ui: &mut Ui, errata: &[Erratum]) {
    let palette = Palette::at(ui);
    ui.add_space(10.0);
    ui.heading("Errata");
    for erratum in errata {
        theme::card(palette).show(ui, |ui| {
            ui.set_width(ui.available_width());
            let title = format!("{}. {}", erratum.number, erratum.printed);
            ui.label(RichText::new(title).strong());
            ui.label(erratum.problem);
            ui.label(RichText::new(format!("Here: {}", erratum.resolution)).color(palette.weak));
        });
    }
    ui.add_space(8.0);
}
