//! The line that follows the cut: what has happened where the playhead stands, and what lasts there; and
//! the events of the whole run, each a way to its moment. Of what lies ahead no more than that is told.

use egui::text::LayoutJob;
use egui::{Label, RichText, Role, TextStyle, TextWrapMode, Ui, WidgetInfo, vec2};

use crate::app::about;
use crate::app::command::{Command, PlaybackCommand, ShellCommand};
use crate::app::format;
use crate::app::panels::View;
use crate::app::panels::machine::STABILITY;
use crate::app::theme::{self, Palette};
use crate::app::widgets::icon::{self, Icon};
use crate::app::widgets::spoken::read_aloud;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::strip::strip;
use crate::base::language::{self, Language, text, tr};
use crate::run::story::{EventKind, StoryEvent};

/// Lines that the sentence about a change has at least, and that about what lasts: as many as the longest one
/// of the run takes, since what stands below must not move from one to the next.
const LINES: [usize; 2] = [2, 1];
/// About as long as such sentences get once the cut is disturbed: the first disturbance moves nothing.
const LONG: [&str; 2] = [
    text!(
        "A burst of chatter begins here: 3 times over 5.0 mm, imposed: safe constant feed leaves the tolerance (Ra \
         0.45 µm to 0.88 µm), the controller lowers the feed by 16.1 % (319 to 299 mm/min), raises the speed by \
         14.6 % and leaves the tolerance (Ra 0.77 µm to 1.23 µm). The remaining error is 51 % above the target Ra, \
         about which Ra still moves by ±13.2 %; the law has no integral."
    ),
    text!(
        "The spindle speed command stands at its upper limit, 2500 1/min (150 % override), 60 % of this time: \
         meanwhile Ra is 12.3 % above its target, outside the tolerance."
    ),
];
/// Most lines of a sentence; more than that is read by hovering.
const MOST_LINES: usize = 10;
/// What is told of an event that is not cut yet.
const AHEAD: &str = text!("Ahead of the playhead, not cut yet: a click goes there");
/// What a button says of more than one event.
const SEVERAL: &str = text!("Each click goes to the next of them.");
/// Most buttons.
const MOST: usize = 200;

