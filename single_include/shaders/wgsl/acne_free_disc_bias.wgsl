// umbrage 0.1.0, acne_free_disc_bias: smallest bias without acne, for filters that read a disc. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// acne_free_disc_bias, tier C: within 13 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: clamp_bias.wgsl; or paste wgsl_joined/acne_free_disc_bias.wgsl alone.

// umbrage_acne_free_disc_bias: the smallest bias in depth with which no plane shadows itself, 0.0 to 1.0
//   slope   change of depth from one texel to the next;   radius  to the disc's farthest point, texels
//   error   how far a decoded depth may lie before the true one
fn umbrage_acne_free_disc_bias(slope: vec2f, radius: f32, error: f32) -> f32 {
    let square: f32 = slope.x * slope.x + slope.y * slope.y;
    let beside: f32 = (abs(slope.x) + abs(slope.y)) * 0.5078125 + (error + (1.0 / 8388608.0));
    let bias: f32 = radius * sqrt(square) + beside;
    return umbrage_clamp_bias(bias);
}
