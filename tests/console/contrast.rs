//! Contrast of every text with what is behind it, measured on pictures: of the pixels of a text the most
//! frequent colour is the ground, and the one that stands out most is the text.

use std::collections::BTreeMap;

use egui::epaint::{ClippedShape, TextShape};
use egui::{Pos2, Rect, Shape, Theme, Vec2};
use egui_kittest::kittest::NodeT;

use steadycut::base::math::pow;

use crate::judged::Judge;
use crate::screen::Screen;

/// Pixels to the point. Drawing takes most of the time of this test.
pub const PIXELS: f32 = 1.5;
/// The same for a view that has texts which seem faint: thin strokes have to have pixels of their own.
const FINE: f32 = 2.0;
/// Least contrast of text, of large text, and of that of controls that are out of use (WCAG 2.2, 1.4.3,
/// which has no limit for the last).
const LEAST: [f64; 3] = [4.5, 3.0, 3.0];
/// So far around a text its ground is looked at, points.
const AROUND: f32 = 1.5;
/// From this size on, points, a text is large.
const LARGE: f32 = 24.0;

/// A piece of text of one colour, where it is drawn.
struct Piece {
    rect: Rect,
    text: String,
    size: f32,
}

fn flat<'s>(shape: &'s Shape, found: &mut dyn FnMut(&'s Shape)) {
    match shape {
        Shape::Vec(shapes) => shapes.iter().for_each(|shape| flat(shape, found)),
        other => found(other),
    }
}

/// The rows of a text, those of several colours cut up.
fn pieces(text: &TextShape, clip: Rect, out: &mut Vec<Piece>) {
    let size = text.galley.job.sections.iter().map(|s| s.format.font_id.size);
    let size = size.fold(f32::INFINITY, f32::min);
    for row in &text.galley.rows {
        let mut colors: BTreeMap<[u8; 4], Rect> = BTreeMap::new();
        let visuals = &row.visuals;
        for quad in visuals.mesh.vertices[visuals.glyph_vertex_range.clone()].chunks(4) {
            let bounds = colors.entry(quad[0].color.to_array()).or_insert(Rect::NOTHING);
            quad.iter().for_each(|vertex| bounds.extend_with(vertex.pos));
        }
        for bounds in colors.values() {
            let at = bounds.translate(row.pos.to_vec2());
            let rect = at.rotate_bb(egui::emath::Rot2::from_angle(text.angle));
            let rect = rect.translate(text.pos.to_vec2());
            // What is cut off is judged by what is seen of it, if that is more than a sliver.
            let seen = rect.intersect(clip);
            if rect.is_positive() && seen.height() > 0.6 * rect.height() && seen.width() > 3.0 {
                out.push(Piece { rect: seen, text: row.text(), size });
            }
        }
    }
}

/// What is seen of every text: not what lies below a window or a menu.
fn seen(screen: &Screen<'_>) -> Vec<Piece> {
    let whole = screen.ctx.content_rect();
    let mut pieces_so_far: Vec<Piece> = Vec::new();
    for ClippedShape { clip_rect, shape, .. } in &screen.output().shapes {
        flat(shape, &mut |shape| match shape {
            Shape::Text(text) => pieces(text, clip_rect.intersect(whole), &mut pieces_so_far),
            Shape::Rect(cover) if cover.fill.a() > 200 => {
                let cover = cover.rect.intersect(*clip_rect);
                pieces_so_far.retain(|piece| !cover.intersects(piece.rect));
            }
            _ => {}
        });
    }
    pieces_so_far
}

fn luminance(color: [u8; 3]) -> f64 {
    let linear = color.map(|c| {
        let c = f64::from(c) / 255.0;
        if c <= 0.04045 { c / 12.92 } else { pow((c + 0.055) / 1.055, 2.4) }
    });
    0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
}

