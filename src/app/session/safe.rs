//! The safe constant feed of the session's cut: found in slices once both runs are simulated, kept for what it was
//! found for, and found anew once a drag has paused. While it is being found the one before stays drawn, and nothing
//! is told of it.

use super::{Session, TICKS_PER_FRAME};
use crate::app::clock::now_s;
use crate::app::format;
use crate::base::language::tr;
use crate::base::math::extent;
use crate::run::job::{Budget, Job, OneThread};
use crate::run::scenario::{Scenario, TwinKind};
use crate::study::safe_feed::{SafeFeed, SafeFeedJob, SafeFeedProblem, SafeTwin, twin_scenario};

/// Time in a frame that the search takes, s: what is begun by then takes its own time, of some fractions of a
/// millisecond.
const SEARCH_S: f64 = 0.006;
/// A change that goes on, as a drag does, must have paused for so long, s.
const PAUSE_S: f64 = 0.25;
/// Answers that are kept: a way back finds its own again.
const KEPT: usize = 16;

/// What stands beside the cut.
#[derive(Clone, Debug, PartialEq)]
pub enum TwinStand {
    /// Constant feed as programmed, as it was asked for.
    Programmed,
    /// The safe constant feed.
    Safe(SafeTwin),
    /// It is being found; the one before is drawn, if there is one.
    Finding(Option<SafeTwin>),
    /// There is none, and why: constant feed as programmed stands in its place.
    NoneSafe(String),
}

impl TwinStand {
    /// Whether the twin is the one that belongs to the cut as it is.
    #[must_use]
    pub fn is_settled(&self) -> bool {
        !matches!(self, Self::Finding(_))
    }

    /// Whether there is one to draw.
    #[must_use]
    pub fn is_drawn(&self) -> bool {
        !matches!(self, Self::Finding(None))
    }

    /// What it is called, in a word or two: `safe feed`, or `constant feed` as it is programmed.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Safe(_) | Self::Finding(_) => tr("safe feed"),
            Self::Programmed | Self::NoneSafe(_) => tr("constant feed"),
        }
    }

    /// The same where it is narrow.
    #[must_use]
    pub fn short(&self) -> &'static str {
        match self {
            Self::Safe(_) | Self::Finding(_) => tr("safe"),
            Self::Programmed | Self::NoneSafe(_) => tr("const."),
        }
    }

    fn safe(&self) -> Option<SafeTwin> {
        match self {
            Self::Safe(twin) | Self::Finding(Some(twin)) => Some(*twin),
            Self::Programmed | Self::Finding(None) | Self::NoneSafe(_) => None,
        }
    }
}

/// The search with what it has found so far.
#[derive(Default)]
pub(super) struct Finder {
    /// What was found, the newest last.
    known: Vec<(SafeFeedProblem, SafeFeed)>,
    search: Option<(SafeFeedProblem, SafeFeedJob)>,
    since_change_s: f64,
    /// The scenario by its name, and whether a safe feed stood beside its cut last.
    last: Option<(String, bool)>,
}

impl Finder {
    fn known(&self, problem: &SafeFeedProblem) -> Option<&SafeFeed> {
        self.known.iter().find(|(known, _)| known == problem).map(|(_, found)| found)
    }

    fn keep(&mut self, problem: SafeFeedProblem, found: SafeFeed) {
        self.known.push((problem, found));
        let over = self.known.len().saturating_sub(KEPT);
        self.known.drain(..over);
    }
}

/// What stands beside a cut for an answer.
fn stand(found: &SafeFeed) -> TwinStand {
    match found {
        SafeFeed::Found(twin) => TwinStand::Safe(*twin),
        SafeFeed::NoneHolds(none) => TwinStand::NoneSafe(none.to_string()),
    }
}

/// The scenario of the twin of a cut, by what stands beside it.
pub(super) fn scenario_of(chosen: &Scenario, stand: &TwinStand) -> Scenario {
    let safe = stand.safe().map(SafeFeed::Found);
    twin_scenario(chosen, safe.as_ref())
}

/// Feed and speed of a twin in words.
fn feed_and_speed(twin: &Scenario) -> String {
    let program = &twin.program;
    let feeds = match &program.cut_feeds_mm_min[..] {
        several @ [_, ..] if !twin.workpiece.cuts.is_empty() => {
            let [low, high] = extent(several.iter().copied());
            tr!("{low:.0} to {high:.0}", low = low, high = high)
        }
        _ => format!("{:.0}", program.feed_mm_min),
    };
    let at = tr!("{feeds} mm/min at {speed:.0} 1/min", feeds = feeds, speed = program.spindle_rpm);
    format::typeset(&at)
}

impl Session {
    /// What stands beside the cut.
    #[must_use]
    pub fn twin_stand(&self) -> &TwinStand {
        &self.stand
    }

