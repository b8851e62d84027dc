//! The largest values of even windows of samples.

/// The running window and the last whole one, of `N` quantities that are not negative.
#[derive(Clone, Debug)]
pub struct WindowMax<const N: usize> {
    samples: u64,
    running: [f64; N],
    held: [f64; N],
}

impl<const N: usize> WindowMax<N> {
    /// Windows of `samples`, at least one; the first begins with sample 0.
    #[must_use]
    pub fn new(samples: u64) -> Self {
        Self { samples: samples.max(1), running: [0.0; N], held: [0.0; N] }
    }

    /// Forgets all values; the windows keep their places.
    pub fn restart(&mut self) {
        (self.running, self.held) = ([0.0; N], [0.0; N]);
    }

    /// Takes sample number `sample`; gives the largest values of the last whole window.
    #[inline]
    pub fn push(&mut self, sample: u64, values: [f64; N]) -> [f64; N] {
        for (largest, value) in self.running.iter_mut().zip(values) {
            *largest = largest.max(value);
        }
        if (sample + 1).is_multiple_of(self.samples) {
            (self.held, self.running) = (self.running, [0.0; N]);
        }
        self.held
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_window_holds_its_largest_value_until_the_next_is_whole() {
        let mut window = WindowMax::new(3);
        let values = [5.0, 1.0, 1.0, 2.0, 0.0, 0.0, 9.0];
        let held = values.iter().enumerate().map(|(k, value)| window.push(k as u64, [*value])[0]);
        assert_eq!(held.collect::<Vec<f64>>(), [0.0, 0.0, 5.0, 5.0, 5.0, 2.0, 2.0]);
        window.restart();
        assert_eq!(window.push(7, [3.0]), [0.0]);
        assert_eq!(window.push(8, [1.0]), [3.0], "the windows keep their places");
    }
}
