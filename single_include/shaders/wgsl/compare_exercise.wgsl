// umbrage 0.1.0, compare_exercise: lit if current < stored + epsilon. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// compare_exercise, tier B: within 1 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_compare_exercise: 1.0 when current < stored + epsilon, else 0.0
fn umbrage_compare_exercise(current: f32, stored: f32, epsilon: f32) -> f32 {
    let limit: f32 = stored + epsilon;
    return select(0.0, 1.0, current < limit);
}
