//! What a fit is asked: which channels, which options, of which cut.

use std::fmt;

use crate::base::language::{text, tr};
use crate::base::settings::Kind;
use crate::channel_unit::{place_of, units};
use crate::measured::channel::MeasuredChannel;
use crate::run::edits::Edits;
use crate::run::scenario::{Scenario, param};

/// The option of every recording: the times that are taken.
pub const WITHIN: FitOption = FitOption {
    option: "within",
    label: text!("Within"),
    about: text!("Takes the samples between two times in s alone."),
    unit: "s",
    kind: FitOptionKind::Span,
};

/// A channel that a fit reads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitRole {
    /// The option of the command that names it, without its dashes.
    pub option: &'static str,
    /// Its name for people.
    pub label: &'static str,
    /// What it is.
    pub about: &'static str,
    /// What a channel has to be, with its article.
    pub what: &'static str,
    /// The unit that the fit takes it in; empty where it takes any.
    pub unit: &'static str,
    /// Whether the fit cannot do without.
    pub needed: bool,
    /// Names of channels that are most likely it, in small letters.
    pub names: &'static [&'static str],
    /// Beginnings of names that likely are.
    pub words: &'static [&'static str],
}

/// An option of a fit.
#[derive(Clone, Copy, Debug)]
pub struct FitOption {
    /// The option of the command, without its dashes.
    pub option: &'static str,
    /// Its name for people.
    pub label: &'static str,
    /// What it does.
    pub about: &'static str,
    /// Its unit; empty for none.
    pub unit: &'static str,
    /// What it holds.
    pub kind: FitOptionKind,
}

