//! A cut at one feed and speed, how long its tool lasts, and what it yields.

use crate::base::math;
use crate::base::units::cm3_from_mm3;

/// Cutting speed in m/min and feed per tooth in mm of the reference cut (2005).
pub const REFERENCE: [f64; 2] = [80.0, 0.08];

/// Everything that follows from a cutting speed and a feed per tooth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutAtPoint {
    /// Spindle speed, 1/min.
    pub speed_rpm: f64,
    /// Feed, mm/min.
    pub feed_mm_min: f64,
    /// Force components F_x, F_y, F_z at the instant of the largest force, N.
    pub components_n: [f64; 3],
    /// The largest force across the tool, sqrt(F_x^2 + F_y^2), N.
    pub force_n: f64,
    /// Spindle power, kW.
    pub power_kw: f64,
    /// Roughness of the feed marks, um.
    pub ra_um: f64,
    /// Deflection of the cutter's tip, mm.
    pub deflection_mm: f64,
    /// Tool life, min.
    pub tool_life_min: f64,
}

impl CutAtPoint {
    /// The values of the seven constraints, in their order.
    #[must_use]
    #[inline]
    pub fn values(&self) -> [f64; 7] {
        [
            self.speed_rpm,
            self.feed_mm_min,
            self.force_n,
            self.power_kw,
            self.ra_um,
            self.deflection_mm,
            self.tool_life_min,
        ]
    }
}

/// Taylor's tool life T = T_0 (v_0/v_c)^4 (f_0/f_z)^0.8 (a_0/A_D)^0.4 by its reference values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlannedToolLife {
    /// Tool life at the reference cut, min.
    pub life_min: f64,
    /// Cutting speed in m/min, feed per tooth in mm and axial depth in mm of the reference cut.
    pub reference: [f64; 3],
}

/// The preset `table_2005`: 60 min at the 2005 paper's cut (chosen).
pub const TABLE_2005: PlannedToolLife =
    PlannedToolLife { life_min: 60.0, reference: [REFERENCE[0], REFERENCE[1], 2.0] };

impl PlannedToolLife {
    /// T v_c^4 f_z^0.8 at an axial depth in mm.
    #[must_use]
    pub fn factor(&self, axial_depth_mm: f64) -> f64 {
        let [speed, feed, depth] = self.reference;
        let depth = math::pow(depth / axial_depth_mm, 0.4);
        self.life_min * speed * speed * speed * speed * math::pow(feed, 0.8) * depth
    }
}

/// What time and tools cost, and the size of the cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Economy {
    /// Length of the path, mm.
    pub length_mm: f64,
    /// Cross-section A_D R_D, mm^2.
    pub section_mm2: f64,
    /// Cost of machine and operator C_m, per min.
    pub machine_cost_per_min: f64,
    /// Cost of a tool life C_t.
    pub tool_cost: f64,
    /// Time of a tool change t_ch, min.
    pub tool_change_min: f64,
}

/// What a cut yields.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Yield {
    /// Metal removal rate, cm^3/min.
    pub removal_rate_cm3_min: f64,
    /// Time of the cut, min.
    pub cut_min: f64,
    /// Time of the cut with its share of tool changes, min.
    pub production_min: f64,
    /// Cost of the cut with its share of tools.
    pub cost: f64,
}

impl Economy {
    /// What a cut yields: t_m = L / f, t_p = t_m (1 + t_ch / T),
    /// C = t_m C_m + (t_m / T) (C_m t_ch + C_t).
    #[must_use]
    #[inline]
    pub fn yield_of(&self, cut: &CutAtPoint) -> Yield {
        let cut_min = self.length_mm / cut.feed_mm_min;
        let lives = cut_min / cut.tool_life_min;
        let change_cost = self.machine_cost_per_min * self.tool_change_min + self.tool_cost;
        Yield {
            removal_rate_cm3_min: cm3_from_mm3(self.section_mm2 * cut.feed_mm_min),
            cut_min,
            production_min: cut_min + lives * self.tool_change_min,
            cost: cut_min * self.machine_cost_per_min + lives * change_cost,
        }
    }
}
