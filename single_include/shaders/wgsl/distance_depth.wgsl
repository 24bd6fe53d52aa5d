// umbrage 0.1.0, distance_depth: distance to the light over its range. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// distance_depth, tier C: within 9 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_distance_depth: length of to_point, the vector from the light, times 1 / range
fn umbrage_distance_depth(to_point: vec3f, inv_range: f32) -> f32 {
    return sqrt(to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z) * inv_range;
}
