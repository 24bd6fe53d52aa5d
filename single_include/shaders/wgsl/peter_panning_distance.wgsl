// umbrage 0.1.0, peter_panning_distance: depth within which a bias detaches shadows (peter-panning). Exactness: tier
//   B.
// WGSL lets compilers fuse or reorder sums.
// peter_panning_distance, tier B: within 4 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: clamp_bias.wgsl, acne_free_bias.wgsl; or paste wgsl_joined/peter_panning_distance.wgsl alone.

// umbrage_peter_panning_distance: depth, 0.0 to 1.0, within which casters lose their shadow or part of it
//   bias          bias of the receiver, in depth
//   caster_slope  change of the caster's depth per texel
//   reach         filter radius, in texels
fn umbrage_peter_panning_distance(bias: f32, caster_slope: vec2f, reach: f32) -> f32 {
    return umbrage_acne_free_bias(caster_slope, reach, bias);
}
