//! The tables of this screen as files.

use super::table::{printed_of, title};
use crate::study::compare::load_step::Transient;
use crate::study::compare::outcome::Measure;
use crate::study::compare::robustness::RobustnessRow;
use crate::study::compare::tournament::Compared;
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

fn titles(first: &[&str], known: &str) -> Vec<String> {
    let of = |measure: &Measure| {
        let title = title(*measure);
        [title.clone(), format!("{title} standard deviation"), format!("{title} {known}")]
    };
    let first = first.iter().map(|title| (*title).to_owned());
    first.chain(Measure::ALL.iter().flat_map(of)).collect()
}

fn runs(one: &Compared) -> [Entry; 3] {
    [one.runs, one.finished, one.force_stops].map(|count| (count as f64).into())
}

/// The comparison; the printed table belongs to it or not.
pub fn compared(table: &[Compared], belongs: bool) -> Sheet {
    let first = ["Control", "Runs", "Finished", "Stopped by overload"];
    let mut sheet = Sheet::new(titles(&first, "printed"));
    for one in table {
        let printed = printed_of(&one.name, belongs);
        let name: Entry = one.name.as_str().into();
        let figures = measured(one, |measure| printed.and_then(|row| row.get(measure)));
        sheet.row(std::iter::once(name).chain(runs(one)).chain(figures));
    }
    sheet
}

/// Everybody under changed conditions.
pub fn robustness(rows: &[RobustnessRow]) -> Sheet {
    let first = ["Condition", "Control", "Runs", "Finished", "Stopped by overload"];
    let mut sheet = Sheet::new(titles(&first, "of a prototype"));
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

    #[test]
    fn a_load_step_that_is_never_steady_has_an_empty_cell() {
        let transient = |name: &str, periods| Transient {
            name: name.to_owned(),
            periods,
            overshoot_percent: 12.5,
            offset_percent: -0.25,
        };
        let table = [transient("P, lively", Some(9)), transient("MRAC", None)];
        let csv = load_step(&table, false).csv();
        let lines: Vec<&str> = csv.lines().collect();
        assert_eq!(lines[0], "Control,Periods,Overshoot [%],Left over [%],Printed iterations");
        assert_eq!(lines[1..], ["\"P, lively\",9,12.5,-0.25,", "MRAC,,12.5,-0.25,"]);
    }

    #[test]
    fn every_title_of_a_measure_comes_three_times() {
        let titles = titles(&["Control"], "printed");
        assert_eq!(titles.len(), 1 + 3 * Measure::ALL.len());
        assert!(titles.contains(&format!("{} printed", title(Measure::Time))));
    }
}
