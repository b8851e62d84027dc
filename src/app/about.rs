//! What the program is, in one sentence, for those who see it for the first time.

use crate::base::language::text;

/// The sentence.
pub const WHAT_IT_IS: &str = text!(
    "SteadyCut simulates milling whose controller holds the roughness Ra, or the force, by feed and speed."
);
