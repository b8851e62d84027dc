//! What an answer came to: stars, what is missing, and what there is to learn.

use egui::{Align, Layout, RichText, Ui};

use super::{formula, paragraphs, told};
use crate::app::format;
use crate::app::theme::{self, Palette};
use crate::app::widgets::icon::{self, Icon};
use crate::app::widgets::standing::Standing;
use crate::base::language::{decimal, tr};
use crate::study::mission::{
    MOST_STARS, Mission, MissionTries, MissionVerdict, PredictionVerdict, QuestionKind,
};

/// Shows the verdict; `stale` where something was changed since. Whether it was put away.
pub fn show(
    ui: &mut Ui,
    mission: &Mission,
    verdict: &MissionVerdict,
    stale: bool,
    tries: MissionTries,
) -> bool {
    let palette = Palette::at(ui);
    theme::card(palette)
        .show(ui, |ui| {
            ui.set_width(ui.available_width());
            let closed = head(ui, verdict, stale);
            for prediction in &verdict.predictions {
                let text = foreseen(mission, prediction, verdict.passed);
                let standing = match (prediction.answered, prediction.is_foreseen()) {
                    (false, _) => Standing::Watch,
                    (true, true) => Standing::Good,
                    (true, false) if prediction.right => Standing::Watch,
                    (true, false) => Standing::Bad,
                };
                standing.label(ui, &text, |text| text);
                if !prediction.right && !prediction.word.is_empty() {
                    ui.label(told(&prediction.word));
                }
            }
            if let Some(fault) = &verdict.script_fault {
                Standing::Bad.label(ui, fault, |text| text);
            }
            for check in verdict.checks.iter().filter(|check| !check.holds) {
                Standing::Bad.label(ui, &told(&check.otherwise), |text| text);
            }
            if verdict.passed {
                if verdict.stars < MOST_STARS {
                    more_stars(ui, mission, verdict);
                }
                debrief(ui, mission, palette);
            }
            let small = |text: String| RichText::new(text).small().color(palette.weak);
            ui.label(small(tr!(
                "Tries: begun {begun}, checked {checked}",
                begun = tries.begun,
                checked = tries.checked
            )));
            let digest = tr!("Digest of the cut: {digest}", digest = verdict.digest);
            ui.label(small(digest));
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

/// By how much a number or a curve was off. What the true number is, is told once the mission is passed: until then
/// that it is too high or too low, since by how much gives the true one away.
fn off(mission: &Mission, prediction: &PredictionVerdict, passed: bool) -> Option<String> {
    let off = prediction.off_percent?;
    let (_, question) = mission.questions().find(|(number, _)| *number == prediction.step)?;
    let percent = |of: f64| format::beside(decimal(of.to_string()), "%");
    let words = match &question.kind {
        QuestionKind::Choice(_) => return None,
        QuestionKind::Curve { .. } => {
            let percent = percent(off.round());
            tr!("off the curve by {percent} of its height", percent = percent)
        }
        QuestionKind::Number { tolerance_percent, .. } => {
            let tolerance = percent(*tolerance_percent);
            match (prediction.right, off < 0.0) {
                (true, _) => tr!("within {tolerance} of the true value", tolerance = tolerance),
                (false, true) => {
                    tr!("too low; allowed is {tolerance} to either side", tolerance = tolerance)
                }
                (false, false) => {
                    tr!("too high; allowed is {tolerance} to either side", tolerance = tolerance)
                }
            }
        }
    };
    let is_number = question.kind.is_number();
    let truth = true_number(&prediction.solution).filter(|_| is_number && passed);
    Some(match truth {
        Some(truth) => tr!("{words}; the true value is {truth}", words = words, truth = truth),
        None => words,
    })
}

/// A right answer that is a number with its unit, in as many digits as people read.
fn true_number(solution: &str) -> Option<String> {
    let (number, unit) = solution.split_once(' ')?;
    Some(format::fine(number.parse().ok()?, unit))
}

/// Whether a prediction was right, and by how much it was off.
fn foreseen(mission: &Mission, prediction: &PredictionVerdict, passed: bool) -> String {
    let step = prediction.step;
    if !prediction.answered {
        let asked = mission.questions().find(|(number, _)| *number == step);
        return match asked.is_some_and(|(_, question)| question.look_up) {
            true => {
                tr!("No answer was given in step {step}: that costs the third star", step = step)
            }
            false => {
                tr!("No prediction was made in step {step}: that costs the third star", step = step)
            }
        };
    }
    let off = |_: f64| off(mission, prediction, passed).unwrap_or_default();
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
        formula::show(ui, tr(&debrief.formula));
    }
    if !debrief.source.is_empty() {
        ui.label(RichText::new(tr(&debrief.source)).small().color(palette.weak));
    }
}

/// What all three stars ask for: what of it is reached, and what is missed with the learner's own value.
fn more_stars(ui: &mut Ui, mission: &Mission, verdict: &MissionVerdict) {
    ui.add_space(4.0);
    ui.label(RichText::new(tr("For all three stars:")).small().strong());
    let line = |ui: &mut Ui, holds: bool, words: &str| {
        let words = match holds {
            true => tr!("reached: {condition}", condition = words),
            false => tr!("missed: {condition}", condition = words),
        };
        Standing::either(holds).label(ui, &words, RichText::small);
    };
    let conditions = mission.stars.iter().flatten();
    for (condition, asked) in conditions.zip(&verdict.stars_asked) {
        let words = mission.in_words(condition, &written);
        let own = mission.came_to(condition, asked.sides, &written);
        line(ui, asked.holds, &format!("{words} ({own})"));
    }
    line(ui, verdict.is_foreseen(), tr("predictions that are right, made before the cut"));
}

/// A number of a mission's file with its unit.
fn written(number: &str, unit: &str) -> String {
    format::beside(format::signed(decimal(number.to_owned())), &format::unit(unit))
}
