//! Machine files: versioned TOML with feed drive, spindle drive, dead time and limits of a machine; the file that `steadycut
//! identify drive` writes is one, too, of a feed drive.
//!
//! A drive is `K / product of (1 - s/pole)` by its `gain` and either `poles`, as [real, imaginary] in rad/s, both of a
//! pair, or `denominator`, the coefficients a0, a1, .. an of a0 + a1 s + .. + an s^n over which K a0 stands.

use serde::Deserialize;

use super::entry::FileEntry;
use super::limits::OwnLimits;
use crate::base::files::from_toml;
use crate::base::language::{text, tr};
use crate::base::math;
use crate::base::settings::{SettingError, Structure, Value};
use crate::models::feed_drive::DEAD_TIME_MAX_S;
use crate::models::structure::Complex;
use crate::models::transfer::{MAX_ORDER, TransferPoles};

pub(super) const WHAT: &str = text!("machine file");
/// Gain of a drive: what is allowed.
const GAIN: [f64; 2] = [0.1, 10.0];
/// Imaginary parts below this share of a pole's size are rounding.
const REAL: f64 = 1e-6;
/// Largest difference of the two poles of a pair, as a share of their size.
const PAIRED: f64 = 1e-6;
/// Iterations of the search for roots, and the change that ends it.
const ITERATIONS: u32 = 500;
const FOUND: f64 = 1e-15;

/// A drive of one's own.
#[derive(Clone, Debug, PartialEq)]
pub struct OwnTransfer {
    /// Its poles.
    pub poles: TransferPoles,
    /// Its gain.
    pub gain: f64,
}

