//! Settings fitted to measured data: what `steadycut identify drive`, `force`, `wear` and so on do, to be seen before
//! anything of it is taken.

mod choose;
mod fields;
mod form;
mod found;
mod plots;

use egui::{Button, Label, ProgressBar, RichText, Ui};

use super::super::View;
use crate::app::command::Command;
use crate::app::format;
use crate::app::jobs::{Jobs, Work};
use crate::app::overlay::file::MeasuredFile;
use crate::app::overlay::work::SingleTask;
use crate::app::panels::console::measured::layout::LayoutFields;
use crate::app::theme::{self, Palette};
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::{text, tr};
use crate::measured::layout::DataLayout;
use crate::run::scenario::Scenario;
use crate::study::identify::fits::{FitFault, FitOutcome, MeasuredFitJob, MeasuredFitKind};
use form::FitForm;

/// Name of the work in the list of what goes on.
const WORK: &str = text!("Fit of measured data");
/// Name of making sample data, where that takes long enough to be listed.
const SAMPLE: &str = text!("Sample data");

/// A fit that was begun: of what, and for which cut.
struct BegunFit {
    form: FitForm,
    scenario: Scenario,
    work: Work<MeasuredFitJob>,
    /// What it found, once it is over; and the scenario with that.
    found: Option<Result<(FitOutcome, Option<Scenario>), FitFault>>,
}

impl BegunFit {
    /// Takes what was found, once it is there.
    fn refresh(&mut self) {
        if self.found.is_some() || !self.work.is_over() {
            return;
        }
        let partial = self.work.partial();
        let Some(found) = &*partial else { return };
        self.found = Some((**found).clone().map(|outcome| {
            let mut next = self.scenario.clone();
            let settings = outcome.settings.as_ref().ok();
            let taken = settings.is_some_and(|settings| next.set_all(settings).is_ok());
            (outcome, taken.then_some(next))
        }));
    }

    /// Whether file, fit, channels, options and cut are still those of it; the cut may have what was found.
    fn is_of(&self, form: &FitForm, scenario: &Scenario) -> bool {
        let taken = match &self.found {
            Some(Ok((_, Some(taken)))) => taken == scenario,
            Some(Ok((_, None)) | Err(_)) | None => false,
        };
        self.form == *form && (self.scenario == *scenario || taken)
    }
}

/// The part of the screen.
#[derive(Default)]
pub struct FitView {
    form: FitForm,
    layout: LayoutFields,
    /// What a field that was typed in has to say.
    said: Option<String>,
    begun: Option<BegunFit>,
    sample: Option<Work<SingleTask<Result<String, String>>>>,
    /// Why there are no sample data.
    no_sample: Option<String>,
}

impl FitView {
    /// Takes a file that was opened or dropped.
    pub fn take(&mut self, file: &MeasuredFile) {
        self.form.take(file);
        (self.layout, self.said, self.no_sample) = (LayoutFields::default(), None, None);
        self.sample = None;
    }

    /// Another language is spoken from now on.
    pub fn tell_anew(&mut self) {
        if let Some(begun) = &mut self.begun {
            begun.work.change(MeasuredFitJob::tell_anew);
            begun.found = None;
        }
        (self.said, self.no_sample) = (None, None);
    }

    /// Takes what was worked out meanwhile.
    pub fn refresh(&mut self) {
        if let Some(begun) = &mut self.begun {
            begun.refresh();
        }
        let Some(work) = self.sample.take_if(|work| work.is_over()) else { return };
        match &*work.partial() {
            Some(Ok(text)) => {
                let name = format!("sample-{}.csv", self.form.kind.id());
                let bytes = text.as_bytes().into();
                self.take(&MeasuredFile::read(name, bytes, DataLayout::default()));
            }
            Some(Err(why)) => self.no_sample = Some(why.clone()),
            None => {}
        }
    }

    fn begin_sample(&mut self, scenario: &Scenario, jobs: &Jobs) {
        let (kind, scenario) = (self.form.kind, scenario.clone());
        let seed = scenario.run.seed;
        let task = SingleTask::new(move || kind.sample(&scenario, seed));
        self.no_sample = None;
        self.sample = Some(jobs.begin_brief(tr(SAMPLE), task, 1));
    }

    fn begin(&mut self, view: &View<'_>) {
        let scenario = view.session.scenario().clone();
        let request = self.form.request(scenario.clone(), view.session.edits().clone());
        let Some(request) = request else { return };
        let job = MeasuredFitJob::new(self.form.kind, request);
        let work = view.jobs.begin(tr(WORK), job, 1);
        self.begun = Some(BegunFit { form: self.form.clone(), scenario, work, found: None });
    }

    /// What is fitted, to which data.
    pub fn controls(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        choose::kinds(ui, &mut self.form);
        ui.add_space(6.0);
        ui.label(RichText::new(tr("Measured data")).strong());
        if choose::file(ui, &self.form, self.sample.is_some(), commands) {
            self.begin_sample(view.session.scenario(), view.jobs);
        }
        if let Some(why) = &self.no_sample {
            let text = tr!("No sample data: {why}", why = why);
            Standing::Watch.label(ui, &text, |text| text);
        }
        let Some(file) = self.form.file.clone() else { return };
        if let Err(fault) = file.contents() {
            Standing::Bad.label(ui, &format!("{}: {fault}", file.name), |text| text);
        }
        self.layout.table = !self.form.kind.about().timed;
        if let Some(again) = self.layout.show(ui, &file, &mut self.said, commands) {
            self.form.read_again(&again);
        }
        if let Some(said) = &self.said {
            Standing::Watch.label(ui, said, |text| text);
        }
        if file.contents().is_err() {
            return;
        }
        ui.add_space(6.0);
        let fault = self.fault(view);
        fields::show(ui, &mut self.form, view.session.scenario(), fault.as_ref());
    }

