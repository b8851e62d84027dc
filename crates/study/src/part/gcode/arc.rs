//! Arcs in the plane of X and Y (G17), with a centre (I, J) or a radius (R).

use crate::base::language::tr;
use crate::base::math::{self, PI, TAU};

/// Most that the radii at both ends of an arc may differ by: mm, and in parts of the radius. Programs are rounded.
const RADII_MM: f64 = 0.01;
const RADII_SHARE: f64 = 1e-3;

/// An arc about a centre; a helix where its ends differ in Z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GCodeArc {
    /// Centre, mm.
    pub centre_mm: [f64; 2],
    /// Angle that is swept, counter-clockwise, rad; below 0 clockwise.
    pub sweep_rad: f64,
}

/// How an arc is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Given {
    /// The centre seen from the start, mm.
    Centre([f64; 2]),
    /// The radius, mm; below 0 for more than half a turn.
    Radius(f64),
}

/// Angle from `a` to `b` counter-clockwise, 0 to a full turn, rad.
fn turn_rad(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (dot, cross) = (a[0] * b[0] + a[1] * b[1], a[0] * b[1] - a[1] * b[0]);
    let half = if dot > 0.0 {
        math::atan(cross / dot)
    } else if dot < 0.0 {
        let beyond = math::atan(cross / dot);
        if cross >= 0.0 { PI + beyond } else { beyond - PI }
    } else if cross >= 0.0 {
        0.5 * PI
    } else {
        -0.5 * PI
    };
    if half < 0.0 { half + TAU } else { half }
}

fn length([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

impl GCodeArc {
    /// The arc between two points in mm.
    ///
    /// # Errors
    /// The end is not on the circle, or no circle of the radius goes through both.
    pub(super) fn new(
        from: [f64; 2],
        to: [f64; 2],
        clockwise: bool,
        given: Given,
    ) -> Result<Self, String> {
        let centre_mm = match given {
            Given::Centre(offset) => [from[0] + offset[0], from[1] + offset[1]],
            Given::Radius(radius) => centre(from, to, clockwise, radius)?,
        };
        let [start, end] = [from, to].map(|at| [at[0] - centre_mm[0], at[1] - centre_mm[1]]);
        let [first, last] = [length(start), length(end)];
        if first <= 0.0 || (first - last).abs() > RADII_MM.max(RADII_SHARE * first) {
            return Err(tr!(
                "the arc's radius is {first} mm at its start and {last} mm at its end: allowed is the same, above 0",
                first = first,
                last = last
            ));
        }
        // The same point again is a full turn.
        let same = from == to;
        let turn = if same { TAU } else { turn_rad(start, end) };
        let sweep_rad = match (clockwise, same) {
            (false, _) => turn,
            (true, true) => -TAU,
            (true, false) => turn - TAU,
        };
        Ok(Self { centre_mm, sweep_rad })
    }

    /// The point a share of the way, 0 to 1, behind the start of the arc, mm.
    #[must_use]
    pub fn at(&self, from: [f64; 2], share: f64) -> [f64; 2] {
        let [x, y] = [from[0] - self.centre_mm[0], from[1] - self.centre_mm[1]];
        let angle = share * self.sweep_rad;
        let (sine, cosine) = (math::sin(angle), math::cos(angle));
        [self.centre_mm[0] + x * cosine - y * sine, self.centre_mm[1] + x * sine + y * cosine]
    }
}

/// The centre of an arc of a radius: of both circles through the points the one with the shorter arc, or the other one
/// for a radius below 0.
fn centre(from: [f64; 2], to: [f64; 2], clockwise: bool, radius: f64) -> Result<[f64; 2], String> {
    let way = [to[0] - from[0], to[1] - from[1]];
    let half = 0.5 * length(way);
    if half <= 0.0 || radius.abs() < half * (1.0 - RADII_SHARE) {
        return Err(tr!(
            "an arc of radius {radius} mm does not join points {way} mm apart: allowed is a radius of half of that or \
             more, and two different points",
            radius = radius,
            way = 2.0 * half
        ));
    }
    let aside = math::positive(radius * radius - half * half).sqrt();
    // Left of the way for the shorter arc counter-clockwise.
    let side = if clockwise == (radius < 0.0) { aside } else { -aside };
    let unit = way.map(|x| x / (2.0 * half));
    Ok([0.5 * (from[0] + to[0]) - side * unit[1], 0.5 * (from[1] + to[1]) + side * unit[0]])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: [f64; 2], b: [f64; 2]) {
        assert!((0..2).all(|i| (a[i] - b[i]).abs() < 1e-9), "{a:?} {b:?}");
    }

    #[test]
    fn arcs_sweep_the_angle_that_is_meant() {
        let quarter = GCodeArc::new([10.0, 0.0], [0.0, 10.0], false, Given::Centre([-10.0, 0.0]));
        let quarter = quarter.unwrap();
        assert!((quarter.sweep_rad - 0.5 * PI).abs() < 1e-12);
        near(quarter.at([10.0, 0.0], 0.5), [50.0_f64.sqrt(), 50.0_f64.sqrt()]);
        near(quarter.at([10.0, 0.0], 1.0), [0.0, 10.0]);
        let other = GCodeArc::new([10.0, 0.0], [0.0, 10.0], true, Given::Centre([-10.0, 0.0]));
        assert!((other.unwrap().sweep_rad + 1.5 * PI).abs() < 1e-12);
        let full = GCodeArc::new([10.0, 0.0], [10.0, 0.0], true, Given::Centre([-10.0, 0.0]));
        assert_eq!(full.unwrap().sweep_rad, -TAU);
    }

    #[test]
    fn a_radius_takes_the_shorter_arc_and_below_zero_the_longer_one() {
        for (clockwise, radius, sweep, centre) in [
            (false, 10.0, 0.5 * PI, [0.0, 0.0]),
            (true, 10.0, -0.5 * PI, [10.0, 10.0]),
            (false, -10.0, 1.5 * PI, [10.0, 10.0]),
            (true, -10.0, -1.5 * PI, [0.0, 0.0]),
        ] {
            let arc = GCodeArc::new([10.0, 0.0], [0.0, 10.0], clockwise, Given::Radius(radius));
            let arc = arc.unwrap();
            near(arc.centre_mm, centre);
            assert!((arc.sweep_rad - sweep).abs() < 1e-9, "{clockwise} {radius}: {arc:?}");
        }
        // Half a turn, whose radius is rounded.
        let half = GCodeArc::new([0.0, 0.0], [10.001, 0.0], false, Given::Radius(5.0)).unwrap();
        assert!((half.sweep_rad - PI).abs() < 1e-3, "{half:?}");
    }

    #[test]
    fn what_is_no_arc_is_refused() {
        let far = GCodeArc::new([10.0, 0.0], [0.0, 12.0], false, Given::Centre([-10.0, 0.0]));
        assert!(far.unwrap_err().contains("12"));
        let small = GCodeArc::new([10.0, 0.0], [0.0, 10.0], false, Given::Radius(5.0));
        assert!(small.unwrap_err().contains("radius 5"));
        let same = GCodeArc::new([1.0, 1.0], [1.0, 1.0], false, Given::Radius(5.0));
        assert!(same.is_err());
    }
}
