// umbrage 0.1.0, cube_coordinate: face of a direction, and the position on it. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// cube_coordinate, tier C: within 5 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
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

// umbrage_cube_view_z: magnitude of the largest component, the input of per-face depths
fn umbrage_cube_view_z(direction: vec3f) -> f32 {
    let face: f32 = umbrage_cube_face(direction);
    let side: f32 = select(direction.y, direction.x, face < 1.5);
    return abs(select(side, direction.z, face > 3.5));
}

// umbrage_cube_plane: (sc, tc, face) of a direction: its components across the axis of its face
fn umbrage_cube_plane(direction: vec3f) -> vec3f {
    let face: f32 = umbrage_cube_face(direction);
    let x: vec3f = vec3f(select(direction.z, -direction.z, face < 0.5), -direction.y, face);
    let y: vec3f = vec3f(direction.x, select(-direction.z, direction.z, face < 2.5), face);
    let z: vec3f = vec3f(select(-direction.x, direction.x, face < 4.5), -direction.y, face);
    return select(select(z, y, face < 3.5), x, face < 1.5);
}

// umbrage_cube_coordinate: (s, t, face) of a direction; s and t go from 0.0 to 1.0 over the face
fn umbrage_cube_coordinate(direction: vec3f) -> vec3f {
    let p: vec3f = umbrage_cube_plane(direction);
    let m: f32 = umbrage_cube_view_z(direction);
    return vec3f((p.x + m) / (m + m), (p.y + m) / (m + m), p.z);
}
