// umbrage 0.1.0, cascaded_maps_place: place of a point of the world in one of up to four cascades. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// cascaded_maps_place, tier C: within 38 x 2^-23 x S of the exact result.
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

// umbrage_cascade_slope: change of depth per texel; (0.0, 0.0) for a normal of zero
//   normal  surface normal, rotated into the light's axes
//   scale   scale of the cascade
fn umbrage_cascade_slope(normal: vec3f, scale: vec4f) -> vec2f {
    let up: vec2f = vec2f(normal.x, normal.y) * -scale.z;
    let z: f32 = select(normal.z, 1.0e-18, normal.z == 0.0);  // up is zero without a normal, and not where edge-on
    let across: vec2f = vec2f(scale.x, scale.y) * z;
    return vec2f(up.x / across.x, up.y / across.y);
}

// umbrage_cascade_place: place of a point in one cascade
//   light, across   the point and its normal, rotated into the light's axes
//   scale, offset   those of the cascade. w: slack of a plane in texels of slope, and in depth
//   number, last    number of the cascade and of the last one; above it the place is outside all maps, where all is lit
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
fn umbrage_cascade_place(light: vec3f, across: vec3f, scale: vec4f, offset: vec4f, number: f32, last: f32) -> mat4x4f {
    let none: vec4f = vec4f(0.0, 0.0, 0.0, 0.0);
    let at: vec3f = light * vec3f(scale.x, scale.y, scale.z) + vec3f(offset.x, offset.y, offset.z);
    let x: f32 = select(-65536.0, at.x, number <= last);
    let slope: vec2f = umbrage_cascade_slope(across, scale);
    let slack: f32 = (abs(slope.x) + abs(slope.y)) * scale.w + offset.w;
    return mat4x4f(vec4f(x, at.y, at.z, min(number, last)), vec4f(slope, 1.0, slack), none, none);
}

// umbrage_cascaded_maps_place: umbrage_cascade_place of a point of the world, in one of up to four cascades
//   number   number of the cascade
//   the others as for umbrage_cascaded_maps_choice
fn umbrage_cascaded_maps_place(rotation: mat4x4f, scales: mat4x4f, offsets: mat4x4f, anchor: vec4f, blending: vec4f,
                               terms: vec4f, world: vec3f, normal: vec3f, number: f32) -> mat4x4f {
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let light: vec4f = rotation[3] + rotation[0] * way.x + rotation[1] * way.y + rotation[2] * way.z;
    let across: vec4f = rotation[3] + rotation[0] * normal.x + rotation[1] * normal.y + rotation[2] * normal.z;
    let own: f32 = min(number, blending.y);
    return umbrage_cascade_place(vec3f(light.x, light.y, light.z), vec3f(across.x, across.y, across.z),
                                 umbrage_cascade_column(scales, own), umbrage_cascade_column(offsets, own), number,
                                 blending.y);
}
