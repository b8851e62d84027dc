//! What is known of a formula in words: its constants with their intervals and units, and where it holds.

use egui::{Label, RichText, Ui};

use super::search::FormulaSearch;
use super::symbols::{column_words, told_number};
use crate::app::format;
use crate::app::theme::Palette;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::{decimal, tr};
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
    ui.label(RichText::new(tr("Constants with 95 % intervals")).strong());
    if seen.constants.is_empty() {
        ui.weak(tr("It has none."));
    }
    touch::grid(ui, "constants").num_columns(2).show(ui, |ui| {
        for (place, constant) in seen.constants.iter().enumerate() {
            let unit = match &seen.units {
                Ok(units) => units.get(place).cloned().flatten().unwrap_or_default(),
                Err(_) => String::new(),
            };
            let unit = if unit == "1" { String::new() } else { format::unit(&unit) };
            let value = format!("{} {unit}", told_number(constant.value));
            ui.label(value.trim_end()).on_hover_text(decimal(constant.value.to_string()));
            match constant.interval {
                Some([low, high]) if constant.determined => {
                    let [low, high] = [low, high].map(told_number);
                    ui.label(tr!("{low} to {high}", low = low, high = high));
                }
                Some([low, high]) => {
                    let [low, high] = [low, high].map(told_number);
                    let text = tr!("not determined: {low} to {high}", low = low, high = high);
                    Standing::Watch.label(ui, &text, |text| text);
                }
                None => {
                    Standing::Watch.label(ui, tr("not determined by these rows"), |text| text);
                }
            }
            ui.end_row();
        }
    });
    if let Err(because) = &seen.units {
        let first = because.lines().next().unwrap_or_default();
        let text = tr!("Units: {because}", because = first);
        ui.add(Label::new(RichText::new(text).small().color(palette.weak)).wrap());
    }
}

/// What a slope is called.
fn trend(slope: &str) -> &str {
    if slope == "uncertain" { tr("slope uncertain") } else { tr(slope) }
}

fn ranges(ui: &mut Ui, search: &FormulaSearch, seen: &FormulaInspection) {
    let palette = Palette::at(ui);
    ui.label(RichText::new(tr("Where it holds")).strong());
    let training = &seen.ranges.training;
    let reads = seen.formula.reads();
    let all = seen.ranges.inputs.iter().zip(&training.ranges).zip(&training.slopes).zip(reads);
    let mut outside = Vec::new();
    for (((name, [low, high]), slope), _) in all.filter(|(_, reads)| *reads) {
        let unit = format::unit(&search.asked.unit(name));
        let [low, high] = [*low, *high].map(told_number);
        let text = tr!(
            "{name} {low} to {high} {unit}: {trend}",
            name = column_words(name),
            low = low,
            high = high,
            unit = unit,
            trend = trend(slope)
        );
        ui.add(Label::new(text).wrap());
        outside.push(format!("{} {low}..{high}", column_words(name)));
    }
    if !outside.is_empty() {
        let outside = outside.join(tr(" or "));
        let text = tr!("Outside {ranges} it says nothing.", ranges = outside);
        ui.add(Label::new(RichText::new(text).color(palette.weak)).wrap());
    }
    let unit = format::unit(&search.asked.unit(&search.problem().target));
    let finite = |certificate: &RangeCertificate| match (&certificate.values, certificate.finite) {
        (Some([low, high]), true) => tr!(
            "certain to be finite, from {low} to {high} {unit}",
            low = told_number(*low),
            high = told_number(*high),
            unit = unit
        ),
        (_, true) => tr("certain to be finite").to_owned(),
        (_, false) => match certificate.not_finite.first() {
            Some(place) => tr!("not certain to be finite: {why}", why = tr(&place.why)),
            None => tr("not certain to be finite").to_owned(),
        },
    };
    let text = tr!("There it is {finite}.", finite = finite(training).trim_end());
    Standing::either(training.finite).label(ui, &text, |text| text);
    let wide = &seen.ranges.widened;
    let beyond = tr!(
        "With {percent:.0} % more on each side: {finite}.",
        percent = 100.0 * WIDER,
        finite = finite(wide).trim_end()
    );
    let standing = if wide.finite { Standing::Good } else { Standing::Watch };
    standing.label(ui, &beyond, |text| text);
}
