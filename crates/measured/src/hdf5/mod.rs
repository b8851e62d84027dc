//! HDF5, and MATLAB v7.3, which is HDF5 with a block of MATLAB's own in front: what a file holds.
//!
//! An own reader of what labs have: crates in pure Rust ask for as much memory as a spoilt byte says, and the others
//! bring C, which the page has no use for.

mod arrays;
mod attributes;
mod btree2;
mod checksum;
mod chunks;
mod datatype;
mod decode;
mod file;
mod filters;
mod header;
mod heaps;
mod layout;
mod links;
mod matlab;
mod tree;

use crate::contents::{ChosenFirst, ContentEntry, channels};
use crate::fault::DataFault;
use crate::layout::DataLayout;
use crate::reader::RawData;
pub(crate) use file::begin;
use file::{Hdf5File, Trouble};

/// Reads a file, or the group or array that `variable` of the layout names in it.
pub(crate) fn read(bytes: &[u8], layout: &mut DataLayout) -> Result<RawData, DataFault> {
    let file = Hdf5File::open(bytes)?;
    let all = entries(tree::contents(&file))?;
    let said = layout.variable.clone();
    // Groups lie in each other as folders do.
    layout.variable = said.as_ref().map(|path| path.trim_start_matches('/').replace('/', "."));
    let found = channels(&all, layout, ChosenFirst::Everything);
    layout.variable = said;
    found
}

/// Reads a file of MATLAB, or what `variable` of the layout names in it.
pub(crate) fn read_matlab(bytes: &[u8], layout: &mut DataLayout) -> Result<RawData, DataFault> {
    let file = Hdf5File::open(bytes)?;
    let all = entries(matlab::contents(&file))?;
    channels(&all, layout, ChosenFirst::VectorsOrRecord)
}

/// What is not read of the root group is a fault of the file.
fn entries(found: Result<Vec<ContentEntry>, Trouble>) -> Result<Vec<ContentEntry>, DataFault> {
    found.map_err(|trouble| match trouble {
        Trouble::Fault(fault) => fault,
        Trouble::Unread(what) => DataFault::of_file(crate::base::language::tr(what), ""),
    })
}
