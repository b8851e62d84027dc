//! A cut from the side and from above, to scale, with the tool where it is. What is still to be cut
//! is coloured; what remains of the part is grey.

use std::cmp::Ordering;

use egui::{Align2, FontId, Painter, Pos2, Rangef, Rect, Role, Shape, Stroke, Ui, WidgetInfo};
use egui::{RichText, pos2, vec2};

use super::hand::{Edge, EdgeKind, Hand, Moved};
use crate::app::format;
use crate::app::theme::Palette;
use crate::base::language::tr;
use crate::base::math::{PI, cos, sin};
use crate::blocks::cutting::tool_path::radial_depth_mm;
use crate::models::part::Section;
use crate::models::tool::Outline;

/// Largest scale, and the least one of depths, points per mm. Long cuts are drawn with depths larger than
/// lengths, so that a depth can be seen and dragged.
const SCALE: [f32; 2] = [6.0, 4.0];
/// What is seen above the part's surface, mm.
const ABOVE_MM: f64 = 6.5;
/// What is seen below the deepest cut, mm.
const BELOW_MM: f64 = 1.6;
/// Half of what is seen across, from above, mm.
const ACROSS_MM: f64 = 8.6;
/// Room before a cut that is met from the air, and at the ends of others, mm.
const ENDS_MM: [f64; 2] = [16.5, 9.0];
/// Least width of a section that its values are written into, points.
const WORDS: f32 = 30.0;

/// What is drawn.
#[derive(Clone, Debug)]
pub struct PicturePart {
    /// Its sections: length, axial depth, wall, mm.
    pub sections: Vec<Section>,
    /// Whether the tool starts in the material.
    pub open: bool,
    /// Whether each section has a wall of its own.
    pub walls: bool,
    /// Where the tool's axis is, mm from the part's edge; infinite before or after this cut.
    pub tool_mm: f64,
    /// The outline of the cutter.
    pub outline: Outline,
}

/// The common axis of the pictures.
#[derive(Clone, Copy, Debug)]
pub struct PictureMap {
    /// Where it lies on the screen.
    pub x: Rangef,
    from_mm: f64,
    scale: f32,
}

impl PictureMap {
    fn new(ui: &Ui, part: &PicturePart, length_mm: f64) -> Self {
        let from_mm = -ENDS_MM[usize::from(part.open)];
        let span_mm = (length_mm + ENDS_MM[1] - from_mm) as f32;
        let scale = (ui.available_width() / span_mm).min(SCALE[0]);
        let left = ui.cursor().left();
        Self { x: Rangef::new(left, left + span_mm * scale), from_mm, scale }
    }

    /// The place of a length along the cut.
    pub fn at(&self, x_mm: f64) -> f32 {
        self.x.min + (x_mm - self.from_mm) as f32 * self.scale
    }
}

/// A picture with its own vertical axis.
struct Sheet<'a> {
    painter: Painter,
    map: &'a PictureMap,
    /// Points per mm, upwards, and where zero is.
    rise: f32,
    zero: f32,
    font: FontId,
    palette: &'static Palette,
}

impl Sheet<'_> {
    fn at(&self, x_mm: f64, y_mm: f64) -> Pos2 {
        pos2(self.map.at(x_mm), self.zero - y_mm as f32 * self.rise)
    }

    fn fill(&self, x_mm: [f64; 2], y_mm: [f64; 2], color: egui::Color32) {
        if x_mm[1] > x_mm[0] {
            let rect = Rect::from_two_pos(self.at(x_mm[0], y_mm[0]), self.at(x_mm[1], y_mm[1]));
            self.painter.rect_filled(rect, 0.0, color);
        }
    }

    /// Writes into the middle of a section, above or around a height.
    fn write(&self, x_mm: [f64; 2], y_mm: f64, align: Align2, text: String) {
        if self.map.at(x_mm[1]) - self.map.at(x_mm[0]) >= WORDS {
            let at = self.at(0.5 * (x_mm[0] + x_mm[1]), y_mm);
            self.painter.text(at, align, text, self.font.clone(), self.palette.text);
        }
    }

    /// What lies to either side of the tool's axis: cut already, still to be cut.
    fn split(x_mm: [f64; 2], tool_mm: f64) -> [[f64; 2]; 2] {
        let middle = tool_mm.clamp(x_mm[0], x_mm[1]);
        [[x_mm[0], middle], [middle, x_mm[1]]]
    }
}

