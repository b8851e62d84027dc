//! The map: cutting speed across, feed per tooth up, the force as colour, and the swarm over it.

use egui::{Color32, PointerButton, Pos2, Rect, Sense, Stroke, Ui, WidgetInfo, pos2, vec2};
use egui_plot::{Line, Plot, PlotImage, PlotPoint, PlotPoints, PlotTransform, VLine};

use super::layers::{self, Layer, Layers};
use super::picture::Polyline;
use super::search::Found;
use crate::app::theme::{self, Look, Palette};
use crate::app::widgets::chart::{grid, tick};
use crate::app::widgets::icon::{self, Icon};
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

/// Everything that moves on the map.
pub struct Moving<'a> {
    /// Where the particles are drawn.
    pub positions: &'a [[f64; 2]],
    /// The programmed values as cutting speed in m/min and feed per tooth in mm.
    pub programmed: [f64; 2],
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
        let drags = if by_touch(ui) { Sense::click() } else { Sense::click_and_drag() };
        let width = ui.available_width();
        let picture = &found.picture;
        let fixed_m_min = match found.job.problem().range()[0] {
            [low, high] if low == high => Some(low),
            _ => None,
        };
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
            if self.layers.show(Layer::ForceLines) {
                let color = palette.text.gamma_multiply(0.35);
                for line in picture.force_lines().iter().flat_map(|(_, lines)| lines) {
                    plot.line(quiet(line, Stroke::new(0.8, color)));
                }
            }
            if let Some(speed) = fixed_m_min {
                let (stroke, style) = Look::Searched.line(palette);
                plot.vline(VLine::new("", speed).stroke(stroke).style(style).allow_hover(false));
            }
            for number in 0..CONSTRAINTS.len() {
                if !self.layers.show(Layer::Boundary(number)) {
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
        let problem = found.job.problem();
        if let Some(point) = response.response.hover_pos().map(place).filter(|p| on_the_map(*p)) {
            let hovered = response.response.on_hover_cursor(egui::CursorIcon::Crosshair);
            hovered.on_hover_ui_at_pointer(|ui| readout(ui, problem, point));
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
            if self.layers.show(Layer::Boundary(number)) {
                let color = palette.constraints[number];
                label(ui, &painter, lines, &at, constraint.label, color, &mut taken);
            }
        }
        if self.layers.show(Layer::ForceLines) {
            for (force_n, lines) in found.picture.force_lines() {
                let text = theme::quantity(*force_n, "N").replace(".0 ", " ");
                label(ui, &painter, lines, &at, &text, palette.weak, &mut taken);
            }
        }
        let particles = found.job.particles();
        if self.layers.show(Layer::OwnBests) {
            for particle in particles {
                layers::own_best(&painter, at(particle.best_position), palette);
            }
        }
        if self.layers.show(Layer::Particles) {
            for (place, particle) in moving.positions.iter().zip(particles) {
                layers::particle(&painter, at(*place), particle.score.feasible(), palette);
            }
        }
        if self.layers.show(Layer::Programmed) {
            layers::programmed(&painter, at(moving.programmed), palette);
        }
        if self.layers.show(Layer::Best) {
            let ended = found.job.progress().done;
            let optimum = found.job.optimum();
            let point = [optimum.cutting_speed_m_min, optimum.feed_per_tooth_mm];
            layers::best(&painter, at(point), ended, palette);
        }
        if let Some(point) = self.pinned {
            painter.circle_stroke(at(point), 6.0, Stroke::new(2.0, palette.bad));
        }
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
        painter.rect_filled(place, 3.0, palette.card.gamma_multiply(0.85));
        painter.galley(place.min + vec2(3.0, 1.0), galley, color);
        taken.push(place);
        return;
    }
}

/// What a screen reader says of the map.
fn name(found: &Found) -> String {
    let optimum = found.job.optimum();
    let best = if found.job.progress().done { "optimum" } else { "best so far" };
    format!(
        "Force over cutting speed and feed per tooth; {best} at {} and {}",
        theme::quantity(optimum.cutting_speed_m_min, "m/min"),
        theme::fine(optimum.feed_per_tooth_mm, "mm"),
    )
}

