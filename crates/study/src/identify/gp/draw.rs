//! Random factors and terms.
//!
//! Half of the factors have the forms that laws of cutting, wear and roughness are made of: powers,
//! logarithms and exponentials of one input, with constants of the size of that input. The others are
//! formulas of any form.

use super::node::{Factor, Product, RECIPROCAL, Step, fixed, size_of};
use super::rows::DataRows;
use crate::base::math;
use crate::base::rng::Stream;

/// Share of swings among random terms, where sines and cosines are allowed.
const SWINGS: f64 = 0.2;

/// Random numbers in a row, from one stream.
#[derive(Clone, Debug)]
pub struct Draws {
    stream: Stream,
    counter: u64,
}

impl Draws {
    /// The draws numbered `number` under `seed`.
    #[must_use]
    pub fn new(seed: u64, label: &str, number: u64) -> Self {
        let key = Stream::new(seed, label).bits(number);
        Self { stream: Stream::new(key, "gp"), counter: 0 }
    }

    /// Uniform in 0..1.
    pub fn uniform(&mut self) -> f64 {
        self.counter += 1;
        self.stream.uniform(self.counter)
    }

    /// Uniform in 0..end.
    pub fn below(&mut self, end: usize) -> usize {
        self.counter += 1;
        self.stream.below(self.counter, end as u64) as usize
    }

    /// Standard normal.
    pub fn normal(&mut self) -> f64 {
        self.counter += 1;
        self.stream.normal(self.counter)
    }

    /// Whether an event of this probability happens.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.uniform() < probability
    }

    /// One of some.
    pub fn of<T: Copy>(&mut self, items: &[T]) -> T {
        items[self.below(items.len())]
    }
}

/// Which functions formulas may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Functions {
    /// Logarithms.
    pub ln: bool,
    /// Exponentials.
    pub exp: bool,
    /// Sines and cosines.
    pub periodic: bool,
    /// Scales inside logarithms and exponentials, never without: inputs have units.
    pub scaled: bool,
}

/// What random formulas are made of.
#[derive(Clone, Debug)]
pub struct Grammar {
    /// Which functions.
    pub functions: Functions,
    /// Size of the values of each input.
    scales: Vec<f64>,
    /// Whether an input is positive, in the rows and beyond.
    pub(super) positive: Vec<bool>,
    /// The inputs that formulas may read.
    inputs: Vec<u8>,
    /// Most nodes of a factor.
    most: usize,
}

impl Grammar {
    /// The language for some rows.
    #[must_use]
    pub fn new(rows: &DataRows, positive: Vec<bool>, functions: Functions) -> Self {
        let ranges = rows.ranges();
        let scale = |[low, high]: &[f64; 2]| low.abs().max(high.abs()).max(f64::MIN_POSITIVE);
        Self {
            functions,
            scales: ranges.iter().map(scale).collect(),
            positive,
            inputs: (0..ranges.len() as u8).collect(),
            most: 14,
        }
    }

    /// The same for some of the inputs.
    #[must_use]
    pub fn on(mut self, inputs: &[u8]) -> Self {
        self.inputs = inputs.to_vec();
        self
    }

    /// The number of one of the inputs.
    pub fn input(&self, draws: &mut Draws) -> usize {
        usize::from(draws.of(&self.inputs))
    }

    /// An exponent for a base; a base that may be negative has whole ones.
    fn exponent(&self, positive: bool, draws: &mut Draws) -> Step {
        if !positive {
            return fixed(draws.of(&[2.0, 3.0, 2.0, 3.0, 4.0, 5.0, 6.0, -1.0]));
        }
        if draws.chance(0.5) {
            let exponents =
                [2.0, 3.0, -1.0, 0.5, -0.5, -2.0, 1.5, 4.0, 2.0, 3.0, -1.0, -1.5, 5.0, 6.0];
            return fixed(draws.of(&exponents));
        }
        Step::Power { exponent: (draws.uniform() * 6.0 - 2.5).max(-2.5) + 0.013, free: true }
    }

    /// An offset of at most this size: half of the time of any magnitude down to a
    /// hundred-thousandth.
    fn offset(&self, size: f64, draws: &mut Draws) -> f64 {
        let share = draws.uniform();
        if draws.chance(0.5) { size * share } else { size * math::exp(-12.0 * share) }
    }