    /// Which twin it is, with its feed and speed.
    #[must_use]
    pub fn twin_title(&self) -> String {
        let at = feed_and_speed(self.twin.run().scenario());
        match &self.stand {
            // It holds the target on the whole part, so that a change ahead of the tool is a change of what was cut, too.
            TwinStand::Safe(_) if !self.edits().list().is_empty() => {
                tr!("safe feed from start: {at}", at = at)
            }
            TwinStand::Safe(_) => tr!("safe constant feed: {at}", at = at),
            TwinStand::Finding(_) => tr("safe constant feed: finding \u{2026}").to_owned(),
            TwinStand::Programmed => tr!("constant feed as programmed: {at}", at = at),
            TwinStand::NoneSafe(_) => {
                tr!("none is safe; constant feed as programmed: {at}", at = at)
            }
        }
    }

    /// The same in fewer words, where that has no room.
    #[must_use]
    pub fn twin_short(&self) -> String {
        let name = self.stand.name();
        let at = feed_and_speed(self.twin.run().scenario());
        match &self.stand {
            TwinStand::Finding(_) => tr!("{name}: finding …", name = name),
            TwinStand::Safe(_) | TwinStand::Programmed => format!("{name}: {at}"),
            TwinStand::NoneSafe(_) => tr!("{name}, none is safe: {at}", name = name, at = at),
        }
    }

    /// About the widest of what is said of a safe twin, in few words or in more.
    #[must_use]
    pub fn twin_widest(short: bool) -> String {
        let at = tr!("{feeds} mm/min at {speed:.0} 1/min", feeds = "8888", speed = 8888.0);
        match short {
            true => format!("{}: {at}", tr("safe feed")),
            false => tr!("safe feed from start: {at}", at = at),
        }
    }

    /// What stands beside another cut than before: its own safe feed where that is known, or else it is to be found,
    /// and the one before stays drawn meanwhile. `shared`: the twin shares changes during the cut.
    pub(super) fn stand_beside(&mut self, chosen: &Scenario, shared: bool) {
        self.finder.since_change_s = 0.0;
        self.finder.search = None;
        let known = || {
            // With changes during the cut it goes by their places, which are not known yet.
            let problem = (!shared).then(|| SafeFeedProblem::new(chosen, Vec::new()))?;
            self.finder.known(&problem).map(stand)
        };
        let stand = match chosen.twin.kind {
            TwinKind::Programmed => TwinStand::Programmed,
            TwinKind::Safe => known().unwrap_or_else(|| TwinStand::Finding(self.stand.safe())),
        };
        self.tell_another(&stand);
        self.stand = stand;
    }

    /// Goes on finding the safe feed, for a slice.
    pub(super) fn find(&mut self, dt_s: f64) {
        self.finder.since_change_s += dt_s;
        if self.stand.is_settled() || !self.chosen.is_over() {
            return;
        }
        if self.finder.search.is_none() {
            if self.gesture.is_some() && self.finder.since_change_s < PAUSE_S {
                return;
            }
            let problem = SafeFeedProblem::of(self.chosen.run());
            if let Some(found) = self.finder.known(&problem).map(stand) {
                return self.settle(found);
            }
            let job = SafeFeedJob::new(problem.clone());
            self.finder.search = Some((problem, job));
        }
        let begun_s = now_s();
        let late = || now_s() - begun_s > SEARCH_S;
        let Some((problem, mut job)) = self.finder.search.take() else { return };
        job.advance(&Budget::all().on(&OneThread, &late));
        match job.partial() {
            Some(found) => {
                let settled = stand(&found);
                self.finder.keep(problem, found);
                self.settle(settled);
            }
            None => self.finder.search = Some((problem, job)),
        }
    }

    /// The twin is cut anew at what was found.
    fn settle(&mut self, stand: TwinStand) {
        self.tell_another(&stand);
        self.stand = stand;
        // At another feed it comes to the places of changes at other times.
        self.shared.truncate(0.0);
        self.met += 1;
        self.twin.change(&scenario_of(&self.plan.0, &self.stand), &self.shared.edits());
        // This frame shall already show it.
        self.twin.advance(TICKS_PER_FRAME);
        self.meet();
    }

    /// Says that what the cut is compared with is another one than before: the safe feed of the same part is gone, or
    /// is back.
    fn tell_another(&mut self, stand: &TwinStand) {
        let is_safe = match stand {
            TwinStand::Safe(_) => true,
            TwinStand::NoneSafe(_) => false,
            TwinStand::Programmed | TwinStand::Finding(_) => return,
        };
        let name = self.plan.0.info.name.clone();
        let before = self.finder.last.replace((name.clone(), is_safe));
        let was_safe = before.filter(|(of, _)| *of == name).map(|(_, safe)| safe);
        match (was_safe, stand) {
            (Some(true), TwinStand::NoneSafe(why)) => self.notify(tr!(
                "The cut is compared with constant feed as programmed now: {why}.",
                why = why
            )),
            (Some(false), TwinStand::Safe(_)) => {
                self.notify(tr("The cut is compared with a safe constant feed again."));
            }
            (None | Some(_), _) => {}
        }
    }
}
