use std::fmt::Write;

use super::*;
use crate::base::rng::Stream;
use crate::models::tip_modes::TipAxis;

fn mode(frequency_hz: f64, damping_ratio: f64, mass_kg: f64) -> TipMode {
    TipMode { axis: TipAxis::Y, frequency_hz, damping_ratio, mass_kg }
}

/// Three modes, the last two near each other, and a stiffer one beyond.
fn truth() -> ResponseFit {
    let modes = vec![mode(410.0, 0.035, 1.4), mode(905.0, 0.014, 0.11), mode(985.0, 0.012, 0.16)];
    ResponseFit { modes, residual_m_n: 4e-9, rest: 0.0, estimated: Vec::new() }
}

fn recorded(noise: f64) -> MeasuredResponse {
    let (truth, stream) = (truth(), Stream::new(7, "response"));
    let frequency_hz: Vec<f64> = (0..900).map(|i| 100.0 + 2.0 * f64::from(i)).collect();
    let size = truth.at(905.0).norm_sqr().sqrt();
    let response = frequency_hz.iter().zip(0_u64..).map(|(f_hz, i)| {
        let off = Complex::new(stream.normal(2 * i), stream.normal(2 * i + 1));
        truth.at(*f_hz) + off * (noise * size)
    });
    let response_m_n = response.collect();
    MeasuredResponse { frequency_hz, response_m_n }
}

#[test]
fn modes_come_back_out_of_their_response() {
    let fit = identify_structure(&recorded(0.0), TipAxis::Y, None).unwrap();
    assert_eq!(fit.modes.len(), 3, "{fit:?}");
    for (found, known) in fit.modes.iter().zip(truth().modes) {
        assert!((found.frequency_hz / known.frequency_hz - 1.0).abs() < 1e-6, "{found:?}");
        assert!((found.damping_ratio / known.damping_ratio - 1.0).abs() < 1e-4, "{found:?}");
        assert!((found.mass_kg / known.mass_kg - 1.0).abs() < 1e-4, "{found:?}");
    }
    assert!((fit.residual_m_n / 4e-9 - 1.0).abs() < 1e-3 && fit.rest < 1e-6, "{fit:?}");
}

#[test]
fn noise_is_what_is_left_and_modes_are_near_all_the_same() {
    let recorded = recorded(0.003);
    let fit = identify_structure(&recorded, TipAxis::Y, Some(3)).unwrap();
    for (found, known) in fit.modes.iter().zip(truth().modes) {
        assert!((found.frequency_hz / known.frequency_hz - 1.0).abs() < 2e-3, "{found:?}");
        assert!((found.damping_ratio / known.damping_ratio - 1.0).abs() < 0.06, "{found:?}");
        assert!((found.mass_kg / known.mass_kg - 1.0).abs() < 0.08, "{found:?}");
    }
    let all: f64 = recorded.response_m_n.iter().map(|g| g.norm_sqr()).sum();
    let size = truth().at(905.0).norm_sqr().sqrt();
    let noise = (2.0 * 0.003 * 0.003 * size * size * 900.0 / all).sqrt();
    assert!((fit.rest / noise - 1.0).abs() < 0.1, "{} {noise}", fit.rest);
}

#[test]
#[expect(clippy::disallowed_methods, reason = "the reference is independent of base::math")]
fn tables_of_parts_and_of_magnitude_and_phase_are_the_same() {
    let truth = truth();
    let mut parts = String::from("frequency_hz,real_um_n,imaginary_um_n\n");
    let mut polar = String::from("frequency_hz;magnitude_m_n;phase_deg\n");
    for i in 0..60 {
        let f_hz = 300.0 + 15.0 * f64::from(i);
        let g = truth.at(f_hz);
        let degrees = g.im.atan2(g.re).to_degrees();
        writeln!(parts, "{f_hz},{:?},{:?}", 1e6 * g.re, 1e6 * g.im).unwrap();
        writeln!(polar, "{f_hz};{:?};{degrees:?}", g.norm_sqr().sqrt()).unwrap();
    }
    let [parts, polar] = [parts, polar].map(|text| MeasuredResponse::read(&text).unwrap());
    assert_eq!(parts.frequency_hz, polar.frequency_hz);
    for (a, b) in parts.response_m_n.iter().zip(&polar.response_m_n) {
        assert!((a - b).norm_sqr().sqrt() < 1e-12 * a.norm_sqr().sqrt() + 1e-22, "{a} {b}");
    }
}

#[test]
fn what_is_no_response_is_refused_in_words() {
    let told = |text: &str| MeasuredResponse::read(text).unwrap_err();
    assert!(told("f,real_m_n\n1,2\n").contains("frequency_hz"));
    assert!(told("frequency_hz,real_m_n,imaginary_m_n\n1,2,3\n").contains("1 points"));
    let cell = told("frequency_hz,real_m_n,imaginary_m_n\n1,2,x\n");
    assert!(cell.contains("line 2") && cell.contains("imaginary_m_n"), "{cell}");
    let mut turned = recorded(0.0);
    turned.frequency_hz.swap(3, 4);
    assert!(identify_structure(&turned, TipAxis::X, None).unwrap_err().contains("ascend"));
    let mut flat = recorded(0.0);
    flat.response_m_n.fill(Complex::from(1e-9));
    assert!(identify_structure(&flat, TipAxis::X, None).unwrap_err().contains("no resonance"));
}
