// umbrage 0.1.0, chebyshev: upper bound on visibility from mean and variance. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// chebyshev, tier C: within 11 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_chebyshev: upper bound on the fraction of depths at the receiver's depth or farther. 0.0 for NaN
//   m              mean of the depths, mean of their squares
//   receiver       receiver depth, on the same scale
//   min_variance   0.0 or more
fn umbrage_chebyshev(m: vec2f, receiver: f32, min_variance: f32) -> f32 {
    let difference: f32 = m.y - m.x * m.x;
    let variance: f32 = select(min_variance, difference, difference > min_variance);
    let distance: f32 = receiver - m.x;
    let sum: f32 = variance + distance * distance;
    let p: f32 = variance / sum;
    return select(select(0.0, min(p, 1.0), p > 0.0), 1.0, receiver <= m.x);  // a GPU's v / v may be more than 1.0
}
