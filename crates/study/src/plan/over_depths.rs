//! A plan at all depths of its part. The search judges one depth by its network; the part may have others, and the
//! run may take its force from another model. So the planned feed and speed are judged at every depth, by both: by
//! the network with all constraints, and by a short steady cut of the run's plant at constant feed, without noise and
//! without the machine's vibration.

use serde::Serialize;

use super::constraints::Checked;
use super::machine::MachineLimits;
use super::optimum::Optimum;
use super::problem::{LEAST_DEPTH_MM, Problem};
use crate::base::equation::number;
use crate::base::language::{fixed, tr};
use crate::base::stats;
use crate::base::units::{percent_from_ratio, ratio_from_percent};
use crate::blocks::cutting::tool_path::{Engagement, radial_depth_mm, wall_mm};
use crate::blocks::reference::Reference;
use crate::experiment::measure::steady;
use crate::run::edits::Edits;
use crate::run::one_run::Run;
use crate::run::scenario::Scenario;
use crate::run::signals::{Row, flag};
use crate::run::story::deviation;

/// The steady part of the cut begins here, s (chosen): some ten turns at 800 1/min.
const STEADY_S: f64 = 0.5;
/// Most depths that are judged: the deepest ones and the shallowest (chosen).
const MOST: usize = 16;
/// Depths nearer to each other are one, mm.
const SAME_MM: f64 = 1e-6;

steadycut_core::choice! {
    /// Where what is to be held, Ra or the force, lies in a cut of the run.
    pub enum HeldInRun {
        /// In its tolerance.
        Within = "in_tolerance", "in tolerance";
        /// Above its tolerance.
        Above = "above_tolerance", "above its tolerance";
        /// Below its tolerance.
        Below = "below_tolerance", "below its tolerance";
        /// The model of Ra has ended.
        NotJudged = "not_judged", "not judged, outside the model";
    }
}

/// A steady cut of the run's plant.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct CutInRun {
    /// Its force, N.
    pub force_n: f64,
    /// How much that is above the network's, percent of this; negative below.
    pub above_plan_percent: f64,
    /// Its Ra, um; none where the model of Ra has ended.
    pub ra_um: Option<f64>,
    /// Where what is to be held lies.
    pub held: HeldInRun,
}

/// The planned feed and speed at one depth.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AtDepth {
    /// Axial depth, mm.
    pub axial_depth_mm: f64,
    /// Radial depth, mm.
    pub radial_depth_mm: f64,
    /// Whether it is the depth that was planned for.
    pub is_planned: bool,
    /// The force by the plan's network, N.
    pub force_n: f64,
    /// Whether the network knows this cut; otherwise its force is continued.
    pub inside_training_data: bool,
    /// The constraints that are violated there.
    pub violated: Vec<Checked>,
    /// The same cut by the run's plant; none where that makes no force.
    pub run: Option<CutInRun>,
}

/// See the head of this file.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OverDepths {
    /// What is to be held in the run.
    #[serde(skip)]
    reference: Reference,
    /// The depths of the part and the planned one, the deepest first.
    pub depths: Vec<AtDepth>,
    /// Depths between the last two that are not judged, for there are too many.
    pub left_out: usize,
    /// Whether the part has the planned depth.
    pub part_has_planned: bool,
}

/// Axial and radial depths in mm that the part is cut at, the deepest first.
fn depths_of(scenario: &Scenario) -> Vec<[f64; 2]> {
    let (workpiece, outline) = (&scenario.workpiece, scenario.tool.outline());
    let mut depths: Vec<[f64; 2]> = if workpiece.cuts.is_empty() {
        let [axial_mm, radial_mm] = [workpiece.axial_depth_mm, workpiece.radial_depth_mm];
        let wall = wall_mm(&outline, axial_mm, radial_mm);
        // Formulas and networks take the radial depth as it is set; the teeth meet a wall that stays.
        let by_teeth = scenario.plant.force_model.tooth_by_tooth();
        let has_walls = by_teeth && workpiece.radial_steps.is_empty();
        let radial =
            |axial, set| if has_walls { radial_depth_mm(&outline, axial, wall) } else { set };
        let places = workpiece.places_mm().into_iter();
        places.map(|[axial, set]| [axial, radial(axial, set)]).collect()
    } else {
        let sections = workpiece.cuts.iter().flatten();
        let places =
            sections.map(|[_, axial, wall]| Engagement::in_section(&outline, [*axial, *wall]));
        places.map(|place| [place.axial_depth_mm, place.radial_depth_mm]).collect()
    };
    depths.retain(|depths| depths.iter().all(|depth| *depth >= LEAST_DEPTH_MM));
    depths
}

