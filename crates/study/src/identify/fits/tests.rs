use super::*;
use crate::measured::layout::DataLayout;
use crate::measured::reader::read;
use crate::run::edits::Edits;
use crate::run::job::Job;
use crate::run::presets::load;

/// The request that a file in guessed roles makes.
fn asked(kind: MeasuredFitKind, scenario: &Scenario, text: &str) -> FitRequest {
    let time = (!kind.about().timed).then(|| "none".to_owned());
    let layout = DataLayout { time, ..DataLayout::default() };
    let channels = read(text.as_bytes(), &layout).unwrap().channels;
    FitRequest {
        file: "sample.csv".to_owned(),
        roles: likely_channels(kind.about().roles, &channels),
        channels,
        values: Vec::new(),
        scenario: scenario.clone(),
        edits: Edits::none(),
    }
}

fn found(kind: MeasuredFitKind, request: FitRequest) -> Result<FitOutcome, FitFault> {
    let mut job = MeasuredFitJob::new(kind, request);
    job.to_end();
    (*job.partial().unwrap()).clone()
}

/// A scenario that every sample can be made of: tooth by tooth for the forces.
fn scenario(kind: MeasuredFitKind) -> Scenario {
    match kind {
        MeasuredFitKind::ForceFromData => load("square-12-4-42crmo4").unwrap(),
        MeasuredFitKind::DriveFromData
        | MeasuredFitKind::StructureFromData
        | MeasuredFitKind::NoiseFromData
        | MeasuredFitKind::WearFromData
        | MeasuredFitKind::MaterialFromData => load("table3-5-noise").unwrap(),
    }
}

#[test]
fn sample_data_of_every_fit_are_fitted_with_what_they_were_made_of() {
    for kind in MeasuredFitKind::ALL.iter().copied() {
        let scenario = scenario(kind);
        let text = kind.sample(&scenario, 1).unwrap();
        assert_ne!(text, kind.sample(&scenario, 2).unwrap(), "{}: no noise", kind.id());
        let request = asked(kind, &scenario, &text);
        assert_eq!(kind.lacks(&request), None, "{}: {:?}", kind.id(), request.roles);
        let outcome = found(kind, request).unwrap_or_else(|fault| panic!("{}: {fault}", kind.id()));
        let mut next = scenario.clone();
        next.set_all(&outcome.settings.clone().unwrap()).unwrap();
        assert!(!outcome.plots.is_empty() && !outcome.left.is_empty());
        for plot in &outcome.plots {
            assert!(plot.points.len() > 1 && plot.points.iter().flatten().all(|x| x.is_finite()));
        }
        let near = |name: &str, known: f64, off: f64| {
            let all: Vec<&str> = outcome.estimates.iter().map(|e| e.name.as_str()).collect();
            let value = outcome.estimates.iter().find(|estimate| estimate.name == name);
            let value = value.unwrap_or_else(|| panic!("{name} of {all:?}")).value;
            assert!((value.value / known - 1.0).abs() < off, "{name}: {value:?}, {known}");
            assert!(value.half.is_some_and(|half| half > 0.0), "{name}: {value:?}");
        };
        let file = outcome.file.unwrap();
        assert!(file.contains("sample.csv"), "{file}");
        match kind {
            MeasuredFitKind::DriveFromData => {
                near("dead time", scenario.cnc.dead_time_s, 0.02);
                assert_eq!(outcome.table.unwrap().rows.len(), 4);
            }
            MeasuredFitKind::ForceFromData => {
                near("shift of the axis", scenario.tool.runout_um, 0.2)
            }
            MeasuredFitKind::StructureFromData => {
                near("mode 1: frequency", 922.0, 1e-3);
                assert_eq!(next.machine.tip_modes.all().len(), outcome.estimates.len() / 3);
            }
            MeasuredFitKind::NoiseFromData => {
                near("white noise", scenario.noise.sensor_n, 0.1);
                assert_eq!(next.noise.level, 1.0);
            }
            MeasuredFitKind::WearFromData => near("n", scenario.wear.taylor_exponent, 0.2),
            MeasuredFitKind::MaterialFromData => {
                near("force over that of Ck45 at 200 HB", 1.0, 0.03);
            }
        }
    }
}

