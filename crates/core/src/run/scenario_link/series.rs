//! Many edits of one number, as a drag leaves them, in few characters: `series.target.ra_um=2:998,25,25:3:850,-12,5`
//! stands for edits at 9.98, 10.23 and 10.48 s with the values 0.850, 0.838 and 0.843. Of the times and of the
//! values there stand the number of decimals, the first one, and by how much each of the others differs from the
//! one before, all of them as whole numbers of the last decimal.

use super::super::edits::Edit;
use crate::base::language::tr;
use crate::base::settings::Value;

/// What the key of a series begins with; the setting's path follows.
pub(super) const KEY: &str = "series.";
/// Fewer edits than these are as short one by one.
const LEAST: usize = 4;
/// Most decimals that are tried, and read.
const MOST_DECIMALS: u32 = 9;
/// Largest whole number that takes part: all up to it are exact as `f64`.
const LARGEST: f64 = 9e15;

/// The edits at the front of `edits` that are one series, as key and value, and how many they are; `None` where
/// they are better written one by one.
pub(super) fn write(edits: &[Edit]) -> Option<(String, String, usize)> {
    let path = &edits.first()?.path;
    let floats =
        edits.iter().take_while(|edit| edit.path == *path).map_while(|edit| match edit.value {
            Value::Float(value) => Some([edit.at_s, value]),
            Value::Int(_) | Value::Bool(_) | Value::Text(_) | Value::List(_) => None,
        });
    let points: Vec<[f64; 2]> = floats.collect();
    if points.len() < LEAST {
        return None;
    }
    let column = |i: usize| differences(&points.iter().map(|point| point[i]).collect::<Vec<_>>());
    let value = format!("{}:{}", column(0)?, column(1)?);
    Some((format!("{KEY}{path}"), value, points.len()))
}

/// Decimals, the first number, and the steps from each to the next; `None` for numbers with more decimals than
/// are written, or that do not come back to the bit.
fn differences(numbers: &[f64]) -> Option<String> {
    let whole = |decimals: u32| -> Option<Vec<i64>> {
        let each = numbers.iter().map(|number| {
            let scaled = (number * power_of_ten(decimals)).round();
            let whole = (scaled.abs() <= LARGEST).then_some(scaled as i64)?;
            let read = whole as f64 / power_of_ten(decimals);
            (read.to_bits() == number.to_bits()).then_some(whole)
        });
        each.collect()
    };
    let (decimals, numbers) = (0..=MOST_DECIMALS).find_map(|d| whole(d).map(|all| (d, all)))?;
    let first = numbers.first()?.to_string();
    let steps = numbers.windows(2).map(|pair| (pair[1] - pair[0]).to_string());
    let all: Vec<String> = std::iter::once(first).chain(steps).collect();
    Some(format!("{decimals}:{}", all.join(",")))
}

fn power_of_ten(decimals: u32) -> f64 {
    10_u64.pow(decimals) as f64
}

/// The edits of a series on the setting at `path`.
///
/// # Errors
/// What is wrong with it, in words.
pub(super) fn read(path: &str, text: &str) -> Result<Vec<Edit>, String> {
    let parts: Vec<&str> = text.split(':').collect();
    let [time_decimals, times, value_decimals, values] = parts[..] else {
        return Err(tr!(
            "the series of `{path}` has {n} parts, not 4",
            path = path,
            n = parts.len()
        ));
    };
    let times = numbers(path, time_decimals, times)?;
    let values = numbers(path, value_decimals, values)?;
    if times.len() != values.len() {
        let [times, values] = [times.len(), values.len()];
        return Err(tr!(
            "the series of `{path}` has {times} times and {values} values",
            path = path,
            times = times,
            values = values
        ));
    }
    let edit = |(at_s, value)| Edit { at_s, path: path.to_owned(), value: Value::Float(value) };
    Ok(times.into_iter().zip(values).map(edit).collect())
}

fn numbers(path: &str, decimals: &str, steps: &str) -> Result<Vec<f64>, String> {
    let decimals: u32 = match decimals.parse() {
        Ok(decimals) if decimals <= MOST_DECIMALS => decimals,
        _ => {
            return Err(tr!(
                "the series of `{path}` has `{decimals}` decimals; allowed are 0 to {most}",
                path = path,
                decimals = decimals,
                most = MOST_DECIMALS
            ));
        }
    };
    let mut sum = 0_i64;
    let each = steps.split(',').map(|step| {
        let added = step.parse().ok().and_then(|step: i64| sum.checked_add(step));
        sum = added.filter(|sum| (sum.unsigned_abs() as f64) <= LARGEST).ok_or_else(|| {
            tr!(
                "the series of `{path}` has `{step}` where a whole number must stand",
                path = path,
                step = step
            )
        })?;
        Ok(sum as f64 / power_of_ten(decimals))
    });
    each.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edits(points: &[[f64; 2]]) -> Vec<Edit> {
        let edit = |[at_s, value]: &[f64; 2]| {
            let (path, value) = ("target.ra_um".to_owned(), Value::Float(*value));
            Edit { at_s: *at_s, path, value }
        };
        points.iter().map(edit).collect()
    }

    #[test]
    fn the_example_of_the_head_is_written_and_read() {
        let series = edits(&[[9.98, 0.85], [10.23, 0.838], [10.48, 0.843], [10.6, 0.843]]);
        let (key, value, count) = write(&series).unwrap();
        assert_eq!((key.as_str(), count), ("series.target.ra_um", 4));
        assert_eq!(value, "2:998,25,25,12:3:850,-12,5,0");
        assert_eq!(read("target.ra_um", &value), Ok(series));
    }

    #[test]
    fn what_does_not_come_back_to_the_bit_is_no_series() {
        let third = 1.0 / 3.0;
        assert_eq!(write(&edits(&[[1.0, third]; 9])), None);
        assert_eq!(write(&edits(&[[1.0, -0.0]; 9])), None);
        assert_eq!(write(&edits(&[[1.0, 1e18]; 9])), None);
        assert_eq!(write(&edits(&[[1.0, 0.5]; 3])), None);
    }

    #[test]
    fn a_broken_series_is_refused_in_words() {
        for (text, told) in [
            ("2:998", "2 parts, not 4"),
            ("2:998:3:850:1", "5 parts"),
            ("77:998:3:850", "`77` decimals; allowed are 0 to 9"),
            ("2:998,25:3:850", "2 times and 1 values"),
            ("2:9.5:3:850", "`9.5` where a whole number"),
            ("2:9223372036854775807,9223372036854775807:3:1,1", "whole number"),
        ] {
            let error = read("target.ra_um", text).unwrap_err();
            assert!(error.contains(told) && error.contains("target.ra_um"), "{error}");
        }
    }
}
