// umbrage 0.1.0, tetrahedron_face_point: direction in the axes of a tetrahedron's face. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_tetrahedron_face_point: (along the base, up, away) of a direction in the axes of a face, 0.0 to 3.0
fn umbrage_tetrahedron_face_point(face: f32, d: vec3f) -> vec3f {
    let z: vec3f = select(vec3f(d.x, d.y, -d.z), vec3f(-d.x, d.y, d.z), face < 0.5);
    let x: vec3f = select(vec3f(d.z, -d.y, -d.x), vec3f(-d.z, -d.y, d.x), face < 2.5);
    return select(x, z, face < 1.5);
}
