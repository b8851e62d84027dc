//! The sentences: figures in plain words. Each text for the languages is a whole clause, or a whole predicate.

mod lasting;

pub(super) use lasting::{
    chatter, first_answer, limit, limit_cycle, outside, stretches, verdict, wear,
};

use super::EventKind;
use super::changes::Cause;
use super::figures::{AirCut, ChangeEffect, Excursion};
use super::means::StretchMeans;
use super::response::ResponseEnd;
use crate::base::equation::number;
use crate::base::language::{fixed, text, tr};
use crate::blocks::control::ControllerKind;
use crate::blocks::control::law::AtRest;
use crate::blocks::reference::Reference;
use crate::models::disturbances::Disturbance;
use crate::run::constant_feed_twin;
use crate::run::scenario::{Scenario, TwinKind, param};

/// A feed that changes by less than this is kept, percent.
const KEPT_PERCENT: f64 = 0.5;
/// Nor is one that changes by less than so many times what it scatters by in a stretch (chosen): the means of two
/// stretches of a second, some six independent values each, differ by half as much by chance alone.
const OF_SCATTER: f64 = 1.0;
/// A remaining error below this is none, percent.
const NO_ERROR_PERCENT: f64 = 0.05;
/// While a disturbance acts it is told how far what is judged went once it is outside for so long, s (chosen).
const LEAST_OUTSIDE_S: f64 = 0.05;
/// A value that differs by no more than this fraction is told as the same (chosen).
const SAME: f64 = 0.02;
/// Settings that act only while feed or speed moves: a loop at rest does not show them.
const SHOW_LATER: &[&str] = &[
    "cnc.dead_time_s",
    "cnc.override_rate_limited",
    "cnc.override_rate_percent_s",
    "feed_drive.kind",
    "feed_drive.poles",
    "spindle_drive.time_constant_s",
    "spindle_drive.rate_rpm_s",
    "spindle_drive.poles",
    "belief.dead_time_s",
    "belief.feed_drive",
    "belief.spindle_time_constant_s",
    "belief.spindle_rate_rpm_s",
];
/// A spindle speed that changes by less than this is not spoken of, percent.
const SPEED_KEPT_PERCENT: f64 = 1.0;

pub(super) fn mm(x: f64) -> String {
    fixed(x, 1) + " mm"
}

pub(super) fn newtons(x: f64) -> String {
    fixed(x, 0) + " N"
}

fn um(x: f64) -> String {
    fixed(x, 2) + " µm"
}

fn depth(x: f64) -> String {
    fixed(x, 2) + " mm"
}

fn feed(x: f64) -> String {
    fixed(x, 0) + " mm/min"
}

fn rpm(x: f64) -> String {
    fixed(x, 0) + " 1/min"
}

fn seconds(x: f64) -> String {
    fixed(x, 2) + " s"
}

fn percent(x: f64) -> String {
    fixed(x, if x.abs() < 9.95 { 1 } else { 0 }) + " %"
}

