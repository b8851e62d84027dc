//! Help beside an entry of a list: below it, it would lie over the next entry.

use egui::{Label, RectAlign, Response, Tooltip};

use super::super::format;

/// Shows what an entry is at its right, as long as it is pointed at.
pub fn help_beside(response: &Response, text: &str) {
    let ctx = &response.ctx;
    if ctx.has_accesskit_node(response.id) {
        ctx.accesskit_node_builder(response.id, |node| node.set_description(text));
    }
    let mut tooltip = Tooltip::for_enabled(response);
    tooltip.popup = tooltip.popup.align(RectAlign::RIGHT);
    tooltip.show(|ui| {
        ui.set_max_width(ui.spacing().tooltip_width);
        ui.add(Label::new(format::typeset(text)));
    });
}
