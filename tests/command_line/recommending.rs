//! Recommended cutting conditions as the command line gives them.

use std::path::PathBuf;

use proptest::prelude::*;
use steadycut::models::tool::Tool;
use steadycut::study::recommend::table::Table;
use steadycut::study::recommend::{Advisor, EngagementCode};

use super::program::{json, steadycut};

const ASK: [&str; 7] = ["recommend", "--hb", "200", "--diameter", "16", "--engagement", "2"];

#[test]
fn the_shipped_table_is_regenerated_exactly() {
    assert!(steadycut(&["recommend", "table", "--check"]).status.success());
    let printed = steadycut(&["recommend", "table"]).stdout;
    assert_eq!(printed, include_bytes!("../../assets/data/cutting_data_2005.csv"));
}

#[test]
fn a_recommendation_names_its_rules_its_errors_and_its_table() {
    let report = json(&[&ASK[..], &["--json"]].concat());
    let found = &report["recommendation"];
    let [speed, feed] = ["cutting_speed_m_min", "feed_per_tooth_mm"].map(|key| {
        assert_eq!(found[key]["inside_table"], true);
        assert!(report["systems"][key]["left_out"]["rms_percent"].as_f64().unwrap() < 6.0);
        assert!(found[key]["rules"].as_array().unwrap().len() >= 4);
        found[key]["value"].as_f64().unwrap()
    });
    let rpm = 1000.0 * speed / (std::f64::consts::PI * 16.0);
    assert!((found["speed_rpm"].as_f64().unwrap() - rpm).abs() < 1e-6);
    assert!((found["feed_mm_min"].as_f64().unwrap() - 2.0 * feed * rpm).abs() < 1e-6);
    let text = String::from_utf8(steadycut(&ASK).stdout).unwrap();
    for part in ["synthetic", "not knowledge", "rows left out", "hardness low, engagement high"] {
        assert!(text.contains(part), "{part}: {text}");
    }
}

#[test]
fn a_faulty_table_or_question_is_refused_by_name() {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("cutting_data.csv");
    let file = path.to_str().unwrap();
    let with_table = [&ASK[..], &["--table", file]].concat();
    let shipped = include_str!("../../assets/data/cutting_data_2005.csv");
    std::fs::write(&path, shipped.replacen("200,,1,", "200,,1,-", 1)).unwrap();
    let output = steadycut(&with_table);
    let error = String::from_utf8(output.stderr).unwrap();
    assert!(!output.status.success() && output.stdout.is_empty());
    for part in ["cutting_data.csv", "line 23", "`cutting_speed_m_min`", "-", "from 1 to 2000"] {
        assert!(error.contains(part), "{part}: {error}");
    }
    let output = steadycut(&["recommend", "--hb", "nan", "--diameter", "16", "--engagement", "2"]);
    assert!(String::from_utf8(output.stderr).unwrap().contains("hardness_hb"));
}

/// Rows of any allowed numbers.
fn rows() -> impl Strategy<Value = Vec<(f64, f64, u8, f64, f64)>> {
    let row = (50.0..=700.0, 0.5..=100.0, 1..=4_u8, 1.0..=2000.0, 0.0001..=5.0);
    proptest::collection::vec(row, 1..12)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn any_table_is_refused_or_answers_with_finite_numbers(rows in rows()) {
        let mut text = "hardness_hb,diameter_mm,engagement,cutting_speed_m_min,feed_per_tooth_mm\n"
            .to_owned();
        for (hardness, diameter, engagement, speed, feed) in &rows {
            text += &format!("{hardness},{diameter},{engagement},{speed},{feed}\n");
        }
        let Ok(table) = Table::parse(&text) else {
            // Draws within 1 % of each other are the rest.
            prop_assert!(rows.len() < 4 || rows.iter().all(|row| row.2 == rows[0].2), "{}", text);
            return Ok(());
        };
        let advisor = Advisor::new(&table);
        for (hardness, diameter) in [(50.0, 0.5), (230.0, 16.0), (700.0, 100.0)] {
            for engagement in EngagementCode::ALL {
                let tool = Tool { diameter_mm: diameter, ..Tool::default() };
                let found = advisor.recommend(hardness, &tool, *engagement).unwrap();
                let values = [found.cutting_speed_m_min.value, found.feed_per_tooth_mm.value];
                prop_assert!(values.iter().all(|x| x.is_finite() && *x > 0.0), "{:?}", values);
            }
        }
    }

    #[test]
    fn text_that_is_no_table_is_refused_and_never_panics(
        text in "[0-9a-z,;\t.#\n\"-]{0,80}",
        at in 0..1000_usize,
    ) {
        prop_assert!(Table::parse(&text).is_err());
        let mut damaged = include_str!("../../assets/data/cutting_data_2005.csv").to_owned();
        damaged.insert_str(at, &text);
        let _ = Table::parse(&damaged);
    }
}
