//! The plots of this screen: lines, bands and marks over frequency, life, time or speed, with a
//! logarithmic vertical axis where wanted.

use egui::{RichText, Role, Ui, WidgetInfo};
use egui_plot::{
    FilledArea, HLine, HoverPosition, Line, MarkerShape, PlotPoint, PlotPoints, PlotResponse,
    PlotUi, Points, Text, VLine,
};

use crate::app::format::{self, log10};
use crate::app::theme::{Look, Palette};
use crate::app::widgets::legend;
use crate::app::widgets::plot::{decade, decades, grid, near, still, tick};
use crate::base::language::tr;
use crate::base::math::{extent, pow};

/// A line of a plot.
pub struct PlotCurve {
    /// Its name in the legend, in English; so are the names of all that a figure shows.
    pub name: &'static str,
    /// How it is drawn.
    pub look: Look,
    /// Its points; what is not finite is left out.
    pub points: Vec<[f64; 2]>,
}

/// Points that stand out.
pub struct Marks {
    /// What one of them is.
    pub name: &'static str,
    /// Their places.
    pub at: Vec<[f64; 2]>,
    /// Their form.
    pub shape: MarkerShape,
    /// Their colour.
    pub color: egui::Color32,
    /// Their size, points.
    pub radius: f32,
}

/// What a plot shows.
pub struct Figure {
    /// Its name.
    pub title: &'static str,
    /// Its title where the unit of the horizontal axis is too long for its numbers: with the words for that axis.
    pub long_title: &'static str,
    /// Units of the two axes.
    pub units: [&'static str; 2],
    /// Range of the horizontal axis.
    pub across: [f64; 2],
    /// Range of the vertical axis.
    pub up: [f64; 2],
    /// Whether the vertical axis is logarithmic; its range is then positive.
    pub logarithmic: bool,
    /// Lines, the first ones at the back.
    pub curves: Vec<PlotCurve>,
    /// A band: name, and places with their two values.
    pub band: Option<(&'static str, Vec<[f64; 3]>)>,
    /// Vertical lines, with their names in the chosen language.
    pub posts: Vec<(String, Look, f64)>,
    /// Horizontal lines.
    pub levels: Vec<(&'static str, Look, f64)>,
    /// Marks.
    pub marks: Vec<Marks>,
    /// Words at the upper end, with their places.
    pub tags: Vec<(f64, String)>,
}

impl Figure {
    /// A plot without anything in it.
    pub fn new(title: &'static str, units: [&'static str; 2], across: [f64; 2]) -> Self {
        Self {
            title,
            long_title: "",
            units,
            across,
            up: [0.0, 1.0],
            logarithmic: false,
            curves: Vec::new(),
            band: None,
            posts: Vec::new(),
            levels: Vec::new(),
            marks: Vec::new(),
            tags: Vec::new(),
        }
    }

    /// Title with unit, and the legend of lines, levels and band.
    pub fn legend(&self, ui: &mut Ui) {
        ui.scope(|ui| {
            ui.spacing_mut().interact_size.y = 14.0;
            ui.horizontal_wrapped(|ui| {
                self.title(ui);
                for curve in &self.curves {
                    legend::sample(ui, tr(curve.name), curve.look);
                }
                for (name, look, _) in &self.levels {
                    legend::sample(ui, tr(name), *look);
                }
                if let Some((name, _)) = &self.band {
                    let color = Palette::at(ui).accent;
                    legend::sample_of(ui, tr(name), color, |painter, rect, color| {
                        let bar = rect.shrink2(egui::vec2(0.0, 0.25 * rect.height()));
                        painter.rect_filled(bar, 2.0, color.gamma_multiply(BAND));
                    });
                }
                for marks in &self.marks {
                    legend::points(ui, tr(marks.name), marks.color, marks.shape);
                }
            });
        });
    }

    /// Its title with its units.
    fn title(&self, ui: &mut Ui) {
        let [across, up] = self.units;
        let text = match (up.is_empty(), long(across)) {
            (_, true) => tr(self.long_title).to_owned(),
            (true, false) => tr(self.title).to_owned(),
            (false, false) => format!("{} [{}]", tr(self.title), format::unit(up)),
        };
        ui.label(RichText::new(text).strong());
    }

    fn place(&self, value: f64) -> f64 {
        if self.logarithmic { log10(value) } else { value }
    }

    fn points(&self, points: &[[f64; 2]]) -> PlotPoints<'static> {
        let placed = points.iter().map(|[x, y]| [*x, self.place(*y)]);
        PlotPoints::from(placed.filter(|[_, y]| y.is_finite()).collect::<Vec<_>>())
    }

    /// Draws the plot, `height` points high with its axis, and what `more` adds to it.
    pub fn show(&self, ui: &mut Ui, height: f32, sense: egui::Sense) -> PlotResponse<()> {
        let palette = Palette::at(ui);
        let width = ui.available_width();
        let [across_unit, up_unit] = self.units;
        let logarithmic = self.logarithmic;
        let label = move |hover: &HoverPosition<'_>| {
            let (name, position) = near(hover)?;
            let value = if logarithmic { pow(10.0, position.y) } else { position.y };
            let at = format::fine(position.x, across_unit);
            Some(format!("{name}: {}\n{at}", format::fine(value, up_unit)))
        };
        let response = still(self.title, palette, [width, height])
            .sense(sense)
            .y_grid_spacer(move |input| match logarithmic {
                true => decades(input, height),
                false => grid(input, height / 27.0),
            })
            .x_axis_formatter(move |mark, _| match long(across_unit) {
                true => tick(mark),
                false => format!("{} {across_unit}", tick(mark)),
            })
            .y_axis_formatter(move |mark, _| match logarithmic {
                true => decade(mark),
                false => tick(mark),
            })
            .label_formatter(label)
            .show(ui, |plot| {
                // With room for the last number of the axis.
                let [from, to] = self.across;
                plot.set_plot_bounds_x(from..=to + 0.025 * (to - from));
                plot.set_plot_bounds_y(self.place(self.up[0])..=self.place(self.up[1]));
                self.draw(plot, palette);
            });
        response.response.widget_info(|| {
            let [from, to] = self.across.map(|x| format::fine(x, across_unit));
            let title = tr(self.title);
            let label = tr!("{title} from {from} to {to}", title = title, from = from, to = to);
            WidgetInfo::labeled(Role::Figure, true, label)
        });
        response
    }

