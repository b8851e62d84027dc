//! What is kept on the graphics adapter from frame to frame. Nothing of it is more than WebGL 2
//! has: four samples of an 8-bit colour, 24 bits of depth, 32-bit numbers of corners.

use std::sync::Arc;

use eframe::egui_wgpu::wgpu;
use egui::Color32;

use crate::app::scene::mesh::{CORNER_BYTES, Mesh};

/// Format of the picture, and of its depth.
pub(super) const PICTURE: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth24Plus;
/// Samples of a pixel: smooth edges; every adapter can do four.
const SAMPLES: u32 = 4;
/// Bytes of the uniform block of the shader: a matrix and a direction.
const LOOK_BYTES: u64 = 80;

/// What is kept on the adapter from frame to frame.
pub(super) struct Gpu {
    pub(super) scene: wgpu::RenderPipeline,
    pub(super) glass: wgpu::RenderPipeline,
    pub(super) screen: wgpu::RenderPipeline,
    pub(super) look: wgpu::Buffer,
    pub(super) scene_group: wgpu::BindGroup,
    pub(super) glass_group: wgpu::BindGroup,
    reader: wgpu::Sampler,
    pub(super) corners: Store,
    pub(super) triangles: Store,
    pub(super) canvas: Option<Canvas>,
    pub(super) drawn: Option<Drawn>,
}

/// What the picture holds: nothing is done where it is the same again.
pub(super) struct Drawn {
    pub(super) mesh: Arc<Mesh>,
    pub(super) look: Vec<u8>,
    pub(super) pixels: [u32; 2],
    pub(super) background: Color32,
}

/// A buffer that grows with what is put into it, and what was put in last.
pub(super) struct Store {
    pub(super) buffer: wgpu::Buffer,
    usage: wgpu::BufferUsages,
}

/// Textures of a size.
pub(super) struct Canvas {
    size: [u32; 2],
    pub(super) color: wgpu::TextureView,
    pub(super) depth: wgpu::TextureView,
    pub(super) resolved: wgpu::TextureView,
    pub(super) group: wgpu::BindGroup,
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

    pub(super) fn write(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, bytes: &[u8]) {
        if self.buffer.size() < bytes.len() as u64 {
            *self = Self::new(device, self.usage, (bytes.len() as u64).next_power_of_two());
        }
        queue.write_buffer(&self.buffer, 0, bytes);
    }
}

/// What a pipeline draws.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Draws {
    /// Triangles in space that hide what is behind them.
    Solid,
    /// Triangles in space that are seen through.
    Glass,
    /// The finished picture onto the screen.
    Screen,
}

fn pipeline(
    device: &wgpu::Device,
    shader: &wgpu::ShaderModule,
    [vertex, fragment]: [&str; 2],
    target: wgpu::TextureFormat,
    draws: Draws,
) -> wgpu::RenderPipeline {
    let in_space = draws != Draws::Screen;
    let blend = (draws == Draws::Glass).then_some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING);
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
            depth_write_enabled: Some(draws == Draws::Solid),
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
            targets: &[Some(wgpu::ColorTargetState {
                format: target,
                blend,
                write_mask: wgpu::ColorWrites::ALL,
            })],
        }),
        multiview_mask: None,
        cache: None,
    })
}

impl Gpu {
    pub(super) fn new(device: &wgpu::Device, screen_format: wgpu::TextureFormat) -> Self {
        let shader = device.create_shader_module(wgpu::include_wgsl!("../scene.wgsl"));
        let scene = pipeline(device, &shader, ["corner", "lit"], PICTURE, Draws::Solid);
        let glass = pipeline(device, &shader, ["corner", "lit"], PICTURE, Draws::Glass);
        let onto = if screen_format.is_srgb() { "shown_linear" } else { "shown" };
        let screen = pipeline(device, &shader, ["whole", onto], screen_format, Draws::Screen);
        let look = Store::new(device, wgpu::BufferUsages::UNIFORM, LOOK_BYTES).buffer;
        let [scene_group, glass_group] = [&scene, &glass].map(|pipeline| {
            device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("scene look"),
                layout: &pipeline.get_bind_group_layout(0),
                entries: &[wgpu::BindGroupEntry { binding: 0, resource: look.as_entire_binding() }],
            })
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
            glass,
            screen,
            look,
            scene_group,
            glass_group,
            reader,
            corners,
            triangles,
            canvas: None,
            drawn: None,
        }
    }

    pub(super) fn resize(&mut self, device: &wgpu::Device, size: [u32; 2]) {
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
