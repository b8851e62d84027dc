//! The off-line optimisation: the force surface over cutting speed and feed per tooth with the
//! boundaries of seven constraints, the particle swarm that flies over it, the optimum, and its
//! way into the programmed values.

mod answer;
mod controls;
mod convergence;
mod layers;
mod legend;
mod map;
mod marks;
mod picture;
mod polyline;
mod readout;
mod recommended;
mod relief;
mod search;
mod space;
mod steps;
mod table;
mod transport;

use egui::{CollapsingHeader, Panel as SidePanel, RichText, ScrollArea, Ui};

use super::{Panel, View};
use crate::app::command::Command;
use crate::app::theme::{self, Palette};
use crate::app::widgets::save_table::{SavedTable, TableOf, save_table};
use crate::app::widgets::scaffold;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::{text, tr};
use map::Map;
use marks::Moving;
use recommended::RecommendedCard;
use relief::Relief;
use search::Search;

/// Width of the column with the answer, points.
const ANSWER_WIDTH: f32 = 440.0;
/// From this width on, points, the map stands between settings and answer.
const WIDE_FROM: f32 = 1128.0;
/// Height of the map where it is scrolled, as a fraction of the width, and at most, points.
const MAP_FRACTION: f32 = 0.86;
const MAP_HEIGHT_SCROLLED: f32 = 460.0;
/// Room for the legend above it, and for the buttons above that, points.
const LEGEND_HEIGHT: f32 = 110.0;
const BUTTONS_HEIGHT: f32 = 40.0;
/// Least height of the map, points.
const MAP_HEIGHT_MIN: f32 = 220.0;
/// Height of the convergence plots with their titles, points.
const CONVERGENCE_HEIGHT: f32 = 132.0;

/// The screen.
#[derive(Default)]
pub struct PlanPanel {
    search: Search,
    map: Map,
    relief: Relief,
    /// Whether the surface is shown in space.
    in_space: bool,
    /// What a cutting-data table recommends.
    recommended: RecommendedCard,
    /// The constraint that is explained.
    open: Option<usize>,
}

impl Panel for PlanPanel {
    fn id(&self) -> &'static str {
        "plan"
    }

    fn title(&self) -> &'static str {
        text!("Plan")
    }

    fn words(&self) -> &'static str {
        text!("optimise optimum cutting conditions swarm constraints feed speed particle")
    }

    fn has_timeline(&self) -> bool {
        false
    }

    fn ui(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        self.search.follow(view.session.scenario(), view.jobs);
        let dt_s = scaffold::frame_s(ui.ctx());
        self.search.advance(dt_s);
        if self.search.is_playing() {
            ui.ctx().request_repaint();
        }
        if ui.available_width() < WIDE_FROM {
            self.narrow(ui, view, commands);
        } else {
            self.wide(ui, view, commands);
        }
    }

    fn left(&mut self) {
        self.search.leave();
    }
}

