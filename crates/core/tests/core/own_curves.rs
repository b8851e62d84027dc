//! Curves of material and wear as formulas of one's own: plants of every kind compute with them, cards show them,
//! what lies beyond their ranges is marked.

use steadycut_core::base::math;
use steadycut_core::base::settings::Value;
use steadycut_core::blocks::control::ControllerKind;
use steadycut_core::blocks::cutting::process::ForceModel;
use steadycut_core::models::wear::WearCut;
use steadycut_core::run::edits::Edits;
use steadycut_core::run::explanation::explain_force;
use steadycut_core::run::one_run::Run;
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::Scenario;
use steadycut_core::run::signals::{Row, flag};
use steadycut_core::run::{scenario_file, scenario_link};

fn quiet() -> Scenario {
    let own = load("own-curves").unwrap();
    own.with(|s| {
        s.noise.level = 0.0;
        s.controller.kind = ControllerKind::ConstantFeed;
    })
    .unwrap()
}

fn rows(scenario: &Scenario) -> Vec<Row> {
    Run::complete(scenario, &Edits::none()).recording().rows().to_vec()
}

fn without(mut scenario: Scenario, paths: &[&str]) -> Scenario {
    for path in paths {
        scenario.set(path, Value::Text(String::new())).unwrap();
    }
    scenario
}

#[test]
fn the_material_is_its_formula_times_ck45_in_every_plant() {
    for force_model in ForceModel::ALL {
        let plain = load("table3-5").unwrap().with(|s| {
            s.controller.kind = ControllerKind::ConstantFeed;
            s.plant.force_model = *force_model;
            s.run.duration_s = 1.5;
            if force_model.tooth_by_tooth() {
                s.run.steps_per_control = 200;
                s.run.record_every = 200;
            }
        });
        let ck45 = plain.unwrap();
        let mut own = ck45.clone();
        own.set("formula.material", quiet().get("formula.material").unwrap()).unwrap();
        own.set("plant.hardness_hb", Value::Float(250.0)).unwrap();
        let factor = math::pow(250.0 / 200.0, 0.55);
        let mut compared = 0;
        for (own, ck45) in rows(&own).iter().zip(rows(&ck45)) {
            assert!((own.force_n - factor * ck45.force_n).abs() < 0.02 * ck45.force_n + 1e-9);
            if force_model.is_map() {
                assert!((own.force_n - factor * ck45.force_n).abs() < 1e-9, "{own:?} {ck45:?}");
            }
            compared += usize::from(ck45.force_n > 50.0);
        }
        assert!(compared > 20, "{force_model:?}");
        // Whatever the material is called.
        let mut brass = own.clone();
        brass.set("plant.material", Value::Text("cuzn39pb3".to_owned())).unwrap();
        brass.set("plant.hardness_hb", Value::Float(250.0)).unwrap();
        assert_eq!(rows(&brass), rows(&own), "{force_model:?}");
        let mut hard = own.clone();
        hard.set("plant.hardness_hb", Value::Float(320.0)).unwrap();
        assert!(!rows(&own).last().unwrap().has(flag::K4_OUTSIDE), "{force_model:?}");
        assert!(rows(&hard).last().unwrap().has(flag::K4_OUTSIDE), "{force_model:?}");
    }
}

/// Kienzle's own law as a formula gives Kienzle's forces.
#[test]
fn the_specific_cutting_force_stands_in_the_place_of_kienzle_s() {
    let plain = load("table3-5").unwrap().with(|s| {
        s.controller.kind = ControllerKind::ConstantFeed;
        s.plant.force_model = ForceModel::Mechanistic;
        s.run.duration_s = 1.0;
        s.run.steps_per_control = 200;
        s.run.record_every = 200;
    });
    let plain = plain.unwrap();
    let with = |formula: &str, high: f64| {
        let text = format!(
            r#"{{"version":1,"formula":"{formula}","output":{{"name":"kc","unit":"N/mm^2"}},"inputs":[{{"name":"h","unit":"mm","low":1e-9,"high":{high}}}]}}"#
        );
        let mut own = plain.clone();
        own.set("formula.specific_force", Value::Text(text)).unwrap();
        rows(&own)
    };
    let own = with("2220*h^-0.14", 0.5);
    for (own, kienzle) in own.iter().zip(rows(&plain)) {
        assert!((own.force_n - kienzle.force_n).abs() < 1e-6 * (1.0 + kienzle.force_n), "{own:?}");
        assert!(!own.has(flag::K4_OUTSIDE), "{own:?}");
    }
    let last = |rows: &[Row]| *rows.last().unwrap();
    let doubled = last(&with("4440*h^-0.14", 0.5));
    let ratio = doubled.force_n / last(&own).force_n;
    assert!((1.5..2.0).contains(&ratio), "the radial force is Kienzle's still: {ratio}");
    // All three as formulas are Kienzle's as well, and all three doubled are twice the force of a rigid tool.
    let all = |factor: f64| {
        let mut own = plain.with(|s| s.tool.compliance_um_n = 0.0).unwrap();
        for (path, k, m) in [
            ("formula.specific_force", 2220.0, 0.14),
            ("formula.specific_radial_force", 450.0, 0.45),
            ("formula.specific_axial_force", 200.0, 0.20),
        ] {
            let text = format!(
                r#"{{"version":1,"formula":"{}*h^-{m}","output":{{"name":"k","unit":"N/mm^2"}},"inputs":[{{"name":"h","unit":"mm","low":1e-9,"high":0.5}}]}}"#,
                factor * k
            );
            own.set(path, Value::Text(text)).unwrap();
        }
        last(&rows(&own)).force_n
    };
    let rigid_n = last(&rows(&plain.with(|s| s.tool.compliance_um_n = 0.0).unwrap())).force_n;
    for factor in [1.0, 2.0] {
        let ratio = all(factor) / rigid_n;
        assert!((ratio - factor).abs() < 1e-6, "{factor}: {ratio}");
    }
    // 430 mm/min by two teeth at 1571 1/min are 0.137 mm a tooth.
    assert!(last(&with("2220*h^-0.14", 0.13)).has(flag::K4_OUTSIDE));
    assert!(!last(&with("2220*h^-0.14", 0.14)).has(flag::K4_OUTSIDE));
}

