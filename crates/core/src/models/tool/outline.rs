//! The outline that a turning cutter sweeps: flat, corner and straight edge.

use crate::base::math;

/// A flat about the tip, a rounded corner around it and a straight edge above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outline {
    /// Diameter D, mm.
    pub diameter_mm: f64,
    /// Corner radius r_c, mm: half the diameter for a ball, 0 for a square end.
    pub corner_radius_mm: f64,
}

impl Outline {
    /// The outline of a ball of this radius in mm.
    #[must_use]
    pub fn ball(radius_mm: f64) -> Self {
        Self { diameter_mm: 2.0 * radius_mm, corner_radius_mm: radius_mm }
    }

    /// Radius R_0 of the straight edge, mm.
    #[must_use]
    #[inline]
    pub fn edge_mm(&self) -> f64 {
        0.5 * self.diameter_mm
    }

    /// Radius of the flat about the tip, mm: 0 for a ball.
    #[must_use]
    #[inline]
    pub fn flat_mm(&self) -> f64 {
        self.edge_mm() - self.corner_radius_mm
    }

    /// Whether there is no flat.
    #[must_use]
    #[inline]
    pub fn is_ball(&self) -> bool {
        self.corner_radius_mm == self.edge_mm()
    }

    /// Radius in mm of the circle in which a line `y_mm` beside the axis meets a ball; a flat end is met in
    /// none.
    #[must_use]
    #[inline]
    fn circle_mm(&self, y_mm: f64) -> Option<f64> {
        let edge = self.edge_mm();
        self.is_ball().then(|| (edge * edge - y_mm * y_mm).sqrt())
    }

    /// Radius R in mm at height `z_mm` above the tip.
    #[must_use]
    #[inline]
    pub fn radius_mm(&self, z_mm: f64) -> f64 {
        let corner = self.corner_radius_mm;
        if z_mm < corner {
            self.flat_mm() + math::positive(z_mm * (2.0 * corner - z_mm)).sqrt()
        } else {
            self.edge_mm()
        }
    }

    /// Height in mm of the outline `off_mm` beside its axis; beyond the edge that of the corner's end.
    #[must_use]
    pub fn height_mm(&self, off_mm: f64) -> f64 {
        let (corner, beyond) = (self.corner_radius_mm, self.beyond_mm(off_mm));
        corner - math::positive(corner * corner - beyond * beyond).sqrt()
    }

    /// How far in mm beyond the flat a place `off_mm` beside the axis lies; 0 on the flat.
    #[must_use]
    #[inline]
    pub fn beyond_mm(&self, off_mm: f64) -> f64 {
        math::positive(off_mm - self.flat_mm())
    }

    /// Height in mm of the outline `d_mm` beside its axis, along a line `y_mm` from the axis over that
    /// straight across from it; infinite beyond the edge.
    ///
    /// ```text
    /// s(d, y) - s(0, y),   s = r_c - (r_c^2 - (rho - flat)^2)^1/2 beyond the flat,  rho^2 = d^2 + y^2
    /// ```
    #[must_use]
    #[inline]
    pub fn rise_mm(&self, d_mm: f64, y_mm: f64) -> f64 {
        if let Some(circle) = self.circle_mm(y_mm) {
            // It keeps all digits of a small rise.
            return rise_of_circle_mm(circle, d_mm);
        }
        let corner = |rho: f64| rise_of_circle_mm(self.corner_radius_mm, self.beyond_mm(rho));
        corner((d_mm * d_mm + y_mm * y_mm).sqrt()) - corner(y_mm.abs())
    }

    /// How far in mm beside a mark one shows that lies by up to `deeper_mm` deeper or higher: two marks
    /// reach as far as the parabola between them, beside the flat.
    #[must_use]
    #[inline]
    pub fn reach_mm(&self, deeper_mm: f64) -> f64 {
        self.flat_mm() + (4.0 * self.corner_radius_mm * 2.0 * deeper_mm).sqrt()
    }

    /// Height in mm of the cusps of a feed per tooth in mm along a line `y_mm` from the axis; a ball is met
    /// in a smaller circle there.
    #[must_use]
    #[inline]
    pub fn cusp_at_mm(&self, feed_per_tooth_mm: f64, y_mm: f64) -> f64 {
        match self.circle_mm(y_mm) {
            Some(circle) => feed_per_tooth_mm * feed_per_tooth_mm / (8.0 * circle),
            None => self.rise_mm(0.5 * feed_per_tooth_mm, y_mm),
        }
    }

    /// Feed per tooth in mm less what the flat takes of it: that of a ball of the corner's radius that
    /// leaves the same cusps.
    #[must_use]
    pub fn cusp_feed_mm(&self, feed_per_tooth_mm: f64) -> f64 {
        math::positive(feed_per_tooth_mm - 2.0 * self.flat_mm())
    }
}

/// Height in mm of a circle `d_mm` beside its lowest point; infinite beyond it.
#[inline]
fn rise_of_circle_mm(radius_mm: f64, d_mm: f64) -> f64 {
    let squared = d_mm * d_mm;
    let rest = radius_mm * radius_mm - squared;
    if squared == 0.0 {
        0.0
    } else if rest >= 0.0 {
        squared / (radius_mm + rest.sqrt())
    } else {
        f64::INFINITY
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_outline_has_the_radii_of_its_circle() {
        let bull = Outline { diameter_mm: 16.0, corner_radius_mm: 2.0 };
        assert_eq!([0.0, 2.0, 5.0].map(|z| bull.radius_mm(z)), [6.0, 8.0, 8.0]);
        // Half a corner's height up: 6 + 3^1/2.
        assert!((bull.radius_mm(1.0) - 6.0 - 3.0_f64.sqrt()).abs() < 1e-12);
        let square = Outline { diameter_mm: 16.0, corner_radius_mm: 0.0 };
        assert_eq!([0.0, 1.0].map(|z| square.radius_mm(z)), [8.0; 2]);
        let ball = Outline::ball(8.0);
        assert!((ball.radius_mm(2.0) - 28.0_f64.sqrt()).abs() < 1e-12 && ball.is_ball());
    }

    #[test]
    fn the_rise_is_that_of_the_corner_beyond_the_flat() {
        let ball = Outline::ball(8.0);
        assert!((ball.rise_mm(3.0, 0.0) - (8.0 - 55.0_f64.sqrt())).abs() < 1e-12);
        assert!((ball.rise_mm(3.0, 4.0) - (48.0_f64.sqrt() - 39.0_f64.sqrt())).abs() < 1e-12);
        assert_eq!(ball.rise_mm(8.1, 0.0), f64::INFINITY);
        let bull = Outline { diameter_mm: 16.0, corner_radius_mm: 2.0 };
        assert_eq!(bull.rise_mm(5.9, 0.0), 0.0);
        assert!((bull.rise_mm(7.0, 0.0) - (2.0 - 3.0_f64.sqrt())).abs() < 1e-12);
        assert_eq!(bull.rise_mm(8.1, 0.0), f64::INFINITY);
        // The same height on the same circle about the axis, whichever way it is reached.
        let height = |d: f64, y: f64| bull.rise_mm(d, y) + bull.rise_mm(y, 0.0);
        assert!((height(3.0, 6.5) - height(6.5, 3.0)).abs() < 1e-12);
        let square = Outline { diameter_mm: 16.0, corner_radius_mm: 0.0 };
        assert_eq!([0.0, 7.9].map(|d| square.rise_mm(d, 0.0)), [0.0; 2]);
        assert_eq!(square.rise_mm(8.1, 0.0), f64::INFINITY);
    }
}
