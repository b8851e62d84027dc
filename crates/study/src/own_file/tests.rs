use super::*;
use crate::base::math;
use crate::blocks::cutting::material::Material;
use crate::identify::drive::{DriveRecording, DriveStructure, drive_file, identify_drive};
use crate::models::feed_drive::{DriveState, ExactDrive, FeedDriveKind};
use crate::models::transfer::TransferPoles;
use crate::run::scenario::Scenario;

fn number(file: &OwnFile, path: &str) -> f64 {
    let found = file.changes.iter().find(|(known, _)| known == path);
    found.and_then(|(_, value)| value.number()).unwrap_or_else(|| panic!("{path}"))
}

#[test]
fn every_template_says_what_it_is_and_a_scenario_takes_it() {
    for kind in OwnFileKind::ALL {
        let text = kind.template();
        assert_eq!(OwnFileKind::recognised(text), Some(*kind));
        let file = OwnFile::read(text).unwrap();
        assert!(file.title.len() > 3 && file.source.len() > 3, "{file:?}");
        let mut scenario = Scenario::default();
        scenario.set_all(&file.changes).unwrap();
        for (path, value) in &file.changes {
            let found = scenario.get(path).unwrap();
            // A formula is written anew by the setting.
            assert!(found == *value || path.starts_with("formula."), "{path}: {found} {value}");
        }
        assert_ne!(scenario, Scenario::default(), "{kind:?}");
    }
    assert_eq!(
        OwnFileKind::recognised("version = 1\nname = \"a\"\n[feed_drive]\nkind = \"x\"\n"),
        None
    );
    let none = OwnFile::read("a = 1").unwrap_err().to_string();
    assert!(none.contains("diameter_mm") && none.contains("kc11_n_mm2"), "{none}");
}

#[test]
fn the_shipped_cutters_come_as_their_settings() {
    use crate::models::tool::ShippedTool;
    for shipped in ShippedTool::ALL {
        let file = OwnFile::read(shipped.text()).unwrap();
        let mut scenario = Scenario::default();
        scenario.set_all(&file.changes).unwrap();
        assert_eq!(scenario.tool.shipped_alike(), Some(*shipped));
    }
}

#[test]
fn a_shipped_material_by_its_constants_cuts_as_the_shipped_one() {
    for (material, hardness) in
        [(Material::Crmo42, 300.0), (Material::Al7075, 120.0), (Material::Ck45, 200.0)]
    {
        let (kc11, mc, at) = material.constants();
        let text = format!(
            "version = 1\ntitle = \"a\"\nsource = \"b\"\nkc11_n_mm2 = {kc11}\nmc = {mc}\nhardness_hb = {at}\n"
        );
        let file = OwnFile::parse(OwnFileKind::Material, &text).unwrap();
        assert_eq!(number(&file, "plant.hardness_hb"), at);
        let mut scenario = Scenario::default();
        scenario.set_all(&file.changes).unwrap();
        let found = scenario.formula.material_factor(hardness).unwrap();
        let known = material.force_factor(hardness);
        assert!(found.valid && (found.value / known - 1.0).abs() < 1e-12, "{material:?}");
        // Tooth by tooth factor and law together are Kienzle's own.
        let law = scenario.formula.specific_force.get().unwrap();
        let factor = scenario.formula.material_factor(at).unwrap().value;
        for h in [0.02, 0.1, 0.4] {
            let found = factor * law.at(&[h]).value;
            assert!((found / (kc11 * math::pow(h, -mc)) - 1.0).abs() < 1e-12, "{material:?} {h}");
        }
    }
}

