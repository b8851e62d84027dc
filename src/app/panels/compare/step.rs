//! The load step: how long each way of control takes until the force is back.

use egui::{RichText, ScrollArea, TextWrapMode, Ui};

use super::contest::Contest;
use super::sheets;
use super::table::printed_of;
use crate::app::command::Command;
use crate::app::format;
use crate::app::theme::Palette;
use crate::app::widgets::save_table::save_table;
use crate::app::widgets::touch;

/// The section; the printed table belongs to what is shown or not.
pub fn show(ui: &mut Ui, contest: &Contest, belongs: bool, commands: &mut Vec<Command>) {
    if !contest.has_load_step() {
        return;
    }
    let palette = Palette::at(ui);
    ui.add_space(8.0);
    ui.heading("After a load step");
    let [before_n, after_n] = contest.load_step_n();
    let text = format!(
        "From a section of {before_n:.0} N into one of {after_n:.0} N (static peaks in Ck45 at 100 % \
         override), without noise: control periods of {} ms until the mean of four samples is back \
         within 10 % for good. The paper prints iterations of an optimisation step without saying what \
         they are; they are shown beside.",
        contest.control_period_ms()
    );
    ui.label(RichText::new(text).color(palette.weak));
    if contest.transients().is_empty() {
        ui.weak("Not run yet: it comes first when the comparison runs.");
        return;
    }
    ScrollArea::horizontal().id_salt("load step").show(ui, |ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
        steps(ui, contest, belongs);
    });
    let sheet = || sheets::load_step(contest.transients(), belongs);
    save_table(ui, "load-step", sheet, commands);
}

fn steps(ui: &mut Ui, contest: &Contest, belongs: bool) {
    let palette = Palette::at(ui);
    touch::grid(ui, "load step").striped(true).spacing([16.0, 4.0]).show(ui, |ui| {
        for title in ["Control", "Periods", "Overshoot", "Left over", "Printed"] {
            ui.strong(title);
        }
        ui.end_row();
        for transient in contest.transients() {
            ui.label(&transient.name);
            let periods = transient.periods.map_or("never steady".to_owned(), |n| n.to_string());
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
