// umbrage 0.1.0, biased: receiver moved towards the light. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// biased, tier B: within 1 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_biased: receiver moved towards the light by bias, in depth; no move for NaN, or magnitudes of 2^64 or more
fn umbrage_biased(receiver: f32, bias: f32) -> f32 {
    let by: f32 = select(0.0, bias, abs(bias) < 18446744073709551616.0);
    return select(receiver + by, receiver - by, umbrage_cleared_depth() > 0.5);
}
