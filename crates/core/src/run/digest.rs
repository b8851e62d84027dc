//! The digest of a run: equal digests mean equal bits of every signal at every recorded tick.

use super::signals::Row;

/// A 64-bit hash over words (FNV-1a with a final mix), enough to notice any change by accident.
#[derive(Clone, Copy, Debug)]
pub struct Digest(u64);

impl Default for Digest {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Digest {
    /// Takes in one word.
    pub fn word(&mut self, word: u64) {
        // The rotation carries high bits down; plain FNV on words would never move them.
        self.0 = (self.0 ^ word).wrapping_mul(0x0000_0100_0000_01b3).rotate_left(29);
    }

    /// Takes in one row.
    pub fn row(&mut self, row: &Row) {
        for value in row.values() {
            self.word(value.to_bits());
        }
    }

    /// The digest as 16 hexadecimal digits.
    #[must_use]
    pub fn hex(self) -> String {
        let z = (self.0 ^ (self.0 >> 32)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        format!("{:016x}", z ^ (z >> 29))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_changed_bit_anywhere_changes_the_digest() {
        let rows = [Row { force_n: 1.0, ..Row::default() }; 3];
        let digest = |rows: &[Row]| {
            let mut digest = Digest::default();
            rows.iter().for_each(|row| digest.row(row));
            digest.hex()
        };
        let reference = digest(&rows);
        for k in 0..3 {
            let mut changed = rows;
            changed[k].force_n = f64::from_bits(changed[k].force_n.to_bits() ^ 1);
            assert_ne!(digest(&changed), reference);
            changed[k].force_n = f64::from_bits(1.0_f64.to_bits() ^ (1 << 62));
            assert_ne!(digest(&changed), reference);
        }
    }
}
