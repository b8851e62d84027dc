//! The sentences of what lasts for a while, of wear, and of the end.

use super::super::EventKind;
use super::super::changes::Cause;
use super::super::figures::{
    Chatter, ChatterEnd, FirstAnswer, LimitCycle, LimitReached, LimitedCommand, ModelInput,
    RangeLeft, WearEffect,
};
use super::super::verdict::CutVerdict;
use super::{
    depth, feed, held_name, is_kept, joined, kind, newtons, percent, rpm, seconds, shakes, um,
};
use crate::base::equation::number;
use crate::base::language::{fixed, tr};
use crate::blocks::reference::Reference;
use crate::run::scenario::{Scenario, TwinKind};

/// Most stretches of time that are told one by one.
const MOST_STRETCHES: usize = 3;
/// A share from here on reads as all of it, percent.
const ALL_PERCENT: f64 = 99.95;

/// The first answer to a change.
pub(in crate::run::story) fn first_answer(
    answer: &FirstAnswer,
    of: &[Cause],
    scenario: &Scenario,
) -> String {
    let command = seconds(answer.command_after_s);
    let moves = seconds(answer.feed_after_s);
    let dead = seconds(answer.dead_time_s);
    let told = match kind(of) {
        EventKind::Start => tr!(
            "The command answers {command} after the start, the feed only after {feed}, since the \
             command channel has a dead time of {dead}",
            command = command,
            feed = moves,
            dead = dead
        ),
        EventKind::Contact => tr!(
            "The command answers {command} after contact, the feed only after {feed}, since the \
             command channel has a dead time of {dead}",
            command = command,
            feed = moves,
            dead = dead
        ),
        EventKind::DepthStep => tr!(
            "The command answers {command} after the step, the feed only after {feed}, since the \
             command channel has a dead time of {dead}",
            command = command,
            feed = moves,
            dead = dead
        ),
        EventKind::TargetChange | EventKind::SettingChange => tr!(
            "The command answers {command} after the change, the feed only after {feed}, since the \
             command channel has a dead time of {dead}",
            command = command,
            feed = moves,
            dead = dead
        ),
        EventKind::Disturbance => tr!(
            "The command answers {command} after it, the feed only after {feed}, since the command \
             channel has a dead time of {dead}",
            command = command,
            feed = moves,
            dead = dead
        ),
        EventKind::Air
        | EventKind::DeadTime
        | EventKind::Saturation
        | EventKind::OutsideModel
        | EventKind::Chatter
        | EventKind::Wear
        | EventKind::LimitCycle
        | EventKind::End => tr!(
            "The command answers {command} after this, the feed only after {feed}, since the command \
             channel has a dead time of {dead}",
            command = command,
            feed = moves,
            dead = dead
        ),
    };
    let name = held_name(scenario);
    let meanwhile = answer.deviation_percent.map(|deviation| {
        let size = percent(deviation.abs());
        let clause = if deviation < 0.0 {
            tr!("until then {name} goes {size} below its target", name = name, size = size)
        } else {
            tr!("until then {name} goes {size} above its target", name = name, size = size)
        };
        ("; ", clause)
    });
    joined(told, meanwhile) + "."
}

