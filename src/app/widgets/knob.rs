//! The override knob of a machine's panel: an arc with marks, a pointer, and the override in percent. It is turned by
//! a drag around it, by the wheel over it, by a finger, and by keys where it has the focus; it goes from click to click.

use egui::accesskit::{Action, ActionData};
use egui::{
    Align2, Event, EventFilter, FontId, Id, Key, MouseWheelUnit, Painter, Pos2, Rect, Response,
    Sense, Shape, Stroke, Ui, Vec2, WidgetInfo,
};

use super::super::command::{Command, HandCommand};
use super::super::format;
use super::super::session::hand::CLICK_PERCENT;
use super::super::shortcuts::PAGE_CLICKS;
use super::super::theme::{self, Palette};
use crate::base::language::{text, tr};

/// Name of the knob.
pub const NAME: &str = text!("Feed override by hand");
/// Turn from one end of the scale to the other, degrees, and where it begins, clockwise from the right.
const TURN_DEG: f32 = 270.0;
/// See [`TURN_DEG`].
const FROM_DEG: f32 = 135.0;
/// Nearer to the middle than this, as a fraction of the diameter, a drag has no angle to speak of.
const MIDDLE: f32 = 0.1;
/// Below this diameter the override is written smaller, points.
const SMALL: f32 = 160.0;
/// Way of a smooth wheel that is a click, points.
const WHEEL_POINTS: f32 = 24.0;

/// The knob as it is to be shown.
#[derive(Clone, Copy, Debug)]
pub struct Knob {
    /// Where it stands, percent.
    pub percent: f64,
    /// Where its scale ends, percent; it begins at 0.
    pub scale_percent: f64,
    /// The overrides that it reaches, percent.
    pub range: [f64; 2],
    /// Whether the hand has the feed; otherwise the pointer follows a controller.
    pub by_hand: bool,
    /// Its size, points.
    pub diameter: f32,
}

/// A drag under way: the angle of the pointer, degrees, and the override that it has come to, percent.
#[derive(Clone, Copy, Debug)]
struct Held {
    angle_deg: f32,
    percent: f64,
}

/// Angle of a point around another one, degrees clockwise from the right.
fn angle_deg(around: Pos2, at: Pos2) -> f32 {
    (at - around).angle().to_degrees()
}

/// The shorter way from one angle to another, degrees.
fn way_deg(from: f32, to: f32) -> f32 {
    (to - from + 180.0).rem_euclid(360.0) - 180.0
}

impl Knob {
    /// Draws it, and pushes the turns.
    pub fn show(&self, ui: &mut Ui, commands: &mut Vec<Command>) -> Response {
        let sense = Sense::click_and_drag();
        let (rect, response) = ui.allocate_exact_size(Vec2::splat(self.diameter), sense);
        response.widget_info(|| WidgetInfo::slider(true, self.percent, tr(NAME)));
        let mut turn = |command| commands.push(Command::hand(command));
        if let Some(percent) = self.dragged(ui, &response) {
            turn(HandCommand::To(percent));
        }
        let clicks = wheel(ui, &response) + self.keys(ui, &response, &mut turn);
        if clicks != 0 {
            turn(HandCommand::Turn(clicks));
        }
        self.tell(ui, &response, &mut turn);
        if response.clicked() {
            response.request_focus();
        }
        if ui.is_rect_visible(rect) {
            self.paint(ui, rect, &response);
        }
        let help = tr(
            "Turn it by a drag around it, by the wheel, or with a finger; + and -, Page Up and Page Down \
                    turn it from anywhere",
        );
        response.on_hover_text(help)
    }

