// umbrage 0.1.0, blend_cascades: blend of two cascades' visibilities. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// blend_cascades, tier B: within 3 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_blend_cascades: blend of the visibilities of a cascade and of the next one, by the next one's weight
fn umbrage_blend_cascades(nearer: f32, farther: f32, weight: f32) -> f32 {
    let sum: f32 = nearer + (farther - nearer) * weight;
    return select(farther, sum, weight < 1.0);
}