/// A command at a limit.
pub(in crate::run::story) fn limit(reached: &LimitReached, scenario: &Scenario) -> String {
    let share = reached.override_percent;
    let at = match (reached.command, reached.upper) {
        (LimitedCommand::Feed, true) => tr!(
            "The feed command stands at its upper limit, {value} ({share:.0} % override)",
            value = feed(reached.value),
            share = share
        ),
        (LimitedCommand::Feed, false) => tr!(
            "The feed command stands at its lower limit, {value} ({share:.0} % override)",
            value = feed(reached.value),
            share = share
        ),
        (LimitedCommand::SpindleSpeed, true) => tr!(
            "The spindle speed command stands at its upper limit, {value} ({share:.0} % override)",
            value = rpm(reached.value),
            share = share
        ),
        (LimitedCommand::SpindleSpeed, false) => tr!(
            "The spindle speed command stands at its lower limit, {value} ({share:.0} % override)",
            value = rpm(reached.value),
            share = share
        ),
    };
    let at = match reached.share_percent {
        all if all > 99.0 => at,
        some => tr!("{at}, {share:.0} % of this time", at = at, share = some),
    };
    let name = held_name(scenario);
    let (deviation, inside) = match (reached.deviation_percent, reached.in_tolerance) {
        (Some(deviation), Some(inside)) => (deviation, inside),
        (_, None) | (None, _) => {
            let outside = tr!("{name} is outside the model meanwhile", name = name);
            return format!("{at}; {outside}.");
        }
    };
    if shakes(scenario) {
        return format!("{at}: {}.", shaken_at_limit(reached, deviation));
    }
    let size = percent(deviation.abs());
    let meanwhile = match (deviation < 0.0, inside) {
        (true, true) => tr!(
            "meanwhile {name} is {size} below its target, within the tolerance",
            name = name,
            size = size
        ),
        (true, false) => tr!(
            "meanwhile {name} is {size} below its target, outside the tolerance",
            name = name,
            size = size
        ),
        (false, true) => tr!(
            "meanwhile {name} is {size} above its target, within the tolerance",
            name = name,
            size = size
        ),
        (false, false) => tr!(
            "meanwhile {name} is {size} above its target, outside the tolerance",
            name = name,
            size = size
        ),
    };
    format!("{at}: {meanwhile}.")
}

/// Where Ra is meanwhile in a machine that vibrates in the cut: with dynamics, which is judged, and without.
fn shaken_at_limit(reached: &LimitReached, without_percent: f64) -> String {
    let with = match (reached.deviation_dyn_percent, reached.in_tolerance_dyn) {
        (Some(off), Some(true)) if off < 0.0 => tr!(
            "meanwhile Ra with dynamics is {size} below its target, within the tolerance",
            size = percent(-off)
        ),
        (Some(off), Some(false)) if off < 0.0 => tr!(
            "meanwhile Ra with dynamics is {size} below its target, outside the tolerance",
            size = percent(-off)
        ),
        (Some(off), Some(true)) => tr!(
            "meanwhile Ra with dynamics is {size} above its target, within the tolerance",
            size = percent(off)
        ),
        (Some(off), Some(false)) => tr!(
            "meanwhile Ra with dynamics is {size} above its target, outside the tolerance",
            size = percent(off)
        ),
        (None, _) | (_, None) => {
            tr("meanwhile Ra with dynamics is outside the model instead of at its target")
                .to_owned()
        }
    };
    let without = if without_percent < 0.0 {
        tr!("without dynamics {size} below it", size = percent(-without_percent))
    } else {
        tr!("without dynamics {size} above it", size = percent(without_percent))
    };
    format!("{with}; {without}")
}

