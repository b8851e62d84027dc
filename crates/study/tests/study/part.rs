//! Parts of one's own: what a tool meets along a program is what geometry says, and what a table says is what a run cuts.

use steadycut_core::base::math;
use steadycut_core::base::settings::Value;
use steadycut_core::models::part::MAX_STEPS;
use steadycut_core::models::tool::Outline;
use steadycut_core::run::edits::Edits;
use steadycut_core::run::job::Job;
use steadycut_core::run::one_run::Run;
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::Scenario;
use steadycut_core::run::{scenario_file, scenario_link};
use steadycut_study::part::blank::Blank;
use steadycut_study::part::gcode::GCodeProgram;
use steadycut_study::part::milling::{MilledPart, MillingJob};
use steadycut_study::part::{EXAMPLE_CSV, EXAMPLE_GCODE, PartPath};

/// A square end of 10 mm.
const SQUARE: Outline = Outline { diameter_mm: 10.0, corner_radius_mm: 0.0 };
/// Step along the way and cell of the map, mm.
const STEP_MM: f64 = 0.5;
const CELL_MM: f64 = 0.125;

/// A program over a blank of 60 x 40 x 20 mm whose top is at z = 0.
fn job(program: &str, outline: Outline) -> MillingJob {
    let program = GCodeProgram::read(program).unwrap_or_else(|error| panic!("{error}"));
    let blank = Blank::new([60.0, 40.0, 20.0], None).unwrap();
    let mut job = MillingJob::new(&program, blank, outline, STEP_MM).unwrap();
    job.to_end();
    job
}

fn milled(program: &str, outline: Outline) -> MilledPart {
    job(program, outline).part().unwrap().clone()
}

/// Axial and radial depth of the rows that begin between two places along x, mm.
fn between(part: &MilledPart, low: f64, high: f64) -> Vec<[f64; 2]> {
    let inside = part.rows.iter().filter(|row| row.at_mm[0] >= low && row.at_mm[0] < high);
    inside.map(|row| [row.axial_mm, row.radial_mm]).collect()
}

/// The radial depth of the row that begins at a place along x, mm.
fn radial_at(part: &MilledPart, x: f64) -> f64 {
    let row = part.rows.iter().find(|row| (row.at_mm[0] - x).abs() < 1e-6).unwrap();
    row.radial_mm
}

const SLOT: &str = "G21 G90\nG0 X-10 Y20 Z5\nG0 Z-2\nG1 X70 F300 S1500\nG0 Z5\n";

#[test]
fn a_slot_has_its_depth_and_the_diameter_with_ramps_at_both_ends() {
    let part = milled(SLOT, SQUARE);
    assert_eq!(part.length_mm, 80.0);
    assert_eq!((part.rows.len(), part.end_mm), (160, [70.0, 20.0, -2.0]));
    let inside = between(&part, 0.0, 54.9);
    assert!(
        inside.len() == 110 && inside.iter().all(|depths| *depths == [2.0, 10.0]),
        "{inside:?}"
    );
    for air in [between(&part, -10.0, -5.6), between(&part, 65.1, 70.0)] {
        assert!(!air.is_empty() && air.iter().all(|depths| *depths == [0.0, 0.0]), "{air:?}");
    }
    // Entry: the chord of the tool at the blank's edge at the end of the step. Exit: what is left beside the chord.
    let chord = |x: f64| 2.0 * (25.0 - x * x).sqrt();
    for x in [-4.0_f64, -3.0, -2.0, -1.0] {
        let [found, wanted] = [radial_at(&part, x - STEP_MM), chord(x)];
        assert!((found - wanted).abs() < 3.0 * CELL_MM, "{x}: {found}, not {wanted}");
    }
    for x in [1.0_f64, 2.0, 3.0, 4.0] {
        let [found, wanted] = [radial_at(&part, 60.0 - x), 10.0 - chord(x)];
        assert!((found - wanted).abs() < 4.0 * CELL_MM, "{x}: {found}, not {wanted}");
    }
    assert!(part.rows.iter().all(|row| row.feed_mm_min == Some(300.0) && row.line == 4));
}

