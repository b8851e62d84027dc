//! The cutter: its shape, its teeth, and how far it bends. The default is the papers' ball end
//! R216-16B20-040; the other shipped ones are files in `assets/tools` ([`ShippedTool`]).
//!
//! Three shapes of one end (Engin and Altintas 2001, Mechanics and dynamics of general milling
//! cutters, part I; the ball of Lee and Altintas 1996 among them): a flat of radius R_0 - r_c about the
//! tip with a corner of radius r_c around it, below a straight edge of radius R_0 = D/2.
//!
//! ```text
//! ball end   r_c = R_0        bull nose   0 <= r_c <= R_0        square end   r_c = 0
//! R(z) = R_0 - r_c + (z (2 r_c - z))^1/2 for z < r_c, else R_0           z above the tip
//! ```

mod catalogue;
mod file;
mod outline;

pub use catalogue::ShippedTool;
pub use file::{FORMAT_VERSION, ToolFile};
pub use outline::Outline;

use crate::base::math::{self, PI};

crate::choice! {
    /// The shape of a cutter's end.
    pub enum EndShape {
        /// A ball of half the diameter.
        Ball = "ball", "Ball end";
        /// A flat end with a rounded corner.
        BullNose = "bull_nose", "Bull nose";
        /// A flat end with a sharp corner.
        Square = "square", "Square end";
    }
}

crate::settings! {
    /// The cutter.
    pub struct Tool {
        /// Shipped cutter; choosing one sets all that follows to its values.
        name: ShippedTool = ShippedTool::R21616B20, [], "", setup, "Cutter";
        /// Shape of its end. A ball end has a corner of half the diameter, a square end none.
        shape: EndShape = EndShape::Ball, [], "", setup, "Shape";
        /// Diameter D.
        diameter_mm: f64 = 16.0, [2.0, 50.0], "mm", setup, "Diameter";
        /// Corner radius of a bull nose, at most half the diameter; other shapes do not ask for it.
        corner_radius_mm: f64 = 1.0, [0.0, 25.0], "mm", setup, "Corner radius";
        /// Number of teeth z, evenly spaced.
        teeth: u32 = 2, [1.0, 8.0], "", setup, "Teeth";
        /// Helix angle at the diameter; the flutes have one lead from the tip on.
        helix_deg: f64 = 10.0, [0.0, 60.0], "deg", setup, "Helix angle";
        /// Rake angle: 1.5 % of the force for each degree. The networks know 6 to 12 degrees.
        rake_deg: f64 = 12.0, [-10.0, 25.0], "deg", setup, "Rake angle";
        /// Free length L from the holder to the tip (chosen for the papers' cutter).
        overhang_mm: f64 = 40.0, [5.0, 300.0], "mm", setup, "Overhang";
        /// Modulus of elasticity E of the shank: steel 210 000, cemented carbide some 580 000 N/mm^2.
        elastic_modulus_n_mm2: f64 = 2.1e5, [5e4, 7e5], "N/mm^2", setup, "Modulus of the shank";
        /// Compliance G of tool and holder in the regeneration of the force tooth by tooth (2005 eq. 1):
        /// 50 N/um. As printed, in m/N, 650 N would bend the tool by 13 mm.
        compliance_um_n: f64 = 0.02, [0.0, 1.0], "um/N", setup, "Compliance";
        /// Run-out: the axis is shifted by this towards the first tooth, so of two one stands out and one
        /// in; tooth by tooth only.
        runout_um: f64 = 3.0, [0.0, 50.0], "um", live, "Run-out";
        /// Thickest chip that a tooth stands; beyond it the tooth breaks, the last one with the whole tool. 0: any. For
        /// the papers' cutter 0.6 mm is a choice, four times the feed per tooth of its own cut.
        chip_max_mm: f64 = 0.0, [0.0, 10.0], "mm", live, "Chip that breaks a tooth";
        /// Largest force that the cutter stands, with all that shakes it; beyond it a tooth breaks in the same way. 0:
        /// any. For the papers' cutter 4000 N is a choice: 400 N/mm^2 in its shank.
        force_max_n: f64 = 0.0, [0.0, 100_000.0], "N", live, "Force that breaks a tooth";
    }
}

/// Where tooth `tooth` of `teeth` stands in the run-out, from 1 (furthest out) to -1: the axis is
/// shifted towards tooth 0 (Kline and DeVor 1983), so two teeth stand out and in by the same.
#[must_use]
pub fn runout_share(tooth: usize, teeth: usize) -> f64 {
    math::cos(math::TAU * (tooth % teeth.max(1)) as f64 / teeth.max(1) as f64)
}

impl Tool {
    /// Spindle speed in 1/min of a cutting speed in m/min: n = 1000 v_c / (pi D).
    #[must_use]
    #[inline]
    pub fn speed_rpm(&self, cutting_speed_m_min: f64) -> f64 {
        1000.0 / (PI * self.diameter_mm) * cutting_speed_m_min
    }

    /// Cutting speed in m/min at a spindle speed in 1/min: v_c = pi D n / 1000.
    #[must_use]
    #[inline]
    pub fn cutting_speed_m_min(&self, speed_rpm: f64) -> f64 {
        PI * self.diameter_mm * speed_rpm / 1000.0
    }

    /// Feed in mm/min of a feed per tooth in mm: f = f_z z n.
    #[must_use]
    #[inline]
    pub fn feed_mm_min(&self, feed_per_tooth_mm: f64, speed_rpm: f64) -> f64 {
        feed_per_tooth_mm * f64::from(self.teeth) * speed_rpm
    }

