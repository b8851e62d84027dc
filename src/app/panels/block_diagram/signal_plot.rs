//! The plot of one wire: the last part of the run up to the playhead.

use egui::{Label, RichText};
use egui_plot::{Line, PlotPoints};

use super::moment::Now;
use crate::app::format;
use crate::app::session::Session;
use crate::app::theme::{Look, Palette};
use crate::app::widgets::plot::{pieces, still, tick};
use crate::base::language::tr;
use crate::run::diagram::Wire;
use crate::run::signals::{SIGNALS, SignalInfo, signal};

/// Length of the plotted part, s.
const WINDOW_S: f64 = 10.0;
/// Buckets of the min-max decimation over the width.
const BUCKETS: usize = 400;

/// What a signal is compared with.
fn companion(id: &str) -> Option<(&'static SignalInfo, Look)> {
    let (id, look) = match id {
        "ra_um" | "ra_dyn_um" => ("ra_target_um", Look::Reference),
        "force_n" | "force_dyn_n" | "force_measured_n" | "force_setpoint_n" => {
            ("force_ref_n", Look::Reference)
        }
        "feed_mm_min" => ("feed_command_mm_min", Look::Command),
        "spindle_rpm" => ("spindle_command_rpm", Look::Command),
        _ => return None,
    };
    signal(id).map(|info| (info, look))
}

/// One drawn line.
struct Trace {
    name: String,
    points: Vec<[f64; 2]>,
    look: Look,
}

fn points(session: &Session, info: &SignalInfo, span_s: [f64; 2], delay_s: f64) -> Vec<[f64; 2]> {
    let Some(index) = SIGNALS.iter().position(|other| other.id == info.id) else {
        return Vec::new();
    };
    let cut = session.chosen();
    let rows = cut.run().recording().rows();
    let span_s = span_s.map(|t| t - delay_s);
    let end = session.revealed().len();
    let mut points = cut.traces().points(index, span_s, end, BUCKETS, Some(rows));
    // Only what lies in the window may set the scale; what is delayed must not run ahead.
    points.retain(|[t, _]| *t >= span_s[0] && *t <= span_s[1]);
    points.iter_mut().for_each(|[t, _]| *t += delay_s);
    without_level_runs(&points)
}

/// Leaves out the inner points of level runs: dashes are drawn from point to point, and would
/// come out ragged.
fn without_level_runs(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let level = |i: usize| {
        let neighbours = [i.checked_sub(1), Some(i + 1)].map(|i| points.get(i?));
        neighbours.iter().all(|other| other.is_some_and(|other| other[1] == points[i][1]))
    };
    (0..points.len()).filter(|i| !level(*i)).map(|i| points[i]).collect()
}

fn traces(session: &Session, wire: Wire, span_s: [f64; 2], dead_s: f64) -> Vec<Trace> {
    let info = wire.info();
    let mut traces = Vec::new();
    if let Some((other, look)) = companion(wire.signal) {
        let points = points(session, other, span_s, 0.0);
        traces.push(Trace { name: tr(other.label).to_owned(), points, look });
    }
    if wire.delayed {
        let points = points(session, info, span_s, 0.0);
        traces.push(Trace { name: tr(info.label).to_owned(), points, look: Look::Setpoint });
    }
    let delay_s = if wire.delayed { dead_s } else { 0.0 };
    let points = points(session, info, span_s, delay_s);
    traces.push(Trace { name: wire.name(), points, look: Look::Produced });
    traces
}

/// Range of the values with room around it; a constant lies in the middle.
fn value_range(traces: &[Trace]) -> [f64; 2] {
    let values = || traces.iter().flat_map(|trace| &trace.points).map(|point| point[1]);
    let (low, high) =
        (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
    if low > high {
        return [0.0, 1.0];
    }
    let margin = (0.08 * (high - low)).max(0.01 * high.abs()).max(1e-3);
    [low - margin, high + margin]
}

/// Plots the wire in `height` points.
pub fn show(ui: &mut egui::Ui, session: &Session, now: &Now<'_>, wire: Wire, height: f32) {
    let palette = Palette::at(ui);
    let info = wire.info();
    let to_s = session.playback().playhead_s.max(1.0);
    let span_s = [(to_s - WINDOW_S).max(0.0), to_s];
    let traces = traces(session, wire, span_s, now.moment.scenario.cnc.dead_time_s);
    let range = value_range(&traces);

    let top = ui.cursor().top();
    ui.horizontal_wrapped(|ui| {
        // A name stays in one piece where the line wraps.
        let mut name = |text: String, color| {
            ui.add(Label::new(RichText::new(text).strong().color(color)).extend());
        };
        name(wire.name(), palette.text);
        name(now.text(wire), palette.produced);
        for trace in traces.iter().filter(|trace| trace.look != Look::Produced) {
            let (stroke, _) = trace.look.line(palette);
            name(format!("- - {}", trace.name), stroke.color);
        }
    });
    let height = (height - (ui.cursor().top() - top)).max(90.0);
    let unit = format::unit(info.unit);
    still("wire", palette, [ui.available_width(), height])
        .x_axis_formatter(|mark, _| format!("{} s", tick(mark)))
        .y_axis_label(if unit == "-" { String::new() } else { unit })
        .show(ui, |plot| {
            plot.set_plot_bounds_x(span_s[0]..=span_s[1]);
            plot.set_plot_bounds_y(range[0]..=range[1]);
            for trace in traces {
                let (stroke, style) = trace.look.line(palette);
                for piece in pieces(&trace.points) {
                    let line = Line::new(trace.name.clone(), PlotPoints::from(piece));
                    // Decimated here already; a band would also fill in single steps.
                    plot.line(line.stroke(stroke).style(style).allow_band(false));
                }
            }
        });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn level_runs_keep_their_ends() {
        let points = [[0.0, 1.0], [1.0, 1.0], [2.0, 1.0], [3.0, 2.0], [4.0, 2.0]];
        let kept = [[0.0, 1.0], [2.0, 1.0], [3.0, 2.0], [4.0, 2.0]];
        assert_eq!(without_level_runs(&points), kept);
        assert!(without_level_runs(&[]).is_empty());
    }

    #[test]
    fn the_range_keeps_a_constant_in_the_middle() {
        let trace = |values: &[f64]| Trace {
            name: String::new(),
            points: values.iter().map(|y| [0.0, *y]).collect(),
            look: Look::Produced,
        };
        assert_eq!(value_range(&[trace(&[100.0])]), [99.0, 101.0]);
        assert_eq!(value_range(&[trace(&[])]), [0.0, 1.0]);
        let [low, high] = value_range(&[trace(&[100.0, 300.0]), trace(&[200.0])]);
        assert!(low < 100.0 && high > 300.0);
    }
}
