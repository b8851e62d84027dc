//! The picture of a revolution: forces against angle or time, the last control period shaded, its
//! peak marked.

use egui::{RichText, Role, Ui, WidgetInfo};
use egui_plot::{
    GridInput, GridMark, HLine, HoverPosition, Line, MarkerShape, PlotPoints, Points, Polygon,
    VLine,
};

use super::{Axis, DESIRED, LINES, RevolutionWindow};
use crate::app::format;
use crate::app::panels::View;
use crate::app::theme::{self, Look, Palette};
use crate::app::widgets::focus::pointer_only;
use crate::app::widgets::plot::{grid, near, still, tick};
use crate::app::widgets::zoom::{by_touch, zoom};
use crate::base::language::tr;
use crate::base::units::ms_from_s;
use crate::run::revolution::{Revolution, RevolutionSample};

/// Distance between grid lines that is wanted, points.
const GRID: [f32; 2] = [70.0, 30.0];

/// Distances between lines of angle, degrees: whole parts of a turn.
const ANGLES_DEG: [f64; 8] = [1.0, 5.0, 10.0, 15.0, 30.0, 45.0, 90.0, 180.0];

/// Grid lines of the horizontal axis, about `count` of them.
fn lines_along(axis: Axis, input: GridInput, count: f32) -> Vec<GridMark> {
    if axis == Axis::Time {
        return grid(input, count);
    }
    let (low, high) = input.bounds;
    let wanted = (high - low) / f64::from(count.max(1.0));
    let step = ANGLES_DEG.into_iter().find(|step| *step >= wanted).unwrap_or(360.0);
    let (first, last) = ((low / step).ceil() as i64, (high / step).floor() as i64);
    (first..=last).map(|k| GridMark { value: k as f64 * step, step_size: step }).collect()
}

/// A place on the horizontal axis as its scale counts it: angles begin again with every turn.
fn scale(axis: Axis, place: f64) -> f64 {
    if axis == Axis::Angle { place.rem_euclid(360.0) } else { place }
}

/// Places of the samples on the horizontal axis: degrees that go on growing, or ms.
fn places(samples: &[RevolutionSample], axis: Axis) -> Vec<f64> {
    let Some(first) = samples.first() else { return Vec::new() };
    let (mut turns, mut before_deg) = (0.0, first.angle_deg);
    let place = |sample: &RevolutionSample| match axis {
        Axis::Time => ms_from_s(sample.time_s - first.time_s),
        Axis::Angle => {
            if sample.angle_deg < before_deg {
                turns += 360.0;
            }
            before_deg = sample.angle_deg;
            turns + sample.angle_deg
        }
    };
    samples.iter().map(place).collect()
}

