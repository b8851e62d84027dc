//! The columns of a table of a path: what their names mean, their units, and what is allowed in them.

use super::path::{PartPath, span};
use crate::base::language::tr;
use crate::csv_table::{CsvRow, CsvTable};
use crate::run::scenario::param;

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Holds {
    Length,
    X,
    Y,
    Z,
    Axial,
    Radial,
    Feed,
    Speed,
}

/// Their names, in small letters but for the two that only size tells apart.
const NAMES: &[(&str, Holds)] = &[
    ("s", Holds::Length),
    ("length", Holds::Length),
    ("position", Holds::Length),
    ("path", Holds::Length),
    ("x", Holds::X),
    ("y", Holds::Y),
    ("z", Holds::Z),
    ("a_p", Holds::Axial),
    ("ap", Holds::Axial),
    ("depth", Holds::Axial),
    ("axial_depth", Holds::Axial),
    ("a_e", Holds::Radial),
    ("ae", Holds::Radial),
    ("width", Holds::Radial),
    ("radial_depth", Holds::Radial),
    ("f", Holds::Feed),
    ("feed", Holds::Feed),
    ("S", Holds::Speed),
    ("n", Holds::Speed),
    ("speed", Holds::Speed),
];

/// Units of a length with their size in mm, of a feed in mm/min, and of a speed in 1/min.
const UNITS: [&[(&str, f64)]; 3] = [
    &[
        ("mm", 1.0),
        ("um", 1e-3),
        ("\u{b5}m", 1e-3),
        ("\u{3bc}m", 1e-3),
        ("cm", 10.0),
        ("m", 1e3),
        ("in", 25.4),
        ("inch", 25.4),
    ],
    &[("mm/min", 1.0), ("mm_min", 1.0), ("m/min", 1e3), ("mm/s", 60.0), ("in/min", 25.4)],
    &[("1/min", 1.0), ("rpm", 1.0), ("min^-1", 1.0), ("1/s", 60.0)],
];

impl Holds {
    fn units(self) -> &'static [(&'static str, f64)] {
        match self {
            Self::Length | Self::X | Self::Y | Self::Z | Self::Axial | Self::Radial => UNITS[0],
            Self::Feed => UNITS[1],
            Self::Speed => UNITS[2],
        }
    }

    /// The largest value; the least one is 0, or minus that of a coordinate.
    fn most(self) -> f64 {
        let bound = |path: &str, name: &str| {
            let bound = param(path).ok().and_then(|param| param.spec.allowed.bound(name));
            bound.unwrap_or(f64::INFINITY)
        };
        match self {
            Self::Length => bound("workpiece.depth_steps", "max_position_mm"),
            Self::Axial => bound("workpiece.depth_steps", "max_depth_mm"),
            Self::Radial => bound("workpiece.radial_steps", "max_depth_mm"),
            Self::X | Self::Y | Self::Z => 1e6,
            Self::Feed | Self::Speed => 1e6,
        }
    }

    fn least(self) -> f64 {
        match self {
            Self::X | Self::Y | Self::Z => -self.most(),
            Self::Length | Self::Axial | Self::Radial | Self::Feed | Self::Speed => 0.0,
        }
    }
}

/// A column that is used.
struct Used<'a> {
    holds: Holds,
    place: usize,
    name: &'a str,
    unit: &'static str,
    times: f64,
}

/// What a header's cell names, with its unit; none where it names nothing known.
fn named(cell: &str) -> Option<(Holds, &str)> {
    let (name, unit) = match cell.find(['[', '(']) {
        Some(at) => (&cell[..at], cell[at + 1..].trim_end_matches([']', ')'])),
        None => cell.split_once(" / ").unwrap_or((cell, "")),
    };
    let (name, unit) = (name.trim(), unit.trim());
    let of = |name: &str| {
        let small = name.to_lowercase().replace([' ', '-'], "_");
        let exact = NAMES.iter().find(|(known, _)| *known == name);
        exact.or_else(|| NAMES.iter().find(|(known, _)| *known == small)).map(|(_, holds)| *holds)
    };
    if let Some(holds) = of(name) {
        return Some((holds, unit));
    }
    // `s_mm`: a known name and a unit behind it.
    let ends = name.char_indices().filter(|(_, c)| *c == '_' || *c == ' ').map(|(at, _)| at);
    ends.filter(|_| unit.is_empty()).find_map(|at| {
        let (holds, unit) = (of(&name[..at])?, &name[at + 1..]);
        holds.units().iter().any(|(known, _)| *known == unit).then_some((holds, unit))
    })
}

