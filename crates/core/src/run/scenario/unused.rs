//! Settings that have no part in a run because another one stands as it does: nothing that is given is
//! dropped in silence, so whoever is given such a setting refuses it, or greys it, with the reason.
//!
//! A table, one row for each reason. What a controller leaves out it says itself
//! ([`ControlLaw::believes`], [`ControlLaw::left_out`]). A test holds all of it against runs, to the bit.
//!
//! [`ControlLaw::believes`]: crate::blocks::control::law::ControlLaw::believes
//! [`ControlLaw::left_out`]: crate::blocks::control::law::ControlLaw::left_out

use super::groups::Settings;
use super::table::{Param, param};
use crate::base::language::{text, tr};
use crate::base::settings::SettingError;
use crate::blocks::reference::Reference;
use crate::models::genetic::{Calibration, ModelSet};
use crate::models::structure::RoughnessFrom;
use crate::models::tool::EndShape;
use crate::models::wear::WearModel;

/// Settings that a run leaves out while another one stands as it does.
#[derive(Clone, Copy)]
pub struct Unused {
    /// Their paths; a group ends in a full stop.
    pub paths: &'static [&'static str],
    /// Of a group, those that are used.
    pub but: &'static [&'static str],
    /// Whether they are left out; none where a run never asks for them.
    pub when: Option<fn(&Settings) -> bool>,
    /// Why.
    pub because: &'static str,
}

const fn unused(
    paths: &'static [&'static str],
    when: fn(&Settings) -> bool,
    because: &'static str,
) -> Unused {
    Unused { paths, but: &[], when: Some(when), because }
}

const fn never(paths: &'static [&'static str], because: &'static str) -> Unused {
    Unused { paths, but: &[], when: None, because }
}

fn by_teeth(s: &Settings) -> bool {
    s.plant.force_model.tooth_by_tooth()
}

fn adjusts_speed(s: &Settings) -> bool {
    s.wear.adjust_speed && s.wear.model == WearModel::Life
}

/// Whether the tool's wear jumps somewhere.
fn wear_jumps(s: &Settings) -> bool {
    !s.disturbances.wear_jumps.zones().is_empty()
}

/// Whether a coupled machine's vibration makes Ra with dynamics.
fn marks_measured(s: &Settings) -> bool {
    s.machine.coupled && s.machine.roughness_from == RoughnessFrom::Vibration
}

/// Whether every cut has a programmed feed of its own.
fn all_cuts_have_feeds(s: &Settings) -> bool {
    let cuts = s.workpiece.cuts.len();
    cuts > 0 && s.program.cut_feeds_mm_min.len() >= cuts
}

/// Whether the controller's models are own formulas where there are any.
fn believes_formulas(s: &Settings) -> bool {
    s.belief.calibration == Calibration::Formula && s.belief.model_set != ModelSet::Milling2005
}

/// Whether the plant's are.
fn cut_by_formulas(s: &Settings) -> bool {
    s.plant.calibration == Calibration::Formula && s.plant.model_set != ModelSet::Milling2005
}

/// Whether no source of noise draws anything.
fn no_noise(s: &Settings) -> bool {
    let n = &s.noise;
    let sizes = [n.band_percent, n.ripple_percent, n.inhomogeneity_percent, n.sensor_n];
    n.level == 0.0 || sizes == [0.0; 4]
}

/// Why a run leaves out the settings of a controller that is not chosen.
pub const ANOTHER_CONTROLLER: &str = text!("`controller.kind` is another one");
/// Why it leaves out a setting of the chosen one.
pub const LEFT_OUT: &str = text!("the controller does not ask for it as its other settings stand");
/// Why it leaves out a belief.
pub const NOT_BELIEVED: &str = text!("the controller, as it is set, does not ask for it");

/// Why settings of the wear's curves are left out where a formula stands in their place.
pub const BY_CURVES: [Unused; 4] = [
    unused(
        &[
            "wear.break_in_share",
            "wear.break_in_span",
            "wear.steady_share",
            "wear.failure_share",
            "wear.failure_span",
        ],
        |s| s.wear.curve.get().is_some(),
        text!("`wear.curve` gives the wear over the life"),
    ),
    unused(
        &["wear.force_growth"],
        |s| s.wear.force_curve.get().is_some(),
        text!("`wear.force_curve` gives the force over the wear"),
    ),
    unused(
        &["wear.tooth_softening"],
        |s| s.wear.stiffness_curve.get().is_some(),
        text!("`wear.stiffness_curve` gives the stiffness over the wear"),
    ),
    unused(
        &[
            "wear.taylor_life_min",
            "wear.taylor_speed_m_min",
            "wear.reference_feed_mm",
            "wear.feed_exponent",
            "wear.reference_depth_mm",
            "wear.depth_exponent",
        ],
        |s| s.wear.life_curve.get().is_some(),
        text!("`wear.life_curve` gives the life over the cut"),
    ),
];

