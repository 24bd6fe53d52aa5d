// umbrage 0.1.0, plane_reference: depth that a texel is compared with, by the receiver's plane. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// plane_reference, tier B: within 8 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_plane_reference: depth of the receiver, or of its plane at a texel where that is nearer to the light
//   slope   slope of the receiver's plane, per texel, no NaN
//   at      receiver position in texels, and its depth, bias applied
//   texel   index of the texel
fn umbrage_plane_reference(slope: vec2f, at: vec3f, texel: vec2f) -> f32 {
    let way: vec2f = texel - (vec2f(at.x, at.y) - 0.5);
    let plane: f32 = (at.z + slope.x * way.x) + slope.y * way.y;
    return select(max(plane, at.z), min(plane, at.z), umbrage_cleared_depth() > 0.5);
}
