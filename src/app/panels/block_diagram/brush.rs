//! Paints wires, labels, blocks, lamps and the dead-time queue.

use egui::text::{LayoutJob, TextWrapping};
use egui::{
    Align2, Color32, CornerRadius, FontId, Painter, Pos2, Rect, Shape, Stroke, StrokeKind, Vec2,
    pos2, vec2,
};

use super::layout::{Course, Style};
use super::moment::Now;
use crate::app::format;
use crate::app::panels::equation_cards::Block;
use crate::app::panels::equation_cards::formula::{number, typeset};
use crate::app::theme::{self, Palette};
use crate::base::language::{decimal, tr};
use crate::run::diagram::Lamp;
use crate::run::explanation::explain_controller;

/// Sizes of text at scale 1, points; none is drawn smaller than the smallest of the theme.
const TITLE: f32 = 13.5;
const TEXT: f32 = 12.0;
const NAME: f32 = 12.0;
const VALUE: f32 = 13.0;
const PADDING: f32 = 6.0;
const LAMP_RADIUS: f32 = 4.0;
const ARROW: f32 = 7.0;

/// A number in words about settings.
fn told(x: f64) -> String {
    format::signed(decimal(number(x)))
}

/// A drive of one's own.
fn own_drive(order: usize) -> String {
    tr!("your own, order {order}", order = order)
}

/// A line or two about a block's settings.
fn detail(block: Block, now: &Now<'_>) -> String {
    let scenario = now.moment.scenario;
    match block {
        Block::Reference | Block::Surface | Block::SurfaceDynamic => {
            let origin = block.origin(scenario);
            format!("{} {origin}", block.info().models(scenario))
        }
        Block::Controller => {
            let beside = explain_controller(scenario, now.moment.row).beside_name;
            let comma = if beside.is_empty() { "" } else { ", " };
            format!("{}{comma}{beside}", tr(scenario.controller.kind.label()))
        }
        Block::Override => {
            let cnc = &scenario.cnc;
            let [low, high] = [cnc.override_min_percent, cnc.override_max_percent].map(told);
            let range = if cnc.override_quantised {
                tr!("{low} to {high} %, whole", low = low, high = high)
            } else {
                tr!("{low} to {high} %", low = low, high = high)
            };
            if !cnc.override_rate_limited {
                return range;
            }
            let rate = tr!("at most {rate} %/s", rate = told(cnc.override_rate_percent_s));
            format!("{range}\n{rate}")
        }
        Block::DeadTime => format!("{} s", told(scenario.cnc.dead_time_s)),
        Block::FeedDrive if !scenario.feed_drive.poles.is_empty() => {
            own_drive(scenario.feed_drive.poles.order())
        }
        Block::SpindleDrive if !scenario.spindle_drive.poles.is_empty() => {
            own_drive(scenario.spindle_drive.poles.order())
        }
        Block::FeedDrive => tr(scenario.feed_drive.kind.label()).to_owned(),
        Block::SpindleDrive => {
            let drive = &scenario.spindle_drive;
            format!("{} s, {} 1/min/s", told(drive.time_constant_s), told(drive.rate_rpm_s))
        }
        Block::Cutting => {
            let plant = &scenario.plant;
            let state = tr!(
                "{hardness} HB, wear {wear}",
                hardness = told(plant.hardness_hb),
                wear = told(plant.wear_factor)
            );
            format!("{}\n{state}", tr(plant.material.label()))
        }
        Block::Dynamic if scenario.noise.level == 0.0 => tr("off").to_owned(),
        Block::Dynamic => tr!("noise × {level}", level = told(scenario.noise.level)),
        Block::Dynamometer => {
            let noise = scenario.noise.level * scenario.noise.sensor_n;
            tr!("noise {force} N", force = told(noise))
        }
    }
}

/// Painter, colours and scale of one frame.
pub struct Brush {
    painter: Painter,
    palette: &'static Palette,
    scale: f32,
    /// Size of the smallest text, points.
    least: f32,
}

impl Brush {
    /// A brush for `ui` at the scale of a layout.
    #[must_use]
    pub fn new(ui: &egui::Ui, scale: f32) -> Self {
        let least = theme::note(ui.ctx()).size;
        Self { painter: ui.painter().clone(), palette: Palette::at(ui), scale, least }
    }

    fn s(&self, x: f32) -> f32 {
        x * self.scale
    }

    fn size(&self, text: f32) -> f32 {
        self.s(text).max(self.least)
    }