/// Clauses after one another, each behind what parts it from those before.
fn joined(first: String, more: impl IntoIterator<Item = (&'static str, String)>) -> String {
    more.into_iter().fold(first, |all, (mark, clause)| all + mark + clause.as_str())
}

/// What happens most, for the event's kind: a depth before a target, a target before a setting.
pub(super) fn kind(causes: &[Cause]) -> EventKind {
    let of = |cause: &Cause| match cause {
        Cause::Start => EventKind::Start,
        Cause::Contact => EventKind::Contact,
        Cause::Air => EventKind::Air,
        Cause::Depth { .. } | Cause::RadialDepth { .. } => EventKind::DepthStep,
        Cause::TargetRa { .. } | Cause::ReferenceForce { .. } => EventKind::TargetChange,
        Cause::Disturbance { .. } => EventKind::Disturbance,
        Cause::Setting { .. } => EventKind::SettingChange,
    };
    let found: Vec<EventKind> = causes.iter().map(of).collect();
    let order = [
        EventKind::Start,
        EventKind::Disturbance,
        EventKind::Contact,
        EventKind::DepthStep,
        EventKind::TargetChange,
        EventKind::SettingChange,
    ];
    order.into_iter().find(|kind| found.contains(kind)).unwrap_or(EventKind::Air)
}

/// A disturbance that begins: what it is, how large and how long. The sizes stand as their kinds' suffixes have them.
fn disturbance(kind: Disturbance, length_mm: Option<f64>, size: Option<f64>) -> String {
    let size = size.map(number).unwrap_or_default();
    let over = length_mm.map(mm).unwrap_or_default();
    match kind {
        Disturbance::HardSpot => tr!(
            "a hard spot begins here: {size} times the force over {length}",
            size = size,
            length = over
        ),
        Disturbance::Gap => tr!("a gap begins here: over {length}", length = over),
        Disturbance::DepthStep => tr!(
            "a depth step begins here: {size} mm deeper over {length}",
            size = size,
            length = over
        ),
        Disturbance::WearJump => {
            tr!("the tool's wear jumps here: {size} mm more VB", size = size)
        }
        Disturbance::BrokenTooth => {
            tr("a tooth breaks here: the next one cuts its feed too").to_owned()
        }
        Disturbance::ChatterBurst => tr!(
            "a chatter burst begins here: {size} % of the force over {length}, imposed",
            size = size,
            length = over
        ),
        Disturbance::SensorDropout => {
            tr!("the sensor drops out here and reads 0 over {length}", length = over)
        }
        Disturbance::SensorDrift => tr!(
            "a sensor drift begins here: {size} N in the end over {length}",
            size = size,
            length = over
        ),
        Disturbance::DeadTime => tr!(
            "a longer dead time begins here: {size} s longer over {length}",
            size = size,
            length = over
        ),
        Disturbance::Operator => tr!(
            "an operator's override begins here: {size} % of the feed over {length}",
            size = size,
            length = over
        ),
    }
}

/// A disturbance that is over, or has come to what it stays at.
fn disturbance_ends(kind: Disturbance) -> &'static str {
    match kind {
        Disturbance::HardSpot => tr("the hard spot ends here"),
        Disturbance::Gap => tr("the gap ends here"),
        Disturbance::DepthStep => tr("the depth step ends here"),
        Disturbance::WearJump => tr("the wear jump has grown to its end here"),
        Disturbance::BrokenTooth => tr("the broken tooth has grown to its end here"),
        Disturbance::ChatterBurst => tr("the chatter burst ends here"),
        Disturbance::SensorDropout => tr("the sensor dropout ends here"),
        Disturbance::SensorDrift => tr("the sensor drift has grown to its end here"),
        Disturbance::DeadTime => tr("the longer dead time ends here"),
        Disturbance::Operator => tr("the operator's override ends here"),
    }
}

fn cause(cause: &Cause, scenario: &Scenario) -> String {
    match cause {
        Cause::Start => tr!(
            "the cut begins at the programmed {feed} and {speed}",
            feed = feed(scenario.programmed(0).feed_mm_min),
            speed = rpm(scenario.programmed(0).speed_rpm)
        ),
        Cause::Contact => tr("the tool meets the part").to_owned(),
        Cause::Air => tr("the tool leaves the part").to_owned(),
        Cause::Depth { from_mm, to_mm } => {
            let size = depth((to_mm - from_mm).abs());
            if to_mm > from_mm {
                tr!("the part gets {size} deeper here", size = size)
            } else {
                tr!("the part gets {size} shallower here", size = size)
            }
        }
        Cause::RadialDepth { from_mm, to_mm } => tr!(
            "the radial depth goes from {from} to {to}",
            from = depth(*from_mm),
            to = depth(*to_mm)
        ),
        Cause::TargetRa { from_um, to_um } if from_um == to_um => {
            tr!("the target Ra is moved and comes back to {to}", to = um(*to_um))
        }
        Cause::TargetRa { from_um, to_um } => {
            tr!("the target Ra goes from {from} to {to}", from = um(*from_um), to = um(*to_um))
        }
        Cause::Disturbance { kind, begins: false, .. } => disturbance_ends(*kind).to_owned(),
        Cause::Disturbance { kind, length_mm, size, .. } => disturbance(*kind, *length_mm, *size),
        Cause::ReferenceForce { from_n, to_n } if from_n == to_n => {
            tr!("the reference force is moved and comes back to {to}", to = newtons(*to_n))
        }
        Cause::ReferenceForce { from_n, to_n } => tr!(
            "the reference force goes from {from} to {to}",
            from = newtons(*from_n),
            to = newtons(*to_n)
        ),
        Cause::Setting { path, from, to } => {
            let setting = param(path).map_or(path.as_str(), |param| tr(param.spec.label));
            if from == to {
                tr!("{setting} is moved and comes back to {to}", setting = setting, to = to)
            } else {
                tr!("{setting} goes from {from} to {to}", setting = setting, from = from, to = to)
            }
        }
    }
}

