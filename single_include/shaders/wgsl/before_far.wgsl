// umbrage 0.1.0, before_far: whether a receiver is a number, and not behind the far plane. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_before_far: whether a receiver is a number, and not behind the far plane
fn umbrage_before_far(receiver: f32) -> bool {
    return receiver <= 1.0;
}