/// The values at a place, and what forbids it.
pub fn readout(ui: &mut Ui, problem: &Problem, point: [f64; 2]) {
    let palette = Palette::at(ui);
    let cut = problem.cut(point);
    let lines = [
        ("Cutting speed", theme::quantity(point[0], "m/min")),
        ("Feed per tooth", theme::fine(point[1], "mm")),
        ("Spindle speed", theme::quantity(cut.speed_rpm, "1/min")),
        ("Feed", theme::quantity(cut.feed_mm_min, "mm/min")),
        ("Force", theme::quantity(cut.force_n, "N")),
        ("Ra of feed marks", theme::quantity(cut.ra_um, "um")),
        ("Spindle power", theme::quantity(cut.power_kw, "kW")),
        ("Deflection", theme::fine(cut.deflection_mm, "mm")),
        ("Tool life", theme::quantity(cut.tool_life_min, "min")),
    ];
    ui.style_mut().wrap_mode = Some(egui::TextWrapMode::Extend);
    ui.spacing_mut().interact_size.y = 14.0;
    egui::Grid::new("readout").num_columns(2).spacing([12.0, 1.0]).show(ui, |ui| {
        for (name, value) in lines {
            ui.label(egui::RichText::new(name).color(palette.weak));
            ui.label(value);
            ui.end_row();
        }
    });
    let checked = problem.check(point);
    let violated: Vec<&str> =
        checked.iter().filter(|one| one.violation > 0.0).map(|one| one.constraint.label).collect();
    if violated.is_empty() {
        ui.label(egui::RichText::new("allowed").color(palette.good).strong());
    } else {
        let text = format!("violated: {}", violated.join(", "));
        ui.label(egui::RichText::new(text).color(palette.bad).strong());
    }
}

/// The row above the map: the scale of its colours, and what part of it is shown.
pub fn head(ui: &mut Ui, map: &mut Map, found: &Found) {
    ui.horizontal_wrapped(|ui| {
        scale(ui, found);
        let allowed = found.picture.allowed();
        let button = egui::Button::new("Zoom to allowed").small();
        let response = ui.add_enabled(allowed.is_some(), button);
        let response = response.on_hover_text("Shows the part of the map that holds allowed cuts");
        if response.on_disabled_hover_text("There are none on the map").clicked() {
            map.wanted = allowed.map(Part::Ranges);
        }
        let help = "Shows the whole map, as a double-click on it does; a drag on it zooms";
        if ui.small_button("Whole map").on_hover_text(help).clicked() {
            map.wanted = Some(Part::All);
        }
    });
}

/// The scale of the colours: what is allowed, and below it what is not.
fn scale(ui: &mut Ui, found: &Found) {
    const SIZE: egui::Vec2 = vec2(110.0, 12.0);
    const STEPS: usize = 40;
    let palette = Palette::at(ui);
    let [low, high] = found.picture.range_n();
    ui.label(egui::RichText::new(theme::quantity(low, "N")).small().color(palette.weak));
    let (rect, response) = ui.allocate_exact_size(SIZE, Sense::hover());
    let said = "Force: in colour where the cut is allowed, grey where a constraint forbids it";
    response.widget_info(|| WidgetInfo::labeled(egui::Role::Label, true, said));
    for step in 0..STEPS {
        let share = step as f32 / STEPS as f32;
        let force_n = low + (high - low) * f64::from(share);
        let left = rect.left() + share * rect.width();
        let right = left + rect.width() / STEPS as f32 + 0.5;
        for (allowed, top, bottom) in
            [(true, rect.top(), rect.center().y), (false, rect.center().y, rect.bottom())]
        {
            let piece = Rect::from_min_max(pos2(left, top), pos2(right, bottom));
            let color = found.picture.color(palette, force_n, allowed);
            ui.painter().rect_filled(piece, 0.0, color);
        }
    }
    response.on_hover_text(said);
    ui.label(egui::RichText::new(theme::quantity(high, "N")).small().color(palette.weak));
}

/// The values at the pinned place, with a way to let go of it.
pub fn pinned(ui: &mut Ui, map: &mut Map, problem: &Problem) {
    let Some(point) = map.pinned else { return };
    let palette = Palette::at(ui);
    theme::card(palette).show(ui, |ui| {
        ui.horizontal_top(|ui| {
            ui.vertical(|ui| readout(ui, problem, point));
            let right = egui::Layout::right_to_left(egui::Align::Min);
            ui.with_layout(right, |ui| {
                let help = "Let go of this place";
                if icon::button(ui, Icon::Close, help, help, true).clicked() {
                    map.pinned = None;
                }
            });
        });
    });
}
