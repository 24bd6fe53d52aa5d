// umbrage 0.1.0, cascade_edge: texels beyond the part of a cascade where a filter stays inside. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// cascade_edge, tier B: within 11 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cascade_edge: texels beyond the part of a cascade's map where a filter stays inside, at most 0.0 inside
//   coordinate   position in the cascade's map: texels, texels, depth
//   size, reach  size of the map and filter radius, in texels
// Returns 65536.0 for a depth outside [0, 1], far from the map, and for NaN
fn umbrage_cascade_edge(coordinate: vec3f, size: vec2f, reach: f32) -> f32 {
    let half_size: vec2f = size * 0.5;
    let beyond: vec2f = abs(vec2f(coordinate.x, coordinate.y) - half_size) - (half_size - reach);
    let near_map: bool = beyond.x + beyond.y < 65536.0;  // false for NaN
    return select(65536.0, max(beyond.x, beyond.y), coordinate.z >= 0.0 && coordinate.z <= 1.0 && near_map);
}
