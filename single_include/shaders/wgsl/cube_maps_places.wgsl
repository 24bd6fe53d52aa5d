// umbrage 0.1.0, cube_maps_places: place of a point of the world in a cube's six maps. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// cube_maps_places, tier C: within 121 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cube_maps_places: place of a point of the world in a cube's six maps
//   face              texels a unit across the face's axis, at distance 1 along it; middle of a map; depth over
//                     1.0 / distance, and that by texels
//   anchor            position of the light
//   rounding, slack   of umbrage_anchored_place, from a face's axes
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
fn umbrage_cube_maps_places(face: vec4f, anchor: vec4f, rounding: vec4f, slack: vec4f, terms: vec4f, world: vec3f,
                            normal: vec3f) -> mat4x4f {
    let none: vec4f = vec4f(0.0, 0.0, 0.0, 0.0);
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let m: vec3f = abs(way);
    let on_x: bool = select(false, (m.x >= m.z), m.x >= m.y);
    let on_y: bool = select((m.y >= m.z), false, on_x);
    let along: f32 = select(select(way.z, way.y, on_y), way.x, on_x);
    let flip: f32 = select(1.0, -1.0, along < 0.0);
    let number: f32 = select(select(4.5, 2.5, on_y), 0.5, on_x) - 0.5 * flip;
    let signs: vec2f = vec2f(select(select(flip, 1.0, on_y), -flip, on_x), select(-1.0, flip, on_y));
    let there: vec2f = vec2f(select(way.x, way.z, on_x), select(way.y, way.z, on_y)) * signs;
    let across: vec2f = vec2f(select(normal.x, normal.z, on_x), select(normal.y, normal.z, on_y)) * signs;
    let off_plane: f32 = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    let rise: f32 = face.w / select(off_plane, 1.0e-30, off_plane == 0.0);  // as umbrage_receiver_slope
    let slope: vec2f = across * rise;
    let i: f32 = 1.0 / max(abs(along), 1.0e-30);
    let z: f32 = face.z * i;
    let at: vec2f = there * (face.x * i) + face.y;
    let steep: f32 = abs(slope.x) + abs(slope.y);
    let moves: f32 = rounding.x + rounding.y * i;
    let off: f32 = abs(z) * (moves + slack.y) + slack.z;  // a lens has no rounding.w
    let all: f32 = (moves * rounding.z + slack.x) * steep + off;
    return mat4x4f(vec4f(at, z + slack.w, number), vec4f(slope, 1.0, all), none, none);
}
