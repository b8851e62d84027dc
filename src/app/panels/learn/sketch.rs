//! A curve that is sketched by hand: a signal over time, before the run shows it.

use egui::{Align2, FontId, Rect, Sense, Shape, Stroke, StrokeKind, TextStyle, Ui, pos2, vec2};

use super::pen::Pen;
use crate::app::format;
use crate::app::session::Session;
use crate::app::theme::Palette;
use crate::base::language::tr;
use crate::run::signals::signal;
use crate::study::mission::MissionValue;

/// Heights that a sketch has over its time.
const BINS: usize = 49;
/// Height of the paper, points.
const HEIGHT: f32 = 140.0;
/// How much higher than the largest value of the run the paper is: it must not tell the value (chosen).
const HEADROOM: f64 = 1.6;

/// Shows the sketch; gives its points once there are any.
pub fn show(
    ui: &mut Ui,
    of: &MissionValue,
    points: &[[f64; 2]],
    session: &Session,
) -> Option<Vec<[f64; 2]>> {
    let MissionValue::Signal { signal: id, window, .. } = of else { return None };
    let info = signal(id)?;
    let [from_s, to_s] = [window.time_s[0], window.time_s[1].min(session.length_s())];
    let rows = session.chosen().run().recording().rows();
    let largest = rows.iter().filter_map(|row| (info.value)(row)).fold(0.0, f64::max);
    let top = if largest > 0.0 { HEADROOM * largest } else { 1.0 };
    let mut heights: Vec<Option<f64>> =
        (0..BINS).map(|bin| at(points, time(bin, from_s, to_s))).collect();
    let palette = Palette::at(ui);
    let (rect, response) =
        ui.allocate_exact_size(vec2(ui.available_width(), HEIGHT), Sense::click_and_drag());
    let paper = rect.shrink2(vec2(2.0, 14.0));
    let painter = ui.painter_at(rect);
    painter.rect(paper, 2.0, palette.card, Stroke::new(1.0, palette.weak), StrokeKind::Inside);
    let font =
        FontId::new(TextStyle::Small.resolve(ui.style()).size, egui::FontFamily::Proportional);
    let unit = format::unit(info.unit);
    let label =
        |place, align, text: String| painter.text(place, align, text, font.clone(), palette.weak);
    let up_to =
        tr!("{signal} up to {top:.0} {unit}", signal = tr(info.label), top = top, unit = unit);
    label(rect.left_top(), Align2::LEFT_TOP, up_to);
    label(rect.left_bottom(), Align2::LEFT_BOTTOM, format!("{from_s:.0} s"));
    label(rect.right_bottom(), Align2::RIGHT_BOTTOM, format!("{to_s:.0} s"));
    let mut drawn = !points.is_empty();
    let mut pen = Pen::of(ui, &response);
    if let Some(pointer) = response.interact_pointer_pos() {
        let bin_of = |x: f32| (x - paper.left()) / paper.width() * (BINS - 1) as f32;
        let height_of =
            |y: f32| f64::from(((paper.bottom() - y) / paper.height()).clamp(0.0, 1.0)) * top;
        let before = pointer - response.drag_delta();
        let (a, b) = (bin_of(before.x), bin_of(pointer.x));
        let (first, last) = (a.min(b).round(), a.max(b).round());
        for (bin, height) in heights.iter_mut().enumerate() {
            let bin = bin as f32;
            if first <= bin && bin <= last {
                let part = if a == b { 1.0 } else { ((bin - a) / (b - a)).clamp(0.0, 1.0) };
                *height = Some(height_of(before.y + part * (pointer.y - before.y)));
                drawn = true;
            }
        }
        let bin = (bin_of(pointer.x).round().max(0.0) as usize).min(BINS - 1);
        pen.put(ui, &response, bin, height_of(pointer.y) / top);
    }
    for Pen { bin, height } in pen.drawn_by_keys(ui, &response, BINS) {
        heights[bin] = Some(height * top);
        drawn = true;
    }
    let pen_at = pos2(
        paper.left() + pen.bin as f32 / (BINS - 1) as f32 * paper.width(),
        paper.bottom() - pen.height as f32 * paper.height(),
    );
    let told = tr!(
        "{value} at {time}",
        value = format::quantity(pen.height * top, info.unit),
        time = format::time(time(pen.bin, from_s, to_s)),
    );
    pen.show(ui, &response, pen_at, pen.height * top, &told);
    if !drawn {
        label(paper.center(), Align2::CENTER_CENTER, tr("Draw here").to_owned());
        return None;
    }
    let sketched: Vec<[f64; 2]> = heights
        .iter()
        .enumerate()
        .filter_map(|(bin, height)| Some([time(bin, from_s, to_s), (*height)?]))
        .collect();
    let place = |[time_s, value]: [f64; 2]| {
        let x = ((time_s - from_s) / (to_s - from_s)) as f32;
        pos2(
            paper.left() + x * paper.width(),
            paper.bottom() - (value / top) as f32 * paper.height(),
        )
    };
    line(&painter, paper, sketched.iter().map(|point| place(*point)).collect(), palette);
    // A curve has two points at least.
    (sketched.len() >= 2).then_some(sketched)
}

fn line(painter: &egui::Painter, paper: Rect, points: Vec<egui::Pos2>, palette: &Palette) {
    painter.with_clip_rect(paper).add(Shape::line(points, Stroke::new(2.0, palette.accent)));
}

fn time(bin: usize, from_s: f64, to_s: f64) -> f64 {
    from_s + (to_s - from_s) * bin as f64 / (BINS - 1) as f64
}

/// The height of a sketch at a time, where it has been drawn.
fn at(points: &[[f64; 2]], time_s: f64) -> Option<f64> {
    let hair = 1e-9;
    points.iter().find(|[t, _]| (t - time_s).abs() <= hair * (1.0 + time_s.abs())).map(|[_, y]| *y)
}
