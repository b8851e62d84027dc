//! The stability chart: the depth at which the cut chatters over the speed, and where the cuts of the
//! run stand in it. The verdict is on the whole run: after a deep part has chattered, a shallow one at the
//! playhead makes no stable run of it.

mod whole_run;

use std::sync::Arc;

use egui::{ProgressBar, RichText, Sense, Ui};
use egui_plot::MarkerShape;

use self::whole_run::{CutOfRun, deepest};
use super::plot::{Figure, Marks, PlotCurve};
use crate::app::command::Command;
use crate::app::format;
use crate::app::jobs::{Jobs, Work};
use crate::app::session::Session;
use crate::app::theme::{self, Look, Palette};
use crate::app::widgets::standing::Standing;
use crate::base::language::{text, tr};
use crate::base::settings::Value;
use crate::blocks::cutting::workpiece::Workpiece;
use crate::models::structure::MachineSettings;
use crate::models::structure::parameters::{QUALITY_PRINTED, SPINDLE_QUALITY};
use crate::models::tool::Tool;
use crate::run::scenario::Scenario;
use crate::study::stability::chart::{ChartJob, LobePoint, Range};
use crate::study::stability::charted::ChartedCut;

/// Number of speeds of the chart.
const SPEEDS: u32 = 65;
/// Greatest depth that is looked at and the greatest that is shown, in depths that are stable at
/// every speed.
const HIGHEST: f64 = 25.0;
const SHOWN: f64 = 4.0;
/// Changes of speed and depth after which the verdict is made again, 1/min and mm.
const VERDICT_STEP: [f64; 2] = [5.0, 0.01];

/// The limit depth is found anew where the speed has changed, at most every so often while it goes on
/// changing, s.
const LIMIT_EVERY_S: f64 = 0.5;

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
    /// The present cut that was judged last, with its multiplier.
    judged: Option<(Operating, f64)>,
    /// The deepest cuts of the run, each with its multiplier once it is judged.
    of_run: Vec<(CutOfRun, Option<f64>)>,
    limit: AtSpeed,
}

/// The limit depth at the present speed.
#[derive(Default)]
struct AtSpeed {
    /// The speed that is asked about, 1/min, and when it was, s.
    asked: Option<(f64, f64)>,
    work: Option<Work<ChartJob>>,
    /// The last one found.
    found: Option<LobePoint>,
}

impl AtSpeed {
    /// Asks about a speed, unless it is that of the last time or that is not over yet.
    fn follow(
        &mut self,
        speed_rpm: f64,
        now_s: f64,
        scenario: &Scenario,
        highest_mm: f64,
        jobs: &Jobs,
    ) {
        let over = self.work.take_if(|work| work.is_over());
        if let Some(work) = over {
            self.found = work.partial().first().copied();
        }
        let due = self.asked.is_none_or(|(asked_rpm, at_s)| {
            (asked_rpm - speed_rpm).abs() > VERDICT_STEP[0] && (now_s - at_s).abs() >= LIMIT_EVERY_S
        });
        if !due || speed_rpm <= 0.0 || self.work.is_some() {
            return;
        }
        self.asked = Some((speed_rpm, now_s));
        let (from_rpm, to_rpm) = (speed_rpm, speed_rpm);
        let range = Range { from_rpm, to_rpm, speeds: 1, highest_mm, simulate: false };
        // A machine that gives no chart says so in the place of the chart.
        let job = ChartJob::new(scenario, range).ok();
        self.work = job.map(|job| jobs.begin_brief(text!("Limit depth at this speed"), job, 1));
    }

