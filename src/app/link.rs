//! The link that holds scenario and edits: kept in the page's address, and put up for copying by hand where
//! the clipboard is not to be had.

use egui::text::{CCursor, CCursorRange};
use egui::{Align2, Context, TextEdit, Ui, Vec2};

use super::widgets::window;

/// The address is brought up to date at most this often, s: browsers refuse more.
const EVERY_S: f64 = 0.5;

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

/// Puts a link up, all of it selected, and below it how the run is `repeated`; gives `false` when it is to be
/// closed.
#[must_use]
pub fn show(ctx: &Context, link: &str, repeated: &str) -> bool {
    let mut open = true;
    let title = "Link to this state";
    let window = egui::Window::new(title)
        .collapsible(false)
        .resizable(false)
        .anchor(Align2::CENTER_CENTER, Vec2::ZERO);
    let width = 460.0_f32.min(ctx.content_rect().width() - 40.0);
    window::closable(ctx, title, window, Some(width), &mut open, |ui| {
        ui.label("There is no clipboard here. Copy the link by hand (Ctrl+C, or a long press):");
        egui::ScrollArea::vertical().max_height(160.0).show(ui, |ui| field(ui, link));
        ui.label(repeated);
    });
    open
}

/// The link, selected when it appears.
fn field(ui: &mut Ui, mut link: &str) {
    let id = egui::Id::unique("link to copy");
    let edit = TextEdit::multiline(&mut link).id(id).desired_rows(3).desired_width(f32::INFINITY);
    let mut output = edit.show(ui);
    let frame = ui.ctx().cumulative_frame_nr();
    let seen = ui.data_mut(|data| {
        let seen = data.get_temp::<u64>(id);
        data.insert_temp(id, frame);
        seen
    });
    if seen.is_none_or(|seen| seen + 1 < frame) {
        output.response.request_focus();
        let all = CCursorRange::two(CCursor::new(0), CCursor::new(link.chars().count()));
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
}
