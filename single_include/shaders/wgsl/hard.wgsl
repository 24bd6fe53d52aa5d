// umbrage 0.1.0, MIT License: hard
// Paste along: inside_texel_space.wgsl, beyond_far.wgsl, is_compared.wgsl, compare.wgsl, texel.wgsl, fetch_clamped.wgsl, decode.wgsl, fetch_depth.wgsl, lit.wgsl

// umbrage_hard: unfiltered shadow test; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased
fn umbrage_hard(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let compared: bool = umbrage_is_compared(coord, receiver);
    let texel: vec2f = select(vec2f(0.0, 0.0), floor(coord), compared);  // no branch: fetches of several taps overlap
    let lit: f32 = umbrage_lit(map, size, texel, receiver);
    return select(1.0, lit, compared);
}
