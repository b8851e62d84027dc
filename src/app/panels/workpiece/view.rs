//! How the part is looked at: orbit, zoom, what is followed, how much larger heights are drawn.

use egui::{Rect, Response, Slider, Ui};

use crate::app::scene::camera::Camera;
use crate::app::theme::round_step;

/// Distances of the eye, mm: the whole part, at the tool, close up; and how near and far it goes.
const WHOLE: f32 = 1.75;
const AT_TOOL_MM: f32 = 84.0;
/// What is looked at there stands behind the tool by this, mm.
const BEHIND_TOOL_MM: f32 = 9.0;
const CLOSE_MM: f32 = 9.0;
const RANGE_MM: [f32; 2] = [2.0, 900.0];
/// Zoom of a button.
const ZOOM: f32 = 1.35;
/// Target Ra as a share of the height of the picture when heights are drawn by themselves.
const SHOWN: f64 = 0.003;
/// Largest factor of the heights that comes by itself.
const TIMES_BY_ITSELF: f64 = 200.0;
/// Factors of the heights that can be chosen.
const TIMES: [f64; 2] = [1.0, 5000.0];

/// See the head of this file.
#[derive(Clone, Debug)]
pub struct Looking {
    /// The eye.
    pub camera: Camera,
    /// Whether it goes along with the tool.
    follows: bool,
    /// Whether the cutter is shown.
    pub cutter: bool,
    /// Factor of the heights; none: as the zoom wants it.
    chosen: Option<f64>,
    /// First and last place of the part, mm.
    pub extent: [f32; 2],
}

impl Default for Looking {
    fn default() -> Self {
        let camera = Camera {
            target: [0.0, 2.0, 1.0],
            distance: AT_TOOL_MM,
            turn_rad: -0.5,
            tilt_rad: 0.55,
        };
        Self { camera, follows: true, cutter: true, chosen: None, extent: [0.0, 1.0] }
    }
}

impl Looking {
    /// Takes in drags, wheel and pinch, and where the tool is.
    pub fn steer(&mut self, ui: &Ui, response: &Response, tool_mm: f32) {
        self.camera.orbit(response.drag_delta());
        if response.contains_pointer() {
            let (pinch, wheel) =
                ui.input(|input| (input.zoom_delta(), input.smooth_scroll_delta().y));
            self.zoom(pinch * (0.003 * wheel).exp());
        }
        if self.follows {
            self.camera.target[0] = tool_mm - BEHIND_TOOL_MM;
        }
    }

    fn zoom(&mut self, factor: f32) {
        let distance = self.camera.distance / factor;
        self.camera.distance = distance.clamp(RANGE_MM[0], RANGE_MM[1]);
    }

    /// Factor of the heights, for a surface of about this Ra in um.
    pub fn times(&self, ra_um: f64) -> f32 {
        let wanted = SHOWN * 0.62 * f64::from(self.camera.distance) * 1000.0 / ra_um;
        let times =
            self.chosen.unwrap_or_else(|| round_step(wanted.min(TIMES_BY_ITSELF)).unwrap_or(1.0));
        times.clamp(TIMES[0], TIMES[1]) as f32
    }

    /// What part of the way can be seen, mm.
    pub fn window(&self, rect: Rect) -> [f32; 2] {
        let half = 0.42 * self.camera.distance * rect.aspect_ratio().max(1.0);
        [self.camera.target[0] - half, self.camera.target[0] + half]
    }

    /// The buttons.
    pub fn controls(&mut self, ui: &mut Ui) {
        ui.horizontal_wrapped(|ui| {
            if ui.button("Whole part").on_hover_text("All of the present cut").clicked() {
                let [from, to] = self.extent;
                self.follows = false;
                self.camera.target[0] = 0.5 * (from + to);
                self.camera.distance = (WHOLE * (to - from)).clamp(RANGE_MM[0], RANGE_MM[1]);
            }
            if ui.button("At the tool").on_hover_text("Goes along with the tool").clicked() {
                (self.follows, self.camera.distance) = (true, AT_TOOL_MM);
            }
            let help = "The surface right behind the tool, near enough to see each tooth's mark";
            if ui.button("Close up").on_hover_text(help).clicked() {
                self.follows = false;
                self.cutter = false;
                self.camera.distance = CLOSE_MM;
                self.camera.target[0] += BEHIND_TOOL_MM - 3.0;
            }
        });
        ui.horizontal_wrapped(|ui| {
            let help = "Turns the picture; so does a drag with the mouse";
            for (name, turn, tilt) in [
                ("Turn left", 0.25, 0.0),
                ("Turn right", -0.25, 0.0),
                ("Up", 0.0, 0.15),
                ("Down", 0.0, -0.15),
            ] {
                if ui.small_button(name).on_hover_text(help).clicked() {
                    let drag = egui::vec2(-turn, tilt) / 0.008;
                    self.camera.orbit(drag);
                }
            }
            if ui.small_button("Nearer").on_hover_text("Or the wheel").clicked() {
                self.zoom(ZOOM);
            }
            if ui.small_button("Farther").on_hover_text("Or the wheel").clicked() {
                self.zoom(1.0 / ZOOM);
            }
        });
        ui.horizontal_wrapped(|ui| {
            ui.checkbox(&mut self.cutter, "Cutter");
            ui.checkbox(&mut self.follows, "Follow the tool");
        });
        ui.horizontal_wrapped(|ui| {
            let mut own = self.chosen.is_some();
            let help = "Otherwise as the distance wants it";
            if ui.checkbox(&mut own, "Own factor of heights").on_hover_text(help).changed() {
                self.chosen = own.then(|| f64::from(self.times(1.0)));
            }
            if let Some(times) = &mut self.chosen {
                let slider = Slider::new(times, TIMES[0]..=TIMES[1]).logarithmic(true);
                ui.add(slider.prefix("×").max_decimals(0));
            }
        });
    }
}
