//! The groups and arrays of a file as values in each other, with what their attributes say of them.

use super::attributes::{Attributes, as_number, as_text};
use super::chunks;
use super::datatype::Datatype;
use super::decode::{DimensionOrder, ElementBytes, value};
use super::file::{Hdf5File, Trouble};
use super::header::{DATATYPE, Header};
use super::layout::Stored;
use super::links::{is_group, members};
use crate::base::language::text;
use crate::contents::{ContentEntry, ContentValue, rate_hz};

/// How deep groups may lie in each other.
pub(super) const MAX_DEPTH: usize = 32;
/// Longest text of an attribute that is kept as a fact, characters.
const MAX_FACT: usize = 200;

/// Names of attributes with units, with lists of channels' names, and with the time from sample to sample, in small
/// letters without `_`.
const UNITS: [&str; 4] = ["unit", "units", "unitstring", "unitsymbol"];
const NAMES: [&str; 5] = ["name", "label", "channel", "column", "signal"];
const STEP: &str = "wfincrement";
/// Attributes that programs write for themselves.
const OWN: [&str; 8] =
    ["CLASS", "VERSION", "TITLE", "NROWS", "NAME", "DIMENSION_LIST", "REFERENCE_LIST", "EXTDIM"];
const OWN_BEGINS: [&str; 5] = ["PYTABLES", "FIELD_", "MATLAB_", "_Netcdf4", "_NCProperties"];
/// What netCDF writes as the name of a dimension that has no values.
const NO_VALUES: &str = "This is a netCDF dimension but not a netCDF variable";

/// Goes through a file.
struct Walk<'a, 'f> {
    file: &'f Hdf5File<'a>,
    /// Addresses of the groups that are being read: a link to one of them leads in a circle.
    within: Vec<u64>,
}

/// Members of a group with their names.
type Named = Vec<(String, ContentValue)>;

/// All that a file holds.
pub(super) fn contents(file: &Hdf5File<'_>) -> Result<Vec<ContentEntry>, Trouble> {
    let mut walk = Walk { file, within: vec![file.root] };
    let header = Header::read(file, file.root)?;
    let attributes = Attributes::of(file, &header)?;
    let mut named = walk.group(&header, None)?;
    facts(&attributes, "", true, &mut named);
    Ok(named.into_iter().map(|(name, value)| ContentEntry { name, value }).collect())
}

impl<'a> Walk<'a, '_> {
    /// The members of a group; `rate` is the sample rate in Hz that groups around it tell.
    fn group(&mut self, header: &Header<'a>, rate: Option<f64>) -> Result<Named, Trouble> {
        let mut named = Named::new();
        let members = members(self.file, header)?;
        for member in &members {
            // What PyTables keeps to find rows of a table beside it.
            let of = member.name.strip_prefix("_i_");
            if of.is_some_and(|table| members.iter().any(|other| other.name == table)) {
                continue;
            }
            // A link by a name: what it leads to is read where it is.
            let Some(address) = member.address.filter(|address| !self.within.contains(address))
            else {
                continue;
            };
            if self.within.len() > MAX_DEPTH {
                let what = text!("groups too deep in each other");
                named.push((member.name.clone(), ContentValue::Other(what)));
                continue;
            }
            self.within.push(address);
            let found = self.object(address, &member.name, rate, &mut named);
            self.within.pop();
            match found {
                Ok(()) => {}
                Err(Trouble::Unread(what)) => {
                    named.push((member.name.clone(), ContentValue::Other(what)))
                }
                Err(fault) => return Err(fault),
            }
        }
        pandas(&mut named);
        Ok(named)
    }

    /// Adds an object, with what its attributes say.
    fn object(
        &mut self,
        address: u64,
        name: &str,
        rate: Option<f64>,
        named: &mut Named,
    ) -> Result<(), Trouble> {
        let header = Header::read(self.file, address)?;
        let attributes = Attributes::of(self.file, &header)?;
        let rate = told_rate(&attributes).or(rate);
        if let Some(stored) = Stored::of(self.file, &header)? {
            if attributes.text("NAME").is_some_and(|name| name.starts_with(NO_VALUES)) {
                return Ok(());
            }
            let mut found = array(self.file, &header, &stored, DimensionOrder::File)?;
            tell(&mut found, &attributes, rate);
            named.push((name.to_owned(), found));
            facts(&attributes, &format!("{name}."), false, named);
        } else if is_group(&header) {
            let mut members = self.group(&header, rate)?;
            facts(&attributes, "", false, &mut members);
            let (fields, record) = members.into_iter().unzip();
            named.push((name.to_owned(), ContentValue::Records { fields, records: vec![record] }));
        }
        Ok(())
    }
}

