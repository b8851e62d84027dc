//! The answer of the plan, and its way into the scenario.

use egui::{Button, RichText, Ui};

use super::search::Found;
use crate::app::command::{Command, PlaybackCommand, SessionCommand, ShellCommand};
use crate::app::format;
use crate::app::theme::{self, Palette};
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::settings::Value;
use crate::run::scenario::Scenario;
use crate::study::plan::optimum::Optimum;
use crate::study::plan::remarks::remarks;

/// From this width on, points, two values stand beside each other.
const WIDE: f32 = 380.0;

/// Why the answer can't be programmed; none if it can.
fn obstacle(found: &Found) -> Option<String> {
    let optimum = found.optimum();
    match (found.stage().counts.done, optimum.feasible) {
        (false, _) if found.is_stopped() => {
            Some("The search was stopped; “Move the swarm” goes on with it.".to_owned())
        }
        (false, _) => Some("The swarm is still searching; “To the end” shortens it.".to_owned()),
        (true, false) => Some(format!("Not programmed: {}.", optimum.verdict_text())),
        (true, true) => None,
    }
}

/// What programs the answer and cuts with it from the start.
fn use_it(optimum: &Optimum, commands: &mut Vec<Command>) {
    let changes =
        [("program.feed_mm_min", optimum.feed_mm_min), ("program.spindle_rpm", optimum.speed_rpm)];
    let changes = changes.map(|(path, value)| (path.to_owned(), Value::Float(value)));
    commands.push(Command::Session(SessionCommand::SetUp(changes.to_vec())));
    let feed = format::quantity(optimum.feed_mm_min, "mm/min");
    let speed = format::quantity(optimum.speed_rpm, "1/min");
    commands.push(Command::notify(format!(
        "The plan is programmed, {feed} and {speed}: the part is cut from its start."
    )));
    commands.push(Command::Shell(ShellCommand::ShowScreen("console")));
    commands.push(Command::Playback(PlaybackCommand::Restart));
}

/// The card with the best cut, the verdict, the button and what a run does with it.
pub fn show(ui: &mut Ui, found: &Found, scenario: &Scenario, commands: &mut Vec<Command>) {
    let palette = Palette::at(ui);
    let optimum = found.optimum();
    let done = found.stage().counts.done;
    theme::card(palette).show(ui, |ui| {
        ui.set_width(ui.available_width());
        let title = match (done, optimum.feasible) {
            (false, _) => "Best so far",
            (true, true) => "Optimum",
            (true, false) => "No optimum",
        };
        ui.label(RichText::new(title).strong());
        let verdict = optimum.verdict_text();
        let mut letters = verdict.chars();
        let first = letters.next().map(|letter| letter.to_uppercase().to_string());
        let sentence = first.unwrap_or_default() + letters.as_str() + ".";
        Standing::either(optimum.feasible).label(ui, &sentence, |text| text);
        if !optimum.inside_training_data {
            let text = "The network does not know this cut: material, hardness or depths lie \
                        outside its training data, and the force is continued.";
            Standing::Watch.label(ui, text, RichText::small);
        }
        values(ui, optimum);
        let obstacle = obstacle(found);
        let button = Button::new("Use as programmed values");
        let response = ui.add_enabled(obstacle.is_none(), button).on_hover_text(
            "Programs this feed and speed, keeps all else, and cuts from the start on the \
             console. Constant feed is then this feed; a controller that sets the feed by its own models \
             goes to the same feed as before. One step of undo.",
        );
        if response.clicked() {
            use_it(optimum, commands);
        }
        match obstacle {
            Some(obstacle) => {
                ui.label(RichText::new(obstacle).small().color(palette.weak));
            }
            None => {
                for remark in remarks(scenario) {
                    ui.label(RichText::new(remark.text + ".").small().color(palette.weak));
                }
            }
        }
    });
}

fn values(ui: &mut Ui, optimum: &Optimum) {
    let palette = Palette::at(ui);
    let pairs = [
        [
            ("Feed", format::quantity(optimum.feed_mm_min, "mm/min")),
            ("Speed", format::quantity(optimum.speed_rpm, "1/min")),
        ],
        [
            ("Feed per tooth", format::fine(optimum.feed_per_tooth_mm, "mm")),
            ("Cutting speed", format::quantity(optimum.cutting_speed_m_min, "m/min")),
        ],
        [
            ("Force", format::quantity(optimum.force_n, "N")),
            ("Removal", format::fine(optimum.removal_rate_cm3_min, "cm3/min")),
        ],
        [
            ("Time of cut", format::quantity(optimum.time_s, "s")),
            ("with tool changes", format::quantity(optimum.production_time_s, "s")),
        ],
        [
            ("Cost of cut", format::fine(optimum.cost, "")),
            ("Objective", format::fine(optimum.score.value, "")),
        ],
    ];
    let [columns, beside] = if ui.available_width() < WIDE { [2, 1] } else { [4, 2] };
    touch::grid(ui, "answer").num_columns(columns).spacing([10.0, 2.0]).show(ui, |ui| {
        for row in pairs.as_flattened().chunks(beside) {
            for (name, value) in row {
                ui.label(RichText::new(*name).small().color(palette.weak));
                ui.label(RichText::new(value).strong());
            }
            ui.end_row();
        }
    });
}
