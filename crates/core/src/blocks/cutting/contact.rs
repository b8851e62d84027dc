//! How the cutter meets the sections of a cut where the force is a map of feed and engagement.
//!
//! The teeth cut ahead of the axis, up to the cutter's radius R at the cut's largest depth, so a section
//! is entered and left gradually, and force control is possible at all:
//!
//! ```text
//! F(x) = max(mean of F(section) over x + R/4 .. x + R,  the same over x .. x + 3R/4)
//! ```
//!
//! A tooth is loaded most where it is furthest ahead as material begins, and where it is not as material
//! ends. The two stretches are chosen: with them the ramps lie where those of the force tooth by
//! tooth do (`crates/study/tests/study/milling.rs`).

use super::tool_path::{Engagement, met_mm};
use crate::base::math;
use crate::models::Valued;
use crate::models::part::CutPath;
use crate::models::tool::Outline;

/// Stretches ahead of the axis, in parts of R.
const STRETCHES: [[f64; 2]; 2] = [[0.25, 1.0], [0.0, 0.75]];

/// The force in N with the tool's axis at `x_mm` along `cut`; `force_in` gives that of a section.
pub fn force_along(
    outline: &Outline,
    cut: &CutPath,
    x_mm: f64,
    mut force_in: impl FnMut(&Engagement) -> Valued,
) -> Valued {
    let reach_mm = met_mm(outline, cut.depth_max_mm());
    let stretches = STRETCHES.map(|ends| ends.map(|part| x_mm + part * reach_mm));
    let (mut means, mut valid) = ([0.0; 2], true);
    for (section, [from_mm, to_mm]) in cut.sections_within([x_mm, x_mm + reach_mm]) {
        let force = force_in(&Engagement::in_section(outline, section));
        valid &= force.valid;
        for (mean, [low, high]) in means.iter_mut().zip(stretches) {
            let inside_mm = math::positive(to_mm.min(high) - from_mm.max(low));
            *mean += force.value * (inside_mm / (high - low));
        }
    }
    Valued::new(means[0].max(means[1]), valid)
}

#[cfg(test)]
mod tests {
    use super::*;

    const BALL: Outline = Outline { diameter_mm: 16.0, corner_radius_mm: 8.0 };

    #[test]
    fn sections_are_entered_and_left_over_three_quarters_of_the_radius() {
        // R = 5.898 mm at 2.6 mm: both sections have it, the second one twice the force.
        let cut = CutPath::new(&[[30.0, 2.6, 2.0], [30.0, 2.6, 0.0]]);
        let radius = met_mm(&BALL, 2.6);
        let at = |x_mm: f64| {
            let wide = |place: &Engagement| if place.radial_depth_mm > 5.0 { 2.0 } else { 1.0 };
            force_along(&BALL, &cut, x_mm, |place| Valued::new(wide(place), true)).value
        };
        let near = |x_mm: f64, force: f64| assert!((at(x_mm) - force).abs() < 1e-9, "{x_mm}");
        assert_eq!(at(-radius - 0.01), 0.0, "in the air");
        near(-0.625 * radius, 0.5);
        near(-0.25 * radius, 1.0);
        near(15.0, 1.0);
        near(30.0 - 0.625 * radius, 1.5);
        near(30.0, 2.0);
        near(60.0 - 0.75 * radius, 2.0);
        near(60.0 - 0.375 * radius, 1.0);
        near(60.0, 0.0);
    }

    #[test]
    fn what_a_section_does_not_know_marks_the_force() {
        let cut = CutPath::new(&[[30.0, 2.6, 2.0]]);
        let unknown = |_: &Engagement| Valued::new(1.0, false);
        assert!(
            !force_along(&BALL, &cut, 10.0, unknown).valid
                && force_along(&BALL, &cut, -9.0, unknown).valid
        );
    }
}
