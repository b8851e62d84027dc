//! Lessons that are checked: missions drive the cut, ask what will happen, and judge what came of it by the same code
//! as `steadycut mission check`.

mod answer;
mod catalogue;
mod formula;
mod lesson;
mod pen;
mod questions;
mod sketch;
mod tasks;
mod verdict;

use std::collections::BTreeMap;

use egui::{
    CentralPanel, CollapsingHeader, Context, Frame, Id, Margin, Response, RichText, Ui, UiBuilder,
};

use super::console::charts;
use super::{BroughtFile, Panel, View};
use crate::app::command::{Command, SessionCommand, ShellCommand};
use crate::app::format;
use crate::app::session::MissionLock;
use crate::app::session::hand::is_for_the_hand;
use crate::app::theme::{self, Palette};
use crate::app::widgets::chart::{self, Axes};
use crate::app::widgets::scaffold;
use crate::base::language::{text, tr};
use crate::study::mission::Mission;
use crate::study::opening::LinkedMission;
use lesson::{Lesson, Past};

/// Charts that a lesson shows, by their ids on the console.
const CHARTS: [&str; 4] = ["roughness", "force", "feed", "depth"];
/// Room at the right of the charts for the half of a label that stands at the end of their axis, points.
const AXIS_END: i8 = 16;
/// So many of them stand before the settings on a phone.
const WATCHED: usize = 2;

/// The screen.
#[derive(Default)]
pub struct LearnPanel {
    lesson: Option<Lesson>,
    /// What is known of missions that were begun before, by their parts of a link.
    past: BTreeMap<String, Past>,
    /// A mission that was left before its cut was shown: on any other screen it is to be seen now.
    unseen: Option<Mission>,
    /// Whether another screen is shown.
    away: bool,
    axes: Axes,
    /// A mission that a file or a link brought, to be begun in the next frame.
    brought: Option<Box<LinkedMission>>,
    /// The learner's name, as it was typed for a result.
    name: String,
    /// Why a file is no mission.
    refused: Option<String>,
}

impl Panel for LearnPanel {
    fn id(&self) -> &'static str {
        "learn"
    }

    fn title(&self) -> &'static str {
        text!("Learn")
    }

    fn words(&self) -> &'static str {
        "mission missions lesson lessons training teach exercise course help"
    }

    fn has_timeline(&self) -> bool {
        self.lesson.is_some()
    }

    fn left(&mut self) {
        self.away = true;
        if let Some(mission) = self.unseen.take() {
            self.past.entry(mission.link()).or_default().see_all(&mission);
        }
    }

    fn take(&mut self, file: &BroughtFile) {
        match file {
            BroughtFile::Mission { name, text } => match Mission::read(text) {
                Ok(mission) => self.bring(as_given(mission)),
                Err(error) => self.refused = Some(format!("{name}: {error}")),
            },
            BroughtFile::Linked(linked) => self.bring((**linked).clone()),
            BroughtFile::Table { .. }
            | BroughtFile::Search { .. }
            | BroughtFile::Measured(_)
            | BroughtFile::ToFit(_)
            | BroughtFile::Program { .. } => {}
        }
    }

    fn ui(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        if let Some(linked) = self.brought.take() {
            self.begin(*linked, commands);
        }
        if self.lesson.as_mut().is_some_and(|lesson| lesson.is_left(view.session)) {
            // Left on another screen, its cut was shown there from then on.
            let shown = self.away;
            self.unseen = self.put_away();
            if shown {
                self.left();
            }
        }
        self.away = false;
        if let Some(lesson) = &mut self.lesson {
            if lesson.hands_in {
                lesson.mark(view.session, view.jobs);
            }
            if lesson.refresh()
                && let Some(result) = lesson.result("")
            {
                commands.push(Command::Shell(ShellCommand::Marked(Box::new(result))));
            }
            self.learn(ui, view, commands);
            return;
        }
        let chosen = if view.narrow {
            scaffold::column(ui, "missions")
                .show(ui, |ui| {
                    scaffold::narrow().show(ui, |ui| self.choose(ui, view, commands)).inner
                })
                .inner
        } else {
            let mut chosen = None;
            scaffold::middle(ui, |ui| {
                scaffold::column(ui, "missions")
                    .show(ui, |ui| chosen = self.choose(ui, view, commands));
            });
            chosen
        };
        if let Some(mission) = chosen {
            self.begin(as_given(mission), commands);
        }
    }
}