#[test]
fn what_is_missing_or_wrong_is_told_at_its_option() {
    let kind = MeasuredFitKind::DriveFromData;
    let scenario = scenario(kind);
    let sound = asked(kind, &scenario, &kind.sample(&scenario, 1).unwrap());
    let option = |request: &FitRequest| {
        let fault = found(kind, request.clone()).unwrap_err();
        (fault.option, fault.text)
    };
    let mut none = sound.clone();
    none.roles.clear();
    assert_eq!(option(&none).0, Some("feed"));
    let mut alone = sound.clone();
    alone.roles.retain(|(role, _)| *role == "feed");
    assert_eq!(option(&alone).0, Some("command"));
    // The step said in the place of the command gives the same drive.
    let fed = scenario.program.feed_mm_min;
    for (name, value) in [("step-at", 0.2), ("step-from", 0.6 * fed), ("step-to", fed)] {
        alone.values.push((name, FitValue::Number(value)));
    }
    let drive = |request: &FitRequest| found(kind, request.clone()).unwrap().settings.unwrap();
    assert_eq!(drive(&alone), drive(&sound));
    let mut turned = sound.clone();
    turned.values.push(("within", FitValue::Span([1.0, 0.0])));
    assert_eq!(option(&turned).0, Some("within"));
    let mut holed = sound.clone();
    holed.channels[1].values[7] = f64::NAN;
    let (at, text) = option(&holed);
    assert_eq!(at, Some("feed"));
    assert!(text.starts_with("1 samples of `feed_mm_min` are missing"), "{text}");
    let mut short = sound;
    short.values.push(("within", FitValue::Span([0.19, 0.2])));
    let (at, text) = option(&short);
    assert!(at.is_none() && text.contains("samples: allowed are 20"), "{text}");

    let kind = MeasuredFitKind::WearFromData;
    let scenario = self::scenario(kind);
    let mut wear = asked(kind, &scenario, &kind.sample(&scenario, 1).unwrap());
    wear.values.push(("limit", FitValue::Number(-1.0)));
    let fault = found(kind, wear).unwrap_err();
    assert_eq!(fault.option, Some("limit"));
    assert!(fault.text.contains("allowed is a number from 0.001 to 10"), "{fault}");
    let error = MeasuredFitKind::ForceFromData.sample(&scenario, 1).unwrap_err();
    assert!(error.contains("tooth by tooth"), "{error}");
}

#[test]
fn units_are_those_of_the_file_or_said_and_others_are_refused() {
    let kind = MeasuredFitKind::MaterialFromData;
    let scenario = scenario(kind);
    let sound = asked(kind, &scenario, &kind.sample(&scenario, 1).unwrap());
    let force = |request: &FitRequest| {
        found(kind, request.clone()).map(|outcome| outcome.plots[0].points[0][1])
    };
    let newtons = force(&sound).unwrap();
    let mut large = sound.clone();
    large.channels[0].unit = "kN".to_owned();
    large.channels[0].values.iter_mut().for_each(|x| *x /= 1000.0);
    assert!((force(&large).unwrap() / newtons - 1.0).abs() < 1e-12);
    let mut volts = sound;
    volts.channels[0].unit = "V".to_owned();
    let fault = force(&volts).unwrap_err();
    assert_eq!(fault.option, Some("force"));
    assert!(fault.text.contains("is in V; expected is a force in N or kN"), "{fault}");
    let at = volts.roles.iter().position(|(role, _)| *role == "force").unwrap();
    volts.roles[at].1.unit = Some("N".to_owned());
    assert!((force(&volts).unwrap() / newtons - 1.0).abs() < 1e-12);
}

#[test]
fn the_other_direction_s_modes_are_kept_where_that_is_asked() {
    let kind = MeasuredFitKind::StructureFromData;
    let scenario = scenario(kind);
    let text = kind.sample(&scenario, 1).unwrap();
    let first = found(kind, asked(kind, &scenario, &text)).unwrap().settings.unwrap();
    let mut with_x = scenario;
    with_x.set_all(&first).unwrap();
    let mut across = asked(kind, &with_x, &text);
    across.values.push(("direction", FitValue::Id("y".to_owned())));
    let modes = |request: &FitRequest| {
        let mut next = with_x.clone();
        next.set_all(&found(kind, request.clone()).unwrap().settings.unwrap()).unwrap();
        next.machine.tip_modes.all().len()
    };
    let alone = modes(&across);
    across.values.push(("keep-other", FitValue::On));
    assert_eq!(modes(&across), alone + with_x.machine.tip_modes.all().len());
}

#[test]
fn forces_are_fitted_to_another_cut_only_where_its_settings_allow_it() {
    let kind = MeasuredFitKind::ForceFromData;
    let scenario = scenario(kind);
    let text = kind.sample(&scenario, 1).unwrap();
    let mut fast = asked(kind, &scenario, &text);
    fast.values.push(("speed", FitValue::Number(1e9)));
    assert_eq!(found(kind, fast).unwrap_err().option, Some("speed"));
    let mut both = asked(kind, &scenario, &text);
    let x = both.roles[0].1.clone();
    both.roles.push(("across", x));
    assert_eq!(kind.lacks(&both).unwrap().option, Some("across"));
    let mut map = asked(kind, &scenario, &text);
    map.scenario = load("table3-5").unwrap();
    let fault = found(kind, map).unwrap_err();
    assert!(fault.text.contains("tooth by tooth"), "{fault}");
}
