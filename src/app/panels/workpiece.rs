//! The part in space, cut as the run goes: its surface true to the simulated profile, its heights
//! drawn larger by a factor that is shown, its colour the local roughness against the tolerance; and
//! a profilometer that measures the surface along a line. A part that came from a program is shown as the blank that it is
//! cut from, too.

mod blank;
mod cutter;
mod judged;
mod part;
mod picture;
mod placed;
mod profile_chart;
mod profilometer;
mod program;
mod view;

use egui::{CentralPanel, Color32, Frame, Margin, Panel as SidePanel, Rect};
use egui::{RichText, ScrollArea, Stroke, Ui, Vec2};

use super::console::workpiece::{EDIT_HELP, WorkpieceWindow};
use super::{BroughtFile, Panel, View};
use crate::app::command::{Command, FileCommand};
use crate::app::format;
use crate::app::session::Session;
use crate::app::theme::{self, Palette};
use crate::app::widgets::legend;
use crate::app::widgets::my_files::my_files;
use crate::app::widgets::scaffold;
use crate::app::widgets::standing::Standing;
use crate::base::language::{text, tr};
use crate::blocks::cutting::tool_path::ToolPath;
use crate::blocks::reference::Reference;
use crate::models::disturbances::Disturbance;
use crate::run::tooth_marks::MarkedPart;
use crate::study::library::LibraryKind;
use blank::ShownBlank;
use judged::Lengths;
use picture::{Kept, SLOWER};
use profilometer::{MeasuredLine, Profilometer};
use program::ProgramWindow;
use view::Looking;

/// Width of the column beside the picture, points.
const BESIDE_WIDTH: f32 = 360.0;
/// Height of the picture where everything stands in one column, as a fraction of the width.
const NARROW_FRACTION: f32 = 0.85;
/// How a place within the tolerance, above it up to twice as far off, farther above, and below it, stands.
const SIGNS: [Standing; 4] = [Standing::Good, Standing::Watch, Standing::Bad, Standing::Plain];

/// The screen.
#[derive(Default)]
pub struct WorkpiecePanel {
    looking: Looking,
    profilometer: Profilometer,
    marks: Option<Marked>,
    kept: Kept,
    depths: WorkpieceWindow,
    program: ProgramWindow,
    /// The blank of the program that became the part.
    blank: Option<ShownBlank>,
    /// The disturbance that a press on the part places.
    placing: Option<Disturbance>,
}

/// Tooth marks of the run as far as it is revealed, and how good the surface is.
struct Marked {
    changes: u64,
    marks: MarkedPart,
    lengths: Lengths,
}

impl Marked {
    /// The cut under the tool.
    fn measured<'a>(&'a self, path: &'a ToolPath) -> MeasuredLine<'a> {
        let number = self.marks.cut();
        MeasuredLine { number, path: path.of(number), surface: &self.marks.cuts()[number].surface }
    }
}

/// The way of the tool, as it stands at the playhead.
fn under_tool(session: &Session) -> ToolPath {
    let current = session.current();
    let mut path =
        ToolPath::new(&current.workpiece, current.tool.outline()).disturbed(&current.disturbances);
    let position_mm = session.row().position_mm;
    while path.next_cut(position_mm).is_some() {}
    path
}

impl Panel for WorkpiecePanel {
    fn id(&self) -> &'static str {
        "workpiece"
    }

    fn title(&self) -> &'static str {
        text!("Workpiece")
    }

    fn words(&self) -> &'static str {
        text!("part surface 3d profile roughness profilometer picture")
    }

    fn ui(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        self.follow(view.session);
        placed::escape(ui, &mut self.placing);
        self.screen(ui, view, commands);
        self.depths.show(ui, view, commands);
        self.program.show(ui, view, commands);
        if let Some(taken) = self.program.taken.take() {
            self.blank = Some(ShownBlank::of(taken, view.session));
            // It is drawn in the next frame.
            ui.ctx().request_repaint();
        }
    }

    fn take(&mut self, file: &BroughtFile) {
        match file {
            BroughtFile::Program { name, text } => self.program.bring(name, text),
            BroughtFile::Table { .. }
            | BroughtFile::Search { .. }
            | BroughtFile::Mission { .. }
            | BroughtFile::Measured(_)
            | BroughtFile::ToFit(_)
            | BroughtFile::Linked(_) => {}
        }
    }

    fn left(&mut self) {
        self.placing = None;
    }
}

