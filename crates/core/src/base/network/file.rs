//! Network files: JSON, numbers with nine significant digits. Readers get what was written to the
//! bit, since rounded weights are what a network is judged by.

use serde::{Deserialize, Serialize};

use super::{Activation, Network, ScaledNetwork, Scaling};
use crate::base::files::{JsonLayout, from_json, to_json};
use crate::base::language::tr;

/// Where a network's weights come from: enough to train it again.
#[derive(Clone, Debug, PartialEq)]
pub struct Provenance {
    /// What the training data are and which command made the file.
    pub note: String,
    /// Rows generated, training and hold-out together.
    pub rows: u32,
    /// Seed of data, first weights and order.
    pub seed: u32,
    /// Epochs trained.
    pub epochs: u32,
    /// Learning rate of the first epoch.
    pub rate: f64,
    /// Momentum.
    pub momentum: f64,
    /// Decay of the learning rate.
    pub decay: f64,
}

/// Longest file read, in bytes; a network of the largest size needs less.
const MAX_BYTES: usize = 200_000;
/// Longest note, in bytes.
const MAX_NOTE: usize = 2000;

/// `x` with the nine significant digits of a file.
fn rounded(x: f64) -> f64 {
    format!("{x:.8e}").parse().unwrap_or(x)
}

impl ScaledNetwork {
    /// The network as a file holds it: every number with nine digits.
    #[must_use]
    pub fn as_in_file(mut self) -> Self {
        self.network.weights.iter_mut().for_each(|weight| *weight = rounded(*weight));
        let ranges = self.scaling.inputs.iter_mut().chain(&mut self.scaling.outputs);
        ranges.flatten().for_each(|bound| *bound = rounded(*bound));
        self
    }
}

/// The fields of a network file, in order.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a network")]
pub struct NetworkFile {
    note: String,
    rows: u32,
    seed: u32,
    epochs: u32,
    rate: f64,
    momentum: f64,
    decay: f64,
    sizes: Vec<usize>,
    activation: String,
    linear_output: bool,
    norm_lo: f64,
    norm_hi: f64,
    target_lo: f64,
    target_hi: f64,
    ln_inputs: Vec<bool>,
    xmin: Vec<f64>,
    xmax: Vec<f64>,
    ymin: Vec<f64>,
    ymax: Vec<f64>,
    weights: Vec<f64>,
}

impl NetworkFile {
    /// What is to be written of a network, with the digits of a file.
    #[must_use]
    pub fn new(scaled: &ScaledNetwork, provenance: &Provenance) -> Self {
        let ScaledNetwork { network, scaling } = scaled.clone().as_in_file();
        let Provenance { note, rows, seed, epochs, rate, momentum, decay } = provenance.clone();
        let bounds = |ranges: &[[f64; 2]], end: usize| ranges.iter().map(|r| r[end]).collect();
        Self {
            note,
            rows,
            seed,
            epochs,
            rate,
            momentum,
            decay,
            activation: network.activation.id().to_owned(),
            linear_output: network.linear_output,
            norm_lo: scaling.norm[0],
            norm_hi: scaling.norm[1],
            target_lo: scaling.target[0],
            target_hi: scaling.target[1],
            xmin: bounds(&scaling.inputs, 0),
            xmax: bounds(&scaling.inputs, 1),
            ymin: bounds(&scaling.outputs, 0),
            ymax: bounds(&scaling.outputs, 1),
            ln_inputs: scaling.ln_inputs,
            sizes: network.sizes,
            weights: network.weights,
        }
    }

    /// The network, checked.
    ///
    /// # Errors
    /// Names the field that does not fit, its value and what is allowed.
    pub fn network(self) -> Result<(ScaledNetwork, Provenance), String> {
        if self.note.len() > MAX_NOTE {
            let bytes = self.note.len();
            return Err(tr!(
                "`note` is {n} bytes long: allowed is at most {most}",
                n = bytes,
                most = MAX_NOTE
            ));
        }
        let activation = Activation::from_id(&self.activation).ok_or_else(|| {
            let shown: String = self.activation.chars().take(40).collect();
            let ids: Vec<&str> = Activation::ALL.iter().map(|one| one.id()).collect();
            tr!(
                "`activation` cannot be {found}: allowed is {ids}",
                found = format!("{shown:?}"),
                ids = ids.join(", ")
            )
        })?;
        let network = Network::new(&self.sizes, activation, self.linear_output, self.weights)?;
        let scaling = Scaling {
            norm: [self.norm_lo, self.norm_hi],
            target: [self.target_lo, self.target_hi],
            ln_inputs: self.ln_inputs,
            inputs: ranges(["xmin", "xmax"], self.xmin, self.xmax)?,
            outputs: ranges(["ymin", "ymax"], self.ymin, self.ymax)?,
        };
        scaling.check(&network)?;
        let provenance = Provenance {
            note: self.note,
            rows: self.rows,
            seed: self.seed,
            epochs: self.epochs,
            rate: self.rate,
            momentum: self.momentum,
            decay: self.decay,
        };
        Ok((ScaledNetwork { network, scaling }, provenance))
    }
}

