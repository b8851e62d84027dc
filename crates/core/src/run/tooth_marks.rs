//! The marks that the teeth of a run leave on its part, cut by cut: from the recorded rows to the
//! surface ([`crate::blocks::surface::topography`]).
//!
//! A tooth comes past whenever the spindle has turned on by a tooth; between two rows place and turn
//! are taken as even. Teeth that turn in the air leave nothing. Simulated tooth by tooth, the surface
//! is what run-out makes of the feed marks: K5 does not hold there, and no texture is added.

use super::scenario::Scenario;
use super::signals::{Row, flag};
use crate::base::units::{mm_from_um, rev_s_from_rpm};
use crate::blocks::cutting::breakage::Breakage;
use crate::blocks::cutting::tool_path::ToolPath;
use crate::blocks::surface::profile::Passing;
use crate::blocks::surface::topography::{ToothMark, Topography};
use crate::models::disturbances::Disturbances;
use crate::models::part::APPROACH_MM;
use crate::models::structure::RoughnessFrom;
use crate::models::tool::runout_share;

/// A straight cut of the part.
#[derive(Clone, Debug)]
pub struct MarkedCut {
    /// Where along the whole way its part begins, mm.
    pub begins_mm: f64,
    /// Length of the part along it, mm.
    pub length_mm: f64,
    /// Its surface; x counts from where the part begins.
    pub surface: Topography,
}

/// The part with the surface of a run, as far as it has come.
#[derive(Clone, Debug)]
pub struct MarkedPart {
    cuts: Vec<MarkedCut>,
    cut: usize,
    teeth: u32,
    /// How far the axis is shifted towards tooth 0, mm.
    runout_mm: f64,
    by_teeth: bool,
    /// Whether vibration makes Ra with dynamics, and its share that is normal to the surface.
    vibrates: bool,
    vibrating: f64,
    passing: Passing,
    rows: usize,
    /// Where along the way teeth break, mm.
    broken_mm: Vec<f64>,
}

impl MarkedPart {
    /// The part before the first tooth.
    #[must_use]
    pub fn new(scenario: &Scenario) -> Self {
        let tool = &scenario.tool;
        let workpiece = &scenario.workpiece;
        let cut = |begins_mm: f64, length_mm: f64| MarkedCut {
            begins_mm,
            length_mm,
            surface: Topography::new(tool.outline(), scenario.run.seed),
        };
        let lengths = workpiece.cuts.iter().map(|cut| cut.iter().map(|section| section[0]).sum());
        let begins = ToolPath::begins_of(workpiece).into_iter().map(|way_mm| way_mm + APPROACH_MM);
        let mut cuts: Vec<MarkedCut> =
            begins.zip(lengths).map(|(at, long)| cut(at, long)).collect();
        if cuts.is_empty() {
            cuts.push(cut(0.0, workpiece.length_mm));
        }
        let by_teeth = scenario.plant.force_model.tooth_by_tooth();
        Self {
            cuts,
            cut: 0,
            teeth: tool.teeth,
            runout_mm: if by_teeth { mm_from_um(tool.runout_um) } else { 0.0 },
            by_teeth,
            vibrates: scenario.machine.coupled
                && scenario.machine.roughness_from == RoughnessFrom::Vibration,
            vibrating: scenario.profile.normal_share,
            passing: Passing::default(),
            rows: 0,
            broken_mm: Vec::new(),
        }
        .disturbed(&scenario.disturbances, &[])
    }

    /// The same with the disturbances that edits have brought and with the teeth that broke under their load: a broken
    /// tooth leaves no mark.
    #[must_use]
    pub fn disturbed(self, disturbances: &Disturbances, breakages: &[Breakage]) -> Self {
        let placed = disturbances.broken_teeth.zones().iter().map(|zone| zone.at_mm);
        let broken_mm = placed.chain(breakages.iter().map(|broke| broke.position_mm)).collect();
        Self { broken_mm, ..self }
    }