impl LearnPanel {
    fn bring(&mut self, linked: LinkedMission) {
        (self.brought, self.refused) = (Some(Box::new(linked)), None);
    }

    fn choose(
        &mut self,
        ui: &mut Ui,
        view: &View<'_>,
        commands: &mut Vec<Command>,
    ) -> Option<Mission> {
        catalogue::show(ui, view, self.refused.as_deref(), commands)
    }

    /// Puts the mission under way away, and keeps what is known of it; gives it where its cut was not shown.
    fn put_away(&mut self) -> Option<Mission> {
        let lesson = self.lesson.take()?;
        let unseen = lesson.hides_the_cut().then(|| lesson.mission.clone());
        self.past.insert(lesson.mission.link(), lesson.into_past());
        unseen
    }

    fn begin(&mut self, linked: LinkedMission, commands: &mut Vec<Command>) {
        let LinkedMission { mission, cut: (scenario, edits) } = linked;
        self.put_away();
        self.unseen = None;
        let link = mission.link();
        let past = self.past.get(&link).cloned().unwrap_or_default();
        let lesson = Lesson::new(mission, past);
        let mission = &lesson.mission;
        let lock = MissionLock {
            title: mission.title.clone(),
            link,
            scenario: mission.scenario.clone(),
            open: mission.controls.open.clone(),
            options: mission.controls.options.clone(),
            given: mission.edits.clone(),
            hides: lesson.hides_the_cut(),
        };
        commands.push(Command::Session(SessionCommand::BeginMission {
            scenario: Box::new(scenario),
            edits,
            lock: Box::new(lock),
        }));
        self.lesson = Some(lesson);
        self.axes.fit();
    }

    fn learn(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let Self { lesson: Some(lesson), axes, name, .. } = self else { return };
        if lesson.hides_the_cut() != view.session.hides_the_cut() {
            let hide = SessionCommand::HideCut(lesson.hides_the_cut());
            commands.push(Command::Session(hide));
        }
        let mut next = None;
        let tried = lesson.is_tried();
        let mut with_feet = |ui: &mut Ui, lesson: &mut Lesson, task: Task<'_>| {
            let mut left = ui.available_rect_before_wrap();
            let feet = answer::Feet::of(ui, lesson, &mut left);
            ui.scope_builder(UiBuilder::new().max_rect(left), |ui| {
                scaffold::column(ui, "lesson").show(ui, |ui| task(ui, lesson, commands));
            });
            next = feet.and_then(|feet| feet.show(ui, lesson, view, name, commands));
        };
        if view.narrow {
            CentralPanel::no_frame().frame(scaffold::narrow()).show(ui, |ui| {
                with_feet(ui, lesson, &mut |ui, lesson, commands| {
                    tasks::show(ui, lesson, view, commands);
                    // What is to be watched comes before what is to be set, but for the knob, which is held meanwhile.
                    let by_hand = is_for_the_hand(&lesson.mission.controls.open);
                    if tried && by_hand {
                        tasks::settings(ui, lesson, view, commands);
                    }
                    cut(ui, lesson, axes, view, Some(&CHARTS[..WATCHED]));
                    if tried {
                        if !by_hand {
                            tasks::settings(ui, lesson, view, commands);
                        }
                        tasks::hints(ui, lesson);
                        cut(ui, lesson, axes, view, Some(&CHARTS[WATCHED..]));
                    }
                });
            });
        } else {
            scaffold::controls_unscrolled(ui, "lesson", |ui| {
                with_feet(ui, lesson, &mut |ui, lesson, commands| {
                    tasks::show(ui, lesson, view, commands);
                    if tried {
                        tasks::settings(ui, lesson, view, commands);
                        tasks::hints(ui, lesson);
                    }
                });
            });
            scaffold::middle(ui, |ui| cut(ui, lesson, axes, view, None));
        }
        if let Some(next) = next {
            self.brought = Some(Box::new(as_given(next)));
            ui.request_repaint();
        }
    }
}

