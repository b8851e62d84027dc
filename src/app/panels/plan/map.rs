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
use crate::base::language::tr;
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
    pub fn show(
        &mut self,
        ui: &mut Ui,
        found: &mut Found,
        scenario: &Scenario,
        moving: &Moving<'_>,
        height: f32,
    ) {
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
            .x_axis_label(tr("cutting speed [m/min]"))
            .y_axis_label(tr("feed per tooth [mm]"))
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
        if let Some(point) = response.response.hover_pos().map(place).filter(|p| on_the_map(*p)) {
            let hovered = response.response.on_hover_cursor(egui::CursorIcon::Crosshair);
            hovered.on_hover_ui_at_pointer(|ui| readout(ui, found, scenario, point));
        }
    }

    /// The buttons that choose what part of it is shown.
    pub fn parts(&mut self, ui: &mut Ui, found: &Found) {
        let allowed = found.picture.allowed();
        let button = touch::small(ui, egui::Button::new(tr("Zoom to allowed")));
        let response = ui.add_enabled(allowed.is_some(), button);
        let help = tr("Shows the part of the map that holds allowed cuts");
        let response = response.on_hover_text(help);
        if response.on_disabled_hover_text(tr("There are none on the map")).clicked() {
            self.wanted = allowed.map(Part::Ranges);
        }
        let help = tr("Shows the whole map, as a double-click on it does; a drag on it zooms");
        let button = touch::small(ui, egui::Button::new(tr("Whole map")));
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
        let mut labels = Labels { frame, taken: Vec::new() };
        // A small map leaves the names to the legend above it, which has them beside their colours.
        let named = frame.width() >= NAMES_FROM;
        for (number, constraint) in CONSTRAINTS.iter().enumerate().filter(|_| named) {
            let lines = &found.picture.boundary(number).lines;
            if self.layers.show(MapLayer::Boundary(number)) {
                let color = palette.constraints[number];
                let lines: Vec<Vec<Pos2>> = on_screen(lines, &at);
                labels.write(ui, &painter, &lines, tr(constraint.label), color);
            }
        }
        if self.layers.show(MapLayer::ForceLines) {
            for (force_n, lines) in found.picture.force_lines() {
                let text = format::round_quantity(*force_n, "N");
                let lines = on_screen(lines, &at);
                labels.write(ui, &painter, &lines, &text, palette.weak);
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

/// Width of the map's frame from which on the boundaries have their names on it, points.
const NAMES_FROM: f32 = 360.0;
/// Room around a label that no other one stands in, points.
const GAP: egui::Vec2 = vec2(6.0, 4.0);

/// Lines where they are drawn, each from the end that lies further to the right and up: the allowed cuts, and the
/// swarm with them, lie to the left and below mostly.
fn on_screen(lines: &[Polyline], at: &dyn Fn([f64; 2]) -> Pos2) -> Vec<Vec<Pos2>> {
    let placed = lines.iter().map(|line| {
        let mut line: Vec<Pos2> = line.iter().map(|point| at(*point)).collect();
        let far = |end: Option<&Pos2>| end.map_or(0.0, |end| end.x - end.y);
        if far(line.last()) > far(line.first()) {
            line.reverse();
        }
        line
    });
    placed.collect()
}

/// Labels on lines, none over another one.
struct Labels {
    /// What they stay inside of.
    frame: Rect,
    taken: Vec<Rect>,
}

impl Labels {
    /// The first place on the lines for a label of a size, where no other one stands; none where there is none.
    fn place(&mut self, lines: &[Vec<Pos2>], size: egui::Vec2) -> Option<Rect> {
        let inside = self.frame.shrink2(vec2(4.0, 3.0));
        let places = lines.iter().flatten().map(|point| Rect::from_center_size(*point, size));
        let free = |place: &Rect| {
            let room = place.expand2(GAP);
            inside.contains_rect(*place) && !self.taken.iter().any(|other| other.intersects(room))
        };
        let place = places.into_iter().find(free)?;
        self.taken.push(place);
        Some(place)
    }

    fn write(
        &mut self,
        ui: &Ui,
        painter: &egui::Painter,
        lines: &[Vec<Pos2>],
        text: &str,
        color: Color32,
    ) {
        let font = egui::TextStyle::Small.resolve(ui.style());
        let galley = painter.layout_no_wrap(text.to_owned(), font, color);
        if let Some(place) = self.place(lines, galley.size() + vec2(6.0, 2.0)) {
            painter.rect_filled(place, 3.0, Palette::at(ui).card);
            painter.galley(place.min + vec2(3.0, 1.0), galley, color);
        }
    }
}

/// What a screen reader says of the map.
fn name(found: &Found) -> String {
    let optimum = found.optimum();
    let speed = format::quantity(optimum.cutting_speed_m_min, "m/min");
    let feed = format::fine(optimum.feed_per_tooth_mm, "mm");
    match found.stage().counts.done {
        true => tr!(
            "Force over cutting speed and feed per tooth; optimum at {speed} and {feed}",
            speed = speed,
            feed = feed,
        ),
        false => tr!(
            "Force over cutting speed and feed per tooth; best so far at {speed} and {feed}",
            speed = speed,
            feed = feed,
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;

    /// On a phone's map too, no label lies over another or beyond the frame; a line without room has none.
    #[test]
    fn labels_keep_apart_and_inside() {
        let frame = Rect::from_min_size(pos2(70.0, 340.0), vec2(290.0, 200.0));
        let mut labels = Labels { frame, taken: Vec::new() };
        let mut places = Vec::new();
        // Lines of equal force, ever nearer to each other.
        let heights = [530.0, 515.0, 498.0, 480.0, 440.0, 400.0, 341.0];
        for height in heights {
            let line = (0..60).map(|k| [f64::from(k) * 5.0 + 70.0, height]).collect::<Vec<_>>();
            let line = on_screen(&[line], &|[x, y]| pos2(x as f32, y as f32));
            places.push(labels.place(&line, vec2(40.0, 14.0)));
        }
        assert_eq!(places.last(), Some(&None), "half of it would lie outside");
        let found: Vec<Rect> = places.into_iter().flatten().collect();
        assert!(found.len() >= 5, "{found:?}");
        for (i, one) in found.iter().enumerate() {
            assert!(frame.contains_rect(*one), "{one:?}");
            for other in &found[..i] {
                assert!(!one.intersects(other.expand2(GAP - vec2(0.1, 0.1))), "{one:?} {other:?}");
            }
        }
        assert!(found[0].right() > frame.right() - 12.0, "at the right end first: {:?}", found[0]);
    }
}