impl WorkpiecePanel {
    fn screen(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        if view.narrow {
            let margin = Frame::new().inner_margin(Margin::symmetric(8, 4));
            scaffold::column(ui, "workpiece").show(ui, |ui| {
                margin.show(ui, |ui| {
                    let height = NARROW_FRACTION * ui.available_width();
                    self.in_space(ui, view.session, (height, true), commands);
                    self.beside(ui, view, commands);
                });
            });
            return;
        }
        let margin = Frame::new().inner_margin(Margin::symmetric(12, 8));
        SidePanel::right("workpiece beside")
            .exact_size(BESIDE_WIDTH)
            .resizable(false)
            .frame(margin)
            .show(ui, |ui| {
                ScrollArea::vertical()
                    .auto_shrink([false, false])
                    .show(ui, |ui| self.beside(ui, view, commands));
            });
        CentralPanel::no_frame().show(ui, |ui| {
            let height = ui.available_height();
            self.in_space(ui, view.session, (height, false), commands);
        });
    }

    /// The blank, or the strip along the way.
    fn in_space(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        (height, pages): (f32, bool),
        commands: &mut Vec<Command>,
    ) {
        match self.shows_blank(session) {
            true => self.blank_picture(ui, session, (height, pages), commands),
            false => self.picture(ui, session, (height, pages), commands),
        }
    }

    /// Whether the blank is drawn: the part is that of its program, and it is asked for.
    fn shows_blank(&self, session: &Session) -> bool {
        let asked = |blank: &ShownBlank| blank.asked && blank.is_of(session).is_ok();
        !self.profilometer.open && self.blank.as_ref().is_some_and(asked)
    }

    /// Brings the marks up to the playhead.
    fn follow(&mut self, session: &Session) {
        let rows = session.revealed();
        let current = self.marks.as_ref();
        if current.is_none_or(|m| m.changes != session.changes() || m.marks.rows() > rows.len()) {
            let marks = MarkedPart::new(session.scenario())
                .disturbed(&session.current().disturbances, session.chosen().run().breakages());
            let lengths = Lengths::default();
            self.marks = Some(Marked { changes: session.changes(), marks, lengths });
        }
        if let Some(marked) = &mut self.marks {
            marked.marks.extend(rows);
            marked.lengths.extend(session);
            if self.profilometer.open {
                let path = under_tool(session);
                let (changes, settings) = (session.changes(), &session.current().profile);
                self.profilometer.follow(&marked.measured(&path), changes, settings);
            }
        }
    }

    fn beside(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let shows_blank = self.shows_blank(view.session);
        if ui.button(tr("Edit depths\u{2026}")).on_hover_text(tr(EDIT_HELP)).clicked() {
            self.depths.toggle(view);
        }
        let help = tr(
            "A table of depths along a path (CSV), or a program (G-code) that is cut from a blank; both can be dropped \
             onto the window, too",
        );
        ui.horizontal_wrapped(|ui| {
            if ui.button(tr("Part from a file\u{2026}")).on_hover_text(help).clicked() {
                commands.push(Command::File(FileCommand::OpenPart));
            }
            my_files(ui, view, Some(LibraryKind::Part), commands);
        });
        self.choose_picture(ui, view.session);
        match self.blank.as_mut().filter(|_| shows_blank) {
            Some(blank) => blank.looking.controls(ui, view.narrow),
            None => self.looking.controls(ui, view.narrow),
        }
        ui.add_space(4.0);
        placed::choose(ui, &mut self.placing);
        ui.add_space(4.0);
        self.legend(ui, view.session);
        ui.separator();
        let help =
            tr("A stylus drawn along a line over the machined surface: its profile, Ra, Rq, Rz");
        let text = RichText::new(tr("Profilometer")).strong();
        let switch = ui.checkbox(&mut self.profilometer.open, text).on_hover_text(help);
        if switch.changed() {
            // The cutter would hide what is right behind it.
            self.looking.cutter = !self.profilometer.open;
            self.follow(view.session);
            ui.request_repaint();
        }
        if self.profilometer.open {
            self.profilometer.show(ui, view, commands);
        }
    }

