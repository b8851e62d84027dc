//! Named values of a mission: what a condition can read beside the metrics of the learner's cut.

use crate::base::stats;
use crate::blocks::control::ControllerKind;
use crate::run::end::EndId;
use crate::run::one_run::Run;
use crate::run::signals::{Row, SignalInfo};

/// A value that is read from a run, from the settings, or from what the learner did.
#[derive(Clone, Debug, PartialEq)]
pub enum MissionValue {
    /// A metric of a run, by its id.
    Metric(String, RunOf),
    /// A signal in a part of a run.
    Signal {
        /// The signal's id.
        signal: &'static str,
        /// Of which run.
        run: RunOf,
        /// In which part of it.
        window: Window,
        /// What is taken of it.
        taken: Taken,
    },
    /// A setting as it stands at the end of the learner's cut; for a choice the number of its option from 1 on.
    Setting(String),
    /// How often the learner changed a setting during the cut; of all settings where none is named.
    Changes(Option<String>),
    /// The learner's prediction in a step: the number of the choice, or the number itself.
    Prediction(usize),
    /// 1 if a run ended so, 0 if not.
    Ended(EndId, RunOf),
}

/// Whose run a value is of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum RunOf {
    /// The learner's.
    #[default]
    Learner,
    /// The mission's cut as it was given, nothing touched.
    Given,
    /// The learner's cut at constant feed as programmed.
    ConstantFeed,
    /// The cut as given, under another controller with its settings as they stand in the mission.
    Controller(ControllerKind),
}

impl RunOf {
    /// Its name in files.
    #[must_use]
    pub fn id(self) -> &'static str {
        match self {
            Self::Learner => "learner",
            Self::Given => "given",
            Self::ConstantFeed => "constant_feed_twin",
            Self::Controller(kind) => kind.id(),
        }
    }

    /// All of them.
    pub fn all() -> impl Iterator<Item = Self> {
        let controllers = ControllerKind::ALL.iter().map(|kind| Self::Controller(*kind));
        [Self::Learner, Self::Given, Self::ConstantFeed].into_iter().chain(controllers)
    }
}

steadycut_core::choice! {
    /// What is taken of a signal.
    pub enum Taken {
        /// Its mean over the rows that have a value.
        Mean = "mean", "mean";
        /// Its largest value.
        Max = "max", "largest";
        /// Its least value.
        Min = "min", "least";
        /// Largest less least value.
        Range = "range", "largest less least";
        /// Its first value.
        First = "first", "first";
        /// Its last value.
        Last = "last", "last";
    }
}

/// A part of a run: rows from a time on and up to another, and from a place on and up to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// From and to, s.
    pub time_s: [f64; 2],
    /// From and to, mm along the path.
    pub place_mm: [f64; 2],
}

impl Window {
    /// All of a run.
    pub const ALL: Self = Self { time_s: [0.0, f64::INFINITY], place_mm: [0.0, f64::INFINITY] };

    /// Whether a row lies in it.
    #[must_use]
    pub fn holds(&self, row: &Row) -> bool {
        let within = |value: f64, [from, to]: [f64; 2]| from <= value && value <= to;
        within(row.time_s, self.time_s) && within(row.position_mm, self.place_mm)
    }
}

impl Taken {
    /// What is taken of a signal in a part of a run; none where it has no value there.
    #[must_use]
    pub fn of(self, signal: &SignalInfo, window: &Window, run: &Run) -> Option<f64> {
        let rows = run.recording().rows().iter().filter(|row| window.holds(row));
        let mut values = rows.filter_map(|row| (signal.value)(row));
        match self {
            Self::First => values.next(),
            Self::Last => values.next_back(),
            Self::Max => values.reduce(f64::max),
            Self::Min => values.reduce(f64::min),
            Self::Range => {
                let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
                for value in values {
                    (least, most) = (least.min(value), most.max(value));
                }
                (least <= most).then_some(most - least)
            }
            Self::Mean => stats::mean(values),
        }
    }
}
