//! What an operator sees of the cut: the force against what stops it, feed, speed, override and place, in figures
//! that are read from afar.

use egui::{Rect, RichText, Role, Sense, Ui, WidgetInfo, vec2};

use super::super::super::View;
use crate::app::command::Command;
use crate::app::format;
use crate::app::theme::{self, Palette};
use crate::app::timeline::try_again;
use crate::app::widgets::standing::Standing;
use crate::base::language::{fixed, tr};
use crate::blocks::cutting::tool_path::ToolPath;
use crate::blocks::reference::Reference;
use crate::run::one_run::End;
use crate::run::scenario::Scenario;
use crate::run::signals::flag;

/// From this fraction of its limit on a force is marked (chosen).
const NEAR_THE_LIMIT: f64 = 0.9;
/// Height of the bar of the force, points.
const BAR: f32 = 26.0;

/// Shows the figures, and the part with the tool in it.
pub fn show(ui: &mut Ui, view: &View<'_>) {
    force(ui, view);
    ui.add_space(4.0);
    let row = view.session.row();
    let scenario = view.session.current();
    let programmed = scenario.programmed(ToolPath::cut_of(&scenario.workpiece, row.position_mm));
    let length_mm = ToolPath::length_of(&scenario.workpiece);
    let (feed, speed) = (programmed.feed_mm_min, programmed.speed_rpm);
    let [feed, speed] = match view.narrow {
        true => {
            [tr!("mm/min, of {feed:.0}", feed = feed), tr!("1/min, of {speed:.0}", speed = speed)]
        }
        false => [
            tr!("mm/min, programmed {feed:.0}", feed = feed),
            tr!("1/min, programmed {speed:.0}", speed = speed),
        ],
    };
    let cells = [
        (tr("Feed"), format!("{:.0}", row.feed_mm_min), feed),
        (
            tr("Override"),
            format::beside(format!("{:.0}", row.feed_override_percent), "%"),
            tr("sent to the machine").to_owned(),
        ),
        (tr("Spindle speed"), format!("{:.0}", row.spindle_rpm), speed),
        (
            tr("Place in the cut"),
            fixed(row.position_mm, 1),
            tr!("mm of {length}", length = format::quantity(length_mm, "mm")),
        ),
    ];
    let columns = if view.narrow { 2 } else { 4 };
    for line in cells.chunks(columns) {
        ui.columns(columns, |columns| {
            for (ui, (title, value, below)) in columns.iter_mut().zip(line) {
                cell(ui, title, value, below);
            }
        });
    }
    ui.add_space(2.0);
    part(ui, view, length_mm);
}

/// The part from the side, as an operator sees it behind the window: the depth that is cut, and the tool.
fn part(ui: &mut Ui, view: &View<'_>, length_mm: f64) {
    /// Height of the picture, and of its part that the deepest cut takes, points.
    const HEIGHT: [f32; 2] = [64.0, 34.0];
    /// Places whose depth is looked at.
    const PLACES: usize = 240;
    let palette = Palette::at(ui);
    let (rect, response) =
        ui.allocate_exact_size(vec2(ui.available_width(), HEIGHT[0]), Sense::hover());
    let (rows, now) = (view.session.chosen().run().recording().rows(), view.session.row());
    response.widget_info(|| {
        let [at, depth] =
            [now.position_mm, now.axial_depth_mm].map(|mm| format::quantity(mm, "mm"));
        let text = tr!("The part: the tool is at {place}, {depth} deep", place = at, depth = depth);
        WidgetInfo::labeled(Role::Figure, true, text)
    });
    let deepest_mm = rows.iter().map(|row| row.axial_depth_mm).fold(1e-3, f64::max);
    let x =
        |place_mm: f64| egui::lerp(rect.x_range(), (place_mm / length_mm).clamp(0.0, 1.0) as f32);
    let y = |depth_mm: f64| rect.top() + 10.0 + HEIGHT[1] * (depth_mm / deepest_mm) as f32;
    let painter = ui.painter();
    let step = (rows.len() / PLACES).max(1);
    for pair in rows.iter().step_by(step).zip(rows.iter().skip(step).step_by(step)) {
        let [from, to] = [x(pair.0.position_mm), x(pair.1.position_mm)];
        let piece = |top: f32, bottom: f32| {
            Rect::from_min_max(egui::pos2(from, top), egui::pos2(to, bottom))
        };
        let floor = y(pair.1.axial_depth_mm);
        painter.rect_filled(piece(floor, rect.bottom()), 0.0, palette.twin.gamma_multiply(0.55));
        if pair.0.position_mm >= now.position_mm {
            painter.rect_filled(piece(y(0.0), floor), 0.0, palette.twin.gamma_multiply(0.3));
        }
    }
    let tool = [x(now.position_mm) - 5.0, x(now.position_mm) + 5.0];
    let tool = Rect::from_min_max(
        egui::pos2(tool[0], rect.top()),
        egui::pos2(tool[1], y(now.axial_depth_mm)),
    );
    painter.rect_filled(tool, 3.0, palette.produced);
}

fn cell(ui: &mut Ui, title: &str, value: &str, below: &str) {
    let palette = Palette::at(ui);
    theme::card(palette).show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.label(RichText::new(title).color(palette.weak));
        ui.label(RichText::new(value).text_style(theme::large()).strong());
        ui.label(RichText::new(below).small().color(palette.weak));
    });
}

