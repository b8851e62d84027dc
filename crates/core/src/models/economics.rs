//! What a cut and its scrap cost, in any currency: one currency for all three.
//!
//! ```text
//! cost of the cut    C_m t + C_T dx               t time of the cut in min, dx share of the tool's life that it uses,
//!                                                 1 where a tooth has broken
//! cost of the scrap  C_s l                        l length cut beyond the tolerance on the bad side, mm
//! ```

crate::settings! {
    /// What a cut costs; all values are chosen.
    pub struct Economics {
        /// Machine with its operator, for a minute of the cut.
        machine_cost_per_min: f64 = 1.0, [0.0, 1000.0], "1/min", setup, "Machine cost";
        /// A tool, of which a cut costs the share of the life that it uses; all of it where a tooth breaks.
        tool_cost: f64 = 20.0, [0.0, 10_000.0], "", setup, "Tool cost";
        /// A millimetre of the way that is scrap: too rough a surface, or too large a force where one is held.
        scrap_cost_per_mm: f64 = 0.1, [0.0, 1000.0], "1/mm", setup, "Scrap cost";
    }
}
