// umbrage 0.1.0, corner_reference: depth that four texels are compared with, by the receiver's plane. Exactness: tier
//   C.
// WGSL lets compilers fuse or reorder sums.
// corner_reference, tier C: within 5 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_corner_reference: depth of the receiver, or of its plane where four texels meet, the nearer to the light
//   slope      slope of the receiver's plane, per texel, no NaN
//   way        from the receiver to where the texels meet, in texels
//   receiver   depth, bias applied
fn umbrage_corner_reference(slope: vec2f, way: vec2f, receiver: f32) -> f32 {
    let plane: f32 = (receiver + slope.x * way.x) + slope.y * way.y;
    return select(max(plane, receiver), min(plane, receiver), umbrage_cleared_depth() > 0.5);
}