/// What stands above the foot of a task.
type Task<'t> = &'t mut dyn FnMut(&mut Ui, &mut Lesson, &mut Vec<Command>);

/// What the cut does, once it may be seen: all of it, or some charts of a page that is scrolled.
fn cut(
    ui: &mut Ui,
    lesson: &Lesson,
    axes: &mut Axes,
    view: &View<'_>,
    some: Option<&[&'static str]>,
) {
    if lesson.hides_the_cut() {
        ui.add_space(8.0);
        predict_first(ui);
        return;
    }
    let ids = some.unwrap_or(&CHARTS);
    let charts: Vec<_> = charts(view).into_iter().filter(|chart| ids.contains(&chart.id)).collect();
    // One legend for all of a page.
    if ids.contains(&CHARTS[0]) {
        chart::legend_of_all(ui, view.session, axes);
    }
    let gap = ui.spacing().item_spacing.y;
    let height = if some.is_some() {
        theme::PLOT_HEIGHT_SCROLLED
    } else {
        let room = ui.available_height() / charts.len() as f32 - 2.0 * gap;
        room.max(theme::PLOT_HEIGHT_MIN)
    };
    let mut draw = |ui: &mut Ui| {
        let frame = Frame::new().inner_margin(Margin { right: AXIS_END, ..Margin::ZERO });
        frame.show(ui, |ui| {
            for chart in &charts {
                chart::show(ui, chart, view.session, axes, height);
            }
        });
    };
    if some.is_some() {
        draw(ui);
    } else {
        scaffold::column(ui, "cut of the lesson").show(ui, draw);
    }
}

/// What stands in the place of a cut that is to be predicted.
fn predict_first(ui: &mut Ui) {
    theme::card(Palette::at(ui)).show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.label(RichText::new(tr("Predict first")).strong());
        ui.label(tr(
            "The cut begins, and is shown, as soon as you have said what you expect, or gone on without a prediction.",
        ));
    });
}

/// What any other screen shows while the cut of a mission is to be predicted: what is asked could be read off it.
pub fn instead_of_the_cut(ui: &mut Ui, view: &View<'_>) {
    let frame = if view.narrow { scaffold::narrow() } else { scaffold::wide() };
    CentralPanel::no_frame().frame(frame).show(ui, predict_first);
}

/// A mission with its cut as it is given.
fn as_given(mission: Mission) -> LinkedMission {
    let cut = (mission.scenario.clone(), mission.edits.clone());
    LinkedMission { mission, cut }
}

/// Where the buttons of a mission were drawn last, by their names, for tests in a browser.
type Places = BTreeMap<String, [f32; 4]>;

fn places_id() -> Id {
    Id::unique("places of a mission's buttons")
}

/// Notes where a button is.
fn note_place(ui: &Ui, name: &str, response: &Response) {
    let rect = response.rect;
    let place = [rect.left(), rect.top(), rect.right(), rect.bottom()];
    ui.data_mut(|data| {
        data.get_temp_mut_or_default::<Places>(places_id()).insert(name.to_owned(), place);
    });
}

/// Where the buttons of a mission were drawn last: left, top, right and bottom in points, by their names.
#[must_use]
pub fn places(ctx: &Context) -> Places {
    ctx.data(|data| data.get_temp(places_id())).unwrap_or_default()
}

/// A text of a mission: its paragraphs.
fn paragraphs(ui: &mut Ui, text: &str) {
    for paragraph in told(text).trim().split("\n\n").filter(|paragraph| !paragraph.is_empty()) {
        ui.label(paragraph);
    }
}

/// A text of a mission in the language of now, its numbers typeset.
fn told(text: &str) -> String {
    format::typeset(tr(text))
}

/// A part of the page that can be folded away.
fn folded(ui: &mut Ui, title: &str, open: bool, add: impl FnOnce(&mut Ui)) {
    // One that is open at first is another one than one that is not.
    let id = (title.to_owned(), open);
    CollapsingHeader::new(title).id_salt(id).default_open(open).show_unindented(ui, add);
}
