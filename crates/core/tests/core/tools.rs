//! Other cutters than the papers': forces against closed forms and against each other, and every shipped
//! one in the closed loop.

use steadycut_core::base::math;
use steadycut_core::base::settings::Value;
use steadycut_core::models::mechanistic::{CK45, Cutter, Kienzle, Sliced, steady};
use steadycut_core::models::tool::{EndShape, ShippedTool, Tool};
use steadycut_core::run::edits::Edits;
use steadycut_core::run::one_run::Run;
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::Scenario;
use steadycut_core::run::signals::{Row, flag};
use steadycut_core::run::{scenario_file, scenario_link};

const AXIAL_MM: f64 = 3.0;

fn square(teeth: u32, helix_deg: f64) -> Tool {
    Tool { shape: EndShape::Square, teeth, helix_deg, ..Tool::default() }
}

/// Mean forces in N over a turn of a slot at a feed per tooth in mm, the tool rigid and without run-out.
fn mean_in_slot(tool: &Tool, law: &Kienzle, feed_per_tooth_mm: f64) -> [f64; 3] {
    const STEPS: usize = 2880;
    let sliced = Sliced::new(&Cutter::new(tool, 0.0, 0.1), AXIAL_MM);
    let mut mean = [0.0; 3];
    for step in 0..STEPS {
        let angle = math::TAU * step as f64 / STEPS as f64;
        let forces = sliced.forces(law, angle, &steady(feed_per_tooth_mm), |_, _| AXIAL_MM);
        for (mean, force) in mean.iter_mut().zip(forces.forces_n) {
            *mean += force / STEPS as f64;
        }
    }
    mean
}

#[test]
fn a_square_end_in_a_slot_has_the_mean_forces_of_the_closed_form() {
    // Altintas, Manufacturing Automation, eq. 2.24, for forces on the tool and dF_i = K_i a h:
    // F_x = -z a c K_r / 4, F_y = z a c K_t / 4, F_z = -z a c K_a / pi, whatever the helix.
    let linear = Kienzle { k_n_mm2: [2000.0, 700.0, 300.0], exponents: [1.0; 3] };
    for (teeth, helix_deg) in [(1, 0.0), (2, 0.0), (2, 30.0), (3, 45.0), (4, 38.0), (8, 10.0)] {
        let found = mean_in_slot(&square(teeth, helix_deg), &linear, 0.08);
        let area = f64::from(teeth) * AXIAL_MM * 0.08;
        let [t, r, a] = linear.k_n_mm2;
        let expected = [-area * r / 4.0, area * t / 4.0, -area * a / math::PI];
        for (found, expected) in found.iter().zip(expected) {
            assert!(
                (found / expected - 1.0).abs() < 1e-3,
                "{teeth} {helix_deg}: {found} {expected}"
            );
        }
    }
}

#[test]
fn more_teeth_at_the_same_feed_per_revolution_cut_with_the_laws_power_more() {
    // z (f/z)^(1 - m) grows as z^m; for a linear law not at all.
    let law = Kienzle::new(&CK45, 80.0, 12.0, 200.0);
    let linear = Kienzle { exponents: [1.0; 3], ..law };
    for (law, power) in [(law, 1.0 - law.exponents[0]), (linear, 0.0)] {
        let across = |teeth: u32| mean_in_slot(&square(teeth, 30.0), &law, 0.24 / f64::from(teeth));
        let two = across(2)[1];
        for teeth in [3, 4, 6] {
            let ratio = across(teeth)[1] / two;
            let expected = math::pow(f64::from(teeth) / 2.0, power);
            assert!((ratio / expected - 1.0).abs() < 1e-3, "{teeth}: {ratio} {expected}");
        }
    }
}

#[test]
fn a_bull_nose_is_a_ball_at_one_end_of_its_corner_and_a_square_at_the_other() {
    let law = Kienzle::new(&CK45, 80.0, 12.0, 200.0);
    let of = |shape, corner_radius_mm| {
        let tool = Tool { shape, corner_radius_mm, helix_deg: 30.0, ..Tool::default() };
        mean_in_slot(&tool, &law, 0.08)
    };
    assert_eq!(of(EndShape::BullNose, 8.0), of(EndShape::Ball, 1.0));
    assert_eq!(of(EndShape::BullNose, 0.0), of(EndShape::Square, 1.0));
    let sharp = of(EndShape::Square, 0.0);
    let mut before = f64::INFINITY;
    for corner in [4.0, 1.0, 0.25, 1e-3] {
        let rounded = of(EndShape::BullNose, corner);
        let off = rounded.iter().zip(sharp).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off <= before, "corner {corner}: {off} N after {before} N");
        before = off;
    }
    assert!(before < 1e-9, "{before} N");
}

