//! What stands beside the picture: the line in numbers, the cut-offs, the figures and the profile.

use egui::{RichText, Ui};

use super::super::profile_chart;
use super::Profilometer;
use crate::app::command::Command;
use crate::app::format;
use crate::app::panels::View;
use crate::app::theme::{self, Palette};
use crate::app::widgets::number::NumberField;
use crate::app::widgets::setting::{Size, setting};
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::tr;
use crate::study::profilometer::{Measurement, ProfileLine};
use crate::study::uses::Screen;

/// Ranges of the fields of x and y: any machine, the ball.
const FIELDS: [[f64; 2]; 2] = [[-100.0, 100_000.0], [-8.0, 8.0]];

impl Profilometer {
    /// Line, figures and profile.
    pub fn show(&mut self, ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        ui.horizontal_wrapped(|ui| {
            ui.label(tr("A drag"));
            ui.radio_value(&mut self.turns, false, tr("draws the line"));
            ui.radio_value(&mut self.turns, true, tr("turns the part"));
        });
        let Some(line) = self.shown else {
            ui.label(tr("No tooth has been in this cut yet: there is no surface to measure."));
            return;
        };
        self.ends(ui, line, commands);
        let scenario = view.session.current();
        setting(ui, Screen::Workpiece, "profile.long_mm", scenario, Size::Small, commands);
        setting(ui, Screen::Workpiece, "profile.short_um", scenario, Size::Small, commands);
        match self.found.as_ref().map(|found| &found.result) {
            Some(Ok((found, curves))) => {
                figures(ui, found, scenario.profile.long_mm);
                profile_chart::show(ui, curves);
            }
            Some(Err(error)) => {
                Standing::Bad.label(ui, &format::unit(&format::sentence(error)), |text| text);
            }
            None => {}
        }
    }

    /// The ends of the line as numbers.
    fn ends(&mut self, ui: &mut Ui, line: ProfileLine, commands: &mut Vec<Command>) {
        let mut ends = [line.from_mm, line.to_mm];
        let mut said = None;
        touch::grid(ui, "line").num_columns(4).show(ui, |ui| {
            let all = [[tr("From x"), tr("From y")], [tr("To x"), tr("To y")]];
            for (names, end) in all.into_iter().zip(&mut ends) {
                for (name, (value, range)) in names.into_iter().zip(end.iter_mut().zip(FIELDS)) {
                    let label = ui.label(name);
                    let field = NumberField {
                        name,
                        unit: "mm",
                        range,
                        speed: 0.02,
                        decimals: 3,
                        least: 0,
                        suffix: " mm",
                    };
                    field.show(ui, value, &mut said).labelled_by(label.id);
                }
                ui.end_row();
            }
        });
        commands.extend(said.map(Command::notify));
        let edited = ProfileLine { from_mm: ends[0], to_mm: ends[1] };
        if edited != line {
            self.own = Some(edited);
            ui.request_repaint();
        }
        ui.horizontal_wrapped(|ui| {
            let help = tr("Five sampling lengths along the feed, as the tool goes on");
            let button = egui::Button::selectable(self.own.is_none(), tr("Behind the tool"));
            if ui.add(button).on_hover_text(help).clicked() {
                self.own = None;
                ui.request_repaint();
            }
            let length = format::quantity(line.length_mm(), "mm");
            ui.label(tr!("{length} long", length = length));
        });
    }
}

/// Ra, Rq, Rz and what they were taken of.
fn figures(ui: &mut Ui, found: &Measurement, long_mm: f64) {
    let palette = Palette::at(ui);
    let roughness = &found.roughness;
    ui.horizontal_wrapped(|ui| {
        for (name, value) in
            [("Ra", roughness.ra_um), ("Rq", roughness.rq_um), ("Rz", roughness.rz_um)]
        {
            let text = format!("{name} {}", format::quantity(value, "um"));
            ui.label(RichText::new(text).text_style(theme::value()).strong());
            ui.add_space(6.0);
        }
    });
    let long = format::fine(long_mm, "mm");
    let lengths = match found.lengths {
        1 => tr!("Over one sampling length of {long}; the standard takes five.", long = long),
        n if n < 5 => {
            tr!("Over {n} sampling lengths of {long}; the standard takes five.", n = n, long = long,)
        }
        n => tr!("Over {n} sampling lengths of {long}.", n = n, long = long),
    };
    let run = match found.run_ra_um {
        Some(ra_um) => {
            let ra = format::quantity(ra_um, "um");
            tr!("The run's Ra with dynamics is {ra} along the line on average.", ra = ra)
        }
        None => tr("Simulated tooth by tooth, K5 gives no Ra here: feed marks and run-out alone.")
            .to_owned(),
    };
    ui.label(RichText::new(format!("{lengths} {run}")).small().color(palette.weak));
}
