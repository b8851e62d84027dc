//! Explains the words and symbols where they stand: a pointer that rests on a text, a finger that stays on it,
//! or a widget that the keyboard has come to shows what its abbreviations mean ([`crate::run::glossary`]).
//!
//! Texts are found among what is drawn, so that plots, cards and tables need do nothing for it.

use egui::epaint::{ClippedShape, TextShape};
use egui::{
    Align2, Area, Context, Frame, Id, LayerId, Order, Pos2, Rect, RichText, Shape, Vec2, vec2,
};

use super::format;
use crate::base::language::tr;
use crate::run::glossary::{Term, terms_in};

/// Rest of a pointer before it is answered, s.
const REST_S: f32 = 0.7;
/// The same where a tooltip is shown: two texts at once are one too many for those who only pass by.
const REST_BESIDE_S: f32 = 1.6;
/// A finger must stay for this long, s.
const PRESS_S: f64 = 0.6;
/// Terms explained at once, at most.
const MOST: usize = 4;
/// Width of an explanation, points.
const WIDTH: f32 = 320.0;

/// A text on the screen.
struct Found {
    text: String,
    rect: Rect,
}

/// The texts of a shape and of those in it.
fn texts(shape: &Shape, see: &mut dyn FnMut(&TextShape)) {
    match shape {
        Shape::Text(text) => see(text),
        Shape::Vec(shapes) => shapes.iter().for_each(|shape| texts(shape, see)),
        Shape::Noop
        | Shape::Circle(_)
        | Shape::Ellipse(_)
        | Shape::LineSegment { .. }
        | Shape::Path(_)
        | Shape::Rect(_)
        | Shape::Band(_)
        | Shape::Mesh(_)
        | Shape::QuadraticBezier(_)
        | Shape::CubicBezier(_)
        | Shape::Callback(_) => {}
    }
}

/// The texts of a layer that touch a place.
fn at(ctx: &Context, layer: LayerId, place: Rect) -> Vec<Found> {
    let mut found = Vec::new();
    ctx.graphics(|graphics| {
        let Some(list) = graphics.get(layer) else { return };
        for ClippedShape { clip_rect, shape, .. } in list.all_entries() {
            if !clip_rect.intersects(place) {
                continue;
            }
            texts(shape, &mut |text| {
                let rect = text.visual_bounding_rect();
                if rect.intersects(place) {
                    found.push(Found { text: line_at(text, place.center()), rect });
                }
            });
        }
    });
    found
}

/// The line of a text at a height; all of it where it is not in it.
fn line_at(text: &TextShape, place: Pos2) -> String {
    let galley = &text.galley;
    let here = place - text.pos.to_vec2();
    let row = galley.rows.iter().find(|row| (row.min_y()..=row.max_y()).contains(&here.y));
    row.map_or_else(|| galley.text().to_owned(), |row| row.text())
}

/// What has the focus, and for how long, s.
fn focus(ctx: &Context) -> Option<(Id, f32)> {
    let focused = ctx.memory(|memory| memory.focused());
    let now_s = ctx.input(|input| input.time);
    let id = Id::unique("focused since");
    let before = ctx.data(|data| data.get_temp::<(Option<Id>, f64)>(id));
    let since_s = match before {
        Some((same, since_s)) if same == focused => since_s,
        Some(_) | None => now_s,
    };
    ctx.data_mut(|data| data.insert_temp(id, (focused, since_s)));
    if focused.is_some() && now_s - since_s < f64::from(REST_S) {
        ctx.request_repaint_after_secs(REST_S);
    }
    focused.map(|focused| (focused, (now_s - since_s) as f32))
}

/// What is asked about: where, in which layer.
fn asked(ctx: &Context) -> Option<(LayerId, Rect)> {
    let touch = |place: Pos2| Rect::from_center_size(place, Vec2::splat(2.0));
    let (pointer, rests, pressed_s, down, dragged) = ctx.input(|input| {
        let pointer = &input.pointer;
        let pressed_s = pointer.press_start_time().map(|since| input.time - since);
        (
            pointer.latest_pos(),
            pointer.time_since_last_movement(),
            pressed_s,
            pointer.any_down(),
            pointer.is_decidedly_dragging(),
        )
    });
    let focus = focus(ctx);
    // Whichever moved last is asked: a pointer that lies still does not hold up the keyboard.
    let keyboard = focus.filter(|(_, for_s)| *for_s < rests);
    if let Some(place) = pointer
        && !dragged
        && keyboard.is_none()
    {
        let long_press = down && ctx.input(|input| input.any_touches());
        let asks = if down {
            long_press && pressed_s.is_some_and(|pressed_s| pressed_s >= PRESS_S)
        } else {
            rests >= REST_S
        };
        if asks {
            return Some((ctx.layer_id_at(place)?, touch(place)));
        }
    }
    // What is being written needs no word about it, which would cover what comes of it.
    if ctx.text_edit_focused() {
        return None;
    }
    let (focused, _) =
        keyboard.or(focus).filter(|(_, for_s)| *for_s >= REST_S && rests >= REST_S)?;
    let response = ctx.read_response(focused)?;
    Some((response.layer_id, response.rect))
}

