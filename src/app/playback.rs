//! The playhead: which part of the run is revealed, and how fast it moves.

use crate::base::language::{self, tr};

/// How fast the playhead moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Speed {
    /// Seconds of the run per second of real time.
    Times(f64),
    /// As far as the run is simulated, at once.
    Max,
}

impl Speed {
    /// The speeds on offer, slowest first.
    pub const ALL: [Self; 9] = [
        Self::Times(0.1),
        Self::Times(0.2),
        Self::Times(0.5),
        Self::Times(1.0),
        Self::Times(2.0),
        Self::Times(5.0),
        Self::Times(10.0),
        Self::Times(100.0),
        Self::Max,
    ];

    /// Its name.
    #[must_use]
    pub fn label(self) -> String {
        match self {
            Self::Times(factor) => language::decimal(format!("×{factor}")),
            Self::Max => tr("as fast as possible").to_owned(),
        }
    }
}

/// The state of playing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Playback {
    /// Up to where the run is revealed, s.
    pub playhead_s: f64,
    /// Whether the playhead moves.
    pub playing: bool,
    /// Whether it stands at the end of the run, and stays there while the run gets longer.
    pub at_end: bool,
    /// How fast it moves.
    pub speed: Speed,
    /// Whether the plots follow it.
    pub follow: bool,
}

impl Playback {
    /// At the start, playing at natural speed.
    #[must_use]
    pub fn from_start() -> Self {
        let speed = Speed::Times(1.0);
        Self { playhead_s: 0.0, playing: true, at_end: false, speed, follow: true }
    }

    /// Goes back to the start and plays.
    pub fn restart(&mut self) {
        (self.playhead_s, self.playing, self.at_end) = (0.0, true, false);
    }

    /// Moves on by `dt_s` seconds of real time within what is simulated; stops at the end of a
    /// run that is over.
    pub fn advance(&mut self, dt_s: f64, simulated_s: f64, over: bool) {
        if self.at_end {
            self.playhead_s = simulated_s;
        }
        if !self.playing {
            return;
        }
        let wish = match self.speed {
            Speed::Times(factor) => self.playhead_s + dt_s * factor,
            Speed::Max => f64::INFINITY,
        };
        // A run that is being simulated again behind the playhead does not pull it back.
        self.playhead_s = wish.min(simulated_s.max(self.playhead_s));
        if over && self.playhead_s >= simulated_s {
            (self.playhead_s, self.playing, self.at_end) = (simulated_s, false, true);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_playhead_keeps_its_speed_and_stops_at_the_end() {
        let mut playback = Playback::from_start();
        playback.speed = Speed::Times(10.0);
        playback.advance(0.1, 5.0, false);
        assert_eq!(playback.playhead_s, 1.0);
        playback.speed = Speed::Max;
        playback.advance(0.1, 5.0, false);
        assert_eq!((playback.playhead_s, playback.playing), (5.0, true));
        playback.advance(0.1, 5.0, true);
        assert_eq!((playback.playhead_s, playback.playing), (5.0, false));
        playback.advance(0.1, 6.0, true);
        assert_eq!((playback.playhead_s, playback.at_end), (6.0, true));
        playback.restart();
        assert_eq!((playback.playhead_s, playback.playing), (0.0, true));
    }
}