/// What the machine does, and after a stop the way back.
pub fn state(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let session = view.session;
    ui.horizontal_wrapped(|ui| {
        let (standing, text) = match session.finished() {
            Some(end) => {
                let standing = match end {
                    End::PathDone => Standing::Good,
                    End::TimeLimit => Standing::Watch,
                    End::Overload(_)
                    | End::Crash(_)
                    | End::Breakage(_)
                    | End::Fault(_)
                    | End::Refused(_)
                    | End::Script(_) => Standing::Bad,
                };
                (standing, format!("{end}."))
            }
            None if !session.playback().playing => {
                (Standing::Plain, tr("The machine is paused.").to_owned())
            }
            None if session.row().has(flag::AIR) => {
                (Standing::Plain, tr("Feeding, not in the cut.").to_owned())
            }
            None => (Standing::Plain, tr("Cutting.").to_owned()),
        };
        standing.label(ui, &text, RichText::strong);
        if standing == Standing::Bad {
            try_again(ui, view, commands);
        }
    });
}

/// What a force does that ends the cut.
#[derive(Clone, Copy, Debug)]
enum ForceEnds {
    Feed,
    Tooth,
}

/// The force that ends the cut, N, with what it does; none where nothing is set that it ends by.
fn limit_n(scenario: &Scenario) -> Option<(f64, ForceEnds)> {
    let cnc = &scenario.cnc;
    let stop = cnc.force_stop.then_some((cnc.force_stop_n, ForceEnds::Feed));
    let broken = Some((scenario.tool.force_max_n, ForceEnds::Tooth));
    let broken = broken.filter(|(force_n, _)| *force_n > 0.0);
    stop.into_iter().chain(broken).min_by(|a, b| a.0.total_cmp(&b.0))
}

/// The measured force as a bar, with the force that is asked for and the one that ends the cut.
fn force(ui: &mut Ui, view: &View<'_>) {
    let palette = Palette::at(ui);
    let (row, scenario) = (view.session.row(), view.session.current());
    let (now_n, asked_n) = (row.force_measured_n, row.force_ref_n);
    let limit = limit_n(scenario);
    let near = limit.is_some_and(|(limit_n, _)| now_n >= NEAR_THE_LIMIT * limit_n);
    theme::card(palette).show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.horizontal_wrapped(|ui| {
            ui.label(RichText::new(tr("Cutting force")).color(palette.weak));
            let text = RichText::new(format!("{now_n:.0} N")).text_style(theme::large()).strong();
            ui.label(text);
            let asked = match scenario.target.reference {
                Reference::Ra | Reference::Force if view.narrow => {
                    tr!("mark: {force:.0} N", force = asked_n)
                }
                Reference::Ra => {
                    let target = format::quantity(scenario.target.ra_um, "um");
                    tr!(
                        "mark: {force:.0} N, which Ra {target} asks for",
                        force = asked_n,
                        target = target
                    )
                }
                Reference::Force => {
                    tr!("mark: {force:.0} N, which is to be held", force = asked_n)
                }
            };
            ui.label(RichText::new(asked).color(palette.weak));
        });
        let end_n = limit.map_or(2.0 * asked_n, |(limit_n, _)| (1.08 * limit_n).max(1.5 * asked_n));
        bar(ui, [now_n, asked_n, end_n], limit.map(|(limit_n, _)| limit_n), near);
        match limit {
            Some((limit_n, ends)) => {
                let text = match ends {
                    ForceEnds::Feed => tr!("{force:.0} N stops the feed", force = limit_n),
                    ForceEnds::Tooth => tr!("{force:.0} N breaks a tooth", force = limit_n),
                };
                let standing = if near { Standing::Bad } else { Standing::Plain };
                standing.label(ui, &text, RichText::small);
            }
            None => {
                let text = tr("No force stops this machine (setting: Stop on overload)");
                ui.label(RichText::new(text).small().color(palette.weak));
            }
        }
    });
}

/// A bar with two marks: the force that is asked for, and the limit.
fn bar(ui: &mut Ui, [now_n, asked_n, end_n]: [f64; 3], limit_n: Option<f64>, near: bool) {
    /// How far the mark of the force that is asked for stands out, points.
    const OUT: f32 = 5.0;
    let palette = Palette::at(ui);
    let size = vec2(ui.available_width(), BAR + 2.0 * OUT);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    response.widget_info(|| {
        let text = match limit_n {
            Some(limit_n) => tr!(
                "Force {force:.0} N, asked for {asked:.0} N, limit {limit:.0} N",
                force = now_n,
                asked = asked_n,
                limit = limit_n
            ),
            None => {
                tr!("Force {force:.0} N, asked for {asked:.0} N", force = now_n, asked = asked_n)
            }
        };
        WidgetInfo::labeled(Role::Meter, true, text)
    });
    let inner = rect.shrink2(vec2(0.0, OUT));
    let x = |force_n: f64| {
        egui::lerp(inner.left()..=inner.right(), (force_n / end_n).clamp(0.0, 1.0) as f32)
    };
    let painter = ui.painter();
    painter.rect_filled(inner, 4.0, palette.grid);
    let color = if near { palette.bad } else { palette.produced };
    let filled = Rect::from_min_max(inner.min, egui::pos2(x(now_n), inner.bottom()));
    painter.rect_filled(filled, 4.0, color);
    let mark = egui::Stroke::new(3.0, palette.text);
    painter.vline(x(asked_n), rect.y_range(), mark);
    if let Some(limit_n) = limit_n {
        let barred = Rect::from_min_max(egui::pos2(x(limit_n), inner.top()), inner.max);
        painter.rect_filled(barred, 4.0, palette.limit.gamma_multiply(0.45));
        painter.vline(x(limit_n), inner.y_range(), egui::Stroke::new(3.0, palette.limit));
    }
}