impl RevolutionWindow {
    pub(super) fn picture(&mut self, ui: &mut Ui, view: &View<'_>) {
        let Some(shown) = &self.shown else { return };
        let palette = Palette::at(ui);
        let axis = self.axis;
        let unit = if self.axis == Axis::Angle { "deg" } else { "ms" };
        let places = places(&shown.samples, self.axis);
        let [Some(&from), Some(&to)] = [places.first(), places.last()] else { return };
        let reference_n = view.session.row().force_ref_n;
        let values: [fn(&RevolutionSample) -> f64; 4] = [
            RevolutionSample::fxy_n,
            |sample| sample.fx_n,
            |sample| sample.fy_n,
            |sample| sample.fz_n,
        ];
        let (mut low, mut high) = (0.0_f64, reference_n);
        let mut lines = Vec::new();
        // Across last: it is drawn on top.
        for i in (0..LINES.len()).rev().filter(|i| !self.hidden[*i]) {
            let points: Vec<[f64; 2]> = places
                .iter()
                .zip(&shown.samples)
                .map(|(x, sample)| [*x, values[i](sample)])
                .collect();
            (low, high) = points.iter().fold((low, high), |(l, h), [_, y]| (l.min(*y), h.max(*y)));
            let (stroke, style) = LINES[i].1.line(palette);
            let line = Line::new(tr(LINES[i].0), PlotPoints::from(points));
            lines.push(line.stroke(stroke).style(style).allow_band(false));
        }
        let margin = 0.08 * (high - low).max(1.0);
        let (low, high) = (low - margin, high + margin);
        let range = self.zoomed.unwrap_or([from, to]);
        let old = self.repeat.as_ref().is_none_or(|(of, _)| *of != view.session.changes());
        let mut text = summary(shown);
        if old {
            text.push(' ');
            text.push_str(tr("Before the last change; the new picture is being made."));
        }
        ui.label(RichText::new(text).small().color(palette.weak));
        let window = shown.window_from.and_then(|i| places.get(i)).map(|x| {
            let corners = vec![[*x, low], [to, low], [to, high], [*x, high]];
            let fill = palette.accent.gamma_multiply(0.10);
            let polygon = Polygon::new("", PlotPoints::from(corners)).allow_hover(false);
            polygon.fill_color(fill).stroke(egui::Stroke::NONE)
        });
        let peak = shown.peak.map(|i| {
            let at = vec![[places[i], shown.samples[i].fxy_n()]];
            let marker = Points::new(tr("Peak of the control period"), PlotPoints::from(at));
            marker.shape(MarkerShape::Diamond).radius(6.0).color(palette.bad)
        });
        let label = move |hover: &HoverPosition<'_>| {
            let (name, position) = near(hover)?;
            let at = format::quantity(scale(axis, position.x), unit);
            Some(format!("{name}: {}\n{at}", format::quantity(position.y, "N")))
        };
        let size = egui::vec2(
            ui.available_width(),
            ui.available_height().max(theme::PLOT_HEIGHT_SCROLLED),
        );
        let sense = pointer_only(!by_touch(ui));
        let response = still("revolution", palette, [size.x, size.y])
            .allow_zoom([true, false])
            .sense(sense)
            .x_grid_spacer(move |input| lines_along(axis, input, size.x / GRID[0]))
            .y_grid_spacer(move |input| grid(input, size.y / GRID[1]))
            .x_axis_formatter(move |mark, _| {
                let value = scale(axis, mark.value);
                format!("{} {}", tick(GridMark { value, ..mark }), format::unit(unit))
            })
            .y_axis_formatter(|mark, _| format!("{} N", tick(mark)))
            .label_formatter(label)
            .show(ui, |plot| {
                plot.set_plot_bounds_x(range[0]..=range[1]);
                plot.set_plot_bounds_y(low..=high);
                window.into_iter().for_each(|window| plot.polygon(window));
                let (stroke, style) = Look::Reference.line(palette);
                plot.hline(HLine::new(tr(DESIRED), reference_n).stroke(stroke).style(style));
                lines.into_iter().for_each(|line| plot.line(line));
                peak.into_iter().for_each(|peak| plot.points(peak));
                let now = VLine::new("", to).allow_hover(false);
                plot.vline(now.color(palette.playhead).width(1.0));
            });
        response.response.widget_info(|| {
            let [from, to] = range.map(|place| format::quantity(place, unit));
            let label = tr!("Forces from {from} to {to}", from = from, to = to);
            WidgetInfo::labeled(Role::Figure, true, label)
        });
        if let Some(range) = zoom(ui, &response, range, &mut self.drag) {
            self.zoomed = Some(range);
        } else if response.response.double_clicked() {
            self.zoomed = None;
        }
    }
}

/// What is seen, in words.
fn summary(shown: &Revolution) -> String {
    let Some(last) = shown.samples.last() else { return String::new() };
    let n = shown.samples.len();
    let Some(peak) = shown.peak.map(|i| &shown.samples[i]) else {
        return tr!("{n} samples up to {time:.3} s", n = n, time = last.time_s);
    };
    let force = format::quantity(peak.fxy_n(), "N");
    let angle = format::quantity(peak.angle_deg, "deg");
    tr!(
        "{n} samples up to {time:.3} s. Peak of the last control period (shaded): {force} at {angle}; with \
         the sensor's noise it is what the controller sees.",
        n = n,
        time = last.time_s,
        force = force,
        angle = angle
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_go_on_growing_and_times_start_at_zero() {
        let sample = |time_s: f64, angle_deg: f64| RevolutionSample {
            time_s,
            angle_deg,
            fx_n: 0.0,
            fy_n: 0.0,
            fz_n: 0.0,
        };
        let samples = [sample(1.0, 350.0), sample(1.001, 5.0), sample(1.002, 20.0)];
        assert_eq!(places(&samples, Axis::Angle), [350.0, 365.0, 380.0]);
        let times = places(&samples, Axis::Time);
        assert!(times[0] == 0.0 && (times[2] - 2.0).abs() < 1e-9, "{times:?}");
        assert!(places(&[], Axis::Time).is_empty());
    }
}
