// umbrage 0.1.0, forward_depth: depth that grows with distance. Exactness: tier B.
// Tier B: WGSL lets compilers fuse or reorder sums. Results then stay within the stated bound.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: cleared_depth.wgsl; or paste wgsl_joined/forward_depth.wgsl alone.

// umbrage_forward_depth: depth that grows with distance, 1.0 - depth where the map's is reversed
fn umbrage_forward_depth(depth: f32) -> f32 {
    return select(depth, 1.0 - depth, umbrage_cleared_depth() < 0.5);
}
