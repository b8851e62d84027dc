//! The law against sequences worked out by hand: 20 ms, a reference of 100 N, recovery 20 %/s.

use super::*;
use crate::blocks::control::ControllerSettings;
use crate::blocks::control::{Belief, ControllerKind};
use crate::models::genetic::{Calibration, GeneticModels};
use crate::models::part::ProgrammedPart;
use crate::models::tool::Tool;

const PROGRAMMED: FeedSpeed = FeedSpeed { feed_mm_min: 400.0, speed_rpm: 1500.0 };
const LIMITS: Limits = Limits {
    feed_mm_min: [0.0, 1000.0],
    speed_rpm: [0.0, 3750.0],
    resolution: FeedSpeed { feed_mm_min: 0.0, speed_rpm: 0.0 },
};

fn with<T>(settings: &AfcSettings, then: impl FnOnce(&ControlSetup) -> T) -> T {
    let all = ControllerSettings {
        kind: ControllerKind::Afc,
        afc: settings.clone(),
        ..ControllerSettings::default()
    };
    let (tool, belief) = (Tool::default(), Belief::default());
    let (axial_depth_mm, radial_depth_mm) = (2.0, 3.0);
    let part = ProgrammedPart {
        cuts: &[],
        axial_depth_mm,
        radial_depth_mm,
        depth_steps: &[],
        radial_steps: &[],
    };
    then(&ControlSetup { settings: &all, part, tool: &tool, belief: &belief, period_s: 0.02 })
}

fn taught() -> AfcSettings {
    AfcSettings { references_n: vec![100.0], ..AfcSettings::default() }
}

/// A controller, and what it asks for: feed in percent, and an overload.
struct Asked {
    afc: Afc,
    models: GeneticModels,
    by_hand: f64,
}

impl Asked {
    fn of(settings: &AfcSettings) -> Self {
        let afc = with(settings, |setup| Afc::new(settings, setup, PROGRAMMED));
        Self {
            afc,
            models: GeneticModels::new(ModelSet::Sdnrp2007, Calibration::Identified),
            by_hand: 1.0,
        }
    }

    fn both(&mut self, force_measured_n: f64) -> (f64, Option<Exceeded>) {
        let output = self.afc.update(&ControlInput {
            force_measured_n,
            force_ref_n: 180.0,
            programmed: PROGRAMMED,
            applied: PROGRAMMED,
            limits: LIMITS,
            models: &self.models,
            cut: 0,
            x_mm: 0.0,
            by_hand: self.by_hand,
        });
        assert_eq!(output.request.speed_rpm, PROGRAMMED.speed_rpm, "the spindle is not its own");
        (percent_from_ratio(output.request.feed_mm_min / PROGRAMMED.feed_mm_min), output.exceeded)
    }

    fn feeds(&mut self, forces_n: &[f64]) -> Vec<f64> {
        forces_n.iter().map(|force_n| (1e9 * self.both(*force_n).0).round() / 1e9).collect()
    }
}

#[test]
fn the_feed_goes_down_five_times_as_fast_as_up_and_ends_at_the_quotient() {
    let mut asked = Asked::of(&taught());
    // The first contact: entry feed. Recovery by 0.4 % a period towards 100 / 100.
    assert_eq!(asked.feeds(&[100.0, 100.0, 100.0]), [80.0, 80.4, 80.8]);
    // Retreat by 2 % towards 100 / 130 = 76.9 %, which is reached and kept.
    assert_eq!(asked.feeds(&[130.0, 130.0, 130.0]), [78.8, 76.923_076_923, 76.923_076_923]);
    assert_eq!(asked.feeds(&[100.0]), [77.323_076_923]);
}

#[test]
fn nothing_goes_below_fmin_or_above_fmax_and_fmin_not_below_thirty_percent() {
    let settings = AfcSettings { f_min_percent: 30.0, ..taught() };
    let mut asked = Asked::of(&settings);
    let down = asked.feeds(&[900.0; 60]);
    assert_eq!(down[..2], [80.0, 78.0]);
    assert_eq!(down[59], 30.0);
    assert!(down.iter().all(|percent| *percent >= FLOOR_PERCENT));
    // From 30 to 120 % at 0.4 % a period: 225 periods.
    let up = asked.feeds(&[20.0; 230]);
    assert_eq!((up[0], up[224], up[229]), (30.4, 120.0, 120.0));
}

