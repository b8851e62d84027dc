//! The measured profile over the distance along the line: as the teeth left it, and filtered.

use egui::{RichText, Role, Ui, WidgetInfo};
use egui_plot::{HoverPosition, Line, PlotPoints};

use crate::app::format;
use crate::app::theme::{Look, Palette};
use crate::app::widgets::focus::pointer_only;
use crate::app::widgets::legend;
use crate::app::widgets::plot::{grid, near, still, tick};
use crate::base::language::{text, tr};
use crate::base::math::extent;
use crate::base::stats;
use crate::study::profilometer::Measurement;

/// Number of pieces whose extremes are drawn: more than there are pixels.
const PIECES: usize = 480;
const HEIGHT: f32 = 148.0;
/// Names and looks of the two profiles.
const LINES: [(&str, Look); 2] =
    [(text!("as the teeth left it"), Look::Dynamics), (text!("roughness profile"), Look::Produced)];

/// The profiles as they are drawn: mm along the line, um about their mean.
#[derive(Clone, Debug, PartialEq)]
pub struct Curves {
    points: [Vec<[f64; 2]>; 2],
    along_mm: [f64; 2],
}

/// Least and largest value of every piece, in their order.
fn thinned(values_mm: &[f64], begins_mm: f64, step_mm: f64) -> Vec<[f64; 2]> {
    let mean_mm = stats::mean(values_mm.iter().copied()).unwrap_or(0.0);
    let size = values_mm.len().div_ceil(PIECES).max(1);
    let mut points = Vec::with_capacity(2 * PIECES);
    for (number, piece) in values_mm.chunks(size).enumerate() {
        let least = (0..piece.len()).min_by(|a, b| piece[*a].total_cmp(&piece[*b]));
        let most = (0..piece.len()).max_by(|a, b| piece[*a].total_cmp(&piece[*b]));
        let (Some(least), Some(most)) = (least, most) else { continue };
        let mut push = |i: usize| {
            let along_mm = begins_mm + (number * size + i) as f64 * step_mm;
            points.push([along_mm, 1000.0 * (piece[i] - mean_mm)]);
        };
        push(least.min(most));
        if least != most {
            push(least.max(most));
        }
    }
    points
}

impl Curves {
    /// Those of a measurement.
    pub fn of(found: &Measurement) -> Self {
        let roughness = &found.roughness;
        let thin = |values: &[f64]| thinned(values, found.begins_mm, roughness.step_mm);
        let length_mm = roughness.profile_mm.len() as f64 * roughness.step_mm;
        Self {
            points: [thin(&roughness.total_mm), thin(&roughness.profile_mm)],
            along_mm: [found.begins_mm, found.begins_mm + length_mm],
        }
    }
}

/// Draws them over the width of `ui`.
pub fn show(ui: &mut Ui, curves: &Curves) {
    let palette = Palette::at(ui);
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(tr("Profile [µm]")).strong());
        for (name, look) in LINES {
            legend::sample(ui, tr(name), look);
        }
    });
    let heights = curves.points.iter().flatten().map(|point| point[1]);
    let [low, high] = extent(heights);
    let margin = 0.08 * (high - low).max(0.01);
    let [from, to] = curves.along_mm;
    let width = ui.available_width();
    let label = |hover: &HoverPosition<'_>| {
        let (name, position) = near(hover)?;
        let [height, along] =
            [(position.y, "um"), (position.x, "mm")].map(|(x, u)| format::quantity(x, u));
        Some(tr!(
            "{name}: {height}\n{along} along the line",
            name = name,
            height = height,
            along = along,
        ))
    };
    let response = still("profile", palette, [width, HEIGHT])
        .sense(pointer_only(false))
        .y_axis_min_width(40.0)
        .x_grid_spacer(move |input| grid(input, width / 70.0))
        .y_grid_spacer(|input| grid(input, HEIGHT / 30.0))
        .x_axis_formatter(|mark, _| format!("{} mm", tick(mark)))
        .label_formatter(label)
        .show(ui, |plot| {
            plot.set_plot_bounds_x(from..=to);
            plot.set_plot_bounds_y(low - margin..=high + margin);
            for ((name, look), points) in LINES.iter().zip(&curves.points) {
                let (stroke, style) = look.line(palette);
                let line = Line::new(tr(name), PlotPoints::from(points.clone()));
                plot.line(line.stroke(stroke).style(style).width(1.2).allow_band(false));
            }
        });
    response.response.widget_info(|| {
        let [from, to] = [from, to].map(|x| format::quantity(x, "mm"));
        let label = tr!("Profile from {from} to {to} along the line", from = from, to = to);
        WidgetInfo::labeled(Role::Figure, true, label)
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_keeps_order_and_extremes() {
        let values: Vec<f64> =
            (0..20_000).map(|i| if i == 7777 { 0.5 } else { 1e-3 * f64::from(i % 7) }).collect();
        let points = thinned(&values, 2.0, 0.001);
        assert!(points.len() <= 2 * PIECES && points.windows(2).all(|p| p[0][0] < p[1][0]));
        let most = points.iter().max_by(|a, b| a[1].total_cmp(&b[1])).unwrap();
        assert!((most[0] - 9.777).abs() < 1e-9 && most[1] > 490.0, "{most:?}");
        assert_eq!(thinned(&[1.0], 0.0, 0.1), [[0.0, 0.0]]);
        assert!(thinned(&[], 0.0, 0.1).is_empty());
    }
}
