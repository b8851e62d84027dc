//! Columns of files with groups: names as short as they can be, and times of a group's own.

use std::collections::BTreeMap;

use super::prefix_of;
use crate::assemble::{RawColumn, goes_on, names_time, seconds};
use crate::channel::SampleTimes;

/// Takes off the names of columns what all of them begin with, and gives those of several groups the times that stand in
/// their own: a file has one column of times for all, or one in each group.
pub(super) fn settle(columns: &mut Vec<RawColumn>) {
    let shared = columns.iter().map(|column| prefix_of(&column.name)).reduce(shared_prefix);
    let shared = shared.map_or(0, str::len);
    let mut groups: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for (index, column) in columns.iter_mut().enumerate() {
        column.name.drain(..shared);
        groups.entry(prefix_of(&column.name).to_owned()).or_default().push(index);
    }
    let mut used = Vec::new();
    for (prefix, members) in groups.iter().filter(|(prefix, _)| !prefix.is_empty()) {
        let is_time = |index: &&usize| {
            let column = &columns[**index];
            let unit = column.unit.is_empty() || seconds(&column.unit).is_some();
            names_time(&column.name[prefix.len()..]) && unit && goes_on(column)
        };
        let Some(&time) = members.iter().find(is_time) else { continue };
        let size_s = seconds(&columns[time].unit).unwrap_or(1.0);
        let times_s: Vec<f64> = columns[time].values.iter().map(|time| time * size_s).collect();
        let times = SampleTimes::of(&times_s);
        for &member in members.iter().filter(|member| **member != time) {
            let column = &mut columns[member];
            if column.values.len() == times_s.len() {
                column.times = times.clone();
                used.push(time);
            }
        }
    }
    let mut index = 0..;
    columns.retain(|_| !used.contains(&index.next().unwrap_or(0)));
}

/// What two prefixes have in common, up to a dot.
fn shared_prefix<'a>(a: &'a str, b: &str) -> &'a str {
    let same = a.bytes().zip(b.bytes()).take_while(|(a, b)| a == b).count();
    let dot = a.as_bytes()[..same].iter().rposition(|byte| *byte == b'.');
    &a[..dot.map_or(0, |dot| dot + 1)]
}
