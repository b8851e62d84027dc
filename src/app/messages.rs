//! Messages: they lie over the screen, move nothing on it and go by themselves once there was time to read
//! them; all that were shown can be read again in a list.

use egui::{
    Align, Align2, Area, Context, Layout, Order, Rect, RichText, ScrollArea, Sense, Ui, vec2,
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
    /// Numbers of those that are shown, the newest last, and how long they still are, s.
    up: Vec<(u64, f64)>,
    /// Whether the pointer is over them: then they stay.
    held: bool,
}

impl Messages {
    /// Shows new messages, and removes those whose time is over; `dt_s` seconds have gone by.
    pub fn follow(&mut self, notices: &[Notice], dt_s: f64) {
        if !self.held {
            self.up.iter_mut().for_each(|(_, left_s)| *left_s -= dt_s);
        }
        for notice in notices.iter().filter(|notice| notice.number > self.taken) {
            let chars = notice.text.chars().count() as f64;
            self.up.push((notice.number, SHOWN_S + SHOWN_PER_CHAR_S * chars));
        }
        self.taken = notices.last().map_or(self.taken, |notice| notice.number.max(self.taken));
        self.up.retain(|(number, left_s)| {
            *left_s > 0.0 && notices.iter().any(|notice| notice.number == *number)
        });
        let over = self.up.len().saturating_sub(MOST);
        self.up.drain(..over);
    }

    /// Whether one is shown.
    #[must_use]
    pub fn is_up(&self, number: u64) -> bool {
        self.up.iter().any(|(up, _)| *up == number)
    }

    /// Removes a message from the screen.
    pub fn dismiss(&mut self, number: u64) {
        self.up.retain(|(up, _)| *up != number);
    }

    /// Removes all from the screen.
    pub fn dismiss_all(&mut self) {
        self.up.clear();
    }

    /// Another screen is shown: what has had its least time goes, and does not lie over what is looked for there.
    pub fn leave_screen(&mut self) {
        self.up.retain(|(_, left_s)| *left_s > LEAST_LEFT_S);
    }

    /// Removes the newest one from the screen; `false` where there is none.
    pub fn dismiss_newest(&mut self) -> bool {
        self.up.pop().is_some()
    }

    /// Draws them over what is free at the right of the transport, or where there is no room over the lower right corner
    /// of `screen`; on a phone over the bar, between its list of screens and its menu, in small letters. On the screen they
    /// would lie on the figures, or on the sentence that tells the cut.
    pub fn show(
        &mut self,
        ctx: &Context,
        screen: Rect,
        notices: &[Notice],
        commands: &mut Vec<Command>,
    ) {
        self.held = false;
        let Some(soonest_s) = self.up.iter().map(|(_, left_s)| *left_s).reduce(f64::min) else {
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
            true => (Align2::RIGHT_TOP, screen.right_top() + vec2(-EDGE - MENU, 4.0)),
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

    fn notice(number: u64, text: &str) -> Notice {
        Notice { number, text: text.to_owned() }
    }

    #[test]
    fn messages_go_by_themselves_once_there_was_time_to_read_them() {
        let mut messages = Messages::default();
        let mut all = vec![notice(1, "short"), notice(2, &"long ".repeat(20))];
        messages.follow(&all, 0.1);
        assert!(messages.is_up(1) && messages.is_up(2));
        messages.follow(&all, 6.0);
        assert!(!messages.is_up(1) && messages.is_up(2));
        // Under the pointer one stays.
        messages.held = true;
        messages.follow(&all, 60.0);
        assert!(messages.is_up(2));
        messages.held = false;
        all.extend((3..=6).map(|number| notice(number, "more")));
        messages.follow(&all, 0.1);
        let up: Vec<u64> = (1..=6).filter(|number| messages.is_up(*number)).collect();
        assert_eq!(up, [4, 5, 6]);
        assert!(messages.dismiss_newest() && !messages.is_up(6));
        messages.dismiss(4);
        messages.leave_screen();
        assert!(messages.is_up(5), "it has only just come");
        messages.follow(&all, 2.0);
        messages.leave_screen();
        assert!(!messages.is_up(5), "it was there for two seconds");
        assert!(!messages.dismiss_newest(), "what has been shown does not come again");
    }
}
