//! The line that follows the cut: what has happened where the playhead stands, and what lasts there; and
//! the events of the whole run, each a way to its moment.

use egui::scroll_area::ScrollBarVisibility;
use egui::{RichText, Role, ScrollArea, TextWrapMode, Ui, WidgetInfo, vec2};

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
    let area = area.auto_shrink([false, true]);
    area.show(ui, |ui| {
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
                if button.on_hover_text(&event.sentence).clicked() {
                    commands.push(Command::Playback(PlaybackCommand::SeekTo(event.from_s)));
                }
            }
        });
    });
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
