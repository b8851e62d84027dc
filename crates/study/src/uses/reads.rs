//! What the commands read, besides a run's settings or instead of them.

use super::Reader;
use crate::base::language::text;
use crate::blocks::reference::Reference;
use crate::experiment::sheet::TOLD_SETTINGS;
use crate::models::genetic::{Calibration, ModelSet};
use crate::models::plan::ForceLimit;
use crate::models::tool::EndShape;
use crate::run::scenario::{BY_CURVES, TwinKind, Unused};

/// What a command reads.
pub(super) struct Reads {
    /// Whether it reads what a run reads.
    pub as_run: bool,
    /// What it reads besides; a group ends in a full stop.
    pub also: &'static [&'static str],
    /// What it leaves out all the same, and why.
    pub but: &'static [(&'static [&'static str], &'static str)],
    /// What it leaves out of its own while another setting stands as it does.
    pub unused: &'static [Unused],
}

/// What only names the report and what only judges it.
const DESCRIPTION: (&[&str], &str) = (&["description"], text!("only `run` prints it"));
const TOLERANCE: (&[&str], &str) = (
    &["target.tolerance_percent", "economics."],
    text!("only metrics judge by it, and this prints none of those"),
);
/// What a cut costs.
const ECONOMICS: (&[&str], &str) = (&["economics."], text!("it prints no cost"));
const ROWS: (&[&str], &str) =
    (&["run.record_every"], text!("a row is recorded for every control period"));
const ALWAYS_UNKS: (&[&str], &str) = (&["controller.kind"], text!("the controller is always UNKS"));
/// What becomes of Ra, which feeds back into nothing.
const ROUGHNESS: (&[&str], &str) = (
    &["machine.roughness_from", "profile.", "formula.ra"],
    text!("Ra is not among what this prints"),
);
const MODELS_OF_RA: Unused = Unused {
    paths: &["plant.calibration"],
    but: &[],
    when: Some(|s| !s.plant.force_model.is_formula()),
    because: text!("`plant.force_model` is no formula, and Ra is not among what this prints"),
};

const AS_RUN: Reads = Reads { as_run: true, also: &[], but: &[], unused: &[] };

/// What the comparison with constant feed leaves out.
const TWIN_UNUSED: &[Unused] = &[Unused {
    paths: &["twin.free_speed"],
    but: &[],
    when: Some(|s| s.twin.kind == TwinKind::Programmed),
    because: text!("`twin.kind` is programmed"),
}];

/// What the plan reads of cutter, part and material.
const PLANNED: &[&str] = &[
    "name",
    "tool.name",
    "tool.shape",
    "tool.diameter_mm",
    "tool.teeth",
    "tool.helix_deg",
    "tool.rake_deg",
    "tool.overhang_mm",
    "tool.elastic_modulus_n_mm2",
    "target.ra_um",
    "target.reference",
    "target.force_n",
    "plant.material",
    "plant.hardness_hb",
    "plant.wear_factor",
    "plant.model_set",
    "plant.force_model",
    "belief.model_set",
    "belief.calibration",
    "formula.force_of_ra",
    "plan.",
    "cnc.feed_max_mm_min",
    "cnc.speed_min_rpm",
    "cnc.speed_max_rpm",
    "workpiece.length_mm",
    "workpiece.axial_depth_mm",
    "workpiece.radial_depth_mm",
    "workpiece.depth_steps",
    "workpiece.radial_steps",
];

