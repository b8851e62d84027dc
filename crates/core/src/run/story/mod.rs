//! A run in sentences: what happens, when, why, and what it does, measured in the run itself and in
//! its constant-feed twin.
//!
//! [`Scan`] goes over the recorded rows once and grows with them; [`Story`] is told from it when it
//! is wanted. A change (a depth step, a target, a setting, contact) is compared before and after,
//! each at the end of its stretch; no cause is named that is not seen in the rows, the scenario or
//! the edits. Where rows are recorded more seldom than the plant steps, the story is as coarse.
//!
//! ```
//! use steadycut_core::run::story::{EventKind, Story};
//! use steadycut_core::run::{constant_feed_twin, edits::Edits, one_run::Run, presets};
//!
//! let scenario = presets::load("depth-step").unwrap();
//! let run = Run::complete(&scenario, &Edits::none());
//! let twin = constant_feed_twin::beside(&run);
//! let story = Story::of(&run, Some(&twin));
//! let step = story.events.iter().find(|event| event.id == EventKind::DepthStep).unwrap();
//! println!("{:.2} s: {}", step.from_s, step.sentence);
//! ```

mod changes;
mod chatter;
mod effects;
mod figures;
mod means;
mod met;
mod oscillation;
mod response;
mod scan;
mod spans;
mod verdict;
mod words;

use serde::Serialize;

pub use changes::{Cause, ONE_DRAG_S};
pub use figures::{
    AirCut, ChangeEffect, Chatter, ChatterEnd, Excursion, Figures, FirstAnswer, LimitCycle,
    LimitReached, LimitedCommand, ModelInput, RangeLeft, RangedInput, WayDone, WearEffect,
};
pub use means::{StretchMeans, deviation, force_error, produced_ra_um, shaken_deviation};
pub use oscillation::{Oscillation, undamped};
pub use response::{ResponseEnd, Sampling, StepResponse};
pub use scan::{RowSpan, Scan};
pub use verdict::CutVerdict;

use super::one_run::Run;
use crate::base::language::text;

/// What times may be off by, having been summed or written in decimals, s.
const HAIR_S: f64 = 1e-6;

/// What an event is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum EventKind {
    /// The run begins, in contact.
    Start,
    /// The tool comes into contact.
    Contact,
    /// The tool is in the air.
    Air,
    /// The depth of cut changes.
    DepthStep,
    /// The target changes.
    TargetChange,
    /// A disturbance begins or ends.
    Disturbance,
    /// Another setting changes.
    SettingChange,
    /// Nothing answers yet.
    DeadTime,
    /// A command stands at a limit.
    Saturation,
    /// A model is used outside its range.
    OutsideModel,
    /// The machine chatters: a tooth jumps out of the cut, or its vibration does not die down.
    Chatter,
    /// The tool wears.
    Wear,
    /// The loop swings without damping.
    LimitCycle,
    /// The run is over.
    End,
}

/// Something that happens in a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StoryEvent {
    /// What it is.
    pub id: EventKind,
    /// When it begins, s.
    pub from_s: f64,
    /// When it ends, s: what a change does lasts until the next change.
    pub to_s: f64,
    /// Where along the way it begins, mm.
    pub position_mm: f64,
    /// Its figures.
    pub figures: Figures,
    /// It in words, for people.
    pub sentence: String,
}

/// See the head of this file.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Story {
    /// What happens, by its beginning.
    pub events: Vec<StoryEvent>,
    /// Time of the last row that is told of a run that goes on, s; none of one that is over.
    #[serde(skip)]
    told_to_s: Option<f64>,
}

impl Story {
    /// The story of a run as far as it is recorded, with its constant-feed twin where there is one.
    #[must_use]
    pub fn of(run: &Run, twin: Option<&Run>) -> Self {
        let mut scan = Scan::default();
        scan.extend(run.recording().rows());
        Self::told(run, &scan, twin)
    }

    /// The same from a scan of the run's recording.
    #[must_use]
    pub fn told(run: &Run, scan: &Scan, twin: Option<&Run>) -> Self {
        Self::until(run, scan, run.recording().rows().len(), twin)
    }

    /// The story of the first `rows` rows alone: what is known when the cut has come so far.
    #[must_use]
    pub fn until(run: &Run, scan: &Scan, rows: usize, twin: Option<&Run>) -> Self {
        let all = run.recording().rows();
        let rows = &all[..rows.min(scan.rows()).min(all.len())];
        if rows.is_empty() {
            return Self::default();
        }
        let so_far = run.end().is_none() || rows.len() < all.len();
        let mut seen = scan.clone();
        seen.truncate(rows.len());
        let changes = changes::changes(run, &seen, rows);
        let told = effects::Told { run, rows, twin, so_far, ahead: scan };
        let mut events = effects::tell(&told, &changes);
        events.extend(spans::tell(run, &seen, rows, so_far));
        if !so_far {
            let end = effects::end(run, rows, &events);
            events.extend(end);
        }
        // In the order of time; what comes at the same time stays in the order of causes.
        events.sort_by(|a, b| a.from_s.total_cmp(&b.from_s));
        let told_to_s = rows.last().filter(|_| so_far).map(|row| row.time_s);
        Self { events, told_to_s }
    }

