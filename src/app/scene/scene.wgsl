// The picture: triangles with a colour each, lit by one lamp that stands with the eye.

struct Look {
    // From the world to the screen.
    projection: mat4x4<f32>,
    // Towards the lamp, in the world.
    lamp: vec4<f32>,
}

@group(0) @binding(0) var<uniform> look: Look;

struct Corner {
    @builtin(position) place: vec4<f32>,
    @location(0) normal: vec3<f32>,
    @location(1) color: vec4<f32>,
}

@vertex
fn corner(
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) color: vec4<f32>,
) -> Corner {
    return Corner(look.projection * vec4<f32>(position, 1.0), normal, color);
}

@fragment
fn lit(at: Corner) -> @location(0) vec4<f32> {
    // A normal of length zero: a line, which shines by itself.
    let length = length(at.normal);
    if length < 0.5 {
        return at.color;
    }
    let slope = dot(at.normal / length, look.lamp.xyz);
    // Faces turned away from the lamp differ too.
    let light = 0.3 + 0.75 * (0.5 + 0.5 * slope);
    return vec4<f32>(min(at.color.rgb * light, vec3<f32>(1.0)), at.color.a);
}

// The finished picture onto the screen.
@group(0) @binding(0) var picture: texture_2d<f32>;
@group(0) @binding(1) var reader: sampler;

struct Spot {
    @builtin(position) place: vec4<f32>,
    @location(0) at: vec2<f32>,
}

@vertex
fn whole(@builtin(vertex_index) index: u32) -> Spot {
    // One triangle that covers the screen.
    let at = vec2<f32>(f32((index << 1u) & 2u), f32(index & 2u));
    return Spot(vec4<f32>(at.x * 2.0 - 1.0, 1.0 - at.y * 2.0, 0.0, 1.0), at);
}

@fragment
fn shown(spot: Spot) -> @location(0) vec4<f32> {
    return textureSample(picture, reader, spot.at);
}

// For screens that expect linear light.
@fragment
fn shown_linear(spot: Spot) -> @location(0) vec4<f32> {
    let color = textureSample(picture, reader, spot.at);
    let low = color.rgb / 12.92;
    let high = pow((color.rgb + vec3<f32>(0.055)) / 1.055, vec3<f32>(2.4));
    return vec4<f32>(select(high, low, color.rgb <= vec3<f32>(0.04045)), color.a);
}
