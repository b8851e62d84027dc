//! The picture of the machine: five masses on springs and dampers over the ground. All of them move
//! along one axis, drawn upwards; tooth and work stand side by side with the force between them.

use egui::{Align2, Color32, Pos2, Rect, Role, Sense, Shape, Stroke, Ui, WidgetInfo};
use egui::{pos2, vec2};

use super::motion::{MotionPicture, amplitude};
use super::state::MachineState;
use crate::app::format;
use crate::app::theme::{self, Palette};
use crate::base::language::{decimal, fixed, tr};
use crate::base::math::pow;
use crate::models::structure::parameters::NODES;

/// Width of a point on a screen, m: 96 to the inch.
const POINT_M: f64 = 0.0254 / 96.0;
/// Height of a mass, points.
const MASS: f32 = 40.0;
/// Room for the ground, and above the highest masses, points.
const ENDS: [f32; 2] = [14.0, 26.0];
/// Least width of the tooth with its words, points.
const TOOTH: f32 = 118.0;
/// Largest movement as a fraction of a spring.
const REACH: f32 = 0.38;

/// Draws the machine moving at `phase` (in turns), `height` points high.
pub fn show(ui: &mut Ui, machine: &MachineState, motion: &MotionPicture, phase: f64, height: f32) {
    let palette = Palette::at(ui);
    let size = vec2(ui.available_width(), height);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 6.0, palette.card);
    // Three springs, and room above for the topmost mass to move.
    let link = (rect.height() - ENDS[0] - ENDS[1] - 3.0 * MASS) / (3.0 + REACH);
    let largest = motion.largest();
    let wanted = f64::from(REACH * link);
    let scale = Scale::new(largest, wanted, motion.in_metres);
    let now = motion.at(phase);
    let (inner, outer) = machine.model.branch();
    // Places at rest: the base over the whole width, the work's branch left, the tool's right.
    let half = 0.5 * rect.width();
    let column = |side: f32| rect.left() + half * (0.5 + side);
    let level = |floor: f32| rect.bottom() - ENDS[0] - (floor + 1.0) * (link + MASS);
    let body = |x: f32, width: f32, floor: f32| {
        Rect::from_min_size(pos2(x - 0.5 * width, level(floor)), vec2(width, MASS))
    };
    let arm = (0.82 * half).min(210.0);
    let mut rest = [Rect::NOTHING; 5];
    rest[0] = body(rect.center().x, rect.width() - 36.0, 0.0);
    rest[inner] = body(column(0.0), arm, 1.0);
    rest[outer] = body(column(0.0), arm, 2.0);
    rest[1] = body(column(1.0), arm, 1.0);
    rest[2] = body(column(1.0), (0.62 * arm).max(TOOTH.min(arm)), 2.0);
    let moved = |i: usize| rest[i].translate(vec2(0.0, -(now[i] * scale.points) as f32));
    let ground = rect.bottom() - ENDS[0];
    ground_line(&painter, rect, ground, palette);
    let joint = |top: Rect, x: f32, below: f32, k: &str| {
        link_between(&painter, x, top.bottom(), below, k, palette);
    };
    // Beside the scale.
    joint(moved(0), egui::lerp(rect.x_range(), 0.66), ground, "1");
    for node in [1, 2, inner, outer] {
        let parent = if node == 2 {
            1
        } else if node == outer {
            inner
        } else {
            0
        };
        let name = (node + 1).to_string();
        joint(moved(node), rest[node].center().x, moved(parent).top(), &name);
    }
    for (node, place) in rest.iter().enumerate() {
        let outline = Stroke::new(1.0, palette.line);
        painter.rect_stroke(*place, 4.0, outline, egui::StrokeKind::Inside);
        let color = if node == 2 { palette.command } else { palette.produced };
        mass(&painter, machine, motion, node, moved(node), color, palette);
    }
    force(&painter, moved(2), moved(outer), palette);
    scale.show(&painter, pos2(rect.left() + 22.0, ground - 8.0), palette);
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, said(motion, &scale)));
}

/// The picture in words.
fn said(motion: &MotionPicture, scale: &Scale) -> String {
    let parts = NODES.iter().zip(motion.z).map(|(node, z)| match motion.in_metres {
        true => format!("{} {}", tr(node), format::fine(1e6 * amplitude(z), "um")),
        false => format!("{} {}", tr(node), fixed(z.re, 3)),
    });
    let parts = parts.collect::<Vec<String>>().join(", ");
    let at = format::fine(motion.f_hz, "Hz");
    tr!("Five masses at {at}: {parts}. {scale}", at = at, parts = parts, scale = scale.text)
}

