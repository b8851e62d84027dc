//! The stability chart: the depth at which the cut chatters over the speed, and where the present
//! cut stands in it.

use std::sync::Arc;

use egui::{ProgressBar, RichText, Role, Sense, Ui, WidgetInfo};
use egui_plot::MarkerShape;

use super::plot::{Figure, Marks, PlotCurve};
use crate::app::command::{Command, SessionCommand};
use crate::app::format;
use crate::app::jobs::{Jobs, Work};
use crate::app::theme::{self, Look, Palette};
use crate::base::math::{extent, limit};
use crate::base::settings::Value;
use crate::blocks::cutting::workpiece::Workpiece;
use crate::models::structure::MachineSettings;
use crate::models::structure::parameters::{QUALITY_PRINTED, SPINDLE_QUALITY};
use crate::models::tool::Tool;
use crate::run::scenario::Scenario;
use crate::study::stability::StabilityCut;
use crate::study::stability::chart::{ChartJob, LobePoint, Range};
use crate::study::stability::interrupted::multiplier;

/// Speeds of the chart, 1/min, and their number.
const SPEEDS_RPM: [f64; 2] = [800.0, 4000.0];
const SPEEDS: u32 = 65;
/// Greatest depth that is looked at and the greatest that is shown, in depths that are stable at
/// every speed.
const HIGHEST: f64 = 25.0;
const SHOWN: f64 = 4.0;
/// Changes of speed and depth after which the verdict is made again, 1/min and mm.
const VERDICT_STEP: [f64; 2] = [5.0, 0.01];

/// Speed and depth of a cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Operating {
    /// Spindle speed, 1/min.
    pub speed_rpm: f64,
    /// Axial depth, mm.
    pub depth_mm: f64,
}

/// See the head of this file.
#[derive(Default)]
pub struct StabilityView {
    charted: Option<Charted>,
}

struct Charted {
    settings: (MachineSettings, Tool, Workpiece),
    /// The chart, or why there is none.
    chart: Result<Chart, String>,
    /// The cut that was judged last, with its multiplier.
    judged: Option<(Operating, f64)>,
}

/// A chart on its way.
struct Chart {
    cut: StabilityCut,
    any_speed_mm: f64,
    work: Work<ChartJob>,
    points: Arc<Vec<LobePoint>>,
}

fn begin(scenario: &Scenario, jobs: &Jobs) -> Result<Chart, String> {
    let [from_rpm, to_rpm] = SPEEDS_RPM;
    let mut range =
        Range { from_rpm, to_rpm, speeds: SPEEDS, highest_mm: f64::MAX, simulate: false };
    let of = |range| ChartJob::new(scenario, range).map_err(|error| error.to_string());
    range.highest_mm = HIGHEST * of(range)?.any_speed_mm();
    let job = of(range)?;
    let (cut, any_speed_mm) = (job.cut().clone(), job.any_speed_mm());
    let work = jobs.begin("Stability chart", job, 1);
    Ok(Chart { cut, any_speed_mm, points: work.partial(), work })
}

impl StabilityView {
    /// Keeps up with the scenario.
    pub fn follow(&mut self, scenario: &Scenario, jobs: &Jobs) {
        let settings =
            (scenario.machine.clone(), scenario.tool.clone(), scenario.workpiece.clone());
        if self.charted.as_ref().is_none_or(|charted| charted.settings != settings) {
            let chart = begin(scenario, jobs);
            self.charted = Some(Charted { settings, chart, judged: None });
        }
        if let Some(Charted { chart: Ok(chart), .. }) = &mut self.charted {
            chart.points = chart.work.partial();
        }
    }

    /// Draws all of it, `height` points high, with the verdict on the present cut.
    pub fn show(&mut self, ui: &mut Ui, now: Operating, height: f32, commands: &mut Vec<Command>) {
        let palette = Palette::at(ui);
        let Some(charted) = &mut self.charted else {
            // Begun before the next frame.
            return ui.ctx().request_repaint();
        };
        let top = ui.cursor().top();
        quality(ui, charted.settings.0.spindle_quality, commands);
        let chart = match &charted.chart {
            Ok(chart) => chart,
            Err(error) => {
                theme::card(palette).show(ui, |ui| {
                    ui.set_width(ui.available_width());
                    let title = "No chart can be made of this machine";
                    ui.label(RichText::new(title).strong().color(palette.bad));
                    ui.label(error);
                });
                return;
            }
        };
        let cuts = now.speed_rpm > 0.0 && now.depth_mm > 0.0;
        if cuts && charted.judged.is_none_or(|(judged, _)| far(judged, now)) {
            let grown = multiplier(&chart.cut, now.speed_rpm, now.depth_mm);
            charted.judged = Some((now, grown));
        }
        let grown = charted.judged.map(|(_, grown)| grown).filter(|_| cuts);
        verdict(ui, now, grown, chart);
        let figure = figure(chart, now, grown, palette);
        figure.legend(ui);
        if !chart.work.is_over() {
            let share = chart.work.progress().share() as f32;
            let bar = ProgressBar::new(share).show_percentage();
            ui.add(bar.desired_height(14.0));
            if !chart.work.is_running() && ui.button("Go on with the chart").clicked() {
                chart.work.go_on();
            }
        }
        let height = height - (ui.cursor().top() - top);
        figure.show(ui, height.max(theme::PLOT_HEIGHT_SCROLLED), Sense::hover());
    }
}

