//! What each change does: before and after, in the run and in its twin; the first answer, limit
//! cycles, wear; and the end.

use super::super::edits::Edit;
use super::super::metrics::Judged;
use super::super::one_run::{End, Run};
use super::super::scenario::Scenario;
use super::super::signals::{Row, flag};
use super::changes::{Cause, Change};
use super::figures::{
    AirCut, ChangeEffect, Excursion, Figures, FirstAnswer, LimitCycle, WayDone, WearEffect,
};
use super::means::{StretchMeans, deviation, produced_ra_um, shaken_deviation, shaken_ra_um};
use super::response::{ResponseEnd, Sampling, StepResponse, at_the_end};
use super::scan::Scan;
use super::verdict::CutVerdict;
use super::{EventKind, StoryEvent, words};
use crate::base::language::tr;
use crate::base::math::extent;
use crate::base::units::percent_from_ratio;
use crate::blocks::control::ControllerKind;
use crate::blocks::cutting::tool_path::ToolPath;
use crate::blocks::reference::Reference;

/// A signal answers once it leaves what it was in the second before by this fraction (chosen).
const ANSWERS: f64 = 0.002;
/// How far short of the end of a stretch the twin may stop and still have cut it, mm (chosen).
const NEAR_MM: f64 = 0.1;
/// Wear of less than this fraction of the tool's life over a run is not told of (chosen).
const LEAST_WEAR: f64 = 0.01;

/// A stretch that is still being cut is judged from this on after its change, s (chosen), and the time in which
/// nothing can answer: what has not begun to move would count as being at rest.
const JUDGED_FROM_S: f64 = 2.0;

/// What is told of.
pub(super) struct Told<'a> {
    pub run: &'a Run,
    /// The rows that are known.
    pub rows: &'a [Row],
    pub twin: Option<&'a Run>,
    /// Whether the cut goes on after them.
    pub so_far: bool,
    /// What is found in all rows of the run: the program's way is known before it is cut.
    pub ahead: &'a Scan,
}

impl Told<'_> {
    /// When the depth changes next after a row, s; that it does not, where the run is over; nothing where that is
    /// not known yet.
    fn next_depth_s(&self, row: usize) -> Option<Option<f64>> {
        let next = self.ahead.depth().iter().find(|span| span.first > row);
        match (next, self.run.end()) {
            (Some(span), _) => {
                Some(self.run.recording().rows().get(span.first).map(|row| row.time_s))
            }
            (None, Some(_)) => Some(None),
            (None, None) => None,
        }
    }
}

/// The scenario as its edits leave it, taken on in the order of time.
pub(super) struct Moment<'a> {
    pub scenario: Scenario,
    edits: std::slice::Iter<'a, Edit>,
}

impl<'a> Moment<'a> {
    pub fn start(run: &'a Run) -> Self {
        Self { scenario: run.scenario().clone(), edits: run.edits().list().iter() }
    }

    /// Takes over the edits up to a time in s.
    pub fn advance(&mut self, time_s: f64) {
        while let Some(edit) = self.edits.as_slice().first().filter(|edit| edit.at_s <= time_s) {
            // One that does not fit has ended the run.
            let _unfit = self.scenario.set(&edit.path, edit.value.clone());
            self.edits.next();
        }
    }
}

/// The stretch of rows between two changes.
struct Place<'a> {
    rows: &'a [Row],
    row_s: f64,
    /// The first row after the change.
    from: usize,
    /// The first row of the next change, or the end.
    end: usize,
}

impl<'a> Place<'a> {
    fn stretch(&self) -> &'a [Row] {
        &self.rows[self.from..self.end]
    }
}

