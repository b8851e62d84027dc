//! The window "Within a revolution": the forces on the tool at every plant step of the last turns
//! before the playhead, with the peak of each control period.

mod plot;

use egui::{RichText, Ui};

use super::super::View;
use crate::app::command::{Command, FileCommand, SessionCommand};
use crate::app::jobs::Work;
use crate::app::theme::{self, Look, Palette};
use crate::app::widgets::legend;
use crate::app::widgets::window::{self, WindowPlace};
use crate::base::language::{text, tr};
use crate::base::settings::Value;
use crate::blocks::cutting::process::ForceModel;
use crate::run::one_run::Repeat;
use crate::run::revolution::{Revolution, RevolutionJob};
use crate::study::export::csv;

/// Time between two pictures while the cut is playing, s: each repeats a part of the run.
const EVERY_S: f64 = 0.25;
/// Plant steps of the first slice: some milliseconds of work.
const FIRST: u64 = 8_000;
/// Plant steps in a control period and rows in it where it is switched on from here: 28.8 kHz.
const STEPS: [i64; 2] = [576, 96];

/// Title of the window, and name of its work.
const TITLE: &str = text!("Within a revolution");

/// What the horizontal axis is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Axis {
    /// The angle of the spindle from the start of the picture's first turn.
    #[default]
    Angle,
    /// The time from the first sample.
    Time,
}

/// What a picture was made of: number of changes, control period at the playhead, turns.
type Key = (u64, u64, u32);

/// The window.
pub struct RevolutionWindow {
    /// Whether it is shown.
    pub open: bool,
    turns: u32,
    axis: Axis,
    hidden: [bool; 4],
    zoomed: Option<[f64; 2]>,
    drag: Option<f32>,
    /// What the last job was begun for, and when.
    made: Option<(Key, f64)>,
    work: Option<Work<RevolutionJob>>,
    /// The state of the last job that is over, and the number of changes that it and the picture belong to.
    repeat: Option<(u64, Repeat)>,
    shown: Option<Revolution>,
}

impl Default for RevolutionWindow {
    fn default() -> Self {
        Self {
            open: false,
            turns: 1,
            axis: Axis::Angle,
            hidden: [false; 4],
            zoomed: None,
            drag: None,
            made: None,
            work: None,
            repeat: None,
            shown: None,
        }
    }
}

/// Name of the line of the reference.
const DESIRED: &str = text!("Desired force");
/// The lines: name and look, in the order of the samples' values.
const LINES: [(&str, Look); 4] = [
    (text!("Fxy, across the tool"), Look::Produced),
    (text!("Fx, along the feed"), Look::Axis(0)),
    (text!("Fy, across the feed"), Look::Axis(1)),
    (text!("Fz, along the tool"), Look::Axis(2)),
];

impl RevolutionWindow {
    /// Shows it, if it is open.
    pub fn show(&mut self, ui: &Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let size = [theme::OVERLAY_WIDTH, theme::OVERLAY_HEIGHTS[1]];
        let place = WindowPlace { screen: ui.max_rect(), narrow: view.narrow, size, share: 1.0 };
        let mut open = self.open;
        window::show(ui.ctx(), TITLE, place, &mut open, |ui| {
            self.content(ui, view, commands);
        });
        self.open = open;
    }

    fn content(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        self.refresh(ui, view);
        let by_teeth = view.session.current().plant.force_model.tooth_by_tooth();
        match &self.shown {
            Some(shown) if by_teeth => {
                let csv = csv_of(shown);
                self.head(ui, csv, commands);
                self.picture(ui, view);
            }
            None if by_teeth && self.work.as_ref().is_some_and(Work::is_running) => {
                ui.label(tr("The run is being repeated up to this moment."));
            }
            Some(_) | None => nothing(ui, by_teeth, commands),
        }
    }

    /// Repeats the run for another picture where the playhead or the run has changed; while playing
    /// at most every so often. A picture of this run that is under way is finished first, so that a
    /// drag of the playhead is followed.
    fn refresh(&mut self, ui: &Ui, view: &View<'_>) {
        let session = view.session;
        let run = session.chosen().run();
        let playhead_s = session.playback().playhead_s;
        let tick = session.scenario().ticks(playhead_s).min(run.ticks());
        let period = (tick + 1) / u64::from(session.scenario().run.steps_per_control);
        let key = (session.changes(), period, self.turns);
        self.take_finished(key.0);
        let now_s = ui.input(|input| input.time);
        let due = self.made.is_none_or(|(made, at_s)| {
            let moved_on = (made.0, made.2) == (key.0, key.2) && session.playback().playing;
            let under_way = self.work.as_ref().is_some_and(Work::is_running);
            made != key && !under_way && !(moved_on && (now_s - at_s).abs() < EVERY_S)
        });
        if due {
            self.made = Some((key, now_s));
            // A job that is not done leaves nothing; the last one that was does.
            let repeat = self.repeat.clone().filter(|(changes, _)| *changes == key.0);
            let before = repeat.map(|(_, repeat)| repeat);
            let job = RevolutionJob::new(run, playhead_s, self.turns, before);
            self.work = Some(view.jobs.begin_brief(TITLE, job, FIRST));
        }
    }

