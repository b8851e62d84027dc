//! The link that holds scenario, edits and mission: kept in the page's address, and put up in a window with its QR
//! code, to be sent or pointed at.

mod code;

use egui::text::{CCursor, CCursorRange};
use egui::{Align2, Context, Label, RichText, TextEdit, Ui, Vec2, WidgetInfo};

use super::command::{Command, FileCommand, LinkText, ShellCommand};
use super::theme::Palette;
use super::widgets::spoken::read_aloud;
use super::widgets::standing::Standing;
use super::widgets::window;
use crate::base::language::{text, tr};
use crate::study::mission;
use code::LinkCode;

/// The address is brought up to date at most this often, s: browsers refuse more.
const EVERY_S: f64 = 0.5;
/// Most that a code is wide, points.
const CODE: f32 = 260.0;
/// The same of a long link, whose squares are small.
const CODE_LONG: f32 = 400.0;
/// Links above this length are long, characters.
const LONG: usize = 600;
/// Letters of the link that are shown in the command line.
const LINK_BEGIN: usize = 24;
/// Names of the window.
const TITLES: [&str; 2] = [text!("Link to this state"), text!("Link to this mission")];

/// What the page's address holds.
#[derive(Clone, Copy, Debug, Default)]
pub struct Address {
    /// Number of changes that it was written with.
    changes: u64,
    /// When, s; none before the first time.
    at_s: Option<f64>,
}

/// Whether the address is to be written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Due {
    /// It is as it should be.
    Current,
    /// Now.
    Now,
    /// After this time, s.
    In(f64),
}

impl Address {
    /// What is due at the time `now_s`, where there were so many changes; what is due now counts as done.
    pub fn due(&mut self, changes: u64, now_s: f64) -> Due {
        if self.changes == changes {
            return Due::Current;
        }
        // A clock that was set back does not hold it up.
        let since_s = self.at_s.map_or(EVERY_S, |at_s| (now_s - at_s).abs());
        if since_s < EVERY_S {
            return Due::In(EVERY_S - since_s);
        }
        *self = Self { changes, at_s: Some(now_s) };
        Due::Now
    }

    /// Whether it holds the last of so many changes.
    #[must_use]
    pub fn is_current(&self, changes: u64) -> bool {
        self.changes == changes
    }
}

/// Changes made so far, and whether the run is worked out to its end.
pub type RunStand = (u64, bool);

/// The run that is shown, as a link to it would tell it.
pub struct RunTold {
    /// The part of its link after `#`.
    pub fragment: String,
    /// Its digest, once it is worked out to its end.
    pub digest: Option<String>,
}

/// Whether the link is that of the run that is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum LinkedRun {
    /// It never was: it was made of something else.
    Other,
    /// It is.
    Shown,
    /// It was, before the run was changed.
    Before,
}

/// A link that is put up. Link, command line and digest are of one and the same run, however the one that is shown is
/// changed meanwhile.
pub struct LinkWindow {
    link: String,
    /// What was copied last, or was to be.
    text: LinkText,
    /// Whether that is in the clipboard.
    copied: bool,
    /// The code, with the link that it was made of.
    code: Option<(String, Result<LinkCode, String>)>,
    /// The address of the page as it is typed.
    page: String,
    run: LinkedRun,
    /// What that was found at.
    stand: Option<RunStand>,
    /// The digest of the link's run: it goes over all of the recording.
    digest: Option<String>,
}

impl LinkWindow {
    /// Puts a link up: an address, or its part from `#` on where no page is known.
    #[must_use]
    pub fn new(link: String, copied: bool) -> Self {
        let (text, run) = (LinkText::Link, LinkedRun::Other);
        let (code, page, stand, digest) = (None, String::new(), None, None);
        Self { link, text, copied, code, page, run, stand, digest }
    }

    /// The link.
    #[must_use]
    pub fn link(&self) -> &str {
        &self.link
    }

    /// A text of it was copied, or was refused by the clipboard.
    pub fn was_copied(&mut self, text: LinkText, copied: bool) {
        (self.text, self.copied) = (text, copied);
    }

