//! A structured setting is one type: a setting of a test's own proves it.

use super::*;

/// Three shares that add up to one at most.
#[derive(Clone, Debug, PartialEq)]
pub struct Blend([f64; 3]);

crate::structured!(Blend);

impl Structure for Blend {
    const ID: &'static str = "blend";

    fn bounds([least, largest]: [f64; 2]) -> Vec<(&'static str, f64)> {
        vec![("least", least), ("largest", largest)]
    }
    fn allowed([least, largest]: [f64; 2], unit: &str) -> String {
        format!("three shares from {least} to {largest} {unit}, at most one together")
    }
    fn write(&self) -> Value {
        self.0.into()
    }
    fn read(value: &Value, [least, largest]: [f64; 2]) -> Option<Self> {
        let shares: [f64; 3] = value.array()?;
        let fit = shares.iter().all(|share| (least..=largest).contains(share));
        (fit && shares.iter().sum::<f64>() <= 1.0).then_some(Self(shares))
    }
    fn editor(_: [f64; 2]) -> Editor {
        Editor::Count("share")
    }
    fn example([least, largest]: [f64; 2], share: f64, _: u32) -> Value {
        Value::from([least + share * (largest - least); 3])
    }
}

crate::settings! {
    /// A group with a structured setting.
    pub struct Paint {
        /// Its blend.
        blend: Blend = Blend([0.5, 0.25, 0.0]), [0.0, 0.5], "L", live, "Blend";
    }
}

#[test]
fn a_structured_setting_is_read_printed_bounded_and_listed_by_its_type_alone() {
    let spec = Paint::specs().remove(0);
    assert_eq!(spec.default.to_string(), "[0.5, 0.25, 0.0]");
    assert_eq!(spec.allowed.bound("largest"), Some(0.5));
    assert!(spec.allowed.allowed(spec.unit).contains("from 0 to 0.5 L"));
    let listed = serde_json::to_value(&spec).unwrap();
    assert_eq!((&listed["kind"], &listed["largest"]), (&"blend".into(), &0.5.into()));
    assert_eq!(listed["default"], serde_json::json!([0.5, 0.25, 0.0]));

    let Kind::Structured(shape) = &spec.allowed else { panic!("{:?}", spec.allowed) };
    assert_eq!(shape.editor(), Editor::Count("share"));
    let mut paint = Paint::default();
    for (text, taken) in [("[0.1, 0, 0.2]", true), ("[0.5, 0.5, 0.5]", false), ("[1, 2]", false)] {
        let value = shape.parse(text).unwrap();
        assert_eq!(paint.set("blend", &value, &spec.allowed).is_some(), taken, "{text}");
    }
    assert_eq!(paint.blend, Blend([0.1, 0.0, 0.2]));
    assert!(shape.parse("[0.1").is_none());
    assert!(paint.set("blend", &shape.example(0.5, 0), &spec.allowed).is_some());
}

#[test]
fn lists_are_printed_as_toml_and_json_read_them() {
    let list = Value::from(vec![vec![[0.1, 2.0], [-0.0, 1e300]], vec![]]);
    let json: serde_json::Value = serde_json::from_str(&list.to_string()).unwrap();
    assert_eq!(Value::from(json), list);
    let toml: toml::Table = format!("x = {list}").parse().unwrap();
    assert_eq!(toml["x"].as_array().map(Vec::len), Some(2));
}
