//! The sentences: figures in plain English.

use super::EventKind;
use super::changes::Cause;
use super::figures::{
    AirCut, ChangeEffect, Chatter, ChatterEnd, FirstAnswer, LimitCycle, LimitReached,
    LimitedCommand, RangeLeft, WearEffect,
};
use super::means::StretchMeans;
use super::response::ResponseEnd;
use crate::base::equation::number;
use crate::blocks::control::ControllerKind;
use crate::blocks::reference::Reference;
use crate::run::scenario::{Scenario, param};

/// A feed that changes by less than this is kept, percent.
const KEPT_PERCENT: f64 = 0.5;
/// A remaining error below this is none, percent.
const NO_ERROR_PERCENT: f64 = 0.05;
/// Most stretches of time that are told one by one.
const MOST_STRETCHES: usize = 3;
/// A spindle speed that changes by less than this is not spoken of, percent.
const SPEED_KEPT_PERCENT: f64 = 1.0;

pub(super) fn mm(x: f64) -> String {
    format!("{x:.1} mm")
}

pub(super) fn newtons(x: f64) -> String {
    format!("{x:.0} N")
}

fn um(x: f64) -> String {
    format!("{x:.2} µm")
}

fn depth(x: f64) -> String {
    format!("{x:.2} mm")
}

fn feed(x: f64) -> String {
    format!("{x:.0} mm/min")
}

fn rpm(x: f64) -> String {
    format!("{x:.0} 1/min")
}

fn seconds(x: f64) -> String {
    format!("{x:.2} s")
}

fn percent(x: f64) -> String {
    if x.abs() < 9.95 { format!("{x:.1} %") } else { format!("{x:.0} %") }
}

/// What happens most, for the event's kind: a depth before a target, a target before a setting.
pub(super) fn kind(causes: &[Cause]) -> EventKind {
    let of = |cause: &Cause| match cause {
        Cause::Start => EventKind::Start,
        Cause::Contact => EventKind::Contact,
        Cause::Air => EventKind::Air,
        Cause::Depth { .. } | Cause::RadialDepth { .. } => EventKind::DepthStep,
        Cause::TargetRa { .. } | Cause::ReferenceForce { .. } => EventKind::TargetChange,
        Cause::Setting { .. } => EventKind::SettingChange,
    };
    let found: Vec<EventKind> = causes.iter().map(of).collect();
    let order = [
        EventKind::Start,
        EventKind::Contact,
        EventKind::DepthStep,
        EventKind::TargetChange,
        EventKind::SettingChange,
    ];
    order.into_iter().find(|kind| found.contains(kind)).unwrap_or(EventKind::Air)
}

fn deeper(what: &str, from_mm: f64, to_mm: f64) -> String {
    let size = depth((to_mm - from_mm).abs());
    let way = if to_mm > from_mm { "deeper" } else { "shallower" };
    match what {
        "" => format!("the part gets {size} {way} here"),
        what => format!("the {what} goes from {} to {}", depth(from_mm), depth(to_mm)),
    }
}

fn cause(cause: &Cause, scenario: &Scenario) -> String {
    match cause {
        Cause::Start => format!(
            "the cut begins at the programmed {} and {}",
            feed(scenario.programmed(0).feed_mm_min),
            rpm(scenario.programmed(0).speed_rpm)
        ),
        Cause::Contact => "the tool meets the part".to_owned(),
        Cause::Air => "the tool leaves the part".to_owned(),
        Cause::Depth { from_mm, to_mm } => deeper("", *from_mm, *to_mm),
        Cause::RadialDepth { from_mm, to_mm } => deeper("radial depth", *from_mm, *to_mm),
        Cause::TargetRa { from_um, to_um } => {
            format!("the target Ra goes from {} to {}", um(*from_um), um(*to_um))
        }
        Cause::ReferenceForce { from_n, to_n } => {
            format!("the reference force goes from {} to {}", newtons(*from_n), newtons(*to_n))
        }
        Cause::Setting { path, from, to } => {
            let label = param(path).map_or(path.as_str(), |param| param.spec.label);
            format!("{label} goes from {from} to {to}")
        }
    }
}

