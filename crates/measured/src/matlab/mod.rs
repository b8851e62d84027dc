//! MATLAB v5: what a file holds.

mod element;

use crate::contents::{ChosenFirst, channels};
use crate::fault::DataFault;
use crate::layout::DataLayout;
use crate::reader::RawData;
pub(crate) use element::{is, rows};

/// Reads a file, or what `variable` of the layout names in it.
pub(crate) fn read(bytes: &[u8], layout: &mut DataLayout) -> Result<RawData, DataFault> {
    channels(&element::variables(bytes)?, layout, ChosenFirst::VectorsOrRecord)
}