fn causes(causes: &[Cause], scenario: &Scenario) -> String {
    // With the tool coming into the part, the depth grows from nothing: that says no more.
    let contact = causes.contains(&Cause::Contact);
    let told = causes.iter().filter(|cause| !(contact && matches!(cause, Cause::Depth { .. })));
    let and = |first, next| tr!("{first}, and {next}", first = first, next = next);
    told.map(|of| cause(of, scenario)).reduce(and).unwrap_or_default()
}

fn capital(text: &str) -> String {
    let mut chars = text.chars();
    let first = chars.next().map(char::to_uppercase);
    first.into_iter().flatten().chain(chars).collect()
}

/// Whether Ra with dynamics is what is judged: Ra is to be held, and the machine vibrates in the cut.
fn shakes(scenario: &Scenario) -> bool {
    scenario.machine.coupled && scenario.target.reference == Reference::Ra
}

/// Whether what is left lies within the tolerance: with dynamics where the machine vibrates in the cut.
fn inside(means: &StretchMeans, scenario: &Scenario) -> Option<bool> {
    if shakes(scenario) { means.in_tolerance_dyn } else { means.in_tolerance }
}

/// A roughness, where there is one.
fn ra(of: Option<f64>) -> String {
    of.map_or_else(|| tr("outside the model").to_owned(), um)
}

/// What is held, with its value.
fn held(means: &StretchMeans, reference: Reference) -> String {
    match reference {
        Reference::Ra => ra(means.ra_um),
        Reference::Force => newtons(means.force_n),
    }
}

/// The name of what is held. Where the machine vibrates in the cut, there is another one with dynamics.
fn held_name(scenario: &Scenario) -> &'static str {
    match (scenario.target.reference, scenario.machine.coupled) {
        (Reference::Ra, false) => "Ra",
        (Reference::Ra, true) => tr("Ra without dynamics"),
        (Reference::Force, false) => tr("the force"),
        (Reference::Force, true) => tr("the force without dynamics"),
    }
}

/// How a tolerance is met.
#[derive(Clone, Copy)]
enum Met {
    Stays,
    Leaves,
    Comes,
    StaysOutside,
    Is,
    IsOutside,
    /// A surface that the model cannot judge.
    Unknown,
    /// Of a twin that is safe: smoother than asked, which is no scrap.
    Smoother,
    /// The same of a force.
    Below,
}

impl Met {
    /// Before and after.
    fn of(before: Option<bool>, after: Option<bool>) -> Self {
        match (before, after) {
            (Some(true), Some(true)) => Self::Stays,
            (Some(true), Some(false)) => Self::Leaves,
            (Some(false), Some(true)) => Self::Comes,
            (Some(false), Some(false)) => Self::StaysOutside,
            (None, Some(true)) => Self::Is,
            (None, Some(false)) => Self::IsOutside,
            (_, None) => Self::Unknown,
        }
    }

    /// What is said of who meets it so, with the values of what is held.
    fn told(self, held: String) -> String {
        match self {
            Self::Stays => tr!("stays within the tolerance {held}", held = held),
            Self::Leaves => tr!("leaves the tolerance {held}", held = held),
            Self::Comes => tr!("comes into the tolerance {held}", held = held),
            Self::StaysOutside => tr!("stays outside the tolerance {held}", held = held),
            Self::Is => tr!("is within the tolerance {held}", held = held),
            Self::IsOutside => tr!("is outside the tolerance {held}", held = held),
            Self::Unknown => {
                tr!("leaves a surface that the model cannot judge {held}", held = held)
            }
            Self::Smoother => tr!("is smoother than asked {held}", held = held),
            Self::Below => tr!("stays below the tolerance {held}", held = held),
        }
    }