/// The columns of a header that are used, and the names of the others.
fn used(names: &[String]) -> Result<(Vec<Used<'_>>, Vec<&str>), String> {
    let (mut used, mut others): (Vec<Used<'_>>, Vec<&str>) = (Vec::new(), Vec::new());
    for (place, name) in names.iter().enumerate() {
        let Some((holds, unit)) = named(name) else {
            others.push(name);
            continue;
        };
        let units = holds.units();
        let known = units.iter().find(|(known, _)| unit.is_empty() || *known == unit);
        let Some((unit, times)) = known else {
            let all: Vec<&str> = units.iter().map(|(unit, _)| *unit).collect();
            return Err(tr!(
                "column `{name}`: the unit is `{unit}`: allowed is {all}",
                name = name,
                unit = unit,
                all = all.join(", ")
            ));
        };
        if let Some(other) = used.iter().find(|other| other.holds == holds) {
            return Err(tr!(
                "the columns `{name}` and `{other}` mean the same",
                name = other.name,
                other = name
            ));
        }
        used.push(Used { holds, place, name, unit, times: *times });
    }
    let has = |holds| used.iter().any(|column: &Used<'_>| column.holds == holds);
    let along = has(Holds::Length);
    let mut missing = Vec::new();
    if !(along || has(Holds::X) && has(Holds::Y)) {
        missing.push(tr("s (or x and y)"));
    }
    for (holds, name) in [(Holds::Axial, "a_p"), (Holds::Radial, "a_e")] {
        if !has(holds) {
            missing.push(name);
        }
    }
    if !missing.is_empty() {
        return Err(tr!(
            "the columns are {found}; missing are {missing}",
            found = names.join(", "),
            missing = missing.join(", ")
        ));
    }
    Ok((used, others))
}

/// The number of a column in a row, in its base unit; none where no such column is there, or an optional one is empty.
fn value(
    table: &CsvTable,
    row: &CsvRow,
    used: &[Used<'_>],
    holds: Holds,
) -> Result<Option<f64>, String> {
    let Some(column) = used.iter().find(|column| column.holds == holds) else { return Ok(None) };
    let cell = &row.cells[column.place];
    if cell.is_empty() && [Holds::Feed, Holds::Speed].contains(&holds) {
        return Ok(None);
    }
    let [least, most] = [holds.least(), holds.most()];
    let number = table.number(cell).map(|x| column.times * x);
    let number = number.filter(|x| (least..=most).contains(x)).ok_or_else(|| {
        tr!(
            "line {line}, column `{name}`: `{cell}`: allowed is a number from {least} to {most} {unit}",
            line = row.line,
            name = column.name,
            cell = cell,
            least = least / column.times,
            most = most / column.times,
            unit = column.unit
        )
    })?;
    Ok(Some(number + 0.0))
}

/// Where along the way a row is: as it says, or so much farther than the last one as its place is from that one's.
fn along_mm(
    table: &CsvTable,
    row: &CsvRow,
    used: &[Used<'_>],
    before: Option<&([f64; 3], f64)>,
) -> Result<([f64; 3], f64), String> {
    let get = |holds| value(table, row, used, holds);
    let at = [get(Holds::X)?, get(Holds::Y)?, get(Holds::Z)?].map(|x| x.unwrap_or(0.0));
    if let Some(length_mm) = get(Holds::Length)? {
        return Ok((at, length_mm));
    }
    let Some((from, along_mm)) = before else { return Ok((at, 0.0)) };
    let [x, y, z] = [0, 1, 2].map(|i: usize| at[i] - from[i]);
    Ok((at, along_mm + (x * x + y * y + z * z).sqrt()))
}

/// See [`PartPath::is_meant_by`].
pub(super) fn is_meant_by(text: &str) -> bool {
    let mut lines = text.lines().map(str::trim);
    let is_header =
        |line: &&str| !line.is_empty() && !line.starts_with('#') && !line.starts_with("sep=");
    let Some(header) = lines.find(is_header) else { return false };
    [';', '\t', ','].into_iter().any(|separator| {
        let names: Vec<String> =
            header.split(separator).map(|name| name.trim().trim_matches('"').to_owned()).collect();
        used(&names).is_ok()
    })
}

/// See [`PartPath::read`].
pub(super) fn read(text: &str) -> Result<PartPath, String> {
    let (names, table) = CsvTable::whole(text)?;
    let (used, others) = used(&names)?;
    let mut rows: Vec<[f64; 3]> = Vec::with_capacity(table.rows.len());
    let (mut feeds, mut speeds) = (Vec::new(), Vec::new());
    let mut place: Option<([f64; 3], f64)> = None;
    for row in &table.rows {
        let (at, along_mm) = along_mm(&table, row, &used, place.as_ref())?;
        let refused = match (&place, along_mm) {
            (None, 0.0) => None,
            (None, _) => Some(tr!(
                "line {line}: the path begins at {s} mm: allowed is 0",
                line = row.line,
                s = along_mm
            )),
            (Some((_, before)), _) if along_mm > *before => None,
            (Some((_, before)), _) => Some(tr!(
                "line {line}: the path is at {s} mm: allowed is more than the {before} mm of the row before",
                line = row.line,
                s = along_mm,
                before = *before
            )),
        };
        if let Some(refused) = refused {
            return Err(refused);
        }
        place = Some((at, along_mm));
        let depth = |holds| Ok::<f64, String>(value(&table, row, &used, holds)?.unwrap_or(0.0));
        rows.push([along_mm, depth(Holds::Axial)?, depth(Holds::Radial)?]);
        feeds.extend(value(&table, row, &used, Holds::Feed)?);
        speeds.extend(value(&table, row, &used, Holds::Speed)?);
    }
    let Some([length_mm, ..]) = rows.pop().filter(|_| !rows.is_empty()) else {
        return Err(tr!(
            "the table has {n} rows: allowed is 2 or more, from the start of the path to its end",
            n = table.rows.len()
        ));
    };
    let most = Holds::Length.most();
    if length_mm > most {
        return Err(tr!(
            "the path is {length} mm long: allowed is at most {most} mm",
            length = length_mm,
            most = most
        ));
    }
    let mut remarks = Vec::new();
    if !others.is_empty() {
        remarks.push(tr!("Columns that are not used: {names}.", names = others.join(", ")));
    }
    Ok(PartPath {
        stretches: rows,
        length_mm,
        feeds_mm_min: span(feeds.into_iter().filter(|feed| *feed > 0.0)),
        speeds_rpm: span(speeds.into_iter().filter(|speed| *speed > 0.0)),
        remarks,
    })
}
