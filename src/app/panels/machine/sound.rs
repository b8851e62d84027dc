//! The sound of the cut: off until it is switched on, and silent while nothing is cut.

use egui::{RichText, Slider, Ui, WidgetInfo};

use crate::app::session::Session;
use crate::app::speaker::Speaker;
use crate::app::theme::Palette;
use crate::app::widgets::icon::{self, Icon};
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::tr;
use crate::base::units::rev_s_from_rpm;
use crate::models::machine_trend::MachineTrend;
use crate::run::signals::flag;
use crate::study::machine_life::model;
use crate::study::sound::{CutSound, SAMPLES};

/// Least time from one block to the next, s: one costs some ten milliseconds, and fades in.
const CHANGE_EVERY_S: f64 = 0.25;

/// Steps in the share of the tool's life from one block to the next.
const X_STEPS: f64 = 50.0;
/// The same in the force.
const LOAD_STEPS: f64 = 12.0;

/// What a block of samples depends on.
#[derive(Clone, Debug, PartialEq)]
struct Key {
    model: MachineTrend,
    /// Line of the block on which the spindle turns.
    spindle_line: u64,
    /// Fraction of the tool's life.
    x: f64,
    /// Force as a fraction of the one at which the model's own level is heard.
    load: f64,
}

/// See the head of this file.
pub struct SoundControl {
    on: bool,
    volume: f32,
    speaker: Option<Speaker>,
    /// What sounds; none for silence.
    sounding: Option<Key>,
    made: Option<CutSound>,
    since_change_s: f64,
    problem: Option<String>,
}

impl Default for SoundControl {
    fn default() -> Self {
        Self {
            on: false,
            volume: 0.4,
            speaker: None,
            sounding: None,
            made: None,
            since_change_s: f64::INFINITY,
            problem: None,
        }
    }
}

impl SoundControl {
    /// The switch and the volume, and what stands in the way.
    pub fn show(&mut self, ui: &mut Ui, playing: bool) {
        let palette = Palette::at(ui);
        let help =
            tr("The sound of the cut as the model gives it: passing teeth and random force at \
                       this speed, louder with wear. It sounds while the cut plays.");
        let sign = if self.on { Icon::Sound } else { Icon::Silence };
        let name = tr("Sound of the cut");
        let response = icon::button(ui, sign, name, help, true);
        response.widget_info(|| WidgetInfo::selected(egui::Role::Button, true, self.on, name));
        ui.label(if self.on { tr("Sound on") } else { tr("Sound off") });
        if response.clicked() {
            self.switch();
        }
        ui.spacing_mut().slider_width = 90.0;
        let before = self.volume;
        let slider = Slider::new(&mut self.volume, 0.0..=1.0).show_value(false).step_by(0.05);
        let slider = ui.add_enabled(self.on, slider);
        touch::only_across(ui, &slider, &mut self.volume, before);
        slider.widget_info(|| WidgetInfo::slider(self.on, f64::from(self.volume), tr("Volume")));
        slider.on_hover_text(tr("Volume"));
        if let Some(problem) = &self.problem {
            let text = tr!("No sound: {problem}.", problem = problem.trim_end_matches('.'));
            Standing::Watch.label(ui, &text, |text| text);
        } else if self.on && !playing {
            let text = tr("silent while the cut is paused");
            ui.label(RichText::new(text).small().color(palette.weak));
        }
    }

    fn switch(&mut self) {
        self.on = !self.on;
        self.problem = None;
        if !self.on {
            self.stop();
            return;
        }
        match Speaker::open() {
            Ok(speaker) => self.speaker = Some(speaker),
            Err(problem) => (self.on, self.problem) = (false, Some(problem)),
        }
    }

    /// Closes the loudspeaker; what was on stays on for the way back.
    pub fn stop(&mut self) {
        (self.speaker, self.sounding) = (None, None);
        self.since_change_s = f64::INFINITY;
    }

    /// Lets the loudspeaker play what the cut at the playhead sounds like at the fraction `x` of the
    /// tool's life, under a force as a fraction of the one at
    /// which the model's own level is heard.
    pub fn advance(&mut self, session: &Session, [x, load]: [f64; 2], dt_s: f64) {
        if !self.on {
            return;
        }
        if self.speaker.is_none() {
            // Back on this screen.
            self.on = false;
            self.switch();
        }
        let Some(speaker) = &mut self.speaker else { return };
        if let Some(problem) = speaker.failure() {
            (self.on, self.problem) = (false, Some(problem));
            self.stop();
            return;
        }
        speaker.set_volume(self.volume * self.volume);
        self.since_change_s += dt_s;
        let row = session.row();
        let rate_hz = speaker.rate_hz();
        let line_hz = f64::from(rate_hz.max(1)) / SAMPLES as f64;
        // Finer steps than these are inaudible.
        let x = (x * X_STEPS).round() / X_STEPS;
        let load = (load * LOAD_STEPS).round() / LOAD_STEPS;
        let cuts = session.playback().playing && !row.has(flag::AIR) && row.spindle_rpm > 0.0;
        let wanted = cuts.then(|| Key {
            model: model(session.current()),
            spindle_line: (rev_s_from_rpm(row.spindle_rpm) / line_hz).round() as u64,
            x,
            load,
        });
        if wanted == self.sounding {
            return;
        }
        let Some(wanted) = wanted else {
            speaker.play(Vec::new());
            self.sounding = None;
            return;
        };
        if self.since_change_s < CHANGE_EVERY_S {
            return;
        }
        let before = self.sounding.as_ref();
        let same = before.is_some_and(|key| {
            key.model == wanted.model && key.spindle_line == wanted.spindle_line
        });
        let seed = u64::from(session.scenario().run.seed);
        if !same {
            self.made = None;
        }
        let made = self
            .made
            .get_or_insert_with(|| CutSound::new(&wanted.model, row.spindle_rpm, rate_hz, seed));
        speaker.play(made.block(x, load));
        (self.sounding, self.since_change_s) = (Some(wanted), 0.0);
    }
}
