//! The answer of the plan, and its way into the scenario.

use egui::{Button, RichText, TextStyle, Ui};

use super::search::Found;
use crate::app::command::{Command, PlaybackCommand, SessionCommand, ShellCommand};
use crate::app::format;
use crate::app::session::Session;
use crate::app::theme::{self, Palette};
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::tr;
use crate::base::settings::{Field, Value};
use crate::base::units::percent_from_ratio;
use crate::blocks::control::ControllerKind;
use crate::run::signals::flag;
use crate::study::plan::optimum::Optimum;
use crate::study::plan::over_depths::OverDepths;
use crate::study::plan::remarks::{TIMES, remarks};

/// Space between a name and its value, points.
const GAP: f32 = 10.0;
/// Feed and speed within this fraction of the planned ones are the planned ones (chosen).
const SAME_CUT: f64 = 2e-3;
/// From this width on, points, two values stand beside each other.
const WIDE: f32 = 380.0;

/// Why the answer can't be programmed; none if it can.
fn obstacle(found: &Found) -> Option<String> {
    let optimum = found.optimum();
    match (found.stage().counts.done, optimum.feasible) {
        (false, _) if found.is_stopped() => {
            Some(tr("The search was stopped; “Move the swarm” goes on with it.").to_owned())
        }
        (false, _) => {
            Some(tr("The swarm is still searching; “To the end” shortens it.").to_owned())
        }
        (true, false) => Some(tr!("Not programmed: {why}.", why = optimum.verdict_text())),
        (true, true) => None,
    }
}

/// What programs the answer and cuts with it from the start, with a controller or at constant feed.
fn use_it(optimum: &Optimum, control: ControllerKind, commands: &mut Vec<Command>) {
    let values =
        [("program.feed_mm_min", optimum.feed_mm_min), ("program.spindle_rpm", optimum.speed_rpm)];
    let mut changes = values.map(|(path, value)| (path.to_owned(), Value::Float(value))).to_vec();
    changes.push(("controller.kind".to_owned(), control.to_value()));
    commands.push(Command::Session(SessionCommand::SetUp(changes)));
    let feed = format::quantity(optimum.feed_mm_min, "mm/min");
    let speed = format::quantity(optimum.speed_rpm, "1/min");
    let text = if control == ControllerKind::ConstantFeed {
        tr!(
            "The plan is programmed, {feed} and {speed}: the part is cut from its start, at constant feed.",
            feed = feed,
            speed = speed,
        )
    } else {
        tr!(
            "The plan is programmed, {feed} and {speed}: the part is cut from its start, {controller} moves \
             the feed on from there.",
            feed = feed,
            speed = speed,
            controller = tr(control.label()),
        )
    };
    commands.push(Command::notify(text));
    commands.push(Command::Shell(ShellCommand::ShowScreen("console")));
    commands.push(Command::Playback(PlaybackCommand::Restart));
}

/// The card with the best cut, the verdict, the button and what a run does with it.
pub fn show(ui: &mut Ui, found: &Found, session: &Session, commands: &mut Vec<Command>) {
    let scenario = session.scenario();
    let palette = Palette::at(ui);
    let optimum = found.optimum();
    let done = found.stage().counts.done;
    theme::card(palette).show(ui, |ui| {
        ui.set_width(ui.available_width());
        let title = match (done, optimum.feasible) {
            (false, _) => tr("Best so far"),
            (true, true) => tr("Optimum"),
            (true, false) => tr("No optimum"),
        };
        ui.label(RichText::new(title).strong());
        let over = found.over_depths().filter(|_| done);
        let verdict = match over {
            Some(over) => over.verdict_text(optimum),
            None => optimum.verdict_text(),
        };
        // A tick only for what is good wherever the part is cut.
        let standing = match over {
            Some(over) if optimum.feasible && !over.is_good() => Standing::Watch,
            Some(_) | None => Standing::either(optimum.feasible),
        };
        standing.label(ui, &format::sentence(&verdict), |text| text);
        if let Some(over) = over.filter(|_| optimum.feasible) {
            depths(ui, over);
        }
        if !optimum.inside_training_data {
            let text = tr("The network does not know this cut: material, hardness or depths lie \
                           outside its training data, and the force is continued.");
            Standing::Watch.label(ui, text, RichText::small);
        }
        values(ui, optimum);
        let small = |ui: &mut Ui, text: String| ui.label(RichText::new(text).small().color(palette.weak));
        let (of_times, others): (Vec<_>, Vec<_>) =
            remarks(scenario).into_iter().partition(|remark| remark.id == TIMES);
        for remark in of_times {
            small(ui, remark.text + ".");
        }
        let obstacle = obstacle(found);
        let control = scenario.controller.kind;
        ui.horizontal_wrapped(|ui| {
            // What is planned is what is cut where nothing moves the feed: that way comes first.
            if control != ControllerKind::ConstantFeed {
                let button = Button::new(tr("Cut it at constant feed"));
                let help = tr("Programs this feed and speed, switches the controller to constant feed, and cuts \
                               from the start on the console: the cut that is planned here. One step of undo.");
                if ui.add_enabled(obstacle.is_none(), button).on_hover_text(help).clicked() {
                    use_it(optimum, ControllerKind::ConstantFeed, commands);
                }
            }
            let button = Button::new(tr("Use as programmed values"));
            let response = ui.add_enabled(obstacle.is_none(), button).on_hover_text(tr(
                "Programs this feed and speed, keeps all else, and cuts from the start on the \
                 console. Constant feed as programmed is then this feed; a controller that sets the feed by its own models \
                 goes to the same feed as before. One step of undo.",
            ));
            if response.clicked() {
                use_it(optimum, control, commands);
            }
        });
        if control != ControllerKind::ConstantFeed {
            let text = tr!(
                "{controller} moves the feed on from the programmed one at once.",
                controller = tr(control.label()),
            );
            Standing::Watch.label(ui, &text, RichText::small);
        }
        match obstacle {
            Some(obstacle) => {
                small(ui, obstacle);
            }
            None => {
                for remark in others {
                    small(ui, remark.text + ".");
                }
                if let Some(text) = over.and_then(|over| console_now(session, optimum, over)) {
                    small(ui, text);
                }
            }
        }
    });
}

