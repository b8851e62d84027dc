//! The graphics adapter's part: a picture with depth and smooth edges in a texture of its own, and
//! its way onto the screen.

use std::sync::Arc;

use eframe::egui_wgpu::{Callback, CallbackResources, CallbackTrait, ScreenDescriptor, wgpu};
use egui::{Color32, Context, Id, PaintCallbackInfo, Rect, Shape};

use super::camera::Camera;
use super::mesh::{CORNER_BYTES, Mesh};

/// Format of the picture, and of its depth.
const PICTURE: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth24Plus;
/// Samples of a pixel: smooth edges; every adapter can do four.
const SAMPLES: u32 = 4;
/// Longest side of the picture, pixels: more is not seen, and software adapters are slow.
const LONGEST: f32 = 2048.0;
/// Bytes of the uniform block of the shader: a matrix and a direction.
const LOOK_BYTES: u64 = 80;

fn format_id() -> Id {
    Id::unique("format of the screen")
}

/// Tells the pictures what format the screen of a new window or page has; without it they take
/// that of a test without a window.
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

/// What is kept on the adapter from frame to frame.
struct Gpu {
    scene: wgpu::RenderPipeline,
    screen: wgpu::RenderPipeline,
    look: wgpu::Buffer,
    look_group: wgpu::BindGroup,
    reader: wgpu::Sampler,
    corners: Store,
    triangles: Store,
    canvas: Option<Canvas>,
    drawn: Option<Drawn>,
}

/// What the picture holds: nothing is done where it is the same again.
struct Drawn {
    mesh: Arc<Mesh>,
    look: Vec<u8>,
    pixels: [u32; 2],
    background: Color32,
}

/// A buffer that grows with what is put into it, and what was put in last.
struct Store {
    buffer: wgpu::Buffer,
    usage: wgpu::BufferUsages,
}

/// Textures of a size.
struct Canvas {
    size: [u32; 2],
    color: wgpu::TextureView,
    depth: wgpu::TextureView,
    resolved: wgpu::TextureView,
    group: wgpu::BindGroup,
}

impl Store {
    fn new(device: &wgpu::Device, usage: wgpu::BufferUsages, bytes: u64) -> Self {
        let usage = usage | wgpu::BufferUsages::COPY_DST;
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("scene"),
            size: bytes,
            usage,
            mapped_at_creation: false,
        });
        Self { buffer, usage }
    }

    fn write(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, bytes: &[u8]) {
        if self.buffer.size() < bytes.len() as u64 {
            *self = Self::new(device, self.usage, (bytes.len() as u64).next_power_of_two());
        }
        queue.write_buffer(&self.buffer, 0, bytes);
    }
}

fn pipeline(
    device: &wgpu::Device,
    shader: &wgpu::ShaderModule,
    [vertex, fragment]: [&str; 2],
    target: wgpu::TextureFormat,
    in_space: bool,
) -> wgpu::RenderPipeline {
    let attributes = wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Unorm8x4];
    let corners = [Some(wgpu::VertexBufferLayout {
        array_stride: CORNER_BYTES as u64,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &attributes,
    })];
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("scene"),
        layout: None,
        vertex: wgpu::VertexState {
            module: shader,
            entry_point: Some(vertex),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: if in_space { &corners } else { &[] },
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: in_space.then(|| wgpu::DepthStencilState {
            format: DEPTH,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::LessEqual),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }),
        multisample: wgpu::MultisampleState {
            count: if in_space { SAMPLES } else { 1 },
            ..wgpu::MultisampleState::default()
        },
        fragment: Some(wgpu::FragmentState {
            module: shader,
            entry_point: Some(fragment),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(target.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}

impl Gpu {
    fn new(device: &wgpu::Device, screen_format: wgpu::TextureFormat) -> Self {
        let shader = device.create_shader_module(wgpu::include_wgsl!("scene.wgsl"));
        let scene = pipeline(device, &shader, ["corner", "lit"], PICTURE, true);
        let onto = if screen_format.is_srgb() { "shown_linear" } else { "shown" };
        let screen = pipeline(device, &shader, ["whole", onto], screen_format, false);
        let look = Store::new(device, wgpu::BufferUsages::UNIFORM, LOOK_BYTES).buffer;
        let look_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("scene look"),
            layout: &scene.get_bind_group_layout(0),
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: look.as_entire_binding() }],
        });
        let reader = device.create_sampler(&wgpu::SamplerDescriptor {
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            ..wgpu::SamplerDescriptor::default()
        });
        let corners = Store::new(device, wgpu::BufferUsages::VERTEX, 1 << 16);
        let triangles = Store::new(device, wgpu::BufferUsages::INDEX, 1 << 16);
        Self {
            scene,
            screen,
            look,
            look_group,
            reader,
            corners,
            triangles,
            canvas: None,
            drawn: None,
        }
    }

    fn resize(&mut self, device: &wgpu::Device, size: [u32; 2]) {
        if self.canvas.as_ref().is_some_and(|canvas| canvas.size == size) {
            return;
        }
        let texture = |format, samples, usage| {
            let texture = device.create_texture(&wgpu::TextureDescriptor {
                label: Some("scene"),
                size: wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: samples,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: usage | wgpu::TextureUsages::RENDER_ATTACHMENT,
                view_formats: &[],
            });
            texture.create_view(&wgpu::TextureViewDescriptor::default())
        };
        let none = wgpu::TextureUsages::empty();
        let resolved = texture(PICTURE, 1, wgpu::TextureUsages::TEXTURE_BINDING);
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("scene picture"),
            layout: &self.screen.get_bind_group_layout(0),
            entries: &[
                wgpu::BindGroupEntry {
                    binding: 0,
                    resource: wgpu::BindingResource::TextureView(&resolved),
                },
                wgpu::BindGroupEntry {
                    binding: 1,
                    resource: wgpu::BindingResource::Sampler(&self.reader),
                },
            ],
        });
        let (color, depth) = (texture(PICTURE, SAMPLES, none), texture(DEPTH, SAMPLES, none));
        self.canvas = Some(Canvas { size, color, depth, resolved, group });
    }
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
            let triangles: Vec<u8> =
                self.mesh.triangles.iter().flat_map(|number| number.to_ne_bytes()).collect();
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
        if !self.mesh.triangles.is_empty() {
            pass.set_pipeline(&gpu.scene);
            pass.set_bind_group(0, &gpu.look_group, &[]);
            pass.set_vertex_buffer(0, gpu.corners.buffer.slice(..));
            pass.set_index_buffer(gpu.triangles.buffer.slice(..), wgpu::IndexFormat::Uint32);
            pass.draw_indexed(0..self.mesh.triangles.len() as u32, 0, 0..1);
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
