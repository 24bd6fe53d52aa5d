// umbrage 0.1.0, project_coordinate: division by w; lit behind the light. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// project_coordinate, tier C: within 3 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_project_coordinate: x and y in texels, and depth; w <= 0.0 gives a coordinate that every filter takes as lit
fn umbrage_project_coordinate(coordinate: vec4f) -> vec3f {
    let p: vec3f = vec3f(coordinate.x / coordinate.w, coordinate.y / coordinate.w, coordinate.z / coordinate.w);
    return select(vec3f(65536.0, 65536.0, 0.0), p, coordinate.w > 0.0);
}
