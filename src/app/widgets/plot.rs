//! What all plots have in common: their look, their grid, and what the pointer is near to.

use std::ops::RangeInclusive;

use egui::epaint::RectShape;
use egui::{Rangef, Shape, StrokeKind, Ui};
use egui_plot::{
    AxisHints, GridInput, GridMark, HoverPosition, Plot, PlotPoint, PlotResponse, PlotUi,
};

use super::super::format::{log10, round_step};
use super::super::theme::Palette;
use crate::base::language::fixed;
use crate::base::math::{extent, pow};

/// A range that holds all finite values, with a margin; 0 to 1 where there is none.
#[must_use]
pub fn around(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let [low, high] = extent(values.filter(|x| x.is_finite()));
    if low > high {
        return [0.0, 1.0];
    }
    let margin = (0.08 * (high - low)).max(1e-9 * high.abs().max(1e-9));
    [low - margin, high + margin]
}

/// A plot as all of them look, which by itself is only looked at: nothing in it is dragged, scrolled or
/// zoomed.
#[must_use]
pub fn still<'a>(title: &str, palette: &Palette, [width, height]: [f32; 2]) -> Plot<'a> {
    Plot::new(title)
        .height(height)
        .allow_zoom(false)
        .allow_drag(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .allow_double_click_reset(false)
        .allow_axis_zoom_drag(false)
        .sense(egui::Sense::hover())
        .custom_x_axes(vec![level_axis()])
        .custom_y_axes(vec![upright_axis(44.0)])
        .grid_color(palette.grid)
        .grid_fade(0.0)
        .x_grid_spacer(move |input| grid(input, width / 80.0))
        .y_grid_spacer(move |input| grid(input, height / 27.0))
        .x_axis_formatter(|mark, _| tick(mark))
        .y_axis_formatter(move |mark, range| upright_tick(mark, range, height))
        .grid_spacing(Rangef::new(16.0, 300.0))
}

/// Draws a plot. Its ground is painted with what surrounds it: the plot's own would be one more piece for the
/// graphics, and the labels of its axes another.
pub fn show<'a>(
    ui: &mut Ui,
    plot: Plot<'a>,
    add: impl FnOnce(&mut PlotUi<'a>) + 'a,
) -> PlotResponse<()> {
    let ground = ui.painter().add(Shape::Noop);
    let response = plot.show_background(false).show(ui, add);
    let visuals = ui.visuals();
    let stroke = visuals.widgets.noninteractive.bg_stroke;
    let (rect, inside) = (*response.transform.frame(), StrokeKind::Inside);
    let shape = RectShape::new(rect, 2.0, visuals.extreme_bg_color, stroke, inside);
    ui.painter().set(ground, shape);
    response
}

/// A horizontal axis. Its labels do not fade in as they get room, which would be hard to read.
#[must_use]
pub fn level_axis<'a>() -> AxisHints<'a> {
    AxisHints::new_x().label_spacing(Rangef::new(60.0, 60.1))
}

/// A vertical axis with labels in `width` points, which do not fade in either.
#[must_use]
pub fn upright_axis<'a>(width: f32) -> AxisHints<'a> {
    AxisHints::new_y().label_spacing(Rangef::new(20.0, 20.1)).min_thickness(width)
}

/// Grid lines at round values, about `count` of them.
pub fn grid(input: GridInput, count: f32) -> Vec<GridMark> {
    let (low, high) = input.bounds;
    let Some(step) = round_step((high - low) / f64::from(count.max(1.0))) else {
        return Vec::new();
    };
    let (first, last) = ((low / step).ceil() as i64, (high / step).floor() as i64);
    (first..=last).map(|k| GridMark { value: k as f64 * step, step_size: step }).collect()
}

/// The label of a grid line, with the digits that its step needs.
#[must_use]
pub fn tick(mark: GridMark) -> String {
    let decimals = (-(log10(mark.step_size) + 1e-9).floor()).clamp(0.0, 6.0) as usize;
    fixed(mark.value + 0.0, decimals)
}

/// The same at a vertical axis of a plot so many points high; none at its very foot, where the first label of the
/// horizontal axis stands.
fn upright_tick(mark: GridMark, range: &RangeInclusive<f64>, height: f32) -> String {
    /// Half the height of a label, points.
    const HALF: f64 = 7.0;
    let above = (mark.value - range.start()) / (range.end() - range.start()).max(f64::MIN_POSITIVE);
    let free = above * f64::from(height) >= HALF;
    if free { tick(mark) } else { String::new() }
}

/// Grid lines of a logarithmic axis: powers of ten, and twice and five times them where there is
/// room.
#[must_use]
pub fn decades(input: GridInput, height: f32) -> Vec<GridMark> {
    let (low, high) = input.bounds;
    let room = f64::from(height) / (high - low).max(1e-9);
    let fine: &[f64] = if room > 90.0 { &[1.0, 2.0, 5.0] } else { &[1.0] };
    let (first, last) = ((low - 1.0).floor() as i64, high.ceil() as i64);
    // An axis of any length has few lines.
    let step = ((last - first) / 12).max(1) as usize;
    let places = (first..=last)
        .step_by(step)
        .flat_map(|decade| fine.iter().map(move |factor| decade as f64 + log10(*factor)));
    let inside = places.filter(|place| (low..=high).contains(place));
    inside.map(|value| GridMark { value, step_size: 1.0 }).collect()
}

/// The label of a line of a logarithmic axis.
#[must_use]
pub fn decade(mark: GridMark) -> String {
    let value = pow(10.0, mark.value);
    let decimals = (-(mark.value + 1e-9).floor()).clamp(0.0, 9.0) as usize;
    fixed(value, decimals)
}

/// A logarithmic range that holds all positive `values`, at most `decades` long.
#[must_use]
pub fn decades_of(values: impl Iterator<Item = f64>, decades: f64) -> [f64; 2] {
    let [low, high] = extent(values.filter(|x| x.is_finite() && *x > 0.0));
    if low > high {
        return [0.1, 1.0];
    }
    let high = 1.6 * high;
    [(0.7 * low).max(high * pow(10.0, -decades)), high]
}

/// The pieces of a curve between the gaps in it, where its values are NaN.
#[must_use]
pub fn pieces(points: &[[f64; 2]]) -> Vec<Vec<[f64; 2]>> {
    let pieces = points.split(|[_, y]| y.is_nan());
    pieces.filter(|piece| !piece.is_empty()).map(<[_]>::to_vec).collect()
}

/// The named curve that the pointer is near to, and its nearest point; `None` where it is near to none.
#[must_use]
pub fn near<'a>(hover: &HoverPosition<'a>) -> Option<(&'a str, PlotPoint)> {
    match hover {
        HoverPosition::NearDataPoint { plot_name, position, .. } => {
            (!plot_name.is_empty()).then_some((*plot_name, *position))
        }
        HoverPosition::Elsewhere { .. } => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithmic_axes_have_round_lines() {
        let input = GridInput { bounds: (-1.2, 3.1), base_step_size: 0.1 };
        let marks = |height| {
            let input = GridInput { bounds: input.bounds, base_step_size: 0.1 };
            decades(input, height).into_iter().map(decade).collect::<Vec<String>>()
        };
        assert_eq!(marks(200.0), ["0.1", "1", "10", "100", "1000"]);
        assert_eq!(marks(500.0)[..4], ["0.1", "0.2", "0.5", "1"]);
        let wide = GridInput { bounds: (-300.0, 300.0), base_step_size: 0.1 };
        assert!(decades(wide, 300.0).len() < 20);
    }

    #[test]
    fn a_logarithmic_range_has_so_many_decades_at_most() {
        let [low, high] = decades_of([1e-9, 1.0, 100.0, 0.0].into_iter(), 4.0);
        assert!(high > 100.0 && low > 1e-2 && low < 1.0);
        assert_eq!(decades_of(std::iter::empty(), 3.0), [0.1, 1.0]);
    }
}