#[test]
fn a_denominator_gives_the_poles_of_its_factors() {
    let drive = |denominator: &str| {
        let text = format!(
            "version = 1\nsource = \"b\"\n[feed_drive]\ngain = 1\ndenominator = {denominator}\n"
        );
        MachineFile::parse(&text).map(|file| file.feed_drive.unwrap().poles)
    };
    // 2007 eq. 2 as a product: (s + 14) (s^2 + 155 s + 35500).
    let poles = drive("[497000.0, 37670.0, 169.0, 1.0]").unwrap();
    let mut found = poles.all().to_vec();
    found.sort_by(|a, b| b[0].total_cmp(&a[0]));
    let known = [[-14.0, 0.0], [-77.5, (35_500.0_f64 - 77.5 * 77.5).sqrt()]];
    for (found, known) in found.iter().zip(known) {
        assert!((found[0] - known[0]).abs() + (found[1] - known[1]).abs() < 1e-8, "{poles:?}");
    }
    assert_eq!(poles.order(), 3);
    // Scaled, and a double pole.
    assert_eq!(drive("[5.0, 5.0]").unwrap().all(), [[-1.0, 0.0]]);
    let double = drive("[976.5625, 62.5, 1.0]").unwrap();
    assert_eq!(double.order(), 2);
    assert!(
        double.all().iter().all(|[re, im]| (re + 31.25).abs() < 1e-4 && *im < 1e-4),
        "{double:?}"
    );
    // s^3 + s^2 + s + 30 has all signs alike and is not stable all the same.
    let unstable = drive("[30.0, 1.0, 1.0, 1.0]").unwrap_err().to_string();
    assert!(unstable.contains("line 5") && unstable.contains("stable"), "{unstable}");
}

#[test]
fn what_identify_drive_writes_is_read_back() {
    let period_s = 1e-3;
    for (kind, structure) in [
        (FeedDriveKind::Eq3Of2007, DriveStructure::First),
        (FeedDriveKind::Eq2Of2007, DriveStructure::Third),
    ] {
        let drive = ExactDrive::new(kind, period_s);
        let mut state = DriveState::settled(200.0);
        let mut recording = DriveRecording { period_s, command: vec![200.0], feed: vec![200.0] };
        for k in 1..600 {
            let command = |k: i32| if k > 100 { 400.0 } else { 200.0 };
            drive.advance(&mut state, command(k - 40));
            recording.command.push(command(k));
            recording.feed.push(state.feed_mm_min());
        }
        let fits = identify_drive(&recording).unwrap();
        let fit = fits.iter().find(|fit| fit.structure == structure).unwrap();
        let file = OwnFile::read(&drive_file(fit, "a recording", 600)).unwrap();
        assert_eq!((file.kind, file.title.as_str()), (OwnFileKind::Machine, "a recording"));
        assert_eq!(number(&file, "feed_drive.gain"), fit.gain.value);
        assert_eq!(number(&file, "cnc.dead_time_s"), fit.dead_time_s.value);
        let mut scenario = Scenario::default();
        scenario.set_all(&file.changes).unwrap();
        let upper = fit.poles.iter().copied().filter(|[_, im]| *im >= 0.0).collect();
        assert_eq!(scenario.feed_drive.poles, TransferPoles::new(upper).unwrap());
    }
}

#[test]
fn faults_name_line_entry_value_and_range() {
    let message = |kind: OwnFileKind, from: &str, to: &str| {
        let text = kind.template().replacen(from, to, 1);
        assert_ne!(text, kind.template(), "{from}");
        OwnFile::parse(kind, &text).unwrap_err().to_string()
    };
    use OwnFileKind::{Machine, Material, Tool};
    for (kind, from, to, wanted) in [
        (
            Tool,
            "diameter_mm = 10.0",
            "diameter_mm = 99",
            ["line 8", "`diameter_mm`", "99", "2 to 50"],
        ),
        (Tool, "shape = \"square\"", "shape = \"cone\"", ["line 7", "`shape`", "cone", "ball"]),
        (Material, "mc = 0.18", "mc = 0.9", ["line 8", "`mc`", "0.9", "0 to 0.6"]),
        (
            Material,
            "kc11_n_mm2 = 2130.0",
            "kc11_n_mm2 = \"hard\"",
            ["line 7", "kc11_n_mm2", "hard", "number"],
        ),
        (Material, "version = 1", "version = 7", ["line 4", "`version`", "7", "is 1"]),
        (
            Machine,
            "dead_time_s = 0.05",
            "dead_time_s = 5",
            ["line 9", "`dead_time_s`", "5", "0 to 0.5"],
        ),
        (
            Machine,
            "feed_max_mm_min = 3000.0",
            "feed_max_mm_min = 5",
            ["line 22", "`feed_max_mm_min`", "5", "10 to 12500"],
        ),
        (
            Machine,
            "stop_force_n = 2500.0",
            "stop_force_n = 30000",
            ["line 28", "`stop_force_n`", "30000", "50 to 20000"],
        ),
        (
            Machine,
            "speed_min_rpm = 50.0",
            "speed_min_rpm = 7000.0",
            ["line 23", "`speed_min_rpm`", "7000", "6000 1/min"],
        ),
        (
            Machine,
            "# speed_rate_rpm_s = 1000.0",
            "speed_rate_rpm_s = 1000.0",
            ["line 29", "[spindle_drive]", "lag", "rate limit"],
        ),
        (
            Machine,
            "stop_force_n",
            "power_max_kw",
            ["limits", "power_max_kw", "unknown", "stop_force_n"],
        ),
        (Machine, "gain = 1.0", "gain = -1.0", ["line 12", "`gain`", "-1", "0.1 to 10"]),
        (Machine, "[-22.0, 0.0]", "[22.0, 0.0]", ["line 13", "pole 1", "22", "stable"]),
        (Machine, ", [-60.0, -140.0]", "", ["line 13", "-60", "140", "conjugate"]),
        (
            Machine,
            "[30.0, 11.0, 1.0]",
            "[30.0, -11.0, 1.0]",
            ["line 17", "`denominator`", "-11", "above 0"],
        ),
        (
            Machine,
            "denominator = [",
            "numerator = [",
            ["spindle_drive", "numerator", "unknown", "denominator"],
        ),
    ] {
        let text = message(kind, from, to);
        assert!(wanted.iter().all(|part| text.contains(part)), "{to}: {text}");
    }
    let nine = format!("version = 1\nsource = \"b\"\ngain = 1\npoles = {:?}\n", [[-5.0, 0.0]; 9]);
    let order = OwnFile::read(&nine).unwrap_err().to_string();
    assert!(order.contains("order") && order.contains("at most 8"), "{order}");
}

