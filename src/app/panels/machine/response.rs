//! The frequency response between tooth and work, of the tooth and of the work, with a cursor, the
//! modes, and the harmonics of the passing teeth.

use egui::{RichText, Role, Sense, Slider, Ui, WidgetInfo};
use egui_plot::MarkerShape;

use super::motion::amplitude;
use super::plot::{Figure, Marks, PlotCurve};
use super::state::MachineState;
use crate::app::format;
use crate::app::theme::{self, Look, Palette};
use crate::app::widgets::focus::pointer_only;
use crate::app::widgets::legend;
use crate::app::widgets::plot::decades_of;
use crate::app::widgets::touch;
use crate::app::widgets::zoom::by_touch;
use crate::base::language::{fixed, text, tr};
use crate::base::math::{TAU, acos};
use crate::models::structure::Complex;
use crate::models::structure::frf::{FrequencyResponse, LAST_HZ, tree};

/// Micrometres per kilonewton in a metre per newton.
const UM_KN: f64 = 1e9;
/// Shortest range of frequencies that is offered, Hz: all modes but the tooth's.
const NEAR_HZ: f64 = 600.0;
/// Decades of the vertical axis at most.
const DECADES: f64 = 5.0;
/// Height of the phase, as a fraction of the whole.
const PHASE_FRACTION: f32 = 0.32;

type Part = fn(&FrequencyResponse) -> Complex;

/// The responses that can be shown.
const PARTS: [(&str, Look, Part); 3] = [
    (text!("|G_rel| tooth to work"), Look::Produced, |r| r.grel),
    (text!("|H33| tooth"), Look::Command, |r| r.h33),
    (text!("|Hww| work"), Look::Reference, |r| r.hww),
];

/// See the head of this file.
pub struct ResponseView {
    hidden: [bool; PARTS.len()],
    phase: bool,
    near: bool,
    /// Where the cursor stands, Hz.
    pub cursor_hz: f64,
}

impl Default for ResponseView {
    fn default() -> Self {
        Self { hidden: [false, false, true], phase: false, near: false, cursor_hz: 110.0 }
    }
}