/// A machine as its file describes it.
#[derive(Clone, Debug, PartialEq)]
pub struct MachineFile {
    /// What it is called.
    pub title: String,
    /// Where its values come from.
    pub source: String,
    /// Dead time of the command channel, s.
    pub dead_time_s: Option<f64>,
    /// Feed drive.
    pub feed_drive: Option<OwnTransfer>,
    /// Spindle drive.
    pub spindle_drive: Option<OwnTransfer>,
    /// How far it goes.
    pub limits: Option<OwnLimits>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Whole {
    version: i64,
    title: Option<String>,
    source: String,
    dead_time_s: Option<f64>,
    // What `identify drive` writes beside its poles: the structure and how well it fits, which no run reads.
    #[serde(rename = "structure")]
    _structure: Option<String>,
    #[serde(rename = "fit")]
    _fit: Option<toml::Table>,
    gain: Option<f64>,
    poles: Option<Vec<[f64; 2]>>,
    feed_drive: Option<Drive>,
    spindle_drive: Option<Drive>,
    limits: Option<OwnLimits>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Drive {
    gain: f64,
    poles: Option<Vec<[f64; 2]>>,
    denominator: Option<Vec<f64>>,
}

/// The poles of a pair by the one with positive imaginary part; both have to be there.
fn paired(listed: &[[f64; 2]]) -> Result<Vec<[f64; 2]>, String> {
    let size = |[re, im]: [f64; 2]| (re * re + im * im).sqrt();
    let mut lower: Vec<[f64; 2]> = listed.iter().copied().filter(|[_, im]| *im < 0.0).collect();
    let mut poles = Vec::new();
    for [re, im] in listed.iter().copied().filter(|[_, im]| *im >= 0.0) {
        if im > 0.0 {
            let near =
                |other: &[f64; 2]| size([other[0] - re, other[1] + im]) <= PAIRED * size([re, im]);
            let Some(place) = lower.iter().position(near) else {
                return Err(tr!(
                    "the pole {re} and {im} rad/s lacks its conjugate, {re} and {other}",
                    re = re,
                    im = im,
                    other = -im
                ));
            };
            lower.swap_remove(place);
        }
        poles.push([re, im]);
    }
    match lower.first() {
        None => Ok(poles),
        Some([re, im]) => Err(tr!(
            "the pole {re} and {im} rad/s lacks its conjugate, {re} and {other}",
            re = *re,
            im = *im,
            other = -im
        )),
    }
}

/// The roots of a0 + a1 s + .. + an s^n, by the method of Durand and Kerner; pairs by the one with positive imaginary
/// part.
fn roots(coefficients: &[f64]) -> Vec<[f64; 2]> {
    let order = coefficients.len() - 1;
    let leading = coefficients[order];
    // In the size that the roots have on the average, so that the search begins among them.
    let size = math::pow((coefficients[0] / leading).abs(), 1.0 / order as f64);
    let mut scale = 1.0;
    let scaled: Vec<f64> = coefficients
        .iter()
        .map(|a| {
            let value = a / leading * scale;
            scale *= size;
            value
        })
        .collect();
    let whole = scaled[order];
    let value = |s: Complex| {
        scaled.iter().rev().fold(Complex::from(0.0), |sum, a| sum * s + Complex::from(a / whole))
    };
    // Points on a circle, none of them real and no two conjugate.
    let start = |k: usize| {
        let angle = math::TAU * k as f64 / order as f64 + 0.4;
        Complex::new(math::cos(angle), math::sin(angle))
    };
    let mut found: Vec<Complex> = (0..order).map(start).collect();
    for _ in 0..ITERATIONS {
        let mut moved = 0.0_f64;
        for k in 0..order {
            let others = (0..order).filter(|other| *other != k);
            let apart =
                others.fold(Complex::from(1.0), |all, other| all * (found[k] - found[other]));
            let step = value(found[k]) / apart;
            if step.re.is_finite() && step.im.is_finite() {
                found[k] -= step;
                moved = moved.max(step.norm_sqr().sqrt());
            }
        }
        if moved < FOUND {
            break;
        }
    }
    let real = |z: &Complex| z.im.abs() <= REAL * z.norm_sqr().sqrt();
    found
        .iter()
        .filter(|z| real(z) || z.im > 0.0)
        .map(|z| [z.re * size, if real(z) { 0.0 } else { z.im * size }])
        .collect()
}

/// A drive of a section, or of the top of the file.
fn drive(file: &str, section: &'static str, read: Drive) -> Result<OwnTransfer, SettingError> {
    let at = |key| FileEntry { what: WHAT, text: file, section, key };
    let gain = at("gain").number(read.gain, GAIN)?;
    let (key, listed) = match (read.poles, read.denominator) {
        (Some(poles), None) => {
            ("poles", paired(&poles).map_err(|problem| at("poles").fault(&problem))?)
        }
        (None, Some(a)) => {
            let positive = a.iter().all(|a| *a > 0.0 && a.is_finite());
            if !positive || !(2..=MAX_ORDER + 1).contains(&a.len()) {
                let allowed = tr!(
                    "2 to {n} coefficients above 0, a0 first: with another sign no drive is stable",
                    n = MAX_ORDER + 1
                );
                return Err(at("denominator").refused(&format!("{a:?}"), &allowed));
            }
            ("denominator", roots(&a))
        }
        (Some(_), Some(_)) | (None, None) => {
            return Err(at("gain").fault(tr(
                "one of `poles` and `denominator` is wanted beside it, not both and not neither",
            )));
        }
    };
    if listed.is_empty() {
        return Err(at(key).fault(tr("a drive has at least one pole")));
    }
    let poles = TransferPoles::new(listed).map_err(|problem| at(key).fault(&problem))?;
    Ok(OwnTransfer { poles, gain })
}

impl MachineFile {
    /// Reads a machine file, or the file of a drive that was identified.
    ///
    /// # Errors
    /// Names line, entry and value, and what is allowed: poles that are stable, a gain above 0, limits within the range of
    /// their settings.
    pub fn parse(file: &str) -> Result<Self, SettingError> {
        let read: Whole = from_toml(file)
            .map_err(|problem| SettingError::Format { what: tr(WHAT).to_owned(), problem })?;
        let at = |key| FileEntry { what: WHAT, text: file, section: "", key };
        at("version").version(read.version)?;
        let source = at("source").words(read.source)?;
        let title = read.title.map(|title| at("title").words(title)).transpose()?;
        let dead_time_s = read.dead_time_s;
        let dead_time_s =
            dead_time_s.map(|s| at("dead_time_s").number(s, [0.0, DEAD_TIME_MAX_S])).transpose()?;
        let top = match (read.poles, read.gain) {
            (None, None) => None,
            (Some(poles), gain) => {
                let gain = gain.unwrap_or(1.0);
                Some(drive(file, "", Drive { gain, poles: Some(poles), denominator: None })?)
            }
            (None, Some(_)) => {
                return Err(at("gain").fault(tr("it stands without `poles`")));
            }
        };
        let own =
            |section, read: Option<Drive>| read.map(|read| drive(file, section, read)).transpose();
        let feed_drive = own("feed_drive", read.feed_drive)?;
        if top.is_some() && feed_drive.is_some() {
            return Err(at("poles").fault(tr("the feed drive stands in [feed_drive] already")));
        }
        let spindle_drive = own("spindle_drive", read.spindle_drive)?;
        let feed_drive = top.or(feed_drive);
        let limits = read.limits.map(|limits| limits.checked(file, spindle_drive.is_some()));
        let limits = limits.transpose()?;
        let drives = feed_drive.is_some() || spindle_drive.is_some();
        if !drives && dead_time_s.is_none() && limits.is_none() {
            let problem = tr(
                "there is nothing in it: dead_time_s, [feed_drive], [spindle_drive] or [limits]",
            )
            .to_owned();
            return Err(SettingError::Format { what: tr(WHAT).to_owned(), problem });
        }
        let title = title.unwrap_or_else(|| source.clone());
        Ok(Self { title, source, dead_time_s, feed_drive, spindle_drive, limits })
    }

    /// The settings that it makes.
    #[must_use]
    pub fn changes(&self) -> Vec<(String, Value)> {
        let mut changes = Vec::new();
        for (group, drive) in
            [("feed_drive", &self.feed_drive), ("spindle_drive", &self.spindle_drive)]
        {
            if let Some(OwnTransfer { poles, gain }) = drive {
                changes.push((format!("{group}.poles"), Structure::write(poles)));
                changes.push((format!("{group}.gain"), Value::Float(*gain)));
            }
        }
        changes.extend(self.dead_time_s.map(|s| ("cnc.dead_time_s".to_owned(), Value::Float(s))));
        changes.extend(self.limits.iter().flat_map(OwnLimits::changes));
        changes
    }
}
