//! What is worked out of a channel before it is drawn, as jobs of one step: a million samples take longer than a frame.

use std::sync::Arc;

use super::trace::MeasuredTrace;
use crate::base::language::{text, tr};
use crate::measured::channel::MeasuredChannel;
use crate::measured::signal::Preparation;
use crate::measured::signal::periods::resampled;
use crate::run::job::{Budget, Job, Progress};

use super::file::ReadFile;

/// Most channels that are named where one is missing.
const MOST_NAMED: usize = 8;

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
/// A channel is not there, or is not what a step needs, in words; `of` is the file's name.
pub fn prepared(
    of: &str,
    file: &ReadFile,
    wish: &ChannelWish,
) -> Result<Arc<PreparedChannel>, String> {
    let ChannelWish { channel: name, size, preparation, row_s } = wish;
    let rotation = preparation.rotation.iter().flat_map(|(x, y, _)| [x, y]);
    let peaks = preparation.peaks.iter().flat_map(|(x, y)| [x, y]);
    let needed: Vec<&String> = rotation.chain(peaks).chain([name]).collect();
    let has = |name: &String| file.data.channels.iter().any(|channel| channel.name == *name);
    if let Some(missing) = needed.iter().find(|name| !has(name)) {
        return Err(without(of, file, missing));
    }
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
    let Some(mut channel) = one else { return Err(without(of, file, name)) };
    channel.values.iter_mut().for_each(|value| *value *= size);
    let periods = resampled(&channel, *row_s).map_err(told)?;
    let MeasuredChannel { name, unit: _, times, values } = channel;
    Ok(Arc::new(PreparedChannel { name, trace: MeasuredTrace::new(times, values), periods }))
}

/// That a file does not have a channel, and which it has.
fn without(of: &str, file: &ReadFile, name: &str) -> String {
    let channels = &file.data.channels;
    let first: Vec<String> =
        channels.iter().take(MOST_NAMED).map(|channel| format!("`{}`", channel.name)).collect();
    let mut has = first.join(", ");
    if channels.len() > MOST_NAMED {
        has.push_str(&tr!(" and {n} more", n = channels.len() - MOST_NAMED));
    }
    tr!(
        "{file} has no channel `{name}`: it has {channels}.",
        file = of,
        name = name,
        channels = has
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::overlay::file::MeasuredFile;
    use crate::measured::layout::DataLayout;

    #[test]
    fn a_channel_that_is_missing_is_told_with_file_and_what_there_is() {
        let read = |text: &str| {
            let bytes = text.as_bytes().to_vec().into();
            let file = MeasuredFile::read("cut.csv".to_owned(), bytes, DataLayout::default());
            Arc::clone(file.contents().as_ref().unwrap())
        };
        let file = read("t_s,Fx,Fy\n0,1,2\n0.1,2,3\n0.2,3,4\n");
        let wish = |channel: &str| ChannelWish {
            channel: channel.to_owned(),
            size: 1.0,
            preparation: Preparation::default(),
            row_s: 0.02,
        };
        assert!(prepared("cut.csv", &file, &wish("Fx")).is_ok());
        let said = prepared("cut.csv", &file, &wish("Fz")).unwrap_err();
        assert_eq!(said, "cut.csv has no channel `Fz`: it has `Fx`, `Fy`.");
        // One that a step needs, too.
        let mut turned = wish("Fx");
        turned.preparation.rotation = Some(("Fx".to_owned(), "Fq".to_owned(), 30.0));
        let said = prepared("cut.csv", &file, &turned).unwrap_err();
        assert!(said.contains("no channel `Fq`"), "{said}");
        let head: Vec<String> = (0..12).map(|i| format!("c{i}")).collect();
        let many = format!("t_s,{}\n0{}\n1{}\n", head.join(","), ",1".repeat(12), ",2".repeat(12));
        let said = prepared("cut.csv", &read(&many), &wish("Fz")).unwrap_err();
        assert!(said.ends_with("`c7` and 4 more."), "{said}");
    }
}
