//! The masses moving beside the frequency response, and the table of modes.

use egui::{RichText, Ui};

use super::motion::{Drive, MotionPicture};
use super::picture;
use super::response::ResponseView;
use super::state::MachineState;
use crate::app::command::Command;
use crate::app::format;
use crate::app::theme::{self, Palette};
use crate::app::widgets::icon::{self, Icon};
use crate::app::widgets::save_table::{SavedTable, TableOf, save_table};
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::{decimal, fixed, tr};
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
    /// As it was chosen; otherwise as motion is wanted at all.
    moving: Option<bool>,
    /// Of the movement shown, turns.
    phase: f64,
    response: ResponseView,
}

impl Default for VibrationView {
    fn default() -> Self {
        let drive = Drive::Teeth(HARMONICS[1]);
        Self { drive, moving: None, phase: 0.0, response: ResponseView::default() }
    }
}

/// Least height of the masses with their springs, points.
const MASSES: f32 = 310.0;

impl VibrationView {
    /// Moves on by `dt_s`; `true` while the masses move.
    pub fn advance(&mut self, ui: &Ui, dt_s: f64) -> bool {
        let moving = self.is_moving(ui);
        if moving {
            self.phase = (self.phase + SHOWN_HZ * dt_s).fract();
        }
        moving
    }

    fn is_moving(&self, ui: &Ui) -> bool {
        self.moving.unwrap_or(!theme::is_still(ui.ctx()))
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
            let moving = self.is_moving(ui);
            let (sign, name) = match moving {
                true => (Icon::Pause, tr("Stop the masses")),
                false => (Icon::Play, tr("Move the masses")),
            };
            if icon::button(ui, sign, name, name, true).clicked() {
                self.moving = Some(!moving);
            }
            let help = tr("The contact force at the frequency of the cursor");
            ui.selectable_value(&mut self.drive, Drive::Frequency, tr("At the cursor"))
                .on_hover_text(help);
            for harmonic in HARMONICS {
                let name = match harmonic {
                    1 => tr("Passing teeth").to_owned(),
                    _ => format!("×{harmonic}"),
                };
                let help = tr!(
                    "The contact force at {harmonic} times the tooth passing of now",
                    harmonic = harmonic,
                );
                let drive = Drive::Teeth(harmonic);
                let response = touch::choice(ui, self.drive == drive, name);
                if response.clicked() {
                    self.drive = drive;
                }
                response.widget_info(|| {
                    let name = tr!("Passing teeth ×{harmonic}", harmonic = harmonic);
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
        let (at, slow) = (format::fine(motion.f_hz, "Hz"), decimal(SHOWN_HZ.to_string()));
        let text = match self.drive {
            Drive::Mode(i) => {
                tr!("Mode {number}: {at}, shown at {slow} Hz", number = i + 1, at = at, slow = slow)
            }
            Drive::Frequency | Drive::Teeth(_) => {
                let force = format::quantity(force_n, "N");
                tr!("{force} at {at}, shown at {slow} Hz", force = force, at = at, slow = slow)
            }
        };
        ui.label(RichText::new(text).color(palette.weak));
        let height = (height - (ui.cursor().top() - top)).max(MASSES);
        picture::show(ui, machine, &motion, self.phase, height);
    }

    /// The modes; a click lets one swing.
    fn modes(&mut self, ui: &mut Ui, machine: &MachineState, commands: &mut Vec<Command>) {
        let palette = Palette::at(ui);
        ui.add_space(2.0);
        ui.label(RichText::new(tr("Modes")).strong());
        if machine.modes.is_empty() {
            let text = tr("The eigenvalues of this machine do not converge.");
            Standing::Watch.label(ui, text, |text| text);
            return;
        }
        touch::low_rows(ui, 20.0);
        touch::grid(ui, "modes").num_columns(4).striped(true).spacing([14.0, 1.0]).show(ui, |ui| {
            for title in [tr("mode"), "Hz", tr("damping"), tr("moves most")] {
                ui.label(RichText::new(title).small().color(palette.weak));
            }
            ui.end_row();
            for (i, mode) in machine.modes.iter().enumerate() {
                let drive = Drive::Mode(i);
                let name = tr!("Mode {number}", number = i + 1);
                ui.selectable_value(&mut self.drive, drive, name).on_hover_text(tr("Let it swing"));
                ui.label(hertz(mode.free.frequency_hz));
                ui.label(mode.damping_ratio.map_or("-".to_owned(), |d| fixed(d, 4)));
                ui.label(RichText::new(movers(&mode.free.shape)));
                ui.end_row();
            }
        });
        let table = SavedTable { what: "modes", of: TableOf::Open, partial: None };
        save_table(ui, &table, || sheet(machine), commands);
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
    if f_hz >= 1e5 { format!("{} MHz", fixed(1e-6 * f_hz, 2)) } else { fixed(f_hz, 2) }
}

/// The nodes that move at least a third as far as the one that moves most.
fn movers(shape: &[f64; 5]) -> String {
    let largest = shape.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let mut parts: Vec<(f64, &str)> =
        shape.iter().map(|x| x / largest).zip(NODES).filter(|(x, _)| x.abs() > 1.0 / 3.0).collect();
    parts.sort_by(|a, b| b.0.abs().total_cmp(&a.0.abs()));
    let told = |(x, node): &(f64, &str)| {
        format!("{} {}", tr(node), format::signed(decimal(format!("{x:+.2}"))))
    };
    parts.iter().map(told).collect::<Vec<String>>().join(", ")
}