    /// What stands inside a function.
    fn inner(&self, draws: &mut Draws) -> (Factor, bool) {
        let x = self.input(draws);
        let (input, scale) = (Step::Input(x as u8), self.scales[x]);
        let constant = |size: f64| Step::Constant(size);
        match draws.below(10) {
            9 => {
                // As in the inverse hyperbolic functions, and in hypotenuses.
                let mut code = vec![input];
                let (part, positive) = self.inner(draws);
                code.extend(part);
                code.extend([self.exponent(positive, draws), Step::Add]);
                (code, self.positive[x] && positive)
            }
            0 if !self.functions.scaled => (vec![input], self.positive[x]),
            1 | 2 => {
                let a = scale * (draws.uniform() * 2.0 - 0.7);
                (vec![input, constant(a), Step::Add], self.positive[x] && a > 0.0)
            }
            3 => {
                let a = self.offset(scale * scale, draws);
                (vec![input, fixed(2.0), constant(a), Step::Add], true)
            }
            4 => {
                let a = scale * (draws.uniform() * 1.4 - 0.7);
                let b = self.offset(scale * scale, draws);
                let code = vec![input, constant(a), Step::Add, fixed(2.0), constant(b), Step::Add];
                (code, true)
            }
            5 if !self.functions.scaled => {
                let z = Step::Input(self.input(draws) as u8);
                (vec![input, z, draws.of(&[Step::Add, Step::Mul, Step::Sub])], false)
            }
            6 if !self.functions.scaled => (vec![input, fixed(2.0)], true),
            7 if !self.functions.scaled => (vec![input, fixed(2.0), input, Step::Add], false),
            _ => {
                let k = (0.3 + 2.0 * draws.uniform()) / scale;
                (vec![input, constant(k), Step::Mul], self.positive[x])
            }
        }
    }

    /// A formula of any form of at most the given depth.
    fn any(&self, depth: usize, draws: &mut Draws) -> Factor {
        if depth == 0 || draws.chance(0.15) {
            if draws.chance(0.3) {
                let x = self.input(draws);
                return vec![Step::Constant(self.scales[x] * (draws.uniform() * 2.0 - 0.6))];
            }
            return vec![Step::Input(self.input(draws) as u8)];
        }
        if draws.chance(0.45) {
            let mut code = self.any(depth - 1, draws);
            code.push(self.function(draws));
            return code;
        }
        let mut code = self.any(depth - 1, draws);
        code.extend(self.any(depth - 1, draws));
        code.push(draws.of(&[Step::Add, Step::Sub, Step::Mul, Step::Mul, Step::Div]));
        code
    }

    /// A function of one value.
    pub fn function(&self, draws: &mut Draws) -> Step {
        loop {
            match draws.below(8) {
                0 if self.functions.ln => return Step::Ln,
                1 if self.functions.exp => return Step::Exp,
                2 if self.functions.periodic => return draws.of(&[Step::Sin, Step::Cos]),
                3 | 4 => return fixed(draws.of(&[0.5, -1.0, 2.0, 0.5, -1.0, 2.0, -0.5, 1.5])),
                5 => return fixed(draws.of(&[2.0, 3.0])),
                6 => return Step::Power { exponent: 0.2 + draws.uniform() * 1.5, free: true },
                _ => {}
            }
        }
    }

    /// A random part of a formula, for a mutation.
    pub fn part(&self, draws: &mut Draws) -> Factor {
        match draws.below(10) {
            0 | 1 => vec![Step::Input(self.input(draws) as u8)],
            2 | 3 => {
                let x = self.input(draws);
                vec![Step::Constant(self.scales[x] * (draws.uniform() * 2.0 - 0.6))]
            }
            4 | 5 => self.inner(draws).0,
            6 | 7 => self.factor(draws),
            _ => self.any(2, draws),
        }
    }

