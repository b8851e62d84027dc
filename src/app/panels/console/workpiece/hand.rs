//! Edges of the picture that can be dragged: the floor of a section is its depth, its end its length, the wall
//! its place across. The mouse takes an edge at once; a finger, which may want to scroll, first chooses it by a
//! tap and then drags the handle that comes up.

use egui::{CursorIcon, Id, Pos2, Rect, Response, RichText, Sense, Stroke, Ui, Vec2, vec2};

use super::table::limits;
use crate::app::theme::{self, Palette};
use crate::app::widgets::focus::pointer_only;
use crate::app::widgets::number::NumberField;
use crate::app::widgets::zoom::by_touch;
use crate::base::language::tr;

/// What an edge stands for, with the number of its section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EdgeKind {
    /// The axial depth.
    Depth(usize),
    /// Where the section ends.
    End(usize),
    /// The place of the side wall.
    Wall(usize),
}

/// An edge as it is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Edge {
    /// What it stands for.
    pub kind: EdgeKind,
    /// Its ends on the screen.
    pub ends: [Pos2; 2],
    /// The value that it shows, mm.
    pub value_mm: f64,
    /// The way on the screen that one more millimetre is.
    pub per_mm: Vec2,
}

/// An edge that was moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moved {
    /// What it stands for.
    pub kind: EdgeKind,
    /// Its value now, mm: not yet held against any range.
    pub to_mm: f64,
}

/// How near the mouse has to be to an edge, points.
const REACH: f32 = 7.0;
/// Way of a finger for a change of a depth or wall by one millimetre, and of a length, points, where the picture is
/// smaller: a finger cannot be moved by less than a point or two.
const FINGER_PER_MM: [f32; 2] = [40.0, 6.0];
/// The same of a mouse, which can be moved by a point: each step can be met.
const MOUSE_PER_MM: [f32; 2] = [20.0, 2.0];
/// Steps of depths and walls, and of lengths, mm: the tables take any number.
const STEPS_MM: [f64; 2] = [0.05, 0.5];

impl Edge {
    fn middle(&self) -> Pos2 {
        self.ends[0] + 0.5 * (self.ends[1] - self.ends[0])
    }

    fn distance(&self, to: Pos2) -> f32 {
        let along = self.ends[1] - self.ends[0];
        let share = (to - self.ends[0]).dot(along) / along.length_sq().max(1e-6);
        (self.ends[0] + share.clamp(0.0, 1.0) * along - to).length()
    }

    fn cursor(&self) -> CursorIcon {
        match self.kind {
            EdgeKind::Depth(_) | EdgeKind::Wall(_) => CursorIcon::ResizeVertical,
            EdgeKind::End(_) => CursorIcon::ResizeHorizontal,
        }
    }

    /// The way that counts where a finger or the mouse has gone this one, with so many points at least for a
    /// millimetre of depth and of length.
    fn slowed(&self, way: Vec2, per_mm: [f32; 2]) -> Vec2 {
        let least = match self.kind {
            EdgeKind::Depth(_) | EdgeKind::Wall(_) => per_mm[0],
            EdgeKind::End(_) => per_mm[1],
        };
        way * (self.per_mm.length() / least).min(1.0)
    }

    /// Its value after a way of the pointer, on whole steps.
    fn after(&self, way: Vec2) -> f64 {
        let by_mm = f64::from(way.dot(self.per_mm) / self.per_mm.length_sq().max(1e-6));
        let step_mm = match self.kind {
            EdgeKind::Depth(_) | EdgeKind::Wall(_) => STEPS_MM[0],
            EdgeKind::End(_) => STEPS_MM[1],
        };
        // A value between two steps stays where it is until it is moved by half a step.
        let steps = (by_mm / step_mm).round();
        if steps == 0.0 {
            self.value_mm
        } else {
            ((self.value_mm + by_mm) / step_mm).round() * step_mm
        }
    }
}

/// What is held or chosen.
#[derive(Clone, Copy, Debug, Default)]
pub struct Hand {
    /// The edge as it was when the drag began, and where that was.
    held: Option<(Edge, Pos2)>,
    chosen: Option<EdgeKind>,
    /// What the chosen edge shows, mm.
    shows_mm: f64,
}