    /// Where a drag around the knob has brought it, where that is another click.
    fn dragged(&self, ui: &Ui, response: &Response) -> Option<f64> {
        let id = response.id.with("held");
        if response.drag_stopped() {
            ui.data_mut(|data| data.remove::<Held>(id));
            super::focus::leave(response);
        }
        let at = response.interact_pointer_pos().filter(|_| response.dragged())?;
        let around = response.rect.center();
        if around.distance(at) < MIDDLE * self.diameter {
            return None;
        }
        let angle = angle_deg(around, at);
        let held = ui.data(|data| data.get_temp::<Held>(id));
        let mut held = held.unwrap_or_else(|| {
            // What a drag has gone before it is known to be one counts as well.
            let from = ui.input(|input| input.pointer.press_origin()).unwrap_or(at);
            Held { angle_deg: angle_deg(around, from), percent: self.percent }
        });
        let way = f64::from(way_deg(held.angle_deg, angle) / TURN_DEG);
        let [low, high] = self.range;
        // A click beyond the end is felt, and said; the way back begins there.
        held.percent = (held.percent + way * self.scale_percent)
            .clamp(low - CLICK_PERCENT, high + CLICK_PERCENT);
        held.angle_deg = angle;
        ui.data_mut(|data| data.insert_temp(id, held));
        let clicks = |percent: f64| (percent / CLICK_PERCENT).round();
        (clicks(held.percent) != clicks(self.percent)).then_some(held.percent)
    }

    /// Clicks by keys, where it has the focus.
    fn keys(&self, ui: &Ui, response: &Response, turn: &mut impl FnMut(HandCommand)) -> i32 {
        if !response.has_focus() {
            return 0;
        }
        let filter = EventFilter {
            horizontal_arrows: true,
            vertical_arrows: true,
            ..EventFilter::default()
        };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
        ui.input(|input| {
            if input.num_presses(Key::Home) > 0 {
                turn(HandCommand::To(100.0));
            }
            let presses = |key| input.num_presses(key) as i32;
            presses(Key::ArrowUp) + presses(Key::ArrowRight)
                - presses(Key::ArrowDown)
                - presses(Key::ArrowLeft)
                + PAGE_CLICKS * (presses(Key::PageUp) - presses(Key::PageDown))
        })
    }

    /// What a screen reader knows of it and does with it.
    fn tell(&self, ui: &Ui, response: &Response, turn: &mut impl FnMut(HandCommand)) {
        let id = response.id;
        ui.input(|input| {
            let count = |action| input.num_accesskit_action_requests(id, action) as i32;
            let clicks = count(Action::Increment) - count(Action::Decrement);
            if clicks != 0 {
                turn(HandCommand::Turn(clicks));
            }
            for request in input.accesskit_action_requests(id, Action::SetValue) {
                if let Some(ActionData::NumericValue(percent)) = request.data {
                    turn(HandCommand::To(percent));
                }
            }
        });
        let [low, high] = self.range;
        let percent = self.percent;
        ui.ctx().accesskit_node_builder(id, |node| {
            node.set_min_numeric_value(low);
            node.set_max_numeric_value(high);
            node.set_numeric_value_step(CLICK_PERCENT);
            node.add_action(Action::SetValue);
            if percent < high {
                node.add_action(Action::Increment);
            }
            if percent > low {
                node.add_action(Action::Decrement);
            }
        });
    }

    /// Where an override stands on the scale: the direction from the middle.
    fn direction(&self, percent: f64) -> Vec2 {
        let share = (percent / self.scale_percent).clamp(0.0, 1.0) as f32;
        Vec2::angled((FROM_DEG + TURN_DEG * share).to_radians())
    }

    fn arc(
        &self,
        painter: &Painter,
        center: Pos2,
        radius: f32,
        [from, to]: [f64; 2],
        stroke: Stroke,
    ) {
        /// Percents from one point of the arc to the next.
        const PIECE: f64 = 2.0;
        if to <= from {
            return;
        }
        let pieces = ((to - from) / PIECE).ceil().max(1.0);
        let points = (0..=pieces as usize)
            .map(|i| center + radius * self.direction(from + (to - from) * i as f64 / pieces));
        painter.add(Shape::line(points.collect(), stroke));
    }