fn same(a: [f64; 2], b: [f64; 2]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < SAME_MM)
}

impl OverDepths {
    /// A plan's answer for a scenario on a machine, at all depths of the part.
    #[must_use]
    pub fn of(scenario: &Scenario, machine: &MachineLimits, optimum: &Optimum) -> Self {
        let planned = [optimum.axial_depth_mm, optimum.radial_depth_mm];
        let mut depths = depths_of(scenario);
        let part_has_planned = depths.iter().any(|depth| same(*depth, planned));
        depths.push(planned);
        depths.sort_by(|a, b| b[0].total_cmp(&a[0]).then(b[1].total_cmp(&a[1])));
        depths.dedup_by(|a, b| same(*a, *b));
        let left_out = depths.len().saturating_sub(MOST);
        if left_out > 0 {
            let shallowest = depths.pop();
            depths.truncate(MOST - 1);
            depths.extend(shallowest);
        }
        let at = |depth: &[f64; 2]| AtDepth::of(scenario, machine, optimum, *depth);
        let depths = depths.iter().filter_map(at).collect();
        Self { reference: scenario.target.reference, depths, left_out, part_has_planned }
    }
}

impl AtDepth {
    /// That at an axial and a radial depth in mm; none where nothing can be planned.
    fn of(
        scenario: &Scenario,
        machine: &MachineLimits,
        optimum: &Optimum,
        depths_mm: [f64; 2],
    ) -> Option<Self> {
        let problem = Problem::at_depths(scenario, machine, depths_mm).ok()?;
        let point = [optimum.cutting_speed_m_min, optimum.feed_per_tooth_mm];
        let here = Optimum::at(&problem, point);
        let run = CutInRun::of(scenario, &here);
        let [axial_depth_mm, radial_depth_mm] = depths_mm;
        Some(Self {
            axial_depth_mm,
            radial_depth_mm,
            is_planned: same(depths_mm, [optimum.axial_depth_mm, optimum.radial_depth_mm]),
            force_n: here.force_n,
            inside_training_data: here.inside_training_data,
            violated: here.constraints.into_iter().filter(|one| one.violation > 0.0).collect(),
            run,
        })
    }

    /// Whether the constraints are kept and what is to be held is in its tolerance.
    #[must_use]
    pub fn is_good(&self) -> bool {
        self.violated.is_empty() && self.run.is_some_and(|run| run.held == HeldInRun::Within)
    }

    /// Whether a constraint is violated or what is to be held is above its tolerance.
    #[must_use]
    pub fn is_bad(&self) -> bool {
        !self.violated.is_empty() || self.run.is_some_and(|run| run.held == HeldInRun::Above)
    }
}

impl CutInRun {
    /// The cut at a cutting speed in m/min and a feed per tooth in mm, at the depths that a plan is made for, by the
    /// plant of a scenario's run; none where that makes no force.
    #[must_use]
    pub fn at(scenario: &Scenario, problem: &Problem, point: [f64; 2]) -> Option<Self> {
        Self::of(scenario, &Optimum::at(problem, point))
    }

