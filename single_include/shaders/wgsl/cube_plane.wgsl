// umbrage 0.1.0, cube_plane: direction in the axes of its face. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: cube_face.wgsl; or paste wgsl_joined/cube_plane.wgsl alone.

// umbrage_cube_plane: (sc, tc, face) of a direction: its components across the axis of its face
fn umbrage_cube_plane(direction: vec3f) -> vec3f {
    let face: f32 = umbrage_cube_face(direction);
    let x: vec3f = vec3f(select(direction.z, -direction.z, face < 0.5), -direction.y, face);
    let y: vec3f = vec3f(direction.x, select(-direction.z, direction.z, face < 2.5), face);
    let z: vec3f = vec3f(select(-direction.x, direction.x, face < 4.5), -direction.y, face);
    return select(select(z, y, face < 3.5), x, face < 1.5);
}