#[test]
fn a_drive_by_its_pole_cuts_as_the_papers_drive() {
    use crate::run::edits::Edits;
    use crate::run::one_run::Run;
    let cut = |text: &str| {
        let mut scenario = Scenario::default();
        scenario.set("run.duration_s", Value::Float(4.0)).unwrap();
        if !text.is_empty() {
            scenario.set_all(&OwnFile::read(text).unwrap().changes).unwrap();
        }
        let run = Run::complete(&scenario, &Edits::none());
        let feeds = run.recording().rows().iter().map(|row| row.feed_mm_min);
        feeds.collect::<Vec<f64>>()
    };
    // The default: 14 / (s + 14).
    let papers = cut("");
    let own = cut("version = 1\nsource = \"b\"\ngain = 1.0\npoles = [[-14.0, 0.0]]\n");
    assert_eq!(papers.len(), own.len());
    for (papers, own) in papers.iter().zip(&own) {
        assert!((papers - own).abs() < 1e-6, "{papers} {own}");
    }
    let slower = cut("version = 1\nsource = \"b\"\ngain = 1.0\npoles = [[-4.0, 0.0]]\n");
    assert!(papers.iter().zip(&slower).any(|(papers, own)| (papers - own).abs() > 1.0));
}

/// A machine file of limits alone.
fn limited(entries: &str) -> OwnFile {
    let text = format!("version = 1\ntitle = \"a\"\nsource = \"b\"\n[limits]\n{entries}\n");
    OwnFile::read(&text).unwrap()
}

