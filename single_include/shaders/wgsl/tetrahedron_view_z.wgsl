// umbrage 0.1.0, tetrahedron_view_z: distance along the normal of a direction's face. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// tetrahedron_view_z, tier B: within 3 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: tetrahedron_face.wgsl, tetrahedron_face_point.wgsl, tetrahedron_plane.wgsl; or paste
//   wgsl_joined/tetrahedron_view_z.wgsl alone.

// umbrage_tetrahedron_view_z: distance along the face's normal, the input of per-face depths
fn umbrage_tetrahedron_view_z(direction: vec3f) -> f32 {
    let p: vec3f = umbrage_tetrahedron_plane(direction);
    let z: f32 = p.z * 0.816496581 + p.y * -0.577350269;
    return z;
}
