//! The table: a grid on a desktop, a card for everybody where it is narrow. Beside each mean its
//! deviation over the seeds, below it what is printed.

use egui::{Button, RichText, Role, ScrollArea, TextWrapMode, Ui, WidgetInfo};

use crate::app::command::{Command, SessionCommand, ShellCommand};
use crate::app::format;
use crate::app::theme::{self, Palette};
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::run::edits::Edits;
use crate::run::scenario_file;
use crate::study::compare::entrants::Entrant;
use crate::study::compare::outcome::Measure;
use crate::study::compare::table_1::{self, Table1Printed};
use crate::study::compare::tournament::Compared;

/// A value of a measure with its digits.
pub fn value(measure: Measure, value: f64) -> String {
    let decimals = match measure {
        Measure::Nsn | Measure::Nsn20 => 3,
        Measure::Force => 2,
        Measure::Time | Measure::InTolerance | Measure::Held | Measure::Travel => 1,
        Measure::Recovery => 0,
    };
    format!("{value:.decimals$}")
}

/// A printed figure with the digits of the table.
fn as_printed(measure: Measure, value: f64) -> String {
    let decimals = if measure == Measure::Time { 0 } else { 2 };
    format!("printed {value:.decimals$}")
}

/// A measure's name with its unit.
pub fn title(measure: Measure) -> String {
    match measure.unit() {
        "" => measure.label().to_owned(),
        unit => format!("{} [{unit}]", measure.label()),
    }
}

/// The printed row of an entrant, if the table has one and belongs here.
pub fn printed_of(name: &str, belongs: bool) -> Option<&'static Table1Printed> {
    table_1::printed_of(name).filter(|_| belongs)
}

/// Fraction of the length in tolerance from which on it counts as held, percent, as on the console.
const HELD_PERCENT: f64 = 90.0;

/// Whether it holds the tolerance in the mean over its seeds.
fn holds(one: &Compared) -> bool {
    one.get(Measure::InTolerance).is_some_and(|spread| spread.mean >= HELD_PERCENT)
}

/// The best mean of a measure where there is anything to compare: of what is no gain outside the
/// tolerance, among those that hold it.
fn best(compared: &[Compared], measure: Measure) -> Option<f64> {
    let ranked = compared.iter().filter(|one| !measure.needs_tolerance() || holds(one));
    let means: Vec<f64> = ranked.filter_map(|one| one.get(measure)).map(|s| s.mean).collect();
    let pick = if measure.more_is_better() { f64::max } else { f64::min };
    (means.len() > 1).then(|| means.into_iter().reduce(pick)).flatten()
}

struct Figure {
    mean: String,
    deviation: String,
    printed: Option<String>,
    is_best: bool,
}

fn figure(
    one: &Compared,
    all: &[Compared],
    measure: Measure,
    printed: Option<&Table1Printed>,
) -> Figure {
    let printed = printed.and_then(|row| row.get(measure));
    let Some(spread) = one.get(measure) else {
        let printed = printed.map(|printed| as_printed(measure, printed));
        return Figure { mean: "-".to_owned(), deviation: String::new(), printed, is_best: false };
    };
    let deviation = match spread.runs {
        1 => String::new(),
        _ => format!("± {}", value(measure, spread.deviation)),
    };
    let printed = printed.map(|printed| {
        let off = format::deviation(100.0 * (spread.mean / printed - 1.0));
        format!("{}, {off}", as_printed(measure, printed))
    });
    let ranked = !measure.needs_tolerance() || holds(one);
    let is_best = ranked && best(all, measure) == Some(spread.mean);
    Figure { mean: value(measure, spread.mean), deviation, printed, is_best }
}

fn mean_line(ui: &mut Ui, figure: &Figure) {
    let standing = if figure.is_best { Standing::Best } else { Standing::Plain };
    standing.label(ui, &figure.mean, RichText::strong);
}

/// The button that loads an entrant's scenario into the console.
fn load(ui: &mut Ui, entrants: &[Entrant], index: usize, commands: &mut Vec<Command>) {
    let entrant = &entrants[index];
    let button = ui.add(touch::small(ui, Button::new("Load")));
    let name = format!("Load {}", entrant.name);
    button.widget_info(|| WidgetInfo::labeled(Role::Button, true, name.clone()));
    if button.on_hover_text("Opens this run in the console").clicked() {
        let named = format!("{} ({})", entrant.scenario.info.name, entrant.name);
        let scenario = match entrant.scenario.with(|settings| settings.info.name = named) {
            Ok(scenario) => scenario,
            Err(refused) => return commands.push(Command::notify(refused.to_string())),
        };
        let text = scenario_file::write(&scenario, &Edits::none());
        commands
            .push(Command::Session(SessionCommand::LoadText { name: entrant.name.clone(), text }));
        commands.push(Command::Shell(ShellCommand::ShowScreen("console")));
    }
}

