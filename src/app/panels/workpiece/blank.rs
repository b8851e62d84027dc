//! The blank of a program in space, as it is cut up to the playhead: its heights in their true size, what is cut in the
//! colour of what was judged there, the way of the tool over it and what the tool meets now.

mod surface;
mod way;

use std::sync::Arc;

use egui::{Align2, Color32, CursorIcon, Rect, RichText, Ui, WidgetInfo, vec2};

use super::picture::{SLOWER, caption, place};
use super::program::TakenProgram;
use super::view::Looking;
use super::{WorkpiecePanel, cutter, judged, placed};
use crate::app::command::Command;
use crate::app::format;
use crate::app::scene;
use crate::app::scene::camera::Point;
use crate::app::scene::mesh::Mesh;
use crate::app::session::Session;
use crate::app::theme::{self, Palette};
use crate::app::widgets::touch;
use crate::app::widgets::zoom::by_touch;
use crate::base::equation::number;
use crate::base::language::tr;
use crate::blocks::cutting::workpiece::Workpiece;
use crate::study::part::blank::Blank;
use crate::study::part::carved::{CarvedBlank, WayPoint};
use crate::study::part::milling::MilledRow;

/// Cells that are looked at in a frame at most: the rest comes in the next ones.
const PER_FRAME: usize = 2_000_000;
/// Points of the way that are drawn.
const WAY_POINTS: usize = 1500;

/// The blank of the program that became the part.
pub struct ShownBlank {
    name: String,
    /// Whether it is to be shown rather than the strip along the way.
    pub asked: bool,
    /// How it is looked at.
    pub looking: Looking,
    /// The part that the program became.
    part: Option<Workpiece>,
    rows: Vec<MilledRow>,
    carved: Result<CarvedBlank, String>,
    way: Vec<WayPoint>,
    kept: Option<(Made, Arc<Mesh>)>,
}

/// What a mesh was made of.
#[derive(Clone, Copy, PartialEq)]
struct Made {
    changes: u64,
    rows: usize,
    stand: [usize; 2],
    cutter: bool,
    dark: bool,
}

impl ShownBlank {
    /// Of a program that is made the part of this session.
    pub fn of(taken: TakenProgram, session: &Session) -> Self {
        let TakenProgram { name, path, rows, carved } = taken;
        let mut scenario = session.current().clone();
        let changed = path.to_scenario(&scenario).ok().map(|taken| {
            let of_part =
                taken.changes.into_iter().filter(|(path, _)| path.starts_with("workpiece."));
            scenario.set_all(&of_part.collect::<Vec<_>>())
        });
        let part = changed.is_some_and(|done| done.is_ok()).then(|| scenario.workpiece.clone());
        let way = carved.as_ref().map_or(Vec::new(), |carved| carved.way(WAY_POINTS));
        let looking = Looking::at_blank();
        Self { name, asked: true, looking, part, rows, carved, way, kept: None }
    }

    /// Whether the part that is cut at the playhead is that of the program, cut by the same cutter.
    ///
    /// # Errors
    /// Says why the blank is not shown.
    pub fn is_of(&self, session: &Session) -> Result<&CarvedBlank, String> {
        let now = session.current();
        if self.part.as_ref() != Some(&now.workpiece) {
            return Err(tr!(
                "The part is another one than that of {name} now: its blank is not shown.",
                name = &self.name
            ));
        }
        let carved = self.carved.as_ref().map_err(|why| {
            tr!("The blank of {name} is not shown: {why}.", name = &self.name, why = why)
        })?;
        if *carved.outline() != now.tool.outline() {
            return Err(tr!(
                "{name} was cut with another cutter: cut it from the blank again to see that.",
                name = &self.name
            ));
        }
        Ok(carved)
    }

    /// What the tool meets at a place of the way.
    fn met(&self, s_mm: f64) -> Option<&MilledRow> {
        let index = self.rows.partition_point(|row| row.s_mm <= s_mm);
        self.rows.get(index.checked_sub(1)?)
    }

    /// The same in words; nothing before the way.
    fn engaged(&self, s_mm: f64) -> String {
        match self.met(s_mm) {
            None => String::new(),
            Some(row) if row.axial_mm <= 0.0 || row.radial_mm <= 0.0 => {
                tr!("in the air, line {line}", line = row.line)
            }
            Some(row) => tr!(
                "{axial} deep, {radial} wide, line {line}",
                axial = format::quantity(row.axial_mm, "mm"),
                radial = format::quantity(row.radial_mm, "mm"),
                line = row.line
            ),
        }
    }
}

