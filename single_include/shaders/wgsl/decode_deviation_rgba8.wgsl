// umbrage 0.1.0, decode_deviation_rgba8: mean and deviation in RGBA8 to two moments (VSM). Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// decode_deviation_rgba8, tier B: within 21 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_decode_deviation: mean and twice the standard deviation to mean and mean square of depths
fn umbrage_decode_deviation(held: vec2f) -> vec2f {
    let half_of_it: f32 = held.y * 0.5;
    let square: f32 = held.x * held.x + half_of_it * half_of_it;
    return vec2f(held.x, square);
}

// umbrage_from_unorm: channel 0..255 of a value from an 8-bit texture, even if the division by 255 is inexact
fn umbrage_from_unorm(c: f32) -> f32 {
    return floor(c * 255.0 + 0.5);
}
fn umbrage_from_unorm_vec2f(c: vec2f) -> vec2f {
    return floor(c * 255.0 + 0.5);
}
fn umbrage_from_unorm_vec3f(c: vec3f) -> vec3f {
    return floor(c * 255.0 + 0.5);
}
fn umbrage_from_unorm_vec4f(c: vec4f) -> vec4f {
    return floor(c * 255.0 + 0.5);
}

// umbrage_decode_rg16: depth from the two channels of a 16-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
fn umbrage_decode_rg16(c: vec2f, edge: f32) -> f32 {
    let k: vec2f = umbrage_from_unorm_vec2f(c);
    return (k.x + k.y * 256.0 + edge) * (1.0 / 65536.0);
}

// umbrage_decode_deviation_rgba8: RGBA8 mean and deviation to mean and mean square of depths
//   c   as sampled, mean in xy and deviation in zw
fn umbrage_decode_deviation_rgba8(c: vec4f) -> vec2f {
    let mean: f32 = umbrage_decode_rg16(vec2f(c.x, c.y), 1.0);
    let deviation: f32 = umbrage_decode_rg16(vec2f(c.z, c.w), 1.0);
    return umbrage_decode_deviation(vec2f(mean, deviation));
}
