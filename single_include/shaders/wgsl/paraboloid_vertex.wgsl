// umbrage 0.1.0, paraboloid_vertex: clip space position of a vertex in a paraboloid map. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// paraboloid_vertex, tier C: within 51 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_dual_paraboloid_position: (x w, y w, distance w, w) of a vertex, for the depth pass' projection
//   direction  from the light to the vertex
//   map        index of the map, 0.0 or 1.0
fn umbrage_dual_paraboloid_position(direction: vec3f, map: f32) -> vec4f {
    let behind: bool = map > 0.5;
    let square: f32 = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    let distance_to: f32 = sqrt(square);
    let w: f32 = distance_to + select(direction.z, -direction.z, behind);
    return vec4f(select(-direction.x, direction.x, behind), direction.y, distance_to * w, w);
}

// umbrage_paraboloid_vertex: clip space position of a vertex in a paraboloid map
//   to_clip    the light's projection
//   anchor     position of the light
//   number     0.0 or 1.0, the map
fn umbrage_paraboloid_vertex(to_clip: mat4x4f, world: vec3f, anchor: vec4f, number: f32) -> vec4f {
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let p: vec4f = umbrage_dual_paraboloid_position(way, number);
    let place: vec4f = to_clip[3] * p.w + to_clip[0] * p.x + to_clip[1] * p.y + to_clip[2] * p.z;
    return place;
}