/// All other reasons.
pub const UNUSED: &[Unused] = &[
    unused(
        &["target.ra_um"],
        |s| s.target.reference == Reference::Force,
        text!("`target.reference` is force"),
    ),
    unused(
        &["target.force_n"],
        |s| s.target.reference == Reference::Ra,
        text!("`target.reference` is ra"),
    ),
    unused(
        &["belief.calibration"],
        |s| s.belief.model_set == ModelSet::Milling2005,
        text!("`belief.model_set` is milling_2005, which has one calibration"),
    ),
    unused(
        &["plant.calibration"],
        |s| s.plant.model_set == ModelSet::Milling2005,
        text!("`plant.model_set` is milling_2005, which has one calibration"),
    ),
    unused(
        &["formula.force_of_ra"],
        |s| s.target.reference == Reference::Force,
        text!("`target.reference` is force"),
    ),
    unused(
        &["formula.force_of_ra", "formula.feed", "formula.speed"],
        |s| !believes_formulas(s),
        text!("`belief.calibration` is not formula, or `belief.model_set` milling_2005"),
    ),
    unused(
        &["formula.force"],
        |s| {
            let cut = cut_by_formulas(s) && s.plant.force_model.is_formula();
            !cut && !believes_formulas(s)
        },
        text!(
            "neither `belief.calibration` nor `plant.calibration`, where `plant.force_model` is formula, is formula"
        ),
    ),
    unused(
        &["formula.ra"],
        |s| !cut_by_formulas(s) && !believes_formulas(s),
        text!("neither `belief.calibration` nor `plant.calibration` is formula"),
    ),
    unused(
        &["tool.corner_radius_mm"],
        |s| s.tool.shape != EndShape::BullNose,
        text!("`tool.shape` is no bull_nose"),
    ),
    never(
        &["tool.overhang_mm", "tool.elastic_modulus_n_mm2"],
        text!("only the off-line plan bends the cutter"),
    ),
    unused(
        &[
            "tool.compliance_um_n",
            "tool.runout_um",
            "plant.slice_mm",
            "formula.specific_force",
            "formula.specific_radial_force",
            "formula.specific_axial_force",
        ],
        |s| !by_teeth(s),
        text!("`plant.force_model` is a map, not mechanistic"),
    ),
    unused(
        &["tool.compliance_um_n"],
        |s| s.machine.coupled,
        text!("`machine.coupled` is true: the machine is what gives way"),
    ),
    unused(
        &["plant.force_offset_n"],
        by_teeth,
        text!("`plant.force_model` is mechanistic: the teeth's force has no intercept"),
    ),
    Unused {
        paths: &["noise."],
        but: &["noise.level"],
        when: Some(|s| s.noise.level == 0.0),
        because: text!("`noise.level` is 0"),
    },
    unused(
        &["noise.band_low_hz", "noise.band_high_hz"],
        |s| s.noise.band_percent == 0.0,
        text!("`noise.band_percent` is 0"),
    ),
    unused(
        &["noise.correlation_mm"],
        |s| s.noise.inhomogeneity_percent == 0.0,
        text!("`noise.inhomogeneity_percent` is 0"),
    ),
    unused(
        &["run.seed"],
        no_noise,
        text!("nothing is random: `noise.level` or every size of noise is 0"),
    ),
    unused(
        &["cnc.override_rate_percent_s"],
        |s| !s.cnc.override_rate_limited,
        text!("`cnc.override_rate_limited` is false"),
    ),
    unused(
        &["feed_drive.kind"],
        |s| !s.feed_drive.poles.is_empty(),
        text!("`feed_drive.poles` gives the drive"),
    ),
    unused(
        &["feed_drive.gain"],
        |s| s.feed_drive.poles.is_empty(),
        text!("`feed_drive.poles` is empty: the papers' drives have a gain of 1"),
    ),
    unused(
        &["spindle_drive.time_constant_s", "spindle_drive.rate_rpm_s"],
        |s| !s.spindle_drive.poles.is_empty(),
        text!("`spindle_drive.poles` gives the drive"),
    ),
    unused(
        &["spindle_drive.gain"],
        |s| s.spindle_drive.poles.is_empty(),
        text!("`spindle_drive.poles` is empty: lag and rate limit have a gain of 1"),
    ),
    unused(&["cnc.force_stop_n"], |s| !s.cnc.force_stop, text!("`cnc.force_stop` is false")),
    unused(
        &["program.cut_feeds_mm_min"],
        |s| s.workpiece.cuts.is_empty(),
        text!("`workpiece.cuts` is empty"),
    ),
    unused(
        &["program.feed_mm_min"],
        all_cuts_have_feeds,
        text!("`program.cut_feeds_mm_min` programs every cut"),
    ),
    unused(
        &[
            "workpiece.length_mm",
            "workpiece.axial_depth_mm",
            "workpiece.radial_depth_mm",
            "workpiece.depth_steps",
            "workpiece.radial_steps",
        ],
        |s| !s.workpiece.cuts.is_empty(),
        text!("`workpiece.cuts` gives lengths and depths"),
    ),
    Unused {
        paths: &["machine."],
        but: &["machine.coupled"],
        when: Some(|s| !s.machine.coupled),
        because: text!("`machine.coupled` is false: the cut does not feel the machine"),
    },
    unused(
        &["machine.variant", "machine.parameters", "machine.spindle_quality"],
        |s| !s.machine.tip_modes.is_empty(),
        text!("`machine.tip_modes` gives the machine"),
    ),
    never(
        &["machine.radial_ratio", "machine.down_milling"],
        text!("only the stability chart of measured modes has it"),
    ),
    unused(
        &["wear.tooth_softening", "wear.stiffness_curve"],
        |s| !s.machine.tip_modes.is_empty(),
        text!("`machine.tip_modes` gives the machine: its tooth is stiff"),
    ),
    Unused {
        paths: &["wear."],
        but: &["wear.model", "wear.used_life"],
        when: Some(|s| s.wear.model == WearModel::Fixed && !wear_jumps(s)),
        because: text!("`wear.model` is fixed"),
    },
    Unused {
        paths: &["wear."],
        but: &[
            "wear.model",
            "wear.used_life",
            "wear.flank_end_mm",
            "wear.force_growth",
            "wear.force_curve",
            "wear.tooth_softening",
            "wear.stiffness_curve",
            "wear.indentation_n_mm3",
        ],
        when: Some(|s| s.wear.model == WearModel::Fixed),
        because: text!(
            "`wear.model` is fixed: the tool is worn by `disturbances.wear_jumps` alone"
        ),
    },
    unused(
        &["wear.tooth_softening", "wear.stiffness_curve", "wear.indentation_n_mm3"],
        |s| !s.machine.coupled,
        text!("`machine.coupled` is false: nothing vibrates"),
    ),
    unused(
        &["wear.flank_end_mm"],
        |s| !s.machine.coupled && !wear_jumps(s),
        text!("`machine.coupled` is false: nothing vibrates"),
    ),
    unused(
        &["disturbances.chatter_hz"],
        |s| s.disturbances.chatter_bursts.zones().is_empty(),
        text!("`disturbances.chatter_bursts` is empty"),
    ),
    BY_CURVES[0],
    BY_CURVES[1],
    BY_CURVES[2],
    BY_CURVES[3],
    unused(
        &["wear.taylor_exponent"],
        |s| s.wear.life_curve.get().is_some() && !adjusts_speed(s),
        text!("`wear.life_curve` gives the life over the cut, and nothing adjusts the speed"),
    ),
    unused(
        &["wear.flank_end_mm"],
        |s| s.wear.indentation_n_mm3 == 0.0 && !wear_jumps(s),
        text!("`wear.indentation_n_mm3` is 0"),
    ),
    unused(
        &["life.tool_life_min", "life.sigma_percent", "life.correlated_min", "life.prior_spread"],
        |s| !adjusts_speed(s),
        text!("`wear.adjust_speed` is false, or `wear.model` fixed"),
    ),
    never(
        &[
            "life.contact_force_n",
            "life.sound_exponent",
            "life.random_ratio",
            "life.white_percent",
            "life.slow_percent",
            "life.slow_min",
            "life.spectrum_ratio",
        ],
        text!("only trends over the tool's life have it; a run has the force of its own cut"),
    ),
    never(
        &["profile.short_um"],
        text!("Ra with dynamics in the running cut leaves out waves below 50 um whatever is set"),
    ),
    unused(
        &["profile.long_mm", "profile.normal_share"],
        |s| !marks_measured(s),
        text!(
            "no vibration of a coupled machine makes Ra with dynamics (`machine.coupled`, \
         `machine.roughness_from`)"
        ),
    ),
    never(&["plan."], text!("the off-line plan has it, not a run")),
    never(&["twin."], text!("it chooses what a cut is compared with, and moves none")),
];

