// umbrage 0.1.0, cascaded_maps_places: places of a point of the world in up to four cascades. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// cascaded_maps_places, tier C: within 38 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cascade_edge: texels beyond the part of a cascade's map where a filter stays inside, at most 0.0 inside
//   coordinate   position in the cascade's map: texels, texels, depth
//   size, reach  size of the map and filter radius, in texels
// Returns 65536.0 for a depth outside [0, 1], far from the map, and for NaN
fn umbrage_cascade_edge(coordinate: vec3f, size: vec2f, reach: f32) -> f32 {
    let half_size: vec2f = size * 0.5;
    let beyond: vec2f = abs(vec2f(coordinate.x, coordinate.y) - half_size) - (half_size - reach);
    let near_map: bool = beyond.x + beyond.y < 65536.0;  // false for NaN
    return select(65536.0, max(beyond.x, beyond.y), coordinate.z >= 0.0 && coordinate.z <= 1.0 && near_map);
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

// umbrage_cascaded_maps_places: places of a point of the world in one or two of up to four cascades
//   rotation          rotation from the world to the light's axes
//   scales, offsets   scales and offsets of the cascades
//   anchor            position that is subtracted from world
//   blending, terms   as for umbrage_cascade_pair, whose columns it returns; size of a map and reach of the filter
fn umbrage_cascaded_maps_places(rotation: mat4x4f, scales: mat4x4f, offsets: mat4x4f, anchor: vec4f, blending: vec4f,
                                terms: vec4f, world: vec3f, normal: vec3f) -> mat4x4f {
    let size: vec2f = vec2f(terms.x, terms.y);
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let light: vec4f = rotation[3] + rotation[0] * way.x + rotation[1] * way.y + rotation[2] * way.z;
    let across: vec4f = rotation[3] + rotation[0] * normal.x + rotation[1] * normal.y + rotation[2] * normal.z;
    let a: vec4f = light * scales[0] + offsets[0];
    let b: vec4f = light * scales[1] + offsets[1];
    let c: vec4f = light * scales[2] + offsets[2];
    let d: vec4f = light * scales[3] + offsets[3];
    let edge_a: f32 = umbrage_cascade_edge(vec3f(a.x, a.y, a.z), size, terms.z);
    let edge_b: f32 = umbrage_cascade_edge(vec3f(b.x, b.y, b.z), size, terms.z);
    let edge_c: f32 = umbrage_cascade_edge(vec3f(c.x, c.y, c.z), size, terms.z);
    let edge_d: f32 = umbrage_cascade_edge(vec3f(d.x, d.y, d.z), size, terms.z);
    let in_a: bool = edge_a <= 0.0;
    let in_b: bool = edge_b <= 0.0;
    let in_c: bool = edge_c <= 0.0;
    let none: vec4f = vec4f(65536.0, 65536.0, 0.0, 4.0);
    var found: vec4f = select(none, vec4f(d.x, d.y, d.z, 3.0), edge_d <= 0.0);
    found = select(found, vec4f(c.x, c.y, c.z, 2.0), in_c);
    found = select(found, vec4f(b.x, b.y, b.z, 1.0), in_b);
    found = select(found, vec4f(a.x, a.y, a.z, 0.0), in_a);
    // the next cascade is already looked at; no column is chosen by number
    let there: vec4f = select(select(d, c, in_b), b, in_a);
    let edge: f32 = select(select(select(edge_d, edge_c, in_c), edge_b, in_b), edge_a, in_a);
    let next_edge: f32 = select(select(edge_d, edge_c, in_b), edge_b, in_a);
    let scale: vec4f = select(select(select(scales[3], scales[2], in_c), scales[1], in_b), scales[0], in_a);
    let next_scale: vec4f = select(select(scales[3], scales[2], in_b), scales[1], in_a);
    let next_slack: f32 = select(select(offsets[3].w, offsets[2].w, in_b), offsets[1].w, in_a);
    let slack: f32 = select(select(select(offsets[3].w, offsets[2].w, in_c), offsets[1].w, in_b), offsets[0].w, in_a);
    return umbrage_cascade_pair(vec3f(across.x, across.y, across.z), found, vec3f(there.x, there.y, there.z),
                                vec2f(edge, next_edge), vec2f(slack, next_slack), scale, next_scale, blending);
}
