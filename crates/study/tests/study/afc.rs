//! Adaptive feed control over whole runs: what teach-in finds, what watching leaves alone, what control holds,
//! what an overload does, and the log.

use steadycut_core::base::settings::Value;
use steadycut_core::blocks::control::{ControllerKind, OverloadReaction};
use steadycut_core::blocks::cutting::tool_path::ToolPath;
use steadycut_core::run::edits::Edits;
use steadycut_core::run::job::Job;
use steadycut_core::run::one_run::{End, Run};
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::Scenario;
use steadycut_core::run::signals::{Row, flag};
use steadycut_core::run::{constant_feed_twin, scenario_file};
use steadycut_study::afc::{AfcCut, Recorded, TeachIn, Teaching, log, sheet, sum, taught};

fn references(scenario: &Scenario) -> Vec<f64> {
    let mut teach_in = TeachIn::new(scenario);
    teach_in.to_end();
    match teach_in.partial() {
        Teaching::Taught { references_n, .. } => references_n,
        other @ (Teaching::UnderWay | Teaching::NotTaught(_)) => panic!("{other:?}"),
    }
}

fn complete(scenario: &Scenario) -> Run {
    Run::complete(scenario, &Edits::none())
}

/// The shipped scenario as it was taught in: with a sharp tool.
fn sharp() -> Scenario {
    load("afc").unwrap().with(|s| s.plant.wear_factor = 1.0).unwrap()
}

fn log_of(run: &Run) -> Vec<AfcCut> {
    let constant = complete(&constant_feed_twin::scenario(run.scenario()));
    log(run.scenario(), Recorded::all(run), Recorded::all(&constant))
}

#[test]
fn the_references_are_the_largest_forces_that_the_run_at_constant_feed_has_measured() {
    for preset in ["afc", "experiment-1", "table3-5-noise"] {
        let scenario = load(preset).unwrap();
        let run = complete(&constant_feed_twin::scenario(&scenario));
        let begins_mm = ToolPath::begins_of(&scenario.workpiece);
        let mut peaks_n = vec![0.0; begins_mm.len().max(1)];
        // Each period holds what was read at its beginning, where the row before it stands.
        let (rows, stride) = (run.recording().rows(), run.recording().control_stride());
        let mut first = 0;
        while let Some(row) = rows.get(first + 1) {
            let place_mm = rows[first].position_mm;
            let cut = begins_mm.iter().rposition(|begin_mm| *begin_mm <= place_mm).unwrap_or(0);
            peaks_n[cut] = f64::max(peaks_n[cut], row.force_measured_n);
            first += stride;
        }
        assert_eq!(references(&scenario), peaks_n, "{preset}");
        assert!(peaks_n.iter().all(|peak_n| *peak_n > 50.0), "{preset}: {peaks_n:?}");
    }
}

#[test]
fn watching_is_constant_feed_to_the_bit() {
    for preset in ["afc", "experiment-2-neural", "table3-5-noise"] {
        let scenario = load(preset).unwrap();
        let watched = taught(&scenario, &references(&scenario)).unwrap();
        let watched = watched
            .with(|s| {
                (s.controller.afc.f_min_percent, s.controller.afc.f_max_percent) = (100.0, 100.0);
            })
            .unwrap();
        let (watched, constant) =
            (complete(&watched), complete(&constant_feed_twin::scenario(&scenario)));
        let bits = |row: &Row| {
            // The setpoint shows the reference, and the flags who is at a limit of what.
            let row = Row { force_setpoint_n: 0.0, state_flags: 0.0, ..*row };
            row.values().map(f64::to_bits)
        };
        let [one, other] = [&watched, &constant].map(|run| run.recording().rows());
        assert_eq!(one.len(), other.len(), "{preset}");
        for (one, other) in one.iter().zip(other) {
            assert_eq!(bits(one), bits(other), "{preset} at {} s", one.time_s);
        }
    }
}

#[test]
fn without_references_a_run_is_its_own_teach_in() {
    let untaught = load("afc").unwrap().with(|s| s.controller.afc.references_n.clear()).unwrap();
    let run = complete(&untaught);
    assert!(run.recording().rows().iter().all(|row| row.feed_override_percent == 100.0));
    let peaks: Vec<f64> = log_of(&run).iter().map(|cut| cut.peak_n.unwrap()).collect();
    assert_eq!(peaks, references(&untaught));
}