/// Draws both views; gives back their axis, and what was dragged in them.
pub fn show(ui: &mut Ui, part: &PicturePart, hand: &mut Hand) -> (PictureMap, Option<Moved>) {
    let palette = Palette::at(ui);
    let length_mm: f64 = part.sections.iter().map(|section| section[0]).sum();
    let depth_mm = part.sections.iter().map(|section| section[1]).fold(0.0, f64::max);
    let map = PictureMap::new(ui, part, length_mm);
    let rise = map.scale.max(SCALE[1]);
    let scale = if rise > 1.05 * map.scale {
        tr!("depths drawn {times:.1} times larger than lengths", times = rise / map.scale)
    } else {
        tr("to scale").to_owned()
    };
    let title = |ui: &mut Ui, text: String| {
        ui.label(RichText::new(text).small().color(palette.weak));
    };
    title(
        ui,
        tr!(
            "From the side, axial depths in mm, {scale}. {help}",
            scale = scale,
            help = Hand::help(ui, tr("a floor or an end"))
        ),
    );
    let said = tr!("Cut from the side: {depths}", depths = listed(part, |section| section[1]));
    let height_mm = [ABOVE_MM, depth_mm + BELOW_MM];
    let (response, sheet) = sheet(ui, &map, rise, height_mm, said);
    side(&sheet, part, depth_mm + BELOW_MM);
    let in_side = hand.over(ui, &response, &side_edges(&sheet, part));
    let walls = if part.walls { Hand::help(ui, tr("a wall")) } else { String::new() };
    title(ui, tr!("From above, radial depths in mm. {help}", help = walls));
    let radial = listed(part, |section| radial_depth_mm(&part.outline, section[1], section[2]));
    let said = tr!("Cut from above: {depths}", depths = radial);
    let (response, sheet) = self::sheet(ui, &map, rise, [ACROSS_MM; 2], said);
    above(&sheet, part);
    let edges = if part.walls { wall_edges(&sheet, part) } else { Vec::new() };
    let in_plan = hand.over(ui, &response, &edges);
    (map, in_side.or(in_plan))
}

/// Floors and ends: an end wins over a floor where both are near, since it is shorter.
fn side_edges(sheet: &Sheet<'_>, part: &PicturePart) -> Vec<Edge> {
    let mut edges = Vec::new();
    for (i, (x_mm, [_, axial_mm, _])) in stretches(part).into_iter().enumerate() {
        let end = EdgeKind::End(i);
        let ends = [sheet.at(x_mm[1], 0.0), sheet.at(x_mm[1], -axial_mm.max(1.0))];
        let per_mm = vec2(sheet.map.scale, 0.0);
        edges.push(Edge { kind: end, ends, value_mm: x_mm[1], per_mm });
        let floor = EdgeKind::Depth(i);
        let ends = x_mm.map(|x_mm| sheet.at(x_mm, -axial_mm));
        let per_mm = vec2(0.0, sheet.rise);
        edges.push(Edge { kind: floor, ends, value_mm: axial_mm, per_mm });
    }
    edges
}

fn wall_edges(sheet: &Sheet<'_>, part: &PicturePart) -> Vec<Edge> {
    let edge = |(i, (x_mm, [_, _, wall_mm])): (usize, ([f64; 2], Section))| Edge {
        kind: EdgeKind::Wall(i),
        ends: x_mm.map(|x_mm| sheet.at(x_mm, wall_mm)),
        value_mm: wall_mm,
        per_mm: vec2(0.0, -sheet.rise),
    };
    stretches(part).into_iter().enumerate().map(edge).collect()
}

fn listed(part: &PicturePart, value: impl Fn(&Section) -> f64) -> String {
    let values = part.sections.iter().map(|section| format::number(value(section), "mm"));
    format!("{} mm", values.collect::<Vec<_>>().join(", "))
}

fn sheet<'a>(
    ui: &mut Ui,
    map: &'a PictureMap,
    rise: f32,
    [above_mm, below_mm]: [f64; 2],
    said: String,
) -> (egui::Response, Sheet<'a>) {
    let height = (above_mm + below_mm) as f32 * rise;
    let (rect, response) = ui.allocate_exact_size(vec2(map.x.span(), height), Hand::sense(ui));
    response.widget_info(|| WidgetInfo::labeled(Role::Figure, true, said.clone()));
    let sheet = Sheet {
        painter: ui.painter().with_clip_rect(rect.intersect(ui.clip_rect())),
        map,
        rise,
        zero: rect.top() + above_mm as f32 * rise,
        font: egui::TextStyle::Small.resolve(ui.style()),
        palette: Palette::at(ui),
    };
    (response, sheet)
}

/// The sections with their ends, mm; a part that the tool starts in reaches to the left.
fn stretches(part: &PicturePart) -> Vec<([f64; 2], Section)> {
    let mut from_mm = 0.0;
    let mut stretches = Vec::new();
    for (i, section) in part.sections.iter().enumerate() {
        let to_mm = from_mm + section[0];
        let left_mm = if part.open && i == 0 { -ENDS_MM[0] } else { from_mm };
        stretches.push(([left_mm, to_mm], *section));
        from_mm = to_mm;
    }
    stretches
}

