// umbrage 0.1.0, parallel_map_places: place of a point of the world in the one map of a light with parallel rays.
//   Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// parallel_map_places, tier C: within 121 x 2^-23 x S of the exact result.
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

// umbrage_parallel_map_places: umbrage_single_map_places under parallel rays, where w is 1
fn umbrage_parallel_map_places(to_texels: mat4x4f, planes: mat4x4f, anchor: vec4f, rounding: vec4f, slack: vec4f,
                               terms: vec4f, world: vec3f, normal: vec3f) -> mat4x4f {
    let none: vec4f = vec4f(0.0, 0.0, 0.0, 0.0);
    let one: vec4f = vec4f(1.0, 1.0, 1.0, 1.0);
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let c: vec4f = to_texels[3] + to_texels[0] * way.x + to_texels[1] * way.y + to_texels[2] * way.z;
    let q: vec4f = planes[0] * normal.x + planes[1] * normal.y + planes[2] * normal.z;
    let slope: vec2f = umbrage_cascade_slope(vec3f(q.x, q.y, q.z), one);
    let steep: f32 = abs(slope.x) + abs(slope.y);
    let off: f32 = abs(c.z) * slack.y + slack.z;
    return mat4x4f(vec4f(c.x, c.y, c.z + slack.w, 0.0), vec4f(slope, 1.0, slack.x * steep + off), none, none);
}