    /// Shows what a job has found that is over; what belongs to the run before a change is given up.
    fn take_finished(&mut self, changes: u64) {
        if self.made.is_some_and(|((made, ..), _)| made != changes) {
            self.work = None;
        }
        let over = self.work.take_if(|work| work.is_over());
        if let Some(job) = over.and_then(Work::into_job) {
            let (found, repeat) = job.finish();
            (self.shown, self.repeat) = (found, Some((changes, repeat)));
        }
    }

    /// What can be chosen: turns, axis, lines; the samples as a file.
    fn head(&mut self, ui: &mut Ui, csv: String, commands: &mut Vec<Command>) {
        ui.horizontal_wrapped(|ui| {
            let before = (self.turns, self.axis);
            for (turns, name) in [(1, tr("1 turn")), (2, tr("2 turns"))] {
                ui.selectable_value(&mut self.turns, turns, name);
            }
            ui.separator();
            ui.selectable_value(&mut self.axis, Axis::Angle, tr("Angle"));
            ui.selectable_value(&mut self.axis, Axis::Time, tr("Time"));
            ui.separator();
            if before != (self.turns, self.axis) {
                self.zoomed = None;
            }
            let help = tr("Save these samples as CSV: time, angle, Fx, Fy, Fz, Fxy");
            let button = ui.button(tr("Save CSV")).on_hover_text(help);
            if button.clicked() {
                commands.push(Command::File(FileCommand::SaveCsv {
                    what: "revolution".to_owned(),
                    text: csv,
                }));
            }
        });
        ui.scope(|ui| {
            ui.spacing_mut().item_spacing = egui::vec2(10.0, 1.0);
            legend::row(ui, tr("the revolution"), |ui| {
                for ((name, look), hidden) in LINES.into_iter().zip(&mut self.hidden) {
                    if legend::entry(ui, tr(name), look, *hidden).pressed {
                        *hidden = !*hidden;
                    }
                }
                legend::sample(ui, tr(DESIRED), Look::Reference);
            });
        });
    }
}

fn csv_of(shown: &Revolution) -> String {
    let mut bytes = Vec::new();
    // Writing into memory does not fail, and what is written is text.
    let _ = csv::write_samples(&mut bytes, &shown.samples);
    String::from_utf8(bytes).unwrap_or_default()
}

/// What to do where there is nothing to see.
fn nothing(ui: &mut Ui, by_teeth: bool, commands: &mut Vec<Command>) {
    let palette = Palette::at(ui);
    if by_teeth {
        ui.label(tr("The force was not simulated tooth by tooth at this moment of the run."));
        return;
    }
    let text = tr("The force of this cut is the maximum that a formula or a network gives.");
    ui.label(RichText::new(text).strong());
    ui.label(tr(
        "To look into a revolution, the force has to be simulated tooth by tooth: the mechanistic \
         model of the ball-end mill, at 28.8 kHz.",
    ));
    ui.add_space(6.0);
    ui.horizontal_wrapped(|ui| {
        if ui.button(tr("Simulate tooth by tooth")).clicked() {
            let [steps, rows] = STEPS;
            let model = ForceModel::Mechanistic.id().to_owned();
            commands.push(Command::Session(SessionCommand::SetUp(vec![
                ("plant.force_model".to_owned(), Value::Text(model)),
                ("run.steps_per_control".to_owned(), Value::Int(steps)),
                ("run.record_every".to_owned(), Value::Int(rows)),
            ])));
        }
        if ui.button(tr("Load Experiment 2")).clicked() {
            commands.push(Command::Session(SessionCommand::LoadPreset("experiment-2".to_owned())));
        }
    });
    let text = tr("Both can be undone. The first keeps this scenario and changes its plant.");
    ui.label(RichText::new(text).small().color(palette.weak));
    ui.add_space(theme::PLOT_HEIGHT_MIN * 0.2);
}
