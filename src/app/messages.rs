//! Messages: they lie over the screen, move nothing on it and go by themselves once there was time to read
//! them; all that were shown can be read again in a list.

use egui::{
    Align, Align2, Area, Context, Layout, Order, Rect, RichText, ScrollArea, Sense, Ui, pos2, vec2,
};

use super::command::{Command, ShellCommand};
use super::format;
use super::session::Notice;
use super::theme::{self, Palette};
use super::timeline::FREE_FROM;
use super::widgets::icon::{self, Icon};
use super::widgets::spoken::read_aloud;
use crate::base::language::tr;

/// Time that a message is shown, s, and more for each of its letters.
const SHOWN_S: f64 = 5.0;
/// See [`SHOWN_S`].
const SHOWN_PER_CHAR_S: f64 = 0.08;
/// A message with less time left than this goes with the screen that it came up on, s (chosen): what a change of the
/// screen itself says has just come.
const LEAST_LEFT_S: f64 = 4.0;
/// Most messages over the screen, and over a narrow one; older ones are in the list.
const MOST: usize = 3;
/// See [`MOST`].
const MOST_NARROW: usize = 1;
/// Width of messages and list, points, and distance from the edges.
const WIDTH: f32 = 380.0;
/// See [`WIDTH`].
const EDGE: f32 = 10.0;
/// Width of the list of screens at the left of a phone's bar, and of the menu at its right: both stay in reach, points.
const SCREENS: f32 = 128.0;
/// See [`SCREENS`].
const MENU: f32 = 44.0;

/// Messages over the screen.
#[derive(Default)]
pub struct Messages {
    /// Number of the last message that was taken.
    taken: u64,
    /// Those that are shown, the newest last.
    up: Vec<Shown>,
    /// How many missions were begun and ended.
    missions: u64,
    /// Whether the pointer is over them: then they stay.
    held: bool,
}

/// A message over the screen.
#[derive(Clone, Copy)]
struct Shown {
    number: u64,
    /// How long it still is, s.
    left_s: f64,
    /// Whether it came while a mission was under way.
    of_mission: bool,
}

impl Messages {
    /// Shows new messages, and removes those whose time is over; `dt_s` seconds have gone by. `mission` is how many
    /// missions were begun and ended, and whether one is under way: what was said in one goes with it.
    pub fn follow(&mut self, notices: &[Notice], dt_s: f64, (missions, under_way): (u64, bool)) {
        if !self.held {
            self.up.iter_mut().for_each(|shown| shown.left_s -= dt_s);
        }
        if missions != self.missions {
            self.up.retain(|shown| !shown.of_mission);
            self.missions = missions;
        }
        for notice in notices.iter().filter(|notice| notice.number > self.taken) {
            let chars = notice.text.chars().count() as f64;
            let left_s = SHOWN_S + SHOWN_PER_CHAR_S * chars;
            self.up.push(Shown { number: notice.number, left_s, of_mission: under_way });
        }
        self.taken = notices.last().map_or(self.taken, |notice| notice.number.max(self.taken));
        self.up.retain(|shown| {
            shown.left_s > 0.0 && notices.iter().any(|notice| notice.number == shown.number)
        });
        let over = self.up.len().saturating_sub(MOST);
        self.up.drain(..over);
    }

    /// Whether one is shown.
    #[must_use]
    pub fn is_up(&self, number: u64) -> bool {
        self.up.iter().any(|shown| shown.number == number)
    }

    /// Removes a message from the screen.
    pub fn dismiss(&mut self, number: u64) {
        self.up.retain(|shown| shown.number != number);
    }

    /// Removes all from the screen.
    pub fn dismiss_all(&mut self) {
        self.up.clear();
    }

    /// Another screen is shown: what has had its least time goes, and does not lie over what is looked for there.
    pub fn leave_screen(&mut self) {
        self.up.retain(|shown| shown.left_s > LEAST_LEFT_S);
    }

    /// Removes the newest one from the screen; `false` where there is none.
    pub fn dismiss_newest(&mut self) -> bool {
        self.up.pop().is_some()
    }

    /// Draws them over what is free at the right of the transport, or where there is no room over the lower right corner
    /// of `screen`; on a phone over the bar, between its list of screens and its menu, in small letters. On the screen they
    /// would lie on the figures, or on the sentence that tells the cut. On a phone they lie `below` that height, where there
    /// is one.
    pub fn show(
        &mut self,
        ctx: &Context,
        (screen, below): (Rect, Option<f32>),
        notices: &[Notice],
        commands: &mut Vec<Command>,
    ) {
        self.held = false;
        let Some(soonest_s) = self.up.iter().map(|shown| shown.left_s).reduce(f64::min) else {
            return;
        };
        let narrow = screen.width() < theme::NARROW;
        let whole = ctx.content_rect();
        let ends = ctx.data(|data| data.get_temp::<f32>(egui::Id::unique(FREE_FROM)));
        let free = ends.is_some_and(|x| x + WIDTH + 3.0 * EDGE <= whole.right());
        let screen = if free || narrow { whole } else { screen };
        let taken = if narrow { SCREENS + MENU } else { 0.0 };
        let width = WIDTH.min(screen.width() - 2.0 * EDGE - taken);
        let (pivot, at) = match narrow {
            true => {
                let top = below.unwrap_or(screen.top());
                (Align2::RIGHT_TOP, pos2(screen.right() - EDGE - MENU, top + 4.0))
            }
            false => (Align2::RIGHT_BOTTOM, screen.right_bottom() - vec2(EDGE, EDGE)),
        };
        let shown = Area::new(egui::Id::unique("messages"))
            .order(Order::Foreground)
            .pivot(pivot)
            .fixed_pos(at)
            .constrain_to(screen)
            .show(ctx, |ui| {
                ui.set_width(width);
                let up = notices.iter().filter(|notice| self.is_up(notice.number));
                let most = if narrow { MOST_NARROW } else { MOST };
                for notice in up.clone().skip(up.count().saturating_sub(most)) {
                    let card = card(ui, notice, narrow, commands);
                    // On a phone it lies over what a finger wants: a tap anywhere on it takes it away.
                    let tapped = narrow.then(|| {
                        let id = ui.scope_id().with(("tap", notice.number));
                        ui.interact(card, id, Sense::click()).clicked()
                    });
                    if tapped == Some(true) {
                        commands.push(Command::Shell(ShellCommand::Dismiss(notice.number)));
                    }
                }
            });
        let rect = shown.response.rect;
        self.held =
            ctx.input(|input| input.pointer.hover_pos().is_some_and(|at| rect.contains(at)));
        // Time goes on while nothing else asks for a frame.
        ctx.request_repaint_after_secs(soonest_s.clamp(0.05, 0.25) as f32);
    }
}

