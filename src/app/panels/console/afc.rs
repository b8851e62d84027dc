//! The window "AFC", after the dialogue that operators know: teach-in and references, the limits of the feed,
//! what it does at the playhead, and the log of the run, cut by cut.

use egui::{ProgressBar, RichText, Ui};

use super::super::View;
use crate::app::command::{Command, SessionCommand};
use crate::app::format::{deviation, number, quantity};
use crate::app::jobs::Work;
use crate::app::theme::{self, Palette};
use crate::app::widgets::save_table::{SavedTable, TableOf, save_table_of};
use crate::app::widgets::setting::{Size, setting};
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::app::widgets::window::{self, WindowPlace};
use crate::base::language::{text, tr};
use crate::base::settings::Value;
use crate::base::units::percent_from_ratio;
use crate::blocks::control::afc::AfcSettings;
use crate::blocks::cutting::tool_path::ToolPath;
use crate::run::scenario::Scenario;
use crate::run::signals::{Row, flag};
use crate::study::afc::{AfcCut, REFERENCES, Recorded, TeachIn, Teaching, log, sheet, sum};
use crate::study::uses::Screen;

/// Plant steps of the first slice of a teach-in.
const FIRST: u64 = 8_000;
/// How near to a limit the feed counts as standing there, percent of the programmed one.
const NEAR_PERCENT: f64 = 0.05;
/// The settings of the dialogue, in its order.
const DIALOGUE: [&str; 9] = [
    "controller.afc.f_min_percent",
    "controller.afc.f_max_percent",
    "controller.afc.entry_percent",
    "controller.afc.air_percent",
    "controller.afc.exit_percent",
    "controller.afc.recovery_percent_s",
    "controller.afc.overload_percent",
    "controller.afc.overload_s",
    "controller.afc.reaction",
];

/// What the button that opens the window says it is for.
pub const HELP: &str = text!(
    "Adaptive feed control: teach in the reference forces, set FMIN and FMAX, and read the log of the cut"
);

/// The window.
#[derive(Default)]
pub struct AfcWindow {
    /// Whether it is shown.
    pub open: bool,
    /// The teach-in under way, with the scenario that it belongs to.
    teaching: Option<(Scenario, Work<TeachIn>)>,
    /// What the last one came to.
    said: Option<(Standing, String)>,
}

impl AfcWindow {
    /// Shows it, if it is open. A teach-in under way goes on even while it is closed.
    pub fn show(&mut self, ui: &Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        self.take(view, commands);
        let size = [theme::OVERLAY_WIDTH, theme::OVERLAY_HEIGHTS[0]];
        let place = WindowPlace { screen: ui.max_rect(), narrow: view.narrow, size, share: 1.0 };
        let mut open = self.open;
        window::show(ui.ctx(), "AFC", place, &mut open, |ui| {
            self.teach_in(ui, view, commands);
            ui.separator();
            now(ui, view);
            ui.separator();
            logged(ui, view, commands);
            ui.separator();
            for path in DIALOGUE {
                setting(ui, Screen::Console, path, view.session.current(), Size::Small, commands);
            }
        });
        self.open = open;
    }

    /// Takes over what a teach-in has found, where the scenario is still the one that was taught in.
    fn take(&mut self, view: &View<'_>, commands: &mut Vec<Command>) {
        let Some((scenario, work)) = self.teaching.take_if(|(_, work)| work.is_over()) else {
            return;
        };
        let found = work.partial();
        self.said = match &*found {
            Teaching::Taught { .. } if scenario != *view.session.scenario() => {
                let text =
                    tr("The set-up was changed meanwhile: nothing is taken over. Teach in again.");
                Some((Standing::Watch, text.to_owned()))
            }
            Teaching::Taught { references_n, whole } => {
                let set = vec![(REFERENCES.to_owned(), Value::from(references_n.clone()))];
                commands.push(Command::Session(SessionCommand::SetUp(set)));
                Some(if *whole {
                    (Standing::Good, tr("Taught in.").to_owned())
                } else {
                    let text = tr("Taught in up to the time limit; the part is longer.");
                    (Standing::Watch, text.to_owned())
                })
            }
            Teaching::NotTaught(why) => {
                Some((Standing::Bad, tr!("Not taught in: {why}", why = why)))
            }
            Teaching::UnderWay => None,
        };
    }

    fn teach_in(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let palette = Palette::at(ui);
        let text = tr(
            "Teach-in cuts the part of the set-up once at the programmed feed, without the changes of this session, \
             and keeps the peak force of each cut as its reference.",
        );
        ui.label(RichText::new(text).small().color(palette.weak));
        let running = self.teaching.as_ref().filter(|(_, work)| work.is_running());
        let mut stopped = false;
        if let Some((_, work)) = running {
            ui.horizontal(|ui| {
                stopped = ui.button(tr("Stop the teach-in")).clicked();
                let bar = ProgressBar::new(work.progress().share() as f32).show_percentage();
                ui.add(bar.desired_height(16.0));
            });
        } else if ui.button(tr("Teach in")).clicked() {
            let scenario = view.session.scenario().clone();
            let work = view.jobs.begin_brief(text!("Teach-in"), TeachIn::new(&scenario), FIRST);
            (self.teaching, self.said) = (Some((scenario, work)), None);
        }
        if stopped {
            self.teaching = None;
        }
        if let Some((standing, text)) = &self.said {
            standing.label(ui, text, |text| text);
        }
        setting(ui, Screen::Console, REFERENCES, view.session.current(), Size::Small, commands);
    }
}