fn causes(causes: &[Cause], scenario: &Scenario) -> String {
    // With the tool coming into the part, the depth grows from nothing: that says no more.
    let contact = causes.contains(&Cause::Contact);
    let told = causes.iter().filter(|cause| !(contact && matches!(cause, Cause::Depth { .. })));
    told.map(|of| cause(of, scenario)).collect::<Vec<String>>().join(", and ")
}

fn capital(text: &str) -> String {
    let mut chars = text.chars();
    let first = chars.next().map(char::to_uppercase);
    first.into_iter().flatten().chain(chars).collect()
}

/// What is held, with its value.
fn held(means: &StretchMeans, reference: Reference) -> String {
    match reference {
        Reference::Ra => means.ra_um.map_or("outside the model".to_owned(), um),
        Reference::Force => newtons(means.force_n),
    }
}

fn held_name(reference: Reference) -> &'static str {
    match reference {
        Reference::Ra => "Ra",
        Reference::Force => "the force",
    }
}

/// How the tolerance is met before and after, as a verb.
fn tolerance(before: Option<bool>, after: Option<bool>) -> &'static str {
    match (before, after) {
        (Some(true), Some(true)) => "stays within the tolerance",
        (Some(true), Some(false)) => "leaves the tolerance",
        (Some(false), Some(true)) => "comes into the tolerance",
        (Some(false), Some(false)) => "stays outside the tolerance",
        (None, Some(true)) => "is within the tolerance",
        (None, Some(false)) => "is outside the tolerance",
        (_, None) => "leaves a surface that the model cannot judge",
    }
}

/// Before and after of what is held, in brackets.
fn from_to(before: Option<&StretchMeans>, after: &StretchMeans, reference: Reference) -> String {
    let name = held_name(reference);
    match before {
        Some(before) if before.ra_um.is_some() || after.ra_um.is_some() => {
            format!("({name} {} to {})", held(before, reference), held(after, reference))
        }
        Some(_) | None => format!("({name} {})", held(after, reference)),
    }
}

/// What the feed and the speed do.
fn moved(before: &StretchMeans, after: &StretchMeans) -> String {
    let change = |from: f64, to: f64| if from > 0.0 { 100.0 * (to - from) / from } else { 0.0 };
    let by = change(before.feed_mm_min, after.feed_mm_min);
    let verb = if by < 0.0 { "lowers" } else { "raises" };
    let of_feed = if by.abs() < KEPT_PERCENT {
        format!("keeps the feed at {}", feed(after.feed_mm_min))
    } else {
        let (from, to) = (before.feed_mm_min, feed(after.feed_mm_min));
        format!("{verb} the feed by {} ({from:.0} to {to})", percent(by.abs()))
    };
    let by = change(before.spindle_rpm, after.spindle_rpm);
    let verb = if by < 0.0 { "lowers" } else { "raises" };
    if by.abs() < SPEED_KEPT_PERCENT {
        of_feed
    } else {
        format!("{of_feed}, {verb} the speed by {}", percent(by.abs()))
    }
}

/// The error that remains, named and signed, or that the loop does not come to rest.
fn remains(effect: &ChangeEffect, reference: Reference) -> String {
    let Some(response) = effect.response else { return String::new() };
    let swings = response.told_swing_percent().map_or(String::new(), |swing| {
        format!(", about which {} still moves by ±{}", held_name(reference), percent(swing))
    });
    match (response.ends, response.remaining_error_percent) {
        (ResponseEnd::AtRest, Some(error)) if error.abs() < NO_ERROR_PERCENT => {
            format!(" No error remains{}.", swings.replace("about which", "but"))
        }
        (ResponseEnd::AtRest, Some(error)) => {
            let side = if error < 0.0 { "below" } else { "above" };
            let of = match reference {
                Reference::Ra => "the target Ra",
                Reference::Force => "the reference force",
            };
            format!(" The remaining error is {} {side} {of}{swings}.", percent(error.abs()))
        }
        (ResponseEnd::Moving, _) => " It does not come to rest in this stretch.".to_owned(),
        (ResponseEnd::AtRest, None) | (ResponseEnd::TooShort | ResponseEnd::Unstable, _) => {
            String::new()
        }
    }
}

