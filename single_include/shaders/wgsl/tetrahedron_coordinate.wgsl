// umbrage 0.1.0, tetrahedron_coordinate: tetrahedron face of a direction, and the position on it. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// tetrahedron_coordinate, tier C: within 6 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: tetrahedron_face.wgsl, tetrahedron_face_point.wgsl, tetrahedron_plane.wgsl; or paste
//   wgsl_joined/tetrahedron_coordinate.wgsl alone.

// umbrage_tetrahedron_coordinate: (s, t, face) of a direction
//   s  -1.0 to 1.0 along the base
//   t  0.0 at the base to 1.0 at the apex
fn umbrage_tetrahedron_coordinate(direction: vec3f) -> vec3f {
    let p: vec3f = umbrage_tetrahedron_plane(direction);
    let d: f32 = p.z * 2.0 + p.y * -1.414213562;
    return vec3f(p.x / d, p.z / d, umbrage_tetrahedron_face(direction));
}
