//! The tool's life: wear, sound and roughness at a fraction of it, the sound's spectrum, the trends
//! side by side, and the life predicted from the sound.

use egui::{ProgressBar, RichText, Role, Sense, Slider, Ui, WidgetInfo};
use egui_plot::MarkerShape;

use super::life::{Life, LifeInCut};
use super::plot::{Figure, Marks, PlotCurve, range_of};
use crate::app::format;
use crate::app::session::Session;
use crate::app::theme::{self, Look, Palette};
use crate::app::widgets::plot::decades_of;
use crate::app::widgets::touch;
use crate::base::language::{fixed, text, tr};
use crate::base::math::extent;
use crate::models::machine_trend::{TrendLine, TrendPoint};
use crate::models::wear::WearModel;
use crate::study::machine_life::CLAIMS;
use crate::study::machine_life::tool_condition::ConditionEstimate;

/// From this width on, points, two plots stand beside each other.
const BESIDE_FROM: f32 = 620.0;
/// Points of a curve.
const DRAWN: usize = 240;
/// Decades of the spectrum's axis at most.
const DECADES: f64 = 4.0;
/// Room for the words below the plots, points.
const WORDS: f32 = 76.0;

/// See the head of this file.
pub struct WearView {
    /// Fraction of the tool's life that is drawn and sounded.
    pub x: f64,
    /// Whether it is that of the cut, where the tool wears in it.
    follows: bool,
    /// Whether the speed of the predicted tool is adjusted.
    pub adjusts: bool,
    /// Whether the life of the tool in the cut is predicted, where it can be.
    of_cut: bool,
}

impl Default for WearView {
    fn default() -> Self {
        Self { x: 0.5, follows: true, adjusts: false, of_cut: true }
    }
}

impl WearView {
    /// Takes over the used life of the tool in the cut; none where it does not
    /// wear.
    pub fn follow(&mut self, used_life: Option<f64>) {
        if let Some(used_life) = used_life.filter(|_| self.follows) {
            self.x = used_life.clamp(0.0, 1.0);
        }
    }