    /// Holds the link against the run that is shown, where that stands otherwise than in the frame before.
    fn follow(&mut self, stand: RunStand, told: impl FnOnce() -> RunTold) {
        if self.stand == Some(stand) {
            return;
        }
        self.stand = Some(stand);
        let told = told();
        self.run = match (told.fragment == self.fragment(), self.run) {
            (true, _) => LinkedRun::Shown,
            (false, LinkedRun::Other) => LinkedRun::Other,
            (false, LinkedRun::Shown | LinkedRun::Before) => LinkedRun::Before,
        };
        if self.run == LinkedRun::Shown && told.digest.is_some() {
            self.digest = told.digest;
        }
    }

    /// Shows it, all of it selected where it is to be copied by hand, with its code, and below it how its run is
    /// repeated; the run that is shown is `told` where it stands otherwise than before. `false` when it is to be
    /// closed.
    #[must_use]
    pub fn show(
        &mut self,
        ctx: &Context,
        stand: RunStand,
        told: impl FnOnce() -> RunTold,
        commands: &mut Vec<Command>,
    ) -> bool {
        self.follow(stand, told);
        let mut open = true;
        let title = TITLES[usize::from(self.is_of_mission())];
        // The same window in every language.
        let window = egui::Window::new(tr(title))
            .id(egui::Id::unique(title))
            .collapsible(false)
            .resizable(false)
            .anchor(Align2::CENTER_CENTER, Vec2::ZERO);
        let screen = ctx.content_rect();
        let width = 460.0_f32.min(screen.width() - 40.0);
        window::closable(ctx, title, window, Some(width), &mut open, |ui| {
            // Below the title; on a low screen it is scrolled.
            let height = (screen.height() - 90.0).max(120.0);
            let scrolled = egui::ScrollArea::vertical().max_height(height);
            scrolled.min_scrolled_height(height).show(ui, |ui| {
                self.body(ui, commands);
            });
        });
        open
    }

    fn body(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        ui.label(match (self.text, self.copied, self.has_page()) {
            (LinkText::Link, true, true) => tr("The link is in the clipboard."),
            (LinkText::Link, true, false) => {
                tr("The link's part from # on is in the clipboard: append it to the address of SteadyCut's web page.")
            }
            (LinkText::Link, false, _) => {
                tr("There is no clipboard here. Copy the link by hand (Ctrl+C, or a long press):")
            }
            (LinkText::CommandLine, true, _) => tr("The command line is in the clipboard."),
            (LinkText::CommandLine, false, _) => {
                tr("There is no clipboard here. Copy the command line by hand (Ctrl+C, or a long press):")
            }
        });
        let (shown, name) = match self.text {
            LinkText::Link => (self.link.clone(), text!("Link")),
            LinkText::CommandLine => (self.command_line(), text!("Command line")),
        };
        egui::ScrollArea::vertical()
            .id_salt(name)
            .max_height(72.0)
            .show(ui, |ui| field(ui, &shown, name, !self.copied));
        self.changed_since(ui, commands);
        if !self.has_page() {
            self.ask_for_page(ui, commands);
        } else {
            self.code(ui, commands);
        }
        if !self.is_of_mission() {
            self.repeated(ui, commands);
        }
    }

    /// Says it where the run that is shown is not the link's any more.
    fn changed_since(&self, ui: &mut Ui, commands: &mut Vec<Command>) {
        if self.run != LinkedRun::Before {
            return;
        }
        ui.horizontal_wrapped(|ui| {
            let text = tr("The cut has changed since: all this is of the cut as it was.");
            read_aloud(&Standing::Watch.label(ui, text, |text| text));
            if ui.button(tr("Take a new link")).clicked() {
                commands.push(Command::File(FileCommand::CopyLink));
            }
        });
    }

