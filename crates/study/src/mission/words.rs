//! Conditions in words: the names that a mission's file has are for files, a learner reads what they stand for.

use super::Mission;
use super::condition::{Condition, Quantity, Relation};
use super::value::{MissionValue, RunOf, Taken, Window};
use crate::base::language::{decimal, text, tr};
use crate::run::scenario::param;
use crate::run::signals::signal;

/// Writes a number, as the file has it, with its unit.
pub type WriteNumber<'a> = &'a dyn Fn(&str, &str) -> String;

impl Mission {
    /// A condition in words, its numbers with their units as `write` has them.
    #[must_use]
    pub fn in_words(&self, condition: &Condition, write: WriteNumber<'_>) -> String {
        let [left, right] = condition.quantities();
        if let Some(text) = self.nearness(left, condition.comparison(), right, write) {
            return text;
        }
        // A bare number is of the unit of what it is compared with.
        let unit = |side: &Quantity| side.as_name().map_or("", |name| self.unit_of(name));
        let beside = left.as_name();
        let (left, right) = (
            self.side(left, None, unit(right), write),
            self.side(right, beside, unit(left), write),
        );
        match condition.comparison() {
            Relation::AtMost => tr!("{left}: at most {right}", left = left, right = right),
            Relation::AtLeast => tr!("{left}: at least {right}", left = left, right = right),
            Relation::Equal => tr!("{left}: the same as {right}", left = left, right = right),
            Relation::NotEqual => tr!("{left}: other than {right}", left = left, right = right),
            Relation::Less => tr!("{left}: less than {right}", left = left, right = right),
            Relation::More => tr!("{left}: more than {right}", left = left, right = right),
        }
    }

    /// What a condition came to, in words: the value of its left side, and of its right one where that is worked out;
    /// `sides` are their values.
    #[must_use]
    pub fn came_to(
        &self,
        condition: &Condition,
        sides: [Option<f64>; 2],
        write: WriteNumber<'_>,
    ) -> String {
        let [left, right] = condition.quantities();
        let (Some(value), Some(limit)) = (sides[0], sides[1]) else {
            return tr("there is no such value").to_owned();
        };
        if self.nearness(left, condition.comparison(), right, write).is_some() {
            let percent = write(&readable(100.0 * value.sqrt()), "%");
            return tr!("yours is off by {percent}", percent = percent);
        }
        let unit_of = |side: &Quantity| side.as_name().map_or("", |name| self.unit_of(name));
        let unit = Some(unit_of(left)).filter(|unit| !unit.is_empty());
        let unit = unit.unwrap_or_else(|| unit_of(right));
        let value = write(&readable(value), unit);
        if right.to_string().parse::<f64>().is_ok() {
            return tr!("yours: {value}", value = value);
        }
        let limit = write(&readable(limit), unit);
        tr!("yours: {value}, the limit: {limit}", value = value, limit = limit)
    }

    /// `(a / b - 1)^2 <= c^2` is how a file says that a is within a fraction c of b.
    fn nearness(
        &self,
        left: &Quantity,
        comparison: Relation,
        right: &Quantity,
        write: WriteNumber<'_>,
    ) -> Option<String> {
        if comparison != Relation::AtMost {
            return None;
        }
        let inner = left.to_string();
        let inner = inner.strip_prefix('(')?.strip_suffix(" - 1)^2")?;
        let (of, wanted) = inner.split_once(" / ")?;
        let is_plain = |side: &str| !side.is_empty() && !side.contains([' ', '(', ')']);
        if !is_plain(of) || !is_plain(wanted) {
            return None;
        }
        let within: f64 = right.to_string().strip_suffix("^2")?.parse().ok()?;
        let of_unit = if is_name(of) { self.unit_of(of) } else { "" };
        let percent = (1e6 * within).round() / 1e4;
        Some(tr!(
            "{value}: within {percent} of {wanted}",
            value = self.part(of, "", write),
            percent = write(&percent.to_string(), "%"),
            wanted = self.part(wanted, of_unit, write)
        ))
    }