    /// Goes on to the last of `rows`, all rows of the run from its start.
    pub fn extend(&mut self, rows: &[Row]) {
        for pair in rows[self.rows.saturating_sub(1).min(rows.len())..].windows(2) {
            self.between(&pair[0], &pair[1]);
        }
        self.rows = self.rows.max(rows.len());
    }

    /// The teeth that come past between two rows.
    fn between(&mut self, from: &Row, to: &Row) {
        let turned =
            rev_s_from_rpm(to.spindle_rpm) * (to.time_s - from.time_s) * f64::from(self.teeth);
        if self.cut + 1 < self.cuts.len() {
            let next_mm = self.cuts[self.cut + 1].begins_mm;
            self.cut += usize::from(to.position_mm >= next_mm - APPROACH_MM);
        }
        let cut = &mut self.cuts[self.cut];
        // Vibration is in the marks themselves; without it, Ra with dynamics is used.
        let ra_um = if self.vibrates { to.ra_um } else { to.ra_dyn_um };
        self.passing.advance(turned, |tooth, fraction| {
            if to.has(flag::AIR) {
                return;
            }
            let position_mm = from.position_mm + fraction * (to.position_mm - from.position_mm);
            let teeth = self.teeth as usize;
            let tooth = (tooth % u64::from(self.teeth)) as usize;
            let broken = self.broken_mm.iter().filter(|at_mm| position_mm >= **at_mm);
            if tooth < broken.count() {
                return;
            }
            let back_mm = -self.runout_mm * runout_share(tooth, teeth);
            cut.surface.push(ToothMark {
                x_mm: position_mm - cut.begins_mm,
                z_mm: back_mm + self.vibrating * mm_from_um(to.vibration_um),
                ra_um: if self.by_teeth { 0.0 } else { ra_um },
            });
        });
    }

    /// The cuts.
    #[must_use]
    pub fn cuts(&self) -> &[MarkedCut] {
        &self.cuts
    }

    /// Number of the cut under the tool.
    #[must_use]
    pub fn cut(&self) -> usize {
        self.cut
    }

    /// Turns of the spindle so far.
    #[must_use]
    pub fn turns(&self) -> f64 {
        self.passing.teeth() / f64::from(self.teeth)
    }

    /// Rows taken in so far.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::edits::Edits;
    use crate::run::one_run::Run;
    use crate::run::presets::load;

    #[test]
    fn marks_stand_a_feed_per_tooth_apart_and_pieces_change_nothing() {
        let scenario = load("table3-5").unwrap();
        let run = Run::complete(&scenario, &Edits::none());
        let rows = run.recording().rows();
        let mut whole = MarkedPart::new(&scenario);
        whole.extend(rows);
        let marks = whole.cuts()[0].surface.marks();
        let last = rows.last().unwrap();
        let feed_mm = last.feed_mm_min / last.spindle_rpm / 2.0;
        let [.., a, b] = marks else { panic!("{} marks", marks.len()) };
        assert!(((b.x_mm - a.x_mm) / feed_mm - 1.0).abs() < 1e-3, "{a:?} {b:?} {feed_mm}");
        let mut pieces = MarkedPart::new(&scenario);
        for end in (0..rows.len()).step_by(777).chain([rows.len()]) {
            pieces.extend(&rows[..end]);
        }
        assert_eq!(pieces.cuts()[0].surface.marks(), marks);
    }

    #[test]
    fn every_cut_of_experiment_2_is_marked_over_its_length() {
        let mut scenario = load("experiment-2").unwrap();
        scenario.change(|s| s.run.duration_s = 60.0).unwrap();
        let run = Run::complete(&scenario, &Edits::none());
        let mut marks = MarkedPart::new(&scenario);
        marks.extend(run.recording().rows());
        assert!(marks.cut() >= 2, "cut {}", marks.cut());
        for cut in &marks.cuts()[..2] {
            let [from, to] = cut.surface.range_mm().unwrap();
            // It meets the material before its axis is there, and leaves it at the end.
            assert!(from > -APPROACH_MM && from < 0.0, "{from}");
            assert!((to - cut.length_mm).abs() < 0.5, "{to} of {}", cut.length_mm);
        }
    }
}
