// umbrage 0.1.0, warped_maps_places: places of a point of the world in up to four warped cascades. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// warped_maps_places, tier C: within 121 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_plane_in_map: normal, in texels, texels and depth, of the plane through a point
//   plane_matrix  transpose of the texture matrix' inverse
//   normal        normal of the plane, any length
//   world         point on the plane
fn umbrage_plane_in_map(plane_matrix: mat4x4f, normal: vec3f, world: vec3f) -> vec3f {
    let d: f32 = -(normal.x * world.x + normal.y * world.y + normal.z * world.z);
    let q: vec4f = plane_matrix[3] * d + plane_matrix[0] * normal.x + plane_matrix[1] * normal.y + plane_matrix[2] *
        normal.z;
    return vec3f(q.x, q.y, q.z);
}

// umbrage_receiver_slope: umbrage_plane_slope without its clamps; (0.0, 0.0) for a normal of zero (the caller has none)
fn umbrage_receiver_slope(plane_matrix: mat4x4f, normal: vec3f, world: vec3f) -> vec2f {
    let q: vec3f = umbrage_plane_in_map(plane_matrix, normal, world);
    let depth: f32 = select(q.z, 1.0e-30, q.z == 0.0);  // q is zero without a normal, and not where edge-on
    return vec2f(-q.x / depth, -q.y / depth);
}

// umbrage_anchored_place: place of a point in one map, and the slack of its plane
//   to_texels, planes   matrices from positions less the anchor to texels of the map, and to their planes
//   rounding, slack     of anchored_map; slack.w is added to depth
//   way                 position less the anchor
//   returns (texels, texels, depth, 0.0), (slope, slope, weight, slack); behind the light: a place taken as lit
fn umbrage_anchored_place(to_texels: mat4x4f, planes: mat4x4f, rounding: vec4f, slack: vec4f, way: vec3f,
                          normal: vec3f) -> mat4x4f {
    let none: vec4f = vec4f(0.0, 0.0, 0.0, 0.0);
    let c: vec4f = to_texels[3] + to_texels[0] * way.x + to_texels[1] * way.y + to_texels[2] * way.z;
    let slope: vec2f = umbrage_receiver_slope(planes, normal, way);
    let before: bool = c.w > 0.0;
    let i: f32 = select(0.0, 1.0 / c.w, before);
    let at: vec3f = vec3f(c.x, c.y, c.z) * i;
    let steep: f32 = abs(slope.x) + abs(slope.y);
    let moves: f32 = rounding.x + rounding.y * i;
    let off: f32 = moves * (rounding.w + abs(at.z)) + (abs(at.z) * slack.y + slack.z);
    let all: f32 = (moves * rounding.z + slack.x) * steep + off;
    return mat4x4f(vec4f(select(65536.0, at.x, before), at.y, at.z + slack.w, 0.0), vec4f(slope, 1.0, all), none, none);
}

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

// umbrage_warped_maps_places: places of a point of the world in one or two of up to four warped cascades
//   to_texels_0 to planes_3   matrices of umbrage_anchored_place for each map
//   rounding, slack           one column per map: its rounding and slack there
//   fades                     one column per map: scale and offset of the next one's weight
//   anchor                    the one anchor of all maps
//   ahead                     distance along the camera's axis: dot(ahead.xyz, world - anchor) + ahead.w
//   ends                      ends of the first three cascades, number of the last one
//   returns (texels, texels, depth, number), (slope, slope, weight, slack) of both. After the last: outside, lit
fn umbrage_warped_maps_places(to_texels_0: mat4x4f, to_texels_1: mat4x4f, to_texels_2: mat4x4f, to_texels_3: mat4x4f,
                              planes_0: mat4x4f, planes_1: mat4x4f, planes_2: mat4x4f, planes_3: mat4x4f,
                              rounding: mat4x4f, slack: mat4x4f, fades: mat4x4f, anchor: vec4f, ahead: vec4f,
                              ends: vec4f, terms: vec4f, world: vec3f, normal: vec3f) -> mat4x4f {
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let depth: f32 = ahead.x * way.x + ahead.y * way.y + ahead.z * way.z + ahead.w;
    let number: f32 = umbrage_cascade_by_depth(depth, vec3f(ends.x, ends.y, ends.z));
    let own: vec4f = umbrage_cascade_column(fades, number);
    let weight: f32 = umbrage_cascade_fade(depth, own.x, own.y);
    var to_texels: mat4x4f = to_texels_0;
    var planes: mat4x4f = planes_0;
    var to_next: mat4x4f = to_texels_1;
    var next_planes: mat4x4f = planes_1;
    if (number > 0.5) {
        to_texels = to_texels_1;
        planes = planes_1;
        to_next = to_texels_2;
        next_planes = planes_2;
    }
    if (number > 1.5) {
        to_texels = to_texels_2;
        planes = planes_2;
        to_next = to_texels_3;
        next_planes = planes_3;
    }
    if (number > 2.5) {
        to_texels = to_texels_3;
        planes = planes_3;
    }
    let at: mat4x4f =
        umbrage_anchored_place(to_texels, planes, umbrage_cascade_column(rounding, number),
                               umbrage_cascade_column(slack, number), way, normal);
    let there: mat4x4f =
        umbrage_anchored_place(to_next, next_planes, umbrage_cascade_column(rounding, number + 1.0),
                               umbrage_cascade_column(slack, number + 1.0), way, normal);
    let after: vec3f = vec3f(there[0].x, there[0].y, there[0].z);
    let next: vec3f = select(after, vec3f(-65536.0, -65536.0, 0.0), number >= ends.w);
    return mat4x4f(vec4f(at[0].x, at[0].y, at[0].z, number), at[1], vec4f(next, min(number + 1.0, ends.w)),
                   vec4f(there[1].x, there[1].y, weight, there[1].w));
}
