// umbrage 0.1.0, apply_receiver_plane: stored depth moved along the receiver's plane to it. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// apply_receiver_plane, tier B: within 8 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: cleared_depth.wgsl; or paste wgsl_joined/apply_receiver_plane.wgsl alone.

// umbrage_apply_receiver_plane: a texel's depth moved along the receiver's plane to the receiver; not if cleared
//   stored  depth of the texel
//   slope   slope of the receiver's plane, per texel
//   coord   receiver position, in texels
//   texel   index of the texel
fn umbrage_apply_receiver_plane(stored: f32, slope: vec2f, coord: vec2f, texel: vec2f) -> f32 {
    let way: vec2f = texel + 0.5 - coord;
    let depth: f32 = stored - (slope.x * way.x + slope.y * way.y);
    let cleared: bool = abs(stored - umbrage_cleared_depth()) < (1.0 / 18446744073709551616.0);
    return select(depth, stored, cleared);
}
