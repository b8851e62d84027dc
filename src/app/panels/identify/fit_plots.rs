//! How a formula fits: predicted against measured, and what is left over row by row, with the rows that do not fit.

use egui::{Color32, Label, RichText, Role, Ui, WidgetInfo};
use egui_plot::{HLine, HoverPosition, Line, MarkerShape, PlotPoints, PlotUi, Points};

use super::search::FormulaSearch;
use crate::app::format;
use crate::app::theme::{Look, Palette};
use crate::app::widgets::plot::{near, still};
use crate::app::widgets::standing::Standing;
use crate::base::equation::number;
use crate::base::math::extent;
use crate::study::identify::gp::inspect::FormulaInspection;

/// Height of a plot, points.
const HEIGHT: f32 = 190.0;
/// Most rows that do not fit which are told in words.
const MOST: usize = 5;
/// Most rows that are drawn, evenly spread.
const MOST_DRAWN: usize = 2000;
/// Size of a mark, points.
const RADIUS: f32 = 3.5;

/// A range that holds all values, with a margin.
fn around(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let [low, high] = extent(values.filter(|x| x.is_finite()));
    if low > high {
        return [0.0, 1.0];
    }
    let margin = (0.08 * (high - low)).max(1e-9 * high.abs().max(1e-9));
    [low - margin, high + margin]
}

/// Both plots.
pub fn show(ui: &mut Ui, search: &FormulaSearch, seen: &FormulaInspection) {
    let problem = search.problem();
    let unit = format::unit(&search.asked.unit(&problem.target));
    let bracket = if unit.is_empty() { String::new() } else { format!(" [{unit}]") };
    let measured = &problem.rows.target;
    let outlying = |row: usize| seen.outliers.iter().any(|outlier| outlier.row == row + 1);
    let every = measured.len().div_ceil(MOST_DRAWN).max(1);
    let split = |of: &dyn Fn(usize) -> [f64; 2]| -> [Vec<[f64; 2]>; 2] {
        let rows = (0..measured.len()).filter(|row| row % every == 0 || outlying(*row));
        let (out, fits): (Vec<usize>, Vec<usize>) = rows.partition(|row| outlying(*row));
        [fits, out].map(|rows| rows.into_iter().map(of).collect())
    };

    ui.label(RichText::new(format!("Predicted over measured{bracket}")).strong());
    let [low, high] = around(measured.iter().chain(&seen.predicted).copied());
    let points = split(&|row| [measured[row], seen.predicted[row]]);
    plot(ui, "predicted", [[low, high], [low, high]], &points, "measured", |plot, palette| {
        let (stroke, style) = Look::Reference.line(palette);
        let ends = PlotPoints::from(vec![[low, low], [high, high]]);
        plot.line(Line::new("", ends).stroke(stroke).style(style).allow_hover(false));
    });

    ui.label(RichText::new(format!("Left over, row by row{bracket}")).strong());
    let [low, high] = around(seen.residuals.iter().copied().chain([0.0]));
    let rows = [0.0, measured.len() as f64 + 1.0];
    let points = split(&|row| [row as f64 + 1.0, seen.residuals[row]]);
    plot(ui, "left over", [rows, [low, high]], &points, "row", |plot, palette| {
        let (stroke, style) = Look::Reference.line(palette);
        plot.hline(HLine::new("", 0.0).stroke(stroke).style(style).allow_hover(false));
    });
    for outlier in seen.outliers.iter().take(MOST) {
        let text = format!(
            "Row {} does not fit: {} = {}, {} off, {} of its own standard deviations.",
            outlier.row,
            problem.target,
            number(outlier.target),
            number(outlier.residual),
            number(outlier.studentised)
        );
        Standing::Watch.label(ui, &text, |text| text);
    }
    let more = seen.outliers.len().saturating_sub(MOST);
    if more > 0 {
        ui.add(Label::new(format!("{more} more rows do not fit.")).wrap());
    }
}

/// Points that fit and points that do not, over what `back` draws behind them.
fn plot(
    ui: &mut Ui,
    what: &'static str,
    [across, up]: [[f64; 2]; 2],
    [fits, out]: &[Vec<[f64; 2]>; 2],
    over: &'static str,
    back: impl FnOnce(&mut PlotUi<'_>, &Palette),
) {
    let palette = Palette::at(ui);
    let width = ui.available_width();
    let label = move |hover: &HoverPosition<'_>| {
        let (name, at) = near(hover)?;
        Some(format!("{name}\n{over} {}\n{what} {}", number(at.x), number(at.y)))
    };
    let marks = |name: &str, at: &[[f64; 2]], color: Color32, shape, radius| {
        Points::new(name.to_owned(), at.to_vec()).color(color).shape(shape).radius(radius)
    };
    let response = still(what, palette, [width, HEIGHT])
        .x_axis_label(over)
        .label_formatter(label)
        .show(ui, |plot| {
            plot.set_plot_bounds_x(across[0]..=across[1]);
            plot.set_plot_bounds_y(up[0]..=up[1]);
            back(plot, palette);
            plot.points(marks("row", fits, palette.produced, MarkerShape::Circle, RADIUS));
            let cross = MarkerShape::Cross;
            plot.points(marks("row that does not fit", out, palette.bad, cross, 2.0 * RADIUS));
        })
        .response;
    let (all, apart) = (fits.len() + out.len(), out.len());
    response.widget_info(|| {
        let label = format!("{what} over {over}: {all} rows, {apart} of them do not fit");
        WidgetInfo::labeled(Role::Figure, true, label)
    });
}
