//! What the console works on: scenario and edits, the chosen run with its constant-feed twin, the
//! playhead, and the way back. Nothing of it knows how it is drawn.
//!
//! Both runs are simulated ahead to their end, a budget of ticks at a time; the playhead reveals
//! them. A live setting changed while the cut is running becomes an edit at the playhead and the
//! run branches there; every other change is one of the scenario itself, and the runs are done
//! again under a playhead that stays.

mod change;
pub mod disturb;
mod foreign;
pub mod hand;
pub mod mishap;
mod safe;

use std::collections::{BTreeMap, BTreeSet};

use super::clock::now_s;
use super::cut::{Cut, Ghost};
use super::playback::Playback;
use crate::base::language::tr;
use crate::models::disturbances::Zone;
use crate::run::against_twin::{self, Comparison};
use crate::run::constant_feed_twin::{self, SharedEdits};
use crate::run::edits::{Edits, Unfit};
use crate::run::one_run::End;
use crate::run::scenario::{Scenario, TwinKind};
use crate::run::signals::Row;
use crate::run::story::Story;
pub use change::{LOCKED, NO_OTHER_SCENARIO, PREDICT_FIRST};
use hand::Driving;
pub use safe::TwinStand;
use safe::{Finder, scenario_of};

/// Ticks that each run is simulated by in one frame: some milliseconds of work.
const TICKS_PER_FRAME: u64 = 60_000;
/// The same tooth by tooth, where a tick costs some ten times as much.
const TOOTH_TICKS_PER_FRAME: u64 = 12_000;
/// Time in a frame in which the twin meets edits, s: it is cut again from each of them on.
const MEET_S: f64 = 0.008;
/// So many edits it meets in a frame at least.
const LEAST_EDITS: u32 = 4;
/// Ticks by which it is simulated towards the place of the next one.
const TICKS_TO_NEXT: u64 = 2_000;
/// Steps of undo that are kept.
const MAX_UNDO: usize = 200;
/// Messages that are kept.
const MAX_NOTICES: usize = 100;
/// Time between two comparisons while playing, s: numbers that change faster can't be read.
const COMPARE_EVERY_S: f64 = 0.4;
/// A comparison walks over all revealed rows: with more than these it is made less often.
const COMPARE_ROWS: usize = 1_000_000;

/// Most that is told of runs that are not as they will be, as a fraction.
const NEARLY: f64 = 0.99;

/// What times may be off by, having been written in decimals, s.
const HAIR_S: f64 = 1e-6;

/// Which edits are gone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Gone {
    /// Those after the playhead.
    AfterPlayhead,
    /// Those of a setting that is set for the whole cut now.
    SetAgain,
}

/// A message.
#[derive(Clone, Debug, PartialEq)]
pub struct Notice {
    /// Its number: larger than those of all before.
    pub number: u64,
    /// Its text.
    pub text: String,
}

/// What a mission lets be changed.
#[derive(Clone, Debug, PartialEq)]
pub struct MissionLock {
    /// The mission's name for people.
    pub title: String,
    /// Its part of a link.
    pub link: String,
    /// The cut that the learner is given.
    pub scenario: Scenario,
    /// Paths of the settings that may be changed.
    pub open: Vec<String>,
    /// Of those that are choices: the ids of the options that are offered, where not all are.
    pub options: BTreeMap<String, Vec<String>>,
    /// Whether the cut is to be predicted: it is shown nowhere and stands at its start.
    pub hides: bool,
    /// Changes during the cut that are part of the mission.
    pub given: Edits,
}

/// A scenario with its edits: what undo goes back to.
type Plan = (Scenario, Edits);

