// umbrage 0.1.0, shaped_softness: softness of a place, by its shape. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// shaped_softness, tier C: within 9 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_shaped_softness: softness of a place
//   softness   that of its map: (1/16 texel per distance code along x and y, min_radius, max_radius)
//   shape      factors in x and y, shear
fn umbrage_shaped_softness(softness: vec4f, shape: vec3f) -> vec4f {
    let max_radius: f32 = softness.w / sqrt(1.0 + shape.z * shape.z);
    return vec4f(softness.x * shape.x, softness.y * shape.y, softness.z, max_radius);
}
