//! Measured against model, and what is left below it.

use egui::{RichText, Role, Ui, WidgetInfo};
use egui_plot::{HLine, HoverPosition, Line, MarkerShape, PlotPoints, Points};

use crate::app::format::{self, log10};
use crate::app::theme::{Look, Palette};
use crate::app::widgets::legend;
use crate::app::widgets::plot::{around, decade, decades, near, still};
use crate::base::language::{fixed, tr};
use crate::base::math::pow;
use crate::study::identify::fits::FitPlot;

/// Heights of the plots, points.
const HEIGHT: f32 = 200.0;
const LEFT_HEIGHT: f32 = 120.0;
/// Most places that are drawn: of more, the extremes of every stretch.
const MOST: usize = 1500;
/// Size of a mark, points.
const RADIUS: f32 = 3.0;

/// Fewer points: the least and the largest value of every stretch, in their order.
fn thinned(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    if points.len() <= MOST {
        return points.to_vec();
    }
    let stretch = points.len().div_ceil(MOST / 2);
    let extremes = |part: &[[f64; 2]]| {
        let by = |a: &&[f64; 2], b: &&[f64; 2]| a[1].total_cmp(&b[1]);
        let ends = [part.iter().min_by(by), part.iter().max_by(by)];
        let mut ends: Vec<[f64; 2]> = ends.into_iter().flatten().copied().collect();
        ends.sort_by(|a, b| a[0].total_cmp(&b[0]));
        ends
    };
    points.chunks(stretch).flat_map(extremes).collect()
}

/// Both plots.
pub fn show(ui: &mut Ui, of: &FitPlot) {
    let palette = Palette::at(ui);
    let unit = format::unit(&of.unit);
    let bracket = if unit.is_empty() { String::new() } else { format!(" [{unit}]") };
    let (over, over_unit) = &of.over;
    let axis = format!("{over} [{}]", format::unit(over_unit));
    let place = |y: f64| if of.logarithmic { log10(y) } else { y };
    let column = |of: &dyn Fn(&[f64; 3]) -> f64, points: &[[f64; 3]]| -> Vec<[f64; 2]> {
        let placed = points.iter().map(|point| [point[0], of(point)]);
        placed.filter(|[_, y]| y.is_finite()).collect()
    };
    let measured = column(&|point| place(point[1]), &of.points);
    let model = column(&|point| place(point[2]), &of.points);
    let left = match of.logarithmic {
        true => column(&|point| point[1] / point[2], &of.points),
        false => column(&|point| point[1] - point[2], &of.points),
    };
    legend::row(ui, tr("the fit"), |ui| {
        ui.label(RichText::new(format!("{}{bracket}", of.title)).strong());
        if of.joined {
            legend::sample(ui, tr("measured"), Look::Measured(0));
            legend::sample(ui, tr("model"), Look::Produced);
        } else {
            legend::points(ui, tr("measured"), palette.measured, MarkerShape::Circle);
            legend::points(ui, tr("model"), palette.produced, MarkerShape::Cross);
        }
    });
    let across = around(of.points.iter().map(|point| point[0]));
    let up = around(measured.iter().chain(&model).map(|point| point[1]));
    let width = ui.available_width();
    let logarithmic = of.logarithmic;
    let (hover_unit, hover_over) = (of.unit.clone(), *over_unit);
    let label = move |hover: &HoverPosition<'_>| {
        let (name, at) = near(hover)?;
        let value = if logarithmic { pow(10.0, at.y) } else { at.y };
        Some(format!(
            "{name}: {}\n{}",
            format::fine(value, &hover_unit),
            format::fine(at.x, hover_over)
        ))
    };
    let plot = still(&format!("fit {}", of.title), palette, [width, HEIGHT])
        .x_axis_label(axis.clone())
        .label_formatter(label);
    let plot = match logarithmic {
        true => plot
            .y_grid_spacer(move |input| decades(input, HEIGHT))
            .y_axis_formatter(|mark, _| decade(mark)),
        false => plot,
    };
    let response = plot.show(ui, |plot| {
        plot.set_plot_bounds_x(across[0]..=across[1]);
        plot.set_plot_bounds_y(up[0]..=up[1]);
        let (stroke, style) = Look::Measured(0).line(palette);
        let (model_stroke, model_style) = Look::Produced.line(palette);
        if of.joined {
            let line = Line::new(tr("measured"), PlotPoints::from(thinned(&measured)));
            plot.line(line.stroke(stroke).style(style));
            let line = Line::new(tr("model"), PlotPoints::from(thinned(&model)));
            plot.line(line.stroke(model_stroke).style(model_style));
        } else {
            let marks = Points::new(tr("measured"), measured.clone());
            plot.points(marks.color(palette.measured).shape(MarkerShape::Circle).radius(RADIUS));
            let marks = Points::new(tr("model"), model.clone());
            let cross = marks.color(palette.produced).shape(MarkerShape::Cross);
            plot.points(cross.radius(2.0 * RADIUS));
        }
    });
    let said = tr!(
        "{what} over {over}: measured against the model, {n} places",
        what = of.title,
        over = over,
        n = of.points.len()
    );
    response.response.widget_info(|| WidgetInfo::labeled(Role::Figure, true, said.clone()));
    let title = match of.logarithmic {
        true => tr("Measured over model").to_owned(),
        false => format!("{}{bracket}", tr("Left over: measured less model")),
    };
    ui.label(RichText::new(title).strong());
    let middle = if of.logarithmic { 1.0 } else { 0.0 };
    let up = around(left.iter().map(|point| point[1]).chain([middle]));
    let label = move |hover: &HoverPosition<'_>| {
        let (_, at) = near(hover)?;
        Some(format!("{}\n{}", fixed(at.y, 4), format::fine(at.x, hover_over)))
    };
    let plot = still(&format!("fit left {}", of.title), palette, [width, LEFT_HEIGHT])
        .x_axis_label(axis)
        .label_formatter(label);
    let response = plot.show(ui, |plot| {
        plot.set_plot_bounds_x(across[0]..=across[1]);
        plot.set_plot_bounds_y(up[0]..=up[1]);
        let (stroke, style) = Look::Reference.line(palette);
        plot.hline(HLine::new("", middle).stroke(stroke).style(style).allow_hover(false));
        if of.joined {
            let (stroke, style) = Look::Measured(0).line(palette);
            let line = Line::new(tr("left over"), PlotPoints::from(thinned(&left)));
            plot.line(line.stroke(stroke).style(style));
        } else {
            let marks = Points::new(tr("left over"), left.clone());
            plot.points(marks.color(palette.measured).shape(MarkerShape::Circle).radius(RADIUS));
        }
    });
    let said = tr!("what the fit of {what} leaves over {over}", what = of.title, over = over);
    response.response.widget_info(|| WidgetInfo::labeled(Role::Figure, true, said.clone()));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_peak_is_drawn_however_many_points_there_are() {
        let mut points: Vec<[f64; 2]> = (0..100_000).map(|i| [f64::from(i), 0.0]).collect();
        points[70_001][1] = 5.0;
        let thin = thinned(&points);
        assert!(thin.len() <= MOST + 2, "{}", thin.len());
        assert!(thin.contains(&[70_001.0, 5.0]));
        assert!(thin.windows(2).all(|pair| pair[0][0] <= pair[1][0]));
        assert_eq!(thinned(&points[..10]), points[..10]);
    }
}
