//! The console: the only part that draws. Panels read a [`panels::View`] and push
//! [`command::Command`]s; [`Console`] carries them out.

mod about;
mod bar;
mod clock;
pub mod command;
pub mod cut;
mod draw_calls;
mod execute;
mod files;
pub mod format;
mod framed;
mod glossary;
pub mod history;
pub mod jobs;
pub mod library;
mod link;
mod messages;
pub mod mirror;
#[cfg(not(target_arch = "wasm32"))]
mod native;
pub mod overlay;
pub mod panels;
pub mod playback;
pub mod remembered;
pub mod scene;
mod search;
pub mod session;
pub mod shortcuts;
mod speaker;
pub mod theme;
mod timeline;
pub mod trace;
#[cfg(target_arch = "wasm32")]
pub mod web;
pub mod widgets;

use std::collections::BTreeMap;
use std::sync::Arc;

use egui::{CentralPanel, Frame, Margin, Panel as SidePanel, Ui};

use crate::base::language::{self, Language, tr};
use crate::run::signals::signal;
use crate::run::{Start, scenario_link};
use crate::study::mission::MissionResult;
use crate::study::opening::{Frame as Embedding, FramePart, Opening};
use bar::{LEARN, Tab};
use command::{Command, FileCommand, ShellCommand};
use files::Files;
use jobs::Jobs;
use library::{Library, Shelf};
use link::{Address, Due, LinkWindow};
use messages::Messages;
use panels::{BroughtFile, Panel, View, panels};
use remembered::Remembered;
use search::Finder;
use session::Session;
use shortcuts::{Host, Reach};
use widgets::{focus, scaffold, setting, window};

/// Time without a change after which a drag counts as over, s.
const GESTURE_PAUSE_S: f64 = 0.6;

/// The application.
pub struct Console {
    session: Session,
    jobs: Jobs,
    panels: Vec<Box<dyn Panel>>,
    shown: usize,
    files: Files,
    library: Library,
    place: Host,
    messages: Messages,
    /// Whether the sheet of keys is shown.
    shortcuts: bool,
    search: Finder,
    /// A link that is put up.
    link: Option<LinkWindow>,
    /// What is hidden.
    frame: Embedding,
    remembered: Remembered,
    /// The language that was chosen; none leaves that of the thread, English unless told otherwise.
    language: Option<Language>,
    /// What the last mission that was marked came to.
    result: Option<MissionResult>,
    address: Address,
    /// Whether a control had the focus at the end of the last frame.
    had_focus: bool,
    /// Whether the next Tab leaves the console, in a page.
    tab_leaves: bool,
    frames: u64,
    since_change_s: f64,
    target_slider: Option<egui::Rect>,
    /// Where the buttons of a mission are, by their names.
    lesson_rects: BTreeMap<String, [f32; 4]>,
}

/// Opens the console in a window of the desktop and stays until it is closed.
///
/// # Errors
/// There is no display, or nothing to draw with: what is missing, and how to get it.
#[cfg(not(target_arch = "wasm32"))]
pub fn open(opening: Opening) -> Result<(), String> {
    native::run(opening)
}

impl Console {
    /// The console at the start of a cut, playing.
    #[must_use]
    pub fn new(ctx: &egui::Context, start: Start) -> Self {
        Self::with_screens(ctx, start, panels())
    }

    /// The console with these screens, of which there is at least one.
    ///
    /// # Panics
    /// There is none.
    #[must_use]
    pub fn with_screens(ctx: &egui::Context, start: Start, panels: Vec<Box<dyn Panel>>) -> Self {
        assert!(!panels.is_empty(), "a console has a screen");
        theme::install(ctx);
        ctx.add_plugin(mirror::PlainNames);
        ctx.add_plugin(draw_calls::FewDrawCalls);
        let mut session = Session::new(start.scenario, start.edits);
        if let Some(notice) = start.notice {
            session.notify(notice);
        }
        session.wait_for_consent();
        Self {
            session,
            jobs: Jobs::default(),
            panels,
            shown: 0,
            files: Files::default(),
            library: Library::default(),
            place: Host::HERE,
            messages: Messages::default(),
            shortcuts: false,
            search: Finder::default(),
            link: None,
            frame: Embedding::default(),
            remembered: Remembered::default(),
            language: None,
            result: None,
            address: Address::default(),
            had_focus: false,
            tab_leaves: false,
            frames: 0,
            since_change_s: 0.0,
            target_slider: None,
            lesson_rects: BTreeMap::new(),
        }
    }