/// A change and what it does.
pub(super) fn change(effect: &ChangeEffect, scenario: &Scenario) -> String {
    let reference = scenario.target.reference;
    let begin = capital(&causes(&effect.causes, scenario));
    let Some(after) = &effect.after else { return format!("{begin}.") };
    let mut parts = Vec::new();
    if let Some(twin) = &effect.twin_after {
        let before = effect.twin_before.as_ref();
        let verb = tolerance(before.and_then(|before| before.in_tolerance), twin.in_tolerance);
        parts.push(format!("constant feed {verb} {}", from_to(before, twin, reference)));
    }
    parts.push(own(effect, after, scenario));
    format!("{begin}: {}.{}", parts.join(", "), remains(effect, reference))
}

/// What the run itself does.
fn own(effect: &ChangeEffect, after: &StretchMeans, scenario: &Scenario) -> String {
    let reference = scenario.target.reference;
    if effect.response.is_some_and(|response| response.ends == ResponseEnd::Unstable) {
        return "the controller is unstable here, feed and force swing without end".to_owned();
    }
    let before = effect.before.as_ref();
    // The first moment of contact is no state that could be kept or left.
    let contact = effect.causes.contains(&Cause::Contact);
    let settled = before.filter(|_| !contact);
    let verb = tolerance(settled.and_then(|before| before.in_tolerance), after.in_tolerance);
    let swing = effect.response.and_then(|response| response.told_swing_percent());
    // A mean within the tolerance says nothing of how far the swings about it go.
    let off = after.deviation_percent.map_or(0.0, f64::abs);
    let leaves = swing.is_some_and(|swing| off + swing > scenario.target.tolerance_percent);
    let in_the_mean = if leaves && after.in_tolerance == Some(true) { "in the mean " } else { "" };
    let held = format!("{in_the_mean}{}", from_to(settled, after, reference));
    if scenario.controller.kind == ControllerKind::ConstantFeed {
        return format!("the feed stays as programmed and {verb} {held}");
    }
    let does = before.map_or(String::new(), |before| format!(" {} and", moved(before, after)));
    format!("the controller{does} {verb} {held}")
}

/// The tool in the air.
pub(super) fn air(cut: &AirCut) -> String {
    format!(
        "The tool is in the air for {}: no force and no surface; the feed goes to {}.",
        mm(cut.length_mm),
        feed(cut.feed_mm_min)
    )
}

/// The first answer to a change.
pub(super) fn first_answer(answer: &FirstAnswer, of: &[Cause], scenario: &Scenario) -> String {
    let reference = scenario.target.reference;
    let meanwhile = answer.deviation_percent.map_or(String::new(), |deviation| {
        let side = if deviation < 0.0 { "below" } else { "above" };
        let name = held_name(reference);
        format!("; until then {name} goes {} {side} its target", percent(deviation.abs()))
    });
    let after = match kind(of) {
        EventKind::Start => "the start",
        EventKind::Contact => "contact",
        EventKind::DepthStep => "the step",
        EventKind::TargetChange | EventKind::SettingChange => "the change",
        EventKind::Air
        | EventKind::DeadTime
        | EventKind::Saturation
        | EventKind::OutsideModel
        | EventKind::Chatter
        | EventKind::Wear
        | EventKind::LimitCycle
        | EventKind::End => "this",
    };
    format!(
        "The command answers {} after {after}, the feed only after {}, since the command channel has \
         a dead time of {}{meanwhile}.",
        seconds(answer.command_after_s),
        seconds(answer.feed_after_s),
        seconds(answer.dead_time_s)
    )
}

/// A command at a limit.
pub(super) fn limit(reached: &LimitReached, reference: Reference) -> String {
    let (what, value) = match reached.command {
        LimitedCommand::Feed => ("feed", feed(reached.value)),
        LimitedCommand::SpindleSpeed => ("spindle speed", rpm(reached.value)),
    };
    let side = if reached.upper { "upper" } else { "lower" };
    let share = match reached.share_percent {
        all if all > 99.0 => String::new(),
        some => format!(", {some:.0} % of this time"),
    };
    let at = format!(
        "The {what} command stands at its {side} limit, {value} ({:.0} % override){share}",
        reached.override_percent
    );
    let name = held_name(reference);
    match (reached.deviation_percent, reached.in_tolerance) {
        (Some(deviation), Some(inside)) => {
            let side = if deviation < 0.0 { "below" } else { "above" };
            let judged = if inside { "within" } else { "outside" };
            let size = percent(deviation.abs());
            format!("{at}: meanwhile {name} is {size} {side} its target, {judged} the tolerance.")
        }
        (_, None) | (None, _) => format!("{at}; {name} is outside the model meanwhile."),
    }
}