/// See the head of this file.
pub struct Session {
    plan: Plan,
    chosen: Cut,
    twin: Cut,
    /// Which constant feed that is.
    stand: TwinStand,
    finder: Finder,
    /// Where the twin meets the edits that it shares.
    shared: SharedEdits,
    /// Counts the edits that the twin has met.
    met: u64,
    /// Whether it has edits to meet still, for which there was no time in the last frame.
    behind: bool,
    ghost: Option<Ghost>,
    playback: Playback,
    undo: Vec<Plan>,
    redo: Vec<Plan>,
    /// Length and size with which each kind of disturbance is dropped next.
    offered: Vec<Zone>,
    /// Driving by hand.
    hand: Driving,
    /// What may be changed, where a mission says so.
    mission: Option<MissionLock>,
    /// The way back to before the mission, which is closed within it.
    undo_before_mission: Vec<Plan>,
    /// Counts the missions that were begun and ended.
    missions: u64,
    /// Settings that nothing changes here, by their paths.
    locked: BTreeSet<String>,
    /// The setting that is being changed without a pause: its changes are one step of undo.
    gesture: Option<String>,
    notices: Vec<Notice>,
    notices_so_far: u64,
    /// Why there is no scenario at the playhead, where that was said.
    refused: Option<String>,
    /// Scenario as it stands at the playhead.
    current: Scenario,
    comparison: Comparison,
    compared: Compared,
    since_comparison_s: f64,
    story: Story,
    /// The story of all that is simulated.
    whole_story: Story,
    /// Counts how often that was told.
    stories: u64,
    told: Compared,
    /// Up to where [`Self::story`] is told, s.
    told_until_s: f64,
    changes: u64,
    /// Whether a script that came with a file or a link waits to be run.
    waits: bool,
}

/// What a comparison or a story was made of: number of changes and of edits that the twin has met, rows (of a comparison those revealed),
/// rows of the twin.
type Compared = (u64, usize, usize);

/// What no story was made of.
const NEVER_TOLD: Compared = (u64::MAX, usize::MAX, usize::MAX);

impl Session {
    /// A session at the start of its run, playing.
    #[must_use]
    pub fn new(scenario: Scenario, edits: Edits) -> Self {
        let (edits, unfit) = edits.fitted(&scenario);
        let mut chosen = Cut::new(&scenario, &edits);
        let mut twin = Cut::new(&constant_feed_twin::scenario(&scenario), &Edits::none());
        let stand = match scenario.twin.kind {
            TwinKind::Safe => TwinStand::Finding(None),
            TwinKind::Programmed => TwinStand::Programmed,
        };
        let comparison = against_twin::compare_on(chosen.counted(), 1, twin.counted());
        let mut session = Self {
            current: scenario.clone(),
            plan: (scenario, edits),
            chosen,
            twin,
            stand,
            finder: Finder::default(),
            shared: SharedEdits::default(),
            met: 0,
            behind: false,
            ghost: None,
            playback: Playback::from_start(),
            undo: Vec::new(),
            redo: Vec::new(),
            offered: disturb::usual(),
            hand: Driving::default(),
            mission: None,
            undo_before_mission: Vec::new(),
            missions: 0,
            locked: BTreeSet::new(),
            gesture: None,
            notices: Vec::new(),
            notices_so_far: 0,
            refused: None,
            comparison,
            compared: (0, 1, 0),
            since_comparison_s: 0.0,
            story: Story::default(),
            whole_story: Story::default(),
            stories: 0,
            told: (0, 0, 0),
            told_until_s: 0.0,
            changes: 0,
            waits: false,
        };
        session.report(&unfit);
        session.refresh();
        session.tell();
        session
    }

    /// The scenario as it is at the start of the run.
    #[must_use]
    pub fn scenario(&self) -> &Scenario {
        &self.plan.0
    }

    /// The edits.
    #[must_use]
    pub fn edits(&self) -> &Edits {
        &self.plan.1
    }

    /// The scenario as it stands at the playhead: what the controls show.
    #[must_use]
    pub fn current(&self) -> &Scenario {
        &self.current
    }