    /// The same where the tolerance was left on the way: that it is met at both ends says nothing of what is between.
    fn told_with(
        self,
        out: Excursion,
        ends: [Option<&StretchMeans>; 2],
        scenario: &Scenario,
        held: String,
    ) -> String {
        let furthest = match scenario.target.reference {
            Reference::Ra => um(out.furthest),
            Reference::Force => newtons(out.furthest),
        };
        let of = |end: &StretchMeans| match (scenario.target.reference, shakes(scenario)) {
            (Reference::Ra, false) => end.ra_um,
            (Reference::Ra, true) => end.ra_dyn_um,
            (Reference::Force, _) => Some(end.force_n),
        };
        // What stands in the brackets already is not said again.
        let mut told = ends.into_iter().flatten().filter_map(of);
        let beyond = !told.any(|end| (out.furthest - end).abs() <= SAME * end.abs());
        match self {
            Self::Stays => tr!(
                "is back in the tolerance {held} after {time} outside, furthest {value}",
                held = held,
                time = seconds(out.outside_s),
                value = furthest
            ),
            Self::Is => tr!(
                "comes into the tolerance {held} after {time} outside, furthest {value}",
                held = held,
                time = seconds(out.outside_s),
                value = furthest
            ),
            Self::Leaves | Self::Comes | Self::StaysOutside | Self::IsOutside if beyond => {
                tr!("{met}, furthest {value}", met = self.told(held), value = furthest)
            }
            Self::Leaves
            | Self::Comes
            | Self::StaysOutside
            | Self::IsOutside
            | Self::Unknown
            | Self::Smoother
            | Self::Below => self.told(held),
        }
    }

    /// The same of a mean alone, whose swings go beyond the tolerance.
    fn told_of_mean(self, held: String) -> String {
        match self {
            Self::Stays => tr!("stays within the tolerance in the mean {held}", held = held),
            Self::Comes => tr!("comes into the tolerance in the mean {held}", held = held),
            Self::Is => tr!("is within the tolerance in the mean {held}", held = held),
            Self::Leaves
            | Self::StaysOutside
            | Self::IsOutside
            | Self::Unknown
            | Self::Smoother
            | Self::Below => self.told(held),
        }
    }
}

/// How a twin meets the tolerance before and after: what the safe one is short of is no scrap.
fn twin_meets(twin: &Scenario, before: Option<&StretchMeans>, after: &StretchMeans) -> Met {
    let off = if shakes(twin) { after.deviation_dyn_percent } else { after.deviation_percent };
    let short = inside(after, twin) == Some(false) && off.is_some_and(|d| d < 0.0);
    match (twin.twin.kind, twin.target.reference) {
        (TwinKind::Safe, Reference::Ra) if short => Met::Smoother,
        (TwinKind::Safe, Reference::Force) if short => Met::Below,
        (TwinKind::Safe | TwinKind::Programmed, _) => {
            Met::of(before.and_then(|before| inside(before, twin)), inside(after, twin))
        }
    }
}

/// What Ra is called that is left on the part where the machine vibrates in the cut.
const RA_SHAKEN: &str = text!("Ra with dynamics");

/// Before and after of one of the two Ra that there are then.
fn shaken_values(
    before: Option<&StretchMeans>,
    after: &StretchMeans,
    of: fn(&StretchMeans) -> Option<f64>,
) -> String {
    match before {
        Some(before) => match (of(before), of(after)) {
            (Some(from), Some(to)) => {
                tr!("{from} to {to}", from = fixed(from, 2), to = um(to))
            }
            (None, None) => ra(None),
            (from, to) => tr!("{from} to {to}", from = ra(from), to = ra(to)),
        },
        None => ra(of(after)),
    }
}

/// Before and after of what is held, in brackets.
fn from_to(before: Option<&StretchMeans>, after: &StretchMeans, scenario: &Scenario) -> String {
    let (name, reference) = (held_name(scenario), scenario.target.reference);
    if shakes(scenario) {
        // Judged is what is left on the part; what the controller holds is told beside it.
        let with = shaken_values(before, after, |of| of.ra_dyn_um);
        let without = shaken_values(before, after, |of| of.ra_um);
        if with == without && after.ra_um.is_none() {
            return tr!("({name} {value})", name = "Ra", value = with);
        }
        return tr!("(Ra with dynamics {with}, without {without})", with = with, without = without);
    }
    match before {
        Some(before) if before.ra_um.is_some() || after.ra_um.is_some() => {
            let [from, to] = [held(before, reference), held(after, reference)];
            tr!("({name} {from} to {to})", name = name, from = from, to = to)
        }
        Some(_) | None => {
            tr!("({name} {value})", name = name, value = held(after, reference))
        }
    }
}

