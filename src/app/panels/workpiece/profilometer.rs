//! The virtual profilometer of the screen: its line, drawn over the surface or written in numbers,
//! and what it finds, which the core computes.

use egui::{Response, RichText, Ui};

use super::part::Part;
use super::profile_chart::{self, Curves};
use crate::app::command::Command;
use crate::app::panels::View;
use crate::app::scene::camera::Camera;
use crate::app::scene::mesh::Mesh;
use crate::app::theme::{self, Palette};
use crate::app::widgets::number::Field;
use crate::app::widgets::setting::{Size, setting};
use crate::base::model::part::CutPath;
use crate::base::model::roughness_profile::{ProfileSettings, evaluation_mm, run_up_mm};
use crate::blocks::cutting::tool_path::strip_mm;
use crate::blocks::surface::topography::Topography;
use crate::study::profilometer::{Line, Measurement, measure};

/// The line that comes by itself ends so far behind the tool's axis, in steps of this, mm.
const BEHIND_MM: f64 = 1.0;
const STEP_MM: f64 = 0.5;
/// How far from the borders of the surface a drawn line stays, mm.
const BORDER_MM: f64 = 0.02;
/// Pieces of the line in space, and its half-width as a share of the distance of the eye.
const PIECES: usize = 160;
const WIDTH: f32 = 0.0025;

/// What a measurement was made of.
#[derive(Clone, PartialEq)]
struct Made {
    changes: u64,
    cut: usize,
    line: Line,
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
    own: Option<Line>,
    shown: Option<Line>,
    cut: usize,
    pressed: Option<[f64; 2]>,
    found: Option<Found>,
}

/// The cut that is measured.
pub struct Measured<'a> {
    /// Its number, from 0.
    pub number: usize,
    /// Its path.
    pub path: &'a CutPath,
    /// Its surface.
    pub surface: &'a Topography,
}

/// Across the strip in the middle between two places along the cut.
fn middle_mm(path: &CutPath, ends_mm: [f64; 2]) -> f64 {
    let [a, b] = ends_mm.map(|x| strip_mm(path, x).unwrap_or([0.0, 0.0]));
    0.5 * (a[0].max(b[0]) + a[1].min(b[1]))
}

/// The line right behind the tool, as long as five sampling lengths take, or as is cut yet.
fn behind_tool(cut: &Measured<'_>, settings: &ProfileSettings) -> Option<Line> {
    let [first_mm, last_mm] = cut.surface.range_mm()?;
    let first_mm = first_mm.max(0.0) + BORDER_MM;
    let length_mm = 2.0 * run_up_mm(settings) + evaluation_mm(settings);
    let length_mm = (length_mm / STEP_MM).ceil() * STEP_MM;
    let to_mm = (((last_mm - BEHIND_MM) / STEP_MM).floor() * STEP_MM).max(first_mm);
    let from_mm = (to_mm - length_mm).max(first_mm);
    let y_mm = middle_mm(cut.path, [from_mm, to_mm]);
    Some(Line { from_mm: [from_mm, y_mm], to_mm: [to_mm, y_mm] })
}

