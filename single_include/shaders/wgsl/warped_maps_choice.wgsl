// umbrage 0.1.0, warped_maps_choice: warped cascade that holds a point of the world, and weight of the next one.
//   Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// warped_maps_choice, tier C: within 12 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cascade_by_depth: cascade that contains a distance along the camera's axis, 0.0 to 3.0
//   ends  ends of the first three cascades, increasing
fn umbrage_cascade_by_depth(depth: f32, ends: vec3f) -> f32 {
    let reached: i32 = i32(depth >= ends.x) + i32(depth >= ends.y) + i32(depth >= ends.z);
    return f32(reached);
}

// umbrage_cascade_column: column of a matrix by its index, 0.0 to 3.0, for languages without dynamic indexing
fn umbrage_cascade_column(columns: mat4x4f, number: f32) -> vec4f {
    let low: vec4f = select(columns[1], columns[0], number < 0.5);
    let high: vec4f = select(columns[3], columns[2], number < 2.5);
    return select(high, low, number < 1.5);
}

// umbrage_cascade_weight: v rounded down to steps of 1/256, from 0.0 to 1.0; NaN gives 0.0
fn umbrage_cascade_weight(v: f32) -> f32 {
    return select(0.0, min(floor(v * 256.0), 256.0) * (1.0 / 256.0), v > 0.0);
}

// umbrage_cascade_fade: weight of the next cascade at a distance along the camera's axis: depth * scale + offset
fn umbrage_cascade_fade(depth: f32, scale: f32, offset: f32) -> f32 {
    let v: f32 = depth * scale + offset;
    return umbrage_cascade_weight(v);
}

// umbrage_warped_maps_choice: number of the warped cascade that holds a point of the world, and weight of the next one
//   fades    one column per map: scale and offset of the next one's weight
//   anchor   the one anchor of all maps
//   ahead    distance along the camera's axis: dot(ahead.xyz, world - anchor) + ahead.w
//   ends     ends of the first three cascades, number of the last one
fn umbrage_warped_maps_choice(fades: mat4x4f, anchor: vec4f, ahead: vec4f, ends: vec4f, world: vec3f) -> vec2f {
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let depth: f32 = ahead.x * way.x + ahead.y * way.y + ahead.z * way.z + ahead.w;
    let number: f32 = umbrage_cascade_by_depth(depth, vec3f(ends.x, ends.y, ends.z));
    let own: vec4f = umbrage_cascade_column(fades, number);
    return vec2f(number, umbrage_cascade_fade(depth, own.x, own.y));
}