    /// Feed per tooth in mm of a feed in mm/min at a speed in 1/min: f_z = f / (z n); 0 without feed, infinite
    /// where the spindle stands.
    #[must_use]
    #[inline]
    pub fn feed_per_tooth_mm(&self, feed_mm_min: f64, speed_rpm: f64) -> f64 {
        if feed_mm_min == 0.0 {
            return 0.0;
        }
        feed_mm_min / (f64::from(self.teeth) * speed_rpm)
    }

    /// Deflection of the tip in mm under one newton across the shank, a clamped bar:
    /// 64 L^3 / (3 pi E D^4).
    #[must_use]
    pub fn bar_compliance_mm_n(&self) -> f64 {
        let (l, d) = (self.overhang_mm, self.diameter_mm);
        64.0 * l * l * l / (3.0 * PI * self.elastic_modulus_n_mm2 * d * d * d * d)
    }

    /// The outline that its edges sweep.
    #[must_use]
    pub fn outline(&self) -> Outline {
        let corner_radius_mm = match self.shape {
            EndShape::Ball => 0.5 * self.diameter_mm,
            EndShape::BullNose => self.corner_radius_mm.min(0.5 * self.diameter_mm),
            EndShape::Square => 0.0,
        };
        Outline { diameter_mm: self.diameter_mm, corner_radius_mm }
    }

    /// The largest corner radius in mm, where that of a bull nose is above it: half the diameter.
    #[must_use]
    pub fn corner_too_large_mm(&self) -> Option<f64> {
        let most = 0.5 * self.diameter_mm;
        (self.shape == EndShape::BullNose && self.corner_radius_mm > most).then_some(most)
    }

    /// Code of the insert's geometry for the networks: 1, 2, 3 for a rake of 6, 9, 12 degrees.
    #[must_use]
    pub fn geometry_code(&self) -> f64 {
        self.rake_deg / 3.0 - 1.0
    }

    /// Whether it cuts as the papers' cutter does, for which their formulas hold: shape, diameter,
    /// teeth, helix and rake.
    #[must_use]
    pub fn cuts_as_in_the_papers(&self) -> bool {
        self.cuts_as(&Self::default())
    }

    /// Whether it cuts as another one does: shape, diameter, teeth, helix and rake. Overhang, run-out and
    /// material may differ.
    #[must_use]
    pub fn cuts_as(&self, other: &Self) -> bool {
        self.outline() == other.outline()
            && self.rake_deg == other.rake_deg
            && self.teeth == other.teeth
            && self.helix_deg == other.helix_deg
    }

    /// The shipped cutter that it cuts as, if there is one.
    #[must_use]
    pub fn shipped_alike(&self) -> Option<ShippedTool> {
        ShippedTool::ALL.iter().copied().find(|shipped| self.cuts_as(shipped.tool()))
    }

    /// Whether shape, number and helix of its teeth are those of the networks' training data; diameter
    /// and rake they know over a range.
    #[must_use]
    pub fn teeth_as_in_the_papers(&self) -> bool {
        let papers = Self::default();
        self.outline().is_ball() && self.teeth == papers.teeth && self.helix_deg == papers.helix_deg
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tool_turns_as_the_papers_say_and_bends_as_a_clamped_bar() {
        let tool = Tool::default();
        let speed = tool.speed_rpm(80.0);
        assert!((speed - 1591.55).abs() < 0.01, "2005: 80 m/min are 1591.55 1/min, not {speed}");
        let feed = tool.feed_mm_min(0.08, speed);
        assert!((feed - 254.65).abs() < 0.01, "2005: 0.08 mm are 254.65 mm/min, not {feed}");
        assert!((tool.feed_per_tooth_mm(feed, speed) - 0.08).abs() < 1e-15);
        assert!((tool.cutting_speed_m_min(speed) - 80.0).abs() < 1e-12);
        // F L^3 / (3 E I) with I = pi D^4 / 64 = 3217.0 mm^4.
        let by_hand = 1000.0 * 40.0_f64 * 40.0 * 40.0 / (3.0 * 2.1e5 * 3216.99);
        assert!((1000.0 * tool.bar_compliance_mm_n() - by_hand).abs() < 1e-6);
        assert_eq!(tool.geometry_code(), 3.0);
        assert!(tool.cuts_as_in_the_papers() && tool.teeth_as_in_the_papers());
    }

    #[test]
    fn another_end_or_other_teeth_are_not_the_papers() {
        let half = Tool { shape: EndShape::BullNose, corner_radius_mm: 8.0, ..Tool::default() };
        assert!(half.cuts_as_in_the_papers(), "a ball under another name");
        for other in [
            Tool { shape: EndShape::Square, ..Tool::default() },
            Tool { teeth: 3, ..Tool::default() },
            Tool { helix_deg: 30.0, ..Tool::default() },
        ] {
            assert!(!other.cuts_as_in_the_papers() && !other.teeth_as_in_the_papers());
        }
        for other in [
            Tool { diameter_mm: 12.0, ..Tool::default() },
            Tool { rake_deg: 6.0, ..Tool::default() },
        ] {
            assert!(!other.cuts_as_in_the_papers() && other.teeth_as_in_the_papers());
        }
    }

    #[test]
    fn run_out_sums_to_nothing_and_two_teeth_stand_out_and_in() {
        assert_eq!([0, 1, 2, 3].map(|tooth| runout_share(tooth, 2)), [1.0, -1.0, 1.0, -1.0]);
        for teeth in 2..=8 {
            let sum: f64 = (0..teeth).map(|tooth| runout_share(tooth, teeth)).sum();
            assert!(sum.abs() < 1e-12, "{teeth}: {sum}");
        }
    }
}
