// umbrage 0.1.0, depth_from_ndc: z/w in [-1, 1] to depth in [0, 1]. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// depth_from_ndc, tier B: within 2 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_depth_from_ndc: depth in [0, 1] from z/w in [-1, 1]
fn umbrage_depth_from_ndc(ndc: f32) -> f32 {
    let depth: f32 = ndc * 0.5 + 0.5;
    return depth;
}
