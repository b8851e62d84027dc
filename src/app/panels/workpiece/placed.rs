//! Disturbances on the part in space: where a click on it means, and a bar along each.

use egui::{Color32, Key, Label, Modifiers, Pos2, Rect, RichText, Sense, Ui};

use crate::app::command::{Command, DisturbCommand, SessionCommand};
use crate::app::scene::camera::{Camera, Point};
use crate::app::scene::mesh::Mesh;
use crate::app::session::Session;
use crate::app::theme::Palette;
use crate::app::widgets::drop;
use crate::app::widgets::spoken::read_aloud;
use crate::base::language::{text, tr};
use crate::models::disturbances::Disturbance;
use crate::models::part::CutPath;

/// Width of the bars, mm, and how far they lie above the stock.
const BAR_MM: f32 = 1.6;
const ABOVE_MM: f32 = 0.08;
/// Shortest bar, mm: what has no length must be seen as well.
const SHORTEST_MM: f32 = 0.6;
/// How much lower the stock in front of the wall lies than the lowest point of the cutter, mm.
const FRONT_MM: f32 = 0.6;

/// What is said of a press that meets no part of the cut.
const BESIDE: &str = text!("That is beside the part.");

/// What a press on the part does now.
pub fn armed(kind: Disturbance) -> String {
    tr!("{kind}: press on the part to place it; Escape leaves", kind = tr(kind.label()))
}

/// Choosing a kind that a press on the part places.
pub fn choose(ui: &mut Ui, placing: &mut Option<Disturbance>) {
    let help = tr(
        "Choose one, then press on the part where it is to begin; behind the tool the cut is done again. With \
         Shift held the next press places another one.",
    );
    ui.label(RichText::new(tr("Disturb the part")).strong()).on_hover_text(help);
    // The same line, so that nothing moves.
    let palette = Palette::at(ui);
    let (text, color) = match placing {
        Some(kind) => (armed(*kind), palette.accent),
        None => (tr("Choose one, then press on the part").to_owned(), palette.weak),
    };
    let line = Label::new(RichText::new(text).small().color(color));
    read_aloud(&ui.add(line.truncate()));
    for pair in Disturbance::ALL.chunks(2) {
        let width = drop::width(ui, 2);
        ui.horizontal(|ui| {
            for kind in pair {
                let chosen = *placing == Some(*kind);
                let more = tr("Then press on the part.");
                if drop::button(ui, *kind, width, chosen, more).clicked() {
                    *placing = (!chosen).then_some(*kind);
                }
            }
        });
    }
}

/// Escape leaves it, where nothing else takes the key.
pub fn escape(ui: &Ui, placing: &mut Option<Disturbance>) {
    let free = placing.is_some() && !ui.egui_wants_keyboard_input();
    if free && ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape)) {
        *placing = None;
    }
}

/// What the picture takes: presses where a disturbance is armed, drags unless fingers scroll the page with them.
pub fn sense(is_armed: bool, scrolls: bool) -> Sense {
    match (is_armed, scrolls) {
        (true, true) => Sense::click(),
        (true, false) => Sense::click_and_drag(),
        (false, true) => Sense::hover(),
        (false, false) => Sense::drag(),
    }
}

/// A press at a place of the cut that begins at `begins_mm` of the way, or beside it: it places what is chosen, once,
/// and on and on with Shift held.
pub fn press(
    ui: &Ui,
    placing: &mut Option<Disturbance>,
    along: Option<f64>,
    begins_mm: f64,
    commands: &mut Vec<Command>,
) {
    let Some(kind) = *placing else { return };
    match along {
        Some(x_mm) => {
            commands.push(drop_at(kind, begins_mm + x_mm));
            if !ui.input(|input| input.modifiers.shift) {
                *placing = None;
            }
        }
        None => commands.push(Command::notify(format!("{} {}.", tr(BESIDE), armed(kind)))),
    }
}

/// The command that drops a kind at a place along the way in mm.
fn drop_at(kind: Disturbance, at_mm: f64) -> Command {
    let drop = DisturbCommand::Drop { kind, at_mm: Some(at_mm) };
    Command::Session(SessionCommand::Disturb(drop))
}

/// Where along the cut a place of the picture lies, in mm from the part's edge: on top of the stock ahead of the tool,
/// on the machined surface behind it; none beside the part.
pub fn along(camera: &Camera, rect: Rect, at: Pos2, cut: &CutPath, tool_mm: f64) -> Option<f64> {
    let top = cut.depth_max_mm() as f32;
    let level = |z: f32| camera.on_level(rect, at, z).map(|[x, _]| f64::from(x));
    let ahead = level(top)?;
    let x_mm = if ahead > tool_mm { ahead } else { level(0.3 * top)? };
    (0.0..cut.length_mm()).contains(&x_mm).then_some(x_mm)
}

/// A bar along every disturbance of the cut that begins at `begins_mm` of the way.
pub fn mark(
    mesh: &mut Mesh,
    session: &Session,
    begins_mm: f64,
    bounds: [Point; 2],
    color: Color32,
) {
    let [[from, front, _], [to, back, top]] = bounds;
    for (kind, zone) in session.current().disturbances.all() {
        let x0 = (zone.at_mm - begins_mm) as f32;
        let length = if kind.lasts() { zone.length_mm as f32 } else { 0.0 };
        let x1 = (x0 + length.max(SHORTEST_MM)).min(to);
        let x0 = x0.max(from);
        if x0 >= x1 {
            continue;
        }
        for (y, z) in [(front, -FRONT_MM), (back - BAR_MM, top)] {
            let corners = [[x0, y], [x1, y], [x1, y + BAR_MM], [x0, y + BAR_MM]];
            let corner = |[x, y]: [f32; 2]| mesh.corner([x, y, z + ABOVE_MM], [0.0; 3], color);
            let [a, b, c, d] = corners.map(corner);
            mesh.triangle(a, b, c);
            mesh.triangle(a, c, d);
        }
    }
}