/// The events of changes and of what follows from them.
pub(super) fn tell(told: &Told<'_>, changes: &[Change]) -> Vec<StoryEvent> {
    let Told { run, rows, twin, .. } = *told;
    let row_s = run.recording().row_s();
    let control_every = run.recording().control_every();
    let sampling = Sampling { stride: run.recording().control_stride(), row_s };
    let mut events = Vec::new();
    let mut moment = Moment::start(run);
    let mut before: Option<StretchMeans> = None;
    let mut before_from = 0;
    for (i, change) in changes.iter().enumerate() {
        let end = changes.get(i + 1).map_or(rows.len(), |next| next.rows.first);
        let place = Place { rows, row_s, from: change.rows.last, end };
        // An edit at a row's very time acts from the next one on.
        moment.advance(rows[end - 1].time_s - 0.5 * row_s);
        let scenario = &moment.scenario;
        let (held, tolerance) = (scenario.target.reference, scenario.target.tolerance_percent);
        let first = change.rows.first;
        let goes_on = told.so_far && end == rows.len();
        // What a hand drags is there at the end of the drag.
        let changed_s = rows[change.begins().saturating_sub(1)].time_s;
        if leaves_part(&change.causes) {
            events.push(air(&place, first, &change.causes));
            before = None;
            before_from = end;
            continue;
        }
        let begins = change.causes.iter().any(|c| matches!(c, Cause::Start | Cause::Contact));
        if begins {
            before = StretchMeans::of(&rows[first..=first], held, tolerance);
        }
        let after = at_the_end(place.stretch(), row_s, held, tolerance);
        let response = StepResponse::of(place.stretch(), changed_s, held, sampling);
        let judged_from_s = changed_s + JUDGED_FROM_S + scenario.cnc.dead_time_s;
        let too_soon = goes_on && rows[end - 1].time_s < judged_from_s;
        let response = response.map(|found| if too_soon { StepResponse::TOO_SHORT } else { found });
        let twin_of = |from: usize, end: usize| {
            let uncontrolled = scenario.controller.kind == ControllerKind::ConstantFeed;
            twin.filter(|_| !uncontrolled)
                .and_then(|twin| twin_means(twin, rows, from, end, scenario))
        };
        let effect = ChangeEffect {
            causes: change.causes.clone(),
            before,
            after,
            twin_before: if begins { None } else { twin_of(before_from, first) },
            twin_after: twin_of(place.from, end),
            response,
            excursion: excursion(place.stretch(), row_s, (scenario, control_every)),
        };
        let mut event = StoryEvent {
            id: words::kind(&change.causes),
            from_s: rows[first].time_s,
            to_s: rows[end - 1].time_s,
            position_mm: rows[first].position_mm,
            sentence: words::change(&effect, scenario, twin.map(Run::scenario), goes_on)
                + told
                    .next_depth_s(change.rows.last)
                    .map_or(String::new(), |next_s| words::shows_later(&effect, scenario, next_s))
                    .as_str(),
            figures: Figures::Change(Box::new(effect)),
        };
        if let Some(answer) = first_answer(&place, change, scenario) {
            let figures = Figures::Answer(answer);
            let to_s = rows[first.saturating_sub(1)].time_s + answer.feed_after_s;
            let sentence = words::first_answer(&answer, &change.causes, scenario);
            let dead =
                StoryEvent { id: EventKind::DeadTime, to_s, figures, sentence, ..event.clone() };
            events.push(event.clone());
            events.push(dead);
        } else {
            events.push(event.clone());
        }
        if let Some(response) = response.filter(|r| r.ends == ResponseEnd::Unstable)
            && let Some(oscillation) = response.oscillation
        {
            let cycle = LimitCycle { oscillation, dead_time_s: scenario.cnc.dead_time_s };
            event.id = EventKind::LimitCycle;
            event.sentence = words::limit_cycle(&cycle);
            event.figures = Figures::LimitCycle(cycle);
            // Beginning with its first period: the step itself comes before it.
            event.from_s = (changed_s + oscillation.period_s).min(event.to_s);
            event.position_mm = rows[run.recording().index_at(event.from_s)].position_mm;
            events.push(event);
        }
        before = after;
        before_from = place.from;
    }
    events.extend(wear(told, changes));
    events
}

/// How far what is judged was out of its tolerance within a stretch.
fn excursion(
    stretch: &[Row],
    row_s: f64,
    (scenario, control_every): (&Scenario, u64),
) -> Option<Excursion> {
    let held = scenario.target.reference;
    let judged = Judged::by(scenario, control_every);
    let value = |row: &Row| match (held, judged.shakes()) {
        (Reference::Ra, true) => shaken_deviation(row).zip(shaken_ra_um(row)),
        (Reference::Ra, false) => deviation(row, held).zip(produced_ra_um(row)),
        (Reference::Force, _) => deviation(row, held).map(|off| (off, row.force_n)),
    };
    // Below the range of its model nothing is known but that it is smooth.
    let in_range = |row: &Row| held == Reference::Force || !row.has(flag::K5_OUTSIDE);
    let strays = stretch.iter().filter(|row| judged.strays(row));
    let outside =
        strays.filter_map(|row| value(row).filter(|(off, _)| *off > 0.0 || in_range(row)));
    // What is too rough is scrap, and comes before what is smoother, however far that is off.
    let rank = |off: f64| if off > 0.0 { (true, off) } else { (false, -off) };
    let (mut rows, mut furthest) = (0_usize, ((false, 0.0_f64), 0.0));
    for (off, value) in outside {
        rows += 1;
        if rank(off) > furthest.0 {
            furthest = (rank(off), value);
        }
    }
    (rows > 0).then_some(Excursion { outside_s: rows as f64 * row_s, furthest: furthest.1 })
}

