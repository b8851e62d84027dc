//! Static peak forces of the ball-end model beside published values, and how they depend on the
//! height of the slices.

use serde::Serialize;

use crate::models::mechanistic::{CK45, Cutter, Kienzle, StaticCut, StaticPeak, static_peak};
use crate::models::tool::Tool;

/// The cuts: feed per tooth in mm, A_D and R_D in mm, run-out in mm; then Fx, Fy, Fz at the instant
/// of the largest F_xy, that F_xy and the mean F_xy, in N. Ck45, D 16 mm, two teeth, v_c 80 m/min,
/// rake 12 deg, slices of 0.1 mm; from an independent implementation of the same model.
pub const REFERENCE: [([f64; 4], [f64; 5]); 7] = [
    ([0.08, 2.0, 3.0, 0.0], [-264.8, 94.5, 117.9, 281.2, 67.0]),
    ([0.08, 2.0, 4.0, 0.0], [-335.2, 226.2, 172.2, 404.3, 114.2]),
    ([0.08, 2.0, 4.0, 0.003], [-357.4, 244.7, 179.8, 433.1, 114.2]),
    ([0.04, 2.0, 4.0, 0.0], [-197.2, 115.8, 119.9, 228.7, 64.9]),
    ([0.16, 2.0, 4.0, 0.0], [-574.7, 434.0, 246.3, 720.2, 202.8]),
    ([0.08, 5.0, 4.0, 0.0], [-649.5, 177.2, 147.0, 673.3, 164.8]),
    ([0.08, 4.0, 8.0, 0.0], [-402.2, 1031.3, 366.0, 1106.9, 470.1]),
];
/// Heights of slices at which the convergence is shown, mm.
pub const SLICES_MM: [f64; 5] = [0.4, 0.25, 0.1, 0.05, 0.025];
/// Slices of the reference values, mm.
pub const REFERENCE_SLICE_MM: f64 = 0.1;

/// One cut of the table.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PeakRow {
    /// Feed per tooth in mm, A_D, R_D, run-out in mm.
    pub cut: [f64; 4],
    /// Reference: Fx, Fy, Fz, F_xy, mean F_xy in N.
    pub reference_n: [f64; 5],
    /// Computed here, in the same order.
    pub computed_n: [f64; 5],
    /// Peak F_xy in N at each of [`SLICES_MM`].
    pub fxy_over_slices_n: [f64; 5],
    /// Peak F_xy in the limit of thin slices over that at the reference's slices, extrapolated
    /// linearly from the two thinnest, in percent.
    pub limit_percent: f64,
}

fn peak(
    [feed_per_tooth_mm, axial_depth_mm, radial_depth_mm, runout]: [f64; 4],
    slice_mm: f64,
) -> StaticPeak {
    let tool = Tool::default();
    let law = Kienzle::new(&CK45, 80.0, tool.rake_deg, CK45.hardness_hb);
    let cutter = Cutter::new(&tool, runout, slice_mm);
    static_peak(&cutter, &law, &StaticCut { feed_per_tooth_mm, axial_depth_mm, radial_depth_mm })
}

/// The whole table.
#[must_use]
pub fn table() -> Vec<PeakRow> {
    let row = |(cut, reference_n): &([f64; 4], [f64; 5])| {
        let at = peak(*cut, REFERENCE_SLICE_MM);
        let [x, y, z] = at.components_n;
        let over_slices = SLICES_MM.map(|slice_mm| peak(*cut, slice_mm).fxy_n);
        let limit_n = 2.0 * over_slices[4] - over_slices[3];
        PeakRow {
            cut: *cut,
            reference_n: *reference_n,
            computed_n: [x, y, z, at.fxy_n, at.mean_fxy_n],
            fxy_over_slices_n: over_slices,
            limit_percent: 100.0 * (limit_n / at.fxy_n - 1.0),
        }
    };
    REFERENCE.iter().map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peaks_meet_the_reference_within_half_a_percent() {
        for (cut, reference) in REFERENCE {
            let at = peak(cut, REFERENCE_SLICE_MM);
            let [x, y, z] = at.components_n;
            for (computed, reference) in [x, y, z, at.fxy_n, at.mean_fxy_n].iter().zip(reference) {
                assert!(
                    (computed / reference - 1.0).abs() < 5e-3,
                    "{cut:?}: {computed} {reference}"
                );
            }
        }
    }

    #[test]
    fn thin_slices_converge_some_percent_below_the_reference() {
        let cut = REFERENCE[0].0;
        let [thick, reference, thin] = [0.25, 0.1, 0.025].map(|slice| peak(cut, slice));
        assert!(thick.fxy_n > reference.fxy_n && reference.fxy_n > thin.fxy_n);
        assert!((thin.fxy_n / reference.fxy_n - 0.97).abs() < 0.01, "{thin:?} {reference:?}");
        // Only the peak: the mean force does not depend on the slices.
        assert!((thin.mean_fxy_n / thick.mean_fxy_n - 1.0).abs() < 5e-3);
    }
}
