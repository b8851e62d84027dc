//! Predictions: a choice, a number, or a curve that is sketched.

use egui::{RichText, Ui};

use super::{note_place, sketch, told};
use crate::app::command::Command;
use crate::app::format;
use crate::app::session::Session;
use crate::app::widgets::number::NumberField;
use crate::base::language::tr;
use crate::study::mission::{Prediction, Question, QuestionKind};

/// Shows a question with what was answered; gives the answer as it is now, if there is one.
pub fn show(
    ui: &mut Ui,
    question: &Question,
    given: Option<&Prediction>,
    session: &Session,
    commands: &mut Vec<Command>,
) -> Option<Prediction> {
    ui.label(told(&question.ask));
    if question.must {
        ui.label(RichText::new(tr("The right answer is needed to pass.")).small());
    }
    match &question.kind {
        QuestionKind::Choice(options) => {
            let mut chosen = match given {
                Some(Prediction::Choice(number)) => Some(*number),
                Some(Prediction::Number(_) | Prediction::Curve(_)) | None => None,
            };
            for (number, option) in (1..).zip(options) {
                let choice = ui.radio(chosen == Some(number), told(&option.text));
                note_place(ui, &format!("option {number}"), &choice);
                if choice.clicked() {
                    chosen = Some(number);
                }
            }
            chosen.map(Prediction::Choice)
        }
        QuestionKind::Number { unit, .. } => number(ui, unit, given, commands),
        QuestionKind::Curve { of, .. } => {
            let points = match given {
                Some(Prediction::Curve(points)) => points.as_slice(),
                Some(Prediction::Choice(_) | Prediction::Number(_)) | None => &[],
            };
            sketch::show(ui, of, points, session).map(Prediction::Curve)
        }
    }
}

/// A number with its unit; what is not touched is not answered.
fn number(
    ui: &mut Ui,
    unit: &str,
    given: Option<&Prediction>,
    commands: &mut Vec<Command>,
) -> Option<Prediction> {
    /// Beyond what any question asks for.
    const MOST: f64 = 1e6;
    let before = match given {
        Some(Prediction::Number(number)) => Some(*number),
        Some(Prediction::Choice(_) | Prediction::Curve(_)) | None => None,
    };
    let mut value = before;
    let mut said = None;
    ui.horizontal_wrapped(|ui| {
        let label = ui.label(tr("Your prediction"));
        let field = NumberField {
            name: tr("Prediction"),
            unit: "",
            range: [-MOST, MOST],
            speed: 0.1,
            decimals: 3,
            least: 0,
            suffix: "",
        };
        let field = field.show_or_blank(ui, &mut value, &mut said).labelled_by(label.id);
        note_place(ui, "number", &field);
        ui.label(format::unit(unit));
    });
    commands.extend(said.map(Command::notify));
    value.map(Prediction::Number)
}
