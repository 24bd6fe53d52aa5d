// umbrage 0.1.0, tap_coordinate: coordinate of a tap from the center's, before division by w. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// tap_coordinate, tier B: within 2 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_tap_coordinate: coordinate before the division by w, moved by offset texels
fn umbrage_tap_coordinate(coordinate: vec4f, offset: vec2f) -> vec4f {
    let moved: vec2f = vec2f(coordinate.x, coordinate.y) + offset * coordinate.w;
    return vec4f(moved.x, moved.y, coordinate.z, coordinate.w);
}
