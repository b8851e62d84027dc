//! Cost of one step of the machine in the running cut against a bare 8 x 8 matrix-vector product
//! in the same run: eight states are what a plain discretisation of the reduced machine would carry.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use nalgebra::SMatrix;
use nalgebra::SVector;
use steadycut_core::blocks::machine::response::{CutForce, ModalResponse};
use steadycut_core::models::structure::reduction::Reduction;
use steadycut_core::models::structure::{FiveMass, MachineSettings};

/// Most that a step may cost, in matrix-vector products. What it costs depends on the processor: a step
/// is a chain of sums that wait for each other, a product many that do not. The same code took 2.8 products on one
/// and 4.1 on another.
const LIMIT: f64 = 6.0;
const STEPS: u32 = 20_000;

/// A cut that keeps everything busy: regeneration, process damping, a delay between two steps, and
/// teeth that come and go.
fn forces() -> [CutForce; 256] {
    let mut forces = [CutForce::default(); 256];
    for (i, force) in forces.iter_mut().enumerate() {
        let inside = i % 188 < 54;
        *force = CutForce {
            static_n: if inside { 150.0 } else { 0.0 },
            stiffness_n_m: if inside { 1.5e6 } else { 0.0 },
            damping_n_s_m: if inside { 200.0 } else { 0.0 },
            delay_s: 0.018_85,
        };
    }
    forces
}

fn products(matrix: &SMatrix<f64, 8, 8>, state: &mut SVector<f64, 8>) {
    for _ in 0..STEPS {
        // Each product waits for the one before, as steps of a recursion do.
        *state = black_box(matrix) * *state;
    }
}

fn steps(response: &mut ModalResponse, forces: &[CutForce; 256]) -> f64 {
    let mut sum = 0.0;
    for i in 0..STEPS {
        sum += response.update(&forces[i as usize & 255]).displacement_m;
    }
    sum
}

#[expect(clippy::disallowed_methods, reason = "a bench needs a clock")]
fn ratio(response: &mut ModalResponse, matrix: &SMatrix<f64, 8, 8>) {
    let forces = forces();
    let mut state = SVector::<f64, 8>::repeat(1.0);
    let mut best = [f64::INFINITY; 2];
    // The least of many, taken alternately: other work on the machine disturbs both alike.
    for _ in 0..400 {
        let start = std::time::Instant::now();
        products(matrix, &mut state);
        black_box(&state);
        let middle = std::time::Instant::now();
        black_box(steps(response, black_box(&forces)));
        best[0] = best[0].min((middle - start).as_secs_f64());
        best[1] = best[1].min(middle.elapsed().as_secs_f64());
    }
    let [product, step] = best.map(|seconds| seconds / f64::from(STEPS) * 1e9);
    let ratio = step / product;
    println!(
        "machine: {step:.1} ns per step of 0.1 ms, 8 x 8 product {product:.1} ns, ratio {ratio:.2} \
         (limit {LIMIT})"
    );
    assert!(ratio <= LIMIT, "a step costs {ratio:.2} matrix-vector products");
}

fn machine(criterion: &mut Criterion) {
    let reduction = Reduction::new(&FiveMass::new(&MachineSettings::default()))
        .expect("the default machine reduces");
    let mut response = ModalResponse::new(&reduction, 1e-4, 0.05);
    // A rotation-like matrix: states neither vanish nor grow.
    let matrix = SMatrix::<f64, 8, 8>::from_fn(|i, j| if (i + 3) % 8 == j { 1.0 } else { 0.0 });
    ratio(&mut response, &matrix);
    let forces = forces();
    criterion.bench_function("20000 steps of 0.1 ms", |bencher| {
        bencher.iter(|| steps(&mut response, black_box(&forces)));
    });
    criterion.bench_function("20000 products 8 x 8", |bencher| {
        let mut state = SVector::<f64, 8>::repeat(1.0);
        bencher.iter(|| {
            products(&matrix, &mut state);
            black_box(state[0])
        });
    });
}

criterion_group!(benches, machine);
criterion_main!(benches);