#[test]
fn the_shipped_references_are_those_of_a_sharp_tool() {
    let found = references(&sharp()).into_iter().map(|force_n| (10.0 * force_n).round() / 10.0);
    assert_eq!(load("afc").unwrap().controller.afc.references_n, found.collect::<Vec<f64>>());
}

#[test]
fn a_worn_tool_and_a_deeper_part_are_held_nearer_to_the_reference_than_at_constant_feed() {
    let sharp = sharp();
    let references_n = references(&sharp);
    let worn = load("afc").unwrap();
    let mut deeper = sharp.clone();
    deeper
        .change(|s| {
            s.workpiece.cuts.iter_mut().flatten().for_each(|section| section[1] *= 1.2);
        })
        .unwrap();
    for (case, scenario) in [("worn", worn), ("deeper", deeper)] {
        let scenario = taught(&scenario, &references_n).unwrap();
        let runs = [complete(&scenario), complete(&constant_feed_twin::scenario(&scenario))];
        let above = runs.each_ref().map(|run| {
            assert_eq!(run.end(), Some(&End::PathDone), "{case}");
            let rows = run.recording().rows().iter().filter(|row| !row.has(flag::AIR));
            let above = rows.filter_map(|row| {
                let cut = ToolPath::cut_of(&scenario.workpiece, row.position_mm);
                let above = row.force_n / references_n[cut] - 1.0;
                (above > 0.0).then_some(above)
            });
            let above: Vec<f64> = above.collect();
            above.iter().sum::<f64>() / above.len() as f64
        });
        let [controlled, constant] = above;
        assert!(constant > 0.1, "{case}: {constant}");
        assert!(controlled < 0.75 * constant, "{case}: {controlled} against {constant}");
    }
}

/// A cut of twice the force that was taught in, FMIN at 80 %: an overload.
fn overloaded(reaction: OverloadReaction) -> Run {
    let mut scenario = sharp();
    let references_n: Vec<f64> =
        references(&scenario).iter().map(|force_n| 0.5 * force_n).collect();
    scenario
        .change(|s| {
            s.controller.afc.references_n = references_n;
            s.controller.afc.f_min_percent = 80.0;
            s.controller.afc.reaction = reaction;
        })
        .unwrap();
    complete(&scenario)
}

#[test]
fn an_overload_is_said_stops_the_feed_or_lifts_the_tool() {
    let said = overloaded(OverloadReaction::Message);
    assert_eq!(said.end(), Some(&End::PathDone));
    let first = said.recording().rows().iter().find(|row| row.has(flag::OVER_LIMIT)).unwrap();
    let cuts = log_of(&said);
    assert!(cuts[0].overload, "{cuts:?}");
    let mut times_s = Vec::new();
    for (reaction, lifted) in
        [(OverloadReaction::Stop, false), (OverloadReaction::RetractStop, true)]
    {
        let run = overloaded(reaction);
        let Some(End::Overload(stop)) = run.end() else { panic!("{:?}", run.end()) };
        assert_eq!(stop.retracted, lifted);
        assert!((stop.time_s - first.time_s).abs() < 0.002, "{stop:?} {}", first.time_s);
        let limit_n = 1.3 * run.scenario().controller.afc.references_n[0];
        assert_eq!(stop.limit_n, limit_n);
        assert!(stop.force_n > limit_n, "{stop:?}");
        assert_eq!(run.end().unwrap().to_string().contains("lifted off"), lifted);
        times_s.push(run.recording().rows().last().unwrap().time_s);
        assert!(log_of(&run)[0].overload, "the log has it though the run ends there");
    }
    // A stop takes the drive's time; a lifted tool is out at once.
    assert!(times_s[1] < times_s[0] && times_s[1] - first.time_s < 0.002, "{times_s:?}");
}