/// Whether the feed moves by no more than noise may move it.
fn is_kept(before: &StretchMeans, after: &StretchMeans) -> bool {
    let by = (after.feed_mm_min - before.feed_mm_min).abs();
    let scatter = before.feed_scatter_mm_min.max(after.feed_scatter_mm_min);
    let least = (0.01 * KEPT_PERCENT * before.feed_mm_min).max(OF_SCATTER * scatter);
    before.feed_mm_min <= 0.0 || by < least
}

/// What the feed and the speed do.
fn moved(before: &StretchMeans, after: &StretchMeans) -> String {
    let change = |from: f64, to: f64| if from > 0.0 { 100.0 * (to - from) / from } else { 0.0 };
    let by = change(before.feed_mm_min, after.feed_mm_min);
    let (from, to) = (fixed(before.feed_mm_min, 0), feed(after.feed_mm_min));
    let size = percent(by.abs());
    let of_feed = if is_kept(before, after) {
        tr!("keeps the feed at {feed}", feed = to)
    } else if by < 0.0 {
        tr!("lowers the feed by {size} ({from} to {to})", size = size, from = from, to = to)
    } else {
        tr!("raises the feed by {size} ({from} to {to})", size = size, from = from, to = to)
    };
    let by = change(before.spindle_rpm, after.spindle_rpm);
    if by.abs() < SPEED_KEPT_PERCENT {
        of_feed
    } else if by < 0.0 {
        tr!("{moves}, lowers the speed by {size}", moves = of_feed, size = percent(-by))
    } else {
        tr!("{moves}, raises the speed by {size}", moves = of_feed, size = percent(by))
    }
}

/// The error that remains, named and signed, or that the loop does not come to rest.
fn remains(effect: &ChangeEffect, scenario: &Scenario, goes_on: bool) -> String {
    let Some(response) = effect.response else { return String::new() };
    let swing = response.told_swing_percent().map(percent);
    // The error is that without dynamics, which is said already.
    let name = match scenario.target.reference {
        Reference::Ra => "Ra",
        Reference::Force => tr("the force"),
    };
    let unsettled =
        response.settling_band_percent.filter(|_| swing.is_some() && response.swings_on());
    let unsettled =
        unsettled.map(|band| (": ", tr!("nothing settles within ±{band}", band = percent(band))));
    match (response.ends, response.remaining_error_percent) {
        (ResponseEnd::AtRest, Some(error)) if error.abs() < NO_ERROR_PERCENT => {
            let none = if scenario.machine.coupled {
                tr("No error remains without dynamics")
            } else {
                tr("No error remains")
            };
            let told = match swing {
                Some(swing) => tr!(
                    "{error}, but {name} still moves by ±{swing}",
                    error = none,
                    name = name,
                    swing = swing
                ),
                None => none.to_owned(),
            };
            format!(" {}.", joined(told, unsettled))
        }
        (ResponseEnd::AtRest, Some(error)) => {
            let told = remaining_error(scenario, error);
            let told = match swing {
                Some(swing) => tr!(
                    "{error}, about which {name} still moves by ±{swing}",
                    error = told,
                    name = name,
                    swing = swing
                ),
                None => told,
            };
            // Why an error stays that the law itself leaves.
            let why = stays_by_law(scenario, error)
                .then(|| ("; ", tr("the law has no integral").to_owned()));
            format!(" {}.", joined(told, unsettled.into_iter().chain(why)))
        }
        (ResponseEnd::Moving, _) if goes_on => format!(" {}", tr("It is still on its way.")),
        (ResponseEnd::Moving, _) => {
            format!(" {}", tr("It does not come to rest in this stretch."))
        }
        (ResponseEnd::AtRest, None) | (ResponseEnd::TooShort | ResponseEnd::Unstable, _) => {
            String::new()
        }
    }
}

/// The size of an error at rest and its side, an error in percent.
fn remaining_error(scenario: &Scenario, error: f64) -> String {
    let size = percent(error.abs());
    let below = error < 0.0;
    match (scenario.target.reference, scenario.machine.coupled) {
        (Reference::Ra, false) if below => {
            tr!("The remaining error is {size} below the target Ra", size = size)
        }
        (Reference::Ra, false) => {
            tr!("The remaining error is {size} above the target Ra", size = size)
        }
        (Reference::Ra, true) if below => {
            tr!("Without dynamics {size} below the target Ra remain", size = size)
        }
        (Reference::Ra, true) => {
            tr!("Without dynamics {size} above the target Ra remain", size = size)
        }
        (Reference::Force, false) if below => {
            tr!("The remaining error is {size} below the reference force", size = size)
        }
        (Reference::Force, false) => {
            tr!("The remaining error is {size} above the reference force", size = size)
        }
        (Reference::Force, true) if below => {
            tr!("Without dynamics {size} below the reference force remain", size = size)
        }
        (Reference::Force, true) => {
            tr!("Without dynamics {size} above the reference force remain", size = size)
        }
    }
}