    /// How the run is repeated elsewhere, and how to see that it is the same.
    fn repeated(&self, ui: &mut Ui, commands: &mut Vec<Command>) {
        let weak = Palette::at(ui).weak;
        let said = |ui: &mut Ui, text: &str| ui.label(RichText::new(text).small().color(weak));
        // Whole, in the next line where this one has no room.
        let code = |ui: &mut Ui, text: &str| {
            ui.add(Label::new(RichText::new(text).small().monospace()).extend())
        };
        ui.separator();
        ui.horizontal_wrapped(|ui| {
            said(ui, tr("Repeats the run on the command line:"));
            // Its beginning: the button below copies it whole.
            let begin: String = self.link.chars().take(LINK_BEGIN).collect();
            let cut_off = if begin.len() < self.link.len() { "\u{2026}" } else { "" };
            code(ui, &format!("steadycut run '{begin}{cut_off}'"));
        });
        match (&self.digest, self.run) {
            (Some(digest), _) => {
                ui.horizontal_wrapped(|ui| {
                    said(ui, tr("It comes to the digest"));
                    code(ui, digest);
                });
            }
            (None, LinkedRun::Shown) => {
                said(ui, tr("The digest comes here once the cut is worked out to its end."));
            }
            (None, LinkedRun::Before) => {
                said(ui, tr("It was changed before it was worked out to its end: no digest."));
            }
            (None, LinkedRun::Other) => {}
        }
        let (button, text, wanted) = match self.text {
            LinkText::Link => {
                (tr("Copy the command line"), self.command_line(), LinkText::CommandLine)
            }
            LinkText::CommandLine => (tr("Copy the link"), self.link.clone(), LinkText::Link),
        };
        if ui.button(button).clicked() {
            commands.push(Command::File(FileCommand::CopyText { what: wanted, text }));
        }
    }

    /// The command line that repeats the run, for the shells that know quotes.
    fn command_line(&self) -> String {
        format!("steadycut run '{}'", self.link.replace('\'', "%27"))
    }

    /// The part after `#`.
    fn fragment(&self) -> &str {
        self.link.split_once('#').map_or("", |(_, fragment)| fragment)
    }

    /// Whether it opens a mission, which is no run to be repeated.
    fn is_of_mission(&self) -> bool {
        self.fragment().split('&').any(of_mission)
    }

    fn has_page(&self) -> bool {
        !self.link.starts_with('#')
    }

    /// Without the page's address there is nothing for a phone to open.
    fn ask_for_page(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        let label = ui.label(tr("For a QR code: the address of a page with SteadyCut on it"));
        let edit = TextEdit::singleline(&mut self.page)
            .hint_text("https://\u{2026}")
            .char_limit(500)
            .desired_width(f32::INFINITY);
        let response = ui.add(edit).labelled_by(label.id);
        let page = self.page.trim();
        let is_one = page_of(page).is_some();
        if !page.is_empty() && !is_one {
            ui.label(tr("Allowed is an address that begins with https:// or http://, without #."));
        }
        let entered =
            response.lost_focus() && ui.input(|input| input.key_pressed(egui::Key::Enter));
        let take = ui.add_enabled(is_one, egui::Button::new(tr("Make the code"))).clicked();
        if let Some(page) = page_of(page).filter(|_| take || entered) {
            self.link = format!("{page}{}", self.link);
            commands.push(Command::Shell(ShellCommand::PageIs(page)));
        }
    }

    fn code(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        if self.code.as_ref().is_none_or(|(of, _)| *of != self.link) {
            self.code = Some((self.link.clone(), LinkCode::of(&self.link)));
        }
        match &self.code {
            Some((link, Ok(code))) => {
                let most = if link.len() > LONG { CODE_LONG } else { CODE };
                ui.add_space(4.0);
                ui.vertical_centered(|ui| code.show(ui, most.min(ui.available_width())));
                ui.add_space(4.0);
                ui.horizontal_wrapped(|ui| {
                    if ui.button(tr("Save as SVG")).clicked() {
                        let name = "steadycut-link.svg".to_owned();
                        let text = code.svg();
                        commands.push(Command::File(FileCommand::SaveText { name, text }));
                    }
                    if ui.button(tr("Save as PNG")).clicked() {
                        let name = "steadycut-link.png".to_owned();
                        let bytes = code.png();
                        commands.push(Command::File(FileCommand::SaveBytes { name, bytes }));
                    }
                });
            }
            Some((_, Err(too_long))) => {
                ui.label(too_long);
            }
            None => {}
        }
    }
}

/// Whether a part of a link is a mission.
fn of_mission(part: &str) -> bool {
    [mission::SHIPPED, mission::PACKED].iter().any(|start| part.starts_with(start))
}

