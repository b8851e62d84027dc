//! Min-max normalisation: from values with units to a network's values and back.
//!
//! An input x (its logarithm where `ln_inputs` says so) between its least and largest value of the
//! training data is mapped linearly to norm_lo..norm_hi, a target to target_lo..target_hi.

use super::{Layer, MAX_WIDTH, Network};
use crate::base::language::tr;
use crate::base::math;

/// Ranges of a network's inputs and outputs.
#[derive(Clone, Debug, PartialEq)]
pub struct Scaling {
    /// Range of normalised inputs.
    pub norm: [f64; 2],
    /// Range of normalised targets.
    pub target: [f64; 2],
    /// Which inputs are replaced by their natural logarithm.
    pub ln_inputs: Vec<bool>,
    /// Least and largest value of each input, with its unit (before the logarithm).
    pub inputs: Vec<[f64; 2]>,
    /// Least and largest value of each output, with its unit.
    pub outputs: Vec<[f64; 2]>,
}

impl Scaling {
    /// Checks it against a network's first and last layer.
    ///
    /// # Errors
    /// Names the field, and what is allowed.
    pub fn check(&self, network: &Network) -> Result<(), String> {
        let sizes = network.sizes();
        let (inputs, outputs) = (sizes[0], sizes[sizes.len() - 1]);
        let increasing = |[low, high]: &[f64; 2]| low.is_finite() && high.is_finite() && low < high;
        for (name, found, needed) in [
            ("ln_inputs", self.ln_inputs.len(), inputs),
            ("xmin` and `xmax", self.inputs.len(), inputs),
            ("ymin` and `ymax", self.outputs.len(), outputs),
        ] {
            if found != needed {
                return Err(tr!(
                    "`{name}` must hold {needed} values each, found {found}",
                    name = name,
                    needed = needed,
                    found = found
                ));
            }
        }
        for (i, range) in self.inputs.iter().enumerate() {
            if !increasing(range) || self.ln_inputs[i] && range[0] <= 0.0 {
                let [low, high] = range;
                return Err(tr!(
                    "`xmin[{index}]` and `xmax[{index}]` are {low} and {high}: they must be finite and \
                     ascending, positive where `ln_inputs` is true",
                    index = i,
                    low = *low,
                    high = *high
                ));
            }
        }
        if let Some(i) = self.outputs.iter().position(|range| !increasing(range)) {
            return Err(tr!(
                "`ymin[{index}]` and `ymax[{index}]` must be finite and ascending",
                index = i
            ));
        }
        if !increasing(&self.norm) || !increasing(&self.target) {
            let problem = tr("`norm_lo`, `norm_hi` and `target_lo`, `target_hi` must ascend");
            return Err(problem.to_owned());
        }
        Ok(())
    }

    /// Slope and intercept that give input `i` normalised, from x or ln x.
    #[must_use]
    pub fn input_map(&self, i: usize) -> [f64; 2] {
        let [low, high] = self.inputs[i].map(|x| if self.ln_inputs[i] { math::ln(x) } else { x });
        let slope = (self.norm[1] - self.norm[0]) / (high - low);
        [slope, self.norm[0] - slope * low]
    }

    /// Slope and intercept that give output `i` with its unit from its normalised value.
    #[must_use]
    pub fn output_map(&self, i: usize) -> [f64; 2] {
        let [low, high] = self.outputs[i];
        let slope = (high - low) / (self.target[1] - self.target[0]);
        [slope, low - slope * self.target[0]]
    }

    /// Normalised inputs.
    #[must_use]
    pub fn normal_inputs(&self, inputs: &[f64]) -> Layer {
        let mut normal = [0.0; MAX_WIDTH];
        for (i, x) in inputs.iter().take(self.inputs.len()).enumerate() {
            let [slope, intercept] = self.input_map(i);
            normal[i] = slope * if self.ln_inputs[i] { math::ln(*x) } else { *x } + intercept;
        }
        normal
    }

    /// Normalised targets.
    #[must_use]
    pub fn normal_targets(&self, outputs: &[f64]) -> Layer {
        let mut normal = [0.0; MAX_WIDTH];
        for (i, y) in outputs.iter().take(self.outputs.len()).enumerate() {
            let [slope, intercept] = self.output_map(i);
            normal[i] = (y - intercept) / slope;
        }
        normal
    }
}

/// A network with its scaling: takes and gives values with units.
#[derive(Clone, Debug, PartialEq)]
pub struct ScaledNetwork {
    /// The network over normalised values.
    pub network: Network,
    /// Ranges of its inputs and outputs.
    pub scaling: Scaling,
}

impl ScaledNetwork {
    /// Outputs with units for inputs with units; where an input's logarithm is taken, it must be
    /// positive.
    #[must_use]
    pub fn predict(&self, inputs: &[f64]) -> Layer {
        let mut outputs = self.network.forward(&self.scaling.normal_inputs(inputs));
        for i in 0..self.scaling.outputs.len() {
            let [slope, intercept] = self.scaling.output_map(i);
            outputs[i] = slope * outputs[i] + intercept;
        }
        outputs
    }
}