#[test]
fn limits_of_a_machine_bind_in_the_run_and_in_its_twin() {
    use crate::blocks::control::ControllerKind;
    use crate::run::constant_feed_twin;
    use crate::run::edits::Edits;
    use crate::run::end::EndId;
    use crate::run::one_run::Run;
    use crate::run::scenario::parse_value;
    use crate::run::signals::{Row, flag};
    let base = Scenario::default()
        .with(|s| {
            s.run.duration_s = 2.0;
            s.controller.kind = ControllerKind::Proportional;
            // Far more force than the programmed feed makes: the controller asks for all the feed there is.
            s.target.ra_um = 4.0;
        })
        .unwrap();
    let on = |entries: &str| {
        let mut scenario = base.clone();
        scenario.set_all(&limited(entries).changes).unwrap();
        scenario
    };
    let rows =
        |scenario: &Scenario| Run::complete(scenario, &Edits::none()).recording().rows().to_vec();
    let most = |rows: &[Row], of: fn(&Row) -> f64| rows.iter().map(of).fold(0.0, f64::max);
    assert!(most(&rows(&base), |row| row.feed_mm_min) > 431.0);
    // Below what is programmed, 430 mm/min at 1571 1/min: from the start on, in the run and at constant feed.
    let slow = on("feed_max_mm_min = 300\nspeed_max_rpm = 1200");
    for scenario in [slow.clone(), constant_feed_twin::scenario(&slow)] {
        let rows = rows(&scenario);
        assert!((most(&rows, |row| row.feed_mm_min) - 300.0).abs() < 1e-6);
        assert!((most(&rows, |row| row.spindle_rpm) - 1200.0).abs() < 1e-6);
        assert!((rows[0].feed_override_percent - 69.70).abs() < 0.01);
        // A controller knows the limits and asks for no more; constant feed does.
        let constant = scenario.controller.kind == ControllerKind::ConstantFeed;
        assert_eq!(rows[rows.len() / 2].has(flag::FEED_SATURATED), constant);
    }
    let fast = rows(&on("speed_min_rpm = 2000"));
    assert!(fast.iter().all(|row| row.spindle_rpm > 1999.9), "a spindle that turns no slower");
    let ramp = rows(&on("override_rate_percent_s = 20"));
    assert!(ramp.iter().any(|row| row.has(flag::FEED_RATE_LIMITED)));
    assert!(most(&ramp, |row| row.feed_override_percent) <= 100.0 + 20.0 * 2.0);
    assert!(
        most(&rows(&on("override_max_percent = 110")), |row| row.feed_override_percent) < 110.001
    );
    let stopped = Run::complete(&on("stop_force_n = 60"), &Edits::none());
    assert_eq!(stopped.end().map(|end| end.id()), Some(EndId::Overload));
    // The hand at the machine turns no drive faster than it goes.
    let mut by_hand = on("feed_max_mm_min = 440");
    let operator = parse_value("disturbances.operator_overrides", "[[0.0, 100.0, 200.0]]").unwrap();
    by_hand.set("disturbances.operator_overrides", operator).unwrap();
    assert!(most(&rows(&by_hand), |row| row.feed_mm_min) < 440.0 + 1e-6);
}

#[test]
fn limits_of_a_machine_bind_in_the_plan() {
    use crate::plan::PlanJob;
    use crate::plan::machine::{MachineLimits, Source};
    use crate::run::presets::load;
    let base = load("strategy-2013").unwrap();
    let on = |entries: &str| {
        let mut scenario = base.clone();
        scenario.set_all(&limited(entries).changes).unwrap();
        scenario
    };
    let free = PlanJob::complete(&base).unwrap().optimum();
    let cap = (0.6 * free.feed_mm_min).round();
    let bound = PlanJob::complete(&on(&format!("feed_max_mm_min = {cap}"))).unwrap().optimum();
    assert!(bound.feasible && bound.feed_mm_min <= cap, "{} of {cap}", bound.feed_mm_min);
    // In the place of a placeholder also where the machine goes further; of known limits the narrower one.
    let machine = MachineLimits::heller_bea_01();
    let far = on("feed_max_mm_min = 8000\nspeed_max_rpm = 9000").cnc.clone();
    let own = machine.within(&far);
    assert_eq!((own.feed_max_mm_min.value, own.feed_max_mm_min.source), (8000.0, Source::Given));
    assert_eq!((own.speed_max_rpm.value, own.speed_min_rpm), (9000.0, machine.speed_min_rpm));
    assert_eq!(machine.within(&base.cnc), machine);
    let mut given = machine;
    given.feed_max_mm_min.source = Source::Given;
    assert_eq!(given.within(&far).feed_max_mm_min.value, 2000.0);
}

#[test]
fn the_present_cutter_and_structure_are_written_and_read_back() {
    use crate::models::tool::ShippedTool;
    for shipped in ShippedTool::ALL {
        let text = tool_file(shipped.tool(), "a \"b\"", "c");
        let file = OwnFile::read(&text).unwrap();
        assert_eq!((file.title.as_str(), file.source.as_str()), ("a \"b\"", "c"));
        let mut scenario = Scenario::default();
        scenario.set_all(&file.changes).unwrap();
        assert_eq!(scenario.tool.shipped_alike(), Some(*shipped), "{text}");
    }
    let mut scenario = Scenario::default();
    assert_eq!(structure_file(&scenario.machine.tip_modes, "a", "b"), None);
    scenario.set_all(&OwnFile::read(OwnFileKind::Structure.template()).unwrap().changes).unwrap();
    let text = structure_file(&scenario.machine.tip_modes, "a", "b").unwrap();
    let mut again = Scenario::default();
    again.set_all(&OwnFile::read(&text).unwrap().changes).unwrap();
    assert_eq!(again.machine.tip_modes, scenario.machine.tip_modes);
}
