//! The virtual profilometer of the screen: its line, drawn over the surface or written in numbers,
//! and what it finds, which the core computes.

mod fields;

use egui::Response;

use super::part::Part;
use super::profile_chart::Curves;
use crate::app::scene::camera::Camera;
use crate::app::scene::mesh::Mesh;
use crate::app::theme::Palette;
use crate::blocks::cutting::tool_path::strip_mm;
use crate::blocks::surface::topography::Topography;
use crate::models::part::CutPath;
use crate::models::roughness_profile::{ProfileSettings, evaluation_mm, run_up_mm};
use crate::study::profilometer::{Measurement, ProfileLine, measure};

/// Distance from the end of the automatic line to the tool's axis, and its step, mm.
const BEHIND_MM: f64 = 1.0;
const STEP_MM: f64 = 0.5;
/// How far from the borders of the surface a drawn line stays, mm.
const BORDER_MM: f64 = 0.02;
/// Pieces of the line in space, and its half-width as a fraction of the distance of the eye.
const PIECES: usize = 160;
const WIDTH: f32 = 0.0025;

/// What a measurement was made of.
#[derive(Clone, PartialEq)]
struct Made {
    changes: u64,
    cut: usize,
    line: ProfileLine,
    settings: ProfileSettings,
}

struct Found {
    made: Made,
    /// Marks there were; with more the result may be another, unless it is settled.
    marks: usize,
    settled: bool,
    result: Result<(Measurement, Curves), String>,
}

/// See the head of this file.
#[derive(Default)]
pub struct Profilometer {
    /// Whether it is out.
    pub open: bool,
    /// Whether a drag turns the part, in place of drawing the line.
    pub turns: bool,
    /// The line; none: right behind the tool.
    own: Option<ProfileLine>,
    shown: Option<ProfileLine>,
    cut: usize,
    pressed: Option<[f64; 2]>,
    found: Option<Found>,
}

/// The cut that is measured.
pub struct MeasuredLine<'a> {
    /// Its number, from 0.
    pub number: usize,
    /// Its path.
    pub path: &'a CutPath,
    /// Its surface.
    pub surface: &'a Topography,
}

/// Across the strip in the middle between two places along the cut.
fn middle_mm(cut: &MeasuredLine<'_>, ends_mm: [f64; 2]) -> f64 {
    let [a, b] =
        ends_mm.map(|x| strip_mm(cut.surface.outline(), cut.path, x).unwrap_or([0.0, 0.0]));
    0.5 * (a[0].max(b[0]) + a[1].min(b[1]))
}

/// The line right behind the tool: five sampling lengths, or what is cut so far.
fn behind_tool(cut: &MeasuredLine<'_>, settings: &ProfileSettings) -> Option<ProfileLine> {
    let [first_mm, last_mm] = cut.surface.range_mm()?;
    let first_mm = first_mm.max(0.0) + BORDER_MM;
    let length_mm = 2.0 * run_up_mm(settings) + evaluation_mm(settings);
    let length_mm = (length_mm / STEP_MM).ceil() * STEP_MM;
    let to_mm = (((last_mm - BEHIND_MM) / STEP_MM).floor() * STEP_MM).max(first_mm);
    let from_mm = (to_mm - length_mm).max(first_mm);
    let y_mm = middle_mm(cut, [from_mm, to_mm]);
    Some(ProfileLine { from_mm: [from_mm, y_mm], to_mm: [to_mm, y_mm] })
}

impl Profilometer {
    /// Brings the measurement up to date.
    pub fn follow(&mut self, cut: &MeasuredLine<'_>, changes: u64, settings: &ProfileSettings) {
        if self.cut != cut.number {
            (self.own, self.cut) = (None, cut.number);
        }
        self.shown = self.own.or_else(|| behind_tool(cut, settings));
        let Some(line) = self.shown else {
            self.found = None;
            return;
        };
        let made = Made { changes, cut: cut.number, line, settings: settings.clone() };
        let marks = cut.surface.marks().len();
        let kept = self.found.as_ref().is_some_and(|found| {
            let same = found.marks == marks || (found.settled && found.marks < marks);
            found.made == made && same
        });
        if kept {
            return;
        }
        let result = measure(cut.surface, cut.path, &line, settings);
        let end_mm = line.from_mm[0].max(line.to_mm[0]);
        let last_mm = cut.surface.range_mm().map_or(0.0, |range| range[1]);
        self.found = Some(Found {
            made,
            marks,
            settled: result.is_ok() && end_mm + 0.5 * BEHIND_MM < last_mm,
            result: result.map_err(|error| error.to_string()).map(|found| {
                let curves = Curves::of(&found);
                (found, curves)
            }),
        });
    }

