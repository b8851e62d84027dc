//! Fewer, larger pieces for the graphics. What is painted one after the other within one clip rectangle and of one
//! texture becomes one draw call; egui paints a plot, then its axis in the rectangle around it, then the next plot, and
//! so on. In a page each call costs some 25 calls of WebGL, which were a quarter of the console's own work in a frame.

use egui::emath::TSTransform;
use egui::epaint::{ClippedShape, TextureId};
use egui::{Context, FullOutput, Plugin, Rect, Shape};

/// Reorders what a frame paints, so that it takes fewer draw calls and looks the same.
pub struct FewDrawCalls;

impl Plugin for FewDrawCalls {
    fn debug_name(&self) -> &'static str {
        "few draw calls"
    }

    fn output_hook(&mut self, _: &Context, output: &mut FullOutput) {
        output.shapes = gathered(std::mem::take(&mut output.shapes));
    }
}

/// What is painted in one draw call.
struct Batch {
    /// The clip rectangle and texture of all that may join it; none of what paints by itself.
    of: Option<(Rect, TextureId)>,
    /// Where it paints; more than that where the exact place would cost time.
    painted: Rect,
    shapes: Vec<ClippedShape>,
}

/// Where a shape paints at most.
fn place(clipped: &ClippedShape) -> Rect {
    let ClippedShape { clip_rect, shape, transform_after_tessellation } = clipped;
    if *transform_after_tessellation != TSTransform::IDENTITY {
        return *clip_rect;
    }
    let own = match shape {
        Shape::Rect(_) | Shape::Text(_) | Shape::Circle(_) | Shape::LineSegment { .. } => {
            shape.visual_bounding_rect()
        }
        // Counting their points would cost more than it saves.
        Shape::Noop
        | Shape::Vec(_)
        | Shape::Ellipse(_)
        | Shape::Path(_)
        | Shape::Band(_)
        | Shape::Mesh(_)
        | Shape::QuadraticBezier(_)
        | Shape::CubicBezier(_)
        | Shape::Callback(_) => return *clip_rect,
    };
    own.intersect(*clip_rect)
}

/// Whether two places share more than an edge.
fn overlap(a: Rect, b: Rect) -> bool {
    a.intersect(b).is_positive()
}

/// The shapes in an order in which any two that overlap are painted as before, and those of one clip rectangle and
/// texture follow each other where that can be.
fn gathered(shapes: Vec<ClippedShape>) -> Vec<ClippedShape> {
    let count = shapes.len();
    let mut batches: Vec<Batch> = Vec::new();
    for shape in shapes {
        if matches!(shape.shape, Shape::Noop) {
            continue;
        }
        let by_itself = matches!(shape.shape, Shape::Callback(_));
        let of = (!by_itself).then(|| (shape.clip_rect, shape.shape.texture_id()));
        let place = place(&shape);
        let mut found = None;
        for (i, batch) in batches.iter().enumerate().rev() {
            if of.is_some() && batch.of == of {
                found = Some(i);
                break;
            }
            if overlap(batch.painted, place) {
                break;
            }
        }
        match found {
            Some(i) => {
                batches[i].painted |= place;
                batches[i].shapes.push(shape);
            }
            None => batches.push(Batch { of, painted: place, shapes: vec![shape] }),
        }
    }
    let mut all = Vec::with_capacity(count);
    all.extend(batches.into_iter().flat_map(|batch| batch.shapes));
    all
}

#[cfg(test)]
mod tests {
    use egui::{Color32, Pos2, vec2};

    use super::*;

    fn rect(x: f32, y: f32, width: f32, height: f32) -> Rect {
        Rect::from_min_size(Pos2::new(x, y), vec2(width, height))
    }

    fn filled(clip_rect: Rect, of: Rect) -> ClippedShape {
        ClippedShape::new(clip_rect, Shape::rect_filled(of, 0.0, Color32::RED))
    }

    /// Stretches of one clip rectangle.
    fn calls(shapes: &[ClippedShape]) -> usize {
        shapes.chunk_by(|a, b| a.clip_rect == b.clip_rect).count()
    }

    #[test]
    fn plots_with_their_axes_are_one_call_each_and_one_for_all_axes() {
        let around = rect(0.0, 0.0, 1000.0, 1000.0);
        let plots = [0.0, 200.0, 400.0].map(|y| rect(50.0, y, 900.0, 150.0));
        let mut shapes = Vec::new();
        for plot in plots {
            shapes.push(filled(plot, rect(0.0, plot.top(), 1000.0, 20.0)));
            let under = rect(50.0, plot.bottom(), 900.0, 30.0);
            shapes.push(filled(around, under));
        }
        assert_eq!((calls(&shapes), calls(&gathered(shapes))), (6, 4));
    }

    #[test]
    fn what_overlaps_is_painted_as_before_whatever_else_there_is() {
        // Small numbers from a fixed sequence: many of the rectangles overlap, touch or lie apart.
        let mut state = 1_u32;
        let mut next = |most: u32| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            ((state >> 16) % most) as f32
        };
        for _ in 0..200 {
            let clips = [0, 1, 2].map(|_| rect(next(6), next(6), 1.0 + next(8), 1.0 + next(8)));
            let shapes: Vec<ClippedShape> = (0..30)
                .map(|k| {
                    let clip = clips[next(3) as usize];
                    let of = rect(next(10), next(10), 1.0 + next(4), 1.0 + next(4));
                    // The colour is the number of the shape.
                    let shape = Shape::rect_filled(of, 0.0, Color32::from_gray(k));
                    ClippedShape::new(clip, shape)
                })
                .collect();
            let places: Vec<Rect> = shapes.iter().map(place).collect();
            let number = |shape: &ClippedShape| {
                let Shape::Rect(rect) = &shape.shape else { panic!("{:?}", shape.shape) };
                usize::from(rect.fill.r())
            };
            let (before, after) = (calls(&shapes), gathered(shapes));
            let order: Vec<usize> = after.iter().map(number).collect();
            assert_eq!(order.len(), 30);
            assert!(calls(&after) <= before);
            for (i, later) in order.iter().enumerate() {
                let swapped = order[i + 1..].iter().filter(|other| *other < later);
                for other in swapped {
                    assert!(!overlap(places[*other], places[*later]), "{other} under {later}");
                }
            }
        }
    }

    #[test]
    fn what_paints_by_itself_keeps_its_place() {
        let whole = rect(0.0, 0.0, 100.0, 100.0);
        let part = rect(0.0, 0.0, 50.0, 50.0);
        let callback = egui::PaintCallback { rect: whole, callback: std::sync::Arc::new(()) };
        let by_itself = ClippedShape::new(whole, Shape::Callback(callback));
        let shapes = vec![filled(whole, part), by_itself, filled(whole, part)];
        let kinds: Vec<bool> = gathered(shapes)
            .iter()
            .map(|shape| matches!(shape.shape, Shape::Callback(_)))
            .collect();
        assert_eq!(kinds, [false, true, false]);
    }
}
