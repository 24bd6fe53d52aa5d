// umbrage 0.1.0, reverse_depth: 1 - depth. Exactness: tier B.
// Tier B: WGSL lets compilers fuse or reorder sums. Results then stay within the stated bound.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_reverse_depth: forward depth from reversed, or reversed from forward
fn umbrage_reverse_depth(depth: f32) -> f32 {
    return 1.0 - depth;
}
