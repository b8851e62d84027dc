//! What the presets themselves do not show, over a handful of them that cover every model set,
//! every kind of plant and every machine: short runs of every controller, drive and calibration,
//! changed in the cut; the coefficients of drives and machine; a tool's life; a plan.

use std::collections::BTreeMap;

use serde_json::{Map, Value as Json};

use super::switches::{named, others, switches};
use crate::base::settings::Value;
use crate::blocks::control::ControllerKind;
use crate::blocks::machine::response::ModalResponse;
use crate::machine_life;
use crate::machine_life::adaptive::AdaptiveLife;
use crate::machine_life::surface::surface;
use crate::models::feed_drive::{ExactDrive, FeedDriveKind};
use crate::models::genetic::{Calibration, ModelSet};
use crate::models::neural_force::NeuralForce;
use crate::models::part::APPROACH_MM;
use crate::models::structure::frf;
use crate::models::structure::parameters::Parameters;
use crate::models::structure::reduction::Reduction;
use crate::models::structure::{FiveMass, MachineSettings, Variant};
use crate::models::wear::WearModel;
use crate::plan::PlanJob;
use crate::run::digest::Digest;
use crate::run::edits::{Edit, Edits};
use crate::run::job::Job;
use crate::run::one_run::Run;
use crate::run::scenario::{Scenario, table};

/// The presets whose variants are held: formula, neural network and tooth by tooth, one cut and
/// several, the models of 2005, 2007 and 2013, with and without the machine.
pub const BASES: [&str; 6] = [
    "experiment-1",
    "experiment-2-neural",
    "machine-dynamics",
    "machine-life",
    "strategy-2013",
    "table3-5-noise",
];

/// Seconds in the cut of a short run.
const SHORT_S: f64 = 1.5;
/// Seconds in the cut until a worn tool's speed has been adjusted several times.
const WORN_S: f64 = 4.0;
/// Reference force of AFC, N: below the forces of every base preset, whatever its cut is.
const AFC_REFERENCE_N: f64 = 40.0;
/// Plant steps of a control period tooth by tooth: the fewest that are allowed.
const TOOTH_STEPS: u32 = 200;

/// Digests of the variants of a base preset, by name; `held` are the switches that another one holds, and
/// then this one too.
pub(super) fn variants(
    preset: &Scenario,
    held: &mut BTreeMap<String, String>,
) -> Map<String, Json> {
    let base = short(preset);
    let mut all = Map::new();
    let mut put = |name: &str, digest: String| {
        all.insert(name.to_owned(), Json::String(digest));
    };
    put("drives", drives());
    put("machine", machines(&preset.machine));
    put("tool_life", tool_life(preset));
    put("plan", plan(preset));
    put("drives_and_calibrations", drives_and_calibrations(&base));
    for kind in ControllerKind::ALL {
        put(&named("controller.kind", &text(kind.id())), controller(&base, *kind));
        for param in table().iter().filter(|param| param.group == kind.group()) {
            for value in others(&base, param) {
                let mut scenario = base.clone();
                scenario.set(&param.path, value.clone()).expect("a choice that the controller has");
                put(&named(&param.path, &value), controller(&scenario, *kind));
            }
        }
    }
    let mut coupled = base.clone();
    coupled.set("machine.coupled", Value::Bool(true)).expect("the base presets' machine runs");
    if !preset.machine.coupled {
        put("machine coupled", controller(&coupled, preset.controller.kind));
    }
    put("worn", undisturbed(&worn(&coupled, false)));
    let adjusted =
        (named("wear.adjust_speed", &Value::Bool(true)), undisturbed(&worn(&coupled, true)));
    put(&adjusted.0, adjusted.1.clone());
    held.extend([adjusted]);
    // What a switch may show itself in, the cheapest first.
    let tracking = base.with(|settings| settings.controller.kind = ControllerKind::Tracking);
    let tracking = tracking.expect("a controller goes with any scenario");
    let stepped = base.with(|settings| settings.workpiece.depth_steps = vec![[20.0, 1.5]]);
    let stepped = stepped.expect("a shallower section goes with any scenario");
    for (name, digest) in switches(&[base, tracking, stepped, worn(&coupled, false)], held) {
        put(&name, digest);
    }
    all
}