/// How large movements are drawn.
struct Scale {
    /// Points per metre, or per largest amplitude of a mode.
    points: f64,
    /// A bar: its length in points and its name.
    bar: Option<(f32, String)>,
    text: String,
}

impl Scale {
    fn new(largest: f64, wanted: f64, in_metres: bool) -> Self {
        let none = largest <= 0.0 || !largest.is_finite();
        if !in_metres || none {
            let points = if none { 0.0 } else { wanted / largest };
            let text = tr("Shape of a mode: its size means nothing").to_owned();
            return Self { points, bar: None, text };
        }
        // Round, and no larger than there is room for.
        let times = round_down(wanted * POINT_M / largest);
        let points = times / POINT_M;
        let bar_um = round_down(1e6 * 40.0 / points);
        let name = format!("{} {}", decimal(bar_um.to_string()), format::unit("um"));
        let bar = ((1e-6 * bar_um * points) as f32, name);
        let text = tr!("Movement drawn ×{times}", times = grouped(times));
        Self { points, bar: Some(bar), text }
    }

    /// Draws it upwards from `foot`, the bar before the words.
    fn show(&self, painter: &egui::Painter, foot: Pos2, palette: &Palette) {
        let font = theme::note(painter.ctx());
        let write = |at: Pos2, text: &str| {
            painter.text(at, Align2::LEFT_BOTTOM, text, font.clone(), palette.weak);
        };
        let Some((length, name)) = &self.bar else { return write(foot, &self.text) };
        let ends = [foot, foot - vec2(0.0, *length)];
        let stroke = Stroke::new(2.0, palette.text);
        painter.line_segment(ends, stroke);
        for end in ends {
            painter.line_segment([end - vec2(4.0, 0.0), end + vec2(4.0, 0.0)], stroke);
        }
        write(foot + vec2(12.0, 0.0), &self.text);
        write(foot + vec2(12.0, -16.0), name);
    }
}

/// The largest of 1, 2 and 5 times a power of ten that is not above `x`.
fn round_down(x: f64) -> f64 {
    if !(x.is_finite() && x > 0.0) {
        return 1.0;
    }
    let decade = pow(10.0, format::log10(x).floor());
    [5.0, 2.0, 1.0].map(|factor| factor * decade).into_iter().find(|y| *y <= x).unwrap_or(decade)
}

/// A number with its thousands apart.
fn grouped(x: f64) -> String {
    let digits = format!("{x:.0}");
    let parts: Vec<&str> = digits
        .as_bytes()
        .rchunks(3)
        .rev()
        .filter_map(|part| std::str::from_utf8(part).ok())
        .collect();
    if x < 1.0 { decimal(x.to_string()) } else { parts.join(" ") }
}

fn ground_line(painter: &egui::Painter, rect: Rect, y: f32, palette: &Palette) {
    let stroke = Stroke::new(1.5, palette.weak);
    painter.line_segment([pos2(rect.left() + 18.0, y), pos2(rect.right() - 18.0, y)], stroke);
    let mut x = rect.left() + 22.0;
    while x < rect.right() - 18.0 {
        painter.line_segment([pos2(x, y), pos2(x - 6.0, y + 8.0)], Stroke::new(1.0, palette.weak));
        x += 12.0;
    }
}

