// umbrage 0.1.0, cascaded_maps_places_8: places of a point of the world in up to eight cascades. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// cascaded_maps_places_8, tier C: within 38 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_shadow_coordinate: texture matrix times world position: (x w, y w, depth w, w), x and y in texels
fn umbrage_shadow_coordinate(m: mat4x4f, world: vec3f) -> vec4f {
    let c: vec4f = m[3] + m[0] * world.x + m[1] * world.y + m[2] * world.z;
    return c;
}

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

// umbrage_cascade_column: column of a matrix by its index, 0.0 to 3.0, for languages without dynamic indexing
fn umbrage_cascade_column(columns: mat4x4f, number: f32) -> vec4f {
    let low: vec4f = select(columns[1], columns[0], number < 0.5);
    let high: vec4f = select(columns[3], columns[2], number < 2.5);
    return select(high, low, number < 1.5);
}

// umbrage_cascade_column_8: column of two matrices by its index, 0.0 to 7.0
fn umbrage_cascade_column_8(nearer: mat4x4f, farther: mat4x4f, number: f32) -> vec4f {
    let low: vec4f = umbrage_cascade_column(nearer, number);
    let high: vec4f = umbrage_cascade_column(farther, number - 4.0);
    return select(high, low, number < 3.5);
}

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

// umbrage_cascaded_maps_places_8: places of a point of the world in one or two of up to eight cascades
//   farther_scales, farther_offsets   those of the fifth cascade and of those after it
//   the others, and what it returns   as umbrage_cascaded_maps_places
fn umbrage_cascaded_maps_places_8(rotation: mat4x4f, scales: mat4x4f, offsets: mat4x4f, farther_scales: mat4x4f,
                                  farther_offsets: mat4x4f, anchor: vec4f, blending: vec4f, terms: vec4f, world: vec3f,
                                  normal: vec3f) -> mat4x4f {
    let size: vec2f = vec2f(terms.x, terms.y);
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let turned: vec4f = umbrage_shadow_coordinate(rotation, way);
    let turned_normal: vec4f = umbrage_shadow_coordinate(rotation, normal);
    let light: vec3f = vec3f(turned.x, turned.y, turned.z);
    let across: vec3f = vec3f(turned_normal.x, turned_normal.y, turned_normal.z);
    let found: vec4f =
        umbrage_cascade_by_projection_8(light, scales, offsets, farther_scales, farther_offsets, size, terms.z);
    let number: f32 = min(found.w, blending.y);
    let next: f32 = min(number + 1.0, blending.y);
    let next_scale: vec4f = umbrage_cascade_column_8(scales, farther_scales, next);
    let next_offset: vec4f = umbrage_cascade_column_8(offsets, farther_offsets, next);
    let there: vec3f = umbrage_cascade_coordinate(light, next_scale, next_offset);
    let offset: vec4f = umbrage_cascade_column_8(offsets, farther_offsets, number);
    let edge: f32 = umbrage_cascade_edge(vec3f(found.x, found.y, found.z), size, terms.z);
    let next_edge: f32 = umbrage_cascade_edge(there, size, terms.z);
    return umbrage_cascade_pair(across, found, there, vec2f(edge, next_edge), vec2f(offset.w, next_offset.w),
                                umbrage_cascade_column_8(scales, farther_scales, number), next_scale, blending);
}