    /// The mission under way, with what it opens.
    #[must_use]
    pub fn mission(&self) -> Option<&MissionLock> {
        self.mission.as_ref()
    }

    /// Whether the cut is to be predicted before any of it is seen.
    #[must_use]
    pub fn hides_the_cut(&self) -> bool {
        self.mission.as_ref().is_some_and(|lock| lock.hides)
    }

    /// Counts the missions that were begun and ended.
    #[must_use]
    pub fn missions(&self) -> u64 {
        self.missions
    }

    /// Locks settings, by their paths: nothing changes them from now on, and no other scenario is opened.
    pub fn lock(&mut self, paths: BTreeSet<String>) {
        self.locked = paths;
    }

    /// Whether any setting is locked.
    #[must_use]
    pub fn has_locks(&self) -> bool {
        !self.locked.is_empty()
    }

    /// The run with the chosen controller.
    #[must_use]
    pub fn chosen(&self) -> &Cut {
        &self.chosen
    }

    /// The same cut at constant feed.
    #[must_use]
    pub fn twin(&self) -> &Cut {
        &self.twin
    }

    /// The chosen run as it was before the last change.
    #[must_use]
    pub fn ghost(&self) -> Option<&Ghost> {
        self.ghost.as_ref()
    }

    /// Playhead, speed, follow mode.
    #[must_use]
    pub fn playback(&self) -> &Playback {
        &self.playback
    }

    /// The comparison with the twin, at most 0.4 s old while playing.
    #[must_use]
    pub fn comparison(&self) -> &Comparison {
        &self.comparison
    }

    /// What has happened up to the playhead, in sentences: nothing of what is not cut yet. As old as
    /// [`Self::comparison`].
    #[must_use]
    pub fn story(&self) -> &Story {
        &self.story
    }

    /// Up to where [`Self::story`] is told, s.
    #[must_use]
    pub fn told_until_s(&self) -> f64 {
        self.told_until_s
    }

    /// The same of the whole run as far as it is simulated: the moments that lie ahead.
    #[must_use]
    pub fn whole_story(&self) -> &Story {
        &self.whole_story
    }

    /// Counts how often [`Self::whole_story`] was told anew.
    #[must_use]
    pub fn stories(&self) -> u64 {
        self.stories
    }

    /// The messages so far, the newest last; old ones are forgotten at last.
    #[must_use]
    pub fn notices(&self) -> &[Notice] {
        &self.notices
    }

    /// Counts the changes of scenario and edits.
    #[must_use]
    pub fn changes(&self) -> u64 {
        self.changes
    }

    /// Whether there is something to take back.
    #[must_use]
    pub fn can_undo(&self) -> bool {
        !self.undo.is_empty()
    }

    /// Whether there is something to do again.
    #[must_use]
    pub fn can_redo(&self) -> bool {
        !self.redo.is_empty()
    }

    /// Rows of the chosen run that are revealed; at least one.
    #[must_use]
    pub fn revealed(&self) -> &[Row] {
        let recording = self.chosen.run().recording();
        &recording.rows()[..=recording.index_at(self.playback.playhead_s)]
    }

    /// The row at the playhead.
    #[must_use]
    pub fn row(&self) -> &Row {
        let recording = self.chosen.run().recording();
        &recording.rows()[recording.index_at(self.playback.playhead_s)]
    }

    /// Length of the time axis: the end of the run, or the time limit until that is known.
    #[must_use]
    pub fn length_s(&self) -> f64 {
        if self.chosen.is_over() {
            self.chosen.simulated_s()
        } else {
            self.chosen.run().last_tick() as f64 * self.plan.0.dt_s()
        }
    }

    /// Why the cut is over, once the playhead has come to its end.
    #[must_use]
    pub fn finished(&self) -> Option<&End> {
        self.chosen.run().end().filter(|_| self.playback.at_end)
    }

