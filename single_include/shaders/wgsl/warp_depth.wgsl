// umbrage 0.1.0, warp_depth: depth on the scale of exponential shadow maps. Exactness: tier B.
// Tier B: WGSL lets compilers fuse or reorder sums. Results then stay within the stated bound.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: power_of_two.wgsl, exp2_polynomial.wgsl; or paste wgsl_joined/warp_depth.wgsl alone.

// umbrage_warp_depth: 2^(exponent * (2.0 * depth - 1.0)) of a depth that grows with distance
fn umbrage_warp_depth(depth: f32, exponent: f32) -> f32 {
    let y: f32 = exponent * (depth * 2.0 - 1.0);
    return umbrage_exp2_polynomial(y);
}
