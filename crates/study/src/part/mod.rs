//! Parts of one's own: a path with axial and radial depth by its length.
//!
//! | from | by | to |
//! | --- | --- | --- |
//! | a table (CSV) | [`PartPath::read`] | the path |
//! | a program (G-code) over a blank | [`gcode`], then [`milling`] on the map of heights of [`blank`] | the path, as rows of [`milling::MilledRow`] |
//! | a scenario | [`PartPath::of`] | the path |
//! | the path | [`PartPath::to_scenario`] | the settings of a scenario: length, axial and radial profile |
//!
//! Depths hold from a row to the next one: the controllers of the papers see a part as stretches of constant depth
//! along the way. Everything is the four operations, square roots and the functions of `base::math`, so that a program
//! gives the same part, to the bit, natively and in the page.

pub mod blank;
pub mod carved;
mod columns;
pub mod gcode;
pub mod milling;
mod path;
mod taken;

/// A program to try: a shoulder round a corner and a slot, of a blank of 100 x 60 x 20 mm with a square end of 12 mm.
pub const EXAMPLE_GCODE: &str = include_str!("../../../../assets/parts/bracket.nc");
/// A table to try: a side cut of changing depths with a gap.
pub const EXAMPLE_CSV: &str = include_str!("../../../../assets/parts/steps.csv");

pub use path::PartPath;
pub use taken::TakenPart;
