//! The equations as their sources print them, for the model sets and the drive in use.

use super::super::scenario::Scenario;
use super::Block;
use crate::base::language::text;
use crate::blocks::control::law::Held;
use crate::models::feed_drive::FeedDriveKind;
use crate::models::genetic::ModelSet;
use crate::models::printed::Printed;

const fn eq(formula: &'static str, source: &'static str) -> Printed {
    Printed::new(formula, source)
}

const K1: Printed = eq("F_d = 293 - 593 / √(39.37 Ra)", text!("SDNRP 2007, eq. 4"));
const K2: Printed = eq("f_c = 25.4 (189 - 5926160 / F_s^2)", text!("SDNRP 2007, eq. 5"));
const K3: Printed = eq("n_c = √(30064193 - 2.28 F_s^3)", text!("SDNRP 2007, eq. 6"));
const K5: Printed = eq("Ra = 0.0254 (593 / (293 - F))^2", text!("SDNRP 2007, eq. 8"));
const M1: Printed =
    eq("F = 69.306 Ra^3 - 270.18 Ra^2 + 398.82 Ra + 14.875", text!("Control strategy 2013, eq. 2"));
const M2: Printed = eq(
    "f_c = 10^{05} F^4 - 0.01 F^3 + 2.7568 F^2 - 333.75 F + 15348",
    text!("Control strategy 2013, eq. 3 (\"10^05\" can only be 10^-5)"),
);
const M3: Printed = eq("n_c = 7641.3 e^{-0.004 F}", text!("Control strategy 2013, eq. 4"));
const M5: Printed = eq("Ra = 0.0001 F^2 - 0.0341 F + 3.018", text!("Control strategy 2013, eq. 6"));

const OWN_FEED_DRIVE: Printed =
    eq("f_a / f_c = K / Π (1 - s / p_i)", text!("a drive of your own, by its poles and gain"));
const OWN_SPINDLE_DRIVE: Printed =
    eq("n_a / n_c = K / Π (1 - s / p_i)", text!("a drive of your own, by its poles and gain"));
const OWN_DEAD_TIME: Printed =
    eq("G(s) = e^{-t s}", text!("the dead time of the command channel; the drive is your own"));

/// The transfer function of a drive.
fn drive(kind: FeedDriveKind) -> Printed {
    match kind {
        FeedDriveKind::Eq1Of2007 => eq(
            "f_a / f_c = K_i K_{ip} K_t e^{-st} / (J_e L_a s^3 + J_e (R + K_H K_{ip}) s^2 \
             + K_t (K_p K_{ip} + K_b) s + K_t K_i K_{ip})",
            text!("SDNRP 2007, eq. 1, with the constants of its Table 1"),
        ),
        FeedDriveKind::Eq2Of2007 => eq(
            "f_a / f_c = 497000 e^{-0.08 s} / ((s + 14.0) + (s^2 + 155 s + 35500))",
            text!("SDNRP 2007, eq. 2 (the sum is a misprint: a product has the gain 1)"),
        ),
        FeedDriveKind::Eq3Of2007 => eq(
            "f_a / f_c = 14.0 e^{-0.08 s} / (s + 14.0)",
            text!("SDNRP 2007, eq. 3: the drive that the paper simulates with"),
        ),
        FeedDriveKind::SecondOrder2013 => eq(
            "f_a / f_c = 1 / (0.001024 s^2 + 0.064 s + 1)",
            text!("Control strategy 2013, eq. 1 (\"natural frequency of 3 Hz\" does not fit it)"),
        ),
        FeedDriveKind::Measured3Hz => eq(
            text!("second order, natural frequency 3 Hz, settling time 0.4 s"),
            text!("Control strategy 2013, section 2.2: measured step responses, in words only"),
        ),
    }
}

/// The dead time published with a drive.
fn dead_time(kind: FeedDriveKind) -> Printed {
    match kind {
        FeedDriveKind::Eq1Of2007 | FeedDriveKind::Eq2Of2007 | FeedDriveKind::Eq3Of2007 => eq(
            "G(s) = e^{-0.08 s}",
            text!("SDNRP 2007, eq. 2 and 3 (the text's \"t = 8 s\" is a misprint)"),
        ),
        FeedDriveKind::SecondOrder2013 | FeedDriveKind::Measured3Hz => {
            eq("t = 0.04 s", text!("Control strategy 2013, section 2.2, below eq. 1"))
        }
    }
}

impl Block {
    /// Its equations as printed, those of the model set or drive in use.
    #[must_use]
    pub fn printed(self, scenario: &Scenario) -> Vec<Printed> {
        let set = self.using(scenario).map_or(ModelSet::Sdnrp2007, |using| using.set);
        // Those of the milling simulator have the forms of 2007.
        let of_2007 = set != ModelSet::Strategy2013;
        let kind = scenario.feed_drive.kind;
        match self {
            Self::Reference => vec![if of_2007 { K1 } else { M1 }],
            Self::Controller => {
                let mut law = scenario.controller.printed(set);
                law.extend(match scenario.controller.kind.held() {
                    Held::Roughness if of_2007 => vec![K2, K3],
                    Held::Roughness => vec![M2, M3],
                    Held::Overrides | Held::Force => Vec::new(),
                });
                law
            }
            Self::Override => vec![eq(
                "f_c = DNCFRO · f_p,  n_c = DNCSPO · n_p,  0..250 %",
                text!(
                    "Control strategy 2013, section 2; whole percents and rate: CNC practice, chosen"
                ),
            )],
            Self::DeadTime if !scenario.feed_drive.poles.is_empty() => vec![OWN_DEAD_TIME],
            Self::DeadTime => vec![dead_time(kind)],
            Self::FeedDrive if !scenario.feed_drive.poles.is_empty() => vec![OWN_FEED_DRIVE],
            Self::FeedDrive => vec![drive(kind)],
            Self::SpindleDrive if !scenario.spindle_drive.poles.is_empty() => {
                vec![OWN_SPINDLE_DRIVE]
            }
            Self::SpindleDrive => vec![eq(
                "n_a' = limit((n_c - n_a) / τ, ± rate)",
                text!("chosen: no paper gives a spindle drive"),
            )],
            Self::Cutting => scenario.plant.force_model.printed(set).to_vec(),
            Self::Dynamic => vec![eq(
                "F_{dyn} = F (1 + level (b(t) + ripple sin θ + w(x)))",
                text!(
                    "SDNRP 2007, Fig. 10 (lost): random, sized like measured oscillations; form chosen"
                ),
            )],
            Self::Dynamometer => vec![eq(
                "F_m = F_{dyn} + sensor noise",
                text!("SDNRP 2007, section 1: Kistler force transducer; noise chosen"),
            )],
            Self::Surface | Self::SurfaceDynamic => vec![if of_2007 { K5 } else { M5 }],
        }
    }
}
