//! The map: cutting speed across, feed per tooth up, the force as colour, and the swarm over it.

use egui::{Color32, PointerButton, Pos2, Rect, Stroke, Ui, WidgetInfo, vec2};
use egui_plot::{Line, Plot, PlotImage, PlotPoint, PlotPoints, PlotTransform, VLine};

use super::layers::{Layers, MapLayer};
use super::marks::{self, Moving};
use super::picture::Polyline;
use super::readout::readout;
use super::search::Found;
use crate::app::format;
use crate::app::theme::{Look, Palette};
use crate::app::widgets::focus::pointer_only;
use crate::app::widgets::plot::{grid, tick};
use crate::app::widgets::touch;
use crate::app::widgets::zoom::by_touch;
use crate::run::scenario::Scenario;
use crate::study::plan::constraints::CONSTRAINTS;
use crate::study::plan::problem::{CUTTING_SPEED_M_MIN, FEED_PER_TOOTH_MM, Problem};

/// What of the map is seen, and the place that was clicked.
#[derive(Clone, Debug, Default)]
pub struct Map {
    /// What is shown.
    pub layers: Layers,
    /// The place whose values stay below the map: cutting speed in m/min, feed per tooth in mm.
    pub pinned: Option<[f64; 2]>,
    /// The part that is to be shown from the next frame on.
    wanted: Option<Part>,
}

/// A part of the map.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Part {
    /// All of it.
    All,
    /// Ranges of cutting speed in m/min and feed per tooth in mm.
    Ranges([[f64; 2]; 2]),
}

/// The programmed values of a scenario as cutting speed in m/min and feed per tooth in mm.
#[must_use]
pub fn programmed(problem: &Problem, scenario: &Scenario) -> [f64; 2] {
    let (tool, program) = (problem.tool(), &scenario.program);
    let cutting_speed_m_min = program.spindle_rpm / tool.speed_rpm(1.0);
    [cutting_speed_m_min, program.feed_mm_min / tool.feed_mm_min(1.0, program.spindle_rpm)]
}

/// Whether a place lies on the map.
#[must_use]
pub fn on_the_map([cutting_speed_m_min, feed_per_tooth_mm]: [f64; 2]) -> bool {
    let within = |[low, high]: [f64; 2], x: f64| (low..=high).contains(&x);
    within(CUTTING_SPEED_M_MIN, cutting_speed_m_min) && within(FEED_PER_TOOTH_MM, feed_per_tooth_mm)
}

