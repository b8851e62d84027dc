//! The task: story, goal, steps, what may be changed, and hints.

use egui::text::{LayoutJob, TextFormat};
use egui::{Button, Color32, RichText, TextStyle, Ui};

use super::lesson::Lesson;
use super::{catalogue, folded, note_place, paragraphs, questions, told};
use crate::app::command::{Command, SessionCommand};
use crate::app::panels::View;
use crate::app::panels::console::operator;
use crate::app::session::hand::is_for_the_hand;
use crate::app::theme::Palette;
use crate::app::widgets::setting::{Size, setting};
use crate::app::widgets::standing::Standing;
use crate::base::language::tr;
use crate::study::compare::by_hand::HAND;
use crate::study::mission::Question;
use crate::study::uses::Screen;

/// Diameter of the operator's knob in a task, points.
const KNOB: f32 = 190.0;

/// What the mission is about, and the step under way.
pub fn show(ui: &mut Ui, lesson: &mut Lesson, view: &View<'_>, commands: &mut Vec<Command>) {
    head(ui, lesson, view, commands);
    steps(ui, lesson, view, commands);
    ui.add_space(6.0);
}

fn head(ui: &mut Ui, lesson: &Lesson, view: &View<'_>, commands: &mut Vec<Command>) {
    let mission = &lesson.mission;
    ui.label(RichText::new(told(&mission.title)).strong());
    ui.horizontal_wrapped(|ui| {
        let help =
            tr("Back to all missions; the cut stays as it is, and all of it can be changed again");
        if ui.button(tr("Leave")).on_hover_text(help).clicked() {
            commands.push(Command::Session(SessionCommand::EndMission));
        }
        catalogue::link_button(ui, view, mission, commands);
    });
    // It was read in the first step: what is to be done then needs the room.
    folded(ui, tr("Story"), lesson.step == 1, |ui| paragraphs(ui, &mission.story));
    headed(ui, tr("Goal:"), ui.visuals().strong_text_color(), &told(&mission.goal));
    ui.add_space(4.0);
}

fn steps(ui: &mut Ui, lesson: &mut Lesson, view: &View<'_>, commands: &mut Vec<Command>) {
    let count = lesson.mission.steps.len();
    let Some(step) = lesson.mission.steps.get(lesson.step - 1).cloned() else { return };
    ui.separator();
    let title = tr!(
        "Step {step} of {count}: {title}",
        step = lesson.step,
        count = count,
        title = tr(&step.title)
    );
    let title = ui.label(RichText::new(title).strong());
    note_place(ui, &format!("step {}", lesson.step), &title);
    paragraphs(ui, &step.text);
    if let Some(question) = &step.predict {
        ask(ui, lesson, question, view, commands);
    }
    let say = step.predict.as_ref().filter(|_| lesson.asks() || lesson.has_draft());
    ui.horizontal_wrapped(|ui| {
        if ui.add_enabled(lesson.step > 1, Button::new(tr("Back"))).clicked() {
            lesson.step -= 1;
            lesson.leaves = false;
            return;
        }
        let Some(question) = say else {
            // After the last step there is none.
            if lesson.step < count {
                let next = ui.button(tr("Next"));
                note_place(ui, "next", &next);
                if next.clicked() {
                    lesson.go_on();
                }
            }
            return;
        };
        let (say, leave) = match question.look_up {
            false => (tr("That is my prediction"), tr("Go on without a prediction")),
            true => (tr("That is my answer"), tr("Go on without an answer")),
        };
        let asks = lesson.asks();
        let say = ui.add_enabled(lesson.has_draft(), Button::new(say));
        note_place(ui, "say", &say);
        if say.clicked() {
            lesson.say();
        }
        if asks {
            let skip = ui.button(leave);
            note_place(ui, "skip", &skip);
            if skip.clicked() {
                lesson.leaves = !lesson.leaves;
            }
        }
    });
    if lesson.leaves && lesson.asks() {
        leave_open(ui, lesson);
    }
}

