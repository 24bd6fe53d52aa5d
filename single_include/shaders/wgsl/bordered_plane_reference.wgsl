// umbrage 0.1.0, bordered_plane_reference: plane_reference in a map whose border is lit. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// bordered_plane_reference, tier B: within 8 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_bordered_plane_reference: umbrage_plane_reference, but before every stored depth outside the map
//   slope, at, texel   as for umbrage_plane_reference
//   inside             texel if the map has it, otherwise any other
fn umbrage_bordered_plane_reference(slope: vec2f, at: vec3f, texel: vec2f, inside: vec2f) -> f32 {
    let lights: f32 = select(16777216.0, -16777216.0, umbrage_cleared_depth() > 0.5);
    let moves: vec2f = slope * (texel - (vec2f(at.x, at.y) - 0.5));
    let x: f32 = select(lights, moves.x, inside.x == texel.x);  // the same for all texels of a column
    let y: f32 = select(lights, moves.y, inside.y == texel.y);
    let plane: f32 = (at.z + x) + y;
    return select(max(plane, at.z), min(plane, at.z), umbrage_cleared_depth() > 0.5);
}
