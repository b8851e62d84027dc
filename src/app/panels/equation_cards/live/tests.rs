//! Cards against runs, and against a calculation of what they write.

use super::super::BLOCKS;
use super::repeat::repeated;
use super::*;
use crate::base::settings::Value;
use crate::blocks::control::ControllerKind;
use crate::blocks::control::law::Held;
use crate::blocks::cutting::process::ForceModel;
use crate::models::formula_model::FormulaRole;
use crate::models::genetic::{
    Calibration, FeedOfForce, ForceOfCut, ForceOfRa, ModelSet, RaOfForce, SpeedOfForce,
};
use crate::run::edits::Edits;
use crate::run::one_run::Run;
use crate::run::presets;
use crate::run::signals::flag;

/// The number before the unit at the end of an equation's values.
fn result(live: &Live) -> f64 {
    let after = live.values.rsplit(" = ").next().unwrap_or_default();
    let text = after.split(' ').next().unwrap_or_default();
    text.parse().unwrap_or_else(|_| panic!("no number ends {:?}", live.values))
}

fn near(live: &Live, value: f64) {
    let shown = result(live);
    assert!((shown - value).abs() <= 2e-3 * value.abs() + 5.1e-4, "{live:?}: {value}");
}

/// The result is what the written calculation gives, to the accuracy of its rounded numbers.
fn follows(live: &Live) {
    let middle = live.values.split(" = ").nth(1).unwrap_or_default();
    let (repeated, shown) = (repeated(middle), result(live));
    // What the last digit of a force or speed does to a difference of large terms.
    let rounding = match live.values.rsplit(' ').next() {
        Some("mm/min" | "1/min") => 4.0,
        Some("µm") => 0.003,
        _ => 0.1,
    };
    let close = (repeated - shown).abs() <= 0.002 * shown.abs() + rounding;
    assert!(close, "{repeated}: {live:?}");
}

fn at<'a>(row: &'a Row, scenario: &'a Scenario) -> Moment<'a> {
    let delayed = [row.feed_command_mm_min, row.spindle_command_rpm];
    Moment { row, scenario, delayed }
}

fn models() -> impl Iterator<Item = (ModelSet, Calibration)> {
    let sets = ModelSet::ALL.iter();
    // Own formulas have a test of their own.
    let of = Calibration::PUBLISHED;
    sets.flat_map(move |set| of.map(|calibration| (*set, calibration)))
}

#[test]
fn cards_show_what_the_run_recorded_in_every_set_and_calibration() {
    for (set, calibration) in models() {
        let name = if set == ModelSet::Sdnrp2007 { "table3-5" } else { "strategy-table1-5" };
        let mut scenario = presets::load(name).expect("shipped");
        scenario.set("plant.model_set", Value::Text(set.id().to_owned())).expect("a set");
        scenario
            .change(|s| {
                s.belief.calibration = calibration;
                s.plant.calibration = calibration;
                s.plant.wear_factor = 1.1;
            })
            .unwrap();
        let run = Run::complete(&scenario, &Edits::none());
        let rows = run.recording().rows();
        // At the start, out of most ranges, and at rest.
        for row in [rows[1], rows[200], *rows.last().expect("a row")] {
            let moment = at(&row, &scenario);
            let [reference, control, overrides, drive, cutting, surface, dynamic] = [
                Block::Reference,
                Block::Controller,
                Block::Override,
                Block::FeedDrive,
                Block::Cutting,
                Block::Surface,
                Block::SurfaceDynamic,
            ]
            .map(|block| live(block, &moment));
            near(&reference[0], row.force_ref_n);
            near(&control[0], row.force_setpoint_n);
            near(&overrides[0], row.feed_command_mm_min);
            near(&overrides[1], row.spindle_command_rpm);
            near(&drive[0], row.feed_mm_min);
            near(&cutting[1], row.force_n);
            near(&surface[0], row.ra_um);
            near(&dynamic[0], row.ra_dyn_um);
            for line in [reference, control, overrides, cutting, surface, dynamic].concat() {
                follows(&line);
            }
            for (block, line) in [
                (Block::Reference, 0),
                (Block::Controller, 1),
                (Block::Controller, 2),
                (Block::Cutting, 0),
                (Block::Surface, 0),
                (Block::SurfaceDynamic, 0),
            ] {
                let lamp = block.info().lamps[usize::from(line == 2)];
                let (valid, lit) = (live(block, &moment)[line].valid, row.has(lamp.bits));
                assert_eq!(valid, !lit, "{block:?} {line} {set:?} {calibration:?}");
            }
        }
    }
}

