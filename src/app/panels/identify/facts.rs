//! What is known of a formula in words: its constants with their intervals and units, and where it holds.

use egui::{Label, RichText, Ui};

use super::search::FormulaSearch;
use crate::app::format;
use crate::app::theme::Palette;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::equation::number;
use crate::study::identify::gp::inspect::FormulaInspection;
use crate::study::identify::gp::range::{RangeCertificate, WIDER};

/// All of it.
pub fn show(ui: &mut Ui, search: &FormulaSearch, seen: &FormulaInspection) {
    constants(ui, seen);
    ui.add_space(6.0);
    ranges(ui, search, seen);
}

fn constants(ui: &mut Ui, seen: &FormulaInspection) {
    let palette = Palette::at(ui);
    ui.label(RichText::new("Constants with 95 % intervals").strong());
    if seen.constants.is_empty() {
        ui.weak("It has none.");
    }
    touch::grid(ui, "constants").num_columns(2).show(ui, |ui| {
        for (place, constant) in seen.constants.iter().enumerate() {
            let unit = match &seen.units {
                Ok(units) => units.get(place).cloned().flatten().unwrap_or_default(),
                Err(_) => String::new(),
            };
            let unit = if unit == "1" { String::new() } else { format::unit(&unit) };
            let value = format!("{} {unit}", number(constant.value));
            ui.label(value.trim_end()).on_hover_text(constant.value.to_string());
            match constant.interval {
                Some([low, high]) if constant.determined => {
                    ui.label(format!("{} to {}", number(low), number(high)));
                }
                Some([low, high]) => {
                    let text = format!("not determined: {} to {}", number(low), number(high));
                    Standing::Watch.label(ui, &text, |text| text);
                }
                None => {
                    Standing::Watch.label(ui, "not determined by these rows", |text| text);
                }
            }
            ui.end_row();
        }
    });
    if let Err(because) = &seen.units {
        let first = because.lines().next().unwrap_or_default();
        let text = format!("Units: {first}");
        ui.add(Label::new(RichText::new(text).small().color(palette.weak)).wrap());
    }
}

/// What a slope is called.
fn trend(slope: &str) -> &str {
    if slope == "uncertain" { "slope uncertain" } else { slope }
}

fn ranges(ui: &mut Ui, search: &FormulaSearch, seen: &FormulaInspection) {
    let palette = Palette::at(ui);
    ui.label(RichText::new("Where it holds").strong());
    let training = &seen.ranges.training;
    let reads = seen.formula.reads();
    let all = seen.ranges.inputs.iter().zip(&training.ranges).zip(&training.slopes).zip(reads);
    let mut outside = Vec::new();
    for (((name, [low, high]), slope), _) in all.filter(|(_, reads)| *reads) {
        let unit = format::unit(&search.asked.unit(name));
        let text = format!("{name} {} to {} {unit}: {}", number(*low), number(*high), trend(slope));
        ui.add(Label::new(text).wrap());
        outside.push(format!("{name} {}..{}", number(*low), number(*high)));
    }
    if !outside.is_empty() {
        let text = format!("Outside {} it says nothing.", outside.join(" or "));
        ui.add(Label::new(RichText::new(text).color(palette.weak)).wrap());
    }
    let unit = format::unit(&search.asked.unit(&search.problem().target));
    let finite = |certificate: &RangeCertificate| match (&certificate.values, certificate.finite) {
        (Some([low, high]), true) => {
            format!("certain to be finite, from {} to {} {unit}", number(*low), number(*high))
        }
        (_, true) => "certain to be finite".to_owned(),
        (_, false) => match certificate.not_finite.first() {
            Some(place) => format!("not certain to be finite: {}", place.why),
            None => "not certain to be finite".to_owned(),
        },
    };
    let text = format!("There it is {}.", finite(training).trim_end());
    Standing::either(training.finite).label(ui, &text, |text| text);
    let wide = &seen.ranges.widened;
    let beyond =
        format!("With {:.0} % more on each side: {}.", 100.0 * WIDER, finite(wide).trim_end());
    let standing = if wide.finite { Standing::Good } else { Standing::Watch };
    standing.label(ui, &beyond, |text| text);
}
