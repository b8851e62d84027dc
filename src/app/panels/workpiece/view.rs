//! How the part is looked at: orbit, zoom, what is followed, how much larger heights are drawn.

use egui::{Button, PointerButton, Rect, Response, Role, Slider, Ui, Vec2, WidgetInfo};

use super::cutter::SHANK_MM;
use crate::app::format::round_step;
use crate::app::scene::camera::{Camera, Point};
use crate::app::widgets::touch;
use crate::base::language::tr;

/// Distance of the eye and how far behind the tool it looks, mm: at the tool, and close up.
const AT_TOOL_MM: [f32; 2] = [96.0, 9.0];
const CLOSE_MM: [f32; 2] = [10.0, 3.5];
/// Height that is looked at, mm.
const HEIGHT_MM: [f32; 2] = [6.0, 1.4];
/// Least distance of the eye, and the largest one in lengths of the part.
const NEAREST_MM: f32 = 2.0;
const FARTHEST: f32 = 8.0;
/// Zoom of a button, and of a point of the wheel.
const ZOOM: f32 = 1.35;
const ZOOM_PER_POINT: f32 = 0.003;
/// Turn and tilt of a button, as a drag in points.
const PUSH: f32 = 25.0;
/// Target Ra as a fraction of the height of the picture when heights are drawn by themselves.
const SHOWN: f64 = 0.003;
/// Largest factor of the heights that is chosen automatically.
const TIMES_BY_ITSELF: f64 = 200.0;
/// Factors of the heights that can be chosen.
const TIMES: [f64; 2] = [1.0, 5000.0];

/// What the view follows.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Follows {
    /// All of the part.
    Part,
    /// The tool: it looks so far behind it, mm.
    Tool(f32),
    /// Nothing.
    Nothing,
}

/// See the head of this file.
#[derive(Clone, Debug)]
pub struct Looking {
    /// The eye.
    pub camera: Camera,
    follows: Follows,
    /// Whether the cutter is shown.
    pub cutter: bool,
    /// Whether fingers turn the part where they would scroll the page.
    pub by_touch: bool,
    /// Factor of the heights; none: as the zoom wants it.
    chosen: Option<f64>,
    /// The factor that was shown last.
    shown: f64,
    /// Whether it is a blank in its true size: no heights are drawn larger, and the tool goes anywhere.
    blank: bool,
}

impl Default for Looking {
    fn default() -> Self {
        let [distance, behind] = AT_TOOL_MM;
        let target = [0.0, 2.0, HEIGHT_MM[0]];
        Self {
            camera: Camera { target, distance, turn_rad: -0.5, tilt_rad: 0.55 },
            follows: Follows::Tool(behind),
            cutter: true,
            by_touch: false,
            chosen: None,
            shown: TIMES_BY_ITSELF,
            blank: false,
        }
    }
}

impl Looking {
    /// At all of a blank, from above.
    pub fn at_blank() -> Self {
        let camera = Camera { turn_rad: -0.45, tilt_rad: 0.8, ..Self::default().camera };
        Self { camera, follows: Follows::Part, blank: true, ..Self::default() }
    }

    /// Takes in wheel, pinch and drags, those of the first button where it `turns`; follows the
    /// tool's tip, or the part with these bounds.
    pub fn steer(
        &mut self,
        ui: &Ui,
        response: &Response,
        turns: bool,
        tip: Point,
        bounds: [Point; 2],
    ) {
        let other = [PointerButton::Secondary, PointerButton::Middle];
        if turns || other.into_iter().any(|button| response.dragged_by(button)) {
            self.camera.orbit(response.drag_delta());
        }
        let length = bounds[1][0] - bounds[0][0];
        let farthest = (FARTHEST * length).max(AT_TOOL_MM[0]);
        if response.contains_pointer() {
            let factor = ui.input_mut(|input| {
                // The page does not scroll too.
                let wheel = std::mem::replace(&mut input.smooth_scroll_delta, Vec2::ZERO);
                input.zoom_delta() * (ZOOM_PER_POINT * wheel.y).exp()
            });
            self.zoom(factor);
        }
        match self.follows {
            Follows::Tool(_) if self.blank => self.camera.target = tip,
            Follows::Tool(behind) => self.camera.target[0] = tip[0] - behind,
            Follows::Part => {
                let [low, mut high] = bounds;
                if self.cutter {
                    high[2] = if self.blank { high[2] + SHANK_MM } else { SHANK_MM };
                }
                let corner = |i: usize| [0, 1, 2].map(|k| [low, high][i >> k & 1][k]);
                let points: Vec<Point> = (0..8).map(corner).collect();
                self.camera.fit([low, high], &points, response.rect.aspect_ratio());
            }
            Follows::Nothing => {}
        }
        self.camera.distance = self.camera.distance.clamp(NEAREST_MM, farthest);
    }

