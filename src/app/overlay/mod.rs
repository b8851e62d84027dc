//! Measured data over the plots of the run: files that were opened or dropped, and what of them lies over which signal
//! and where. It is no part of the scenario: no file and no link holds it, and no change of the run touches it.

pub mod file;
pub mod layouts;
pub mod trace;
pub mod unit;
pub mod work;

use std::sync::Arc;

use super::jobs::{Jobs, Work};
use super::session::Session;
use super::widgets::chart::{Chart, ChartMeasured};
use crate::base::language::{text, tr};
use crate::measured::channel::MeasuredChannel;
use crate::measured::signal::Preparation;
use crate::run::signals::{SignalInfo, signal};
use crate::study::over_run::{self, OverRun, OverRunFit};
use file::MeasuredFile;
use unit::{likely_signal, place_of, units};
use work::{ChannelWish, PreparedChannel, SingleTask, prepared};

/// Most channels that lie over the plots at once.
pub const MOST_OVERLAYS: usize = 6;
/// Name of the work, where it takes long enough to be listed.
const WORK: &str = text!("Measured data");

/// What of a file lies over which signal.
#[derive(Clone, Debug, PartialEq)]
pub struct OverlayChoice {
    /// Name of the channel.
    pub channel: String,
    /// Place of its unit among those that the signal's channels have; none: its values are taken as they are.
    pub unit: Option<usize>,
    /// Id of the signal.
    pub signal: &'static str,
    /// What is done with the channel before.
    pub preparation: Preparation,
}

/// What a fit was worked out of: changes of the run, its rows, the signal.
type ReferenceKey = (u64, usize, &'static str);

/// What came of working a channel out.
type Worked = Result<Arc<PreparedChannel>, String>;
/// The values of a signal in the rows of the run.
type OfRun = Arc<Result<Vec<f64>, String>>;

/// A channel over a signal of the run.
pub struct Overlay {
    /// Its number: larger than those of all before.
    pub id: u64,
    /// The file that it is of.
    pub file: MeasuredFile,
    /// What of it lies over which signal.
    pub choice: OverlayChoice,
    /// How it lies there.
    place: OverRun,
    /// Whether a person has put it there.
    by_hand: bool,
    /// Whether it is to be aligned as soon as channel and run are worked out.
    to_align: bool,
    /// What the channel was worked out for last.
    asked: Option<(Arc<file::ReadFile>, ChannelWish)>,
    preparing: Option<Work<SingleTask<Worked>>>,
    prepared: Option<Worked>,
    aligning: Option<Work<SingleTask<Result<OverRunFit, String>>>>,
    /// Why it could not be aligned.
    not_aligned: Option<String>,
    reference: Option<(ReferenceKey, OfRun)>,
    /// How well it lies, and of what that was worked out.
    fit: Option<(ReferenceKey, OverRun, Option<OverRunFit>)>,
}

/// The signal with an id of the table.
fn info(id: &str) -> &'static SignalInfo {
    signal(id).expect("channels are laid over signals of the table")
}

impl Overlay {
    fn new(id: u64, file: MeasuredFile) -> Self {
        let mut overlay = Self {
            id,
            file,
            choice: OverlayChoice {
                channel: String::new(),
                unit: None,
                signal: unit::SIGNALS_OVER[0],
                preparation: Preparation::default(),
            },
            place: OverRun::default(),
            by_hand: false,
            to_align: true,
            asked: None,
            preparing: None,
            prepared: None,
            aligning: None,
            not_aligned: None,
            reference: None,
            fit: None,
        };
        overlay.choose_again();
        overlay
    }

    /// The channels of its file; none where that could not be read.
    #[must_use]
    pub fn channels(&self) -> &[MeasuredChannel] {
        self.file.contents().map_or(&[], |read| &read.data.channels)
    }

    /// Takes the file as it was read again.
    pub fn read_again(&mut self, file: MeasuredFile) {
        self.file = file;
        self.choose_again();
    }

    /// Keeps the channel where the file has it still, else takes that of a force, else the first.
    fn choose_again(&mut self) {
        let of_force = |channel: &&MeasuredChannel| place_of(&channel.unit, "N").is_some();
        let is_kept = |channel: &&MeasuredChannel| channel.name == self.choice.channel;
        let channels = self.channels();
        let kept = channels.iter().find(is_kept).map(|channel| channel.name.clone());
        let found = channels.iter().find(of_force).or(channels.first());
        match (kept, found.map(|channel| channel.name.clone())) {
            (Some(_), _) | (None, None) => {}
            (None, Some(name)) => self.choose_channel(&name),
        }
    }

