//! The load step: how long each way of control takes until the force is back.

use egui::{RichText, TextWrapMode, Ui};

use super::contest::Contest;
use super::sheets;
use super::table::printed_of;
use crate::app::command::Command;
use crate::app::format;
use crate::app::theme::Palette;
use crate::app::widgets::save_table::{SavedTable, TableOf, save_table_of};
use crate::app::widgets::scaffold;
use crate::app::widgets::touch;
use crate::base::language::{text, tr};

/// The section; the printed table belongs to what is shown or not.
pub fn show(ui: &mut Ui, contest: &Contest, belongs: bool, commands: &mut Vec<Command>) {
    if !contest.has_load_step() {
        return;
    }
    let palette = Palette::at(ui);
    ui.add_space(8.0);
    ui.horizontal_wrapped(|ui| {
        ui.heading(tr("After a load step"));
        let rows = contest.transients();
        let so_many = || {
            let told = |[done, all]: [usize; 2]| tr!("{done} of {n} done", done = done, n = all);
            contest.load_steps().map(told).unwrap_or_default()
        };
        let saved = SavedTable {
            what: "load-step",
            of: TableOf::Cut(contest.scenario()),
            partial: contest.load_steps().is_some().then_some(&so_many),
        };
        save_table_of(ui, &saved, !rows.is_empty(), || sheets::load_step(rows, belongs), commands);
    });
    let [before_n, after_n] = contest.load_step_n();
    let text = tr!(
        "From a section of {before:.0} N into one of {after:.0} N (static peaks in Ck45 at 100 % \
         override), without noise: control periods of {period} ms until the mean of four samples is back \
         within 10 % for good. The paper prints iterations of an optimisation step without saying what \
         they are; they are shown beside.",
        before = before_n,
        after = after_n,
        period = contest.control_period_ms(),
    );
    ui.label(RichText::new(text).color(palette.weak));
    if contest.transients().is_empty() {
        ui.weak(tr("Not run yet: it comes first when the comparison runs."));
        return;
    }
    scaffold::across(ui, "load step", |ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
        steps(ui, contest, belongs);
    });
}

fn steps(ui: &mut Ui, contest: &Contest, belongs: bool) {
    let palette = Palette::at(ui);
    touch::grid(ui, "load step").striped(true).spacing([16.0, 4.0]).show(ui, |ui| {
        for title in [
            text!("Control"),
            text!("Periods"),
            text!("Overshoot"),
            text!("Left over"),
            text!("Printed"),
        ] {
            ui.strong(tr(title));
        }
        ui.end_row();
        for transient in contest.transients() {
            ui.label(tr(&transient.name));
            let periods = transient
                .periods
                .map_or(tr(transient.without_periods()).to_owned(), |n| n.to_string());
            ui.label(periods);
            ui.label(format::deviation(transient.overshoot_percent));
            ui.label(format::deviation(transient.offset_percent));
            let printed = printed_of(&transient.name, belongs);
            let printed = printed.map(|row| format!("{:.0}", row.optimization_iterations));
            ui.label(RichText::new(printed.unwrap_or_default()).color(palette.weak));
            ui.end_row();
        }
    });
}
