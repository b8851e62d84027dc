//! A virtual profilometer: a stylus drawn along a straight line over the machined surface, what it
//! finds filtered by the standards, and Ra, Rq, Rz of it.
//!
//! The form that the turning cutter would leave without feed is taken off before, as a measuring
//! instrument takes off the nominal form. The filters need a run-up on each side
//! ([`roughness_profile::run_up_mm`]); the whole sampling lengths that fit between them
//! are evaluated. The standards take five; fewer are measured, and said.

use crate::base::language::tr;
use crate::base::math;
use crate::base::stats;
use crate::base::units::mm_from_um;
use crate::blocks::cutting::tool_path::strip_mm;
use crate::blocks::surface::topography::Topography;
use crate::models::part::CutPath;
use crate::models::roughness_profile;
use crate::models::roughness_profile::{ProfileSettings, Roughness};

/// Most points of a measurement: beyond, neither a picture nor a number gains anything.
const MOST_POINTS: usize = 300_000;
/// What a length may miss by rounding, sampling lengths.
const HAIR: f64 = 1e-9;

/// The line that the stylus is drawn along, x along the cut and y across it from the tool's axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfileLine {
    /// Where it begins, mm.
    pub from_mm: [f64; 2],
    /// Where it ends, mm.
    pub to_mm: [f64; 2],
}

impl ProfileLine {
    /// Its length, mm.
    #[must_use]
    pub fn length_mm(&self) -> f64 {
        let [x, y] = [0, 1].map(|i| self.to_mm[i] - self.from_mm[i]);
        (x * x + y * y).sqrt()
    }

    /// The point at a distance from its beginning, mm.
    #[must_use]
    pub fn at(&self, along_mm: f64) -> [f64; 2] {
        let fraction = along_mm / self.length_mm();
        [0, 1].map(|i| self.from_mm[i] + fraction * (self.to_mm[i] - self.from_mm[i]))
    }
}

/// Why a line cannot be measured.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LineError {
    /// A coordinate is no number.
    #[error("{}", tr("the line's ends must be numbers in mm"))]
    NoNumber,
    /// Its length, and the least and the largest one that these cut-offs allow, mm.
    #[error("{}", too_short_or_long(*length_mm, *allowed_mm))]
    Length {
        /// What it is.
        length_mm: f64,
        /// What it may be.
        allowed_mm: [f64; 2],
    },
    /// No tooth has been anywhere yet.
    #[error("{}", tr("no tooth has cut anything yet"))]
    NothingCut,
    /// It leaves the surface at a place, mm; the surface there, across the cut, or along it.
    #[error("{}", leaves(*at_mm, &beside(at_mm[0], *along_mm, *across_mm)))]
    Leaves {
        /// The first place off the surface.
        at_mm: [f64; 2],
        /// What is cut so far along the cut.
        along_mm: [f64; 2],
        /// What is machined across the cut at that place, if anything.
        across_mm: Option<[f64; 2]>,
    },
}

/// That a line is not of a length that can be measured, mm.
fn too_short_or_long(length_mm: f64, [least, most]: [f64; 2]) -> String {
    tr!(
        "the line is {length:.3} mm long: with these cut-offs it takes at least {least:.3} mm (a run-up on each side \
         and one sampling length), and at most {most:.1} mm",
        length = length_mm,
        least = least,
        most = most
    )
}

/// That a line leaves the surface, and where that is.
fn leaves([x, y]: [f64; 2], beside: &str) -> String {
    tr!(
        "the line leaves the machined surface at x = {x:.3} mm, y = {y:.3} mm: {beside}",
        x = x,
        y = y,
        beside = beside
    )
}

/// Where the surface is beside a place that lies off it: across the cut, or along it.
fn beside(x_mm: f64, [first, last]: [f64; 2], across_mm: Option<[f64; 2]>) -> String {
    match across_mm {
        Some([low, high]) if (first..=last).contains(&x_mm) => {
            tr!("there y reaches from {low:.3} to {high:.3} mm", low = low, high = high)
        }
        Some(_) | None => {
            tr!("x reaches from {first:.3} to {last:.3} mm so far", first = first, last = last)
        }
    }
}

