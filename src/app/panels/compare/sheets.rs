//! The tables of this screen as files.

use super::table::{printed_of, title};
use crate::blocks::reference::Reference;
use crate::run::edits::Edits;
use crate::run::scenario_link;
use crate::study::compare::entrants::Entrant;
use crate::study::compare::load_step::Transient;
use crate::study::compare::outcome::Measure;
use crate::study::compare::robustness::RobustnessRow;
use crate::study::compare::tournament::{Compared, scenario_of};
use crate::study::export::sheet::{Entry, Sheet};

/// What stands of each measure: mean, deviation over the seeds, printed figure.
fn measured(one: &Compared, printed: impl Fn(Measure) -> Option<f64>) -> Vec<Entry> {
    let of = |measure: &Measure| {
        let spread = one.get(*measure);
        let mean = spread.map(|spread| spread.mean).into();
        let deviation = spread.filter(|spread| spread.runs > 1).map(|spread| spread.deviation);
        [mean, deviation.into(), printed(*measure).into()]
    };
    Measure::ALL.iter().flat_map(of).collect()
}

fn titles(first: &[&str], known: &str, reference: Reference) -> Vec<String> {
    let of = |measure: &Measure| {
        let title = title(*measure, reference);
        [title.clone(), format!("{title} standard deviation"), format!("{title} {known}")]
    };
    let first = first.iter().map(|title| (*title).to_owned());
    first.chain(Measure::ALL.iter().flat_map(of)).collect()
}

fn runs(one: &Compared) -> [Entry; 3] {
    [one.runs, one.finished, one.force_stops].map(|count| (count as f64).into())
}

/// Titles of what the runs are of: with the link anybody repeats the run of seed 1, and finds its digest.
const OF_RUNS: [&str; 6] =
    ["Scenario", "Dead time [s]", "Seeds from", "Seeds to", "Digest of seed 1", "Link of seed 1"];

/// What the runs are of.
fn source(entrant: &Entrant, one: &Compared) -> [Entry; 6] {
    let scenario = &entrant.scenario;
    let link = scenario_link::write(&scenario_of(scenario, 1), &Edits::none());
    [
        scenario.info.name.as_str().into(),
        scenario.cnc.dead_time_s.into(),
        1.0.into(),
        (one.runs as f64).into(),
        one.digest.as_deref().map_or(Entry::Empty, Entry::from),
        link.into(),
    ]
}

/// The comparison; the printed table belongs to it or not.
pub fn compared(
    entrants: &[Entrant],
    table: &[Compared],
    reference: Reference,
    belongs: bool,
) -> Sheet {
    let first = ["Control", "Runs", "Finished", "Stopped by overload"];
    let titles = titles(&first, "printed", reference).into_iter();
    let mut sheet = Sheet::new(titles.chain(OF_RUNS.map(str::to_owned)));
    for (one, entrant) in table.iter().zip(entrants) {
        let printed = printed_of(&one.name, belongs);
        let name: Entry = one.name.as_str().into();
        let figures = measured(one, |measure| printed.and_then(|row| row.get(measure)));
        let source = source(entrant, one);
        sheet.row(std::iter::once(name).chain(runs(one)).chain(figures).chain(source));
    }
    sheet
}

/// Everybody under changed conditions.
pub fn robustness(rows: &[RobustnessRow]) -> Sheet {
    let first = ["Condition", "Control", "Runs", "Finished", "Stopped by overload"];
    // Of Experiment 2, where the force is held.
    let mut sheet = Sheet::new(titles(&first, "of a prototype", Reference::Force));
    for row in rows {
        let names: [Entry; 2] = [row.label.into(), row.found.name.as_str().into()];
        let known = |measure| row.reference.as_ref().and_then(|known| known.get(measure));
        let figures = measured(&row.found, known);
        sheet.row(names.into_iter().chain(runs(&row.found)).chain(figures));
    }
    sheet
}

/// The load step; the printed table belongs to it or not.
pub fn load_step(transients: &[Transient], belongs: bool) -> Sheet {
    let titles = ["Control", "Periods", "Overshoot [%]", "Left over [%]", "Printed iterations"];
    let mut sheet = Sheet::new(titles);
    for transient in transients {
        let printed = printed_of(&transient.name, belongs).map(|row| row.optimization_iterations);
        sheet.row([
            transient.name.as_str().into(),
            transient.periods.map(|periods| periods as f64).into(),
            transient.overshoot_percent.into(),
            transient.offset_percent.into(),
            printed.into(),
        ]);
    }
    sheet
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::job::Job;
    use crate::run::one_run::Run;
    use crate::run::presets;
    use crate::study::compare::entrants::{TABLE_1, on};
    use crate::study::compare::tournament::Tournament;

    #[test]
    fn a_load_step_that_nobody_is_back_from_has_an_empty_cell() {
        let transient = |name: &str, periods| Transient {
            name: name.to_owned(),
            periods,
            unstable: false,
            overshoot_percent: 12.5,
            offset_percent: -0.25,
        };
        let table = [transient("P, lively", Some(9)), transient("MRAC", None)];
        let csv = load_step(&table, false).csv();
        let lines: Vec<&str> = csv.lines().collect();
        assert_eq!(lines[0], "Control,Periods,Overshoot [%],Left over [%],Printed iterations");
        assert_eq!(lines[1..], ["\"P, lively\",9,12.5,-0.25,", "MRAC,,12.5,-0.25,"]);
    }

    /// The table that is saved says what it is of, so that anybody can repeat it.
    #[test]
    fn the_comparison_names_scenario_seeds_dead_time_and_a_digest_with_its_link() {
        let mut base = presets::load("table3-5-noise").unwrap();
        base.change(|settings| settings.run.duration_s = 2.0).unwrap();
        let mut tournament = Tournament::new(on(&base, &TABLE_1[..2]), 2);
        tournament.to_end();
        let (entrants, table) = (tournament.entrants(), tournament.table());
        let csv = compared(entrants, &table, Reference::Ra, false).csv();
        let mut rows = csv::Reader::from_reader(csv.as_bytes());
        let titles = rows.headers().unwrap().clone();
        let row = rows.records().next().unwrap().unwrap();
        let cell = |title: &str| &row[titles.iter().position(|known| known == title).unwrap()];
        assert_eq!((cell("Scenario"), cell("Dead time [s]")), ("table3-5-noise", "0.08"));
        assert_eq!((cell("Seeds from"), cell("Seeds to")), ("1", "2"));
        let (scenario, edits) = scenario_link::parse(cell("Link of seed 1")).unwrap();
        let run = Run::complete(&scenario, &edits);
        assert_eq!(cell("Digest of seed 1"), run.recording().digest());
    }

    #[test]
    fn every_title_of_a_measure_comes_three_times() {
        let titles = titles(&["Control"], "printed", Reference::Ra);
        assert_eq!(titles.len(), 1 + 3 * Measure::ALL.len());
        assert!(titles.contains(&format!("{} printed", title(Measure::Time, Reference::Ra))));
        assert!(titles.contains(&"Ra in tolerance [%]".to_owned()));
    }
}