impl Hand {
    /// What the picture's response has to sense: a finger scrolls, but for the handle.
    pub fn sense(ui: &Ui) -> Sense {
        pointer_only(!by_touch(ui))
    }

    /// What to do with the mouse, or with a finger.
    pub fn help(ui: &Ui, what: &str) -> String {
        if theme::fingers(ui.ctx()) {
            tr!("Tap {what}, then drag its dot.", what = what)
        } else {
            tr!("Drag {what}.", what = what)
        }
    }

    /// Follows the pointer over a picture with these edges, marks the one in reach, and gives what moved.
    pub fn over(&mut self, ui: &Ui, response: &Response, edges: &[Edge]) -> Option<Moved> {
        if by_touch(ui) {
            self.finger(ui, response, edges)
        } else {
            self.mouse(ui, response, edges)
        }
    }

    fn mouse(&mut self, ui: &Ui, response: &Response, edges: &[Edge]) -> Option<Moved> {
        let origin = ui.input(|input| input.pointer.press_origin());
        if response.drag_started()
            && let Some(at) = origin
        {
            self.held = nearest(edges, at, REACH).map(|edge| (*edge, at));
        }
        let held = self.held.filter(|(edge, _)| edges.iter().any(|other| other.kind == edge.kind));
        let shown = match held {
            Some((edge, _)) => edges.iter().find(|other| other.kind == edge.kind),
            None => response.hover_pos().and_then(|at| nearest(edges, at, REACH)),
        };
        if let Some(edge) = shown {
            ui.set_cursor_icon(edge.cursor());
            mark(ui, edge, 3.5);
        }
        let (edge, from) = held.filter(|_| response.dragged())?;
        let way = edge.slowed(response.interact_pointer_pos()? - from, MOUSE_PER_MM);
        let moved = moved(&edge, way);
        moved.filter(|moved| shown.is_none_or(|now| now.value_mm != moved.to_mm))
    }

    fn finger(&mut self, ui: &Ui, response: &Response, edges: &[Edge]) -> Option<Moved> {
        if response.clicked()
            && let Some(at) = response.interact_pointer_pos()
        {
            self.chosen = nearest(edges, at, 0.5 * theme::FINGER).map(|edge| edge.kind);
        }
        let chosen = self.chosen?;
        let edge = edges.iter().find(|edge| edge.kind == chosen)?;
        self.shows_mm = edge.value_mm;
        mark(ui, edge, 8.0);
        let area = Rect::from_center_size(edge.middle(), vec2(theme::FINGER, theme::FINGER));
        let handle = ui.interact(area, Id::unique(("handle", response.id)), Sense::drag());
        if handle.drag_started() {
            let from = ui.input(|input| input.pointer.press_origin());
            self.held = from.map(|from| (*edge, from));
        }
        let (held, from) = self.held.filter(|_| handle.dragged())?;
        let way = held.slowed(handle.interact_pointer_pos()? - from, FINGER_PER_MM);
        moved(&held, way).filter(|moved| moved.to_mm != edge.value_mm)
    }

    /// For fingers, a field with the number of the edge that is chosen.
    pub fn field(&self, ui: &mut Ui, said: &mut Option<String>) -> Option<Moved> {
        if !theme::fingers(ui.ctx()) {
            return None;
        }
        let (longest_mm, deepest_mm) = limits();
        let mut to_mm = self.shows_mm;
        ui.horizontal(|ui| {
            let (name, range) = match self.chosen {
                None => {
                    ui.label(RichText::new(tr("Nothing chosen")).color(Palette::at(ui).weak));
                    // Its place is kept: nothing moves when one is.
                    ui.allocate_space(vec2(0.0, theme::FINGER));
                    return None;
                }
                Some(EdgeKind::Depth(i)) => {
                    (tr!("Depth {number}", number = i + 1), [0.0, deepest_mm])
                }
                Some(EdgeKind::End(i)) => {
                    (tr!("End of {number}", number = i + 1), [0.0, longest_mm])
                }
                Some(EdgeKind::Wall(i)) => {
                    (tr!("Wall {number}", number = i + 1), [-deepest_mm, deepest_mm])
                }
            };
            let label = ui.label(&name).id;
            let speed = if matches!(self.chosen, Some(EdgeKind::End(_))) { 0.25 } else { 0.01 };
            let field = NumberField {
                name: &name,
                unit: "mm",
                range,
                speed,
                decimals: 3,
                least: 0,
                suffix: " mm",
            };
            field.show(ui, &mut to_mm, said).labelled_by(label);
            self.chosen.filter(|_| to_mm != self.shows_mm).map(|kind| Moved { kind, to_mm })
        })
        .inner
    }
}

