use super::*;

fn full() -> DataLayout {
    let mut layout = DataLayout::default();
    for (key, value) in [
        ("encoding", "latin-1"),
        ("separator", "tab"),
        ("decimal", "comma"),
        ("thousands", "point"),
        ("names_line", "19"),
        ("units_line", "20"),
        ("first_line", "21"),
        ("variable", "mill[3]"),
        ("names", "t,F \"x\""),
        ("units", "s,"),
        ("time", "none"),
        ("rate_hz", "25000.5"),
    ] {
        layout.set(key, value).unwrap();
    }
    layout
}

#[test]
fn every_entry_is_written_read_and_told() {
    let layout = full();
    assert_eq!(DataLayout::read(&layout.write()), Ok(layout.clone()));
    assert_eq!(layout.entries().len(), LAYOUT_KEYS.len());
    let mut again = DataLayout::default();
    for (key, value) in layout.entries() {
        again.set(key, &value).unwrap();
    }
    assert_eq!(again, layout);
    for (key, about) in LAYOUT_KEYS {
        assert!(layout.write().contains(&format!("# {about}\n{key} = ")), "{key}");
    }
    assert_eq!(DataLayout::read("version = 1\n"), Ok(DataLayout::default()));
}

#[test]
fn what_is_said_later_counts_and_the_rest_stays() {
    let mut over = DataLayout::default();
    over.set("decimal", "point").unwrap();
    let both = full().overruled_by(&over);
    assert_eq!(both.decimal, Some(DecimalMark::Point));
    assert_eq!(both.names_line, Some(19));
    assert_eq!(full().overruled_by(&DataLayout::default()), full());
}

#[test]
fn what_is_not_allowed_is_named_with_what_is() {
    for (text, parts) in [
        ("", ["`version` is missing", ""]),
        ("version = 2\n", ["`version` must be 1", ""]),
        ("version = 1\nseperator = \"tab\"\n", ["`seperator`", "did you mean `separator`"]),
        ("version = 1\nxyz = 1\n", ["no entry `xyz`", "rate_hz"]),
        ("version = 1\nseparator = \"pipe\"\n", ["`separator` cannot be pipe", "semicolon"]),
        ("version = 1\nfirst_line = 0\n", ["`first_line` cannot be 0", "1.."]),
        ("version = 1\nnames_line = -1\n", ["`names_line` cannot be -1", "0.."]),
        ("version = 1\nnames = [1, 2]\n", ["`names` cannot be [1, 2]", "list of texts"]),
        ("version = 1\nnames = [\"\"]\n", ["`names`", "none of them empty"]),
        ("version = 1\ndecimal = [\"comma\"]\n", ["`decimal`", "not a list"]),
        ("version = 1\nrate_hz = 0\n", ["`rate_hz` cannot be 0", "above 0"]),
        ("version = 1\nrate_hz = nan\n", ["`rate_hz` cannot be nan", "above 0"]),
        ("version = 1\ntime = \"\"\n", ["`time`", "or none"]),
        ("version = 1\nnames =\n", ["not TOML", "line 2"]),
    ] {
        let error = DataLayout::read(text).unwrap_err();
        for part in parts {
            assert!(error.contains(part), "{part}: {error}");
        }
    }
}
