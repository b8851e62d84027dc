//! How a formula fits: predicted against measured, and what is left over row by row, with the rows that do not fit.

use egui::{Color32, Label, RichText, Role, Stroke, Ui, WidgetInfo};
use egui_plot::{HLine, HoverPosition, Line, MarkerShape, PlotPoints, PlotUi, Points};

use super::search::FormulaSearch;
use super::symbols::{column_words, told_number};
use crate::app::format;
use crate::app::theme::{Look, Palette};
use crate::app::widgets::plot::{around, near, still};
use crate::app::widgets::standing::Standing;
use crate::base::language::{text, tr};
use crate::study::identify::gp::inspect::FormulaInspection;

/// Height of a plot, points.
const HEIGHT: f32 = 190.0;
/// Most rows that do not fit which are told in words.
const MOST: usize = 5;
/// Most rows that are drawn, evenly spread.
const MOST_DRAWN: usize = 2000;
/// Size of a mark, points.
const RADIUS: f32 = 3.5;

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

    ui.label(RichText::new(format!("{}{bracket}", tr("Predicted over measured"))).strong());
    let [low, high] = around(measured.iter().chain(&seen.predicted).copied());
    let points = split(&|row| [measured[row], seen.predicted[row]]);
    plot(ui, &PREDICTED, [[low, high], [low, high]], &points, |plot, palette| {
        let (stroke, style) = Look::Reference.line(palette);
        let ends = PlotPoints::from(vec![[low, low], [high, high]]);
        plot.line(Line::new("", ends).stroke(stroke).style(style).allow_hover(false));
        for row in (0..measured.len()).step_by(every) {
            let Some(half) = seen.bands[row] else { continue };
            let (x, y) = (measured[row], seen.predicted[row]);
            let band = PlotPoints::from(vec![[x, y - half], [x, y + half]]);
            let stroke = Stroke::new(1.0, palette.produced);
            plot.line(Line::new("", band).stroke(stroke).allow_hover(false));
        }
    });
    if seen.bands.iter().any(Option::is_some) {
        let text = tr(
            "Upright lines: the 95 % band, in which the true values lie if the formula's form is the true one.",
        );
        let weak = Palette::at(ui).weak;
        ui.add(Label::new(RichText::new(text).small().color(weak)).wrap());
    }

    ui.label(RichText::new(format!("{}{bracket}", tr("Left over, row by row"))).strong());
    let [low, high] = around(seen.residuals.iter().copied().chain([0.0]));
    let rows = [0.0, measured.len() as f64 + 1.0];
    let points = split(&|row| [row as f64 + 1.0, seen.residuals[row]]);
    plot(ui, &LEFT_OVER, [rows, [low, high]], &points, |plot, palette| {
        let (stroke, style) = Look::Reference.line(palette);
        plot.hline(HLine::new("", 0.0).stroke(stroke).style(style).allow_hover(false));
    });
    for outlier in seen.outliers.iter().take(MOST) {
        let text = tr!(
            "Row {row} does not fit: {target} = {value}, {off} off, {deviations} of its own standard deviations.",
            row = outlier.row,
            target = column_words(&problem.target),
            value = told_number(outlier.target),
            off = told_number(outlier.residual),
            deviations = told_number(outlier.studentised)
        );
        Standing::Watch.label(ui, &text, |text| text);
    }
    let more = seen.outliers.len().saturating_sub(MOST);
    if more > 0 {
        ui.add(Label::new(tr!("{n} more rows do not fit.", n = more)).wrap());
    }
}

/// The words of a plot.
struct PlotWords {
    /// What is plotted.
    what: &'static str,
    /// Over what.
    over: &'static str,
    /// What a screen reader says of its rows, and of those that do not fit.
    said: fn(usize, usize) -> String,
}

const PREDICTED: PlotWords = PlotWords {
    what: text!("predicted"),
    over: text!("measured"),
    said: |rows, apart| {
        tr!(
            "predicted over measured: {n} rows, {apart} of them do not fit",
            n = rows,
            apart = apart
        )
    },
};
const LEFT_OVER: PlotWords = PlotWords {
    what: text!("left over"),
    over: text!("row"),
    said: |rows, apart| {
        tr!("left over over row: {n} rows, {apart} of them do not fit", n = rows, apart = apart)
    },
};

/// Points that fit and points that do not, over what `back` draws behind them.
fn plot(
    ui: &mut Ui,
    words: &PlotWords,
    [across, up]: [[f64; 2]; 2],
    [fits, out]: &[Vec<[f64; 2]>; 2],
    back: impl FnOnce(&mut PlotUi<'_>, &Palette),
) {
    let palette = Palette::at(ui);
    let width = ui.available_width();
    let (what, over) = (tr(words.what), tr(words.over));
    let label = move |hover: &HoverPosition<'_>| {
        let (name, at) = near(hover)?;
        Some(format!("{name}\n{over} {}\n{what} {}", told_number(at.x), told_number(at.y)))
    };
    let marks = |name: &str, at: &[[f64; 2]], color: Color32, shape, radius| {
        Points::new(name.to_owned(), at.to_vec()).color(color).shape(shape).radius(radius)
    };
    let response = still(words.what, palette, [width, HEIGHT])
        .x_axis_label(over)
        .label_formatter(label)
        .show(ui, |plot| {
            plot.set_plot_bounds_x(across[0]..=across[1]);
            plot.set_plot_bounds_y(up[0]..=up[1]);
            back(plot, palette);
            plot.points(marks(tr("row"), fits, palette.produced, MarkerShape::Circle, RADIUS));
            let cross = MarkerShape::Cross;
            plot.points(marks(tr("row that does not fit"), out, palette.bad, cross, 2.0 * RADIUS));
        })
        .response;
    let (all, apart) = (fits.len() + out.len(), out.len());
    response.widget_info(|| WidgetInfo::labeled(Role::Figure, true, (words.said)(all, apart)));
}
