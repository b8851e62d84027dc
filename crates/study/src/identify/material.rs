//! The force of a material over that of Ck45 at 200 HB, from forces that were recorded in a cut
//! (`steadycut identify material`): the one factor by which the plant's force model takes a material
//! ([`crate::blocks::cutting::material`]).
//!
//! ```text
//! F_i = k M(f_i, n_i, engagement),  k = sum F M / sum M^2        HB = HB_0 (k/k_0)^(1/0.4)
//! ```
//!
//! M is the plant's own model for Ck45 at 200 HB with a sharp tool, where that is a map; F the largest force of a revolution,
//! as controllers see it. Noise of a cut is correlated, so that samples are no independent readings: the interval of 95 % is
//! that of the factors of batches of the recording, one after the other, by Student's distribution (B. Schmeiser, Batch size
//! effects in the analysis of simulation output, Operations Research 30, 1982).

use super::EstimatedValue;
use super::estimate::explained;
use super::gp::constants::t_quantile;
use crate::base::language::tr;
use crate::base::math;
use crate::base::settings::{SettingError, Value};
use crate::base::stats;
use crate::blocks::cutting::force_model::law::ForceSetup;
use crate::blocks::cutting::material::Material;
use crate::blocks::cutting::process::PlantSettings;
use crate::blocks::cutting::tool_path::ToolPath;
use crate::models::formula_model::OwnFormula;
use crate::models::genetic::FormulaSettings;
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;
use crate::run::scenario_file;

/// Fewest samples, and batches of them.
const LEAST_SAMPLES: usize = 40;
const BATCHES: usize = 20;
/// Exponent of the hardness ratio, as the materials have it.
const HARDNESS_EXPONENT: f64 = 0.4;
/// Hardness of the material's formula, HB: the range of `plant.hardness_hb`.
const HARDNESS_HB: [f64; 2] = [60.0, 500.0];

/// What was recorded of a cut, sample by sample.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CutSamples {
    /// Largest force of a revolution, N.
    pub force_n: Vec<f64>,
    /// Feed, mm/min.
    pub feed_mm_min: Vec<f64>,
    /// Spindle speed, 1/min.
    pub speed_rpm: Vec<f64>,
    /// Position along the path, mm; empty where the cut has one depth.
    pub position_mm: Vec<f64>,
}

/// What was identified.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialFit {
    /// Force over that of Ck45 at 200 HB.
    pub factor: EstimatedValue,
    /// Hardness at which the scenario's material has this factor, HB.
    pub hardness_hb: EstimatedValue,
    /// Hardness that the factor counts from in the written formula, HB: that of the scenario.
    pub at_hb: f64,
    /// Root mean square of what is left, N.
    pub rest_n: f64,
    /// Samples used: those in which the model has a force.
    pub samples: usize,
    /// Share of them in which the model was used outside its range.
    pub outside: f64,
    /// Share of the force's variation that the model explains.
    pub r2: f64,
    /// The number of each used sample, the force there and the model's, N.
    pub forces: Vec<(usize, [f64; 2])>,
}

/// The model's force at every sample in Ck45 at 200 HB with a sharp tool, N, and whether it is within its range.
fn modelled(scenario: &Scenario, samples: &CutSamples) -> Result<Vec<(f64, bool)>, String> {
    let plant = PlantSettings {
        material: Material::Ck45,
        hardness_hb: Material::Ck45.hardness_hb(),
        wear_factor: 1.0,
        ..scenario.plant.clone()
    };
    let formulas = FormulaSettings { material: OwnFormula::default(), ..scenario.formula.clone() };
    let mut path = ToolPath::new(&scenario.workpiece, scenario.tool.outline());
    let setup = ForceSetup {
        plant: &plant,
        formulas: &formulas,
        tool: &scenario.tool,
        radial_depth_mm: scenario.workpiece.radial_depth_mm,
        several: path.is_several(),
        depth_max_mm: path.depth_max_mm(),
        dt_s: scenario.dt_s(),
        window: u64::from(scenario.run.steps_per_control),
    };
    let mut all = Vec::with_capacity(samples.force_n.len());
    for (i, (feed, speed)) in samples.feed_mm_min.iter().zip(&samples.speed_rpm).enumerate() {
        let position_mm = samples.position_mm.get(i).copied().unwrap_or(0.0);
        while path.next_cut(position_mm).is_some() {}
        let here = path.place(position_mm);
        let place = path.loaded(position_mm, here);
        let force = plant.force_model.at(&setup, *feed, *speed, &place).ok_or_else(|| {
            tr!(
                "`plant.force_model` is {id}, tooth by tooth: expected is a scenario whose force is a map; `steadycut identify force` fits the teeth",
                id = plant.force_model.id()
            )
        })?;
        all.push((force.value, force.valid));
    }
    Ok(all)
}

