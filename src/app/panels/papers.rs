//! Table 3 of SDNRP 2007 against ten runs: printed, reproduced, residual, verdict of every cell,
//! the errata, and the paper's own deviations. A click loads a row into the console.

mod table;

use std::collections::BTreeMap;

use egui::{Frame, Margin, RichText, ScrollArea};

use super::{Panel, View};
use crate::app::command::Command;
use crate::app::theme::{self, Palette};
use crate::base::model::gp::Calibration;
use crate::blocks::cutting::process::ForceModel;
use crate::study::papers::{self, PaperTable, Verdict};
use crate::study::published::PaperId;

/// The screen.
pub struct PapersPanel {
    calibration: Calibration,
    /// What has been reproduced so far: the ten runs are done once for each calibration.
    done: BTreeMap<Calibration, PaperTable>,
}

impl Default for PapersPanel {
    fn default() -> Self {
        Self { calibration: Calibration::Identified, done: BTreeMap::new() }
    }
}

impl Panel for PapersPanel {
    fn id(&self) -> &'static str {
        "papers"
    }

    fn title(&self) -> &'static str {
        "Papers"
    }

    fn ui(&mut self, ui: &mut egui::Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let side = if view.narrow { 8 } else { 12 };
        let margin = Frame::new().inner_margin(Margin::symmetric(side, 6));
        ScrollArea::vertical().id_salt("papers").auto_shrink(false).show(ui, |ui| {
            margin.show(ui, |ui| self.page(ui, view.narrow, commands));
        });
    }
}

impl PapersPanel {
    fn page(&mut self, ui: &mut egui::Ui, narrow: bool, commands: &mut Vec<Command>) {
        ui.heading("SDNRP 2007, Table 3: ten simulations");
        self.choose_calibration(ui);
        let calibration = self.calibration;
        let paper = self
            .done
            .entry(calibration)
            .or_insert_with(|| papers::table(PaperId::Sdnrp2007, calibration, ForceModel::Formula));
        summary(ui, paper);
        if narrow {
            table::cards(ui, paper, commands);
        } else {
            table::table(ui, paper, commands);
        }
        own_deviations(ui, paper);
        errata(ui, paper);
    }

    fn choose_calibration(&mut self, ui: &mut egui::Ui) {
        ui.horizontal_wrapped(|ui| {
            ui.label("Calibration of plant and controller:");
            for (calibration, choice) in Calibration::ALL.iter().zip(Calibration::OPTIONS) {
                ui.selectable_value(&mut self.calibration, *calibration, choice.label)
                    .on_hover_text(choice.doc);
            }
        });
    }
}

/// How many cells are met, and what that means.
fn summary(ui: &mut egui::Ui, paper: &PaperTable) {
    let palette = Palette::at(ui);
    let compared = || paper.rows.iter().flat_map(|row| row.compared());
    let met = compared().filter(|cell| cell.verdict == Verdict::Met).count();
    let color = if paper.all_met() { palette.good } else { palette.bad };
    let text = format!("{met} of {} final values met", compared().count());
    ui.label(RichText::new(text).strong().color(color));
    let bands = format!(
        "Each row is run in time from its printed start values, noise off, SDNRP; the final values \
         are means over the last of 15 s. Met: force within {} %, feed {} %, speed {} %, Ra {}.",
        paper.bands.force_percent,
        paper.bands.feed_percent,
        paper.bands.speed_percent,
        theme::quantity(paper.bands.ra_um, "um"),
    );
    ui.label(RichText::new(bands).color(palette.weak));
    ui.add_space(4.0);
}

/// What the paper's own table says about its findings.
fn own_deviations(ui: &mut egui::Ui, paper: &PaperTable) {
    ui.add_space(10.0);
    ui.heading("The paper's own deviations");
    ui.label(
        "The findings speak of at most 4.1 % in Ra and 5.2 % in force. Table 3 itself, final value \
         against desired value, says more: proportional feedback leaves a steady-state error. With \
         the identified models the runs leave the same one.",
    );
    table::deviations(ui, paper);
}

fn errata(ui: &mut egui::Ui, paper: &PaperTable) {
    let palette = Palette::at(ui);
    ui.add_space(10.0);
    ui.heading("Errata");
    for erratum in paper.errata {
        theme::card(palette).show(ui, |ui| {
            ui.set_width(ui.available_width());
            let title = format!("{}. {}", erratum.number, erratum.printed);
            ui.label(RichText::new(title).strong());
            ui.label(erratum.problem);
            ui.label(RichText::new(format!("Here: {}", erratum.resolution)).color(palette.good));
        });
    }
    ui.add_space(8.0);
}
