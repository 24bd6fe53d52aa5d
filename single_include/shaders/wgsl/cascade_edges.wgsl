// umbrage 0.1.0, cascade_edges: cascade_edge of four cascades. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// cascade_edges, tier C: within 13 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cascade_edge: texels beyond the part of a cascade's map where a filter stays inside, at most 0.0 inside
//   light          the point, rotated into the light's axes
//   scale, offset  those of the cascade
//   size, reach    size of the map and filter radius, in texels
// Returns 65536.0 for a depth outside [0, 1], and for NaN there
fn umbrage_cascade_edge(light: vec3f, scale: vec4f, offset: vec4f, size: vec2f, reach: f32) -> f32 {
    let at: vec3f = light * vec3f(scale.x, scale.y, scale.z) + vec3f(offset.x, offset.y, offset.z);
    let half_size: vec2f = size * 0.5;
    let beyond: vec2f = abs(vec2f(at.x, at.y) - half_size) - (half_size - reach);
    return select(65536.0, max(beyond.x, beyond.y), abs(at.z - 0.5) <= 0.5);
}

// umbrage_cascade_edges: umbrage_cascade_edge of four cascades
//   scales, offsets   one column per cascade
fn umbrage_cascade_edges(light: vec3f, scales: mat4x4f, offsets: mat4x4f, size: vec2f, reach: f32) -> vec4f {
    return vec4f(umbrage_cascade_edge(light, scales[0], offsets[0], size, reach),
                 umbrage_cascade_edge(light, scales[1], offsets[1], size, reach),
                 umbrage_cascade_edge(light, scales[2], offsets[2], size, reach),
                 umbrage_cascade_edge(light, scales[3], offsets[3], size, reach));
}