/// Errors of less are not explained, percent (chosen).
const EXPLAINED_PERCENT: f64 = 1.0;

/// Whether an error in percent is one that the controller's law leaves at rest.
fn stays_by_law(scenario: &Scenario, error: f64) -> bool {
    let control = &scenario.controller;
    error.abs() >= EXPLAINED_PERCENT
        && control.kind != ControllerKind::ConstantFeed
        && control.at_rest() == AtRest::WhereTheLawMeetsThePlant
}

/// A change and what it does; what it has done so far where its stretch goes on.
pub(super) fn change(
    effect: &ChangeEffect,
    scenario: &Scenario,
    twin: Option<&Scenario>,
    goes_on: bool,
) -> String {
    let begin = capital(&causes(&effect.causes, scenario));
    if acts_later(effect, scenario) {
        // What feed and speed do meanwhile is the end of something else.
        return format!("{begin}.");
    }
    let Some(after) = &effect.after else { return format!("{begin}.") };
    let ends = effect.response.filter(|_| goes_on).map(|response| response.ends);
    let so_far = match ends {
        // What has only just begun is no state that could be told, but for how far it went.
        Some(ResponseEnd::TooShort) => {
            let disturbed =
                effect.causes.iter().any(|cause| matches!(cause, Cause::Disturbance { .. }));
            let out = effect.excursion.filter(|out| disturbed && out.outside_s >= LEAST_OUTSIDE_S);
            let furthest = out.map(|out| furthest(out, scenario));
            return match furthest {
                Some(furthest) => {
                    tr!("{begin}: so far {furthest}.", begin = begin, furthest = furthest)
                }
                None => format!("{begin}."),
            };
        }
        Some(ResponseEnd::Moving) => true,
        Some(ResponseEnd::AtRest | ResponseEnd::Unstable) | None => false,
    };
    let mut parts = Vec::new();
    if let (Some(of), Some(after)) = (twin, &effect.twin_after) {
        let before = effect.twin_before.as_ref();
        // The safe one's feed is told once, where it begins; the programmed one stands there already.
        let names_feed = of.twin.kind == TwinKind::Safe && effect.causes.contains(&Cause::Start);
        let values = match shakes(scenario) {
            true => tr!(
                "({name} {value})",
                name = tr(RA_SHAKEN),
                value = shaken_values(before, after, |of| of.ra_dyn_um)
            ),
            false => from_to(before, after, scenario),
        };
        let met = twin_meets(of, before, after).told(values);
        let name = constant_feed_twin::name(of);
        parts.push(match names_feed {
            true => {
                tr!("{twin}, {feed}, {met}", twin = name, feed = feed(after.feed_mm_min), met = met)
            }
            false => tr!("{twin} {met}", twin = name, met = met),
        });
    }
    parts.push(own(effect, after, scenario));
    let does = parts.join(", ");
    let told = match so_far {
        true => tr!("{begin}: so far {does}.", begin = begin, does = does),
        false => tr!("{begin}: {does}.", begin = begin, does = does),
    };
    told + remains(effect, scenario, goes_on).as_str()
}

/// How far out of its tolerance what is judged was at the furthest.
fn furthest(out: Excursion, scenario: &Scenario) -> String {
    let time = seconds(out.outside_s);
    match scenario.target.reference {
        Reference::Ra => {
            tr!(
                "{value} Ra at the furthest, {time} outside the tolerance",
                value = um(out.furthest),
                time = time
            )
        }
        Reference::Force => {
            tr!(
                "{value} at the furthest, {time} outside the tolerance",
                value = newtons(out.furthest),
                time = time
            )
        }
    }
}

