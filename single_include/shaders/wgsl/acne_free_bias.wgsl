// umbrage 0.1.0, acne_free_bias: bias without acne, from slope, reach and error. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// acne_free_bias, tier B: within 4 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_clamp_bias: bias in depth clamped to [0, 1]; 0.0 below 2^-64, and 1.0 (no shadows) for NaN
fn umbrage_clamp_bias(bias: f32) -> f32 {
    let least: f32 = (1.0 / 18446744073709551616.0);
    return select(1.0, select(0.0, bias, bias >= least), bias < 1.0);
}

// umbrage_acne_free_bias: bias in depth without shadow acne, 0.0 to 1.0
//   slope  change of depth per texel, in x and y
//   reach  filter radius, in texels
//   error  largest error of a decoded depth towards the light
fn umbrage_acne_free_bias(slope: vec2f, reach: f32, error: f32) -> f32 {
    let bias: f32 = reach * (abs(slope.x) + abs(slope.y)) + (error + (1.0 / 8388608.0));
    return umbrage_clamp_bias(bias);
}
