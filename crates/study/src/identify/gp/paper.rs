//! Genetic programming as the papers describe it: trees of their functions and of constants drawn at random,
//! which nothing fits afterwards.
//!
//! Printed are functions, range of the constants, population, generations, probabilities and the fitness at
//! which it stops (2007, 3.1; 2013, 3). Chosen, since the papers do not say: fitness is R2, the probabilities
//! (0.75 and 1.07 in sum) are shares, selection is by tournaments of five, first trees are grown to depth 2 to
//! 6, trees have at most 60 nodes, half of all leaves are constants.

use serde::Serialize;

use super::draw::Draws;
use super::lanes::{self, LANE, Lane};
use super::rows::DataRows;
use crate::base::formula::{Formula, Function, Node as Tree, Operator};
use crate::base::language::text;
use crate::base::math;
use crate::published::PaperId;
use crate::run::job::{Budget, Job, Progress};
use crate::run::parts::{Making, OneStep, Parts};

/// Most nodes of a tree.
const MOST_NODES: usize = 60;
/// Trees of a tournament.
const TOURNAMENT: usize = 5;
/// Generations.
const GENERATIONS: u64 = 100;

/// The setting of a paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PaperSetting {
    /// Trees of a generation.
    pub population: usize,
    /// Shares of reproduction, crossover and mutation.
    pub shares: [f64; 3],
    /// Fitness at which it stops.
    pub stop: f64,
    /// Constants lie between minus this and this.
    pub constants: f64,
    /// Whether e^x is among the functions.
    pub exp: bool,
}