    /// The limit, in words; nothing where that at another speed is known only.
    fn text(&self, now: Operating, highest_mm: f64, any_speed_mm: f64) -> Option<String> {
        let here =
            |point: &&LobePoint| (point.speed_rpm - now.speed_rpm).abs() <= 4.0 * VERDICT_STEP[0];
        let point = self.found.as_ref().filter(here)?;
        let speed = format::quantity(point.speed_rpm, "1/min");
        // One answer to "how deep may it go", and what the other depth in the chart is.
        let any = format::quantity(any_speed_mm, "mm");
        Some(match point.interrupted_mm {
            Some(mm) => tr!(
                "Quiet at {speed} up to {limit} (limit depth), at any speed up to {any}.",
                speed = speed,
                limit = format::quantity(mm, "mm"),
                any = any,
            ),
            None => tr!(
                "Quiet at {speed} up to {highest} at least: no limit depth was found; at any speed up to {any}.",
                speed = speed,
                highest = format::quantity(highest_mm, "mm"),
                any = any,
            ),
        })
    }
}

impl Charted {
    /// The cut of the run that a disturbance grows most in, once all are judged.
    fn worst(&self) -> Option<(CutOfRun, f64)> {
        let judged: Option<Vec<(CutOfRun, f64)>> =
            self.of_run.iter().map(|(cut, grown)| grown.map(|grown| (*cut, grown))).collect();
        judged?.into_iter().max_by(|a, b| a.1.total_cmp(&b.1))
    }
}

/// A chart on its way.
struct Chart {
    cut: ChartedCut,
    /// From and to, 1/min.
    speeds_rpm: [f64; 2],
    any_speed_mm: f64,
    work: Work<ChartJob>,
    points: Arc<Vec<LobePoint>>,
}

fn begin(scenario: &Scenario, jobs: &Jobs) -> Result<Chart, String> {
    let cut = ChartedCut::new(scenario).map_err(|error| error.to_string())?;
    let speeds_rpm = cut.usual_speeds_rpm();
    let ([from_rpm, to_rpm], highest_mm) = (speeds_rpm, HIGHEST * cut.any_speed_mm());
    let range = Range { from_rpm, to_rpm, speeds: SPEEDS, highest_mm, simulate: false };
    let job = ChartJob::new(scenario, range).map_err(|error| error.to_string())?;
    let any_speed_mm = job.any_speed_mm();
    let work = jobs.begin(text!("Stability chart"), job, 1);
    Ok(Chart { cut, speeds_rpm, any_speed_mm, points: work.partial(), work })
}

impl StabilityView {
    /// Keeps up with the scenario.
    pub fn follow(&mut self, session: &Session, now_s: f64, jobs: &Jobs) {
        let scenario = session.current();
        let settings =
            (scenario.machine.clone(), scenario.tool.clone(), scenario.workpiece.clone());
        if self.charted.as_ref().is_none_or(|charted| charted.settings != settings) {
            let chart = begin(scenario, jobs);
            let limit = AtSpeed::default();
            self.charted =
                Some(Charted { settings, chart, judged: None, of_run: Vec::new(), limit });
        }
        if let Some(Charted { chart: Ok(chart), of_run, .. }) = &mut self.charted {
            let cuts = deepest(session);
            let alike = |(known, _): &(CutOfRun, _), cut: &CutOfRun| !far(known.at, cut.at);
            if cuts.len() != of_run.len() || !of_run.iter().zip(&cuts).all(|(a, b)| alike(a, b)) {
                *of_run = cuts.into_iter().map(|cut| (cut, None)).collect();
            }
            // One a frame: each is a moment's work.
            if let Some((cut, grown)) = of_run.iter_mut().find(|(_, grown)| grown.is_none()) {
                *grown = Some(chart.cut.multiplier(cut.at.speed_rpm, cut.at.depth_mm));
            }
        }
        if let Some(Charted { chart: Ok(chart), limit, .. }) = &mut self.charted {
            chart.points = chart.work.partial();
            let speed_rpm = session.row().spindle_rpm;
            limit.follow(speed_rpm, now_s, scenario, HIGHEST * chart.any_speed_mm, jobs);
        }
    }

