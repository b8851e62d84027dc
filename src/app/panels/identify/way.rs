//! The whole way of the papers with one button: cuts planned and measured on the simulator with the open scenario's
//! cutter and material, models identified from them, the rows of Table 3 run on the models.

use std::sync::{Arc, Mutex, PoisonError};

use egui::{Button, Label, ProgressBar, RichText, Ui};

use super::symbols::{in_language, told_number};
use crate::app::command::{Command, FileCommand, SessionCommand, ShellCommand};
use crate::app::jobs::{Jobs, Work, time_left};
use crate::app::panels::BroughtFile;
use crate::app::theme::{self, Palette};
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::{text, tr};
use crate::blocks::control::ControllerKind;
use crate::models::tool::Tool;
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;
use crate::run::scenario_file;
use crate::study::experiment::way::job::WayJob;
use crate::study::experiment::way::report::{EntrantSummary, WayReport};
use crate::study::experiment::way::{CUTS_2007, WaySettings};

/// Name of the work at the way.
const WORK: &str = text!("Identify: the whole way");
/// Steps of the first slice.
const FIRST: u64 = 500;

/// What is handed on once the way is gone.
struct Taken {
    /// The cuts.
    table: Option<String>,
    /// The scenario with the models, as a file, or why there is none.
    scenario: Result<String, String>,
}

/// The way that is gone or was gone.
#[derive(Default)]
pub struct WayView {
    work: Option<Work<WayJob>>,
    taken: Option<Arc<Mutex<Option<Taken>>>>,
    /// Why it was not begun.
    refused: Option<String>,
}

/// What the way is gone with: cutter and material of a scenario, all else as in the papers.
///
/// # Errors
/// Its cutter is none of the shipped.
fn settings(scenario: &Scenario, seed: u64, batches: u64) -> Result<WaySettings, String> {
    let tool = scenario.tool.name;
    if scenario.tool != (Tool { name: tool, ..tool.load().tool }) {
        return Err(tr(
            "the open scenario's cutter is none of the shipped: the way is gone with one of those",
        )
        .to_owned());
    }
    let (material, hardness) = (scenario.plant.material, scenario.plant.hardness_hb);
    let hardness_hb = (hardness != material.hardness_hb()).then_some(hardness);
    Ok(WaySettings { tool, material, hardness_hb, seed, batches, ..WaySettings::default() })
}

impl WayView {
    /// The button, and how far it is.
    pub fn controls(
        &mut self,
        ui: &mut Ui,
        scenario: &Scenario,
        (seed, batches): (u64, u64),
        jobs: &Jobs,
    ) {
        let palette = Palette::at(ui);
        ui.label(RichText::new(tr("From cuts to a controller")).strong());
        let about = tr!(
            "With the open scenario's cutter and material: {n} cuts planned and measured on the simulator, models \
             1 to 5 identified from them, the rows of Table 3 run on the models.",
            n = CUTS_2007
        );
        ui.add(Label::new(RichText::new(about).small().color(palette.weak)).wrap());
        let least = touch::least(ui);
        let button = |ui: &mut Ui, name: &str| ui.add(Button::new(name).min_size(least)).clicked();
        let running = self.work.as_ref().is_some_and(Work::is_running);
        let over = self.work.as_ref().is_none_or(Work::is_over);
        ui.horizontal_wrapped(|ui| {
            if over && button(ui, tr("Go the whole way")) {
                let job =
                    settings(scenario, seed, batches).and_then(|settings| WayJob::new(&settings));
                self.refused = job.as_ref().err().cloned();
                if let Ok(job) = job {
                    self.work = Some(jobs.begin(WORK, job, FIRST));
                    self.taken = None;
                }
            }
            if let Some(work) = self.work.as_ref().filter(|_| !over) {
                if running && button(ui, tr("Pause the way")) {
                    work.stop();
                }
                if !running && button(ui, tr("Go on with the way")) {
                    work.go_on();
                }
                if button(ui, tr("Give the way up")) {
                    self.work = None;
                }
            }
        });
        if let Some(work) = self.work.as_ref().filter(|_| !over) {
            ui.scope(|ui| {
                ui.visuals_mut().extreme_bg_color = palette.line;
                let share = work.progress().share() as f32;
                ui.add(ProgressBar::new(share).desired_width(140.0).desired_height(10.0));
            });
            let left = work.left_s().filter(|_| running).map(time_left);
            let percent = 100.0 * work.progress().share();
            let text = match (left, running) {
                (Some(left), _) => tr!(
                    "{percent:.0} % of the way, about {left} left",
                    percent = percent,
                    left = left
                ),
                (None, true) => tr!("{percent:.0} % of the way", percent = percent),
                (None, false) => tr!("{percent:.0} % of the way, paused", percent = percent),
            };
            ui.label(RichText::new(text).color(palette.weak));
        }
        for because in self.refused.iter().chain(&self.work.as_ref().and_then(Work::refusal)) {
            Standing::Bad.label(ui, because, |text| text);
        }
    }