impl Unused {
    /// Whether it is about the setting at `path`.
    #[must_use]
    pub fn names(&self, path: &str) -> bool {
        let named = |one: &str| path == one || (one.ends_with('.') && path.starts_with(one));
        self.paths.iter().any(|one| named(one)) && !self.but.contains(&path)
    }

    /// Whether it leaves them out of a run of these settings.
    #[must_use]
    pub fn holds(&self, settings: &Settings) -> bool {
        self.when.is_none_or(|when| when(settings))
    }
}

impl Settings {
    /// Why a run of these settings leaves out the one at `path`, in the chosen language; none where it is used.
    ///
    /// # Errors
    /// [`SettingError::Unknown`].
    pub fn unused(&self, path: &str) -> Result<Option<&'static str>, SettingError> {
        Ok(self.unused_param(param(path)?).map(tr))
    }

    fn unused_param(&self, Param { path, group, spec }: &Param) -> Option<&'static str> {
        let kind = self.controller.kind;
        if *group != "controller" && group.starts_with("controller.") {
            return if *group != kind.group() {
                Some(ANOTHER_CONTROLLER)
            } else if self.controller.left_out().contains(&spec.key) {
                Some(LEFT_OUT)
            } else {
                None
            };
        }
        let models = ["model_set", "calibration"].contains(&spec.key);
        if *group == "belief" && !models && !self.controller.believes().contains(&spec.key) {
            return Some(NOT_BELIEVED);
        }
        let row = UNUSED.iter().find(|row| row.names(path) && row.holds(self))?;
        Some(row.because)
    }
}
