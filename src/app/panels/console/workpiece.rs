//! The window "Workpiece": the cuts of the part (or its one path with a depth profile) as tables,
//! drawn to scale with the tool where it is, and the material's inhomogeneity along them.

mod hand;
mod material;
mod picture;
mod table;

use egui::{RichText, Ui};

use super::super::View;
use crate::app::command::{Command, PlaybackCommand};
use crate::app::format;
use crate::app::theme::{self, Palette};
use crate::app::widgets::icon::{self, Icon};
use crate::app::widgets::setting::{Size, setting};
use crate::app::widgets::standing::Standing;
use crate::app::widgets::window::{self, WindowPlace};
use crate::base::language::{text, tr};
use crate::base::settings::Value;
use crate::blocks::cutting::tool_path::{ToolPath, wall_mm};
use crate::blocks::cutting::workpiece::{DepthProfile, Workpiece};
use crate::models::part::APPROACH_MM;
use crate::models::part::{MAX_CUTS, MAX_SECTIONS, MIN_SECTION_MM, Section};
use crate::models::tool::Outline;
use crate::run::presets;
use crate::study::uses::Screen;
use hand::{Hand, Moved};
use material::MaterialPicture;
use picture::PicturePart;

const CUTS: &str = "workpiece.cuts";
/// The parts of the papers, as shipped scenarios have them.
const PARTS: [(&str, &str); 2] =
    [(text!("Experiment 1"), "experiment-1"), (text!("Experiment 2"), "experiment-2")];
/// A section as it is added: length, axial depth, wall, mm.
const NEW_SECTION: Section = [30.0, 2.0, 2.0];

/// What the buttons that open the window say it is for.
pub const EDIT_HELP: &str =
    text!("The part from the side: drag its depths and its ends, or type them in a table");

/// The window.
#[derive(Default)]
pub struct WorkpieceWindow {
    open: bool,
    /// The cut that is shown.
    cut: usize,
    /// What was wrong with the last number that was typed.
    said: Option<String>,
    material: MaterialPicture,
    hand: Hand,
}

/// The cut that the tool is in, and where its axis is along it, mm.
fn tool(view: &View<'_>) -> (usize, f64) {
    let position_mm = view.session.row().position_mm;
    let begins_mm = ToolPath::begins_of(&view.session.current().workpiece);
    let cut = begins_mm.partition_point(|begin_mm| *begin_mm <= position_mm).saturating_sub(1);
    match begins_mm.get(cut) {
        Some(begin_mm) => (cut, position_mm - begin_mm - APPROACH_MM),
        None => (0, position_mm),
    }
}

/// The one path as sections, as the tool meets it from the start: along a wall that stays, or that follows a profile of
/// the radial depth.
fn path_sections(workpiece: &Workpiece, outline: &Outline) -> Vec<Section> {
    let of_start_mm = wall_mm(outline, workpiece.axial_depth_mm, workpiece.radial_depth_mm);
    let sections = DepthProfile::new(workpiece).sections(workpiece.length_mm, of_start_mm);
    let radial = DepthProfile::radial(workpiece);
    match radial.is_flat() {
        true => sections,
        false => {
            radial.walled(&sections, |axial_mm, radial_mm| wall_mm(outline, axial_mm, radial_mm))
        }
    }
}

/// The same for a formula or a network, which take the radial depth as it is set.
fn path_by_formula(workpiece: &Workpiece, outline: &Outline) -> Vec<Section> {
    let mut sections = path_sections(workpiece, outline);
    if !workpiece.radial_steps.is_empty() {
        return sections;
    }
    for [_, axial_mm, wall] in &mut sections {
        *wall = wall_mm(outline, *axial_mm, workpiece.radial_depth_mm);
    }
    sections
}

impl WorkpieceWindow {
    /// Opens it on the cut that the tool is in, or closes it.
    pub fn toggle(&mut self, view: &View<'_>) {
        self.open = !self.open;
        self.cut = tool(view).0;
        self.said = None;
    }

    /// Shows it, if it is open.
    pub fn show(&mut self, ui: &Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let size = [theme::OVERLAY_WIDTH, theme::OVERLAY_HEIGHTS[0]];
        let place = WindowPlace { screen: ui.max_rect(), narrow: view.narrow, size, share: 1.0 };
        let mut open = self.open;
        window::show(ui.ctx(), text!("Workpiece"), place, &mut open, |ui| {
            self.content(ui, view, commands);
        });
        self.open = open;
    }

