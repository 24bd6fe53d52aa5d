// umbrage 0.1.0, tetrahedron_plane: direction in the axes of its tetrahedron face. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// tetrahedron_plane, tier B: within 1 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_tetrahedron_face: face that a direction meets, 0.0 to 3.0: down and +z, down and -z, up and +x, up and -x
fn umbrage_tetrahedron_face(direction: vec3f) -> f32 {
    let beside: f32 = abs(direction.z) - abs(direction.x);
    let up: f32 = direction.y * 1.414213562;
    let z: f32 = select(0.0, 1.0, direction.z < 0.0);
    let x: f32 = select(2.0, 3.0, direction.x < 0.0);
    return select(x, z, beside >= up);
}

// umbrage_tetrahedron_face_point: (along the base, up, away) of a direction in the axes of a face, 0.0 to 3.0
fn umbrage_tetrahedron_face_point(face: f32, d: vec3f) -> vec3f {
    let z: vec3f = select(vec3f(d.x, d.y, -d.z), vec3f(-d.x, d.y, d.z), face < 0.5);
    let x: vec3f = select(vec3f(d.z, -d.y, -d.x), vec3f(-d.z, -d.y, d.x), face < 2.5);
    return select(x, z, face < 1.5);
}

// umbrage_tetrahedron_plane: (along the base, up, away) of a direction in the axes of the face that it meets
fn umbrage_tetrahedron_plane(direction: vec3f) -> vec3f {
    return umbrage_tetrahedron_face_point(umbrage_tetrahedron_face(direction), direction);
}