    fn zoom(&mut self, factor: f32) {
        if factor != 1.0 {
            self.camera.distance /= factor;
            if self.follows == Follows::Part {
                self.follows = Follows::Nothing;
            }
        }
    }

    /// Factor of the heights, for a surface of about this Ra in um.
    pub fn times(&mut self, ra_um: f64) -> f32 {
        let wanted = SHOWN * 0.62 * f64::from(self.camera.distance) * 1000.0 / ra_um;
        let by_itself = || round_step(wanted.min(TIMES_BY_ITSELF)).unwrap_or(1.0);
        self.shown = self.chosen.unwrap_or_else(by_itself).clamp(TIMES[0], TIMES[1]);
        self.shown as f32
    }

    /// What part of the way can be seen, mm.
    pub fn window(&self, rect: Rect) -> [f32; 2] {
        let half = 0.42 * self.camera.distance * rect.aspect_ratio().max(1.0);
        [self.camera.target[0] - half, self.camera.target[0] + half]
    }

    fn at_tool(&mut self, [distance, behind]: [f32; 2], height: f32, cutter: bool) {
        self.follows = Follows::Tool(behind);
        (self.camera.distance, self.cutter) = (distance, cutter);
        // Near the tool the machined strip is in the middle.
        [self.camera.target[1], self.camera.target[2]] = [if cutter { 2.0 } else { 3.8 }, height];
    }

    /// The controls; `pages` says that fingers scroll the page.
    pub fn controls(&mut self, ui: &mut Ui, pages: bool) {
        if pages {
            // So that the first row has all of its buttons.
            ui.spacing_mut().item_spacing.x = 4.0;
            ui.spacing_mut().button_padding.x = 7.0;
        }
        ui.horizontal_wrapped(|ui| {
            if ui.button(tr("Whole part")).on_hover_text(tr("All of the present cut")).clicked() {
                self.follows = Follows::Part;
                self.cutter = true;
            }
            if ui.button(tr("At the tool")).on_hover_text(tr("Goes along with the tool")).clicked()
            {
                self.at_tool(AT_TOOL_MM, HEIGHT_MM[0], true);
            }
            let help =
                tr("The surface right behind the tool, near enough to see each tooth's mark");
            if !self.blank && ui.button(tr("Close up")).on_hover_text(help).clicked() {
                self.at_tool(CLOSE_MM, HEIGHT_MM[1], false);
            }
            for (sign, name, help, factor) in [
                ("+", tr("Nearer"), tr("Nearer; so does the wheel"), ZOOM),
                ("-", tr("Farther"), tr("Farther; so does the wheel"), 1.0 / ZOOM),
            ] {
                let least = touch::least(ui);
                let button = ui.add(Button::new(sign).min_size(least));
                button.widget_info(|| WidgetInfo::labeled(Role::Button, true, name));
                if button.on_hover_text(help).clicked() {
                    self.zoom(factor);
                }
            }
        });
        ui.horizontal_wrapped(|ui| {
            let help = tr("Turns the picture; so does a drag over it");
            for (name, x, y) in [
                (tr("Turn left"), -PUSH, 0.0),
                (tr("Turn right"), PUSH, 0.0),
                (tr("Higher"), 0.0, PUSH),
                (tr("Lower"), 0.0, -PUSH),
            ] {
                if ui.button(name).on_hover_text(help).clicked() {
                    self.camera.orbit(Vec2::new(x, y));
                }
            }
        });
        ui.horizontal_wrapped(|ui| {
            ui.checkbox(&mut self.cutter, tr("Cutter"));
            let mut along = matches!(self.follows, Follows::Tool(_));
            if ui.checkbox(&mut along, tr("Follow the tool")).changed() {
                let behind = if self.cutter { AT_TOOL_MM[1] } else { CLOSE_MM[1] };
                self.follows = if along { Follows::Tool(behind) } else { Follows::Nothing };
            }
            if !self.blank {
                self.factor(ui);
            }
            if pages {
                let help =
                    tr("Fingers on the picture turn the part; otherwise they scroll the page");
                ui.checkbox(&mut self.by_touch, tr("Turn by touch")).on_hover_text(help);
            }
        });
    }

    /// By how much heights are drawn larger.
    fn factor(&mut self, ui: &mut Ui) {
        let mut own = self.chosen.is_some();
        let help = tr("A factor of your own; otherwise as the distance wants it");
        let switch = ui.checkbox(&mut own, tr("Own factor")).on_hover_text(help);
        if switch.changed() {
            self.chosen = own.then_some(self.shown);
        }
        if let Some(times) = &mut self.chosen {
            let before = *times;
            let slider = Slider::new(times, TIMES[0]..=TIMES[1]).logarithmic(true);
            let slider = ui.add(slider.prefix(tr("heights ×")).max_decimals(0));
            touch::only_across(ui, &slider.labelled_by(switch.id), times, before);
        }
    }
}