fn side(sheet: &Sheet<'_>, part: &PicturePart, floor_mm: f64) {
    let palette = sheet.palette;
    let mut tip_mm = 0.0;
    let stretches = stretches(part);
    for (x_mm, [_, axial_mm, _]) in &stretches {
        sheet.fill(*x_mm, [-floor_mm, -axial_mm], palette.line);
        let [_, to_come] = Sheet::split(*x_mm, part.tool_mm);
        sheet.fill(to_come, [-axial_mm, 0.0], palette.dynamics);
        let edge = [sheet.at(x_mm[0], -axial_mm), sheet.at(x_mm[1], -axial_mm)];
        sheet.painter.line_segment(edge, Stroke::new(1.5, palette.weak));
        if (x_mm[0]..=x_mm[1]).contains(&part.tool_mm) {
            tip_mm = -axial_mm;
        }
    }
    if part.tool_mm.is_finite() {
        if part.tool_mm < 0.0 {
            tip_mm = stretches.first().map_or(0.0, |(_, section)| -section[1]);
        }
        tool_from_side(sheet, &part.outline, part.tool_mm, tip_mm);
    }
    for (x_mm, [_, axial_mm, _]) in stretches {
        sheet.write(x_mm, 0.0, Align2::CENTER_BOTTOM, format::number(axial_mm, "mm"));
    }
}

/// The outline of the cutter and its shank, the tip at a height in mm.
fn tool_from_side(sheet: &Sheet<'_>, tool: &Outline, x_mm: f64, tip_mm: f64) {
    const ARC: usize = 24;
    let (radius_mm, flat_mm, corner_mm) = (tool.edge_mm(), tool.flat_mm(), tool.corner_radius_mm);
    let top_mm = 2.0 * radius_mm + ABOVE_MM;
    let mut outline = vec![sheet.at(x_mm - radius_mm, top_mm)];
    // The left corner, the flat between the two halves of the arc, the right corner.
    outline.extend((0..=ARC).map(|i| {
        let angle = PI * (1.0 + i as f64 / ARC as f64);
        let [across, up] = [cos(angle), sin(angle)].map(|fraction| corner_mm * fraction);
        let side_mm = match (2 * i).cmp(&ARC) {
            Ordering::Less => -flat_mm,
            Ordering::Equal => 0.0,
            Ordering::Greater => flat_mm,
        };
        sheet.at(x_mm + side_mm + across, tip_mm + corner_mm + up)
    }));
    outline.push(sheet.at(x_mm + radius_mm, top_mm));
    tool_shape(sheet, outline);
}

fn tool_shape(sheet: &Sheet<'_>, outline: Vec<Pos2>) {
    let palette = sheet.palette;
    let fill = palette.command.gamma_multiply(0.22);
    sheet.painter.add(Shape::convex_polygon(outline, fill, Stroke::new(1.5, palette.command)));
}

fn above(sheet: &Sheet<'_>, part: &PicturePart) {
    let palette = sheet.palette;
    for (x_mm, [_, axial_mm, wall_mm]) in stretches(part) {
        let radial_mm = radial_depth_mm(&part.outline, axial_mm, wall_mm);
        let edge_mm = wall_mm + radial_mm;
        sheet.fill(x_mm, [edge_mm, ACROSS_MM], palette.line);
        if axial_mm > 0.0 {
            let [_, to_come] = Sheet::split(x_mm, part.tool_mm);
            sheet.fill(to_come, [wall_mm, edge_mm], palette.dynamics);
            let wall = [sheet.at(x_mm[0], wall_mm), sheet.at(x_mm[1], wall_mm)];
            sheet.painter.line_segment(wall, Stroke::new(1.5, palette.weak));
            sheet.write(
                x_mm,
                0.5 * (wall_mm + edge_mm),
                Align2::CENTER_CENTER,
                format::number(radial_mm, "mm"),
            );
        }
    }
    let length_mm: f64 = part.sections.iter().map(|section| section[0]).sum();
    let ends = [sheet.at(-ENDS_MM[0], 0.0), sheet.at(length_mm + ENDS_MM[1], 0.0)];
    let axis = Stroke::new(1.0, palette.command);
    sheet.painter.extend(Shape::dashed_line(&ends, axis, 8.0, 5.0));
    if part.tool_mm.is_finite() {
        const AROUND: usize = 40;
        let radius_mm = part.outline.edge_mm();
        let circle = (0..AROUND).map(|i| {
            let angle = 2.0 * PI * i as f64 / AROUND as f64;
            sheet.at(part.tool_mm + radius_mm * cos(angle), radius_mm * sin(angle))
        });
        tool_shape(sheet, circle.collect());
    }
}
