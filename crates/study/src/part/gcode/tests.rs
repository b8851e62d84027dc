//! Programs and what is refused in them.

use super::*;
use crate::base::math::PI;

const START: &str = "G0 X0 Y0 Z5\nG0 Z0\n";

fn read(text: &str) -> GCodeProgram {
    GCodeProgram::read(&format!("{START}{text}")).unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// The moves behind the start.
fn moves(text: &str) -> Vec<GCodeMove> {
    read(text).moves.split_off(1)
}

fn ends(text: &str) -> Vec<[f64; 3]> {
    moves(text).into_iter().map(|one| one.ends_mm[1]).collect()
}

#[test]
fn modes_hold_until_they_change() {
    let program = moves("G1 X10 F300 S1500\nY5\nG0 Z5\nX0 Y0\nG1 Z-1 F100");
    let told: Vec<_> = program.iter().map(|m| (m.line, m.rapid, m.feed_mm_min)).collect();
    assert_eq!(
        told,
        [
            (3, false, Some(300.0)),
            (4, false, Some(300.0)),
            (5, true, Some(300.0)),
            (6, true, Some(300.0)),
            (7, false, Some(100.0))
        ]
    );
    assert!(program.iter().all(|m| m.speed_rpm == Some(1500.0)));
    assert!(program[4].is_plunge() && !program[3].is_plunge());
}

#[test]
fn relative_moves_add_up_and_come_to_the_same_places() {
    let absolute = ends("G90\nG1 X10\nG1 X10 Y4\nG1 X7 Y4 Z-1");
    assert_eq!(ends("G91\nG1 X10\nG1 Y4\nG1 X-3 Z-1"), absolute);
    // A mode holds for its whole line, wherever it stands there.
    assert_eq!(ends("G1 X10\nG1 Y4 G91\nG90 G1 X7 Z-1"), absolute);
}

#[test]
fn inches_are_millimetres_times_25_4() {
    let inches = moves("G20\nG1 X1 F10\nG2 X2 Y0 I0.5 J0");
    assert_eq!(inches[0].ends_mm[1], [25.4, 0.0, 0.0]);
    assert_eq!(inches[0].feed_mm_min, Some(254.0));
    assert!((inches[1].length_mm() - 12.7 * PI).abs() < 1e-9);
    let back = moves("G20\nG1 X1\nG21\nG1 X10");
    assert_eq!(back[1].ends_mm[1], [10.0, 0.0, 0.0]);
}

#[test]
fn arcs_and_helices_have_their_lengths() {
    let arc = moves("G3 X10 Y10 I0 J10 F1")[0];
    assert!((arc.length_mm() - 5.0 * PI).abs() < 1e-9, "{}", arc.length_mm());
    let [x, y, _] = arc.at(0.5);
    assert!((x - 50.0_f64.sqrt()).abs() < 1e-9 && (y - 10.0 + 50.0_f64.sqrt()).abs() < 1e-9);
    let circle = moves("G2 X0 Y0 I5 J0 F1")[0];
    assert!((circle.length_mm() - 10.0 * PI).abs() < 1e-9);
    let helix = moves("G2 X0 Y0 Z-3 I5 J0 F1")[0];
    let wanted = (100.0 * PI * PI + 9.0_f64).sqrt();
    assert!((helix.length_mm() - wanted).abs() < 1e-9);
    assert_eq!(helix.at(0.5)[2], -1.5);
    assert!((moves("G2 X10 Y0 R5 F1")[0].length_mm() - 5.0 * PI).abs() < 1e-6);
}

#[test]
fn what_is_not_followed_is_told_with_its_lines() {
    let program = read("M3 T1\nG1 X1 M8\nG43 H1\nG64 P0.01\nG1 X2 M8\nM30\nG1 X99\n%");
    let told: Vec<_> =
        program.not_followed.iter().map(|t| (t.word.as_str(), t.lines.clone())).collect();
    assert_eq!(
        told,
        [
            ("M3", vec![3]),
            ("T", vec![3]),
            ("M8", vec![4, 7]),
            ("G43", vec![5]),
            ("H", vec![5]),
            ("G64", vec![6]),
            ("P", vec![6])
        ]
    );
    assert_eq!(program.left_out, 1, "behind the end of the program");
    assert_eq!(program.moves.last().unwrap().ends_mm[1][0], 2.0);
}

#[test]
fn a_place_that_only_the_machine_knows_is_known_again_after_a_rapid_move() {
    let program = read("G28 Z0\nG0 Z5\nG1 Z-1 F100");
    assert_eq!(program.moves.len(), 2, "{:?}", program.moves);
    let error = GCodeProgram::read(&format!("{START}G28\nG1 X5 F100")).unwrap_err();
    assert!(error.starts_with("line 4") && error.contains("not known"), "{error}");
}

#[test]
fn what_would_change_the_way_is_refused_with_its_line() {
    for (line, named) in [
        ("G18", "G18"),
        ("G41 D1", "G41"),
        ("G81 X1 Z-5 R2", "G81"),
        ("G92 X0", "G92"),
        ("G55", "G55"),
        ("G95 F0.1", "G95"),
        ("G90.1", "G90.1"),
        ("G1 A10", "A10"),
        ("M98 P100", "M98"),
        ("O100", "O100"),
        ("G0 G1 X5", "motion"),
        ("G1 X5 X6", "X"),
        ("G1 X5 I2", "I, J and R"),
        ("G2 X5", "without I, J or R"),
        ("G2 X5 I1 R2", "not both"),
        ("G2 X5 Y0 I1", "radius"),
        ("G1 X5 F-1", "F-1"),
        ("#100=5", "#"),
        ("G1 X", "number"),
    ] {
        let error = GCodeProgram::read(&format!("{START}{line}")).unwrap_err();
        assert!(error.starts_with("line 3: ") && error.contains(named), "{line}: {error}");
    }
    for (text, named) in [
        ("X5", "motion"),
        ("G1 X5 F100", "not known"),
        ("G91 G0 X5", "relative"),
        ("G0 X0 Y0\nG1 X5", "not known"),
    ] {
        let error = GCodeProgram::read(text).unwrap_err();
        assert!(error.contains(named), "{text}: {error}");
    }
}