    /// Draws all of it, `height` points high, with the verdict on the present cut.
    /// On a phone it comes first, and the choice of the damper last.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        now: Operating,
        (height, narrow): (f32, bool),
        commands: &mut Vec<Command>,
    ) {
        let palette = Palette::at(ui);
        let Some(charted) = &mut self.charted else {
            // Begun before the next frame.
            return ui.ctx().request_repaint();
        };
        let top = ui.cursor().top();
        let machine = charted.settings.0.clone();
        if !narrow {
            structure(ui, &machine, commands);
        }
        let chart = match &charted.chart {
            Ok(chart) => chart,
            Err(error) => {
                theme::card(palette).show(ui, |ui| {
                    ui.set_width(ui.available_width());
                    let title = tr("No chart can be made of this machine");
                    Standing::Bad.label(ui, title, RichText::strong);
                    ui.label(error);
                });
                if narrow {
                    structure(ui, &machine, commands);
                }
                return;
            }
        };
        let cuts = now.speed_rpm > 0.0 && now.depth_mm > 0.0;
        if cuts && charted.judged.is_none_or(|(judged, _)| far(judged, now)) {
            let grown = chart.cut.multiplier(now.speed_rpm, now.depth_mm);
            charted.judged = Some((now, grown));
        }
        let grown = charted.judged.map(|(_, grown)| grown).filter(|_| cuts);
        let worst = charted.worst();
        if charted.of_run.iter().any(|(_, grown)| grown.is_none()) {
            ui.ctx().request_repaint();
        }
        verdict(ui, worst, chart);
        let limit = charted.limit.text(now, HIGHEST * chart.any_speed_mm, chart.any_speed_mm);
        let chatters = worst.is_some_and(|(_, grown)| grown > 1.0);
        present(ui, now, (grown, chatters), limit.as_deref());
        quiet_speed(ui, worst, chart);
        let cut = tr!("Charted: {cut}.", cut = chart.cut.engagement_text());
        ui.label(RichText::new(cut).small().color(palette.weak));
        let figure = figure(chart, now, grown, worst, palette);
        figure.legend(ui);
        if !chart.work.is_over() {
            let share = chart.work.progress().share() as f32;
            let bar = ProgressBar::new(share).show_percentage();
            ui.add(bar.desired_height(14.0));
            if !chart.work.is_running() && ui.button(tr("Go on with the chart")).clicked() {
                chart.work.go_on();
            }
        }
        let height = height - (ui.cursor().top() - top);
        figure.show(ui, height.max(theme::PLOT_HEIGHT_SCROLLED), Sense::hover());
        if narrow {
            structure(ui, &machine, commands);
        }
    }
}

fn far(judged: Operating, now: Operating) -> bool {
    (judged.speed_rpm - now.speed_rpm).abs() > VERDICT_STEP[0]
        || (judged.depth_mm - now.depth_mm).abs() > VERDICT_STEP[1]
}

/// The measured modes that are charted, or the choice of the spindle's damper.
fn structure(ui: &mut Ui, machine: &MachineSettings, commands: &mut Vec<Command>) {
    let modes = machine.tip_modes.all().len();
    if modes == 0 {
        return quality(ui, machine.spindle_quality, commands);
    }
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(tr("Structure")).strong());
        ui.label(tr!("{n} measured modes at the tool's tip", n = modes));
        let help = tr("Takes the measured modes away: the five masses of 2019 stand again");
        if ui.button(tr("Back to the five masses")).on_hover_text(help).clicked() {
            commands.push(Command::set("machine.tip_modes", Value::List(Vec::new())));
        }
    });
}

