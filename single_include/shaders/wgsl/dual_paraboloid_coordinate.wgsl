// umbrage 0.1.0, dual_paraboloid_coordinate: paraboloid map that sees a direction, and position in it. Exactness:
//   tier C.
// WGSL lets compilers fuse or reorder sums.
// dual_paraboloid_coordinate, tier C: within 32 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_dual_paraboloid_coordinate: (s, t, map) of a direction: 0.0 to 1.0 over the map's square, map 0.0 or 1.0
fn umbrage_dual_paraboloid_coordinate(direction: vec3f) -> vec3f {
    let square: f32 = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    let behind: bool = direction.z < 0.0;
    let m: f32 = sqrt(square) + select(direction.z, -direction.z, behind);
    let x: f32 = select(-direction.x, direction.x, behind);
    return vec3f((x + m) / (m + m), (direction.y + m) / (m + m), select(0.0, 1.0, behind));
}
