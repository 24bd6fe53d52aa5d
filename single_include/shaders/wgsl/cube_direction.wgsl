// umbrage 0.1.0, cube_direction: direction to a point of a cube's face. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// cube_direction, tier B: within 2 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: cube_point.wgsl; or paste wgsl_joined/cube_direction.wgsl alone.

// umbrage_cube_direction: direction from a cube's center to a point of a face, 0.0 to 5.0; st is in [0.0, 1.0]
fn umbrage_cube_direction(face: f32, st: vec2f) -> vec3f {
    let uv: vec2f = st * 2.0 - 1.0;  // the product is exact: fused or not, it rounds once
    return umbrage_cube_point(face, vec3f(uv, 1.0));
}