/// The two readings of the spindle's damper.
fn quality(ui: &mut Ui, now: f64, commands: &mut Vec<Command>) {
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(tr("Spindle quality")).strong());
        for (quality, name, help) in [
            (
                SPINDLE_QUALITY,
                tr("Q 5, by its damper"),
                tr("The printed damper of 2348 N s/m belongs to it"),
            ),
            (
                QUALITY_PRINTED[1],
                tr("Q 17, as printed"),
                tr("The quality printed in the table: a third of the damping"),
            ),
        ] {
            let chosen = now == quality;
            if ui.selectable_label(chosen, name).on_hover_text(help).clicked() && !chosen {
                commands.push(Command::set("machine.spindle_quality", Value::Float(quality)));
            }
        }
    });
}

/// The verdict on the whole run: on its cut that is nearest to chatter.
fn verdict(ui: &mut Ui, worst: Option<(CutOfRun, f64)>, chart: &Chart) {
    let palette = Palette::at(ui);
    let (text, standing) = match worst {
        None => (tr("The cuts of this run are being judged").to_owned(), Standing::Plain),
        Some((cut, grown)) => {
            let [from, to] = cut.from_to_mm.map(|mm| format::quantity(mm, "mm"));
            let [speed, depth] = words(cut.at);
            if grown > 1.0 {
                let text = tr!(
                    "Chatter at {speed} and {depth} deep, from {from} to {to} of the path: a disturbance \
                     grows ×{grown:.2} per tooth",
                    speed = speed,
                    depth = depth,
                    from = from,
                    to = to,
                    grown = grown,
                );
                (text, Standing::Bad)
            } else {
                let text = tr!(
                    "Stable at {speed} and {depth} deep, from {from} to {to} of the path, the cut of this \
                     run nearest to chatter: a disturbance shrinks to ×{grown:.2} per tooth",
                    speed = speed,
                    depth = depth,
                    from = from,
                    to = to,
                    grown = grown,
                );
                (text, Standing::Good)
            }
        }
    };
    // Lines of text, which fingers do not press.
    let spacing = ui.spacing().clone();
    ui.spacing_mut().interact_size.y = 18.0;
    ui.horizontal_wrapped(|ui| {
        standing.label(ui, &text, RichText::strong);
        let any_speed_mm = chart.any_speed_mm;
        let text = match any_speed_mm.is_finite() {
            true => {
                let any = format::quantity(any_speed_mm, "mm");
                tr!("Stable at every speed up to {any}, by the lobes.", any = any)
            }
            false => tr("Nothing can chatter: the chip does not feel the vibration.").to_owned(),
        };
        ui.label(RichText::new(text).color(palette.weak));
    });
    *ui.spacing_mut() = spacing;
}

/// Speed and depth of a cut with their units.
fn words(at: Operating) -> [String; 2] {
    [format::quantity(at.speed_rpm, "1/min"), format::quantity(at.depth_mm, "mm")]
}

/// The speed of the chart at which the depth of the run's worst cut has most room, where it chatters at its own.
fn quiet_speed(ui: &mut Ui, worst: Option<(CutOfRun, f64)>, chart: &Chart) {
    let Some((cut, _)) = worst.filter(|(_, grown)| *grown > 1.0) else { return };
    if !chart.work.is_over() {
        return;
    }
    let depth_mm = cut.at.depth_mm;
    let room = |point: &LobePoint| point.interrupted_mm.unwrap_or(f64::INFINITY);
    let best = chart.points.iter().max_by(|a, b| room(a).total_cmp(&room(b)));
    let depth = format::quantity(depth_mm, "mm");
    let text = match best.filter(|point| room(point) > depth_mm) {
        Some(point) if room(point).is_finite() => tr!(
            "{depth} deep it is quietest near {speed}, where the limit depth is {limit}.",
            depth = depth,
            speed = format::quantity(point.speed_rpm, "1/min"),
            limit = format::quantity(room(point), "mm"),
        ),
        Some(point) => tr!(
            "{depth} deep it is quietest near {speed}, where no limit depth was found.",
            depth = depth,
            speed = format::quantity(point.speed_rpm, "1/min"),
        ),
        None => tr!("{depth} deep it is quiet at no speed of the chart.", depth = depth),
    };
    Standing::Plain.label(ui, &text, |text| text);
}

