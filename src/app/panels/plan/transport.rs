//! What moves the swarm: again, play and pause, one iteration, to the end, and how fast.

use egui::{ComboBox, Label, RichText, Role, Ui, WidgetInfo};

use super::search::{SPEEDS, Search};
use crate::app::command::{Command, SessionCommand};
use crate::app::playback::Speed;
use crate::app::theme::Palette;
use crate::app::widgets::icon::{self, Icon};
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
        let help = "Again from the same random start";
        if icon::button(ui, Icon::Restart, "Search again", help, progress.is_some()).clicked() {
            search.again();
        }
        if search.is_playing() && !done {
            let help = "The swarm stands still";
            if icon::button(ui, Icon::Pause, "Pause the swarm", help, true).clicked() {
                search.pause();
            }
        } else {
            let help = "The swarm moves on; at its end: again from the start";
            let enabled = progress.is_some();
            if icon::button(ui, Icon::Play, "Move the swarm", help, enabled).clicked() {
                search.play();
            }
        }
        let help = "One iteration of the swarm";
        if icon::button(ui, Icon::Step, "One iteration", help, has_more).clicked() {
            search.step();
        }
        let help = "To the end of the search";
        if icon::button(ui, Icon::End, "To the end", help, !done).clicked() {
            search.rush();
        }
        speed(ui, &mut search.speed);
        let help = "Another seed: another random start, and nearly the same optimum";
        if ui.button("Other seed").on_hover_text(help).clicked() {
            let seed = i64::from(scenario.plan.seed.wrapping_add(1));
            commands.push(Command::Session(SessionCommand::SetUp(vec![(
                "plan.seed".to_owned(),
                Value::Int(seed),
            )])));
        }
        if let Some(progress) = progress {
            let state = match (progress.done, stopped) {
                (true, _) => "done",
                (false, true) => "stopped",
                (false, false) => "searching",
            };
            let (iteration, most) = (progress.iteration, progress.iterations);
            let text = format!("{state}: iteration {iteration} of at most {most}");
            let help = format!("{} evaluations of the force surface", progress.evaluations);
            let text = RichText::new(text).color(Palette::at(ui).weak);
            // In one piece where the line wraps.
            ui.add(Label::new(text).extend()).on_hover_text(help);
        }
    });
}

fn speed(ui: &mut Ui, now: &mut Speed) {
    let short = |speed: Speed| match speed {
        Speed::Max => "at once".to_owned(),
        times => times.label(),
    };
    let response = ComboBox::from_id_salt("swarm speed")
        .width(64.0)
        .selected_text(short(*now))
        .show_ui(ui, |ui| {
            for speed in SPEEDS {
                ui.selectable_value(now, speed, short(speed));
            }
        })
        .response;
    response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, "Speed of the swarm"));
    response.on_hover_text("Speed of the swarm");
}
