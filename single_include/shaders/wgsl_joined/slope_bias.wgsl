// umbrage 0.1.0, slope_bias: bias by the greater slope, as rasterizers have it. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// slope_bias, tier B: within 2 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_clamp_bias: a bias in depth clamped to [0, 1], 0.0 below 2^-64; NaN becomes 1.0, and nothing is in shadow
fn umbrage_clamp_bias(bias: f32) -> f32 {
    let least: f32 = (1.0 / 18446744073709551616.0);
    return select(select(1.0, 0.0, bias < least), bias, bias >= least && bias < 1.0);
}

// umbrage_slope_bias: factor times the greater slope, and a base, 0.0 to 1.0
//   slope  change of depth from one texel to the next;   factor  in texels;   base  in depth
fn umbrage_slope_bias(slope: vec2f, factor: f32, base: f32) -> f32 {
    let bias: vec2f = abs(slope) * factor + base;
    let x: f32 = umbrage_clamp_bias(bias.x);  // of both: a maximum of a NaN is what a GPU makes it
    let y: f32 = umbrage_clamp_bias(bias.y);
    return select(y, x, x > y);
}
