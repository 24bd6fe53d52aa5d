// umbrage 0.1.0, beyond_far: receivers behind the far plane. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_beyond_far: whether a receiver is behind the far plane
fn umbrage_beyond_far(receiver: f32) -> bool {
    return receiver > 1.0;
}