#[test]
fn force_and_life_follow_their_formulas() {
    let own = quiet();
    let sharp = without(own.clone(), &["wear.curve", "wear.force_curve", "wear.life_curve"]);
    let sharp = sharp.with(|s| s.wear.force_growth = 0.0).unwrap();
    let sharp_n = rows(&sharp).last().unwrap().force_n;
    let all = rows(&own);
    let wear = |x: f64| 0.35 * x.sqrt() + 0.25 * x + 0.4 * math::pow(x, 6.0);
    for row in all.iter().filter(|row| row.time_s > 5.0 && row.used_life < 1.0) {
        let w = wear(row.used_life);
        let expected_n = sharp_n * (1.0 + 0.4 * w + 0.25 * w * w);
        assert!((row.force_n / expected_n - 1.0).abs() < 1e-3, "{row:?} {expected_n}");
    }
    // The life by hand: v over 160 m/min, fz over 0.135 mm, ap over 2 mm.
    let last = all.iter().rfind(|row| !row.has(flag::AIR)).unwrap();
    let v = math::PI * 16.0 * last.spindle_rpm / 1000.0;
    let fz = last.feed_mm_min / (2.0 * last.spindle_rpm);
    let life_min = 15.0 * math::pow(v / 160.0, -3.6) * math::pow(fz / 0.135, -0.7);
    let cut = WearCut { cutting_speed_m_min: v, feed_per_tooth_mm: fz, axial_depth_mm: 2.0 };
    assert!((own.wear.life_min(&cut) / life_min - 1.0).abs() < 1e-9, "{life_min}");
    let [early, late] = [10.0, 20.0].map(|at_s| all.iter().find(|row| row.time_s >= at_s).unwrap());
    let rate = (late.used_life - early.used_life) / (late.time_s - early.time_s);
    assert!((rate * 60.0 * life_min / own.wear.time_scale - 1.0).abs() < 1e-3, "{rate} {life_min}");
}

#[test]
fn what_lies_beyond_a_curve_s_range_is_marked() {
    let own = quiet();
    let marked = |scenario: &Scenario, x: f64| {
        let worn = scenario.with(|s| (s.wear.used_life, s.run.duration_s) = (x, 0.5)).unwrap();
        rows(&worn).last().unwrap().has(flag::K4_OUTSIDE)
    };
    // From 0.01 to 1 of the life.
    assert!(marked(&own, 0.0) && !marked(&own, 0.5) && marked(&own, 1.0));
    // The life's formula holds from 0.5 mm depth on.
    let thin = own.with(|s| s.workpiece.axial_depth_mm = 0.4).unwrap();
    assert!(marked(&thin, 0.5) && !marked(&without(thin, &["wear.life_curve"]), 0.5));
    let far = own.with(|s| s.plant.force_offset_n = 0.0).unwrap();
    let worn = far.wear.force_valued(1.9);
    assert!(!worn.valid && worn.value > 1.0 + 0.4 * 1.2 + 0.25 * 1.44, "straight on: {worn:?}");
    // A life that a straight line ends at nothing is a short one, not a negative one.
    let cut = WearCut { cutting_speed_m_min: 5000.0, feed_per_tooth_mm: 0.1, axial_depth_mm: 2.0 };
    let life = own.wear.life_valued(&cut);
    assert!(!life.valid && life.value > 0.0 && life.value < 0.1, "{life:?}");
}