/// What the stylus has found.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurement {
    /// Profile and parameters over the evaluation length.
    pub roughness: Roughness,
    /// Where along the line the evaluation length begins, mm.
    pub begins_mm: f64,
    /// Sampling lengths evaluated.
    pub lengths: usize,
    /// Mean of the Ra that the run has along the line, um; none tooth by tooth.
    pub run_ra_um: Option<f64>,
}

/// The least and the largest length of a line in mm.
#[must_use]
pub fn allowed_mm(settings: &ProfileSettings) -> [f64; 2] {
    let run_ups_mm = 2.0 * roughness_profile::run_up_mm(settings);
    // What a further sampling length takes, and what one takes besides.
    let [one, two] = [1, 2].map(|lengths| roughness_profile::points_over(settings, lengths));
    let most = 1 + (MOST_POINTS - one) / (two - one);
    [1, most].map(|lengths| run_ups_mm + lengths as f64 * settings.long_mm)
}

/// Draws the stylus along `line` over the surface of a cut.
///
/// # Errors
/// The line is too short or too long for the cut-offs, or leaves the surface.
pub fn measure(
    surface: &Topography,
    cut: &CutPath,
    line: &ProfileLine,
    settings: &ProfileSettings,
) -> Result<Measurement, LineError> {
    if !line.from_mm.iter().chain(&line.to_mm).all(|x| x.is_finite()) {
        return Err(LineError::NoNumber);
    }
    let along_mm = surface.range_mm().ok_or(LineError::NothingCut)?;
    let (length_mm, allowed_mm) = (line.length_mm(), allowed_mm(settings));
    let hair_mm = HAIR * settings.long_mm;
    if !(allowed_mm[0] - hair_mm..allowed_mm[1] + settings.long_mm).contains(&length_mm) {
        return Err(LineError::Length { length_mm, allowed_mm });
    }
    let run_up_mm = roughness_profile::run_up_mm(settings);
    let lengths = ((length_mm - 2.0 * run_up_mm) / settings.long_mm + HAIR).floor() as usize;
    let mut left = None;
    let roughness = roughness_profile::evaluate_over(settings, lengths, |_, step_mm, count| {
        let height = |i: usize| {
            let [x, y] = line.at(i as f64 * step_mm);
            let across_mm = strip_mm(surface.outline(), cut, x);
            let inside = across_mm.is_some_and(|[low, high]| (low..=high).contains(&y));
            let found = surface.height_um(x, y).filter(|_| inside);
            if found.is_none() {
                left = Some(LineError::Leaves { at_mm: [x, y], along_mm, across_mm });
            }
            found.map(mm_from_um)
        };
        // Ends at the first point off the surface.
        (0..count).map_while(height).collect()
    });
    let Some(roughness) = roughness else {
        return Err(left.unwrap_or(LineError::NoNumber));
    };
    let run_ra_um = mean_ra_um(surface, line);
    Ok(Measurement { roughness, begins_mm: run_up_mm, lengths, run_ra_um })
}

