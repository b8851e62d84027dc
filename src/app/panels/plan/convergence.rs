//! Convergence: the best value, the mean of all particles, and the share of particles at an
//! allowed place, over the iterations.

use egui::{RichText, Ui};
use egui_plot::{Line, PlotPoints};

use crate::app::theme::{Look, Palette};
use crate::app::widgets::legend;
use crate::app::widgets::plot::still;
use crate::base::language::{text, tr};
use crate::base::units::percent_from_ratio;
use crate::study::plan::swarm::Iteration;

/// From this width on, points, the plots stand beside each other.
const BESIDE_FROM: f32 = 480.0;

/// A line of a plot.
struct Curve {
    /// Its name, in English.
    name: &'static str,
    look: Look,
    points: Vec<[f64; 2]>,
}

/// Both plots, each `height` points high with its title; beside each other where there is room.
pub fn show(ui: &mut Ui, history: &[Iteration], height: f32) {
    let at = |one: &Iteration, value: f64| [f64::from(one.iteration), value];
    let best = history.iter().filter(|one| one.best.feasible());
    let objective = [
        Curve {
            name: text!("mean of all particles"),
            look: Look::Setpoint,
            points: history.iter().map(|one| at(one, one.mean_value)).collect(),
        },
        Curve {
            name: text!("best allowed"),
            look: Look::Produced,
            points: best.map(|one| at(one, one.best.value)).collect(),
        },
    ];
    let fraction = [Curve {
        name: text!("particles at an allowed place [%]"),
        look: Look::Reference,
        points: history.iter().map(|one| at(one, percent_from_ratio(one.feasible_share))).collect(),
    }];
    let last = history.last().map_or(0, |one| one.iteration).max(10);
    let span = [0.0, f64::from(last)];
    let draw = |ui: &mut Ui, height: f32| {
        plot(ui, text!("Objective"), &objective, span, None, height);
    };
    let draw_share = |ui: &mut Ui, height: f32| {
        plot(ui, text!("Allowed"), &fraction, span, Some([0.0, 100.0]), height);
    };
    if ui.available_width() < BESIDE_FROM {
        draw(ui, height);
        draw_share(ui, 0.7 * height);
    } else {
        ui.columns_const(|[left, right]| {
            draw(left, height);
            draw_share(right, height);
        });
    }
}

fn plot(
    ui: &mut Ui,
    title: &'static str,
    curves: &[Curve],
    span: [f64; 2],
    range: Option<[f64; 2]>,
    height: f32,
) {
    let palette = Palette::at(ui);
    let top = ui.cursor().top();
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().interact_size.y = 14.0;
        ui.label(RichText::new(tr(title)).strong());
        for curve in curves {
            legend::sample(ui, tr(curve.name), curve.look);
        }
    });
    let values = || curves.iter().flat_map(|curve| &curve.points).map(|point| point[1]);
    let (low, high) =
        (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
    let margin = 0.08 * (high - low).max(1e-3);
    let range = range.unwrap_or([low - margin, high + margin]);
    let width = ui.available_width();
    let height = height - (ui.cursor().top() - top);
    still(title, palette, [width, height])
        .link_cursor(egui::Id::unique("iterations"), [true, false])
        .show(ui, |plot| {
            plot.set_plot_bounds_x(span[0]..=span[1]);
            plot.set_plot_bounds_y(range[0]..=range[1]);
            for curve in curves {
                let (stroke, style) = curve.look.line(palette);
                let line = Line::new(tr(curve.name), PlotPoints::from(curve.points.clone()));
                plot.line(line.stroke(stroke).style(style).allow_band(false));
            }
        });
}