    /// Draws all of it; in a narrow window one plot below the other.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        life: &Life,
        (in_cut, session): (&LifeInCut, &Session),
        seen_height: f32,
    ) {
        let now = life.model().at(self.x);
        let top = ui.cursor().top();
        self.slider(ui, &now, life);
        let used = ui.cursor().top() - top;
        if ui.available_width() < BESIDE_FROM {
            let height = theme::PLOT_HEIGHT_SCROLLED;
            spectrum(ui, life, self.x, height);
            self.wear(ui, life, &now, height);
            trends(ui, life, self.x, height);
            self.prediction(ui, life, (in_cut, session), height);
        } else {
            let height = (0.5 * (seen_height - used - WORDS)).max(theme::PLOT_HEIGHT_MIN + 30.0);
            ui.columns_const(|[left, right]| {
                spectrum(left, life, self.x, height);
                self.wear(right, life, &now, height);
            });
            ui.columns_const(|[left, right]| {
                trends(left, life, self.x, height);
                self.prediction(right, life, (in_cut, session), height);
            });
        }
        words(ui, life);
    }

    /// The slider of the life, and what is so far.
    fn slider(&mut self, ui: &mut Ui, now: &TrendPoint, life: &Life) {
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().slider_width = 160.0;
            ui.label(RichText::new(tr("Tool life used")).strong());
            // The slider rounds what it is given.
            let mut x = (100.0 * self.x).round() / 100.0;
            let before = x;
            let response = ui.add(Slider::new(&mut x, 0.0..=1.0).step_by(0.01).fixed_decimals(2));
            touch::only_across(ui, &response, &mut x, before);
            response.widget_info(|| WidgetInfo::slider(true, x, tr("Share of the tool's life")));
            if response.changed() && x != before {
                (self.x, self.follows) = (x, false);
            }
            response.on_hover_text(tr("Fraction τ/T of the tool's life that is drawn and sounded"));
            if life.model().wear.model == WearModel::Life {
                let help = tr("The tool of the running cut, which wears in it");
                ui.checkbox(&mut self.follows, tr("As in the cut")).on_hover_text(help);
            }
            if life.findings().is_none() {
                let bar = ProgressBar::new(life.progress() as f32).show_percentage();
                ui.add(bar.desired_width(120.0).desired_height(14.0));
            }
            if life.is_stopped() && ui.button(tr("Go on")).clicked() {
                life.go_on();
            }
        });
        let (factor, unit) = sound_unit(life);
        let text = tr!(
            "wear land {land}, force {force}, sound {sound}, Ra {ra}",
            land = format::fine(now.flank_mm, "mm"),
            force = format::quantity(now.force_n, "N"),
            sound = format::fine(factor * now.sound, unit),
            ra = format::quantity(now.ra_um, "um"),
        );
        let label = ui.label(RichText::new(&text).color(Palette::at(ui).weak));
        label.widget_info(|| WidgetInfo::labeled(Role::Label, true, text.clone()));
    }

    fn wear(&self, ui: &mut Ui, life: &Life, now: &TrendPoint, height: f32) {
        let wear = &life.model().wear;
        let mut figure = Figure::new(text!("Wear land VB"), ["", "mm"], [0.0, 1.0]);
        let points = (0..=DRAWN).map(|i| {
            let x = i as f64 / DRAWN as f64;
            [x, wear.flank_mm(wear.wear(x))]
        });
        let points = points.collect();
        let name = text!("over the fraction of life");
        figure.curves = vec![PlotCurve { name, look: Look::Produced, points }];
        figure.up = [-0.04 * wear.flank_end_mm, 1.1 * wear.flank_end_mm];
        let color = Palette::at(ui).command;
        let at = vec![[self.x, now.flank_mm]];
        let name = text!("now");
        let mark = Marks { name, at, shape: MarkerShape::Circle, color, radius: 4.5 };
        figure.marks.push(mark);
        draw(ui, &figure, height);
    }

    fn prediction(
        &mut self,
        ui: &mut Ui,
        life: &Life,
        (in_cut, session): (&LifeInCut, &Session),
        height: f32,
    ) {
        let top = ui.cursor().top();
        let possible = LifeInCut::possible(session.scenario());
        let of_cut = possible && self.of_cut;
        let estimates = in_cut.until(session.playback().playhead_s);
        let figure = if of_cut { prediction_in_cut(life, estimates) } else { prediction(life) };
        figure.legend(ui);
        ui.horizontal_wrapped(|ui| {
            if possible {
                let help = tr("The tool of the running cut, by the sound of the vibrating machine");
                ui.checkbox(&mut self.of_cut, tr("In the cut")).on_hover_text(help);
            }
            if of_cut {
                let said = match (estimates.last(), &in_cut.problem) {
                    (_, Some(problem)) => problem.clone(),
                    (Some(last), None) => {
                        let remaining = format::quantity(last.prediction.remaining_min(), "min");
                        if last.prediction.alarm {
                            tr!(
                                "{remaining} left at the programmed cut, worn out by its sound",
                                remaining = remaining,
                            )
                        } else {
                            tr!("{remaining} left at the programmed cut", remaining = remaining)
                        }
                    }
                    (None, None) if in_cut.is_ready() => tr("no estimate yet").to_owned(),
                    (None, None) => tr("estimated once the cut is simulated").to_owned(),
                };
                ui.label(RichText::new(said).small().color(Palette::at(ui).weak));
                return;
            }
            let help =
                tr("Every ten minutes the cutting speed is set so that the tool reaches the \
                           desired tool life, as far as its sound shows it");
            ui.checkbox(&mut self.adjusts, tr("Adjust the speed")).on_hover_text(help);
            let speed = life.tool.minutes.last().map_or(0.0, |minute| minute.cutting_speed_m_min);
            let speed = format::quantity(speed, "m/min");
            let text = match (life.tool_done, life.tool.end_min) {
                (_, Some(end_min)) => tr!(
                    "worn out after {time}, at last {speed}",
                    time = format::quantity(end_min, "min"),
                    speed = speed,
                ),
                (true, None) => tr!(
                    "not worn out in ten times the desired tool life, at last {speed}",
                    speed = speed,
                ),
                (false, None) => tr!(
                    "cutting: minute {minute}, at last {speed}",
                    minute = life.tool.minutes.len(),
                    speed = speed,
                ),
            };
            ui.label(RichText::new(text).small().color(Palette::at(ui).weak));
        });
        let height = height - (ui.cursor().top() - top);
        figure.show(ui, height.max(90.0), Sense::hover());
    }
}