/// A spring and a damper side by side, with their index.
fn link_between(
    painter: &egui::Painter,
    x: f32,
    top: f32,
    below: f32,
    index: &str,
    palette: &Palette,
) {
    let stroke = Stroke::new(1.5, palette.weak);
    let (spring, damper) = (x - 16.0, x + 16.0);
    let length = below - top;
    let mut points = vec![pos2(spring, top)];
    for i in 0..8 {
        let side = if i % 2 == 0 { -6.0 } else { 6.0 };
        points.push(pos2(spring + side, top + length * (0.14 + 0.72 * (i as f32 + 0.5) / 8.0)));
    }
    points.push(pos2(spring, below));
    painter.add(Shape::line(points, stroke));
    // The pot stands on the lower mass, its piston hangs from the upper one.
    let (pot, half) = (below - 0.62 * length.abs(), 7.0);
    painter.line_segment([pos2(damper, top), pos2(damper, below - 0.4 * length)], stroke);
    let piston = below - 0.4 * length;
    painter.line_segment([pos2(damper - 5.0, piston), pos2(damper + 5.0, piston)], stroke);
    let floor = below - 0.2 * length;
    let sides = [
        pos2(damper - half, pot),
        pos2(damper - half, floor),
        pos2(damper + half, floor),
        pos2(damper + half, pot),
    ];
    painter.add(Shape::line(sides.to_vec(), stroke));
    painter.line_segment([pos2(damper, floor), pos2(damper, below)], stroke);
    let font = theme::note(painter.ctx());
    let middle = 0.5 * (top + below);
    let name = |text: String, x: f32, anchor: Align2| {
        painter.text(pos2(x, middle), anchor, text, font.clone(), palette.weak);
    };
    name(format!("k{index}"), spring - 10.0, Align2::RIGHT_CENTER);
    name(format!("c{index}"), damper + 11.0, Align2::LEFT_CENTER);
}

fn mass(
    painter: &egui::Painter,
    machine: &MachineState,
    motion: &MotionPicture,
    node: usize,
    rect: Rect,
    color: Color32,
    palette: &Palette,
) {
    let fill = color.gamma_multiply(0.22);
    let painter = painter.with_clip_rect(painter.clip_rect());
    painter.rect_filled(rect, 4.0, palette.card);
    painter.rect(rect, 4.0, fill, Stroke::new(1.5, color), egui::StrokeKind::Inside);
    let weight = kilograms(machine.model.elements.mass_kg[node]);
    let z = motion.z[node];
    let move_text = match motion.in_metres {
        true => format::fine(1e6 * amplitude(z), "um"),
        false => format::signed(decimal(format!("{:+.2}", z.re + 0.0))),
    };
    let line = |text: String, y: f32, color: Color32| {
        let galley = painter.layout_no_wrap(text, theme::note(painter.ctx()), color);
        let at = pos2(rect.center().x - 0.5 * galley.size().x, rect.center().y + y);
        painter.galley(at, galley, color);
    };
    line(format!("{} {}", node + 1, tr(NODES[node])), -17.0, palette.text);
    line(format!("{weight} · {move_text}"), 1.0, palette.text);
}

fn kilograms(mass_kg: f64) -> String {
    if mass_kg < 1e-3 {
        format!("{} mg", fixed(1e6 * mass_kg, 1))
    } else {
        format!("{} kg", decimal(mass_kg.to_string()))
    }
}

/// The pair of forces between tooth and work.
fn force(painter: &egui::Painter, tooth: Rect, work: Rect, palette: &Palette) {
    let arrow = |from: Pos2, up: f32| {
        let stroke = Stroke::new(2.0, palette.text);
        let tip = from + vec2(0.0, -16.0 * up);
        painter.line_segment([from, tip], stroke);
        for side in [-4.0, 4.0] {
            painter.line_segment([tip, tip + vec2(side, 6.0 * up)], stroke);
        }
    };
    let font = theme::note(painter.ctx());
    let at = pos2(work.right() + 10.0, work.center().y + 4.0);
    arrow(at, 1.0);
    painter.text(at + vec2(0.0, 2.0), Align2::CENTER_TOP, "+P", font.clone(), palette.text);
    let at = pos2(tooth.left() - 10.0, tooth.center().y - 4.0);
    arrow(at, -1.0);
    painter.text(at - vec2(0.0, 2.0), Align2::CENTER_BOTTOM, "−P", font, palette.text);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn movements_are_drawn_with_a_round_factor_that_fits() {
        let scale = Scale::new(61.5e-6, 24.0, true);
        assert!(61.5e-6 * scale.points <= 24.0 && 61.5e-6 * scale.points > 9.0);
        assert_eq!(scale.text, "Movement drawn ×100");
        assert_eq!(Scale::new(1e-9, 24.0, true).text, "Movement drawn ×5 000 000");
        for largest in [0.0, f64::NAN, f64::INFINITY] {
            assert_eq!(Scale::new(largest, 24.0, true).points, 0.0);
        }
    }

    #[test]
    fn masses_are_written_with_a_unit_that_fits() {
        assert_eq!([0.3e-6, 17.0].map(kilograms), ["0.3 mg", "17 kg"]);
    }
}