/// Own formulas in all five places, in place and far out of their ranges.
#[test]
fn cards_of_own_formulas_show_what_the_models_compute() {
    let mut scenario = presets::load("table3-5").expect("shipped");
    let own = [
        ("force_of_ra", ForceOfRa::EXAMPLE),
        ("feed", FeedOfForce::EXAMPLE),
        ("speed", SpeedOfForce::EXAMPLE),
        ("force", ForceOfCut::EXAMPLE),
        ("ra", RaOfForce::EXAMPLE),
    ];
    let calibrations = ["plant.calibration", "belief.calibration"];
    let mut changes: Vec<(String, Value)> =
        calibrations.map(|path| (path.to_owned(), Value::Text("formula".to_owned()))).to_vec();
    changes
        .extend(own.map(|(role, text)| (format!("formula.{role}"), Value::Text(text.to_owned()))));
    scenario.set_all(&changes).expect("examples");
    let (plant, belief) = (scenario.of_plant(), scenario.believed());
    for (force_n, ra_um, feed_mm_min, spindle_rpm) in
        [(180.0, 0.81, 330.0, 1600.0), (90.0, 0.2, 100.0, 700.0), (260.0, 2.5, 900.0, 3100.0)]
    {
        let row = Row {
            ra_target_um: ra_um,
            force_ref_n: force_n,
            force_measured_n: force_n,
            force_n,
            force_dyn_n: force_n,
            feed_mm_min,
            spindle_rpm,
            axial_depth_mm: 2.0,
            radial_depth_mm: 3.0,
            ..Row::default()
        };
        let moment = at(&row, &scenario);
        let [reference, control, cutting, surface] =
            [Block::Reference, Block::Controller, Block::Cutting, Block::Surface]
                .map(|block| live(block, &moment));
        for line in [&reference[..], &control, &cutting[..1], &surface].concat() {
            follows(&line);
        }
        near(&reference[0], belief.force_from_ra(ra_um).value);
        near(&cutting[0], plant.force(feed_mm_min, spindle_rpm).value);
        near(&surface[0], plant.ra_from_force(force_n).value);
        assert_eq!(cutting[0].valid, plant.force(feed_mm_min, spindle_rpm).valid);
        assert!(surface[0].formula.contains("300 - F"), "{surface:?}");
        assert!(control.iter().any(|line| line.formula.contains("exp(")), "{control:?}");
    }
}

#[test]
fn models_explain_themselves_over_every_force() {
    for (set, calibration) in models() {
        let mut scenario = Scenario::default();
        scenario
            .change(|s| {
                (s.plant.model_set, s.belief.model_set) = (set, set);
                (s.plant.calibration, s.belief.calibration) = (calibration, calibration);
                s.controller.sdnrp.kp = 0.0;
            })
            .unwrap();
        for force in [90.0, 141.8, 160.0, 177.5, 196.0, 203.0, 230.0, 240.0, 262.0, 280.0] {
            let row = Row {
                ra_target_um: force * force * force / 1e7,
                force_ref_n: force,
                force_n: force,
                force_dyn_n: force,
                ..Row::default()
            };
            let moment = at(&row, &scenario);
            for block in [Block::Reference, Block::Controller, Block::Surface] {
                live(block, &moment).iter().for_each(follows);
            }
        }
    }
}

