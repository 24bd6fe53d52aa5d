// umbrage 0.1.0, exponential_warp: depth on the scale of exponential shadow maps. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// exponential_warp, tier B: within 31 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: power_of_two.wgsl, exp2_polynomial.wgsl; or paste wgsl_joined/exponential_warp.wgsl alone.

// umbrage_exponential_warp: 2^(exponent * (2.0 * depth - 1.0)) of a depth that grows with distance
fn umbrage_exponential_warp(depth: f32, exponent: f32) -> f32 {
    let y: f32 = exponent * (depth * 2.0 - 1.0);
    return umbrage_exp2_polynomial(y);
}
