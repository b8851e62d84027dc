//! The networks of UNKS as a scenario holds them and as a file keeps them: one JSON object with a
//! version, the start they belong to, and NM-R, NM-1, NM-2 in the format of single network files.
//!
//! A run is a pure function of its scenario, so networks that were learned are a part of the
//! scenario: a setting whose value is this text, some 4 kB. With it they reach file, link, undo
//! and digest like any other setting, and nothing depends on another file being there. What is
//! saved has the nine digits of network files; what learns on is what was saved, to the bit.

use std::sync::Arc;

use serde_json::{Map, Value as Json};

use super::{SIZES, UnksNetworks, UnksStart};
use crate::base::network::{Provenance, ScaledNetwork, from_map, write_line};
use crate::base::settings::{Field, Kind, Value};

/// Version of the format.
const VERSION: u64 = 1;
/// Longest text read, bytes.
const MAX_BYTES: usize = 60_000;
/// Names of the networks in the file.
const NAMES: [&str; 3] = ["nm_r", "nm_1", "nm_2"];

/// Three networks with where they come from.
#[derive(Clone, Debug, PartialEq)]
pub struct Stored {
    /// The start, and so the law, that they belong to.
    pub start: UnksStart,
    /// The networks, their numbers with the digits of a file.
    pub networks: UnksNetworks,
    /// Where NM-R, NM-1 and NM-2 come from.
    pub origins: [Provenance; 3],
}

impl Stored {
    /// Networks to be kept, rounded to the digits of a file.
    #[must_use]
    pub fn new(start: UnksStart, networks: &UnksNetworks, origins: [Provenance; 3]) -> Self {
        let rounded = |network: &ScaledNetwork| network.clone().as_in_file();
        let networks = UnksNetworks {
            reference: rounded(&networks.reference),
            forward: rounded(&networks.forward),
            inverse: rounded(&networks.inverse),
        };
        Self { start, networks, origins }
    }

    /// Reads a file.
    ///
    /// # Errors
    /// Names the network and the field that is missing, unknown or not allowed, its value and what
    /// is allowed.
    pub fn parse(text: &str) -> Result<Self, String> {
        if text.len() > MAX_BYTES {
            return Err(format!("{} bytes; at most {MAX_BYTES} are read", text.len()));
        }
        let mut map: Map<String, Json> =
            serde_json::from_str(text).map_err(|error| format!("not a JSON object: {error}"))?;
        let shown = |value: &Json| value.to_string().chars().take(40).collect::<String>();
        let mut take = |name: &str| map.remove(name).ok_or_else(|| format!("`{name}` is missing"));
        let version = take("version")?;
        if version.as_u64() != Some(VERSION) {
            return Err(format!("`version` cannot be {}: allowed is {VERSION}", shown(&version)));
        }
        let start = take("start")?;
        let ids: Vec<&str> = UnksStart::ALL.iter().map(|start| start.id()).collect();
        let start = start.as_str().and_then(UnksStart::from_id).ok_or_else(|| {
            format!("`start` cannot be {}: allowed is one of {}", shown(&start), ids.join(", "))
        })?;
        let mut network = |i: usize| match take(NAMES[i])? {
            Json::Object(fields) => {
                let (scaled, origin) =
                    from_map(fields).map_err(|error| format!("{}: {error}", NAMES[i]))?;
                let sizes = scaled.network.sizes();
                if sizes == SIZES[i] {
                    return Ok((scaled, origin));
                }
                let allowed = SIZES[i];
                Err(format!("{}: `sizes` cannot be {sizes:?}: allowed is {allowed:?}", NAMES[i]))
            }
            other => {
                Err(format!("`{}` cannot be {}: allowed is a network", NAMES[i], shown(&other)))
            }
        };
        let [(reference, a), (forward, b), (inverse, c)] = [network(0)?, network(1)?, network(2)?];
        if let Some(unknown) = map.keys().next() {
            let unknown: String = unknown.chars().take(40).collect();
            return Err(format!("`{unknown}` is no field of this file"));
        }
        let networks = UnksNetworks { reference, forward, inverse };
        Ok(Self::new(start, &networks, [a, b, c]))
    }

    /// The text of the file; reading it gives the same networks to the bit.
    #[must_use]
    pub fn write(&self) -> String {
        format!("{{\n{}\n}}\n", self.fields().join(",\n"))
    }

    /// The same in one line: the value of the setting.
    fn write_line(&self) -> String {
        format!("{{{}}}", self.fields().join(","))
    }

