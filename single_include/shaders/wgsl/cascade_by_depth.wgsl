// umbrage 0.1.0, cascade_by_depth: cascade that contains a view depth. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cascade_by_depth: cascade that contains a distance along the camera's axis, 0.0 to 3.0
//   ends  ends of the first three cascades, increasing
fn umbrage_cascade_by_depth(depth: f32, ends: vec3f) -> f32 {
    let reached: i32 = i32(depth >= ends.x) + i32(depth >= ends.y) + i32(depth >= ends.z);
    return f32(reached);
}
