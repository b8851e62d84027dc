//! The loudspeaker under Linux: samples are piped into the player of the sound system at hand. A
//! library would need ALSA's headers wherever the console is built; nothing but Rust is asked for.

use std::io::Write;
use std::process::{Child, Command, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::looped::Shared;
use crate::base::language::{self, tr};

/// Samples per second, one channel, floats of 32 bits.
const RATE_HZ: u32 = 44_100;
/// Samples that are handed over at once: some twentieth of a second.
const CHUNK: usize = 2048;
/// Players with their arguments: PulseAudio, PipeWire, ALSA.
const PLAYERS: [(&str, &[&str]); 3] = [
    ("pacat", &["--format=float32le", "--rate=44100", "--channels=1", "--latency-msec=80"]),
    ("pw-cat", &["--playback", "--raw", "--format=f32", "--rate=44100", "--channels=1", "-"]),
    ("aplay", &["-q", "-t", "raw", "-f", "FLOAT_LE", "-r", "44100", "-c", "1", "-"]),
];

/// The player, playing until it is dropped.
pub struct Speaker {
    shared: Shared,
    over: Arc<AtomicBool>,
}

impl Speaker {
    /// Starts the first player that there is, silent.
    ///
    /// # Errors
    /// There is none: in words for people.
    #[expect(
        clippy::disallowed_methods,
        reason = "a front end: the player is fed beside the picture"
    )]
    pub fn open() -> Result<Self, String> {
        let mut players = PLAYERS.iter();
        let first = players.find_map(started).ok_or_else(|| {
            tr(
                "no player was found: pacat (PulseAudio), pw-cat (PipeWire) or aplay (ALSA; Debian: apt install \
                 alsa-utils)",
            )
        })?;
        let speaker = Self { shared: Shared::new(RATE_HZ), over: Arc::new(AtomicBool::new(false)) };
        let (shared, over) = (speaker.shared.clone(), Arc::clone(&speaker.over));
        let spoken = language::catalogue();
        std::thread::spawn(move || {
            // One that ends at once may lack its sound server: the next may have one.
            for player in std::iter::once(first).chain(players.filter_map(started)) {
                if feed(player, &shared, &over) {
                    return;
                }
            }
            language::use_catalogue(spoken);
            let problem = tr("the sound system's player has ended: is there a sound output?");
            shared.fail(problem.to_owned());
        });
        Ok(speaker)
    }

    /// Samples per second.
    #[must_use]
    pub fn rate_hz(&self) -> u32 {
        RATE_HZ
    }

    /// Plays `block`, samples within -1 to 1, over and over; an empty one is silence.
    pub fn play(&mut self, block: Vec<f32>) {
        self.shared.looped().play(block);
    }

    /// Sets the volume, 0 to 1.
    pub fn set_volume(&mut self, volume: f32) {
        self.shared.looped().set_volume(volume);
    }

    /// What has gone wrong since, if it plays no more: there is no sound output, for example.
    #[must_use]
    pub fn failure(&self) -> Option<String> {
        self.shared.failure()
    }
}

impl Drop for Speaker {
    fn drop(&mut self) {
        self.over.store(true, Ordering::Relaxed);
    }
}

/// A player, if there is one of this name.
fn started((name, arguments): &(&str, &[&str])) -> Option<Child> {
    let mut command = Command::new(name);
    command.args(*arguments).stdin(Stdio::piped());
    command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().ok()
}

/// Hands samples over until the speaker is dropped (`true`) or the player ends; the full pipe keeps
/// the pace.
fn feed(mut player: Child, shared: &Shared, over: &AtomicBool) -> bool {
    let mut bytes = Vec::with_capacity(4 * CHUNK);
    if let Some(mut pipe) = player.stdin.take() {
        while !over.load(Ordering::Relaxed) {
            bytes.clear();
            {
                let mut looped = shared.looped();
                (0..CHUNK).for_each(|_| bytes.extend_from_slice(&looped.sample().to_le_bytes()));
            }
            if pipe.write_all(&bytes).is_err() {
                break;
            }
        }
    }
    // It may be gone already, and its end is waited for in either case.
    let _ = player.kill();
    let _ = player.wait();
    over.load(Ordering::Relaxed)
}
