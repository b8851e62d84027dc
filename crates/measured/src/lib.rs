//! Measured data: files as labs and shops have them, read into channels, and what is done with the channels before
//! anything is fitted to them.
//!
//! | question | module |
//! | --- | --- |
//! | What is in a file, and as what is it read? | [`reader`] |
//! | What was guessed of its layout, and what did a person say of it? | [`layout`] |
//! | What is a channel? | [`channel`] |
//! | What is wrong with a file? | [`fault`] |
//! | What is done with channels before anything is fitted to them? | [`signal`] |
//! | How do channels become plain CSV? | [`table`] |
//!
//! Formats: text of any separator, decimal sign and encoding, with or without names, units and head lines; MATLAB v5 and
//! v7.3 with structures; HDF5; TDMS; Parquet. All readers take bytes and give channels or a fault with its place: nothing here
//! opens a file, and no bytes make them panic or take memory that the file has no values for.

#![forbid(unsafe_code)]
#![warn(missing_docs)]
// A new format or encoding must be met wherever there is a choice of them.
#![deny(clippy::wildcard_enum_match_arm)]

// The layer below, under the name that it has in the whole project.
pub use steadycut_core::base;

mod assemble;
mod bytes;
pub mod channel;
mod contents;
pub mod fault;
mod hdf5;
pub mod layout;
mod matlab;
mod parquet;
pub mod reader;
pub mod signal;
pub mod table;
mod tdms;
mod text;