/// Whether the tool comes into the air, and nothing but a disturbance goes with it.
fn leaves_part(causes: &[Cause]) -> bool {
    causes.contains(&Cause::Air)
        && causes.iter().all(|cause| matches!(cause, Cause::Air | Cause::Disturbance { .. }))
}

fn air(place: &Place<'_>, first: usize, causes: &[Cause]) -> StoryEvent {
    let (from, to) = (&place.rows[first], &place.rows[place.end - 1]);
    let cut = AirCut { length_mm: to.position_mm - from.position_mm, feed_mm_min: to.feed_mm_min };
    StoryEvent {
        id: EventKind::Air,
        from_s: from.time_s,
        to_s: to.time_s,
        position_mm: from.position_mm,
        sentence: words::air(&cut, causes),
        figures: Figures::Air(cut),
    }
}

/// The twin's means at the end of the way that `rows[from..end]` cover; none where it has not been
/// there in the same conditions.
fn twin_means(
    twin: &Run,
    rows: &[Row],
    from: usize,
    end: usize,
    scenario: &Scenario,
) -> Option<StretchMeans> {
    let all = twin.recording().rows();
    let stretch = rows.get(from..end).filter(|stretch| !stretch.is_empty())?;
    let (first, last) = (&stretch[0], &stretch[stretch.len() - 1]);
    // Up to the last row that is not beyond: the next one may lie behind a step.
    let begin = all.partition_point(|row| row.position_mm < first.position_mm);
    let end = all.partition_point(|row| row.position_mm <= last.position_mm);
    let found = all.get(begin..end).filter(|found| !found.is_empty())?;
    let reached = &found[found.len() - 1];
    // A millisecond of feed short of it is as good as there.
    if end == all.len() && last.position_mm - reached.position_mm > NEAR_MM {
        return None;
    }
    let (held, tolerance) = (scenario.target.reference, scenario.target.tolerance_percent);
    let same = |a: f64, b: f64| (a - b).abs() < 1e-9;
    let alike = same(reached.axial_depth_mm, last.axial_depth_mm)
        && same(reached.ra_target_um, last.ra_target_um)
        && same(reached.force_ref_n, last.force_ref_n);
    if !alike {
        return None;
    }
    at_the_end(found, twin.recording().row_s(), held, tolerance)
}

/// When command and feed leave what they were in the second before the change, if the controller
/// answers at all; told where there is a dead time.
fn first_answer(place: &Place<'_>, change: &Change, scenario: &Scenario) -> Option<FirstAnswer> {
    let dead_time_s = scenario.cnc.dead_time_s;
    if dead_time_s <= 0.0 {
        return None;
    }
    let first = change.rows.first;
    let second = (1.0 / place.row_s) as usize;
    let known = &place.rows[first.saturating_sub(second)..first.max(1)];
    let answers = |of: fn(&Row) -> f64| {
        let [low, high] = extent(known.iter().map(of));
        let margin = ANSWERS * high.abs();
        let after = place.rows[first..place.end].iter();
        let mut after = after.skip_while(|row| (low - margin..=high + margin).contains(&of(row)));
        after.next()
    };
    let command = answers(|row| row.feed_command_mm_min)?;
    let feed = answers(|row| row.feed_mm_min)?;
    let changed_s = place.rows[first.saturating_sub(1)].time_s;
    let waiting = place.rows[first..place.end].iter().take_while(|row| row.time_s < feed.time_s);
    let held = scenario.target.reference;
    let worst = waiting.filter_map(|row| deviation(row, held));
    let worst = worst.reduce(|most, next| if next.abs() > most.abs() { next } else { most });
    let command_after_s = command.time_s - changed_s;
    let feed_after_s = feed.time_s - changed_s;
    (feed_after_s >= command_after_s).then_some(FirstAnswer {
        command_after_s,
        feed_after_s,
        dead_time_s,
        deviation_percent: worst.map(percent_from_ratio),
    })
}