/// The smallest and the largest corner of what is to be seen: blank and way, mm.
fn bounds(blank: &Blank, way: &[WayPoint]) -> [Point; 2] {
    let high = [0, 1, 2].map(|i: usize| blank.corner_mm[i] + blank.size_mm[i]);
    let [mut least, mut most] = [blank.corner_mm, high];
    for point in way {
        for (i, x) in point.at_mm.iter().take(2).enumerate() {
            least[i] = least[i].min(*x);
            most[i] = most[i].max(*x);
        }
    }
    [least, most].map(|corner| corner.map(|x| x as f32))
}

impl WorkpiecePanel {
    /// Chooses between blank and strip, where there is a blank; says why there is none.
    pub(super) fn choose_picture(&mut self, ui: &mut Ui, session: &Session) {
        let weak = Palette::at(ui).weak;
        let small = |text: &str| RichText::new(text).small().color(weak);
        let Some(blank) = &mut self.blank else {
            if !session.current().workpiece.radial_steps.is_empty() {
                ui.label(small(tr(
                    "This part is a table of depths along its way, which has no shape in space: shown is the strip along the \
                     way. A part that is made of a program here is shown as its blank, too.",
                )));
            }
            return;
        };
        if let Err(why) = blank.is_of(session) {
            ui.label(small(&why));
            return;
        }
        ui.horizontal_wrapped(|ui| {
            let is_blank = blank.asked && !self.profilometer.open;
            let help = tr("The blank in space, as it is cut up to the playhead");
            if touch::choice(ui, is_blank, tr("Blank")).on_hover_text(help).clicked() {
                blank.asked = true;
                // Its line lies on the strip.
                if std::mem::replace(&mut self.profilometer.open, false) {
                    self.looking.cutter = true;
                }
            }
            let help = tr("The way made straight, with the fine surface of the finished wall");
            if touch::choice(ui, !is_blank, tr("Strip along the way")).on_hover_text(help).clicked()
            {
                blank.asked = false;
            }
        });
    }

