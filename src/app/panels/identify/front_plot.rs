//! The front as a picture: error against size, a click picks a formula.

use egui::{Color32, Role, Ui, Vec2, WidgetInfo};
use egui_plot::{MarkerShape, PlotPoint, Points};

use super::search::{FormulaSearch, FrontRow};
use crate::app::format::{self, log10};
use crate::app::theme::Palette;
use crate::app::widgets::focus::pointer_only;
use crate::app::widgets::legend;
use crate::app::widgets::plot::{decade, decades, decades_of, grid, still};
use crate::base::language::tr;

/// Most powers of ten of errors that are shown: what is exact lies at the lower edge.
const DECADES: f64 = 8.0;
/// How far from a point a click picks it, points.
const NEAR: f32 = 40.0;
/// Size of a mark, points.
const RADIUS: f32 = 4.5;

/// The picture, `height` points high; the size of the formula that was clicked.
pub fn show(
    ui: &mut Ui,
    search: &FormulaSearch,
    shown: Option<usize>,
    height: f32,
) -> Option<usize> {
    let palette = Palette::at(ui);
    ui.vertical(|ui| {
        marks(ui, search, palette);
        let rows = search.rows();
        let unit = format::unit(&search.asked.unit(&search.problem().target));
        let errors = rows.iter().flat_map(|row| [Some(row.error), row.left_out]).flatten();
        let [low, high] = decades_of(errors, DECADES).map(log10);
        let place = move |row: &FrontRow, error: f64| [row.size as f64, log10(error).max(low)];
        let largest = rows.iter().map(|row| row.size).max().unwrap_or(1).max(12) as f64;
        let width = ui.available_width();
        let response = still("front", palette, [width, height])
            .sense(pointer_only(false))
            .x_grid_spacer(move |input| grid(input, width / 60.0))
            .y_grid_spacer(move |input| decades(input, height))
            .y_axis_formatter(|mark, _| decade(mark))
            .x_axis_label(tr("size [nodes]"))
            .show(ui, |plot| {
                plot.set_plot_bounds_x(0.0..=largest + 1.0);
                plot.set_plot_bounds_y(low..=high);
                let of = |name: &str, at: Vec<[f64; 2]>, color: Color32, shape, filled| {
                    let points = Points::new(name.to_owned(), at).shape(shape).radius(RADIUS);
                    points.color(color).filled(filled)
                };
                let trained = rows.iter().map(|row| place(row, row.error)).collect();
                plot.points(of(tr("error"), trained, palette.produced, MarkerShape::Circle, true));
                let judged = |row: &FrontRow| Some(place(row, row.left_out?));
                let left_out: Vec<[f64; 2]> = rows.iter().filter_map(judged).collect();
                let diamond = MarkerShape::Diamond;
                plot.points(of(tr("at rows left out"), left_out, palette.command, diamond, true));
                if let Some(row) = rows.iter().find(|row| Some(row.size) == shown) {
                    let ring = Points::new(tr("looked at"), vec![place(row, row.error)]);
                    let ring = ring.shape(MarkerShape::Circle).radius(2.0 * RADIUS).filled(false);
                    plot.points(ring.color(palette.text));
                }
            });
        let clicked = response.response.clicked().then(|| {
            let at = response.response.interact_pointer_pos()?;
            let distance = |row: &FrontRow| {
                let place = |error: f64| {
                    let [x, y] = place(row, error);
                    let on_screen = response.transform.position_from_point(&PlotPoint::new(x, y));
                    Vec2::length(on_screen - at)
                };
                place(row.error).min(row.left_out.map_or(f32::INFINITY, place))
            };
            let near = rows.iter().map(|row| (row.size, distance(row)));
            let near = near.min_by(|a, b| a.1.total_cmp(&b.1))?;
            (near.1 <= NEAR).then_some(near.0)
        });
        let count = rows.len();
        response.response.widget_info(|| {
            let label = if unit.is_empty() {
                tr!("Front: error against size, {n} formulas", n = count)
            } else {
                tr!("Front: error in {unit} against size, {n} formulas", unit = unit, n = count)
            };
            WidgetInfo::labeled(Role::Figure, true, label)
        });
        clicked.flatten()
    })
    .inner
}

fn marks(ui: &mut Ui, search: &FormulaSearch, palette: &Palette) {
    let unit = format::unit(&search.asked.unit(&search.problem().target));
    let unit = if unit.is_empty() { String::new() } else { format!(" [{unit}]") };
    ui.horizontal_wrapped(|ui| {
        legend::points(
            ui,
            &format!("{}{unit}", tr("error")),
            palette.produced,
            MarkerShape::Circle,
        );
        if search.report().is_some() {
            legend::points(ui, tr("at rows left out"), palette.command, MarkerShape::Diamond);
        }
        legend::sample_of(ui, tr("looked at"), palette.text, |painter, rect, color| {
            painter.circle_stroke(rect.center(), 5.0, egui::Stroke::new(1.0, color));
        });
    });
}
