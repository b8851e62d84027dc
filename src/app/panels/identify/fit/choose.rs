//! Which fit, and of which file.

use egui::{Button, RichText, Role, Ui, WidgetInfo};

use super::form::FitForm;
use crate::app::command::{Command, FileCommand};
use crate::app::format;
use crate::app::theme::Palette;
use crate::app::widgets::touch;
use crate::base::language::tr;
use crate::study::identify::fits::MeasuredFitKind;

/// The fits to choose from.
pub fn kinds(ui: &mut Ui, form: &mut FitForm) {
    ui.label(RichText::new(tr("What is fitted")).strong());
    ui.horizontal_wrapped(|ui| {
        for kind in MeasuredFitKind::ALL.iter().copied() {
            let is = form.kind == kind;
            let title = tr(kind.about().title);
            let response = touch::choice(ui, is, title);
            let label = tr!("Fitted: {what}", what = title);
            response.widget_info(|| WidgetInfo::selected(Role::Button, true, is, label.clone()));
            if response.on_hover_text(tr(kind.about().finds)).clicked() {
                form.choose(kind);
            }
        }
    });
    let about = RichText::new(format::typeset(tr(form.kind.about().finds))).small();
    ui.label(about.color(Palette::at(ui).weak));
}

/// Opens a file; `true` where sample data are asked for.
pub fn file(ui: &mut Ui, form: &FitForm, making: bool, commands: &mut Vec<Command>) -> bool {
    let mut sample = false;
    ui.horizontal_wrapped(|ui| {
        let open = Button::new(tr("Open a recording\u{2026}")).min_size(touch::least(ui));
        let help = tr("Text of any layout, MATLAB, HDF5, TDMS or Parquet; it can also be dropped here");
        if ui.add(open).on_hover_text(help).clicked() {
            commands.push(Command::File(FileCommand::OpenFit));
        }
        let button = Button::new(tr("Try with sample data")).min_size(touch::least(ui));
        let help = tr(
            "Simulates the recording that the present scenario would give, with noise by its seed: what comes out of the fit \
             can be compared with what went in",
        );
        sample = ui.add_enabled(!making, button).on_hover_text(help).clicked();
    });
    if form.file.is_none() {
        let text = tr("None yet.");
        ui.label(RichText::new(text).small().color(Palette::at(ui).weak));
    }
    sample
}

/// The name of a role or option by its option on the command line.
pub fn name(kind: MeasuredFitKind, option: &str) -> Option<&'static str> {
    let about = kind.about();
    let role = about.roles.iter().find(|role| role.option == option).map(|role| role.label);
    let option = || about.options.iter().find(|of| of.option == option).map(|of| of.label);
    role.or_else(option).map(tr)
}