#[test]
fn what_is_removed_is_depth_times_width_times_length() {
    let job = job(SLOT, SQUARE);
    let part = job.part().unwrap();
    assert!((part.removed_mm3 - 1200.0).abs() < 1e-6, "{}", part.removed_mm3);
    assert!((job.map().removed_mm3() - part.removed_mm3).abs() < 1e-6);
    // Each ramp is counted by the largest width of every step: a step of the whole slot more at most.
    assert!((part.counted_mm3 - 1200.0).abs() < 2.0 * 20.0 * STEP_MM, "{}", part.counted_mm3);
}

#[test]
fn a_side_cut_has_its_width_in_any_direction() {
    // The tool's radius is 5 mm: its axis is 2 mm outside of the blank.
    let part = milled("G0 X-10 Y-2 Z-4\nG1 X70 F300", SQUARE);
    let inside = between(&part, 10.0, 50.0);
    assert!(inside.iter().all(|depths| *depths == [4.0, 3.0]), "{inside:?}");
    let other = milled("G0 X70 Y-2 Z-4\nG1 X-10 F300", SQUARE);
    assert_eq!(between(&other, 10.0, 50.0).len(), 80);
    assert!(between(&other, 10.0, 50.0).iter().all(|depths| *depths == [4.0, 3.0]));
    // Along y, on the other axis of the grid.
    let part = milled("G0 X-2 Y-10 Z-4\nG1 Y50 F300", SQUARE);
    let rows = part.rows.iter().filter(|row| (10.0..30.0).contains(&row.at_mm[1]));
    assert!(rows.clone().count() == 40 && rows.clone().all(|row| row.radial_mm == 3.0));
}

#[test]
fn a_slot_across_the_grid_has_the_diameter_too() {
    for way in ["X-10 Y10 X50 Y30", "X-10 Y-10 X50 Y50", "X-10 Y12 X50 Y13.7", "X-10 Y30 X50 Y8"] {
        let (from, to) = way.split_at(way.rfind(" X").unwrap());
        let part = milled(&format!("G0 {from} Z-1\nG1{to} F300"), SQUARE);
        let inside = between(&part, 10.0, 25.0);
        assert!(inside.len() > 10, "{way}");
        for depths in inside {
            let near = (depths[1] - 10.0).abs() <= 2.0 * CELL_MM;
            assert!(depths[0] == 1.0 && near, "{way}: {depths:?}");
        }
    }
}

#[test]
fn a_ball_and_a_bull_nose_meet_the_plane_where_their_outline_does() {
    let ball = Outline::ball(5.0);
    let program = "G0 X-10 Y20 Z-2\nG1 X70 F300";
    let part = milled(program, ball);
    let width = 2.0 * (2.0_f64 * 10.0 - 4.0).sqrt();
    for [axial, radial] in between(&part, 0.0, 50.0) {
        assert!(axial == 2.0 && (radial - width).abs() <= 2.0 * CELL_MM, "{axial} {radial}");
    }
    // The segment of a circle of 5 mm, 2 mm high.
    let segment = 25.0 * math::acos(0.6) - 3.0 * 4.0;
    let removed = job(program, ball).map().removed_mm3();
    assert!((removed / (60.0 * segment) - 1.0).abs() < 0.003, "{removed}");
    let nose = Outline { diameter_mm: 10.0, corner_radius_mm: 2.0 };
    let part = milled("G0 X-10 Y20 Z-1\nG1 X70 F300", nose);
    let width = 2.0 * (3.0 + 3.0_f64.sqrt());
    for [axial, radial] in between(&part, 0.0, 50.0) {
        assert!(axial == 1.0 && (radial - width).abs() <= 2.0 * CELL_MM, "{axial} {radial}");
    }
}

#[test]
fn the_same_way_again_is_air_and_a_deeper_one_cuts_the_rest() {
    let part = milled("G0 X-10 Y20 Z-2\nG1 X70 F300\nX-10\nG1 Z-3\nX70", SQUARE);
    let [forth, back, deeper]: [Vec<_>; 3] = [2, 3, 5].map(|line: usize| {
        let rows = part.rows.iter().filter(|row| row.line == line);
        rows.filter(|row| (5.0..50.0).contains(&row.at_mm[0]))
            .map(|r| [r.axial_mm, r.radial_mm])
            .collect()
    });
    assert!(forth.iter().all(|depths| *depths == [2.0, 10.0]));
    assert!(back.iter().all(|depths| *depths == [0.0, 0.0]), "{back:?}");
    assert!(!deeper.is_empty() && deeper.iter().all(|depths| *depths == [1.0, 10.0]), "{deeper:?}");
    assert!(part.plunges.is_empty(), "outside of the blank");
}

