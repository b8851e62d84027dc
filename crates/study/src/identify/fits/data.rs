//! Channels as fits take them: even in time and whole, or as columns of a table.

use super::request::{FitFault, FitOption, FitRequest, FitRole, missing};
use crate::base::language::tr;
use crate::measured::channel::{MeasuredChannel, SampleTimes};
use crate::measured::signal::filled;

/// A channel whose samples are even in time and all there, in the unit of its role.
#[derive(Clone, Debug, PartialEq)]
pub struct EvenChannel {
    /// Its name.
    pub name: String,
    /// Its unit in the file.
    pub unit: String,
    /// Samples in a second.
    pub rate_hz: f64,
    /// Its samples.
    pub values: Vec<f64>,
    times: SampleTimes,
}

impl EvenChannel {
    /// The time of a sample, s.
    #[must_use]
    pub fn time_s(&self, i: usize) -> f64 {
        self.times.at(i).unwrap_or(0.0)
    }

    /// Whether another one was sampled at the same times.
    ///
    /// # Errors
    /// It was not.
    pub fn goes_with(&self, other: &Self) -> Result<(), FitFault> {
        if self.times != other.times || self.values.len() != other.values.len() {
            let text = tr!(
                "`{one}` and `{other}` have different times",
                one = self.name,
                other = other.name
            );
            return Err(text.into());
        }
        Ok(())
    }

    /// The numbers of the samples between two times in s; of all without.
    #[must_use]
    pub fn within(&self, span: Option<[f64; 2]>) -> Vec<usize> {
        let [from_s, to_s] = span.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
        let taken = |i: &usize| (from_s..=to_s).contains(&self.time_s(*i));
        (0..self.values.len()).filter(taken).collect()
    }
}

/// Values at some places.
pub(super) fn at(places: &[usize], values: &[f64]) -> Vec<f64> {
    places.iter().map(|i| values[*i]).collect()
}

impl FitRequest {
    /// The channel in a role, even in time and whole; none where the role is free.
    ///
    /// # Errors
    /// As [`FitRequest::column`]; its samples are not even, or some are missing.
    pub(super) fn even(&self, role: &FitRole) -> Result<Option<EvenChannel>, FitFault> {
        let Some(channel) = self.column(role)? else { return Ok(None) };
        let fault = |text: String| FitFault::at(role.option, text);
        let rate_hz = channel.times.rate_hz().ok_or_else(|| {
            fault(tr!(
                "the samples of `{name}` are not even in time, or their times are not known: give --layout rate_hz=",
                name = channel.name
            ))
        })?;
        let values = whole(&channel, role)?;
        let MeasuredChannel { name, unit, times, values: _ } = channel;
        Ok(Some(EvenChannel { name, unit, rate_hz, values, times }))
    }

    /// The same of a role that has to be filled.
    pub(super) fn needed(&self, role: &FitRole) -> Result<EvenChannel, FitFault> {
        self.even(role)?.ok_or_else(|| missing(role))
    }

    /// The values of a column of a table; none where the role is free.
    pub(super) fn cells(&self, role: &FitRole) -> Result<Option<Vec<f64>>, FitFault> {
        self.column(role)?.map(|channel| whole(&channel, role)).transpose()
    }

    /// The values of a column that has to be there.
    pub(super) fn needed_cells(&self, role: &FitRole) -> Result<Vec<f64>, FitFault> {
        self.cells(role)?.ok_or_else(|| missing(role))
    }
}

/// The samples, if none is missing.
fn whole(channel: &MeasuredChannel, role: &FitRole) -> Result<Vec<f64>, FitFault> {
    let fault = |text: String| FitFault::at(role.option, text);
    let (values, missing) = filled(channel).map_err(|problem| fault(problem.to_string()))?;
    if missing > 0 {
        return Err(fault(tr!(
            "{missing} samples of `{name}` are missing or no numbers; expected are whole records",
            missing = missing,
            name = channel.name
        )));
    }
    Ok(values)
}

/// The force in a role, N, and its samples within the times of an option.
///
/// # Errors
/// As those of the channel and of the option.
pub fn force_n(
    request: &FitRequest,
    role: &FitRole,
    within: &FitOption,
) -> Result<(EvenChannel, Vec<f64>), FitFault> {
    let channel = request.needed(role)?;
    let taken = at(&channel.within(request.span(within)?), &channel.values);
    Ok((channel, taken))
}
