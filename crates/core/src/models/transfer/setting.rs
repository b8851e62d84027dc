//! Poles as a setting.

use super::MAX_ORDER;
use crate::base::language::tr;
use crate::base::settings::{Editor, Structure, Value};

/// Slowest decay that a pole may have, rad/s.
pub const SLOWEST_RAD_S: f64 = 0.1;
/// Largest real and imaginary part of a pole, rad/s.
pub const LARGEST_RAD_S: f64 = 1e4;

/// The poles of a transfer function, real and imaginary part in rad/s; one with an imaginary part, which is positive,
/// stands for itself and its conjugate. None where a drive of the list stands.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TransferPoles {
    poles: Vec<[f64; 2]>,
}

fn allowed() -> String {
    tr!(
        "stable poles: real parts from {slowest} down to {fastest} rad/s, imaginary parts from 0 to {largest} rad/s, \
         order at most {n}",
        slowest = -SLOWEST_RAD_S,
        fastest = -LARGEST_RAD_S,
        largest = LARGEST_RAD_S,
        n = MAX_ORDER
    )
}

impl TransferPoles {
    /// Takes poles over, a pair by the one with positive imaginary part.
    ///
    /// # Errors
    /// Names a pole that is not stable or out of range, or an order that is too high.
    pub fn new(poles: Vec<[f64; 2]>) -> Result<Self, String> {
        for (place, [re, im]) in poles.iter().enumerate() {
            let stable = (-LARGEST_RAD_S..=-SLOWEST_RAD_S).contains(re);
            if !stable || !(0.0..=LARGEST_RAD_S).contains(im) {
                return Err(tr!(
                    "pole {place} cannot be {re} and {im} rad/s: allowed is {allowed}",
                    place = place + 1,
                    re = *re,
                    im = *im,
                    allowed = allowed()
                ));
            }
        }
        let these = Self { poles };
        if these.order() > MAX_ORDER {
            return Err(tr!(
                "the order cannot be {order}: allowed is {allowed}",
                order = these.order(),
                allowed = allowed()
            ));
        }
        Ok(these)
    }

    /// The poles, a pair by the one with positive imaginary part.
    #[must_use]
    pub fn all(&self) -> &[[f64; 2]] {
        &self.poles
    }

    /// Number of poles, those of pairs both.
    #[must_use]
    pub fn order(&self) -> usize {
        self.poles.iter().map(|[_, im]| if *im == 0.0 { 1 } else { 2 }).sum()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.poles.is_empty()
    }
}

/// A list of [real, imaginary].
impl Structure for TransferPoles {
    const ID: &'static str = "transfer_poles";

    fn bounds(_: [f64; 2]) -> Vec<(&'static str, f64)> {
        vec![
            ("slowest_rad_s", SLOWEST_RAD_S),
            ("largest_rad_s", LARGEST_RAD_S),
            ("max_order", MAX_ORDER as f64),
        ]
    }
    fn allowed(_: [f64; 2], _: &str) -> String {
        tr!("lists [real, imaginary] of {poles}", poles = allowed())
    }
    fn write(&self) -> Value {
        self.poles.clone().into()
    }
    fn read(value: &Value, _: [f64; 2]) -> Option<Self> {
        let poles = value.list()?.iter().map(Value::array).collect::<Option<Vec<[f64; 2]>>>()?;
        // + 0.0 turns -0.0 into 0.0, so that equal settings have equal bits.
        Self::new(poles.into_iter().map(|pole| pole.map(|x| x + 0.0)).collect()).ok()
    }
    fn editor(_: [f64; 2]) -> Editor {
        Editor::Presence
    }
    fn example(_: [f64; 2], share: f64, pick: u32) -> Value {
        let re = -SLOWEST_RAD_S - share * (LARGEST_RAD_S - SLOWEST_RAD_S);
        let poles = [[re, 0.0], [re, share * LARGEST_RAD_S], [-14.0, 0.0]];
        poles[..1 + pick as usize % 3].to_vec().into()
    }
}

crate::structured!(TransferPoles);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stable_poles_are_demanded_and_the_order_is_limited() {
        let told = |poles: Vec<[f64; 2]>| TransferPoles::new(poles).unwrap_err();
        for (error, parts) in [
            (told(vec![[-14.0, 0.0], [1.0, 0.0]]), ["pole 2", "1", "stable poles"]),
            (told(vec![[-14.0, -3.0]]), ["pole 1", "-3", "0 to 10000"]),
            (told(vec![[f64::NAN, 0.0]]), ["pole 1", "NaN", "stable"]),
            (told(vec![[-5.0, 2.0]; 5]), ["order", "10", "at most 8"]),
        ] {
            assert!(parts.iter().all(|part| error.contains(part)), "{error}");
        }
        let poles = TransferPoles::new(vec![[-14.0, 0.0], [-77.5, 171.74]]).unwrap();
        assert_eq!(poles.order(), 3);
        assert_eq!(
            <TransferPoles as Structure>::read(&Structure::write(&poles), [0.0; 2]),
            Some(poles)
        );
    }
}