#[test]
fn a_circle_is_as_long_as_it_is_and_cut_as_wide_as_the_tool() {
    let part = milled("G0 X40 Y20 Z5\nG1 Z-1 F100\nG2 X40 Y20 I-10 J0 F300", SQUARE);
    assert!((part.length_mm - 6.0 - 20.0 * math::PI).abs() < 1e-9, "{}", part.length_mm);
    assert_eq!(part.plunges, [2]);
    // Behind the tool's own hole and before it comes back to it.
    let rows = part.rows.iter().filter(|row| row.line == 3 && (20.0..50.0).contains(&row.s_mm));
    for row in rows {
        assert!(row.axial_mm == 1.0 && (row.radial_mm - 10.0).abs() <= 4.0 * CELL_MM, "{row:?}");
    }
}

#[test]
fn many_short_moves_are_the_path_of_one_long_one() {
    let mut short = "G0 X-10 Y20 Z5\nG0 Z-2\nG1 F300 S1500\n".to_owned();
    for i in 1..=800 {
        short.push_str(&format!("G1 X{}\n", -10.0 + 0.1 * f64::from(i)));
    }
    let [long, short] = [SLOT, &short].map(|program| milled(program, SQUARE));
    assert_eq!(long.rows.len(), short.rows.len());
    let off = |a: &f64, b: &f64| (a - b).abs();
    for (one, other) in long.rows.iter().zip(&short.rows) {
        assert!(off(&one.s_mm, &other.s_mm) < 1e-6 && one.axial_mm == other.axial_mm);
        assert!(off(&one.radial_mm, &other.radial_mm) <= 2.0 * CELL_MM, "{one:?} {other:?}");
    }
}

#[test]
fn rapid_moves_through_material_and_plunges_are_told() {
    let part = milled("G0 X30 Y20 Z5\nG1 Z-3 F100\nG0 X50\nG0 Z5\nM30\nG0 X1", SQUARE);
    assert_eq!((part.rapids.clone(), part.plunges.clone()), (vec![3], vec![2]));
    let told = part.remarks().join(" ");
    assert!(told.contains("material: lines 3") && told.contains("1 lines, not read"), "{told}");
    let clean = milled(SLOT, SQUARE);
    assert!(clean.rapids.is_empty() && clean.remarks().is_empty(), "{:?}", clean.remarks());
}

#[test]
fn what_cannot_be_cut_is_refused_with_what_is_allowed() {
    let program = GCodeProgram::read(SLOT).unwrap();
    let blank = Blank::new([60.0, 40.0, 20.0], None).unwrap();
    let refused = |program: &GCodeProgram, blank, step| {
        MillingJob::new(program, blank, SQUARE, step).unwrap_err()
    };
    assert!(refused(&program, blank, 0.01).contains("0.05 to 10 mm"));
    let wide = Blank::new([5000.0, 5000.0, 20.0], None).unwrap();
    assert!(refused(&program, wide, 0.5).contains("cells"));
    let none = GCodeProgram::read("G0 X0 Y0 Z0\nG0 X5").unwrap();
    assert!(refused(&none, blank, 0.5).contains("no feed move"));
    let flat = Blank::new([60.0, 0.0, 20.0], None).unwrap_err();
    assert!(flat.contains("along Y is 0 mm") && flat.contains("1 to 5000"), "{flat}");
}

fn taken(path: &PartPath) -> Scenario {
    let mut scenario = load("first-cut").unwrap();
    let part = path.to_scenario(&scenario).unwrap();
    scenario.set_all(&part.changes).unwrap();
    scenario
}

