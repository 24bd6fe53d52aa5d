// umbrage 0.1.0, MIT License: fetch_bilinear
// Paste along: texel.wgsl, fetch_clamped.wgsl

// umbrage_fetch_bilinear: mean of the four texels around a point, weights in steps of 1/256
//   coord  in texels, first centre at (0.5, 0.5)
fn umbrage_fetch_bilinear(map: texture_2d<f32>, size: vec2f, coord: vec2f) -> vec4f {
    let x: vec2f = floor(coord * 256.0) - 128.0;
    let texel: vec2f = floor(x * (1.0 / 256.0));
    let hi: vec2f = x - texel * 256.0;
    let lo: vec2f = 256.0 - hi;
    let a: vec4f = umbrage_fetch_clamped(map, size, texel);
    let b: vec4f = umbrage_fetch_clamped(map, size, texel + vec2f(1.0, 0.0));
    let c: vec4f = umbrage_fetch_clamped(map, size, texel + vec2f(0.0, 1.0));
    let d: vec4f = umbrage_fetch_clamped(map, size, texel + vec2f(1.0, 1.0));
    let low: vec4f = a * lo.x + b * hi.x;
    let high: vec4f = c * lo.x + d * hi.x;
    let sum: vec4f = low * lo.y + high * hi.y;
    return sum * (1.0 / 65536.0);
}