    fn fields(&self) -> Vec<String> {
        let UnksNetworks { reference, forward, inverse } = &self.networks;
        let mut fields =
            vec![format!("\"version\": {VERSION}"), format!("\"start\": \"{}\"", self.start.id())];
        let networks = [reference, forward, inverse].into_iter().zip(&self.origins);
        fields.extend(NAMES.iter().zip(networks).map(|(name, (network, origin))| {
            format!("\"{name}\": {}", write_line(network, origin))
        }));
        fields
    }
}

/// The setting: networks to begin with in the place of the shipped or the untrained ones, or none.
/// Shared, so that a scenario is copied quickly.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StoredNetworks(Option<Arc<Stored>>);

impl StoredNetworks {
    /// The networks, if there are any.
    #[must_use]
    pub fn get(&self) -> Option<&Stored> {
        self.0.as_deref()
    }

    /// The value of the setting that holds these networks.
    #[must_use]
    pub fn value_of(stored: &Stored) -> Value {
        Value::Text(stored.write_line())
    }
}

impl From<Stored> for StoredNetworks {
    fn from(stored: Stored) -> Self {
        Self(Some(Arc::new(stored)))
    }
}

impl Field for StoredNetworks {
    fn kind(_: f64, _: f64) -> Kind {
        Kind::Networks
    }
    fn to_value(&self) -> Value {
        self.get().map_or_else(|| Value::Text(String::new()), Self::value_of)
    }
    fn from_value(value: &Value, _: &Kind) -> Option<Self> {
        match value {
            Value::Text(text) if text.trim().is_empty() => Some(Self(None)),
            Value::Text(text) => Stored::parse(text).ok().map(Self::from),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::FILES;
    use super::*;
    use crate::base::network::parse;

    fn example() -> Stored {
        let origin = |i: usize| parse(FILES[i]).unwrap().1;
        let origins = [origin(0), origin(1), origin(2)];
        Stored::new(UnksStart::Shipped, UnksNetworks::shipped(), origins)
    }

    #[test]
    fn file_and_setting_give_the_networks_back_to_the_bit() {
        let stored = example();
        assert_eq!(&stored.networks, UnksNetworks::shipped());
        assert_eq!(Stored::parse(&stored.write()).unwrap(), stored);
        let setting = StoredNetworks::from(stored.clone());
        let read = StoredNetworks::from_value(&setting.to_value(), &Kind::Networks).unwrap();
        assert_eq!((&read, read.get()), (&setting, Some(&stored)));
        // However it is laid out, it is the same setting.
        let laid_out = Value::Text(stored.write());
        assert_eq!(StoredNetworks::from_value(&laid_out, &Kind::Networks), Some(read));
        let none = StoredNetworks::default();
        assert_eq!(StoredNetworks::from_value(&none.to_value(), &Kind::Networks), Some(none));
    }

    #[test]
    fn faulty_files_are_refused_by_network_and_field() {
        let text = example().write();
        let weight = text.split("\"weights\": [").nth(2).unwrap().split(',').next().unwrap();
        for (from, to, named) in [
            ("\"version\": 1", "\"version\": 2", "`version` cannot be 2: allowed is 1"),
            ("\"shipped\"", "\"warm\"", "`start` cannot be \"warm\": allowed is one of shipped"),
            ("\"nm_r\"", "\"nm_x\"", "`nm_r` is missing"),
            ("\"start\"", "\"more\": 1, \"start\"", "`more` is no field"),
            ("\"sizes\": [2,12,1]", "\"sizes\": [2,11,1]", "nm_r: `weights` holds 49"),
            ("\"sizes\": [4,8,1]", "\"sizes\": [2,12,1]", "nm_1: "),
            ("\"xmin\": [", "\"xmin\": [1e400,", "not a JSON object"),
            (weight, "null", "nm_1: `weights`"),
            (weight, "NaN", "not a JSON object"),
        ] {
            let broken = text.replacen(from, to, 1);
            assert_ne!(broken, text, "{from}");
            let error = Stored::parse(&broken).unwrap_err();
            assert!(error.contains(named), "{from} -> {to}: {error}");
        }
        let [r, ..] = FILES;
        let r = r.replace('\n', " ");
        let swapped =
            format!("{{\"version\":1,\"start\":\"cold\",\"nm_r\":{r},\"nm_1\":{r},\"nm_2\":{r}}}");
        let error = Stored::parse(&swapped).unwrap_err();
        assert!(
            error.contains("nm_1: `sizes` cannot be [2, 12, 1]: allowed is [4, 8, 1]"),
            "{error}"
        );
        assert!(Stored::parse(&"x".repeat(MAX_BYTES + 1)).unwrap_err().contains("bytes"));
    }
}