    /// A formula in words; what is the same as the name `beside` in another run is called its value there.
    fn side(
        &self,
        side: &Quantity,
        beside: Option<&str>,
        unit: &str,
        write: WriteNumber<'_>,
    ) -> String {
        let text = side.to_string();
        let same = |name: &str| beside.and_then(|beside| self.same_elsewhere(beside, name));
        let bare = is_name(&text) || text.parse::<f64>().is_ok();
        if bare {
            return same(&text).unwrap_or_else(|| self.part(&text, unit, write));
        }
        let mut words = String::new();
        for piece in pieces(&text) {
            match piece {
                "*" => words.push('\u{d7}'),
                "-" => words.push('\u{2212}'),
                name if is_name(name) && side.names().iter().any(|known| known == name) => {
                    words.push_str(&same(name).unwrap_or_else(|| self.name(name)));
                }
                other => words.push_str(&decimal(other.to_owned())),
            }
        }
        words
    }

    /// A name or a number in words.
    fn part(&self, text: &str, unit: &str, write: WriteNumber<'_>) -> String {
        if is_name(text) { self.name(text) } else { write(text, unit) }
    }

    /// What a name stands for.
    fn name(&self, name: &str) -> String {
        self.named(name).told()
    }

    fn named(&self, name: &str) -> Named {
        match self.values.get(name) {
            Some(value) => named(value),
            None => Named {
                name: metric(name).map_or(name, |(label, _)| tr(label)).to_owned(),
                beside: Vec::new(),
                run: RunOf::Learner,
            },
        }
    }

    /// A name that stands for the same as `beside`, of another run: as the value of that.
    fn same_elsewhere(&self, beside: &str, name: &str) -> Option<String> {
        let (beside, other) = (self.named(beside), self.named(name));
        let same = beside.name == other.name && beside.beside == other.beside;
        if !same || beside.run == other.run {
            return None;
        }
        Some(match other.run {
            RunOf::Learner => return None,
            RunOf::Given => tr("the value of the cut as given").to_owned(),
            RunOf::ConstantFeed => tr("the value at constant feed as programmed").to_owned(),
            RunOf::Controller(kind) => {
                tr!("the value with {controller}", controller = tr(kind.label()))
            }
        })
    }

    /// The unit of what a name stands for; empty where it has none.
    fn unit_of(&self, name: &str) -> &'static str {
        let of_metric = |id: &str| metric(id).map_or("", |(_, unit)| unit);
        let unit = match self.values.get(name) {
            None => of_metric(name),
            Some(MissionValue::Metric(id, _)) => of_metric(id),
            Some(MissionValue::Signal { signal: id, .. }) => {
                signal(id).map_or("", |signal| signal.unit)
            }
            Some(MissionValue::Setting(path)) => param(path).map_or("", |param| param.spec.unit),
            Some(
                MissionValue::Changes(_) | MissionValue::Prediction(_) | MissionValue::Ended(..),
            ) => "",
        };
        if unit == "-" { "" } else { unit }
    }
}

/// A number with about four significant digits.
fn readable(value: f64) -> String {
    let decimals = match value.abs() {
        size if size >= 1000.0 || size == 0.0 => 0,
        size if size >= 100.0 => 1,
        size if size >= 10.0 => 2,
        _ => 3,
    };
    format!("{value:.decimals$}")
}

