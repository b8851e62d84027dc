//! Where a channel lies over the signal: its shift in time and its scale, found or put by hand, and what is left.

use egui::{RichText, Ui, WidgetInfo};

use crate::app::format;
use crate::app::overlay::Overlay;
use crate::app::theme::Palette;
use crate::app::widgets::number::NumberField;
use crate::app::widgets::standing::Standing;
use crate::base::language::{fixed, tr};
use crate::run::signals::signal;
use crate::study::over_run::{OverRun, OverRunFit};

/// Shifts that can be put, s; scales, either way; offsets.
const SHIFTS: [f64; 2] = [-1e6, 1e6];
const SCALES: [f64; 2] = [-1e6, 1e6];
const OFFSETS: [f64; 2] = [-1e9, 1e9];
/// Least size of a scale.
const LEAST_SCALE: f64 = 1e-6;

/// Shows it.
pub fn show(ui: &mut Ui, overlay: &mut Overlay, said: &mut Option<String>) {
    match overlay.prepared() {
        Some(Err(why)) => {
            let why = why.to_owned();
            Standing::Bad.label(ui, &why, |text| text);
            return;
        }
        None => {
            ui.label(tr("The channel is being worked out."));
            return;
        }
        Some(Ok(_)) => {}
    }
    let unit = signal(overlay.choice.signal).map_or("", |signal| signal.unit);
    let before = overlay.place();
    let (mut place, mut now) = (before, None);
    ui.horizontal_wrapped(|ui| {
        let help = tr(
            "Finds the shift at which both go together most, and there scale and offset, as steadycut measured does",
        );
        if ui.button(tr("Align")).on_hover_text(help).clicked() {
            overlay.align();
        }
        let help = tr("Shift 0 s, scale 1, offset 0");
        if ui.button(tr("As measured")).on_hover_text(help).clicked() {
            place = OverRun::default();
        }
    });
    field(ui, (tr("Shift"), "s", SHIFTS), 0.01, &mut place.shift_s, &mut now).on_hover_text(tr(
        "By so much the measurement is later than the run: it is drawn earlier by that",
    ));
    let mut scale = place.scale;
    field(ui, (tr("Scale"), "", SCALES), 0.002, &mut scale, &mut now).on_hover_text(tr(
        "The run times this is what was measured: the line is drawn divided by it",
    ));
    if scale.abs() >= LEAST_SCALE {
        place.scale = scale;
    } else if scale != before.scale {
        now = Some(tr!(
            "Scale: {value} cannot be: allowed is any number but 0, of a size from {least} on",
            value = scale,
            least = LEAST_SCALE
        ));
    }
    field(ui, (tr("Offset"), unit, OFFSETS), 0.1, &mut place.offset, &mut now)
        .on_hover_text(tr("What the measurement has in addition, after the scale"));
    // What was said of a field goes with the next change.
    if now.is_some() || place != before {
        *said = now;
    }
    overlay.put(place);
    told(ui, overlay, unit);
}

/// How well it lies there.
fn told(ui: &mut Ui, overlay: &Overlay, unit: &str) {
    if let Some(why) = overlay.not_aligned() {
        let text = tr!("Not aligned: {why}. It can be moved by hand.", why = why);
        Standing::Watch.label(ui, &text, |text| text);
    }
    let weak = Palette::at(ui).weak;
    let Some(OverRunFit { place: _, correlation, rest, samples }) = overlay.fit() else {
        let text = match overlay.is_at_work() {
            true => tr("It is aligned as soon as the cut is worked out."),
            false => tr("It has nothing in common with the cut here."),
        };
        ui.label(RichText::new(text).color(weak));
        return;
    };
    let how = match overlay.is_by_hand() {
        true => tr("by hand"),
        false => tr("aligned"),
    };
    ui.label(tr!(
        "{how}: what is left, rms {rest} over {samples} samples; correlation {correlation}",
        how = how,
        rest = format::beside(fixed(rest, 4), &format::unit(unit)),
        samples = samples,
        correlation = fixed(correlation, 4)
    ));
}

/// A field behind its name.
fn field(
    ui: &mut Ui,
    (name, unit, range): (&str, &str, [f64; 2]),
    speed: f64,
    value: &mut f64,
    said: &mut Option<String>,
) -> egui::Response {
    let suffix = if unit.is_empty() { String::new() } else { format!(" {}", format::unit(unit)) };
    let field = NumberField { name, unit, range, speed, decimals: 6, least: 0, suffix: &suffix };
    ui.horizontal(|ui| {
        ui.set_min_width(ui.available_width().min(300.0));
        let before = *value;
        let mut shown = before;
        let response = field.show(ui, &mut shown, said);
        // The field shows six digits behind the point; what lies behind them stays.
        if (shown - before).abs() > 5e-7 {
            *value = shown;
        }
        response.widget_info(|| WidgetInfo {
            label: Some(name.to_owned()),
            ..WidgetInfo::drag_value(true, shown)
        });
        ui.label(name);
        response
    })
    .inner
}
