//! What a chart draws: the range of its values, the band, and the lines in their order.

use egui_plot::FilledArea;

use super::content::{ALL, Axes, Chart, FUTURE, GHOST, TWIN, index};
use super::envelope::Curve;
use super::places::Places;
use crate::app::cut::Cut;
use crate::app::session::Session;
use crate::app::theme::{Look, Palette};
use crate::app::widgets::plot::pieces;
use crate::run::signals::SIGNALS;

/// The range of values: of all of the run and its twin, so that it does not jump while playing; or
/// of what was zoomed to.
pub(super) fn fit_values(chart: &Chart, session: &Session, zoomed: Option<[f64; 2]>) -> [f64; 2] {
    /// Enough to keep every extreme, few enough for every frame.
    const BUCKETS: usize = 16;
    let mut range = [f64::INFINITY, f64::NEG_INFINITY];
    let mut join = |value: f64| range = [range[0].min(value), range[1].max(value)];
    let times = zoomed.unwrap_or([0.0, f64::INFINITY]);
    let mut of = |cut: &Cut, signal: &str, times: [f64; 2]| {
        let rows = cut.run().recording().rows();
        let points = cut.traces().points(index(signal), times, usize::MAX, BUCKETS, Some(rows));
        points.iter().for_each(|[_, value]| join(*value));
    };
    for curve in chart.curves {
        of(session.chosen(), curve.signal, times);
        if curve.compared {
            let places = Places::of(session);
            of(session.twin(), curve.signal, times.map(|time_s| places.of_twin(time_s)));
        }
    }
    if zoomed.is_none() {
        chart.include.iter().for_each(|value| join(*value));
    }
    if range[0] > range[1] {
        // Zoomed to where nothing is.
        return [0.0, 1.0];
    }
    let margin = (0.08 * (range[1] - range[0])).max(0.02 * range[1].abs()).max(1e-3);
    [range[0] - margin, range[1] + margin]
}

pub(super) fn band(
    chart: &Chart,
    session: &Session,
    [range, values]: [[f64; 2]; 2],
    width: f32,
    palette: &Palette,
) -> Option<FilledArea> {
    let (signal, fraction) = chart.band?;
    let points = visible(session.chosen(), signal, range, session.revealed().len(), width);
    let points = without_flats(points, values[1] - values[0]);
    if points.len() < 2 {
        return None;
    }
    let side = |factor: f64| points.iter().map(|[_, y]| y * factor).collect::<Vec<_>>();
    let times: Vec<f64> = points.iter().map(|[x, _]| *x).collect();
    let area = FilledArea::new("", &times, &side(1.0 - fraction), &side(1.0 + fraction));
    let edge = egui::Stroke::new(0.8, palette.reference.gamma_multiply(0.5));
    Some(area.fill_color(palette.band).stroke(edge).allow_hover(false))
}

/// Buckets for a curve of a width, points: at most two points of it a pixel, a least and a largest value. More
/// are not seen, and drawing them is most of the work of a frame.
fn buckets(width: f32) -> usize {
    (0.5 * width) as usize
}

fn visible(cut: &Cut, signal: &str, range: [f64; 2], end: usize, width: f32) -> Vec<[f64; 2]> {
    let rows = cut.run().recording().rows();
    cut.traces().points(index(signal), range, end, buckets(width), Some(rows))
}

/// Leaves out the points between two that look equal: a level needs only its ends. Dashes would
/// otherwise be made of pieces too short to draw, and the line of a value that settles would have
/// gaps. `span` is the height of the picture in the values' unit.
fn without_flats(points: Vec<[f64; 2]>, span: f64) -> Vec<[f64; 2]> {
    /// Difference that nobody sees, as a fraction of the picture's height.
    const SAME: f64 = 1e-4;
    let same = |a: [f64; 2], b: [f64; 2]| (a[1] - b[1]).abs() <= SAME * span;
    let mut kept: Vec<[f64; 2]> = Vec::with_capacity(points.len());
    for point in points {
        if let [.., before, last] = kept.as_mut_slice()
            && same(*before, *last)
            && same(*before, point)
        {
            *last = point;
        } else {
            kept.push(point);
        }
    }
    kept
}

/// Whether what is to come is drawn: after a change, while the playhead stands before the end.
pub(super) fn future_is_shown(session: &Session) -> bool {
    let playback = session.playback();
    session.ghost().is_some() && !playback.playing && !playback.at_end
}

pub(super) fn lines(
    chart: &Chart,
    session: &Session,
    axes: &Axes,
    [range, values]: [[f64; 2]; 2],
    width: f32,
    palette: &Palette,
) -> Vec<Curve> {
    let span = values[1] - values[0];
    let shown = |name: &'static str| !axes.hidden.contains(&(chart.id, name));
    let compared = |name: &'static str| !axes.hidden.contains(&(ALL, name));
    let line = |name: &str, look: Look, points: Vec<[f64; 2]>| {
        let pieces = pieces(&points).into_iter();
        let curve = |piece| Curve::new(name, without_flats(piece, span), look.line(palette));
        pieces.map(curve).collect::<Vec<_>>()
    };
    let revealed = session.revealed().len();
    let playhead_s = session.playback().playhead_s;
    let mut lines = Vec::new();
    for curve in chart.curves {
        let label = SIGNALS[index(curve.signal)].label;
        let chosen = session.chosen();
        if curve.compared && compared(TWIN) {
            let places = Places::of(session);
            let end = places.rows_of_twin(playhead_s);
            let there = range.map(|time_s| places.of_twin(time_s));
            let points = visible(session.twin(), curve.signal, there, end, width);
            // Levels, as feed and speed of the twin are, have few points to look the places up of.
            let points = places.at_the_cut(without_flats(points, span));
            lines.extend(line(&format!("{label}, {TWIN}"), Look::Twin, points));
        }
        if curve.compared
            && compared(GHOST)
            && let Some(ghost) = session.ghost()
        {
            let from = [range[0].max(ghost.from_s), range[1]];
            let signal = index(curve.signal);
            let points = ghost.traces.points(signal, from, usize::MAX, buckets(width), None);
            lines.extend(line(&format!("{label}, {GHOST}"), Look::Ghost, points));
        }
        if shown(label) {
            // While it stands still after a change, what is to come is shown as well.
            if curve.compared && compared(FUTURE) && future_is_shown(session) {
                let from = [range[0].max(playhead_s), range[1]];
                let points = visible(chosen, curve.signal, from, usize::MAX, width);
                lines.extend(line(&format!("{label}, {FUTURE}"), Look::Future, points));
            }
            let points = visible(chosen, curve.signal, range, revealed, width);
            lines.extend(line(label, curve.look, points));
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::without_flats;

    #[test]
    fn a_value_that_settles_is_one_level_and_a_step_stays() {
        let settling = |i: i32| [f64::from(i), 73.0 + 0.01 / f64::from(1 + i * i)];
        let points: Vec<[f64; 2]> = (0..1000).map(settling).chain([[1000.0, 80.0]]).collect();
        let kept = without_flats(points.clone(), 1000.0);
        assert_eq!(kept, [points[0], points[999], points[1000]]);
        // Where the picture is closer, the same values are a curve.
        assert!(without_flats(points, 0.1).len() > 10);
    }
}
