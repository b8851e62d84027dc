//! The table: a grid on a desktop, a card for everybody where it is narrow. Beside each mean its
//! deviation over the seeds, below it what is printed.

use egui::{Button, CollapsingHeader, RichText, Role, TextWrapMode, Ui, WidgetInfo};

use super::contest::Contest;
use crate::app::command::{Command, SessionCommand, ShellCommand};
use crate::app::format;
use crate::app::theme::{self, Palette};
use crate::app::widgets::scaffold;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::language::{fixed, text, tr};
use crate::blocks::reference::Reference;
use crate::run::edits::Edits;
use crate::run::metrics::HELD_PERCENT;
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
    fixed(value, decimals)
}

/// A printed figure with the digits of the table.
fn as_printed(measure: Measure, value: f64) -> String {
    let decimals = if measure == Measure::Time { 0 } else { 2 };
    tr!("printed {value}", value = fixed(value, decimals))
}

/// A measure's name with its unit, where `reference` is to be held.
pub fn title(measure: Measure, reference: Reference) -> String {
    let name = tr(measure.name(reference));
    match measure.unit() {
        "" => name.to_owned(),
        unit => format!("{name} [{}]", tr(unit)),
    }
}

/// The printed row of an entrant, if the table has one and belongs here.
pub fn printed_of(name: &str, belongs: bool) -> Option<&'static Table1Printed> {
    table_1::printed_of(name).filter(|_| belongs)
}

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
    // Runs that no seed changes have no spread, and that is known of two.
    let same = compared.iter().filter(|one| one.runs > 0).all(|one| one.same);
    let known = same || means.iter().all(|(_, spread)| spread.runs >= LEAST_SEEDS);
    let lead = (second.mean - first.mean).abs();
    // Two that are written alike are no first and second.
    let seen = value(measure, first.mean) != value(measure, second.mean);
    known.then_some(Leader { index, clear: seen && lead > first.deviation + second.deviation })
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
    let deviation = match spread.runs > 1 && !one.same {
        true => format!("± {}", value(measure, spread.deviation)),
        false => String::new(),
    };
    let printed = printed.map(|printed| {
        let off = format::deviation(100.0 * (spread.mean / printed - 1.0));
        format!("{}, {off}", as_printed(measure, printed))
    });
    let leads = leader(all, measure).filter(|leader| leader.index == index);
    let within = leads.filter(|leader| !leader.clear).map(|_| tr(WITHIN).to_owned());
    let below = printed.into_iter().chain(within).collect();
    let is_best = leads.is_some_and(|leader| leader.clear);
    Figure { mean: value(measure, spread.mean), deviation, below, is_best }
}