impl ResponseView {
    /// Draws all of it, `height` points high; `true` when the cursor was moved.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        machine: &MachineState,
        tooth_hz: f64,
        height: f32,
    ) -> bool {
        let top = ui.cursor().top();
        self.legend(ui);
        let mut moved = self.cursor(ui, machine);
        let last_hz = if self.near { NEAR_HZ } else { f64::from(LAST_HZ) };
        let height = (height - (ui.cursor().top() - top)).max(theme::PLOT_HEIGHT_MIN);
        let phase_height = if self.phase { PHASE_FRACTION * height } else { 0.0 };
        let sizes = self.sizes(ui, machine, tooth_hz, last_hz);
        // Fingers that drag scroll the page; a tap sets the cursor.
        let sense = pointer_only(!by_touch(ui));
        let plot = sizes.show(ui, height - phase_height, sense);
        let pointed = plot.response.clicked() || plot.response.dragged();
        if let Some(at) = plot.response.interact_pointer_pos().filter(|_| pointed) {
            let f_hz = plot.transform.value_from_position(at).x;
            self.cursor_hz = f_hz.clamp(0.0, last_hz);
            moved = true;
        }
        if self.phase {
            self.phases(machine, last_hz).show(ui, phase_height, Sense::hover());
        }
        moved
    }

    fn legend(&mut self, ui: &mut Ui) {
        ui.scope(|ui| {
            ui.spacing_mut().interact_size.y = 14.0;
            legend::row(ui, text!("the frequency response"), |ui| {
                let title = tr!("Frequency response [{unit}]", unit = format::unit("um/kN"));
                ui.label(RichText::new(title).strong());
                for (i, (name, look, _)) in PARTS.iter().enumerate() {
                    if legend::entry(ui, tr(name), *look, self.hidden[i]).pressed {
                        self.hidden[i] = !self.hidden[i];
                    }
                }
                legend::sample(ui, tr("modes"), Look::Limit);
                let color = Palette::at(ui).warn;
                legend::points(ui, tr("passing teeth"), color, MarkerShape::Up);
            });
        });
    }

    /// The slider of the cursor, what is read there, and what is in the picture.
    fn cursor(&mut self, ui: &mut Ui, machine: &MachineState) -> bool {
        let mut moved = false;
        ui.horizontal_wrapped(|ui| {
            let last_hz = if self.near { NEAR_HZ } else { f64::from(LAST_HZ) };
            ui.spacing_mut().slider_width = 130.0;
            let before = self.cursor_hz;
            let slider = Slider::new(&mut self.cursor_hz, 0.0..=last_hz)
                .step_by(1.0)
                .max_decimals(1)
                .suffix(" Hz");
            let response = ui.add(slider);
            touch::only_across(ui, &response, &mut self.cursor_hz, before);
            let name = tr("Cursor frequency");
            response.widget_info(|| WidgetInfo::slider(true, self.cursor_hz, name));
            moved = response.changed();
            let help = tr("The cursor: drag it here or in the plot, or use the arrow keys");
            response.on_hover_text(help);
            ui.selectable_value(&mut self.near, false, tr("to 3000 Hz"));
            ui.selectable_value(&mut self.near, true, tr("to 600 Hz"));
            ui.checkbox(&mut self.phase, tr("Phase"));
        });
        let here = tree(&machine.model, self.cursor_hz);
        let read = |(name, _, part): &(&str, Look, Part)| {
            let z = part(&here);
            let size = format::fine(UM_KN * amplitude(z), "um/kN");
            let name = name.split(' ').next().unwrap_or_default();
            format!("{name} {size}, {}°", fixed(degrees(z), 1))
        };
        let shown = PARTS.iter().enumerate().filter(|(i, _)| !self.hidden[*i]);
        let said = shown.map(|(_, part)| read(part)).collect::<Vec<String>>().join("; ");
        let at = format::fine(self.cursor_hz, "Hz");
        let text = tr!("At {at}: {said}", at = at, said = said);
        let label = ui.label(RichText::new(&text).color(Palette::at(ui).weak));
        label.widget_info(|| WidgetInfo::labeled(Role::Label, true, text.clone()));
        moved
    }

    fn sizes(&self, ui: &Ui, machine: &MachineState, tooth_hz: f64, last_hz: f64) -> Figure {
        let palette = Palette::at(ui);
        let mut figure = Figure::new(text!("Response"), ["Hz", "um/kN"], [0.0, last_hz]);
        let shown = PARTS.iter().enumerate().filter(|(i, _)| !self.hidden[*i]);
        // The first stands in front.
        let curves = shown.rev().map(|(_, (name, look, part))| {
            let points = machine.sweep.iter().map(|r| [r.f_hz, UM_KN * amplitude(part(r))]);
            PlotCurve { name, look: *look, points: points.collect() }
        });
        figure.curves = curves.collect();
        let values = figure.curves.iter().flat_map(|curve| &curve.points).map(|point| point[1]);
        (figure.up, figure.logarithmic) = (decades_of(values, DECADES), true);
        for (i, mode) in machine.modes.iter().enumerate() {
            let f_hz = mode.free.frequency_hz;
            let at = format::fine(f_hz, "Hz");
            let name = tr!("mode {number}, {at}", number = i + 1, at = at);
            figure.posts.push((name, Look::Limit, f_hz));
            if f_hz < last_hz {
                figure.tags.push((f_hz, (i + 1).to_string()));
            }
        }
        figure.posts.push((tr("cursor").to_owned(), Look::Setpoint, self.cursor_hz));
        if tooth_hz > 0.0 {
            let harmonics = (1..).map(|k| f64::from(k) * tooth_hz);
            let floor = figure.up[0] * 1.12;
            let at = harmonics.take_while(|f_hz| *f_hz <= last_hz).map(|f_hz| [f_hz, floor]);
            figure.marks.push(Marks {
                name: text!("passing teeth"),
                at: at.collect(),
                shape: MarkerShape::Up,
                color: palette.warn,
                radius: 3.5,
            });
        }
        figure
    }

    fn phases(&self, machine: &MachineState, last_hz: f64) -> Figure {
        let mut figure = Figure::new(text!("Phase"), ["Hz", "deg"], [0.0, last_hz]);
        let shown = PARTS.iter().enumerate().filter(|(i, _)| !self.hidden[*i]);
        let curves = shown.rev().map(|(_, (name, look, part))| {
            let points = machine.sweep.iter().map(|r| [r.f_hz, degrees(part(r))]);
            PlotCurve { name, look: *look, points: points.collect() }
        });
        figure.curves = curves.collect();
        figure.up = [-190.0, 20.0];
        figure.posts.push((tr("cursor").to_owned(), Look::Setpoint, self.cursor_hz));
        figure
    }
}

/// The phase in degrees, -180 to 180.
fn degrees(z: Complex) -> f64 {
    let size = amplitude(z);
    if size == 0.0 {
        return 0.0;
    }
    let angle = acos((z.re / size).clamp(-1.0, 1.0)) * 360.0 / TAU;
    if z.im < 0.0 { -angle } else { angle }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::structure::MachineSettings;

    #[test]
    fn phases_are_those_of_the_plane() {
        let of = |re, im| degrees(Complex::new(re, im));
        assert_eq!([of(1.0, 0.0), of(0.0, 0.0), of(-1.0, 0.0)], [0.0, 0.0, 180.0]);
        assert!((of(0.0, -2.0) + 90.0).abs() < 1e-12 && (of(1.0, 1.0) - 45.0).abs() < 1e-9);
    }

    #[test]
    fn driving_points_take_power_at_every_frequency() {
        // Their imaginary part is never positive: the phase lies in the plot.
        let machine = MachineState::new(&MachineSettings::default());
        for response in &machine.sweep {
            for (name, _, part) in PARTS {
                let phase = degrees(part(response));
                assert!((-180.0..=0.0).contains(&phase), "{name} {}", response.f_hz);
            }
        }
    }
}
