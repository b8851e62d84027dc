//! What hands the answer in, at the foot of the task, and what it came to above that: neither is looked for, and
//! nothing moves under the pointer that has pressed.

use egui::{Button, Rect, RichText, ScrollArea, TextEdit, TextStyle, Ui, vec2};

use super::lesson::Lesson;
use super::{note_place, verdict};
use crate::app::command::{Command, FileCommand, HandCommand, PlaybackCommand, SessionCommand};
use crate::app::panels::View;
use crate::app::session::hand::is_for_the_hand;
use crate::app::theme::Palette;
use crate::app::widgets::scaffold::Foot;
use crate::app::widgets::standing::Standing;
use crate::base::language::tr;
use crate::study::mission::{Mission, shipped};

/// Most of the height that what an answer came to takes, and of that of a phone: what is to be changed stays in sight.
const MOST: f32 = 0.6;
/// See [`MOST`].
const MOST_NARROW: f32 = 0.45;

/// What hands the answer in.
pub fn buttons(ui: &mut Ui, lesson: &mut Lesson, view: &View<'_>, commands: &mut Vec<Command>) {
    ui.separator();
    ui.horizontal_wrapped(|ui| {
        // A hand begins anew; what it has set last is not for the whole cut.
        let by_hand = is_for_the_hand(&lesson.mission.controls.open);
        let (help, command) = match by_hand {
            true => (tr("From the start, by hand again"), Command::hand(HandCommand::CutByHand)),
            false => (
                tr("From the start, with what is set now"),
                Command::Session(SessionCommand::CutAgain),
            ),
        };
        if ui.button(tr("Cut from the start")).on_hover_text(help).clicked() {
            commands.push(command);
        }
        let help = tr("Marks the whole cut as it is set now, and your predictions");
        let check = ui.add_enabled(!lesson.is_marked_now(), Button::new(tr("Check my answer")));
        note_place(ui, "check", &check);
        if check.on_hover_text(help).clicked() {
            // What is marked is the whole cut: so it is seen to its end as well.
            commands.push(Command::Playback(PlaybackCommand::SeekToEnd));
            // A number that was being typed is set in this frame.
            lesson.hands_in = true;
        }
    });
    standing(ui, lesson, view);
}

/// What the check would do now, in a room that has room for all that it may be: nothing moves as the cut ends.
fn standing(ui: &mut Ui, lesson: &Lesson, view: &View<'_>) {
    let runs = |percent: f64| {
        tr!(
            "The cut still runs ({percent:.0} %): the check runs it to its end first.",
            percent = percent
        )
    };
    let over = || tr("The cut is over: the check marks all of it.").to_owned();
    let marked = || tr("The cut is being marked").to_owned();
    let words = match (lesson.is_marked_now(), seen_percent(view)) {
        (true, _) => marked(),
        (false, Some(percent)) => runs(percent),
        (false, None) => over(),
    };
    let weak = Palette::at(ui).weak;
    let font = TextStyle::Small.resolve(ui.style());
    let width = ui.available_width();
    let height = [runs(99.0), over(), marked()]
        .map(|text| ui.painter().layout(text, font.clone(), weak, width).size().y)
        .into_iter()
        .fold(0.0, f32::max);
    ui.allocate_ui(vec2(width, height), |ui| {
        ui.set_min_height(height);
        ui.label(RichText::new(words).small().color(weak));
    });
}

/// How much of the cut the playhead has shown, in whole percent, while that is not all.
fn seen_percent(view: &View<'_>) -> Option<f64> {
    let session = view.session;
    let share = session.playback().playhead_s / session.length_s();
    session.finished().is_none().then(|| (100.0 * share).floor().clamp(0.0, 99.0))
}

