// umbrage 0.1.0, cube_direction: direction to a point of a cube's face. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// cube_direction, tier B: within 2 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cube_point: point from (sc, tc, distance along the axis) in a face, 0.0 to 5.0
fn umbrage_cube_point(face: f32, p: vec3f) -> vec3f {
    let x: vec3f = select(vec3f(-p.z, -p.y, p.x), vec3f(p.z, -p.y, -p.x), face < 0.5);
    let y: vec3f = select(vec3f(p.x, -p.z, -p.y), vec3f(p.x, p.z, p.y), face < 2.5);
    let z: vec3f = select(vec3f(-p.x, -p.y, -p.z), vec3f(p.x, -p.y, p.z), face < 4.5);
    return select(select(z, y, face < 3.5), x, face < 1.5);
}

// umbrage_cube_direction: direction from a cube's center to a point of a face, 0.0 to 5.0; st is in [0.0, 1.0]
fn umbrage_cube_direction(face: f32, st: vec2f) -> vec3f {
    let uv: vec2f = st * 2.0 - 1.0;  // the product is exact: fused or not, it rounds once
    return umbrage_cube_point(face, vec3f(uv, 1.0));
}
