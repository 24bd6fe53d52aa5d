// umbrage 0.1.0, dual_paraboloid_position: position of a vertex in a paraboloid map's depth pass. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// dual_paraboloid_position, tier C: within 18 x 2^-23 x S of the exact result.
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
