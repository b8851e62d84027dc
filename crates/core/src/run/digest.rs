//! The digest of a run: equal digests mean equal bits of every signal at every recorded tick.
//!
//! It is XXH3 with 64 bits and seed 0 (Y. Collet, xxHash specification), written as 16 hexadecimal
//! digits, over these bytes and no others: row by row in the order of recording, in a row the
//! signals in the order of [`super::signals::SIGNALS`], every value as the eight bytes of its binary64 form, least
//! significant byte first. A CSV file of the run holds the same values in the same order, each in a
//! form that reads back to the same bits; an empty cell, where there is no value, counts as 0. So anybody can check a digest, for example in Python:
//!
//! ```text
//! import numpy, xxhash          # steadycut run table3-5 --out run.csv
//! rows = numpy.genfromtxt("run.csv", delimiter=",", skip_header=1, filling_values=0)
//! print(xxhash.xxh3_64_hexdigest(rows.astype("<f8").tobytes()))
//! ```

use xxhash_rust::xxh3::Xxh3Default;

use super::signals::Row;

/// A running XXH3 over 64-bit words, each taken in least significant byte first.
#[derive(Clone, Default)]
pub struct Digest(Xxh3Default);

impl Digest {
    /// Takes in one word.
    pub fn word(&mut self, word: u64) {
        self.0.update(&word.to_le_bytes());
    }

    /// Takes in the bytes of a text.
    pub fn text(&mut self, text: &str) {
        self.0.update(text.as_bytes());
    }

    /// Takes in one row.
    pub fn row(&mut self, row: &Row) {
        let mut bytes = [0; 8 * Row::LEN];
        for (place, value) in bytes.as_chunks_mut::<8>().0.iter_mut().zip(row.values()) {
            *place = value.to_le_bytes();
        }
        self.0.update(&bytes);
    }

    /// The digest as 16 hexadecimal digits.
    #[must_use]
    pub fn hex(&self) -> String {
        format!("{:016x}", self.0.digest())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What Python's `xxhash.xxh3_64_hexdigest` gives for rows of the numbers 1, 2, 3, ... as
    /// `struct.pack("<%dd" % n, *range(1, n + 1))`.
    #[test]
    fn it_is_xxh3_over_little_endian_doubles() {
        let after = |count: u32| {
            let mut digest = Digest::default();
            (1..=count).for_each(|x| digest.word(f64::from(x).to_bits()));
            digest.hex()
        };
        // The empty input's value is printed in the specification's test vectors.
        assert_eq!(after(0), "2d06800538d394c2");
        assert_eq!(after(1), "620bae6765497e01");
        assert_eq!(after(2), "699392ab66f8cce1");
        assert_eq!(after(23), "c04364f9f90d4bf1");
        assert_eq!(after(31), "41adc7ce87f3fa67");
        assert_eq!(after(400), "0eb239b99e9adafb");
    }

    #[test]
    fn a_row_is_its_values_one_after_another() {
        let row = Row { time_s: 0.5, force_n: 170.0, state_flags: 256.0, ..Row::default() };
        let (mut whole, mut words) = (Digest::default(), Digest::default());
        whole.row(&row);
        row.values().into_iter().for_each(|value| words.word(value.to_bits()));
        assert_eq!(whole.hex(), words.hex());
    }

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
