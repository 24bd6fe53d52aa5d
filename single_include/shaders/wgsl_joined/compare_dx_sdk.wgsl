// umbrage 0.1.0, compare_dx_sdk: shadow if stored + epsilon < receiver. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// compare_dx_sdk, tier B: within 1 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_compare_dx_sdk: 0.0 when stored + epsilon < receiver, else 1.0
fn umbrage_compare_dx_sdk(receiver: f32, stored: f32, epsilon: f32) -> f32 {
    let limit: f32 = stored + epsilon;
    return select(1.0, 0.0, limit < receiver);
}
