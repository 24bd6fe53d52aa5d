// umbrage 0.1.0, cascade_by_projection_8: first of eight cascades that contains a point and its filter. Exactness:
//   tier B.
// WGSL lets compilers fuse or reorder sums.
// cascade_by_projection_8, tier B: within 5 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: cascade_coordinate.wgsl, inside_cascade.wgsl, cascade_by_projection.wgsl; or paste
//   wgsl_joined/cascade_by_projection_8.wgsl alone.

// umbrage_cascade_by_projection_8: umbrage_cascade_by_projection for eight cascades, four and four; index 8.0 for none
fn umbrage_cascade_by_projection_8(light: vec3f, scales: mat4x4f, offsets: mat4x4f, farther_scales: mat4x4f,
                                   farther_offsets: mat4x4f, size: vec2f, reach: f32) -> vec4f {
    let nearer: vec4f = umbrage_cascade_by_projection(light, scales, offsets, size, reach);
    let farther: vec4f = umbrage_cascade_by_projection(light, farther_scales, farther_offsets, size, reach);
    return select(vec4f(farther.x, farther.y, farther.z, farther.w + 4.0), nearer, nearer.w < 3.5);
}