#[test]
fn a_path_survives_table_scenario_file_and_link() {
    let part = milled(SLOT, SQUARE);
    let read = PartPath::read(&part.csv()).unwrap();
    assert_eq!(read.stretches, part.path().stretches);
    assert_eq!((read.length_mm, read.feeds_mm_min), (80.0, Some([300.0, 300.0])));
    let path = PartPath::read(
        "s,a_p,a_e\n0,0,0\n5,2,3.25\n20,2.5,3.25\n40,2.5,4\n60,0,0\n70,1,4\n90,0,0\n",
    );
    let path = path.unwrap();
    let scenario = taken(&path);
    let again = PartPath::of(&scenario.workpiece).unwrap();
    assert_eq!(again.length_mm, 90.0);
    assert_eq!(again.air_mm(), path.air_mm());
    let cut = |path: &PartPath| -> Vec<[f64; 3]> {
        path.stretches.iter().copied().filter(|stretch| stretch[1] > 0.0).collect()
    };
    assert_eq!(cut(&again), cut(&path));
    assert_eq!(PartPath::read(&again.csv()).unwrap().stretches, again.stretches);
    assert_eq!(taken(&again), scenario);
    let text = scenario_file::write(&scenario, &Edits::none());
    assert_eq!(scenario_file::parse(&text).unwrap().0, scenario);
    let link = scenario_link::write(&scenario, &Edits::none());
    assert_eq!(scenario_link::parse(&link).unwrap().0, scenario);
}

#[test]
fn a_run_meets_the_depths_of_its_path() {
    let path =
        PartPath::read("s,a_p,a_e\n0,2,3\n10,2,4.5\n15,1,4.5\n20,0,0\n25,1.5,2\n40,0,0\n").unwrap();
    let scenario = taken(&path);
    let run = Run::complete(&scenario, &Edits::none());
    let rows = run.recording().rows();
    assert!(rows.last().unwrap().position_mm >= 40.0, "the path is done: {:?}", run.end());
    for row in rows {
        let place = match row.position_mm {
            x if x < 10.0 => [2.0, 3.0],
            x if x < 15.0 => [2.0, 4.5],
            x if x < 20.0 => [1.0, 4.5],
            x if x < 25.0 => [0.0, 4.5],
            _ => [1.5, 2.0],
        };
        assert_eq!([row.axial_depth_mm, row.radial_depth_mm], place, "{}", row.position_mm);
    }
    // The formula's force goes with the cross-section.
    let force = |at_mm: f64| {
        let row = rows.iter().find(|row| row.position_mm >= at_mm).unwrap();
        row.force_n
    };
    assert_eq!(force(22.0), 0.0);
    assert!(force(10.2) > force(9.9), "{} {}", force(10.2), force(9.9));
}

#[test]
fn a_part_with_too_many_depths_is_told_and_then_refused() {
    let table = |n: usize, depth: &dyn Fn(usize) -> f64| {
        let rows: Vec<String> = (0..n).map(|i| format!("{i},{},3\n", depth(i))).collect();
        PartPath::read(&format!("s,a_p,a_e\n{}{n},0,0\n", rows.concat())).unwrap()
    };
    let scenario = load("first-cut").unwrap();
    let fits = table(MAX_STEPS, &|i| if i % 2 == 0 { 2.0 } else { 3.0 });
    assert!(
        !fits
            .to_scenario(&scenario)
            .unwrap()
            .told
            .iter()
            .any(|told| told.contains("taken for none"))
    );
    let noisy = table(3 * MAX_STEPS, &|i| if i % 2 == 0 { 2.0 } else { 2.004 });
    let part = noisy.to_scenario(&scenario).unwrap();
    assert!(part.told[0].contains("0.005 mm"), "{:?}", part.told);
    let wild = table(3 * MAX_STEPS, &|i| if i % 2 == 0 { 2.0 } else { 4.0 });
    let refused = wild.to_scenario(&scenario).unwrap_err();
    assert!(refused.contains("6000") && refused.contains("2000"), "{refused}");
}