/// What the answer came to, above its buttons; gives the mission that is to begin after it.
pub fn outcome(
    ui: &mut Ui,
    lesson: &mut Lesson,
    view: &View<'_>,
    name: &mut String,
    commands: &mut Vec<Command>,
) -> Option<Mission> {
    let most = if view.narrow { MOST_NARROW } else { MOST };
    let mut area = ScrollArea::vertical()
        .id_salt("what the answer came to")
        .max_height(most * ui.available_height());
    if std::mem::take(&mut lesson.is_news) {
        area = area.vertical_scroll_offset(0.0);
    }
    let verdict = lesson.verdict.clone();
    let told = verdict.as_deref().and_then(Option::as_ref);
    area.show(ui, |ui| {
        if let Some(because) = &lesson.refused {
            Standing::Bad.label(ui, because, |text| text);
        }
        let Some(told) = told else { return };
        let (stale, tries) = (lesson.is_stale(view.session), lesson.tries());
        if verdict::show(ui, &lesson.mission, told, stale, tries) {
            lesson.close_verdict();
        }
        save(ui, lesson, name, commands);
    });
    // Below what is scrolled: it is in sight however much there is to read.
    next_mission(ui, lesson, told.is_some_and(|told| told.passed))
}

/// Whether there is something to show of an answer.
#[must_use]
pub fn has_outcome(lesson: &Lesson) -> bool {
    lesson.refused.is_some() || lesson.verdict.as_deref().is_some_and(Option::is_some)
}

/// The foot with the buttons, and that with what came of them; both are drawn after what stands above them.
pub struct Feet {
    buttons: Foot,
    outcome: Option<Foot>,
}

impl Feet {
    /// At the foot of `left`, of which they take their room: none while nothing can be handed in.
    pub fn of(ui: &Ui, lesson: &Lesson, left: &mut Rect) -> Option<Self> {
        if !lesson.is_tried() {
            return None;
        }
        let buttons = Foot::of(ui, left, "answer of a mission");
        let outcome = has_outcome(lesson).then(|| Foot::of(ui, left, "outcome of a mission"));
        Some(Self { buttons, outcome })
    }

    /// Draws them; gives the mission that is to begin next.
    pub fn show(
        self,
        ui: &mut Ui,
        lesson: &mut Lesson,
        view: &View<'_>,
        name: &mut String,
        commands: &mut Vec<Command>,
    ) -> Option<Mission> {
        let Self { buttons: foot, outcome: above } = self;
        let next =
            above.and_then(|foot| foot.show(ui, |ui| outcome(ui, lesson, view, name, commands)));
        foot.show(ui, |ui| buttons(ui, lesson, view, commands));
        next
    }
}

/// Leads on to the next mission once this one is passed; gives it when it is to begin.
fn next_mission(ui: &mut Ui, lesson: &Lesson, passed: bool) -> Option<Mission> {
    if !passed {
        return None;
    }
    let Some(next) = shipped::after(&lesson.mission.id) else {
        if shipped::is_last(&lesson.mission.id) {
            ui.label(tr("This was the last mission. Leave leads to the list of all."));
        }
        return None;
    };
    let mission = shipped::load(next.id).ok()?;
    let words = tr!("Next mission: {title}", title = tr(&mission.title));
    let button = ui.add(Button::new(words).wrap());
    note_place(ui, "next mission", &button);
    button.clicked().then_some(mission)
}

/// The verdict as a file, with a name if one is typed.
fn save(ui: &mut Ui, lesson: &Lesson, name: &mut String, commands: &mut Vec<Command>) {
    ui.horizontal_wrapped(|ui| {
        let label = ui.label(tr("Your name"));
        let field = TextEdit::singleline(name).hint_text(tr("if you like"));
        ui.add(field.char_limit(80).desired_width(140.0)).labelled_by(label.id);
        let help =
            tr("A file with your answer and what it came to; steadycut mission check verifies it");
        if ui.button(tr("Save result")).on_hover_text(help).clicked()
            && let Some(result) = lesson.result(name)
        {
            let name = format!("{}-result.json", lesson.mission.id);
            let text = result.write();
            commands.push(Command::File(FileCommand::SaveText { name, text }));
        }
    });
}
