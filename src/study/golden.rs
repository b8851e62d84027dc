//! Golden values: per shipped preset the number of ticks, the digest and a handful of metrics. The
//! same JSON comes from native builds and from wasm, so a difference anywhere shows.

use serde_json::{Map, Value, json};

use crate::base::model::feed_drive::{ExactDrive, FeedDriveKind};
use crate::run::digest::Digest;
use crate::run::edits::Edits;
use crate::run::one_run::Run;
use crate::run::presets::{PRESETS, load};

/// Golden values of all presets, by name.
///
/// # Panics
/// Never: a test loads every shipped preset.
#[must_use]
pub fn golden() -> Map<String, Value> {
    let mut all = Map::new();
    for preset in PRESETS {
        let scenario = load(preset.name).expect("presets are tested");
        let run = Run::complete(&scenario, &Edits::none());
        let m = run.metrics();
        let entry = json!({
            "ticks": run.ticks(),
            "digest": run.recording().digest(),
            "drive_coefficients": drive_coefficients(scenario.dt_s()),
            "ra_final_um": rounded(m.ra_final_um),
            "force_final_n": rounded(m.force_final_n),
            "feed_final_mm_min": rounded(m.feed_final_mm_min),
            "in_tolerance_percent": rounded(m.in_tolerance_percent),
        });
        all.insert(preset.name.to_owned(), entry);
    }
    all
}

/// Digest over the coefficients of every drive, discretised for `dt_s`: the matrix exponential
/// comes from a library, which must give the same bits everywhere too.
fn drive_coefficients(dt_s: f64) -> String {
    let mut digest = Digest::default();
    for kind in FeedDriveKind::ALL {
        for word in ExactDrive::new(*kind, dt_s).coefficient_bits() {
            digest.word(word);
        }
    }
    digest.hex()
}

/// Six decimals: enough to read; the digest holds the bits.
fn rounded(x: f64) -> f64 {
    (x * 1e6).round() / 1e6
}

/// The text of `tests/golden.json`.
#[must_use]
pub fn to_json() -> String {
    let mut text = format!("{:#}", Value::Object(golden()));
    text.push('\n');
    text
}
