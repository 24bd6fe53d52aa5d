// umbrage 0.1.0, cascaded_maps_choice_8: those of up to eight cascades that hold a point of the world. Exactness:
//   tier C.
// WGSL lets compilers fuse or reorder sums.
// cascaded_maps_choice_8, tier C: within 38 x 2^-23 x S of the exact result.
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

// umbrage_first_cascade: number of the first of four cascades that holds a point and its filter, its edge, and the edge
// of the next one; (4.0, 65536.0, 65536.0) for none
//   edges   umbrage_cascade_edge of each
fn umbrage_first_cascade(edges: vec4f) -> vec3f {
    var found: vec3f = select(vec3f(4.0, 65536.0, 65536.0), vec3f(3.0, edges.w, 65536.0), edges.w <= 0.0);
    found = select(found, vec3f(2.0, edges.z, edges.w), edges.z <= 0.0);
    found = select(found, vec3f(1.0, edges.y, edges.z), edges.y <= 0.0);
    return select(found, vec3f(0.0, edges.x, edges.y), edges.x <= 0.0);
}

// umbrage_cascade_weight: v rounded down to steps of 1/256, from 0.0 to 1.0; NaN gives 0.0
fn umbrage_cascade_weight(v: f32) -> f32 {
    return select(0.0, min(floor(v * 256.0), 256.0) * (1.0 / 256.0), v > 0.0);
}

// umbrage_next_cascade_weight: weight of the next cascade, which grows towards the border of a cascade's map
//   found      of umbrage_first_cascade
//   blending   1.0 / width of the band in texels, or 0.0; number of the last cascade, after which comes light
fn umbrage_next_cascade_weight(found: vec3f, blending: vec4f) -> f32 {
    let v: vec2f = vec2f(found.y, found.z) * blending.x + 1.0;
    let leaves: f32 = umbrage_cascade_weight(v.x);
    let held: f32 = select(0.0, 1.0 - umbrage_cascade_weight(v.y), found.z <= 0.0);
    let weight: f32 = select(min(leaves, held), leaves, found.x >= blending.y);
    return select(0.0, weight, blending.x > 0.0 && found.x <= blending.y);
}

// umbrage_cascaded_maps_choice_8: umbrage_cascaded_maps_choice for up to eight cascades
//   farther_scales, farther_offsets   those of the fifth cascade and of those after it
fn umbrage_cascaded_maps_choice_8(rotation: mat4x4f, scales: mat4x4f, offsets: mat4x4f, farther_scales: mat4x4f,
                                  farther_offsets: mat4x4f, anchor: vec4f, blending: vec4f, terms: vec4f,
                                  world: vec3f) -> vec2f {
    let size: vec2f = vec2f(terms.x, terms.y);
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let turned: vec4f = rotation[3] + rotation[0] * way.x + rotation[1] * way.y + rotation[2] * way.z;
    let light: vec3f = vec3f(turned.x, turned.y, turned.z);
    let nearer: vec4f = umbrage_cascade_edges(light, scales, offsets, size, terms.z);
    let farther: vec4f = umbrage_cascade_edges(light, farther_scales, farther_offsets, size, terms.z);
    var found: vec3f = umbrage_first_cascade(nearer);
    let after: vec3f = umbrage_first_cascade(farther);
    let next: f32 = select(found.z, farther.x, found.x == 3.0);
    found = select(vec3f(after.x + 4.0, after.y, after.z), vec3f(found.x, found.y, next), found.x < 3.5);
    return vec2f(found.x, umbrage_next_cascade_weight(found, blending));
}