/// What lasts and comes again and again, as a command at its limit, shares a button with its like that follow: it
/// would hide what else happens. Changes have a button each.
fn alike<'a>(events: &'a [&'a StoryEvent]) -> impl Iterator<Item = &'a [&'a StoryEvent]> {
    events.chunk_by(|a, b| a.id == b.id && !a.id.is_change())
}

/// Says what the program is, until it is used or that is closed.
pub fn introduction(ui: &mut Ui, view: &View<'_>, closed: &mut bool) {
    if *closed || view.session.changes() > 0 {
        return;
    }
    let palette = Palette::at(ui);
    theme::card(palette).show(ui, |ui| {
        ui.horizontal_top(|ui| {
            let spacing = ui.spacing();
            let button = spacing.interact_size.y.max(26.0) + 4.0 + spacing.item_spacing.x;
            let width = ui.available_width() - button;
            ui.allocate_ui(vec2(width, 0.0), |ui| {
                ui.set_width(width);
                ui.add(Label::new(tr(about::WHAT_IT_IS)).wrap());
            });
            let help = tr("Remove this line; `?` shows it again");
            let name = tr("Close the introduction");
            *closed |= icon::button(ui, Icon::Close, name, help, true).clicked();
        });
    });
    ui.add_space(2.0);
}

/// The sentences.
pub fn sentences(ui: &mut Ui, view: &View<'_>) {
    let story = view.session.story();
    let now_s = now_s(view);
    let change = story.change_at(now_s);
    let lasting = story.lasting_at(now_s);
    let lines = lines(ui, view);
    sentence(ui, change, lines[0], Standing::Plain);
    sentence(ui, lasting, lines[1], lasting.map_or(Standing::Plain, standing));
}

/// The playhead, s: it stands on a row, and events begin on rows.
fn now_s(view: &View<'_>) -> f64 {
    view.session.row().time_s + 1e-9
}

/// The row of events, each a way to its moment.
pub fn events(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let story = view.session.story();
    let now_s = now_s(view);
    let (change, lasting) = (story.change_at(now_s), story.lasting_at(now_s));
    let id = ui.scope_id().with("current event");
    // Wanted in the frame before.
    let wanted = ui.data_mut(|data| data.remove_temp::<f32>(id));
    let mut current = None;
    let place = strip(ui, "events", wanted, 4.0, |ui| {
        if story.events.iter().any(|event| event.id == EventKind::Chatter) {
            let help = tr(
                "The depths and speeds at which this machine chatters, and the switch of its sound",
            );
            let button = ui.button(RichText::new(tr("Stability and sound")).small());
            if button.on_hover_text(help).clicked() {
                let part = ShellCommand::ShowPart("machine", STABILITY);
                commands.push(Command::Shell(part));
            }
        }
        let until_s = view.session.told_until_s() + 1e-9;
        let ahead = view.session.whole_story().events.iter();
        let ahead = ahead.filter(|event| event.from_s > until_s);
        let weak = Palette::at(ui).weak;
        let told: Vec<&StoryEvent> = story.events.iter().collect();
        let ahead: Vec<&StoryEvent> = ahead.collect();
        let groups = alike(&told).map(|group| (group, false));
        let groups = groups.chain(alike(&ahead).map(|group| (group, true)));
        for (group, is_ahead) in groups.take(MOST) {
            let first = group[0];
            let mut text = format!("{} {}", format::time(first.from_s), tr(first.id.label()));
            if group.len() > 1 {
                text += &format!(" \u{d7}{}", group.len());
            }
            let here = group.iter().find(|event| [change, lasting].contains(&Some(**event)));
            let shown = RichText::new(&text).small();
            let shown = if is_ahead { shown.color(weak) } else { shown };
            let button = ui.selectable_label(here.is_some(), shown);
            button.widget_info(|| WidgetInfo::selected(Role::Button, true, here.is_some(), &text));
            if here.is_some() {
                current = Some((first.from_s, button.rect.x_range()));
            }
            let told = if is_ahead { tr(AHEAD) } else { here.unwrap_or(&first).sentence.as_str() };
            let mut help = format::typeset(told);
            if group.len() > 1 {
                help += &format!("\n{}", tr(SEVERAL));
            }
            if button.on_hover_text(help).clicked() {
                let next = group.iter().find(|event| event.from_s > now_s).unwrap_or(&first);
                commands.push(Command::Playback(PlaybackCommand::SeekTo(next.from_s)));
            }
        }
    });
    // Another event than before is brought into sight; a hand may scroll away from it.
    let now = current.map(|(from_s, _)| from_s);
    if ui.data(|data| data.get_temp(id)) != Some(now) {
        ui.data_mut(|data| data.insert_temp(id, now));
        if let Some((_, button)) = current {
            let middle = button.center() - place.seen.center();
            let wanted = (place.offset + middle).clamp(0.0, place.most);
            ui.data_mut(|data| data.insert_temp(id, wanted));
            ui.ctx().request_repaint();
        }
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
        | EventKind::Disturbance
        | EventKind::SettingChange
        | EventKind::DeadTime
        | EventKind::Wear
        | EventKind::End => Standing::Plain,
    }
}

fn set(ui: &Ui, text: &str, standing: Standing) -> LayoutJob {
    let font = TextStyle::Small.resolve(ui.style());
    LayoutJob::simple(
        format::typeset(text),
        font,
        standing.color(Palette::at(ui)),
        ui.available_width(),
    )
}

/// Lines of the two sentences, for the longest of each in this scenario and this width: they grow while it is
/// worked out, and once it is they are those of what is told then, however it came to that.
fn lines(ui: &Ui, view: &View<'_>) -> [usize; 2] {
    let width = ui.available_width();
    let name = &view.session.scenario().info.name;
    let id = egui::Id::unique("lines of the story");
    let before = ui.data(|data| data.get_temp::<Lines>(id));
    let language = language::chosen();
    let before = before.filter(|before| {
        before.of == *name && before.width == width && before.language == language
    });
    let settled = view.session.simulated() >= 1.0 && view.session.twin_stand().is_settled();
    let told = (view.session.stories(), settled);
    if let Some(before) = before.as_ref().filter(|before| before.told == told) {
        return before.lines;
    }
    let size = TextStyle::Small.resolve(ui.style()).size;
    let rows = |text: &str, standing: Standing| {
        let mut job = set(ui, text, standing);
        job.wrap.max_width -= standing.room(size);
        ui.painter().layout_job(job).rows.len().min(MOST_LINES)
    };
    let least = || {
        let [change, lasting] =
            [rows(tr(LONG[0]), Standing::Plain), rows(tr(LONG[1]), Standing::Watch)];
        [change.max(LINES[0]), lasting.max(LINES[1])]
    };
    let mut lines = before.filter(|_| !settled).map_or_else(least, |before| before.lines);
    for event in &view.session.whole_story().events {
        let of = &mut lines[usize::from(!event.id.is_change())];
        *of = rows(&event.sentence, standing(event)).max(*of);
    }
    ui.data_mut(|data| {
        data.insert_temp(id, Lines { of: name.clone(), width, language, told, lines })
    });
    lines
}

/// What lines were found, of which scenario, in which width and language, of how many stories, and whether nothing was
/// being worked out then.
#[derive(Clone)]
struct Lines {
    of: String,
    width: f32,
    language: Language,
    told: (u64, bool),
    lines: [usize; 2],
}

/// A sentence in a room that does not change with it: what stands below must not move.
fn sentence(ui: &mut Ui, event: Option<&StoryEvent>, lines: usize, standing: Standing) {
    // The sign minus may come from another font, whose lines are a hair higher.
    let font = TextStyle::Small.resolve(ui.style());
    let probe = format!("{}0\u{a0}%", format::MINUS);
    let probe = ui.painter().layout_no_wrap(probe, font, egui::Color32::PLACEHOLDER);
    let height = ui.text_style_height(&TextStyle::Small).max(probe.size().y);
    let size = vec2(ui.available_width(), height * lines as f32);
    let text = format::typeset(event.map_or("", |event| event.sentence.as_str()));
    ui.allocate_ui(size, |ui| {
        ui.set_min_size(size);
        let mut job = set(ui, &text, standing);
        job.wrap.max_rows = lines;
        // What is cut off comes up as a whole under the pointer; what can be read is not written over itself.
        let label = standing.lead(ui, job, TextWrapMode::Wrap);
        label.widget_info(|| WidgetInfo::labeled(Role::Label, true, &text));
        read_aloud(&label);
    });
}
