// umbrage 0.1.0, decode_deviation_rgba8: mean and deviation in RGBA8 to two moments (VSM). Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// decode_deviation_rgba8, tier B: within 21 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: decode_deviation.wgsl, from_unorm.wgsl, decode_rg16.wgsl; or paste
//   wgsl_joined/decode_deviation_rgba8.wgsl alone.

// umbrage_decode_deviation_rgba8: RGBA8 mean and deviation to mean and mean square of depths
//   c   as sampled, mean in xy and deviation in zw
fn umbrage_decode_deviation_rgba8(c: vec4f) -> vec2f {
    let mean: f32 = umbrage_decode_rg16(vec2f(c.x, c.y), 1.0);
    let deviation: f32 = umbrage_decode_rg16(vec2f(c.z, c.w), 1.0);
    return umbrage_decode_deviation(vec2f(mean, deviation));
}
