//! A looped block on its way to the loudspeaker, sample by sample, and what the console and the thread
//! that plays it share.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::FADE_S;

/// The block that sounds, the one before it as it fades, and the volume.
#[derive(Clone, Debug, Default)]
pub struct Looped {
    block: Vec<f32>,
    place: usize,
    before: Vec<f32>,
    before_place: usize,
    /// Fraction of the block that sounds against the one before.
    fraction: f32,
    volume: f32,
    wanted_volume: f32,
    /// Change of share and volume from a sample to the next.
    step: f32,
}

impl Looped {
    /// Silence; blocks and volumes change over `fade` samples.
    #[must_use]
    pub fn new(fade: usize) -> Self {
        Self { step: 1.0 / fade.max(1) as f32, fraction: 1.0, ..Self::default() }
    }

    /// The block that sounds from now on, from its start; an empty one is silence.
    pub fn play(&mut self, block: Vec<f32>) {
        self.before = std::mem::replace(&mut self.block, block);
        self.before_place = self.place;
        (self.place, self.fraction) = (0, 0.0);
    }

    /// The volume from now on, 0 to 1.
    pub fn set_volume(&mut self, volume: f32) {
        self.wanted_volume = volume.clamp(0.0, 1.0);
    }

    /// The next sample, within -1 to 1 for blocks within it.
    pub fn sample(&mut self) -> f32 {
        let off = self.wanted_volume - self.volume;
        self.volume += off.clamp(-self.step, self.step);
        let new = next(&self.block, &mut self.place);
        let old = next(&self.before, &mut self.before_place);
        let mixed = self.fraction * new + (1.0 - self.fraction) * old;
        self.fraction = (self.fraction + self.step).min(1.0);
        self.volume * mixed
    }
}

/// What is to sound, and what has gone wrong where it is played.
#[derive(Clone, Debug)]
pub struct Shared {
    looped: Arc<Mutex<Looped>>,
    failed: Arc<Mutex<Option<String>>>,
}

impl Shared {
    /// Silence at `rate_hz` samples per second.
    #[must_use]
    pub fn new(rate_hz: u32) -> Self {
        let looped = Looped::new((FADE_S * f64::from(rate_hz)) as usize);
        Self { looped: Arc::new(Mutex::new(looped)), failed: Arc::new(Mutex::new(None)) }
    }

    /// The block and its volume, for the thread that plays it.
    pub fn looped(&self) -> MutexGuard<'_, Looped> {
        lock(&self.looped)
    }

    /// It plays no more: why.
    pub fn fail(&self, problem: String) {
        *lock(&self.failed) = Some(problem);
    }

    /// Why it plays no more, if it does not.
    #[must_use]
    pub fn failure(&self) -> Option<String> {
        lock(&self.failed).clone()
    }
}

/// A panic cannot leave the values behind the lock half written.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

fn next(block: &[f32], place: &mut usize) -> f32 {
    let Some(sample) = block.get(*place) else { return 0.0 };
    *place = (*place + 1) % block.len();
    *sample
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_repeats_without_a_gap_once_it_has_faded_in() {
        let mut looped = Looped::new(4);
        looped.set_volume(1.0);
        looped.play(vec![0.25, -0.5, 1.0]);
        let heard: Vec<f32> = (0..16).map(|_| looped.sample()).collect();
        assert!(heard[0].abs() < 0.25 && heard[5..9] == [1.0, 0.25, -0.5, 1.0], "{heard:?}");
    }

    #[test]
    fn no_change_jumps() {
        let mut looped = Looped::new(100);
        let mut last = 0.0_f32;
        for k in 0..3000 {
            match k {
                0 => looped.set_volume(0.8),
                300 => looped.play(vec![1.0; 7]),
                900 => looped.play(vec![-1.0; 5]),
                1500 => looped.play(Vec::new()),
                1800 => looped.play(vec![0.5]),
                2400 => looped.set_volume(0.0),
                _ => {}
            }
            let now = looped.sample();
            assert!((now - last).abs() < 0.021, "{k}: {last} {now}");
            last = now;
        }
        assert!(last.abs() < 1e-6);
    }

    #[test]
    fn nothing_to_play_is_silence() {
        let mut looped = Looped::new(0);
        looped.set_volume(7.0);
        assert_eq!([looped.sample(), looped.sample()], [0.0, 0.0]);
    }
}