/// The value of an array.
pub(super) fn array<'a>(
    file: &Hdf5File<'a>,
    header: &Header<'a>,
    stored: &Stored<'a>,
    order: DimensionOrder,
) -> Result<ContentValue, Trouble> {
    let Some(message) = header.one(DATATYPE) else {
        return Err(Trouble::Unread(text!("an array without a type")));
    };
    let of = Datatype::of(file, message)?;
    let bytes = chunks::bytes(file, stored, of.size)?;
    value(file, &of, &stored.space.dims, ElementBytes::dense(&bytes, of.size), order)
}

/// A name of an attribute without what programs write in different ways.
fn bare(name: &str) -> String {
    name.to_lowercase().replace(['_', ' '], "")
}

/// The sample rate in Hz that attributes tell.
fn told_rate(attributes: &Attributes) -> Option<f64> {
    attributes.0.iter().find_map(|(name, value)| {
        let number = as_number(value)?;
        match bare(name) == STEP && number > 0.0 {
            true => Some(1.0 / number),
            false => rate_hz(name, number),
        }
    })
}

/// Lets an array's attributes say names, units, scale and rate of its columns.
fn tell(found: &mut ContentValue, attributes: &Attributes, rate: Option<f64>) {
    let texts = |is: &dyn Fn(&str) -> bool| {
        attributes
            .0
            .iter()
            .filter(|(name, _)| is(&bare(name)))
            .find_map(|(_, value)| Attributes::texts(value))
    };
    let units = texts(&|name| UNITS.contains(&name)).unwrap_or_default();
    // A packed number times its scale and with its offset, as netCDF's conventions have it.
    let scale = attributes.number("scale_factor").unwrap_or(1.0);
    let offset = attributes.number("add_offset").unwrap_or(0.0);
    match found {
        ContentValue::Numbers { values, told, .. } => {
            told.names =
                texts(&|name| NAMES.iter().any(|word| name.contains(word))).unwrap_or_default();
            told.units = units;
            told.rate_hz = rate;
            if (scale, offset) != (1.0, 0.0) {
                values.iter_mut().for_each(|value| *value = *value * scale + offset);
            }
        }
        ContentValue::Records { records, .. } => {
            for (index, value) in records.iter_mut().flatten().enumerate() {
                let ContentValue::Numbers { told, .. } = value else { continue };
                told.rate_hz = rate;
                told.units.extend(units.get(index).filter(|_| units.len() > 1).cloned());
            }
        }
        ContentValue::Text(_) | ContentValue::Cells(_) | ContentValue::Other(_) => {}
    }
}

/// Adds the attributes that are single numbers or texts, with their object's name before theirs.
fn facts(attributes: &Attributes, prefix: &str, is_root: bool, named: &mut Named) {
    for (name, value) in &attributes.0 {
        let own =
            OWN.contains(&name.as_str()) || OWN_BEGINS.iter().any(|own| name.starts_with(own));
        // Of the root group, rates and units are those of all; of others, they were told already.
        let bare = bare(name);
        let rate = as_number(value).and_then(|number| rate_hz(name, number));
        let told = !is_root && (UNITS.contains(&bare.as_str()) || bare == STEP || rate.is_some());
        let value = match (as_text(value), as_number(value)) {
            (Some(text), _) if text.chars().count() <= MAX_FACT && !text.is_empty() => {
                ContentValue::Text(text.to_owned())
            }
            (_, Some(number)) => ContentValue::numbers(vec![1, 1], vec![number]),
            (_, None) => continue,
        };
        let name = format!("{prefix}{name}");
        if !own && !told && !named.iter().any(|(known, _)| *known == name) {
            named.push((name, value));
        }
    }
}

/// Tables of pandas: names of columns stand beside their values.
fn pandas(named: &mut Named) {
    let lists: Vec<(String, Vec<String>)> = named
        .iter()
        .filter_map(|(name, value)| {
            Some((format!("{}_values", name.strip_suffix("_items")?), Attributes::texts(value)?))
        })
        .collect();
    for (of, names) in lists {
        for (name, value) in named.iter_mut().filter(|(name, _)| *name == of) {
            let ContentValue::Numbers { told, .. } = value else { continue };
            match names.as_slice() {
                [only] => name.clone_from(only),
                names => told.names = names.to_vec(),
            }
        }
    }
}
