//! The part in space, cut as the run goes: its surface true to the simulated profile, its heights
//! drawn larger by a factor that is shown, its colour the local roughness against the tolerance.

mod cutter;
mod part;
mod view;

use std::sync::Arc;

use egui::{Align2, CentralPanel, Color32, FontId, Frame, Margin, Panel as SidePanel, Rect};
use egui::{RichText, ScrollArea, Sense, Ui, WidgetInfo, vec2};

use super::{Panel, View};
use crate::app::command::Command;
use crate::app::scene;
use crate::app::scene::mesh::Mesh;
use crate::app::session::Session;
use crate::app::theme::{self, Palette};
use crate::app::widgets::zoom::by_touch;
use crate::base::units::ratio_from_percent;
use crate::blocks::cutting::tool_path::ToolPath;
use crate::blocks::reference::Reference;
use crate::run::signals::{Row, flag};
use crate::run::tooth_marks::ToothMarks;
use part::Part;
use view::Looking;

/// Width of the column beside the picture, points.
const BESIDE_WIDTH: f32 = 360.0;
/// Height of the picture where everything stands in one column, as a share of the width.
const NARROW_SHARE: f32 = 0.85;
/// The cutter is drawn turning so many times slower: its turns could not be seen.
const SLOWER: f64 = 25.0;
/// Colour of the bare metal.
const METAL: Color32 = Color32::from_rgb(158, 166, 176);

/// The screen.
#[derive(Default)]
pub struct WorkpiecePanel {
    looking: Looking,
    marks: Option<Marked>,
}

/// Tooth marks of the run as far as it is revealed.
struct Marked {
    changes: u64,
    marks: ToothMarks,
}