/// Wear over the whole run, with its effect where nothing else differs between start and end.
fn wear(told: &Told<'_>, changes: &[Change]) -> Option<StoryEvent> {
    let Told { run, rows, twin, .. } = *told;
    let (first, last) = (rows.first()?, rows.last()?);
    if last.used_life - first.used_life < LEAST_WEAR {
        return None;
    }
    let row_s = run.recording().row_s();
    let scenario = run.scenario();
    let (held, tolerance) = (scenario.target.reference, scenario.target.tolerance_percent);
    let settings = changes.iter().flat_map(|change| &change.causes);
    let unchanged = !settings.into_iter().any(|cause| {
        matches!(
            cause,
            Cause::Setting { .. }
                | Cause::TargetRa { .. }
                | Cause::ReferenceForce { .. }
                | Cause::Disturbance { .. }
        )
    });
    // A second of the start once the loop has had a second to come to rest, and the last one.
    let second = (1.0 / row_s) as usize;
    let contact = rows.iter().position(|row| !row.has(flag::AIR))?;
    let early = (contact + second).min(rows.len())..(contact + 2 * second).min(rows.len());
    let late = rows.len().saturating_sub(second)..rows.len();
    let alike = rows.get(early.start).is_some_and(|row| {
        row.axial_depth_mm == last.axial_depth_mm && row.radial_depth_mm == last.radial_depth_mm
    });
    let means = |range: &std::ops::Range<usize>| {
        let alone = unchanged && alike && early.end <= late.start;
        StretchMeans::of(&rows[range.clone()], held, tolerance).filter(|_| alone)
    };
    let twin_of = |range: &std::ops::Range<usize>| {
        let uncontrolled = scenario.controller.kind == ControllerKind::ConstantFeed;
        let twin = twin.filter(|_| !uncontrolled)?;
        means(range).and_then(|_| twin_means(twin, rows, range.start, range.end, scenario))
    };
    let effect = WearEffect {
        used_from_percent: percent_from_ratio(first.used_life),
        used_to_percent: percent_from_ratio(last.used_life),
        before: means(&early),
        after: means(&late),
        twin_before: twin_of(&early),
        twin_after: twin_of(&late),
    };
    Some(StoryEvent {
        id: EventKind::Wear,
        from_s: first.time_s,
        to_s: last.time_s,
        position_mm: first.position_mm,
        sentence: words::wear(&effect, twin.map(Run::scenario), told.so_far),
        figures: Figures::Wear(Box::new(effect)),
    })
}

/// The stretches of time in s of all events of a kind, those of neighbours joined: a limit cycle is told of
/// from its first period after a change on.
pub(super) fn spans(events: &[StoryEvent], kind: EventKind) -> Vec<[f64; 2]> {
    let mut found: Vec<[f64; 2]> = Vec::new();
    for event in events.iter().filter(|event| event.id == kind) {
        let gap_s = match &event.figures {
            Figures::LimitCycle(cycle) => 1.5 * cycle.oscillation.period_s,
            Figures::Change(_)
            | Figures::Air(_)
            | Figures::Answer(_)
            | Figures::Limit(_)
            | Figures::Outside(_)
            | Figures::Chatter(_)
            | Figures::Wear(_)
            | Figures::End(_) => 0.0,
        };
        match found.last_mut() {
            Some(last) if event.from_s <= last[1] + gap_s => last[1] = last[1].max(event.to_s),
            _ => found.push([event.from_s, event.to_s]),
        }
    }
    found
}

/// What the cut was on the way and is not at its end: who sees the end alone is told of it.
fn was(events: &[StoryEvent]) -> String {
    let stretches = |kind| words::stretches(&spans(events, kind));
    let mut told = String::new();
    let unstable = stretches(EventKind::LimitCycle);
    if !unstable.is_empty() {
        told = format!(" {}", tr!("It was unstable {stretches}.", stretches = unstable));
    }
    let chattered = stretches(EventKind::Chatter);
    if !chattered.is_empty() {
        told += &format!(" {}", tr!("It chattered {stretches}.", stretches = chattered));
    }
    told
}

/// The end of the run, with its cause, and with what its events say against it.
pub(super) fn end(run: &Run, rows: &[Row], events: &[StoryEvent]) -> Option<StoryEvent> {
    let last = rows.last()?;
    let done = WayDone {
        path_mm: last.position_mm,
        of_mm: ToolPath::length_of(&run.scenario().workpiece),
        verdict: CutVerdict::of(run),
    };
    let sentence = match run.end()? {
        End::PathDone => {
            tr!("The cut is finished: {length} of path.", length = words::mm(done.path_mm))
        }
        End::TimeLimit => tr!(
            "The time limit ends the run with {done} of {whole} cut.",
            done = words::mm(done.path_mm),
            whole = words::mm(done.of_mm)
        ),
        end @ (End::Overload(_)
        | End::Crash(_)
        | End::Breakage(_)
        | End::Fault(_)
        | End::Refused(_)
        | End::Script(_)) => {
            format!("{end}.")
        }
    };
    let judged = words::verdict(&done.verdict, run.scenario());
    let sentence = sentence + judged.as_str() + was(events).as_str();
    Some(StoryEvent {
        id: EventKind::End,
        from_s: last.time_s,
        to_s: last.time_s,
        position_mm: last.position_mm,
        figures: Figures::End(done),
        sentence,
    })
}
