//! The graphics adapter's part: a picture with depth and smooth edges in a texture of its own, and
//! its way onto the screen.

mod kept;

use std::sync::Arc;

use eframe::egui_wgpu::{Callback, CallbackResources, CallbackTrait, ScreenDescriptor, wgpu};
use egui::{Color32, Context, Id, PaintCallbackInfo, Rect, Shape};

use super::camera::Camera;
use super::mesh::Mesh;
use kept::{Drawn, Gpu, PICTURE};

/// Longest side of the picture, pixels: more is not seen, and software adapters are slow.
const LONGEST: f32 = 2048.0;

fn format_id() -> Id {
    Id::unique("format of the screen")
}

/// Gives the pictures the format of the screen of a new window or page; without it they take that of
/// a test without a window.
pub fn prepare(cc: &eframe::CreationContext<'_>) {
    if let Some(state) = &cc.wgpu_render_state {
        cc.egui_ctx.data_mut(|data| data.insert_temp(format_id(), state.target_format));
    }
}

/// The shape that shows `mesh` in `rect` as the camera sees it.
pub fn picture(
    ctx: &Context,
    rect: Rect,
    camera: &Camera,
    mesh: Arc<Mesh>,
    background: Color32,
) -> Shape {
    let format = ctx.data(|data| data.get_temp(format_id()));
    let shown = Picture {
        format: format.unwrap_or(PICTURE),
        size: rect.size() * ctx.pixels_per_point(),
        camera: *camera,
        aspect: rect.aspect_ratio(),
        mesh,
        background,
    };
    Shape::Callback(Callback::new_paint_callback(rect, shown))
}

struct Picture {
    format: wgpu::TextureFormat,
    size: egui::Vec2,
    camera: Camera,
    aspect: f32,
    mesh: Arc<Mesh>,
    background: Color32,
}

impl Picture {
    fn look(&self) -> Vec<u8> {
        let matrix = self.camera.projection(self.aspect);
        // The lamp stands above, well to the left of the eye: faces at a right angle differ.
        let [x, y, z] = self.camera.backwards();
        let lamp = super::camera::unit([0.25 * x + 0.9 * y, 0.25 * y - 0.9 * x, z + 0.9]);
        let numbers = matrix.iter().flatten().chain(&lamp).chain(&[0.0]);
        numbers.flat_map(|x| x.to_ne_bytes()).collect()
    }

    fn pixels(&self) -> [u32; 2] {
        let size = self.size * (LONGEST / self.size.max_elem()).min(1.0);
        [size.x, size.y].map(|x| (x.round() as u32).max(1))
    }
}

impl CallbackTrait for Picture {
    fn prepare(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        _screen: &ScreenDescriptor,
        encoder: &mut wgpu::CommandEncoder,
        kept: &mut CallbackResources,
    ) -> Vec<wgpu::CommandBuffer> {
        let gpu: &mut Gpu = kept.entry().or_insert_with(|| Gpu::new(device, self.format));
        let (look, pixels, background) = (self.look(), self.pixels(), self.background);
        let before = gpu.drawn.as_ref();
        let same_mesh = before.is_some_and(|drawn| Arc::ptr_eq(&drawn.mesh, &self.mesh));
        let same_view = before.is_some_and(|drawn| {
            (&drawn.look, drawn.pixels, drawn.background) == (&look, pixels, background)
        });
        if same_mesh && same_view {
            return Vec::new();
        }
        gpu.resize(device, pixels);
        queue.write_buffer(&gpu.look, 0, &look);
        if !same_mesh {
            gpu.corners.write(device, queue, &self.mesh.corners);
            let numbers = self.mesh.triangles.iter().chain(&self.mesh.glass);
            let triangles: Vec<u8> = numbers.flat_map(|number| number.to_ne_bytes()).collect();
            gpu.triangles.write(device, queue, &triangles);
        }
        gpu.drawn = Some(Drawn { mesh: Arc::clone(&self.mesh), look, pixels, background });
        let Some(canvas) = &gpu.canvas else { return Vec::new() };
        let [r, g, b] =
            [background.r(), background.g(), background.b()].map(|part| f64::from(part) / 255.0);
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("scene"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &canvas.color,
                depth_slice: None,
                resolve_target: Some(&canvas.resolved),
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color { r, g, b, a: 1.0 }),
                    store: wgpu::StoreOp::Discard,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &canvas.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(1.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            ..wgpu::RenderPassDescriptor::default()
        });
        // What is seen through comes after what hides it.
        let solid = self.mesh.triangles.len() as u32;
        let all = solid + self.mesh.glass.len() as u32;
        let parts =
            [(&gpu.scene, &gpu.scene_group, 0..solid), (&gpu.glass, &gpu.glass_group, solid..all)];
        for (pipeline, group, range) in parts.into_iter().filter(|(.., range)| !range.is_empty()) {
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, group, &[]);
            pass.set_vertex_buffer(0, gpu.corners.buffer.slice(..));
            pass.set_index_buffer(gpu.triangles.buffer.slice(..), wgpu::IndexFormat::Uint32);
            pass.draw_indexed(range, 0, 0..1);
        }
        drop(pass);
        Vec::new()
    }

    fn paint(
        &self,
        _info: PaintCallbackInfo,
        pass: &mut wgpu::RenderPass<'static>,
        kept: &CallbackResources,
    ) {
        let Some(gpu) = kept.get::<Gpu>() else { return };
        let Some(canvas) = &gpu.canvas else { return };
        pass.set_pipeline(&gpu.screen);
        pass.set_bind_group(0, &canvas.group, &[]);
        pass.draw(0..3, 0..1);
    }
}