fn moved(edge: &Edge, way: Vec2) -> Option<Moved> {
    let to_mm = edge.after(way);
    to_mm.is_finite().then_some(Moved { kind: edge.kind, to_mm })
}

/// The nearest edge within reach; at the same distance the first one.
fn nearest(edges: &[Edge], at: Pos2, reach: f32) -> Option<&Edge> {
    let near = edges.iter().filter(|edge| edge.distance(at) <= reach);
    near.min_by(|a, b| a.distance(at).total_cmp(&b.distance(at)))
}

fn mark(ui: &Ui, edge: &Edge, radius: f32) {
    let palette = Palette::at(ui);
    ui.painter().line_segment(edge.ends, Stroke::new(2.5, palette.accent));
    ui.painter().circle_filled(edge.middle(), radius, palette.accent);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edge(value_mm: f64) -> Edge {
        let ends = [Pos2::new(10.0, 50.0), Pos2::new(110.0, 50.0)];
        Edge { kind: EdgeKind::Depth(0), ends, value_mm, per_mm: vec2(0.0, 20.0) }
    }

    #[test]
    fn an_edge_goes_with_the_pointer_in_whole_steps() {
        assert_eq!(edge(2.0).after(vec2(300.0, 20.0)), 3.0);
        assert_eq!(edge(2.0).after(vec2(0.0, -10.0)), 1.5);
        // A value between two steps is kept until it is moved.
        assert_eq!(edge(2.013).after(vec2(0.0, 0.1)), 2.013);
        assert!((edge(2.013).after(vec2(0.0, 2.0)) - 2.1).abs() < 1e-12);
    }

    #[test]
    fn a_finger_moves_a_depth_by_less_than_its_own_way() {
        let small = Edge { per_mm: vec2(0.0, 4.0), ..edge(2.0) };
        let moved = |way: f32| small.after(small.slowed(vec2(0.0, way), FINGER_PER_MM));
        assert!((moved(20.0) - 2.5).abs() < 1e-12, "{}", moved(20.0));
        assert!((moved(2.0) - 2.05).abs() < 1e-12, "{}", moved(2.0));
        // Where the picture is large enough, the edge goes with the finger.
        let large = Edge { per_mm: vec2(0.0, 50.0), ..edge(2.0) };
        assert_eq!(large.after(large.slowed(vec2(0.0, 50.0), FINGER_PER_MM)), 3.0);
    }

    #[test]
    fn a_mouse_meets_each_step_of_a_small_picture() {
        let small = Edge { per_mm: vec2(0.0, 4.0), ..edge(2.0) };
        for points in 0..20 {
            let way = small.slowed(vec2(0.0, points as f32), MOUSE_PER_MM);
            let expected = 2.0 + 0.05 * f64::from(points);
            assert!((small.after(way) - expected).abs() < 1e-9, "{points}");
        }
    }

    #[test]
    fn the_nearest_edge_within_reach_is_taken() {
        let edges = [edge(1.0), Edge { kind: EdgeKind::End(0), ..edge(2.0) }];
        assert_eq!(nearest(&edges, Pos2::new(60.0, 54.0), REACH).unwrap().kind, EdgeKind::Depth(0));
        assert!(nearest(&edges, Pos2::new(60.0, 58.0), REACH).is_none());
        assert!(nearest(&edges, Pos2::new(120.0, 50.0), REACH).is_none());
    }
}
