//! Units that a measured channel may have where it is laid over a signal of the run, and over which one it is first.

pub use crate::study::channel_unit::{place_of, units};

/// Signals of the run that a channel is laid over, those that are asked for most first.
pub const SIGNALS_OVER: [&str; 9] = [
    "force_n",
    "force_dyn_n",
    "force_measured_n",
    "ra_um",
    "ra_dyn_um",
    "feed_mm_min",
    "spindle_rpm",
    "feed_override_percent",
    "axial_depth_mm",
];

/// Beginnings of words in the names of channels, by the signal that they speak of.
const NAMES: [(&str, &[&str]); 5] = [
    ("feed_mm_min", &["feed", "vorschub", "podaj", "vf"]),
    ("spindle_rpm", &["spindle", "speed", "dreh", "vrti", "rpm"]),
    ("ra_um", &["ra", "rough", "rau", "hrap"]),
    ("axial_depth_mm", &["depth", "tiefe", "schnitttiefe", "globin", "ap"]),
    ("force_n", &["f", "force", "kraft", "sila"]),
];

/// The signal that a channel with this name and unit is most likely one of.
#[must_use]
pub fn likely_signal(
    name: &str,
    unit: &str,
    unit_of: impl Fn(&str) -> &'static str,
) -> &'static str {
    let by_unit = SIGNALS_OVER.into_iter().find(|id| place_of(unit, unit_of(id)) == Some(0));
    let name = name.to_lowercase();
    let by_name =
        || NAMES.iter().find(|(_, words)| words.iter().any(|word| name.starts_with(word)));
    by_unit.or_else(|| by_name().map(|(id, _)| *id)).unwrap_or(SIGNALS_OVER[0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::signals::signal;

    fn unit_of(id: &str) -> &'static str {
        signal(id).unwrap().unit
    }

    #[test]
    fn a_channel_is_laid_over_what_its_unit_and_name_say() {
        for (name, unit, id) in [
            ("Fx", "N", "force_n"),
            ("Fx", "kN", "force_n"),
            ("peak", "V", "force_n"),
            ("Vorschub", "", "feed_mm_min"),
            ("n", "rpm", "spindle_rpm"),
            ("Ra", "µm", "ra_um"),
            ("ap", "mm", "axial_depth_mm"),
        ] {
            assert_eq!(likely_signal(name, unit, unit_of), id, "{name} {unit}");
        }
    }

    #[test]
    fn every_signal_has_its_own_unit_first() {
        for id in SIGNALS_OVER {
            assert_eq!(place_of(unit_of(id), unit_of(id)), Some(0), "{id}");
            assert_eq!(units(unit_of(id))[0].size, 1.0);
        }
        assert_eq!(place_of("KN", "N").map(|i| units("N")[i].size), Some(1000.0));
        assert_eq!(place_of("V", "N"), None);
    }
}
