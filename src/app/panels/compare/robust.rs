//! Experiment 2 under other dead times and in another steel, nothing retuned, beside the figures of
//! an independent prototype.

use egui::{ProgressBar, RichText, TextWrapMode, Ui};

use super::contest::Robust;
use super::controls::run_or_pause;
use super::sheets;
use super::table::value;
use crate::app::command::Command;
use crate::app::jobs::Jobs;
use crate::app::theme::Palette;
use crate::app::widgets::save_table::{SavedTable, TableOf, save_table_of};
use crate::app::widgets::scaffold;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::tr;
use crate::study::compare::outcome::Measure;
use crate::study::compare::robustness::{CONDITIONS, RobustnessRow, material_claim};
use crate::study::verdict::Verdict;

/// What is shown of each condition.
const MEASURES: [Measure; 3] = [Measure::Nsn, Measure::Time, Measure::Force];

/// The section.
pub fn show(ui: &mut Ui, robust: &mut Robust, jobs: &Jobs, commands: &mut Vec<Command>) {
    let palette = Palette::at(ui);
    ui.add_space(8.0);
    ui.heading(tr("Without retuning anything"));
    let text = tr(
        "Experiment 2 at other dead times, which the controllers know, and in another steel, \
                   which they do not. Below each figure that of an independent prototype of the same \
                   equations, where it has one: it is no figure of the paper.",
    );
    ui.label(RichText::new(text).color(palette.weak));
    let progress = robust.progress();
    let (done, all) = (progress.done.floor() as u64, progress.total as u64);
    ui.horizontal_wrapped(|ui| {
        let over = done >= all;
        let names = [tr("Run the conditions"), tr("Pause the conditions")];
        let running = robust.is_running();
        let help = tr("Runs everybody under every condition");
        if run_or_pause(ui, names, help, running, !over) {
            match running {
                true => robust.stop(),
                false => robust.go_on(jobs),
            }
        }
        ui.add(ProgressBar::new(progress.share() as f32).desired_width(120.0).desired_height(10.0));
        let text = tr!("{done} of {n} runs", done = done, n = all);
        ui.label(RichText::new(text).color(palette.weak));
    });
    let each = robust.methods();
    let rows = robust.rows();
    let sheet = || sheets::robustness(rows);
    let so_many = || tr!("{done} of {n} runs done", done = done, n = all);
    let partial = (done < all).then_some(&so_many as &dyn Fn() -> String);
    let saved =
        SavedTable { what: "changed-conditions", of: TableOf::Named("experiment-2"), partial };
    save_table_of(ui, &saved, !rows.is_empty(), sheet, commands);
    if rows.is_empty() {
        return;
    }
    scaffold::across(ui, "robustness", |ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
        touch::grid(ui, "robustness").striped(true).spacing([14.0, 4.0]).show(ui, |ui| {
            ui.strong(tr("Control"));
            for condition in &CONDITIONS {
                ui.strong(tr(condition.label));
            }
            ui.end_row();
            ui.label("");
            for _ in &CONDITIONS {
                ui.label(RichText::new("Nsn / s / kN").small().color(palette.weak));
            }
            ui.end_row();
            for method in 0..each {
                ui.label(tr(&rows[method].found.name));
                for condition in 0..CONDITIONS.len() {
                    cell(ui, &rows[condition * each + method], palette);
                }
                ui.end_row();
            }
        });
    });
    if let Some(claim) = material_claim(rows) {
        let standing = Standing::either(claim.verdict == Verdict::Holds);
        let mark = tr(claim.verdict.label());
        ui.horizontal_wrapped(|ui| {
            standing.label(ui, mark, RichText::strong);
            ui.label(tr(claim.paper));
            ui.label(RichText::new(claim.found).color(palette.weak));
        });
    }
}

fn cell(ui: &mut Ui, row: &RobustnessRow, palette: &Palette) {
    let figures = |of: &dyn Fn(Measure) -> Option<f64>| {
        let each =
            MEASURES.map(|measure| of(measure).map_or("-".to_owned(), |x| value(measure, x)));
        each.join(" / ")
    };
    ui.vertical(|ui| {
        let found = figures(&|measure| row.found.get(measure).map(|spread| spread.mean));
        ui.label(found);
        let (finished, runs) = (row.found.finished, row.found.runs);
        if finished < runs {
            let text = tr!("{n} of {runs} runs not finished", n = runs - finished, runs = runs);
            ui.label(RichText::new(text).small().color(palette.weak));
        }
        if let Some(reference) = &row.reference {
            let known = figures(&|measure| reference.get(measure));
            ui.label(RichText::new(known).small().color(palette.weak));
        }
    });
}