    /// The console with all that a link says: mission, what is hidden and locked, the screen to begin with.
    #[must_use]
    pub fn opened(ctx: &egui::Context, opening: Opening) -> Self {
        let Opening { start, mission, frame, problems, unread: _ } = opening;
        let mut console = Self::new(ctx, start);
        problems.into_iter().for_each(|problem| console.session.notify(problem));
        console.session.lock(frame.locked().clone());
        if let Some(id) = frame.screen() {
            let ids: Vec<&str> = console.panels.iter().map(|panel| panel.id()).collect();
            match ids.iter().position(|known| *known == id) {
                Some(place) => console.shown = place,
                None => {
                    let allowed = ids.join(", ");
                    let problem = tr!(
                        "embed: `screen:{id}`: allowed behind screen: are {allowed}",
                        id = id,
                        allowed = allowed
                    );
                    console.session.notify(problem);
                }
            }
        }
        console.frame = frame;
        if let Some(mission) = mission {
            let brought = BroughtFile::Linked(Box::new(mission));
            console.push(Command::File(FileCommand::Bring(brought)));
        }
        console
    }

    /// Keeps what is remembered from one start to the next; without this it is forgotten.
    pub fn remember(&mut self, remembered: Remembered) {
        self.files.know(remembered.layouts().clone());
        self.remembered = remembered;
    }

    /// Keeps files of one's own here; without this there is no place for them.
    pub fn keep_files(&mut self, shelf: Arc<dyn Shelf>) {
        self.library.keep_on(shelf);
    }

    /// Files of one's own.
    #[must_use]
    pub fn library(&self) -> &Library {
        &self.library
    }

    /// Speaks the language that a link names, else the one chosen at an earlier start, else the first of these tags
    /// that the program has, else English.
    pub fn speak_as_asked(&mut self, tags: impl IntoIterator<Item = String>) {
        let asked = self.frame.language().or(self.remembered.language());
        let language = asked.or_else(|| tags.into_iter().find_map(|tag| Language::of_tag(&tag)));
        self.speak(language.unwrap_or(Language::English));
    }

    /// Speaks this language from now on.
    pub fn speak(&mut self, language: Language) {
        self.language = Some(language);
        language::choose(language);
        self.tell_anew();
        #[cfg(target_arch = "wasm32")]
        web::speaks(language);
    }

    /// Makes the texts anew that are kept from frame to frame, in the language of the thread.
    pub fn tell_anew(&mut self) {
        self.session.tell_anew();
        self.library.tell_anew();
        self.panels.iter_mut().for_each(|panel| panel.tell_anew());
    }

    /// Scenario, run and playhead.
    #[must_use]
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// Takes the keys of a page from now on, as in a browser.
    pub fn act_as_page(&mut self) {
        self.place = Host::Page;
    }

    /// Carries a command out in the next frame.
    pub fn push(&self, command: Command) {
        self.files.push(command);
    }

    /// The messages over the screen, the newest last.
    pub fn messages(&self) -> impl Iterator<Item = &str> {
        let notices = self.session.notices().iter();
        notices
            .filter(|notice| self.messages.is_up(notice.number))
            .map(|notice| notice.text.as_str())
    }

    /// Whether the next Tab is to leave the console for what stands around it.
    #[must_use]
    pub fn tab_leaves(&self) -> bool {
        self.tab_leaves
    }

    /// The long work of the screens.
    #[must_use]
    pub fn jobs(&self) -> &Jobs {
        &self.jobs
    }

