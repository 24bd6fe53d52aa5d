// umbrage 0.1.0, MIT License: tent2
// Paste along: inside_texel_space.wgsl, beyond_far.wgsl, is_compared.wgsl, compare.wgsl, texel.wgsl, fetch_clamped.wgsl, decode.wgsl, fetch_depth.wgsl, lit.wgsl, lit_2x2.wgsl

// umbrage_tent2: lit share of 3 x 3 texels, the window 1 1; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased
fn umbrage_tent2(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let compared: bool = umbrage_is_compared(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);  // no branch: fetches overlap
    let texel: vec2f = floor(x * (1.0 / 256.0));
    let s: vec2f = x - texel * 256.0;
    let r: vec2f = 256.0 - s;
    let w0: vec2f = r * 8.0;
    let w2: vec2f = s * 8.0;
    let w1: vec2f = 4096.0 - w0 - w2;
    let a: vec4f = umbrage_lit_2x2(map, size, texel - 1.0, receiver);
    let b: vec4f = umbrage_lit_2x2(map, size, texel + vec2f(1.0, -1.0), receiver);
    let c: vec4f = umbrage_lit_2x2(map, size, texel + vec2f(-1.0, 1.0), receiver);
    let d: vec4f = umbrage_lit_2x2(map, size, texel + vec2f(1.0, 1.0), receiver);
    var n: f32 = w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z);
    n += w2.y * (w0.x * c.x + w1.x * c.y + w2.x * d.x);
    return select(1.0, n * (1.0 / 16777216.0), compared);
}
