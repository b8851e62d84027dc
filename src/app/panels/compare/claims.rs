//! What the figures are worth: the bands, what was chosen with the table in view, what can't be
//! reached and why.

use egui::{RichText, Ui};

use crate::app::theme::{self, Palette};
use crate::app::widgets::standing::Standing;
use crate::base::language::tr;
use crate::study::compare::load_step::Transient;
use crate::study::compare::table_1::{DISCLOSED, NOT_REACHED, TOLD_BY_VERSION, margin, verdicts};
use crate::study::compare::tournament::Compared;

/// The sections below the table; the printed table belongs to it or not.
pub fn show(ui: &mut Ui, compared: &[Compared], transients: &[Transient], belongs: bool) {
    let palette = Palette::at(ui);
    ui.add_space(8.0);
    if !belongs {
        let text =
            tr("Table 1 of 2005 belongs to Experiment 2 in Ck45 at 40 ms dead time: beside \
                       anything else its figures are not shown.");
        ui.label(RichText::new(text).color(palette.weak));
        return;
    }
    let verdicts = verdicts(compared);
    let found = !verdicts.is_empty() && compared.iter().all(|one| one.runs > 0);
    ui.heading(tr("Beside Table 1 of 2005"));
    if found {
        let met = verdicts.iter().filter(|verdict| verdict.kept()).count();
        let all_kept = met == verdicts.len();
        let standing = if all_kept { Standing::Good } else { Standing::Watch };
        let text = tr!("{met} of {n} bands kept", met = met, n = verdicts.len());
        standing.label(ui, &text, RichText::strong);
        for verdict in &verdicts {
            let mark = if verdict.kept() { tr("kept") } else { tr("not reached") };
            ui.horizontal_wrapped(|ui| {
                Standing::either(verdict.kept()).label(ui, mark, RichText::strong);
                ui.label(&verdict.band);
                let found = tr!("found {found}", found = &verdict.found);
                ui.label(RichText::new(found).color(palette.weak));
            });
        }
    } else {
        ui.label(tr("The bands are judged when the six methods of the table have run."));
    }
    if let Some(margin) = margin(compared, transients) {
        ui.label(margin);
    }
    list(ui, tr("Chosen with the table in view"), DISCLOSED);
    list(ui, tr("Not reached, and why"), NOT_REACHED);
}

fn list(ui: &mut Ui, title: &str, lines: &[&str]) {
    ui.add_space(6.0);
    theme::card(Palette::at(ui)).show(ui, |ui| {
        ui.set_width(ui.available_width());
        let version = TOLD_BY_VERSION;
        ui.strong(tr!("{title} (figures of version {version})", title = title, version = version));
        for line in lines {
            // The program's own words write the unit in plain letters; those of a catalogue have its sign.
            let text = match tr(line) {
                own if own == *line => own.replace("um", "µm"),
                other => other.to_owned(),
            };
            ui.label(format!("• {text}"));
        }
    });
}