fn ranges(names: [&str; 2], lows: Vec<f64>, highs: Vec<f64>) -> Result<Vec<[f64; 2]>, String> {
    if lows.len() != highs.len() {
        let ([low, high], [a, b]) = (names, [lows.len(), highs.len()]);
        return Err(tr!(
            "`{low}` and `{high}` must be equally long, found {lows} and {highs}",
            low = low,
            high = high,
            lows = a,
            highs = b
        ));
    }
    Ok(lows.into_iter().zip(highs).map(|(low, high)| [low, high]).collect())
}

/// The text of a network file.
#[must_use]
pub fn write(scaled: &ScaledNetwork, provenance: &Provenance) -> String {
    to_json(&NetworkFile::new(scaled, provenance), JsonLayout::FieldALine("  "))
}

/// Reads a network file.
///
/// # Errors
/// Names the field that is missing, unknown or not allowed, its value and what is allowed.
pub fn parse(text: &str) -> Result<(ScaledNetwork, Provenance), String> {
    if text.len() > MAX_BYTES {
        return Err(tr!("longer than {n} bytes", n = MAX_BYTES));
    }
    from_json::<NetworkFile>(text)?.network()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::rng::Stream;

    fn example() -> (ScaledNetwork, Provenance) {
        let stream = Stream::new(5, "test");
        let network = Network::random(&[2, 3, 1], Activation::Sine, true, stream).unwrap();
        let scaling = Scaling {
            norm: [-1.0, 1.0],
            target: [0.0, 1.0],
            ln_inputs: vec![false, true],
            inputs: vec![[-1.0 / 3.0, 2.0], [0.02, 0.2]],
            outputs: vec![[-1e-7 / 3.0, 1234.5]],
        };
        let provenance = Provenance {
            note: "made \"here\"".to_owned(),
            rows: 10,
            seed: 5,
            epochs: 0,
            rate: 0.1,
            momentum: 0.5,
            decay: 0.0,
        };
        (ScaledNetwork { network, scaling }.as_in_file(), provenance)
    }

    #[test]
    fn what_is_written_is_read_to_the_bit() {
        let (scaled, provenance) = example();
        let text = write(&scaled, &provenance);
        assert_eq!(parse(&text).unwrap(), (scaled.clone(), provenance));
        let outputs = scaled.predict(&[0.5, 0.1]);
        assert_eq!(parse(&text).unwrap().0.predict(&[0.5, 0.1])[0].to_bits(), outputs[0].to_bits());
    }

    #[test]
    fn faulty_files_are_refused_by_field() {
        let (scaled, provenance) = example();
        let text = write(&scaled, &provenance);
        for (from, to, named) in [
            ("[2,3,1]", "[2,33,1]", "`sizes`"),
            ("[2,3,1]", "[2,4,1]", "`weights`"),
            ("[2,3,1]", "[2,-3,1]", "`sizes[1]`"),
            ("\"sine\"", "\"relu\"", "`activation`"),
            ("\"linear_output\": true", "\"linear_output\": 1", "`linear_output`"),
            ("\"seed\": 5", "\"seed\": -5", "`seed`"),
            ("\"rate\": 0.1", "\"rate\": null", "`rate`"),
            ("  \"decay\": 0.0,\n", "", "missing field `decay`"),
            ("[false,true]", "[true,true]", "`xmin[0]`"),
            ("[false,true]", "[true]", "`ln_inputs`"),
            ("\"norm_lo\": -1.0", "\"norm_lo\": 1.0", "`norm_lo`"),
            ("\"ymax\": [1234.5]", "\"ymax\": [-9.0]", "`ymin[0]`"),
            ("\"ymax\": [1234.5]", "\"ymax\": []", "`ymax`"),
            ("\"ymax\": [1234.5]", "\"ymax\": [1e999]", "JSON"),
            ("\"note\"", "\"nota\"", "unknown field `nota`, expected one of `note`"),
            ("{\n", "{\n\"extra\": 1,\n", "`extra`"),
        ] {
            let changed = text.replacen(from, to, 1);
            assert_ne!(changed, text, "{from}");
            let error = parse(&changed).unwrap_err();
            assert!(error.contains(named), "{to}: {error}");
        }
        assert!(parse("[]").is_err() && parse("").is_err());
        assert!(parse(&" ".repeat(MAX_BYTES + 1)).unwrap_err().contains("bytes"));
    }
}
