// umbrage 0.1.0, dual_paraboloid_slope: change of distance per texel in a dual paraboloid map. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// dual_paraboloid_slope, tier C: within 41 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_clamp_slope: change of depth per texel clamped to [-2, 2]; NaN becomes 2.0
fn umbrage_clamp_slope(slope: f32) -> f32 {
    return select(select(2.0, -2.0, slope <= -2.0), slope, abs(slope) < 2.0);
}

// umbrage_dual_paraboloid_slope: change of distance per texel, the same in x and y; 0.0 without a normal
//   way        from the light to the receiver
//   normal     surface normal
//   per_texel  2.0 / (range * (size - 2.0 * border))
fn umbrage_dual_paraboloid_slope(way: vec3f, normal: vec3f, per_texel: f32) -> vec2f {
    let square: f32 = way.x * way.x + way.y * way.y + way.z * way.z;
    let x: f32 = normal.y * way.z - normal.z * way.y;
    let y: f32 = normal.z * way.x - normal.x * way.z;
    let z: f32 = normal.x * way.y - normal.y * way.x;
    let across: f32 = x * x + y * y + z * z;
    let along: f32 = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    let wide: f32 = (sqrt(square) + abs(way.z)) * (per_texel * 0.707106781);
    let slope: f32 = umbrage_clamp_slope(wide * sqrt(across) / abs(along));
    let none: bool = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    return select(vec2f(slope, slope), vec2f(0.0, 0.0), none);
}
