//! The masses moving beside the frequency response, and the table of modes.

use egui::{RichText, Ui};

use super::motion::{Drive, MotionPicture};
use super::picture;
use super::response::ResponseView;
use super::state::MachineState;
use crate::app::command::Command;
use crate::app::format;
use crate::app::theme::Palette;
use crate::app::widgets::icon::{self, Icon};
use crate::app::widgets::save_table::save_table;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::models::structure::parameters::NODES;
use crate::study::export::sheet::{Entry, Sheet};

/// From this width on, points, picture and response stand beside each other.
const BESIDE_FROM: f32 = 760.0;
/// Height of the picture and of the response where they are scrolled, points.
const PICTURE: f32 = 360.0;
const RESPONSE: f32 = 340.0;
/// Room for the modes below, points.
const MODES: f32 = 172.0;
/// Frequency at which movements are shown, Hz: slow enough to be followed.
const SHOWN_HZ: f64 = 0.6;
/// Harmonics of the passing teeth on offer.
const HARMONICS: [u32; 3] = [1, 2, 3];

/// See the head of this file.
pub struct VibrationView {
    drive: Drive,
    moving: bool,
    /// Of the movement shown, turns.
    phase: f64,
    response: ResponseView,
}

impl Default for VibrationView {
    fn default() -> Self {
        let drive = Drive::Teeth(HARMONICS[1]);
        Self { drive, moving: true, phase: 0.0, response: ResponseView::default() }
    }
}

/// Least height of the masses with their springs, points.
const MASSES: f32 = 310.0;

impl VibrationView {
    /// Moves on by `dt_s`; `true` while the masses move.
    pub fn advance(&mut self, dt_s: f64) -> bool {
        if self.moving {
            self.phase = (self.phase + SHOWN_HZ * dt_s).fract();
        }
        self.moving
    }

