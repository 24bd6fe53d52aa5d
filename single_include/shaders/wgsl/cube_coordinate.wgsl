// umbrage 0.1.0, cube_coordinate: face of a direction, and the position on it. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// cube_coordinate, tier C: within 5 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: cube_face.wgsl, cube_view_z.wgsl, cube_plane.wgsl; or paste wgsl_joined/cube_coordinate.wgsl alone.

// umbrage_cube_coordinate: (s, t, face) of a direction; s and t go from 0.0 to 1.0 over the face
fn umbrage_cube_coordinate(direction: vec3f) -> vec3f {
    let p: vec3f = umbrage_cube_plane(direction);
    let m: f32 = umbrage_cube_view_z(direction);
    return vec3f((p.x + m) / (m + m), (p.y + m) / (m + m), p.z);
}
