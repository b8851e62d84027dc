//! What all plots have in common: their look, their grid, and what the pointer is near to.

use egui::Rangef;
use egui_plot::{AxisHints, GridInput, GridMark, HoverPosition, Plot, PlotPoint};

use super::super::format::{log10, round_step};
use super::super::theme::Palette;

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
        .y_axis_formatter(|mark, _| tick(mark))
        .grid_spacing(Rangef::new(16.0, 300.0))
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
    format!("{:.decimals$}", mark.value + 0.0)
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
