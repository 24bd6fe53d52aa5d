// umbrage 0.1.0, MIT License: castano_dyadic5
// Paste along: inside_texel_space.wgsl, beyond_far.wgsl, is_compared.wgsl, compare.wgsl, texel.wgsl, fetch_clamped.wgsl, decode.wgsl, fetch_depth.wgsl, lit.wgsl, lit_2x2.wgsl, window_sum5.wgsl

// umbrage_castano_dyadic5: lit share under 5 x 5 weights, 5 16 22 16 5, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased
fn umbrage_castano_dyadic5(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let n: f32 = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.25, 4.0, 5.5);
    return n * (1.0 / 16777216.0);
}