impl Panel for WorkpiecePanel {
    fn id(&self) -> &'static str {
        "workpiece"
    }

    fn title(&self) -> &'static str {
        "Workpiece"
    }

    fn ui(&mut self, ui: &mut Ui, view: &View<'_>, _commands: &mut Vec<Command>) {
        let session = view.session;
        self.follow(session);
        if view.narrow {
            let margin = Frame::new().inner_margin(Margin::symmetric(8, 4));
            ScrollArea::vertical().id_salt("workpiece").auto_shrink(false).show(ui, |ui| {
                margin.show(ui, |ui| {
                    let height = NARROW_SHARE * ui.available_width();
                    self.picture(ui, session, height);
                    self.beside(ui, session);
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
                    .show(ui, |ui| self.beside(ui, session));
            });
        CentralPanel::no_frame().show(ui, |ui| {
            let height = ui.available_height();
            self.picture(ui, session, height);
        });
    }
}

/// How far a row is off what is held, in tolerances; nothing in the air.
fn off(row: &Row, session: &Session) -> Option<f64> {
    let target = &session.current().target;
    let tolerance = ratio_from_percent(target.tolerance_percent);
    let off = match target.reference {
        Reference::Ra => row.ra_um / row.ra_target_um - 1.0,
        Reference::Force => row.force_n / row.force_ref_n - 1.0,
    };
    (!row.has(flag::AIR)).then_some(off.abs() / tolerance)
}

/// From good within the tolerance to bad at twice as much.
fn judged(off: Option<f64>, palette: &Palette) -> Color32 {
    let mix = |a: Color32, b: Color32, share: f32| a.lerp_to_gamma(b, share);
    let Some(off) = off else { return METAL };
    let color = match off {
        off if off <= 1.0 => palette.good,
        off if off < 2.0 => mix(palette.warn, palette.bad, (off - 1.0) as f32),
        _ => palette.bad,
    };
    mix(METAL, color, 0.62)
}

impl WorkpiecePanel {
    /// Brings the marks up to the playhead.
    fn follow(&mut self, session: &Session) {
        let rows = session.revealed();
        let current = self.marks.as_ref();
        if current.is_none_or(|m| m.changes != session.changes() || m.marks.rows() > rows.len()) {
            let marks = ToothMarks::new(session.scenario());
            self.marks = Some(Marked { changes: session.changes(), marks });
        }
        if let Some(marked) = &mut self.marks {
            marked.marks.extend(rows);
        }
    }

    fn picture(&mut self, ui: &mut Ui, session: &Session, height: f32) {
        let palette = Palette::at(ui);
        let Some(marked) = &self.marks else { return };
        let marks = &marked.marks;
        let cut = &marks.cuts()[marks.cut()];
        let mut path = ToolPath::new(&session.current().workpiece);
        let position_mm = session.row().position_mm;
        while path.next_cut(position_mm).is_some() {}
        let (under, x_mm) = path.cut_at(position_mm);
        let size = vec2(ui.available_width(), height);
        // Fingers scroll the page.
        let sense = if by_touch(ui) { Sense::hover() } else { Sense::drag() };
        let (rect, response) = ui.allocate_exact_size(size, sense);
        self.looking.steer(ui, &response, x_mm as f32);
        let camera = self.looking.camera;
        let rows = session.revealed();
        let color = |x: f32| {
            let at = rows.partition_point(|row| row.position_mm < cut.begins_mm + f64::from(x));
            judged(rows.get(at).and_then(|row| off(row, session)), palette)
        };
        let times = self.looking.times(session.row().ra_target_um.max(0.1));
        let part = Part {
            cut: under,
            surface: &cut.surface,
            tool_mm: x_mm as f32,
            window_mm: self.looking.window(rect),
            times,
            stock: METAL,
            color: &color,
        };
        let mut mesh = Mesh::default();
        part.draw(&mut mesh);
        if self.looking.cutter {
            let turn = (marks.turns() / SLOWER).fract() * std::f64::consts::TAU;
            let colors = [Color32::from_rgb(96, 104, 116), Color32::from_rgb(214, 186, 92)];
            cutter::draw(&mut mesh, x_mm as f32, turn as f32, colors);
        }
        let background = ui.visuals().extreme_bg_color;
        let painter = ui.painter().with_clip_rect(rect);
        painter.add(scene::picture(ui.ctx(), rect, &camera, Arc::new(mesh), background));
        self.looking.extent = part.extent();
        self.captions(&painter, rect, palette, x_mm, times);
        response.widget_info(|| {
            let said = format!(
                "Part in space, tool at {}, heights drawn {times} times larger",
                theme::quantity(x_mm, "mm")
            );
            WidgetInfo::labeled(egui::Role::Figure, true, said)
        });
    }

    fn captions(
        &self,
        painter: &egui::Painter,
        rect: Rect,
        palette: &Palette,
        x_mm: f64,
        times: f32,
    ) {
        let font = FontId::proportional(12.0);
        let write = |at, anchor, text: String, color| {
            painter.text(at, anchor, text, font.clone(), color);
        };
        let corner = rect.left_bottom() + vec2(10.0, -8.0);
        let text = format!("heights drawn {times} times larger");
        write(corner, Align2::LEFT_BOTTOM, text, palette.text);
        let text = format!("tool at {}", theme::quantity(x_mm, "mm"));
        write(rect.right_bottom() + vec2(-10.0, -8.0), Align2::RIGHT_BOTTOM, text, palette.weak);
    }

    fn beside(&mut self, ui: &mut Ui, session: &Session) {
        let palette = Palette::at(ui);
        self.looking.controls(ui);
        ui.add_space(4.0);
        let judged_by = match session.current().target.reference {
            Reference::Ra => "Ra against its tolerance",
            Reference::Force => "force against its tolerance",
        };
        ui.label(RichText::new(format!("Colour: {judged_by}")).strong());
        ui.horizontal_wrapped(|ui| {
            for (name, off) in [("within", 0.5), ("up to twice as far", 1.5), ("farther", 3.0)] {
                let color = judged(Some(off), palette);
                let (rect, _) = ui.allocate_exact_size(vec2(14.0, 14.0), Sense::hover());
                ui.painter().rect_filled(rect, 3.0, color);
                ui.label(name);
            }
        });
        let text = format!(
            "The cutter is drawn turning {SLOWER} times slower. What stands in front of the wall was \
             taken by an earlier cut."
        );
        ui.label(RichText::new(text).small().color(palette.weak));
    }
}