    /// Lays another channel over the signal that it is most likely one of.
    pub fn choose_channel(&mut self, name: &str) {
        let channel = self.channels().iter().find(|channel| channel.name == name);
        let Some((name, unit)) =
            channel.map(|channel| (channel.name.clone(), channel.unit.clone()))
        else {
            return;
        };
        let signal = likely_signal(&name, &unit, |id| info(id).unit);
        self.choice.channel = name;
        self.choose_signal(signal);
    }

    /// Lays the channel over another signal.
    pub fn choose_signal(&mut self, id: &'static str) {
        let of_file = self.channels().iter().find(|channel| channel.name == self.choice.channel);
        let unit = of_file.and_then(|channel| place_of(&channel.unit, info(id).unit));
        (self.choice.signal, self.choice.unit) = (id, unit);
        self.align();
    }

    /// Aligns it anew.
    pub fn align(&mut self) {
        (self.to_align, self.by_hand) = (true, false);
    }

    /// How it lies over the signal.
    #[must_use]
    pub fn place(&self) -> OverRun {
        self.place
    }

    /// Puts it somewhere by hand.
    pub fn put(&mut self, place: OverRun) {
        if place != self.place {
            (self.place, self.by_hand, self.to_align) = (place, true, false);
            self.aligning = None;
            self.not_aligned = None;
        }
    }

    /// Whether a person has put it where it lies.
    #[must_use]
    pub fn is_by_hand(&self) -> bool {
        self.by_hand
    }

    /// How well it lies there, once the run is worked out.
    #[must_use]
    pub fn fit(&self) -> Option<OverRunFit> {
        self.fit.and_then(|(_, place, fit)| fit.filter(|_| place == self.place))
    }

    /// The channel as it is drawn, or why there is none.
    #[must_use]
    pub fn prepared(&self) -> Option<Result<&PreparedChannel, &str>> {
        self.prepared.as_ref().map(|result| match result {
            Ok(channel) => Ok(&**channel),
            Err(why) => Err(why.as_str()),
        })
    }

    /// Why it could not be aligned.
    #[must_use]
    pub fn not_aligned(&self) -> Option<&str> {
        self.not_aligned.as_deref()
    }

    /// Whether something of it is being worked out.
    #[must_use]
    pub fn is_at_work(&self) -> bool {
        self.preparing.is_some() || self.aligning.is_some() || self.to_align
    }

    /// What it is called over the plots.
    #[must_use]
    pub fn name(&self) -> String {
        let name = match &self.prepared {
            Some(Ok(channel)) => &channel.name,
            Some(Err(_)) | None => &self.choice.channel,
        };
        tr!("measured: {name}", name = name)
    }

    /// Follows what was chosen and the run.
    fn follow(&mut self, session: &Session, jobs: &Jobs) {
        self.prepare(session, jobs);
        let Some(Ok(channel)) = self.prepared.clone() else { return };
        // What lies over the first seconds of a run may lie elsewhere over the whole one.
        if !session.chosen().is_over() {
            return;
        }
        let row_s = session.chosen().run().recording().row_s();
        let (key, reference) = self.reference_of(session);
        let of_run = match &*reference {
            Ok(of_run) => of_run,
            Err(why) => {
                if std::mem::take(&mut self.to_align) {
                    self.not_aligned = Some(why.clone());
                }
                return;
            }
        };
        if let Some(work) = self.aligning.take_if(|work| work.is_over()) {
            match &*work.partial() {
                Some(Ok(found)) => (self.place, self.not_aligned) = (found.place, None),
                Some(Err(why)) => self.not_aligned = Some(why.clone()),
                None => {}
            }
        }
        if self.to_align && self.preparing.is_none() {
            self.to_align = false;
            let (channel, reference) = (Arc::clone(&channel), Arc::clone(&reference));
            let align = move || match &*reference {
                Ok(of_run) => over_run::aligned(&channel.periods, of_run, row_s)
                    .map_err(|fault| fault.to_string()),
                Err(why) => Err(why.clone()),
            };
            self.aligning = Some(jobs.begin_brief(tr(WORK), SingleTask::new(align), 1));
        }
        let known = self.fit.is_some_and(|(of, place, _)| of == key && place == self.place);
        if !known {
            let fit = over_run::judged(&channel.periods, of_run, row_s, self.place);
            self.fit = Some((key, self.place, fit));
        }
    }

