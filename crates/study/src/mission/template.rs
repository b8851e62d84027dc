//! What a mission looks like: a commented one to begin with.

/// A mission that can be read as it is, with every entry explained.
pub const TEMPLATE: &str = include_str!("../../../../assets/missions/template.toml");