    /// Takes in a drag over the picture: the line that is being drawn over the surface.
    pub fn draw(&mut self, response: &Response, camera: &Camera, cut: &MeasuredLine<'_>) {
        let pressed = response.ctx.input(|input| input.pointer.press_origin());
        let on_surface = |at| on_surface(camera, response.rect, at, cut);
        if response.drag_started_by(egui::PointerButton::Primary) {
            self.pressed = pressed.and_then(on_surface);
        }
        let now = response.interact_pointer_pos().and_then(on_surface);
        if let (Some(from_mm), Some(to_mm)) = (self.pressed, now)
            && response.dragged_by(egui::PointerButton::Primary)
        {
            // Thousandths are what the fields show.
            let round = |at: [f64; 2]| at.map(|x| (1000.0 * x).round() / 1000.0);
            self.own = Some(ProfileLine { from_mm: round(from_mm), to_mm: round(to_mm) });
            // It is measured in the next frame.
            response.ctx.request_repaint();
        }
        if response.drag_stopped() {
            self.pressed = None;
        }
    }

    /// The line in space, just above the surface of `part`.
    pub fn ribbon(&self, mesh: &mut Mesh, part: &Part<'_>, distance: f32, palette: &Palette) {
        let Some((line, ok)) = self.line() else { return };
        let length = line.length_mm() as f32;
        if !(length.is_finite() && length > 0.0) {
            return;
        }
        let color = if ok { palette.playhead } else { palette.bad };
        let [dx, dy] = [0, 1].map(|i| (line.to_mm[i] - line.from_mm[i]) as f32 / length);
        let at = |fraction: f32| line.at(f64::from(fraction * length)).map(|x| x as f32);
        let fractions: Vec<f32> = (0..=PIECES).map(|i| i as f32 / PIECES as f32).collect();
        // Straight over the highest of the fine surface.
        let rise = |fraction: &f32| {
            let [x, y] = at(*fraction);
            part.height(x, y) - part.outline(y)
        };
        let above = fractions.iter().map(rise).fold(0.0, f32::max) + WIDTH * distance;
        let mut row = |fraction: f32, half: f32| -> [u32; 2] {
            let [x, y] = at(fraction);
            let z = part.outline(y) + above;
            [half, -half]
                .map(|side| mesh.corner([x - side * dy, y + side * dx, z], [0.0; 3], color))
        };
        let half = WIDTH * distance;
        let middle: Vec<[u32; 2]> = fractions.iter().map(|fraction| row(*fraction, half)).collect();
        // Bars at both ends.
        let bar = 2.0 * half / length;
        let bars = [[0.0, bar], [1.0 - bar, 1.0]].map(|ends| ends.map(|x| row(x, 5.0 * half)));
        for pair in middle.windows(2).chain(bars.iter().map(|bar| &bar[..])) {
            mesh.strip(&pair[0], &pair[1]);
        }
    }

    /// The line as it is shown, and whether it could be measured.
    pub fn line(&self) -> Option<(ProfileLine, bool)> {
        let ok = self.found.as_ref().is_some_and(|found| found.result.is_ok());
        self.shown.map(|line| (line, ok))
    }
}

/// The point of the machined surface at a place on the screen, kept within it.
fn on_surface(
    camera: &Camera,
    rect: egui::Rect,
    at: egui::Pos2,
    cut: &MeasuredLine<'_>,
) -> Option<[f64; 2]> {
    let [first, last] = cut.surface.range_mm()?;
    let outline = cut.surface.outline();
    let mut z = 0.0_f64;
    let mut found = None;
    // The surface rises across the cut: its height there is met in a few steps.
    for _ in 0..8 {
        let [x, y] = camera.on_level(rect, at, z as f32)?.map(f64::from);
        let x = x.clamp(first.max(0.0) + BORDER_MM, (last - BORDER_MM).max(first + BORDER_MM));
        let [low, high] = strip_mm(outline, cut.path, x)?;
        let y = y.clamp(low + BORDER_MM, (high - BORDER_MM).max(low + BORDER_MM));
        z = outline.height_mm(y);
        found = Some([x, y]);
    }
    found
}