    fn draw(&self, plot: &mut PlotUi<'_>, palette: &Palette) {
        if let Some((name, band)) = &self.band {
            let column = |i: usize| band.iter().map(|row| row[i]).collect::<Vec<f64>>();
            let area = FilledArea::new(tr(name), &column(0), &column(1), &column(2));
            plot.add(area.fill_color(palette.accent.gamma_multiply(BAND)).allow_hover(false));
        }
        for (name, look, at) in &self.posts {
            let (stroke, style) = look.line(palette);
            plot.vline(VLine::new(name.clone(), *at).stroke(stroke).style(style));
        }
        for (name, look, at) in &self.levels {
            let (stroke, style) = look.line(palette);
            plot.hline(HLine::new(tr(name), self.place(*at)).stroke(stroke).style(style));
        }
        for curve in &self.curves {
            let (stroke, style) = curve.look.line(palette);
            let line = Line::new(tr(curve.name), self.points(&curve.points));
            plot.line(line.stroke(stroke).style(style).allow_band(false));
        }
        for (x, text) in &self.tags {
            let at = PlotPoint::new(*x, self.place(self.up[1]));
            let text = RichText::new(text).small().color(palette.weak);
            plot.text(Text::new("", at, text).anchor(egui::Align2::LEFT_TOP).allow_hover(false));
        }
        for marks in &self.marks {
            let points = Points::new(tr(marks.name), self.points(&marks.at));
            let points = points.shape(marks.shape).radius(marks.radius).color(marks.color);
            plot.points(points);
        }
    }
}

/// Whether a unit is too long to stand behind every number of an axis.
fn long(unit: &str) -> bool {
    unit.len() > 3
}

/// Opacity of a band.
const BAND: f32 = 0.22;

/// A range that holds all finite `values` with a margin at both ends.
pub fn range_of(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let [low, high] = extent(values.filter(|x| x.is_finite()));
    if low > high {
        return [0.0, 1.0];
    }
    let margin = 0.08 * (high - low).max(1e-9);
    [low - margin, high + margin]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_hold_their_values_and_survive_none() {
        let [low, high] = range_of([2.0, 5.0, f64::NAN].into_iter());
        assert!(low < 2.0 && high > 5.0 && high < 6.0);
        assert_eq!(range_of(std::iter::empty()), [0.0, 1.0]);
    }
}
