//! Node evaluations of the search for formulas, some 30 nodes over 10 000 rows: in blocks of rows as the search does,
//! beside the straightforward way, which goes through the tree row by row.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use steadycut_core::base::math;
use steadycut_study::identify::gp::evaluate::Sweeps;
use steadycut_study::identify::gp::node::Step;

const ROWS: usize = 10_000;

fn inputs() -> Vec<Vec<f64>> {
    let column = |by: f64| (0..ROWS).map(|row| 0.5 + (row as f64 * by).fract()).collect();
    vec![column(0.618), column(0.414)]
}

/// A chain of nodes from these operations of two values and of one.
fn code(two: &[Step], one: &[Step]) -> Vec<Step> {
    let mut code = vec![Step::Input(0)];
    let (mut twos, mut ones) = (two.iter().cycle(), one.iter().cycle());
    while code.len() < 28 {
        if let Some(one) = ones.next() {
            code.push(*one);
        }
        let second = if code.len() % 3 == 0 { Step::Constant(1.3) } else { Step::Input(1) };
        code.push(second);
        code.extend(twos.next());
    }
    code
}

/// A formula as a tree of its own.
enum Tree {
    Leaf(Step),
    One(Step, Box<Tree>),
    Two(Step, Box<Tree>, Box<Tree>),
}

impl Tree {
    fn of(code: &[Step]) -> Self {
        let mut stack = Vec::new();
        for step in code {
            let tree = match step.arity() {
                0 => Self::Leaf(*step),
                1 => Self::One(*step, Box::new(stack.pop().expect("an operand"))),
                _ => {
                    let b = Box::new(stack.pop().expect("an operand"));
                    Self::Two(*step, Box::new(stack.pop().expect("an operand")), b)
                }
            };
            stack.push(tree);
        }
        stack.pop().expect("a formula")
    }

    fn value(&self, inputs: &[Vec<f64>], row: usize) -> f64 {
        let operands = match self {
            Self::Leaf(step) => (*step, [0.0; 2]),
            Self::One(step, a) => (*step, [a.value(inputs, row), 0.0]),
            Self::Two(step, a, b) => (*step, [a.value(inputs, row), b.value(inputs, row)]),
        };
        let (step, [a, b]) = operands;
        match step {
            Step::Input(number) => inputs[usize::from(number)][row],
            Step::Constant(value) => value,
            Step::Add => a + b,
            Step::Sub => a - b,
            Step::Mul => a * b,
            Step::Div => a / b,
            Step::Power { exponent, .. } => math::power(a, exponent),
            Step::Ln => math::ln(a),
            Step::Exp => math::exp(a),
            Step::Sin => math::sin(a),
            Step::Cos => math::cos(a),
        }
    }
}

fn nodes(c: &mut Criterion) {
    let inputs = inputs();
    let power = Step::Power { exponent: 0.7, free: true };
    let arithmetic = code(&[Step::Add, Step::Mul, Step::Sub], &[]);
    let all = code(&[Step::Add, Step::Mul], &[power, Step::Exp, power, Step::Ln, power]);
    for (name, code) in [("+ - *", arithmetic), ("+ * ^ ln exp", all)] {
        let mut group = c.benchmark_group(format!("nodes {name}"));
        group.throughput(Throughput::Elements((code.len() * ROWS) as u64));
        let (mut sweeps, mut to) = (Sweeps::default(), vec![0.0; ROWS]);
        group.bench_function("blocks", |b| {
            b.iter(|| black_box(sweeps.run(black_box(&code), &inputs, &mut to, None)));
        });
        let tree = Tree::of(&code);
        group.bench_function("row by row", |b| {
            b.iter(|| {
                for (row, to) in to.iter_mut().enumerate() {
                    *to = tree.value(&inputs, row);
                }
                black_box(&to);
            });
        });
        group.finish();
    }
}

criterion_group!(benches, nodes);
criterion_main!(benches);
