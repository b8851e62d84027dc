//! Adaptive feed control over whole runs: teach-in, which finds the reference force of each cut, and the log
//! of a run, cut by cut. Both are read from what a run records.
//!
//! ```
//! use steadycut_core::run::{job::Job, presets};
//! use steadycut_study::afc::{TeachIn, Teaching};
//!
//! let mut teach_in = TeachIn::new(&presets::load("table3-5").unwrap());
//! teach_in.to_end();
//! let Teaching::Taught { references_n, .. } = teach_in.partial() else { panic!("it can be cut") };
//! assert_eq!(references_n.len(), 1, "one path has one reference");
//! ```

use serde::Serialize;

use crate::base::language::tr;
use crate::base::settings::{SettingError, Value};
use crate::base::units::percent_from_ratio;
use crate::blocks::control::ControllerKind;
use crate::blocks::cutting::tool_path::ToolPath;
use crate::blocks::cutting::workpiece::Workpiece;
use crate::export::sheet::{Entry, Sheet};
use crate::run::edits::Edits;
use crate::run::end::End;
use crate::run::job::{Budget, Job, Progress};
use crate::run::one_run::Run;
use crate::run::recording::Recording;
use crate::run::scenario::Scenario;
use crate::run::signals::{Row, flag};

/// The setting that teach-in finds.
pub const REFERENCES: &str = "controller.afc.references_n";

/// How far a teach-in is.
#[derive(Clone, Debug, PartialEq)]
pub enum Teaching {
    /// It is being cut.
    UnderWay,
    /// It is cut.
    Taught {
        /// Peak force of each cut, N.
        references_n: Vec<f64>,
        /// Whether the part was cut to its end; the time limit may have come first.
        whole: bool,
    },
    /// No references come of it, and why.
    NotTaught(String),
}

/// The teach-in cut: the whole part at the programmed feed.
#[derive(Clone, Debug)]
pub struct TeachIn {
    run: Run,
}

impl TeachIn {
    /// The teach-in cut of a scenario, not yet begun. Changes during the cut do not belong to it.
    ///
    /// # Panics
    /// Never: no rule refuses a controller, or a row for every control period.
    #[must_use]
    pub fn new(scenario: &Scenario) -> Self {
        let untaught = scenario.with(|settings| {
            settings.controller.kind = ControllerKind::Afc;
            settings.controller.afc.references_n = Vec::new();
            settings.run.record_every = settings.run.steps_per_control;
        });
        let untaught = untaught.expect("AFC, and a row a control period, go with any scenario");
        Self { run: Run::new(&untaught, &Edits::none()) }
    }

    fn found(&self) -> Teaching {
        let Some(end) = self.run.end() else { return Teaching::UnderWay };
        let whole = match end {
            End::PathDone => true,
            End::TimeLimit => false,
            End::Overload(_)
            | End::Crash(_)
            | End::Breakage(_)
            | End::Fault(_)
            | End::Refused(_)
            | End::Script(_) => {
                return Teaching::NotTaught(end.to_string());
            }
        };
        let (scenario, recording) = (self.run.scenario(), self.run.recording());
        let visits = visits(&scenario.workpiece, recording, recording.rows().len());
        let mut references_n = Vec::with_capacity(visits.len());
        for (number, visit) in (1..).zip(&visits) {
            let peak_n = visit.peak_n;
            if !visit.begun {
                let limit_s = scenario.run.duration_s;
                return Teaching::NotTaught(tr!(
                    "cut {number} is not reached within `run.duration_s`, {limit} s",
                    number = number,
                    limit = limit_s
                ));
            }
            if let Err(refused) = Scenario::accepts(REFERENCES, &Value::from(vec![peak_n])) {
                return Teaching::NotTaught(tr!(
                    "cut {number}: {refused}",
                    number = number,
                    refused = refused.to_string()
                ));
            }
            references_n.push(peak_n);
        }
        Teaching::Taught { references_n, whole }
    }
}

/// A step is one of the plant.
impl Job for TeachIn {
    type Partial = Teaching;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        Job::advance(&mut self.run, budget)
    }

    fn progress(&self) -> Progress {
        self.run.progress()
    }

    fn partial(&self) -> Teaching {
        self.found()
    }
}

/// The scenario under AFC with these references.
///
/// # Errors
/// The references are not allowed.
pub fn taught(scenario: &Scenario, references_n: &[f64]) -> Result<Scenario, SettingError> {
    let mut taught = scenario.clone();
    taught.set_all(&[
        ("controller.kind".to_owned(), Value::Text(ControllerKind::Afc.id().to_owned())),
        (REFERENCES.to_owned(), Value::from(references_n.to_vec())),
    ])?;
    Ok(taught)
}

/// What a run did in a cut.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Visit {
    /// Whether the tool has come to it, and through it.
    begun: bool,
    done: bool,
    time_s: f64,
    peak_n: f64,
    least_percent: f64,
    overload: bool,
}

