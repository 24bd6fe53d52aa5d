// umbrage 0.1.0, MIT License: box
// Paste along: inside_texel_space.wgsl, beyond_far.wgsl, is_compared.wgsl, compare.wgsl, texel.wgsl, fetch_clamped.wgsl, decode.wgsl, fetch_depth.wgsl, lit.wgsl, box_count.wgsl, box_scale.wgsl

// umbrage_box: lit share of a (2r+1) x (2r+1) box; visibility, 1.0 is lit; arguments as for umbrage_box_count
fn umbrage_box(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: i32) -> f32 {
    let visibility: f32 = umbrage_box_count(map, size, coord, receiver, radius) * umbrage_box_scale(radius);
    return select(1.0, visibility, visibility < 0.999);  // 121 times the rounded 1/121 is not 1
}
