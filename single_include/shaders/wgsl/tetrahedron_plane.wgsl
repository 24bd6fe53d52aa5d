// umbrage 0.1.0, tetrahedron_plane: direction in the axes of its tetrahedron face. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// tetrahedron_plane, tier B: within 1 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: tetrahedron_face.wgsl, tetrahedron_face_point.wgsl; or paste wgsl_joined/tetrahedron_plane.wgsl alone.

// umbrage_tetrahedron_plane: (along the base, up, away) of a direction in the axes of the face that it meets
fn umbrage_tetrahedron_plane(direction: vec3f) -> vec3f {
    return umbrage_tetrahedron_face_point(umbrage_tetrahedron_face(direction), direction);
}