/// A model outside its range.
pub(in crate::run::story) fn outside(left: &RangeLeft) -> String {
    // Plain words first: the symbol alone says nothing to those who have not read the papers.
    let model = &left.model;
    let Some(input) = left.input else {
        let used = match left.number {
            1 => tr!(
                "The model of the force for a target Ra ({model}) is used outside what it was made for: \
                 its answer is a guess.",
                model = model
            ),
            2 => tr!(
                "The model of the feed for a force ({model}) is used outside what it was made for: its \
                 answer is a guess.",
                model = model
            ),
            3 => tr!(
                "The model of the speed for a force ({model}) is used outside what it was made for: its \
                 answer is a guess.",
                model = model
            ),
            4 => tr!(
                "The model of the cutting force ({model}) is used outside what it was made for: its \
                 answer is a guess.",
                model = model
            ),
            5 => tr!(
                "The model of Ra ({model}) is used outside what it was made for: its answer is a guess.",
                model = model
            ),
            _ => tr!(
                "The model of Ra with dynamics ({model}) is used outside what it was made for: its \
                 answer is a guess.",
                model = model
            ),
        };
        return used;
    };
    let used = match left.number {
        1 => tr!(
            "The model of the force for a target Ra ({model}) is used outside its range",
            model = model
        ),
        2 => {
            tr!(
                "The model of the feed for a force ({model}) is used outside its range",
                model = model
            )
        }
        3 => {
            tr!(
                "The model of the speed for a force ({model}) is used outside its range",
                model = model
            )
        }
        4 => {
            tr!("The model of the cutting force ({model}) is used outside its range", model = model)
        }
        5 => tr!("The model of Ra ({model}) is used outside its range", model = model),
        _ => {
            tr!("The model of Ra with dynamics ({model}) is used outside its range", model = model)
        }
    };
    let (value, unit) = (format!("{} {}", number(input.value), input.unit), input.unit);
    let goes = match input.name {
        ModelInput::TargetRa => tr!("the target Ra goes to {value}", value = value),
        ModelInput::ForceAskedFor => tr!("the force asked for goes to {value}", value = value),
        ModelInput::Feed => tr!("the feed goes to {value}", value = value),
        ModelInput::SpindleSpeed => tr!("the spindle speed goes to {value}", value = value),
        ModelInput::Force => tr!("the force goes to {value}", value = value),
        ModelInput::ForceWithDynamics => {
            tr!("the force with dynamics goes to {value}", value = value)
        }
    };
    let [low, high] = input.range;
    let holds = match (low.is_finite(), high.is_finite()) {
        (true, true) => tr!(
            "it holds from {low} to {high} {unit}",
            low = number(low),
            high = number(high),
            unit = unit
        ),
        (true, false) => tr!("it holds from {low} {unit} on", low = number(low), unit = unit),
        (false, true) => tr!("it holds up to {high} {unit}", high = number(high), unit = unit),
        (false, false) => tr("it holds elsewhere").to_owned(),
    };
    format!("{used}: {goes}, {holds}.")
}

/// Chatter.
pub(in crate::run::story) fn chatter(found: &Chatter) -> String {
    let ends = match found.ends {
        ChatterEnd::Depth => tr("It ends where the depth changes."),
        ChatterEnd::Air => tr("It ends where the tool leaves the part."),
        ChatterEnd::Itself => tr("It ends while the depth stays the same."),
        ChatterEnd::GoesOn => tr("It goes on to the end."),
        ChatterEnd::SoFar => tr("It still goes on."),
    };
    let (deepest, speed) = (depth(found.deepest_mm), rpm(found.spindle_rpm));
    let (largest, mean) = (newtons(found.largest_force_n), newtons(found.mean_force_n));
    let told = match found.loses_contact {
        true => tr!(
            "Chatter at {depth} depth and {speed}: teeth jump out of the cut, and the force goes to \
             {largest} where it would be {mean} without vibration",
            depth = deepest,
            speed = speed,
            largest = largest,
            mean = mean
        ),
        false => tr!(
            "Chatter at {depth} depth and {speed}: the teeth keep contact, but the vibration does not \
             die down and leaves marks, up to ±{marks:.1} µm from tooth to tooth, and the force goes to \
             {largest} where it would be {mean} without vibration",
            depth = deepest,
            speed = speed,
            marks = found.from_tooth_to_tooth_um,
            largest = largest,
            mean = mean
        ),
    };
    // The marks of the first teeth make no Ra yet.
    let left = found.ra_um.filter(|[with, without]| *with > 1.02 * without);
    let left = left.map(|[with, without]| {
        let clause = tr!(
            "Ra is {with} where it would be {without} without",
            with = um(with),
            without = um(without)
        );
        ("; ", clause)
    });
    format!("{}. {ends}", joined(told, left))
}

