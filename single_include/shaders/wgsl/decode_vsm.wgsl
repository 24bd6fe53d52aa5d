// umbrage 0.1.0, decode_vsm: mean of VSM texels to visibility. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// decode_vsm, tier C: within 13 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

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

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
fn umbrage_to_forward_depth(depth: f32) -> f32 {
    return select(depth, 1.0 - depth, umbrage_cleared_depth() < 0.5);
}

// umbrage_decode_vsm: visibility of a receiver from a variance shadow map, at least its lit fraction. 1.0 = lit
//   m              mean of texels
//   receiver       receiver depth, bias applied
//   min_variance   0.0 or more
fn umbrage_decode_vsm(m: vec2f, receiver: f32, min_variance: f32) -> f32 {
    return umbrage_chebyshev(m, umbrage_to_forward_depth(receiver), min_variance);
}
