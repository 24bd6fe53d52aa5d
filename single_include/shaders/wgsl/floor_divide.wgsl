// umbrage 0.1.0, floor_divide: integer division that rounds down, exact on any GPU. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_correct_quotient: floor(a / b) from a guess q, off by at most one
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
fn umbrage_correct_quotient(q: f32, a: f32, b: f32) -> f32 {
    let more: f32 = q + 1.0;
    let known: f32 = select(q, more, more * b <= a);
    return select(known, q - 1.0, q * b > a);
}

// umbrage_floor_divide: floor(a / b) of integers; the quotient is at most 2^18
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
fn umbrage_floor_divide(a: f32, b: f32) -> f32 {
    return umbrage_correct_quotient(floor(a / b), a, b);
}
