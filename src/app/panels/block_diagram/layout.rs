//! Where blocks, wires and their labels lie: pure geometry, so that a test can prove at every
//! size that nothing overlaps.

mod chain;
mod ring;

use egui::{Pos2, Rect, Vec2, pos2};

use crate::app::panels::equation_cards::Block;
use crate::run::diagram::{BLOCKS, Wire};

/// How a label lies on its wire.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// Centred on a level wire: name above, value below.
    Across,
    /// To the right of an upright wire: name above value.
    Right,
    /// To the left of an upright wire: name above value.
    Left,
    /// To the right of an upright wire: symbol and value in one line.
    Short,
}

/// A wire's course and label.
#[derive(Clone, Debug)]
pub struct Course {
    /// The wire.
    pub wire: Wire,
    /// Its branches, each from its source to an arrow head.
    pub branches: Vec<Vec<Pos2>>,
    /// Room for its label.
    pub label: Rect,
    /// How the label lies.
    pub style: Style,
}

/// A drawn-out diagram.
#[derive(Clone, Debug)]
pub struct DiagramLayout {
    /// Its size.
    pub size: Vec2,
    /// Scale of type and lines.
    pub scale: f32,
    /// Blocks.
    pub blocks: Vec<(Block, Rect)>,
    /// Wires.
    pub courses: Vec<Course>,
    /// Room for a word of help, where there is any.
    pub hint: Option<Rect>,
}

impl DiagramLayout {
    fn new(size: Vec2, scale: f32) -> Self {
        Self { size, scale, blocks: Vec::new(), courses: Vec::new(), hint: None }
    }

    /// Every box of the diagram, where `place` puts it.
    fn boxes(&mut self, place: impl Fn(Block) -> Rect) {
        self.blocks.extend(BLOCKS.iter().map(|info| (info.block, place(info.block))));
    }

    fn course(&mut self, wire: Wire, points: &[Pos2], label: Rect, style: Style) {
        self.courses.push(Course { wire, branches: vec![points.to_vec()], label, style });
    }

    /// A second branch of the wire added last.
    fn branch(&mut self, points: &[Pos2]) {
        if let Some(course) = self.courses.last_mut() {
            course.branches.push(points.to_vec());
        }
    }

    /// The wire nearest to a point, if it is near enough to be meant.
    #[must_use]
    pub fn wire_at(&self, at: Pos2) -> Option<Wire> {
        const NEAR: f32 = 8.0;
        let distance = |course: &Course| {
            let pairs = course.branches.iter().flat_map(|branch| branch.windows(2));
            pairs
                .map(|pair| Rect::from_two_pos(pair[0], pair[1]).distance_to_pos(at))
                .fold(f32::MAX, f32::min)
        };
        let near = self.courses.iter().map(|course| (distance(course), course.wire));
        near.filter(|(d, _)| *d <= NEAR).min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, wire)| wire)
    }
}

/// A point of a rectangle given as fractions of its width and height.
fn at(rect: Rect, x: f32, y: f32) -> Pos2 {
    pos2(rect.left() + x * rect.width(), rect.top() + y * rect.height())
}

/// The diagram for an area: a ring on a desktop, a chain from top to bottom where it is narrow.
/// It is never smaller than it can be read; a larger one than the area must be scrolled.
#[must_use]
pub fn arrange(available: Vec2, narrow: bool) -> DiagramLayout {
    if narrow { chain::arrange(available) } else { ring::arrange(available) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::diagram::WIRES;
    use egui::vec2;

    fn sizes() -> Vec<(Vec2, bool)> {
        let narrow = (300..700).step_by(20).map(|w| (vec2(w as f32, 500.0), true));
        let wide = (680..3840)
            .step_by(90)
            .flat_map(|w| [300.0, 420.0, 700.0, 1900.0].map(|h| (vec2(w as f32, h), false)));
        narrow.chain(wide).collect()
    }

    #[test]
    fn nothing_overlaps_at_any_size() {
        for (size, narrow) in sizes() {
            let layout = arrange(size, narrow);
            let blocks = layout.blocks.iter().map(|(block, rect)| (format!("{block:?}"), *rect));
            let labels = layout.courses.iter().map(|c| (format!("label {:?}", c.wire), c.label));
            let hint = layout.hint.map(|rect| ("hint".to_owned(), rect));
            let all: Vec<(String, Rect)> = blocks.chain(labels).chain(hint).collect();
            let frame = Rect::from_min_size(Pos2::ZERO, layout.size);
            for (i, (name, rect)) in all.iter().enumerate() {
                assert!(rect.is_positive() && frame.contains_rect(*rect), "{name} {rect} {size}");
                for (other, second) in &all[i + 1..] {
                    let common = rect.intersect(*second);
                    assert!(!common.shrink(0.01).is_positive(), "{name} on {other} at {size}");
                }
            }
        }
    }

    #[test]
    fn every_wire_joins_the_boxes_that_the_diagram_says() {
        for (size, narrow) in sizes() {
            let layout = arrange(size, narrow);
            let rect = |block: Block| {
                let found = layout.blocks.iter().find(|(other, _)| *other == block);
                found.expect("every box has its place").1.expand(0.1)
            };
            for course in &layout.courses {
                let Course { wire, branches, .. } = course;
                if let Some(from) = wire.from {
                    assert!(rect(from).contains(branches[0][0]), "{wire:?} at {size}");
                }
                let tips = || branches.iter().filter_map(|branch| branch.last());
                for to in wire.to {
                    assert!(tips().any(|tip| rect(*to).contains(*tip)), "{wire:?} at {size}");
                }
                let reached = wire.to.len().max(1);
                assert_eq!(branches.len(), reached, "{wire:?} at {size}");
            }
        }
    }

    #[test]
    fn no_wire_crosses_a_block_or_a_foreign_label() {
        for (size, narrow) in sizes() {
            let layout = arrange(size, narrow);
            for course in &layout.courses {
                let segments = course.branches.iter().flat_map(|branch| branch.windows(2));
                for pair in segments {
                    let line = Rect::from_two_pos(pair[0], pair[1]);
                    assert!(
                        line.width() < 0.01 || line.height() < 0.01,
                        "{:?} slants",
                        course.wire
                    );
                    for (block, rect) in &layout.blocks {
                        let inner = rect.shrink(1.0);
                        assert!(
                            !inner.intersects(line),
                            "{:?} in {block:?} at {size}",
                            course.wire
                        );
                    }
                    for other in layout.courses.iter().filter(|c| c.wire != course.wire) {
                        let hit = other.label.shrink(1.0).intersects(line);
                        assert!(!hit, "{:?} on {:?} at {size}", course.wire, other.wire);
                    }
                }
            }
        }
    }

    #[test]
    fn every_block_and_wire_is_there_once() {
        for narrow in [false, true] {
            let layout = arrange(vec2(650.0, 500.0), narrow);
            assert_eq!(layout.blocks.len(), BLOCKS.len());
            for wire in WIRES {
                assert_eq!(layout.courses.iter().filter(|c| c.wire == wire).count(), 1);
            }
        }
    }

    #[test]
    fn the_nearest_wire_is_found() {
        let layout = arrange(vec2(1000.0, 500.0), false);
        for course in &layout.courses {
            let branch = &course.branches[0];
            let middle = branch[0] + 0.5 * (branch[1] - branch[0]);
            assert_eq!(layout.wire_at(middle), Some(course.wire));
        }
        assert_eq!(layout.wire_at(pos2(-50.0, -50.0)), None);
    }
}
