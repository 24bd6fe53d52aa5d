// umbrage 0.1.0, MIT License: fetch_depth
// Paste along: texel.wgsl, fetch_clamped.wgsl, decode.wgsl

// umbrage_fetch_depth: stored depth of a texel, outside the map of the nearest one inside
fn umbrage_fetch_depth(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> f32 {
    return umbrage_decode(umbrage_fetch_clamped(map, size, texel));
}