#[test]
fn run_out_of_four_teeth_follows_the_shifted_axis() {
    let cutter = Cutter::new(&square(4, 0.0), 0.01, 0.1);
    for (found, expected) in cutter.runout_mm.iter().zip([0.01, 0.0, -0.01, 0.0]) {
        assert!((found - expected).abs() < 1e-15, "{found}");
    }
    // The chip is that of rho_j - rho_(j-1): the tooth behind the one furthest in cuts most.
    let law = Kienzle { k_n_mm2: [2000.0, 0.0, 0.0], exponents: [1.0; 3] };
    let sliced = Sliced::new(&cutter, 1.0);
    let peak = |tooth: u32| {
        let angle = math::PI / 2.0 + math::TAU * f64::from(tooth) / 4.0;
        // Only the sector about the direction across the feed is in the material.
        let ahead = |x: f64, y: f64| if x > 7.9 && y.abs() < 1.0 { 1.0 } else { 0.0 };
        sliced.forces(&law, angle, &steady(0.05), ahead).forces_n[1]
    };
    for (tooth, chip_mm) in [(0, 0.06), (1, 0.04), (2, 0.04), (3, 0.06)] {
        assert!((peak(tooth) - 2000.0 * chip_mm).abs() < 1e-9, "{tooth}: {}", peak(tooth));
    }
}

fn with(name: &str, tool: ShippedTool) -> Scenario {
    let mut scenario = load(name).unwrap();
    scenario.set("tool.name", Value::Text(tool.id().to_owned())).unwrap();
    scenario
}

fn rows(mut scenario: Scenario, duration_s: f64) -> Vec<Row> {
    scenario.set("run.duration_s", Value::Float(duration_s)).unwrap();
    Run::complete(&scenario, &Edits::none()).recording().rows().to_vec()
}

#[test]
fn every_shipped_cutter_runs_tooth_by_tooth_and_its_roughness_is_marked_as_unknown() {
    let mut peaks = Vec::new();
    for tool in ShippedTool::ALL {
        let rows = rows(with("experiment-1", *tool), 6.0);
        let cutting: Vec<&Row> = rows.iter().filter(|row| !row.has(flag::AIR)).collect();
        assert!(cutting.len() > 100, "{tool:?}");
        let papers = *tool == ShippedTool::R21616B20;
        for row in &cutting {
            assert!(row.force_n > 0.0 && row.force_n < 5000.0, "{tool:?} {}", row.force_n);
            assert!(!row.has(flag::K4_OUTSIDE), "the teeth hold for every cutter");
            assert!(papers || row.has(flag::K5_OUTSIDE), "{tool:?}");
        }
        let peak = cutting.iter().map(|row| row.force_n).fold(0.0, f64::max);
        assert!(peaks.iter().all(|other: &f64| (other - peak).abs() > 1e-6), "{tool:?} {peak}");
        peaks.push(peak);
    }
}

#[test]
fn formulas_and_networks_are_outside_their_range_with_another_cutter() {
    // One cuts by the formula, the other by a network.
    for preset in ["first-cut", "strategy-2013"] {
        for tool in ShippedTool::ALL {
            let rows = rows(with(preset, *tool), 2.0);
            let outside = |bit: u32| rows.iter().all(|row| row.has(bit));
            if *tool == ShippedTool::R21616B20 {
                assert!(!outside(flag::K4_OUTSIDE), "{preset}");
            } else {
                for bit in [flag::K1_OUTSIDE, flag::K4_OUTSIDE, flag::K5_OUTSIDE, flag::K6_OUTSIDE]
                {
                    assert!(outside(bit), "{preset} {tool:?} {bit:b}");
                }
            }
        }
    }
}

#[test]
fn choosing_a_cutter_sets_its_values_and_what_is_set_with_it_wins() {
    let mut scenario = Scenario::default();
    let text = |id: &str| Value::Text(id.to_owned());
    scenario.set("tool.name", text("bull-nose-16-4")).unwrap();
    let file = ShippedTool::BullNose16.load();
    assert_eq!(scenario.tool, Tool { name: ShippedTool::BullNose16, ..file.tool });
    let both = [
        ("tool.overhang_mm".to_owned(), Value::Float(60.0)),
        ("tool.name".to_owned(), text("square-20-3")),
        ("tool.runout_um".to_owned(), Value::Float(7.0)),
        ("workpiece.radial_depth_mm".to_owned(), Value::Float(20.0)),
    ];
    scenario.set_all(&both).unwrap();
    assert_eq!((scenario.tool.diameter_mm, scenario.tool.overhang_mm), (20.0, 60.0));
    assert_eq!(scenario.tool.runout_um, 7.0);
    let file = scenario_file::write(&scenario, &Edits::none());
    assert_eq!(scenario_file::parse(&file).unwrap().0, scenario);
    let link = scenario_link::write(&scenario, &Edits::none());
    assert_eq!(scenario_link::parse(&link).unwrap().0, scenario);

    let message =
        |path: &str, value: Value| scenario.clone().set(path, value).unwrap_err().to_string();
    let said = message("tool.name", text("square-12-4"));
    assert!(said.contains("workpiece.radial_depth_mm") && said.contains("12 mm"), "{said}");
    let said = message("tool.diameter_mm", Value::Float(1.0));
    assert!(said.contains("tool.diameter_mm") && said.contains("2 to 50 mm"), "{said}");
    scenario.set("tool.shape", text("bull_nose")).unwrap();
    let said = scenario.set("tool.corner_radius_mm", Value::Float(10.5)).unwrap_err().to_string();
    assert!(said.contains("tool.corner_radius_mm") && said.contains("10 mm"), "{said}");
}