/// Wear over the run.
pub(in crate::run::story) fn wear(
    effect: &WearEffect,
    twin: Option<&Scenario>,
    so_far: bool,
) -> String {
    let (from, to) = (effect.used_from_percent, effect.used_to_percent);
    let used = match so_far {
        true => tr!(
            "The tool wears from {from:.0} to {to:.0} % of its life so far",
            from = from,
            to = to
        ),
        false => tr!(
            "The tool wears from {from:.0} to {to:.0} % of its life in this run",
            from = from,
            to = to
        ),
    };
    let (Some(before), Some(after)) = (&effect.before, &effect.after) else {
        return format!("{used}.");
    };
    let grown = |from: f64, to: f64| {
        let by = 100.0 * (to - from) / from;
        (by < 0.0, percent(by.abs()))
    };
    let (falls, size) = grown(before.force_n, after.force_n);
    let force = match (&effect.twin_before, &effect.twin_after) {
        (Some(from), Some(to)) => {
            let of_twin = wear_of_twin(twin, grown(from.force_n, to.force_n));
            let here = match falls {
                true => tr!("here it falls by {size}", size = size),
                false => tr!("here it grows by {size}", size = size),
            };
            format!("{of_twin}, {here}")
        }
        (_, None) | (None, _) => match falls {
            true => tr!("the force falls by {size}", size = size),
            false => tr!("the force grows by {size}", size = size),
        },
    };
    let to = feed(after.feed_mm_min);
    let told = if is_kept(before, after) {
        tr!("{force} with the feed kept at {feed}", force = force, feed = to)
    } else {
        let from = fixed(before.feed_mm_min, 0);
        tr!("{force} while the feed goes from {from} to {to}", force = force, from = from, to = to)
    };
    format!("{used}: {told}.")
}

/// What wear does to the force of a twin: whether it falls, and by how much.
fn wear_of_twin(twin: Option<&Scenario>, (falls, size): (bool, String)) -> String {
    let kind = twin.map_or(TwinKind::Programmed, |twin| twin.twin.kind);
    match (kind, falls) {
        (TwinKind::Safe, true) => {
            tr!("at safe constant feed the force falls by {size}", size = size)
        }
        (TwinKind::Safe, false) => {
            tr!("at safe constant feed the force grows by {size}", size = size)
        }
        (TwinKind::Programmed, true) => {
            tr!("at constant feed the force falls by {size}", size = size)
        }
        (TwinKind::Programmed, false) => {
            tr!("at constant feed the force grows by {size}", size = size)
        }
    }
}

/// A limit cycle.
pub(in crate::run::story) fn limit_cycle(cycle: &LimitCycle) -> String {
    let of = &cycle.oscillation;
    let period = seconds(of.period_s);
    let (force, feed) = (percent(of.force_percent), percent(of.feed_percent));
    if cycle.dead_time_s > 0.0 {
        tr!(
            "Unstable: feed and force swing without dying down (a limit cycle), with a period of \
             {period}, {times:.1} times the dead time of {dead}; the force by ±{force}, the feed by \
             ±{feed}.",
            period = period,
            times = of.period_s / cycle.dead_time_s,
            dead = seconds(cycle.dead_time_s),
            force = force,
            feed = feed
        )
    } else {
        tr!(
            "Unstable: feed and force swing without dying down (a limit cycle), with a period of \
             {period}; the force by ±{force}, the feed by ±{feed}.",
            period = period,
            force = force,
            feed = feed
        )
    }
}

/// Stretches of time.
pub(in crate::run::story) fn stretches(of: &[[f64; 2]]) -> String {
    let each =
        of.iter().map(|[from, to]| tr!("from {from:.2} to {to:.2} s", from = *from, to = *to));
    let each: Vec<String> = each.collect();
    match &each[..] {
        [] => String::new(),
        [one] => one.clone(),
        [first, .., last] if each.len() > MOST_STRETCHES => {
            tr!("{n} times {first} up to {last}", n = each.len(), first = first, last = last)
        }
        [before @ .., last] => {
            tr!("{first} and {last}", first = before.join(", "), last = last)
        }
    }
}

/// Shares of the time of less are not told, percent (chosen).
const LEAST_OUTSIDE_PERCENT: f64 = 1.0;

