//! Where something changes in a run: the start, a depth, a target, a setting, air and contact. What
//! comes within a moment is one change, as the depth is along a ramp; what a hand drags is one, from the
//! value before the drag to the value at its end.

use serde::Serialize;

use super::super::edits::Edit;
use super::super::one_run::Run;
use super::super::scenario::{Param, param};
use super::super::signals::{Row, flag};
use super::scan::{RowSpan, Scan, joined};
use crate::base::language::{decimal, tr};
use crate::base::settings::{Kind, Value};
use crate::blocks::reference::Reference;
use crate::models::disturbances::Disturbance;

/// Changes nearer than this are one, s (chosen).
const ONE_S: f64 = 0.25;
/// Changes of the same setting nearer than this are one, s (chosen): a hand drags it.
pub const ONE_DRAG_S: f64 = 1.0;
/// The air between two contacts shorter than this is no event of its own, s (chosen).
pub(super) const LEAST_AIR_S: f64 = 0.1;

/// What changes.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "what", rename_all = "snake_case")]
pub enum Cause {
    /// The run begins.
    Start,
    /// The tool comes into contact.
    Contact,
    /// The tool leaves the material.
    Air,
    /// The depth of cut, mm.
    Depth {
        /// Before.
        from_mm: f64,
        /// After.
        to_mm: f64,
    },
    /// The radial depth of cut, mm.
    RadialDepth {
        /// Before.
        from_mm: f64,
        /// After.
        to_mm: f64,
    },
    /// The target roughness, um.
    TargetRa {
        /// Before.
        from_um: f64,
        /// After.
        to_um: f64,
    },
    /// The reference force, N.
    ReferenceForce {
        /// Before.
        from_n: f64,
        /// After.
        to_n: f64,
    },
    /// A disturbance along the way.
    Disturbance {
        /// Its kind.
        kind: Disturbance,
        /// Whether it begins here; otherwise it ends.
        begins: bool,
        /// Its length, mm; none of one that stays.
        length_mm: Option<f64>,
        /// Its size in the unit of its kind; none of one without a size.
        size: Option<f64>,
    },
    /// Another setting.
    Setting {
        /// Its path.
        path: String,
        /// Before, for people.
        from: String,
        /// After, for people.
        to: String,
    },
}

/// One change: the rows on which it comes, and what changes.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Change {
    pub rows: RowSpan,
    pub causes: Vec<Cause>,
}

impl Change {
    /// The row with which what it does begins: the last one of what a hand moves, the first one of what the way
    /// brings.
    pub fn begins(&self) -> usize {
        let by_hand = self.causes.iter().all(|cause| match cause {
            Cause::TargetRa { .. } | Cause::ReferenceForce { .. } | Cause::Setting { .. } => true,
            Cause::Start
            | Cause::Contact
            | Cause::Air
            | Cause::Depth { .. }
            | Cause::RadialDepth { .. }
            | Cause::Disturbance { .. } => false,
        });
        if by_hand { self.rows.last } else { self.rows.first }
    }
}

fn depth(rows: &[Row], span: RowSpan) -> Vec<Cause> {
    let (before, after) = (&rows[span.first - 1], &rows[span.last]);
    let mut causes = Vec::new();
    if before.axial_depth_mm != after.axial_depth_mm {
        let (from_mm, to_mm) = (before.axial_depth_mm, after.axial_depth_mm);
        causes.push(Cause::Depth { from_mm, to_mm });
    } else if before.radial_depth_mm != after.radial_depth_mm {
        let (from_mm, to_mm) = (before.radial_depth_mm, after.radial_depth_mm);
        causes.push(Cause::RadialDepth { from_mm, to_mm });
    }
    causes
}

fn reference(rows: &[Row], span: RowSpan, held: Reference) -> Vec<Cause> {
    let (before, after) = (&rows[span.first - 1], &rows[span.last]);
    match held {
        Reference::Ra if before.ra_target_um != after.ra_target_um => {
            vec![Cause::TargetRa { from_um: before.ra_target_um, to_um: after.ra_target_um }]
        }
        // The force that the same Ra asks for, by another belief.
        Reference::Ra | Reference::Force => {
            vec![Cause::ReferenceForce { from_n: before.force_ref_n, to_n: after.force_ref_n }]
        }
    }
}

/// A value for people, with its unit.
fn text(param: &Param, value: &Value) -> String {
    let words = match (&param.spec.allowed, value) {
        (Kind::Choice { options }, Value::Text(id)) => {
            let option = options.iter().find(|option| option.id == *id);
            option.map_or(id.clone(), |option| tr(option.label).to_owned())
        }
        (_, Value::Bool(on)) => if *on { tr("on") } else { tr("off") }.to_owned(),
        (_, Value::List(_)) => tr("another one").to_owned(),
        (_, Value::Text(text)) => text.clone(),
        (_, value @ (Value::Int(_) | Value::Float(_))) => decimal(value.to_string()),
    };
    format!("{words} {}", param.spec.unit.replace("um", "µm")).trim_end().to_owned()
}