fn far(judged: Operating, now: Operating) -> bool {
    (judged.speed_rpm - now.speed_rpm).abs() > VERDICT_STEP[0]
        || (judged.depth_mm - now.depth_mm).abs() > VERDICT_STEP[1]
}

/// The two readings of the spindle's damper.
fn quality(ui: &mut Ui, now: f64, commands: &mut Vec<Command>) {
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new("Spindle quality").strong());
        for (quality, name, help) in [
            (
                SPINDLE_QUALITY,
                "Q 5, by its damper",
                "The printed damper of 2348 N s/m belongs to it",
            ),
            (
                QUALITY_PRINTED[1],
                "Q 17, as printed",
                "The quality printed in the table: a third of the damping",
            ),
        ] {
            let chosen = now == quality;
            if ui.selectable_label(chosen, name).on_hover_text(help).clicked() && !chosen {
                let path = "machine.spindle_quality".to_owned();
                commands.push(Command::Session(SessionCommand::Set {
                    path,
                    value: Value::Float(quality),
                }));
            }
        }
    });
}

fn verdict(ui: &mut Ui, now: Operating, grown: Option<f64>, chart: &Chart) {
    let palette = Palette::at(ui);
    let at = format!(
        "{} and {} deep",
        format::quantity(now.speed_rpm, "1/min"),
        format::quantity(now.depth_mm, "mm")
    );
    let (text, color) = match grown {
        None => ("No cut now".to_owned(), palette.weak),
        Some(grown) if grown > 1.0 => {
            (format!("Chatter at {at}: a disturbance grows ×{grown:.2} per tooth"), palette.bad)
        }
        Some(grown) => (
            format!("Stable at {at}: a disturbance shrinks to ×{grown:.2} per tooth"),
            palette.good,
        ),
    };
    ui.horizontal_wrapped(|ui| {
        let label = ui.label(RichText::new(&text).strong().color(color));
        label.widget_info(|| WidgetInfo::labeled(Role::Label, true, text.clone()));
        let any_speed_mm = chart.any_speed_mm;
        let text = match any_speed_mm.is_finite() {
            true => {
                let any = format::quantity(any_speed_mm, "mm");
                format!("Stable at every speed up to {any}, by the lobes.")
            }
            false => "Nothing can chatter: the chip does not feel the vibration.".to_owned(),
        };
        ui.label(RichText::new(text).color(palette.weak));
    });
    let cut = format!("Charted: {}.", chart.cut.engagement_text());
    ui.label(RichText::new(cut).small().color(palette.weak));
}

fn figure(chart: &Chart, now: Operating, grown: Option<f64>, palette: &Palette) -> Figure {
    let [from_rpm, to_rpm] = SPEEDS_RPM;
    let across = [from_rpm.min(now.speed_rpm), to_rpm.max(now.speed_rpm)];
    let across = if grown.is_some() { across } else { SPEEDS_RPM };
    let mut figure = Figure::new("Limit depth", ["1/min", "mm"], across);
    figure.over = "speed";
    let curve = |name, look, of: fn(&LobePoint) -> Option<f64>| {
        let points = chart.points.iter();
        let points = points.map(|point| [point.speed_rpm, of(point).unwrap_or(f64::INFINITY)]);
        PlotCurve { name, look, points: points.collect() }
    };
    figure.curves = vec![
        curve("lobes", Look::Twin, |point| point.mean_mm),
        curve("interrupted cut", Look::Produced, |point| point.interrupted_mm),
    ];
    let any_speed_mm = chart.any_speed_mm;
    if any_speed_mm.is_finite() {
        figure.levels.push(("stable at every speed", Look::Limit, any_speed_mm));
    }
    let found = chart.points.iter().filter_map(|point| point.interrupted_mm);
    let [_, highest] = extent(found);
    let highest = limit(highest, 1.2 * any_speed_mm, SHOWN * any_speed_mm);
    let highest = highest.max(1.3 * now.depth_mm);
    let highest = if highest.is_finite() { 1.05 * highest } else { 10.0 };
    figure.up = [-0.03 * highest, highest];
    if let Some(grown) = grown {
        let color = if grown > 1.0 { palette.bad } else { palette.good };
        figure.marks.push(Marks {
            name: "the cut now",
            at: vec![[now.speed_rpm, now.depth_mm]],
            shape: MarkerShape::Diamond,
            color,
            radius: 7.0,
        });
    }
    figure
}
