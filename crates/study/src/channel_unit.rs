//! Units that a measured channel may have for a quantity of the program: one of each in the program's own.

/// A unit of a channel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChannelUnit {
    /// Its names, the first as the tables write it.
    pub names: &'static [&'static str],
    /// One of it in the program's unit.
    pub size: f64,
}

const fn unit(names: &'static [&'static str], size: f64) -> ChannelUnit {
    ChannelUnit { names, size }
}

const FORCES: &[ChannelUnit] = &[unit(&["N"], 1.0), unit(&["kN"], 1e3)];
const ROUGHNESSES: &[ChannelUnit] = &[unit(&["um"], 1.0), unit(&["nm"], 1e-3), unit(&["mm"], 1e3)];
const FEEDS: &[ChannelUnit] =
    &[unit(&["mm/min"], 1.0), unit(&["mm/s"], 60.0), unit(&["m/min"], 1e3)];
const SPEEDS: &[ChannelUnit] =
    &[unit(&["1/min", "rpm", "min-1", "U/min", "/min"], 1.0), unit(&["1/s", "Hz"], 60.0)];
const DEPTHS: &[ChannelUnit] = &[unit(&["mm"], 1.0), unit(&["um"], 1e-3), unit(&["m"], 1e3)];
const SHARES: &[ChannelUnit] = &[unit(&["%"], 1.0), unit(&["-"], 100.0)];
const CUTTING_SPEEDS: &[ChannelUnit] = &[unit(&["m/min"], 1.0), unit(&["m/s"], 60.0)];
const MINUTES: &[ChannelUnit] =
    &[unit(&["min"], 1.0), unit(&["s", "sec"], 1.0 / 60.0), unit(&["h"], 60.0)];
const FREQUENCIES: &[ChannelUnit] = &[unit(&["Hz", "1/s"], 1.0), unit(&["kHz"], 1e3)];
const COMPLIANCES: &[ChannelUnit] =
    &[unit(&["m/N"], 1.0), unit(&["um/N"], 1e-6), unit(&["mm/N"], 1e-3)];
const ANGLES: &[ChannelUnit] =
    &[unit(&["deg", "°"], 1.0), unit(&["rad"], 180.0 / std::f64::consts::PI)];

/// The units of channels of a quantity that the program has in this unit, its own first; none where no other is known.
#[must_use]
pub fn units(own: &str) -> &'static [ChannelUnit] {
    match own {
        "N" => FORCES,
        "um" => ROUGHNESSES,
        "mm/min" => FEEDS,
        "1/min" => SPEEDS,
        "mm" => DEPTHS,
        "%" => SHARES,
        "m/min" => CUTTING_SPEEDS,
        "min" => MINUTES,
        "Hz" => FREQUENCIES,
        "m/N" => COMPLIANCES,
        "deg" => ANGLES,
        _ => &[],
    }
}

/// The place of a file's unit among those of a quantity; none where it is not one of them.
#[must_use]
pub fn place_of(file_unit: &str, own: &str) -> Option<usize> {
    let plain = file_unit.trim().replace(['µ', 'μ'], "u");
    let is = |unit: &ChannelUnit| unit.names.iter().any(|name| name.eq_ignore_ascii_case(&plain));
    units(own).iter().position(is)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_quantity_has_its_own_unit_first_and_no_two_units_of_one_name() {
        for own in ["N", "um", "mm/min", "1/min", "mm", "%", "m/min", "min", "Hz", "m/N", "deg"] {
            assert_eq!(place_of(own, own), Some(0), "{own}");
            assert_eq!(units(own)[0].size, 1.0, "{own}");
            for (place, unit) in units(own).iter().enumerate() {
                for name in unit.names {
                    assert_eq!(place_of(name, own), Some(place), "{own}: {name}");
                }
            }
        }
        assert_eq!(place_of("KN", "N").map(|i| units("N")[i].size), Some(1000.0));
        assert_eq!(place_of("µm/N", "m/N").map(|i| units("m/N")[i].size), Some(1e-6));
        assert_eq!(place_of("V", "N"), None);
        assert!(units("V").is_empty());
    }
}
