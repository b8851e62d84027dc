//! A row that is moved across where it has no room, with signs at the ends beyond which it goes on: a press on one
//! goes on there.

use egui::scroll_area::ScrollBarVisibility;
use egui::{Rangef, Rect, ScrollArea, Sense, Shape, Stroke, Ui, pos2};

use super::super::theme::Palette;
use super::touch;

/// Share of what is seen that a press on a sign goes on by.
const PAGE: f32 = 0.8;

/// Where the row stands.
#[derive(Clone, Copy, Debug)]
pub struct StripPlace {
    /// How far it is moved, and how far it can be, points.
    pub offset: f32,
    /// See [`Self::offset`].
    pub most: f32,
    /// What is seen of it.
    pub seen: Rangef,
}

/// Shows a row; where it is to be moved to, points.
pub fn strip(
    ui: &mut Ui,
    id: &str,
    offset: Option<f32>,
    spacing: f32,
    add: impl FnOnce(&mut Ui),
) -> StripPlace {
    let pressed = ui.scope_id().with((id, "pressed"));
    let offset = offset.or_else(|| ui.data_mut(|data| data.remove_temp(pressed)));
    // Without a bar, which would come with the first entry that has no room, and move what is below.
    let hidden = ScrollBarVisibility::AlwaysHidden;
    let area = ScrollArea::horizontal().id_salt(id).scroll_bar_visibility(hidden);
    let mut area = area.auto_shrink([false, true]);
    if let Some(offset) = offset {
        area = area.horizontal_scroll_offset(offset);
    }
    let output = area.show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = spacing;
            add(ui);
        });
    });
    touch::hand_on(ui, output.id);
    let offset = output.state.clamped_offset().x;
    let most = (output.content_size.x - output.inner_rect.width()).max(0.0);
    // The area has the height that is left below it.
    let row = output.inner_rect.with_max_y(output.inner_rect.top() + output.content_size.y);
    if let Some(inwards) = more(ui, id, row, [offset > 1.0, offset < most - 1.0]) {
        let to = (offset - inwards * PAGE * row.width()).clamp(0.0, most);
        ui.data_mut(|data| data.insert_temp(pressed, to));
        ui.ctx().request_repaint();
    }
    StripPlace { offset, most, seen: output.inner_rect.x_range() }
}

/// Signs at the ends of a row that goes on beyond them, at the left and at the right; of the one that is pressed, which
/// way is inwards.
fn more(ui: &Ui, id: &str, rect: Rect, beyond: [bool; 2]) -> Option<f32> {
    const WIDTH: f32 = 16.0;
    let palette = Palette::at(ui);
    let ends = [(rect.left(), 1.0), (rect.right(), -1.0)];
    let mut pressed = None;
    for ((edge, inwards), _) in ends.into_iter().zip(beyond).filter(|(_, beyond)| *beyond) {
        let place = |x: f32, y: f32| pos2(edge + inwards * x, rect.center().y + y);
        let ground =
            Rect::from_two_pos(place(0.0, -0.5 * rect.height()), place(WIDTH, 0.5 * rect.height()));
        ui.painter().rect_filled(ground, 0.0, ui.visuals().panel_fill);
        let tip = vec![place(4.0, 0.0), place(11.0, -5.0), place(11.0, 5.0)];
        ui.painter().add(Shape::convex_polygon(tip, palette.text, Stroke::NONE));
        // By hand alone and without a name: keys go from entry to entry, and each of those comes into sight.
        let sign = ui.scope_id().with((id, "sign", inwards > 0.0));
        let sign = ui.interact(ground, sign, Sense::CLICK);
        if sign.clicked() {
            pressed = Some(inwards);
        }
    }
    pressed
}
