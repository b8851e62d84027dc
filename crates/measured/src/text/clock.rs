//! Times of day and dates as data loggers write them: `14:32:10,5`, `2024-03-01 14:32:10.5`, `01.03.2024 14:32:10`.

/// Days from 1970-01-01 of a date of the Gregorian calendar (H. Hinnant, days_from_civil).
fn days([year, month, day]: [i64; 3]) -> i64 {
    let year = if month <= 2 { year - 1 } else { year };
    let era = year.div_euclid(400);
    let of_era = year - era * 400;
    let of_year = (153 * ((month + 9) % 12) + 2) / 5 + day - 1;
    era * 146_097 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719_468
}

/// Three whole numbers of at most four digits between separators.
fn three(text: &str, separator: char) -> Option<[i64; 3]> {
    let mut parts = text.split(separator);
    let mut next = || {
        let part = parts.next()?;
        let digits =
            (1..=4).contains(&part.len()) && part.bytes().all(|byte| byte.is_ascii_digit());
        part.parse::<i64>().ok().filter(|_| digits)
    };
    let found = [next()?, next()?, next()?];
    parts.next().is_none().then_some(found)
}

/// Days of a date: year, month, day by `-` or `/`, day, month, year by points.
fn date(text: &str) -> Option<i64> {
    let by = |separator: char| three(text, separator);
    let found = match by('-').or_else(|| by('/')) {
        Some(found) => found,
        None => {
            let [day, month, year] = by('.')?;
            [year, month, day]
        }
    };
    let [year, month, day] = found;
    let sound = year >= 1000 && (1..=12).contains(&month) && (1..=31).contains(&day);
    sound.then(|| days(found))
}

/// Seconds of a time of day.
fn of_day(text: &str) -> Option<f64> {
    let text = text.strip_suffix('Z').unwrap_or(text);
    let (whole, part) = match text.find(['.', ',']) {
        Some(at) => (&text[..at], &text[at + 1..]),
        None => (text, ""),
    };
    let [hours, minutes, seconds] = three(whole, ':')?;
    let sound = hours < 24
        && minutes < 60
        && seconds < 61
        && part.bytes().all(|byte| byte.is_ascii_digit());
    let part: f64 = if part.is_empty() { 0.0 } else { format!("0.{part}").parse().ok()? };
    sound.then(|| (hours * 3600 + minutes * 60 + seconds) as f64 + part)
}

/// Seconds of a date, a time of day, or both: from 1970, or from midnight.
pub(super) fn clock(cell: &str) -> Option<f64> {
    if let Some(seconds) = of_day(cell) {
        return Some(seconds);
    }
    if let Some(days) = date(cell) {
        return Some(days as f64 * 86_400.0);
    }
    let (day, time) = cell.split_once([' ', 'T'])?;
    Some(date(day)? as f64 * 86_400.0 + of_day(time.trim())?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_and_times_are_seconds() {
        for (cell, seconds) in [
            ("00:00:00", 0.0),
            ("14:32:10,5", 52_330.5),
            ("1970-01-02", 86_400.0),
            ("2024-03-01 12:00:00.25", 1_709_294_400.25),
            ("2024-03-01T12:00:00Z", 1_709_294_400.0),
            ("01.03.2024 12:00:00", 1_709_294_400.0),
            ("2000/02/29", 951_782_400.0),
        ] {
            assert_eq!(clock(cell), Some(seconds), "{cell}");
        }
        for cell in [
            "",
            "12",
            "12:00",
            "25:00:00",
            "1.2.3",
            "2024-13-01",
            "12:00:00.x",
            "ok",
            "1:2:3:4",
            "-1:00:00",
        ] {
            assert_eq!(clock(cell), None, "{cell}");
        }
    }
}