    /// What was found so far.
    pub fn show(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        let Some(work) = &self.work else { return };
        let over = work.is_over() && work.refusal().is_none();
        let report = work.partial();
        if over && self.taken.is_none() {
            let place = Arc::new(Mutex::new(None));
            self.taken = Some(Arc::clone(&place));
            work.change(move |job| {
                let example = job.example();
                let scenario = example.map(|found| scenario_file::write(&found, &Edits::none()));
                let taken = Taken { table: job.table(), scenario };
                *place.lock().unwrap_or_else(PoisonError::into_inner) = Some(taken);
            });
        }
        ui.add_space(8.0);
        theme::card(Palette::at(ui)).show(ui, |ui| {
            ui.set_width(ui.available_width());
            told(ui, &report);
            let Some(taken) = self.taken.as_ref().filter(|_| over) else { return };
            let taken = taken.lock().unwrap_or_else(PoisonError::into_inner);
            let Some(taken) = taken.as_ref() else { return };
            handed_on(ui, taken, commands);
        });
    }
}

/// Buttons for what can be gone on with.
fn handed_on(ui: &mut Ui, taken: &Taken, commands: &mut Vec<Command>) {
    let least = touch::least(ui);
    ui.horizontal_wrapped(|ui| {
        if let Some(table) = &taken.table
            && ui.add(Button::new(tr("Its cuts as the table")).min_size(least)).clicked()
        {
            let (name, text) = (tr("cuts of the way").to_owned(), table.clone());
            commands.push(Command::File(FileCommand::Bring(BroughtFile::Table { name, text })));
        }
        match &taken.scenario {
            Ok(text) => {
                let help = tr("Ra 0.81 µm with Tracking on the models found");
                let button = ui.add(Button::new(tr("Cut with its models")).min_size(least));
                if button.on_hover_text(help).clicked() {
                    let (name, text) = (tr("The scenario of the way").to_owned(), text.clone());
                    commands.push(Command::Session(SessionCommand::LoadText { name, text }));
                    commands.push(Command::Shell(ShellCommand::ShowScreen("console")));
                }
            }
            Err(because) => {
                Standing::Bad.label(ui, because, |text| text);
            }
        }
    });
}

fn told(ui: &mut Ui, report: &WayReport) {
    let palette = Palette::at(ui);
    let weak = |ui: &mut Ui, text: String| {
        ui.add(Label::new(RichText::new(text).small().color(palette.weak)).wrap());
    };
    let settings = &report.settings;
    let title = tr!(
        "The whole way: {tool} in {material}",
        tool = tr(settings.tool.label()),
        material = tr(settings.material.label())
    );
    ui.label(RichText::new(title).strong());
    weak(ui, tr!("Truth: {truth}.", truth = report.truth));
    let [axial, radial] = report.depths_mm;
    ui.label(tr!(
        "{measured} of {n} cuts measured, {axial} mm deep and {radial} mm wide.",
        measured = report.measured,
        n = settings.cuts,
        axial = told_number(axial),
        radial = told_number(radial)
    ));
    for (run, problem) in &report.unmeasured {
        let text = tr!("Cut {run}: {problem}.", run = *run, problem = problem);
        Standing::Watch.label(ui, &text, |text| text);
    }
    for found in &report.models {
        let ranges = found.ranges.iter().map(|(name, [low, high])| {
            let [low, high] = [*low, *high].map(told_number);
            tr!("{name} {low} to {high}", name = name, low = low, high = high)
        });
        let formula = in_language(&found.formula.to_string());
        let text = format!("{}: {} = {formula}", found.name, found.role.target());
        ui.add(Label::new(text).wrap());
        let ranges: Vec<String> = ranges.collect();
        let text = tr!(
            "error {error}, {n} cuts, {ranges}",
            error = told_number(found.error),
            n = found.cuts,
            ranges = ranges.join(", ")
        );
        weak(ui, text);
    }
    if report.rows.is_empty() {
        return;
    }
    let title = tr!("Ra against its target, {n} rows of Table 3", n = report.rows.len());
    ui.label(RichText::new(title).strong());
    report.summary.iter().for_each(|one| held(ui, one));
    let digest =
        tr!("Digest {digest}: that of `steadycut experiment way`.", digest = report.digest);
    weak(ui, digest);
}

/// How far an entrant holds Ra.
fn held(ui: &mut Ui, one: &EntrantSummary) {
    let outside = match one.outside {
        0 => String::new(),
        n => format!("; {}", tr!("{n} rows outside the ranges of the models", n = n)),
    };
    let (standing, held) = match (one.worst_percent, one.rms_percent) {
        (Some(worst), Some(rms)) => {
            let held = tr!("off by {worst:.1} % at most, {rms:.1} % rms", worst = worst, rms = rms);
            (Standing::Plain, held)
        }
        (_, _) => (Standing::Watch, tr!("{n} rows without a Ra", n = one.without_ra)),
    };
    let kind = ControllerKind::ALL.iter().find(|kind| kind.id() == one.controller);
    let controller = kind.map_or(one.controller, |kind| tr(kind.label()));
    let entrant =
        tr!("{controller} on {models}", controller = controller, models = tr(one.models.label()));
    let text = format!("{entrant}: {held}{outside}.");
    standing.label(ui, &text, |text| text);
}