    /// Works the channel out where something else was chosen.
    fn prepare(&mut self, session: &Session, jobs: &Jobs) {
        if let Some(work) = self.preparing.take_if(|work| work.is_over())
            && let Some(done) = (*work.partial()).clone()
        {
            self.to_align |= !self.by_hand;
            (self.prepared, self.fit) = (Some(done), None);
        }
        let Ok(read) = self.file.contents() else {
            (self.prepared, self.asked, self.preparing) = (None, None, None);
            return;
        };
        let unit = self.choice.unit.and_then(|i| units(info(self.choice.signal).unit).get(i));
        let wish = ChannelWish {
            channel: self.choice.channel.clone(),
            size: unit.map_or(1.0, |unit| unit.size),
            preparation: self.choice.preparation.clone(),
            row_s: session.chosen().run().recording().row_s(),
        };
        let same = |(of, asked): &(Arc<file::ReadFile>, ChannelWish)| {
            Arc::ptr_eq(of, read) && *asked == wish
        };
        if self.asked.as_ref().is_some_and(same) {
            return;
        }
        let (file, asked) = (Arc::clone(read), wish.clone());
        let name = self.file.name.clone();
        let work = SingleTask::new(move || prepared(&name, &file, &asked));
        self.asked = Some((Arc::clone(read), wish));
        self.preparing = Some(jobs.begin_brief(tr(WORK), work, 1));
    }

    /// The values of the signal in the run, worked out once for each change of it.
    fn reference_of(&mut self, session: &Session) -> (ReferenceKey, OfRun) {
        let recording = session.chosen().run().recording();
        let key = (session.changes(), recording.rows().len(), self.choice.signal);
        match &self.reference {
            Some((known, reference)) if *known == key => (key, Arc::clone(reference)),
            Some(_) | None => {
                let values = over_run::reference(recording, info(self.choice.signal));
                let reference = Arc::new(values.map_err(|fault| fault.to_string()));
                self.reference = Some((key, Arc::clone(&reference)));
                (key, reference)
            }
        }
    }
}

/// All measured data over the plots.
#[derive(Default)]
pub struct Overlays {
    all: Vec<Overlay>,
    /// The one that the window shows.
    chosen: usize,
    so_far: u64,
}

impl Overlays {
    /// Lays a file over the plots, and chooses it; `false` where there are as many as there may be.
    pub fn take(&mut self, file: &MeasuredFile) -> bool {
        if self.all.len() >= MOST_OVERLAYS {
            return false;
        }
        self.so_far += 1;
        self.all.push(Overlay::new(self.so_far, file.clone()));
        self.chosen = self.all.len() - 1;
        true
    }

    /// Those that there are.
    #[must_use]
    pub fn all(&self) -> &[Overlay] {
        &self.all
    }

    /// Place of the one that the window shows.
    #[must_use]
    pub fn place(&self) -> usize {
        self.chosen
    }

    /// The one that the window shows.
    pub fn chosen_mut(&mut self) -> Option<&mut Overlay> {
        self.all.get_mut(self.chosen)
    }

    /// Shows another one in the window.
    pub fn choose(&mut self, place: usize) {
        self.chosen = place.min(self.all.len().saturating_sub(1));
    }

    /// Removes the one that the window shows.
    pub fn remove_chosen(&mut self) {
        if self.chosen < self.all.len() {
            self.all.remove(self.chosen);
            self.choose(self.chosen);
        }
    }

    /// Says what is wrong with a file in the language of now.
    pub fn tell_anew(&mut self) {
        let faulty = self.all.iter_mut().filter(|overlay| overlay.file.contents().is_err());
        faulty.for_each(|overlay| overlay.file = overlay.file.again());
    }

    /// Follows what was chosen and the run.
    pub fn follow(&mut self, session: &Session, jobs: &Jobs) {
        self.all.iter_mut().for_each(|overlay| overlay.follow(session, jobs));
    }

    /// Puts each of them into the chart of its unit.
    pub fn over<'a>(&'a self, charts: &mut [Chart<'a>]) {
        for (number, overlay) in self.all.iter().enumerate() {
            let unit = info(overlay.choice.signal).unit;
            let chart = charts.iter_mut().find(|chart| chart.unit() == unit);
            let (Some(chart), Some(Ok(channel))) = (chart, overlay.prepared()) else { continue };
            chart.measured.push(ChartMeasured {
                id: overlay.id,
                name: overlay.name(),
                number,
                trace: &channel.trace,
                place: overlay.place,
            });
        }
    }
}
