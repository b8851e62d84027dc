//! What an answer came to: stars, what is missing, and what there is to learn.

use egui::{Align, Layout, RichText, Ui};

use super::{formula, paragraphs, told};
use crate::app::format;
use crate::app::theme::{self, Palette};
use crate::app::widgets::icon::{self, Icon};
use crate::app::widgets::standing::Standing;
use crate::base::language::{decimal, tr};
use crate::study::mission::{MOST_STARS, Mission, MissionVerdict, PredictionVerdict, QuestionKind};

/// Shows the verdict; `stale` where something was changed since. Whether it was put away.
pub fn show(ui: &mut Ui, mission: &Mission, verdict: &MissionVerdict, stale: bool) -> bool {
    let palette = Palette::at(ui);
    theme::card(palette)
        .show(ui, |ui| {
            ui.set_width(ui.available_width());
            let closed = head(ui, verdict, stale);
            for prediction in verdict.predictions.iter().filter(|prediction| prediction.answered) {
                let text = foreseen(mission, prediction);
                Standing::either(prediction.right).label(ui, &text, |text| text);
                if !prediction.right {
                    ui.label(told(&prediction.word));
                }
            }
            for check in verdict.checks.iter().filter(|check| !check.holds) {
                Standing::Bad.label(ui, &told(&check.otherwise), |text| text);
            }
            if verdict.passed {
                debrief(ui, mission, palette);
                if verdict.stars < MOST_STARS {
                    more_stars(ui, mission, palette);
                }
            }
            let digest = tr!("Digest of the cut: {digest}", digest = verdict.digest);
            ui.label(RichText::new(digest).small().color(palette.weak));
            closed
        })
        .inner
}

/// Whether it is passed, of which cut that is told, and the button that puts it away; whether that was pressed.
fn head(ui: &mut Ui, verdict: &MissionVerdict, stale: bool) -> bool {
    let row = ui.horizontal(|ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let help = tr("Puts the result away; a check brings the next one");
            let close = icon::button(ui, Icon::Close, tr("Close the result"), help, true);
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                if verdict.passed {
                    let won = tr!(
                        "Passed: {won} of {most} stars",
                        won = verdict.stars,
                        most = MOST_STARS
                    );
                    Standing::Best.label(ui, &won, RichText::strong);
                } else {
                    Standing::Bad.label(ui, tr("Not passed yet"), RichText::strong);
                }
            });
            close.clicked()
        })
        .inner
    });
    let closed = row.inner;
    if stale {
        let words = tr("This is of before your last change: check again.");
        Standing::Watch.label(ui, words, RichText::strong);
    }
    closed
}

/// Whether a prediction was right, and by how much it was off.
fn foreseen(mission: &Mission, prediction: &PredictionVerdict) -> String {
    let step = prediction.step;
    let question = mission.questions().find(|(number, _)| *number == step);
    let is_curve =
        question.is_some_and(|(_, question)| matches!(question.kind, QuestionKind::Curve { .. }));
    let off = |off: f64| {
        let percent = format::beside(format!("{:.0}", off.abs()), "%");
        match (is_curve, off < 0.0) {
            _ if off.abs() < 0.5 => tr("exactly").to_owned(),
            (true, _) => tr!("off the curve by {percent} of its height", percent = percent),
            (false, true) => tr!("{percent} below the true value", percent = percent),
            (false, false) => tr!("{percent} above the true value", percent = percent),
        }
    };
    if prediction.late {
        return match prediction.right {
            true => tr!(
                "Your answer in step {step} is right; it came when the cut had been seen",
                step = step
            ),
            false => tr!("Your answer in step {step} is wrong", step = step),
        };
    }
    match (prediction.right, prediction.off_percent.map(off)) {
        (true, None) => tr!("Your prediction in step {step} was right", step = step),
        (false, None) => tr!("Your prediction in step {step} was wrong", step = step),
        (true, Some(off)) => {
            tr!("Your prediction in step {step} was right ({off})", step = step, off = off)
        }
        (false, Some(off)) => {
            tr!("Your prediction in step {step} was wrong ({off})", step = step, off = off)
        }
    }
}

fn debrief(ui: &mut Ui, mission: &Mission, palette: &Palette) {
    let debrief = &mission.debrief;
    ui.add_space(4.0);
    paragraphs(ui, &debrief.text);
    if !debrief.formula.is_empty() {
        formula::show(ui, &debrief.formula);
    }
    if !debrief.source.is_empty() {
        ui.label(RichText::new(tr(&debrief.source)).small().color(palette.weak));
    }
}

fn more_stars(ui: &mut Ui, mission: &Mission, palette: &Palette) {
    let [two, three] = &mission.stars;
    let asked = two.iter().chain(three).map(|asked| mission.in_words(asked, &written));
    let predicted = tr("predictions that are right, made before the cut").to_owned();
    ui.label(RichText::new(tr("For all three stars:")).small().color(palette.weak));
    for asked in asked.chain([predicted]) {
        let line = RichText::new(format!("\u{2022} {asked}")).small().color(palette.weak);
        ui.label(line);
    }
}

/// A number of a mission's file with its unit.
fn written(number: &str, unit: &str) -> String {
    format::beside(format::signed(decimal(number.to_owned())), &format::unit(unit))
}