impl Profilometer {
    /// Brings the measurement up to date.
    pub fn follow(&mut self, cut: &Measured<'_>, changes: u64, settings: &ProfileSettings) {
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
    pub fn draw(&mut self, response: &Response, camera: &Camera, cut: &Measured<'_>) {
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
            self.own = Some(Line { from_mm: round(from_mm), to_mm: round(to_mm) });
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
        let at = |share: f32| line.at(f64::from(share * length)).map(|x| x as f32);
        let shares: Vec<f32> = (0..=PIECES).map(|i| i as f32 / PIECES as f32).collect();
        // Straight over the highest of the fine surface.
        let rise = |share: &f32| {
            let [x, y] = at(*share);
            part.height(x, y) - part.ball(y)
        };
        let above = shares.iter().map(rise).fold(0.0, f32::max) + WIDTH * distance;
        let mut row = |share: f32, half: f32| -> [u32; 2] {
            let [x, y] = at(share);
            let z = part.ball(y) + above;
            [half, -half]
                .map(|side| mesh.corner([x - side * dy, y + side * dx, z], [0.0; 3], color))
        };
        let half = WIDTH * distance;
        let middle: Vec<[u32; 2]> = shares.iter().map(|share| row(*share, half)).collect();
        // Bars at both ends.
        let bar = 2.0 * half / length;
        let bars = [[0.0, bar], [1.0 - bar, 1.0]].map(|ends| ends.map(|x| row(x, 5.0 * half)));
        for pair in middle.windows(2).chain(bars.iter().map(|bar| &bar[..])) {
            mesh.strip(&pair[0], &pair[1]);
        }
    }

    /// The line as it is shown, and whether it could be measured.
    pub fn line(&self) -> Option<(Line, bool)> {
        let ok = self.found.as_ref().is_some_and(|found| found.result.is_ok());
        self.shown.map(|line| (line, ok))
    }

    /// Line, figures and profile.
    pub fn show(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let palette = Palette::at(ui);
        ui.horizontal_wrapped(|ui| {
            ui.label("A drag");
            ui.radio_value(&mut self.turns, false, "draws the line");
            ui.radio_value(&mut self.turns, true, "turns the part");
        });
        let Some(line) = self.shown else {
            ui.label("No tooth has cut anything yet: there is no surface to measure.");
            return;
        };
        self.ends(ui, line, commands);
        let scenario = view.session.current();
        setting(ui, "profile.long_mm", scenario, Size::Small, commands);
        setting(ui, "profile.short_um", scenario, Size::Small, commands);
        match self.found.as_ref().map(|found| &found.result) {
            Some(Ok((found, curves))) => {
                figures(ui, found, scenario.profile.long_mm);
                profile_chart::show(ui, curves);
            }
            Some(Err(error)) => {
                let mut text = error.clone();
                text[..1].make_ascii_uppercase();
                ui.label(RichText::new(theme::unit(&format!("{text}."))).color(palette.bad));
            }
            None => {}
        }
    }

    /// The ends of the line as numbers.
    fn ends(&mut self, ui: &mut Ui, line: Line, commands: &mut Vec<Command>) {
        let mut ends = [line.from_mm, line.to_mm];
        let mut said = None;
        egui::Grid::new("line").num_columns(4).show(ui, |ui| {
            for (names, end) in [["From x", "From y"], ["To x", "To y"]].iter().zip(&mut ends) {
                for (name, (value, range)) in names.iter().zip(end.iter_mut().zip(FIELDS)) {
                    let label = ui.label(*name);
                    let field =
                        Field { name, unit: "mm", range, speed: 0.02, decimals: 3, suffix: " mm" };
                    field.show(ui, value, &mut said).labelled_by(label.id);
                }
                ui.end_row();
            }
        });
        commands.extend(said.map(Command::Notify));
        let edited = Line { from_mm: ends[0], to_mm: ends[1] };
        if edited != line {
            self.own = Some(edited);
            ui.request_repaint();
        }
        ui.horizontal_wrapped(|ui| {
            let help = "Five sampling lengths along the feed, as the tool goes on";
            let button = egui::Button::selectable(self.own.is_none(), "Behind the tool");
            if ui.add(button).on_hover_text(help).clicked() {
                self.own = None;
                ui.request_repaint();
            }
            let length = theme::quantity(line.length_mm(), "mm");
            ui.label(format!("{length} long"));
        });
    }
}

/// Ranges of the fields of x and y: any machine, the ball.
const FIELDS: [[f64; 2]; 2] = [[-100.0, 100_000.0], [-8.0, 8.0]];

/// The point of the machined surface at a place on the screen, kept within it.
fn on_surface(
    camera: &Camera,
    rect: egui::Rect,
    at: egui::Pos2,
    cut: &Measured<'_>,
) -> Option<[f64; 2]> {
    let [first, last] = cut.surface.range_mm()?;
    let radius = cut.surface.radius_mm();
    let mut z = 0.0_f64;
    let mut found = None;
    // The surface rises across the cut: its height there is met in a few steps.
    for _ in 0..8 {
        let [x, y] = camera.on_level(rect, at, z as f32)?.map(f64::from);
        let x = x.clamp(first.max(0.0) + BORDER_MM, (last - BORDER_MM).max(first + BORDER_MM));
        let [low, high] = strip_mm(cut.path, x)?;
        let y = y.clamp(low + BORDER_MM, (high - BORDER_MM).max(low + BORDER_MM));
        z = radius - (radius * radius - y * y).max(0.0).sqrt();
        found = Some([x, y]);
    }
    found
}

/// Ra, Rq, Rz and what they were taken of.
fn figures(ui: &mut Ui, found: &Measurement, long_mm: f64) {
    let palette = Palette::at(ui);
    let roughness = &found.roughness;
    ui.horizontal_wrapped(|ui| {
        for (name, value) in
            [("Ra", roughness.ra_um), ("Rq", roughness.rq_um), ("Rz", roughness.rz_um)]
        {
            let text = format!("{name} {}", theme::quantity(value, "um"));
            ui.label(RichText::new(text).size(15.0).strong());
            ui.add_space(6.0);
        }
    });
    let long = theme::fine(long_mm, "mm");
    let lengths = match found.lengths {
        1 => format!("Over one sampling length of {long}; the standard takes five. "),
        n if n < 5 => format!("Over {n} sampling lengths of {long}; the standard takes five. "),
        n => format!("Over {n} sampling lengths of {long}. "),
    };
    let run = if found.run_ra_um > 0.0 {
        let ra = theme::quantity(found.run_ra_um, "um");
        format!("The run's Ra with dynamics is {ra} along the line on average.")
    } else {
        "Simulated tooth by tooth, K5 gives no Ra here: feed marks and run-out alone.".to_owned()
    };
    ui.label(RichText::new(lengths + &run).small().color(palette.weak));
}
