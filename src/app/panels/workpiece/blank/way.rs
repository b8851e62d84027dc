//! The way of the tool over a blank, as a ribbon: behind the tool where its tip was, ahead of it over the stock.

use egui::Color32;

use crate::app::scene::camera::Point;
use crate::app::scene::mesh::Mesh;
use crate::study::part::carved::{CarvedBlank, WayPoint};

/// Half the ribbon's width, and its height over what it lies on, as shares of the blank's larger side (chosen).
const HALF: f32 = 0.003;
const ABOVE: f32 = 0.004;
/// How much wider it is where something disturbs the cut.
const WIDER: f32 = 2.5;

/// Adds it; `now_mm` is how far the tool is. The colours: ahead, behind, and disturbed.
pub fn draw(
    mesh: &mut Mesh,
    carved: &CarvedBlank,
    way: &[WayPoint],
    now_mm: f64,
    disturbed: &[[f64; 2]],
    [ahead, behind, warn]: [Color32; 3],
) {
    let blank = carved.map().blank();
    let side = blank.size_mm[0].max(blank.size_mm[1]) as f32;
    let [bottom, top] = [blank.corner_mm[2], blank.top_mm()];
    let place = |point: &WayPoint| -> Point {
        let [x, y, z] = point.at_mm;
        let z = if point.s_mm <= now_mm { z.max(bottom) } else { z.max(top) };
        [x as f32, y as f32, z as f32 + ABOVE * side]
    };
    for pair in way.windows(2).filter(|pair| pair[1].joined) {
        let [from, to] = [place(&pair[0]), place(&pair[1])];
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        let length = dx.hypot(dy);
        if length <= 0.0 {
            continue;
        }
        let is_in = |[begin, end]: &[f64; 2]| pair[1].s_mm >= *begin && pair[0].s_mm <= *end;
        let (color, half) = match disturbed.iter().any(is_in) {
            true => (warn, WIDER * HALF * side),
            false if pair[1].s_mm <= now_mm => (behind, HALF * side),
            false => (ahead, HALF * side),
        };
        let [ox, oy] = [-dy / length * half, dx / length * half];
        let mut corner = |[x, y, z]: Point, sign: f32| {
            mesh.corner([x + sign * ox, y + sign * oy, z], [0.0; 3], color)
        };
        let [a, b] = [corner(from, -1.0), corner(from, 1.0)];
        let [c, d] = [corner(to, -1.0), corner(to, 1.0)];
        mesh.triangle(a, c, d);
        mesh.triangle(a, d, b);
    }
}

/// The place of the way whose axis is nearest to a point in x and y and within the tool's reach of it, mm.
pub fn nearest(way: &[WayPoint], [x, y]: [f64; 2], reach_mm: f64) -> Option<f64> {
    let off = |point: &WayPoint| {
        let [dx, dy] = [point.at_mm[0] - x, point.at_mm[1] - y];
        (dx * dx + dy * dy).sqrt()
    };
    let near = way.iter().min_by(|a, b| off(a).total_cmp(&off(b)))?;
    (off(near) <= reach_mm).then_some(near.s_mm)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_press_means_the_nearest_place_within_the_tool() {
        let point = |s_mm: f64, x: f64| WayPoint { s_mm, at_mm: [x, 5.0, -1.0], joined: true };
        let way = [point(0.0, 0.0), point(10.0, 10.0), point(20.0, 20.0)];
        assert_eq!(nearest(&way, [11.0, 8.0], 6.0), Some(10.0));
        assert_eq!(nearest(&way, [11.0, 18.0], 6.0), None);
        assert_eq!(nearest(&[], [0.0, 0.0], 6.0), None);
    }
}