/// Factor and unit in which the sound is written.
fn sound_unit(life: &Life) -> (f64, &'static str) {
    match life.model().life.sound_exponent {
        0 => (1e6, "um"),
        1 => (1e3, "mm/s"),
        _ => (1.0, "m/s2"),
    }
}

/// A plot with its legend, `height` points high together.
fn draw(ui: &mut Ui, figure: &Figure, height: f32) {
    let top = ui.cursor().top();
    figure.legend(ui);
    let height = height - (ui.cursor().top() - top);
    figure.show(ui, height.max(90.0), Sense::hover());
}

fn spectrum(ui: &mut Ui, life: &Life, x: f64, height: f32) {
    let (factor, unit) = sound_unit(life);
    let points = |lines: &mut dyn Iterator<Item = TrendLine>| {
        lines.map(|line| [line.f_hz, factor * line.sound]).collect::<Vec<[f64; 2]>>()
    };
    let mut figure = Figure::new(text!("Sound spectrum"), ["Hz", unit], [0.0, 3000.0]);
    let curve = |name, look, x: f64| PlotCurve {
        name,
        look,
        points: points(&mut life.model().spectrum(x)),
    };
    figure.curves = vec![
        curve(text!("sharp tool"), Look::Twin, 0.0),
        curve(text!("worn out"), Look::Limit, 1.0),
        curve(text!("now"), Look::Produced, x),
    ];
    let values = figure.curves.iter().flat_map(|curve| &curve.points).map(|point| point[1]);
    (figure.up, figure.logarithmic) = (decades_of(values, DECADES), true);
    draw(ui, &figure, height);
}

/// A quantity of the trends from 0 for the sharp tool to 1 at the end of its life.
fn share(of: fn(&TrendPoint) -> f64, life: &Life) -> impl Fn(&TrendPoint) -> f64 {
    let [first, last] = life.ends.map(|point| of(&point));
    move |point| (of(point) - first) / (last - first)
}

fn trends(ui: &mut Ui, life: &Life, x: f64, height: f32) {
    let points = &life.trends.points;
    let step = (points.len() / DRAWN).max(1);
    let curve = |name, look, of: fn(&TrendPoint) -> f64| {
        let share = share(of, life);
        let last = points.last().filter(|_| life.findings().is_some());
        let some = points.iter().step_by(step).chain(last);
        PlotCurve { name, look, points: some.map(|point| [point.x, share(point)]).collect() }
    };
    let title = text!("Trends over the life, each from 0 to 1");
    let mut figure = Figure::new(title, ["", ""], [0.0, 1.0]);
    figure.curves = vec![
        curve(text!("sound E_S"), Look::Produced, |point| point.sound),
        curve(text!("roughness Ra"), Look::Setpoint, |point| point.ra_um),
    ];
    figure.up = [-0.05, 1.08];
    figure.posts.push((tr("now").to_owned(), Look::Twin, x));
    draw(ui, &figure, height);
}

