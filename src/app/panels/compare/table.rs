//! The table: a grid on a desktop, a card for everybody where it is narrow. Beside each mean its
//! deviation over the seeds, below it what is printed.

use egui::{Button, RichText, Role, ScrollArea, TextWrapMode, Ui, WidgetInfo};

use super::contest::Contest;
use crate::app::command::{Command, SessionCommand, ShellCommand};
use crate::app::format;
use crate::app::theme::{self, Palette};
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::blocks::reference::Reference;
use crate::run::edits::Edits;
use crate::run::scenario_file;
use crate::study::compare::entrants::Entrant;
use crate::study::compare::outcome::Measure;
use crate::study::compare::spread::Spread;
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

/// A measure's name with its unit, where `reference` is to be held.
pub fn title(measure: Measure, reference: Reference) -> String {
    let name = measure.name(reference);
    match measure.unit() {
        "" => name.to_owned(),
        unit => format!("{name} [{unit}]"),
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

/// The deviation of fewer seeds says next to nothing (chosen).
const LEAST_SEEDS: usize = 3;

/// Who is best in a measure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Leader {
    /// Its place in the table.
    index: usize,
    /// Whether it leads by more than both spreads, its own and that of the next one: then mean and standard
    /// deviation of one do not reach those of the other.
    clear: bool,
}

/// Who leads in a measure, where there is anything to compare; in what is no gain outside the tolerance, among
/// those that hold it. None while a spread is not known, with less than [`LEAST_SEEDS`] runs.
fn leader(compared: &[Compared], measure: Measure) -> Option<Leader> {
    let ranked = compared.iter().enumerate();
    let ranked = ranked.filter(|(_, one)| !measure.needs_tolerance() || holds(one));
    let mut means: Vec<(usize, Spread)> =
        ranked.filter_map(|(index, one)| Some((index, one.get(measure)?))).collect();
    let sign = if measure.more_is_better() { -1.0 } else { 1.0 };
    means.sort_by(|(_, a), (_, b)| (sign * a.mean).total_cmp(&(sign * b.mean)));
    let [(index, first), (_, second), ..] = means[..] else { return None };
    let known = means.iter().all(|(_, spread)| spread.runs >= LEAST_SEEDS);
    let lead = (second.mean - first.mean).abs();
    known.then_some(Leader { index, clear: lead > first.deviation + second.deviation })
}

struct Figure {
    mean: String,
    deviation: String,
    /// What is printed of it, or that its lead is none.
    below: Vec<String>,
    is_best: bool,
}

fn figure(
    (index, one): (usize, &Compared),
    all: &[Compared],
    measure: Measure,
    printed: Option<&Table1Printed>,
) -> Figure {
    let printed = printed.and_then(|row| row.get(measure));
    let Some(spread) = one.get(measure) else {
        let below = printed.map(|printed| as_printed(measure, printed)).into_iter().collect();
        return Figure { mean: "-".to_owned(), deviation: String::new(), below, is_best: false };
    };
    let deviation = match spread.runs {
        1 => String::new(),
        _ => format!("± {}", value(measure, spread.deviation)),
    };
    let printed = printed.map(|printed| {
        let off = format::deviation(100.0 * (spread.mean / printed - 1.0));
        format!("{}, {off}", as_printed(measure, printed))
    });
    let leads = leader(all, measure).filter(|leader| leader.index == index);
    let within = leads.filter(|leader| !leader.clear).map(|_| WITHIN.to_owned());
    let below = printed.into_iter().chain(within).collect();
    let is_best = leads.is_some_and(|leader| leader.clear);
    Figure { mean: value(measure, spread.mean), deviation, below, is_best }
}

/// What is said of the best mean of a column that leads by less than the spread.
const WITHIN: &str = "best, within the spread";

/// Mean with its deviation, and the lines below.
fn figure_lines(ui: &mut Ui, figure: &Figure) {
    let weak = Palette::at(ui).weak;
    ui.vertical(|ui| {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            // Room for both numbers from the first run on: a column that grows is drawn once over the next.
            ui.set_min_width(FIGURE_WIDTH);
            let standing = if figure.is_best { Standing::Best } else { Standing::Plain };
            standing.label(ui, &figure.mean, RichText::strong);
            ui.label(RichText::new(&figure.deviation).small().color(weak));
        });
        for line in &figure.below {
            ui.label(RichText::new(line).small().color(weak));
        }
    });
}

