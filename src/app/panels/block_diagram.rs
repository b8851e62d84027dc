//! The closed loop of the paper's Fig. 3 as a live picture. A click on a wire plots its signal, a
//! click on a block opens its equation card.

mod brush;
mod card_view;
mod draw;
mod layout;
mod moment;
mod signal_plot;

use egui::{Frame, Margin, Rect, ScrollArea, UiBuilder, pos2};

use super::equation_cards::Block;
use super::learning::LearningView;
use super::{Panel, View};
use crate::app::command::Command;
use crate::app::widgets::scaffold;
use crate::base::language::{text, tr};
use crate::run::diagram::Wire;
use crate::run::diagram::wires::RA;
use moment::Now;

/// Fraction of the height that plot and card take, and where they stand below each other.
const DETAILS_FRACTION: f32 = 0.33;
/// See [`DETAILS_FRACTION`].
const DETAILS_NARROW: f32 = 0.55;
/// Height of the plot over the card, points, and the least height of both at which it stays in sight.
const PLOT_OVER_CARD: f32 = 132.0;
/// See [`PLOT_OVER_CARD`].
const LEAST_WITH_PLOT: f32 = 260.0;
/// Least and largest height of plot and card, points.
const DETAILS_HEIGHT: (f32, f32) = (180.0, 460.0);
const GAP: f32 = 8.0;

/// The screen.
pub struct BlockDiagramPanel {
    wire: Wire,
    block: Block,
    /// Whether the card also explains itself in words.
    explain: bool,
    learning: LearningView,
    /// Whether the networks are shown in the place of the diagram.
    watching: bool,
}

impl Default for BlockDiagramPanel {
    fn default() -> Self {
        Self {
            wire: RA,
            block: Block::Cutting,
            explain: false,
            learning: LearningView::default(),
            watching: false,
        }
    }
}

impl Panel for BlockDiagramPanel {
    fn id(&self) -> &'static str {
        "block_diagram"
    }

    fn title(&self) -> &'static str {
        text!("Block diagram")
    }

    fn words(&self) -> &'static str {
        "closed loop scheme figure 3 equations controller gain Kp transfer function"
    }

    fn ui(&mut self, ui: &mut egui::Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let side = if view.narrow { 4 } else { 12 };
        Frame::new().inner_margin(Margin::symmetric(side, 6)).show(ui, |ui| {
            let learns = view.session.current().controller.kind.learns();
            if learns {
                self.choose(ui);
            }
            if learns && self.watching {
                self.learning.show(ui, view, commands);
            } else {
                self.screen(ui, view, commands);
            }
        });
    }
}

impl BlockDiagramPanel {
    /// Diagram or networks, where there are networks that learn.
    fn choose(&mut self, ui: &mut egui::Ui) {
        ui.horizontal(|ui| {
            ui.selectable_value(&mut self.watching, false, tr("Closed loop"));
            let help = tr("NM-1 and NM-2 at the playhead, learning curves, several passes");
            ui.selectable_value(&mut self.watching, true, tr("Networks that learn"))
                .on_hover_text(help);
        });
    }

    fn screen(&mut self, ui: &mut egui::Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let now = Now::of(view.session);
        let area = ui.available_rect_before_wrap();
        let fraction = if view.narrow { DETAILS_NARROW } else { DETAILS_FRACTION };
        let details = (area.height() * fraction).clamp(DETAILS_HEIGHT.0, DETAILS_HEIGHT.1);
        let split = (area.bottom() - details).max(area.top() + 0.3 * area.height());
        let above = Rect::from_min_max(area.min, pos2(area.right(), split - GAP));
        let below = Rect::from_min_max(pos2(area.left(), split), area.max);
        ui.scope_builder(UiBuilder::new().max_rect(above), |ui| self.diagram(ui, view, &now));
        ui.scope_builder(UiBuilder::new().max_rect(below), |ui| {
            self.details(ui, view, &now, commands);
        });
    }

    fn diagram(&mut self, ui: &mut egui::Ui, view: &View<'_>, now: &Now<'_>) {
        ScrollArea::both().id_salt("diagram").auto_shrink(false).show(ui, |ui| {
            let layout = layout::arrange(ui.available_size(), view.narrow);
            match draw::diagram(ui, &layout, now, self.wire, self.block) {
                Some(draw::Clicked::Wire(wire)) => self.wire = wire,
                Some(draw::Clicked::Block(block)) => self.block = block,
                None => {}
            }
        });
    }

    fn details(
        &mut self,
        ui: &mut egui::Ui,
        view: &View<'_>,
        now: &Now<'_>,
        commands: &mut Vec<Command>,
    ) {
        if view.narrow {
            let in_sight = ui.available_height() >= LEAST_WITH_PLOT;
            if in_sight {
                self.plot(ui, view, now);
            }
            // Each has a place of its own: what is asked for is seen from its head.
            let area = scaffold::column(ui, ("card", self.block.info().id));
            area.show(ui, |ui| {
                self.card(ui, now, commands);
                if !in_sight {
                    self.plot(ui, view, now);
                }
            });
            return;
        }
        ui.columns_const(|[left, right]| {
            self.plot(left, view, now);
            ScrollArea::vertical()
                // Each card has a place of its own: another one begins at its head.
                .id_salt(("card", self.block.info().id))
                .auto_shrink(false)
                .show(right, |ui| ui.vertical(|ui| self.card(ui, now, commands)));
        });
    }

    fn plot(&self, ui: &mut egui::Ui, view: &View<'_>, now: &Now<'_>) {
        let height = if view.narrow { PLOT_OVER_CARD } else { ui.available_height() };
        signal_plot::show(ui, view.session, now, self.wire, height);
    }

    fn card(&mut self, ui: &mut egui::Ui, now: &Now<'_>, commands: &mut Vec<Command>) {
        if let Some(wire) = card_view::show(ui, self.block, now, &mut self.explain, commands) {
            self.wire = wire;
        }
    }
}
