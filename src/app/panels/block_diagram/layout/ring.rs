//! The desktop's layout: the loop as a ring of four columns.
//!
//! ```text
//!   target
//!  reference ─▶ controller ═▶ override ═▶ dead time
//!      ┌────────────▲            │depth     ║     │
//!  dynamometer ◀─ dynamic ◀── cutting ◀── feed    │
//!                   │           │ ▲──── spindle ◀─┘
//!   (hint)         K6          K5
//!                 Ra dyn       Ra
//! ```

use egui::{Pos2, Rect, Vec2, pos2, vec2};

use super::{DiagramLayout, Style, at};
use crate::app::panels::equation_cards::Block;
use crate::run::diagram::wires as w;

/// Least size that can be read.
const LEAST: Vec2 = Vec2::new(676.0, 420.0);
const MARGIN: f32 = 10.0;
/// Lane of the spindle command at the right edge.
const LANE: f32 = 22.0;
/// Strips of target and results at the top and bottom.
const STRIP: f32 = 36.0;
/// Gap between rows.
const ROW_GAP: f32 = 50.0;
/// Height of a label of two lines.
const LABEL: f32 = 30.0;

struct Grid {
    left: f32,
    top: f32,
    block: Vec2,
    gap: Vec2,
}

impl Grid {
    fn cell(&self, column: f32, row: f32) -> Rect {
        let min = pos2(
            self.left + column * (self.block.x + self.gap.x),
            self.top + row * (self.block.y + self.gap.y),
        );
        Rect::from_min_size(min, self.block)
    }
}

