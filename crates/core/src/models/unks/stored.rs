//! The networks of UNKS as a scenario holds them and as a file keeps them: one JSON object with a
//! version, the start they belong to, and NM-R, NM-1, NM-2 in the format of single network files.
//!
//! A run is a pure function of its scenario, so networks that were learned are a part of the
//! scenario: a setting whose value is this text, some 4 kB. With it they reach file, link, undo
//! and digest like any other setting, and nothing depends on another file being there. What is
//! saved has the nine digits of network files; what learns on is what was saved, to the bit.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::{FILES, SIZES, UnksNetworks, UnksStart};
use crate::base::files::{JsonLayout, from_json, to_json};
use crate::base::language::tr;
use crate::base::network::{Network, NetworkFile, Provenance, ScaledNetwork, parse};
use crate::base::settings::{Editor, Structure, Value};

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
            return Err(tr!(
                "{n} bytes; at most {most} are read",
                n = text.len(),
                most = MAX_BYTES
            ));
        }
        // The version comes first: a file of another version may hold anything.
        let Version { version } = from_json(text)?;
        if version != VERSION {
            return Err(tr!(
                "`version` cannot be {version}: allowed is {known}",
                version = version,
                known = VERSION
            ));
        }
        let file: StoredFile = from_json(text)?;
        let start = UnksStart::from_id(&file.start).ok_or_else(|| {
            let shown: String = file.start.chars().take(40).collect();
            let ids: Vec<&str> = UnksStart::ALL.iter().map(|start| start.id()).collect();
            tr!(
                "`start` cannot be {found}: allowed is one of {ids}",
                found = format!("{shown:?}"),
                ids = ids.join(", ")
            )
        })?;
        let network = |i: usize, fields: NetworkFile| {
            let named = |error: String| format!("{}: {error}", NAMES[i]);
            let (scaled, origin) = fields.network().map_err(named)?;
            let (sizes, allowed) = (scaled.network.sizes(), SIZES[i]);
            if sizes == allowed {
                Ok((scaled, origin))
            } else {
                Err(named(tr!(
                    "`sizes` cannot be {sizes}: allowed is {allowed}",
                    sizes = format!("{sizes:?}"),
                    allowed = format!("{allowed:?}")
                )))
            }
        };
        let (reference, a) = network(0, file.nm_r)?;
        let (forward, b) = network(1, file.nm_1)?;
        let (inverse, c) = network(2, file.nm_2)?;
        let networks = UnksNetworks { reference, forward, inverse };
        Ok(Self::new(start, &networks, [a, b, c]))
    }

    /// The text of the file; reading it gives the same networks to the bit.
    #[must_use]
    pub fn write(&self) -> String {
        to_json(&self.file(), JsonLayout::FieldALine(""))
    }

    /// The same in one line: the value of the setting.
    fn write_line(&self) -> String {
        to_json(&self.file(), JsonLayout::Line)
    }

    fn file(&self) -> StoredFile {
        let UnksNetworks { reference, forward, inverse } = &self.networks;
        let [a, b, c] = &self.origins;
        StoredFile {
            version: VERSION,
            start: self.start.id().to_owned(),
            nm_r: NetworkFile::new(reference, a),
            nm_1: NetworkFile::new(forward, b),
            nm_2: NetworkFile::new(inverse, c),
        }
    }
}

/// The fields of the file, in order.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "three networks")]
struct StoredFile {
    version: u64,
    start: String,
    nm_r: NetworkFile,
    nm_1: NetworkFile,
    nm_2: NetworkFile,
}

/// What every version has.
#[derive(Deserialize)]
#[serde(expecting = "three networks")]
struct Version {
    version: u64,
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

crate::structured!(StoredNetworks);

impl Structure for StoredNetworks {
    const ID: &'static str = "networks";

    fn bounds(_: [f64; 2]) -> Vec<(&'static str, f64)> {
        Vec::new()
    }
    fn allowed(_: [f64; 2], _: &str) -> String {
        tr("nothing, or the text of a file that `steadycut unks --save` writes: finite weights of NM-R \
            2-12-1, NM-1 4-8-1, NM-2 4-8-1")
        .to_owned()
    }
    fn write(&self) -> Value {
        self.get().map_or_else(|| Value::Text(String::new()), Self::value_of)
    }
    fn read(value: &Value, _: [f64; 2]) -> Option<Self> {
        let Value::Text(text) = value else { return None };
        if text.trim().is_empty() {
            Some(Self(None))
        } else {
            Stored::parse(text).ok().map(Self::from)
        }
    }
    fn parse(text: &str) -> Option<Value> {
        Some(Value::Text(text.to_owned()))
    }
    fn fault(value: &Value) -> Option<String> {
        let Value::Text(text) = value else { return None };
        Stored::parse(text).err()
    }
    fn editor(_: [f64; 2]) -> Editor {
        Editor::Presence
    }
    fn example(_: [f64; 2], share: f64, pick: u32) -> Value {
        // Networks of either start with weights of up to a million times their size.
        let start = UnksStart::ALL[pick as usize % UnksStart::ALL.len()];
        let mut networks = UnksNetworks::at_start(start, 1);
        for scaled in [&mut networks.reference, &mut networks.forward, &mut networks.inverse] {
            let old = &scaled.network;
            let weights = old.weights().iter().map(|weight| weight * 1e6 * share).collect();
            scaled.network =
                Network::new(old.sizes(), old.activation(), old.linear_output(), weights)
                    .expect("as many weights as there were");
        }
        let origins = FILES.map(|file| parse(file).expect("shipped networks are tested").1);
        Self::value_of(&Stored::new(start, &networks, origins))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let read = StoredNetworks::read(&setting.write(), [0.0, 0.0]).unwrap();
        assert_eq!((&read, read.get()), (&setting, Some(&stored)));
        // However it is laid out, it is the same setting.
        let laid_out = Value::Text(stored.write());
        assert_eq!(StoredNetworks::read(&laid_out, [0.0, 0.0]), Some(read));
        let none = StoredNetworks::default();
        assert_eq!(StoredNetworks::read(&none.write(), [0.0, 0.0]), Some(none));
    }

    #[test]
    fn faulty_files_are_refused_by_network_and_field() {
        let text = example().write();
        let weight = text.split("\"weights\": [").nth(2).unwrap().split(',').next().unwrap();
        for (from, to, named) in [
            ("\"version\": 1", "\"version\": 2", "`version` cannot be 2: allowed is 1"),
            ("\"shipped\"", "\"warm\"", "`start` cannot be \"warm\": allowed is one of shipped"),
            ("\"nm_r\"", "\"nm_x\"", "unknown field `nm_x`"),
            ("\"start\"", "\"more\": 1, \"start\"", "unknown field `more`"),
            ("\"sizes\": [2,12,1]", "\"sizes\": [2,11,1]", "nm_r: `weights` holds 49"),
            ("\"sizes\": [4,8,1]", "\"sizes\": [2,12,1]", "nm_1: "),
            ("\"xmin\": [", "\"xmin\": [1e400,", "not JSON"),
            (weight, "null", "`nm_1.weights[0]`"),
            (weight, "NaN", "not JSON"),
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
