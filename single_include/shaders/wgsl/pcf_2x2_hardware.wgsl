// umbrage 0.1.0, MIT License: pcf_2x2_hardware
// Paste along: inside_texel_space.wgsl, beyond_far.wgsl, is_compared.wgsl, before_far.wgsl, compare.wgsl, texel.wgsl, fetch_clamped.wgsl, decode.wgsl, fetch_depth.wgsl, lit.wgsl, lit_2x2.wgsl, pcf_2x2.wgsl, lit_filtered.wgsl, lit_at.wgsl

// umbrage_pcf_2x2_hardware: 2x2 comparisons, weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased
fn umbrage_pcf_2x2_hardware(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let compared: bool = umbrage_is_compared(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), coord, compared);
    let lit: f32 = umbrage_lit_at(map, size, at / size, receiver);
    let visibility: f32 = select(0.0, lit, umbrage_before_far(receiver));
    return select(1.0, visibility, compared);
}
