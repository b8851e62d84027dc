use super::*;
use crate::models::structure::MachineSettings;

/// The papers' cut: 430.4 mm/min, 80 m/min on 16 mm, two teeth.
fn papers() -> MachineTrend {
    let cut = WearCut {
        cutting_speed_m_min: 80.0,
        feed_per_tooth_mm: 0.135_214_147_810_504_7,
        axial_depth_mm: 2.0,
    };
    MachineTrend {
        machine: FiveMass::new(&MachineSettings::default()),
        wear: WearSettings::default(),
        life: LifeSettings::default(),
        cut,
        tool: Tool::default(),
        radial_depth_mm: 3.0,
    }
}

#[test]
fn the_reference_table_is_met() {
    let model = papers();
    for (x, sound, vibration_rms_m, ra_um) in [
        (0.0, 0.00538897557962, 7.09386928276e-06, 0.255740479581),
        (0.02, 0.00581287141494, 7.54727843429e-06, 0.269898200529),
        (0.05, 0.00618959193776, 7.93956583255e-06, 0.282135120776),
        (0.1, 0.00648739917855, 8.24279910332e-06, 0.291583617435),
        (0.25, 0.00682985891555, 8.58420546035e-06, 0.302208621383),
        (0.5, 0.00727144514709, 9.01326986572e-06, 0.315539792845),
        (0.75, 0.00774817228783, 9.46286420834e-06, 0.329480137866),
        (0.9, 0.00831310865693, 9.97810743141e-06, 0.345417160467),
        (0.95, 0.00882686226188, 1.04308696438e-05, 0.359385553217),
        (1.0, 0.0099385131226, 1.13621293256e-05, 0.388006011933),
    ] {
        let point = model.at(x);
        assert!((point.sound / sound - 1.0).abs() < 1e-11, "E_S({x}) = {}", point.sound);
        assert!((point.vibration_rms_m / vibration_rms_m - 1.0).abs() < 1e-11, "{point:?}");
        assert!((point.ra_um / ra_um - 1.0).abs() < 1e-11, "{point:?}");
    }
    // The sharp tool by 60 digits.
    assert!((model.at(0.0).sound / 0.00538897557961598 - 1.0).abs() < 1e-13);
}

#[test]
fn the_sound_grows_over_the_life_by_the_reference_ratios() {
    for (exponent, reference) in [(0, 1.6532), (1, 1.8442), (2, 1.9014)] {
        let mut model = papers();
        model.life.sound_exponent = exponent;
        let (new, old) = (model.at(0.0), model.at(1.0));
        assert!((old.sound / new.sound - reference).abs() < 5.1e-5, "s = {exponent}");
        assert!((old.vibration_rms_m / new.vibration_rms_m - 1.6017).abs() < 5.1e-5);
        assert!((old.ra_um / new.ra_um - 1.5172).abs() < 5.1e-5);
    }
}

#[test]
fn process_damping_takes_the_growth_away() {
    let growth = |indentation_n_mm3: f64| {
        let mut model = papers();
        model.wear.indentation_n_mm3 = indentation_n_mm3;
        model.at(1.0).vibration_rms_m / model.at(0.0).vibration_rms_m
    };
    assert!((growth(4e4) - 1.39).abs() < 0.005);
    assert!(growth(1.5e5) < 1.1);
}
