// umbrage 0.1.0, encode_deviation: two moments of depth (VSM) to mean and deviation. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// encode_deviation, tier C: within 7 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_encode_deviation: mean and mean square of depths to mean and twice the standard deviation, each 0.0 to 1.0
fn umbrage_encode_deviation(m: vec2f) -> vec2f {
    let variance: f32 = m.y - m.x * m.x;
    return vec2f(m.x, 2.0 * sqrt(select(0.0, variance, variance > 0.0)));
}