    /// The cut of a planned feed and speed at its depths by the run's plant.
    fn of(scenario: &Scenario, planned: &Optimum) -> Option<Self> {
        let cut = steady(scenario).ok()?.with(|s| {
            s.program.feed_mm_min = planned.feed_mm_min;
            s.program.spindle_rpm = planned.speed_rpm;
            s.controller.constant_feed = Default::default();
            s.workpiece.axial_depth_mm = planned.axial_depth_mm;
            s.workpiece.radial_depth_mm = planned.radial_depth_mm;
            s.workpiece.radial_steps.clear();
            s.noise.level = 0.0;
            s.machine.coupled = false;
        });
        let run = Run::complete(&cut.ok()?, &Edits::none());
        let recording = run.recording();
        let rows = recording.rows().iter().skip(recording.index_at(STEADY_S));
        let in_cut: Vec<&Row> = rows.filter(|row| !row.has(flag::AIR)).collect();
        let mean =
            |of: &dyn Fn(&Row) -> Option<f64>| stats::mean(in_cut.iter().filter_map(|row| of(row)));
        let force_n = mean(&|row| Some(row.force_n)).filter(|force_n| *force_n > 0.0)?;
        let target = &scenario.target;
        let judged = |row: &Row| deviation(row, Reference::Ra).map(|_| row.ra_um);
        let off = mean(&|row| deviation(row, target.reference));
        let tolerance = ratio_from_percent(target.tolerance_percent);
        Some(Self {
            force_n,
            above_plan_percent: percent_from_ratio(force_n / planned.force_n - 1.0),
            ra_um: mean(&judged),
            held: match off {
                None => HeldInRun::NotJudged,
                Some(off) if off > tolerance => HeldInRun::Above,
                Some(off) if off < -tolerance => HeldInRun::Below,
                Some(_) => HeldInRun::Within,
            },
        })
    }

    /// Where what is to be held, `reference`, lies, in words.
    #[must_use]
    pub fn held_text(&self, reference: Reference) -> String {
        let name = match reference {
            Reference::Ra => "Ra",
            Reference::Force => tr("force"),
        };
        let held = match self.held {
            HeldInRun::Within => tr("in tolerance"),
            HeldInRun::Above => tr("above its tolerance"),
            HeldInRun::Below => tr("below its tolerance"),
            HeldInRun::NotJudged => tr("not judged, outside the model"),
        };
        match self.ra_um {
            Some(ra_um) if reference == Reference::Ra => {
                format!("Ra {} µm, {held}", fixed(ra_um, 2))
            }
            Some(_) | None => format!("{name} {held}"),
        }
    }
}

impl OverDepths {
    /// Whether the plan is good at every depth: allowed by the network, and in tolerance in the run.
    #[must_use]
    pub fn is_good(&self) -> bool {
        self.left_out == 0 && self.depths.iter().all(AtDepth::is_good)
    }

    /// The force by the network at an axial depth in mm that only one cut of the part has, N.
    #[must_use]
    pub fn force_at_n(&self, axial_depth_mm: f64) -> Option<f64> {
        let here = |at: &&AtDepth| (at.axial_depth_mm - axial_depth_mm).abs() < SAME_MM;
        let mut here = self.depths.iter().filter(here);
        here.next().filter(|_| here.next().is_none()).map(|at| at.force_n)
    }

    /// An optimum's verdict with that at the other depths of the part, in the chosen language.
    #[must_use]
    pub fn verdict_text(&self, optimum: &Optimum) -> String {
        let told = optimum.verdict_text();
        if !optimum.feasible {
            return told;
        }
        let others = || self.depths.iter().filter(|at| !at.is_planned);
        let broken: Vec<String> =
            others().filter(|at| !at.violated.is_empty()).map(|at| self.broken_text(at)).collect();
        let told = match (broken.is_empty(), others().next().is_some()) {
            (false, _) => {
                tr!("{verdict}; not {places}", verdict = told, places = broken.join(", "))
            }
            (true, true) => tr!("{verdict}; at the part's other depths too", verdict = told),
            (true, false) => told,
        };
        match self.part_has_planned {
            true => told,
            false => tr!("{verdict}; the part has no such depth", verdict = told),
        }
    }

    /// A depth with the constraints that it breaks.
    fn broken_text(&self, at: &AtDepth) -> String {
        let broken = at.violated.iter().map(|one| {
            let (value, unit) = (number(one.value), one.constraint.unit);
            format!("{} {value} {unit}", tr(one.constraint.label))
        });
        let broken: Vec<String> = broken.collect();
        tr!("at {depth}: {broken}", depth = self.place_text(at), broken = broken.join(", "))
    }

