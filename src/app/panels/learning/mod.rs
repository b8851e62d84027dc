//! The networks of UNKS at the playhead: NM-1 and NM-2 drawn with what they have learned, how the
//! feedback gives way to them, and several passes over the same part. Shown beside the block
//! diagram while UNKS is the controller.

mod actions;
mod curves;
mod net;
mod passes;

use egui::{CentralPanel, CollapsingHeader, Frame, Margin, Panel as SidePanel};
use egui::{RichText, ScrollArea, Ui};

use super::View;
use crate::app::command::Command;
use crate::app::history::LearningSample;
use crate::app::theme::{self, Palette};
use crate::app::widgets::legend;
use crate::base::language::{text, tr};
use crate::models::unks::UnksStart;
use net::{DrawnNet, Shown};
use passes::PassesView;

/// From this width on, points, the networks stand beside each other.
const BESIDE_FROM: f32 = 560.0;
/// Height of a network and of a curve, points.
const NET_HEIGHT: f32 = 260.0;
const CURVE_HEIGHT: f32 = 150.0;

/// The view.
#[derive(Default)]
pub struct LearningView {
    shown: Shown,
    passes: PassesView,
}

impl LearningView {
    /// Draws it into the whole of `ui`; the passes go on even while other things are looked at.
    pub fn show(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        self.passes.follow(view.session.scenario());
        let samples = view.session.chosen().learning().until(view.session.playback().playhead_s);
        if view.narrow {
            ScrollArea::vertical().id_salt("learning").auto_shrink(false).show(ui, |ui| {
                self.networks(ui, samples);
                curves::show(ui, view, samples, CURVE_HEIGHT);
                self.controls(ui, view, commands);
            });
            return;
        }
        SidePanel::left("learning controls")
            .exact_size(theme::CONTROLS_WIDTH + 64.0)
            .resizable(false)
            .frame(Frame::new().inner_margin(Margin { right: 12, ..Margin::ZERO }))
            .show(ui, |ui| {
                ScrollArea::vertical()
                    .auto_shrink([false, false])
                    .show(ui, |ui| self.controls(ui, view, commands));
            });
        let frame = Frame::new().inner_margin(Margin { left: 12, ..Margin::ZERO });
        CentralPanel::no_frame().frame(frame).show(ui, |ui| {
            ScrollArea::vertical().id_salt("networks").auto_shrink(false).show(ui, |ui| {
                self.networks(ui, samples);
                curves::show(ui, view, samples, CURVE_HEIGHT);
            });
        });
    }

    fn controls(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        actions::show(ui, view, commands);
        ui.add_space(6.0);
        self.passes.show(ui, view, commands);
    }

    fn networks(&mut self, ui: &mut Ui, samples: &[LearningSample]) {
        let palette = Palette::at(ui);
        let (Some(first), Some(now)) = (samples.first(), samples.last()) else {
            ui.label(RichText::new(tr("No networks at the playhead yet.")).color(palette.weak));
            return;
        };
        ui.horizontal_wrapped(|ui| {
            for shown in Shown::ALL {
                ui.selectable_value(&mut self.shown, shown, shown.label())
                    .on_hover_text(shown.help());
            }
            legend::sample(ui, tr("positive"), net::POSITIVE);
            legend::sample(ui, tr("negative"), net::NEGATIVE);
        });
        let cold = now.start == UnksStart::Cold;
        let drawn =
            |i: usize| DrawnNet::new(i, cold, &first.weights[i], &now.weights[i], now.lessons[i]);
        let [forward, inverse] = [drawn(0), drawn(1)];
        if ui.available_width() < BESIDE_FROM {
            net::show(ui, &inverse, self.shown, NET_HEIGHT);
            net::show(ui, &forward, self.shown, NET_HEIGHT);
        } else {
            ui.columns_const(|[left, right]| {
                net::show(left, &forward, self.shown, NET_HEIGHT);
                net::show(right, &inverse, self.shown, NET_HEIGHT);
            });
        }
        CollapsingHeader::new(tr("What is this?")).id_salt("learning words").show(ui, |ui| {
            for line in words(cold).iter().chain(SIGNS) {
                ui.label(tr(line));
            }
        });
    }
}

/// What the pictures mean.
const SIGNS: &[&str] = &[
    text!(
        "F is the measured force, F1 and F2 what it was one and two control periods ago; a is the \
         override that the feed drive has reached, u the one that is asked for."
    ),
    text!(
        "A dot in a neuron is its bias. Beside the weights, a ring marks the neurons that have changed \
         most."
    ),
];

/// The scheme in words.
fn words(cold: bool) -> &'static [&'static str] {
    if cold {
        &[
            text!(
                "NM-2 is the inverse model: it asks for the override by itself. It begins untrained and \
                 asks for 100 %, so at first the feedback does all the work, as the division controller \
                 does."
            ),
            text!(
                "What the feedback adds is what NM-2 has not known: it learns from it, sample by sample \
                 (feedback-error learning). As it learns, the feedback's share falls."
            ),
            text!("NM-1 has no part in the cold start and does not learn."),
        ]
    } else {
        &[
            text!(
                "NM-2 is the inverse model: it asks for the override that gives the wanted force. NM-1 is \
                 the forward model: it predicts the force of an override, and an internal loop corrects \
                 the override with it before it is sent."
            ),
            text!(
                "Both were trained before and go on learning in the cut: NM-1 from what the force came \
                 to, NM-2 from what the loops have added to it."
            ),
        ]
    }
}