/// The predicted life over the time in cut, with its 90 % range.
fn prediction(life: &Life) -> Figure {
    let minutes = &life.tool.minutes;
    let wanted_min = life.model().life.tool_life_min;
    let predicted = minutes.iter().filter_map(|minute| {
        let (remaining, range) = (minute.remaining_min?, minute.remaining_range_min?);
        let total = |remaining_min: f64| minute.time_min + remaining_min;
        Some((minute.time_min, total(remaining), range.map(total)))
    });
    let predicted: Vec<_> = predicted.collect();
    let [_, last_min] = extent(minutes.iter().map(|minute| minute.time_min));
    let promised_min = life.model().wear.usual_life_min(&life.model().cut);
    let length_min = last_min.max(promised_min.min(10.0 * wanted_min)).max(1.0);
    let mut figure = Figure::new(text!("Predicted life"), ["min", "min"], [0.0, length_min]);
    let band = predicted.iter().map(|(time, _, [low, high])| [*time, *low, *high]);
    figure.band = Some((text!("90 % of the belief"), band.collect()));
    let points = predicted.iter().map(|(time, total, _)| [*time, *total]);
    let name = text!("from the sound");
    figure.curves = vec![PlotCurve { name, look: Look::Produced, points: points.collect() }];
    figure.levels.push((text!("desired"), Look::Reference, wanted_min));
    let known = predicted.iter().flat_map(|(_, _, range)| *range);
    let end = life.tool.end_min;
    if let Some(end_min) = end {
        figure.levels.push((text!("true"), Look::Ghost, end_min));
    }
    let [_, high] = range_of(known.chain([wanted_min, length_min]).chain(end));
    figure.up = [-0.04 * high, high];
    figure
}

/// The life predicted from the sound of the running cut, up to the playhead.
fn prediction_in_cut(life: &Life, estimates: &[ConditionEstimate]) -> Figure {
    let wanted_min = life.model().life.tool_life_min;
    let promised_min = life.model().wear.usual_life_min(&life.model().cut);
    let [_, last_min] = extent(estimates.iter().map(|estimate| estimate.prediction.age_min));
    let length_min = last_min.max(promised_min).max(1.0);
    let mut figure = Figure::new(text!("Predicted life"), ["min", "min"], [0.0, length_min]);
    let band = estimates.iter().map(|estimate| {
        let [low, high] = estimate.prediction.life_range_min;
        [estimate.prediction.age_min, low, high]
    });
    figure.band = Some((text!("90 % of the belief"), band.collect()));
    let points = estimates
        .iter()
        .map(|estimate| [estimate.prediction.age_min, estimate.prediction.life_min]);
    let name = text!("from the sound");
    figure.curves = vec![PlotCurve { name, look: Look::Produced, points: points.collect() }];
    figure.levels.push((text!("desired"), Look::Reference, wanted_min));
    // What really is: the age over the fraction of the life used so far.
    let worn = estimates.last().filter(|estimate| estimate.used_life > 0.0);
    if let Some(worn) = worn {
        figure.levels.push((text!("true"), Look::Ghost, worn.prediction.age_min / worn.used_life));
    }
    let known = estimates.iter().map(|estimate| estimate.prediction.life_range_min[1]);
    let [_, high] = range_of(known.chain([wanted_min, length_min]));
    figure.up = [-0.04 * high, high];
    figure
}

/// What the trends show beside what the paper says.
fn words(ui: &mut Ui, life: &Life) {
    let palette = Palette::at(ui);
    let r = |value: Option<f64>| value.map_or(tr("none").to_owned(), |r| fixed(r, 4));
    let Some(findings) = life.findings() else {
        ui.label(RichText::new(tr("The equations are being solved for every second.")).small());
        return;
    };
    let [trend_r, spectrum_r] = life.measured_r().map(r);
    let found = [
        tr!(
            "Here: found R = {r}, largest difference {difference:.3}.",
            r = r(findings.sound_roughness_r),
            difference = findings.largest_difference,
        ),
        tr!("Here: with the noise of the settings R = {r}.", r = trend_r),
        tr!("Here: with the noise of the settings R = {r}.", r = spectrum_r),
    ];
    ui.scope(|ui| {
        ui.spacing_mut().interact_size.y = 14.0;
        for (claim, found) in CLAIMS.iter().zip(found) {
            ui.horizontal_wrapped(|ui| {
                ui.spacing_mut().item_spacing.x = 4.0;
                let claim = tr!("The paper: {claim}.", claim = tr(claim));
                ui.label(RichText::new(claim).small().color(palette.weak));
                ui.label(RichText::new(found).small());
            });
        }
    });
}
