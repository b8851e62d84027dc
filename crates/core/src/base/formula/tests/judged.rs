//! Units and ranges, case by case.

use super::super::*;
use super::read;

/// K4 of 2007, with a feed in mm/min and a speed in 1/min.
const K4: &str = "286.44 - 5.82e-10*n^3 - 8973*ln(0.039*f)/f";

fn units(all: [&str; 2]) -> [Unit; 2] {
    all.map(|text| Unit::parse(text).unwrap())
}

#[test]
fn the_units_of_constants_are_found() {
    let formula = Formula::parse(K4, &["f", "n"]).unwrap();
    let newton = Unit::parse("N").unwrap();
    let report = formula.check_units(&units(["mm/min", "1/min"]), &newton, NumberUnits::Solved);
    let found: Vec<(String, String, bool)> =
        report.unwrap().constants.into_iter().map(|c| (c.text, c.unit, c.fixed)).collect();
    let expected = [
        ("286.44", "N"),
        ("5.82e-10", "min^3 N"),
        ("3", "1"),
        ("8973", "mm N/min"),
        ("0.039", "min/mm"),
    ];
    assert_eq!(found, expected.map(|(text, unit)| (text.to_owned(), unit.to_owned(), true)));
    let error =
        formula.check_units(&units(["mm/min", "1/min"]), &newton, NumberUnits::Absent).unwrap_err();
    assert!(error.problem.contains("cannot subtract 1/min^3 from 1"), "{error}");
    assert_eq!(error.column, 1);
}

#[test]
fn units_that_do_not_fit_are_told_with_their_place() {
    for (text, at, output, column, part) in [
        ("x + y", ["N", "mm"], "N", 1, "`x + y`: cannot add mm to N"),
        ("2*x + y*y", ["N", "mm"], "mm", 1, "the formula has the unit mm^2"),
        (
            "1 + ln(x)",
            ["N", "mm"],
            "",
            8,
            "`x`: `ln` needs a plain number, but this has the unit N",
        ),
        ("x^y", ["", "mm"], "", 3, "an exponent is a plain number, but this has the unit mm"),
        ("x^y", ["mm", ""], "", 1, "the base must be a plain number"),
        ("x", ["mm", ""], "um", 1, "has the unit mm, but its result is to have um"),
        ("x - y", ["mm", "um"], "mm", 1, "cannot subtract um from mm"),
        ("sqrt(x)", ["mm", "um"], "mm", 1, "has the unit mm^0.5"),
    ] {
        let output = Unit::parse(output).unwrap();
        let error = read(text).check_units(&units(at), &output, NumberUnits::Solved).unwrap_err();
        assert!(error.problem.contains(part), "{text}: {error}");
        assert_eq!(error.column, column, "{error}");
    }
    let free = read("2 * 3 * x").check_units(
        &units(["N", ""]),
        &Unit::parse("mm").unwrap(),
        NumberUnits::Solved,
    );
    let fixed: Vec<bool> = free.unwrap().constants.iter().map(|constant| constant.fixed).collect();
    assert_eq!(fixed, [false, false], "2 and 3 share mm/N");
    for (a, b) in [
        ("N/mm^2", "MPa"),
        ("rpm", "1/min"),
        ("µm", "um"),
        ("kN m", "kJ"),
        ("N/mm2", "N/mm²"),
        ("1/s", "Hz"),
    ] {
        let [one, other] = units([a, b]);
        assert!(one.is_same(&other), "{a} and {b}");
    }
    for (text, part) in [
        ("mm/", "ends with"),
        ("parsec", "`parsec`"),
        ("mm^x", "a power is a number"),
        ("kmin", "`kmin`"),
    ] {
        assert!(Unit::parse(text).unwrap_err().contains(part), "{text}");
    }
}

#[test]
fn a_certificate_says_what_holds_everywhere_and_where_it_is_open() {
    let formula = Formula::parse(K4, &["f", "n"]).unwrap();
    let inside = [Interval::new(150.0, 600.0), Interval::new(800.0, 2500.0)];
    let certificate = formula.certify(&inside).unwrap();
    assert!(certificate.is_finite());
    assert_eq!(certificate.trends, [Trend::Rising, Trend::Falling]);
    let values = certificate.values.unwrap();
    let corners = [formula.value(&[150.0, 2500.0]), formula.value(&[600.0, 800.0])];
    assert!(
        (values.low - corners[0]).abs() < 2.0 && (values.high - corners[1]).abs() < 2.0,
        "{values:?}"
    );
    for f in 0..=30 {
        for n in 0..=30 {
            let at = [150.0 + f64::from(f) * 15.0, 800.0 + f64::from(n) * 1700.0 / 30.0];
            assert!(values.contains(formula.value(&at)));
        }
    }
    // K4 has its least force over the feed at e / 0.039 = 69.7 mm/min.
    let low = [Interval::new(30.0, 600.0), Interval::new(800.0, 2500.0)];
    let certificate = formula.certify(&low).unwrap();
    assert!(certificate.is_finite() && certificate.trends == [Trend::Turning, Trend::Falling]);
    // A pole inside is found and named.
    let pole =
        read("1 / (x - 3) + y").certify(&[Interval::new(0.0, 10.0), Interval::new(0.0, 1.0)]);
    let pole = pole.unwrap();
    assert!(!pole.is_finite() && pole.values.is_none());
    assert!(
        pole.not_finite.iter().any(|p| p.at[0].contains(3.0) && p.at[0].width() < 0.1),
        "{pole:?}"
    );
    assert!(pole.not_finite.iter().all(|p| p.why == "`1 / (x - 3)`: a division by 0"), "{pole:?}");
    assert_eq!(pole.trends[1], Trend::Rising);
    // The value at a point is bounded though the parts depend on each other.
    let range = [Interval::new(0.1, 5.0), Interval::new(0.0, 1.0)];
    assert!(read("1 / (x - x^2 / 20)").certify(&range).unwrap().is_finite());
    assert_eq!(read("y").certify(&range).unwrap().trends, [Trend::Constant, Trend::Rising]);
    assert!(read("x").certify(&[Interval::new(1.0, 0.0), range[1]]).unwrap_err().contains("`x`"));
}