/// When a change that a loop at rest does not show will show, with the time of the next change of depth, s.
pub(super) fn shows_later(
    effect: &ChangeEffect,
    scenario: &Scenario,
    next_depth_s: Option<f64>,
) -> String {
    if !acts_later(effect, scenario) {
        return String::new();
    }
    let lengthened =
        effect.causes.iter().any(|cause| matches!(cause, Cause::Disturbance { begins: true, .. }));
    if lengthened {
        let told = tr(
            "It acts only while feed or speed moves: where nothing changes within its length, nothing shows.",
        );
        return format!(" {told}");
    }
    if effect.causes.iter().all(|cause| matches!(cause, Cause::Disturbance { .. })) {
        return String::new();
    }
    let told = match next_depth_s {
        Some(at_s) => tr!(
            "It acts only while feed or speed moves: it shows most at the next change of depth, at {time}.",
            time = seconds(at_s)
        ),
        None => {
            tr("It acts only while feed or speed moves: no change of depth lies ahead.").to_owned()
        }
    };
    format!(" {told}")
}

/// Whether nothing changes but what a loop at rest does not show.
fn acts_later(effect: &ChangeEffect, scenario: &Scenario) -> bool {
    let later = effect.causes.iter().all(|cause| match cause {
        Cause::Setting { path, .. } => SHOW_LATER.contains(&path.as_str()),
        Cause::Start
        | Cause::Contact
        | Cause::Air
        | Cause::Depth { .. }
        | Cause::RadialDepth { .. }
        | Cause::TargetRa { .. }
        | Cause::ReferenceForce { .. } => false,
        Cause::Disturbance { kind, .. } => *kind == Disturbance::DeadTime,
    });
    let moves = effect.response.is_some_and(|response| response.is_unstable())
        || scenario.controller.kind == ControllerKind::ConstantFeed;
    later && !moves
}

/// What the run itself does.
fn own(effect: &ChangeEffect, after: &StretchMeans, scenario: &Scenario) -> String {
    if effect.response.is_some_and(|response| response.ends == ResponseEnd::Unstable) {
        return tr("the controller is unstable here, feed and force swing without dying down")
            .to_owned();
    }
    let before = effect.before.as_ref();
    // The first moment of contact is no state that could be kept or left.
    let contact = effect.causes.contains(&Cause::Contact);
    let settled = before.filter(|_| !contact);
    let is_inside = inside(after, scenario);
    let met = Met::of(settled.and_then(|before| inside(before, scenario)), is_inside);
    let swing = effect.response.and_then(|response| response.told_swing_percent());
    // A mean within the tolerance says nothing of how far the swings about it go.
    let off = after.deviation_percent.map_or(0.0, f64::abs);
    let leaves = swing.is_some_and(|swing| off + swing > scenario.target.tolerance_percent);
    let held = from_to(settled, after, scenario);
    let met = match effect.excursion {
        _ if leaves => met.told_of_mean(held),
        Some(out) => met.told_with(out, [settled, Some(after)], scenario, held),
        None => met.told(held),
    };
    if scenario.controller.kind == ControllerKind::ConstantFeed {
        return tr!("the cut at the programmed feed {met}", met = met);
    }
    match before {
        Some(before) => {
            tr!("the controller {moves} and {met}", moves = moved(before, after), met = met)
        }
        None => tr!("the controller {met}", met = met),
    }
}

/// Words as a sentence, with a space behind it.
fn sentence(words: &str) -> String {
    let mut letters = words.chars();
    let first: String = letters.next().into_iter().flat_map(char::to_uppercase).collect();
    format!("{first}{}. ", letters.as_str())
}

/// The tool in the air.
pub(super) fn air(cut: &AirCut, causes: &[Cause]) -> String {
    let disturbed = causes.iter().filter_map(|cause| match cause {
        Cause::Disturbance { kind, begins: true, length_mm, size } => {
            Some(sentence(&disturbance(*kind, *length_mm, *size)))
        }
        Cause::Disturbance { .. }
        | Cause::Start
        | Cause::Contact
        | Cause::Air
        | Cause::Depth { .. }
        | Cause::RadialDepth { .. }
        | Cause::TargetRa { .. }
        | Cause::ReferenceForce { .. }
        | Cause::Setting { .. } => None,
    });
    let disturbed: String = disturbed.collect();
    let in_air = tr!(
        "The tool is in the air for {length}: no force and no surface; the feed goes to {feed}.",
        length = mm(cut.length_mm),
        feed = feed(cut.feed_mm_min)
    );
    disturbed + in_air.as_str()
}
