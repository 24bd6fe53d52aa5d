// umbrage 0.1.0, detachment: depth before a receiver within which its bias loses a caster's shadow. Exactness: tier
//   B.
// Tier B: WGSL lets compilers fuse or reorder sums. Results then stay within the stated bound.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: clamp_bias.wgsl, acne_free_bias.wgsl; or paste wgsl_joined/detachment.wgsl alone.

// umbrage_detachment: depth before a receiver within which a caster's shadow is lost, wholly or in part, 0.0 to 1.0
//   bias   of the receiver, in depth;   caster_slope  change of the caster's depth from one texel to the next
//   reach  of the filter, texels
fn umbrage_detachment(bias: f32, caster_slope: vec2f, reach: f32) -> f32 {
    return umbrage_acne_free_bias(caster_slope, reach, bias);
}