impl PlanPanel {
    fn wide(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        scaffold::controls(ui, "plan controls", |ui| {
            controls::show(ui, view.session, commands);
            self.recommended.show(ui, view.session.scenario(), commands);
        });
        SidePanel::right("plan answer")
            .exact_size(ANSWER_WIDTH)
            .resizable(false)
            .frame(scaffold::wide())
            .show(ui, |ui| {
                ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
                    self.pinned(ui, view);
                    self.answer(ui, view, commands);
                    ui.add_space(4.0);
                    self.steps(ui, view);
                });
            });
        scaffold::middle(ui, |ui| {
            self.transport(ui, view, commands);
            let gap = ui.spacing().item_spacing.y;
            self.map(ui, view, ui.available_height() - CONVERGENCE_HEIGHT - 2.0 * gap);
            self.convergence(ui);
        });
    }

    fn narrow(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let room = ui.available_height() - LEGEND_HEIGHT - BUTTONS_HEIGHT;
        scaffold::column(ui, "plan").show(ui, |ui| {
            scaffold::narrow().show(ui, |ui| {
                self.transport(ui, view, commands);
                let height = MAP_FRACTION * ui.available_width();
                // All of it is in sight at once, its legend and what moves the swarm with it.
                let most = room.clamp(MAP_HEIGHT_MIN, MAP_HEIGHT_SCROLLED);
                let height = height.clamp(MAP_HEIGHT_MIN, most);
                self.map(ui, view, height + LEGEND_HEIGHT);
                self.pinned(ui, view);
                CollapsingHeader::new(tr("Settings of the plan"))
                    .id_salt("Settings of the plan")
                    .show_unindented(ui, |ui| {
                        controls::show(ui, view.session, commands);
                        self.recommended.show(ui, view.session.scenario(), commands);
                    });
                self.answer(ui, view, commands);
                self.convergence(ui);
                self.steps(ui, view);
            });
        });
    }

    fn transport(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        transport::show(ui, &mut self.search, view.session.scenario(), commands);
    }

    /// The map with its legend, `height` points high together; or why there is none.
    fn map(&mut self, ui: &mut Ui, view: &View<'_>, height: f32) {
        let positions = self.search.positions();
        let found = match self.search.found() {
            Some(Ok(found)) => found,
            Some(Err(error)) => return no_plan(ui, &error.to_string(), height),
            None => return,
        };
        let top = ui.cursor().top();
        let programmed = map::programmed(&found.problem, view.session.scenario());
        let name = match map::on_the_map(programmed) {
            true => tr("programmed now"),
            false => tr("programmed now: outside the map"),
        };
        legend::show(ui, &mut self.map.layers, found, name);
        ui.horizontal_wrapped(|ui| {
            readout::scale(ui, &found.picture);
            let help = tr("The force as a surface in space, cut by the plane of its limit");
            let button = touch::small(ui, egui::Button::selectable(self.in_space, "3-D"));
            if ui.add(button).on_hover_text(help).clicked() {
                self.in_space = !self.in_space;
            }
            match self.in_space {
                true => self.relief.buttons(ui),
                false => self.map.parts(ui, found),
            }
        });
        let left = (height - (ui.cursor().top() - top)).max(MAP_HEIGHT_MIN);
        let programmed = Some(programmed).filter(|point| map::on_the_map(*point));
        let moving = Moving { positions: &positions, programmed, pinned: self.map.pinned };
        match self.in_space {
            true => self.relief.show(ui, found, &self.map.layers, &moving, left),
            false => self.map.show(ui, found, view.session.scenario(), &moving, left),
        }
    }

    /// The values at the place that was clicked.
    fn pinned(&mut self, ui: &mut Ui, view: &View<'_>) {
        if let Some(Ok(found)) = self.search.found() {
            readout::pinned(ui, &mut self.map.pinned, found, view.session.scenario());
        }
    }

    fn answer(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let Some(Ok(found)) = self.search.found() else { return };
        answer::show(ui, found, view.session, commands);
        ui.add_space(4.0);
        table::show(ui, found.optimum(), &mut self.open);
        let searching = || tr!("{n} iterations of the swarm", n = found.stage().counts.iteration);
        let done = found.stage().counts.done;
        let partial = (!done).then_some(&searching as &dyn Fn() -> String);
        let table = SavedTable { what: "plan", of: TableOf::Open, partial };
        save_table(ui, &table, || table::sheet(found.optimum()), commands);
    }

    fn convergence(&mut self, ui: &mut Ui) {
        if let Some(Ok(found)) = self.search.found() {
            convergence::show(ui, found.history(), CONVERGENCE_HEIGHT);
        }
    }

    fn steps(&mut self, ui: &mut Ui, view: &View<'_>) {
        let found = match self.search.found() {
            Some(Ok(found)) => Some(&*found),
            Some(Err(_)) | None => None,
        };
        steps::show(ui, view, found);
    }
}

/// In place of the map: why there is none.
fn no_plan(ui: &mut Ui, error: &str, height: f32) {
    let palette = Palette::at(ui);
    theme::card(palette).show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.set_min_height(0.3 * height);
        Standing::Bad.label(ui, tr("No plan can be made"), RichText::strong);
        ui.label(error);
        let text = tr("The settings are beside or below.");
        ui.label(RichText::new(text).color(palette.weak));
    });
}