/// The cut at the playhead, below the verdict.
fn present(
    ui: &mut Ui,
    now: Operating,
    (grown, chatters): (Option<f64>, bool),
    limit: Option<&str>,
) {
    let [speed, depth] = words(now);
    let (mut text, standing) = match grown {
        None => (tr("At the playhead: no cut.").to_owned(), Standing::Plain),
        Some(grown) if grown > 1.0 => {
            let text = tr!(
                "At the playhead, {speed} and {depth} deep: chatter, ×{grown:.2}.",
                speed = speed,
                depth = depth,
                grown = grown,
            );
            (text, Standing::Bad)
        }
        Some(grown) => {
            let text = tr!(
                "At the playhead, {speed} and {depth} deep: no chatter, ×{grown:.2}.",
                speed = speed,
                depth = depth,
                grown = grown,
            );
            // Beside a run that chatters elsewhere a tick would be read as the verdict.
            (text, if chatters { Standing::Plain } else { Standing::Good })
        }
    };
    if let Some(limit) = limit.filter(|_| grown.is_some()) {
        text = format!("{text} {limit}");
    }
    standing.label(ui, &text, |text| text);
}

fn figure(
    chart: &Chart,
    now: Operating,
    grown: Option<f64>,
    worst: Option<(CutOfRun, f64)>,
    palette: &Palette,
) -> Figure {
    let [from_rpm, to_rpm] = chart.speeds_rpm;
    let across = [from_rpm.min(now.speed_rpm), to_rpm.max(now.speed_rpm)];
    let across = if grown.is_some() { across } else { chart.speeds_rpm };
    let mut figure = Figure::new(text!("Limit depth"), ["1/min", "mm"], across);
    figure.long_title = text!("Limit depth [mm] over the speed [1/min]: quiet below the line");
    let curve = |name, look, of: fn(&LobePoint) -> Option<f64>| {
        let points = chart.points.iter();
        let points = points.map(|point| [point.speed_rpm, of(point).unwrap_or(f64::INFINITY)]);
        PlotCurve { name, look, points: points.collect() }
    };
    figure.curves = vec![
        curve(text!("lobes"), Look::Twin, |point| point.mean_mm),
        curve(text!("interrupted cut"), Look::Produced, |point| point.interrupted_mm),
    ];
    let any_speed_mm = chart.any_speed_mm;
    if any_speed_mm.is_finite() {
        figure.levels.push((text!("stable at every speed"), Look::Limit, any_speed_mm));
    }
    // The same from the first point on: an axis that grows with the curve leaves nothing to compare it with.
    let highest = SHOWN * any_speed_mm;
    let deepest_mm = worst.map_or(0.0, |(cut, _)| cut.at.depth_mm);
    let highest = highest.max(1.3 * now.depth_mm.max(deepest_mm));
    let highest = if highest.is_finite() { 1.05 * highest } else { 10.0 };
    figure.up = [-0.03 * highest, highest];
    if let Some((cut, grown)) = worst {
        let color = if grown > 1.0 { palette.bad } else { palette.good };
        figure.marks.push(Marks {
            name: match grown > 1.0 {
                true => text!("furthest into chatter in the run"),
                false => text!("nearest to chatter in the run"),
            },
            at: vec![[cut.at.speed_rpm, cut.at.depth_mm]],
            shape: MarkerShape::Cross,
            color,
            radius: 7.0,
        });
    }
    if let Some(grown) = grown {
        let color = if grown > 1.0 { palette.bad } else { palette.good };
        figure.marks.push(Marks {
            name: text!("the cut now"),
            at: vec![[now.speed_rpm, now.depth_mm]],
            shape: MarkerShape::Diamond,
            color,
            radius: 7.0,
        });
    }
    figure
}
