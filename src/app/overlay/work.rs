//! What is worked out of a channel before it is drawn, as jobs of one step: a million samples take longer than a frame.

use std::sync::Arc;

use super::trace::MeasuredTrace;
use crate::base::language::text;
use crate::measured::channel::MeasuredChannel;
use crate::measured::signal::Preparation;
use crate::measured::signal::periods::resampled;
use crate::run::job::{Budget, Job, Progress};

use super::file::ReadFile;

/// Work that is done in one step.
pub struct SingleTask<T> {
    work: Option<Box<dyn FnOnce() -> T + Send>>,
    done: Option<T>,
}

impl<T> SingleTask<T> {
    /// Of a piece of work.
    pub fn new(work: impl FnOnce() -> T + Send + 'static) -> Self {
        Self { work: Some(Box::new(work)), done: None }
    }
}

impl<T: Clone + Send> Job for SingleTask<T> {
    type Partial = Option<T>;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        if let Some(work) = self.work.take_if(|_| budget.step()) {
            self.done = Some(work());
        }
        self.done.is_some()
    }

    fn progress(&self) -> Progress {
        let done = if self.done.is_some() { 1.0 } else { 0.0 };
        Progress { done, total: 1.0, unit: text!("steps") }
    }

    fn partial(&self) -> Self::Partial {
        self.done.clone()
    }
}

/// A channel as it is drawn and aligned.
#[derive(Debug)]
pub struct PreparedChannel {
    /// Its name after the preparation.
    pub name: String,
    /// All samples.
    pub trace: MeasuredTrace,
    /// One sample in every row of the run.
    pub periods: MeasuredChannel,
}

/// What is done with a channel of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct ChannelWish {
    /// Its name.
    pub channel: String,
    /// One of its unit in that of the signal; 1 where it is not converted.
    pub size: f64,
    /// What is done with it before.
    pub preparation: Preparation,
    /// Time between two rows of the run, s.
    pub row_s: f64,
}

/// Prepares a channel.
///
/// # Errors
/// A channel is not there, or is not what a step needs, in words.
pub fn prepared(file: &ReadFile, wish: &ChannelWish) -> Result<Arc<PreparedChannel>, String> {
    let ChannelWish { channel: name, size, preparation, row_s } = wish;
    let rotation = preparation.rotation.iter().flat_map(|(x, y, _)| [x, y]);
    let peaks = preparation.peaks.iter().flat_map(|(x, y)| [x, y]);
    let needed: Vec<&String> = rotation.chain(peaks).chain([name]).collect();
    // Those alone: a file may have many.
    let some: Vec<MeasuredChannel> = file
        .data
        .channels
        .iter()
        .filter(|channel| needed.contains(&&channel.name))
        .cloned()
        .collect();
    let told = |fault: crate::measured::fault::DataFault| fault.to_string();
    let done = preparation.of(&some).map_err(told)?;
    let one = match preparation.peaks {
        Some(_) => done.into_iter().next(),
        None => done.into_iter().find(|channel| channel.name == *name),
    };
    let Some(mut channel) = one else { return Err(format!("`{name}`")) };
    channel.values.iter_mut().for_each(|value| *value *= size);
    let periods = resampled(&channel, *row_s).map_err(told)?;
    let MeasuredChannel { name, unit: _, times, values } = channel;
    Ok(Arc::new(PreparedChannel { name, trace: MeasuredTrace::new(times, values), periods }))
}
