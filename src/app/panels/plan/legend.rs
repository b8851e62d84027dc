//! The legend of the map, which shows and hides its layers, and what stands behind a constraint.

use egui::{Color32, Painter, Rect, RichText, Stroke, Ui, vec2};

use super::layers::{Layers, MapLayer};
use super::marks;
use super::search::Found;
use crate::app::format;
use crate::app::theme::{Look, Palette};
use crate::app::widgets::legend;
use crate::base::language::{text, tr};
use crate::study::plan::constraints::{Checked, ORIGIN};
use crate::study::plan::machine::Source;

/// The legend.
pub fn show(ui: &mut Ui, layers: &mut Layers, found: &Found, programmed_text: &str) {
    let palette = Palette::at(ui);
    let checked = &found.optimum().constraints;
    let boundaries = |number: usize| found.picture.boundary(number);
    let spacing = ui.spacing().clone();
    ui.spacing_mut().item_spacing = vec2(12.0, 1.0);
    ui.spacing_mut().interact_size.y = 14.0;
    legend::row(ui, text!("the map"), |ui| {
        for (number, one) in checked.iter().enumerate() {
            let layer = MapLayer::Boundary(number);
            if boundaries(number).lines.is_empty() {
                continue;
            }
            let (label, look) = (tr(one.constraint.label), Look::Constraint(number));
            let entry = legend::entry(ui, label, look, !layers.show(layer));
            entry.response.on_hover_ui(|ui| explain(ui, one));
            if entry.pressed {
                layers.toggle(layer);
            }
        }
        let mut mark = |layer: MapLayer, name: &str, paint: &dyn Fn(&Painter, Rect, Color32)| {
            let off = !layers.show(layer);
            if legend::entry_of(ui, name, off, palette.text, paint).pressed {
                layers.toggle(layer);
            }
        };
        mark(MapLayer::ForceLines, tr("equal force"), &|painter, rect, color| {
            let color = color.gamma_multiply(0.5);
            painter.hline(rect.x_range(), rect.center().y, Stroke::new(1.0, color));
        });
        mark(MapLayer::Particles, tr("particles (full: allowed)"), &|painter, rect, _| {
            marks::particle(painter, rect.center() - vec2(4.0, 0.0), true, palette);
            marks::particle(painter, rect.center() + vec2(5.0, 0.0), false, palette);
        });
        mark(MapLayer::OwnBests, tr("their own bests"), &|painter, rect, _| {
            marks::own_best(painter, rect.center(), palette);
        });
        mark(MapLayer::Best, tr("best of all"), &|painter, rect, _| {
            marks::best(painter, rect.center(), true, palette);
        });
        mark(MapLayer::Programmed, programmed_text, &|painter, rect, _| {
            marks::programmed(painter, rect.center(), palette);
        });
        if found.fixed_speed_m_min().is_some() {
            legend::sample(ui, tr("the speed searched"), Look::Searched);
        }
    });
    ui.horizontal_wrapped(|ui| {
        let absent = checked.iter().enumerate();
        let mut absent = absent.filter(|(i, _)| boundaries(*i).lines.is_empty()).peekable();
        if absent.peek().is_some() {
            ui.label(RichText::new(tr("Outside the map:")).small().color(palette.weak));
        }
        for (number, one) in absent {
            let constraint = tr(one.constraint.label);
            let name = match boundaries(number).kept_somewhere {
                true => constraint.to_owned(),
                false => tr!("{constraint} (violated)", constraint = constraint),
            };
            legend::sample(ui, &name, Look::Constraint(number)).on_hover_ui(|ui| explain(ui, one));
        }
    });
    *ui.spacing_mut() = spacing;
}

/// A limit without digits that say nothing.
fn plain(value: f64) -> String {
    let text = format::fine(value, "");
    if text.contains(['.', ',']) {
        text.trim_end_matches('0').trim_end_matches(['.', ',']).to_owned()
    } else {
        text
    }
}

/// The limits of a constraint, without their unit.
#[must_use]
pub fn limits(checked: &Checked) -> String {
    match (checked.low, checked.high) {
        (Some(low), Some(high)) => tr!("{low} to {high}", low = plain(low), high = plain(high)),
        (Some(low), None) => format!("≥ {}", plain(low)),
        (None, Some(high)) => format!("≤ {}", plain(high)),
        (None, None) => tr("none").to_owned(),
    }
}

/// Where the limits of a constraint come from, in words.
#[must_use]
pub fn source(source: Source) -> &'static str {
    match source {
        Source::Placeholder => tr("placeholder: no public data of this machine were found"),
        Source::Chosen => tr("a chosen limit of the process"),
        Source::Given => tr("given by the settings or a data sheet"),
    }
}

/// Formula, reason, limits and origin of a constraint.
pub fn explain(ui: &mut Ui, checked: &Checked) {
    let palette = Palette::at(ui);
    let constraint = &checked.constraint;
    ui.set_max_width(340.0);
    ui.label(RichText::new(constraint.formula).monospace());
    ui.label(tr(constraint.why));
    ui.label(tr!(
        "Limit: {limits} {unit} ({source}).",
        limits = limits(checked),
        unit = format::unit(constraint.unit),
        source = source(checked.source),
    ));
    let origin = tr!("The constraint is {origin}.", origin = tr(ORIGIN));
    ui.label(RichText::new(origin).color(palette.weak));
}