/// What did not go as it should, in words.
fn trouble(one: &Compared) -> Option<String> {
    let unfinished = one.runs - one.finished;
    match (one.force_stops, unfinished) {
        (0, 0) => None,
        (0, n) => Some(format!("{n} of {} not finished", one.runs)),
        (n, _) => Some(format!("{n} of {} stopped by overload", one.runs)),
    }
}

/// The table as a grid.
pub fn table(
    ui: &mut Ui,
    entrants: &[Entrant],
    compared: &[Compared],
    belongs: bool,
    commands: &mut Vec<Command>,
) {
    let palette = Palette::at(ui);
    ScrollArea::horizontal().id_salt("compared").show(ui, |ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
        touch::grid(ui, "compared").striped(true).spacing([18.0, 6.0]).show(ui, |ui| {
            ui.strong("Control");
            ui.label("");
            for measure in Measure::ALL {
                let text = RichText::new(title(*measure)).strong();
                ui.label(text).on_hover_text(doc(*measure));
            }
            ui.end_row();
            for (index, one) in compared.iter().enumerate() {
                let printed = printed_of(&one.name, belongs);
                ui.vertical(|ui| {
                    ui.horizontal(|ui| ui.strong(&one.name));
                    if let Some(trouble) = trouble(one) {
                        Standing::Bad.label(ui, &trouble, RichText::small);
                    }
                });
                // At the height of the name.
                ui.vertical(|ui| ui.horizontal(|ui| load(ui, entrants, index, commands)));
                for measure in Measure::ALL {
                    let figure = figure(one, compared, *measure, printed);
                    ui.vertical(|ui| {
                        ui.horizontal(|ui| {
                            ui.spacing_mut().item_spacing.x = 4.0;
                            mean_line(ui, &figure);
                            ui.label(RichText::new(&figure.deviation).small().color(palette.weak));
                        });
                        if let Some(printed) = &figure.printed {
                            ui.label(RichText::new(printed).small().color(palette.weak));
                        }
                    });
                }
                ui.end_row();
            }
        });
    });
    let text = "Mean and standard deviation over the seeds; a star marks the best of a column.";
    ui.label(RichText::new(text).small().color(palette.weak));
    ui.label(RichText::new(ranking(compared)).small().color(palette.weak));
}

/// Who is ranked by more than the errors, in words.
fn ranking(compared: &[Compared]) -> String {
    let holding: Vec<&str> =
        compared.iter().filter(|one| holds(one)).map(|one| one.name.as_str()).collect();
    let named: Vec<String> =
        Measure::ALL.iter().filter(|m| m.needs_tolerance()).map(|m| m.label().to_owned()).collect();
    let columns = named.join(", ");
    if compared.iter().all(|one| one.get(Measure::InTolerance).is_none()) {
        // Nothing is known of anybody yet.
        return format!("{columns} are ranked only among those that hold the tolerance.");
    }
    match holding[..] {
        [] => format!(
            "Nobody holds the tolerance on {HELD_PERCENT} % of the length: {columns} have no best, \
             since they are no gain outside it."
        ),
        [..] => format!(
            "{columns} are ranked among those that hold the tolerance on {HELD_PERCENT} % of the \
             length: {}.",
            holding.join(", ")
        ),
    }
}

fn doc(measure: Measure) -> String {
    let option = Measure::OPTIONS.iter().find(|option| option.id == measure.id());
    option.map_or_else(String::new, |option| option.doc.replace('\n', " "))
}

/// The table as a card for everybody.
pub fn cards(
    ui: &mut Ui,
    entrants: &[Entrant],
    compared: &[Compared],
    belongs: bool,
    commands: &mut Vec<Command>,
) {
    let palette = Palette::at(ui);
    for (index, one) in compared.iter().enumerate() {
        let printed = printed_of(&one.name, belongs);
        theme::card(palette).show(ui, |ui| {
            ui.set_width(ui.available_width());
            ui.horizontal(|ui| {
                ui.strong(&one.name);
                load(ui, entrants, index, commands);
            });
            if let Some(trouble) = trouble(one) {
                Standing::Bad.label(ui, &trouble, RichText::small);
            }
            ui.spacing_mut().interact_size.y = 18.0;
            touch::grid(ui, ("compared", index)).num_columns(3).spacing([8.0, 2.0]).show(
                ui,
                |ui| {
                    for measure in Measure::ALL {
                        let figure = figure(one, compared, *measure, printed);
                        ui.label(RichText::new(title(*measure)).small())
                            .on_hover_text(doc(*measure));
                        ui.horizontal(|ui| {
                            ui.spacing_mut().item_spacing.x = 4.0;
                            mean_line(ui, &figure);
                            ui.label(RichText::new(&figure.deviation).small().color(palette.weak));
                        });
                        let printed = figure.printed.unwrap_or_default();
                        ui.label(RichText::new(printed).small().color(palette.weak));
                        ui.end_row();
                    }
                },
            );
        });
    }
    ui.label(RichText::new(ranking(compared)).small().color(palette.weak));
}