    /// Fraction of both runs that is simulated, from 0 to 1; below 1 as long as the twin's feed is being found.
    #[must_use]
    pub fn progress(&self) -> f64 {
        // Tooth by tooth that takes long, and all else is there before.
        let by_teeth = self.plan.0.plant.force_model.tooth_by_tooth();
        let finds = !by_teeth && !self.stand.is_settled();
        if finds { self.simulated().min(NEARLY) } else { self.simulated() }
    }

    /// Whether the twin has come as far along the way as the cut ever does: no more of it is compared.
    #[must_use]
    pub fn twin_is_done(&self) -> bool {
        let last_mm =
            |cut: &Cut| cut.run().recording().rows().last().map_or(0.0, |row| row.position_mm);
        let far = || last_mm(&self.twin) >= last_mm(&self.chosen);
        self.twin.is_over() || self.chosen.is_over() && far()
    }

    /// Fraction of both runs that is simulated, from 0 to 1.
    #[must_use]
    pub fn simulated(&self) -> f64 {
        // The twin takes about as long as the cut, or ends on its way.
        let last_tick = self.chosen.run().last_tick() as f64;
        let share = |cut: &Cut, done: bool| {
            if done { 1.0 } else { (cut.run().ticks() as f64 / last_tick).min(NEARLY) }
        };
        let [chosen, twin] = [self.chosen.is_over(), self.twin_is_done()];
        let share = 0.5 * (share(&self.chosen, chosen) + share(&self.twin, twin));
        // What is compared is not final before the twin has met every change.
        if self.behind { share.min(NEARLY) } else { share }
    }

    /// Advances by `dt_s` seconds of real time: simulates ahead and moves the playhead.
    pub fn advance(&mut self, dt_s: f64) {
        if self.waits {
            return self.refresh();
        }
        let by_teeth = self.current.plant.force_model.tooth_by_tooth();
        let ticks = if by_teeth { TOOTH_TICKS_PER_FRAME } else { TICKS_PER_FRAME };
        if !self.chosen.is_over() {
            self.chosen.advance(ticks);
        }
        if !self.twin_is_done() {
            self.twin.advance(ticks);
        }
        self.meet();
        self.find(dt_s);
        if !self.hides_the_cut() {
            self.playback.advance(dt_s, self.chosen.simulated_s(), self.chosen.is_over());
        }
        self.since_comparison_s += dt_s;
        self.refresh();
        self.keep_hand();
        let rows = self.revealed().len();
        let moving = self.playback.playing || !self.chosen.is_over();
        let pause_s = match (moving, rows / COMPARE_ROWS) {
            (false, 0) => 0.0,
            (_, times) => COMPARE_EVERY_S * (1 + times) as f64,
        };
        if self.comparison_is_due() && self.since_comparison_s >= pause_s {
            self.compare();
        }
    }

    /// Whether the comparison is older than what is shown.
    #[must_use]
    pub fn comparison_is_due(&self) -> bool {
        self.compared != self.to_compare()
    }

    fn to_compare(&self) -> Compared {
        let rows = self.twin.run().recording().rows().len();
        (self.changes + self.met, self.revealed().len(), rows)
    }

    /// Ends the step of undo that a drag has opened.
    pub fn end_gesture(&mut self) {
        self.gesture = None;
    }

    /// Says something; what was said before in the same words is said again in its place.
    pub fn notify(&mut self, text: impl Into<String>) {
        let text = text.into();
        self.notices.retain(|notice| notice.text != text);
        self.notices_so_far += 1;
        self.notices.push(Notice { number: self.notices_so_far, text });
        let over = self.notices.len().saturating_sub(MAX_NOTICES);
        self.notices.drain(..over);
    }

    /// Says which edits were left out, and why.
    fn report(&mut self, unfit: &[Unfit]) {
        if let Some(first) = unfit.first() {
            let first = first.to_string();
            self.notify(match unfit.len() - 1 {
                0 => tr!("Left out: {first}", first = first),
                more => tr!("Left out (and {more} more): {first}", more = more, first = first),
            });
        }
    }

