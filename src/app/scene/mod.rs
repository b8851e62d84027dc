//! Pictures in space, drawn with wgpu inside the console: triangles go in, an orbit camera looks at
//! them, and the graphics adapter draws them into a texture of its own with depth and smooth edges,
//! which then stands on the screen like any other shape. So nothing is asked of the console's own
//! render pass, and a window, a page under WebGL and a test without a window draw alike.

pub mod camera;
mod gpu;
pub mod mesh;

pub use gpu::{picture, prepare};
