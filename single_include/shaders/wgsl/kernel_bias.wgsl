// umbrage 0.1.0, kernel_bias: bias from kernel width and angle of the light. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// kernel_bias, tier C: within 30 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_kernel_bias: distance along the light that a kernel extends beyond a surface's plane, in width's unit
//   normal     surface normal
//   direction  direction of the light, of length one
//   way        from the light to the point over w; for a directional light its direction
//   width      sqrt(2) reach texel
//   greatest   limit of the tangent
fn umbrage_kernel_bias(normal: vec3f, direction: vec3f, way: vec3f, width: f32, greatest: f32) -> f32 {
    let x: f32 = normal.y * direction.z + normal.z * -direction.y;
    let y: f32 = normal.z * direction.x + normal.x * -direction.z;
    let z: f32 = normal.x * direction.y + normal.y * -direction.x;
    let square: f32 = x * x + y * y + z * z;
    let sine: f32 = sqrt(square);
    let cosine: f32 = -(normal.x * way.x + normal.y * way.y + normal.z * way.z);
    let edge: f32 = cosine * greatest;
    let tangent: f32 = select(greatest, sine / cosine, edge > sine);
    let bias: f32 = width * tangent;
    return select(0.0, bias, bias >= (1.0 / 18446744073709551616.0) && bias < 18446744073709551616.0);
}
