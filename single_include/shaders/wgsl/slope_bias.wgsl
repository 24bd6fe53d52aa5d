// umbrage 0.1.0, slope_bias: slope-scaled bias, as rasterizers compute it. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// slope_bias, tier B: within 2 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_clamp_bias: bias in depth clamped to [0, 1]; 0.0 below 2^-64, and 1.0 (no shadows) for NaN
fn umbrage_clamp_bias(bias: f32) -> f32 {
    let least: f32 = (1.0 / 18446744073709551616.0);
    return select(1.0, select(0.0, bias, bias >= least), bias < 1.0);
}

// umbrage_slope_bias: factor times the larger slope, plus a base, 0.0 to 1.0
//   slope   change of depth per texel
//   factor  factor of the slope, in texels
//   base    constant bias, in depth
fn umbrage_slope_bias(slope: vec2f, factor: f32, base: f32) -> f32 {
    let bias: vec2f = abs(slope) * factor + base;
    let x: f32 = umbrage_clamp_bias(bias.x);  // clamp first: GPUs differ in the maximum of a NaN
    let y: f32 = umbrage_clamp_bias(bias.y);
    return select(y, x, x > y);
}
