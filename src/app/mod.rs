//! The console: the only part that draws. Panels read a [`panels::View`] and push
//! [`command::Command`]s; [`Console`] carries them out.

mod bar;
mod clock;
pub mod command;
pub mod cut;
mod execute;
mod files;
pub mod format;
pub mod history;
pub mod jobs;
#[cfg(not(target_arch = "wasm32"))]
mod native;
pub mod panels;
pub mod playback;
pub mod scene;
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

use crate::run::{Start, scenario_link};
use bar::Tab;
use command::Command;
use files::Files;
use jobs::Jobs;
use panels::{Panel, View, panels};
use session::Session;
use widgets::{scaffold, setting};

/// Time without a change after which a drag counts as over, s.
const GESTURE_PAUSE_S: f64 = 0.6;
/// The link is brought up to date at most this often, s: browsers refuse more.
const LINK_EVERY_S: f64 = 0.5;

/// The application.
pub struct Console {
    session: Session,
    jobs: Jobs,
    panels: Vec<Box<dyn Panel>>,
    shown: usize,
    files: Files,
    shortcuts: bool,
    frames: u64,
    since_change_s: f64,
    link: Link,
    target_slider: Option<egui::Rect>,
}

/// What the link in the page's address holds.
#[derive(Default)]
struct Link {
    changes: u64,
    age_s: f64,
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
            shortcuts: false,
            frames: 0,
            since_change_s: 0.0,
            link: Link::default(),
            target_slider: None,
        }
    }

    /// Scenario, run and playhead.
    #[must_use]
    pub fn session(&self) -> &Session {
        &self.session
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
        shortcuts::read(&ctx, &ids, &mut commands);
        for command in commands.drain(..) {
            self.execute(command, &ctx);
        }
        self.session.advance(dt_s);
        self.jobs.pump(&ctx);
        self.since_change_s += dt_s;
        if self.since_change_s > GESTURE_PAUSE_S && !ctx.input(|input| input.pointer.any_down()) {
            self.session.end_gesture();
        }
        self.draw(ui, &mut commands);
        shortcuts::sheet(&ctx, ids.len(), &mut self.shortcuts);
        let acted = !commands.is_empty();
        for command in commands {
            self.execute(command, &ctx);
        }
        self.frames += 1;
        self.target_slider = setting::slider_rect(&ctx, "target.ra_um");
        self.write_link(dt_s);
        let session = &self.session;
        let at_work = session.playback().playing || session.progress() < 1.0;
        if acted || at_work || session.comparison_is_due() {
            ctx.request_repaint();
        }
    }

    fn draw(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        let narrow = ui.available_width() < theme::NARROW;
        let view = View { session: &self.session, jobs: &self.jobs, narrow };
        let tabs: Vec<Tab> =
            self.panels.iter().map(|p| Tab { id: p.id(), title: p.title() }).collect();
        let side = if view.narrow { 8 } else { 12 };
        let strip = |ui: &Ui, y| {
            Frame::new().fill(ui.visuals().panel_fill).inner_margin(Margin::symmetric(side, y))
        };
        let shown = self.panels[self.shown].id();
        let frame = strip(ui, 6);
        SidePanel::top("bar").frame(frame).resizable(false).show(ui, |ui| {
            bar::show(ui, &view, &tabs, shown, commands);
            bar::notices(ui, &view, commands);
        });
        SidePanel::bottom("timeline").frame(strip(ui, 6)).resizable(false).show(ui, |ui| {
            timeline::show(ui, &view, commands);
        });
        CentralPanel::no_frame().frame(strip(ui, 0).inner_margin(0)).show(ui, |ui| {
            self.panels[self.shown].ui(ui, &view, commands);
        });
    }

    /// Scenario and edits as the part of a link after `#`.
    fn fragment(&self) -> String {
        scenario_link::write(self.session.scenario(), self.session.edits())
    }

    /// Keeps the page's address current; a window of the desktop has none.
    fn write_link(&mut self, dt_s: f64) {
        self.link.age_s += dt_s;
        if self.link.changes == self.session.changes() || self.link.age_s < LINK_EVERY_S {
            return;
        }
        self.link = Link { changes: self.session.changes(), age_s: 0.0 };
        #[cfg(target_arch = "wasm32")]
        web::write_link(&self.fragment());
    }

    /// What tests in a browser read: frames drawn, playhead, target and produced Ra, the screen
    /// that is shown and the list of all with their keys (with Ctrl; null where there is none), the
    /// last message, and where the slider of the target is, in points.
    #[must_use]
    pub fn state_json(&self) -> String {
        let playback = self.session.playback();
        let screens = self.panels.iter().enumerate().map(|(place, panel)| {
            let key = shortcuts::screen_key(place).map(egui::Key::symbol_or_name);
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
            "ra_um": self.session.row().ra_um,
            "screen": self.panels[self.shown].id(),
            "screens": screens,
            "error": self.session.notices().last().map(|notice| notice.text.as_str()),
            "rects": { "target_ra_slider": rect },
        })
        .to_string()
    }
}

#[cfg(not(target_arch = "wasm32"))]
impl eframe::App for Console {
    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        Self::ui(self, ui);
    }
}
