//! Golden values: per shipped preset the number of ticks, the digest and a handful of metrics. The
//! same JSON comes from native builds and from wasm, so a difference anywhere shows.

use serde_json::{Map, json};

use crate::base::settings::Value;
use crate::blocks::machine::response::ModalResponse;
use crate::machine_life;
use crate::machine_life::adaptive::AdaptiveLife;
use crate::machine_life::surface::surface;
use crate::models::feed_drive::{ExactDrive, FeedDriveKind};
use crate::models::genetic::{Calibration, ModelSet};
use crate::models::neural_force::NeuralForce;
use crate::models::structure::frf;
use crate::models::structure::parameters::Parameters;
use crate::models::structure::reduction::Reduction;
use crate::models::structure::{FiveMass, MachineSettings, Variant};
use crate::plan::PlanJob;
use crate::run::digest::Digest;
use crate::run::edits::{Edit, Edits};
use crate::run::one_run::Run;
use crate::run::presets::{PRESETS, load};
use crate::run::scenario::Scenario;

/// Golden values of all presets, by name.
///
/// # Panics
/// Never: a test loads every shipped preset.
#[must_use]
pub fn golden() -> Map<String, serde_json::Value> {
    let mut all = Map::new();
    for preset in PRESETS {
        let scenario = load(preset.name).expect("presets are tested");
        let run = Run::complete(&scenario, &Edits::none());
        let m = run.metrics();
        let entry = json!({
            "ticks": run.ticks(),
            "digest": run.recording().digest(),
            "variants": variants(&scenario),
            "plan": plan(&scenario),
            "ra_final_um": rounded(m.ra_final_um),
            "force_final_n": rounded(m.force_final_n),
            "feed_final_mm_min": rounded(m.feed_final_mm_min),
            "in_tolerance_percent": m.in_tolerance_percent.map(rounded),
        });
        all.insert(preset.name.to_owned(), entry);
    }
    all
}

/// Digest over the plan of a preset, iteration by iteration, and over the shipped networks; the
/// message where the preset cannot be planned.
fn plan(preset: &Scenario) -> String {
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

/// Digest over what the preset itself does not show: the coefficients of every drive for several
/// steps (the matrix exponential comes from a library, which must give the same bits everywhere
/// too), and short runs with every drive, calibration and controller, changed in the cut.
fn variants(preset: &Scenario) -> String {
    let mut digest = Digest::default();
    machines(&preset.machine, &mut digest);
    tool_life(preset, &mut digest);
    for kind in FeedDriveKind::ALL {
        for dt_s in [5e-6, 1e-3, 7e-3, 2e-2] {
            for word in ExactDrive::new(*kind, dt_s).coefficient_bits() {
                digest.word(word);
            }
        }
        for (set, calibration) in
            ModelSet::ALL.iter().flat_map(|set| Calibration::ALL.iter().map(move |c| (*set, *c)))
        {
            let mut scenario = preset.clone();
            scenario.run.duration_s = 1.5;
            scenario.feed_drive.kind = *kind;
            scenario.plant.model_set = set;
            scenario.plant.calibration = calibration;
            scenario.belief.model_set = set;
            scenario.belief.calibration = calibration;
            let mut edits = Edits::none();
            for (at_s, path, value) in [
                (0.1, "cnc.override_quantised", Value::Bool(true)),
                (0.2, "cnc.override_rate_limited", Value::Bool(true)),
                (0.3, "noise.level", Value::Float(1.5)),
                (0.5, "controller.kind", Value::Text("tracking".to_owned())),
                (0.6, "plant.force_model", Value::Text("neural".to_owned())),
                (0.7, "plant.wear_factor", Value::Float(1.2)),
                (0.8, "plant.force_model", Value::Text("neural_literal".to_owned())),
                (0.75, "controller.kind", Value::Text("unks".to_owned())),
                (0.9, "cnc.dead_time_s", Value::Float(0.033)),
                (0.95, "controller.kind", Value::Text("mrac".to_owned())),
                (1.05, "controller.kind", Value::Text("adjustable_pi".to_owned())),
                (1.07, "wear.time_scale", Value::Float(9e3)),
                (1.08, "wear.model", Value::Text("life".to_owned())),
                (1.1, "controller.kind", Value::Text("sdnrp".to_owned())),
            ] {
                let edit = Edit { at_s, path: path.to_owned(), value };
                edits.push(&scenario, edit).expect("these edits fit every preset");
            }
            let run = Run::complete(&scenario, &edits);
            run.recording().rows().iter().for_each(|row| digest.row(row));
        }
    }
    digest.hex()
}

/// Both readings and all parameters of the machine: frequency response, and poles and residues
/// from the library's eigenvalues.
fn machines(preset: &MachineSettings, digest: &mut Digest) {
    for reading in Variant::ALL {
        for parameters in Parameters::ALL {
            let settings =
                MachineSettings { reading: *reading, parameters: *parameters, ..preset.clone() };
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
}

/// Trends, predictions, adjusted speeds and the measured surface over the tool's life.
fn tool_life(preset: &Scenario, digest: &mut Digest) {
    let model = machine_life::model(preset);
    for x in [0.0, 0.3, 1.0] {
        let point = model.at(x);
        digest.word(point.sound.to_bits());
        digest.word(point.ra_um.to_bits());
    }
    let rough = surface(&model, &preset.profile, preset.plant.runout_um, 0.5, 1);
    digest.word(rough.map_or(f64::NAN, |rough| rough.rz_um).to_bits());
    let mut life = AdaptiveLife::new(preset, true);
    life.advance(25);
    for minute in life.minutes() {
        digest.word(minute.cutting_speed_m_min.to_bits());
        digest.word(minute.remaining_min.unwrap_or(f64::NAN).to_bits());
    }
}

/// Six decimals: enough to read; the digest holds the bits.
fn rounded(x: f64) -> f64 {
    (x * 1e6).round() / 1e6
}

/// The text of `tests/golden.json`.
#[must_use]
pub fn to_json() -> String {
    let mut text = format!("{:#}", serde_json::Value::Object(golden()));
    text.push('\n');
    text
}
