// umbrage 0.1.0, MIT License: depth_at
// Paste along: texel.wgsl, fetch_clamped.wgsl, decode.wgsl, fetch_depth.wgsl

// umbrage_depth_at: stored depth of the texel at a point; on a border it may be the texel beside
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
fn umbrage_depth_at(map: texture_2d<f32>, size: vec2f, uv: vec2f) -> f32 {
    return umbrage_fetch_depth(map, size, floor(uv * size));
}
