//! The picture in space: what goes into it, what it says in words, and what is kept of it while
//! nothing changes.

use std::sync::Arc;

use egui::{Align2, Color32, CursorIcon, Pos2, Rect, Ui, WidgetInfo, vec2};

use super::part::{self, Part};
use super::{Marked, WorkpiecePanel, cutter, judged, placed, under_tool};
use crate::app::command::Command;
use crate::app::format;
use crate::app::scene;
use crate::app::scene::camera::Camera;
use crate::app::scene::mesh::Mesh;
use crate::app::session::Session;
use crate::app::theme::{self, Palette};
use crate::app::widgets::zoom::by_touch;
use crate::base::language::{decimal, tr};
use crate::study::profilometer::ProfileLine;

/// Factor by which the drawn cutter turns slower: its true turns could not be seen.
pub const SLOWER: f64 = 25.0;
/// About the Ra of feed marks alone, um: at 0.2 mm per tooth it is 0.16.
const FEED_MARKS_UM: f64 = 0.15;

/// What a mesh was made of.
#[derive(Clone, Copy, PartialEq)]
struct Made {
    changes: u64,
    rows: usize,
    camera: Camera,
    rect: Rect,
    times: f32,
    cutter: bool,
    line: Option<(ProfileLine, bool)>,
    dark: bool,
}

/// The mesh drawn last.
#[derive(Default)]
pub struct Kept(Option<(Made, Arc<Mesh>)>);

impl WorkpiecePanel {
    /// Draws it over the width of `ui`, `height` points high; `pages`: fingers scroll the page.
    pub(super) fn picture(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        (height, pages): (f32, bool),
        commands: &mut Vec<Command>,
    ) {
        let palette = Palette::at(ui);
        let Some(marked) = &self.marks else { return };
        let Marked { changes, marks, .. } = marked;
        let number = marks.cut();
        let cut = &marks.cuts()[number];
        let path = under_tool(session);
        let (under, x_mm) = path.cut_at(session.row().position_mm);
        let draws = self.profilometer.open && !self.profilometer.turns;
        let scrolls = pages && by_touch(ui) && !self.looking.by_touch && !draws;
        let sense = placed::sense(self.placing.is_some(), scrolls);
        let size = vec2(ui.available_width(), height);
        let (rect, response) = ui.allocate_exact_size(size, sense);
        if !ui.is_rect_visible(rect) {
            return;
        }
        let bounds = part::bounds(under, cut.surface.outline());
        self.looking.steer(ui, &response, !draws, [x_mm as f32, 0.0, 0.0], bounds);
        let camera = self.looking.camera;
        if draws {
            self.profilometer.draw(&response, &camera, &marked.measured(&path));
        }
        let told = self.placing.map(placed::armed);
        if told.is_some() && response.hovered() {
            ui.set_cursor_icon(CursorIcon::Crosshair);
        }
        if let Some(at) = response.interact_pointer_pos().filter(|_| response.clicked()) {
            let along = placed::along(&camera, rect, at, under, x_mm);
            placed::press(ui, &mut self.placing, along, cut.begins_mm, commands);
        }
        let by_teeth = session.current().plant.force_model.tooth_by_tooth();
        let ra_um = if by_teeth { FEED_MARKS_UM } else { session.row().ra_target_um };
        let times = self.looking.times(ra_um.max(FEED_MARKS_UM));
        let made = Made {
            changes: *changes,
            rows: marks.rows(),
            camera,
            rect,
            times,
            cutter: self.looking.cutter,
            line: self.profilometer.line().filter(|_| self.profilometer.open),
            dark: ui.visuals().dark_mode,
        };
        let kept = self.kept.0.take().filter(|(before, _)| *before == made);
        let (_, mesh) = kept.unwrap_or_else(|| {
            let rows = session.revealed();
            let range_mm = cut.surface.range_mm();
            let color = |x: f32| {
                if range_mm.is_none_or(|range| f64::from(x) < range[0]) {
                    return theme::METAL;
                }
                let at = rows.partition_point(|row| row.position_mm < cut.begins_mm + f64::from(x));
                judged::color(rows.get(at).and_then(|row| judged::off(row, session)))
            };
            let part = Part {
                cut: under,
                surface: &cut.surface,
                tool_mm: x_mm as f32,
                window_mm: self.looking.window(rect),
                times,
                stock: theme::METAL,
                color: &color,
            };
            let mut mesh = Mesh::default();
            part.draw(&mut mesh);
            placed::mark(&mut mesh, session, cut.begins_mm, bounds, palette.warn);
            if made.line.is_some() {
                self.profilometer.ribbon(&mut mesh, &part, camera.distance, palette);
            }
            if self.looking.cutter {
                let turn = (marks.turns() / SLOWER).fract() * std::f64::consts::TAU;
                let tool = &session.current().tool;
                let tip = [x_mm as f32, 0.0, 0.0];
                cutter::draw(&mut mesh, tool, tip, turn as f32, theme::CUTTER);
            }
            (made, Arc::new(mesh))
        });
        let background = ui.visuals().extreme_bg_color;
        let painter = ui.painter().with_clip_rect(rect);
        painter.add(scene::picture(ui.ctx(), rect, &camera, Arc::clone(&mesh), background));
        self.kept = Kept(Some((made, mesh)));
        let at = place(x_mm, under.length_mm(), [number, marks.cuts().len()]);
        let backdrop = ui.visuals().panel_fill.gamma_multiply(0.85);
        let heights = format!("{}{}", tr("heights ×"), decimal(times.to_string()));
        captions(&painter, rect, [palette.text, backdrop], &at, &heights);
        if let Some(told) = told {
            let corner = rect.left_top() + vec2(10.0, 8.0);
            caption(&painter, Align2::LEFT_TOP, corner, &told, [palette.accent, backdrop]);
        }
        response.widget_info(|| {
            let said = tr!(
                "Part in space, {place}, heights drawn {times} times larger",
                place = at,
                times = decimal(times.to_string()),
            );
            WidgetInfo::labeled(egui::Role::Figure, true, said)
        });
    }
}

