// umbrage 0.1.0, cube_face_point: point in a face's axes. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cube_face_point: (sc, tc, distance along the axis) in a face, 0.0 to 5.0, of a point from the cube's center
fn umbrage_cube_face_point(face: f32, p: vec3f) -> vec3f {
    let x: vec3f = select(vec3f(p.z, -p.y, -p.x), vec3f(-p.z, -p.y, p.x), face < 0.5);
    let y: vec3f = select(vec3f(p.x, -p.z, -p.y), vec3f(p.x, p.z, p.y), face < 2.5);
    let z: vec3f = select(vec3f(-p.x, -p.y, -p.z), vec3f(p.x, -p.y, p.z), face < 4.5);
    return select(select(z, y, face < 3.5), x, face < 1.5);
}
