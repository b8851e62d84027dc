//! The 2013 paper's claim about forces, 4 % against 6 %, with what is found here.

use egui::{RichText, ScrollArea, Ui};

use super::sheets;
use crate::app::command::Command;
use crate::app::jobs::Work;
use crate::app::theme::Palette;
use crate::app::widgets::save_table::save_table;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::study::train::claim::{ForceClaim, ForceClaimJob};
use crate::study::verdict::Verdict;

/// How a verdict stands.
fn standing(verdict: Verdict) -> Standing {
    match verdict {
        Verdict::Holds => Standing::Good,
        Verdict::InPart => Standing::Watch,
        Verdict::Not => Standing::Bad,
        Verdict::NoRun => Standing::Plain,
    }
}

fn rows(ui: &mut Ui, claim: &ForceClaim) {
    for title in ["Model", "claimed", "mean", "median", "95 %"] {
        ui.strong(title);
    }
    ui.end_row();
    for contender in &claim.contenders {
        let errors = &contender.errors;
        ui.label(contender.name).on_hover_text(contender.what);
        ui.label(format!("{} %", contender.claimed_percent));
        ui.strong(format!("{:.2} %", errors.mean_percent));
        for percent in [errors.median_percent, errors.p95_percent] {
            ui.label(format!("{percent:.2} %"));
        }
        ui.end_row();
    }
}

/// The section of the screen.
pub fn show(ui: &mut Ui, work: &Work<ForceClaimJob>, commands: &mut Vec<Command>) {
    let palette = Palette::at(ui);
    let claim = work.partial();
    ui.add_space(10.0);
    ui.heading("The claim about forces: 4 % against 6 %");
    ui.label(format!(
        "The paper: {}. Errors of the force here over the same {} fresh rows.",
        claim.paper, claim.fresh_rows
    ));
    ui.label(RichText::new(claim.data).color(palette.weak));
    if !work.is_over() {
        ui.label(RichText::new(format!("{} done.", work.progress())).color(palette.accent));
        return;
    }
    let grid = touch::grid(ui, "claim").striped(true).min_col_width(24.0).spacing([12.0, 3.0]);
    ScrollArea::horizontal().id_salt("claim").show(ui, |ui| grid.show(ui, |ui| rows(ui, &claim)));
    for statement in &claim.statements {
        let text = format!("{}: {}", statement.verdict.label(), statement.statement);
        standing(statement.verdict).label(ui, &text, |text| text);
    }
    save_table(ui, "claim-2013", || sheets::claim(&claim), commands);
}