/// The preset for a short run: tooth by tooth with the longest step allowed.
fn short(preset: &Scenario) -> Scenario {
    let shortened = preset.with(|settings| {
        if settings.run.steps_per_control > TOOTH_STEPS {
            settings.run.steps_per_control = TOOTH_STEPS;
            settings.run.record_every = TOOTH_STEPS / 10;
        }
        settings.run.duration_s = enters_s(preset) + SHORT_S;
        // Taught in with a light cut: AFC soon stands at its least feed, and an overload is one at once.
        settings.controller.afc.references_n = vec![AFC_REFERENCE_N];
        settings.controller.afc.f_min_percent = 80.0;
        settings.controller.afc.overload_s = 0.1;
    });
    shortened.expect("every base preset may be cut short")
}

/// When the tool meets the work, s: a part of cuts is approached at the programmed feed.
fn enters_s(scenario: &Scenario) -> f64 {
    if scenario.workpiece.cuts.is_empty() {
        return 0.0;
    }
    APPROACH_MM / (scenario.programmed(0).feed_mm_min / 60.0)
}

/// Digest of a run with changes, their times counted from the entry into the work.
fn run(scenario: &Scenario, changes: &[(f64, &str, Value)], digest: &mut Digest) {
    let mut edits = Edits::none();
    for (after_s, path, value) in changes {
        let at_s = enters_s(scenario) + after_s;
        let edit = Edit { at_s, path: (*path).to_owned(), value: value.clone() };
        edits.push(scenario, edit).expect("these edits fit every base preset");
    }
    let run = Run::complete(scenario, &edits);
    run.recording().rows().iter().for_each(|row| digest.row(row));
}

pub(super) fn text(id: &str) -> Value {
    Value::Text(id.to_owned())
}

/// A controller from the start, the tool worn in the cut, left and taken up again.
fn controller(base: &Scenario, kind: ControllerKind) -> String {
    let scenario = base.with(|settings| settings.controller.kind = kind);
    let scenario = scenario.expect("a controller goes with any scenario");
    let other = if kind == ControllerKind::ConstantFeed {
        ControllerKind::Tracking
    } else {
        ControllerKind::ConstantFeed
    };
    let mut digest = Digest::default();
    run(
        &scenario,
        &[
            (0.4, "plant.wear_factor", Value::Float(1.15)),
            (0.8, "controller.kind", text(other.id())),
            (1.0, "controller.kind", text(kind.id())),
            (1.2, "belief.dead_time_s", Value::Float(0.1)),
        ],
        &mut digest,
    );
    digest.hex()
}

/// A tool that wears out while its sound is observed, at the programmed speed or at an adjusted one; a
/// controller that works out the speed itself would hide the adjustment.
fn worn(base: &Scenario, adjust_speed: bool) -> Scenario {
    let scenario = base.with(|settings| {
        settings.run.duration_s = enters_s(base) + WORN_S;
        settings.controller.kind = ControllerKind::ConstantFeed;
        settings.wear.model = WearModel::Life;
        settings.wear.time_scale = 600.0;
        settings.wear.adjust_speed = adjust_speed;
    });
    scenario.expect("the coupled base presets may be worn")
}

/// A run without changes.
pub(super) fn undisturbed(scenario: &Scenario) -> String {
    let mut digest = Digest::default();
    run(scenario, &[], &mut digest);
    digest.hex()
}

/// The calibrations of [`drives_and_calibrations`]; what else there is has variants of its own.
const CALIBRATIONS: [Calibration; 3] =
    [Calibration::Printed, Calibration::Restored, Calibration::Identified];

