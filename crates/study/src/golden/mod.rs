//! Golden values: per shipped preset the number of ticks, the digest and a handful of metrics; per
//! base preset the digests of its variants too. The same JSON comes from native builds of every
//! optimisation and from wasm, so a difference anywhere shows.

mod switches;
mod variants;

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};

use crate::run::edits::Edits;
use crate::run::one_run::Run;
use crate::run::presets::{PRESETS, load};
pub use switches::{named, values};
pub use variants::BASES;

/// Golden values of all presets, by name.
///
/// # Panics
/// Never: a test loads every shipped preset.
#[must_use]
pub fn golden() -> Map<String, Value> {
    let (mut all, mut held) = (Map::new(), BTreeMap::new());
    for preset in PRESETS {
        let scenario = load(preset.name).expect("presets are tested");
        let run = Run::complete(&scenario, &Edits::none());
        let m = run.metrics();
        let mut entry = json!({
            "ticks": run.ticks(),
            "digest": run.recording().digest(),
            "ra_final_um": m.ra_final_um.map(rounded),
            "force_final_n": m.force_final_n.map(rounded),
            "feed_final_mm_min": rounded(m.feed_final_mm_min),
            "in_tolerance_percent": m.in_tolerance_percent.map(rounded),
        });
        if BASES.contains(&preset.name) {
            entry["variants"] = Value::Object(variants::variants(&scenario, &mut held));
        }
        all.insert(preset.name.to_owned(), entry);
    }
    all
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