    /// The change that the loop answers to at a time in s, with its response.
    #[must_use]
    pub fn response_at(&self, time_s: f64) -> Option<(&StoryEvent, &StepResponse)> {
        let begun = self.events.iter().take_while(|event| event.from_s <= time_s);
        begun.filter_map(|event| event.response().map(|response| (event, response))).last()
    }

    /// When events of a kind lasted before a time in s, as stretches of time in s that do not touch.
    #[must_use]
    pub fn stretches_until(&self, kind: EventKind, time_s: f64) -> Vec<[f64; 2]> {
        let spans = effects::spans(&self.events, kind).into_iter();
        let begun = spans.filter(|[from_s, _]| *from_s <= time_s);
        begun.map(|[from_s, to_s]| [from_s, to_s.min(time_s)]).collect()
    }

    /// What the whole cut comes to, once it is over.
    #[must_use]
    pub fn verdict(&self) -> Option<&CutVerdict> {
        self.events.iter().rev().find_map(|event| match &event.figures {
            Figures::End(done) => Some(&done.verdict),
            Figures::Change(_)
            | Figures::Air(_)
            | Figures::Answer(_)
            | Figures::Limit(_)
            | Figures::Outside(_)
            | Figures::Chatter(_)
            | Figures::Wear(_)
            | Figures::LimitCycle(_) => None,
        })
    }

    /// Whether the cut was unstable or chattered at any time.
    #[must_use]
    pub fn has_swung(&self) -> bool {
        self.has(EventKind::LimitCycle) || self.has(EventKind::Chatter)
    }

    /// Whether it tells of an event of a kind.
    #[must_use]
    pub fn has(&self, kind: EventKind) -> bool {
        self.events.iter().any(|event| event.id == kind)
    }

    /// The change that a time in s stands behind: the last start, step, contact, air or end before it.
    #[must_use]
    pub fn change_at(&self, time_s: f64) -> Option<&StoryEvent> {
        let begun = self.events.iter().take_while(|event| event.from_s <= time_s);
        begun.filter(|event| event.id.is_change()).last()
    }

    /// What lasts at a time in s and matters most: an instability before chatter, that before a limit,
    /// then a dead time, a model outside its range, wear.
    #[must_use]
    pub fn lasting_at(&self, time_s: f64) -> Option<&StoryEvent> {
        let lasting = self.events.iter().filter(|event| {
            // What lasts at the last moment told lasts until more is: the playhead is a little ahead of it.
            let goes_on = self.told_to_s.is_some_and(|told_s| event.to_s + HAIR_S >= told_s);
            let now = event.from_s <= time_s && (goes_on || time_s <= event.to_s + HAIR_S);
            now && !event.id.is_change()
        });
        lasting.min_by_key(|event| event.id.rank())
    }
}

impl EventKind {
    /// Its name for people.
    #[must_use]
    pub fn label(self) -> &'static str {
        match self {
            Self::Start => text!("Start"),
            Self::Contact => text!("Contact"),
            Self::Air => text!("Air"),
            Self::DepthStep => text!("Depth step"),
            Self::TargetChange => text!("Target"),
            Self::Disturbance => text!("Disturbance"),
            Self::SettingChange => text!("Setting"),
            Self::DeadTime => text!("Dead time"),
            Self::Saturation => text!("At a limit"),
            Self::OutsideModel => text!("Outside model"),
            Self::Chatter => text!("Chatter"),
            Self::Wear => text!("Wear"),
            Self::LimitCycle => text!("Unstable"),
            Self::End => text!("End"),
        }
    }

    /// Whether a new stretch of the run begins with it.
    #[must_use]
    pub fn is_change(self) -> bool {
        self.rank() == 0
    }

    /// What matters more of what lasts at the same time has the lower number; 0 for changes.
    fn rank(self) -> u8 {
        match self {
            Self::Start
            | Self::Contact
            | Self::Air
            | Self::DepthStep
            | Self::TargetChange
            | Self::Disturbance
            | Self::SettingChange
            | Self::End => 0,
            Self::LimitCycle => 1,
            Self::Chatter => 2,
            Self::Saturation => 3,
            Self::DeadTime => 4,
            Self::OutsideModel => 5,
            Self::Wear => 6,
        }
    }
}

impl StoryEvent {
    /// The response to it, if it is a change that the loop answers to.
    #[must_use]
    pub fn response(&self) -> Option<&StepResponse> {
        match &self.figures {
            Figures::Change(effect) => effect.response.as_ref(),
            Figures::Air(_)
            | Figures::Answer(_)
            | Figures::Limit(_)
            | Figures::Outside(_)
            | Figures::Chatter(_)
            | Figures::Wear(_)
            | Figures::LimitCycle(_)
            | Figures::End(_) => None,
        }
    }
}
