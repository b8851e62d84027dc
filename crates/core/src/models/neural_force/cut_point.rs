//! The inputs of the neural force model and the ranges of its training data.

use crate::base::math;

/// Teeth of the cutters in the training data.
pub const TEETH: f64 = 2.0;
/// Feed per tooth in the training data, mm.
pub const FEED_PER_TOOTH_MM: [f64; 2] = [0.02, 0.2];
/// Cutting speed, m/min.
pub const SPEED_M_MIN: [f64; 2] = [40.0, 150.0];
/// Axial depth A_D, mm; also at most [`AXIAL_PER_DIAMETER`] of the diameter.
pub const AXIAL_DEPTH_MM: [f64; 2] = [0.5, 5.0];
/// Largest axial depth over the diameter.
pub const AXIAL_PER_DIAMETER: f64 = 1.0 / 3.0;
/// Radial depth R_D over the diameter.
pub const RADIAL_PER_DIAMETER: [f64; 2] = [0.12, 0.5];
/// Cutter diameter, mm.
pub const DIAMETER_MM: [f64; 2] = [10.0, 20.0];
/// Hardness of Ck45 (code 1) and 16MnCrSi5 (code 2), HB.
pub const HARDNESS_HB: [[f64; 2]; 2] = [[180.0, 240.0], [150.0, 210.0]];
/// Tool geometry code.
pub const GEOMETRY_CODE: [f64; 2] = [1.0, 3.0];
/// Below this speed, 1/min, the feed per tooth is taken as at it: at rest it would be infinite.
const SPEED_FLOOR_RPM: f64 = 1.0;
/// Inputs beyond this magnitude (mm/min, 1/min, mm) are taken as it, so that forces stay finite.
pub(super) const INPUT_MAX: f64 = 1e6;
/// Names of the inputs in the order of the network.
pub const INPUTS: [&str; 8] = [
    "feed_mm_min",
    "speed_rpm",
    "radial_depth_mm",
    "axial_depth_mm",
    "material_code",
    "hardness_hb",
    "diameter_mm",
    "geometry_code",
];

/// Cutting speed in m/min of a diameter in mm at a speed in 1/min.
#[must_use]
pub fn speed_m_min(diameter_mm: f64, speed_rpm: f64) -> f64 {
    math::PI * diameter_mm * speed_rpm / 1000.0
}

/// A cut as the network sees it: the papers' eight inputs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutPoint {
    /// Feed, mm/min.
    pub feed_mm_min: f64,
    /// Spindle speed, 1/min.
    pub speed_rpm: f64,
    /// Radial depth of cut R_D, mm.
    pub radial_depth_mm: f64,
    /// Axial depth of cut A_D, mm.
    pub axial_depth_mm: f64,
    /// Material: 1 Ck45, 2 16MnCrSi5.
    pub material_code: f64,
    /// Hardness, HB.
    pub hardness_hb: f64,
    /// Cutter diameter D, mm.
    pub diameter_mm: f64,
    /// Tool geometry: 1, 2, 3 for a rake of 6, 9, 12 deg. It replaces the papers' 8-digit
    /// code, which was not published.
    pub geometry_code: f64,
}

impl CutPoint {
    /// The inputs in the order of [`INPUTS`].
    #[must_use]
    pub fn inputs(&self) -> [f64; 8] {
        [
            self.feed_mm_min,
            self.speed_rpm,
            self.radial_depth_mm,
            self.axial_depth_mm,
            self.material_code,
            self.hardness_hb,
            self.diameter_mm,
            self.geometry_code,
        ]
    }

    /// Feed per tooth in mm, for the training data's [`TEETH`].
    #[must_use]
    pub fn feed_per_tooth_mm(&self) -> f64 {
        feed_per_tooth_mm(self.feed_mm_min, self.speed_rpm)
    }
}

pub(super) fn feed_per_tooth_mm(feed_mm_min: f64, speed_rpm: f64) -> f64 {
    let speed_rpm = math::limit(speed_rpm, SPEED_FLOOR_RPM, INPUT_MAX);
    math::limit(feed_mm_min, 0.0, INPUT_MAX) / (TEETH * speed_rpm)
}
