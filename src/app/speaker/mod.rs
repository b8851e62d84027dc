//! A loudspeaker that plays blocks of samples over and over: the desktop's by cpal, a page's by
//! Web Audio. A new block fades in over the old one, so that a change does not click.

#[cfg(not(target_arch = "wasm32"))]
mod looped;
#[cfg(not(target_arch = "wasm32"))]
mod native;
#[cfg(target_arch = "wasm32")]
mod page;

#[cfg(not(target_arch = "wasm32"))]
pub use native::Speaker;
#[cfg(target_arch = "wasm32")]
pub use page::Speaker;

/// Time in which a block or a volume gives way to the next one, s.
const FADE_S: f64 = 0.05;
