// umbrage 0.1.0, on_receiver_plane: stored depth moved along the receiver's plane to the receiver. Exactness: tier B.
// Tier B: WGSL lets compilers fuse or reorder sums. Results then stay within the stated bound.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_on_receiver_plane: a texel's depth as the receiver's own texel would hold it; a cleared one stays cleared
//   stored  depth of the texel;   slope  of the receiver's plane, a texel;   coord  receiver in texels
fn umbrage_on_receiver_plane(stored: f32, slope: vec2f, coord: vec2f, texel: vec2f) -> f32 {
    let way: vec2f = texel + 0.5 - coord;
    let depth: f32 = stored - (slope.x * way.x + slope.y * way.y);
    let cleared: bool = abs(stored - umbrage_cleared_depth()) < (1.0 / 18446744073709551616.0);
    return select(depth, stored, cleared);
}