fn checked(samples: &CutSamples) -> Result<(), String> {
    let count = samples.force_n.len();
    let CutSamples { force_n, feed_mm_min, speed_rpm, position_mm } = samples;
    let lengths = [feed_mm_min.len(), speed_rpm.len()];
    let placed = position_mm.is_empty() || position_mm.len() == count;
    if count < LEAST_SAMPLES || lengths != [count; 2] || !placed {
        return Err(tr!(
            "the recording has {count} samples of the force: expected are at least {least}, and as many of feed, speed and position",
            count = count,
            least = LEAST_SAMPLES
        ));
    }
    for (name, values) in [
        (tr("force"), force_n),
        (tr("feed"), feed_mm_min),
        (tr("spindle speed"), speed_rpm),
        (tr("position"), position_mm),
    ] {
        if let Some(i) = values.iter().position(|x| !x.is_finite()) {
            return Err(tr!("{name}: sample {sample} is no number", name = name, sample = i + 1));
        }
    }
    if position_mm.windows(2).any(|pair| pair[1] < pair[0]) {
        return Err(tr("the position falls: expected is that along the path").to_owned());
    }
    Ok(())
}

/// The factor of the material that was cut.
///
/// # Errors
/// Too few samples, some that are no numbers; a plant whose force is no map; no sample in the cut.
pub fn identify_material(scenario: &Scenario, samples: &CutSamples) -> Result<MaterialFit, String> {
    checked(samples)?;
    let model = modelled(scenario, samples)?;
    // A tool that stands cuts nothing, whatever its model says.
    let cuts = |i: &usize| {
        model[*i].0 > 0.0 && samples.feed_mm_min[*i] > 0.0 && samples.speed_rpm[*i] > 0.0
    };
    let used: Vec<usize> = (0..model.len()).filter(cuts).collect();
    let pairs: Vec<([f64; 2], bool)> =
        used.iter().map(|i| ([samples.force_n[*i], model[*i].0], model[*i].1)).collect();
    if pairs.len() < LEAST_SAMPLES {
        return Err(tr!(
            "the model has a force in {count} samples: expected are at least {least} in the cut, with feed in mm/min and speed in 1/min",
            count = pairs.len(),
            least = LEAST_SAMPLES
        ));
    }
    let factor_of = |pairs: &[([f64; 2], bool)]| {
        let product: f64 = pairs.iter().map(|([force, model], _)| force * model).sum();
        let square: f64 = pairs.iter().map(|([_, model], _)| model * model).sum();
        product / square
    };
    let factor = factor_of(&pairs);
    if factor <= 0.0 {
        return Err(tr("the forces are not above 0: expected is the size of the force").to_owned());
    }
    let batch = pairs.len() / BATCHES;
    let batches: Vec<f64> = pairs.chunks_exact(batch).take(BATCHES).map(factor_of).collect();
    let spread = stats::deviation(&batches).unwrap_or(0.0) / (BATCHES as f64).sqrt();
    let half = t_quantile(BATCHES - 1) * spread;
    let material = scenario.plant.material;
    let reference_hb = material.hardness_hb();
    let at_reference = material.force_factor(reference_hb);
    let hardness_hb = reference_hb * math::pow(factor / at_reference, 1.0 / HARDNESS_EXPONENT);
    let left: Vec<f64> = pairs.iter().map(|([force, model], _)| force - factor * model).collect();
    let forces_n: Vec<f64> = pairs.iter().map(|([force, _], _)| *force).collect();
    let fitted =
        |(i, ([force, model], _)): (&usize, &([f64; 2], bool))| (*i, [*force, factor * model]);
    Ok(MaterialFit {
        factor: EstimatedValue { value: factor, half: Some(half) },
        hardness_hb: EstimatedValue {
            value: hardness_hb,
            half: Some(hardness_hb / HARDNESS_EXPONENT * half / factor),
        },
        at_hb: scenario.plant.hardness_hb,
        rest_n: stats::rms(left.iter().copied()).unwrap_or(0.0),
        samples: pairs.len(),
        outside: pairs.iter().filter(|(_, valid)| !valid).count() as f64 / pairs.len() as f64,
        r2: explained(&forces_n, &left),
        forces: used.iter().zip(&pairs).map(fitted).collect(),
    })
}