    fn content(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let scenario = view.session.current();
        let workpiece = &scenario.workpiece;
        parts(ui, workpiece, &scenario.tool.outline(), commands);
        ui.separator();
        if workpiece.cuts.is_empty() {
            self.path(ui, view, commands);
        } else {
            self.cuts(ui, view, commands);
        }
        if let Some(said) = &self.said {
            Standing::Bad.label(ui, said, |text| text);
        }
    }

    fn cuts(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let workpiece = &view.session.current().workpiece;
        let mut cuts = workpiece.cuts.clone();
        self.cut = self.cut.min(cuts.len() - 1);
        let (tool_cut, tool_mm) = tool(view);
        self.choose(ui, &mut cuts, tool_cut);
        if let Some(sections) = workpiece.cuts.get(self.cut) {
            let tool_mm = match tool_cut.cmp(&self.cut) {
                std::cmp::Ordering::Less => f64::NEG_INFINITY,
                std::cmp::Ordering::Equal => tool_mm,
                std::cmp::Ordering::Greater => f64::INFINITY,
            };
            let part = PicturePart {
                sections: sections.clone(),
                open: false,
                walls: true,
                tool_mm,
                outline: view.session.current().tool.outline(),
            };
            let begin_mm = ToolPath::begins_of(workpiece)[self.cut] + APPROACH_MM;
            if let Some(moved) = self.pictures(ui, view, &part, begin_mm) {
                table::move_section(&mut cuts[self.cut], moved);
            }
            table::sections(ui, &part.outline, (self.cut, &mut cuts), &mut self.said);
        }
        if cuts != workpiece.cuts {
            commands.push(Command::set(CUTS, Value::from(cuts)));
        }
    }

    /// The row of cuts, one of them chosen, with what can be done with them.
    fn choose(&mut self, ui: &mut Ui, cuts: &mut Vec<Vec<Section>>, tool_cut: usize) {
        ui.horizontal_wrapped(|ui| {
            for number in 0..cuts.len() {
                let mark = match number == tool_cut {
                    true => tr!("Cut {number}, tool", number = number + 1),
                    false => tr!("Cut {number}", number = number + 1),
                };
                ui.selectable_value(&mut self.cut, number, mark);
            }
            let room = cuts.len() < MAX_CUTS;
            let full = tr!("At most {n} cuts", n = MAX_CUTS);
            let add = ui.add_enabled(room, egui::Button::new(tr("Add a cut")));
            if add.on_disabled_hover_text(&full).clicked() {
                cuts.push(vec![NEW_SECTION]);
                self.cut = cuts.len() - 1;
            }
            let name = tr!("Duplicate cut {number}", number = self.cut + 1);
            if icon::button(ui, Icon::Copy, &name, if room { &name } else { &full }, room).clicked()
            {
                cuts.insert(self.cut + 1, cuts[self.cut].clone());
                self.cut += 1;
            }
            let name = tr!("Remove cut {number}", number = self.cut + 1);
            let last = tr("The last cut stays: “One path” goes without cuts");
            let several = cuts.len() > 1;
            if icon::button(ui, Icon::Close, &name, if several { &name } else { last }, several)
                .clicked()
            {
                cuts.remove(self.cut);
                self.cut = self.cut.min(cuts.len() - 1);
            }
        });
    }