/// How long a model was asked outside its range: what is judged then stands on a continued curve.
fn continued(of: &CutVerdict) -> String {
    if of.outside_percent < LEAST_OUTSIDE_PERCENT {
        return String::new();
    }
    let told = tr!(
        "On {share} of the time a model was used outside its range, where it is continued beyond what was measured.",
        share = percent(of.outside_percent)
    );
    format!(" {told}")
}

/// What a whole cut comes to, after its end.
pub(in crate::run::story) fn verdict(of: &CutVerdict, scenario: &Scenario) -> String {
    let Some(share) = of.in_tolerance_percent else { return String::new() };
    if of.not_judged_percent.is_some_and(|unknown| unknown >= ALL_PERCENT) {
        let told = tr(
            "Ra lies outside its model on the whole length: whether the target was held is not known.",
        );
        return format!(" {told}");
    }
    let (tolerance, share) = (number(of.tolerance_percent), of.share_text(share));
    let coupled = scenario.machine.coupled;
    let reference = scenario.target.reference;
    let within = match reference {
        Reference::Ra if of.without_dynamics_percent.is_some() => tr!(
            "Ra with dynamics was within ±{tolerance} % of its target on {share} of the length",
            tolerance = tolerance,
            share = share
        ),
        Reference::Ra if coupled => tr!(
            "Ra without dynamics was within ±{tolerance} % of its target on {share} of the length",
            tolerance = tolerance,
            share = share
        ),
        Reference::Ra => tr!(
            "Ra was within ±{tolerance} % of its target on {share} of the length",
            tolerance = tolerance,
            share = share
        ),
        Reference::Force if coupled => tr!(
            "The force without dynamics was within ±{tolerance} % of its reference on {share} of the \
             length",
            tolerance = tolerance,
            share = share
        ),
        Reference::Force => tr!(
            "The force was within ±{tolerance} % of its reference on {share} of the length",
            tolerance = tolerance,
            share = share
        ),
    };
    let within = match of.without_dynamics_percent {
        Some(without) => tr!(
            "{within} (without dynamics on {share})",
            within = within,
            share = of.share_text(without)
        ),
        None => within,
    };
    let within = match of.longest_out_s {
        none if none < 0.005 => within,
        some => tr!(
            "{within}, and outside for {time} at the longest",
            within = within,
            time = seconds(some)
        ),
    };
    let from = of.held_from_percent;
    let unknown = || percent(of.not_judged_percent.unwrap_or(0.0));
    let judged = match (reference, of.held) {
        (Reference::Ra, Some(true)) => {
            tr!("the target was held (that takes {share:.0} %)", share = from)
        }
        (Reference::Ra, Some(false)) => {
            tr!("the target was not held (that takes {share:.0} %)", share = from)
        }
        (Reference::Ra, None) => tr!(
            "with {unknown} of it outside the model, whether the target was held is not known (that takes \
             {share:.0} %)",
            unknown = unknown(),
            share = from
        ),
        (Reference::Force, Some(true)) => {
            tr!("the reference was held (that takes {share:.0} %)", share = from)
        }
        (Reference::Force, Some(false)) => {
            tr!("the reference was not held (that takes {share:.0} %)", share = from)
        }
        (Reference::Force, None) => tr!(
            "with {unknown} of it outside the model, whether the reference was held is not known (that takes \
             {share:.0} %)",
            unknown = unknown(),
            share = from
        ),
    };
    let above = of.above_tolerance_percent.unwrap_or(100.0);
    match (of.held, reference) {
        // Short of being held, and no scrap.
        (Some(false), Reference::Ra) if above <= 100.0 - from => {
            let smooth = tr!(
                "too rough on {share} alone, elsewhere smoother than asked",
                share = percent(above)
            );
            format!(" {within}: {judged}; {smooth}.{}", continued(of))
        }
        (Some(true | false) | None, _) => format!(" {within}: {judged}.{}", continued(of)),
    }
}