    /// The depth, with the radial one where that differs as well.
    fn place_text(&self, at: &AtDepth) -> String {
        let radial_mm = self.depths.first().map_or(0.0, |first| first.radial_depth_mm);
        let several = self.depths.iter().any(|at| (at.radial_depth_mm - radial_mm).abs() > SAME_MM);
        match several {
            true => {
                format!("{} x {} mm", fixed(at.axial_depth_mm, 2), fixed(at.radial_depth_mm, 2))
            }
            false => format!("{} mm", fixed(at.axial_depth_mm, 2)),
        }
    }

    /// A line for every depth: the force by the network, and that of the run with what it comes to.
    #[must_use]
    pub fn lines(&self) -> Vec<String> {
        self.depths.iter().map(|at| self.line(at)).collect()
    }

    fn line(&self, at: &AtDepth) -> String {
        let depth = self.place_text(at);
        let plan_n = fixed(at.force_n, 1);
        let told = match &at.run {
            None => tr!(
                "{depth}: {plan} N by the network, no force in the run",
                depth = depth,
                plan = plan_n
            ),
            Some(run) => tr!(
                "{depth}: {plan} N by the network, {run} N in the run ({more:+.0} %), {held}",
                depth = depth,
                plan = plan_n,
                run = fixed(run.force_n, 1),
                more = run.above_plan_percent,
                held = run.held_text(self.reference),
            ),
        };
        let names: Vec<&str> = at.violated.iter().map(|one| tr(one.constraint.label)).collect();
        let mut told = told;
        if !names.is_empty() {
            told += &tr!("; violated: {names}", names = names.join(", "));
        }
        if !at.inside_training_data {
            told += tr("; outside the network's training data");
        }
        told
    }

