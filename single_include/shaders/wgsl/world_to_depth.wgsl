// umbrage 0.1.0, world_to_depth: world units along a light to depth. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// world_to_depth, tier C: within 5 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_clamp_bias: bias in depth clamped to [0, 1]; 0.0 below 2^-64, and 1.0 (no shadows) for NaN
fn umbrage_clamp_bias(bias: f32) -> f32 {
    let least: f32 = (1.0 / 18446744073709551616.0);
    return select(1.0, select(0.0, bias, bias >= least), bias < 1.0);
}

// umbrage_world_to_depth: world units along a light as depth, 0.0 to 1.0
//   units  (edge of a texel, depth per world unit) at w = 1.0
//   w      w of the point's shadow coordinate, above 0.0
fn umbrage_world_to_depth(world: f32, units: vec2f, w: f32) -> f32 {
    let along: f32 = world * units.y;
    let square: f32 = w * w;
    return umbrage_clamp_bias(along / square);
}