    fn path(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let scenario = view.session.current();
        for path in ["workpiece.length_mm", "workpiece.radial_depth_mm"] {
            setting(ui, Screen::Console, path, scenario, Size::Small, commands);
        }
        let tool_mm = view.session.row().position_mm;
        let by_teeth = scenario.plant.force_model.tooth_by_tooth();
        let sections = if by_teeth { path_sections } else { path_by_formula };
        let outline = scenario.tool.outline();
        let sections = sections(&scenario.workpiece, &outline);
        let part = PicturePart { sections, open: true, walls: false, tool_mm, outline };
        let playback = view.session.playback();
        let under_way = playback.playhead_s > 0.0 && !playback.at_end;
        let cut_to_mm = if under_way { tool_mm } else { f64::NEG_INFINITY };
        if let Some(moved) = self.pictures(ui, view, &part, 0.0) {
            if table::is_long(&scenario.workpiece) {
                let said =
                    tr("These depths are profiles of a file: take them away to drag a depth.");
                commands.push(Command::notify(said.to_owned()));
            } else {
                table::move_stretch(&scenario.workpiece, cut_to_mm, moved, commands);
            }
        }
        if table::is_long(&scenario.workpiece) {
            table::long(ui, &scenario.workpiece, commands);
        } else {
            table::profile(ui, scenario, cut_to_mm, commands, &mut self.said);
        }
        // There at all times, so that nothing comes under the finger that pressed it.
        let grey = table::any_is_cut(&scenario.workpiece, cut_to_mm);
        let back = ui.add_enabled(grey, egui::Button::new(tr("Back to the start")));
        let help =
            tr("What is grey is cut already: at the start of the cut every stretch can be changed");
        if back.on_hover_text(help).on_disabled_hover_text(help).clicked() {
            commands.push(Command::Playback(PlaybackCommand::SeekTo(0.0)));
        }
        if under_way {
            let at = format::quantity(tool_mm, "mm");
            let text = tr!(
                "The tool is at {at}: changed depths act from there and from now on. A stretch that \
                 begins before it holds only for what of it is still to be cut; what is cut stays.",
                at = at
            );
            ui.label(RichText::new(text).small().color(Palette::at(ui).weak));
        } else if view.session.finished().is_some() {
            let text = tr(
                "The cut is over: changed depths are those of the whole part, which is cut anew from its start.",
            );
            ui.label(RichText::new(text).small().color(Palette::at(ui).weak));
        }
    }

    /// Side view, view from above and material on one axis.
    fn pictures(
        &mut self,
        ui: &mut Ui,
        view: &View<'_>,
        part: &PicturePart,
        begin_mm: f64,
    ) -> Option<Moved> {
        let length_mm: f64 = part.sections.iter().map(|section| section[0]).sum();
        let place = match part.tool_mm {
            at if at == f64::NEG_INFINITY => tr("still to be cut").to_owned(),
            at if at == f64::INFINITY => tr("cut already").to_owned(),
            at if at < 0.0 => tr("the tool comes in from the air").to_owned(),
            at => tr!("tool at {place}", place = format::quantity(at, "mm")),
        };
        let length = format::quantity(length_mm, "mm");
        let text = tr!("{length} long, {place}", length = length, place = place);
        ui.label(RichText::new(text).strong());
        let (map, moved) = picture::show(ui, part, &mut self.hand);
        let moved = moved.or_else(|| self.hand.field(ui, &mut self.said));
        let place_mm = [begin_mm, length_mm];
        self.material.show(ui, view.session.current(), &map, place_mm, part.tool_mm);
        ui.add_space(4.0);
        moved
    }
}

/// The shipped parts, and the way from one path to cuts and back.
fn parts(ui: &mut Ui, workpiece: &Workpiece, outline: &Outline, commands: &mut Vec<Command>) {
    let mut set = |cuts: Vec<Vec<Section>>| {
        commands.push(Command::set(CUTS, Value::from(cuts)));
    };
    ui.horizontal_wrapped(|ui| {
        ui.label(tr("Take the part of"));
        for (name, preset) in PARTS {
            let help = tr(
                "Takes over the cuts alone; the scenario of this name also sets controller, noise and feed",
            );
            if ui.button(tr(name)).on_hover_text(help).clicked()
                && let Ok(scenario) = presets::load(preset)
            {
                set(scenario.workpiece.cuts.clone());
            }
        }
        if workpiece.cuts.is_empty() {
            let help =
                tr("One straight cut with this path's depths, the tool coming in from the air");
            if ui.button(tr("Make cuts of the path")).on_hover_text(help).clicked() {
                let mut sections = path_sections(workpiece, outline);
                sections.retain(|section| section[0] >= MIN_SECTION_MM);
                sections.truncate(MAX_SECTIONS);
                sections.iter_mut().for_each(|[length_mm, _, wall_mm]| {
                    *length_mm = length_mm.min(table::limits().0);
                    *wall_mm = wall_mm.clamp(-table::limits().1, table::limits().1);
                });
                set(vec![sections]);
            }
        } else {
            let help = tr("No cuts: the path with its length, depths and depth profile");
            if ui.button(tr("One path")).on_hover_text(help).clicked() {
                set(Vec::new());
            }
        }
    });
}