#[test]
fn below_the_exit_threshold_it_is_air_and_the_next_contact_an_entry() {
    let mut asked = Asked::of(&taught());
    // 8 % of 100 N are 8 N: contact there, air below.
    assert_eq!(
        asked.feeds(&[0.0, 7.9, 8.0, 100.0, 7.9, 100.0]),
        [150.0, 150.0, 80.0, 80.4, 150.0, 80.0]
    );
}

#[test]
fn an_overload_is_one_after_more_than_a_second_at_fmin_and_not_before() {
    let settings = AfcSettings { f_min_percent: 80.0, ..taught() };
    let mut asked = Asked::of(&settings);
    // The entry feed is FMIN here: from the second sample on the feed stands there.
    let over: Vec<bool> = (0..60).map(|_| asked.both(131.0).1.is_some()).collect();
    let first = over.iter().position(|over| *over);
    // The second sample is the first that is over the limit at FMIN: 1 s later is sample 52 (from 1).
    assert_eq!(first, Some(52));
    // A moment below the limit, and the second begins anew.
    assert_eq!(asked.both(130.0).1, None);
    assert!((0..51).all(|_| asked.both(131.0).1.is_none()));
    let exceeded = asked.both(131.0).1.expect("more than a second");
    assert_eq!((exceeded.limit_n, exceeded.reaction), (130.0, OverloadReaction::Stop));
}

#[test]
fn while_the_feed_can_still_go_down_there_is_no_overload() {
    // FMIN is 50 %, the quotient 66.7 %: the feed stays above FMIN.
    let mut asked = Asked::of(&taught());
    assert!((0..500).all(|_| asked.both(150.0).1.is_none()));
    // Over the limit before the feed has come down to 50 %: the time counts from there.
    let mut asked = Asked::of(&taught());
    let first = (0..200).position(|_| asked.both(400.0).1.is_some());
    // Entry, then 15 periods from 80 to 50 %, 51 periods of more than a second.
    assert_eq!(first, Some(16 + 51));
}

#[test]
fn watching_and_teaching_in_leave_the_feed_alone_to_the_bit() {
    let watching = AfcSettings { f_min_percent: 100.0, f_max_percent: 100.0, ..taught() };
    for settings in [watching.clone(), AfcSettings::default()] {
        let mut asked = Asked::of(&settings);
        let feeds = asked.feeds(&[0.0, 100.0, 500.0, 0.0, 90.0]);
        assert!(feeds.iter().all(|percent| *percent == 100.0), "{feeds:?}");
    }
    let mut asked = Asked::of(&watching);
    let first = (0..100).position(|_| asked.both(200.0).1.is_some());
    assert_eq!(first, Some(51), "watched all the same");
    let mut teaching = Asked::of(&AfcSettings::default());
    assert!((0..100).all(|_| teaching.both(1e6).1.is_none()), "there is no limit yet");
}

#[test]
fn it_takes_over_a_running_cut_where_the_feed_stands() {
    let settings = taught();
    let sent = FeedSpeed { feed_mm_min: 360.0, ..PROGRAMMED };
    let running = Running { programmed: PROGRAMMED, actual: sent, sent };
    let mut asked = Asked::of(&settings);
    asked.afc = with(&settings, |setup| Afc::take_over(&settings, setup, &running));
    assert_eq!(asked.feeds(&[100.0]), [90.4]);
}

#[test]
fn the_operators_hand_switches_it_off_for_the_rest_of_the_cut() {
    let settings = AfcSettings { f_min_percent: 80.0, ..taught() };
    let mut asked = Asked::of(&settings);
    assert_eq!(asked.feeds(&[100.0, 100.0]), [80.0, 80.4]);
    asked.by_hand = 0.9;
    assert_eq!(asked.feeds(&[100.0]), [80.8], "a tenth is not more than a tenth");
    asked.by_hand = 0.89;
    assert_eq!(asked.feeds(&[100.0]), [100.0]);
    asked.by_hand = 1.0;
    assert!((0..100).all(|_| asked.both(200.0) == (100.0, None)), "nor is there an overload");
    asked.afc.restart(PROGRAMMED);
    assert_eq!(asked.feeds(&[100.0]), [80.0], "the next cut");
}
