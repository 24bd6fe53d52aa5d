// umbrage 0.1.0, exp2_steps: 2^y in steps of 12 bits. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_power_of_two: 2^n of an integer n, -64.0 to 63.0
fn umbrage_power_of_two(n: f32) -> f32 {
    let exponent: u32 = u32(n + 127.0);
    return bitcast<f32>(exponent << 23);
}

// umbrage_exp2_steps: 2^y, an integer below 2^12 times a power of two. y is rounded down to 1/2048
//   y   exponent, clamped to -64.0 to 63.0. NaN is -64.0
fn umbrage_exp2_steps(y: f32) -> f32 {
    let x: f32 = floor(select(-64.0, min(y, 63.0), y > -64.0) * 2048.0);
    let n: f32 = floor(x * (1.0 / 2048.0));
    let f: f32 = max(x - n * 2048.0, 0.0);  // not negative already: no sum is regrouped across the max
    let g: f32 = floor(f * (2048.0 - f) * (1.0 / 256.0));
    let r: f32 = 1251.0 + floor(f * 314.0 * (1.0 / 2048.0));
    let m: f32 = 2048.0 + f - floor((g * r + 16384.0) * (1.0 / 32768.0));
    return m * (1.0 / 2048.0) * umbrage_power_of_two(n);
}
