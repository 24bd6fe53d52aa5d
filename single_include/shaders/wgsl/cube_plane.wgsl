// umbrage 0.1.0, cube_plane: direction in the axes of its face. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cube_face: face that a direction meets, 0.0 to 5.0: +x, -x, +y, -y, +z, -z
fn umbrage_cube_face(direction: vec3f) -> f32 {
    let m: vec3f = abs(direction);
    let x: f32 = select(0.0, 1.0, direction.x < 0.0);
    let y: f32 = select(2.0, 3.0, direction.y < 0.0);
    let z: f32 = select(4.0, 5.0, direction.z < 0.0);
    // not m.x >= m.y && m.x >= m.z: Mesa turns it into one comparison with max(m.y, m.z), which loses a NaN
    return select(select(z, y, m.y >= m.z), select(z, x, m.x >= m.z), m.x >= m.y);
}

// umbrage_cube_plane: (sc, tc, face) of a direction: its components across the axis of its face
fn umbrage_cube_plane(direction: vec3f) -> vec3f {
    let face: f32 = umbrage_cube_face(direction);
    let x: vec3f = vec3f(select(direction.z, -direction.z, face < 0.5), -direction.y, face);
    let y: vec3f = vec3f(direction.x, select(-direction.z, direction.z, face < 2.5), face);
    let z: vec3f = vec3f(select(-direction.x, direction.x, face < 4.5), -direction.y, face);
    return select(select(z, y, face < 3.5), x, face < 1.5);
}
