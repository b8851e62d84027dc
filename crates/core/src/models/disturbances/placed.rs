//! Disturbances of one kind as a setting: where each begins, how long it lasts, how large it is.

use std::marker::PhantomData;

use super::Disturbance;
use crate::base::language::tr;
use crate::base::settings::{Column, Editor, Rows, Structure, Value};

/// Most disturbances of a kind.
pub const MAX_PLACED: usize = 64;
/// Furthest place along the way, and longest length, mm: those of the longest path.
const FURTHEST_MM: f64 = 20_000.0;
/// Shortest length, mm.
pub const SHORTEST_MM: f64 = 0.1;

/// A kind of disturbance as a type of its own, so that its list is a setting with its own shape.
pub trait Placing: Clone + std::fmt::Debug + PartialEq + 'static {
    /// The kind.
    const OF: Disturbance;
}

/// One disturbance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Zone {
    /// Where along the way it begins, mm.
    pub at_mm: f64,
    /// Over which length, mm; infinite for one that stays.
    pub length_mm: f64,
    /// How large it is, in the unit of its kind; 1 for one without a size.
    pub size: f64,
}

impl Zone {
    /// Whether a place along the way in mm lies in it.
    #[must_use]
    pub fn holds(&self, position_mm: f64) -> bool {
        position_mm >= self.at_mm && position_mm < self.end_mm()
    }

    /// Where it ends, mm.
    #[must_use]
    pub fn end_mm(&self) -> f64 {
        self.at_mm + self.length_mm
    }
}

/// The disturbances of a kind, by place.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed<K> {
    zones: Vec<Zone>,
    of: PhantomData<K>,
}

impl<K> Default for Placed<K> {
    fn default() -> Self {
        Self { zones: Vec::new(), of: PhantomData }
    }
}

impl<K: Placing> Placed<K> {
    /// All of them, by place.
    #[must_use]
    pub fn zones(&self) -> &[Zone] {
        &self.zones
    }

    /// Those that hold at a place along the way in mm.
    pub fn at(&self, position_mm: f64) -> impl Iterator<Item = &Zone> {
        self.zones.iter().filter(move |zone| zone.holds(position_mm))
    }
}

/// A row of a list: place, length where it lasts, size where it has one.
fn row(of: Disturbance, zone: &Zone) -> Vec<f64> {
    let mut row = vec![zone.at_mm];
    row.extend(of.lasts().then_some(zone.length_mm));
    row.extend(of.size().map(|_| zone.size));
    row
}

fn zone(of: Disturbance, row: &[f64], [least, largest]: [f64; 2]) -> Option<Zone> {
    let mut numbers = row.iter().copied();
    let at_mm = numbers.next().filter(|at_mm| (0.0..=FURTHEST_MM).contains(at_mm))?;
    let length_mm = match of.lasts() {
        true => numbers.next().filter(|mm| (SHORTEST_MM..=FURTHEST_MM).contains(mm))?,
        false => f64::INFINITY,
    };
    let size = match of.size() {
        Some(_) => numbers.next().filter(|size| (least..=largest).contains(size))?,
        None => 1.0,
    };
    // + 0.0 turns -0.0 into 0.0, so that equal settings have equal bits.
    numbers.next().is_none().then_some(Zone { at_mm: at_mm + 0.0, length_mm, size: size + 0.0 })
}

/// The value of a list of zones of a kind.
pub(super) fn written(of: Disturbance, zones: &[Zone]) -> Value {
    zones.iter().map(|zone| row(of, zone)).collect::<Vec<_>>().into()
}

/// Declared with the least and the largest size; the kind says of what and how it lasts.
impl<K: Placing> Structure for Placed<K> {
    const ID: &'static str = K::OF.id_of_kind();

    fn bounds([least, largest]: [f64; 2]) -> Vec<(&'static str, f64)> {
        let mut bounds = vec![("max_position_mm", FURTHEST_MM)];
        if K::OF.lasts() {
            bounds.extend([("min_length_mm", SHORTEST_MM), ("max_length_mm", FURTHEST_MM)]);
        }
        if K::OF.size().is_some() {
            bounds.extend([("min_size", least), ("max_size", largest)]);
        }
        bounds
    }

    fn allowed([least, largest]: [f64; 2], unit: &str) -> String {
        let mut names = vec![tr("position mm").to_owned()];
        let mut ranges = vec![tr!("positions ascending from 0 to {most} mm", most = FURTHEST_MM)];
        if K::OF.lasts() {
            names.push(tr("length mm").to_owned());
            ranges.push(tr!(
                "lengths from {least} to {most} mm",
                least = SHORTEST_MM,
                most = FURTHEST_MM
            ));
        }
        if let Some(size) = K::OF.size() {
            let name = tr(size.name);
            names.push(format!("{name} {unit}").trim_end().to_owned());
            let sizes = tr!(
                "{size} from {least} to {most} {unit}",
                size = name,
                least = least,
                most = largest,
                unit = unit
            );
            ranges.push(sizes.trim_end().to_owned());
        }
        tr!(
            "at most {n} lists [{entries}], {ranges}",
            n = MAX_PLACED,
            entries = names.join(", "),
            ranges = ranges.join(", ")
        )
    }

    fn write(&self) -> Value {
        written(K::OF, &self.zones)
    }

    fn read(value: &Value, range: [f64; 2]) -> Option<Self> {
        let rows: Vec<Vec<f64>> =
            value.list()?.iter().map(Value::numbers).collect::<Option<_>>()?;
        let zones: Option<Vec<Zone>> = rows.iter().map(|row| zone(K::OF, row, range)).collect();
        let zones = zones.filter(|zones| zones.len() <= MAX_PLACED)?;
        let ascending = zones.windows(2).all(|pair| pair[0].at_mm < pair[1].at_mm);
        ascending.then_some(Self { zones, of: PhantomData })
    }

    fn editor([least, largest]: [f64; 2]) -> Editor {
        let mut columns = vec![Column {
            name: "Position",
            suffix: " mm:",
            range: [0.0, FURTHEST_MM],
            speed: 0.5,
        }];
        let mut next = vec![20.0];
        if K::OF.lasts() {
            let range = [SHORTEST_MM, FURTHEST_MM];
            columns.push(Column { name: "Length", suffix: " mm long", range, speed: 0.5 });
            next.push(K::OF.usual_length_mm());
        }
        if let Some(size) = K::OF.size() {
            let (range, speed) = ([least, largest], (largest - least) / 500.0);
            columns.push(Column { name: "Size", suffix: size.suffix, range, speed });
            next.push(size.usual);
        }
        Editor::Rows(Rows { row: K::OF.in_text(), columns, most: MAX_PLACED, gap: 0.01, next })
    }

    fn example([least, largest]: [f64; 2], share: f64, pick: u32) -> Value {
        let size = least + share * (largest - least);
        let at = |at_mm: f64| Zone { at_mm, length_mm: SHORTEST_MM + share * 50.0, size };
        let zones = [at(0.0), at(1.0 + share * 10.0), at(FURTHEST_MM)];
        written(K::OF, &zones[..1 + pick as usize % 3])
    }
}