/// Whether a text is a name alone.
fn is_name(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
        && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

/// Names and numbers of a formula, and all between them letter by letter.
fn pieces(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = text;
    std::iter::from_fn(move || {
        let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '.';
        let end = match rest.chars().next()? {
            first if is_part(first) => rest.find(|c| !is_part(c)).unwrap_or(rest.len()),
            first => first.len_utf8(),
        };
        let (piece, after) = rest.split_at(end);
        rest = after;
        Some(piece)
    })
}

/// What a name stands for.
struct Named {
    name: String,
    /// What is taken of it, and where.
    beside: Vec<String>,
    /// Of which run.
    run: RunOf,
}

impl Named {
    /// All of it in words.
    fn told(self) -> String {
        let Self { name, mut beside, run } = self;
        beside.extend(whose(run));
        if beside.is_empty() { name } else { format!("{name} ({})", beside.join(", ")) }
    }
}

/// What a value is, with what is taken of it, where, and of which run.
fn named(value: &MissionValue) -> Named {
    let path = |path: &str| param(path).map_or("", |param| tr(param.spec.label)).to_owned();
    let of_learner =
        |name: String, beside: Vec<String>| Named { name, beside, run: RunOf::Learner };
    match value {
        MissionValue::Metric(id, run) => {
            let name = metric(id).map_or(id.as_str(), |(label, _)| tr(label)).to_owned();
            Named { name, beside: Vec::new(), run: *run }
        }
        MissionValue::Signal { signal: id, run, window, taken } => {
            let name = signal(id).map_or(*id, |signal| tr(signal.label)).to_owned();
            let mut beside = vec![tr(of_it(*taken)).to_owned()];
            beside.extend(windows(window).into_iter().flatten());
            Named { name, beside, run: *run }
        }
        MissionValue::Setting(of) => of_learner(path(of), Vec::new()),
        MissionValue::Changes(Some(of)) => {
            of_learner(path(of), vec![tr("changes during the cut").to_owned()])
        }
        MissionValue::Changes(None) => {
            of_learner(tr("Changes during the cut").to_owned(), Vec::new())
        }
        MissionValue::Prediction(step) => {
            of_learner(tr!("Prediction in step {step}", step = *step), Vec::new())
        }
        MissionValue::Ended(end, run) => {
            Named { name: tr(end.label()).to_owned(), beside: Vec::new(), run: *run }
        }
    }
}

/// Whose a run is, unless it is the learner's own.
fn whose(run: RunOf) -> Option<String> {
    let words = match run {
        RunOf::Learner => return None,
        RunOf::Given => tr("of the cut as given"),
        RunOf::ConstantFeed => tr("at constant feed as programmed"),
        RunOf::Controller(kind) => return Some(tr(kind.label()).to_owned()),
    };
    Some(words.to_owned())
}

/// In which part of a run.
fn windows(window: &Window) -> [Option<String>; 2] {
    [(window.time_s, "s"), (window.place_mm, "mm")].map(|([from, to], unit)| {
        let number = |value: f64| decimal(value.to_string());
        match (from > 0.0, to.is_finite()) {
            (false, false) => None,
            (true, false) => Some(tr!("from {from} {unit} on", from = number(from), unit = unit)),
            (_, true) => Some(tr!(
                "{from} to {to} {unit}",
                from = number(from),
                to = number(to),
                unit = unit
            )),
        }
    })
}

/// What is taken of a signal.
fn of_it(taken: Taken) -> &'static str {
    match taken {
        Taken::Mean => text!("mean"),
        Taken::Max => text!("largest value"),
        Taken::Min => text!("least value"),
        Taken::Range => text!("largest less least value"),
        Taken::First => text!("first value"),
        Taken::Last => text!("last value"),
    }
}

/// Name and unit of a metric for people.
fn metric(id: &str) -> Option<(&'static str, &'static str)> {
    METRIC_WORDS.iter().find_map(|(known, label, unit)| (*known == id).then_some((*label, *unit)))
}