/// An address of a page as links want it, if it is one.
#[must_use]
pub fn page_of(typed: &str) -> Option<String> {
    let rest = typed.strip_prefix("https://").or_else(|| typed.strip_prefix("http://"))?;
    let fits = !rest.is_empty() && !rest.contains(|c: char| c == '#' || c.is_whitespace());
    fits.then(|| typed.to_owned())
}

/// A text to copy, selected when it appears where that is done by hand.
fn field(ui: &mut Ui, mut shown: &str, name: &str, by_hand: bool) {
    let id = egui::Id::unique(("text to copy", name, by_hand));
    let edit = TextEdit::multiline(&mut shown).id(id).desired_rows(2).desired_width(f32::INFINITY);
    let mut output = edit.show(ui);
    let text = shown.to_owned();
    output.response.widget_info(|| WidgetInfo::text_edit(true, "", &text, tr(name)));
    let frame = ui.ctx().cumulative_frame_nr();
    let seen = ui.data_mut(|data| {
        let seen = data.get_temp::<u64>(id);
        data.insert_temp(id, frame);
        seen
    });
    if by_hand && seen.is_none_or(|seen| seen + 1 < frame) {
        output.response.request_focus();
        let all = CCursorRange::two(CCursor::new(0), CCursor::new(shown.chars().count()));
        output.state.cursor.set_char_range(Some(all));
        output.state.store(ui.ctx(), id);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_change_is_written_half_a_second_after_the_one_before_at_the_latest() {
        let mut address = Address::default();
        assert_eq!(address.due(0, 10.0), Due::Current);
        assert_eq!(address.due(1, 10.0), Due::Now);
        // A burst of changes, and no further frame until it is due.
        assert_eq!(address.due(2, 10.125), Due::In(0.375));
        assert_eq!(address.due(5, 10.25), Due::In(0.25));
        assert!(!address.is_current(5));
        assert_eq!(address.due(5, 10.5), Due::Now);
        assert!(address.is_current(5));
        assert_eq!(address.due(5, 11.0), Due::Current);
        // Slow frames change nothing.
        assert_eq!(address.due(6, 90.0), Due::Now);
    }

    #[test]
    fn link_and_digest_stay_those_of_one_run() {
        let told = |fragment: &str, digest: Option<&str>| RunTold {
            fragment: fragment.to_owned(),
            digest: digest.map(str::to_owned),
        };
        let mut window = LinkWindow::new("https://a.org/#v=1&a=1".to_owned(), true);
        window.follow((3, false), || told("v=1&a=1", None));
        assert_eq!((window.run, window.digest.as_deref()), (LinkedRun::Shown, None));
        window.follow((3, false), || unreachable!("it stands as it stood"));
        window.follow((3, true), || told("v=1&a=1", Some("one")));
        assert_eq!((window.run, window.digest.as_deref()), (LinkedRun::Shown, Some("one")));
        window.follow((4, true), || told("v=1&a=2", Some("two")));
        assert_eq!((window.run, window.digest.as_deref()), (LinkedRun::Before, Some("one")));
        // Taken back, and not worked out again yet.
        window.follow((5, false), || told("v=1&a=1", None));
        assert_eq!((window.run, window.digest.as_deref()), (LinkedRun::Shown, Some("one")));
        let mut other = LinkWindow::new("#mission=a".to_owned(), true);
        other.follow((5, true), || told("v=1", Some("three")));
        assert_eq!((other.run, other.digest), (LinkedRun::Other, None));
    }

    #[test]
    fn a_command_line_quotes_its_link() {
        let window = LinkWindow::new("https://a.org/#v=1&name=it's".to_owned(), true);
        assert_eq!(window.command_line(), "steadycut run 'https://a.org/#v=1&name=it%27s'");
    }

    #[test]
    fn an_address_of_a_page_is_told_from_other_texts() {
        for page in ["https://a.org/", "http://localhost:8080/x?y=1"] {
            assert_eq!(page_of(page).as_deref(), Some(page));
        }
        for other in ["", "https://", "a.org", "https://a.org/#v=1", "https://a b", "ftp://a"] {
            assert_eq!(page_of(other), None, "{other}");
        }
    }
}
