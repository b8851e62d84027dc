//! A loudspeaker that plays blocks of samples over and over: under Linux by the sound system's
//! player, on other desktops by cpal, in a page by Web Audio. A new block fades in over the old one, so that a change does not click.

#[cfg(not(target_arch = "wasm32"))]
mod looped;
#[cfg(not(any(target_arch = "wasm32", target_os = "linux")))]
mod native;
#[cfg(target_arch = "wasm32")]
mod page;
#[cfg(target_os = "linux")]
mod piped;

#[cfg(not(any(target_arch = "wasm32", target_os = "linux")))]
pub use native::Speaker;
#[cfg(target_arch = "wasm32")]
pub use page::Speaker;
#[cfg(target_os = "linux")]
pub use piped::Speaker;

/// Time in which a block or a volume gives way to the next one, s.
const FADE_S: f64 = 0.05;
