//! The operator's view: the feed override in the hand, as on a machine's panel, what an operator sees and hears of the
//! cut, and afterwards the score against every way of control. The whole console can be had beside the knob.

mod figures;
mod panel;
mod score;

use egui::{Button, CentralPanel, Panel as SidePanel, RichText, Ui};

use super::super::View;
use super::super::machine::sound::SoundControl;
use crate::app::command::{Command, HandCommand};
use crate::app::shortcuts::hint;
use crate::app::widgets::{scaffold, touch};
use crate::base::language::{text, tr};
use crate::models::wear::WearModel;
pub use panel::panel;
use score::ScoreView;

/// Name of [`HandCommand::CutByHand`].
pub const CUT_BY_HAND: &str = text!("Cut by hand");
/// What the button that opens the view says it is for.
pub const HELP: &str = text!(
    "You hold the feed override: a knob, what an operator sees and hears, and a score against every controller \
     afterwards"
);

/// Diameter of the knob in the view of its own, on a desktop and on a phone, and beside the whole console, points.
const KNOB: [f32; 2] = [272.0, 184.0];
/// See [`KNOB`].
const KNOB_BESIDE: [f32; 2] = [212.0, 136.0];
/// Width of the panel with the knob, and of that beside the whole console, points.
const WIDTHS: [f32; 2] = [330.0, 244.0];
/// Share of a tool's life that is heard where the tool does not age, as on the screen Machine.
const HALF_WORN: f64 = 0.5;

/// The view.
#[derive(Default)]
pub struct OperatorView {
    /// Whether the whole console is shown beside the knob.
    whole: bool,
    sound: SoundControl,
    score: ScoreView,
}

impl OperatorView {
    /// Follows the cut: its sound, and the score once it is over.
    pub fn follow(&mut self, ui: &Ui, view: &View<'_>) {
        let session = view.session;
        if !session.hand().is_on() {
            return self.sound.stop();
        }
        self.score.follow(view);
        let row = session.row();
        let used = match session.current().wear.model {
            WearModel::Life => row.used_life,
            WearModel::Fixed => HALF_WORN,
        };
        // As loud as the model has it where the force is as asked for.
        let load = row.force_n / row.force_ref_n.max(1.0);
        self.sound.advance(session, [used, load], scaffold::frame_s(ui.ctx()));
    }

    /// Another screen is shown.
    pub fn left(&mut self) {
        self.sound.stop();
    }

    /// Shows what belongs to the operator mode, if it is on; whether that is all of the screen.
    pub fn show(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) -> bool {
        if !view.session.hand().is_on() {
            return false;
        }
        let diameter = if self.whole { KNOB_BESIDE } else { KNOB }[usize::from(view.narrow)];
        if view.narrow {
            // Below everything, where a thumb reaches it.
            let below = SidePanel::bottom("operator").resizable(false).frame(scaffold::narrow());
            below.show(ui, |ui| panel(ui, view, diameter, commands));
            if self.whole {
                let above = SidePanel::top("operator head").resizable(false);
                above.frame(scaffold::narrow()).show(ui, |ui| self.head(ui, view, commands));
                return false;
            }
            CentralPanel::no_frame().frame(scaffold::narrow()).show(ui, |ui| {
                scaffold::column(ui, "operator")
                    .show(ui, |ui| self.instruments(ui, view, commands));
            });
            return true;
        }
        let width = WIDTHS[usize::from(self.whole)];
        let beside = SidePanel::right("operator").resizable(false).exact_size(width);
        beside.frame(scaffold::wide()).show(ui, |ui| {
            if self.whole {
                self.head(ui, view, commands);
                ui.add_space(6.0);
            }
            panel(ui, view, diameter, commands);
            if self.whole {
                ui.add_space(6.0);
                ui.horizontal_wrapped(|ui| self.sound(ui, view));
                ui.add_space(6.0);
                self.score.sentence(ui, view);
            }
        });
        if !self.whole {
            scaffold::middle(ui, |ui| {
                scaffold::column(ui, "operator")
                    .show(ui, |ui| self.instruments(ui, view, commands));
            });
        }
        !self.whole
    }

    /// What an operator sees: figures, and after the cut the score.
    fn instruments(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        self.head(ui, view, commands);
        ui.add_space(4.0);
        figures::state(ui, view, commands);
        // What is news stands in sight.
        let over = view.session.finished().is_some();
        if over {
            ui.add_space(4.0);
            self.score.show(ui, view, &mut self.whole, commands);
            ui.add_space(6.0);
        }
        figures::show(ui, view);
        ui.add_space(4.0);
        ui.horizontal_wrapped(|ui| self.sound(ui, view));
        if !over {
            ui.add_space(4.0);
            self.score.show(ui, view, &mut self.whole, commands);
        }
    }

    fn sound(&mut self, ui: &mut Ui, view: &View<'_>) {
        self.sound.show(ui, view.session.playback().playing);
    }

    /// The name of the view, and the ways out of it.
    fn head(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        ui.horizontal_wrapped(|ui| {
            if !view.narrow {
                ui.label(RichText::new(tr("Operator")).heading());
            }
            let least = touch::least(ui);
            let help = tr("From the start of the part, without a controller and at 100 %");
            let cut = Button::new(tr(CUT_BY_HAND)).min_size(least);
            if ui.add(cut).on_hover_text(help).clicked() {
                commands.push(Command::hand(HandCommand::CutByHand));
            }
            let help = tr(
                "Plots, settings and sentences beside the knob, which an operator does not have",
            );
            ui.checkbox(&mut self.whole, tr("Whole console")).on_hover_text(help);
            let leave = Command::hand(HandCommand::Mode(false));
            let keys = hint(ui.ctx(), view.place, &Command::hand(HandCommand::Toggle));
            let help = tr!("Back to the console; the cut goes on as it is{keys}", keys = keys);
            if ui.add(Button::new(tr("Leave")).min_size(least)).on_hover_text(help).clicked() {
                commands.push(leave);
            }
        });
    }
}