/// What an option holds.
#[derive(Clone, Copy, Debug)]
pub enum FitOptionKind {
    /// A number within a range, from the start on or none.
    Number {
        /// Least and largest value.
        range: [f64; 2],
        /// What it is where nothing is said.
        default: Option<f64>,
        /// Whether it is a whole one.
        whole: bool,
    },
    /// Another value than the scenario's own for a setting, by its path.
    Setting(&'static str),
    /// Two times in s.
    Span,
    /// On or off.
    Switch,
    /// One of several, by ids with names for people; the first where nothing is said.
    Choice(fn() -> Vec<(&'static str, String)>),
}

impl FitOption {
    /// The range of a number.
    #[must_use]
    pub fn range(&self) -> Option<[f64; 2]> {
        match self.kind {
            FitOptionKind::Number { range, .. } => Some(range),
            FitOptionKind::Setting(path) => match &param(path).ok()?.spec.allowed {
                Kind::Float { min, max } => Some([*min, *max]),
                Kind::Int { .. }
                | Kind::Bool
                | Kind::Choice { .. }
                | Kind::Text { .. }
                | Kind::Structured(_) => None,
            },
            FitOptionKind::Span | FitOptionKind::Switch | FitOptionKind::Choice(_) => None,
        }
    }
}

/// What an option was given.
#[derive(Clone, Debug, PartialEq)]
pub enum FitValue {
    /// A number.
    Number(f64),
    /// Two times, s.
    Span([f64; 2]),
    /// On.
    On,
    /// One of several by its id.
    Id(String),
}

/// A channel in a role.
#[derive(Clone, Debug, PartialEq)]
pub struct ChosenChannel {
    /// Its name.
    pub channel: String,
    /// Its unit, where another one is said than the file has.
    pub unit: Option<String>,
}

/// What a fit is asked.
#[derive(Clone, Debug, PartialEq)]
pub struct FitRequest {
    /// Name of the file.
    pub file: String,
    /// Its channels; those in roles at least.
    pub channels: Vec<MeasuredChannel>,
    /// Channels in roles, by the roles' options.
    pub roles: Vec<(&'static str, ChosenChannel)>,
    /// Options that were given.
    pub values: Vec<(&'static str, FitValue)>,
    /// The cut that was recorded.
    pub scenario: Scenario,
    /// What is changed while it runs.
    pub edits: Edits,
}

/// Why a fit cannot be made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FitFault {
    /// The option that is to blame; none where the data are.
    pub option: Option<&'static str>,
    /// What is wrong.
    pub text: String,
}

impl FitFault {
    /// Of an option.
    #[must_use]
    pub fn at(option: &'static str, text: String) -> Self {
        Self { option: Some(option), text }
    }

    /// As a command tells it of a file.
    #[must_use]
    pub fn of_file(&self, file: &str) -> String {
        match self.option {
            Some(option) => format!("--{option}: {}", self.text),
            None => format!("{file}: {}", self.text),
        }
    }
}

impl fmt::Display for FitFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl From<String> for FitFault {
    fn from(text: String) -> Self {
        Self { option: None, text }
    }
}

impl FitRequest {
    /// With a channel in a role, where one is named.
    #[must_use]
    pub fn with_channel(mut self, role: &FitRole, channel: Option<&String>) -> Self {
        let chosen = |channel: &String| ChosenChannel { channel: channel.clone(), unit: None };
        self.roles.extend(channel.map(|channel| (role.option, chosen(channel))));
        self
    }

    /// With a value of an option, where there is one.
    #[must_use]
    pub fn with_value(mut self, option: &FitOption, value: Option<FitValue>) -> Self {
        self.values.extend(value.map(|value| (option.option, value)));
        self
    }

    /// The channel in a role.
    #[must_use]
    pub fn chosen(&self, role: &FitRole) -> Option<&ChosenChannel> {
        self.roles.iter().find(|(option, _)| *option == role.option).map(|(_, chosen)| chosen)
    }

    fn value(&self, option: &FitOption) -> Option<&FitValue> {
        self.values.iter().find(|(name, _)| *name == option.option).map(|(_, value)| value)
    }

    /// A role that has to be filled and is not.
    pub(super) fn lacks(&self, roles: &[FitRole]) -> Option<FitFault> {
        let role = roles.iter().find(|role| role.needed && self.chosen(role).is_none())?;
        Some(missing(role))
    }

    /// The number of an option, or the one that holds where nothing was said.
    ///
    /// # Errors
    /// It is out of range.
    pub fn number(&self, option: &FitOption) -> Result<Option<f64>, FitFault> {
        let said = match self.value(option) {
            Some(FitValue::Number(x)) => Some(*x),
            Some(FitValue::Span(_) | FitValue::On | FitValue::Id(_)) | None => None,
        };
        let (default, whole) = match option.kind {
            FitOptionKind::Number { default, whole, .. } => (default, whole),
            FitOptionKind::Setting(_)
            | FitOptionKind::Span
            | FitOptionKind::Switch
            | FitOptionKind::Choice(_) => (None, false),
        };
        let Some(x) = said.or(default) else { return Ok(None) };
        match option.range() {
            Some([low, high]) if !(low..=high).contains(&x) || whole && x.fract() != 0.0 => {
                Err(FitFault::at(
                    option.option,
                    tr!(
                        "{value} {unit} cannot be: allowed is a number from {low} to {high}",
                        value = x,
                        unit = option.unit,
                        low = low,
                        high = high
                    ),
                ))
            }
            Some(_) | None => Ok(Some(x)),
        }
    }

    /// The two times of an option, s.
    ///
    /// # Errors
    /// The first is behind the second, or one is no number.
    pub fn span(&self, option: &FitOption) -> Result<Option<[f64; 2]>, FitFault> {
        match self.value(option) {
            Some(FitValue::Span([from, to])) if from <= to => Ok(Some([*from, *to])),
            Some(FitValue::Span([from, to])) => Err(FitFault::at(
                option.option,
                tr!(
                    "from {from} s to {to} s is no span of time: the second is to be behind the first",
                    from = *from,
                    to = *to
                ),
            )),
            Some(FitValue::Number(_) | FitValue::On | FitValue::Id(_)) | None => Ok(None),
        }
    }

    /// Whether a switch is on.
    #[must_use]
    pub fn is_on(&self, option: &FitOption) -> bool {
        self.value(option) == Some(&FitValue::On)
    }

    /// Which of several was chosen, by its id; none where nothing was said.
    #[must_use]
    pub fn id(&self, option: &FitOption) -> Option<&str> {
        match self.value(option) {
            Some(FitValue::Id(id)) => Some(id),
            Some(FitValue::Number(_) | FitValue::Span(_) | FitValue::On) | None => None,
        }
    }

    /// The channel in a role with its values in the unit of the role.
    ///
    /// # Errors
    /// There is none of that name, or its unit is not one of the role's.
    pub(super) fn column(&self, role: &FitRole) -> Result<Option<MeasuredChannel>, FitFault> {
        let Some(chosen) = self.chosen(role) else { return Ok(None) };
        let name = &chosen.channel;
        let channel = self.channels.iter().find(|channel| channel.name == *name);
        let Some(channel) = channel else {
            let names: Vec<&str> = self.channels.iter().map(|c| c.name.as_str()).collect();
            let text = tr!(
                "there is no channel `{name}`; there are {names}",
                name = name,
                names = names.join(", ")
            );
            return Err(FitFault::at(role.option, text));
        };
        let unit = chosen.unit.as_ref().unwrap_or(&channel.unit);
        let known = units(role.unit);
        let mut channel = channel.clone();
        if !unit.is_empty() && !known.is_empty() {
            let Some(place) = place_of(unit, role.unit) else {
                let known: Vec<&str> = known.iter().map(|unit| unit.names[0]).collect();
                let text = tr!(
                    "`{name}` is in {unit}; expected is {what} in {units}",
                    name = name,
                    unit = unit,
                    what = tr(role.what),
                    units = either(&known)
                );
                return Err(FitFault::at(role.option, text));
            };
            let size = known[place].size;
            if size != 1.0 {
                channel.values.iter_mut().for_each(|value| *value *= size);
            }
        }
        channel.unit.clone_from(unit);
        Ok(Some(channel))
    }
}

/// Names with `or` before the last.
fn either(names: &[&str]) -> String {
    match names {
        [all @ .., last] if !all.is_empty() => {
            tr!("{first} or {last}", first = all.join(", "), last = *last)
        }
        [] | [..] => names.join(", "),
    }
}

/// That no channel is in a role.
pub(super) fn missing(role: &FitRole) -> FitFault {
    let text = tr!("choose a channel: expected is {what}", what = tr(role.what));
    FitFault::at(role.option, text)
}

/// The channels that most likely are in the roles, by names and units: of each role at most one, and none in two.
#[must_use]
pub fn likely_channels(
    roles: &[FitRole],
    channels: &[MeasuredChannel],
) -> Vec<(&'static str, ChosenChannel)> {
    let mut found: Vec<(&'static str, ChosenChannel)> = Vec::new();
    let by_name = |role: &FitRole, name: &str| role.names.contains(&name);
    let by_word = |role: &FitRole, name: &str| role.words.iter().any(|word| name.starts_with(word));
    let by_unit = |role: &FitRole, channel: &MeasuredChannel| {
        role.needed && !channel.unit.is_empty() && place_of(&channel.unit, role.unit).is_some()
    };
    let fits = |role: &FitRole, channel: &MeasuredChannel, pass: usize| {
        let name = channel.name.to_lowercase();
        let known = units(role.unit);
        // A name of something else: an angle is no force.
        let other = !channel.unit.is_empty()
            && !known.is_empty()
            && place_of(&channel.unit, role.unit).is_none();
        !other
            && match pass {
                0 => by_name(role, &name),
                1 => by_word(role, &name),
                _ => by_unit(role, channel),
            }
    };
    for pass in 0..3 {
        for role in roles {
            if found.iter().any(|(option, _)| *option == role.option) {
                continue;
            }
            let free = |channel: &&MeasuredChannel| {
                found.iter().all(|(_, chosen)| chosen.channel != channel.name)
                    && fits(role, channel, pass)
            };
            if let Some(channel) = channels.iter().find(free) {
                let chosen = ChosenChannel { channel: channel.name.clone(), unit: None };
                found.push((role.option, chosen));
            }
        }
    }
    found
}