#[test]
fn the_card_of_the_cut_shows_the_curves_with_the_values_of_the_row() {
    let own = quiet();
    let all = rows(&own);
    let row = all.iter().find(|row| row.time_s >= 12.0).unwrap();
    let card = explain_force(&own, row);
    let of = |symbol: &str| card.iter().find(|line| line.formula.starts_with(symbol)).unwrap();
    assert_eq!(of("material = ").formula, "material = (HB / 200)^{0.55}");
    assert!(of("material = ").range.starts_with("HB 150 to 300 HB"));
    assert!(of("w = ").formula.contains("0.35 · x^{0.5}"), "{:?}", of("w = "));
    assert!(of("P/P_0 = ").valid && of("T = ").range.contains("v_c 40 to 250 m/min"));
    assert!(card.iter().all(|line| !line.formula.starts_with("k_3")), "no machine vibrates");
    let fixed =
        own.with(|s| s.wear.model = steadycut_core::models::wear::WearModel::Fixed).unwrap();
    let card = explain_force(&fixed, row);
    assert!(card.iter().all(|line| !line.formula.starts_with("w = ")), "{card:?}");
}

#[test]
fn file_and_link_carry_curves_and_others_units_are_refused() {
    let own = quiet();
    let written = scenario_file::write(&own, &Edits::none());
    assert_eq!(scenario_file::parse(&written).unwrap().0, own);
    let link = scenario_link::write(&own, &Edits::none());
    assert_eq!(scenario_link::parse(&link).unwrap().0, own);
    let mut other = own.clone();
    let text = own.get("wear.life_curve").unwrap().to_string();
    for (from, to, part) in [
        ("\"unit\": \"m/min\"", "\"unit\": \"mm\"", "the cutting speed in m/min"),
        ("\"unit\": \"min\"", "\"unit\": \"\"", "min"),
        ("\"low\": 40.0", "\"low\": 0.0", "not certain"),
    ] {
        assert!(text.contains(from), "{from}: {text}");
        let refused = other.set("wear.life_curve", Value::Text(text.replacen(from, to, 1)));
        let refused = refused.unwrap_err().to_string();
        assert!(refused.contains("wear.life_curve") && refused.contains(part), "{to}: {refused}");
    }
    assert_eq!(other, own);
}

/// A scenario whose drives reach what formulas say.
fn driven(feed: &str, speed: &str) -> Scenario {
    let mut scenario = load("table3-5")
        .unwrap()
        .with(|s| s.controller.kind = ControllerKind::ConstantFeed)
        .unwrap();
    let model = |formula: &str, unit: &str, high: f64| {
        format!(
            r#"{{"version":1,"formula":"{formula}","output":{{"name":"y","unit":"{unit}"}},"inputs":[{{"name":"x","unit":"{unit}","low":1,"high":{high}}}]}}"#
        )
    };
    scenario.set("feed_drive.curve", Value::Text(model(feed, "mm/min", 500.0))).unwrap();
    scenario.set("spindle_drive.curve", Value::Text(model(speed, "1/min", 1600.0))).unwrap();
    scenario
}

#[test]
fn drives_come_to_rest_where_their_formulas_say() {
    let plain = load("table3-5")
        .unwrap()
        .with(|s| s.controller.kind = ControllerKind::ConstantFeed)
        .unwrap();
    // What is asked for is reached: the same bits.
    assert_eq!(rows(&driven("x", "x")), rows(&plain));
    let slow = rows(&driven("0.9*x", "x - 2e-5*x^2"));
    let [first, last] = [slow[0], *slow.last().unwrap()];
    let asked = plain.program.feed_mm_min;
    assert!((last.feed_mm_min - 0.9 * asked).abs() < 1e-6 * asked, "{last:?}");
    let turned = 1571.0 - 2e-5 * 1571.0 * 1571.0;
    assert!((last.spindle_rpm - turned).abs() < 1e-6 * turned, "{last:?}");
    // It begins at rest there, too.
    assert!((first.feed_mm_min - last.feed_mm_min).abs() < 1e-6 * asked, "{first:?}");
    assert!(!last.has(flag::K4_OUTSIDE), "{last:?}");
    // Beyond 500 mm/min nobody knows.
    let beyond = driven("0.9*x", "x").with(|s| s.program.feed_mm_min = 520.0).unwrap();
    assert!(rows(&beyond).iter().all(|row| row.has(flag::K4_OUTSIDE)));
}

/// A stop stops, whatever a formula says of a feed of nothing; a negative feed is none.
#[test]
fn a_stopped_drive_stands_and_none_runs_backwards() {
    let mut stopped = driven("x + 50", "x");
    stopped.set("controller.constant_feed.feed_percent", Value::Float(0.0)).unwrap();
    let last = *rows(&stopped).last().unwrap();
    assert!(last.feed_mm_min < 1e-6, "{last:?}");
    let backwards = rows(&driven("x - 450", "x"));
    assert!(backwards.iter().all(|row| row.feed_mm_min >= 0.0));
    assert!(backwards.last().unwrap().has(flag::K4_OUTSIDE));
}
