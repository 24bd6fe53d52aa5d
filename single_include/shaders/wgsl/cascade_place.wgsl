// umbrage 0.1.0, cascade_place: place of a point in one cascade. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// cascade_place, tier C: within 14 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

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
