// umbrage 0.1.0, normal_offset: offset along the normal to the point to look up. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// normal_offset, tier C: within 91 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_normal_offset: offset to add to a surface point before its lookup, world units
//   normal       surface normal, of length one
//   direction    direction of the light, of length one
//   way          from the light to the point over w; for a directional light its direction
//   width        sqrt(2) reach texel
//   error_world  error of the map's depths, world units
fn umbrage_normal_offset(normal: vec3f, direction: vec3f, way: vec3f, width: f32, error_world: f32) -> vec3f {
    let x: f32 = normal.y * direction.z + normal.z * -direction.y;
    let y: f32 = normal.z * direction.x + normal.x * -direction.z;
    let z: f32 = normal.x * direction.y + normal.y * -direction.x;
    let straight: f32 = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    let square: f32 = x * x + y * y + z * z;
    let along: f32 = width * sqrt(square) + error_world * abs(straight);
    let offset: vec3f = normal * along;
    return select(vec3f(0.0, 0.0, 0.0), offset, abs(offset.x) + abs(offset.y) + abs(offset.z) < 18446744073709551616.0);
}