    fn legend(&self, ui: &mut Ui, session: &Session) {
        let palette = Palette::at(ui);
        let scenario = session.current();
        let held = scenario.target.reference;
        let judged_by = match (held, scenario.machine.coupled) {
            (Reference::Ra, false) => tr("Colour: Ra against its tolerance"),
            (Reference::Ra, true) => tr("Colour: Ra with dynamics against its tolerance"),
            (Reference::Force, false) => tr("Colour: force against its tolerance"),
            (Reference::Force, true) => tr("Colour: force without dynamics against its tolerance"),
        };
        ui.label(RichText::new(judged_by).strong());
        let lengths = self.marks.as_ref().map_or(Lengths::default(), |marked| marked.lengths);
        let told = |name: &str, mm: f64| format!("{name}, {} mm", format::number(mm, "N"));
        let spacing = ui.spacing().clone();
        ui.spacing_mut().interact_size.y = 18.0;
        ui.horizontal_wrapped(|ui| {
            for (i, name) in judged::names(held).iter().enumerate() {
                let text = told(tr(name), lengths.mm[i]);
                legend::sample_of(ui, &text, theme::MACHINED[i], |painter, rect, color| {
                    painter.rect_filled(rect.shrink(1.0), 3.0, color);
                    let square = Rect::from_center_size(rect.center(), Vec2::splat(8.0));
                    SIGNS[i].paint(painter, square, Color32::BLACK, color);
                });
            }
            if lengths.unknown_mm > 0.0 {
                let text = told(tr("outside the model: not judged"), lengths.unknown_mm);
                legend::sample_of(ui, &text, theme::METAL, |painter, rect, color| {
                    painter.rect_filled(rect.shrink(1.0), 3.0, color);
                });
            }
            if !scenario.disturbances.is_empty() {
                let text = tr("disturbances, along the edges of the part");
                legend::sample_of(ui, text, palette.warn, |painter, rect, color| {
                    painter.rect_filled(rect.shrink(1.0), 3.0, color);
                });
            }
            let [body, edges] = theme::CUTTER;
            legend::sample_of(ui, tr("cutting edges"), edges, |painter, rect, color| {
                painter.rect_filled(rect.shrink(1.0), 3.0, body);
                painter.hline(rect.shrink(1.0).x_range(), rect.center().y, Stroke::new(4.0, color));
            });
        });
        *ui.spacing_mut() = spacing;
        // Too rough, or too large a force: what a price per millimetre counts.
        let scrap_mm = lengths.mm[1] + lengths.mm[2];
        let cost = scenario.economics.scrap_cost_per_mm * scrap_mm;
        let length = format::number(scrap_mm, "N");
        let scrap = tr!("Scrap: {length} mm, at a cost of {cost:.2}", length = length, cost = cost);
        ui.label(RichText::new(scrap).strong()).on_hover_text(tr(
            "Length of the way beyond the tolerance on the bad side, by `economics.scrap_cost_per_mm`",
        ));
        let turns = tr!("The cutter is drawn turning {times} times slower.", times = SLOWER);
        if self.shows_blank(session) {
            let note = tr(
                "The blank has its true size; what is cut has the colour of the moment in which the cutter was there last.",
            );
            let text = format!("{note} {turns}");
            ui.label(RichText::new(text).small().color(palette.weak));
            return;
        }
        let mut text = match held {
            Reference::Ra => {
                let neither = tr("Too rough is rework or scrap; smoother than asked is neither.");
                format!("{neither} ")
            }
            Reference::Force => String::new(),
        };
        text.push_str(&turns);
        text.push(' ');
        text.push_str(tr("What stands in front of the wall was taken by an earlier cut."));
        if scenario.plant.force_model.tooth_by_tooth() {
            text.push(' ');
            text.push_str(tr(
                "Simulated tooth by tooth, K5's Ra does not hold: the surface shows feed marks \
                 and run-out alone.",
            ));
        }
        ui.label(RichText::new(text).small().color(palette.weak));
    }
}