/// A model outside its range.
pub(super) fn outside(left: &RangeLeft) -> String {
    let model = &left.model;
    let Some(input) = left.input else {
        return format!("{model} is used outside what it was made for: its answer is a guess.");
    };
    let [low, high] = input.range;
    let unit = input.unit;
    let range = match (low.is_finite(), high.is_finite()) {
        (true, true) => format!("from {} to {} {unit}", number(low), number(high)),
        (true, false) => format!("from {} {unit} on", number(low)),
        (false, true) => format!("up to {} {unit}", number(high)),
        (false, false) => "elsewhere".to_owned(),
    };
    format!(
        "{model} is used outside its range: the {} goes to {} {unit}, the model holds {range}.",
        input.name,
        number(input.value)
    )
}

/// Chatter.
pub(super) fn chatter(found: &Chatter) -> String {
    let ends = match found.ends {
        ChatterEnd::Depth => "It ends where the depth changes.",
        ChatterEnd::Air => "It ends where the tool leaves the part.",
        ChatterEnd::Itself => "It ends while the depth stays the same.",
        ChatterEnd::GoesOn => "It goes on to the end.",
    };
    format!(
        "Chatter at {} depth and {}: teeth jump out of the cut, and the force goes to {} where it \
         would be {} without vibration. {ends}",
        depth(found.deepest_mm),
        rpm(found.spindle_rpm),
        newtons(found.largest_force_n),
        newtons(found.mean_force_n)
    )
}

/// Wear over the run.
pub(super) fn wear(effect: &WearEffect) -> String {
    let used = format!(
        "The tool wears from {:.0} to {:.0} % of its life in this run",
        effect.used_from_percent, effect.used_to_percent
    );
    let (Some(before), Some(after)) = (&effect.before, &effect.after) else {
        return format!("{used}.");
    };
    let grown = |from: f64, to: f64| {
        let by = 100.0 * (to - from) / from;
        let verb = if by < 0.0 { "falls" } else { "grows" };
        format!("{verb} by {}", percent(by.abs()))
    };
    let force = grown(before.force_n, after.force_n);
    let force = match (&effect.twin_before, &effect.twin_after) {
        (Some(from), Some(to)) => {
            let twin = grown(from.force_n, to.force_n);
            format!("at constant feed the force {twin}, here it {force}")
        }
        (_, None) | (None, _) => format!("the force {force}"),
    };
    let moves = 100.0 * (after.feed_mm_min / before.feed_mm_min - 1.0);
    let feed = if moves.abs() < KEPT_PERCENT {
        format!("with the feed kept at {}", feed(after.feed_mm_min))
    } else {
        format!("while the feed goes from {:.0} to {}", before.feed_mm_min, feed(after.feed_mm_min))
    };
    format!("{used}: {force} {feed}.")
}

/// A limit cycle.
pub(super) fn limit_cycle(cycle: &LimitCycle) -> String {
    let of = &cycle.oscillation;
    let times = if cycle.dead_time_s > 0.0 {
        let times = of.period_s / cycle.dead_time_s;
        let dead = seconds(cycle.dead_time_s);
        format!(", {times:.1} times the dead time of {dead}")
    } else {
        String::new()
    };
    format!(
        "Unstable: feed and force swing without dying down (a limit cycle), with a period of {}{times}; \
         the force by ±{}, the feed by ±{}.",
        seconds(of.period_s),
        percent(of.force_percent),
        percent(of.feed_percent)
    )
}

/// Stretches of time.
pub(super) fn stretches(of: &[[f64; 2]]) -> String {
    let each = of.iter().map(|[from_s, to_s]| format!("from {from_s:.2} to {to_s:.2} s"));
    let each: Vec<String> = each.collect();
    match &each[..] {
        [] => String::new(),
        [one] => one.clone(),
        [first, .., last] if each.len() > MOST_STRETCHES => {
            format!("{} times {first} up to {last}", each.len())
        }
        [before @ .., last] => format!("{} and {last}", before.join(", ")),
    }
}
