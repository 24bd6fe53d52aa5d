// umbrage 0.1.0, exp2_polynomial: 2^y, off by at most 1.8e-7 of itself. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// exp2_polynomial, tier B: within 16 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_power_of_two: 2^n of an integer n, -64.0 to 63.0
fn umbrage_power_of_two(n: f32) -> f32 {
    let exponent: u32 = u32(n + 127.0);
    return bitcast<f32>(exponent << 23);
}

// umbrage_exp2_polynomial: 2^y, off by at most 1.8e-7 of itself
//   y   exponent, clamped to -64.0 to 63.0. NaN is -64.0
fn umbrage_exp2_polynomial(y: f32) -> f32 {
    let x: f32 = select(-64.0, min(y, 63.0), y > -64.0);
    let n: f32 = floor(x);
    let f: f32 = x - n;
    var p: f32 = 0.00187931862 * f + 0.00899099465;
    p = p * f + 0.0558186769;
    p = p * f + 0.240159273;
    p = p * f + 0.693151712;
    p = p * f + 1.0;
    return p * umbrage_power_of_two(n);
}