#[test]
fn a_neural_plant_shows_its_inputs_components_and_what_it_was_not_trained_on() {
    let text = |text: &str| Value::Text(text.to_owned());
    for (force_model, material, offset_n, left) in [
        (ForceModel::Neural, "ck45", 0.0, None),
        (ForceModel::NeuralLiteral, "ck45", -30.0, None),
        (ForceModel::Neural, "s235jr", 10.0, Some("S235JR")),
    ] {
        let mut scenario = presets::load("strategy-table1-5").expect("shipped");
        scenario.set("plant.material", text(material)).expect("a material");
        scenario
            .change(|s| {
                s.plant.force_model = force_model;
                s.plant.wear_factor = 1.1;
                s.plant.force_offset_n = offset_n;
            })
            .unwrap();
        let run = Run::complete(&scenario, &Edits::none());
        let row = run.recording().rows().last().expect("a row");
        let lines = live(Block::Cutting, &at(row, &scenario));
        let [inputs, components, peak, force, origin] = &lines[..] else { panic!("{lines:?}") };
        assert!(inputs.formula.contains("8-15-3, arc tangent"), "{lines:?}");
        assert!(inputs.values.contains("R_D 3 mm, A_D 2 mm"), "{lines:?}");
        assert!(components.values.starts_with("F_x = "), "{lines:?}");
        follows(peak);
        follows(force);
        near(force, row.force_n);
        assert!(origin.formula.contains("3500 measurements were never published"), "{lines:?}");
        assert_eq!(components.valid, !row.has(flag::K4_OUTSIDE), "{lines:?}");
        let told = components.range.contains("trained on");
        assert_eq!(told, !components.valid, "{lines:?}");
        assert!(left.is_none_or(|left| components.range.contains(left)), "{lines:?}");
    }
    let mut scenario = presets::load("strategy-table1-5").expect("shipped");
    scenario.change(|s| s.plant.force_model = ForceModel::Neural).unwrap();
    let air = Row { feed_mm_min: 300.0, spindle_rpm: 2000.0, ..Row::default() };
    let lines = live(Block::Cutting, &at(&air, &scenario));
    assert!(lines[3].values.ends_with("= 0 N"), "{lines:?}");
}

#[test]
fn overrides_show_whole_percents_and_the_rate() {
    let mut scenario = presets::load("strategy-table1-1").expect("shipped");
    scenario
        .change(|s| {
            s.cnc.override_quantised = true;
            s.cnc.override_rate_limited = true;
            s.cnc.override_rate_percent_s = 20.0;
        })
        .unwrap();
    let run = Run::complete(&scenario, &Edits::none());
    let rows = run.recording().rows();
    let early = live(Block::Override, &at(&rows[60], &scenario));
    assert!(rows[60].has(flag::FEED_RATE_LIMITED) && !early[2].valid, "{early:?}");
    assert!(early[2].values.contains("0.02 s = 0.4 %: DNCFRO is on its way"), "{early:?}");
    let last = rows.last().expect("a row");
    let late = live(Block::Override, &at(last, &scenario));
    assert!(late[2].valid && late[3].valid, "{late:?}");
    assert!(late[0].formula.contains("round(ramp)"), "{late:?}");
    for (line, percent) in
        [(&late[0], last.feed_override_percent), (&late[1], last.spindle_override_percent)]
    {
        assert!(line.values.contains(&format!("= {percent:.0} % · ")), "{late:?}");
    }
    // An adaptive controller stays where the force falls with the feed.
    assert!(late[0].range.starts_with("f 69.7 to "), "{late:?}");
}

#[test]
fn every_controller_explains_itself_with_every_model_set_and_force_model() {
    for set in ModelSet::ALL {
        for force in ForceModel::ALL {
            let mut laws = Vec::new();
            for kind in ControllerKind::ALL {
                let mut scenario = presets::load("depth-step").expect("shipped");
                scenario
                    .change(|s| {
                        s.run.steps_per_control = 576;
                        s.controller.kind = *kind;
                        s.plant.force_model = *force;
                        (s.plant.model_set, s.belief.model_set) = (*set, *set);
                    })
                    .unwrap();
                let row = Row { gain_estimate: 1.0, force_ref_n: 180.0, ..Row::default() };
                for info in BLOCKS {
                    let lines = live(info.block, &at(&row, &scenario));
                    assert!(!lines.is_empty(), "{}", info.title(&scenario));
                    assert!(lines.iter().all(|line| !line.values.contains("NaN")), "{lines:?}");
                }
                // Its own law first, then models 2 and 3 where it computes with them.
                let printed = Block::Controller.printed(&scenario);
                let own = scenario.controller.printed(*set);
                assert_eq!(printed[..own.len()], own, "{kind:?}");
                let models = if kind.held() == Held::Roughness { 2 } else { 0 };
                assert_eq!(printed.len() - own.len(), models, "{kind:?}");
                assert!(own.iter().all(|law| !law.source.is_empty()), "{kind:?}");
                laws.extend(own.iter().map(|law| law.formula));
            }
            let all = laws.len();
            laws.sort_unstable();
            laws.dedup();
            assert_eq!(laws.len(), all, "a law is shown for two controllers: {laws:?}");
        }
    }
}
