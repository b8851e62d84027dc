//! What the coupled machine adds to the cards of force and surface.

use super::formula::number;
use crate::base::equation::Live;
use crate::base::language::tr;
use crate::run::scenario::Scenario;
use crate::run::signals::Row;

/// The force that drives the machine, and its vibration and sound.
pub fn vibration(row: &Row, scenario: &Scenario) -> Live {
    let machine = &scenario.machine;
    Live::everywhere(
        tr!(
            "P = F g / max g - {force} · {factor} b (u - u_T), g the teeth's chip, u_T one tooth earlier",
            force = number(machine.specific_cutting_force_n_mm2),
            factor = number(machine.directional_factor)
        ),
        tr!(
            "u = {vibration} µm as the last tooth made the surface; velocity {sound} mm/s over the last second",
            vibration = number(row.vibration_um),
            sound = number(row.sound_mm_s)
        ),
    )
}

/// Ra with dynamics where it comes from the marks of the teeth.
pub fn marks(row: &Row) -> Live {
    Live::everywhere(
        tr("Ra_{dyn} = Ra + Ra(marks) - Ra(marks without vibration)"),
        format!(
            "Ra_{{dyn}} = {} + {} = {} µm",
            number(row.ra_um),
            number(row.ra_dyn_um - row.ra_um),
            number(row.ra_dyn_um)
        ),
    )
}
