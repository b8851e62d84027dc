//! TDMS: the channels of LabVIEW's files, each with its own sample rate and unit.

mod segments;

use crate::assemble::RawColumn;
use crate::base::language::tr;
use crate::channel::SampleTimes;
use crate::fault::{DataFault, FaultPlace, shown};
use crate::layout::DataLayout;
use crate::reader::{DataEntry, RawData};
use segments::{Property, TdmsObject, objects};

/// Most facts that are kept.
const MAX_FACTS: usize = 200;

/// Reads a file, or the group or channel (`group/channel`) that the layout's `variable` names.
pub(crate) fn read(bytes: &[u8], layout: &mut DataLayout) -> Result<RawData, DataFault> {
    let objects = objects(bytes)?;
    let mut raw = RawData::default();
    let channels: Vec<&TdmsObject> =
        objects.iter().filter(|object| object.path.len() >= 2).collect();
    let groups: Vec<&str> = channels.iter().map(|channel| channel.path[0].as_str()).collect();
    let one_group = groups.windows(2).all(|pair| pair[0] == pair[1]);
    for object in &objects {
        let prefix = object.path.join("/");
        let is_channel = object.path.len() >= 2;
        if is_channel {
            let about = match object.unread {
                "" => tr!("{count} numbers", count = object.values.len()),
                unread => tr(unread).to_owned(),
            };
            raw.entries.push(DataEntry { name: prefix, about });
            continue;
        }
        for (name, value) in &object.properties {
            let name = if prefix.is_empty() { name.clone() } else { format!("{prefix}/{name}") };
            let value = match value {
                Property::Number(x) => x.to_string(),
                Property::Text(text) => text.clone(),
            };
            raw.facts.push((name, value));
        }
    }
    raw.facts.truncate(MAX_FACTS);
    let chosen = |channel: &&TdmsObject| match &layout.variable {
        None => true,
        Some(variable) => *variable == channel.path[0] || *variable == channel.path.join("/"),
    };
    for channel in channels.iter().filter(|channel| chosen(channel)) {
        let name = if one_group { channel.path[1..].join("/") } else { channel.path.join("/") };
        if !channel.unread.is_empty() {
            let about = tr(channel.unread);
            raw.notes.push(tr!("`{name}` was left out: {about}", name = name, about = about));
        } else if !channel.values.is_empty() {
            let column = column(channel, name, &mut raw.notes);
            raw.columns.push(column);
        }
    }
    match (&layout.variable, raw.columns.is_empty()) {
        (Some(variable), true) => {
            let names: Vec<&str> =
                raw.entries.iter().map(|entry| entry.name.as_str()).take(20).collect();
            let found = tr!("there is no {name} with numbers", name = shown(variable));
            let expected = tr!("a group, or one of {names}", names = names.join(", "));
            Err(DataFault::new(FaultPlace::Entry(variable.clone()), found, expected))
        }
        (Some(_) | None, _) => Ok(raw),
    }
}

/// A channel with the unit, times and scale that its properties tell.
fn column(channel: &TdmsObject, name: String, notes: &mut Vec<String>) -> RawColumn {
    let number = |name: &str| match channel.properties.get(name) {
        Some(Property::Number(x)) if x.is_finite() => Some(*x),
        Some(Property::Number(_) | Property::Text(_)) | None => None,
    };
    let text = |name: &str| match channel.properties.get(name) {
        Some(Property::Text(text)) => Some(text.clone()),
        Some(Property::Number(_)) | None => None,
    };
    let mut values = channel.values.clone();
    let mut unit = text("unit_string").unwrap_or_default();
    if channel.is_time {
        // Points of time: since the first.
        let first_s = values.first().copied().unwrap_or(0.0);
        values.iter_mut().for_each(|time_s| *time_s -= first_s);
        "s".clone_into(&mut unit);
    }
    // Scales of LabVIEW, one behind the other.
    let scales = number("NI_Number_Of_Scales").unwrap_or(0.0).clamp(0.0, 100.0) as usize;
    let scaled = text("NI_Scaling_Status").is_none_or(|status| status == "unscaled");
    for scale in (0..scales).filter(|_| scaled) {
        let of = |what: &str| format!("NI_Scale[{scale}]_{what}");
        let coefficients: Vec<f64> = match text(&of("Scale_Type")).as_deref() {
            Some("Linear") => ["Linear_Y_Intercept", "Linear_Slope"]
                .iter()
                .map(|what| number(&of(what)).unwrap_or(0.0))
                .collect(),
            Some("Polynomial") => {
                let size = number(&of("Polynomial_Coefficients_Size"))
                    .unwrap_or(4.0)
                    .clamp(0.0, 100.0) as usize;
                let one = |i| number(&of(&format!("Polynomial_Coefficients[{i}]"))).unwrap_or(0.0);
                (0..size).map(one).collect()
            }
            Some(other) => {
                notes.push(tr!(
                    "`{name}` has the scale {scale}, which is not applied",
                    name = name,
                    scale = other
                ));
                continue;
            }
            // An entry that is given up.
            None => continue,
        };
        let polynomial = |x: f64| coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c);
        values.iter_mut().for_each(|x| *x = polynomial(*x));
    }
    let step_s = number("wf_increment").filter(|step| *step > 0.0);
    let times = step_s.map_or(SampleTimes::Unknown, |step_s| {
        let rate_hz = SampleTimes::of(&[0.0, step_s]).rate_hz().unwrap_or(1.0 / step_s);
        SampleTimes::Even { rate_hz, first_s: number("wf_start_offset").unwrap_or(0.0) }
    });
    RawColumn { name, unit, values, times, named: true }
}
