// umbrage 0.1.0, warped_maps_place: place of a point of the world in one of up to four warped cascades. Exactness:
//   tier C.
// WGSL lets compilers fuse or reorder sums.
// warped_maps_place, tier C: within 121 x 2^-23 x S of the exact result.
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

// umbrage_cascade_column: column of a matrix by its index, 0.0 to 3.0, for languages without dynamic indexing
fn umbrage_cascade_column(columns: mat4x4f, number: f32) -> vec4f {
    let low: vec4f = select(columns[1], columns[0], number < 0.5);
    let high: vec4f = select(columns[3], columns[2], number < 2.5);
    return select(high, low, number < 1.5);
}

// umbrage_warped_maps_place: place of a point of the world in one of up to four warped cascades
//   to_texels_0 to planes_3   matrices of umbrage_anchored_place for each map
//   rounding, slack           one column per map: its rounding and slack there
//   fades, ahead              of umbrage_warped_maps_choice, not read
//   anchor                    the one anchor of all maps
//   ends                      w: number of the last cascade, after which the place is outside all maps, and lit
//   number                    number of the cascade
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
fn umbrage_warped_maps_place(to_texels_0: mat4x4f, to_texels_1: mat4x4f, to_texels_2: mat4x4f, to_texels_3: mat4x4f,
                             planes_0: mat4x4f, planes_1: mat4x4f, planes_2: mat4x4f, planes_3: mat4x4f,
                             rounding: mat4x4f, slack: mat4x4f, fades: mat4x4f, anchor: vec4f, ahead: vec4f,
                             ends: vec4f, terms: vec4f, world: vec3f, normal: vec3f, number: f32) -> mat4x4f {
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let own: f32 = min(number, ends.w);
    var to_texels: mat4x4f = to_texels_0;
    var planes: mat4x4f = planes_0;
    if (own > 0.5) {
        to_texels = to_texels_1;
        planes = planes_1;
    }
    if (own > 1.5) {
        to_texels = to_texels_2;
        planes = planes_2;
    }
    if (own > 2.5) {
        to_texels = to_texels_3;
        planes = planes_3;
    }
    let at: mat4x4f =
        umbrage_anchored_place(to_texels, planes, umbrage_cascade_column(rounding, own),
                               umbrage_cascade_column(slack, own), way, normal);
    let x: f32 = select(-65536.0, at[0].x, number <= ends.w);
    return mat4x4f(vec4f(x, at[0].y, at[0].z, own), at[1], at[2], at[3]);
}