/// What the first `rows` rows of a recording show of each cut.
fn visits(workpiece: &Workpiece, recording: &Recording, rows: usize) -> Vec<Visit> {
    let mut begins_mm = ToolPath::begins_of(workpiece);
    if begins_mm.is_empty() {
        begins_mm.push(0.0);
    }
    let all = &recording.rows()[..rows];
    let ends_mm = begins_mm.iter().skip(1).copied().chain([ToolPath::length_of(workpiece)]);
    let mut visits: Vec<Visit> = begins_mm
        .iter()
        .zip(ends_mm)
        .map(|(begin_mm, end_mm)| {
            // The row that ends a cut stands where the next one begins.
            let at = |place_mm: f64| all.partition_point(|row| row.position_mm < place_mm);
            let (first, past) = (at(*begin_mm), at(end_mm));
            let time_s = |index: usize| all.get(index).or(all.last()).map_or(0.0, |row| row.time_s);
            Visit {
                begun: first < all.len(),
                done: past < all.len(),
                time_s: time_s(past) - time_s(first),
                peak_n: 0.0,
                least_percent: f64::INFINITY,
                overload: false,
            }
        })
        .collect();
    // What a row holds was read a control period before: in the cut in which the tool was then. A run may
    // end within a period.
    let (mut read_mm, mut read_s) = (0.0, 0.0);
    let mut take = |row: &Row, read_mm: f64| {
        let cut = begins_mm.partition_point(|begin_mm| *begin_mm <= read_mm).saturating_sub(1);
        let visit = &mut visits[cut];
        visit.peak_n = visit.peak_n.max(row.force_measured_n);
        visit.least_percent = visit.least_percent.min(row.feed_override_percent);
        visit.overload |= row.has(flag::OVER_LIMIT);
    };
    for row in recording.samples(rows).skip(1) {
        take(row, read_mm);
        (read_mm, read_s) = (row.position_mm, row.time_s);
    }
    if let Some(last) = all.last().filter(|last| last.time_s > read_s) {
        take(last, read_mm);
    }
    visits
}

/// A line of the log of AFC: one cut of the part.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct AfcCut {
    /// Its number, from 1.
    pub cut: usize,
    /// Its reference force, N; none where it is taught in.
    pub reference_n: Option<f64>,
    /// Time that the cut takes at the programmed feed, s; none before that is known.
    pub teach_in_s: Option<f64>,
    /// Time that it took, s; none before it is done.
    pub control_s: Option<f64>,
    /// By how much that is longer than the teach-in, percent.
    pub difference_percent: Option<f64>,
    /// Largest measured force, N; none before the cut is begun.
    pub peak_n: Option<f64>,
    /// Least feed that was sent, percent of the programmed one; none before the cut is begun.
    pub least_factor_percent: Option<f64>,
    /// Whether the force has been over its limit for too long.
    pub overload: bool,
}

/// A recording as far as it is looked at: its first so many rows.
#[derive(Clone, Copy, Debug)]
pub struct Recorded<'a> {
    /// The recording.
    pub recording: &'a Recording,
    /// How many of its rows.
    pub rows: usize,
}

impl<'a> Recorded<'a> {
    /// All of it.
    #[must_use]
    pub fn all(run: &'a Run) -> Self {
        Self { recording: run.recording(), rows: run.recording().rows().len() }
    }
}

/// The log of a run of `scenario`, beside the same part at the programmed feed: what teach-in takes, since the
/// time of a cut at a given feed depends on no force.
#[must_use]
pub fn log(scenario: &Scenario, control: Recorded<'_>, constant: Recorded<'_>) -> Vec<AfcCut> {
    let of =
        |recorded: Recorded<'_>| visits(&scenario.workpiece, recorded.recording, recorded.rows);
    let lines = (1..).zip(of(control)).zip(of(constant)).map(|((cut, control), constant)| {
        let teach_in_s = constant.done.then_some(constant.time_s);
        let control_s = control.done.then_some(control.time_s);
        let seen = |value: f64| (control.begun && value.is_finite()).then_some(value);
        AfcCut {
            cut,
            reference_n: scenario.controller.afc.reference_n(cut - 1),
            teach_in_s,
            control_s,
            difference_percent: difference(teach_in_s, control_s),
            peak_n: seen(control.peak_n),
            least_factor_percent: seen(control.least_percent),
            overload: control.overload,
        }
    });
    lines.collect()
}

fn difference(teach_in_s: Option<f64>, control_s: Option<f64>) -> Option<f64> {
    Some(percent_from_ratio(control_s? / teach_in_s? - 1.0))
}

/// All cuts together: times at teach-in and under control, s, and their difference in percent; none while a
/// cut is not done.
#[must_use]
pub fn sum(cuts: &[AfcCut]) -> Option<[f64; 3]> {
    let teach_in_s: f64 = cuts.iter().map(|cut| cut.teach_in_s).sum::<Option<f64>>()?;
    let control_s: f64 = cuts.iter().map(|cut| cut.control_s).sum::<Option<f64>>()?;
    Some([teach_in_s, control_s, difference(Some(teach_in_s), Some(control_s))?])
}

/// The log as a table.
#[must_use]
pub fn sheet(cuts: &[AfcCut]) -> Sheet {
    let mut sheet = Sheet::new([
        "Cut",
        "Reference [N]",
        "Teach-in [s]",
        "Control [s]",
        "Difference [%]",
        "Peak force [N]",
        "Least feed [%]",
        "Overload",
    ]);
    for cut in cuts {
        sheet.row([
            Entry::Number(cut.cut as f64),
            cut.reference_n.into(),
            cut.teach_in_s.into(),
            cut.control_s.into(),
            cut.difference_percent.into(),
            cut.peak_n.into(),
            cut.least_factor_percent.into(),
            if cut.overload { "yes" } else { "no" }.into(),
        ]);
    }
    sheet
}