/// Where the tool is, in words.
pub(super) fn place(x_mm: f64, length_mm: f64, [number, count]: [usize; 2]) -> String {
    let tool = if x_mm < 0.0 {
        tr!("tool {length} before the part", length = format::quantity(-x_mm, "mm"))
    } else {
        let [x, length] = [x_mm.min(length_mm), length_mm].map(|x| format::number(x, "mm"));
        tr!("tool at {place} of {length} mm", place = x, length = length)
    };
    match count {
        0 | 1 => tool,
        _ => tr!("cut {number} of {all}, {tool}", number = number + 1, all = count, tool = tool),
    }
}

/// What the picture says, readable on whatever is behind it.
fn captions(
    painter: &egui::Painter,
    rect: Rect,
    [ink, backdrop]: [Color32; 2],
    at: &str,
    scale: &str,
) {
    let sides = [
        (Align2::LEFT_BOTTOM, rect.left_bottom() + vec2(10.0, -8.0), scale),
        (Align2::RIGHT_BOTTOM, rect.right_bottom() + vec2(-10.0, -8.0), at),
    ];
    for (anchor, corner, text) in sides {
        caption(painter, anchor, corner, text, [ink, backdrop]);
    }
}

pub(super) fn caption(
    painter: &egui::Painter,
    anchor: Align2,
    corner: Pos2,
    text: &str,
    [ink, backdrop]: [Color32; 2],
) {
    let font = theme::note(painter.ctx());
    let galley = painter.layout_no_wrap(text.to_owned(), font, ink);
    let place = anchor.anchor_size(corner, galley.size());
    painter.rect_filled(place.expand2(vec2(5.0, 2.0)), 3.0, backdrop);
    painter.galley(place.min, galley, ink);
}

#[cfg(test)]
mod tests {
    use super::place;

    #[test]
    fn the_place_is_told_before_within_and_at_the_end_of_a_cut() {
        assert_eq!(place(-3.888, 90.0, [0, 5]), "cut 1 of 5, tool 3.89\u{a0}mm before the part");
        assert_eq!(place(45.0, 200.0, [0, 1]), "tool at 45.00 of 200.00 mm");
        assert_eq!(place(90.02, 90.0, [4, 5]), "cut 5 of 5, tool at 90.00 of 90.00 mm");
    }
}