    /// Says how many edits are gone, and which.
    fn report_gone(&mut self, count: usize, which: Gone) {
        let said = match (count, which) {
            (0, _) => return,
            (1, Gone::AfterPlayhead) => {
                tr("The change that came later in the cut is gone: from here on it is cut anew. Undo brings it back.")
                    .to_owned()
            }
            (1, Gone::SetAgain) => tr(
                "The change of the same setting during the cut is gone: the new value holds for the whole cut. Undo brings it back.",
            )
            .to_owned(),
            (n, Gone::AfterPlayhead) => {
                tr!(
                    "{n} changes that came later in the cut are gone: from here on it is cut anew. Undo brings them back.",
                    n = n
                )
            }
            (n, Gone::SetAgain) => tr!(
                "{n} changes of the same settings during the cut are gone: the new values hold for the whole cut. Undo brings them back.",
                n = n
            ),
        };
        self.notify(said);
    }

    fn refresh(&mut self) {
        let (scenario, edits) = &self.plan;
        match edits.scenario_at(scenario, self.playback.playhead_s + HAIR_S) {
            Ok(current) => (self.current, self.refused) = (current, None),
            Err(refused) => {
                // Said once, though it is found in every frame.
                let refused = Some(refused.to_string());
                if refused != self.refused {
                    self.refused.clone_from(&refused);
                    refused.into_iter().for_each(|text| self.notify(text));
                }
            }
        }
    }

    fn compare(&mut self) {
        self.since_comparison_s = 0.0;
        self.compared = self.to_compare();
        let rows = self.revealed().len();
        self.comparison =
            against_twin::compare_on(self.chosen.counted(), rows, self.twin.counted());
        self.tell();
    }

    /// Lets the twin meet the next edits at their places, once both runs have come there: as many as there is time
    /// for in a frame, and some at least however slow the machine is.
    fn meet(&mut self) {
        let begun_s = now_s();
        let (mut edits, mut ticks) = (0, 0);
        let shared = constant_feed_twin::edits(&self.plan.1).list().len();
        self.behind = false;
        loop {
            if self.shared.place(self.chosen.run(), self.twin.run()).is_some() {
                self.met += 1;
                edits += 1;
                self.twin.change(&scenario_of(&self.plan.0, &self.stand), &self.shared.edits());
            } else if self.twin_is_done() || self.shared.edits().list().len() >= shared {
                return;
            } else {
                // As far as the next place, not to the end, which the next edit would throw away.
                self.twin.advance(TICKS_TO_NEXT);
                ticks += TICKS_TO_NEXT;
            }
            let enough = edits >= LEAST_EDITS || ticks >= TICKS_PER_FRAME;
            if enough && now_s() - begun_s >= MEET_S {
                self.behind = true;
                return;
            }
        }
    }

    /// Tells everything again, in the language of now.
    pub fn tell_anew(&mut self) {
        self.told = NEVER_TOLD;
        self.tell();
    }

    /// Tells the story up to the playhead; that of the whole run where the runs are others or longer than when it
    /// was told.
    fn tell(&mut self) {
        let rows = |cut: &Cut| cut.run().recording().rows().len();
        let all = rows(&self.chosen);
        let now = (self.changes + self.met, all, rows(&self.twin));
        let (run, scan, twin) = (
            self.chosen.run(),
            self.chosen.scan(),
            self.stand.is_settled().then(|| self.twin.run()),
        );
        if self.told != now {
            self.told = now;
            self.whole_story = Story::told(run, scan, twin);
            self.stories += 1;
        }
        let revealed = self.revealed().len();
        self.told_until_s = self.row().time_s;
        self.story = match revealed == all {
            true => self.whole_story.clone(),
            false => Story::until(run, scan, revealed, twin),
        };
    }
}