    /// One frame: input, time, picture, and then the commands that came of it.
    pub fn ui(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx().clone();
        if let Some(language) = self.language {
            language::choose(language);
        }
        let dt_s = scaffold::frame_s(&ctx);
        let mut commands: Vec<Command> = self.files.answers().collect();
        self.files.take_dropped(&ctx, self.panels[self.shown].drop_target());
        let ids: Vec<&'static str> = match self.frame.hides(FramePart::Screens) {
            true => Vec::new(),
            false => self.panels.iter().map(|panel| panel.id()).collect(),
        };
        framed::lock(&ctx, self.frame.locked());
        framed::open(&ctx, self.session.mission());
        framed::offer(&ctx, self.session.mission().map(|lock| &lock.options));
        let timeline = self.panels[self.shown].has_timeline();
        let operator = self.session.hand().is_on();
        let reach = Reach { place: self.place, screens: &ids, timeline, operator };
        focus::resume(&ctx);
        self.escape(&ctx, &mut commands);
        shortcuts::read(&ctx, &reach, &mut commands);
        for command in commands.drain(..) {
            self.execute(command, &ctx);
        }
        // The playhead moves where it is seen.
        let timeline = self.panels[self.shown].has_timeline();
        self.session.advance(if timeline && !is_hidden() { dt_s } else { 0.0 });
        self.jobs.pump(&ctx);
        self.since_change_s += dt_s;
        if self.since_change_s > GESTURE_PAUSE_S && !ctx.input(|input| input.pointer.any_down()) {
            self.session.end_gesture();
        }
        // By the clock, however long frames take; a page that was hidden shows what it had to say.
        let real_s = ctx.input(|input| f64::from(input.unstable_dt)).min(1.0);
        let mission = (self.session.missions(), self.session.mission().is_some());
        self.messages.follow(self.session.notices(), real_s, mission);
        theme::fit(ui);
        self.draw(ui, &mut commands);
        let reach = Reach { timeline, ..reach };
        shortcuts::sheet(&ctx, &reach, &mut self.shortcuts, &mut commands);
        if let Some(mut link) = self.link.take() {
            let stand = (self.addressed(), self.session.chosen().run().end().is_some());
            let open = link.show(&ctx, stand, || self.told(), &mut commands);
            self.link = open.then_some(link);
        }
        self.library.ui(&ctx, (&self.session, &self.jobs), &mut commands);
        glossary::explain(&ctx);
        let acted = !commands.is_empty();
        for command in commands {
            self.execute(command, &ctx);
        }
        self.follow_focus(&ctx);
        self.frames += 1;
        self.target_slider = setting::slider_rect(&ctx, "target.ra_um");
        self.lesson_rects = panels::learn::places(&ctx);
        self.write_address(&ctx);
        let session = &self.session;
        let plays = session.playback().playing && timeline && !session.hides_the_cut();
        let computes = session.progress() < 1.0 || !session.twin_stand().is_settled();
        if acted || plays || computes || session.comparison_is_due() {
            ctx.request_repaint();
        }
    }

    /// What Escape closes around the screens. A control that has the focus loses it first, and menus close
    /// themselves.
    fn escape(&mut self, ctx: &egui::Context, commands: &mut Vec<Command>) {
        let escaped = ctx.input(|input| input.key_pressed(egui::Key::Escape));
        if !escaped || egui::Popup::is_any_open(ctx) {
            return;
        }
        let over = self.shortcuts || self.search.is_open() || self.link.is_some();
        // A window takes the key itself: it is what people look at, and a message goes by itself.
        let message = self.messages().next().is_some() && !window::is_shown(ctx);
        if over || (!self.had_focus && message) {
            ctx.input_mut(|input| input.consume_key(egui::Modifiers::NONE, egui::Key::Escape));
            commands.push(Command::Shell(ShellCommand::CloseTopmost));
        }
    }

    /// Whether Tab stays in the console: it does until Escape found nothing to close in this frame.
    fn follow_focus(&mut self, ctx: &egui::Context) {
        let had_focus = self.had_focus;
        self.had_focus = ctx.memory(|memory| memory.focused().is_some());
        let (escaped, touched) = ctx.input(|input| {
            let left = !input.raw.focused || input.pointer.any_pressed();
            (input.key_pressed(egui::Key::Escape), left)
        });
        if self.had_focus || touched {
            self.tab_leaves = false;
        } else if escaped && !had_focus && !egui::Popup::is_any_open(ctx) {
            self.tab_leaves = true;
        }
    }

    fn draw(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        let narrow = ui.available_width() < theme::NARROW;
        let view = View {
            session: &self.session,
            jobs: &self.jobs,
            frame: &self.frame,
            remembered: &self.remembered,
            place: self.place,
            narrow,
        };
        let leads_on = !self.frame.hides(FramePart::Screens);
        let tabs: Vec<Tab> = self
            .panels
            .iter()
            .filter(|_| leads_on)
            .map(|p| Tab { id: p.id(), title: p.title(), words: p.words() })
            .collect();
        let side = if view.narrow { 8 } else { 12 };
        let strip = |ui: &Ui, y| {
            Frame::new().fill(ui.visuals().panel_fill).inner_margin(Margin::symmetric(side, y))
        };
        let shown = self.panels[self.shown].id();
        if !self.frame.hides(FramePart::Bar) {
            let frame = strip(ui, 6);
            SidePanel::top("bar").frame(frame).resizable(false).show(ui, |ui| {
                bar::show(ui, &view, &tabs, shown, commands);
            });
        }
        let lock = self.session.mission().filter(|_| leads_on && shown != LEARN);
        if let Some(lock) = lock {
            let frame = strip(ui, 4);
            SidePanel::top("mission").frame(frame).resizable(false).show(ui, |ui| {
                bar::open_mission(ui, &view, lock, commands);
            });
        }
        let transport = !self.frame.hides(FramePart::Transport);
        if transport && self.panels[self.shown].has_timeline() {
            SidePanel::bottom("timeline").frame(strip(ui, 6)).resizable(false).show(ui, |ui| {
                if self.session.hides_the_cut() {
                    ui.disable();
                }
                timeline::show(ui, &view, commands);
            });
        }
        let middle = ui.available_rect_before_wrap();
        let hides = self.session.hides_the_cut() && shown != LEARN;
        CentralPanel::no_frame().frame(strip(ui, 0).inner_margin(0)).show(ui, |ui| {
            focus::begin_screen(ui);
            match hides {
                // What is asked could be read off any of them.
                true => panels::learn::instead_of_the_cut(ui, &view),
                false => self.panels[self.shown].ui(ui, &view, commands),
            }
        });
        // What leads back to a mission, and out of it, is not lain upon.
        let below = lock.map(|_| middle.top());
        self.messages.show(ui.ctx(), (middle, below), self.session.notices(), commands);
        self.search.ui(ui.ctx(), &view, &tabs, commands);
    }

    /// Flags, mission, scenario and edits as the part of a link after `#`.
    fn fragment(&self) -> String {
        let (scenario, edits) = (self.session.scenario(), self.session.edits());
        let mission = self.session.mission();
        let as_given =
            mission.is_some_and(|lock| lock.scenario == *scenario && lock.given == *edits);
        let cut = if as_given { String::new() } else { scenario_link::write(scenario, edits) };
        let mission = mission.map_or(String::new(), |lock| lock.link.clone());
        let parts = [self.frame.write(), mission, cut];
        let parts: Vec<String> = parts.into_iter().filter(|part| !part.is_empty()).collect();
        parts.join("&")
    }

    /// Counts what the address depends on.
    fn addressed(&self) -> u64 {
        self.session.changes() + self.session.missions()
    }

    /// Whether a link pasted into the open page is not followed, because settings are locked: then it says so, and
    /// the address is to be written again.
    pub fn keeps_its_address(&mut self) -> bool {
        let keeps = self.session.has_locks();
        if keeps {
            self.session.notify(tr(session::NO_OTHER_SCENARIO));
        }
        keeps
    }

    /// Keeps the page's address current; a window of the desktop has none.
    fn write_address(&mut self, ctx: &egui::Context) {
        match self.address.due(self.addressed(), clock::now_s()) {
            Due::Current => {}
            // Nothing else may ask for a frame by then.
            Due::In(wait_s) => ctx.request_repaint_after_secs(wait_s as f32),
            Due::Now => {
                #[cfg(target_arch = "wasm32")]
                web::write_link(&self.fragment());
            }
        }
    }

    /// What tests in a browser read: frames drawn, playhead, target and produced Ra, the screen
    /// that is shown and the list of all with their keys (alone in a page, with Ctrl in a window; null where
    /// there is none), the last message, a link that is put up, the mission under way as links have it, the result
    /// of the last one that was marked with the stars remembered of it, the files of one's own that were read last, whether the address holds the last change,
    /// and where the slider of the target and the buttons of a mission are, in points.
    #[must_use]
    pub fn state_json(&self) -> String {
        let playback = self.session.playback();
        let screens = self.panels.iter().enumerate().map(|(place, panel)| {
            let key = shortcuts::screen_key(place, self.place);
            let key = key.map(|keys| keys.logical_key.symbol_or_name());
            serde_json::json!({ "id": panel.id(), "title": panel.title(), "key": key })
        });
        let screens: Vec<_> = screens.collect();
        let rect = self.target_slider.map_or_else(Vec::new, |rect| {
            vec![rect.left(), rect.top(), rect.right(), rect.bottom()]
        });
        let result = self.result.as_ref().map(MissionResult::kept_as);
        serde_json::json!({
            "frames": self.frames,
            "playing": playback.playing,
            "playhead_s": playback.playhead_s,
            "target_ra_um": self.session.current().target.ra_um,
            "ra_um": signal("ra_um").and_then(|signal| (signal.value)(self.session.row())),
            "screen": self.panels[self.shown].id(),
            "screens": screens,
            "link": self.link.as_ref().map(LinkWindow::link),
            "mission": self.session.mission().map(|lock| &lock.link),
            "result": self.result,
            "stars": result.as_ref().and_then(|id| self.remembered.stars(id)),
            "files": self.library.read().files.iter().map(|file| &file.name).collect::<Vec<_>>(),
            "address_is_current": self.address.is_current(self.addressed()),
            "error": self.session.notices().last().map(|notice| notice.text.as_str()),
            "rects": { "target_ra_slider": rect, "lesson": self.lesson_rects },
        })
        .to_string()
    }
}

/// Whether nobody sees the page: then the playhead rests. A window always counts as seen.
fn is_hidden() -> bool {
    #[cfg(target_arch = "wasm32")]
    let hidden = web::is_hidden();
    #[cfg(not(target_arch = "wasm32"))]
    let hidden = false;
    hidden
}

#[cfg(not(target_arch = "wasm32"))]
impl eframe::App for Console {
    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        Self::ui(self, ui);
    }
}
