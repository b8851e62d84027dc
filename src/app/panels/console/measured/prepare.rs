//! What is done with a channel before it is laid over the plots, as the command `measured` does it.

use egui::{CollapsingHeader, Ui, WidgetInfo};

use super::{choice, position};
use crate::app::widgets::number::NumberField;
use crate::base::language::tr;
use crate::measured::signal::Preparation;

/// Values of the fields at first: idle times before and behind the cut, s; cut-off, Hz; angle, degrees; period, s, that of
/// the papers' control.
const IDLE_S: [f64; 2] = [0.0, 0.5];
const CUT_OFF_HZ: f64 = 100.0;
const PERIOD_S: f64 = 0.02;
/// Ranges of times, s, cut-offs, Hz, angles, degrees, and periods, s.
const TIMES: [f64; 2] = [-1e6, 1e6];
const CUT_OFFS: [f64; 2] = [0.001, 1e6];
const ANGLES: [f64; 2] = [-360.0, 360.0];
const PERIODS: [f64; 2] = [0.0001, 100.0];

/// What the fields had when they were switched off.
#[derive(Default)]
pub struct PrepareFields {
    last: Preparation,
}

/// A number with its name, unit and range.
struct Number<'a>(&'a str, &'static str, [f64; 2]);

impl PrepareFields {
    /// Shows them.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        channels: &[String],
        preparation: &mut Preparation,
        said: &mut Option<String>,
    ) {
        let header = CollapsingHeader::new(tr("Preparation")).id_salt("Preparation");
        header.show_unindented(ui, |ui| {
            let mut next = preparation.clone();
            self.spans(ui, &mut next, said);
            self.axes(ui, channels, &mut next, said);
            switched(
                ui,
                tr("Low-pass filter, without a shift in time"),
                (&mut next.low_pass_hz, &mut self.last.low_pass_hz),
                || CUT_OFF_HZ,
                |ui, cut_off_hz| {
                    number(ui, &Number(tr("Cut-off"), "Hz", CUT_OFFS), cut_off_hz, said)
                },
            );
            self.peaks(ui, channels, &mut next, said);
            *preparation = next;
        });
    }

    /// Zero and drift.
    fn spans(&mut self, ui: &mut Ui, next: &mut Preparation, said: &mut Option<String>) {
        switched(
            ui,
            tr("Zero before the cut"),
            (&mut next.idle_s, &mut self.last.idle_s),
            || IDLE_S,
            |ui, times| span(ui, tr("before the cut"), times, said),
        );
        if next.idle_s.is_none() {
            next.idle_later_s = None;
            return;
        }
        switched(
            ui,
            tr("Drift, by a time behind the cut"),
            (&mut next.idle_later_s, &mut self.last.idle_later_s),
            || IDLE_S,
            |ui, times| span(ui, tr("behind the cut"), times, said),
        );
    }

    /// The axes of the dynamometer.
    fn axes(
        &mut self,
        ui: &mut Ui,
        channels: &[String],
        next: &mut Preparation,
        said: &mut Option<String>,
    ) {
        let Some((x, y)) = two(channels) else { return };
        switched(
            ui,
            tr("Turn two forces into the machine's axes"),
            (&mut next.rotation, &mut self.last.rotation),
            || (x.clone(), y.clone(), 0.0),
            |ui, (x, y, angle_deg)| {
                one_of(ui, tr("Force x of the dynamometer"), channels, x);
                one_of(ui, tr("Force y of the dynamometer"), channels, y);
                number(ui, &Number(tr("Angle to X"), "deg", ANGLES), angle_deg, said);
            },
        );
    }

    /// Peaks of control periods.
    fn peaks(
        &mut self,
        ui: &mut Ui,
        channels: &[String],
        next: &mut Preparation,
        said: &mut Option<String>,
    ) {
        let Some((x, y)) = two(channels) else { return };
        let mut period_s = next.period_s.or(self.last.period_s).unwrap_or(PERIOD_S);
        switched(
            ui,
            tr("Largest force across the tool in every period"),
            (&mut next.peaks, &mut self.last.peaks),
            || (x.clone(), y.clone()),
            |ui, (x, y)| {
                one_of(ui, tr("Force along x"), channels, x);
                one_of(ui, tr("Force along y"), channels, y);
                number(ui, &Number(tr("Period"), "s", PERIODS), &mut period_s, said);
            },
        );
        self.last.period_s = Some(period_s);
        next.period_s = next.peaks.as_ref().map(|_| period_s);
    }
}

/// The first two channels.
fn two(channels: &[String]) -> Option<(String, String)> {
    match channels {
        [x, y, ..] => Some((x.clone(), y.clone())),
        [] | [_] => None,
    }
}

/// A step that is switched on and off, with its values below it; what they were is there again when it is switched on.
fn switched<T: Clone>(
    ui: &mut Ui,
    name: &str,
    (value, last): (&mut Option<T>, &mut Option<T>),
    first: impl FnOnce() -> T,
    show: impl FnOnce(&mut Ui, &mut T),
) {
    let mut on = value.is_some();
    if ui.checkbox(&mut on, name).changed() {
        if on {
            *value = Some(last.clone().unwrap_or_else(first));
        } else {
            *last = value.take();
        }
    }
    if let Some(value) = value {
        ui.indent(name, |ui| show(ui, value));
    }
}

/// Two times.
fn span(ui: &mut Ui, of: &str, [from_s, to_s]: &mut [f64; 2], said: &mut Option<String>) {
    let [from, to] = [tr!("From, {time}", time = of), tr!("To, {time}", time = of)];
    number(ui, &Number(&from, "s", TIMES), from_s, said);
    number(ui, &Number(&to, "s", TIMES), to_s, said);
}

fn one_of(ui: &mut Ui, name: &str, channels: &[String], chosen: &mut String) {
    if let Some(place) = choice(ui, name, channels, position(channels, chosen)) {
        chosen.clone_from(&channels[place]);
    }
}

fn number(ui: &mut Ui, of: &Number<'_>, value: &mut f64, said: &mut Option<String>) {
    let Number(name, unit, range) = *of;
    let suffix = format!(" {}", crate::app::format::unit(unit));
    let field = NumberField {
        name,
        unit,
        range,
        // Typed alone: all samples are gone through again for every value.
        speed: 0.0,
        decimals: 4,
        least: 0,
        suffix: &suffix,
    };
    ui.horizontal(|ui| {
        let response = field.show(ui, value, said);
        response.widget_info(|| WidgetInfo {
            label: Some(name.to_owned()),
            ..WidgetInfo::drag_value(true, *value)
        });
        ui.label(name);
    });
}
