// umbrage 0.1.0, spot_cone: 1 inside a spot light's cone, else 0. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// spot_cone, tier B: within 11 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_spot_cone: 1.0 inside the cone of a spot light, else 0.0
//   direction  of the light, unit length;   to_point  from the light, any length;   cos_outer  in [0, 1)
fn umbrage_spot_cone(direction: vec3f, to_point: vec3f, cos_outer: f32) -> f32 {
    let d: f32 = direction.x * to_point.x + direction.y * to_point.y + direction.z * to_point.z;
    let length2: f32 = to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z;
    let edge2: f32 = cos_outer * cos_outer * length2;
    let d2: f32 = d * d;
    return select(0.0, 1.0, d > 0.0 && d2 > edge2);
}
