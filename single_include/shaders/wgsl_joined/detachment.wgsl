// umbrage 0.1.0, detachment: depth before a receiver within which its bias loses a caster's shadow. Exactness: tier
//   B.
// Tier B: WGSL lets compilers fuse or reorder sums. Results then stay within the stated bound.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_clamp_bias: a bias in depth clamped to [0, 1], 0.0 below 2^-64; NaN becomes 1.0, and nothing is in shadow
fn umbrage_clamp_bias(bias: f32) -> f32 {
    let least: f32 = (1.0 / 18446744073709551616.0);
    return select(select(1.0, 0.0, bias < least), bias, bias >= least && bias < 1.0);
}

// umbrage_acne_free_bias: the smallest bias in depth with which no plane shadows itself, 0.0 to 1.0
//   slope  change of depth from one texel to the next;   reach  of the filter, texels
//   error  how far a decoded depth may lie before the true one
fn umbrage_acne_free_bias(slope: vec2f, reach: f32, error: f32) -> f32 {
    let bias: f32 = reach * (abs(slope.x) + abs(slope.y)) + (error + (1.0 / 8388608.0));
    return umbrage_clamp_bias(bias);
}

// umbrage_detachment: depth before a receiver within which a caster's shadow is lost, wholly or in part, 0.0 to 1.0
//   bias   of the receiver, in depth;   caster_slope  change of the caster's depth from one texel to the next
//   reach  of the filter, texels
fn umbrage_detachment(bias: f32, caster_slope: vec2f, reach: f32) -> f32 {
    return umbrage_acne_free_bias(caster_slope, reach, bias);
}