/// Short runs with every drive and calibration, changed in the cut.
fn drives_and_calibrations(base: &Scenario) -> String {
    let mut digest = Digest::default();
    for kind in FeedDriveKind::ALL {
        for (set, calibration) in
            ModelSet::ALL.iter().flat_map(|set| CALIBRATIONS.iter().map(move |c| (*set, *c)))
        {
            let scenario = base.with(|settings| {
                settings.feed_drive.kind = *kind;
                settings.plant.model_set = set;
                settings.plant.calibration = calibration;
                settings.belief.model_set = set;
                settings.belief.calibration = calibration;
            });
            let scenario = scenario.expect("any drive and models go with a map of force");
            run(
                &scenario,
                &[
                    (0.1, "cnc.override_quantised", Value::Bool(true)),
                    (0.2, "cnc.override_rate_limited", Value::Bool(true)),
                    (0.3, "noise.level", Value::Float(1.5)),
                    (0.5, "controller.kind", text("tracking")),
                    (0.6, "plant.force_model", text("neural")),
                    (0.7, "plant.wear_factor", Value::Float(1.2)),
                    (0.8, "plant.force_model", text("neural_literal")),
                    (0.75, "controller.kind", text("unks")),
                    (0.85, "controller.kind", text("preview")),
                    (0.9, "cnc.dead_time_s", Value::Float(0.033)),
                    (0.95, "controller.kind", text("mrac")),
                    (1.05, "controller.kind", text("adjustable_pi")),
                    (1.07, "wear.time_scale", Value::Float(9e3)),
                    (1.08, "wear.model", text("life")),
                    (1.1, "controller.kind", text("sdnrp")),
                    (1.2, "plant.force_model", text("formula")),
                    (1.3, "controller.kind", text("division")),
                    (1.4, "controller.kind", text("p")),
                ],
                &mut digest,
            );
        }
    }
    digest.hex()
}

/// The coefficients of every drive for several steps: the matrix exponential comes from a library,
/// which must give the same bits everywhere too.
fn drives() -> String {
    let mut digest = Digest::default();
    for kind in FeedDriveKind::ALL {
        for dt_s in [5e-6, 1e-3, 7e-3, 2e-2] {
            let drive = ExactDrive::new(*kind, dt_s);
            drive.coefficient_bits().into_iter().for_each(|word| digest.word(word));
        }
    }
    digest.hex()
}

/// The plan, iteration by iteration, and the shipped networks; the message where the preset cannot
/// be planned.
pub(super) fn plan(preset: &Scenario) -> String {
    let mut digest = Digest::default();
    NeuralForce::output_bits().into_iter().for_each(|word| digest.word(word));
    let job = match PlanJob::complete(preset) {
        Ok(job) => job,
        Err(error) => return error.to_string(),
    };
    for step in job.history() {
        digest.word(step.best.value.to_bits());
        digest.word(step.mean_value.to_bits());
    }
    let optimum = job.optimum();
    digest.word(optimum.feed_mm_min.to_bits());
    digest.word(optimum.speed_rpm.to_bits());
    digest.hex()
}

/// Both variants and all parameters of the machine: frequency response, and poles and residues
/// from the library's eigenvalues.
fn machines(preset: &MachineSettings) -> String {
    let mut digest = Digest::default();
    for variant in Variant::ALL {
        for parameters in Parameters::ALL {
            let settings =
                MachineSettings { variant: *variant, parameters: *parameters, ..preset.clone() };
            let machine = FiveMass::new(&settings);
            for f_hz in [0.0, 110.0, 580.0, 3000.0] {
                let solved = frf::gauss(&machine, f_hz).map_or(f64::NAN, |r| r.grel.re);
                digest.word(solved.to_bits());
                digest.word(frf::tree(&machine, f_hz).grel.im.to_bits());
            }
            if let Ok(reduction) = Reduction::new(&machine) {
                let response = ModalResponse::new(&reduction, 1e-4, 0.1);
                reduction.bits().into_iter().for_each(|word| digest.word(word));
                response.coefficient_bits().into_iter().for_each(|word| digest.word(word));
            }
        }
    }
    digest.hex()
}

/// Trends, predictions, adjusted speeds and the measured surface over the tool's life.
pub(super) fn tool_life(preset: &Scenario) -> String {
    let mut digest = Digest::default();
    let model = machine_life::model(preset);
    for x in [0.0, 0.3, 1.0] {
        let point = model.at(x);
        digest.word(point.sound.to_bits());
        digest.word(point.ra_um.to_bits());
    }
    let rough = surface(&model, &preset.profile, preset.tool.runout_um, 0.5, 1);
    digest.word(rough.map_or(f64::NAN, |rough| rough.rz_um).to_bits());
    let mut life = AdaptiveLife::new(preset, true);
    life.advance_by(25);
    for minute in life.minutes() {
        digest.word(minute.cutting_speed_m_min.to_bits());
        digest.word(minute.remaining_min.unwrap_or(f64::NAN).to_bits());
    }
    digest.hex()
}