/// What the planned feed and speed come to at every depth of the part.
fn depths(ui: &mut Ui, over: &OverDepths) {
    let title = over.title() + ":";
    ui.label(RichText::new(title).small().color(Palette::at(ui).weak));
    for (at, line) in over.depths.iter().zip(over.lines()) {
        let standing = match (at.is_good(), at.is_bad()) {
            (true, _) => Standing::Good,
            (false, true) => Standing::Bad,
            (false, false) => Standing::Watch,
        };
        standing.label(ui, &line, RichText::small);
    }
}

/// The console's force at the playhead beside that of the plan, where feed, speed and depth there are the planned
/// ones: forces of other cuts are not to be compared.
fn console_now(session: &Session, optimum: &Optimum, over: &OverDepths) -> Option<String> {
    let row = session.row();
    let near = |a: f64, b: f64| (a / b - 1.0).abs() < SAME_CUT;
    let same =
        near(row.feed_mm_min, optimum.feed_mm_min) && near(row.spindle_rpm, optimum.speed_rpm);
    if !same || row.has(flag::AIR) || row.force_n <= 0.0 {
        return None;
    }
    let plan_n = over.force_at_n(row.axial_depth_mm)?;
    Some(tr!(
        "The console's force at the playhead is {force}, {off} against the plan's at its depth, {depth}.",
        force = format::quantity(row.force_n, "N"),
        off = format::deviation(percent_from_ratio(row.force_n / plan_n - 1.0)),
        depth = format::quantity(row.axial_depth_mm, "mm"),
    ))
}

fn values(ui: &mut Ui, optimum: &Optimum) {
    let palette = Palette::at(ui);
    let pairs = [
        [
            (tr("Feed"), format::quantity(optimum.feed_mm_min, "mm/min")),
            (tr("Speed"), format::quantity(optimum.speed_rpm, "1/min")),
        ],
        [
            (tr("Feed per tooth"), format::fine(optimum.feed_per_tooth_mm, "mm")),
            (tr("Cutting speed"), format::quantity(optimum.cutting_speed_m_min, "m/min")),
        ],
        [
            (tr("Force"), format::quantity(optimum.force_n, "N")),
            (tr("Removal"), format::fine(optimum.removal_rate_cm3_min, "cm3/min")),
        ],
        [
            (tr("Time at this feed"), format::quantity(optimum.time_s, "s")),
            (tr("with tool changes"), format::quantity(optimum.production_time_s, "s")),
        ],
        [
            (tr("Cost of cut, your currency"), format::fine(optimum.cost, "")),
            (tr("Objective"), format::fine(optimum.score.value, "")),
        ],
    ];
    // Two beside each other where their words have room: they are longer in some languages.
    let widest = |part: usize, style: &TextStyle| {
        let texts = pairs.iter().flat_map(|pair| pair.iter()).map(|(name, value)| match part {
            0 => (*name).to_owned(),
            _ => value.clone(),
        });
        let font = style.resolve(ui.style());
        let width = |text| {
            ui.painter().layout_no_wrap(text, font.clone(), egui::Color32::PLACEHOLDER).size().x
        };
        texts.map(width).fold(0.0, f32::max)
    };
    let needed = 2.0 * (widest(0, &TextStyle::Small) + widest(1, &TextStyle::Body)) + 3.0 * GAP;
    let room = ui.available_width();
    let [columns, beside] = if room < WIDE || room < needed { [2, 1] } else { [4, 2] };
    touch::grid(ui, "answer").num_columns(columns).spacing([GAP, 2.0]).show(ui, |ui| {
        for row in pairs.as_flattened().chunks(beside) {
            for (name, value) in row {
                ui.label(RichText::new(*name).small().color(palette.weak));
                ui.label(RichText::new(value).strong());
            }
            ui.end_row();
        }
    });
}
