//! What is compared and how long: part, dead time, material, who takes part, seeds, run and pause.

use egui::{
    Button, CollapsingHeader, Color32, Label, ProgressBar, RichText, Role, TextStyle, Ui,
    WidgetInfo, vec2,
};

use super::contest::{ContestDeadTime, ContestPart, ContestSetup, Contests, Stock, is_own};
use crate::app::format;
use crate::app::jobs::time_left;
use crate::app::session::Session;
use crate::app::theme::Palette;
use crate::app::widgets::number::NumberField;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::tr;
use crate::base::settings::Choice;
use crate::blocks::control::ControllerKind;
use crate::run::job::Progress;
use crate::run::presets;
use crate::run::scenario::{Scenario, param};
use crate::study::compare::entrants::{Method, methods_and_own};

/// Least and most seeds.
const SEEDS: [u32; 2] = [1, 500];

/// The rows of choices above the table.
pub fn show(ui: &mut Ui, contests: &mut Contests, session: &Session, narrow: bool) {
    let palette = Palette::at(ui);
    let setup = &mut contests.setup;
    choose(
        ui,
        tr("Part"),
        ContestPart::ALL,
        ContestPart::OPTIONS,
        ContestPart::label,
        &mut setup.part,
    );
    if narrow {
        // The table is in sight at once.
        let head = CollapsingHeader::new(tr("Settings of the comparison"));
        head.id_salt("settings of the comparison").show_unindented(ui, |ui| more(ui, setup));
    } else {
        more(ui, setup);
    }
    let mut said = String::new();
    ui.horizontal_wrapped(|ui| {
        let over = contests.shown().is_some_and(|contest| {
            let runs = contest.runs();
            contest.work.is_over() || runs.done >= runs.total
        });
        let running = contests.shown().is_some_and(|contest| contest.work.is_running());
        let possible = contests.shown().is_some() && !over;
        let names = [tr("Run the comparison"), tr("Pause the comparison")];
        let help = tr("Runs everybody on every seed; it goes on while other screens are shown");
        if run_or_pause(ui, names, help, running, possible) {
            contests.shown().iter().for_each(|contest| match running {
                true => contest.work.stop(),
                false => contest.work.go_on(),
            });
        }
        let name = ui.label(tr("Seeds")).id;
        let field = NumberField {
            name: tr("Seeds"),
            unit: "",
            range: SEEDS.map(f64::from),
            speed: 0.2,
            decimals: 0,
            least: 0, suffix: "",
        };
        let mut seeds = f64::from(contests.seeds);
        let help =
            tr("Every seed is another material and other sensor noise, the same for everybody; without noise all seeds give the same run");
        field.show(ui, &mut seeds, &mut contests.said).labelled_by(name).on_hover_text(help);
        contests.seeds = seeds.round() as u32;
        if let Some(contest) = contests.shown() {
            let progress = contest.runs();
            let Progress { done, total: all, .. } = progress;
            ui.add(
                ProgressBar::new(progress.share() as f32).desired_width(120.0).desired_height(10.0),
            );
            // The same counts as in the list of what goes on.
            let (done, all) = (done.floor() as u64, all as u64);
            let state = match (over, running) {
                (true, _) => tr("done").to_owned(),
                (false, true) => match (contest.load_steps(), contest.work.left_s()) {
                    (Some([step, of]), _) => tr!(
                        "load step {step} of {of}, then {n} runs",
                        step = step,
                        of = of,
                        n = all,
                    ),
                    (None, Some(left_s)) => tr!(
                        "{progress}, {time} left",
                        progress = progress.to_string(),
                        time = time_left(left_s),
                    ),
                    (None, None) => progress.to_string(),
                },
                (false, false) => tr!("{done} of {n} runs done", done = done, n = all),
            };
            said = state;
        }
    });
    // On a line of its own, which is there from the start: as it gets longer nothing moves.
    if contests.shown().is_some() {
        ui.add(Label::new(RichText::new(said).color(palette.weak)).truncate());
    }
    if contests.setup.part == ContestPart::Open {
        what_is_compared(ui, session);
    } else if contests.setup.leaves_roughness_out() {
        let text = tr(
            "SDNRP and Tracking set feed and speed by what Ra wants; this part of 2005 has a force to \
                       hold, and its Table 1 does not know them. Off until they are chosen.",
        );
        ui.label(RichText::new(text).small().color(palette.weak));
    }
    for problem in contests.said.iter().chain(&contests.refused) {
        Standing::Bad.label(ui, problem, |text| text);
    }
}

