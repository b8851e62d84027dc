//! Learning curves up to the playhead: the feedback's share of the override, and NM-1's error.

use egui::{RichText, Ui};
use egui_plot::{Line, PlotPoints, VLine};

use super::BESIDE_FROM;
use crate::app::history::LearningSample;
use crate::app::panels::View;
use crate::app::theme::{Look, Palette};
use crate::app::widgets::plot::still;
use crate::base::language::{text, tr};
use crate::base::units::percent_from_ratio;
use crate::models::unks::UnksStart;

/// Titles of the curves.
const FEEDBACK: &str = text!("Feedback's share of the override [%]");
/// See [`FEEDBACK`].
const ERROR: &str = text!("Error of NM-1's prediction [%]");

/// Least and largest height of the range of values, in percent: the first moments of a cut are
/// predicted so badly that they would flatten all that follows.
const SPAN: [f64; 2] = [5.0, 50.0];

/// The curves, each `height` points high with its title.
pub fn show(ui: &mut Ui, view: &View<'_>, samples: &[LearningSample], height: f32) {
    let Some(last) = samples.last() else { return };
    let points = |of: fn(&LearningSample) -> f64| -> Vec<[f64; 2]> {
        // Before the first sample there is no mean.
        let known = samples.iter().map(|sample| [sample.time_s, percent_from_ratio(of(sample))]);
        known.filter(|[_, percent]| *percent > 0.0).collect()
    };
    let feedback = |ui: &mut Ui| {
        let points = points(|sample| sample.feedback);
        plot(ui, view, FEEDBACK, points, Look::Command, height);
    };
    let error = |ui: &mut Ui| {
        let points = points(|sample| sample.error);
        plot(ui, view, ERROR, points, Look::Produced, height);
    };
    match (last.start, ui.available_width() < BESIDE_FROM) {
        (UnksStart::Cold, _) => feedback(ui),
        (UnksStart::Shipped, true) => {
            feedback(ui);
            error(ui);
        }
        (UnksStart::Shipped, false) => ui.columns_const(|[left, right]| {
            error(left);
            feedback(right);
        }),
    }
    if last.start == UnksStart::Shipped {
        let iterations: u32 = samples.iter().map(|sample| sample.iterations).sum();
        let mean = f64::from(iterations) / samples.len() as f64;
        let now = last.iterations;
        ui.label(tr!(
            "Internal loop: {now} iterations now, {mean:.1} on average so far",
            now = now,
            mean = mean
        ));
    }
    let note = match last.start {
        UnksStart::Shipped => tr(
            "Means of the size over about a second in contact. The feedback's share is all that the \
             loops add to NM-2, where the override is between its limits.",
        ),
        UnksStart::Cold => tr(
            "Mean of its size over about a second in contact, where the override is between its \
             limits.",
        ),
    };
    ui.label(RichText::new(note).small().color(Palette::at(ui).weak));
}

fn plot(
    ui: &mut Ui,
    view: &View<'_>,
    title: &'static str,
    points: Vec<[f64; 2]>,
    look: Look,
    height: f32,
) {
    let palette = Palette::at(ui);
    ui.label(RichText::new(tr(title)).strong());
    // Of all of the run, so that the axis does not jump while playing.
    let all = view.session.chosen().learning().until(f64::INFINITY);
    let most = points.iter().map(|point| point[1]).fold(SPAN[0], f64::max).min(SPAN[1]);
    let length_s = all.last().map_or(1.0, |last| last.time_s).max(view.session.length_s());
    let playhead_s = view.session.playback().playhead_s;
    let width = ui.available_width();
    still(title, palette, [width, height])
        .link_cursor(egui::Id::unique("learning time"), [true, false])
        .show(ui, |plot| {
            // With room for the last number of the axis.
            plot.set_plot_bounds_x(0.0..=1.02 * length_s);
            plot.set_plot_bounds_y(0.0..=1.08 * most);
            let (stroke, style) = look.line(palette);
            let line = Line::new(tr(title), PlotPoints::from(points));
            plot.line(line.stroke(stroke).style(style).allow_band(false));
            plot.vline(VLine::new(tr("playhead"), playhead_s).stroke((1.0, palette.playhead)));
        });
}
