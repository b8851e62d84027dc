//! Conversions between units; names read so that units cancel. Nothing else converts.

/// Feed in mm/s from feed in mm/min.
#[must_use]
pub fn mm_s_from_mm_min(feed_mm_min: f64) -> f64 {
    feed_mm_min / 60.0
}

/// Turns per second from spindle speed in 1/min.
#[must_use]
pub fn rev_s_from_rpm(speed_rpm: f64) -> f64 {
    speed_rpm / 60.0
}

/// Seconds from milliseconds.
#[must_use]
pub fn s_from_ms(time_ms: f64) -> f64 {
    time_ms / 1000.0
}

/// Milliseconds from seconds.
#[must_use]
#[inline]
pub fn ms_from_s(time_s: f64) -> f64 {
    time_s * 1000.0
}

/// Millimetres from micrometres.
#[must_use]
pub fn mm_from_um(length_um: f64) -> f64 {
    length_um / 1000.0
}

/// A ratio from percent.
#[must_use]
pub fn ratio_from_percent(percent: f64) -> f64 {
    percent / 100.0
}

/// Percent from a ratio.
#[must_use]
pub fn percent_from_ratio(ratio: f64) -> f64 {
    ratio * 100.0
}

/// Cubic centimetres from cubic millimetres.
#[must_use]
pub fn cm3_from_mm3(volume_mm3: f64) -> f64 {
    volume_mm3 / 1000.0
}

/// Seconds from minutes.
#[must_use]
pub fn s_from_min(time_min: f64) -> f64 {
    time_min * 60.0
}

/// Minutes from seconds.
#[must_use]
pub fn min_from_s(s: f64) -> f64 {
    s / 60.0
}
