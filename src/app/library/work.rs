//! Reading a shelf: a job, a file a step, so that no frame waits for a disk. What was not changed since the last time is
//! not read again.

use std::collections::VecDeque;
use std::sync::Arc;
use std::time::SystemTime;

use super::shelf::{Shelf, ShelvedFile};
use crate::base::language::text;
use crate::run::job::{Budget, Job, Progress};
use crate::study::library::LibraryFile;

/// What a shelf holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ShelfRead {
    /// Where it is, for people.
    pub place: Option<String>,
    /// The files that the program takes, by kind and name.
    pub files: Vec<LibraryFile>,
    /// When each of them was changed last.
    changed: Vec<Option<SystemTime>>,
    /// How many others there are.
    pub others: usize,
    /// What is to be known, in sentences.
    pub remarks: Vec<String>,
    /// Why it could not be listed.
    pub fault: Option<String>,
}

impl ShelfRead {
    /// What is known of a file that was not changed since.
    fn known(&self, file: &ShelvedFile) -> Option<&LibraryFile> {
        let same = |(known, changed): &(&LibraryFile, &Option<SystemTime>)| {
            known.name == file.name
                && known.bytes == file.bytes
                && changed.is_some()
                && **changed == file.changed
                && file.problem.is_none()
        };
        self.files.iter().zip(&self.changed).find(same).map(|(known, _)| known)
    }
}

/// The job.
pub struct ReadShelf {
    shelf: Arc<dyn Shelf>,
    before: Arc<ShelfRead>,
    listed: bool,
    total: usize,
    queue: VecDeque<ShelvedFile>,
    read: Vec<(LibraryFile, Option<SystemTime>)>,
    found: ShelfRead,
    done: Option<Arc<ShelfRead>>,
}

impl ReadShelf {
    /// Of a shelf of which this is known.
    #[must_use]
    pub fn new(shelf: Arc<dyn Shelf>, before: Arc<ShelfRead>) -> Self {
        Self {
            shelf,
            before,
            listed: false,
            total: 1,
            queue: VecDeque::new(),
            read: Vec::new(),
            found: ShelfRead::default(),
            done: None,
        }
    }

    fn list(&mut self) {
        self.listed = true;
        self.found.place = self.shelf.place();
        match self.shelf.list() {
            Ok(shelved) => {
                self.total += shelved.files.len();
                self.queue = shelved.files.into();
                self.found.remarks = shelved.remarks;
            }
            Err(why) => self.found.fault = Some(why),
        }
    }

    fn look_into(&mut self, file: ShelvedFile) {
        let known = self.before.known(&file).cloned();
        let read = || match &file.problem {
            Some(problem) => Err(problem.clone()),
            None => self.shelf.read(&file.name),
        };
        match known.or_else(|| LibraryFile::of(&file.name, file.bytes, read)) {
            // Its length as it was listed, so that it is known again.
            Some(found) => {
                self.read.push((LibraryFile { bytes: file.bytes, ..found }, file.changed));
            }
            None => self.found.others += 1,
        }
    }

    fn end(&mut self) {
        self.read.sort_by(|(a, _), (b, _)| (a.kind, &a.name).cmp(&(b.kind, &b.name)));
        let mut found = std::mem::take(&mut self.found);
        (found.files, found.changed) = self.read.drain(..).unzip();
        self.done = Some(Arc::new(found));
    }
}

impl Job for ReadShelf {
    type Partial = Option<Arc<ShelfRead>>;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        while self.done.is_none() && budget.step() {
            if !self.listed {
                self.list();
            } else if let Some(file) = self.queue.pop_front() {
                self.look_into(file);
            }
            if self.queue.is_empty() {
                self.end();
            }
        }
        self.done.is_some()
    }

    fn progress(&self) -> Progress {
        let done = match self.done {
            Some(_) => self.total,
            None => self.total.saturating_sub(self.queue.len() + 1),
        };
        Progress { done: done as f64, total: self.total as f64, unit: text!("files") }
    }

    fn partial(&self) -> Self::Partial {
        self.done.clone()
    }
}
