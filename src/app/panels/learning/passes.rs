//! Several passes over the same part, worked off in slices beside the picture.

use egui::{ProgressBar, RichText, Ui};

use crate::app::command::{Command, SessionCommand};
use crate::app::format::{deviation, number};
use crate::app::jobs::Work;
use crate::app::panels::View;
use crate::app::theme::Palette;
use crate::app::widgets::save_table::{SavedTable, TableOf, save_table_of};
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::{fixed, text, tr};
use crate::base::units::percent_from_ratio;
use crate::run::scenario::Scenario;
use crate::study::export::sheet::{Entry, Sheet};
use crate::study::unks_passes::{BETTER, Pass, Passes, PassesVerdict, beginning_with};

/// Name of the work at the passes.
const WORK: &str = text!("Passes of UNKS");
/// How many passes.
const PASSES: u32 = 5;
/// Control periods of the first slice.
const FIRST: u64 = 20;

/// The passes under way, with the scenario that they were begun from.
#[derive(Default)]
pub struct PassesView {
    begun: Option<(Scenario, Work<Passes>)>,
}

impl PassesView {
    /// Stops where the scenario has become another one: a change made meanwhile would mix two set-ups in
    /// one table.
    pub fn follow(&mut self, scenario: &Scenario) {
        if let Some((begun, work)) = &self.begun
            && begun != scenario
        {
            work.stop();
        }
    }

    /// The button, the progress, the table and what it shows.
    pub fn show(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let palette = Palette::at(ui);
        ui.label(RichText::new(tr("The same part again and again")).strong());
        let note = tr!(
            "{n} passes without the changes of this session, same part, noise and seed; what \
             was learned is carried on.",
            n = PASSES
        );
        ui.label(RichText::new(note).small().color(palette.weak));
        let running = self.begun.as_ref().is_some_and(|(_, work)| work.is_running());
        if running {
            if ui.button(tr("Stop the passes")).clicked() {
                self.begun.iter().for_each(|(_, work)| work.stop());
            }
        } else if ui.button(tr!("Cut {n} passes", n = PASSES)).clicked() {
            let scenario = view.session.scenario().clone();
            let job = Passes::new(&scenario, PASSES);
            self.begun = Some((scenario, view.jobs.begin(WORK, job, FIRST)));
        }
        let Some((begun, work)) = &self.begun else { return };
        let so_far = work.partial();
        let done = &so_far.done;
        let so_many = || tr!("{done} of {n} passes", done = done.len(), n = PASSES);
        let partial = (!work.is_over()).then_some(&so_many as &dyn Fn() -> String);
        let of = TableOf::Cut(begun);
        let saved = SavedTable { what: "passes", of, partial };
        save_table_of(ui, &saved, !done.is_empty(), || sheet(done), commands);
        if running {
            let bar = ProgressBar::new(work.progress().share() as f32).show_percentage();
            ui.add(bar.desired_height(16.0));
        }
        table(ui, &so_far.done);
        if let Some(refused) = &so_far.refused {
            let text = tr!("No further pass: {because}", because = refused);
            Standing::Bad.label(ui, &text, |text| text);
        }
        if let Some(verdict) = &so_far.verdict {
            judge(ui, verdict);
        }
        if begun != view.session.scenario() {
            let text = tr("Made with other settings than those of now.");
            Standing::Watch.label(ui, text, |text| text);
        }
        if let Some(stored) = so_far.learned.as_ref().filter(|_| !running) {
            let help = tr("Begin the cut with the networks as they are after the last pass");
            if ui.button(tr("Use these networks")).on_hover_text(help).clicked() {
                commands.push(Command::Session(SessionCommand::SetUp(beginning_with(stored))));
            }
        }
    }
}

fn table(ui: &mut Ui, passes: &[Pass]) {
    if passes.is_empty() {
        return;
    }
    let palette = Palette::at(ui);
    touch::grid(ui, "passes").num_columns(5).striped(true).spacing([12.0, 4.0]).show(ui, |ui| {
        for (title, help) in [
            (tr("pass"), tr("Number of the pass")),
            ("Nsn", tr("Normalised standard error over all samples in contact")),
            (tr("time"), tr("Time of the cut, s")),
            ("kN", tr("Largest force")),
            (tr("feedback"), tr("Mean size of the feedback's share of the override, %")),
        ] {
            ui.label(RichText::new(title).small().color(palette.weak)).on_hover_text(help);
        }
        ui.end_row();
        for pass in passes {
            let error = pass.normalized_standard_error;
            ui.label(pass.number.to_string());
            ui.label(error.map_or("-".to_owned(), |error| fixed(error, 3)));
            ui.label(fixed(pass.time_of_cut_s, 1));
            ui.label(fixed(pass.max_force_kn, 2));
            let quarters = pass.feedback_by_quarter;
            let quarters = quarters.map(|share| number(percent_from_ratio(share), "%")).join(", ");
            ui.label(format!("{} %", number(percent_from_ratio(pass.feedback), "%")))
                .on_hover_text(tr!("By quarter of the part: {quarters} %", quarters = quarters));
            ui.end_row();
        }
    });
}

/// The passes as a file.
fn sheet(passes: &[Pass]) -> Sheet {
    let first =
        ["Pass", "Nsn", "Time [s]", "Largest force [kN]", "Feedback [%]"].map(str::to_owned);
    let quarters = (1..=4).map(|quarter| format!("Feedback in quarter {quarter} [%]"));
    let mut sheet = Sheet::new(first.into_iter().chain(quarters));
    for pass in passes {
        let first = [
            f64::from(pass.number).into(),
            pass.normalized_standard_error.into(),
            pass.time_of_cut_s.into(),
            pass.max_force_kn.into(),
            percent_from_ratio(pass.feedback).into(),
        ];
        let quarters = pass.feedback_by_quarter.map(|share| Entry::from(percent_from_ratio(share)));
        sheet.row(first.into_iter().chain(quarters));
    }
    sheet
}

fn judge(ui: &mut Ui, verdict: &PassesVerdict) {
    let mut line = |good: bool, text: String| {
        Standing::either(good).label(ui, &text, |text| text);
    };
    if verdict.unchanged {
        line(false, tr("Nothing is learned: every pass is the same.").to_owned());
        return;
    }
    let text = if verdict.feedback_falls {
        tr("The feedback's share falls pass by pass.")
    } else {
        tr("The feedback's share does not fall pass by pass.")
    };
    line(verdict.feedback_falls || !verdict.from_scratch, text.to_owned());
    let change = deviation(-percent_from_ratio(verdict.error_gain));
    if verdict.from_scratch {
        let text = tr!(
            "Error of the last pass against the first: {change} (from a cold start on the whole part: \
             -{wanted:.0} %).",
            change = change,
            wanted = percent_from_ratio(BETTER)
        );
        line(verdict.error_better, text);
    } else {
        ui.label(tr!("Error of the last pass against the first: {change}.", change = change));
    }
}
