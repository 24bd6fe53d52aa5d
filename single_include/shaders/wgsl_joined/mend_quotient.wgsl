// umbrage 0.1.0, mend_quotient: a quotient of whole numbers, from one at most one off. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_mend_quotient: floor(a / b) from q, at most one off;  whole numbers, a below 2^24, b from 1 to 2^24
fn umbrage_mend_quotient(q: f32, a: f32, b: f32) -> f32 {
    let low: f32 = select(q, q - 1.0, q * b > a);
    return select(low, low + 1.0, (low + 1.0) * b <= a);
}