/// The metrics for people: id, name, unit.
const METRIC_WORDS: &[(&str, &str, &str)] = &[
    ("ra_final_um", text!("Ra at the end"), "um"),
    ("ra_deviation_percent", text!("Ra at the end, off its target"), "%"),
    ("in_tolerance_percent", text!("Share of the length in tolerance"), "%"),
    ("above_tolerance_percent", text!("Share of the length above the tolerance"), "%"),
    ("in_tolerance_dyn_percent", text!("Share of the length in tolerance with dynamics"), "%"),
    (
        "above_tolerance_dyn_percent",
        text!("Share of the length above the tolerance with dynamics"),
        "%",
    ),
    ("not_judged_percent", text!("Share of the length that is not judged"), "%"),
    ("force_final_n", text!("Force at the end"), "N"),
    ("force_deviation_percent", text!("Force at the end, off its reference"), "%"),
    ("force_worst_percent", text!("Largest deviation of the force from its reference"), "%"),
    ("feed_final_mm_min", text!("Feed at the end"), "mm/min"),
    ("spindle_final_rpm", text!("Spindle speed at the end"), "1/min"),
    ("normalized_standard_error", text!("Normalised standard error"), ""),
    ("normalized_standard_error_20", text!("Normalised standard error over 20 samples"), ""),
    ("settling_time_s", text!("Settling time of the force"), "s"),
    ("overshoot_percent", text!("Overshoot of the force"), "%"),
    ("time_of_cut_s", text!("Time of cut"), "s"),
    ("path_mm", text!("Length of path done"), "mm"),
    ("max_force_n", text!("Largest force"), "N"),
    ("metal_removed_cm3", text!("Metal removed"), "cm3"),
    ("scrap_mm", text!("Length of scrap"), "mm"),
    ("scrap_cost", text!("Cost of the scrap"), ""),
    ("cut_cost", text!("Cost of the cut"), ""),
    ("saturated_percent", text!("Share of the time at a limit"), "%"),
    ("outside_percent", text!("Share of the time with a model outside its range"), "%"),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mission::shipped::{self, MISSIONS};
    use crate::run::metrics::METRICS;

    #[test]
    fn every_metric_has_words() {
        for (id, _) in METRICS {
            assert!(metric(id).is_some(), "{id}");
        }
        assert_eq!(METRICS.len(), METRIC_WORDS.len());
    }

    #[test]
    fn what_a_condition_came_to_is_said_beside_it() {
        let write = |number: &str, unit: &str| format!("{number} {unit}").trim_end().to_owned();
        let told = |id: &str, star: usize, sides| {
            let mission = shipped::load(id).unwrap();
            mission.came_to(&mission.stars[star][0], sides, &write)
        };
        let id = "depth-step-at-constant-feed";
        assert_eq!(told(id, 0, [Some(95.25), Some(96.0)]), "yours: 95.25 %");
        let limit = [Some(31.0), Some(28.05)];
        assert_eq!(told(id, 1, limit), "yours: 31.00 s, the limit: 28.05 s");
        let near = told("read-the-errata", 0, [Some(0.05 * 0.05), Some(0.02 * 0.02)]);
        assert_eq!(near, "yours is off by 5.000 %");
        assert_eq!(told(id, 0, [None, Some(96.0)]), "there is no such value");
    }

    #[test]
    fn what_stars_ask_for_is_said_without_names_of_files() {
        let write = |number: &str, unit: &str| format!("{number} {unit}").trim_end().to_owned();
        let told = |id: &str| {
            let mission = shipped::load(id).unwrap();
            let all: Vec<String> = mission
                .stars
                .iter()
                .flatten()
                .map(|condition| mission.in_words(condition, &write))
                .collect();
            all.join("; ")
        };
        for mission in MISSIONS {
            let told = told(mission.id);
            assert!(!told.contains('_') && !told.contains("^2"), "{}: {told}", mission.id);
        }
        assert_eq!(
            told("depth-step-at-constant-feed"),
            "Share of the length in tolerance: at least 96 %; Time of cut: at most 1.1 × the value of \
             the cut as given"
        );
        assert_eq!(
            told("read-the-errata"),
            "Feed at the end: within 2 % of 264.92 mm/min; Ra at the end: within 3 % of 0.50 um"
        );
        assert_eq!(
            told("quiet-speed"),
            "Vibration (largest less least value, 45 to 69 mm): at most 0.35 × the value of the cut \
             as given; Programmed speed: at least 1400 1/min"
        );
    }
}
