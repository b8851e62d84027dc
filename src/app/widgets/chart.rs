//! A chart of signals of the run against time, with the constant-feed twin, the run before the last
//! change, bands around references, and the playhead. Charts share their time axis and cursor.

use std::collections::BTreeSet;

use egui::Ui;
use egui_plot::{GridInput, GridMark, HLine, HoverPosition, Plot, VLine};

use super::super::format::{self, log10};
use super::super::session::Session;
use super::super::theme::{self, Look, Palette};
use super::curves::{band, fit_values, lines};
use super::legend;
use super::reading::reading;
use super::zoom::{by_touch, zoom};
use crate::run::signals::SIGNALS;

/// One signal in a chart.
#[derive(Clone, Copy, Debug)]
pub struct ChartCurve {
    /// Its id in the table of signals.
    pub signal: &'static str,
    /// How it is drawn.
    pub look: Look,
    /// Whether the twin and the run before the last change are drawn with it.
    pub compared: bool,
}

/// What a chart shows.
#[derive(Clone, Debug)]
pub struct Chart<'a> {
    /// Its name for the program.
    pub id: &'static str,
    /// Its title.
    pub title: &'static str,
    /// Its signals, the first ones at the back; all of one unit.
    pub curves: &'a [ChartCurve],
    /// A signal with the half-width of the band around it, as a share of it.
    pub band: Option<(&'static str, f64)>,
    /// Levels that are marked, with their names.
    pub levels: Vec<(&'static str, f64)>,
    /// Values that are always in the picture.
    pub include: &'static [f64],
    /// How its values are written: the value and its unit as the tables have it.
    pub write: fn(f64, &str) -> String,
}

impl<'a> Chart<'a> {
    /// The curves that it is about: those compared with the twin, or else all.
    fn foremost(&self) -> impl Iterator<Item = &'a ChartCurve> {
        let any = self.curves.iter().any(|curve| curve.compared);
        self.curves.iter().filter(move |curve| curve.compared || !any)
    }
}

/// What charts with a common time axis share.
#[derive(Clone, Debug, Default)]
pub struct Axes {
    /// Range of time that was zoomed to, s.
    zoomed: Option<[f64; 2]>,
    /// Where a drag over a range of time began, points.
    drag: Option<f32>,
    /// Legend entries switched off: chart and name.
    pub(super) hidden: BTreeSet<(&'static str, &'static str)>,
}

/// The legend's name of the twin.
pub(super) const TWIN: &str = "constant feed";
/// The legend's name of the run before the last change.
pub(super) const GHOST: &str = "before";

impl Axes {
    /// The range of time in the picture.
    #[must_use]
    pub fn range(&self, session: &Session) -> [f64; 2] {
        if let Some(range) = self.zoomed {
            return range;
        }
        let playback = session.playback();
        let length_s = session.length_s();
        if !playback.follow || length_s <= theme::FOLLOW_S {
            return [0.0, length_s];
        }
        // The playhead stands near the right edge, with some room for what is to come.
        let right = (playback.playhead_s + 0.1 * theme::FOLLOW_S).clamp(theme::FOLLOW_S, length_s);
        [right - theme::FOLLOW_S, right]
    }

    /// Back to the automatic range.
    pub fn fit(&mut self) {
        self.zoomed = None;
    }
}

/// Index of a signal in the table.
pub(super) fn index(id: &str) -> usize {
    SIGNALS.iter().position(|signal| signal.id == id).expect("charts name signals of the table")
}