    /// Draws all of it.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        machine: &MachineState,
        tooth_hz: f64,
        force_n: f64,
        seen_height: f32,
        commands: &mut Vec<Command>,
    ) {
        if ui.available_width() < BESIDE_FROM {
            self.picture(ui, machine, tooth_hz, force_n, PICTURE);
            self.response(ui, machine, tooth_hz, RESPONSE);
            self.modes(ui, machine, commands);
            return;
        }
        let height = seen_height.max(PICTURE + 0.5 * MODES);
        ui.columns_const(|[left, right]| {
            self.picture(left, machine, tooth_hz, force_n, height);
            self.response(right, machine, tooth_hz, height - MODES);
            self.modes(right, machine, commands);
        });
    }

    fn response(&mut self, ui: &mut Ui, machine: &MachineState, tooth_hz: f64, height: f32) {
        if self.response.show(ui, machine, tooth_hz, height) {
            self.drive = Drive::Frequency;
        }
    }

    fn picture(
        &mut self,
        ui: &mut Ui,
        machine: &MachineState,
        tooth_hz: f64,
        force_n: f64,
        height: f32,
    ) {
        let palette = Palette::at(ui);
        let top = ui.cursor().top();
        ui.horizontal_wrapped(|ui| {
            let (sign, name) = match self.moving {
                true => (Icon::Pause, "Stop the masses"),
                false => (Icon::Play, "Move the masses"),
            };
            if icon::button(ui, sign, name, name, true).clicked() {
                self.moving = !self.moving;
            }
            let help = "The contact force at the frequency of the cursor";
            ui.selectable_value(&mut self.drive, Drive::Frequency, "At the cursor")
                .on_hover_text(help);
            for harmonic in HARMONICS {
                let name = match harmonic {
                    1 => "Passing teeth".to_owned(),
                    _ => format!("×{harmonic}"),
                };
                let help =
                    format!("The contact force at {harmonic} times the tooth passing of now");
                let drive = Drive::Teeth(harmonic);
                let response = touch::choice(ui, self.drive == drive, name);
                if response.clicked() {
                    self.drive = drive;
                }
                response.widget_info(|| {
                    let name = format!("Passing teeth ×{harmonic}");
                    let chosen = self.drive == drive;
                    egui::WidgetInfo::selected(egui::Role::Button, true, chosen, name)
                });
                response.on_hover_text(help);
            }
        });
        let cursor_hz = self.response.cursor_hz;
        let motion = MotionPicture::of(machine, self.drive, cursor_hz, tooth_hz, force_n);
        let Some(motion) = motion else {
            // A mode that another machine had.
            self.drive = Drive::Frequency;
            ui.ctx().request_repaint();
            return;
        };
        let what = match self.drive {
            Drive::Mode(i) => format!("Mode {}: {}", i + 1, format::fine(motion.f_hz, "Hz")),
            Drive::Frequency | Drive::Teeth(_) => {
                let force = format::quantity(force_n, "N");
                format!("{force} at {}", format::fine(motion.f_hz, "Hz"))
            }
        };
        let text = format!("{what}, shown at {SHOWN_HZ} Hz");
        ui.label(RichText::new(text).color(palette.weak));
        let height = (height - (ui.cursor().top() - top)).max(MASSES);
        picture::show(ui, machine, &motion, self.phase, height);
    }

    /// The modes; a click lets one swing.
    fn modes(&mut self, ui: &mut Ui, machine: &MachineState, commands: &mut Vec<Command>) {
        let palette = Palette::at(ui);
        ui.add_space(2.0);
        ui.label(RichText::new("Modes").strong());
        if machine.modes.is_empty() {
            let text = "The eigenvalues of this machine do not converge.";
            Standing::Watch.label(ui, text, |text| text);
            return;
        }
        touch::low_rows(ui, 20.0);
        touch::grid(ui, "modes").num_columns(4).striped(true).spacing([14.0, 1.0]).show(ui, |ui| {
            for title in ["mode", "Hz", "damping", "moves most"] {
                ui.label(RichText::new(title).small().color(palette.weak));
            }
            ui.end_row();
            for (i, mode) in machine.modes.iter().enumerate() {
                let drive = Drive::Mode(i);
                let name = format!("Mode {}", i + 1);
                ui.selectable_value(&mut self.drive, drive, name).on_hover_text("Let it swing");
                ui.label(hertz(mode.free.frequency_hz));
                ui.label(mode.damping_ratio.map_or("-".to_owned(), |d| format!("{d:.4}")));
                ui.label(RichText::new(movers(&mode.free.shape)));
                ui.end_row();
            }
        });
        save_table(ui, "modes", || sheet(machine), commands);
    }
}

/// The modes as a file, with the shape of each.
fn sheet(machine: &MachineState) -> Sheet {
    let titles = ["Mode", "Frequency [Hz]", "Damping ratio"].map(str::to_owned);
    let mut sheet =
        Sheet::new(titles.into_iter().chain(NODES.map(|node| format!("Shape at {node}"))));
    for (i, mode) in machine.modes.iter().enumerate() {
        let first = [(i + 1) as f64, mode.free.frequency_hz].map(Entry::from);
        let shape = mode.free.shape.map(Entry::from);
        sheet.row(first.into_iter().chain([mode.damping_ratio.into()]).chain(shape));
    }
    sheet
}

fn hertz(f_hz: f64) -> String {
    if f_hz >= 1e5 { format!("{:.2} MHz", 1e-6 * f_hz) } else { format!("{f_hz:.2}") }
}

/// The nodes that move at least a third as far as the one that moves most.
fn movers(shape: &[f64; 5]) -> String {
    let largest = shape.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let mut parts: Vec<(f64, &str)> =
        shape.iter().map(|x| x / largest).zip(NODES).filter(|(x, _)| x.abs() > 1.0 / 3.0).collect();
    parts.sort_by(|a, b| b.0.abs().total_cmp(&a.0.abs()));
    let parts: Vec<String> = parts.iter().map(|(x, node)| format!("{node} {x:+.2}")).collect();
    parts.join(", ")
}