#[test]
fn the_log_adds_up_and_is_a_table() {
    let run = complete(&load("afc").unwrap());
    let constant = complete(&constant_feed_twin::scenario(run.scenario()));
    let cuts = log_of(&run);
    assert_eq!(cuts.len(), 3);
    let end_s = |run: &Run| run.recording().rows().last().unwrap().time_s;
    let [teach_in_s, control_s, percent] = sum(&cuts).unwrap();
    assert!((control_s - end_s(&run)).abs() < 1e-9, "{control_s}");
    assert!((teach_in_s - end_s(&constant)).abs() < 1e-9, "{teach_in_s}");
    assert!((percent - 100.0 * (control_s / teach_in_s - 1.0)).abs() < 1e-9);
    for cut in &cuts {
        let least = cut.least_factor_percent.unwrap();
        assert!((50.0..100.0).contains(&least), "{cut:?}");
        assert!(cut.peak_n > cut.reference_n, "the tool is worn: {cut:?}");
    }
    let table = sheet(&cuts).csv();
    assert_eq!(table.lines().count(), 4, "{table}");
    assert!(table.starts_with("Cut,Reference [N],Teach-in [s],Control [s],Difference [%],"));
    // In the middle of the second cut: the first is done, the third not begun.
    let begins_mm = ToolPath::begins_of(&run.scenario().workpiece);
    let rows = run.recording().rows();
    let middle = rows.partition_point(|row| row.position_mm < 0.5 * (begins_mm[1] + begins_mm[2]));
    let control = Recorded { recording: run.recording(), rows: middle };
    let so_far = log(run.scenario(), control, Recorded::all(&constant));
    assert_eq!(so_far[0], cuts[0]);
    assert!(so_far[1].control_s.is_none() && so_far[1].peak_n.is_some(), "{so_far:?}");
    assert_eq!((so_far[2].peak_n, so_far[2].difference_percent), (None, None));
    assert_eq!(sum(&so_far), None);
}

#[test]
fn what_cannot_be_taught_in_says_why() {
    let not = |scenario: &Scenario| {
        let mut teach_in = TeachIn::new(scenario);
        assert_eq!(teach_in.partial(), Teaching::UnderWay);
        teach_in.to_end();
        let Teaching::NotTaught(why) = teach_in.partial() else { panic!("{teach_in:?}") };
        why
    };
    let short = not(&sharp().with(|s| s.run.duration_s = 15.0).unwrap());
    assert!(short.contains("cut 3") && short.contains("run.duration_s"), "{short}");
    let stopped = sharp().with(|s| (s.cnc.force_stop, s.cnc.force_stop_n) = (true, 60.0)).unwrap();
    assert!(not(&stopped).contains("allowed 60 N"), "{}", not(&stopped));
    let air = sharp().with(|s| s.workpiece.cuts[1] = vec![[10.0, 0.0, 0.0]]).unwrap();
    let air = not(&air);
    assert!(air.contains("cut 2") && air.contains("controller.afc.references_n"), "{air}");
}

#[test]
fn fmin_below_thirty_percent_is_refused_with_the_range() {
    for path in ["f_min_percent", "air_percent", "entry_percent"] {
        let path = format!("controller.afc.{path}");
        let error = Scenario::default().set(&path, Value::Float(29.0)).unwrap_err().to_string();
        assert!(error.contains(&path) && error.contains("29") && error.contains("30"), "{error}");
    }
}

#[test]
fn a_taught_scenario_is_one_under_afc_and_reads_back() {
    let scenario = taught(&load("table3-5").unwrap(), &[180.5]).unwrap();
    assert_eq!(scenario.controller.kind, ControllerKind::Afc);
    let text = scenario_file::write(&scenario, &Edits::none());
    assert_eq!(scenario_file::parse(&text).unwrap().0, scenario);
    assert!(taught(&scenario, &[0.0]).is_err());
}

#[test]
fn the_operators_override_switches_it_off_until_the_next_cut() {
    let mut scenario = load("afc").unwrap();
    // In the second cut, to 80 % over 5 mm.
    let turned = Value::from(vec![[65.0, 5.0, 80.0]]);
    scenario.set("disturbances.operator_overrides", turned).unwrap();
    let run = complete(&scenario);
    let begins_mm = ToolPath::begins_of(&scenario.workpiece);
    for row in run.recording().rows() {
        let off = row.position_mm > 65.2 && row.position_mm < begins_mm[2] - 0.2;
        let on = row.position_mm < 64.9 || row.position_mm > begins_mm[2] + 0.2;
        let is = row.has(flag::CONTROL_OFF);
        // Between the two it may be either: the control looks once a period.
        assert!(if is { !on } else { !off }, "{row:?}");
        assert!(!is || row.feed_override_percent == 100.0, "{row:?}");
    }
    // A tenth is not more than a tenth.
    let turned = Value::from(vec![[65.0, 5.0, 90.0]]);
    scenario.set("disturbances.operator_overrides", turned).unwrap();
    let run = complete(&scenario);
    assert!(!run.recording().rows().iter().any(|row| row.has(flag::CONTROL_OFF)));
}
