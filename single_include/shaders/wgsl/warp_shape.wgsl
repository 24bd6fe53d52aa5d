// umbrage 0.1.0, warp_shape: shape of penumbras at a texel of a warped map. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// warp_shape, tier C: within 29 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cascade_column: column of a matrix by its index, 0.0 to 3.0, for languages without dynamic indexing
fn umbrage_cascade_column(columns: mat4x4f, number: f32) -> vec4f {
    let low: vec4f = select(columns[1], columns[0], number < 0.5);
    let high: vec4f = select(columns[3], columns[2], number < 2.5);
    return select(high, low, number < 1.5);
}

// umbrage_warp_shape: shape of penumbras at a texel of a warped map
//   warps    one column per map: (change of w along both axes, shear, ratio) of its texel (0, 0)
//   number   number of the map
//   at       place in the map, texels
//   returns factors of the map's softness in x and y, and the shear
fn umbrage_warp_shape(warps: mat4x4f, number: f32, at: vec2f) -> vec3f {
    let own: vec4f = umbrage_cascade_column(warps, number);
    let a: vec2f = vec2f(1.0 - at.x * own.x, own.z - at.x * own.y);
    let b: vec2f = vec2f(-at.y * own.w * own.x, 1.0 - at.y * own.w * own.y);
    let area: f32 = abs(a.x * b.y - a.y * b.x);
    let rows: f32 = length(b);
    return vec3f(area / rows, rows, clamp(dot(a, b) / area, -8.0, 8.0));
}
