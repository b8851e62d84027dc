//! Network files: JSON, numbers with nine significant digits. Readers get what was written to the
//! bit, since rounded weights are what a network is judged by.

use serde_json::{Map, Value, json};

use super::{Activation, MAX_LAYERS, MAX_WIDTH, Network, ScaledNetwork, Scaling};

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

/// The text of a network file.
#[must_use]
pub fn write(scaled: &ScaledNetwork, provenance: &Provenance) -> String {
    // One field a line.
    format!("{{\n  {}\n}}\n", fields(scaled, provenance).join(",\n  "))
}

/// The same as one line of text, for a part of another file.
#[must_use]
pub fn write_line(scaled: &ScaledNetwork, provenance: &Provenance) -> String {
    format!("{{{}}}", fields(scaled, provenance).join(","))
}

/// The fields of a network file with their names, in order.
fn fields(scaled: &ScaledNetwork, provenance: &Provenance) -> Vec<String> {
    let ScaledNetwork { network, scaling } = scaled;
    let bounds = |ranges: &[[f64; 2]], end: usize| -> Value {
        ranges.iter().map(|range| rounded(range[end])).collect()
    };
    let fields = [
        ("note", json!(provenance.note)),
        ("rows", json!(provenance.rows)),
        ("seed", json!(provenance.seed)),
        ("epochs", json!(provenance.epochs)),
        ("rate", json!(provenance.rate)),
        ("momentum", json!(provenance.momentum)),
        ("decay", json!(provenance.decay)),
        ("sizes", json!(network.sizes)),
        ("activation", json!(network.activation.id())),
        ("linear_output", json!(network.linear_output)),
        ("norm_lo", json!(scaling.norm[0])),
        ("norm_hi", json!(scaling.norm[1])),
        ("target_lo", json!(scaling.target[0])),
        ("target_hi", json!(scaling.target[1])),
        ("ln_inputs", json!(scaling.ln_inputs)),
        ("xmin", bounds(&scaling.inputs, 0)),
        ("xmax", bounds(&scaling.inputs, 1)),
        ("ymin", bounds(&scaling.outputs, 0)),
        ("ymax", bounds(&scaling.outputs, 1)),
        ("weights", network.weights.iter().map(|w| rounded(*w)).collect()),
    ];
    fields.iter().map(|(name, value)| format!("\"{name}\": {value}")).collect()
}

/// Takes fields out of a JSON object; what is left at the end is unknown.
struct Fields(Map<String, Value>);

impl Fields {
    fn take<T>(
        &mut self,
        name: &str,
        allowed: &str,
        read: impl Fn(&Value) -> Option<T>,
    ) -> Result<T, String> {
        let value = self.0.remove(name).ok_or_else(|| format!("`{name}` is missing"))?;
        read(&value).ok_or_else(|| {
            let shown: String = value.to_string().chars().take(40).collect();
            format!("`{name}` cannot be {shown}: allowed is {allowed}")
        })
    }

    fn number(&mut self, name: &str) -> Result<f64, String> {
        self.take(name, "a number", Value::as_f64)
    }

    fn count(&mut self, name: &str) -> Result<u32, String> {
        let read = |value: &Value| value.as_u64().and_then(|count| u32::try_from(count).ok());
        self.take(name, "a whole number from 0 to 4294967295", read)
    }

    fn list<T>(
        &mut self,
        name: &str,
        allowed: &str,
        read: impl Fn(&Value) -> Option<T>,
    ) -> Result<Vec<T>, String> {
        self.take(name, allowed, |value| value.as_array()?.iter().map(&read).collect())
    }

    fn ranges(&mut self, low: &str, high: &str) -> Result<Vec<[f64; 2]>, String> {
        let lows = self.list(low, "a list of numbers", Value::as_f64)?;
        let highs = self.list(high, "a list of numbers", Value::as_f64)?;
        if lows.len() != highs.len() {
            return Err(format!("`{low}` and `{high}` must be equally long"));
        }
        Ok(lows.into_iter().zip(highs).map(|(low, high)| [low, high]).collect())
    }
}

/// Reads a network file.
///
/// # Errors
/// Names the field that is missing, unknown or not allowed, its value and what is allowed.
pub fn parse(text: &str) -> Result<(ScaledNetwork, Provenance), String> {
    if text.len() > MAX_BYTES {
        return Err(format!("longer than {MAX_BYTES} bytes"));
    }
    let map = serde_json::from_str(text).map_err(|error| format!("not a JSON object: {error}"))?;
    from_map(map)
}

/// Reads a network from the fields of its JSON object.
///
/// # Errors
/// As [`parse`].
pub fn from_map(map: Map<String, Value>) -> Result<(ScaledNetwork, Provenance), String> {
    let mut fields = Fields(map);
    let note = |value: &Value| value.as_str().map(str::to_owned).filter(|n| n.len() <= MAX_NOTE);
    let provenance = Provenance {
        note: fields.take("note", &format!("text of at most {MAX_NOTE} bytes"), note)?,
        rows: fields.count("rows")?,
        seed: fields.count("seed")?,
        epochs: fields.count("epochs")?,
        rate: fields.number("rate")?,
        momentum: fields.number("momentum")?,
        decay: fields.number("decay")?,
    };
    let allowed = format!("2 to {MAX_LAYERS} layers of 1 to {MAX_WIDTH} neurons");
    let size = |value: &Value| value.as_u64().and_then(|size| usize::try_from(size).ok());
    let sizes = fields.list("sizes", &allowed, size)?;
    let ids: Vec<&str> = Activation::ALL.iter().map(|activation| activation.id()).collect();
    let activation = |value: &Value| Activation::from_id(value.as_str()?);
    let activation = fields.take("activation", &ids.join(", "), activation)?;
    let linear_output = fields.take("linear_output", "true or false", Value::as_bool)?;
    let weights = fields.list("weights", "a list of numbers", Value::as_f64)?;
    let network = Network::new(&sizes, activation, linear_output, weights)?;
    let scaling = Scaling {
        norm: [fields.number("norm_lo")?, fields.number("norm_hi")?],
        target: [fields.number("target_lo")?, fields.number("target_hi")?],
        ln_inputs: fields.list("ln_inputs", "a list of true and false", Value::as_bool)?,
        inputs: fields.ranges("xmin", "xmax")?,
        outputs: fields.ranges("ymin", "ymax")?,
    };
    scaling.check(&network)?;
    match fields.0.keys().next() {
        Some(unknown) => Err(format!("`{unknown}` is no field of a network file")),
        None => Ok((ScaledNetwork { network, scaling }, provenance)),
    }
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
            ("[2,3,1]", "[2,-3,1]", "`sizes`"),
            ("\"sine\"", "\"relu\"", "`activation`"),
            ("\"linear_output\": true", "\"linear_output\": 1", "`linear_output`"),
            ("\"seed\": 5", "\"seed\": -5", "`seed`"),
            ("\"rate\": 0.1", "\"rate\": null", "`rate`"),
            ("[false,true]", "[true,true]", "`xmin[0]`"),
            ("[false,true]", "[true]", "`ln_inputs`"),
            ("\"norm_lo\": -1.0", "\"norm_lo\": 1.0", "`norm_lo`"),
            ("\"ymax\": [1234.5]", "\"ymax\": [-9.0]", "`ymin[0]`"),
            ("\"ymax\": [1234.5]", "\"ymax\": []", "`ymax`"),
            ("\"ymax\": [1234.5]", "\"ymax\": [1e999]", "JSON"),
            ("\"note\"", "\"nota\"", "`note` is missing"),
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
