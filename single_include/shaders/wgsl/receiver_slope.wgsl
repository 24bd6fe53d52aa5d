// umbrage 0.1.0, receiver_slope: change of a receiver's depth per texel. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// receiver_slope, tier C: within 27 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_plane_in_map: normal, in texels, texels and depth, of the plane through a point
//   plane_matrix  transpose of the texture matrix' inverse
//   normal        normal of the plane, any length
//   world         point on the plane
fn umbrage_plane_in_map(plane_matrix: mat4x4f, normal: vec3f, world: vec3f) -> vec3f {
    let d: f32 = -(normal.x * world.x + normal.y * world.y + normal.z * world.z);
    let q: vec4f = plane_matrix[3] * d + plane_matrix[0] * normal.x + plane_matrix[1] * normal.y + plane_matrix[2] *
        normal.z;
    return vec3f(q.x, q.y, q.z);
}

// umbrage_receiver_slope: umbrage_plane_slope without its clamps; (0.0, 0.0) for a normal of zero (the caller has none)
fn umbrage_receiver_slope(plane_matrix: mat4x4f, normal: vec3f, world: vec3f) -> vec2f {
    let q: vec3f = umbrage_plane_in_map(plane_matrix, normal, world);
    let depth: f32 = select(q.z, 1.0e-30, q.z == 0.0);  // q is zero without a normal, and not where edge-on
    return vec2f(-q.x / depth, -q.y / depth);
}
