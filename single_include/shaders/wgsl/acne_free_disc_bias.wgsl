// umbrage 0.1.0, acne_free_disc_bias: bias without acne, for filters that read a disc. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// acne_free_disc_bias, tier C: within 13 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_clamp_bias: bias in depth clamped to [0, 1]; 0.0 below 2^-64, and 1.0 (no shadows) for NaN
fn umbrage_clamp_bias(bias: f32) -> f32 {
    let least: f32 = (1.0 / 18446744073709551616.0);
    return select(1.0, select(0.0, bias, bias >= least), bias < 1.0);
}

// umbrage_acne_free_disc_bias: bias in depth without shadow acne for a disc, 0.0 to 1.0
//   slope   change of depth per texel, in x and y
//   radius  distance to the disc's farthest point, in texels
//   error   largest error of a decoded depth towards the light
fn umbrage_acne_free_disc_bias(slope: vec2f, radius: f32, error: f32) -> f32 {
    let square: f32 = slope.x * slope.x + slope.y * slope.y;
    let beside: f32 = (abs(slope.x) + abs(slope.y)) * 0.5078125 + (error + (1.0 / 8388608.0));
    let bias: f32 = radius * sqrt(square) + beside;
    return umbrage_clamp_bias(bias);
}
