// umbrage 0.1.0, apply_receiver_plane: stored depth, or the far plane's if lit along the receiver's plane. Exactness:
//   tier B.
// WGSL lets compilers fuse or reorder sums.
// apply_receiver_plane, tier B: within 8 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by compare, direction.

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
fn umbrage_compare(receiver: f32, stored: f32) -> f32 {
    return select(0.0, 1.0, receiver <= stored);
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

// umbrage_apply_receiver_plane: depth of a texel that shadows the receiver's plane; any other has the far plane's
//   stored  depth of the texel
//   slope   slope of the receiver's plane, per texel
//   at      receiver position in texels, and its depth, bias applied
//   texel   index of the texel
fn umbrage_apply_receiver_plane(stored: f32, slope: vec2f, at: vec3f, texel: vec2f) -> f32 {
    let lit: f32 = umbrage_compare(umbrage_plane_reference(slope, at, texel), stored);
    return select(stored, umbrage_cleared_depth(), lit > 0.5);
}
