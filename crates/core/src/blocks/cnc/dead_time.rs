//! Dead time of the command channel: a queue of whole plant steps, exact to the tick.

/// A first-in first-out queue of commands, one per tick.
#[derive(Clone, Debug)]
pub struct DeadTime {
    queue: Vec<[f64; 2]>,
    head: usize,
}

impl DeadTime {
    /// A queue of `ticks` steps that first delivers `initial`.
    #[must_use]
    pub fn new(ticks: usize, initial: [f64; 2]) -> Self {
        Self { queue: vec![initial; ticks], head: 0 }
    }

    /// Takes this tick's command and gives the one of `ticks` ticks ago.
    #[inline]
    pub fn pass(&mut self, command: [f64; 2]) -> [f64; 2] {
        if self.queue.is_empty() {
            return command;
        }
        let delayed = std::mem::replace(&mut self.queue[self.head], command);
        self.head += 1;
        if self.head == self.queue.len() {
            self.head = 0;
        }
        delayed
    }

    /// Delivers `initial` first again, as a new cut begins.
    pub fn restart(&mut self, initial: [f64; 2]) {
        self.queue.fill(initial);
    }

    /// Changes the length. Commands under way keep their order; a longer queue repeats its
    /// oldest, a shorter one drops its oldest, as a channel would that suddenly got slower or
    /// faster.
    pub fn resize(&mut self, ticks: usize, current: [f64; 2]) {
        if ticks == self.queue.len() {
            return;
        }
        let under_way: Vec<[f64; 2]> = self.iter().collect();
        let oldest = under_way.first().copied().unwrap_or(current);
        let missing = ticks.saturating_sub(under_way.len());
        let dropped = under_way.len().saturating_sub(ticks);
        let mut queue = vec![oldest; missing];
        queue.extend_from_slice(&under_way[dropped..]);
        *self = Self { queue, head: 0 };
    }

    /// The commands under way, oldest first.
    fn iter(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        let (newer, older) = self.queue.split_at(self.head);
        older.iter().chain(newer).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_delay_is_exact_to_the_tick() {
        for ticks in [0_usize, 1, 2, 80, 500] {
            let mut channel = DeadTime::new(ticks, [-1.0, -1.0]);
            for k in 0..1500_usize {
                let out = channel.pass([k as f64, 0.0])[0];
                let expected = if k < ticks { -1.0 } else { (k - ticks) as f64 };
                assert_eq!(out, expected, "{ticks} ticks, k = {k}");
            }
        }
    }

    #[test]
    fn a_change_of_length_keeps_what_is_under_way_in_order() {
        let mut channel = DeadTime::new(3, [0.0; 2]);
        for k in 1..=5 {
            channel.pass([f64::from(k), 0.0]);
        }
        channel.resize(5, [9.0; 2]);
        let firsts: Vec<f64> = channel.iter().map(|c| c[0]).collect();
        assert_eq!(firsts, [3.0, 3.0, 3.0, 4.0, 5.0]);
        channel.resize(2, [9.0; 2]);
        let firsts: Vec<f64> = channel.iter().map(|c| c[0]).collect();
        assert_eq!(firsts, [4.0, 5.0]);
        channel.resize(0, [9.0; 2]);
        channel.resize(1, [9.0; 2]);
        assert_eq!(channel.pass([1.0; 2]), [9.0; 2]);
    }
}
