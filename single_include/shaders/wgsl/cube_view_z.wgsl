// umbrage 0.1.0, cube_view_z: distance along the axis of a direction's face. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: cube_face.wgsl; or paste wgsl_joined/cube_view_z.wgsl alone.

// umbrage_cube_view_z: magnitude of the largest component, the input of per-face depths
fn umbrage_cube_view_z(direction: vec3f) -> f32 {
    let face: f32 = umbrage_cube_face(direction);
    let side: f32 = select(direction.y, direction.x, face < 1.5);
    return abs(select(side, direction.z, face > 3.5));
}