/// Wherever feed and speed are planned.
const PLAN_UNUSED: &[Unused] = &[
    Unused {
        paths: &["plan.force_max_n"],
        but: &[],
        when: Some(|s| s.plan.force_limit != ForceLimit::Fixed),
        because: text!("`plan.force_limit` is not fixed"),
    },
    Unused {
        paths: &[
            "target.ra_um",
            "target.reference",
            "target.force_n",
            "belief.calibration",
            "formula.force_of_ra",
        ],
        but: &[],
        when: Some(|s| s.plan.force_limit == ForceLimit::Fixed),
        because: text!("`plan.force_limit` is fixed"),
    },
    Unused {
        paths: &["plan.cutting_speed_m_min"],
        but: &[],
        when: Some(|s| s.plan.free_speed),
        because: text!("`plan.free_speed` is true: the speed is searched"),
    },
    Unused {
        paths: &["belief.calibration"],
        but: &[],
        when: Some(|s| s.belief.model_set == ModelSet::Milling2005),
        because: text!("`belief.model_set` is milling_2005, which has one calibration"),
    },
    Unused {
        paths: &["formula.force_of_ra"],
        but: &[],
        when: Some(|s| s.target.reference == Reference::Force),
        because: text!("`target.reference` is force"),
    },
    Unused {
        paths: &["formula.force_of_ra"],
        but: &[],
        when: Some(|s| {
            s.belief.calibration != Calibration::Formula
                || s.belief.model_set == ModelSet::Milling2005
        }),
        because: text!("`belief.calibration` is not formula, or `belief.model_set` milling_2005"),
    },
    CORNER_UNUSED,
];

/// What the plan of every cut reads.
const CUTS_PLANNED: &[&str] = &[
    "name",
    "tool.name",
    "tool.shape",
    "tool.diameter_mm",
    "tool.corner_radius_mm",
    "tool.teeth",
    "tool.helix_deg",
    "tool.rake_deg",
    "tool.overhang_mm",
    "tool.elastic_modulus_n_mm2",
    "target.ra_um",
    "target.reference",
    "target.force_n",
    "plant.material",
    "plant.hardness_hb",
    "plant.wear_factor",
    "plant.model_set",
    "belief.model_set",
    "belief.calibration",
    "formula.force_of_ra",
    "plan.",
    "cnc.feed_max_mm_min",
    "cnc.speed_min_rpm",
    "cnc.speed_max_rpm",
    "program.spindle_rpm",
    "workpiece.cuts",
];

/// What the stability chart reads.
const CHART: &[&str] = &[
    "machine.variant",
    "machine.parameters",
    "machine.spindle_quality",
    "machine.specific_cutting_force_n_mm2",
    "machine.directional_factor",
    "machine.tip_modes",
    "machine.radial_ratio",
    "machine.down_milling",
    "tool.name",
    "tool.shape",
    "tool.diameter_mm",
    "tool.corner_radius_mm",
    "tool.teeth",
    "workpiece.radial_depth_mm",
    "workpiece.radial_steps",
    "workpiece.cuts",
];
const CHART_UNUSED: &[Unused] = &[
    Unused {
        paths: &[
            "machine.variant",
            "machine.parameters",
            "machine.spindle_quality",
            "machine.directional_factor",
        ],
        but: &[],
        when: Some(|s| !s.machine.tip_modes.is_empty()),
        because: text!(
            "`machine.tip_modes` gives the machine, and the teeth's angles the direction"
        ),
    },
    Unused {
        paths: &["machine.radial_ratio", "machine.down_milling"],
        but: &[],
        when: Some(|s| s.machine.tip_modes.is_empty()),
        because: text!("`machine.tip_modes` is empty: the five masses have one direction"),
    },
    Unused {
        paths: &["workpiece.radial_depth_mm", "workpiece.radial_steps"],
        but: &[],
        when: Some(|s| !s.workpiece.cuts.is_empty()),
        because: text!("`workpiece.cuts` gives the radial depths"),
    },
    Unused {
        paths: &["tool.shape", "tool.corner_radius_mm"],
        but: &[],
        when: Some(|s| s.workpiece.cuts.is_empty()),
        because: text!(
            "`workpiece.radial_depth_mm` is the width of the cut whatever the end's shape is"
        ),
    },
    CORNER_UNUSED,
];
const CORNER_UNUSED: Unused = Unused {
    paths: &["tool.corner_radius_mm"],
    but: &[],
    when: Some(|s| s.tool.shape != EndShape::BullNose),
    because: text!("`tool.shape` is no bull_nose"),
};
const WORN: &[Unused] = &[
    BY_CURVES[0],
    BY_CURVES[1],
    BY_CURVES[2],
    BY_CURVES[3],
    Unused {
        paths: &["wear.flank_end_mm"],
        but: &[],
        when: Some(|s| s.wear.indentation_n_mm3 == 0.0),
        because: text!("`wear.indentation_n_mm3` is 0"),
    },
];
const TRENDS_UNUSED: &[Unused] =
    &[CORNER_UNUSED, BY_CURVES[0], BY_CURVES[1], BY_CURVES[2], BY_CURVES[3]];

