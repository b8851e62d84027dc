//! MATLAB v7.3: how MATLAB's values are kept in HDF5. Attributes say what a group or array is to MATLAB; structures are
//! groups, cells and arrays of structures are addresses of what lies in a group of its own, and sizes stand backwards.

use std::collections::BTreeMap;

use super::attributes::Attributes;
use super::chunks;
use super::datatype::{Datatype, ElementKind};
use super::decode::DimensionOrder;
use super::file::{Hdf5File, Trouble};
use super::header::{DATATYPE, Header};
use super::layout::Stored;
use super::links::members;
use super::tree::{MAX_DEPTH, array};
use crate::base::language::text;
use crate::contents::{ContentEntry, ContentValue};
use crate::matlab::rows;

/// Goes through a file.
struct Walk<'a, 'f> {
    file: &'f Hdf5File<'a>,
    /// Addresses of what is being read: one of them within itself leads in a circle.
    within: Vec<u64>,
    /// Values without numbers, which many cells can be the same of.
    empty: BTreeMap<u64, ContentValue>,
}

/// All variables of a file.
pub(super) fn contents(file: &Hdf5File<'_>) -> Result<Vec<ContentEntry>, Trouble> {
    let mut walk = Walk { file, within: vec![file.root], empty: BTreeMap::new() };
    let header = Header::read(file, file.root)?;
    let mut found = Vec::new();
    for member in members(file, &header)? {
        // What MATLAB keeps for itself.
        if member.name.starts_with('#') {
            continue;
        }
        if let Some(address) = member.address {
            found.push(ContentEntry { name: member.name, value: walk.object(address)? });
        }
    }
    Ok(found)
}

impl<'a> Walk<'a, '_> {
    /// The value at an address.
    fn object(&mut self, address: u64) -> Result<ContentValue, Trouble> {
        if let Some(empty) = self.empty.get(&address) {
            return Ok(empty.clone());
        }
        if self.within.len() > MAX_DEPTH || self.within.contains(&address) {
            return Ok(ContentValue::Other(text!("structures too deep in each other")));
        }
        self.within.push(address);
        let found = self.any(address);
        self.within.pop();
        match found {
            Err(Trouble::Unread(what)) => Ok(ContentValue::Other(what)),
            found => found,
        }
    }

    fn any(&mut self, address: u64) -> Result<ContentValue, Trouble> {
        let header = Header::read(self.file, address)?;
        let attributes = Attributes::of(self.file, &header)?;
        let class = attributes.text("MATLAB_class").unwrap_or("").to_owned();
        if attributes.number("MATLAB_empty").is_some_and(|empty| empty != 0.0) {
            let empty = match class.as_str() {
                "char" => ContentValue::Text(String::new()),
                "cell" => ContentValue::Cells(Vec::new()),
                "struct" => ContentValue::Records { fields: Vec::new(), records: Vec::new() },
                _ => ContentValue::numbers(vec![0, 0], Vec::new()),
            };
            self.empty.insert(address, empty.clone());
            return Ok(empty);
        }
        if attributes.number("MATLAB_object_decode").is_some_and(|kind| kind != 0.0) {
            return Ok(ContentValue::Other(text!("an object of a class")));
        }
        let Some(stored) = Stored::of(self.file, &header)? else {
            if attributes.number("MATLAB_sparse").is_some() {
                return Ok(ContentValue::Other(text!("a sparse matrix")));
            }
            return self.structure(&header, &attributes);
        };
        match class.as_str() {
            "cell" => {
                let mut cells = Vec::new();
                for address in self.addresses(&header, &stored)? {
                    cells.push(self.target(address)?);
                }
                Ok(ContentValue::Cells(cells))
            }
            "char" => match array(self.file, &header, &stored, DimensionOrder::Matlab)? {
                ContentValue::Numbers { dims, values, .. } => {
                    let units: Vec<u16> = values.iter().map(|unit| *unit as u16).collect();
                    Ok(ContentValue::Text(rows(&String::from_utf16_lossy(&units), &dims)))
                }
                other @ (ContentValue::Text(_)
                | ContentValue::Cells(_)
                | ContentValue::Records { .. }
                | ContentValue::Other(_)) => Ok(other),
            },
            "function_handle" => Ok(ContentValue::Other(text!("a function or another class"))),
            _ => array(self.file, &header, &stored, DimensionOrder::Matlab),
        }
    }

    /// What an element's address leads to.
    fn target(&mut self, address: Option<u64>) -> Result<ContentValue, Trouble> {
        match address {
            Some(address) => self.object(address),
            None => Ok(ContentValue::numbers(vec![0, 0], Vec::new())),
        }
    }

    /// The addresses in an array of them.
    fn addresses(
        &self,
        header: &Header<'a>,
        stored: &Stored<'a>,
    ) -> Result<Vec<Option<u64>>, Trouble> {
        let of =
            header.one(DATATYPE).map(|message| Datatype::of(self.file, message)).transpose()?;
        match of {
            Some(Datatype { size, kind: ElementKind::Reference }) => {
                let bytes = chunks::bytes(self.file, stored, size)?;
                let address = |bytes: &[u8]| {
                    let mut eight = [0; 8];
                    eight[..size].copy_from_slice(bytes);
                    Some(u64::from_le_bytes(eight)).filter(|x| *x != 0 && *x != u64::MAX)
                };
                Ok(bytes.chunks_exact(size).map(address).collect())
            }
            Some(_) | None => Err(Trouble::Unread(text!("cells that are no references"))),
        }
    }

    /// A structure, or an array of them: the fields of one are values, those of several lists of addresses.
    fn structure(
        &mut self,
        header: &Header<'a>,
        attributes: &Attributes,
    ) -> Result<ContentValue, Trouble> {
        let mut all = members(self.file, header)?;
        let order = attributes.0.iter().find(|(name, _)| name == "MATLAB_fields");
        if let Some(order) = order.and_then(|(_, value)| Attributes::texts(value)) {
            all.sort_by_key(|member| order.iter().position(|field| *field == member.name));
        }
        let mut fields = Vec::new();
        let mut one = Vec::new();
        let mut several: Vec<Vec<Option<u64>>> = Vec::new();
        for member in all {
            let Some(address) = member.address else { continue };
            match self.several(address)? {
                Some(addresses) => several.push(addresses),
                None => one.push(self.object(address)?),
            }
            fields.push(member.name);
        }
        if several.is_empty() {
            return Ok(ContentValue::Records { fields, records: vec![one] });
        }
        let count = several[0].len();
        if !one.is_empty() || several.iter().any(|addresses| addresses.len() != count) {
            return Err(Trouble::Unread(text!("records with fields of different lengths")));
        }
        let mut records = Vec::new();
        for index in 0..count {
            let mut record = Vec::new();
            for addresses in &several {
                record.push(self.target(addresses[index])?);
            }
            records.push(record);
        }
        Ok(ContentValue::Records { fields, records })
    }

    /// The addresses that a field of several structures is: an array of them that is no cell.
    fn several(&self, address: u64) -> Result<Option<Vec<Option<u64>>>, Trouble> {
        let header = Header::read(self.file, address)?;
        let Some(message) = header.one(DATATYPE) else { return Ok(None) };
        let is_reference = matches!(Datatype::of(self.file, message)?.kind, ElementKind::Reference);
        if !is_reference || Attributes::of(self.file, &header)?.text("MATLAB_class").is_some() {
            return Ok(None);
        }
        match Stored::of(self.file, &header)? {
            Some(stored) => self.addresses(&header, &stored).map(Some),
            None => Ok(None),
        }
    }
}