#[test]
fn tables_of_any_kind_are_read_and_what_is_wrong_is_named() {
    let read = |text: &str| PartPath::read(text).unwrap();
    let plain = read("s,a_p,a_e\n0,2,3\n50,0,0\n");
    for same in [
        "s [mm];a_p [mm];a_e [mm]\n0;2;3\n50;0;0\n",
        "a_e_mm\ts_cm\tap_um\n3\t0\t2000\n0\t5\t0\n",
        "Path (mm);Axial depth;Radial depth\n0;2,0;3,0\n50,0;0;0\n",
        "# of the shop\nx,y,depth,width\n10,0,2,3\n40,40,0,0\n",
        "x,y,z,ap,ae\n1,2,0,2,3\n1,2,-50,0,0\n",
    ] {
        assert_eq!(read(same), plain, "{same}");
    }
    for (text, meant) in [
        ("sep=;\n\"s [mm]\";a_p;a_e\n", true),
        ("# a part\nx,y,depth,width,line\n", true),
        ("x,y\n1,2\n", false),
        ("n_rpm,a_p,a_e,F_N\n", false),
        ("", false),
    ] {
        assert_eq!(PartPath::is_meant_by(text), meant, "{text}");
    }
    let other = read("s_mm,a_p_mm,a_e_mm,note,feed [m/min]\n0,2,3,a,0.3\n50,0,0,b,\n");
    assert_eq!(other.feeds_mm_min, Some([300.0, 300.0]));
    assert!(other.remarks[0].contains("note"), "{:?}", other.remarks);
    for (text, named) in [
        ("s,a_p\n0,2\n50,2\n", "missing are a_e"),
        ("a_p,a_e\n2,3\n2,3\n", "s (or x and y)"),
        (
            "s,a_p,a_e\n0,9,3\n50,0,0\n",
            "line 2, column `a_p`: `9`: allowed is a number from 0 to 8 mm",
        ),
        ("s,a_p [um],a_e\n0,9000,3\n50,0,0\n", "from 0 to 8000 um"),
        ("s,a_p,a_e\n0,2,51\n50,0,0\n", "column `a_e`: `51`: allowed is a number from 0 to 50 mm"),
        ("s,a_p,a_e\n0,2,3\n50,x,0\n", "line 3, column `a_p`: `x`"),
        ("s,a_p,a_e\n0,,3\n50,0,0\n", "line 2, column `a_p`"),
        ("s,a_p,a_e\n1,2,3\n50,0,0\n", "line 2: the path begins at 1 mm"),
        ("s,a_p,a_e\n0,2,3\n50,2,3\n40,0,0\n", "line 4: the path is at 40 mm"),
        ("s,a_p,a_e\n0,2,3\n", "1 rows"),
        ("s,a_p [kg],a_e\n0,2,3\n5,0,0\n", "unit is `kg`"),
        ("s,s_mm,a_p,a_e\n0,0,2,3\n5,5,0,0\n", "mean the same"),
        ("x,y,a_p,a_e\n0,0,2,3\n20001,0,0,0\n", "at most 20000 mm"),
    ] {
        let error = PartPath::read(text).unwrap_err();
        assert!(error.contains(named), "{text}: {error}");
    }
    let mut several = load("experiment-1").unwrap();
    assert!(PartPath::of(&several.workpiece).unwrap_err().contains("cuts"));
    several.set("workpiece.cuts", Value::List(Vec::new())).unwrap();
    assert_eq!(PartPath::of(&several.workpiece).unwrap().stretches, [[0.0, 2.0, 3.0]]);
}

#[test]
fn the_examples_are_what_they_say() {
    let table = PartPath::read(EXAMPLE_CSV).unwrap();
    assert_eq!((table.length_mm, table.air_mm()), (130.0, 6.0));
    assert!(table.remarks.is_empty() && PartPath::is_meant_by(EXAMPLE_CSV));
    let program = GCodeProgram::read(EXAMPLE_GCODE).unwrap();
    let blank = Blank::new([100.0, 60.0, 20.0], None).unwrap();
    let cutter = Outline { diameter_mm: 12.0, corner_radius_mm: 0.0 };
    let mut job = MillingJob::new(&program, blank, cutter, STEP_MM).unwrap();
    job.to_end();
    let part = job.part().unwrap();
    assert!(part.rapids.is_empty() && part.plunges.is_empty(), "{:?}", part.remarks());
    // 100 mm, a quarter of a circle of 12 mm, 60 mm; two times 40 mm and half a circle of 15 mm.
    let length = 160.0 + 6.0 * math::PI + 80.0 + 15.0 * math::PI;
    assert!((part.length_mm - length).abs() < 1e-6, "{}", part.length_mm);
    assert_eq!(part.path().deepest_mm(), [3.0, 12.0]);
    let shoulder = part.rows.iter().filter(|row| row.s_mm > 20.0 && row.s_mm < 95.0);
    assert!(shoulder.clone().all(|row| [row.axial_mm, row.radial_mm] == [3.0, 4.0]));
    let scenario = taken(&part.path());
    assert!(scenario.workpiece.depth_steps.len() < MAX_STEPS);
}