impl Map {
    /// Draws it `height` points high.
    pub fn show(&mut self, ui: &mut Ui, found: &mut Found, moving: &Moving<'_>, height: f32) {
        let palette = Palette::at(ui);
        let dark = ui.visuals().dark_mode;
        let texture = found.picture.texture(ui.ctx(), palette, dark);
        let drags = pointer_only(!by_touch(ui));
        let width = ui.available_width();
        let picture = &found.picture;
        let wanted = self.wanted.take();
        let plot = Plot::new("force map")
            .height(height)
            .allow_drag(false)
            .allow_scroll(false)
            .boxed_zoom_pointer_button(PointerButton::Primary)
            .allow_axis_zoom_drag(false)
            .sense(drags)
            .set_margin_fraction(egui::Vec2::splat(0.025))
            .show_x(false)
            .show_y(false)
            .show_grid(false)
            .x_grid_spacer(move |input| grid(input, width / 80.0))
            .y_grid_spacer(move |input| grid(input, height / 40.0))
            .x_axis_formatter(|mark, _| tick(mark))
            .y_axis_formatter(|mark, _| tick(mark))
            .grid_spacing(egui::Rangef::new(16.0, 300.0))
            .x_axis_label("cutting speed [m/min]")
            .y_axis_label("feed per tooth [mm]")
            .label_formatter(|_| None);
        let response = plot.show(ui, |plot| {
            match wanted {
                Some(Part::All) => plot.set_auto_bounds(true),
                Some(Part::Ranges([x, y])) => {
                    plot.set_plot_bounds_x(x[0]..=x[1]);
                    plot.set_plot_bounds_y(y[0]..=y[1]);
                }
                None => {}
            }
            let [x, y] = [CUTTING_SPEED_M_MIN, FEED_PER_TOOTH_MM];
            let middle = PlotPoint::new(0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1]));
            let size = [(x[1] - x[0]) as f32, (y[1] - y[0]) as f32];
            plot.image(PlotImage::new("", texture, middle, size).allow_hover(false));
            if self.layers.show(MapLayer::ForceLines) {
                let color = palette.text.gamma_multiply(0.35);
                for line in picture.force_lines().iter().flat_map(|(_, lines)| lines) {
                    plot.line(quiet(line, Stroke::new(0.8, color)));
                }
            }
            if let Some(speed) = found.fixed_speed_m_min() {
                let (stroke, style) = Look::Searched.line(palette);
                plot.vline(VLine::new("", speed).stroke(stroke).style(style).allow_hover(false));
            }
            for number in 0..CONSTRAINTS.len() {
                if !self.layers.show(MapLayer::Boundary(number)) {
                    continue;
                }
                let (stroke, style) = Look::Constraint(number).line(palette);
                for line in &picture.boundary(number).lines {
                    // On a lighter bed it is seen on any colour of the map.
                    let under = bed(palette, dark);
                    plot.line(quiet(line, Stroke::new(stroke.width + 2.0, under)));
                    plot.line(quiet(line, stroke).style(style));
                }
            }
        });
        let transform = response.transform;
        self.overlay(ui, found, moving, &transform);
        let name = name(found);
        response.response.widget_info(|| WidgetInfo::labeled(egui::Role::Figure, true, &name));
        let place = |at: Pos2| {
            let point = transform.value_from_position(at);
            [point.x, point.y]
        };
        if response.response.clicked()
            && let Some(at) = response.response.interact_pointer_pos()
        {
            self.pinned = Some(place(at)).filter(|point| on_the_map(*point));
        }
        let problem = &found.problem;
        if let Some(point) = response.response.hover_pos().map(place).filter(|p| on_the_map(*p)) {
            let hovered = response.response.on_hover_cursor(egui::CursorIcon::Crosshair);
            hovered.on_hover_ui_at_pointer(|ui| readout(ui, problem, point));
        }
    }

    /// The buttons that choose what part of it is shown.
    pub fn parts(&mut self, ui: &mut Ui, found: &Found) {
        let allowed = found.picture.allowed();
        let button = touch::small(ui, egui::Button::new("Zoom to allowed"));
        let response = ui.add_enabled(allowed.is_some(), button);
        let response = response.on_hover_text("Shows the part of the map that holds allowed cuts");
        if response.on_disabled_hover_text("There are none on the map").clicked() {
            self.wanted = allowed.map(Part::Ranges);
        }
        let help = "Shows the whole map, as a double-click on it does; a drag on it zooms";
        let button = touch::small(ui, egui::Button::new("Whole map"));
        if ui.add(button).on_hover_text(help).clicked() {
            self.wanted = Some(Part::All);
        }
    }

    /// What stands above lines and colours: labels, particles, marks.
    fn overlay(&self, ui: &Ui, found: &Found, moving: &Moving<'_>, transform: &PlotTransform) {
        let palette = Palette::at(ui);
        let frame = *transform.frame();
        let painter = ui.painter().with_clip_rect(frame);
        let at = |[x, y]: [f64; 2]| transform.position_from_point(&PlotPoint::new(x, y));
        let mut taken: Vec<Rect> = Vec::new();
        for (number, constraint) in CONSTRAINTS.iter().enumerate() {
            let lines = &found.picture.boundary(number).lines;
            if self.layers.show(MapLayer::Boundary(number)) {
                let color = palette.constraints[number];
                label(ui, &painter, lines, &at, constraint.label, color, &mut taken);
            }
        }
        if self.layers.show(MapLayer::ForceLines) {
            for (force_n, lines) in found.picture.force_lines() {
                let text = format::quantity(*force_n, "N").replace(".0 ", " ");
                label(ui, &painter, lines, &at, &text, palette.weak, &mut taken);
            }
        }
        marks::all(&painter, palette, found, &self.layers, moving, &at);
    }
}

/// What lies under a line so that it is seen on any colour of the map.
fn bed(palette: &Palette, dark: bool) -> Color32 {
    if dark { Color32::from_black_alpha(140) } else { palette.card.gamma_multiply(0.6) }
}

fn quiet(line: &Polyline, stroke: Stroke) -> Line<'static> {
    Line::new("", PlotPoints::from(line.clone()))
        .stroke(stroke)
        .allow_hover(false)
        .allow_band(false)
}

/// Writes a label on the longest visible line, where no other one stands.
fn label(
    ui: &Ui,
    painter: &egui::Painter,
    lines: &[Polyline],
    at: &dyn Fn([f64; 2]) -> Pos2,
    text: &str,
    color: Color32,
    taken: &mut Vec<Rect>,
) {
    let palette = Palette::at(ui);
    let font = egui::TextStyle::Small.resolve(ui.style());
    let galley = painter.layout_no_wrap(text.to_owned(), font, color);
    let inside = painter.clip_rect().shrink2(0.5 * galley.size() + vec2(4.0, 3.0));
    // Near the right end first: the allowed cuts lie at the left mostly.
    for point in lines.iter().flat_map(|line| line.iter().rev().step_by(3)) {
        let place = Rect::from_center_size(at(*point), galley.size()).expand2(vec2(3.0, 1.0));
        if !inside.contains(place.center()) || taken.iter().any(|other| other.intersects(place)) {
            continue;
        }
        painter.rect_filled(place, 3.0, palette.card);
        painter.galley(place.min + vec2(3.0, 1.0), galley, color);
        taken.push(place);
        return;
    }
}

/// What a screen reader says of the map.
fn name(found: &Found) -> String {
    let optimum = found.optimum();
    let best = if found.stage().counts.done { "optimum" } else { "best so far" };
    format!(
        "Force over cutting speed and feed per tooth; {best} at {} and {}",
        format::quantity(optimum.cutting_speed_m_min, "m/min"),
        format::fine(optimum.feed_per_tooth_mm, "mm"),
    )
}
