// umbrage 0.1.0, cascade_pair: places in a cascade and in the next one, with their weights. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// cascade_pair, tier C: within 14 x 2^-23 x S of the exact result.
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

// umbrage_cascade_weight: v rounded down to steps of 1/256, from 0.0 to 1.0; NaN gives 0.0
fn umbrage_cascade_weight(v: f32) -> f32 {
    return select(0.0, min(floor(v * 256.0), 256.0) * (1.0 / 256.0), v > 0.0);
}

// umbrage_cascade_pair: places in a cascade and in the next one, whose weight grows towards the border of the map
//   across                    normal, rotated into the light's axes
//   found                     (texels, texels, depth, index) in the cascade; an index above the last: in none
//   there                     (texels, texels, depth) in the next one
//   edges                     umbrage_cascade_edge of both
//   slacks                    w of the offsets of both: slack of a plane in depth
//   scale                     scale of the cascade; w: slack of a plane in texels of slope
//   next_scale                that of the next one
//   blending                  1.0 / width of the band in texels, or 0.0; index of the last cascade
//   returns (texels, texels, depth, number), (slope, slope, weight, slack) of both. After the last: outside, lit
fn umbrage_cascade_pair(across: vec3f, found: vec4f, there: vec3f, edges: vec2f, slacks: vec2f, scale: vec4f,
                        next_scale: vec4f, blending: vec4f) -> mat4x4f {
    let last: bool = found.w >= blending.y;
    let v: vec2f = edges * blending.x + 1.0;
    let leaves: f32 = select(0.0, umbrage_cascade_weight(v.x), blending.x > 0.0 && found.w <= blending.y);
    let held: f32 = select(0.0, 1.0 - umbrage_cascade_weight(v.y), edges.y <= 0.0);
    let weight: f32 = select(min(leaves, held), leaves, last);
    let next: vec3f = select(there, vec3f(-65536.0, -65536.0, 0.0), last);
    let slope: vec2f = umbrage_cascade_slope(across, scale);
    let next_slope: vec2f = umbrage_cascade_slope(across, next_scale);
    let slack: f32 = (abs(slope.x) + abs(slope.y)) * scale.w + slacks.x;
    let next_slack: f32 = (abs(next_slope.x) + abs(next_slope.y)) * next_scale.w + slacks.y;
    return mat4x4f(vec4f(found.x, found.y, found.z, min(found.w, blending.y)), vec4f(slope, 1.0, slack),
                   vec4f(next, min(found.w + 1.0, blending.y)), vec4f(next_slope, weight, next_slack));
}
