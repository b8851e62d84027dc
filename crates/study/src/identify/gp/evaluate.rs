//! Values of a formula over rows, in blocks, and their derivatives by its constants: one sweep forward,
//! one back.

use super::lanes::{self, LANE, Lane};
use super::node::Step;
use crate::base::math;

/// Room for a sweep.
#[derive(Default)]
pub struct Sweeps {
    values: Vec<Lane>,
    adjoints: Vec<Lane>,
    /// First and second part of each node.
    parts: Vec<[usize; 2]>,
    /// Whether a node depends on a fitted constant.
    fitted: Vec<bool>,
    stack: Vec<usize>,
    spare: Option<Box<Lane>>,
}

fn zip2(to: &mut [f64], a: &[f64], b: &[f64], of: impl Fn(f64, f64) -> f64) {
    for ((to, a), b) in to.iter_mut().zip(a).zip(b) {
        *to = of(*a, *b);
    }
}

fn zip1(to: &mut [f64], a: &[f64], of: impl Fn(f64) -> f64) {
    for (to, a) in to.iter_mut().zip(a) {
        *to = of(*a);
    }
}

impl Sweeps {
    fn prepare(&mut self, code: &[Step]) {
        self.parts.clear();
        self.fitted.clear();
        self.stack.clear();
        for (at, node) in code.iter().enumerate() {
            let mut parts = [at; 2];
            let mut fitted = node.is_free();
            for slot in (0..node.arity()).rev() {
                if let Some(part) = self.stack.pop() {
                    parts[slot] = part;
                    fitted |= self.fitted[part];
                }
            }
            self.parts.push(parts);
            self.fitted.push(fitted);
            self.stack.push(at);
        }
        if self.values.len() < code.len() {
            self.values.resize(code.len(), [0.0; LANE]);
            self.adjoints.resize(code.len(), [0.0; LANE]);
        }
    }

    /// Values of `code` on every row of `inputs` (a column each) into `to`; with `derivatives`, a column
    /// for each fitted constant in the order of the code. `false` where a value is not finite.
    pub fn run(
        &mut self,
        code: &[Step],
        inputs: &[Vec<f64>],
        to: &mut [f64],
        mut derivatives: Option<&mut [Vec<f64>]>,
    ) -> bool {
        self.prepare(code);
        let rows = to.len();
        let mut from = 0;
        while from < rows {
            let len = LANE.min(rows - from);
            self.forward(code, inputs, from, len);
            let root = &self.values[code.len() - 1][..len];
            // A sum is finite only where every value is: infinities and NaN do not go away.
            if !root.iter().map(|value| value * 0.0).sum::<f64>().is_finite() {
                return false;
            }
            to[from..from + len].copy_from_slice(root);
            if let Some(derivatives) = derivatives.as_deref_mut() {
                self.back(code, from, len, derivatives);
            }
            from += len;
        }
        true
    }

    fn forward(&mut self, code: &[Step], inputs: &[Vec<f64>], from: usize, len: usize) {
        let spare = self.spare.get_or_insert_with(|| Box::new([0.0; LANE]));
        for (at, node) in code.iter().enumerate() {
            let (before, rest) = self.values.split_at_mut(at);
            let to = &mut rest[0][..len];
            let [a, b] = self.parts[at];
            let part = |index: usize| &before[index][..len];
            match *node {
                Step::Input(number) => {
                    to.copy_from_slice(&inputs[usize::from(number)][from..from + len]);
                }
                Step::Constant(value) => to.fill(value),
                Step::Add => zip2(to, part(a), part(b), |a, b| a + b),
                Step::Sub => zip2(to, part(a), part(b), |a, b| a - b),
                Step::Mul => zip2(to, part(a), part(b), |a, b| a * b),
                Step::Div => zip2(to, part(a), part(b), |a, b| a / b),
                Step::Power { exponent, .. } => {
                    lanes::power(to, part(a), exponent, &mut spare[..len]);
                }
                Step::Ln => lanes::ln(to, part(a)),
                Step::Exp => lanes::exp(to, part(a)),
                Step::Sin => zip1(to, part(a), math::sin),
                Step::Cos => zip1(to, part(a), math::cos),
            }
        }
    }

