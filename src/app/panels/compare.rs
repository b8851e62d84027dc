//! Ways of control against each other: the same part, the same noise seeds; a table and box plots,
//! the printed Table 1 of 2005 as the line to beat, and what was chosen with it in view.

mod boxes;
mod claims;
mod contest;
mod controls;
mod robust;
mod sheets;
mod step;
mod table;

use egui::{Frame, Margin, RichText, Ui};

use super::{Panel, View};
use crate::app::command::Command;
use crate::app::theme::{self, Palette};
use crate::app::widgets::save_table::{SavedTable, TableOf, save_table};
use crate::app::widgets::scaffold;
use crate::base::language::{text, tr};
use crate::study::compare::outcome::Measure;
use contest::{ContestPart, Contests};

/// Name of the part of Table 1 of 2005, to show it; people do not read it.
pub const PART_OF_2005: &str = "experiment 2";

/// The screen.
pub struct ComparePanel {
    contests: Contests,
    /// What the box plots show.
    measure: Measure,
    /// What a card is about where it is narrow.
    cards: table::Cards,
}

impl Default for ComparePanel {
    fn default() -> Self {
        let cards = table::Cards::default();
        Self { contests: Contests::default(), measure: Measure::Nsn, cards }
    }
}

impl Panel for ComparePanel {
    fn id(&self) -> &'static str {
        "compare"
    }

    fn title(&self) -> &'static str {
        text!("Compare")
    }

    fn words(&self) -> &'static str {
        text!("controllers ranking best seeds statistics tournament")
    }

    fn show_part(&mut self, part: &str) {
        if part == PART_OF_2005 {
            self.contests.setup.part = ContestPart::Experiment2;
        }
    }

    fn has_timeline(&self) -> bool {
        false
    }

    fn ui(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let may_run_script = !view.session.waits_for_consent();
        self.contests.follow(view.session.current(), may_run_script, view.jobs);
        let margin =
            Frame::new().inner_margin(Margin::symmetric(if view.narrow { 8 } else { 12 }, 6));
        scaffold::column(ui, "compare").show(ui, |ui| {
            margin.show(ui, |ui| self.page(ui, view, commands));
        });
    }
}

impl ComparePanel {
    fn page(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let palette = Palette::at(ui);
        controls::show(ui, &mut self.contests, view.session, view.narrow);
        let printed = self.contests.is_table_1();
        let Some(contest) = self.contests.shown() else {
            // A set-up that is refused says why above.
            if self.contests.refused.is_none() {
                theme::card(palette).show(ui, |ui| {
                    ui.set_width(ui.available_width());
                    ui.label(RichText::new(tr("Nobody takes part")).strong());
                    ui.label(tr("Choose at least one way of control above."));
                });
            }
            return;
        };
        let compared = contest.table();
        ui.add_space(4.0);
        let sheet = || sheets::compared(contest.entrants(), compared, contest.reference(), printed);
        let done = || contest.not_whole().unwrap_or_default();
        let saved = SavedTable {
            what: "comparison",
            of: TableOf::Cut(contest.scenario()),
            partial: contest.not_whole().is_some().then_some(&done),
        };
        ui.horizontal_wrapped(|ui| {
            if view.narrow {
                table::choose(ui, &mut self.cards);
            }
            save_table(ui, &saved, sheet, commands);
        });
        table::summary(ui, contest);
        if view.narrow {
            table::cards(ui, contest, printed, self.cards, commands);
        } else {
            table::table(ui, contest, printed, commands);
        }
        ui.add_space(8.0);
        boxes::show(ui, contest, &mut self.measure, printed);
        step::show(ui, contest, printed, commands);
        claims::show(ui, compared, contest.transients(), printed);
        robust::show(ui, &mut self.contests.robust, view.jobs, commands);
    }
}
