//! The five-mass machine: its masses moving, its frequency response and modes; wear, sound and
//! roughness over the tool's life and the predicted life; the stability chart; and the sound of the
//! cut.

mod controls;
mod life;
mod motion;
mod picture;
mod plot;
mod response;
pub(super) mod sound;
mod stability;
mod state;
mod vibration;
mod wear;

use egui::{CollapsingHeader, Frame, Margin, ScrollArea, Ui};

use super::{Panel, View};
use crate::app::command::Command;
use crate::app::widgets::scaffold;
use crate::base::language::{text, tr};
use crate::base::units::rev_s_from_rpm;
use crate::models::wear::WearModel;
use life::{Life, LifeInCut};
use sound::SoundControl;
use stability::{Operating, StabilityView};
use state::MachineState;
use vibration::VibrationView;
use wear::WearView;

/// Room at the right for the last number of an axis, points.
const AXIS_END: i8 = 16;
/// Height of the stability chart where it is scrolled, points.
const CHART_HEIGHT: f32 = 420.0;

/// What is shown of the machine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Part {
    #[default]
    Vibration,
    Life,
    Stability,
}

/// The name of the part with the stability chart.
pub const STABILITY: &str = text!("Stability");

const PARTS: [(Part, &str, &str); 3] = [
    (
        Part::Vibration,
        text!("Vibration"),
        text!("The masses moving, the frequency response and the modes"),
    ),
    (
        Part::Life,
        text!("Wear and sound"),
        text!("Wear, sound and roughness over the tool's life, and its predicted life"),
    ),
    (Part::Stability, STABILITY, text!("The depth at which the cut chatters, over the speed")),
];

/// The screen.
#[derive(Default)]
pub struct MachinePanel {
    part: Part,
    machine: Option<MachineState>,
    life: Option<Life>,
    in_cut: LifeInCut,
    vibration: VibrationView,
    wear: WearView,
    stability: StabilityView,
    sound: SoundControl,
}

impl Panel for MachinePanel {
    fn id(&self) -> &'static str {
        "machine"
    }

    fn title(&self) -> &'static str {
        text!("Machine")
    }

    fn words(&self) -> &'static str {
        text!(
            "chatter stability lobes sound vibration wear tool life modes frequency response limit depth"
        )
    }

    fn ui(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let dt_s = scaffold::frame_s(ui.ctx());
        self.advance(ui, view, dt_s);
        if view.narrow {
            self.narrow(ui, view, commands);
        } else {
            self.wide(ui, view, commands);
        }
    }

    fn show_part(&mut self, part: &str) {
        if let Some((part, ..)) = PARTS.into_iter().find(|(_, name, _)| *name == part) {
            self.part = part;
        }
    }

    fn left(&mut self) {
        self.sound.stop();
    }
}

impl MachinePanel {
    /// Follows the scenario and continues what is being computed.
    fn advance(&mut self, ui: &Ui, view: &View<'_>, dt_s: f64) {
        let scenario = view.session.current();
        if self.machine.as_ref().is_none_or(|machine| !machine.is_of(&scenario.machine)) {
            self.machine = Some(MachineState::new(&scenario.machine));
        }
        let adjusts = self.wear.adjusts;
        let busy = match self.part {
            Part::Vibration => self.vibration.advance(ui, dt_s),
            Part::Life => {
                self.in_cut.follow(view.session);
                let life = self.life.get_or_insert_with(|| Life::new(scenario, adjusts, view.jobs));
                life.follow(scenario, adjusts, view.jobs);
                false
            }
            Part::Stability => {
                let now_s = ui.input(|input| input.time);
                self.stability.follow(view.session, now_s, view.jobs);
                false
            }
        };
        let wears = scenario.wear.model == WearModel::Life;
        self.wear.follow(wears.then_some(view.session.row().used_life));
        self.sound.advance(view.session, [self.wear.x, 1.0], dt_s);
        if busy {
            ui.ctx().request_repaint();
        }
    }

    fn wide(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        scaffold::controls(ui, "machine controls", |ui| {
            controls::show(ui, view, commands);
        });
        scaffold::middle(ui, |ui| {
            self.head(ui, view);
            ui.add_space(2.0);
            let height = ui.available_height();
            let area = ScrollArea::vertical().id_salt(("machine", self.part as u8));
            let room = Frame::new().inner_margin(Margin { right: AXIS_END, ..Margin::ZERO });
            area.auto_shrink([false, false]).show(ui, |ui| {
                room.show(ui, |ui| self.part(ui, view, height, commands));
            });
        });
    }

    fn narrow(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        scaffold::column(ui, ("machine", self.part as u8)).show(ui, |ui| {
            scaffold::narrow().show(ui, |ui| {
                self.head(ui, view);
                let room = Frame::new().inner_margin(Margin { right: AXIS_END, ..Margin::ZERO });
                room.show(ui, |ui| self.part(ui, view, CHART_HEIGHT, commands));
                // Its verdict is what is looked for: nothing that is pressed stands before it.
                if self.part == Part::Stability {
                    self.sound(ui, view);
                }
                CollapsingHeader::new(tr("Settings of the machine"))
                    .id_salt("Settings of the machine")
                    .show_unindented(ui, |ui| {
                        controls::show(ui, view, commands);
                    });
            });
        });
    }

    /// The parts, and the sound.
    fn head(&mut self, ui: &mut Ui, view: &View<'_>) {
        ui.horizontal_wrapped(|ui| {
            for (part, name, help) in PARTS {
                ui.selectable_value(&mut self.part, part, tr(name)).on_hover_text(tr(help));
            }
            if !view.narrow {
                ui.separator();
                self.sound.show(ui, view.session.playback().playing);
            }
        });
        if view.narrow && self.part != Part::Stability {
            self.sound(ui, view);
        }
    }

    /// The sound, on a phone.
    fn sound(&mut self, ui: &mut Ui, view: &View<'_>) {
        ui.horizontal(|ui| self.sound.show(ui, view.session.playback().playing));
    }

    fn part(&mut self, ui: &mut Ui, view: &View<'_>, height: f32, commands: &mut Vec<Command>) {
        let (scenario, row) = (view.session.current(), view.session.row());
        let tooth_hz = f64::from(scenario.tool.teeth) * rev_s_from_rpm(row.spindle_rpm);
        match (self.part, &self.machine, &self.life) {
            (Part::Vibration, Some(machine), _) => {
                let force_n = scenario.life.contact_force_n;
                self.vibration.show(ui, machine, tooth_hz, force_n, height, commands);
            }
            (Part::Life, _, Some(life)) => {
                self.wear.show(ui, life, (&self.in_cut, view.session), height)
            }
            (Part::Stability, ..) => {
                let now = Operating { speed_rpm: row.spindle_rpm, depth_mm: row.axial_depth_mm };
                self.stability.show(ui, now, (height, view.narrow), commands);
            }
            // Made before the next frame.
            _ => ui.ctx().request_repaint(),
        }
    }
}
