// umbrage 0.1.0, project_depth: z / w, and the far plane behind the light. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// project_depth, tier C: within 3 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_project_depth: z / w. Returns cleared for w <= 0.0: 1.0, or 0.0 where depth is reversed
fn umbrage_project_depth(z: f32, w: f32, cleared: f32) -> f32 {
    return select(cleared, z / w, w > 0.0);
}