    /// A random factor.
    pub fn factor(&self, draws: &mut Draws) -> Factor {
        let x = self.input(draws);
        let input = Step::Input(x as u8);
        for _ in 0..20 {
            let code = match draws.below(12) {
                0 => vec![input],
                1..=3 => vec![input, self.exponent(self.positive[x], draws)],
                4 if self.functions.ln => {
                    if draws.chance(0.5) && !self.functions.scaled {
                        vec![input, Step::Ln]
                    } else {
                        let k = (0.5 + 3.0 * draws.uniform()) / self.scales[x];
                        vec![input, Step::Constant(k), Step::Mul, Step::Ln]
                    }
                }
                5 if self.functions.exp => {
                    let size = (0.2 + 3.0 * draws.uniform()) / self.scales[x];
                    let k = if draws.chance(0.7) { -size } else { size };
                    vec![input, Step::Constant(k), Step::Mul, Step::Exp]
                }
                6 => {
                    let (mut code, positive) = self.inner(draws);
                    code.push(self.exponent(positive, draws));
                    code
                }
                7 if self.functions.ln => {
                    let (mut code, _) = self.inner(draws);
                    code.push(Step::Ln);
                    code
                }
                8 if self.functions.exp => {
                    let (mut code, _) = self.inner(draws);
                    let size = 0.2 + 2.0 * draws.uniform();
                    if self.functions.scaled || draws.chance(0.5) {
                        code.extend([Step::Constant(-size / self.scales[x]), Step::Mul]);
                    }
                    code.push(Step::Exp);
                    code
                }
                9 if self.functions.periodic => {
                    let (mut code, _) = self.inner(draws);
                    code.push(draws.of(&[Step::Sin, Step::Cos]));
                    code
                }
                10 if self.functions.periodic => {
                    let mut code = vec![input, draws.of(&[Step::Sin, Step::Cos])];
                    if draws.chance(0.3) {
                        code.push(fixed(draws.of(&[2.0, 3.0])));
                    }
                    code
                }
                11 => self.any(3, draws),
                _ => continue,
            };
            let varies = code.iter().any(|node| matches!(node, Step::Input(_)));
            if varies && size_of(&code) <= self.most {
                return code;
            }
        }
        vec![input]
    }

    /// Whether there are swings: with units, no input is the argument of a wave by itself.
    #[must_use]
    pub fn swings(&self) -> bool {
        self.functions.periodic && !self.functions.scaled
    }

    /// A swing: sines and cosines of one argument to whole powers, grown or damped or both.
    pub fn swing(&self, draws: &mut Draws) -> Product {
        let x = self.input(draws);
        let (input, scale) = (Step::Input(x as u8), self.scales[x]);
        let mut argument = vec![input];
        if draws.chance(0.3) {
            argument.extend([Step::Constant((1.0 + 20.0 * draws.uniform()) / scale), Step::Mul]);
        }
        let exponents = [0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 3.0];
        let waves = [Step::Sin, Step::Cos].map(|wave| (wave, draws.of(&exponents)));
        let mut factors = Vec::new();
        let power = |mut factor: Factor, exponent: f64, factors: &mut Vec<Factor>| {
            if exponent != 1.0 {
                factor.push(fixed(exponent));
            }
            if exponent != 0.0 {
                factors.push(factor);
            }
        };
        for (wave, exponent) in waves {
            let mut factor = argument.clone();
            factor.push(wave);
            power(factor, exponent, &mut factors);
        }
        power(vec![input], draws.of(&[0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0]), &mut factors);
        if self.functions.exp && draws.chance(0.4) || factors.is_empty() {
            let rate = math::exp(3.5 * draws.uniform() - 0.5) / scale;
            factors.push(vec![input, Step::Constant(-rate), Step::Mul, Step::Exp]);
        }
        Product { factors }
    }

    /// A random term of one to three factors.
    pub fn term(&self, draws: &mut Draws) -> Product {
        if self.swings() && draws.chance(SWINGS) {
            return self.swing(draws);
        }
        let mut term = Product::of(self.factor(draws));
        while term.factors.len() < 3 && draws.chance(0.35) {
            let mut factor = self.factor(draws);
            if draws.chance(0.3) && !matches!(factor.last(), Some(Step::Power { .. })) {
                factor.push(RECIPROCAL);
            }
            term.factors.push(factor);
        }
        term
    }
}
