//! Settings of earlier versions under the names they have now, so that their files, links, `--set` and
//! edits still open. A renamed setting is a line here; what is written has the new name.

/// Paths that a setting had, and the path that it has.
pub const RENAMED: &[(&str, &str)] = &[
    // 0.4.0
    ("life.durability_min", "life.tool_life_min"),
    ("machine.chip_direction", "machine.directional_factor"),
    ("machine.reading", "machine.variant"),
    ("machine.specific_force_n_mm2", "machine.specific_cutting_force_n_mm2"),
    ("plant.runout_um", "tool.runout_um"),
    ("wear.durability_factor", "wear.tool_life_factor"),
];

/// The path that a setting has now.
pub(super) fn current(path: &str) -> &str {
    RENAMED.iter().find(|(old, _)| *old == path).map_or(path, |(_, new)| new)
}

/// Whether settings had paths that begin like this.
pub(super) fn was_a_group(prefix: &str) -> bool {
    RENAMED.iter().any(|(old, _)| old.starts_with(prefix))
}