    /// What stands above the lines.
    #[must_use]
    pub fn title(&self) -> String {
        match self.left_out {
            0 => tr("At this feed, kept constant, without noise and vibration").to_owned(),
            n => tr!(
                "At this feed, kept constant, without noise and vibration; {n} depths between are not judged",
                n = n
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::settings::Value;
    use crate::blocks::control::ControllerKind;
    use crate::models::plan::PlannedSection;
    use crate::plan::PlanJob;
    use crate::run::metrics::HELD_PERCENT;
    use crate::run::presets::load;

    fn over(scenario: &Scenario) -> (Optimum, OverDepths) {
        let optimum = PlanJob::complete(scenario).unwrap().optimum();
        let over = OverDepths::of(scenario, &MachineLimits::heller_bea_01(), &optimum);
        (optimum, over)
    }

    /// What the plan says of each depth is what the console shows when it is cut.
    #[test]
    fn every_depth_is_judged_as_the_run_of_the_plan_comes_out() {
        for name in ["first-cut", "strategy-2013", "depth-step"] {
            let scenario = load(name).unwrap();
            let (optimum, over) = over(&scenario);
            let cut = optimum.apply(&scenario).unwrap();
            let cut = cut.with(|s| {
                s.controller.kind = ControllerKind::ConstantFeed;
                s.noise.level = 0.0;
                s.run.duration_s = 600.0;
            });
            let run = Run::complete(&cut.unwrap(), &Edits::none());
            let metrics = run.metrics();
            let held = metrics.in_tolerance_percent.is_some_and(|share| share >= HELD_PERCENT);
            let all = over.depths.iter().all(|at| at.run.unwrap().held == HeldInRun::Within);
            assert_eq!(all, held, "{name}: {:?}", over.lines());
            for at in &over.depths {
                let mut rows =
                    run.recording().rows().iter().filter(|row| {
                        row.axial_depth_mm == at.axial_depth_mm && !row.has(flag::AIR)
                    });
                let last = rows.next_back().unwrap_or_else(|| panic!("{name}: {at:?}"));
                let in_run = at.run.unwrap();
                assert!((last.force_n / in_run.force_n - 1.0).abs() < 1e-6, "{name}: {at:?}");
                let above = 100.0 * (in_run.force_n / at.force_n - 1.0);
                assert!((in_run.above_plan_percent - above).abs() < 1e-9);
                assert_eq!(last.ra_has_ended(), in_run.held == HeldInRun::NotJudged, "{name}");
            }
            assert!(over.depths.iter().any(|at| at.is_planned && at.force_n == optimum.force_n));
        }
    }

    /// Anywhere on the map the run's force is told beside the network's: at the programmed cut of the first scenario
    /// they lie far apart.
    #[test]
    fn a_place_of_the_map_is_cut_by_the_run_as_the_optimum_is() {
        let scenario = load("first-cut").unwrap();
        let (optimum, over) = over(&scenario);
        let problem = PlanJob::new(&scenario).unwrap().problem().clone();
        let point = [optimum.cutting_speed_m_min, optimum.feed_per_tooth_mm];
        let at = CutInRun::at(&scenario, &problem, point);
        let planned = over.depths.iter().find(|at| at.is_planned).unwrap();
        assert_eq!(at, planned.run);
        let half = CutInRun::at(&scenario, &problem, [point[0], 0.5 * point[1]]).unwrap();
        assert!(half.force_n < at.unwrap().force_n, "{half:?}");
        let off = 100.0 * (half.force_n / problem.cut([point[0], 0.5 * point[1]]).force_n - 1.0);
        assert!((half.above_plan_percent - off).abs() < 1e-9);
    }

    /// A plan for the lightest stretch is not feasible in the others: the verdict says where, and what breaks it.
    #[test]
    fn the_depth_and_the_constraint_that_break_a_plan_are_named() {
        let mut scenario = load("first-cut").unwrap();
        let (optimum, heaviest) = over(&scenario);
        assert!(heaviest.depths.iter().all(|at| at.violated.is_empty()));
        let told = heaviest.verdict_text(&optimum);
        assert!(told.starts_with("feasible at 2.2 mm depth by the plan's network"), "{told}");
        assert!(told.ends_with("; at the part's other depths too"), "{told}");
        scenario
            .set("plan.section", Value::Text(PlannedSection::Lightest.id().to_owned()))
            .unwrap();
        let (optimum, lightest) = over(&scenario);
        let told = lightest.verdict_text(&optimum);
        assert!(optimum.feasible && told.starts_with("feasible at 1.9 mm depth"), "{told}");
        assert!(told.contains("; not at 2.20 mm: Cutting force "), "{told}");
        assert!(told.contains(", at 2.00 mm: Cutting force "), "{told}");
        assert!(!lightest.is_good());
        assert!(lightest.lines()[0].contains("violated: Cutting force"), "{:?}", lightest.lines());
    }

    /// A part of cuts has other depths than the one that is planned for: it is said.
    #[test]
    fn sections_of_a_part_are_judged_each() {
        let scenario = load("experiment-2").unwrap();
        let (optimum, over) = over(&scenario);
        assert!(over.depths.len() > 4 && !over.part_has_planned, "{over:?}");
        assert!(over.verdict_text(&optimum).contains("the part has no such depth"));
        assert!(over.lines()[0].starts_with("4.75 x "), "{:?}", over.lines());
        assert!(over.depths.windows(2).all(|two| two[0].axial_depth_mm >= two[1].axial_depth_mm));
    }

    #[test]
    fn of_many_depths_the_deepest_and_the_shallowest_are_judged_and_the_rest_is_counted() {
        let steps =
            (1..40).map(|k| [f64::from(k) * 5.0, 1.0 + 0.02 * f64::from(k)]).collect::<Vec<_>>();
        let scenario = load("first-cut").unwrap().with(|s| s.workpiece.depth_steps = steps.clone());
        let Ok(scenario) = scenario else { return };
        let (_, over) = over(&scenario);
        assert_eq!(over.depths.len(), MOST);
        assert!(over.left_out > 20 && over.title().contains("are not judged"));
        assert_eq!(over.depths.last().map(|at| at.axial_depth_mm), Some(1.02));
    }
}
