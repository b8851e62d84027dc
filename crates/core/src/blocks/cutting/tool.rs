//! The cutter of the papers.

use crate::base::math::PI;

/// A milling cutter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tool {
    /// Name.
    pub name: &'static str,
    /// Diameter D, mm.
    pub diameter_mm: f64,
    /// Number of teeth z.
    pub teeth: f64,
    /// Free length L from the holder to the tip, mm.
    pub overhang_mm: f64,
    /// Code of the insert's geometry for the networks: 1, 2, 3 for a rake of 6, 9, 12 degrees.
    pub geometry_code: f64,
    /// Modulus of elasticity E of the shank, N/mm^2.
    pub elastic_modulus_n_mm2: f64,
}

/// The papers' ball-end cutter R216-16B20-040 with two teeth and a rake of 12 degrees; overhang
/// and modulus are chosen.
pub const R216_16B20_040: Tool = Tool {
    name: "R216-16B20-040",
    diameter_mm: 16.0,
    teeth: 2.0,
    overhang_mm: 40.0,
    geometry_code: 3.0,
    elastic_modulus_n_mm2: 2.1e5,
};

impl Tool {
    /// Spindle speed in 1/min of a cutting speed in m/min: n = 1000 v_c / (pi D).
    #[must_use]
    #[inline]
    pub fn speed_rpm(&self, cutting_speed_m_min: f64) -> f64 {
        1000.0 / (PI * self.diameter_mm) * cutting_speed_m_min
    }

    /// Feed in mm/min of a feed per tooth in mm: f = f_z z n.
    #[must_use]
    #[inline]
    pub fn feed_mm_min(&self, feed_per_tooth_mm: f64, speed_rpm: f64) -> f64 {
        feed_per_tooth_mm * self.teeth * speed_rpm
    }

    /// Deflection of the tip in mm under one newton across the shank, a clamped bar:
    /// 64 L^3 / (3 pi E D^4).
    #[must_use]
    pub fn compliance_mm_n(&self) -> f64 {
        let (l, d) = (self.overhang_mm, self.diameter_mm);
        64.0 * l * l * l / (3.0 * PI * self.elastic_modulus_n_mm2 * d * d * d * d)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tool_turns_as_the_papers_say_and_bends_as_a_clamped_bar() {
        let speed = R216_16B20_040.speed_rpm(80.0);
        assert!((speed - 1591.55).abs() < 0.01, "2005: 80 m/min are 1591.55 1/min, not {speed}");
        let feed = R216_16B20_040.feed_mm_min(0.08, speed);
        assert!((feed - 254.65).abs() < 0.01, "2005: 0.08 mm are 254.65 mm/min, not {feed}");
        // F L^3 / (3 E I) with I = pi D^4 / 64 = 3217.0 mm^4.
        let by_hand = 1000.0 * 40.0_f64 * 40.0 * 40.0 / (3.0 * 2.1e5 * 3216.99);
        assert!((1000.0 * R216_16B20_040.compliance_mm_n() - by_hand).abs() < 1e-6);
    }
}