    /// Text in at most `lines` lines of `width`; what does not fit ends in an ellipsis.
    fn text(&self, at: Pos2, align: Align2, mut job: LayoutJob, width: f32, lines: usize) -> Rect {
        job.wrap = TextWrapping { max_width: width, max_rows: lines, ..TextWrapping::default() };
        job.halign = align.x();
        let galley = self.painter.layout_job(job);
        // With halign, the galley's own origin is already at its anchor.
        let top = at.y
            - match align.y() {
                egui::Align::Min => 0.0,
                egui::Align::Center => 0.5 * galley.size().y,
                egui::Align::Max => galley.size().y,
            };
        let rect = galley.rect.translate(vec2(at.x, top));
        self.painter.galley(pos2(at.x, top), galley, self.palette.text);
        rect
    }

    fn plain(&self, text: &str, size: f32, color: Color32) -> LayoutJob {
        let font = FontId::proportional(self.size(size));
        LayoutJob::simple(text.to_owned(), font, color, f32::INFINITY)
    }

    /// A wire with all its branches.
    pub fn course(&self, course: &Course, offset: Vec2, chosen: bool, lively: bool) {
        let color = if chosen || lively { self.palette.accent } else { self.palette.weak };
        let stroke = Stroke::new(self.s(if chosen { 2.6 } else { 1.4 }), color);
        for (i, branch) in course.branches.iter().enumerate() {
            let mut points: Vec<Pos2> = branch.iter().map(|p| *p + offset).collect();
            let (Some(&tip), Some(&before)) = (points.last(), points.iter().nth_back(1)) else {
                continue;
            };
            if i > 0 {
                self.painter.circle_filled(points[0], self.s(2.8), color);
            }
            let along = (tip - before).normalized() * self.s(ARROW);
            let across = along.rot90() * 0.5;
            let back = tip - along;
            if let Some(last) = points.last_mut() {
                *last = back;
            }
            self.painter.add(Shape::line(points, stroke));
            let head = vec![tip, back + across, back - across];
            self.painter.add(Shape::convex_polygon(head, color, Stroke::NONE));
        }
    }

    /// The name and value on a wire.
    pub fn label(&self, rect: Rect, course: &Course, value: &str) {
        let name = tr(course.wire.info().label);
        let name = || self.plain(name, NAME, self.palette.weak);
        let shown = || self.plain(value, VALUE, self.palette.text);
        let width = rect.width();
        let middle = rect.center();
        let gap = self.s(2.5);
        match course.style {
            Style::Across => {
                // A name that does not fit gives way to the symbol.
                let name = if self.painter.layout_job(name()).size().x > width {
                    typeset(tr(course.wire.symbol), self.size(NAME), self.least, self.palette.weak)
                } else {
                    name()
                };
                self.text(middle - vec2(0.0, gap), Align2::CENTER_BOTTOM, name, width, 1);
                self.text(middle + vec2(0.0, gap), Align2::CENTER_TOP, shown(), width, 1);
            }
            Style::Right => {
                self.text(rect.left_center(), Align2::LEFT_BOTTOM, name(), width, 1);
                self.text(rect.left_center(), Align2::LEFT_TOP, shown(), width, 1);
            }
            Style::Left => {
                self.text(rect.right_center(), Align2::RIGHT_BOTTOM, name(), width, 1);
                self.text(rect.right_center(), Align2::RIGHT_TOP, shown(), width, 1);
            }
            Style::Short => {
                let symbol = typeset(
                    tr(course.wire.symbol),
                    self.size(VALUE),
                    self.least,
                    self.palette.weak,
                );
                let used = self.text(rect.left_center(), Align2::LEFT_CENTER, symbol, width, 1);
                let from = pos2(used.right() + self.s(5.0), middle.y);
                self.text(from, Align2::LEFT_CENTER, shown(), rect.right() - from.x, 1);
            }
        }
    }

    /// A block with its settings and lamps.
    pub fn block(&self, block: Block, rect: Rect, now: &Now<'_>, chosen: bool, hovered: bool) {
        let palette = self.palette;
        let info = block.info();
        let lit = info.lamps.iter().any(|lamp| now.moment.row.has(lamp.bits));
        let color = match (chosen, lit) {
            (true, _) => palette.accent,
            (false, true) => palette.bad,
            (false, false) if hovered => palette.weak,
            (false, false) => palette.line,
        };
        let width = if chosen { 2.4 } else { 1.4 };
        let radius = CornerRadius::same(6);
        let stroke = Stroke::new(self.s(width), color);
        self.painter.rect(rect, radius, palette.card, stroke, StrokeKind::Inside);

        let inner = rect.shrink(self.s(PADDING));
        // In a flat block the lamps stand beside the title, in a high one at its foot.
        let flat = rect.width() > 2.5 * rect.height();
        let lamps = self.lamps(inner, info.lamps, now, flat);
        let room = if flat { inner.width() - lamps } else { inner.width() };
        let title = self.plain(&info.title(now.moment.scenario), TITLE, palette.text);
        let lines = if flat { 1 } else { 2 };
        let title = self.text(inner.min, Align2::LEFT_TOP, title, room, lines);
        let mut at = pos2(inner.left(), title.bottom());
        let mut detail = detail(block, now);
        if flat {
            detail = detail.replace('\n', ", ");
        }
        for line in detail.lines() {
            let text = self.plain(line, TEXT, palette.weak);
            at.y = self.text(at, Align2::LEFT_TOP, text, inner.width(), 1).bottom();
        }
        if block == Block::DeadTime {
            let lane = Rect::from_min_max(at + vec2(0.0, self.s(2.0)), inner.max);
            self.queue(lane, now);
        }
    }

