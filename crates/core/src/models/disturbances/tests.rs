//! What acts where, and how lists are read and printed.

use super::*;
use crate::base::settings::{Group, Kind};

/// Sets a list, or says that it was refused.
fn set(disturbances: &mut Disturbances, kind: Disturbance, value: &Value) -> Option<()> {
    let key = kind.path().strip_prefix("disturbances.").unwrap();
    let specs = Disturbances::specs();
    let spec = specs.iter().find(|spec| spec.key == key).unwrap();
    disturbances.set(key, value, &spec.allowed)
}

/// With one of a kind at 10 mm over 5 mm.
fn one(kind: Disturbance, size: f64) -> Disturbances {
    let mut disturbances = Disturbances::default();
    let zone = Zone { at_mm: 10.0, length_mm: 5.0, size };
    let value = disturbances.with(kind, zone);
    set(&mut disturbances, kind, &value).unwrap();
    disturbances
}

#[test]
fn every_kind_acts_from_its_place_to_its_end_and_what_stays_stays() {
    type Acts = fn(&Disturbances, f64) -> f64;
    let kinds: [(Disturbance, f64, Acts, f64, f64); 10] = [
        (Disturbance::HardSpot, 1.5, |d, x| d.hardness_factor(x), 1.0, 1.5),
        (Disturbance::Gap, 1.0, |d, x| d.depth_mm(x, 2.0), 2.0, 0.0),
        (Disturbance::DepthStep, 0.5, |d, x| d.depth_mm(x, 2.0), 2.0, 2.5),
        (Disturbance::WearJump, 0.1, |d, x| d.wear_land_mm(x).abs(), 0.0, 0.1),
        (Disturbance::BrokenTooth, 1.0, |d, x| d.broken_teeth(x) as f64, 0.0, 1.0),
        (Disturbance::ChatterBurst, 20.0, |d, x| d.chatter_share(x).abs(), 0.0, 0.2),
        (Disturbance::SensorDropout, 1.0, |d, x| d.sensed_n(x, 170.0), 170.0, 0.0),
        (Disturbance::SensorDrift, 50.0, |d, x| d.sensed_n(x, 170.0), 170.0, 195.0),
        (Disturbance::DeadTime, 0.2, |d, x| d.added_dead_time_s(x).abs(), 0.0, 0.2),
        (Disturbance::Operator, 60.0, |d, x| d.operator_factor(x), 1.0, 0.6),
    ];
    assert_eq!(kinds.map(|(kind, ..)| kind).as_slice(), Disturbance::ALL, "every kind is tried");
    for (kind, size, acts, before, within) in kinds {
        let disturbances = one(kind, size);
        // A drift has half its size in the middle.
        let found = [0.0, 9.99, 12.5].map(|x| acts(&disturbances, x));
        assert!((found[2] - within).abs() < 1e-12, "{kind:?}: {found:?}");
        assert_eq!([found[0], found[1]], [before; 2], "{kind:?}");
        let behind = acts(&disturbances, 15.0);
        let expected = match (kind == Disturbance::SensorDrift, kind.stays()) {
            (true, _) => 220.0,
            (false, true) => within,
            (false, false) => before,
        };
        assert!((behind - expected).abs() < 1e-12, "{kind:?}: {behind}");
        let borders = if kind.lasts() { [10.0, 15.0] } else { [10.0, f64::INFINITY] };
        let next = [0.0, 10.0].map(|x| disturbances.next_border_mm(x));
        assert_eq!(next, borders, "{kind:?}");
        assert!(!disturbances.is_empty() && disturbances.all().count() == 1);
    }
    assert!(Disturbances::default().is_empty());
}

