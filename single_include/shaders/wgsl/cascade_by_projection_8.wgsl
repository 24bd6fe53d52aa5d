// umbrage 0.1.0, cascade_by_projection_8: first of eight cascades that contains a point and its filter. Exactness:
//   tier B.
// WGSL lets compilers fuse or reorder sums.
// cascade_by_projection_8, tier B: within 5 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cascade_coordinate: position in a cascade's map, texels and depth, of a point rotated into the light's axes
fn umbrage_cascade_coordinate(light: vec3f, scale: vec4f, offset: vec4f) -> vec3f {
    let start: vec3f = vec3f(offset.x, offset.y, offset.z);
    let at: vec3f = light * vec3f(scale.x, scale.y, scale.z) + start;
    return at;
}

// umbrage_inside_cascade: true if a filter of radius reach at a coordinate stays inside a map of size texels
fn umbrage_inside_cascade(coordinate: vec3f, size: vec2f, reach: f32) -> bool {
    let end: vec2f = size - reach;
    // y is doubled because Mesa turns two comparisons with one limit into min(x, y) >= reach, which loses a NaN
    let in_x: bool = coordinate.x >= reach && coordinate.x <= end.x;
    let in_y: bool = coordinate.y * 2.0 >= reach * 2.0 && coordinate.y * 2.0 <= end.y * 2.0;
    return in_x && in_y && coordinate.z >= 0.0 && coordinate.z <= 1.0;
}

// umbrage_cascade_by_projection: (texels, texels, depth, index) in the first of four cascades that contains a point
//   and its filter; if there is none, index 4.0 and a coordinate that every filter takes as lit
//   light            the point, rotated into the light's axes
//   scales, offsets  scales and offsets of the cascades
//   size             size of each map, in texels
//   reach            filter radius, in texels
fn umbrage_cascade_by_projection(light: vec3f, scales: mat4x4f, offsets: mat4x4f, size: vec2f, reach: f32) -> vec4f {
    let a: vec3f = umbrage_cascade_coordinate(light, scales[0], offsets[0]);
    let b: vec3f = umbrage_cascade_coordinate(light, scales[1], offsets[1]);
    let c: vec3f = umbrage_cascade_coordinate(light, scales[2], offsets[2]);
    let d: vec3f = umbrage_cascade_coordinate(light, scales[3], offsets[3]);
    var found: vec4f = vec4f(65536.0, 65536.0, 0.0, 4.0);
    found = select(found, vec4f(d, 3.0), umbrage_inside_cascade(d, size, reach));
    found = select(found, vec4f(c, 2.0), umbrage_inside_cascade(c, size, reach));
    found = select(found, vec4f(b, 1.0), umbrage_inside_cascade(b, size, reach));
    return select(found, vec4f(a, 0.0), umbrage_inside_cascade(a, size, reach));
}

// umbrage_cascade_by_projection_8: umbrage_cascade_by_projection for eight cascades, four and four; index 8.0 for none
fn umbrage_cascade_by_projection_8(light: vec3f, scales: mat4x4f, offsets: mat4x4f, farther_scales: mat4x4f,
                                   farther_offsets: mat4x4f, size: vec2f, reach: f32) -> vec4f {
    let nearer: vec4f = umbrage_cascade_by_projection(light, scales, offsets, size, reach);
    let farther: vec4f = umbrage_cascade_by_projection(light, farther_scales, farther_offsets, size, reach);
    return select(vec4f(farther.x, farther.y, farther.z, farther.w + 4.0), nearer, nearer.w < 3.5);
}