/// Asks again before a question is left without an answer, at another place than the first time: a finger that comes
/// down twice leaves nothing.
fn leave_open(ui: &mut Ui, lesson: &mut Lesson) {
    let words = tr("Without an answer there is no third star: any guess teaches more than none.");
    Standing::Watch.label(ui, words, |text| text);
    let sure = ui.button(tr("Go on all the same"));
    note_place(ui, "skip all the same", &sure);
    if sure.clicked() {
        lesson.leave_open();
    }
}

/// The question of a step, as far as it can still be answered.
fn ask(
    ui: &mut Ui,
    lesson: &mut Lesson,
    question: &Question,
    view: &View<'_>,
    commands: &mut Vec<Command>,
) {
    let fixed = lesson.is_seen() && !question.must && !question.look_up;
    let before = lesson.said().cloned();
    let now = ui
        .add_enabled_ui(!fixed, |ui| {
            questions::show(ui, question, before.as_ref(), view.session, commands)
        })
        .inner;
    if !fixed && before != now {
        match now {
            Some(now) => lesson.draft(now),
            // What was typed is no number any more.
            None => lesson.put_draft_away(),
        }
    }
    let note = match (fixed, before.is_some()) {
        (true, true) => tr("Your prediction stays as it is: the cut has been shown."),
        (true, false) => tr("It was left without a prediction: the cut has been shown."),
        (false, _) if lesson.was_seen() && !lesson.is_seen() => tr(
            "You have seen this cut before: another answer than that of the first time counts for passing, not for the third star.",
        ),
        (false, _) if lesson.is_late() || lesson.is_seen() && lesson.has_draft() => tr(
            "Answered after the cut or a check has shown it: that counts for passing, not for the third star.",
        ),
        (false, _) => return,
    };
    ui.label(RichText::new(note).small().color(Palette::at(ui).weak));
}

/// What the learner may change, and what is given.
pub fn settings(ui: &mut Ui, lesson: &Lesson, view: &View<'_>, commands: &mut Vec<Command>) {
    let controls = &lesson.mission.controls;
    let scenario = view.session.current();
    ui.separator();
    ui.label(RichText::new(tr("What you may change")).strong());
    if controls.open.is_empty() {
        ui.label(tr("Nothing: this mission asks only for answers."));
    }
    let by_hand = is_for_the_hand(&controls.open);
    for path in &controls.open {
        if by_hand && path == HAND {
            operator::panel(ui, view, KNOB, commands);
        } else {
            setting(ui, Screen::Console, path, scenario, Size::Large, commands);
        }
    }
    if !controls.locked.is_empty() {
        folded(ui, tr("Given"), false, |ui| {
            ui.add_enabled_ui(false, |ui| {
                for path in &controls.locked {
                    setting(ui, Screen::Console, path, scenario, Size::Small, commands);
                }
            });
        });
    }
    ui.add_space(6.0);
}

/// A text behind its head, in one paragraph: rows of a phone that are high enough for fingers would part its lines.
fn headed(ui: &mut Ui, head: &str, color: Color32, text: &str) {
    let font = TextStyle::Body.resolve(ui.style());
    let format = |color| TextFormat { font_id: font.clone(), color, ..TextFormat::default() };
    let mut job = LayoutJob::default();
    job.append(head, 0.0, format(color));
    job.append(&format!(" {text}"), 0.0, format(ui.visuals().text_color()));
    ui.label(job);
}

/// Hints, one by one.
pub fn hints(ui: &mut Ui, lesson: &mut Lesson) {
    let count = lesson.mission.hints.len();
    for (number, hint) in (1..).zip(lesson.mission.hints.iter().take(lesson.hints)) {
        let head = tr!("Hint {number}:", number = number);
        headed(ui, &head, Palette::at(ui).weak, &told(hint));
    }
    if lesson.hints < count {
        let words = tr!("Hint {number} of {count}", number = lesson.hints + 1, count = count);
        if ui.button(words).clicked() {
            lesson.hints += 1;
        }
    }
}