    /// Draws the lamps, the last one at the right, in rows from the foot up where they do not fit
    /// beside each other; gives back the width of the last row.
    fn lamps(&self, inner: Rect, lamps: &[Lamp], now: &Now<'_>, flat: bool) -> f32 {
        let mut width = 0.0;
        let mut y = if flat { inner.top() + self.s(8.0) } else { inner.bottom() - self.s(7.0) };
        let radius = self.s(LAMP_RADIUS);
        let scenario = now.moment.scenario;
        for lamp in lamps.iter().rev().filter(|lamp| lamp.serves(scenario)) {
            let lit = now.moment.row.has(lamp.bits);
            let name = lamp.name(scenario);
            let (color, label) = if lit {
                (self.palette.bad, format!("{name} !"))
            } else {
                (self.palette.good, name)
            };
            let text = self.plain(&label, NAME, if lit { color } else { self.palette.weak });
            let needed =
                self.painter.layout_job(text.clone()).size().x + 2.0 * radius + self.s(3.0);
            if !flat && width > 0.0 && width + needed > inner.width() {
                (width, y) = (0.0, y - self.s(16.0));
            }
            let at = pos2(inner.right() - width, y);
            let drawn = self.text(at, Align2::RIGHT_CENTER, text, f32::INFINITY, 1);
            let center = pos2(drawn.left() - radius - self.s(3.0), at.y);
            // Dark and hollow, or lit and full: the shape shows it as well as the colour.
            if lit {
                self.painter.circle_filled(center, radius + self.s(1.0), color);
            } else {
                self.painter.circle_stroke(center, radius, Stroke::new(self.s(1.4), color));
            }
            width = inner.right() - center.x + radius + self.s(8.0);
        }
        width
    }

    /// The dead-time queue: feed above, spindle below, from left to right.
    fn queue(&self, area: Rect, now: &Now<'_>) {
        let (above, below) = area.split_top_bottom_at_fraction(0.5);
        let dots = &now.under_way;
        let lanes: [(Rect, Vec<f64>, Color32); 2] = [
            (above, dots.iter().map(|d| d.feed_mm_min).collect(), self.palette.command),
            (below, dots.iter().map(|d| d.speed_rpm).collect(), self.palette.limit),
        ];
        for (lane, values, color) in lanes {
            let lane = lane.shrink2(vec2(0.0, self.s(1.5)));
            self.painter.rect_filled(
                lane,
                CornerRadius::same(3),
                self.palette.line.gamma_multiply(0.6),
            );
            let low = values.iter().copied().fold(f64::INFINITY, f64::min);
            let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            // Differences below 2 % look level.
            let span = (high - low).max(0.02 * high.abs()).max(f64::MIN_POSITIVE);
            let radius = self.s(2.6).min(0.5 * lane.height());
            let field = lane.shrink(radius);
            for (dot, value) in dots.iter().zip(values) {
                let height = 0.5 + (value - 0.5 * (low + high)) / span;
                let x = field.left() + dot.done as f32 * field.width();
                let y = field.bottom() - height.clamp(0.0, 1.0) as f32 * field.height();
                self.painter.circle_filled(pos2(x, y), radius, color);
            }
        }
    }

    /// Marks what has the keyboard's focus.
    pub fn focus(&self, rect: Rect) {
        let stroke = Stroke::new(2.0, self.palette.accent);
        self.painter.rect_stroke(
            rect.expand(2.0),
            CornerRadius::same(6),
            stroke,
            StrokeKind::Outside,
        );
    }

    /// A word of help.
    pub fn hint(&self, rect: Rect) {
        let text =
            tr("Click a wire to plot it, a block for its equations. A full lamp: a limit acts, \
                       or a model is used outside its range.");
        let job = self.plain(text, NAME, self.palette.weak);
        self.text(rect.left_top(), Align2::LEFT_TOP, job, rect.width(), 7);
    }
}
