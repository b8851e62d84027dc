use super::*;
use crate::blocks::control::script::TEMPLATES;
use crate::own_file::OwnFileKind;
use crate::part::{EXAMPLE_CSV, EXAMPLE_GCODE};
use crate::run::{presets, scenario_file};

fn file(name: &str, text: &str) -> LibraryFile {
    let contents = text.as_bytes().to_vec();
    let found = LibraryFile::of(name, contents.len() as u64, || Ok(contents));
    found.unwrap_or_else(|| panic!("{name} is of no use"))
}

#[test]
fn every_kind_is_told_with_what_it_describes() {
    let preset = presets::load("first-cut").unwrap();
    let scenario = scenario_file::write(&preset, &Edits::none());
    for (name, text, kind, wanted) in [
        ("a.toml", OwnFileKind::Tool.template(), LibraryKind::Tool, "Square end, 3 teeth, 10 mm"),
        ("a.TOML", OwnFileKind::Material.template(), LibraryKind::Material, "m_c 0.18"),
        ("b/a.toml", OwnFileKind::Structure.template(), LibraryKind::Structure, "modes"),
        ("a.toml", OwnFileKind::Machine.template(), LibraryKind::Machine, "at most 3000 mm/min"),
        ("a.csv", EXAMPLE_CSV, LibraryKind::Part, "130.0 mm long"),
        ("a.nc", EXAMPLE_GCODE, LibraryKind::Program, "moves"),
        ("a.rhai", TEMPLATES[0].1, LibraryKind::Script, "lines"),
        ("a.toml", &scenario, LibraryKind::Scenario, " mm"),
        ("a.csv", "t [s],Fx [N]\n0.0,1\n0.1,2\n0.2,3\n", LibraryKind::Measured, "Fx [N]"),
        ("a.txt", "t Fx\n0.0 1\n0.1 2\n0.2 2\n", LibraryKind::Measured, "Fx"),
        ("a.csv", "a,b,c,d,e,f\n1,2,3,4,5,6\n", LibraryKind::Table, "a, b, c, d and 2 more"),
    ] {
        let found = file(name, text);
        assert_eq!((found.kind, &found.fault), (kind, &None), "{name}");
        assert!(found.facts.contains(wanted), "{found:?}");
        assert!(kind.own().is_none() || found.title.len() > 3, "{found:?}");
    }
    assert_eq!(file("a.json", r#"{"islands":[],"problem":"0"}"#).kind, LibraryKind::Search);
}

#[test]
fn what_is_broken_is_listed_with_line_entry_value_and_range() {
    let tool = OwnFileKind::Tool.template().replacen("teeth = 3", "teeth = 30", 1);
    for (name, text, kind, wanted) in [
        ("a.toml", tool.as_str(), LibraryKind::Tool, &["line 9", "`teeth`", "30", "1 to 8"][..]),
        ("a.toml", "version = 1\n[target\n", LibraryKind::Unreadable, &["2"]),
        ("a.toml", "version = 1\n[target]\nra_um = 99\n", LibraryKind::Scenario, &["ra_um", "99"]),
        ("a.toml", "", LibraryKind::Scenario, &["version"]),
        ("a.csv", "s,a_p,a_e\n0,99,3\n10,0,0\n", LibraryKind::Part, &["line 2", "a_p", "99"]),
        ("a.nc", "G0 X1 Y1 Z1\nG1 Xx\n", LibraryKind::Program, &["line 2"]),
        ("a.rhai", "fn update(now) {\n  let = \n}\n", LibraryKind::Script, &["line"]),
        ("a.json", "{", LibraryKind::Networks, &[""]),
        ("a.xlsx", "PK\x03\x04", LibraryKind::Table, &["CSV"]),
    ] {
        let found = file(name, text);
        let fault = found.fault.clone().unwrap_or_else(|| panic!("{name}: {found:?}"));
        assert_eq!(found.kind, kind, "{name}: {fault}");
        assert!(wanted.iter().all(|part| fault.contains(part)), "{name}: {fault}");
        let cut = (&Scenario::default(), &Edits::none());
        assert_eq!(found.is_in_use(cut.0, cut), None);
    }
    let latin = LibraryFile::of("a.toml", 5, || Ok(b"Fr\xe4se".to_vec())).unwrap();
    assert_eq!(latin.kind, LibraryKind::Unreadable);
    assert!(latin.fault.is_some_and(|fault| fault.contains("Latin-1")));
    let denied = LibraryFile::of("a.toml", 5, || Err("permission denied".to_owned())).unwrap();
    assert_eq!(denied.fault.as_deref(), Some("permission denied"));
}

#[test]
fn what_is_huge_is_not_read_and_what_is_of_no_use_is_left_out() {
    let unread = || -> Result<Vec<u8>, String> { panic!("it is not to be read") };
    let huge = MOST_LOOKED_INTO + 1;
    let found = LibraryFile::of("a.toml", huge, unread).unwrap();
    assert!(found.fault.is_some_and(|fault| fault.contains("4.0 MB")), "and the limit");
    let found = LibraryFile::of("a.mat", huge, unread).unwrap();
    assert_eq!((found.kind, found.fault), (LibraryKind::Measured, None));
    for name in ["a.png", "README", "a.csv.layout.toml", "a.toml.part", "toml"] {
        assert_eq!(LibraryFile::of(name, 1, unread), None, "{name}");
    }
}

#[test]
fn it_is_known_which_file_a_scenario_uses() {
    let none = Edits::none();
    let tool = OwnFileKind::Tool.template();
    let other = tool.replacen("teeth = 3", "teeth = 4", 1);
    let part = file("part.csv", EXAMPLE_CSV);
    let script = file("p.rhai", TEMPLATES[0].1);
    let files = [
        file("a.toml", tool),
        file("b.toml", &other),
        file("m.toml", OwnFileKind::Material.template()),
        part.clone(),
        script.clone(),
    ];
    let mut scenario = Scenario::default();
    let used = |scenario: &Scenario| -> Vec<bool> {
        files.iter().map(|file| file.is_in_use(scenario, (scenario, &none)) == Some(true)).collect()
    };
    assert_eq!(used(&scenario), [false; 5]);
    for (file, text) in [(0, tool), (2, OwnFileKind::Material.template())] {
        let changes = crate::own_file::OwnFile::read(text).unwrap().changes;
        scenario.set_all(&changes).unwrap();
        assert!(used(&scenario)[file]);
    }
    let path = crate::part::PartPath::read(EXAMPLE_CSV).unwrap();
    let changes = path.to_scenario(&scenario).unwrap().changes;
    scenario.set_all(&changes).unwrap();
    scenario.set_all(&script_changes(TEMPLATES[0].1)).unwrap();
    assert_eq!(used(&scenario), [true, false, true, true, true]);
    scenario.set("tool.teeth", Value::Int(4)).unwrap();
    assert_eq!(used(&scenario)[..2], [false, true]);
    let whole = file("s.toml", &scenario_file::write(&scenario, &none));
    assert_eq!(whole.is_in_use(&scenario, (&scenario, &none)), Some(true));
    assert_eq!(whole.is_in_use(&scenario, (&Scenario::default(), &none)), Some(false));
    assert_eq!(file("p.nc", EXAMPLE_GCODE).is_in_use(&scenario, (&scenario, &none)), None);
    // A formula, at the place that has its units.
    let formula = file("f.toml", FORMULA);
    assert_eq!(
        (formula.kind, formula.is_in_use(&scenario, (&scenario, &none))),
        (LibraryKind::Formula, Some(false))
    );
    let LibraryHas::Formula(text, places) = &formula.has else { panic!("{formula:?}") };
    assert_eq!(places, &[FormulaPlace::Ra]);
    assert_eq!(file("f.json", text).kind, LibraryKind::Formula);
    scenario.set("formula.ra", Value::Text(text.clone())).unwrap();
    assert_eq!(formula.is_in_use(&scenario, (&scenario, &none)), Some(true));
}

/// Ra of a force, as K5.
const FORMULA: &str = "version = 1\nformula = \"0.2 + F/1000\"\nsource = \"a test\"\n[output]\nname = \"Ra\"\n\
    unit = \"um\"\n[[inputs]]\nname = \"F\"\nunit = \"N\"\nlow = 50.0\nhigh = 1000.0\n";