/// Shows the explanation of what is asked about, if it holds any of the glossary's terms; to be called when
/// everything else of a frame is drawn.
pub fn explain(ctx: &Context) {
    let Some((layer, place)) = asked(ctx).filter(|(layer, _)| layer.order != Order::Tooltip) else {
        // A pointer that has just come to rest is looked at once it has rested.
        if ctx.input(|input| input.pointer.time_since_last_movement()) < REST_S {
            ctx.request_repaint_after_secs(REST_S);
        }
        return;
    };
    let id = Id::unique("glossary");
    let rests_s = ctx.input(|input| input.pointer.time_since_last_movement());
    if rests_s < REST_BESIDE_S && !tooltips(ctx, id).is_empty() {
        return ctx.request_repaint_after_secs(REST_BESIDE_S - rests_s);
    }
    let mut terms: Vec<&'static Term> = Vec::new();
    let mut rect = Rect::NOTHING;
    for found in at(ctx, layer, place) {
        for term in terms_in(&found.text) {
            rect = rect.union(found.rect);
            if !terms.contains(&term) {
                terms.push(term);
            }
        }
    }
    if terms.is_empty() {
        return;
    }
    terms.truncate(MOST);
    show(ctx, id, rect.intersect(place.expand(40.0)), &terms);
}

/// The tooltips that are shown, besides the explanation itself.
fn tooltips(ctx: &Context, own: Id) -> Vec<Rect> {
    ctx.memory(|memory| {
        let others = memory.areas().visible_layer_ids().into_iter();
        let others = others.filter(|layer| layer.order == Order::Tooltip && layer.id != own);
        others.filter_map(|layer| memory.area_rect(layer.id)).collect()
    })
}

/// Where an explanation of what stands in `rect` goes: above it, since a finger covers what is below; where a
/// tooltip or the edge of the screen is there, below it or beside the tooltip.
fn place(ctx: &Context, id: Id, rect: Rect, screen: Rect) -> (Align2, Pos2) {
    const GAP: f32 = 6.0;
    let size =
        ctx.memory(|memory| memory.area_rect(id).map_or(vec2(WIDTH, 80.0), |before| before.size()));
    let tooltips = tooltips(ctx, id);
    let above = |rect: Rect| (Align2::LEFT_BOTTOM, rect.left_top() - vec2(0.0, GAP));
    let below = |rect: Rect| (Align2::LEFT_TOP, rect.left_bottom() + vec2(0.0, GAP));
    let beside = tooltips.iter().flat_map(|tooltip| {
        let right = (Align2::LEFT_TOP, tooltip.right_top() + vec2(GAP, 0.0));
        let left = (Align2::RIGHT_TOP, tooltip.left_top() - vec2(GAP, 0.0));
        [below(*tooltip), above(*tooltip), right, left]
    });
    let places: Vec<(Align2, Pos2)> =
        [above(rect), below(rect)].into_iter().chain(beside).collect();
    let free = places.iter().find(|(pivot, at)| {
        let taken = pivot.anchor_size(*at, size);
        // A little more room is found by moving it along the edge of the screen.
        let inside =
            screen.y_range().contains(taken.top()) && screen.y_range().contains(taken.bottom());
        inside && tooltips.iter().all(|tooltip| !tooltip.intersects(taken))
    });
    *free.unwrap_or(&places[0])
}

fn show(ctx: &Context, id: Id, rect: Rect, terms: &[&'static Term]) {
    let screen = ctx.content_rect();
    let (pivot, at) = place(ctx, id, rect, screen);
    Area::new(id)
        .order(Order::Tooltip)
        .pivot(pivot)
        .fixed_pos(at)
        .constrain_to(screen)
        .interactable(false)
        .show(ctx, |ui| {
            Frame::popup(ui.style()).show(ui, |ui| {
                ui.set_max_width(WIDTH.min(screen.width() - 24.0));
                for term in terms {
                    ui.label(RichText::new(term.written()).strong());
                    ui.label(format::typeset(tr(term.meaning)));
                }
            });
        });
}