    /// What is missing now, or else what the last fit had to say of what is asked still.
    fn fault(&self, view: &View<'_>) -> Option<FitFault> {
        let scenario = view.session.scenario();
        let missing = self.form.lacks(scenario);
        missing.or_else(|| match &self.begun {
            Some(begun) if begun.is_of(&self.form, scenario) => match &begun.found {
                Some(Err(fault)) => Some(fault.clone()),
                Some(Ok(_)) | None => None,
            },
            Some(_) | None => None,
        })
    }

    /// The fit, and what it found.
    pub fn page(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        if self.form.file.is_none() && self.begun.is_none() {
            return empty(ui);
        }
        self.transport(ui, view);
        let scenario = view.session.scenario();
        // What another fit has found is there again with that.
        let begun = self.begun.as_ref().filter(|begun| begun.form.kind == self.form.kind);
        let Some(begun) = begun else { return needs(ui, self.form.kind) };
        if !begun.is_of(&self.form, scenario) {
            let text = tr(
                "Data, options or the cut were changed since: what stands here is of before. Fit asks anew.",
            );
            Standing::Watch.label(ui, text, |text| text);
        }
        match &begun.found {
            Some(Ok((outcome, taken))) => {
                // As the scenario has the settings once it has taken them.
                let stands = taken.as_ref().is_some_and(|taken| {
                    let settings = outcome.settings.as_deref().unwrap_or_default();
                    settings.iter().all(|(path, _)| taken.get(path) == scenario.get(path))
                });
                found::show(ui, &begun.form, outcome, stands, commands);
            }
            Some(Err(fault)) => {
                let text = match &begun.form.file {
                    Some(file) => fault.of_file(&file.name),
                    None => fault.to_string(),
                };
                Standing::Bad.label(ui, &text, |text| text);
                needs(ui, begun.form.kind);
            }
            None => {}
        }
    }

    /// Begin and stop; how far it is.
    fn transport(&mut self, ui: &mut Ui, view: &View<'_>) {
        let missing = match &self.form.file {
            Some(file) if file.contents().is_ok() => self.form.lacks(view.session.scenario()),
            Some(_) | None => Some(FitFault::from(tr("Open a file first.").to_owned())),
        };
        let running = self.begun.as_ref().is_some_and(|begun| begun.work.is_running());
        let mut stop = false;
        ui.horizontal_wrapped(|ui| {
            if running {
                let button = Button::new(tr("Stop the fit")).min_size(touch::least(ui));
                stop = ui.add(button).on_hover_text(tr("Gives this fit up")).clicked();
            } else {
                let button = Button::new(tr("Fit")).min_size(touch::least(ui));
                let help =
                    tr("Fits the model to the data; it goes on while other screens are shown");
                if ui.add_enabled(missing.is_none(), button).on_hover_text(help).clicked() {
                    self.begin(view);
                }
            }
            if let Some(begun) = self.begun.as_ref().filter(|_| running) {
                let progress = begun.work.progress();
                ui.scope(|ui| {
                    ui.visuals_mut().extreme_bg_color = Palette::at(ui).line;
                    let bar = ProgressBar::new(progress.share() as f32);
                    ui.add(bar.desired_width(140.0).desired_height(10.0));
                });
            }
        });
        if stop {
            self.begun = None;
        }
        if let Some(missing) = missing.filter(|_| !running) {
            let name = missing.option.and_then(|option| choose::name(self.form.kind, option));
            let text = match name {
                Some(name) => format!("{name}: {missing}"),
                None => missing.to_string(),
            };
            Standing::Watch.label(ui, &text, |text| text);
        }
    }
}

/// What to do where nothing was opened yet.
fn empty(ui: &mut Ui) {
    let palette = Palette::at(ui);
    ui.add_space(4.0);
    theme::card(palette).show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.label(RichText::new(tr("No measured data yet")).strong());
        ui.label(tr(
            "Choose what is to be fitted, open a recording or drop it here, and say which channel is which; then press \
             Fit. Values with their 95 % intervals, what is left and what the data cannot tell apart are shown before \
             anything is taken into the scenario or saved.",
        ));
    });
    for kind in MeasuredFitKind::ALL.iter().copied() {
        ui.add_space(4.0);
        theme::card(palette).show(ui, |ui| {
            ui.set_width(ui.available_width());
            let about = kind.about();
            ui.label(RichText::new(tr(about.title)).strong());
            ui.label(format::typeset(tr(about.finds)));
            needs(ui, kind);
        });
    }
}

/// What has to be recorded for a fit, and the commands that make sample data and fit them.
fn needs(ui: &mut Ui, kind: MeasuredFitKind) {
    let about = kind.about();
    let weak = Palette::at(ui).weak;
    ui.add(Label::new(RichText::new(format::typeset(tr(about.needs))).color(weak)).wrap());
    let text = tr!(
        "Sample data: {sample}. On the command line: steadycut identify {id}.",
        sample = about.sample,
        id = kind.id()
    );
    ui.add(Label::new(RichText::new(text).small().color(weak)).wrap());
}
