//! Files of one's own: a folder on the desktop, files kept by the browser in a page. They are listed in a window over any
//! screen, and used in the present cut by the very commands that dropping them makes.

#[cfg(not(target_arch = "wasm32"))]
mod folder;
mod page;
mod present;
mod shelf;
mod window;
mod work;

use std::sync::Arc;

use egui::Context;

#[cfg(not(target_arch = "wasm32"))]
pub use folder::FolderShelf;
#[cfg(target_arch = "wasm32")]
pub use page::LocalSlots;
pub use page::{PageShelf, Slots};
pub use present::{BEGUN, PRESENT, begun, present};
pub use shelf::{Shelf, Shelved, ShelvedFile};
pub use work::{ReadShelf, ShelfRead};

use super::clock::now_s;
use super::command::{Command, LibraryCommand, OpenedFile};
use super::jobs::{Jobs, Work};
use super::session::Session;
use crate::base::language::{text, tr};
use crate::study::library::{LibraryFile, LibraryKind};
use window::LibraryWindow;

/// Name of the window.
pub const MY_FILES: &str = text!("My files");
/// A folder that is shown is read again so often, s.
const EVERY_S: f64 = 2.0;
/// Most files that were opened from elsewhere and are offered to be kept.
const MOST_OPENED: usize = 4;
/// The longest of them, bytes.
pub const LONGEST_OPENED: usize = 4_000_000;

/// How many changes of the cut there were, and how many of its edits the playhead is past.
type CutStand = (u64, usize);

/// The files, and the window on them.
#[derive(Default)]
pub struct Library {
    shelf: Option<Arc<dyn Shelf>>,
    open: bool,
    window: LibraryWindow,
    read: Arc<ShelfRead>,
    /// Whether it was read at all.
    is_read: bool,
    work: Option<Work<ReadShelf>>,
    /// When it is read again, s; none: not before something changes.
    due_s: Option<f64>,
    /// What was opened from elsewhere, the last one first.
    opened: Vec<OpenedFile>,
    /// Which of the files is in use, after so many changes of the cut and past so many of its edits.
    in_use: Option<(CutStand, Vec<Option<bool>>)>,
}

impl Library {
    /// Keeps files here from now on.
    pub fn keep_on(&mut self, shelf: Arc<dyn Shelf>) {
        *self = Self { shelf: Some(shelf), ..Self::default() };
    }

    /// Where files are kept, if anywhere.
    #[must_use]
    pub fn shelf(&self) -> Option<Arc<dyn Shelf>> {
        self.shelf.clone()
    }

    /// Shows or closes the window, with the files of one kind unfolded.
    pub fn show_it(&mut self, open: bool, kind: Option<LibraryKind>) {
        self.open = open;
        self.window.unfold(kind);
        self.look_again();
    }

    /// Whether the window is shown.
    #[must_use]
    pub fn is_open(&self) -> bool {
        self.open
    }

    /// What is on the shelf, as it was read last.
    #[must_use]
    pub fn read(&self) -> &ShelfRead {
        &self.read
    }

    /// Reads it again at once.
    pub fn look_again(&mut self) {
        self.due_s = Some(0.0);
    }

    /// Forgets what was said in another language.
    pub fn tell_anew(&mut self) {
        self.read = Arc::default();
        self.is_read = false;
        self.work = None;
        self.look_again();
    }

    /// Notes a file that was opened from elsewhere.
    pub fn was_opened(&mut self, file: OpenedFile) {
        self.opened.retain(|other| other.name != file.name);
        self.opened.insert(0, file);
        self.opened.truncate(MOST_OPENED);
    }

    /// One of those.
    #[must_use]
    pub fn opened(&self, name: &str) -> Option<&OpenedFile> {
        self.opened.iter().find(|file| file.name == name)
    }

    /// It is kept now.
    pub fn was_kept(&mut self, name: &str) {
        self.opened.retain(|file| file.name != name);
        self.look_again();
    }

    /// Reads the shelf where that is due, and shows the window.
    pub fn ui(
        &mut self,
        ctx: &Context,
        (session, jobs): (&Session, &Jobs),
        commands: &mut Vec<Command>,
    ) {
        if !self.open {
            return;
        }
        self.follow(ctx, jobs);
        // What was edited in the cut is used from there on.
        let now_s = session.playback().playhead_s;
        let passed = session.edits().list().iter().filter(|edit| edit.at_s <= now_s).count();
        let stand = (session.changes(), passed);
        if self.in_use.as_ref().is_none_or(|(of, _)| *of != stand) {
            let plan = (session.scenario(), session.edits());
            let used = |file: &LibraryFile| file.is_in_use(session.current(), plan);
            self.in_use = Some((stand, self.read.files.iter().map(used).collect()));
        }
        let in_use = self.in_use.as_ref().map_or(&[][..], |(_, in_use)| in_use);
        let shown = window::LibraryShown {
            shelf: self.shelf.as_deref(),
            read: &self.read,
            is_read: self.is_read,
            opened: &self.opened,
            in_use,
            session,
        };
        self.open = self.window.show(ctx, &shown, commands);
        if !self.open {
            commands.push(Command::Library(LibraryCommand::Show { open: false, kind: None }));
        }
    }

    fn follow(&mut self, ctx: &Context, jobs: &Jobs) {
        let Some(shelf) = &self.shelf else { return };
        if let Some(work) = self.work.take_if(|work| work.is_over())
            && let Some(read) = (*work.partial()).clone()
        {
            if *read != *self.read {
                self.read = read;
                self.in_use = None;
            }
            self.is_read = true;
        }
        let now = now_s();
        if self.work.is_none() && self.due_s.is_some_and(|due_s| now >= due_s) {
            let work = ReadShelf::new(Arc::clone(shelf), Arc::clone(&self.read));
            self.work = Some(jobs.begin_brief(tr(MY_FILES), work, 4));
            // What a browser keeps is changed by this page alone.
            self.due_s = (!shelf.can_remove()).then_some(now + EVERY_S);
        }
        if let Some(due_s) = self.due_s {
            ctx.request_repaint_after_secs((due_s - now).max(0.0) as f32);
        }
    }
}
