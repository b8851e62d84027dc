//! The diagram as widgets: draws it and finds out what was clicked.

use egui::{Id, Rect, Response, Role, Sense, Ui, WidgetInfo};

use super::brush::Brush;
use super::layout::DiagramLayout;
use super::moment::Now;
use crate::app::panels::equation_cards::{Block, Moment};
use crate::base::language::tr;
use crate::run::diagram::{Lamp, Names, Wire};
use crate::run::signals::FLAGS;

/// What was clicked.
pub enum Clicked {
    /// A wire or its label.
    Wire(Wire),
    /// A block.
    Block(Block),
}

/// Draws the diagram with its live values; `wire` and `block` are the selected ones.
pub fn diagram(
    ui: &mut Ui,
    layout: &DiagramLayout,
    now: &Now<'_>,
    wire: Wire,
    block: Block,
) -> Option<Clicked> {
    let (area, _) = ui.allocate_exact_size(layout.size, Sense::hover());
    let offset = area.min.to_vec2();
    let mut clicked = None;

    // The wires themselves are wide targets for a pointer; for the keyboard their labels serve.
    let ground = ui.interact(area, ui.scope_id().with("wires"), Sense::CLICK);
    let near = ground.hover_pos().and_then(|at| layout.wire_at(at - offset));
    if let Some(near) = near {
        ui.set_cursor_icon(egui::CursorIcon::PointingHand);
        if ground.clicked() {
            clicked = Some(Clicked::Wire(near));
        }
    }

    let brush = Brush::new(ui, layout.scale);
    for course in &layout.courses {
        let id = ui.scope_id().with((course.wire.signal, course.wire.delayed));
        let rect = course.label.translate(offset);
        let response = wire_label(ui, id, rect, course.wire, now);
        if response.clicked() {
            clicked = Some(Clicked::Wire(course.wire));
        }
        let chosen = course.wire == wire;
        let lively = response.hovered() || near == Some(course.wire);
        brush.course(course, offset, chosen, lively);
        brush.label(rect, course, &now.text(course.wire));
        if response.has_focus() {
            brush.focus(rect);
        }
    }
    for (which, rect) in &layout.blocks {
        let rect = rect.translate(offset);
        let response = block_button(ui, *which, rect, now);
        if response.clicked() {
            clicked = Some(Clicked::Block(*which));
        }
        brush.block(*which, rect, now, *which == block, response.hovered());
        if response.has_focus() {
            brush.focus(rect);
        }
    }
    if let Some(rect) = layout.hint {
        brush.hint(rect.translate(offset));
    }
    clicked
}

fn wire_label(ui: &Ui, id: Id, rect: Rect, wire: Wire, now: &Now<'_>) -> Response {
    let response = ui.interact(rect, id, Sense::click());
    response.widget_info(|| {
        WidgetInfo::labeled(Role::Button, true, tr!("Plot {signal}", signal = wire.name()))
    });
    let value = now.text(wire);
    ui.ctx().accesskit_node_builder(id, |node| node.set_value(value));
    reveal(&response);
    response.on_hover_text(format!("{}\n{}", wire.name(), tr(wire.info().doc).trim()))
}

fn block_button(ui: &Ui, block: Block, rect: Rect, now: &Now<'_>) -> Response {
    let info = block.info();
    let title = info.title(now.moment.scenario);
    let id = ui.scope_id().with(("block", block as usize));
    let response = ui.interact(rect, id, Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, title.clone()));
    let state = state_in_words(info.lamps, now);
    ui.ctx().accesskit_node_builder(id, |node| node.set_value(state.clone()));
    reveal(&response);
    response.on_hover_text(format!("{title}: {state}"))
}

/// A part that gets the keyboard's focus must be seen.
fn reveal(response: &Response) {
    if response.gained_focus() {
        response.scroll_to_me(None);
    }
}

fn state_in_words(lamps: &[Lamp], now: &Now<'_>) -> String {
    let Moment { row, scenario, .. } = now.moment;
    let lit = |bit: u32| lamps.iter().any(|lamp| lamp.bits & bit != 0) && row.has(bit);
    let lit = FLAGS.iter().filter(|flag| lit(flag.bit));
    let words: Vec<String> = lit.map(|flag| Names::of(scenario).flag(flag)).collect();
    if words.is_empty() { tr("as it should be").to_owned() } else { words.join(", ") }
}