/// Mean of the run's Ra over the marks along the line, um; none where the run gives no Ra.
fn mean_ra_um(surface: &Topography, line: &ProfileLine) -> Option<f64> {
    let [from_mm, to_mm] = math::extent([line.from_mm[0], line.to_mm[0]].into_iter());
    let marks = surface.marks();
    let first = marks.partition_point(|mark| mark.x_mm < from_mm).min(marks.len() - 1);
    let last = marks.partition_point(|mark| mark.x_mm <= to_mm).max(first + 1);
    let along = &marks[first..last];
    // Tooth by tooth the marks carry none.
    stats::mean(along.iter().map(|mark| mark.ra_um)).filter(|ra_um| *ra_um > 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::surface::topography::ToothMark;
    use crate::models::tool::Outline;

    /// 40 mm at 0.2 mm per tooth, from 0 on; the strip reaches from 2 to 28^0.5 mm.
    fn surface(ra_um: f64) -> (Topography, CutPath) {
        let mut surface = Topography::new(Outline::ball(8.0), 1);
        for k in 0..=200 {
            surface.push(ToothMark { x_mm: 0.2 * f64::from(k), z_mm: 0.0, ra_um });
        }
        (surface, CutPath::new(&[[40.0, 2.0, 2.0]]))
    }

    fn at(from_mm: [f64; 2], to_mm: [f64; 2], ra_um: f64) -> Result<Measurement, LineError> {
        let (surface, cut) = surface(ra_um);
        measure(&surface, &cut, &ProfileLine { from_mm, to_mm }, &ProfileSettings::default())
    }

    #[test]
    fn feed_marks_alone_have_their_closed_form_whichever_way_they_are_measured() {
        let there = at([10.0, 4.0], [16.0, 4.0], 0.0).unwrap();
        let back = at([16.0, 4.0], [10.0, 4.0], 0.0).unwrap();
        assert_eq!((there.lengths, there.run_ra_um), (5, None));
        // Ra = 4 h/(9 3^0.5), h = f^2/(8 r) on the circle that the ball has there, r^2 = 8^2 - 4^2;
        // of waves of 0.2 mm the filter takes a few parts in a thousand.
        let ra_um = 1000.0 * 0.2566 * 0.04 / (8.0 * 48.0_f64.sqrt());
        for found in [&there, &back] {
            let roughness = &found.roughness;
            assert!((roughness.ra_um / ra_um - 1.0).abs() < 0.01, "{}", roughness.ra_um);
            assert!(roughness.rq_um > roughness.ra_um && roughness.rz_um > roughness.rq_um);
        }
        // Along a slanting line the marks are as much farther apart.
        let slanting = at([10.0, 2.1], [16.0, 5.1], 0.0).unwrap();
        assert_eq!(slanting.lengths, 6);
    }

    #[test]
    fn what_cannot_be_measured_is_said_with_its_limits() {
        let said = |from, to| at(from, to, 0.8).unwrap_err().to_string();
        let short = said([10.0, 4.0], [12.4, 4.0]);
        assert!(short.contains("2.400 mm long") && short.contains("at least 2.405 mm"), "{short}");
        assert_eq!(at([10.0, 4.0], [12.405, 4.0], 0.8).unwrap().lengths, 1);
        let long = said([0.0, 4.0], [5000.0, 4.0]);
        assert!(long.contains("at most 149.6 mm"), "{long}");
        let wide = said([10.0, 4.0], [20.0, 6.0]);
        assert!(wide.contains("there y reaches from 2.000 to 5.292 mm"), "{wide}");
        let far = said([36.0, 4.0], [42.0, 4.0]);
        assert!(far.contains("x reaches from 0.000 to 40.000 mm so far"), "{far}");
        assert_eq!(at([f64::NAN, 4.0], [12.0, 4.0], 0.8), Err(LineError::NoNumber));
        assert!(at([1e300, 4.0], [-1e300, 4.0], 0.8).is_err());
        let (_, cut) = surface(0.8);
        let line = ProfileLine { from_mm: [0.0, 4.0], to_mm: [6.0, 4.0] };
        let none = measure(
            &Topography::new(Outline::ball(8.0), 1),
            &cut,
            &line,
            &ProfileSettings::default(),
        );
        assert_eq!(none, Err(LineError::NothingCut));
    }

    #[test]
    fn the_longest_line_is_measured_whatever_the_cut_offs() {
        for (short_um, long_mm) in [(0.5, 0.08), (25.0, 0.08), (0.5, 8.0), (2.5, 0.8)] {
            let settings = ProfileSettings { short_um, long_mm, ..ProfileSettings::default() };
            let [least, most] = allowed_mm(&settings);
            assert!(0.0 < least && least < most, "{least} {most}");
            let lengths =
                ((most - 2.0 * roughness_profile::run_up_mm(&settings)) / long_mm).round();
            let points = roughness_profile::points_over(&settings, lengths as usize);
            assert!((MOST_POINTS - 8001..=MOST_POINTS).contains(&points), "{points}");
        }
    }
}
