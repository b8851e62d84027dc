//! The formula that is looked at: as printed and as a tree, its constants, where it holds, how it fits, and what can be
//! done with it.

use egui::{Label, RichText, Role, Ui, WidgetInfo};

use super::places::Places;
use super::search::{FormulaSearch, Seen};
use super::symbols::{in_language, rounded, symbols};
use super::{actions, facts, fit_plots, tree};
use crate::app::command::Command;
use crate::app::panels::View;
use crate::app::panels::equation_cards::formula::typeset;
use crate::app::theme::{self, Palette};
use crate::app::widgets::standing::Standing;
use crate::base::language::tr;

/// From this width on, points, words and pictures stand beside each other.
const BESIDE_FROM: f32 = 720.0;
/// Size of the formula, points.
const FORMULA: f32 = 16.0;
/// Digits of its numbers; the pointer is told all, and so are copies and files.
const DIGITS: usize = 6;

/// All of it.
pub fn show(
    ui: &mut Ui,
    search: &mut FormulaSearch,
    places: &mut Places,
    view: &View<'_>,
    commands: &mut Vec<Command>,
) {
    let palette = Palette::at(ui);
    let Some(Seen { row, found, .. }) = search.inspect() else { return };
    let title = match (row.chosen, search.report().is_some()) {
        (true, _) => tr!("Formula of size {size}, the one chosen", size = row.size),
        (false, true) => tr!("Formula of size {size}", size = row.size),
        (false, false) => tr!("Formula of size {size}, so far", size = row.size),
    };
    theme::card(palette).show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.label(RichText::new(title).strong());
        let seen = match found {
            Ok(seen) => seen,
            Err(because) => {
                Standing::Bad.label(ui, &because, |text| text);
                return;
            }
        };
        let problem = search.problem();
        let names: Vec<&str> =
            problem.inputs.iter().chain([&problem.target]).map(String::as_str).collect();
        let words = symbols(&names);
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        let (inputs, target) = words.split_at(problem.inputs.len());
        let target = target.first().copied().unwrap_or_default();
        let equation = rounded(&seen.formula, DIGITS).equation(inputs);
        let equation = in_language(&format!("{target} = {equation}"));
        let set = typeset(&equation, FORMULA, theme::note(ui.ctx()).size, palette.text);
        let response = ui.add(Label::new(set).wrap());
        let said = equation.clone();
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, said.clone()));
        let all = tr!("With all digits: {formula}", formula = seen.formula.to_string());
        response.on_hover_text(all);
        if !row.doubt.is_empty() {
            let text = tr!("Unsure: {doubt}.", doubt = tr(row.doubt));
            Standing::Watch.label(ui, &text, |text| text);
        }
        if row.exact {
            Standing::Good.label(ui, tr("Exact but for rounding."), |text| text);
        }
        actions::show(ui, search, &seen, places, view, commands);
        ui.add_space(4.0);
        if ui.available_width() >= BESIDE_FROM {
            // Columns spread the words of a line over their width.
            ui.columns_const(|[left, right]| {
                left.vertical(|ui| {
                    facts::show(ui, search, &seen);
                    ui.add_space(6.0);
                    tree::show(ui, seen.formula.root(), inputs);
                });
                right.vertical(|ui| fit_plots::show(ui, search, &seen));
            });
        } else {
            facts::show(ui, search, &seen);
            tree::show(ui, seen.formula.root(), inputs);
            fit_plots::show(ui, search, &seen);
        }
    });
}