impl PaperSetting {
    /// The setting of a paper for a model of this many inputs: the larger population is that of the model of
    /// cutting, which has several.
    #[must_use]
    pub fn of(paper: PaperId, inputs: usize) -> Self {
        let population = if inputs > 1 { 1500 } else { 850 };
        match paper {
            PaperId::Sdnrp2007 => Self {
                population,
                shares: [0.15, 0.5, 0.1],
                stop: 0.97,
                constants: 10.0,
                exp: false,
            },
            PaperId::Strategy2013 => Self {
                population,
                shares: [0.17, 0.7, 0.2],
                stop: 0.98,
                constants: 1000.0,
                exp: true,
            },
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Part {
    Input(usize),
    Number(f64),
    Add,
    Subtract,
    Multiply,
    Power,
    Ln,
    Exp,
}

impl Part {
    fn arity(self) -> usize {
        match self {
            Self::Input(_) | Self::Number(_) => 0,
            Self::Ln | Self::Exp => 1,
            Self::Add | Self::Subtract | Self::Multiply | Self::Power => 2,
        }
    }
}

/// A tree in postfix, and its fitness.
#[derive(Clone, Debug, PartialEq)]
struct Organism {
    code: Vec<Part>,
    fitness: f64,
}

fn start_of(code: &[Part], end: usize) -> usize {
    let (mut wanted, mut at) = (1, end + 1);
    while wanted > 0 {
        at -= 1;
        wanted = wanted - 1 + code[at].arity();
    }
    at
}

/// What the paper's search has found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PaperResult {
    /// The paper.
    pub paper: &'static str,
    /// The fittest formula, none where none has values on all rows.
    pub formula: Option<String>,
    /// Its nodes.
    pub size: usize,
    /// Its fitness, R2.
    pub fitness: f64,
    /// Root mean square of its residuals.
    pub error: f64,
    /// Generations bred.
    pub generations: u64,
    /// Most generations.
    pub most_generations: u64,
    /// Trees of a generation.
    pub population: usize,
    /// Shares of reproduction, crossover and mutation, as printed.
    pub shares: [f64; 3],
    /// Constants lie between minus this and this.
    pub constants: f64,
    /// The functions.
    pub functions: &'static str,
    /// Fitness at which it stops.
    pub stop: f64,
    /// Whether that was reached.
    pub reached: bool,
    /// Trees evaluated.
    pub evaluations: u64,
}

/// The search of a paper.
#[derive(Clone)]
pub struct PaperSearch {
    paper: PaperId,
    setting: PaperSetting,
    rows: DataRows,
    seed: u64,
    population: Vec<Organism>,
    generation: u64,
    parts: Parts<OneStep, Organism>,
}

impl PaperSearch {
    /// Begins it.
    #[must_use]
    pub fn new(paper: PaperId, rows: DataRows, seed: u64) -> Self {
        let setting = PaperSetting::of(paper, rows.inputs.len());
        let (population, parts) = (Vec::new(), Parts::default());
        Self { paper, setting, rows, seed, population, generation: 0, parts }
    }

    fn best(&self) -> Option<&Organism> {
        self.population.iter().max_by(|a, b| a.fitness.total_cmp(&b.fitness))
    }

    fn is_over(&self) -> bool {
        let reached = self.best().is_some_and(|best| best.fitness > self.setting.stop);
        reached || self.generation > GENERATIONS
    }

    /// What it has found.
    #[must_use]
    pub fn result(&self, names: &[String]) -> PaperResult {
        let best = self.best().filter(|best| best.fitness.is_finite());
        let formula = best.and_then(|best| written(&best.code, names));
        let fitness = best.map_or(f64::NEG_INFINITY, |best| best.fitness);
        let spread = self.rows.spread() / self.rows.len() as f64;
        PaperResult {
            paper: self.paper.id(),
            size: formula.as_ref().map_or(0, Formula::size),
            formula: formula.map(|formula| formula.to_string()),
            fitness,
            error: ((1.0 - fitness) * spread).max(0.0).sqrt(),
            generations: self.generation.saturating_sub(1),
            most_generations: GENERATIONS,
            population: self.setting.population,
            shares: self.setting.shares,
            constants: self.setting.constants,
            functions: if self.setting.exp { "+ - * ^ ln exp" } else { "+ - * ^ ln" },
            stop: self.setting.stop,
            reached: fitness > self.setting.stop,
            evaluations: self.generation * self.setting.population as u64,
        }
    }

    fn leaf(&self, draws: &mut Draws) -> Part {
        if draws.chance(0.5) {
            Part::Input(draws.below(self.rows.inputs.len()))
        } else {
            Part::Number(self.setting.constants * (2.0 * draws.uniform() - 1.0))
        }
    }

    fn grow(&self, depth: usize, full: bool, draws: &mut Draws, code: &mut Vec<Part>) {
        if depth == 0 || !full && draws.chance(0.2) {
            code.push(self.leaf(draws));
            return;
        }
        let functions =
            [Part::Add, Part::Subtract, Part::Multiply, Part::Power, Part::Ln, Part::Exp];
        let part = functions[draws.below(if self.setting.exp { 6 } else { 5 })];
        for _ in 0..part.arity() {
            self.grow(depth - 1, full, draws, code);
        }
        code.push(part);
    }

    fn chosen(&self, draws: &mut Draws) -> &Organism {
        let mut best = draws.below(self.population.len());
        for _ in 1..TOURNAMENT {
            let other = draws.below(self.population.len());
            if self.population[other].fitness > self.population[best].fitness {
                best = other;
            }
        }
        &self.population[best]
    }

    fn organism(&self, number: usize) -> Organism {
        let place = self.generation * 1_000_000 + number as u64;
        let mut draws = Draws::new(self.seed, "identify.gp.paper", place);
        let mut code = Vec::new();
        if self.population.is_empty() {
            self.grow(2 + number % 5, number.is_multiple_of(2), &mut draws, &mut code);
            return self.judged(code);
        }
        let [reproduction, crossover, mutation] = self.setting.shares;
        let event = draws.uniform() * (reproduction + crossover + mutation);
        let parent = self.chosen(&mut draws).clone();
        if event < reproduction {
            return parent;
        }
        code = parent.code;
        let end = draws.below(code.len());
        let part = if event < reproduction + crossover {
            let other = &self.chosen(&mut draws).code;
            let end = draws.below(other.len());
            other[start_of(other, end)..=end].to_vec()
        } else {
            let mut part = Vec::new();
            self.grow(1 + draws.below(4), false, &mut draws, &mut part);
            part
        };
        let start = start_of(&code, end);
        code.splice(start..=end, part);
        if code.len() > MOST_NODES {
            return self.chosen(&mut draws).clone();
        }
        self.judged(code)
    }

    /// R2 of a tree on the rows; minus infinity where it has no value on one.
    fn judged(&self, code: Vec<Part>) -> Organism {
        let (rows, mut stack, mut spare) = (&self.rows, vec![[0.0; LANE]; MOST_NODES], [0.0; LANE]);
        let (mut squares, mut from) = (0.0, 0);
        while from < rows.len() {
            let len = LANE.min(rows.len() - from);
            values(&code, &rows.inputs, from, len, &mut stack, &mut spare);
            let targets = &rows.target[from..from + len];
            squares +=
                targets.iter().zip(&stack[0][..len]).map(|(y, x)| (y - x) * (y - x)).sum::<f64>();
            from += len;
        }
        let fitness = 1.0 - squares / rows.spread();
        Organism { code, fitness: if fitness.is_finite() { fitness } else { f64::NEG_INFINITY } }
    }
}

/// Values of a tree on a block of rows, left in the first lane.
fn values(
    code: &[Part],
    inputs: &[Vec<f64>],
    from: usize,
    len: usize,
    stack: &mut [Lane],
    spare: &mut Lane,
) {
    let mut top = 0;
    for part in code {
        match *part {
            Part::Input(number) => {
                stack[top][..len].copy_from_slice(&inputs[number][from..from + len]);
                top += 1;
            }
            Part::Number(x) => {
                stack[top][..len].fill(x);
                top += 1;
            }
            Part::Ln | Part::Exp => {
                let lane = &mut stack[top - 1][..len];
                spare[..len].copy_from_slice(lane);
                if *part == Part::Ln {
                    lanes::ln(lane, &spare[..len]);
                } else {
                    lanes::exp(lane, &spare[..len]);
                }
            }
            Part::Add | Part::Subtract | Part::Multiply | Part::Power => {
                top -= 1;
                let (below, above) = stack.split_at_mut(top);
                let of: fn(f64, f64) -> f64 = match part {
                    Part::Add => |a, b| a + b,
                    Part::Subtract => |a, b| a - b,
                    Part::Multiply => |a, b| a * b,
                    Part::Power | Part::Input(_) | Part::Number(_) | Part::Ln | Part::Exp => {
                        math::power
                    }
                };
                for (a, b) in below[top - 1][..len].iter_mut().zip(&above[0][..len]) {
                    *a = of(*a, *b);
                }
            }
        }
    }
}

fn written(code: &[Part], names: &[String]) -> Option<Formula> {
    let mut stack: Vec<Tree> = Vec::new();
    for part in code {
        let tree = match *part {
            Part::Input(number) => Tree::Input(number),
            Part::Number(x) => Tree::Number(x),
            Part::Ln => Tree::unary(Function::Ln, stack.pop()?),
            Part::Exp => Tree::unary(Function::Exp, stack.pop()?),
            Part::Add | Part::Subtract | Part::Multiply | Part::Power => {
                let (b, a) = (stack.pop()?, stack.pop()?);
                let operator = match part {
                    Part::Add => Operator::Add,
                    Part::Subtract => Operator::Subtract,
                    Part::Multiply => Operator::Multiply,
                    Part::Power | Part::Input(_) | Part::Number(_) | Part::Ln | Part::Exp => {
                        Operator::Power
                    }
                };
                Tree::binary(operator, a, b)
            }
        };
        stack.push(tree);
    }
    Some(Formula::new(stack.pop()?, names).ok()?.simplified())
}

impl Job for PaperSearch {
    type Partial = f64;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        while !self.is_over() {
            let count = self.setting.population;
            let before = self.parts.progress();
            let mut parts = std::mem::take(&mut self.parts);
            let end = |number: usize, _: &OneStep| self.organism(number);
            let making = Making { begin: &|_| Ok(OneStep::default()), end: &end };
            let done = parts.advance(count, budget, &making);
            self.parts = parts;
            if !done {
                return false;
            }
            let spent = (count as f64 - before).max(0.0) as u64;
            let _ = budget.spend(spent.div_ceil(budget.threads().count().max(1) as u64));
            self.population = std::mem::take(&mut self.parts).into_done();
            self.generation += 1;
        }
        true
    }

    fn progress(&self) -> Progress {
        let total = (GENERATIONS + 1) as f64;
        if self.is_over() {
            return Progress { done: total, total, unit: text!("generations") };
        }
        let share = self.parts.progress() / self.setting.population as f64;
        Progress { done: self.generation as f64 + share, total, unit: text!("generations") }
    }

    /// The best fitness so far.
    fn partial(&self) -> f64 {
        self.best().map_or(f64::NEG_INFINITY, |best| best.fitness)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_settings_are_those_printed() {
        let old = PaperSetting::of(PaperId::Sdnrp2007, 2);
        assert_eq!((old.population, old.shares, old.stop), (1500, [0.15, 0.5, 0.1], 0.97));
        assert_eq!((old.constants, old.exp), (10.0, false));
        let new = PaperSetting::of(PaperId::Strategy2013, 1);
        assert_eq!((new.population, new.shares, new.stop), (850, [0.17, 0.7, 0.2], 0.98));
        assert_eq!((new.constants, new.exp), (1000.0, true));
    }

    #[test]
    fn fitness_rises_and_is_that_of_the_formula_told() {
        let x: Vec<f64> = (0..40).map(|i| 0.5 + 0.1 * f64::from(i)).collect();
        let target: Vec<f64> = x.iter().map(|x| x * x + 3.0 * math::ln(*x)).collect();
        let rows = DataRows { inputs: vec![x.clone()], target: target.clone() };
        let mut search = PaperSearch::new(PaperId::Sdnrp2007, rows, 1);
        search.advance_by(850);
        let first = search.partial();
        search.to_end();
        let result = search.result(&["x".to_owned()]);
        assert!(result.reached && result.fitness > 0.97 && result.fitness >= first, "{result:?}");
        let formula = Formula::parse(result.formula.as_ref().unwrap(), &["x"]).unwrap();
        let squares: f64 = x
            .iter()
            .zip(&target)
            .map(|(x, y)| (y - formula.value(&[*x])) * (y - formula.value(&[*x])))
            .sum();
        let error = (squares / 40.0).sqrt();
        assert!((error - result.error).abs() < 1e-6 * error, "{error} {result:?}");
    }
}
