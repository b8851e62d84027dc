//! The phone's layout: the loop as a chain from top to bottom, the measured force coming back in
//! a lane at the right edge, the results leaving to the left.

use egui::{Rect, Vec2, pos2, vec2};

use super::{DiagramLayout, Style, at};
use crate::app::panels::equation_cards::Block;
use crate::run::diagram::wires as w;

const LEAST_WIDTH: f32 = 300.0;
const MARGIN: f32 = 8.0;
/// Lane of the measured force.
const LANE: f32 = 26.0;
/// Room for depth and results at the left edge.
const SIDE: f32 = 72.0;
/// Gap between rows with a label of one line.
const GAP: f32 = 46.0;
/// Gap under the reference, where the measured force comes in.
const FEEDBACK_GAP: f32 = 62.0;
/// Gap between the two blocks of a row.
const BETWEEN: f32 = 14.0;
/// Height of a label, and so of what a finger presses.
const LABEL: f32 = 44.0;

pub(super) fn arrange(available: Vec2) -> DiagramLayout {
    let width = available.x.max(LEAST_WIDTH);
    let scale = (width / 390.0).clamp(1.0, 1.3);
    let s = |x: f32| x * scale;
    let (left, right) = (s(MARGIN), width - s(MARGIN + LANE));
    let mut y = s(GAP);
    let mut row = |from: f32, height: f32, gap: f32| {
        let rect = Rect::from_min_max(pos2(from, y), pos2(right, y + s(height)));
        y += s(height + gap);
        rect
    };
    let inner = left + s(SIDE);
    let reference = row(left, 48.0, FEEDBACK_GAP);
    let controller = row(left, 64.0, GAP);
    let limits = row(left, 48.0, GAP);
    let dead_time = row(left, 70.0, GAP);
    let drives = row(left, 62.0, GAP);
    let cutting = row(inner, 70.0, GAP);
    let first = row(inner, 74.0, GAP);
    let second = row(inner, 74.0, MARGIN);
    let halves = |rect: Rect| {
        let half = 0.5 * (rect.width() - s(BETWEEN));
        let a = Rect::from_min_size(rect.min, vec2(half, rect.height()));
        (a, a.translate(vec2(half + s(BETWEEN), 0.0)))
    };
    let (feed, spindle) = halves(drives);
    let (surface, dynamic) = halves(first);
    let (surface_dynamic, sensor) = halves(second);

    let mut out = DiagramLayout::new(vec2(width, y), scale);
    out.boxes(|block| match block {
        Block::Reference => reference,
        Block::Controller => controller,
        Block::Override => limits,
        Block::DeadTime => dead_time,
        Block::FeedDrive => feed,
        Block::SpindleDrive => spindle,
        Block::Cutting => cutting,
        Block::Dynamic => dynamic,
        Block::Dynamometer => sensor,
        Block::Surface => surface,
        Block::SurfaceDynamic => surface_dynamic,
    });

    // Upright wires between rows, the label in one line to the right of each.
    let beside = |x: f32, top: f32, gap: f32, room: f32| {
        let height = s(LABEL);
        let min = pos2(x + s(5.0), top + 0.5 * (s(gap) - height));
        Rect::from_min_size(min, vec2(room - s(7.0), height))
    };
    let mut upright = |wire, x: f32, from: f32, to: f32, room: f32| {
        let label = beside(x, from, (to - from) / scale, room);
        out.course(wire, &[pos2(x, from), pos2(x, to)], label, Style::Short);
    };
    let x = left + s(14.0);
    let full = right - x;
    upright(w::TARGET, x, 0.0, reference.top(), full);
    upright(w::DESIRED_FORCE, x, reference.bottom(), controller.top(), 0.5 * full);
    let (a, b) = (feed.left() + s(14.0), spindle.left() + s(14.0));
    let half = feed.width();
    for (feed_wire, spindle_wire, from, to) in [
        (w::FEED_OVERRIDE, w::SPINDLE_OVERRIDE, controller, limits),
        (w::FEED_COMMAND, w::SPINDLE_COMMAND, limits, dead_time),
        (w::FEED_DELAYED, w::SPINDLE_DELAYED, dead_time, feed),
    ] {
        upright(feed_wire, a, from.bottom(), to.top(), half);
        upright(spindle_wire, b, from.bottom(), to.top(), half);
    }
    // The cutting block begins further right than the feed drive.
    let a = cutting.left() + s(10.0);
    upright(w::FEED, a, feed.bottom(), cutting.top(), b - a);
    upright(w::SPINDLE_SPEED, b, spindle.bottom(), cutting.top(), half);
    let c = dynamic.left() + s(14.0);
    upright(w::FORCE, c, cutting.bottom(), dynamic.top(), dynamic.width() - s(14.0));
    let d = at(surface, 0.5, 0.0).x;
    out.branch(&[pos2(d, cutting.bottom()), pos2(d, surface.top())]);
    let label = beside(c, dynamic.bottom(), GAP, dynamic.width() - s(14.0));
    let points = [pos2(c, dynamic.bottom()), pos2(c, sensor.top())];
    out.course(w::FORCE_DYNAMIC, &points, label, Style::Short);
    let middle = dynamic.bottom() + 0.5 * s(GAP);
    out.branch(&[pos2(c, middle), pos2(d, middle), pos2(d, surface_dynamic.top())]);

    let lane = width - s(MARGIN);
    let down = pos2(x + 0.5 * full, reference.bottom() + s(16.0));
    let from = at(sensor, 1.0, 0.5);
    let points =
        [from, pos2(lane, from.y), pos2(lane, down.y), down, pos2(down.x, controller.top())];
    let label = beside(down.x, down.y, FEEDBACK_GAP - 16.0, lane - down.x);
    out.course(w::MEASURED_FORCE, &points, label, Style::Short);

    let side = |block: Rect| {
        let center = pos2(left + 0.5 * s(SIDE - 4.0), block.center().y);
        Rect::from_center_size(center, vec2(s(SIDE - 4.0), s(LABEL)))
    };
    let edge = |block: Rect| [pos2(left, block.center().y), at(block, 0.0, 0.5)];
    out.course(w::AXIAL_DEPTH, &edge(cutting), side(cutting), Style::Across);
    for (wire, block) in [(w::RA, surface), (w::RA_DYNAMIC, surface_dynamic)] {
        let [to, from] = edge(block);
        out.course(wire, &[from, to], side(block), Style::Across);
    }
    out
}
