//! The pen of a sketch under the keys: right and left draw on at its height, up and down lift and lower it.

use egui::{EventFilter, Key, Pos2, Response, Role, Stroke, Ui, WidgetInfo};

use crate::app::theme::Palette;
use crate::base::language::tr;

/// Steps of the height from foot to top.
const STEPS: f64 = 20.0;

/// Where the pen stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pen {
    /// Its place along the time, counted from 0.
    pub bin: usize,
    /// Its height, 0 at the foot and 1 at the top.
    pub height: f64,
}

impl Pen {
    /// The pen of the sketch that is `response`, at first in the middle of the height at the start.
    pub fn of(ui: &Ui, response: &Response) -> Self {
        let kept = ui.data(|data| data.get_temp::<Self>(response.id));
        kept.unwrap_or(Self { bin: 0, height: 0.5 })
    }

    /// Moves it by the keys of this frame, where the sketch has the focus; gives the places and heights drawn.
    pub fn drawn_by_keys(&mut self, ui: &Ui, response: &Response, bins: usize) -> Vec<Self> {
        if !response.has_focus() {
            return Vec::new();
        }
        let filter = EventFilter {
            horizontal_arrows: true,
            vertical_arrows: true,
            ..EventFilter::default()
        };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
        let presses = |key| ui.input(|input| input.num_presses(key));
        let [up, down] = [Key::ArrowUp, Key::ArrowDown].map(|key| presses(key) as f64);
        let [right, left] = [Key::ArrowRight, Key::ArrowLeft].map(presses);
        let mut drawn = Vec::new();
        if up != down {
            // On the steps, wherever a finger has left it.
            let step = (self.height * STEPS).round() + up - down;
            self.height = (step / STEPS).clamp(0.0, 1.0);
            drawn.push(*self);
        }
        // From where it stands: a curve has two points at least.
        if right + left > 0 {
            drawn.push(*self);
        }
        for _ in 0..right {
            self.bin = (self.bin + 1).min(bins - 1);
            drawn.push(*self);
        }
        for _ in 0..left {
            self.bin = self.bin.saturating_sub(1);
            drawn.push(*self);
        }
        ui.data_mut(|data| data.insert_temp(response.id, *self));
        drawn
    }

    /// Puts it where a finger or the mouse has drawn last.
    pub fn put(&mut self, ui: &Ui, response: &Response, bin: usize, height: f64) {
        *self = Self { bin, height };
        ui.data_mut(|data| data.insert_temp(response.id, *self));
    }

    /// Shows it while it has the keys, and says what it is.
    pub fn show(self, ui: &Ui, response: &Response, at: Pos2, value: f64, told: &str) {
        let name = tr("Sketch: right and left draw, up and down lift and lower the pen");
        response.widget_info(|| {
            let mut info = WidgetInfo::labeled(Role::Slider, true, name);
            (info.value, info.current_text_value) = (Some(value), Some(told.to_owned()));
            info
        });
        if response.has_focus() {
            let color = Palette::at(ui).accent;
            ui.painter().circle(at, 5.0, color, Stroke::new(1.0, Palette::at(ui).text));
        }
    }
}