    fn back(&mut self, code: &[Step], from: usize, len: usize, derivatives: &mut [Vec<f64>]) {
        let mut constant = derivatives.len();
        let root = code.len() - 1;
        self.adjoints[root][..len].fill(1.0);
        let spare = self.spare.get_or_insert_with(|| Box::new([0.0; LANE]));
        for at in (0..code.len()).rev() {
            if !self.fitted[at] {
                continue;
            }
            let (before, rest) = self.adjoints.split_at_mut(at);
            let own = &rest[0][..len];
            let [a, b] = self.parts[at];
            let value = |index: usize| &self.values[index][..len];
            match code[at] {
                Step::Input(_) => {}
                Step::Constant(_) => {
                    constant -= 1;
                    derivatives[constant][from..from + len].copy_from_slice(own);
                }
                Step::Add => {
                    before[a][..len].copy_from_slice(own);
                    before[b][..len].copy_from_slice(own);
                }
                Step::Sub => {
                    before[a][..len].copy_from_slice(own);
                    zip1(&mut before[b][..len], own, |own| -own);
                }
                Step::Mul => {
                    zip2(&mut before[a][..len], own, value(b), |own, b| own * b);
                    zip2(&mut before[b][..len], own, value(a), |own, a| own * a);
                }
                Step::Div => {
                    zip2(&mut before[a][..len], own, value(b), |own, b| own / b);
                    let back = &mut before[b][..len];
                    zip2(back, own, value(at), |own, quotient| -own * quotient);
                    for (back, b) in back.iter_mut().zip(value(b)) {
                        *back /= b;
                    }
                }
                Step::Power { exponent, free } => {
                    if free {
                        constant -= 1;
                        let to = &mut derivatives[constant][from..from + len];
                        lanes::ln(&mut spare[..len], value(a));
                        zip2(to, own, value(at), |own, power| own * power);
                        for ((to, log), x) in to.iter_mut().zip(&spare[..len]).zip(value(a)) {
                            *to = if *x > 0.0 { *to * log } else { 0.0 };
                        }
                    }
                    if self.fitted[a] {
                        let back = &mut before[a][..len];
                        zip2(back, own, value(at), |own, power| own * exponent * power);
                        for (back, x) in back.iter_mut().zip(value(a)) {
                            *back = if *x == 0.0 { 0.0 } else { *back / x };
                        }
                    }
                }
                Step::Ln => zip2(&mut before[a][..len], own, value(a), |own, a| own / a),
                Step::Exp => zip2(&mut before[a][..len], own, value(at), |own, e| own * e),
                Step::Sin => {
                    zip2(&mut before[a][..len], own, value(a), |own, a| own * math::cos(a))
                }
                Step::Cos => {
                    zip2(&mut before[a][..len], own, value(a), |own, a| -own * math::sin(a));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::node::fixed;
    use super::*;

    #[test]
    fn derivatives_agree_with_differences() {
        use Step::{Add, Constant, Cos, Div, Exp, Input, Ln, Mul, Sin, Sub};
        let code = |shift: [f64; 5]| {
            let free = |exponent| Step::Power { exponent, free: true };
            vec![
                Input(0),
                Constant(0.7 + shift[0]),
                Add,
                free(1.3 + shift[1]),
                Input(1),
                Constant(-0.4 + shift[2]),
                Mul,
                Exp,
                Input(0),
                Sin,
                Sub,
                Mul,
                Input(1),
                Constant(0.3 + shift[3]),
                Mul,
                Cos,
                fixed(2.0),
                Input(0),
                Constant(2.0 + shift[4]),
                Add,
                Ln,
                Div,
                Sub,
            ]
        };
        let inputs: Vec<Vec<f64>> = vec![
            (0..200).map(|i| 0.1 + f64::from(i) * 0.02).collect(),
            (0..200).map(|i| 2.0 - f64::from(i) * 0.01).collect(),
        ];
        let mut sweeps = Sweeps::default();
        let (mut to, mut derivatives) = (vec![0.0; 200], vec![vec![0.0; 200]; 5]);
        assert!(sweeps.run(&code([0.0; 5]), &inputs, &mut to, Some(&mut derivatives)));
        for (number, derivative) in derivatives.iter().enumerate() {
            let mut sides = [-1e-6, 1e-6].map(|step| {
                let mut shift = [0.0; 5];
                shift[number] = step;
                let mut to = vec![0.0; 200];
                assert!(sweeps.run(&code(shift), &inputs, &mut to, None));
                to
            });
            let [low, high] = &mut sides;
            for ((low, high), exact) in low.iter().zip(high.iter()).zip(derivative) {
                let difference = (high - low) / 2e-6;
                assert!((difference - exact).abs() < 1e-7 * (1.0 + exact.abs()), "{number}");
            }
        }
        assert!(!sweeps.run(&[Input(0), Constant(-1.0), Mul, Ln], &inputs, &mut to, None));
    }
}