    fn paint(&self, ui: &Ui, rect: Rect, response: &Response) {
        let palette = Palette::at(ui);
        let painter = ui.painter();
        let (center, radius) = (rect.center(), 0.5 * self.diameter);
        let note = theme::note(ui.ctx());
        // The numbers stand around the ring.
        let ring = radius - 2.4 * note.size;
        self.scale(painter, center, ring, (&note, palette));
        let [low, high] = self.range;
        let plain = Stroke::new(5.0, palette.line);
        let barred = Stroke::new(2.0, palette.limit);
        self.arc(painter, center, ring, [0.0, self.scale_percent], barred);
        self.arc(painter, center, ring, [low, high.min(self.scale_percent)], plain);
        let color = if self.by_hand { palette.accent } else { palette.weak };
        self.arc(painter, center, ring, [0.0, self.percent], Stroke::new(5.0, color));
        let body = ring - 9.0;
        let hovered = response.hovered() || response.dragged();
        let edge = if hovered { palette.text } else { palette.weak };
        painter.circle(center, body, palette.card, Stroke::new(1.5, edge));
        // The grip: notches that turn with it.
        let pointer = self.direction(self.percent);
        for i in 0..24 {
            let notch =
                egui::emath::Rot2::from_angle(std::f32::consts::TAU * i as f32 / 24.0) * pointer;
            let ends = [center + (body - 5.0) * notch, center + (body - 1.0) * notch];
            painter.line_segment(ends, Stroke::new(1.5, palette.line));
        }
        let ends = [center + 0.62 * body * pointer, center + (body - 2.0) * pointer];
        painter.line_segment(ends, Stroke::new(5.0, color));
        if response.has_focus() {
            painter.circle_stroke(center, body + 3.0, ui.visuals().selection.stroke);
        }
        let style = if self.diameter < SMALL { theme::figure() } else { theme::large() };
        let font = style.resolve(ui.style());
        let text = format::beside(format!("{:.0}", self.percent), "%");
        painter.text(center, Align2::CENTER_CENTER, text, font, palette.text);
    }

    /// The marks: one every so many percents, longer and with its number at each fifty, at 100 and at the end.
    fn scale(
        &self,
        painter: &Painter,
        center: Pos2,
        ring: f32,
        (note, palette): (&FontId, &Palette),
    ) {
        /// Percents from mark to mark, and up to where a scale is so short that they stand apart.
        const MARKS: [f64; 2] = [5.0, 10.0];
        /// See [`MARKS`].
        const SHORT: f64 = 150.0;
        let apart = MARKS[usize::from(self.scale_percent > SHORT)];
        let last = (self.scale_percent / apart).floor() as u32;
        for mark in 0..=last {
            let percent = f64::from(mark) * apart;
            let named = percent % 50.0 == 0.0 || mark == last;
            let direction = self.direction(percent);
            let length = if named { 8.0 } else { 4.0 };
            let ends =
                [center + (ring + 4.0) * direction, center + (ring + 4.0 + length) * direction];
            let width = if percent == 100.0 { 3.0 } else { 1.2 };
            let color = if named { palette.text } else { palette.weak };
            painter.line_segment(ends, Stroke::new(width, color));
            if named {
                let at = center + (ring + 13.0 + 0.8 * note.size) * direction;
                let text = format!("{percent:.0}");
                painter.text(at, Align2::CENTER_CENTER, text, note.clone(), palette.text);
            }
        }
    }
}

/// Clicks of the wheel over the knob; nothing below it scrolls by them.
fn wheel(ui: &Ui, response: &Response) -> i32 {
    if !response.contains_pointer() {
        return 0;
    }
    let id = Id::unique("wheel over the knob");
    let (mut lines, mut points) = (0, 0.0);
    ui.input_mut(|input| {
        for event in &input.events {
            let Event::MouseWheel { unit, delta, modifiers, .. } = event else { continue };
            // With Ctrl it zooms.
            if modifiers.command || delta.y == 0.0 {
                continue;
            }
            match unit {
                MouseWheelUnit::Point => points += delta.y,
                MouseWheelUnit::Line | MouseWheelUnit::Page => lines += delta.y.signum() as i32,
            }
        }
        input.smooth_scroll_delta = Vec2::ZERO;
    });
    let way = ui.data(|data| data.get_temp::<f32>(id)).unwrap_or_default() + points;
    let whole = (way / WHEEL_POINTS).trunc();
    ui.data_mut(|data| data.insert_temp(id, way - whole * WHEEL_POINTS));
    lines + whole as i32
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;

    #[test]
    fn a_drag_goes_the_shorter_way_across_the_seam_of_the_angles() {
        for (from, to, way) in [(10.0, 30.0, 20.0), (170.0, -170.0, 20.0), (-170.0, 170.0, -20.0)] {
            assert!((way_deg(from, to) - way).abs() < 1e-3, "{from} to {to}");
        }
        assert!(
            (angle_deg(pos2(1.0, 1.0), pos2(1.0, 5.0)) - 90.0).abs() < 1e-3,
            "down is a quarter"
        );
    }
}
