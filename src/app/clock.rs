//! The clock of the console: how long work takes, so that a frame's share of it stays small.

/// Time since some moment in s.
#[cfg(not(target_arch = "wasm32"))]
#[expect(clippy::disallowed_methods, reason = "the front end has a clock")]
pub fn now_s() -> f64 {
    use std::sync::LazyLock;
    use std::time::Instant;
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    START.elapsed().as_secs_f64()
}

/// Time since some moment in s. Without the page's clock it is the time of day, which may be set.
#[cfg(target_arch = "wasm32")]
pub fn now_s() -> f64 {
    let performance = web_sys::window().and_then(|window| window.performance());
    1e-3 * performance.map_or_else(js_sys::Date::now, |performance| performance.now())
}

/// The time of day in UTC, ISO 8601 to the second.
#[must_use]
pub fn utc() -> String {
    iso(unix_s())
}

/// Seconds since the beginning of 1970; 0 where the clock stands before.
#[cfg(not(target_arch = "wasm32"))]
#[expect(clippy::disallowed_methods, reason = "the front end has a clock")]
fn unix_s() -> u64 {
    use std::time::{SystemTime, UNIX_EPOCH};
    SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs())
}

/// See the native one.
#[cfg(target_arch = "wasm32")]
fn unix_s() -> u64 {
    (1e-3 * js_sys::Date::now()).max(0.0) as u64
}

/// Seconds since the beginning of 1970 as a date and time, by the calendar that has a leap year in four, but for 3 of
/// 4 centuries.
fn iso(unix_s: u64) -> String {
    let (days, second) = (unix_s / 86_400, unix_s % 86_400);
    let leap = |year: u64| {
        year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400))
    };
    let (mut year, mut day) = (1970, days);
    while day >= 365 + u64::from(leap(year)) {
        day -= 365 + u64::from(leap(year));
        year += 1;
    }
    let february = 28 + u64::from(leap(year));
    let mut month = 1;
    for length in [31, february, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31] {
        if day < length {
            break;
        }
        day -= length;
        month += 1;
    }
    let (hour, minute) = (second / 3600, second / 60 % 60);
    format!("{year}-{month:02}-{:02}T{hour:02}:{minute:02}:{:02}Z", day + 1, second % 60)
}

#[cfg(test)]
mod tests {
    use super::iso;

    #[test]
    fn times_are_written_as_dates() {
        for (unix_s, written) in [
            (0, "1970-01-01T00:00:00Z"),
            (951_782_399, "2000-02-28T23:59:59Z"),
            (951_782_400, "2000-02-29T00:00:00Z"),
            (1_709_251_199, "2024-02-29T23:59:59Z"),
            (1_798_761_599, "2026-12-31T23:59:59Z"),
            (4_107_542_400, "2100-03-01T00:00:00Z"),
        ] {
            assert_eq!(iso(unix_s), written);
        }
    }
}