/// One message; where it lies.
fn card(ui: &mut Ui, notice: &Notice, narrow: bool, commands: &mut Vec<Command>) -> Rect {
    let palette = Palette::at(ui);
    let frame = theme::card(palette).stroke(egui::Stroke::new(1.0, palette.warn));
    let shown = frame.shadow(ui.visuals().popup_shadow).show(ui, |ui| {
        ui.with_layout(Layout::right_to_left(Align::TOP), |ui| {
            let help = tr("Remove this message; it stays in the list of messages");
            if icon::button(ui, Icon::Close, tr("Dismiss"), help, true).clicked() {
                commands.push(Command::Shell(ShellCommand::Dismiss(notice.number)));
            }
            ui.with_layout(Layout::left_to_right(Align::TOP), |ui| {
                let text = RichText::new(format::typeset(&notice.text));
                let text = if narrow { text.small() } else { text };
                let text = ui.add(egui::Label::new(text).selectable(false).wrap());
                read_aloud(&text);
            });
        });
    });
    shown.response.rect
}

/// The button that opens the list of all messages, once there was one.
pub fn button(ui: &mut Ui, notices: &[Notice]) {
    if notices.is_empty() {
        return;
    }
    let help = tr("What was said so far");
    let response = icon::button(ui, Icon::Message, tr("Messages"), help, true);
    egui::Popup::menu(&response)
        .close_behavior(egui::PopupCloseBehavior::CloseOnClickOutside)
        .show(|ui| {
            // A menu spreads the words of a line over its width.
            ui.with_layout(Layout::top_down(Align::Min), |ui| list(ui, notices));
        });
}

/// All messages, the newest first.
fn list(ui: &mut Ui, notices: &[Notice]) {
    let palette = Palette::at(ui);
    let screen = ui.ctx().content_rect();
    ui.set_width(WIDTH.min(screen.width() - 4.0 * EDGE));
    ui.label(RichText::new(tr("Messages, the newest first")).strong());
    let spacing = ui.spacing_mut();
    spacing.scroll = theme::solid_bars();
    ScrollArea::vertical().max_height(0.6 * screen.height()).show(ui, |ui| {
        for notice in notices.iter().rev() {
            ui.separator();
            ui.add(
                egui::Label::new(RichText::new(format::typeset(&notice.text)).color(palette.text))
                    .wrap(),
            );
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    /// No mission was begun.
    const NONE: (u64, bool) = (0, false);

    fn notice(number: u64, text: &str) -> Notice {
        Notice { number, text: text.to_owned() }
    }

    #[test]
    fn messages_go_by_themselves_once_there_was_time_to_read_them() {
        let mut messages = Messages::default();
        let mut all = vec![notice(1, "short"), notice(2, &"long ".repeat(20))];
        messages.follow(&all, 0.1, NONE);
        assert!(messages.is_up(1) && messages.is_up(2));
        messages.follow(&all, 6.0, NONE);
        assert!(!messages.is_up(1) && messages.is_up(2));
        // Under the pointer one stays.
        messages.held = true;
        messages.follow(&all, 60.0, NONE);
        assert!(messages.is_up(2));
        messages.held = false;
        all.extend((3..=6).map(|number| notice(number, "more")));
        messages.follow(&all, 0.1, NONE);
        let up: Vec<u64> = (1..=6).filter(|number| messages.is_up(*number)).collect();
        assert_eq!(up, [4, 5, 6]);
        assert!(messages.dismiss_newest() && !messages.is_up(6));
        messages.dismiss(4);
        messages.leave_screen();
        assert!(messages.is_up(5), "it has only just come");
        messages.follow(&all, 2.0, NONE);
        messages.leave_screen();
        assert!(!messages.is_up(5), "it was there for two seconds");
        assert!(!messages.dismiss_newest(), "what has been shown does not come again");
    }

    #[test]
    fn what_was_said_in_a_mission_goes_with_it() {
        let mut messages = Messages::default();
        let mut all = vec![notice(1, "before")];
        messages.follow(&all, 0.1, (0, false));
        // It is begun; what was said before stays, and so does what is said of its beginning.
        all.push(notice(2, "in the mission"));
        messages.follow(&all, 0.1, (1, true));
        assert!(messages.is_up(1) && messages.is_up(2));
        all.push(notice(3, "left"));
        messages.follow(&all, 0.1, (2, false));
        assert!(messages.is_up(1) && !messages.is_up(2) && messages.is_up(3));
    }
}
