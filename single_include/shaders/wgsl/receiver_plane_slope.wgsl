// umbrage 0.1.0, receiver_plane_slope: slope of a receiver's plane from derivatives, and its error. Exactness: tier
//   C.
// WGSL lets compilers fuse or reorder sums.
// receiver_plane_slope, tier C: within 31 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_clamp_slope: change of depth per texel clamped to [-2, 2]; NaN becomes 2.0
fn umbrage_clamp_slope(slope: f32) -> f32 {
    return select(select(2.0, -2.0, slope <= -2.0), slope, abs(slope) < 2.0);
}

// umbrage_receiver_plane_slope: change of a receiver's depth per texel in x and y, and the largest error of their sum
//   dx, dy  dFdx and dFdy of (x and y in texels, depth); the result is zero where they do not give the plane
fn umbrage_receiver_plane_slope(dx: vec3f, dy: vec3f) -> vec3f {
    let determinant: f32 = dx.x * dy.y + dx.y * -dy.x;
    let sum: f32 = abs(dx.x) + abs(dx.y) + abs(dy.x) + abs(dy.y);
    let along_x: f32 = dy.y * dx.z + dx.y * -dy.z;
    let along_y: f32 = dx.x * dy.z + dy.x * -dx.z;
    let a: f32 = umbrage_clamp_slope(along_x / determinant);
    let b: f32 = umbrage_clamp_slope(along_y / determinant);
    let off: f32 = ((1.0 / 33554432.0) + (abs(a) + abs(b)) * (1.0 / 8192.0)) * 3.3;
    let error: f32 = off * (sum / abs(determinant));
    let least: f32 = sum * (1.0 / 1024.0);
    let known: bool = abs(determinant) > least && sum < 18446744073709551616.0;
    return select(vec3f(0.0, 0.0, 0.0), vec3f(a, b, umbrage_clamp_slope(error)), known);
}