#[test]
fn what_overlaps_acts_together_and_one_of_a_kind_begins_at_a_place() {
    let mut both = one(Disturbance::HardSpot, 1.5);
    let second = Zone { at_mm: 12.0, length_mm: 5.0, size: 2.0 };
    let value = both.with(Disturbance::HardSpot, second);
    set(&mut both, Disturbance::HardSpot, &value).unwrap();
    assert_eq!([11.0, 13.0, 16.0].map(|x| both.hardness_factor(x)), [1.5, 3.0, 2.0]);
    let again = both.with(Disturbance::HardSpot, Zone { size: 3.0, ..second });
    set(&mut both, Disturbance::HardSpot, &again).unwrap();
    assert_eq!(both.of(Disturbance::HardSpot).len(), 2);
    assert_eq!(both.hardness_factor(16.0), 3.0);
    assert_eq!(both.depth_mm(13.0, 0.1), 0.1);
    let shallow = one(Disturbance::DepthStep, -3.0);
    assert_eq!(shallow.depth_mm(12.0, 2.0), 0.0, "no less than no material");
    let unplugged = one(Disturbance::SensorDrift, -300.0);
    assert_eq!(unplugged.sensed_n(20.0, 170.0), 0.0, "no reading is negative");
}

#[test]
fn lists_are_refused_with_what_is_allowed_and_print_as_they_are_read() {
    for spec in Disturbances::specs() {
        let Kind::Structured(shape) = &spec.allowed else { continue };
        let mut kinds = Disturbance::ALL.iter().copied();
        let kind = kinds.find(|kind| kind.path().ends_with(&format!(".{}", spec.key)));
        let kind = kind.unwrap();
        let mut disturbances = Disturbances::default();
        for pick in 0..3 {
            for share in [0.0, 0.5, 1.0] {
                let value = shape.example(share, pick);
                set(&mut disturbances, kind, &value).unwrap();
                let printed = disturbances.get(spec.key).unwrap();
                assert_eq!(printed.to_string(), value.to_string());
                assert_eq!(shape.parse(&printed.to_string()), Some(value));
            }
        }
        let before = disturbances.clone();
        for bad in ["[[-1]]", "[[1, 2, 3, 4]]", "[[]]", "[1]", "[[30000]]", "7", "[[1e999]]"] {
            let refused = shape.parse(bad).and_then(|value| set(&mut disturbances, kind, &value));
            assert_eq!(refused, None, "{kind:?} {bad}");
        }
        let row = |at_mm: f64| placed::written(kind, &[Zone { at_mm, ..usual(kind) }; 1]);
        let (Some([a]), Some([b])) = (
            row(5.0).list().map(|rows| [rows[0].clone()]),
            row(4.0).list().map(|rows| [rows[0].clone()]),
        ) else {
            panic!("a row")
        };
        for rows in [vec![a.clone(), b], vec![a.clone(), a]] {
            assert_eq!(set(&mut disturbances, kind, &Value::List(rows)), None, "{kind:?}: order");
        }
        assert_eq!(disturbances, before);
        let allowed = spec.allowed.allowed(spec.unit);
        assert!(allowed.contains("position mm") && allowed.contains("64"), "{allowed}");
        assert_eq!(allowed.contains("lengths from 0.1"), kind.lasts(), "{allowed}");
        for bound in ["min_size", "max_size"] {
            let bound = spec.allowed.bound(bound);
            assert_eq!(bound.is_some(), kind.size().is_some());
            let shown = bound.is_none_or(|bound| allowed.contains(&bound.to_string()));
            assert!(shown, "{allowed}");
        }
    }
}

fn usual(kind: Disturbance) -> Zone {
    let size = kind.size().map_or(1.0, |size| size.usual);
    Zone { at_mm: 0.0, length_mm: kind.usual_length_mm(), size }
}

#[test]
fn what_is_offered_first_is_allowed() {
    for kind in Disturbance::ALL.iter().copied() {
        let mut disturbances = Disturbances::default();
        let value = disturbances.with(kind, usual(kind));
        assert!(set(&mut disturbances, kind, &value).is_some(), "{kind:?} {value}");
    }
}