/// Dead time, material, and who takes part.
fn more(ui: &mut Ui, setup: &mut ContestSetup) {
    choose(
        ui,
        tr("Dead time"),
        ContestDeadTime::ALL,
        ContestDeadTime::OPTIONS,
        ContestDeadTime::label,
        &mut setup.dead_time,
    );
    choose(ui, tr("Material"), Stock::ALL, Stock::OPTIONS, Stock::label, &mut setup.stock);
    ui.horizontal_wrapped(|ui| {
        ui.label(tr("Who takes part:"));
        let has_script = setup.has_script();
        for (method, chosen) in methods_and_own().zip(setup.chosen_mut()) {
            if is_own(method) && !has_script {
                continue;
            }
            let choice = touch::choice(ui, *chosen, tr(method.name)).on_hover_text(about(method));
            if choice.clicked() {
                *chosen = !*chosen;
            }
        }
    });
}

/// What a way of control is.
pub fn about(method: &Method) -> String {
    let kind = method.on(&Scenario::default()).scenario.controller.kind;
    let option = ControllerKind::OPTIONS.iter().find(|option| option.id == kind.id());
    option.map_or(String::new(), |option| format!("{}: {}", option.label, option.doc))
}

/// Which cut is compared, and with which settings.
fn what_is_compared(ui: &mut Ui, session: &Session) {
    let weak = Palette::at(ui).weak;
    let name = &session.scenario().info.name;
    let title = presets::title(name).map_or(name.as_str(), tr);
    let edited = !session.edits().list().is_empty();
    let text = match edited || presets::is_changed(session.scenario()) {
        true => tr!(
            "Compared is “{title}, changed” ({name}), from its start, with the settings that the console shows now.",
            title = title,
            name = name,
        ),
        false => tr!(
            "Compared is “{title}” ({name}), from its start, with the settings that the console shows now.",
            title = title,
            name = name,
        ),
    };
    ui.label(RichText::new(text).small().color(weak));
    let changed = not_repeated(session);
    if !changed.is_empty() {
        let text = tr!(
            "Not repeated at their times: {changes}. What the console shows at {time} holds from the start, for \
             everybody.",
            changes = changed.join(", "),
            time = format::time(session.playback().playhead_s),
        );
        Standing::Watch.label(ui, &text, |text| text);
    }
}

/// The settings that were changed in the running cut, each once, with the time of its last change.
fn not_repeated(session: &Session) -> Vec<String> {
    let mut last: Vec<(&str, f64)> = Vec::new();
    for edit in session.edits().list() {
        last.retain(|(path, _)| *path != edit.path);
        last.push((&edit.path, edit.at_s));
    }
    let more = last.len().saturating_sub(MOST_NAMED);
    let named = last.iter().take(MOST_NAMED).map(|(path, at_s)| {
        let name = param(path).map_or(*path, |param| tr(param.spec.label));
        tr!("{name} (last at {time})", name = name, time = format::time(*at_s))
    });
    named.chain((more > 0).then(|| tr!("{n} more", n = more))).collect()
}

/// Changes that are named; the others are counted.
const MOST_NAMED: usize = 4;

/// A button that begins a work, or lets it stand still, by its names for both; whether it was pressed. It is as wide as
/// the longer one, so that nothing moves.
pub fn run_or_pause(
    ui: &mut Ui,
    [run, pause]: [&str; 2],
    help: &str,
    running: bool,
    possible: bool,
) -> bool {
    let font = TextStyle::Button.resolve(ui.style());
    let wide = |text: &str| {
        ui.painter().layout_no_wrap(text.to_owned(), font.clone(), Color32::PLACEHOLDER).size().x
    };
    let width = wide(run).max(wide(pause)) + 2.0 * ui.spacing().button_padding.x;
    let (name, help) = match running {
        true => (pause, tr("Stands still; what is done stays")),
        false => (run, help),
    };
    let button = Button::new(name).min_size(vec2(width, 0.0));
    ui.add_enabled(running || possible, button).on_hover_text(help).clicked()
}

/// A row of choices, one of them taken.
fn choose<T: Copy + PartialEq>(
    ui: &mut Ui,
    title: &str,
    all: &[T],
    options: &[Choice],
    label: fn(T) -> &'static str,
    chosen: &mut T,
) {
    ui.horizontal_wrapped(|ui| {
        ui.label(format!("{title}:"));
        for (value, option) in all.iter().zip(options) {
            let response = ui.selectable_label(*chosen == *value, tr(label(*value)));
            let name = format!("{title}: {}", tr(label(*value)));
            let is = *chosen == *value;
            response.widget_info(|| WidgetInfo::selected(Role::Button, true, is, name.clone()));
            if response.on_hover_text(tr(option.doc).replace('\n', " ")).clicked() {
                *chosen = *value;
            }
        }
    });
}
