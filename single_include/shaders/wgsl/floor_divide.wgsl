// umbrage 0.1.0, floor_divide: integer division that rounds down, exact on any GPU. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: correct_quotient.wgsl; or paste wgsl_joined/floor_divide.wgsl alone.

// umbrage_floor_divide: floor(a / b) of integers; the quotient is at most 2^18
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
fn umbrage_floor_divide(a: f32, b: f32) -> f32 {
    return umbrage_correct_quotient(floor(a / b), a, b);
}