fn contrast(a: [u8; 3], b: [u8; 3]) -> f64 {
    let (a, b) = (luminance(a), luminance(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

/// The contrast of the pixels in a rectangle and closely around it.
fn measured(
    rect: Rect,
    pixels: f32,
    size: [u32; 2],
    pixel: &dyn Fn(u32, u32) -> [u8; 3],
) -> Option<f64> {
    let rect = rect.expand(AROUND);
    let place = |at: Pos2| [at.x, at.y].map(|x| (x * pixels).round().max(0.0) as u32);
    let ([left, top], [right, bottom]) = (place(rect.min), place(rect.max));
    let (right, bottom) = (right.min(size[0]), bottom.min(size[1]));
    let mut count: BTreeMap<[u8; 3], u32> = BTreeMap::new();
    for y in top..bottom {
        for x in left..right {
            *count.entry(pixel(x, y)).or_default() += 1;
        }
    }
    let ground = *count.iter().max_by_key(|(_, n)| **n)?.0;
    count.keys().map(|color| contrast(*color, ground)).reduce(f64::max)
}

/// Whether a control that is out of use stands there.
fn is_disabled(screen: &Screen<'_>, at: Pos2) -> bool {
    screen.root().children_recursive().any(|node| {
        let inside = || node.accesskit_node().bounding_box().is_some() && node.rect().contains(at);
        node.accesskit_node().is_disabled() && inside()
    })
}

/// Texts that are too faint, in both themes: what a view shows takes longer to work out than to draw.
#[derive(Default)]
pub struct Contrast {
    count: usize,
    faint: Vec<String>,
    disabled: Vec<String>,
}

impl Contrast {
    /// The texts that are too faint in a picture of a view.
    fn drawn(&mut self, screen: &mut Screen<'_>, view: &str) -> Vec<String> {
        let (pieces, mut faint) = (seen(screen), Vec::new());
        let pixels = screen.ctx.pixels_per_point();
        // A busy machine may take longer for a large picture than is waited for.
        let picture = (0..5).find_map(|_| screen.render().ok()).expect("a picture");
        let all = [picture.width(), picture.height()];
        let pixel = |x, y| {
            let [r, g, b, _] = picture.get_pixel(x, y).0;
            [r, g, b]
        };
        for piece in pieces {
            let Some(found) = measured(piece.rect, pixels, all, &pixel) else { continue };
            self.count += 1;
            let off = found < LEAST[0] && is_disabled(screen, piece.rect.center());
            // A dash alone is a mark, whose pixels hardly fill a row.
            let mark = !piece.text.chars().any(char::is_alphanumeric);
            let least = match (off, piece.size >= LARGE || mark) {
                (true, _) => LEAST[2],
                (false, true) => LEAST[1],
                (false, false) => LEAST[0],
            };
            if off {
                self.disabled.push(piece.text.clone());
            }
            if found < least {
                let at = piece.rect.center();
                faint.push(format!("{found:.2} {view}: {} at {at}", piece.text));
            }
        }
        faint
    }
}

impl Judge for Contrast {
    fn view(&mut self, screen: &mut Screen<'_>, view: &str) {
        for theme in [Theme::Dark, Theme::Light] {
            screen.ctx.set_theme(theme);
            screen.run_steps(2);
            let name = format!("{theme:?}, {view}");
            if !self.drawn(screen, &name).is_empty() {
                screen.set_pixels_per_point(FINE);
                screen.run_steps(2);
                let faint = self.drawn(screen, &name);
                self.faint.extend(faint);
                screen.set_pixels_per_point(PIXELS);
                screen.run_steps(2);
            }
        }
    }

    fn verdict(&mut self) -> Vec<String> {
        self.disabled.sort();
        self.disabled.dedup();
        println!("{} texts; controls out of use: {}", self.count, self.disabled.join(", "));
        assert!(self.count > 2000, "{} texts were seen", self.count);
        std::mem::take(&mut self.faint)
    }
}

#[test]
fn contrast_is_that_of_the_standard() {
    assert!((contrast([0; 3], [255; 3]) - 21.0).abs() < 1e-9);
    // The grey that just passes on white.
    assert!((contrast([0x76; 3], [255; 3]) - 4.54).abs() < 0.01);
    let pixels = |x: u32, _| if x == 5 { [0x5a, 0x66, 0x72] } else { [255; 3] };
    let rect = Rect::from_min_size(Pos2::new(2.0, 2.0), Vec2::splat(1.0));
    assert!((measured(rect, FINE, [8, 8], &pixels).unwrap() - 5.87).abs() < 0.01);
}