/// What is said of the best mean of a column that leads by less than the spread.
const WITHIN: &str = text!("best, within the spread");

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
    let button = ui.add(touch::small(ui, Button::new(tr("Load"))));
    let name = tr!("Load {name}", name = tr(&entrant.name));
    button.widget_info(|| WidgetInfo::labeled(Role::Button, true, name.clone()));
    if button
        .on_hover_text(tr(
            "Opens the cut in the console with this way of control, and the seed that is set there",
        ))
        .clicked()
    {
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
fn troubles(one: &Compared) -> impl Iterator<Item = String> {
    let (all, unfinished) = (one.runs, one.runs - one.finished);
    let ended = match (one.force_stops, unfinished) {
        (0, 0) => None,
        (0, n) => Some(tr!("{n} of {all} not finished", n = n, all = all)),
        (n, _) => Some(tr!("{n} of {all} stopped by overload", n = n, all = all)),
    };
    let unstable =
        (one.unstable > 0).then(|| tr!("{n} of {all} unstable", n = one.unstable, all = all));
    let chattered =
        (one.chattered > 0).then(|| tr!("{n} of {all} chattered", n = one.chattered, all = all));
    ended.into_iter().chain(unstable).chain(chattered)
}

/// The table as a grid.
pub fn table(ui: &mut Ui, contest: &Contest, belongs: bool, commands: &mut Vec<Command>) {
    let (entrants, compared) = (contest.entrants(), contest.table());
    scaffold::across(ui, "compared", |ui| {
        ui.style_mut().wrap_mode = Some(TextWrapMode::Extend);
        touch::grid(ui, "compared").striped(true).spacing([14.0, 6.0]).show(ui, |ui| {
            ui.strong(tr("Control"));
            ui.label("");
            for measure in Measure::ALL {
                let text = RichText::new(title(*measure, contest.reference())).strong();
                ui.label(text).on_hover_text(doc(*measure));
            }
            ui.end_row();
            for (index, one) in compared.iter().enumerate() {
                let printed = printed_of(&one.name, belongs);
                ui.vertical(|ui| {
                    ui.horizontal(|ui| ui.strong(tr(&one.name)));
                    for trouble in troubles(one) {
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

/// What the figures are, and why those do not hold the tolerance that do not: below the table, which is in sight at once.
fn notes(ui: &mut Ui, contest: &Contest) {
    let weak = Palette::at(ui).weak;
    let lines: Vec<String> = why(contest).collect();
    if !lines.is_empty() {
        let head = CollapsingHeader::new(tr("Why not all hold the tolerance"));
        head.id_salt("why not all hold").show(ui, |ui| {
            for line in lines {
                ui.label(RichText::new(line).color(weak));
            }
        });
    }
    let mut told = vec![
        tr("Mean and standard deviation over the seeds. A star marks the best of a column where it leads \
            by more than both deviations together; with less than three seeds no spread is known, and nobody \
            leads. Nsn: normalised standard error, how far the force strays from its reference, less is better.")
        .to_owned(),
    ];
    let ranked = Measure::ALL.iter().filter(|measure| measure.needs_tolerance());
    let columns: Vec<&str> = ranked.map(|measure| tr(measure.name(contest.reference()))).collect();
    told.push(tr!(
        "{columns} are ranked only among those that hold the tolerance: outside it they are no gain.",
        columns = columns.join(", "),
    ));
    if contest.teaches_in() {
        let text = tr(
            "AFC has no reference forces here: it is taught in, with the feed as programmed. Teach it in \
                       in the console's window AFC.",
        );
        told.push(text.to_owned());
    }
    for text in told {
        ui.label(RichText::new(text).small().color(weak));
    }
}

/// Who holds the tolerance, above the table, and whether the seeds make any difference.
pub fn summary(ui: &mut Ui, contest: &Contest) {
    let holding = holding(contest.table());
    let begun = contest.table().iter().any(|one| one.runs > 0);
    let text = match contest.not_whole().filter(|_| begun) {
        Some(done) => tr!("So far, {done}: {ranking}", done = done, ranking = holding),
        None => holding,
    };
    ui.label(text);
    if let Some(text) = least_straying(contest.table()) {
        ui.label(text);
    }
    if no_spread(contest.table()) {
        let text =
            tr("Every seed gave the same run, since nothing random acts here: there is no spread.");
        ui.label(RichText::new(text).color(Palette::at(ui).weak));
    }
}

/// Whose force strays least, in words: what makes a controller better than others that hold the tolerance too.
fn least_straying(compared: &[Compared]) -> Option<String> {
    // Among those that hold the tolerance, where any does: straying less is no merit of who does not.
    let holding: Vec<Compared> = compared.iter().filter(|one| holds(one)).cloned().collect();
    let among = if holding.is_empty() { compared } else { &holding };
    let leader = leader(among, Measure::Nsn)?;
    let first = &among[leader.index];
    let nsn = value(Measure::Nsn, first.get(Measure::Nsn)?.mean);
    let told = tr!(
        "the force strays least from its reference with {controller}: its normalised standard error, Nsn, is {nsn}, 0 is perfect",
        controller = tr(&first.name),
        nsn = nsn,
    );
    Some(match (holding.is_empty(), leader.clear) {
        (false, true) => tr!("Of those, {told}.", told = told),
        (false, false) => tr!("Of those, {told}; the lead is within the spread.", told = told),
        (true, true) => tr!("Of all, {told}.", told = told),
        (true, false) => tr!("Of all, {told}; the lead is within the spread.", told = told),
    })
}

/// Whether the seeds are known to change nothing for anybody.
pub fn no_spread(compared: &[Compared]) -> bool {
    let mut ran = compared.iter().filter(|one| one.runs > 1).peekable();
    ran.peek().is_some() && ran.all(|one| one.same)
}

/// Why those do not hold the tolerance that do not, a line each.
fn why(contest: &Contest) -> impl Iterator<Item = String> {
    let each = contest.table().iter().zip(contest.entrants());
    each.filter(|(one, _)| !holds(one)).filter_map(|(one, entrant)| {
        let why = one.outside?.why(&entrant.scenario);
        Some(format!("{}: {why}.", tr(&one.name)))
    })
}

/// Who holds the tolerance, in words.
fn holding(compared: &[Compared]) -> String {
    if compared.iter().all(|one| one.get(Measure::InTolerance).is_none()) {
        return tr("Nobody is judged yet.").to_owned();
    }
    let holding: Vec<&str> =
        compared.iter().filter(|one| holds(one)).map(|one| tr(&one.name)).collect();
    match holding[..] {
        [] => {
            tr!("Nobody holds the tolerance on {percent} % of the length.", percent = HELD_PERCENT)
        }
        [..] => tr!(
            "Who holds the tolerance on {percent} % of the length: {controllers}.",
            percent = HELD_PERCENT,
            controllers = holding.join(", "),
        ),
    }
}

fn doc(measure: Measure) -> String {
    let option = Measure::OPTIONS.iter().find(|option| option.id == measure.id());
    let doc = option.map_or_else(String::new, |option| tr(option.doc).replace('\n', " "));
    format!("{doc} {}", tr(measure.better()))
}

/// What the cards are about where the table has no room.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Cards {
    /// One for everybody, with all measures.
    #[default]
    Controller,
    /// One for every measure, with everybody side by side.
    Measure,
}

/// The choice of what the cards are about.
pub fn choose(ui: &mut Ui, cards: &mut Cards) {
    let names = [tr("By controller"), tr("By measure")];
    for (one, name) in [Cards::Controller, Cards::Measure].into_iter().zip(names) {
        if touch::choice(ui, *cards == one, name).clicked() {
            *cards = one;
        }
    }
}

/// The table as cards, as wide as a phone.
pub fn cards(
    ui: &mut Ui,
    contest: &Contest,
    belongs: bool,
    cards: Cards,
    commands: &mut Vec<Command>,
) {
    match cards {
        Cards::Controller => by_controller(ui, contest, belongs, commands),
        Cards::Measure => by_measure(ui, contest, belongs),
    }
    notes(ui, contest);
}

/// A card for everybody.
fn by_controller(ui: &mut Ui, contest: &Contest, belongs: bool, commands: &mut Vec<Command>) {
    let (entrants, compared) = (contest.entrants(), contest.table());
    for (index, one) in compared.iter().enumerate() {
        let printed = printed_of(&one.name, belongs);
        card(
            ui,
            ("compared", index),
            |ui| {
                ui.horizontal(|ui| {
                    ui.strong(tr(&one.name));
                    load(ui, entrants, index, commands);
                });
                for trouble in troubles(one) {
                    Standing::Bad.label(ui, &trouble, RichText::small);
                }
            },
            |ui| {
                for measure in Measure::ALL {
                    let title = title(*measure, contest.reference());
                    ui.label(RichText::new(title).small()).on_hover_text(doc(*measure));
                    figure_lines(ui, &figure((index, one), compared, *measure, printed));
                    ui.end_row();
                }
            },
        );
    }
}

/// A card for every measure: everybody's figures below each other.
fn by_measure(ui: &mut Ui, contest: &Contest, belongs: bool) {
    let compared = contest.table();
    for measure in Measure::ALL {
        card(
            ui,
            ("measure", measure.id()),
            |ui| {
                ui.strong(title(*measure, contest.reference())).on_hover_text(doc(*measure));
            },
            |ui| {
                for (index, one) in compared.iter().enumerate() {
                    let printed = printed_of(&one.name, belongs);
                    ui.label(RichText::new(tr(&one.name)).small());
                    figure_lines(ui, &figure((index, one), compared, *measure, printed));
                    ui.end_row();
                }
            },
        );
    }
}

/// A card with a head and lines of two columns.
fn card(
    ui: &mut Ui,
    id: impl egui::AsIdSalt,
    head: impl FnOnce(&mut Ui),
    lines: impl FnOnce(&mut Ui),
) {
    theme::card(Palette::at(ui)).show(ui, |ui| {
        ui.set_width(ui.available_width());
        head(ui);
        ui.spacing_mut().interact_size.y = 18.0;
        touch::grid(ui, id).num_columns(2).spacing([8.0, 2.0]).show(ui, lines);
    });
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
        let least = least_straying(&several).unwrap();
        assert!(least.contains("the lead is within the spread"), "{least}");
        // Without the one that is as good, the lead over the wild one is clear.
        let two = [several[0].clone(), several[2].clone()];
        assert_eq!(leader(&two, Measure::Nsn), Some(Leader { index: 0, clear: true }));
        assert!(figure((0, &two[0]), &two, Measure::Nsn, None).is_best);
        let least = least_straying(&two).unwrap();
        let nsn = value(Measure::Nsn, two[0].get(Measure::Nsn).unwrap().mean);
        assert!(least.contains(&format!("is {nsn}, 0 is perfect")), "{least}");
        assert!(least.contains(&two[0].name) && !least.contains("spread"), "{least}");
        for seeds in [1, 2] {
            assert_eq!(leader(&table(seeds), Measure::Nsn), None, "{seeds} have no spread");
        }
        assert_eq!(leader(&several[..1], Measure::Nsn), None);
    }
}