/// Width of a mean with its sign and deviation, points.
const FIGURE_WIDTH: f32 = 96.0;

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
pub fn table(ui: &mut Ui, contest: &Contest, belongs: bool, commands: &mut Vec<Command>) {
    let (entrants, compared) = (contest.entrants(), contest.table());
    ScrollArea::horizontal().id_salt("compared").show(ui, |ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
        touch::grid(ui, "compared").striped(true).spacing([14.0, 6.0]).show(ui, |ui| {
            ui.strong("Control");
            ui.label("");
            for measure in Measure::ALL {
                let text = RichText::new(title(*measure, contest.reference())).strong();
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
                    figure_lines(ui, &figure((index, one), compared, *measure, printed));
                }
                ui.end_row();
            }
        });
    });
    notes(ui, contest);
}

/// What the figures are.
fn notes(ui: &mut Ui, contest: &Contest) {
    let weak = Palette::at(ui).weak;
    let text = "Mean and standard deviation over the seeds. A star marks the best of a column where it leads \
                by more than both deviations together; with less than three seeds no spread is known, and nobody \
                leads.";
    let ranking = ranking(contest.table(), contest.reference());
    for text in [text, ranking.as_str()] {
        ui.label(RichText::new(text).small().color(weak));
    }
}

/// Who is ranked by more than the errors, in words.
fn ranking(compared: &[Compared], reference: Reference) -> String {
    let holding: Vec<&str> =
        compared.iter().filter(|one| holds(one)).map(|one| one.name.as_str()).collect();
    let named: Vec<&str> = Measure::ALL
        .iter()
        .filter(|m| m.needs_tolerance())
        .map(|measure| measure.name(reference))
        .collect();
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

/// The table as a card for everybody, as wide as a phone.
pub fn cards(ui: &mut Ui, contest: &Contest, belongs: bool, commands: &mut Vec<Command>) {
    let palette = Palette::at(ui);
    let (entrants, compared) = (contest.entrants(), contest.table());
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
            let grid = touch::grid(ui, ("compared", index)).num_columns(2).spacing([8.0, 2.0]);
            grid.show(ui, |ui| {
                for measure in Measure::ALL {
                    let title = title(*measure, contest.reference());
                    ui.label(RichText::new(title).small()).on_hover_text(doc(*measure));
                    figure_lines(ui, &figure((index, one), compared, *measure, printed));
                    ui.end_row();
                }
            });
        });
    }
    notes(ui, contest);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::job::Job;
    use crate::run::presets;
    use crate::study::compare::entrants::Method;
    use crate::study::compare::tournament::Tournament;

    /// Two who differ in nothing, and one who does not control at all.
    fn table(seeds: u32) -> Vec<Compared> {
        let mut base = presets::load("table3-5-noise").unwrap();
        base.change(|settings| settings.run.duration_s = 2.0).unwrap();
        let sdnrp = Method { id: "a", name: "A", apply: |s| s.controller.sdnrp.kp = 0.5 };
        let same = Method { id: "b", name: "B", apply: |s| s.controller.sdnrp.kp = 0.501 };
        let wild = Method { id: "c", name: "C", apply: |s| s.controller.sdnrp.kp = 3.0 };
        let mut tournament =
            Tournament::new([same, sdnrp, wild].map(|m| m.on(&base)).to_vec(), seeds);
        tournament.to_end();
        tournament.table()
    }

    #[test]
    fn a_lead_counts_only_beyond_the_spread_and_where_there_is_one() {
        let several = table(3);
        let led = leader(&several, Measure::Nsn).unwrap();
        assert!(
            !led.clear,
            "{:?}",
            several.iter().map(|one| one.get(Measure::Nsn)).collect::<Vec<_>>()
        );
        let told = figure((led.index, &several[led.index]), &several, Measure::Nsn, None);
        assert!(!told.is_best && told.below == [WITHIN]);
        // Without the one that is as good, the lead over the wild one is clear.
        let two = [several[0].clone(), several[2].clone()];
        assert_eq!(leader(&two, Measure::Nsn), Some(Leader { index: 0, clear: true }));
        assert!(figure((0, &two[0]), &two, Measure::Nsn, None).is_best);
        for seeds in [1, 2] {
            assert_eq!(leader(&table(seeds), Measure::Nsn), None, "{seeds} have no spread");
        }
        assert_eq!(leader(&several[..1], Measure::Nsn), None);
    }
}
