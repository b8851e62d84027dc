//! The part in space, cut as the run goes: its surface true to the simulated profile, its heights
//! drawn larger by a factor that is shown, its colour the local roughness against the tolerance; and
//! a profilometer that measures the surface along a line.

mod cutter;
mod judged;
mod part;
mod picture;
mod profile_chart;
mod profilometer;
mod view;

use egui::{CentralPanel, Color32, Frame, Margin, Panel as SidePanel, Rect};
use egui::{RichText, ScrollArea, Stroke, Ui, Vec2};

use super::{Panel, View};
use crate::app::command::Command;
use crate::app::format;
use crate::app::session::Session;
use crate::app::theme::{self, Palette};
use crate::app::widgets::legend;
use crate::app::widgets::standing::Standing;
use crate::blocks::cutting::tool_path::ToolPath;
use crate::blocks::reference::Reference;
use crate::run::tooth_marks::MarkedPart;
use judged::Lengths;
use picture::{Kept, SLOWER};
use profilometer::{MeasuredLine, Profilometer};
use view::Looking;

/// Width of the column beside the picture, points.
const BESIDE_WIDTH: f32 = 360.0;
/// Height of the picture where everything stands in one column, as a fraction of the width.
const NARROW_FRACTION: f32 = 0.85;
/// How a place within the tolerance, up to twice as far off, and farther, stands.
const SIGNS: [Standing; 3] = [Standing::Good, Standing::Watch, Standing::Bad];

/// The screen.
#[derive(Default)]
pub struct WorkpiecePanel {
    looking: Looking,
    profilometer: Profilometer,
    marks: Option<Marked>,
    kept: Kept,
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
    let mut path = ToolPath::new(&session.current().workpiece, session.current().tool.outline());
    let position_mm = session.row().position_mm;
    while path.next_cut(position_mm).is_some() {}
    path
}

impl Panel for WorkpiecePanel {
    fn id(&self) -> &'static str {
        "workpiece"
    }

    fn title(&self) -> &'static str {
        "Workpiece"
    }

    fn words(&self) -> &'static str {
        "part surface 3d profile roughness profilometer picture"
    }

    fn ui(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        self.follow(view.session);
        if view.narrow {
            let margin = Frame::new().inner_margin(Margin::symmetric(8, 4));
            ScrollArea::vertical().id_salt("workpiece").auto_shrink(false).show(ui, |ui| {
                margin.show(ui, |ui| {
                    let height = NARROW_FRACTION * ui.available_width();
                    self.picture(ui, view.session, height, true);
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
            self.picture(ui, view.session, height, false);
        });
    }
}

impl WorkpiecePanel {
    /// Brings the marks up to the playhead.
    fn follow(&mut self, session: &Session) {
        let rows = session.revealed();
        let current = self.marks.as_ref();
        if current.is_none_or(|m| m.changes != session.changes() || m.marks.rows() > rows.len()) {
            let marks = MarkedPart::new(session.scenario());
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
        self.looking.controls(ui, view.narrow);
        ui.add_space(4.0);
        self.legend(ui, view.session);
        ui.separator();
        let help = "A stylus drawn along a line over the machined surface: its profile, Ra, Rq, Rz";
        let text = RichText::new("Profilometer").strong();
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
        let judged_by = match scenario.target.reference {
            Reference::Ra => "Ra against its tolerance",
            Reference::Force => "force against its tolerance",
        };
        ui.label(RichText::new(format!("Colour: {judged_by}")).strong());
        let lengths = self.marks.as_ref().map_or([0.0; 3], |marked| marked.lengths.mm);
        let spacing = ui.spacing().clone();
        ui.spacing_mut().interact_size.y = 18.0;
        ui.horizontal_wrapped(|ui| {
            for (i, name) in ["within", "up to twice as far", "farther: scrap"].iter().enumerate() {
                let text = format!("{name}, {} mm", format::number(lengths[i], "N"));
                legend::sample_of(ui, &text, theme::MACHINED[i], |painter, rect, color| {
                    painter.rect_filled(rect.shrink(1.0), 3.0, color);
                    let square = Rect::from_center_size(rect.center(), Vec2::splat(8.0));
                    SIGNS[i].paint(painter, square, Color32::BLACK, color);
                });
            }
            let [body, edges] = theme::CUTTER;
            legend::sample_of(ui, "cutting edges", edges, |painter, rect, color| {
                painter.rect_filled(rect.shrink(1.0), 3.0, body);
                painter.hline(rect.shrink(1.0).x_range(), rect.center().y, Stroke::new(4.0, color));
            });
        });
        *ui.spacing_mut() = spacing;
        let mut text = format!(
            "The cutter is drawn turning {SLOWER} times slower. What stands in front of the wall \
             was taken by an earlier cut."
        );
        if scenario.plant.force_model.tooth_by_tooth() {
            text.push_str(
                " Simulated tooth by tooth, K5's Ra does not hold: the surface shows feed marks \
                 and run-out alone.",
            );
        }
        ui.label(RichText::new(text).small().color(palette.weak));
    }
}
