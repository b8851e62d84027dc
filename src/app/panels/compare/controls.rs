//! What is compared and how long: part, dead time, material, who takes part, seeds, run and pause.

use egui::{Label, ProgressBar, RichText, Role, Ui, WidgetInfo};

use super::contest::{ContestDeadTime, ContestPart, Contests, Stock, methods};
use crate::app::jobs::time_left;
use crate::app::theme::Palette;
use crate::app::widgets::icon::{self, Icon};
use crate::app::widgets::number::NumberField;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::settings::Choice;
use crate::run::job::Progress;

/// Least and most seeds.
const SEEDS: [u32; 2] = [1, 500];

/// The rows of choices above the table; the open scenario has so many changes in its running cut.
pub fn show(ui: &mut Ui, contests: &mut Contests, edits: usize) {
    let palette = Palette::at(ui);
    let setup = &mut contests.setup;
    choose(ui, "Part", ContestPart::ALL, ContestPart::OPTIONS, ContestPart::label, &mut setup.part);
    choose(
        ui,
        "Dead time",
        ContestDeadTime::ALL,
        ContestDeadTime::OPTIONS,
        ContestDeadTime::label,
        &mut setup.dead_time,
    );
    choose(ui, "Material", Stock::ALL, Stock::OPTIONS, Stock::label, &mut setup.stock);
    ui.horizontal_wrapped(|ui| {
        ui.label("Who takes part:");
        for (method, chosen) in methods().zip(&mut setup.chosen) {
            if touch::choice(ui, *chosen, method.name).clicked() {
                *chosen = !*chosen;
            }
        }
    });
    ui.horizontal_wrapped(|ui| {
        let over = contests.shown().is_some_and(|contest| {
            let runs = contest.runs();
            contest.work.is_over() || runs.done >= runs.total
        });
        let running = contests.shown().is_some_and(|contest| contest.work.is_running());
        let possible = contests.shown().is_some() && !over;
        if running {
            let help = "Stands still; what is done stays";
            if icon::button(ui, Icon::Pause, "Pause the comparison", help, true).clicked() {
                contests.shown().iter().for_each(|contest| contest.work.stop());
            }
        } else {
            let help = "Runs everybody on every seed; it goes on while other screens are shown";
            if icon::button(ui, Icon::Play, "Run the comparison", help, possible).clicked() {
                contests.shown().iter().for_each(|contest| contest.work.go_on());
            }
        }
        let name = ui.label("Seeds").id;
        let field = NumberField {
            name: "Seeds",
            unit: "",
            range: SEEDS.map(f64::from),
            speed: 0.2,
            decimals: 0,
            suffix: "",
        };
        let mut seeds = f64::from(contests.seeds);
        let help = "Every seed is another material and other sensor noise, the same for everybody";
        field.show(ui, &mut seeds, &mut contests.said).labelled_by(name).on_hover_text(help);
        contests.seeds = seeds.round() as u32;
        if let Some(contest) = contests.shown() {
            let progress = contest.runs();
            let Progress { done, total: all, .. } = progress;
            ui.add(
                ProgressBar::new(progress.share() as f32).desired_width(120.0).desired_height(10.0),
            );
            let left = contest
                .work
                .left_s()
                .map_or(String::new(), |left_s| format!(", {} left", time_left(left_s)));
            // The same counts as in the list of what goes on.
            let state = match (over, running) {
                (true, _) => "done".to_owned(),
                (false, true) => match contest.load_steps() {
                    Some([steps, of]) => format!("load step {steps} of {of}, then {all} runs"),
                    None => format!("{progress}{left}"),
                },
                (false, false) => format!("{:.0} of {all} runs done", done.floor()),
            };
            ui.add(Label::new(RichText::new(state).color(palette.weak)).extend());
        }
    });
    if edits > 0 && contests.setup.part == ContestPart::Open {
        let what = if edits == 1 { "change" } else { "changes" };
        let text = format!(
            "The scenario is compared as it starts: {edits} {what} in its running cut left out, since \
             every way of control would have others."
        );
        Standing::Watch.label(ui, &text, |text| text);
    }
    for problem in contests.said.iter().chain(&contests.refused) {
        Standing::Bad.label(ui, problem, |text| text);
    }
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
            let response = ui.selectable_label(*chosen == *value, label(*value));
            let name = format!("{title}: {}", label(*value));
            let is = *chosen == *value;
            response.widget_info(|| WidgetInfo::selected(Role::Button, true, is, name.clone()));
            if response.on_hover_text(option.doc.replace('\n', " ")).clicked() {
                *chosen = *value;
            }
        }
    });
}