/// The scenario with the material that was found: the settings, and the text of its file. The factor is that at the
/// scenario's hardness and follows another one by the power that all materials have.
///
/// # Errors
/// A factor that makes no formula.
pub fn scenario_of_material(
    scenario: &Scenario,
    edits: &Edits,
    fit: &MaterialFit,
    source: &str,
) -> Result<(Vec<(String, Value)>, String), SettingError> {
    let [low, high] = HARDNESS_HB;
    let model = serde_json::json!({
        "version": 1,
        "formula": format!("{:?}*(HB/{:?})^{HARDNESS_EXPONENT:?}", fit.factor.value, fit.at_hb),
        "source": source,
        "output": { "name": "k", "unit": "" },
        "inputs": [{ "name": "HB", "unit": "HB", "low": low, "high": high }],
    });
    let changes = vec![
        ("formula.material".to_owned(), Value::Text(model.to_string())),
        ("plant.wear_factor".to_owned(), Value::Float(1.0)),
    ];
    let mut found = scenario.clone();
    found.set_all(&changes)?;
    let told = |x: EstimatedValue, digits: usize| {
        format!("{:.digits$} +- {:.digits$}", x.value, x.half.unwrap_or(f64::NAN))
    };
    let text = format!(
        "# The material identified by `steadycut identify material`: {source}.\n\
         # Its force is {} times that of Ck45 at 200 HB, by {} samples; +- is half a 95 % interval.\n\
         # {} would have it at {} HB. {:.2} N are left (rms).\n{}",
        told(fit.factor, 4),
        fit.samples,
        scenario.plant.material.label(),
        told(fit.hardness_hb, 1),
        fit.rest_n,
        scenario_file::write(&found, edits)
    );
    Ok((changes, text))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::control::ControllerKind;
    use crate::run::one_run::Run;
    use crate::run::presets::load;

    /// A run at constant feed in a material with noise, and its rows as a recording.
    fn recorded(material: Material, hardness_hb: f64, seed: u32) -> (Scenario, CutSamples) {
        let cut = load("table3-5-noise").unwrap().with(|s| {
            s.controller.kind = ControllerKind::ConstantFeed;
            s.run.duration_s = 12.0;
            s.run.seed = seed;
            s.noise.level = 1.0;
        });
        let cut = cut.unwrap();
        let hard = cut.with(|s| {
            s.plant.material = material;
            s.plant.hardness_hb = hardness_hb;
        });
        let run = Run::complete(&hard.unwrap(), &Edits::none());
        let rows = run.recording();
        let rows = rows.rows().iter().filter(|row| row.time_s > 1.0);
        let mut samples = CutSamples::default();
        for row in rows {
            samples.force_n.push(row.force_measured_n);
            samples.feed_mm_min.push(row.feed_mm_min);
            samples.speed_rpm.push(row.spindle_rpm);
            samples.position_mm.push(row.position_mm);
        }
        (cut, samples)
    }

    #[test]
    fn the_material_of_a_run_comes_back_from_its_forces() {
        let mut held = 0;
        for (material, hardness_hb, seed) in [
            (Material::Ck45, 200.0, 1),
            (Material::Ck45, 260.0, 2),
            (Material::Crmo42, 280.0, 3),
            (Material::Al7075, 150.0, 4),
            (Material::Ck45, 200.0, 5),
        ] {
            let (cut, samples) = recorded(material, hardness_hb, seed);
            let fit = identify_material(&cut, &samples).unwrap();
            let known = material.force_factor(hardness_hb);
            assert!((fit.factor.value / known - 1.0).abs() < 0.02, "{known}: {fit:?}");
            held += u32::from((fit.factor.value - known).abs() <= fit.factor.half.unwrap());
            if material == Material::Ck45 {
                assert!((fit.hardness_hb.value / hardness_hb - 1.0).abs() < 0.05, "{fit:?}");
            }
            // The scenario cuts as the recording did, whatever its material is called.
            let (_, text) =
                scenario_of_material(&cut, &Edits::none(), &fit, "from a test").unwrap();
            let (read, _) = scenario_file::parse(&text).unwrap();
            let factor = read.formula.material_factor(read.plant.hardness_hb).unwrap();
            assert!((factor.value - fit.factor.value).abs() < 1e-12 && factor.valid);
        }
        assert!(held >= 4, "{held} of 5 intervals hold the truth");
    }

    #[test]
    fn recordings_that_tell_nothing_are_refused() {
        let (cut, sound) = recorded(Material::Ck45, 200.0, 1);
        let short = CutSamples { force_n: vec![1.0; 3], ..sound.clone() };
        let mut holed = sound.clone();
        holed.feed_mm_min[7] = f64::NAN;
        let still = CutSamples { feed_mm_min: vec![0.0; sound.force_n.len()], ..sound.clone() };
        let turned =
            CutSamples { force_n: sound.force_n.iter().map(|x| -x).collect(), ..sound.clone() };
        let mut back = sound.clone();
        back.position_mm.reverse();
        for (samples, part) in [
            (short, "3 samples of the force: expected are at least 40"),
            (holed, "feed: sample 8 is no number"),
            (still, "in the cut"),
            (turned, "not above 0"),
            (back, "the position falls"),
        ] {
            let error = identify_material(&cut, &samples).unwrap_err();
            assert!(error.contains(part), "{part}: {error}");
        }
        let teeth = load("experiment-1").unwrap();
        let error = identify_material(&teeth, &sound).unwrap_err();
        assert!(error.contains("identify force"), "{error}");
    }
}
