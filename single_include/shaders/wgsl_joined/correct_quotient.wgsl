// umbrage 0.1.0, correct_quotient: a quotient of whole numbers, from one at most one off. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_correct_quotient: floor(a / b) from q, at most one off;  whole numbers, a below 2^24, b from 1 to 2^24
fn umbrage_correct_quotient(q: f32, a: f32, b: f32) -> f32 {
    let more: f32 = q + 1.0;
    let known: f32 = select(q, more, more * b <= a);
    return select(known, q - 1.0, q * b > a);
}
