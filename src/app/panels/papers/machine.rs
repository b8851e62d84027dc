//! Table 1 of the 2019 paper beside its own rules, what its equations give, and what of it can be
//! reproduced.

use egui::{RichText, ScrollArea, TextWrapMode, Ui};

use super::sheets;
use crate::app::command::{Command, ShellCommand};
use crate::app::theme::{self, Palette};
use crate::app::widgets::save_table::save_table;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::study::papers_2019::{NOT_REPRODUCED, REPRODUCED, table};

/// A number of any size as the paper prints it.
fn scientific(value: f64) -> String {
    if (0.1..1e5).contains(&value) { format!("{value:.0}") } else { format!("{value:.2e}") }
}

/// The section above the errata; `measured` is what the equations give.
pub fn show(ui: &mut Ui, measured: &[String], commands: &mut Vec<Command>) {
    let palette = Palette::at(ui);
    ui.add_space(4.0);
    ui.label(
        RichText::new("Springs k = m (2 π f)², dampers c = √(k m) / Q: printed, then by the rule.")
            .color(palette.weak),
    );
    ScrollArea::horizontal().id_salt("table 2019").show(ui, |ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
        touch::grid(ui, "table 2019").striped(true).spacing([16.0, 4.0]).show(ui, |ui| {
            for title in ["Node", "m [kg]", "f [Hz]", "Q", "k [N/m]", "c [N s/m]", "Verdict"] {
                ui.strong(title);
            }
            ui.end_row();
            for row in table() {
                ui.strong(row.node);
                ui.label(scientific(row.mass_kg));
                ui.label(scientific(row.frequency_hz));
                ui.label(format!("{}", row.quality));
                let pairs = [
                    (row.stiffness_printed_n_m, row.stiffness_rule_n_m),
                    (row.damping_printed_n_s_m, row.damping_rule_n_s_m),
                ];
                for ((printed, rule), agrees) in pairs.into_iter().zip(row.agrees) {
                    let text = format!("{}, rule {}", scientific(printed), scientific(rule));
                    Standing::judged(false, !agrees).label(ui, &text, |text| text);
                }
                let fine = row.agrees == [true; 2];
                let standing = if fine { Standing::Good } else { Standing::Watch };
                standing.label(ui, row.verdict_text, |text| text);
                ui.end_row();
            }
        });
    });
    ui.horizontal_wrapped(|ui| {
        save_table(ui, "table-2019", sheets::machine, commands);
        if ui.button("Open Machine").clicked() {
            commands.push(Command::Shell(ShellCommand::ShowScreen("machine")));
        }
    });
    let measured: Vec<&str> = measured.iter().map(String::as_str).collect();
    for (title, lines) in [
        ("What the equations give", measured.as_slice()),
        ("Reproduced", REPRODUCED),
        ("Not reproduced, and why", NOT_REPRODUCED),
    ] {
        ui.add_space(6.0);
        theme::card(palette).show(ui, |ui| {
            ui.set_width(ui.available_width());
            ui.strong(title);
            for line in lines {
                ui.label(format!("• {line}"));
            }
        });
    }
}
