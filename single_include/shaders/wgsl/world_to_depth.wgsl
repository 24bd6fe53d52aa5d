// umbrage 0.1.0, world_to_depth: world units along a light as depth. Exactness: tier C.
// Tier C: WGSL lets compilers fuse or reorder sums. Results then stay within the stated bound.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: clamp_bias.wgsl; or paste wgsl_joined/world_to_depth.wgsl alone.

// umbrage_world_to_depth: world units along a light as depth, 0.0 to 1.0
//   units  (edge of a texel, depth a world unit) at w = 1.0;   w  of the point's shadow coordinate, above 0.0
fn umbrage_world_to_depth(world: f32, units: vec2f, w: f32) -> f32 {
    let along: f32 = world * units.y;
    let square: f32 = w * w;
    return umbrage_clamp_bias(along / square);
}
