//! Recommended cutting conditions (2005, step 1): two neuro-fuzzy systems (ANFIS) interpolate a
//! cutting-data table, v_c over hardness and engagement, f_z over diameter and engagement.
//!
//! Beyond the table the answer is that of its edge, marked. It is an interpolation of the table
//! and knows nothing else.

pub mod learned;
pub mod learning;
pub mod sugeno;
pub mod table;

use serde::Serialize;

use crate::base::language::text;
use crate::base::settings::SettingError;
use crate::models::tool::Tool;
use learned::{Answer, Learned};
use table::Table;

/// What must be said beside every recommendation.
pub const NOTE: &str =
    text!("A recommendation interpolates a table; it is not knowledge of the cut.");

steadycut_core::choice! {
    /// How the cutter stands in the material, in the order of a cutting-data table; the limits of
    /// R_D / D are chosen.
    pub enum EngagementCode {
        /// The whole width of the cutter, R_D from 0.75 D on.
        Slot = "1", "slot";
        /// R_D from 0.4 D on.
        Heavy = "2", "heavy side cut";
        /// R_D from 0.1 D on.
        Light = "3", "light side cut";
        /// R_D below 0.1 D.
        Finishing = "4", "finishing";
    }
}

impl EngagementCode {
    /// The engagement of a radial depth and a diameter in mm.
    #[must_use]
    pub fn of(radial_depth_mm: f64, diameter_mm: f64) -> Self {
        match radial_depth_mm / diameter_mm {
            fraction if fraction >= 0.75 => Self::Slot,
            fraction if fraction >= 0.4 => Self::Heavy,
            fraction if fraction >= 0.1 => Self::Light,
            _ => Self::Finishing,
        }
    }

    /// Its number in a table, 1 to 4.
    #[must_use]
    pub fn number(self) -> f64 {
        1.0 + f64::from(self as u8)
    }
}

/// Memberships of hardness and engagement, and of diameter and engagement: more follow the noise
/// (12 and 18 consequents on 28 and 32 rows).
const COUNTS: [[usize; 2]; 2] = [[2, 2], [2, 3]];

/// Recommended conditions.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Recommendation {
    /// Hardness asked for, HB.
    pub hardness_hb: f64,
    /// Diameter asked for, mm.
    pub diameter_mm: f64,
    /// Number of the engagement asked for.
    pub engagement: &'static str,
    /// Cutting speed, m/min.
    pub cutting_speed_m_min: Answer,
    /// Feed per tooth, mm.
    pub feed_per_tooth_mm: Answer,
    /// Spindle speed, 1/min.
    pub speed_rpm: f64,
    /// Number of teeth of the cutter.
    pub teeth: u32,
    /// Feed of all teeth, mm/min.
    pub feed_mm_min: f64,
}

impl Recommendation {
    /// Whether both values come from inside the table.
    #[must_use]
    pub fn inside_table(&self) -> bool {
        self.cutting_speed_m_min.inside_table && self.feed_per_tooth_mm.inside_table
    }
}

/// Both systems.
#[derive(Clone, Debug)]
pub struct Advisor {
    /// Cutting speed in m/min over hardness in HB.
    pub speed: Learned,
    /// Feed per tooth in mm over diameter in mm.
    pub feed: Learned,
}

impl Advisor {
    /// Learns a table.
    #[must_use]
    pub fn new(table: &Table) -> Self {
        Self {
            speed: Learned::new(text!("hardness"), COUNTS[0], &table.speeds),
            feed: Learned::new(text!("diameter"), COUNTS[1], &table.feeds),
        }
    }

