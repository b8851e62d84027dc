//! The console: the only part that draws. Panels read a [`panels::View`] and push
//! [`command::Command`]s; [`Console`] carries them out.

mod bar;
mod clock;
pub mod command;
pub mod cut;
mod execute;
mod files;
pub mod format;
mod glossary;
pub mod history;
pub mod jobs;
mod link;
mod messages;
#[cfg(not(target_arch = "wasm32"))]
mod native;
pub mod panels;
pub mod playback;
pub mod scene;
mod search;
pub mod session;
pub mod shortcuts;
mod speaker;
pub mod theme;
mod timeline;
pub mod trace;
pub mod twin;
#[cfg(target_arch = "wasm32")]
pub mod web;
pub mod widgets;

use egui::{CentralPanel, Frame, Margin, Panel as SidePanel, Ui};

use crate::run::signals::signal;
use crate::run::{Start, scenario_link};
use bar::Tab;
use command::{Command, ShellCommand};
use files::Files;
use jobs::Jobs;
use link::{Address, Due};
use messages::Messages;
use panels::{Panel, View, panels};
use search::Finder;
use session::Session;
use shortcuts::{Host, Reach};
use widgets::{focus, scaffold, setting};

/// Time without a change after which a drag counts as over, s.
const GESTURE_PAUSE_S: f64 = 0.6;

/// The application.
pub struct Console {
    session: Session,
    jobs: Jobs,
    panels: Vec<Box<dyn Panel>>,
    shown: usize,
    files: Files,
    place: Host,
    messages: Messages,
    /// Whether the sheet of keys is shown.
    shortcuts: bool,
    search: Finder,
    /// A link that is put up for copying.
    link: Option<String>,
    address: Address,
    /// Whether a control had the focus at the end of the last frame.
    had_focus: bool,
    /// Whether the next Tab leaves the console, in a page.
    tab_leaves: bool,
    frames: u64,
    since_change_s: f64,
    target_slider: Option<egui::Rect>,
}

/// Opens the console in a window of the desktop and stays until it is closed.
///
/// # Errors
/// There is no display, or nothing to draw with: what is missing, and how to get it.
#[cfg(not(target_arch = "wasm32"))]
pub fn open(start: Start) -> Result<(), String> {
    native::run(start)
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
        let mut session = Session::new(start.scenario, start.edits);
        if let Some(notice) = start.notice {
            session.notify(notice);
        }
        Self {
            session,
            jobs: Jobs::default(),
            panels,
            shown: 0,
            files: Files::default(),
            place: Host::HERE,
            messages: Messages::default(),
            shortcuts: false,
            search: Finder::default(),
            link: None,
            address: Address::default(),
            had_focus: false,
            tab_leaves: false,
            frames: 0,
            since_change_s: 0.0,
            target_slider: None,
        }
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
        let dt_s = scaffold::frame_s(&ctx);
        let mut commands: Vec<Command> = self.files.answers().collect();
        self.files.take_dropped(&ctx);
        let ids: Vec<&'static str> = self.panels.iter().map(|panel| panel.id()).collect();
        let timeline = self.panels[self.shown].has_timeline();
        let reach = Reach { place: self.place, screens: &ids, timeline };
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
        self.messages.follow(self.session.notices(), real_s);
        theme::fit(ui);
        self.draw(ui, &mut commands);
        shortcuts::sheet(&ctx, &Reach { timeline, ..reach }, &mut self.shortcuts);
        if let Some(link) = self.link.take() {
            self.link = link::show(&ctx, &link, &self.repeated()).then_some(link);
        }
        glossary::explain(&ctx);
        let acted = !commands.is_empty();
        for command in commands {
            self.execute(command, &ctx);
        }
        self.follow_focus(&ctx);
        self.frames += 1;
        self.target_slider = setting::slider_rect(&ctx, "target.ra_um");
        self.write_address(&ctx);
        let session = &self.session;
        let plays = session.playback().playing && timeline;
        if acted || plays || session.progress() < 1.0 || session.comparison_is_due() {
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
        if over || (!self.had_focus && self.messages().next().is_some()) {
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
        let view = View { session: &self.session, jobs: &self.jobs, place: self.place, narrow };
        let tabs: Vec<Tab> = self
            .panels
            .iter()
            .map(|p| Tab { id: p.id(), title: p.title(), words: p.words() })
            .collect();
        let side = if view.narrow { 8 } else { 12 };
        let strip = |ui: &Ui, y| {
            Frame::new().fill(ui.visuals().panel_fill).inner_margin(Margin::symmetric(side, y))
        };
        let shown = self.panels[self.shown].id();
        let frame = strip(ui, 6);
        SidePanel::top("bar").frame(frame).resizable(false).show(ui, |ui| {
            bar::show(ui, &view, &tabs, shown, commands);
        });
        if self.panels[self.shown].has_timeline() {
            SidePanel::bottom("timeline").frame(strip(ui, 6)).resizable(false).show(ui, |ui| {
                timeline::show(ui, &view, commands);
            });
        }
        let middle = ui.available_rect_before_wrap();
        CentralPanel::no_frame().frame(strip(ui, 0).inner_margin(0)).show(ui, |ui| {
            focus::begin_screen(ui);
            self.panels[self.shown].ui(ui, &view, commands);
        });
        self.messages.show(ui.ctx(), middle, self.session.notices(), commands);
        self.search.ui(ui.ctx(), &view, &tabs, commands);
    }

    /// Scenario and edits as the part of a link after `#`.
    fn fragment(&self) -> String {
        scenario_link::write(self.session.scenario(), self.session.edits())
    }

    /// Keeps the page's address current; a window of the desktop has none.
    fn write_address(&mut self, ctx: &egui::Context) {
        match self.address.due(self.session.changes(), clock::now_s()) {
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
    /// there is none), the last message, a link put up for copying, whether the address holds the last change, and where the slider of the target is, in points.
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
        serde_json::json!({
            "frames": self.frames,
            "playing": playback.playing,
            "playhead_s": playback.playhead_s,
            "target_ra_um": self.session.current().target.ra_um,
            "ra_um": signal("ra_um").and_then(|signal| (signal.value)(self.session.row())),
            "screen": self.panels[self.shown].id(),
            "screens": screens,
            "link": self.link,
            "address_is_current": self.address.is_current(self.session.changes()),
            "error": self.session.notices().last().map(|notice| notice.text.as_str()),
            "rects": { "target_ra_slider": rect },
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
