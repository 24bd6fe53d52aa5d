// umbrage 0.1.0, MIT License: fetch_bordered
// Paste along: texel.wgsl, fetch_clamped.wgsl, inside_map.wgsl

// umbrage_fetch_bordered: texel of a map, or border outside of it
fn umbrage_fetch_bordered(map: texture_2d<f32>, size: vec2f, texel: vec2f, border: vec4f) -> vec4f {
    let value: vec4f = umbrage_fetch_clamped(map, size, texel);
    return select(border, value, umbrage_inside_map(size, texel));
}
