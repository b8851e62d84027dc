//! What a chart draws: the range of its values, the band, and the lines in their order.

use egui_plot::FilledArea;

use super::content::{ALL, Axes, BY_HAND, Chart, FUTURE, GHOST, TWIN, index};
use super::envelope::Curve;
use super::places::Places;
use crate::app::cut::Cut;
use crate::app::session::Session;
use crate::app::theme::{Look, Palette};
use crate::app::widgets::plot::pieces;
use crate::base::language::tr;
use crate::run::signals::SIGNALS;

/// The range of values: of all of the run and its twin, so that it does not jump while playing; or
/// of what was zoomed to. The run before the last change stays in the picture as long as it is drawn.
pub(super) fn fit_values(chart: &Chart, session: &Session, axes: &Axes) -> [f64; 2] {
    /// Enough to keep every extreme, few enough for every frame.
    const BUCKETS: usize = 16;
    let zoomed = axes.zoomed;
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
        if curve.compared && session.twin_stand().is_drawn() {
            let places = Places::of(session);
            of(session.twin(), curve.signal, times.map(|time_s| places.of_twin(time_s)));
        }
    }
    if let Some(ghost) = session.ghost().filter(|_| !axes.hidden.contains(&(ALL, GHOST))) {
        let times = [times[0].max(ghost.from_s), times[1]];
        for curve in chart.curves.iter().filter(|curve| curve.has_ghost(session)) {
            let signal = index(curve.signal);
            let points = ghost.traces.points(signal, times, usize::MAX, BUCKETS, None);
            points.iter().for_each(|[_, value]| join(*value));
        }
    }
    if let Some(hand) = session.hand_trace().filter(|_| !axes.hidden.contains(&(ALL, BY_HAND))) {
        let places = Places::beside(session, &hand.recording);
        let there = times.map(|time_s| places.of_twin(time_s));
        for curve in chart.curves.iter().filter(|curve| curve.has_hand()) {
            let rows = Some(hand.recording.rows());
            let points = hand.traces.points(index(curve.signal), there, usize::MAX, BUCKETS, rows);
            points.iter().for_each(|[_, value]| join(*value));
        }
    }
    for channel in chart.measured.iter().filter(|channel| axes.shows_measured(channel.id)) {
        let times = zoomed.unwrap_or([0.0, session.length_s()]);
        let points = channel.trace.points(&channel.place, times, BUCKETS);
        points.iter().filter(|[_, value]| value.is_finite()).for_each(|[_, value]| join(*value));
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
    // At the back: dense samples are a band, and what the run does is to be seen before it.
    for channel in chart.measured.iter().filter(|channel| axes.shows_measured(channel.id)) {
        let points = channel.trace.points(&channel.place, range, buckets(width));
        lines.extend(line(&channel.name, Look::Measured(channel.number), points));
    }
    for curve in chart.curves {
        let label = SIGNALS[index(curve.signal)].label;
        let chosen = session.chosen();
        if curve.compared && compared(TWIN) && session.twin_stand().is_drawn() {
            let places = Places::of(session);
            let end = places.rows_of_twin(playhead_s);
            let there = range.map(|time_s| places.of_twin(time_s));
            let points = visible(session.twin(), curve.signal, there, end, width);
            // Levels, as feed and speed of the twin are, have few points to look the places up of.
            let points = places.at_the_cut(without_flats(points, span));
            lines.extend(line(
                &format!("{}, {}", tr(label), tr(session.twin_stand().name())),
                Look::Twin,
                points,
            ));
        }
        if curve.has_hand()
            && compared(BY_HAND)
            && let Some(hand) = session.hand_trace()
        {
            let places = Places::beside(session, &hand.recording);
            let there = range.map(|time_s| places.of_twin(time_s));
            let (signal, rows) = (index(curve.signal), Some(hand.recording.rows()));
            let points = hand.traces.points(signal, there, usize::MAX, buckets(width), rows);
            let points = places.at_the_cut(without_flats(points, span));
            lines.extend(line(&format!("{}, {}", tr(label), tr(BY_HAND)), Look::Hand, points));
        }
        if curve.has_ghost(session)
            && compared(GHOST)
            && let Some(ghost) = session.ghost()
        {
            let from = [range[0].max(ghost.from_s), range[1]];
            let signal = index(curve.signal);
            let points = ghost.traces.points(signal, from, usize::MAX, buckets(width), None);
            let look = if curve.compared { Look::Ghost } else { Look::GhostDynamics };
            lines.extend(line(&format!("{}, {}", tr(label), tr(GHOST)), look, points));
        }
        if shown(label) {
            // While it stands still after a change, what is to come is shown as well.
            if curve.has_ghost(session) && compared(FUTURE) && future_is_shown(session) {
                let from = [range[0].max(playhead_s), range[1]];
                let points = visible(chosen, curve.signal, from, usize::MAX, width);
                let look = if curve.compared { Look::Future } else { Look::FutureDynamics };
                lines.extend(line(&format!("{}, {}", tr(label), tr(FUTURE)), look, points));
            }
            let points = visible(chosen, curve.signal, range, revealed, width);
            lines.extend(line(tr(label), curve.look, points));
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use egui_plot::PlotItem as _;

    use super::super::content::{ChartCurve, ChartMeasured};
    use super::*;
    use crate::app::command::{PlaybackCommand, SessionCommand};
    use crate::app::overlay::trace::MeasuredTrace;
    use crate::base::settings::Value;
    use crate::measured::channel::SampleTimes;
    use crate::run::edits::Edits;
    use crate::run::presets;
    use crate::study::over_run::OverRun;

    /// What was before the change has the curves that the cut has: with vibration where the machine vibrates.
    #[test]
    fn the_run_before_a_change_has_its_curves_with_vibration_too() {
        for (preset, vibrates) in [("chatter", true), ("depth-step", false)] {
            let mut session = Session::new(presets::load(preset).unwrap(), Edits::none());
            (0..40).for_each(|_| session.advance(0.02));
            session.play(PlaybackCommand::TogglePlay);
            session.play(PlaybackCommand::SeekTo(2.0));
            let (path, value) = ("target.ra_um".to_owned(), Value::Float(0.7));
            session.execute(SessionCommand::Set { path, value });
            let signal = |signal, look, compared| ChartCurve { signal, look, compared };
            let pair = |with, without| {
                [signal(with, Look::Dynamics, false), signal(without, Look::Produced, true)]
            };
            let charts = [
                (pair("ra_dyn_um", "ra_um"), ["Ra with dynamics", "Ra"]),
                (pair("force_dyn_n", "force_n"), ["Force with dynamics", "Maximum force"]),
            ];
            for (curves, names) in charts {
                let chart = Chart {
                    id: "a",
                    title: "A",
                    curves: &curves,
                    band: None,
                    levels: Vec::new(),
                    include: &[],
                    measured: Vec::new(),
                    write: |_, _| String::new(),
                };
                let ranges = [[0.0, 10.0], [0.0, 500.0]];
                let palette = Palette::of(egui::Theme::Light);
                let drawn = lines(&chart, &session, &Axes::default(), ranges, 400.0, palette);
                let has = |name: &str, of: &str| {
                    drawn.iter().any(|line| line.name() == format!("{name}, {of}"))
                };
                for of in [GHOST, FUTURE] {
                    assert_eq!(has(names[0], of), vibrates, "{preset}: {}, {of}", names[0]);
                }
                assert!(has(names[1], FUTURE), "{preset}: {}", names[1]);
            }
        }
    }

    /// What was measured is drawn and in the picture as long as it is switched on.
    #[test]
    fn a_measured_channel_is_a_line_until_it_is_switched_off() {
        let session = Session::new(presets::load("first-cut").unwrap(), Edits::none());
        let times = SampleTimes::Even { rate_hz: 10.0, first_s: 5.0 };
        let trace = MeasuredTrace::new(times, vec![10.0, 4000.0, f64::NAN, 20.0, 30.0]);
        let place = OverRun { shift_s: 5.0, scale: 2.0, offset: 0.0 };
        let name = "measured: Fx".to_owned();
        let chart = Chart {
            id: "a",
            title: "A",
            curves: &[ChartCurve { signal: "force_n", look: Look::Produced, compared: false }],
            band: None,
            levels: Vec::new(),
            include: &[],
            measured: vec![ChartMeasured { id: 7, name, number: 0, trace: &trace, place }],
            write: |_, _| String::new(),
        };
        let mut axes = Axes::default();
        let palette = Palette::of(egui::Theme::Light);
        let drawn = |axes: &Axes| {
            let values = fit_values(&chart, &session, axes);
            let lines = lines(&chart, &session, axes, [[0.0, 10.0], values], 400.0, palette);
            let measured = lines.iter().filter(|line| line.name() == "measured: Fx").count();
            (measured, values[1])
        };
        let (count, most) = drawn(&axes);
        assert!(count == 2 && most >= 2000.0, "in two pieces, as 2000 N: {count} {most}");
        axes.show_measured(7, false);
        let (count, most) = drawn(&axes);
        assert!(count == 0 && most < 2000.0, "{count} {most}");
    }

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
