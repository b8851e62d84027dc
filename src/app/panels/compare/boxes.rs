//! Box plots of a measure: least and largest value, quartiles and median over the seeds, the mean
//! as a dot, the printed figure as a diamond.

use egui::{Role, Stroke, Ui, WidgetInfo};
use egui_plot::{BoxElem, BoxPlot, BoxSpread, MarkerShape, Points};

use super::contest::Contest;
use super::table::{no_spread, printed_of, title, value};
use crate::app::theme::Palette;
use crate::app::widgets::legend;
use crate::app::widgets::plot::{grid, still};
use crate::app::widgets::touch;
use crate::base::language::tr;
use crate::run::job::Progress;
use crate::study::compare::outcome::Measure;

/// Height of a box with its gap, and of the axis, points.
const ROW: f32 = 34.0;
const AXIS: f32 = 34.0;
/// Width of a box as a fraction of its row.
const WIDTH: f64 = 0.5;

/// The choice of the measure and the plot.
pub fn show(ui: &mut Ui, contest: &Contest, measure: &mut Measure, belongs: bool) {
    let palette = Palette::at(ui);
    let (compared, reference) = (contest.table(), contest.reference());
    ui.horizontal_wrapped(|ui| {
        ui.strong(tr("Spread over the seeds:"));
        for one in Measure::ALL {
            let name = tr(one.name(reference));
            let response = touch::choice(ui, *measure == *one, name);
            let (is, name) = (*measure == *one, tr!("Spread of {measure}", measure = name));
            response.widget_info(|| WidgetInfo::selected(Role::Button, true, is, name.clone()));
            if response.clicked() {
                *measure = *one;
            }
        }
    });
    let measure = *measure;
    let row = |index: usize| (compared.len() - 1 - index) as f64;
    let mut boxes = Vec::new();
    let (mut means, mut printed): (Vec<[f64; 2]>, Vec<[f64; 2]>) = (Vec::new(), Vec::new());
    let mut extent = [f64::INFINITY, f64::NEG_INFINITY];
    let mut include = |x: f64| extent = [extent[0].min(x), extent[1].max(x)];
    for (index, one) in compared.iter().enumerate() {
        if let Some(spread) = one.get(measure) {
            let quartiles = BoxSpread::new(
                spread.least,
                spread.lower_quartile,
                spread.median,
                spread.upper_quartile,
                spread.largest,
            );
            let color = palette.produced;
            let element = BoxElem::new(row(index), quartiles)
                .name(tr(&one.name))
                .box_width(WIDTH)
                .whisker_width(0.6 * WIDTH)
                .fill(color.gamma_multiply(0.3))
                .stroke(Stroke::new(1.4, color));
            boxes.push(element);
            means.push([spread.mean, row(index)]);
            include(spread.least);
            include(spread.largest);
        }
        let figure = printed_of(&one.name, belongs).and_then(|printed| printed.get(measure));
        if let Some(figure) = figure {
            printed.push([figure, row(index)]);
            include(figure);
        }
    }
    if extent[0] > extent[1] {
        ui.weak(tr("No values yet: run the comparison."));
        // The room of the plot: what stands below does not move when it comes.
        ui.allocate_space(egui::vec2(0.0, ROW * compared.len() as f32 + AXIS));
        return;
    }
    if no_spread(compared) {
        ui.weak(tr("Every seed gave the same run: a box is a line."));
    }
    ui.horizontal_wrapped(|ui| {
        legend::points(ui, tr("mean"), palette.command, MarkerShape::Circle);
        if !printed.is_empty() {
            legend::points(ui, tr("printed in Table 1"), palette.reference, MarkerShape::Diamond);
        }
    });
    let margin = 0.06 * (extent[1] - extent[0]).max(1e-3);
    let names: Vec<String> = compared.iter().rev().map(|one| tr(&one.name).to_owned()).collect();
    let rows = compared.len();
    let width = ui.available_width();
    let response = still("boxes", palette, [width, ROW * rows as f32 + AXIS])
        .y_axis_min_width(96.0)
        .show_y(false)
        .x_grid_spacer(move |input| grid(input, width / 110.0))
        .y_grid_spacer(move |_| {
            let mark = |k: usize| egui_plot::GridMark { value: k as f64, step_size: 1.0 };
            (0..rows).map(mark).collect()
        })
        .x_axis_label(title(measure, reference))
        .y_axis_formatter(move |mark, _| {
            names.get(mark.value.round() as usize).cloned().unwrap_or_default()
        })
        .show(ui, |plot| {
            plot.set_plot_bounds_x(extent[0] - margin..=extent[1] + margin);
            plot.set_plot_bounds_y(-0.6..=rows as f64 - 0.4);
            let format = move |element: &BoxElem, _: &BoxPlot| {
                let spread = &element.spread;
                tr!(
                    "{name}\nmost {most}\nupper quartile {upper}\nmedian {median}\nlower quartile {lower}\n\
                     least {least}",
                    name = element.name,
                    most = value(measure, spread.upper_whisker),
                    upper = value(measure, spread.quartile3),
                    median = value(measure, spread.median),
                    lower = value(measure, spread.quartile1),
                    least = value(measure, spread.lower_whisker),
                )
            };
            plot.box_plot(
                BoxPlot::new("spread", boxes).horizontal().element_formatter(Box::new(format)),
            );
            let dots = |name: &str, points, color, shape| {
                Points::new(name.to_owned(), points).color(color).shape(shape).radius(4.5)
            };
            plot.points(dots(tr("mean"), means, palette.command, MarkerShape::Circle));
            plot.points(dots(tr("printed"), printed, palette.reference, MarkerShape::Diamond));
        })
        .response;
    let Progress { done, total: all, .. } = contest.runs();
    response.widget_info(|| {
        let title = title(measure, reference);
        let label = tr!(
            "Box plots of {title}, {done} of {n} runs",
            title = title,
            done = done.floor() as u64,
            n = all as u64,
        );
        WidgetInfo::labeled(Role::Figure, true, label)
    });
}
