//! A chart of signals of the run against time, with the constant-feed twin, the run before the last
//! change, bands around references, and the playhead. Charts share their time axis and cursor.

mod content;
mod curves;
mod envelope;
mod places;
mod reading;

use egui::Ui;
use egui_plot::{HLine, HoverPosition, VLine};

use super::super::format;
use super::super::session::Session;
use super::super::theme::{Look, Palette};
use super::focus::pointer_only;
use super::legend;
use super::plot::{self, near, still, tick};
use super::zoom::{by_touch, zoom};
use crate::base::language::tr;
use crate::run::signals::SIGNALS;
pub use content::{Axes, Chart, ChartCurve, ChartMeasured};
use content::{BY_HAND, BY_HAND_HELP, FUTURE, FUTURE_HELP, GHOST, TWIN};
use content::{ghost_help, index, twin_help};
use curves::{band, fit_values, future_is_shown, lines};
use reading::reading;

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
    let values = fit_values(chart, session, axes);
    legend_row(ui, chart, session, axes, values);
    let height = (height - (ui.cursor().top() - top)).max(60.0);
    let width = ui.available_width();
    let range = axes.range(session);
    let palette = Palette::at(ui);
    let unit = SIGNALS[index(chart.curves[0].signal)].unit;
    let lines = lines(chart, session, axes, [range, values], width, palette);
    let band = band(chart, session, [range, values], width, palette);
    let drags = pointer_only(!by_touch(ui));
    let group = egui::Id::unique("time");
    let write = chart.write;
    let label = move |hover: &HoverPosition<'_>| {
        let (name, position) = near(hover)?;
        Some(format!(
            "{name}: {}
{}",
            write(position.y, unit),
            format::time(position.x)
        ))
    };
    let plot = still(chart.id, palette, [width, height])
        .link_cursor(group, [true, false])
        .allow_zoom([true, false])
        .sense(drags)
        .x_axis_formatter(|mark, _| format!("{} s", tick(mark)))
        .label_formatter(label);
    let response = plot::show(ui, plot, |plot| {
        plot.set_plot_bounds_x(range[0]..=range[1]);
        plot.set_plot_bounds_y(values[0]..=values[1]);
        if let Some(band) = band {
            plot.add(band);
        }
        for (name, level) in &chart.levels {
            let (stroke, style) = Look::Limit.line(palette);
            plot.hline(HLine::new(tr(name), *level).stroke(stroke).style(style));
        }
        for line in lines {
            plot.add(line);
        }
        let playhead = VLine::new("", session.playback().playhead_s).allow_hover(false);
        plot.vline(playhead.color(palette.playhead).width(1.0));
    });
    response.response.widget_info(|| {
        let [from_s, to_s] = range.map(format::time);
        let label =
            tr!("{chart} from {from} to {to}", chart = tr(chart.title), from = from_s, to = to_s);
        egui::WidgetInfo::labeled(egui::Role::Figure, true, label)
    });
    if let Some(range) = zoom(ui, &response, range, &mut axes.drag) {
        axes.zoomed = Some(range);
    } else if response.response.double_clicked() {
        axes.fit();
    }
    response.transform.frame().x_range()
}

/// The legend of what all charts compare with: the twin, the run before the last change and after it.
/// A click shows or hides it in all of them.
pub fn legend_of_all(ui: &mut Ui, session: &Session, axes: &mut Axes) {
    let spacing = ui.spacing().clone();
    ui.spacing_mut().item_spacing = egui::vec2(14.0, 1.0);
    ui.spacing_mut().interact_size.y = 14.0;
    legend::row(ui, tr("all plots"), |ui| {
        // Nothing keeps its place: it comes between two cuts.
        if session.hand_trace().is_some() {
            let key = (content::ALL, BY_HAND);
            switch(ui, axes, key, BY_HAND, Look::Hand).on_hover_text(tr(BY_HAND_HELP));
        }
        let changed = session.ghost().is_some();
        let title = session.twin_title();
        let short = !legend::has_room(ui, &title);
        let title = if short { session.twin_short() } else { title };
        let widest = Session::twin_widest(short);
        for (name, said, look, help, shown) in [
            (TWIN, title.as_str(), Look::Twin, twin_help(session).as_str(), true),
            (GHOST, GHOST, Look::Ghost, ghost_help(session).as_str(), changed),
            (FUTURE, FUTURE, Look::Future, tr(FUTURE_HELP), future_is_shown(session)),
        ] {
            // Its place is kept free: a change, in the middle of a drag mostly, moves no plot.
            let entry = |ui: &mut Ui| switch(ui, axes, (content::ALL, name), said, look);
            ui.add_visible(shown, entry).on_hover_text(help);
            if name == TWIN {
                keep_room(ui, said, &widest);
            }
        }
    });
    *ui.spacing_mut() = spacing;
}

/// Keeps the room of the widest name that an entry has: its words change while the twin's feed is being found, and move
/// no other one.
fn keep_room(ui: &mut Ui, said: &str, widest: &str) {
    let font = egui::TextStyle::Small.resolve(ui.style());
    let width = |text: &str| {
        let color = egui::Color32::PLACEHOLDER;
        ui.painter().layout_no_wrap(text.to_owned(), font.clone(), color).size().x
    };
    let missing = width(widest) - width(said);
    if missing > 0.0 {
        ui.add_space(missing);
    }
}

/// An entry of a legend, `said` in it (in English), that shows or hides its line.
fn switch(
    ui: &mut Ui,
    axes: &mut Axes,
    key: (&'static str, &'static str),
    said: &str,
    look: Look,
) -> egui::Response {
    let hidden = axes.hidden.contains(&key);
    let legend::LegendEntry { response, pressed } = legend::entry(ui, tr(said), look, hidden);
    if pressed && !axes.hidden.remove(&key) {
        axes.hidden.insert(key);
    }
    response
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
    legend::row(ui, tr(chart.title), |ui| {
        let unit = format::unit(SIGNALS[index(chart.curves[0].signal)].unit);
        let title = format!("{} [{unit}]", tr(chart.title));
        ui.add(egui::Label::new(egui::RichText::new(title).strong()));
        for curve in chart.foremost() {
            reading(ui, curve, session.row(), chart.write);
        }
        let mut entry = |ui: &mut Ui, name: &'static str, look: Look| {
            switch(ui, axes, (chart.id, name), name, look);
        };
        for curve in chart.curves {
            entry(ui, SIGNALS[index(curve.signal)].label, curve.look);
        }
        // Those out of the picture need no explanation.
        for (name, _) in chart.levels.iter().filter(|(_, level)| (low..=high).contains(level)) {
            entry(ui, name, Look::Limit);
        }
        for channel in &chart.measured {
            let hidden = !axes.shows_measured(channel.id);
            let look = Look::Measured(channel.number);
            if legend::entry(ui, &channel.name, look, hidden).pressed {
                axes.show_measured(channel.id, hidden);
            }
        }
    });
    *ui.spacing_mut() = spacing;
}
