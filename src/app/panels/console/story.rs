//! The line that follows the cut: what has happened where the playhead stands, and what lasts there; and
//! the events of the whole run, each a way to its moment.

use egui::scroll_area::ScrollBarVisibility;
use egui::{
    Rect, RichText, Role, ScrollArea, Shape, Stroke, TextWrapMode, Ui, WidgetInfo, pos2, vec2,
};

use crate::app::command::{Command, PlaybackCommand, ShellCommand};
use crate::app::format;
use crate::app::panels::View;
use crate::app::panels::machine::STABILITY;
use crate::app::theme::Palette;
use crate::app::widgets::standing::Standing;
use crate::run::story::{EventKind, StoryEvent};

/// Lines of the sentence about a change, and of that about what lasts; more than that is read by
/// hovering.
const LINES: [usize; 2] = [2, 1];
/// The same in a narrow window.
const LINES_NARROW: [usize; 2] = [5, 3];
/// Most events with a button each.
const MOST: usize = 200;

/// The sentences and the events.
pub fn show(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let story = view.session.story();
    // The playhead stands on a row; events begin on rows.
    let now_s = view.session.row().time_s + 1e-9;
    let change = story.change_at(now_s);
    let lasting = story.lasting_at(now_s);
    let lines = if view.narrow { LINES_NARROW } else { LINES };
    sentence(ui, change, lines[0], Standing::Plain);
    sentence(ui, lasting, lines[1], lasting.map_or(Standing::Plain, standing));
    // Without a bar, which would come with the first event that has no room, and move the plots.
    let hidden = ScrollBarVisibility::AlwaysHidden;
    let area = ScrollArea::horizontal().id_salt("events").scroll_bar_visibility(hidden);
    let mut area = area.auto_shrink([false, true]);
    let id = ui.scope_id().with("current event");
    // Wanted in the frame before.
    if let Some(offset) = ui.data_mut(|data| data.remove_temp::<f32>(id)) {
        area = area.horizontal_scroll_offset(offset);
    }
    let mut current = None;
    let output = area.show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            if story.events.iter().any(|event| event.id == EventKind::Chatter) {
                let help = "The depths and speeds at which this machine chatters, and the switch of its sound";
                let button = ui.button(RichText::new("Stability and sound").small());
                if button.on_hover_text(help).clicked() {
                    let part = ShellCommand::ShowPart("machine", STABILITY);
                    commands.push(Command::Shell(part));
                }
            }
            for event in story.events.iter().take(MOST) {
                let text = format!("{} {}", format::time(event.from_s), event.id.label());
                let here = [change, lasting].into_iter().flatten().any(|now| now == event);
                let button = ui.selectable_label(here, RichText::new(&text).small());
                button.widget_info(|| WidgetInfo::selected(Role::Button, true, here, &text));
                if here {
                    current = Some((event.from_s, button.rect.x_range()));
                }
                if button.on_hover_text(&event.sentence).clicked() {
                    commands.push(Command::Playback(PlaybackCommand::SeekTo(event.from_s)));
                }
            }
        });
    });
    let offset = output.state.clamped_offset().x;
    let most = (output.content_size.x - output.inner_rect.width()).max(0.0);
    // The area has the height that is left below it.
    let row = output.inner_rect.with_max_y(output.inner_rect.top() + output.content_size.y);
    more(ui, row, [offset > 1.0, offset < most - 1.0]);
    // Another event than before is brought into sight; a hand may scroll away from it.
    let now = current.map(|(from_s, _)| from_s);
    if ui.data(|data| data.get_temp(id)) != Some(now) {
        ui.data_mut(|data| data.insert_temp(id, now));
        if let Some((_, place)) = current {
            let middle = place.center() - output.inner_rect.center().x;
            let wanted = (offset + middle).clamp(0.0, most);
            ui.data_mut(|data| data.insert_temp(id, wanted));
            ui.ctx().request_repaint();
        }
    }
}

/// Signs at the ends of a row that goes on beyond them, at the left and at the right.
fn more(ui: &Ui, rect: Rect, beyond: [bool; 2]) {
    const WIDTH: f32 = 16.0;
    let palette = Palette::at(ui);
    let ends = [(rect.left(), 1.0), (rect.right(), -1.0)];
    for ((edge, inwards), _) in ends.into_iter().zip(beyond).filter(|(_, beyond)| *beyond) {
        let place = |x: f32, y: f32| pos2(edge + inwards * x, rect.center().y + y);
        let ground =
            Rect::from_two_pos(place(0.0, -0.5 * rect.height()), place(WIDTH, 0.5 * rect.height()));
        ui.painter().rect_filled(ground, 0.0, ui.visuals().panel_fill);
        let tip = vec![place(4.0, 0.0), place(11.0, -5.0), place(11.0, 5.0)];
        ui.painter().add(Shape::convex_polygon(tip, palette.text, Stroke::NONE));
    }
}

fn standing(event: &StoryEvent) -> Standing {
    match event.id {
        EventKind::LimitCycle | EventKind::Chatter => Standing::Bad,
        EventKind::Saturation | EventKind::OutsideModel => Standing::Watch,
        EventKind::Start
        | EventKind::Contact
        | EventKind::Air
        | EventKind::DepthStep
        | EventKind::TargetChange
        | EventKind::SettingChange
        | EventKind::DeadTime
        | EventKind::Wear
        | EventKind::End => Standing::Plain,
    }
}

/// A sentence in a room that does not change with it: what stands below must not move.
fn sentence(ui: &mut Ui, event: Option<&StoryEvent>, lines: usize, standing: Standing) {
    let height = ui.text_style_height(&egui::TextStyle::Small);
    let size = vec2(ui.available_width(), height * lines as f32);
    let text = event.map_or("", |event| event.sentence.as_str());
    let color = standing.color(Palette::at(ui));
    ui.allocate_ui(size, |ui| {
        ui.set_min_size(size);
        let font = egui::TextStyle::Small.resolve(ui.style());
        let mut job = egui::text::LayoutJob::simple(text.to_owned(), font, color, size.x);
        job.wrap.max_rows = lines;
        let label = standing.lead(ui, job, TextWrapMode::Wrap);
        label.widget_info(|| WidgetInfo::labeled(Role::Label, true, text));
        if let Some(event) = event {
            label.on_hover_text(&event.sentence);
        }
    });
}
