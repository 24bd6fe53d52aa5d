// umbrage 0.1.0, MIT License: pcf_2x2
// Paste along: inside_texel_space.wgsl, beyond_far.wgsl, is_compared.wgsl, compare.wgsl, texel.wgsl, fetch_clamped.wgsl, decode.wgsl, fetch_depth.wgsl, lit.wgsl, lit_2x2.wgsl

// umbrage_pcf_2x2: bilinear percentage-closer filtering; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased
fn umbrage_pcf_2x2(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let compared: bool = umbrage_is_compared(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0) - 128.0, compared);  // no branch: fetches overlap
    let texel: vec2f = floor(x * (1.0 / 256.0));
    let hi: vec2f = x - texel * 256.0;
    let lo: vec2f = 256.0 - hi;
    let lit: vec4f = umbrage_lit_2x2(map, size, texel, receiver);
    let sum: f32 = lo.y * (lo.x * lit.x + hi.x * lit.y) + hi.y * (lo.x * lit.z + hi.x * lit.w);
    let visibility: f32 = sum * (1.0 / 65536.0);
    return select(1.0, visibility, compared);
}