/// Draws the chart into `ui`, `height` points high with its title and legend; gives back where
/// its time axis lies.
pub fn show(
    ui: &mut Ui,
    chart: &Chart,
    session: &Session,
    axes: &mut Axes,
    height: f32,
) -> egui::Rangef {
    let top = ui.cursor().top();
    let values = fit_values(chart, session, axes.zoomed);
    legend_row(ui, chart, session, axes, values);
    let height = (height - (ui.cursor().top() - top)).max(60.0);
    let width = ui.available_width();
    let range = axes.range(session);
    let palette = Palette::at(ui);
    let unit = SIGNALS[index(chart.curves[0].signal)].unit;
    let lines = lines(chart, session, axes, [range, values], width, palette);
    let band = band(chart, session, range, width, palette);
    let drags = if by_touch(ui) { egui::Sense::click() } else { egui::Sense::click_and_drag() };
    let group = egui::Id::unique("time");
    let write = chart.write;
    let label = move |hover: &HoverPosition<'_>| match hover {
        HoverPosition::NearDataPoint { plot_name, position, .. } if !plot_name.is_empty() => {
            let value = write(position.y, unit);
            Some(format!("{plot_name}: {value}\n{}", format::time(position.x)))
        }
        _ => None,
    };
    let response = still(chart.id, palette, [width, height])
        .link_cursor(group, [true, false])
        .allow_zoom([true, false])
        .sense(drags)
        .x_axis_formatter(|mark, _| format!("{} s", tick(mark)))
        .label_formatter(label)
        .show(ui, |plot| {
            plot.set_plot_bounds_x(range[0]..=range[1]);
            plot.set_plot_bounds_y(values[0]..=values[1]);
            if let Some(band) = band {
                plot.add(band);
            }
            for (name, level) in &chart.levels {
                let (stroke, style) = Look::Limit.line(palette);
                plot.hline(HLine::new(*name, *level).stroke(stroke).style(style));
            }
            for line in lines {
                plot.line(line);
            }
            let playhead = VLine::new("", session.playback().playhead_s).allow_hover(false);
            plot.vline(playhead.color(palette.playhead).width(1.0));
        });
    response.response.widget_info(|| {
        let [from_s, to_s] = range.map(format::time);
        let label = format!("{} from {from_s} to {to_s}", chart.title);
        egui::WidgetInfo::labeled(egui::Role::Figure, true, label)
    });
    if let Some(range) = zoom(ui, &response, range, &mut axes.drag) {
        axes.zoomed = Some(range);
    } else if response.response.double_clicked() {
        axes.fit();
    }
    response.transform.frame().x_range()
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
        .y_axis_min_width(44.0)
        .grid_color(palette.grid)
        .grid_fade(0.0)
        .x_grid_spacer(move |input| grid(input, width / 80.0))
        .y_grid_spacer(move |input| grid(input, height / 27.0))
        .x_axis_formatter(|mark, _| tick(mark))
        .y_axis_formatter(|mark, _| tick(mark))
        .grid_spacing(egui::Rangef::new(16.0, 300.0))
}

/// Grid lines at round values, about as many as asked for.
pub fn grid(input: GridInput, count: f32) -> Vec<GridMark> {
    let (low, high) = input.bounds;
    let Some(step) = format::round_step((high - low) / f64::from(count.max(1.0))) else {
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

/// Title with unit, the values at the playhead, and the entries of the legend.
fn legend_row(
    ui: &mut Ui,
    chart: &Chart,
    session: &Session,
    axes: &mut Axes,
    [low, high]: [f64; 2],
) {
    let spacing = ui.spacing().clone();
    ui.spacing_mut().item_spacing = egui::vec2(10.0, 1.0);
    ui.spacing_mut().interact_size.y = 14.0;
    ui.horizontal_wrapped(|ui| {
        let unit = format::unit(SIGNALS[index(chart.curves[0].signal)].unit);
        ui.add(egui::Label::new(egui::RichText::new(format!("{} [{unit}]", chart.title)).strong()));
        for curve in chart.foremost() {
            reading(ui, curve, session.row(), chart.write);
        }
        let mut entry = |name: &'static str, look: Look| {
            let key = (chart.id, name);
            let hidden = axes.hidden.contains(&key);
            if legend::entry(ui, name, look, hidden).clicked() && !axes.hidden.remove(&key) {
                axes.hidden.insert(key);
            }
        };
        for curve in chart.curves {
            entry(SIGNALS[index(curve.signal)].label, curve.look);
        }
        if chart.curves.iter().any(|curve| curve.compared) {
            entry(TWIN, Look::Twin);
            if session.ghost().is_some() {
                entry(GHOST, Look::Ghost);
            }
        }
        // Those out of the picture need no explanation.
        for (name, _) in chart.levels.iter().filter(|(_, level)| (low..=high).contains(level)) {
            entry(name, Look::Limit);
        }
    });
    *ui.spacing_mut() = spacing;
}
