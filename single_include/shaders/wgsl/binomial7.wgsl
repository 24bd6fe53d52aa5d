// umbrage 0.1.0, MIT License: binomial7
// Paste along: inside_texel_space.wgsl, beyond_far.wgsl, is_compared.wgsl, compare.wgsl, texel.wgsl, fetch_clamped.wgsl, decode.wgsl, fetch_depth.wgsl, lit.wgsl, lit_2x2.wgsl, window_sum7.wgsl

// umbrage_binomial7: lit share under 7 x 7 weights, 1 6 15 20 15 6 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased
fn umbrage_binomial7(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let n: f32 = umbrage_window_sum7(map, size, coord, receiver, 256.0, 0.25, 1.5, 3.75, 5.0);
    return n * (1.0 / 16777216.0);
}
