//! The 2013 paper's claim about forces, 4 % against 6 %, with what is found here.

use egui::{RichText, Ui};

use super::sheets;
use crate::app::command::Command;
use crate::app::jobs::Work;
use crate::app::theme::Palette;
use crate::app::widgets::save_table::{SavedTable, TableOf, save_table};
use crate::app::widgets::scaffold;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::{decimal, fixed, tr};
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
    for title in [tr("Model"), tr("claimed"), tr("mean"), tr("median"), "95 %"] {
        ui.strong(title);
    }
    ui.end_row();
    for contender in &claim.contenders {
        let errors = &contender.errors;
        ui.label(tr(contender.name)).on_hover_text(tr(contender.what));
        ui.label(format!("{} %", decimal(contender.claimed_percent.to_string())));
        ui.strong(format!("{} %", fixed(errors.mean_percent, 2)));
        for percent in [errors.median_percent, errors.p95_percent] {
            ui.label(format!("{} %", fixed(percent, 2)));
        }
        ui.end_row();
    }
}

/// The section of the screen.
pub fn show(ui: &mut Ui, work: &Work<ForceClaimJob>, commands: &mut Vec<Command>) {
    let palette = Palette::at(ui);
    let claim = work.partial();
    ui.add_space(10.0);
    ui.heading(tr("The claim about forces: 4 % against 6 %"));
    ui.label(tr!(
        "The paper: {claim}. Errors of the force here over the same {n} fresh rows.",
        claim = tr(claim.paper),
        n = claim.fresh_rows,
    ));
    ui.label(RichText::new(tr(claim.data)).color(palette.weak));
    if !work.is_over() {
        let text = tr!("{progress} done.", progress = work.progress().to_string());
        ui.label(RichText::new(text).color(palette.accent));
        return;
    }
    let grid = touch::grid(ui, "claim").striped(true).min_col_width(24.0).spacing([12.0, 3.0]);
    scaffold::across(ui, "claim", |ui| {
        grid.show(ui, |ui| rows(ui, &claim));
    });
    for statement in &claim.statements {
        let text = format!("{}: {}", tr(statement.verdict.label()), statement.statement);
        standing(statement.verdict).label(ui, &text, |text| text);
    }
    save_table(
        ui,
        &SavedTable { what: "claim-2013", of: TableOf::Nothing, partial: None },
        || sheets::claim(&claim),
        commands,
    );
}
