//! What moves the swarm: again, play and pause, one iteration, to the end, and how fast.

use egui::{ComboBox, Label, RichText, Role, Ui, WidgetInfo};

use super::search::{SPEEDS, Search};
use crate::app::command::{Command, SessionCommand};
use crate::app::playback::Speed;
use crate::app::theme::Palette;
use crate::app::widgets::icon::{self, Icon};
use crate::base::language::tr;
use crate::base::settings::Value;
use crate::run::scenario::Scenario;

/// The row of buttons.
pub fn show(ui: &mut Ui, search: &mut Search, scenario: &Scenario, commands: &mut Vec<Command>) {
    let (progress, has_more, stopped) = match search.found() {
        Some(Ok(found)) => (Some(found.stage().counts), found.has_more(), found.is_stopped()),
        Some(Err(_)) | None => (None, false, false),
    };
    let done = progress.is_none_or(|progress| progress.done);
    ui.horizontal_wrapped(|ui| {
        let help = tr("Again from the same random start");
        if icon::button(ui, Icon::Restart, tr("Search again"), help, progress.is_some()).clicked() {
            search.again();
        }
        if search.is_playing() && !done {
            let help = tr("The swarm stands still");
            if icon::button(ui, Icon::Pause, tr("Pause the swarm"), help, true).clicked() {
                search.pause();
            }
        } else {
            let help = tr("The swarm moves on; at its end: again from the start");
            let enabled = progress.is_some();
            if icon::button(ui, Icon::Play, tr("Move the swarm"), help, enabled).clicked() {
                search.play();
            }
        }
        let help = tr("One iteration of the swarm");
        if icon::button(ui, Icon::Step, tr("One iteration"), help, has_more).clicked() {
            search.step();
        }
        let help = tr("To the end of the search");
        if icon::button(ui, Icon::End, tr("To the end"), help, !done).clicked() {
            search.rush();
        }
        speed(ui, &mut search.speed);
        let help = tr("Another seed: another random start, and nearly the same optimum");
        if ui.button(tr("Other seed")).on_hover_text(help).clicked() {
            let seed = i64::from(scenario.plan.seed.wrapping_add(1));
            commands.push(Command::Session(SessionCommand::SetUp(vec![(
                "plan.seed".to_owned(),
                Value::Int(seed),
            )])));
        }
        if let Some(progress) = progress {
            let (iteration, most) = (progress.iteration, progress.iterations);
            let text = match (progress.done, stopped) {
                (true, _) => tr!(
                    "done: iteration {iteration} of at most {most}",
                    iteration = iteration,
                    most = most,
                ),
                (false, true) => tr!(
                    "stopped: iteration {iteration} of at most {most}",
                    iteration = iteration,
                    most = most,
                ),
                (false, false) => tr!(
                    "searching: iteration {iteration} of at most {most}",
                    iteration = iteration,
                    most = most,
                ),
            };
            let help = tr!("{n} evaluations of the force surface", n = progress.evaluations);
            let text = RichText::new(text).color(Palette::at(ui).weak);
            // In one piece where the line wraps.
            ui.add(Label::new(text).extend()).on_hover_text(help);
        }
    });
}

fn speed(ui: &mut Ui, now: &mut Speed) {
    let short = |speed: Speed| match speed {
        Speed::Max => tr("at once").to_owned(),
        times => times.label(),
    };
    let response = ComboBox::from_id_salt("swarm speed")
        .width(64.0)
        .selected_text(short(*now))
        .show_ui(ui, |ui| {
            for speed in SPEEDS {
                if ui.selectable_value(now, speed, short(speed)).clicked() {
                    ui.close();
                }
            }
        })
        .response;
    response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, tr("Speed of the swarm")));
    response.on_hover_text(tr("Speed of the swarm"));
}