const MODES: &[&str] = &["machine.variant", "machine.parameters", "machine.spindle_quality"];

/// What the trends over the tool's life read.
const TRENDS: &[&str] = &[
    "machine.variant",
    "machine.parameters",
    "machine.spindle_quality",
    "wear.",
    "life.contact_force_n",
    "life.sound_exponent",
    "life.random_ratio",
    "life.white_percent",
    "life.spectrum_ratio",
    "profile.",
    "tool.name",
    "tool.shape",
    "tool.diameter_mm",
    "tool.corner_radius_mm",
    "tool.teeth",
    "tool.runout_um",
    "program.feed_mm_min",
    "program.spindle_rpm",
    "workpiece.axial_depth_mm",
    "workpiece.radial_depth_mm",
    "run.seed",
];
/// What the prediction of tool lives reads.
const LIFE: &[&str] = &[
    "machine.variant",
    "machine.parameters",
    "machine.spindle_quality",
    "wear.",
    "life.contact_force_n",
    "life.sound_exponent",
    "life.white_percent",
    "life.slow_percent",
    "life.slow_min",
    "life.tool_life_min",
    "life.sigma_percent",
    "life.correlated_min",
    "life.prior_spread",
    "tool.name",
    "tool.diameter_mm",
    "tool.teeth",
    "program.feed_mm_min",
    "program.spindle_rpm",
    "workpiece.axial_depth_mm",
    "workpiece.radial_depth_mm",
    "run.seed",
];
/// What the calibration of the random force reads.
const CALIBRATED: &[&str] = &[
    "machine.variant",
    "machine.parameters",
    "machine.spindle_quality",
    "tool.name",
    "tool.shape",
    "tool.diameter_mm",
    "tool.teeth",
    "plant.calibration",
    "formula.ra",
];
const CALIBRATED_UNUSED: &[Unused] = &[Unused {
    paths: &["formula.ra"],
    but: &[],
    when: Some(|s| s.plant.calibration != Calibration::Formula),
    because: text!("`plant.calibration` is not formula"),
}];
/// What tells a machine's tool how a run goes.
const OF_A_RUN: (&[&str], &str) = (
    &["wear.model", "wear.used_life", "wear.time_scale", "wear.adjust_speed"],
    text!("it tells how a run goes, and this is no run"),
);

/// What short steady cuts at constant feed leave out.
const STEADY_CUTS: &[(&[&str], &str)] = &[
    (
        &[
            "controller.",
            "target.",
            "belief.",
            "formula.force_of_ra",
            "formula.feed",
            "formula.speed",
            "feed_drive.",
            "spindle_drive.",
            "cnc.override_min_percent",
            "cnc.override_max_percent",
            "cnc.override_quantised",
            "cnc.override_rate_limited",
            "cnc.override_rate_percent_s",
            "cnc.dead_time_s",
        ],
        "every cut is made at constant feed and speed",
    ),
    (
        &[
            "workpiece.length_mm",
            "workpiece.depth_steps",
            "workpiece.radial_steps",
            "workpiece.cuts",
            "program.cut_feeds_mm_min",
            "run.duration_s",
            "disturbances.",
        ],
        "every cut is short, straight and of one depth, and nothing disturbs it",
    ),
    (&["machine.roughness_from", "profile."], "Ra is measured without the marks of vibration"),
    (&["wear.adjust_speed", "life."], "every cut is made at constant speed"),
    (&["run.seed"], "every cut draws its own from `--seed`"),
];
/// The same, with what no report of them prints.
const EXPERIMENT_RUN: &[(&[&str], &str)] = &[
    STEADY_CUTS[0],
    STEADY_CUTS[1],
    STEADY_CUTS[2],
    STEADY_CUTS[3],
    STEADY_CUTS[4],
    ECONOMICS,
    DESCRIPTION,
    ROWS,
];

