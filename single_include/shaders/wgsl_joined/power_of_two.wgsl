// umbrage 0.1.0, power_of_two: 2^n of integers n from -64 to 63. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_power_of_two: 2^n of an integer n, -64.0 to 63.0
fn umbrage_power_of_two(n: f32) -> f32 {
    let exponent: u32 = u32(n + 127.0);
    return bitcast<f32>(exponent << 23);
}