pub(super) fn arrange(available: Vec2) -> DiagramLayout {
    let size = available.max(LEAST);
    let scale = (size.x / 900.0).min(size.y / LEAST.y).clamp(1.0, 1.8);
    let s = |x: f32| x * scale;
    let inner = size.x - s(2.0 * MARGIN + LANE);
    let grid = Grid {
        left: s(MARGIN),
        top: s(STRIP),
        block: vec2(0.148 * inner, (size.y - s(2.0 * STRIP + 2.0 * ROW_GAP)) / 3.0),
        gap: vec2(0.408 / 3.0 * inner, s(ROW_GAP)),
    };
    let mut out = DiagramLayout::new(size, scale);

    let place = |block: Block| {
        let (column, row) = match block {
            Block::Reference => (0.0, 0.0),
            Block::Controller => (1.0, 0.0),
            Block::Override => (2.0, 0.0),
            Block::DeadTime => (3.0, 0.0),
            Block::FeedDrive => (3.0, 1.0),
            Block::SpindleDrive => (3.0, 2.0),
            Block::Cutting => (2.0, 1.0),
            Block::Dynamic => (1.0, 1.0),
            Block::Dynamometer => (0.0, 1.0),
            Block::Surface => (2.0, 2.0),
            Block::SurfaceDynamic => (1.0, 2.0),
        };
        grid.cell(column, row)
    };
    out.boxes(place);
    let [reference, controller, limits, dead_time] =
        [Block::Reference, Block::Controller, Block::Override, Block::DeadTime].map(place);
    let [feed, spindle, cutting] =
        [Block::FeedDrive, Block::SpindleDrive, Block::Cutting].map(place);
    let [dynamic, sensor] = [Block::Dynamic, Block::Dynamometer].map(place);
    let [surface, surface_dynamic] = [Block::Surface, Block::SurfaceDynamic].map(place);
    out.hint = Some(grid.cell(0.0, 2.0));

    // A label over a level piece of wire, and one beside an upright piece.
    let label = vec2(grid.gap.x - s(2.0), s(LABEL));
    let across = |a: Pos2, b: Pos2| Rect::from_center_size(a + 0.5 * (b - a), label);
    let beside = |x: f32, top: f32, width: f32| {
        Rect::from_min_size(pos2(x + s(5.0), top), vec2(width - s(5.0), s(LABEL)))
    };
    let mut level = |wire, from: Pos2, to: Pos2| {
        out.course(wire, &[from, to], across(from, to), Style::Across);
    };

    let (upper, middle, lower) = (0.27, 0.5, 0.73);
    level(w::DESIRED_FORCE, at(reference, 1.0, middle), at(controller, 0.0, middle));
    level(w::FEED_OVERRIDE, at(controller, 1.0, upper), at(limits, 0.0, upper));
    level(w::SPINDLE_OVERRIDE, at(controller, 1.0, lower), at(limits, 0.0, lower));
    level(w::FEED_COMMAND, at(limits, 1.0, upper), at(dead_time, 0.0, upper));
    level(w::SPINDLE_COMMAND, at(limits, 1.0, lower), at(dead_time, 0.0, lower));
    level(w::FEED, at(feed, 0.0, upper), at(cutting, 1.0, upper));
    level(w::FORCE, at(cutting, 0.0, middle), at(dynamic, 1.0, middle));
    out.branch(&[at(cutting, 0.5, 1.0), at(surface, 0.5, 0.0)]);
    let (from, to) = (at(dynamic, 0.0, middle), at(sensor, 1.0, middle));
    out.course(w::FORCE_DYNAMIC, &[from, to], across(from, to), Style::Across);
    out.branch(&[at(dynamic, 0.5, 1.0), at(surface_dynamic, 0.5, 0.0)]);

    let gap_top = reference.bottom() + 0.5 * (s(ROW_GAP) - s(LABEL));

    let down = pos2(reference.left() + s(10.0), s(6.0));
    let room = beside(down.x, s(1.0), reference.width() - s(10.0));
    out.course(w::TARGET, &[down, pos2(down.x, reference.top())], room, Style::Right);

    let bend = dead_time.bottom() + 0.5 * s(ROW_GAP);
    let (from, to) = (at(sensor, 0.5, 0.0), at(controller, 0.5, 1.0));
    let (turn, rise) = (pos2(from.x, bend), pos2(to.x, bend));
    out.course(w::MEASURED_FORCE, &[from, turn, rise, to], across(turn, rise), Style::Across);

    let down = pos2(dead_time.left() + s(8.0), dead_time.bottom());
    let room = beside(down.x, gap_top, dead_time.width() - s(8.0));
    out.course(w::FEED_DELAYED, &[down, pos2(down.x, feed.top())], room, Style::Right);

    let from = at(dead_time, 1.0, lower);
    let to = at(spindle, 1.0, middle);
    let lane = size.x - s(MARGIN);
    let room = Rect::from_min_max(
        pos2(feed.left(), feed.bottom() + 0.5 * (s(ROW_GAP) - s(LABEL))),
        pos2(lane - s(6.0), feed.bottom() + 0.5 * (s(ROW_GAP) + s(LABEL))),
    );
    let points = [from, pos2(lane, from.y), pos2(lane, to.y), to];
    out.course(w::SPINDLE_DELAYED, &points, room, Style::Left);

    let from = at(spindle, 0.0, middle);
    let to = at(cutting, 1.0, lower);
    let bend = pos2(cutting.right() + s(14.0), from.y);
    let points = [from, bend, pos2(bend.x, to.y), to];
    let room = Rect::from_center_size(
        pos2(0.5 * (bend.x + s(2.0) + from.x), from.y),
        vec2(from.x - bend.x - s(4.0), s(LABEL)),
    );
    out.course(w::SPINDLE_SPEED, &points, room, Style::Across);

    let down = pos2(at(cutting, 0.35, 0.0).x, gap_top + s(2.0));
    let room = beside(down.x, gap_top, cutting.right() + grid.gap.x - down.x - s(4.0));
    out.course(w::AXIAL_DEPTH, &[down, pos2(down.x, cutting.top())], room, Style::Right);

    for (wire, block) in [(w::RA, surface), (w::RA_DYNAMIC, surface_dynamic)] {
        let from = pos2(block.left() + s(10.0), block.bottom());
        let room = beside(from.x, block.bottom() + s(4.0), block.width() + 0.8 * grid.gap.x);
        out.course(wire, &[from, pos2(from.x, size.y - s(2.0))], room, Style::Right);
    }
    out
}