impl Reader {
    /// What it reads.
    pub(super) fn reads(self) -> Reads {
        match self {
            Self::Run => AS_RUN,
            Self::RunTwin => Reads { also: &["twin."], unused: TWIN_UNUSED, ..AS_RUN },
            Self::RunProfile => Reads {
                also: &["profile.short_um", "profile.long_mm"],
                but: &[DESCRIPTION, TOLERANCE],
                ..AS_RUN
            },
            Self::RunRevolution => Reads {
                but: &[
                    (&["name"], "only forces are printed"),
                    DESCRIPTION,
                    TOLERANCE,
                    ROUGHNESS,
                    ROWS,
                ],
                unused: &[MODELS_OF_RA],
                ..AS_RUN
            },
            Self::Robust => Reads {
                but: &[
                    (&["run.seed"], "every run draws its own from `--seed`"),
                    (
                        &[
                            "plant.wear_factor",
                            "cnc.dead_time_s",
                            "belief.depth_error_percent",
                            "belief.position_error_mm",
                        ],
                        "it is drawn at random for every run",
                    ),
                    DESCRIPTION,
                    TOLERANCE,
                    ROUGHNESS,
                    ROWS,
                ],
                unused: &[MODELS_OF_RA],
                ..AS_RUN
            },
            Self::Experiment => Reads { as_run: false, also: TOLD_SETTINGS, but: &[], unused: &[] },
            Self::ExperimentRun => Reads { but: EXPERIMENT_RUN, ..AS_RUN },
            Self::Unks => Reads {
                but: &[ALWAYS_UNKS, DESCRIPTION, TOLERANCE, ROUGHNESS, ROWS],
                unused: &[MODELS_OF_RA],
                ..AS_RUN
            },
            Self::Combine => Reads {
                also: PLANNED,
                but: &[
                    ALWAYS_UNKS,
                    (&["plan.section"], "`--section` says it"),
                    (&["program.feed_mm_min", "program.spindle_rpm"], "they are planned"),
                    DESCRIPTION,
                ],
                unused: PLAN_UNUSED,
                ..AS_RUN
            },
            Self::Plan => Reads { as_run: false, also: PLANNED, but: &[], unused: PLAN_UNUSED },
            Self::PlanPerCut => Reads {
                as_run: false,
                also: CUTS_PLANNED,
                but: &[
                    (&["plan.section"], "`--per-cut` says it"),
                    (
                        &["plan.free_speed", "plan.cutting_speed_m_min"],
                        "the spindle stays as programmed",
                    ),
                ],
                unused: PLAN_UNUSED,
            },
            Self::MachineModes | Self::MachineFrf => {
                Reads { as_run: false, also: MODES, but: &[], unused: &[] }
            }
            Self::MachineStability => {
                Reads { as_run: false, also: CHART, but: &[], unused: CHART_UNUSED }
            }
            Self::MachineWear => {
                Reads { as_run: false, also: TRENDS, but: &[OF_A_RUN], unused: TRENDS_UNUSED }
            }
            Self::MachineLife => {
                Reads { as_run: false, also: LIFE, but: &[OF_A_RUN], unused: WORN }
            }
            Self::MachineRoughness => {
                Reads { as_run: false, also: CALIBRATED, but: &[], unused: CALIBRATED_UNUSED }
            }
        }
    }
}