    /// Draws the blank over the width of `ui`, `height` points high; `pages`: fingers scroll the page.
    pub(super) fn blank_picture(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        (height, pages): (f32, bool),
        commands: &mut Vec<Command>,
    ) {
        let palette = Palette::at(ui);
        let (Some(marked), Some(shown)) = (&self.marks, &mut self.blank) else { return };
        let scrolls = pages && by_touch(ui) && !shown.looking.by_touch;
        let sense = placed::sense(self.placing.is_some(), scrolls);
        let size = vec2(ui.available_width(), height);
        let (rect, response) = ui.allocate_exact_size(size, sense);
        if !ui.is_rect_visible(rect) {
            return;
        }
        let s_mm = session.row().position_mm;
        let engaged = shown.engaged(s_mm);
        let Ok(carved) = &mut shown.carved else { return };
        if !carved.go_to(s_mm, PER_FRAME) {
            ui.ctx().request_repaint();
        }
        let blank = *carved.map().blank();
        let length_mm = carved.length_mm();
        let tip = carved.tip_mm(s_mm).map(|x| x as f32);
        shown.looking.steer(ui, &response, true, tip, bounds(&blank, &shown.way));
        let camera = shown.looking.camera;
        let told = self.placing.map(placed::armed);
        if told.is_some() && response.hovered() {
            ui.set_cursor_icon(CursorIcon::Crosshair);
        }
        if let Some(at) = response.interact_pointer_pos().filter(|_| response.clicked()) {
            let top = camera.on_level(rect, at, blank.top_mm() as f32);
            let reach_mm = carved.outline().edge_mm();
            let along = top.and_then(|at| way::nearest(&shown.way, at.map(f64::from), reach_mm));
            placed::press(ui, &mut self.placing, along, 0.0, commands);
        }
        let made = Made {
            changes: session.changes(),
            rows: session.revealed().len(),
            stand: carved.stand(),
            cutter: shown.looking.cutter,
            dark: ui.visuals().dark_mode,
        };
        let kept = shown.kept.take().filter(|(before, _)| *before == made);
        let (_, mesh) = kept.unwrap_or_else(|| {
            let rows = session.revealed();
            let color = |s_mm: f64| {
                let at = rows.partition_point(|row| row.position_mm < s_mm);
                judged::color(rows.get(at).and_then(|row| judged::off(row, session)))
            };
            let mut mesh = Mesh::default();
            surface::draw(&mut mesh, carved, theme::METAL, &color);
            let zones = session.current().disturbances.all();
            let disturbed: Vec<[f64; 2]> = zones
                .map(|(kind, zone)| {
                    let length_mm = if kind.lasts() { zone.length_mm } else { 0.0 };
                    [zone.at_mm, zone.at_mm + length_mm]
                })
                .collect();
            let colors = [palette.command, palette.weak, palette.warn];
            way::draw(&mut mesh, carved, &shown.way, s_mm, &disturbed, colors);
            if shown.looking.cutter {
                let turn = (marked.marks.turns() / SLOWER).fract() * std::f64::consts::TAU;
                cutter::draw(&mut mesh, &session.current().tool, tip, turn as f32, theme::CUTTER);
            }
            (made, Arc::new(mesh))
        });
        let background = ui.visuals().extreme_bg_color;
        let painter = ui.painter().with_clip_rect(rect);
        painter.add(scene::picture(ui.ctx(), rect, &camera, Arc::clone(&mesh), background));
        shown.kept = Some((made, mesh));
        let at = place(s_mm, length_mm, [0, 1]);
        let backdrop = ui.visuals().panel_fill.gamma_multiply(0.85);
        let inks = [palette.text, backdrop];
        axes(&painter, rect, &camera, &blank, palette.text);
        // On a phone both have no room in one line at the foot.
        let (anchor, left) = match pages {
            true => {
                (Align2::LEFT_TOP, rect.left_top() + vec2(10.0, theme::note(ui.ctx()).size + 20.0))
            }
            false => (Align2::LEFT_BOTTOM, rect.left_bottom() + vec2(10.0, -8.0)),
        };
        caption(&painter, anchor, left, &sized(&blank), inks);
        let right = rect.right_bottom() + vec2(-10.0, -8.0);
        caption(&painter, Align2::RIGHT_BOTTOM, right, &at, inks);
        let corner = rect.left_top() + vec2(10.0, 8.0);
        match told {
            Some(told) => {
                caption(&painter, Align2::LEFT_TOP, corner, &told, [palette.accent, backdrop]);
            }
            None if engaged.is_empty() => {}
            None => caption(&painter, Align2::LEFT_TOP, corner, &engaged, inks),
        }
        response.widget_info(|| {
            let mut said = tr!("Blank in space, {place}", place = at);
            if !engaged.is_empty() {
                said = format!("{said}, {engaged}");
            }
            WidgetInfo::labeled(egui::Role::Figure, true, said)
        });
    }
}

/// The size of a blank in words.
fn sized(blank: &Blank) -> String {
    let [x, y, z] = blank.size_mm.map(number);
    tr!("blank {x} × {y} × {z} mm", x = x, y = y, z = z)
}

/// The names of the axes at the middles of the blank's lower edges in front.
fn axes(
    painter: &egui::Painter,
    rect: Rect,
    camera: &scene::camera::Camera,
    blank: &Blank,
    ink: Color32,
) {
    let [low, size] = [blank.corner_mm, blank.size_mm].map(|corner| corner.map(|x| x as f32));
    let middle = |i: usize| low[i] + 0.5 * size[i];
    let eye = camera.eye();
    let [x, y] = [0, 1].map(|i: usize| if eye[i] < middle(i) { low[i] } else { low[i] + size[i] });
    for (name, point) in [("X", [middle(0), y, low[2]]), ("Y", [x, middle(1), low[2]])] {
        let out = [0, 1].map(|i: usize| if point[i] < middle(i) { -1.0 } else { 1.0 });
        let off = 0.04 * size[0].max(size[1]);
        let point = match name {
            "X" => [point[0], point[1] + out[1] * off, point[2]],
            _ => [point[0] + out[0] * off, point[1], point[2]],
        };
        if let Some(at) = camera.on_screen(rect, point) {
            painter.text(at, Align2::CENTER_CENTER, name, theme::note(painter.ctx()), ink);
        }
    }
}
