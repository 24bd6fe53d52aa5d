// umbrage 0.1.0, receiver_slope: change of a receiver's depth per texel. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// receiver_slope, tier C: within 27 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: clamp_slope.wgsl, plane_slope.wgsl; or paste wgsl_joined/receiver_slope.wgsl alone.

// umbrage_receiver_slope: umbrage_plane_slope, but (0.0, 0.0) for a normal of zero (the caller has none)
fn umbrage_receiver_slope(plane_matrix: mat4x4f, normal: vec3f, world: vec3f) -> vec2f {
    let slope: vec2f = umbrage_plane_slope(plane_matrix, normal, world);
    let none: bool = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    return select(slope, vec2f(0.0, 0.0), none);
}