/// What an edit changes; none where that is seen in the rows, or where it only judges.
fn setting(edit: &Edit, before: Option<&Value>) -> Option<Cause> {
    let seen =
        ["target.", "workpiece.", "disturbances."].iter().any(|group| edit.path.starts_with(group));
    let param = param(&edit.path).ok().filter(|_| !seen)?;
    let from = before.map_or(String::new(), |value| text(param, value));
    let to = text(param, &edit.value);
    (from != to).then(|| Cause::Setting { path: edit.path.clone(), from, to })
}

/// All changes of a run, in order; the first one is its start.
pub(super) fn changes(run: &Run, scan: &Scan, rows: &[Row]) -> Vec<Change> {
    let row_s = run.recording().row_s();
    let gap = |time_s: f64| (time_s / row_s) as usize;
    let held = run.scenario().target.reference;
    let air = scan.flagged(flag::AIR, gap(LEAST_AIR_S));
    let one = |row| RowSpan { first: row, last: row };
    let begins_in_air = air.first().is_some_and(|span| span.first == 0);
    let begins = if begins_in_air { Cause::Air } else { Cause::Start };
    let mut all = vec![Change { rows: one(0), causes: vec![begins] }];
    for span in air {
        if gap(LEAST_AIR_S) > span.last - span.first {
            continue;
        }
        if span.first > 0 {
            all.push(Change { rows: one(span.first), causes: vec![Cause::Air] });
        }
        if span.last + 1 < rows.len() {
            all.push(Change { rows: one(span.last + 1), causes: vec![Cause::Contact] });
        }
    }
    let in_contact =
        |span: &RowSpan| !rows[span.first - 1].has(flag::AIR) && !rows[span.last].has(flag::AIR);
    for span in joined(scan.depth(), gap(ONE_S)).into_iter().filter(in_contact) {
        all.push(Change { rows: span, causes: depth(rows, span) });
    }
    for span in joined(scan.reference(), gap(ONE_DRAG_S)) {
        all.push(Change { rows: span, causes: reference(rows, span, held) });
    }
    let mut now = run.scenario().clone();
    for edit in run.edits().list() {
        let before = now.get(&edit.path).ok();
        if now.set(&edit.path, edit.value.clone()).is_err() {
            // The run ends there.
            break;
        }
        let row = run.recording().index_at(edit.at_s) + 1;
        if row < rows.len()
            && let Some(cause) = setting(edit, before.as_ref())
        {
            all.push(Change { rows: one(row), causes: vec![cause] });
        }
    }
    all.extend(super::met::disturbances(run, rows));
    all.retain(|change| !change.causes.is_empty());
    all.sort_by_key(|change| change.rows.first);
    merged(all, gap(ONE_S), gap(ONE_DRAG_S))
}

/// Whether two changes are of the same setting or target and of nothing else.
fn are_of_one(a: &[Cause], b: &[Cause]) -> bool {
    match (a, b) {
        ([Cause::Setting { path: a, .. }], [Cause::Setting { path: b, .. }]) => a == b,
        ([Cause::TargetRa { .. }], [Cause::TargetRa { .. }])
        | ([Cause::ReferenceForce { .. }], [Cause::ReferenceForce { .. }]) => true,
        ([..], [..]) => false,
    }
}

fn merged(all: Vec<Change>, near: usize, drag: usize) -> Vec<Change> {
    let mut found: Vec<Change> = Vec::new();
    for change in all {
        let dragged = found.last().is_some_and(|last| are_of_one(&last.causes, &change.causes));
        let gap = if dragged { drag } else { near };
        match found.last_mut() {
            Some(last) if change.rows.first <= last.rows.last + gap => {
                last.rows.last = last.rows.last.max(change.rows.last);
                change.causes.into_iter().for_each(|cause| take_in(&mut last.causes, cause));
            }
            _ => found.push(change),
        }
    }
    found
}

/// What is changed again and again goes from its first value to its last.
fn take_in(causes: &mut Vec<Cause>, cause: Cause) {
    for known in causes.iter_mut() {
        match (known, &cause) {
            (Cause::Setting { path: same, to: last, .. }, Cause::Setting { path, to, .. })
                if same == path =>
            {
                last.clone_from(to);
                return;
            }
            (Cause::TargetRa { to_um: last, .. }, Cause::TargetRa { to_um: to, .. })
            | (Cause::ReferenceForce { to_n: last, .. }, Cause::ReferenceForce { to_n: to, .. }) => {
                *last = *to;
                return;
            }
            (
                Cause::Start
                | Cause::Contact
                | Cause::Air
                | Cause::Depth { .. }
                | Cause::RadialDepth { .. }
                | Cause::TargetRa { .. }
                | Cause::ReferenceForce { .. }
                | Cause::Disturbance { .. }
                | Cause::Setting { .. },
                _,
            ) => {}
        }
    }
    causes.push(cause);
}
