// umbrage 0.1.0, MIT License: fetch_clamped
// Paste along: texel.wgsl

// umbrage_fetch_clamped: texel of a map; coordinates outside move to the nearest texel inside
fn umbrage_fetch_clamped(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    return umbrage_texel(map, size, clamp(texel, vec2f(0.0, 0.0), size - 1.0));
}