/// What it does at the playhead.
fn now(ui: &mut Ui, view: &View<'_>) {
    let (scenario, row) = (view.session.current(), view.session.row());
    let afc = &scenario.controller.afc;
    let cut = ToolPath::cut_of(&scenario.workpiece, row.position_mm);
    let feed = quantity(row.feed_override_percent, "%");
    let measured = quantity(row.force_measured_n, "N");
    let text = match afc.reference_n(cut) {
        Some(reference_n) => tr!(
            "Cut {number}: feed {feed}, {force} of {reference} ({share:.0} %)",
            number = cut + 1,
            feed = feed,
            force = measured,
            reference = quantity(reference_n, "N"),
            share = percent_from_ratio(row.force_measured_n / reference_n)
        ),
        None => tr!(
            "Cut {number}: feed {feed}, {force}, no reference",
            number = cut + 1,
            feed = feed,
            force = measured
        ),
    };
    ui.label(RichText::new(text).strong());
    let (standing, text) = state(afc, cut, row);
    standing.label(ui, text, |text| text);
}

/// The state at a row, in words.
fn state(afc: &AfcSettings, cut: usize, row: &Row) -> (Standing, &'static str) {
    let at = |percent: f64| (row.feed_override_percent - percent).abs() < NEAR_PERCENT;
    let Some(reference_n) = afc.reference_n(cut) else {
        return (Standing::Plain, tr("Teach-in: the feed stays as programmed."));
    };
    if row.has(flag::CONTROL_OFF) {
        (Standing::Watch, tr("Off for this cut: the operator has turned the override down."))
    } else if row.has(flag::OVER_LIMIT) {
        (Standing::Bad, tr("Overload: the force stays over its limit with the feed at FMIN."))
    } else if afc.only_watches() {
        let text = tr("Watching: FMIN and FMAX are 100 %, the feed stays as programmed.");
        (Standing::Plain, text)
    } else if percent_from_ratio(row.force_measured_n / reference_n) < afc.exit_percent {
        (Standing::Plain, tr("Out of the cut: feed in the air."))
    } else if at(afc.f_min_percent) {
        (Standing::Watch, tr("The feed stands at FMIN."))
    } else if at(afc.f_max_percent) {
        (Standing::Plain, tr("The feed stands at FMAX."))
    } else {
        (Standing::Good, tr("The feed follows the force."))
    }
}

/// The log up to the playhead, and the button that saves it.
fn logged(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let session = view.session;
    let [chosen, twin] = [session.chosen(), session.twin()].map(|cut| cut.run());
    let rows = session.revealed().len();
    let control = Recorded { recording: chosen.recording(), rows };
    let cuts = log(session.current(), control, Recorded::all(twin));
    ui.horizontal_wrapped(|ui| {
        ui.strong(tr("Log"));
        let open = session.finished().is_none();
        let done = || {
            let done = cuts.iter().filter(|cut| cut.control_s.is_some()).count();
            tr!("{done} of {n} cuts done", done = done, n = cuts.len())
        };
        let partial = open.then_some(&done as &dyn Fn() -> String);
        let saved = SavedTable { what: "afc-log", of: TableOf::Open, partial };
        let begun = cuts.iter().any(|cut| cut.peak_n.is_some());
        save_table_of(ui, &saved, begun, || sheet(&cuts), commands);
    });
    table(ui, &cuts);
}

fn table(ui: &mut Ui, cuts: &[AfcCut]) {
    let palette = Palette::at(ui);
    let cell =
        |value: Option<f64>, unit: &str| value.map_or("-".to_owned(), |value| number(value, unit));
    // The unit stands in the title, which keeps the table as narrow as a phone.
    let signed = |value: f64| deviation(value).trim_end_matches(" %").to_owned();
    let percent = |value: Option<f64>| value.map_or("-".to_owned(), signed);
    touch::grid(ui, "afc log")
        .num_columns(7)
        .min_col_width(0.0)
        .striped(true)
        .spacing([7.0, 4.0])
        .show(ui, |ui| {
            for (title, help) in [
                (tr("cut"), tr("Number of the cut")),
                (tr("ref. N"), tr("Reference force, as teach-in has found it")),
                (tr("teach-in s"), tr("Time that the cut takes at the programmed feed")),
                (tr("control s"), tr("Time that it took")),
                (tr("diff. %"), tr("By how much that is longer")),
                (tr("peak N"), tr("Largest measured force")),
                (tr("least %"), tr("Least feed, of the programmed one")),
            ] {
                ui.label(RichText::new(title).small().color(palette.weak)).on_hover_text(help);
            }
            ui.end_row();
            for cut in cuts {
                ui.label(cut.cut.to_string());
                ui.label(cell(cut.reference_n, "N"));
                ui.label(cell(cut.teach_in_s, "s"));
                ui.label(cell(cut.control_s, "s"));
                ui.label(percent(cut.difference_percent));
                let peak = cell(cut.peak_n, "N");
                if cut.overload {
                    Standing::Bad.label(ui, &peak, |text| text).on_hover_text(tr("Overload"));
                } else {
                    ui.label(peak);
                }
                ui.label(cell(cut.least_factor_percent, "%"));
                ui.end_row();
            }
            if cuts.len() > 1
                && let Some([teach_in_s, control_s, difference]) = sum(cuts)
            {
                ui.label(tr("all"));
                ui.label("");
                ui.label(number(teach_in_s, "s"));
                ui.label(number(control_s, "s"));
                ui.label(signed(difference));
                ui.end_row();
            }
        });
}
