//! Table 1 of the 2019 paper beside its own rules, what its equations give, and what of it can be
//! reproduced.

use egui::{RichText, TextWrapMode, Ui};

use super::sheets;
use crate::app::command::{Command, ShellCommand};
use crate::app::format;
use crate::app::theme::{self, Palette};
use crate::app::widgets::save_table::{SavedTable, TableOf, save_table};
use crate::app::widgets::scaffold;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::{decimal, text, tr};
use crate::study::papers_2019::{NOT_REPRODUCED, REPRODUCED, table};

/// A number of any size as the paper prints it.
fn scientific(value: f64) -> String {
    if (0.1..1e5).contains(&value) {
        format!("{value:.0}")
    } else {
        decimal(format!("{value:.2e}"))
    }
}

/// The section above the errata; `measured` is what the equations give.
pub fn show(ui: &mut Ui, measured: &[String], commands: &mut Vec<Command>) {
    let palette = Palette::at(ui);
    ui.add_space(4.0);
    let text = tr("Springs k = m (2 π f)², dampers c = √(k m) / Q: printed, then by the rule.");
    ui.label(RichText::new(text).color(palette.weak));
    scaffold::across(ui, "table 2019", |ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
        touch::grid(ui, "table 2019").striped(true).spacing([16.0, 4.0]).show(ui, |ui| {
            ui.strong(tr("Node"));
            for title in ["m [kg]", "f [Hz]", "Q", "k [N/m]", "c [N s/m]"] {
                ui.strong(title);
            }
            ui.strong(tr("Verdict"));
            ui.end_row();
            for row in table() {
                ui.strong(tr(row.node));
                ui.label(scientific(row.mass_kg));
                ui.label(scientific(row.frequency_hz));
                ui.label(decimal(row.quality.to_string()));
                let pairs = [
                    (row.stiffness_printed_n_m, row.stiffness_rule_n_m),
                    (row.damping_printed_n_s_m, row.damping_rule_n_s_m),
                ];
                for ((printed, rule), agrees) in pairs.into_iter().zip(row.agrees) {
                    let text = tr!(
                        "{printed}, rule {rule}",
                        printed = scientific(printed),
                        rule = scientific(rule),
                    );
                    Standing::judged(false, !agrees).label(ui, &text, |text| text);
                }
                let fine = row.agrees == [true; 2];
                let standing = if fine { Standing::Good } else { Standing::Watch };
                standing.label(ui, tr(row.verdict_text), |text| text);
                ui.end_row();
            }
        });
    });
    ui.horizontal_wrapped(|ui| {
        save_table(
            ui,
            &SavedTable { what: "table-2019", of: TableOf::Nothing, partial: None },
            sheets::machine,
            commands,
        );
        if ui.button(tr("Open Machine")).clicked() {
            commands.push(Command::Shell(ShellCommand::ShowScreen("machine")));
        }
    });
    let measured: Vec<&str> = measured.iter().map(String::as_str).collect();
    for (title, lines) in [
        (text!("What the equations give"), measured.as_slice()),
        (text!("Reproduced"), REPRODUCED),
        (text!("Not reproduced, and why"), NOT_REPRODUCED),
    ] {
        ui.add_space(6.0);
        theme::card(palette).show(ui, |ui| {
            ui.set_width(ui.available_width());
            ui.strong(tr(title));
            for line in lines {
                ui.label(format::typeset(&format!("• {}", tr(line))));
            }
        });
    }
}