    /// Recommends for a hardness in HB, a cutter (diameter and teeth) and an engagement.
    ///
    /// # Errors
    /// Hardness or diameter outside what a table may hold.
    pub fn recommend(
        &self,
        hardness_hb: f64,
        tool: &Tool,
        engagement: EngagementCode,
    ) -> Result<Recommendation, SettingError> {
        table::check(table::HARDNESS, hardness_hb)?;
        let Tool { diameter_mm, teeth, .. } = *tool;
        table::check(table::DIAMETER, diameter_mm)?;
        let cutting_speed_m_min = self.speed.answer(hardness_hb, engagement);
        let feed_per_tooth_mm = self.feed.answer(diameter_mm, engagement);
        let speed_rpm = tool.speed_rpm(cutting_speed_m_min.value);
        Ok(Recommendation {
            hardness_hb,
            diameter_mm,
            engagement: engagement.id(),
            teeth,
            feed_mm_min: tool.feed_mm_min(feed_per_tooth_mm.value, speed_rpm),
            cutting_speed_m_min,
            feed_per_tooth_mm,
            speed_rpm,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::math;

    fn of(diameter_mm: f64) -> Tool {
        Tool { diameter_mm, ..Tool::default() }
    }

    #[test]
    fn the_shipped_table_is_met_within_its_noise_and_rules_share_the_answer() {
        let advisor = Advisor::new(&Table::shipped());
        // The formulas of the table, without their noise.
        for (hardness, diameter, engagement, speed, feed) in [
            (200.0, 16.0, EngagementCode::Light, 1.0, 1.0),
            (160.0, 8.0, EngagementCode::Heavy, 0.56, 0.95),
            (300.0, 20.0, EngagementCode::Finishing, 1.85, 1.8),
        ] {
            let found = advisor.recommend(hardness, &of(diameter), engagement).unwrap();
            let speed = 100.0 * math::pow(200.0 / hardness, 0.67) * speed;
            let feed = 0.0265 * math::pow(diameter, 0.44) * feed;
            let off = |answer: &Answer, value: f64| (answer.value / value - 1.0).abs();
            assert!(off(&found.cutting_speed_m_min, speed) < 0.08, "{found:?}");
            assert!(off(&found.feed_per_tooth_mm, feed) < 0.08, "{found:?}");
            assert!(found.inside_table());
            let fractions = found.feed_per_tooth_mm.rules.iter().map(|rule| rule.strength);
            assert!((fractions.sum::<f64>() - 1.0).abs() < 1e-12);
            let rules = &found.cutting_speed_m_min.rules;
            assert!(rules.windows(2).all(|pair| pair[0].strength >= pair[1].strength));
            let product: f64 = rules.iter().map(|rule| rule.strength * math::ln(rule.value)).sum();
            assert!((math::exp(product) / found.cutting_speed_m_min.value - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn rows_left_out_are_met_worse_than_rows_learned_and_still_within_some_percent() {
        let speed = Advisor::new(&Table::shipped()).speed;
        let (learned, left_out) = (speed.training_errors(), speed.left_out_errors());
        // An independent implementation: 2.8 % and 4.2 % on a table of other noise.
        assert!((1.5..3.5).contains(&learned.rms_percent), "{learned:?}");
        assert!(left_out.rms_percent > learned.rms_percent && left_out.rms_percent < 6.0);
        assert!(left_out.mean_percent < left_out.rms_percent);
    }

    #[test]
    fn beyond_the_table_its_edge_answers_and_is_marked() {
        let advisor = Advisor::new(&Table::shipped());
        let ask = |hb, d| advisor.recommend(hb, &of(d), EngagementCode::Slot).unwrap();
        let (edge, beyond) = (ask(450.0, 20.0), ask(600.0, 32.0));
        assert!(edge.inside_table() && !beyond.inside_table());
        assert_eq!(edge.cutting_speed_m_min.value, beyond.cutting_speed_m_min.value);
        assert_eq!(edge.feed_per_tooth_mm.value, beyond.feed_per_tooth_mm.value);
        assert!(!ask(600.0, 16.0).cutting_speed_m_min.inside_table);
        assert!(ask(600.0, 16.0).feed_per_tooth_mm.inside_table);
        for (hb, d) in [(f64::NAN, 16.0), (200.0, 0.0), (1e9, 16.0), (200.0, f64::INFINITY)] {
            let error =
                advisor.recommend(hb, &of(d), EngagementCode::Slot).unwrap_err().to_string();
            assert!(error.contains("allowed is a number from"), "{error}");
        }
    }

    #[test]
    fn a_table_of_twice_the_feeds_gives_twice_the_feed() {
        let mut table = Table::shipped();
        let ask = |table: &Table| {
            let found =
                Advisor::new(table).recommend(200.0, &of(16.0), EngagementCode::Heavy).unwrap();
            [found.cutting_speed_m_min.value, found.feed_per_tooth_mm.value]
        };
        let once = ask(&table);
        table.feeds.iter_mut().for_each(|(_, feed)| *feed *= 2.0);
        let twice = ask(&table);
        assert_eq!(once[0], twice[0]);
        assert!((twice[1] / once[1] - 2.0).abs() < 0.02, "{once:?} {twice:?}");
    }

    #[test]
    fn engagements_follow_the_radial_depth() {
        let of = |radial| EngagementCode::of(radial, 16.0);
        assert_eq!([of(16.0), of(7.3), of(3.2), of(1.0)], *EngagementCode::ALL);
        assert_eq!(EngagementCode::from_id("3").map(EngagementCode::number), Some(3.0));
    }
}
