//! What is asked: the fit, the file, channels in roles, options.

use std::sync::Arc;

use crate::app::overlay::file::{MeasuredFile, NO_TIMES};
use crate::measured::channel::MeasuredChannel;
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;
use crate::study::identify::fits::{
    ChosenChannel, FitFault, FitOption, FitRequest, FitRole, FitValue, MeasuredFitKind,
    likely_channels,
};

/// See the head of this file.
#[derive(Clone)]
pub struct FitForm {
    /// What is fitted.
    pub kind: MeasuredFitKind,
    /// The file as the fit reads it.
    pub file: Option<MeasuredFile>,
    /// The same as it was brought, with what was said of its layout.
    brought: Option<MeasuredFile>,
    /// Channels in roles.
    roles: Vec<(&'static str, ChosenChannel)>,
    /// Options that were given, of every kind of fit.
    values: Vec<(MeasuredFitKind, &'static str, FitValue)>,
}

/// Whether both are one reading of one file: what was read is not gone through.
fn is_same(a: Option<&MeasuredFile>, b: Option<&MeasuredFile>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => {
            a.name == b.name
                && match (a.contents(), b.contents()) {
                    (Ok(a), Ok(b)) => Arc::ptr_eq(a, b),
                    (Err(a), Err(b)) => a == b,
                    (Ok(_), Err(_)) | (Err(_), Ok(_)) => false,
                }
        }
        (None, None) => true,
        (Some(_), None) | (None, Some(_)) => false,
    }
}

impl PartialEq for FitForm {
    fn eq(&self, other: &Self) -> bool {
        let Self { kind, file, brought: _, roles, values } = self;
        *kind == other.kind
            && is_same(file.as_ref(), other.file.as_ref())
            && *roles == other.roles
            && *values == other.values
    }
}

impl Default for FitForm {
    fn default() -> Self {
        let kind = MeasuredFitKind::ALL[0];
        Self { kind, file: None, brought: None, roles: Vec::new(), values: Vec::new() }
    }
}

impl FitForm {
    /// Takes a file.
    pub fn take(&mut self, file: &MeasuredFile) {
        self.brought = Some(file.clone());
        self.read_as_wanted();
    }

    /// Takes the file as it was read again.
    pub fn read_again(&mut self, file: &MeasuredFile) {
        (self.brought, self.file) = (Some(file.clone()), Some(file.clone()));
        self.guess();
    }

    /// Chooses another fit.
    pub fn choose(&mut self, kind: MeasuredFitKind) {
        if kind != self.kind {
            self.kind = kind;
            self.read_as_wanted();
        }
    }

    /// Reads the file with times or as a table without any, as the fit takes it.
    fn read_as_wanted(&mut self) {
        let Some(brought) = &self.brought else { return };
        let has_times = |file: &MeasuredFile| {
            let time = file.contents().ok().and_then(|read| read.data.layout.time.clone());
            time.is_some_and(|time| time != NO_TIMES)
        };
        let table = !self.kind.about().timed && has_times(brought);
        self.file = Some(if table { brought.with_times(NO_TIMES, None) } else { brought.clone() });
        self.guess();
    }

    /// The channels of the file.
    pub fn channels(&self) -> &[MeasuredChannel] {
        let read = self.file.as_ref().and_then(|file| file.contents().ok());
        read.map_or(&[], |read| &read.data.channels)
    }

    /// Puts into the roles what most likely is there.
    fn guess(&mut self) {
        self.roles = likely_channels(self.kind.about().roles, self.channels());
    }

    /// The channel in a role.
    pub fn chosen(&self, role: &FitRole) -> Option<&ChosenChannel> {
        self.roles.iter().find(|(option, _)| *option == role.option).map(|(_, chosen)| chosen)
    }

    /// Puts a channel into a role, or none.
    pub fn put(&mut self, role: &FitRole, chosen: Option<ChosenChannel>) {
        self.roles.retain(|(option, _)| *option != role.option);
        self.roles.extend(chosen.map(|chosen| (role.option, chosen)));
        // In the order of the fit, so that equal choices are equal.
        let order = self.kind.about().roles;
        let place = |option: &str| order.iter().position(|role| role.option == option);
        self.roles.sort_by_key(|(option, _)| place(option));
    }

    /// What was given of an option.
    pub fn value(&self, option: &FitOption) -> Option<&FitValue> {
        let is = |(kind, name, _): &&(MeasuredFitKind, &'static str, FitValue)| {
            *kind == self.kind && *name == option.option
        };
        self.values.iter().find(is).map(|(_, _, value)| value)
    }

    /// Gives an option a value, or none.
    pub fn say(&mut self, option: &FitOption, value: Option<FitValue>) {
        if self.value(option) == value.as_ref() {
            return;
        }
        let kind = self.kind;
        self.values.retain(|(of, name, _)| *of != kind || *name != option.option);
        self.values.extend(value.map(|value| (kind, option.option, value)));
    }

    fn asked(
        &self,
        channels: Vec<MeasuredChannel>,
        scenario: Scenario,
        edits: Edits,
    ) -> FitRequest {
        let name = self.file.as_ref().map(|file| file.name.clone());
        let of_kind = self.values.iter().filter(|(kind, ..)| *kind == self.kind);
        FitRequest {
            file: name.unwrap_or_default(),
            channels,
            roles: self.roles.clone(),
            values: of_kind.map(|(_, name, value)| (*name, value.clone())).collect(),
            scenario,
            edits,
        }
    }

    /// What is missing before it can be fitted.
    pub fn lacks(&self, scenario: &Scenario) -> Option<FitFault> {
        self.kind.lacks(&self.asked(Vec::new(), scenario.clone(), Edits::none()))
    }

    /// What is asked of a cut; none without a file.
    pub fn request(&self, scenario: Scenario, edits: Edits) -> Option<FitRequest> {
        self.file.as_ref()?.contents().ok()?;
        let used = |channel: &&MeasuredChannel| {
            self.roles.iter().any(|(_, chosen)| chosen.channel == channel.name)
        };
        let channels = self.channels().iter().filter(used).cloned().collect();
        Some(self.asked(channels, scenario, edits))
    }
}
