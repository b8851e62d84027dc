use super::*;
use crate::models::structure::parameters::Parameters;
use crate::models::structure::{MachineSettings, Variant};

fn machine(variant: Variant, parameters: Parameters) -> FiveMass {
    FiveMass::new(&MachineSettings { variant, parameters, ..MachineSettings::default() })
}

fn near(x: f64, y: f64, relative: f64) {
    assert!((x / y - 1.0).abs() < relative, "{x} {y}");
}

#[test]
fn undamped_modes_meet_the_reference() {
    let of = |variant| undamped(&machine(variant, Parameters::Rules)).unwrap();
    let a = [
        109.929_156_401_990,
        154.485_631_374_554,
        259.516_245_179_389,
        355.665_720_492_944,
        4_140_000.036_529_41,
    ];
    let b = [109.918_296_277_706, 122.600_809_237_896, 258.756_600_868_438, 449.523_896_085_113];
    let modes = of(Variant::Equations);
    assert_eq!(modes.len(), 5);
    modes.iter().zip(a).for_each(|(mode, f)| near(mode.frequency_hz, f, 2e-12));
    of(Variant::Names).iter().zip(b).for_each(|(mode, f)| near(mode.frequency_hz, f, 2e-12));
    // Orthogonal with respect to the masses.
    for (i, x) in modes.iter().enumerate() {
        for (j, y) in modes.iter().enumerate() {
            let masses = machine(Variant::Equations, Parameters::Rules).elements.mass_kg;
            let product: f64 =
                (0..5).map(|node| masses[node] * (x.shape[node] * y.shape[node])).sum();
            let expected = if i == j { 1.0 } else { 0.0 };
            assert!((product - expected).abs() < 1e-9, "{i} {j}: {product}");
        }
    }
}

#[test]
fn undamped_modes_of_every_set_make_the_flexibility() {
    for parameters in Parameters::ALL {
        for variant in Variant::ALL {
            let machine = machine(*variant, *parameters);
            let modes = undamped(&machine).unwrap();
            // K^-1 = sum of x x^T / w^2.
            let flexibility = machine.stiffness().try_inverse().unwrap();
            let scale = flexibility[(2, 2)];
            for i in 0..5 {
                for j in 0..5 {
                    let sum: f64 = modes
                        .iter()
                        .map(|mode| {
                            let omega = TAU * mode.frequency_hz;
                            mode.shape[i] * mode.shape[j] / (omega * omega)
                        })
                        .sum();
                    let gap = (sum - flexibility[(i, j)]).abs() / scale;
                    assert!(gap < 1e-10, "{parameters:?} {variant:?} {i} {j}: {gap:e}");
                }
            }
        }
    }
}

#[test]
fn poles_meet_the_reference() {
    let modes = damped(&machine(Variant::Equations, Parameters::Rules)).unwrap();
    let poles = [
        (-68.992_174_807_2, 687.253_725_307),
        (-102.766_480_987, 965.256_560_906),
        (-288.342_712_174, 1_605.071_674_38),
        (-554.818_136_752, 2_164.367_109_4),
        (-1.300_619_381_54e6, 2.597_985_156_88e7),
    ];
    assert_eq!(modes.len(), 5);
    for (mode, (re, im)) in modes.iter().zip(poles) {
        near(mode.pole.re, re, 2e-11);
        near(mode.pole.im, im, 2e-11);
    }
    let table = [
        (109.929_599_561, 109.379_827_541, 0.099_886_160_770_7),
        (154.493_563_197, 153.625_353_020, 0.105_867_151_322),
        (259.544_413_946, 255.455_090_995, 0.176_814_315_705),
        (355.607_427_783, 344.469_724_127, 0.248_313_286_175),
    ];
    for (mode, (natural, damped, ratio)) in modes.iter().zip(table) {
        near(mode.natural_hz(), natural, 1e-11);
        near(mode.damped_hz(), damped, 1e-11);
        near(mode.damping_ratio(), ratio, 1e-11);
    }
    let b = damped(&machine(Variant::Names, Parameters::Rules)).unwrap();
    for (mode, ratio) in
        b.iter().zip([0.099_839_941_9, 0.087_578_107, 0.173_602_522_8, 0.305_615_872_8])
    {
        near(mode.damping_ratio(), ratio, 1e-9);
    }
}

#[test]
fn poles_and_residues_make_the_response() {
    for parameters in Parameters::ALL {
        for variant in Variant::ALL {
            let machine = machine(*variant, *parameters);
            let modes = damped(&machine).unwrap();
            let count: usize =
                modes.iter().map(|mode| if mode.pole.im > 0.0 { 2 } else { 1 }).sum();
            assert_eq!(count, 10, "{parameters:?} {variant:?}");
            assert!(modes.iter().all(|mode| mode.pole.re < 0.0));
            for f_hz in [0.0, 110.0, 580.0, 3000.0] {
                let s = Complex::new(0.0, TAU * f_hz);
                let sum: Complex = modes
                    .iter()
                    .map(|mode| {
                        let one = mode.residue / (s - mode.pole);
                        let other = mode.residue.conj() / (s - mode.pole.conj());
                        if mode.pole.im > 0.0 { one + other } else { one }
                    })
                    .sum();
                let direct = crate::models::structure::frf::tree(&machine, f_hz).grel;
                let gap = size(sum - direct) / size(direct);
                assert!(gap < 1e-8, "{parameters:?} {variant:?} {f_hz} Hz: {gap:e}");
            }
        }
    }
}
