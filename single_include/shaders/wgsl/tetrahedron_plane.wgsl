// umbrage 0.1.0, tetrahedron_plane: a direction in its tetrahedron face's axes. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// tetrahedron_plane, tier B: within 1 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: tetrahedron_face.wgsl; or paste wgsl_joined/tetrahedron_plane.wgsl alone.

// umbrage_tetrahedron_plane: (along the base, up, away) of a direction in the axes of the face that it meets
fn umbrage_tetrahedron_plane(direction: vec3f) -> vec3f {
    let face: f32 = umbrage_tetrahedron_face(direction);
    let d: vec3f = direction;
    let z: vec3f = select(vec3f(d.x, d.y, -d.z), vec3f(-d.x, d.y, d.z), face < 0.5);
    let x: vec3f = select(vec3f(d.z, -d.y, -d.x), vec3f(-d.z, -d.y, d.x), face < 2.5);
    return select(x, z, face < 1.5);
}
