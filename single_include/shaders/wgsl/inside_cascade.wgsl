// umbrage 0.1.0, inside_cascade: true if a filter stays inside a cascade. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// inside_cascade, tier B: within 2 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_inside_cascade: true if a filter of radius reach at a coordinate stays inside a map of size texels
fn umbrage_inside_cascade(coordinate: vec3f, size: vec2f, reach: f32) -> bool {
    let end: vec2f = size - reach;
    // y is doubled because Mesa turns two comparisons with one limit into min(x, y) >= reach, which loses a NaN
    let in_x: bool = coordinate.x >= reach && coordinate.x <= end.x;
    let in_y: bool = coordinate.y * 2.0 >= reach * 2.0 && coordinate.y * 2.0 <= end.y * 2.0;
    return in_x && in_y && coordinate.z >= 0.0 && coordinate.z <= 1.0;
}
